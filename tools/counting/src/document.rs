//! `docs/benches.md`: the baseline as tables.

use crate::callgrind::Counted;
use crate::cost::scenes::{FLAKE, OBJECTS, WALKS, subject};
use crate::workloads::{ARRIVING, NUMBERS_AWAY, PICTURES, RANGE_SENSOR, of_solid};
use raylet_tables::markdown::{head, row};
use raylet_tables::{Baseline, Figures, Outcome, SUBJECTS, grouped, in_repository};
use shared::workload::{PLACEMENTS, RAYS, SOLIDS_BY_NAME};
use std::env::consts::ARCH;
use std::fmt::Write;
use std::fs;

const PATH: &str = "docs/benches.md";
const BASELINE: &str = "data/host.tsv";
const PART: &str = "cost";
const WORKLOADS: &str = "workload";
const AWAY: &str = "away from grazing";
const RENEW: &str = ".ci/instructions --renew";

/// Number types, and their tiers.
const NUMBERS: [(&str, &[&str]); 4] = [
    ("f32", &["Plain", "Fast", "Stable", "Exact"]),
    ("f64", &["Plain", "Fast", "Stable"]),
    ("I16F16", &["Plain", "Fast", "Stable", "Exact"]),
    ("I32F32", &["Plain", "Fast", "Stable"]),
];

/// The number types of the scenes, and of normals and surface coordinates.
const FEWER_NUMBERS: [&str; 2] = ["f32", "I16F16"];

/// The queries of the scenes.
const SCENE_QUERIES: [&str; 2] = ["nearest", "occlusion"];

const INTRODUCTION: &str = "\
# On the host

What a query costs on an ordinary computer, in instructions, and how that grows with the objects of a scene.
`.ci/instructions --renew` writes this page and `data/host.tsv`, which has all figures; do not edit them. `.ci/instructions` fails if a figure gets more than 2 % worse.
`cargo bench -p raylet-counting` measures how long a query takes on your machine.

The figures are **instructions, never cycles**, counted by valgrind's callgrind, so that they are the same on every run. Except in the section *What users do*,
each is the mean over 64 seeded rays, which start 2 to 6 units away; all of them hit, or all miss. Subjects, rays and queries are those of
[microcontrollers.md](microcontrollers.md). Each query is a call of a function that is not inlined; the cost of the loop and of a call of an
empty function is subtracted. The program is built with `opt-level = 3`, link-time optimisation and one codegen unit, for any processor of its
architecture.

";

fn figure(figures: &Figures, name: [&str; 5]) -> Option<u64> {
    figures.get(&name.join(" | ")).copied()
}

/// The figure for rays that hit, or for both kinds.
fn cell(figures: &Figures, [subject, query, number, tier]: [&str; 4]) -> String {
    let grouped = |kind| figure(figures, [subject, query, number, tier, kind]).map(grouped);
    match (grouped("hit"), grouped("miss")) {
        (Some(hit), Some(miss)) => format!("{hit} / {miss}"),
        (Some(hit), None) => hit,
        _ => "–".into(),
    }
}

/// A first cell, and the others.
fn cells(first: &str, others: impl IntoIterator<Item = String>) -> impl Iterator<Item = String> {
    std::iter::once(first.to_string()).chain(others)
}

/// Every subject in every number type and tier.
fn query(text: &mut String, figures: &Figures, title: &str, query: &str) {
    let _ = write!(text, "## {title}\n\nInstructions: hit / miss.\n\n");
    let columns: Vec<_> =
        NUMBERS.iter().flat_map(|(number, tiers)| tiers.iter().map(move |tier| (*number, *tier))).collect();
    let titles: Vec<_> = columns.iter().map(|(number, tier)| format!("`{number}` `{tier}`")).collect();
    head(text, cells("subject", titles));
    for subject in SUBJECTS {
        row(text, cells(subject, columns.iter().map(|(number, tier)| cell(figures, [subject, query, number, tier]))));
    }
    text.push('\n');
}

/// Normals and surface coordinates at a hit.
fn surface(text: &mut String, figures: &Figures) {
    text.push_str(
        "## Normal and surface coordinates\n\nInstructions at a known hit. They do not depend on the tier.\n\n",
    );
    let columns: Vec<_> =
        FEWER_NUMBERS.iter().flat_map(|number| ["normal", "uv"].map(|query| (*number, query))).collect();
    let titles: Vec<_> = columns.iter().map(|(number, query)| format!("{query}, `{number}`")).collect();
    head(text, cells("subject", titles));
    for subject in SUBJECTS {
        row(text, cells(subject, columns.iter().map(|(number, query)| cell(figures, [subject, query, number, "any"]))));
    }
    text.push('\n');
}

