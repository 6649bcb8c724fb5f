//! Error against cost: one point a combination of number type and tier, a panel a workload at its own cost, and the
//! front of those that nothing beats in both.

use super::sheet::{self, Area, Axis, INK, Mark, label, power};
use crate::chips::Chip;
use crate::study::Study;
use plotters::prelude::*;
use std::error::Error;
use support::figures::{Figures, NUMBERS, TIERS};

const COLUMNS: usize = 4;
const PANEL: (u32, u32) = (250, 190);
const HEAD: u32 = 74;

/// Errors are drawn within these lengths: beyond them an answer is no answer.
const LENGTHS: [f64; 2] = [1e-17, 1e5];

pub(super) fn color(number: &str) -> RGBColor {
    match number {
        "f32" => RGBColor(0x1f, 0x77, 0xe0),
        "f64" => RGBColor(0x2d, 0xa4, 0x4e),
        "I16F16" => RGBColor(0xd9, 0x73, 0x0d),
        _ => RGBColor(0xa2, 0x59, 0xd9),
    }
}

/// A combination's cost and error.
pub(super) struct Point<'a> {
    row: &'a Figures,
    pub(super) cost: f64,
    error: f64,
}

/// Workloads of this study, and the ones like them that the chips' instructions are counted of.
const ON_CHIPS: [(&str, &str); 6] = [
    ("benign", "in the world, near"),
    ("100 away", "in the world, far"),
    ("benign, turned", "turned, near"),
    ("100 away, turned", "turned, far"),
    ("benign, stretched by 1/30 to 30", "stretched, near"),
    ("departing inwards, turned", "turned, departing"),
];

/// The points of a workload, at what `cost` knows of a row.
pub(super) fn points<'a>(
    study: &'a Study,
    primitive: &str,
    workload: &str,
    cost: impl Fn(&Figures) -> Option<f64>,
) -> Vec<Point<'a>> {
    let rows = NUMBERS.iter().flat_map(|number| TIERS.iter().map(move |tier| (number, tier)));
    rows.filter_map(|(number, tier)| {
        // Where every hit was lost there is no error.
        let row = study.row(number, tier, primitive, workload).filter(|row| row.hits > 0)?;
        Some(Point { row, cost: cost(row)?, error: row.lengths[1].clamp(LENGTHS[0], LENGTHS[1]) })
    })
    .collect()
}

/// The panels of a primitive, each with its title: the workloads that were timed, or those that chips count.
fn panels<'a>(study: &'a Study, chip: Option<&Chip>, primitive: &str) -> Vec<(String, Vec<Point<'a>>)> {
    let Some(chip) = chip else {
        let time = |row: &Figures| Some(study.time(row)?.hit?.ratio);
        return study
            .timed("f32", primitive)
            .into_iter()
            .map(|workload| (workload.clone(), points(study, primitive, &workload, time)))
            .collect();
    };
    let solid = primitive.replacen(' ', ", ", 1);
    let of = |(workload, counted): (&str, &str)| {
        let own = |row: &Figures| {
            let mean = chip.of_workload(&format!("{solid}, {counted}"), &row.number, row.tier);
            // The textbook is only counted at solids in the world, from nearby: rays that hit.
            mean.or_else(|| {
                (workload == "benign" && row.tier == "Textbook")
                    .then(|| chip.instructions(row))
                    .flatten()
                    .map(|cost| cost.hit)
            })
        };
        (counted.to_string(), points(study, primitive, workload, |row| own(row).map(|cost| cost as f64)))
    };
    ON_CHIPS.map(of).into()
}

/// Those without wrong hits or misses that no other beats in cost and error, by cost.
fn front(points: &[Point<'_>]) -> Vec<(f64, f64)> {
    let mut right: Vec<_> = points.iter().filter(|point| point.row.wrong() == 0).collect();
    right.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error)));
    let mut front: Vec<(f64, f64)> = vec![];
    for point in right {
        if front.last().is_none_or(|last| point.error < last.1) {
            front.push((point.cost, point.error));
        }
    }
    front
}

pub(super) fn panel(area: &Area<'_>, title: &str, points: &[Point<'_>], costs: [f64; 2]) -> Result<(), Box<dyn Error>> {
    let axes = [Axis { between: costs, labels: 5 }, Axis { between: LENGTHS, labels: 8 }];
    let mut chart = sheet::panel(area, title, axes, |value| power(*value))?;
    // As stairs: between two of the front there is nothing to be had.
    let front = front(points);
    let mut stairs = vec![];
    for (index, &(cost, error)) in front.iter().enumerate() {
        if index > 0 {
            stairs.push((cost, front[index - 1].1));
        }
        stairs.push((cost, error));
    }
    chart.draw_series(LineSeries::new(stairs, INK.stroke_width(1)))?;
    for point in points {
        let at = (point.cost.clamp(costs[0], costs[1]), point.error);
        Mark::of(point.row.tier).draw(chart.plotting_area(), at, color(&point.row.number), point.row.wrong() > 0)?;
    }
    Ok(())
}

fn legend(area: &Area<'_>, axis: &str) -> Result<(), Box<dyn Error>> {
    let mut x = 16;
    for number in NUMBERS {
        Mark::Square.draw(area, (x, 40), color(number), false)?;
        label(area, number, (x + 10, 40), 12)?;
        x += 70;
    }
    sheet::tiers(area, x + 14, |_| RGBColor(0x80, 0x88, 0x90))?;
    let axes = format!(
        "Across: {axis}. Up: 99.9 % error of t, as a length; the solid's size is about 1. Line: nothing is better in \
         both."
    );
    label(area, &axes, (12, 60), 12)
}

/// The costs that a panel shows.
pub(super) fn span<'a>(points: impl Iterator<Item = &'a Point<'a>>) -> [f64; 2] {
    let costs = points.map(|point| point.cost.max(1e-3));
    let (least, most) = costs.fold((f64::INFINITY, 0.0_f64), |(least, most), cost| (least.min(cost), most.max(cost)));
    if least > most { [1.0, 10.0] } else { [least / 1.5, most * 1.5] }
}

/// The plot of one primitive, on the host or on a chip.
pub fn plot(study: &Study, chip: Option<&Chip>, primitive: &str) -> Result<String, Box<dyn Error>> {
    let panels: Vec<_> = panels(study, chip, primitive).into_iter().filter(|(_, points)| !points.is_empty()).collect();
    let costs = span(panels.iter().flat_map(|(_, points)| points));
    let rows = panels.len().div_ceil(COLUMNS);
    let size = (PANEL.0 * COLUMNS as u32, HEAD + PANEL.1 * rows.max(1) as u32);
    let (place, axis) = match chip {
        Some(chip) => {
            (chip.name, "instructions of a query in the mean, hits and misses of this workload (textbook: of a hit)")
        }
        None => ("this host", "time of a nearest hit; 1 is the textbook's sphere in f32"),
    };
    let title = format!("Error against cost: {primitive}, {place}");
    sheet::sheet(size, &title, |area| {
        legend(area, axis)?;
        let (_, below) = area.split_vertically(HEAD);
        for ((workload, points), panel_area) in panels.iter().zip(below.split_evenly((rows.max(1), COLUMNS))) {
            panel(&panel_area, workload, points, costs)?;
        }
        Ok(())
    })
}
