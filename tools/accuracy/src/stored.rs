//! What the repository holds: times and sweeps as tables of `data`, and the study of these and all other tables.

use crate::chips;
use crate::study::{Cost, Point, Study, Time, Times};
use raylet_tables::{Outcome, Table};
use std::collections::HashMap;
use support::bounds;

pub const TIMES: &str = "data/times.tsv";
pub const SWEEPS: &str = "data/sweeps.tsv";

/// The command that writes them.
const WRITTEN_BY: &str = "cargo run --release -p raylet-accuracy -- --write";

/// What stands where nothing was timed: a workload of which no ray hits, or none misses.
const NONE: &str = "-";

const TIME_COLUMNS: [&str; 8] =
    ["number", "tier", "primitive", "workload", "hit_ratio", "hit_nanoseconds", "miss_ratio", "miss_nanoseconds"];

const SWEEP_COLUMNS: [&str; 9] = ["sweep", "number", "tier", "primitive", "at", "hits", "wrong", "median", "p999"];

/// The times, as they are stored.
pub fn times_table(times: &Times) -> String {
    let reference = times.reference_nanoseconds.to_string();
    let mut table =
        Table::new(&TIME_COLUMNS).with_note("machine", &times.machine).with_note("reference_nanoseconds", &reference);
    for Time { number, tier, primitive, workload, hit, miss } in &times.rows {
        let mut cells = [number, tier, primitive, workload].map(String::clone).to_vec();
        for cost in [hit, miss] {
            let show = |of: fn(&Cost) -> f64| cost.as_ref().map_or(NONE.into(), |cost| of(cost).to_string());
            cells.extend([show(|cost| cost.ratio), show(|cost| cost.nanoseconds)]);
        }
        table.rows.push(cells);
    }
    table.text()
}

/// The sweeps, as they are stored.
pub fn sweeps_table(sweeps: &[Point]) -> String {
    let mut table = Table::new(&SWEEP_COLUMNS);
    for Point { sweep, number, tier, primitive, at, hits, wrong, errors: [median, most] } in sweeps {
        let mut cells = [sweep, number, tier, primitive].map(String::clone).to_vec();
        cells.extend([at.to_string(), hits.to_string(), wrong.to_string(), median.to_string(), most.to_string()]);
        table.rows.push(cells);
    }
    table.text()
}

/// The times of the last `--write`.
pub fn times() -> Outcome<Times> {
    let table = Table::read(TIMES, WRITTEN_BY)?;
    let time = |row: &Vec<String>| {
        let [number, tier, primitive, workload, costs @ ..] = &row[..] else { return None };
        let [hit, miss] = [0, 2].map(|first| match costs.get(first..first + 2)? {
            [ratio, nanoseconds] if ratio == NONE && nanoseconds == NONE => Some(None),
            [ratio, nanoseconds] => {
                Some(Some(Cost { ratio: ratio.parse().ok()?, nanoseconds: nanoseconds.parse().ok()? }))
            }
            _ => None,
        });
        let [number, tier, primitive, workload] = [number, tier, primitive, workload].map(String::clone);
        Some(Time { number, tier, primitive, workload, hit: hit?, miss: miss? })
    };
    let times = || {
        Some(Times {
            machine: table.note("machine")?.to_string(),
            reference_nanoseconds: table.note("reference_nanoseconds")?.parse().ok()?,
            rows: table.rows.iter().map(time).collect::<Option<_>>()?,
        })
    };
    times().ok_or_else(|| format!("{TIMES} is not as `{WRITTEN_BY}` writes it").into())
}

/// The sweeps of the last `--write`.
pub fn sweeps() -> Outcome<Vec<Point>> {
    let table = Table::read(SWEEPS, WRITTEN_BY)?;
    let point = |row: &Vec<String>| {
        let [sweep, number, tier, primitive, at, hits, wrong, median, most] = &row[..] else { return None };
        let [sweep, number, tier, primitive] = [sweep, number, tier, primitive].map(String::clone);
        Some(Point {
            sweep,
            number,
            tier,
            primitive,
            at: at.parse().ok()?,
            hits: hits.parse().ok()?,
            wrong: wrong.parse().ok()?,
            errors: [median.parse().ok()?, most.parse().ok()?],
        })
    };
    let points: Option<Vec<_>> = table.rows.iter().map(point).collect();
    points.ok_or_else(|| format!("{SWEEPS} is not as `{WRITTEN_BY}` writes it").into())
}

/// Times vary by this much from run to run.
const NOISE: f64 = 0.1;

/// The times to store after another run: one within the noise of the stored one on the same machine is not replaced, so
/// that a renewal changes only what changed.
pub fn renewed(before: &Times, mut now: Times) -> Times {
    if before.machine != now.machine {
        return now;
    }
    let key = |time: &Time| [&time.number, &time.tier, &time.primitive, &time.workload].map(String::clone);
    let stored: HashMap<_, _> = before.rows.iter().map(|time| (key(time), time)).collect();
    let kept = |old: Option<Cost>, new: Option<Cost>| match (old, new) {
        (Some(old), Some(new)) if (new.ratio / old.ratio - 1.0).abs() <= NOISE => Some(old),
        _ => new,
    };
    for time in &mut now.rows {
        if let Some(old) = stored.get(&key(time)) {
            (time.hit, time.miss) = (kept(old.hit, time.hit), kept(old.miss, time.miss));
        }
    }
    now
}

/// What the repository holds: the bound table, and the times and sweeps of the last `--write`.
pub fn study() -> Outcome<Study> {
    Ok(Study::new(bounds::RAYS, bounds::all(), times()?, sweeps()?, chips::read()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_renewal_changes_only_what_changed() {
        let of = |machine: &str, ratios: [f64; 2]| {
            let [hit, miss] = ratios.map(|ratio| Some(Cost { ratio, nanoseconds: 4.0 * ratio }));
            let [number, tier, primitive, workload] = ["f32", "Fast", "disc", "benign"].map(String::from);
            let rows = vec![Time { number, tier, primitive, workload, hit, miss }];
            Times { machine: machine.into(), reference_nanoseconds: 4.0, rows }
        };
        assert_eq!(renewed(&of("a", [1.0, 1.0]), of("a", [1.09, 1.11])), of("a", [1.0, 1.11]));
        assert_eq!(renewed(&of("a", [1.0, 1.0]), of("b", [1.09, 1.11])), of("b", [1.09, 1.11]));
    }
}
