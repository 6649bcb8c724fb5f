//! The baseline `data/host.tsv`, and the tables that are made of it: those of `docs/benches.md`, and all others to be
//! printed.

use crate::callgrind::Counted;
use crate::workloads::{ARRIVING, NUMBERS_AWAY, PICTURES, RANGE_SENSOR, of_solid};
use raylet_tables::markdown::{NONE, Table};
use raylet_tables::{Baseline, Cell, Figures, Outcome, SUBJECTS, grouped, joined, mean_and_worst, page, pivot};
use shared::workload::{PLACEMENTS, Placed, SOLIDS_BY_NAME};
use std::env::consts::ARCH;

const PAGE: &str = "docs/benches.md";
const BASELINE: &str = "data/host.tsv";
const PART: &str = "cost";
const WORKLOADS: &str = "workload";
const AWAY: &str = "away from grazing";
const RENEW: &str = ".ci/instructions --renew";

/// Times the mean.
const MANY: f64 = 4.0;

/// The queries of a solid in every number type and tier: hit / miss.
fn query<'a>(figures: &'a Figures, query: &str) -> String {
    let place = |parts: &[&'a str]| {
        let [subject, of, number, tier, rays] = *parts else { return None };
        (of == query && SUBJECTS.contains(&subject)).then(|| (vec![subject], vec![number, tier], rays))
    };
    pivot(&["solid"], figures, place, |cell| joined(cell, &["hit", "miss"]))
}

/// Scenes of ever more spheres: hit / miss.
fn scenes<'a>(figures: &'a Figures) -> String {
    let place = |parts: &[&'a str]| {
        let [subject, query, number, _, rays] = *parts else { return None };
        let (objects, walk) = subject.strip_prefix("scene of ")?.split_once(", ")?;
        Some((vec![walk, objects], vec![number, query], rays))
    };
    pivot(&["objects", "spheres"], figures, place, |cell| joined(cell, &["hit", "miss"]))
}

/// Figures of workloads in every number type and tier.
fn workloads<'a>(figures: &'a Figures, wanted: impl Fn(&str) -> bool, cell: impl Fn(&Cell<'_>) -> String) -> String {
    let place = |parts: &[&'a str]| {
        let [of, number, tier, what] = *parts else { return None };
        wanted(of).then(|| (vec![of], vec![number, tier], what))
    };
    pivot(&["rays"], figures, place, cell)
}

/// The workloads that the page shows: pictures, a sensor, and each solid turned and near.
fn is_shown(of: &str) -> bool {
    let turned = |solid: &&str| of == of_solid(solid, Placed::Turned, ARRIVING[0]);
    of == RANGE_SENSOR || PICTURES.contains(&of) || SOLIDS_BY_NAME.iter().any(turned)
}

/// The workloads of a number type and tier, each with a quantile of its costs over their mean.
fn tails<'a>(figures: &Figures, all: &'a [String], [number, tier, quantile]: [&str; 3]) -> Vec<(f64, &'a str)> {
    let figure = |of: &str, what: &str| figures.get(&format!("{of} | {number} | {tier} | {what}")).copied();
    let tail = |of: &'a String| Some((figure(of, quantile)? as f64 / figure(of, "mean")? as f64, of.as_str()));
    let mut tails: Vec<_> = all.iter().filter_map(tail).collect();
    tails.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    tails
}

/// The median and the largest ratio of a quantile, and of the worst, to the mean.
fn ratios(figures: &Figures, quantile: &str) -> String {
    let names = || figures.keys().map(|name| name.split(" | ").collect::<Vec<_>>());
    let mut all: Vec<_> = names().map(|parts| parts[0].to_string()).collect();
    all.dedup();
    let kinds: std::collections::BTreeSet<_> = names().map(|parts| [parts[1], parts[2]]).collect();
    let [median, greatest] = ["median", "greatest"].map(|of| format!("{quantile}, {of}"));
    let over = format!("{quantile} above {MANY}");
    let titles = ["number", "tier", &median, &greatest, "of", &over, "worst, median", "worst, greatest", "of"];
    let mut table = Table::new(&titles, 2);
    for [number, tier] in kinds {
        let [most, worst] = [quantile, "worst"].map(|quantile| tails(figures, &all, [number, tier, quantile]));
        let (Some(greatest_most), Some(greatest_worst)) = (most.last(), worst.last()) else { continue };
        let median = |tails: &[(f64, &str)]| format!("{:.1}", tails[tails.len() / 2].0);
        let greatest = |(ratio, of): &(f64, &str)| [format!("{ratio:.1}"), of.to_string()];
        let above = most.iter().filter(|(ratio, _)| *ratio > MANY).count().to_string();
        let cells = [format!("`{number}`"), format!("`{tier}`"), median(&most)].into_iter();
        let cells = cells.chain(greatest(greatest_most)).chain([above, median(&worst)]);
        table.row(&cells.chain(greatest(greatest_worst)).collect::<Vec<_>>());
    }
    table.done()
}

