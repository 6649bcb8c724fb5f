//! Figures as text.

use crate::chips::{Chip, is_like};
use crate::study::{Cost, Study};
use raylet_tables::grouped;
pub use raylet_tables::markdown::{NONE, Table};
use support::figures::Figures;

/// An error in units in the last place.
pub fn short(value: f64) -> String {
    match value {
        0.0..10.0 => format!("{value:.2}"),
        10.0..1e5 => format!("{value:.0}"),
        _ => format!("{value:.0e}"),
    }
}

/// A length.
pub fn length(value: f64) -> String {
    if value == 0.0 { "0".into() } else { format!("{value:.1e}") }
}

/// A ratio or nanoseconds, to two or three digits.
pub fn few_digits(value: f64) -> String {
    match value {
        0.0..1.0 => format!("{value:.2}"),
        1.0..100.0 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}

/// What a nearest hit takes, as a ratio: of rays that hit / that miss.
pub fn ratios(hit: Option<Cost>, miss: Option<Cost>) -> String {
    pair(hit.map(|cost| few_digits(cost.ratio)), miss.map(|cost| few_digits(cost.ratio)))
}

pub fn nanoseconds(hit: Option<Cost>, miss: Option<Cost>) -> String {
    pair(hit.map(|cost| few_digits(cost.nanoseconds)), miss.map(|cost| few_digits(cost.nanoseconds)))
}

fn pair(hit: Option<String>, miss: Option<String>) -> String {
    match (hit, miss) {
        (None, None) => NONE.into(),
        (hit, miss) => format!("{} / {}", hit.unwrap_or(NONE.into()), miss.unwrap_or(NONE.into())),
    }
}

/// A chip's instructions for a row: hit / miss; in brackets where the firmware has other rays than the row's.
pub fn instructions(chip: &Chip, row: &Figures) -> String {
    let told = chip.instructions(row);
    let text = pair(told.map(|told| grouped(told.hit)), told.map(|told| grouped(told.miss)));
    if told.is_some() && !is_like(row) { format!("({text})") } else { text }
}

/// The time of a row on the host: hit / miss.
pub fn row_ratios(study: &Study, row: &Figures) -> String {
    study.time(row).map_or(NONE.into(), |time| ratios(time.hit, time.miss))
}
