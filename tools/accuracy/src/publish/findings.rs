//! Unexpected rows: those in which the more accurate tier is the faster one too, and combinations that another beats
//! everywhere.

use super::markdown::{NONE, Table, few_digits};
use crate::chips::is_like;
use crate::study::Study;
use std::collections::{BTreeMap, HashMap};
use support::figures::{Figures, NUMBERS, TIERS};

/// A difference in errors below this is none: of the third digit, which is rounded up.
const SAME_ERROR: f64 = 0.98;

/// A time must be this much shorter to be called so: times are noisy. Instructions are not.
const SHORTER: f64 = 0.9;

/// Where costs are counted: the host, then the chips.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Machine {
    Host,
    Chip(usize),
}

impl Machine {
    fn all(study: &Study) -> Vec<Self> {
        std::iter::once(Self::Host).chain((0..study.chips.len()).map(Self::Chip)).collect()
    }

    fn name(self, study: &Study) -> &'static str {
        match self {
            Self::Host => "host",
            Self::Chip(index) => study.chips[index].name,
        }
    }

    /// What a row costs there: of rays that hit, and of rays that miss.
    fn costs(self, study: &Study, row: &Figures) -> [Option<f64>; 2] {
        match self {
            Self::Host => {
                let time = study.time(row);
                [time.and_then(|time| time.hit), time.and_then(|time| time.miss)]
                    .map(|cost| cost.map(|cost| cost.ratio))
            }
            Self::Chip(index) => {
                let told = study.chips[index].instructions(row);
                [told.map(|told| told.hit as f64), told.map(|told| told.miss as f64)]
            }
        }
    }
}

/// A row in which a tier is both faster and more accurate than another of the same number type.
struct Beaten<'a> {
    machine: Machine,
    faster: &'a Figures,
    slower: &'a Figures,
    /// The faster's cost over the slower's.
    ratio: f64,
}

/// By 99.9 % of the error, and by wrong hits and misses.
fn is_more_accurate(a: &Figures, b: &Figures) -> bool {
    let (less, as_right) = (a.lengths[1] < b.lengths[1] * SAME_ERROR, a.wrong() <= b.wrong());
    as_right && a.lengths[1] <= b.lengths[1] && (less || a.wrong() < b.wrong())
}

fn beaten(study: &Study) -> Vec<Beaten<'_>> {
    let mut all = vec![];
    for slower in &study.rows {
        for tier in TIERS.into_iter().filter(|tier| *tier != slower.tier) {
            let Some(faster) = study.same(slower, &slower.number, tier) else { continue };
            if !is_more_accurate(faster, slower) {
                continue;
            }
            for machine in Machine::all(study) {
                if machine != Machine::Host && !is_like(slower) {
                    continue;
                }
                let limit = if machine == Machine::Host { SHORTER } else { 1.0 };
                for (a, b) in machine.costs(study, faster).into_iter().zip(machine.costs(study, slower)) {
                    if let (Some(a), Some(b)) = (a, b)
                        && a < b * limit
                    {
                        all.push(Beaten { machine, faster, slower, ratio: a / b });
                    }
                }
            }
        }
    }
    all
}

/// What is known of one tier that another of its number type beats: rows by machine, and the smallest ratio there.
#[derive(Default)]
struct Group {
    seen: BTreeMap<usize, (usize, f64)>,
    primitives: Vec<&'static str>,
}

/// In how many rows more accuracy costs less, and the smallest ratio of costs.
pub fn faster_and_more_accurate(study: &Study) -> String {
    let machines = Machine::all(study);
    let mut groups: BTreeMap<[usize; 3], Group> = BTreeMap::new();
    let place = |names: &[&str], name: &str| names.iter().position(|it| *it == name).unwrap_or(names.len());
    for row in beaten(study) {
        let [faster, slower] = [row.faster.tier, row.slower.tier].map(|tier| place(&TIERS, tier));
        let group = groups.entry([place(&NUMBERS, &row.slower.number), faster, slower]).or_default();
        let machine = machines.iter().position(|machine| *machine == row.machine).unwrap_or(0);
        let seen = group.seen.entry(machine).or_insert((0, f64::INFINITY));
        *seen = (seen.0 + 1, seen.1.min(row.ratio));
        if !group.primitives.contains(&row.slower.primitive) {
            group.primitives.push(row.slower.primitive);
        }
    }
    let titles = ["number", "faster and more accurate", "than", "at"].into_iter();
    let titles: Vec<_> = titles.chain(machines.iter().map(|machine| machine.name(study))).collect();
    let mut table = Table::new(&titles, 4);
    for ([number, faster, slower], group) in &groups {
        let at = match group.primitives.len() {
            0..=4 => group.primitives.join(", "),
            more => format!("{more} primitives"),
        };
        let mut cells = vec![format!("`{}`", NUMBERS[*number]), TIERS[*faster].into(), TIERS[*slower].into(), at];
        cells.extend((0..machines.len()).map(|machine| match group.seen.get(&machine) {
            Some((rows, least)) => format!("{rows} ({})", few_digits(*least)),
            None => NONE.into(),
        }));
        table.row(&cells);
    }
    table.done()
}

/// How often a combination is beaten by another, of any number type, in cost (of rays that hit) and error.
struct Dominated<'a> {
    rows: usize,
    beaten: usize,
    by: HashMap<(&'a str, &'static str), usize>,
}

fn dominated<'a>(study: &'a Study, machine: Machine, number: &str, tier: &str) -> Dominated<'a> {
    let mut told = Dominated { rows: 0, beaten: 0, by: HashMap::new() };
    for row in study.rows.iter().filter(|row| row.number == number && row.tier == tier) {
        let Some(cost) = machine.costs(study, row)[0] else { continue };
        told.rows += 1;
        let mut any = false;
        for other in NUMBERS.iter().flat_map(|number| TIERS.iter().map(move |tier| (*number, *tier))) {
            let Some(other) = study.same(row, other.0, other.1) else { continue };
            let Some(less) = machine.costs(study, other)[0] else { continue };
            let as_good = other.wrong() <= row.wrong() && other.lengths[1] <= row.lengths[1] && less <= cost;
            if as_good && (other.wrong() < row.wrong() || other.lengths[1] < row.lengths[1] || less < cost) {
                any = true;
                *told.by.entry((other.number.as_str(), other.tier)).or_default() += 1;
            }
        }
        told.beaten += usize::from(any);
    }
    told
}

/// The share of rows in which each combination is beaten, by machine; where it is all, by whom most often.
pub fn dominated_everywhere(study: &Study) -> String {
    let machines = Machine::all(study);
    let titles = ["number", "tier"].into_iter().chain(machines.iter().map(|machine| machine.name(study)));
    let mut table = Table::new(&titles.collect::<Vec<_>>(), 2);
    for (number, tier) in NUMBERS.iter().flat_map(|number| TIERS.iter().map(move |tier| (*number, *tier))) {
        let cell = |machine: &Machine| {
            let Dominated { rows, beaten, by } = dominated(study, *machine, number, tier);
            match by.iter().max_by_key(|(name, rows)| (**rows, *name)) {
                _ if rows == 0 => NONE.into(),
                Some(((number, tier), _)) if beaten == rows => format!("all (by `{number}` {tier})"),
                _ => format!("{:.0} %", 100.0 * beaten as f64 / rows as f64),
            }
        };
        let cells: Vec<_> = machines.iter().map(cell).collect();
        if cells.iter().any(|cell| cell != NONE) {
            table.row(&[vec![format!("`{number}`"), tier.into()], cells].concat());
        }
    }
    table.done()
}