/// Of rays that do not graze, the 99.9 % in multiples of the mean: near / far.
fn away(figures: &Figures) -> String {
    let mut table = Table::new(&["solid"].into_iter().chain(NUMBERS_AWAY).collect::<Vec<_>>(), 1);
    for (solid, placed) in SOLIDS_BY_NAME.into_iter().flat_map(|solid| PLACEMENTS.map(|placed| (solid, placed))) {
        let cell = |number: &str| {
            let ratio = |rays| {
                let of = of_solid(solid, placed, rays);
                let figure = |what: &str| figures.get(&format!("{of} | {number} | Stable | {what}")).copied();
                let ratio = figure("99.9 %").zip(figure("mean"));
                ratio.map_or(NONE.into(), |(most, mean)| format!("{:.1}", most as f64 / mean as f64))
            };
            ARRIVING.map(ratio).join(" / ")
        };
        let name = format!("{solid}, {}", placed.name());
        table.row(&[name].into_iter().chain(NUMBERS_AWAY.map(cell)).collect::<Vec<_>>());
    }
    table.done()
}

/// A table of the page, by the name of its mark.
fn table(baseline: &Baseline, name: &str) -> Outcome<String> {
    let part = |part| baseline.part(part);
    Ok(match name {
        "counted" => format!("Counted on {} with {}.\n\n", baseline.machine, baseline.compiler),
        "users" => workloads(part(WORKLOADS), is_shown, mean_and_worst),
        "tails" => ratios(part(WORKLOADS), "99 %"),
        "away" => ratios(part(AWAY), "99.9 %"),
        "nearest" => query(part(PART), "nearest"),
        "scenes" => scenes(part(PART)),
        _ => return Err(format!("there is no table `{name}`").into()),
    })
}

/// All tables.
pub fn printed() -> Outcome<String> {
    let baseline = Baseline::read(BASELINE, RENEW)?;
    let [cost, users, away_from_grazing] = [PART, WORKLOADS, AWAY].map(|part| baseline.part(part));
    let of = |what: &'static str| move |cell: &Cell<'_>| joined(cell, &[what]);
    let wrong = |cell: &Cell<'_>| match cell.get("off, units") {
        Some(units) => format!("{} ({})", grouped(*units), joined(cell, &["wrong"])),
        None => NONE.into(),
    };
    let all = |_: &str| true;
    let tables = [
        ("What users do: the mean (the worst)", workloads(users, all, mean_and_worst)),
        ("What users do: the second most expensive of a hundred", workloads(users, all, of("99 %"))),
        ("How many of a hundred the first numbers of the tier pass on", workloads(users, all, of("solved, %"))),
        ("How far off: units in the last place (wrong answers), against Exact", workloads(users, all, wrong)),
        ("How much the expensive rays take", ratios(users, "99 %")),
        ("The same of rays away from grazing", ratios(away_from_grazing, "99.9 %")),
        ("Of these the 99.9 % in multiples of the mean, near / far", away(away_from_grazing)),
        ("The nearest hit, hit / miss", query(cost, "nearest")),
        ("Occlusion, hit / miss", query(cost, "occlusion")),
        ("Normal at a known hit", query(cost, "normal")),
        ("Surface coordinates at a known hit", query(cost, "uv")),
        ("Scenes of ever more spheres, hit / miss", scenes(cost)),
    ];
    let counted = table(&baseline, "counted")?;
    Ok(tables.iter().fold(counted, |text, (title, table)| text + &format!("## {title}\n\n{table}")))
}

/// Makes what was counted the baseline, and writes the tables of the page.
pub fn renew(now: &Baseline) -> Outcome {
    let baseline = Baseline::read(BASELINE, RENEW).unwrap_or_default().renewed(now);
    baseline.write(BASELINE)?;
    show(&baseline, false)
}

/// Writes the tables of the page, or says whether they are as they should be.
fn show(baseline: &Baseline, verify: bool) -> Outcome {
    page::put(PAGE, &page::renewed(PAGE, |name, _, _| table(baseline, name))?, verify, RENEW)
}

/// An error if a figure got worse, or if the page does not show the baseline.
pub fn verify(now: &Baseline) -> Outcome {
    let baseline = Baseline::read(BASELINE, RENEW)?;
    baseline.compare(now, PART, "instructions", RENEW)?;
    baseline.compare(now, WORKLOADS, "instructions of what users do", RENEW)?;
    baseline.compare(now, AWAY, "instructions of rays away from grazing", RENEW)?;
    show(&baseline, true)
}

/// Writes the tables of the page from the baseline.
pub fn document() -> Outcome {
    show(&Baseline::read(BASELINE, RENEW)?, false)
}

/// What was counted on this machine.
pub fn counted(compiler: &str, Counted { cost, workloads, away_from_grazing }: Counted) -> Baseline {
    let mut baseline = Baseline::new(ARCH, compiler, PART, cost);
    for (part, figures) in [(WORKLOADS, workloads), (AWAY, away_from_grazing)] {
        baseline.parts.extend(Baseline::new(ARCH, compiler, part, figures).parts);
    }
    baseline
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_shows_the_baseline() {
        show(&Baseline::read(BASELINE, RENEW).unwrap(), true).unwrap();
    }

    #[test]
    fn all_figures_are_printed() {
        let text = printed().unwrap();
        for row in ["| picture of balls |", "| sphere, turned, departing |", "| in boxes | 66430 |", "| frustum |"] {
            assert!(text.contains(row), "{row}");
        }
    }
}