/// Scenes of ever more spheres.
fn scenes(text: &mut String, figures: &Figures) {
    text.push_str(
        "## Cost against work\n\nInstructions a ray in a scene of small framed spheres, `Stable`: hit / miss. Without a hierarchy a scene tests every object, so that each further object adds the same cost to a nearest hit; occlusion stops at the first object that is hit. With a hierarchy (`Scene::with_hierarchy`) it tests boxes, and only the objects in the boxes that the ray meets. The last row of \
         each table is what a further sphere adds, between the smallest scene and that of 256. The 66,430 spheres are a sphere flake: each sphere bears nine of a third of \
         its radius.\n",
    );
    for walk in WALKS {
        let _ = write!(text, "\nObjects {walk}:\n\n");
        scenes_by(text, figures, walk);
    }
}

fn scenes_by(text: &mut String, figures: &Figures, walk: &str) {
    let columns: Vec<_> = FEWER_NUMBERS.iter().flat_map(|number| SCENE_QUERIES.map(|query| (*number, query))).collect();
    let titles: Vec<_> = columns.iter().map(|(number, query)| format!("{query}, `{number}`")).collect();
    head(text, cells("spheres", titles));
    let scene = |objects: usize| subject(objects, walk);
    for objects in OBJECTS.into_iter().chain([FLAKE]) {
        let counted: Vec<_> =
            columns.iter().map(|(number, query)| cell(figures, [&scene(objects), query, number, "Stable"])).collect();
        if counted.iter().any(|cell| cell != "–") {
            row(text, cells(&grouped(objects as u64), counted));
        }
    }
    let (fewest, most) = (OBJECTS[0], OBJECTS[OBJECTS.len() - 1]);
    let added = |number: &str, query: &str, kind: &str| {
        let of = |objects| figure(figures, [&scene(objects), query, number, "Stable", kind]);
        match (of(fewest), of(most)) {
            (Some(few), Some(many)) => format!("{:.1}", (many as f64 - few as f64) / (most - fewest) as f64),
            _ => "–".into(),
        }
    };
    let further = columns
        .iter()
        .map(|(number, query)| format!("{} / {}", added(number, query, "hit"), added(number, query, "miss")));
    row(text, cells("each further", further));
}

/// The number types and tiers of the workloads.
const OF_WORKLOADS: [(&str, &[&str]); 6] = [
    ("f32", &["Plain", "Fast", "Stable", "Exact"]),
    ("I16F16", &["Plain", "Fast", "Stable", "Exact"]),
    ("I20F12", &["Stable"]),
    ("I8F24", &["Stable"]),
    ("f64", &["Stable"]),
    ("I32F32", &["Stable"]),
];

/// Times the mean.
const MANY: f64 = 4.0;

/// A row of a workload: its mean and its worst in each number type and tier; then how much of it the first method of
/// `Stable` passes on.
fn workload(text: &mut String, figures: &Figures, of: &str) {
    let figure =
        |number: &str, tier: &str, what: &str| figures.get(&format!("{of} | {number} | {tier} | {what}")).copied();
    let cost = OF_WORKLOADS.iter().flat_map(|(number, tiers)| {
        tiers.iter().map(move |tier| {
            let [mean, worst] = ["mean", "worst"].map(|what| figure(number, tier, what).map(grouped));
            mean.zip(worst).map_or("–".into(), |(mean, worst)| format!("{mean} ({worst})"))
        })
    });
    let solved = OF_WORKLOADS
        .map(|(number, _)| figure(number, "Stable", "solved, %").map_or("–".to_string(), |share| share.to_string()));
    row(text, cells(of, cost.chain([solved.join(" / ")])));
}

