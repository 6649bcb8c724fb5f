//! Error against distance and against grazing: a line a tier, a panel a number type and primitive.

use super::sheet::{self, Area, Axis, Mark, label, power};
use crate::study::{Point, Study};
use crate::sweep::PRIMITIVES;
use plotters::prelude::*;
use std::error::Error;
use support::figures::{NUMBERS, TIERS};

const PANEL: (u32, u32) = (270, 250);
const HEAD: u32 = 74;

/// Units in the last place that are drawn.
const UNITS: [f64; 2] = [0.1, 1e10];

/// Hits that a point must have: at the end of a fixed type's range few rays fit it.
const ENOUGH: usize = 10;

pub(super) fn color(tier: &str) -> RGBColor {
    match tier {
        "Textbook" => RGBColor(0x80, 0x88, 0x90),
        "Plain" => RGBColor(0xc2, 0x35, 0x4b),
        "Fast" => RGBColor(0xd9, 0x73, 0x0d),
        "Stable" => RGBColor(0x1f, 0x77, 0xe0),
        _ => RGBColor(0x2d, 0xa4, 0x4e),
    }
}

/// Harder is farther right: rays from farther away, and rays closer to touching, whose places are drawn upside down.
fn place(at: f64) -> f64 {
    if at < 1.0 { 1.0 / at } else { at }
}

fn panel(area: &Area<'_>, title: &str, points: &[&Point], along: [f64; 2]) -> Result<(), Box<dyn Error>> {
    let is_grazing = points.iter().any(|point| point.at < 1.0);
    let axes = [Axis { between: along, labels: 7 }, Axis { between: UNITS, labels: 11 }];
    let across = |value: &f64| power(if is_grazing { 1.0 / value } else { *value });
    let mut chart = sheet::panel(area, title, axes, across)?;
    for tier in TIERS {
        let line: Vec<_> = points
            .iter()
            .filter(|point| point.tier == tier && point.hits >= ENOUGH)
            .map(|point| {
                (
                    (place(point.at).clamp(along[0], along[1]), point.errors[1].clamp(UNITS[0], UNITS[1])),
                    point.wrong > 0,
                )
            })
            .collect();
        chart.draw_series(LineSeries::new(line.iter().map(|(at, _)| *at), color(tier).stroke_width(2)))?;
        for (at, wrong) in line {
            Mark::of(tier).draw(chart.plotting_area(), at, color(tier), wrong)?;
        }
    }
    Ok(())
}

fn legend(area: &Area<'_>, axis: &str) -> Result<(), Box<dyn Error>> {
    sheet::tiers(area, 16, color)?;
    let axes = format!(
        "Across: {axis}. Up: 99.9 % error of t, in units in the last place. A line ends where no ray fits the type."
    );
    label(area, &axes, (12, 60), 12)
}

/// The plot of one sweep.
pub fn plot(study: &Study, sweep: &str) -> Result<String, Box<dyn Error>> {
    let (along, axis, title) = match sweep {
        "distance" => ([1.0, 1e6], "distance of the ray's origin from the solid of size 1", "Error against distance"),
        _ => ([1e1, 1e7], "how far from touching the ray passes, where the radius is about 1", "Error against grazing"),
    };
    let size = (PANEL.0 * NUMBERS.len() as u32, HEAD + PANEL.1 * PRIMITIVES.len() as u32);
    sheet::sheet(size, title, |area| {
        legend(area, axis)?;
        let (_, below) = area.split_vertically(HEAD);
        let panels = PRIMITIVES.iter().flat_map(|primitive| NUMBERS.iter().map(move |number| (*primitive, *number)));
        for ((primitive, number), panel_area) in panels.zip(below.split_evenly((PRIMITIVES.len(), NUMBERS.len()))) {
            let is_of = |point: &&Point| point.sweep == sweep && point.number == number && point.primitive == primitive;
            let points: Vec<_> = study.sweeps.iter().filter(is_of).collect();
            panel(&panel_area, &format!("{number}, {primitive}"), &points, along)?;
        }
        Ok(())
    })
}
