//! All that was measured: errors, times, sweeps, and what the firmware says of the chips.

use crate::chips::{Chip, Instructions};
use serde_json::{Value, json};
use std::collections::HashMap;
use support::figures::{Figures, Rays};

/// What a query costs on the machine that measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// Of the time that the textbook's sphere takes in `f32`, in the same run.
    pub ratio: f64,
    pub nanoseconds: f64,
}

/// The times of one row: of rays that hit, and of rays that miss.
#[derive(Clone, Debug, PartialEq)]
pub struct Time {
    pub number: String,
    pub tier: String,
    pub primitive: String,
    pub workload: String,
    pub hit: Option<Cost>,
    pub miss: Option<Cost>,
}

/// All times of one run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Times {
    pub machine: String,
    /// The reference: the textbook's sphere in `f32`.
    pub reference_nanoseconds: f64,
    pub rows: Vec<Time>,
}

/// One point of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// `distance` or `grazing`.
    pub sweep: String,
    pub number: String,
    pub tier: String,
    pub primitive: String,
    pub at: f64,
    pub hits: usize,
    /// Lost or phantom.
    pub wrong: usize,
    /// Median and 99.9 % of the error of `t`, in units in the last place.
    pub errors: [f64; 2],
}

/// A row's names: number type, tier, primitive, and the workload with the placement (`benign`; `benign, turned`).
pub type Key = [String; 4];

pub fn key(number: &str, tier: &str, primitive: &str, workload: &str) -> Key {
    [number, tier, primitive, workload].map(String::from)
}

/// Everything that the documents show.
pub struct Study {
    pub rays: Rays,
    pub rows: Vec<Figures>,
    pub times: Times,
    pub sweeps: Vec<Point>,
    pub chips: Vec<Chip>,
    row_of: HashMap<Key, usize>,
    time_of: HashMap<Key, usize>,
}

impl Study {
    pub fn new(rays: Rays, rows: Vec<Figures>, times: Times, sweeps: Vec<Point>, chips: Vec<Chip>) -> Self {
        let row_key = |row: &Figures| key(&row.number, row.tier, row.primitive, &row.name());
        let row_of = rows.iter().enumerate().map(|(index, row)| (row_key(row), index)).collect();
        let time_key = |time: &Time| key(&time.number, &time.tier, &time.primitive, &time.workload);
        let time_of = times.rows.iter().enumerate().map(|(index, time)| (time_key(time), index)).collect();
        Self { rays, rows, times, sweeps, chips, row_of, time_of }
    }

    pub fn row(&self, number: &str, tier: &str, primitive: &str, workload: &str) -> Option<&Figures> {
        self.row_of.get(&key(number, tier, primitive, workload)).map(|index| &self.rows[*index])
    }

    pub fn time(&self, row: &Figures) -> Option<&Time> {
        let key = key(&row.number, row.tier, row.primitive, &row.name());
        self.time_of.get(&key).map(|index| &self.times.rows[*index])
    }

    /// The row of the same rays in another number type and tier.
    pub fn same(&self, row: &Figures, number: &str, tier: &str) -> Option<&Figures> {
        self.row(number, tier, row.primitive, &row.name())
    }

    /// The workloads of a primitive in a number type that are timed, with their placements, in the order of the tables.
    pub fn timed(&self, number: &str, primitive: &str) -> Vec<String> {
        let of = |row: &&Figures| row.number == number && row.primitive == primitive && row.tier == "Stable";
        self.rows.iter().filter(of).filter(|row| row.is_timed()).map(Figures::name).collect()
    }
}

/// One object a line: readable, and small differences stay small.
pub fn lines(rows: impl Iterator<Item = Value>) -> String {
    rows.map(|row| row.to_string()).collect::<Vec<_>>().join(",\n")
}

fn cost(cost: Option<Cost>) -> Value {
    cost.map_or(Value::Null, |cost| json!({ "ratio": cost.ratio, "nanoseconds": cost.nanoseconds }))
}

/// A row, its times, and the instructions of the chips that have it.
pub fn row_as_json(study: &Study, row: &Figures) -> Value {
    let ([median, most, worst], [lost, phantom, edge, part, integers]) = (row.errors, row.counts);
    let [median_length, most_length, worst_length] = row.lengths;
    let time = study.time(row);
    let instructions = |chip: &Chip| {
        let Instructions { hit, miss } = chip.instructions(row)?;
        Some((chip.name.to_string(), json!({ "hit": hit, "miss": miss })))
    };
    let instructions: serde_json::Map<_, _> = study.chips.iter().filter_map(instructions).collect();
    json!({
        "tier": row.tier, "number": row.number, "primitive": row.primitive, "placed": row.placed,
        "workload": row.workload,
        "hits": row.hits, "median": median, "p999": most, "worst": worst,
        "median_length": median_length, "p999_length": most_length, "worst_length": worst_length,
        "lost": lost, "phantom": phantom, "edge": edge, "part": part, "integers": integers,
        "broken": row.broken,
        "time_hit": time.map_or(Value::Null, |time| cost(time.hit)),
        "time_miss": time.map_or(Value::Null, |time| cost(time.miss)),
        "instructions": instructions,
    })
}

/// Everything, one object a row.
pub fn as_json(study: &Study) -> String {
    let rows = study.rows.iter().map(|row| row_as_json(study, row));
    let sweeps = study.sweeps.iter().map(|point| {
        let Point { sweep, number, tier, primitive, at, hits, wrong, errors: [median, most] } = point;
        json!({
            "sweep": sweep, "number": number, "tier": tier, "primitive": primitive, "at": at, "hits": hits,
            "wrong": wrong, "median": median, "p999": most,
        })
    });
    format!(
        "{{\n\"machine\": {},\n\"reference_nanoseconds\": {},\n\"rays\": {},\n\"rays_placed\": {},\n\
         \"rows\": [\n{}\n],\n\"sweeps\": [\n{}\n]}}\n",
        json!(study.times.machine),
        study.times.reference_nanoseconds,
        study.rays.unplaced,
        study.rays.placed,
        lines(rows),
        lines(sweeps)
    )
}