/// What users do: pictures, a range sensor, each solid as it is placed.
fn workloads(text: &mut String, figures: &Figures, away_from_grazing: &Figures) {
    text.push_str(
        "## What users do\n\nInstructions of a nearest hit, each query counted by itself: the mean and, in brackets, the worst of a hundred. *Left* is how many of a hundred queries in `Stable` the first numbers of the tier pass on to wider ones, for each of these number types in the order of their columns. `f32` `Exact` computes in doubles first, for which this machine has hardware; on a chip without it the doubles take most of the instructions ([microcontrollers.md](microcontrollers.md)). `I16F16` `Exact` computes in integers first, except for stretched solids.\n\n\
         The rays of a picture are those through its pixels, those from the objects that they hit to a lamp, and those mirrored there. In the built-in scenes glass refracts rays too, up to three times; the still life has \
         no mirrors. Each ray tests the objects whose boxes it meets; in the built-in scenes it tests all objects. The range sensor has 64 zones, one row of them level, and forty solids 1 to 200 metres away, most of them upright. The other solids \
         are about as large as the unit ball; *moved* and *turned* are frames, *stretched* is a matrix, *near* is 2 to 6 away and *far* 20 to 1,000; each query \
         has a placement of its own. *Departing* rays leave the surface of the solid itself, outwards or inwards.\n\n",
    );
    let titles: Vec<_> = OF_WORKLOADS
        .iter()
        .flat_map(|(number, tiers)| tiers.iter().map(move |tier| format!("`{number}` `{tier}`")))
        .chain(["left, %".to_string()])
        .collect();
    head(text, cells("rays", titles));
    let pictures = PICTURES.map(String::from).into_iter();
    let solids = SOLIDS_BY_NAME.into_iter().flat_map(|solid| {
        PLACEMENTS.into_iter().flat_map(move |placed| RAYS.into_iter().map(move |rays| of_solid(solid, placed, rays)))
    });
    let all: Vec<_> = pictures.chain([RANGE_SENSOR.to_string()]).chain(solids).collect();
    for of in &all {
        workload(text, figures, of);
    }
    tail(text, figures, &all);
    tail_away_from_grazing(text, away_from_grazing);
    text.push_str(
        "\n### How far off these answers are\n\nThe results are compared with those of `Exact`, whose `t` is within a unit of the exact one and whose decisions are exact. The figures are the largest error of `t` in units in the last place and, in brackets, how many of a hundred results are a \
         hit for a miss, a miss for a hit or a hit on another part. Rows in which all errors are within 1 unit and no result is wrong are left out. Errors over many more rays, and the hard ones: \
         [accuracy.md](accuracy.md).\n\n",
    );
    const OFF: [(&str, &str); 6] = [
        ("f32", "Plain"),
        ("f32", "Fast"),
        ("f32", "Stable"),
        ("I16F16", "Plain"),
        ("I16F16", "Fast"),
        ("I16F16", "Stable"),
    ];
    head(text, cells("rays", OFF.map(|(number, tier)| format!("`{number}` `{tier}`"))));
    for of in &all {
        let told = OFF.map(|(number, tier)| {
            let figure =
                |what: &str| figures.get(&format!("{of} | {number} | {tier} | {what}")).copied().unwrap_or_default();
            (figure("off, units"), figure("wrong"))
        });
        if told.iter().any(|(units, wrong)| *units > 1 || *wrong > 0) {
            row(text, cells(of, told.map(|(units, wrong)| format!("{} ({wrong})", grouped(units)))));
        }
    }
    text.push('\n');
}

/// The workloads of a number type and tier, each with a quantile of its costs over their mean.
fn tails<'a>(figures: &Figures, all: &'a [String], [number, tier, quantile]: [&str; 3]) -> Vec<(f64, &'a str)> {
    let figure = |of: &str, what: &str| figures.get(&format!("{of} | {number} | {tier} | {what}")).copied();
    let tail = |of: &'a String| Some((figure(of, quantile)? as f64 / figure(of, "mean")? as f64, of.as_str()));
    let mut tails: Vec<_> = all.iter().filter_map(tail).collect();
    tails.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    tails
}

/// How much more than the mean the most expensive queries take.
fn tail(text: &mut String, figures: &Figures, all: &[String]) {
    let _ = write!(
        text,
        "\n### How much the expensive rays take\n\nThe ratio of the instructions of the second most expensive of a hundred queries (*99 %*), and of the most expensive one (*worst*), to the mean of the same \
         workload: the median and the largest ratio of the {} workloads, and how many of them have a 99 % above {MANY} times their mean. Grazing rays are among them as often as they occur by chance.\n\n",
        all.len()
    );
    let rows = OF_WORKLOADS.iter().flat_map(|(number, tiers)| tiers.iter().map(move |tier| [*number, *tier]));
    ratios(text, figures, all, "99 %", rows);
}

/// The median and the largest ratio of a quantile, and of the worst, to the mean.
fn ratios<'a>(
    text: &mut String,
    figures: &Figures,
    all: &[String],
    quantile: &str,
    rows: impl IntoIterator<Item = [&'a str; 2]>,
) {
    let [median, greatest] = ["median", "greatest"].map(|of| format!("{quantile}, {of}"));
    let over = format!("{quantile} above {MANY}");
    head(
        text,
        ["number, tier", &median, &greatest, "of", &over, "worst, median", "worst, greatest", "of"].map(String::from),
    );
    for [number, tier] in rows {
        let [most, worst] = [quantile, "worst"].map(|quantile| tails(figures, all, [number, tier, quantile]));
        let (Some(greatest_most), Some(greatest_worst)) = (most.last(), worst.last()) else { continue };
        let median = |tails: &[(f64, &str)]| format!("{:.1}", tails[tails.len() / 2].0);
        let greatest = |(ratio, of): &(f64, &str)| [format!("{ratio:.1}"), of.to_string()];
        let above = most.iter().filter(|(ratio, _)| *ratio > MANY).count().to_string();
        let cells = [median(&most)].into_iter().chain(greatest(greatest_most)).chain([above]);
        let cells = cells.chain([median(&worst)]).chain(greatest(greatest_worst));
        row(text, [format!("`{number}` `{tier}`")].into_iter().chain(cells));
    }
}

