//! What raylet set out to reach beside its peers, and what it reached.

use crate::measure::Row;
use crate::names::{EMBEDDED_3DGFX, EXACT, PARRY, STABLE, TEXTBOOK};
use crate::sizes::PRIMITIVES;
use crate::speed::Speed;
use support::workload::Workload;

/// A ratio that was measured: first quartile, median and third quartile; and where.
#[derive(Clone, Debug)]
pub struct Reached {
    pub ratio: [f64; 3],
    pub place: String,
}

/// Which way a ratio must lie.
#[derive(Clone, Copy, Debug)]
pub enum Needed {
    AtLeast(f64),
    AtMost(f64),
}

impl Needed {
    pub fn is_reached(self, ratio: f64) -> bool {
        match self {
            Self::AtLeast(least) => ratio >= least,
            Self::AtMost(most) => ratio <= most,
        }
    }

    /// How far a ratio is on the wrong side, to find the worst.
    fn badness(self, ratio: f64) -> f64 {
        match self {
            Self::AtLeast(_) => -ratio,
            Self::AtMost(_) => ratio,
        }
    }
}

/// A bar of speed.
pub struct Bar {
    pub what: String,
    pub needed: Needed,
    /// At benign rays that hit, and at such rays moved aside so that they miss.
    pub benign: [Option<Reached>; 2],
    /// The worst of all workloads that the bar speaks of.
    pub worst: Option<Reached>,
}

type Belongs = fn(Workload) -> bool;

/// Of a contestant's rows in `f32`, the ratio to `Stable` at every workload that belongs.
fn ratios(rows: &[Row], primitive: &str, contestant: &str, belongs: Belongs) -> Vec<[Option<Reached>; 2]> {
    let reached = |row: &Row, speed: &Option<Speed>, kind: &str| {
        speed
            .as_ref()
            .map(|speed| Reached { ratio: speed.to_stable, place: format!("{}, {kind}", row.workload.name()) })
    };
    rows.iter()
        .filter(|row| row.number == "f32" && row.primitive == primitive && row.contestant == contestant)
        .filter(|row| belongs(row.workload))
        .map(|row| [reached(row, &row.hits, "hits"), reached(row, &row.misses, "misses")])
        .collect()
}

fn bar(rows: &[Row], what: String, needed: Needed, primitive: &str, contestant: &str, belongs: Belongs) -> Bar {
    let benign = ratios(rows, primitive, contestant, |workload| workload == Workload::Benign);
    let benign = if belongs(Workload::Benign) { benign.into_iter().next() } else { None };
    let all = ratios(rows, primitive, contestant, belongs);
    let worst = all.into_iter().flatten().flatten();
    let badness = |reached: &Reached| needed.badness(reached.ratio[1]);
    Bar {
        what,
        needed,
        benign: benign.unwrap_or_default(),
        worst: worst.max_by(|a, b| badness(a).total_cmp(&badness(b))),
    }
}

/// All bars of speed: all on the host, in `f32`, for the nearest hit.
pub fn speed_bars(rows: &[Row]) -> Vec<Bar> {
    let mut bars = vec![];
    for (primitive, least) in [("sphere", 1.0), ("capsule", 1.0), ("cylinder capped", 25.0), ("cone capped", 25.0)] {
        let what = format!("{primitive}: times as fast as parry3d");
        bars.push(bar(rows, what, Needed::AtLeast(least), primitive, PARRY, |_| true));
    }
    for primitive in PRIMITIVES {
        let what = format!("{primitive}: `Exact`'s time over `Stable`'s, benign");
        let is_benign = |workload| workload == Workload::Benign;
        bars.push(bar(rows, what, Needed::AtMost(1.5), primitive, EXACT, is_benign));
    }
    for primitive in PRIMITIVES {
        let what = format!("{primitive}: `Exact`'s time over `Stable`'s, grazing");
        let grazes = |workload| matches!(workload, Workload::Grazing(_));
        bars.push(bar(rows, what, Needed::AtMost(3.0), primitive, EXACT, grazes));
    }
    // Nothing grazes what is flat.
    bars.retain(|bar| bar.worst.is_some());
    bars
}

/// Errors within a hundredth of each other are the same.
const SAME: f64 = 1.01;

/// How the errors of `Stable` stand to a peer's, over all rows that both have.
pub struct ErrorBar {
    pub peer: &'static str,
    pub number: String,
    /// Rows in which no figure is larger and one is smaller.
    pub smaller: usize,
    /// Rows in which all figures are the same.
    pub equal: usize,
    /// Rows in which a figure is larger.
    pub larger: Vec<(Row, Row)>,
}

/// The bars of error: median, 99.9 %, worst, and lost, phantom and wrong hits together.
pub fn error_bars(rows: &[Row]) -> Vec<ErrorBar> {
    let mut bars = vec![];
    for number in ["f32", "f64"] {
        for peer in [PARRY, EMBEDDED_3DGFX, TEXTBOOK] {
            let mut bar = ErrorBar { peer, number: number.into(), smaller: 0, equal: 0, larger: vec![] };
            for theirs in rows.iter().filter(|row| row.contestant == peer && row.number == number) {
                let ours = rows.iter().find(|row| {
                    row.contestant == STABLE
                        && (&row.number, row.primitive, row.workload)
                            == (&theirs.number, theirs.primitive, theirs.workload)
                });
                let Some(ours) = ours else { continue };
                let figures = |row: &Row| {
                    let [median, most, worst] = row.errors.units;
                    [median, most, worst, row.errors.failures() as f64]
                };
                let (own, other) = (figures(ours), figures(theirs));
                let some = |is: fn(f64, f64) -> bool| own.iter().zip(other).any(|(own, other)| is(*own, other));
                if some(|own, other| own > SAME * other) {
                    bar.larger.push((ours.clone(), theirs.clone()));
                } else if some(|own, other| SAME * own < other) {
                    bar.smaller += 1;
                } else {
                    bar.equal += 1;
                }
            }
            if bar.smaller + bar.equal + bar.larger.len() > 0 {
                bars.push(bar);
            }
        }
    }
    bars
}
