//! Times and sweeps as tables of `data`.

use crate::study::{Cost, Point, Time, Times};
use raylet_tables::{Outcome, Table};

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
