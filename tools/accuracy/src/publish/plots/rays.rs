//! The plot of a file of rays: errors by the share of hits that exceed them, a panel a number type and a line a tier;
//! and where times were measured, error against cost.

use super::cost;
use super::sheet::{self, Area, Axis, Mark, label, power};
use super::sweeps::color;
use crate::rays::measured::{Outcome, Task};
use plotters::prelude::*;
use std::error::Error;
use support::figures::{NUMBERS, TIERS};

const PANEL: (u32, u32) = (270, 250);
const COLUMNS: usize = 3;
const HEAD: u32 = 92;

/// Units in the last place that are drawn.
const UNITS: [f64; 2] = [1e-2, 1e10];

fn panel(area: &Area<'_>, outcome: &Outcome, number: &str) -> Result<(), Box<dyn Error>> {
    let rows = || outcome.study.rows.iter().zip(&outcome.extras).filter(|(row, _)| row.number == number);
    let most = rows().map(|(row, _)| row.hits).max().unwrap_or(0).max(10) as f64;
    let axes = [Axis { between: [1.0, most], labels: 6 }, Axis { between: UNITS, labels: 12 }];
    let mut chart = sheet::panel(area, number, axes, |value| power(*value))?;
    for tier in TIERS {
        let Some((row, extra)) = rows().find(|(row, _)| row.tier == tier) else { continue };
        let mut line = extra.exceeded.iter().map(|(share, error)| (1.0 / share, error.clamp(UNITS[0], UNITS[1])));
        chart.draw_series(LineSeries::new(line.clone(), color(tier).stroke_width(2)))?;
        // The worst alone has a mark: lines that lie upon each other stay visible.
        if let Some(at) = line.next_back() {
            Mark::of(tier).draw(chart.plotting_area(), at, color(tier), row.wrong() > 0)?;
        }
    }
    Ok(())
}

fn legend(area: &Area<'_>, is_timed: bool) -> Result<(), Box<dyn Error>> {
    sheet::tiers(area, 16, color)?;
    label(
        area,
        "Number types: one of so many hits (across) has a larger error of t, in units in the last place (up).",
        (12, 60),
        12,
    )?;
    if is_timed {
        let axes = "Cost: time of a nearest hit, 1 is the textbook's sphere in f32 (across); 99.9 % error of t, as a \
                    length (up).";
        label(area, axes, (12, 78), 12)?;
    }
    Ok(())
}

/// The number types in the colours of the panel of costs, which are those of the published plots.
fn numbers(area: &Area<'_>, wanted: &[&str]) -> Result<(), Box<dyn Error>> {
    let mut y = 20;
    for number in wanted {
        Mark::Square.draw(area, (14, y), cost::color(number), false)?;
        label(area, number, (24, y), 12)?;
        y += 18;
    }
    Ok(())
}

/// The plot.
pub fn plot(task: &Task<'_>, outcome: &Outcome) -> Result<String, Box<dyn Error>> {
    let study = &outcome.study;
    let has = |number: &&str| study.rows.iter().any(|row| row.number == **number);
    let shown: Vec<&str> = NUMBERS.into_iter().filter(has).collect();
    let name = support::figures::name(task.file, task.placed());
    let time = |row: &support::figures::Figures| study.time(row).and_then(|time| Some(time.hit?.ratio));
    let costs = cost::points(study, task.solid.name(), &name, time);
    // The panel of costs has the names of the number types beside it.
    let panels = shown.len() + if costs.is_empty() { 0 } else { 2 };
    let rows = panels.div_ceil(COLUMNS);
    let size = (PANEL.0 * COLUMNS as u32, HEAD + PANEL.1 * rows as u32);
    let title = format!("Errors of the rays of {} at a {}", task.file, task.solid.name());
    sheet::sheet(size, &title, |area| {
        legend(area, !costs.is_empty())?;
        let (_, below) = area.split_vertically(HEAD);
        let areas = below.split_evenly((rows, COLUMNS));
        for (number, area) in shown.iter().zip(&areas) {
            panel(area, outcome, number)?;
        }
        if let [chart, key, ..] = &areas[shown.len()..]
            && !costs.is_empty()
        {
            cost::panel(chart, "error against cost", &costs, cost::span(costs.iter()))?;
            numbers(key, &shown)?;
        }
        Ok(())
    })
}