/// The same of rays away from grazing; then the ratio of each solid and placement.
fn tail_away_from_grazing(text: &mut String, figures: &Figures) {
    let names = |solid, placed| ARRIVING.map(|rays| of_solid(solid, placed, rays));
    let rows = SOLIDS_BY_NAME.into_iter().flat_map(|solid| PLACEMENTS.into_iter().map(move |placed| (solid, placed)));
    let all: Vec<_> = rows.clone().flat_map(|(solid, placed)| names(solid, placed)).collect();
    let _ = write!(
        text,
        "\n### Rays away from grazing\n\nThe same of a thousand rays from near and from far that do not graze, for each solid and placement ({} workloads): the *99.9 %* is the second most expensive of them. A ray grazes a solid if it meets a side, a ball or a nappe whose radii \
         are a hundredth larger and not one whose radii are a hundredth smaller, or conversely; if its angle to an axis, a generator or a flat surface is less than a hundredth of a radian; or if it starts within a thousandth of a unit of an infinite surface.\n\n",
        all.len()
    );
    ratios(text, figures, &all, "99.9 %", NUMBERS_AWAY.map(|number| [number, "Stable"]));
    text.push_str("\nThe 99.9 % of each, in multiples of its mean, near / far:\n\n");
    head(text, cells("solid", NUMBERS_AWAY.map(|number| format!("`{number}`"))));
    for (solid, placed) in rows {
        let cell = |number: &str| {
            let ratio = |of: String| {
                let figure = |what: &str| figures.get(&format!("{of} | {number} | Stable | {what}")).copied();
                figure("99.9 %").zip(figure("mean")).map(|(most, mean)| format!("{:.1}", most as f64 / mean as f64))
            };
            names(solid, placed).map(|of| ratio(of).unwrap_or("–".into())).join(" / ")
        };
        row(text, cells(&format!("{solid}, {}", placed.name()), NUMBERS_AWAY.map(cell)));
    }
}

fn text(baseline: &Baseline) -> String {
    let figures = baseline.part(PART);
    let mut text = INTRODUCTION.to_string();
    let _ = write!(text, "Counted on {} with {}.\n\n", baseline.machine, baseline.compiler);
    workloads(&mut text, baseline.part(WORKLOADS), baseline.part(AWAY));
    query(&mut text, figures, "The nearest hit of rays from 2 to 6 away", "nearest");
    query(&mut text, figures, "Occlusion of rays from 2 to 6 away", "occlusion");
    surface(&mut text, figures);
    scenes(&mut text, figures);
    text
}

/// Makes what was counted the baseline, and writes the document.
pub fn renew(now: &Baseline) -> Outcome {
    println!(
        "{} figures: the baseline is renewed",
        [PART, WORKLOADS, AWAY].map(|part| now.part(part).len()).iter().sum::<usize>()
    );
    now.write(BASELINE)?;
    Ok(fs::write(in_repository(PATH), text(now))?)
}

/// An error if a figure got worse, or if the document does not show the baseline.
pub fn verify(now: &Baseline) -> Outcome {
    let baseline = Baseline::read(BASELINE, RENEW)?;
    baseline.compare(now, PART, "instructions", RENEW)?;
    baseline.compare(now, WORKLOADS, "instructions of what users do", RENEW)?;
    baseline.compare(now, AWAY, "instructions of rays away from grazing", RENEW)?;
    if fs::read_to_string(in_repository(PATH)).is_ok_and(|found| found == text(&baseline)) {
        Ok(())
    } else {
        Err(format!("{PATH} does not show the baseline: {RENEW}").into())
    }
}

/// What was counted on this machine.
pub fn counted(compiler: &str, Counted { cost, workloads, away_from_grazing }: Counted) -> Baseline {
    let mut baseline = Baseline::new(ARCH, compiler, PART, cost);
    for (part, figures) in [(WORKLOADS, workloads), (AWAY, away_from_grazing)] {
        baseline.parts.extend(Baseline::new(ARCH, compiler, part, figures).parts);
    }
    baseline
}
