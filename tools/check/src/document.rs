//! The baselines of the chips as tables: those of `docs/microcontrollers.md`, `docs/gallery.md` and `docs/displays.md`,
//! and all others to be printed. Also the tables of `docs/errors.md`.

use crate::chip::{self, Part};
use crate::effects::{GALLERY_FIGURES, key};
use crate::sets::{NUMBERS, SETS, SHAPE, USES};
use crate::{cost, frames, kinds, size};
use raylet_tables::markdown::{NONE, Table};
use raylet_tables::{Baseline, CHIPS, Cell, Figures, Outcome, SUBJECTS, grouped, in_repository, joined, page, pivot};
use raylet_tables::{Place, mean_and_worst, together};

/// A chip, and what it takes.
struct Measured {
    name: &'static str,
    /// In instructions and bytes.
    counted: Baseline,
    /// In modelled cycles.
    modelled: Baseline,
}

fn chips() -> Outcome<Vec<Measured>> {
    let read =
        |(target, name)| Ok(Measured { name, counted: chip::baseline(target)?, modelled: chip::cycles(target)? });
    CHIPS.into_iter().map(read).collect()
}

/// Hit / miss.
fn hit_and_miss(cell: &Cell<'_>) -> String {
    joined(cell, &["hit", "miss"])
}

/// A query of every solid in every number type and tier.
fn query<'a>(figures: &'a Figures, query: &str, cell: impl Fn(&Cell<'_>) -> String) -> String {
    let place = |parts: &[&'a str]| match *parts {
        [subject, of, number, tier, what] if of == query => Some((vec![subject], vec![number, tier], what)),
        _ => None,
    };
    pivot(&["solid"], figures, place, cell)
}

/// Figures with names of three or four parts, the last of them in the cell.
fn others<'a>(figures: &'a Figures, wanted: impl Fn(&str) -> bool, cell: impl Fn(&Cell<'_>) -> String) -> String {
    let place = |parts: &[&'a str]| {
        let [row, column @ .., what] = parts else { return None };
        wanted(row).then(|| (vec![*row], column.to_vec(), *what))
    };
    pivot(&["what"], figures, place, cell)
}

/// Figures of a part of all chips: a column a chip.
fn compared(
    chips: &[Measured],
    part: Part,
    titles: &[&str],
    place: impl for<'a> Fn(&[&'a str]) -> Option<Place<'a>>,
    cell: impl Fn(&Cell<'_>) -> String,
) -> String {
    let figures = together(chips.iter().map(|of| (of.name, part.figures(&of.counted))));
    pivot(titles, &figures, |parts| place(parts), cell)
}

/// What the library takes of flash and stack: a shape of any primitive and placement, and pictures of them.
fn uses(chips: &[Measured]) -> String {
    let names = chips
        .iter()
        .flat_map(|of| [format!("{}, flash", of.name), "stack".into(), "instructions".into(), "cycles".into()]);
    let mut table = Table::new(&["use", "number"].map(String::from).into_iter().chain(names).collect::<Vec<_>>(), 2);
    let show = |figure: Option<u64>| figure.map_or(NONE.into(), grouped);
    let of_cost = |baseline: &Baseline, subject: &str, number: &str, what: &str| {
        Part::Cost.figure(baseline, &cost::key(subject, "nearest", number, "Stable", what))
    };
    for number in NUMBERS {
        let mut row = |name: &str, figures: &dyn Fn(&Measured) -> [Option<u64>; 4]| {
            let cells = chips.iter().flat_map(|of| figures(of).map(show));
            table.row(&[name, number].map(String::from).into_iter().chain(cells).collect::<Vec<_>>());
        };
        row(SENSOR, &|of| {
            let stack = |subject| of_cost(&of.counted, subject, number, "stack");
            [
                Part::Size.figure(&of.counted, &size::key(SHAPE, [number, "Stable"])),
                SUBJECTS.into_iter().chain([SENSOR]).filter_map(stack).max(),
                of_cost(&of.counted, SENSOR, number, "hit"),
                of_cost(&of.modelled, SENSOR, number, "hit"),
            ]
        });
        for (name, (_, set)) in [("picture, no effects", SETS[0]), ("picture, all effects", SETS[SETS.len() - 1])] {
            row(name, &|of| {
                let figure = |baseline, what: &str| Part::Effects.figure(baseline, &key(set, number, what));
                [
                    Part::Size.figure(&of.counted, &key(set, number, "bytes")),
                    figure(&of.counted, "stack"),
                    figure(&of.counted, "instructions"),
                    figure(&of.modelled, "instructions"),
                ]
            });
        }
        for of_kinds in &USES {
            row(of_kinds.name, &|of| [Part::Size.figure(&of.counted, &kinds::key(of_kinds, number)), None, None, None]);
        }
    }
    table.done()
}

/// The tests of a range sensor, as a subject.
const SENSOR: &str = "range sensor";

/// Cycles an instruction of a nearest hit, the median over solids and tiers; the textbook is left out.
fn cycles(chips: &[Measured]) -> String {
    let titles = ["number"].into_iter().chain(chips.iter().map(|of| of.name)).collect::<Vec<_>>();
    let mut table = Table::new(&titles, 1);
    for number in ["I16F16", "f32", "I32F32", "f64"] {
        let is_of = |name: &str| {
            let parts: Vec<_> = name.split(" | ").collect();
            matches!(parts[..], [solid, "nearest", of, tier, "hit"]
                if of == number && SUBJECTS.contains(&solid) && !tier.starts_with("textbook"))
        };
        let ratio = |of: &Measured| {
            let counted = Part::Cost.figures(&of.counted).iter().filter(|(name, _)| is_of(name));
            let mut ratios: Vec<_> = counted
                .filter_map(|(name, counted)| Some(Part::Cost.figure(&of.modelled, name)? as f64 / *counted as f64))
                .collect();
            ratios.sort_by(f64::total_cmp);
            ratios.get(ratios.len() / 2).map_or(NONE.into(), |ratio| format!("{ratio:.2}"))
        };
        table.row(&[number.to_string()].into_iter().chain(chips.iter().map(ratio)).collect::<Vec<_>>());
    }
    table.done()
}

/// The frames of the animation: how many rows each draws, and instructions on each chip.
fn frames(chips: &[Measured]) -> Outcome<String> {
    let titles = ["frame", "rows"].into_iter().chain(chips.iter().map(|of| of.name)).collect::<Vec<_>>();
    let mut table = Table::new(&titles, 1);
    for (frame, rows) in frames::rows()?.into_iter().enumerate() {
        let instructions =
            |of: &Measured| Part::Frames.figure(&of.counted, &frames::key(frame)).map_or(NONE.into(), grouped);
        let start = [frame.to_string(), rows.to_string()];
        table.row(&start.into_iter().chain(chips.iter().map(instructions)).collect::<Vec<_>>());
    }
    Ok(table.done())
}

/// A picture of the gallery: its command, what that said, and the cost of a pixel.
fn picture(chips: &[Measured], name: &str) -> Outcome<String> {
    let text = std::fs::read_to_string(in_repository(&format!("docs/gallery/{name}.txt")))
        .map_err(|error| format!("{name}: {error}; `.ci/gallery --renew` draws it"))?;
    let (command, said) = text.split_once('\n').unwrap_or((&text, ""));
    let costs = chips.iter().filter_map(|of| {
        let figure = |number| Part::Gallery.figure(&of.counted, &key(name, number, GALLERY_FIGURES[0])).map(grouped);
        let (fixed, float) = (figure("I16F16")?, figure("f32")?);
        Some(format!("- {}: {fixed} instructions a pixel in I16F16, {float} in f32\n", of.name))
    });
    let said = said.lines().map(|line| format!("- {line}\n")).chain(costs);
    Ok(format!("```sh\n{command}\n```\n\n{}\n", said.collect::<String>()))
}

/// How pictures of a scene differ from that in `f64`.
fn errors(scene: &str) -> Outcome<String> {
    let stored = raylet_tables::Table::read("data/errors.tsv", ".ci/errors --renew")?;
    let titles = ["number and tier", "pixels that differ", "by more than a level", "greatest difference, levels"];
    let titles = titles.into_iter().chain(["instructions a ray", "difference, 32 times as large"]).collect::<Vec<_>>();
    let mut table = Table::new(&titles, 1);
    for row in stored.rows.iter().filter(|row| row[0] == scene) {
        let [_, number, tier, differing, more, greatest, instructions] = &row[..] else {
            return Err("data/errors.tsv has seven columns".into());
        };
        let suffix = if tier == "stable" { String::new() } else { format!("-{tier}") };
        let picture = format!("![difference](errors/{scene}-{number}{suffix}.png)");
        let picture = if number == "f64" { NONE.into() } else { picture };
        let figures = [differing, more, greatest, instructions].map(|figure| figure.replace('-', NONE));
        table.row(&[format!("{number} {tier}")].into_iter().chain(figures).chain([picture]).collect::<Vec<_>>());
    }
    Ok(table.done())
}

/// A table of a page, by the name of its mark.
fn table(chips: &[Measured], name: &str, about: &str) -> Outcome<String> {
    Ok(match name {
        "uses" => uses(chips),
        "frames" => frames(chips)?,
        "cycles" => cycles(chips),
        "picture" => picture(chips, about)?,
        "errors" => errors(about)?,
        "textbook" => compared(chips, Part::Cost, &["solid", "number", "tier"], place_of_solid, hit_and_miss),
        "users" => compared(chips, Part::Workload, &["rays"], place_of_user, mean_and_worst),
        "flash" => compared(chips, Part::Size, &["solid", "tier"], place_of_size, |cell| joined(cell, &["bytes"])),
        "pixels" => pixels(chips, Part::Effects),
        "display" => pixels(chips, Part::Display),
        _ => return Err(format!("there is no table `{name}`").into()),
    })
}

/// Of two solids the textbook and `Stable` in types of 32 bits.
fn place_of_solid<'a>(parts: &[&'a str]) -> Option<Place<'a>> {
    let [chip, solid @ ("sphere" | "cone, capped"), "nearest", number @ ("f32" | "I16F16"), tier, what] = *parts else {
        return None;
    };
    (tier == "Stable" || tier.starts_with("textbook")).then(|| (vec![solid, number, tier], vec![chip], what))
}

/// Of rays of users a few, in `Stable`.
fn place_of_user<'a>(parts: &[&'a str]) -> Option<Place<'a>> {
    let [chip, of, number @ ("f32" | "I16F16"), "Stable", what] = *parts else { return None };
    let is_shown = match of.strip_suffix(", turned, near") {
        Some(solid) => matches!(solid, "sphere" | "cylinder, capped" | "cone, capped" | "triangle"),
        None => of == SENSOR || of.starts_with("picture") || of.starts_with("a ball against a "),
    };
    is_shown.then(|| (vec![of], vec![chip, number], what))
}

/// Bytes of programs with one ball or cone, or any solid.
fn place_of_size<'a>(parts: &[&'a str]) -> Option<Place<'a>> {
    let [chip, solid @ ("sphere" | "cone" | SHAPE), number, tier @ ("Plain" | "Stable" | "Exact")] = *parts else {
        return None;
    };
    Some((vec![solid, tier], vec![chip, number], "bytes"))
}

/// Instructions a pixel.
fn pixels(chips: &[Measured], part: Part) -> String {
    compared(chips, part, &["effects", "number", "tier"], place_of_pixel, |cell| joined(cell, &["instructions"]))
}

/// The nearest hit, light, and shadows in pictures of every tier; and a scene of the gallery.
fn place_of_pixel<'a>(parts: &[&'a str]) -> Option<Place<'a>> {
    let [chip, of, number, "instructions"] = *parts else { return None };
    let (set, tier) = of.split_once("; ").unwrap_or((of, "Stable"));
    let is_shown = matches!(set, "none" | "diffuse" | "diffuse, specular, shadows" | "still-life");
    let is_shown = is_shown || set.ends_with(", by spans");
    is_shown.then(|| (vec![set, number, tier], vec![chip], "instructions"))
}

/// Every table of a chip.
pub fn printed(chip: &str) -> Outcome<String> {
    let named = |of: &Measured| of.name == chip || CHIPS.contains(&(chip, of.name));
    let Some(Measured { name, counted, modelled }) = chips()?.into_iter().find(named) else {
        let names = CHIPS.map(|(target, name)| format!("{name} ({target})")).join(", ");
        return Err(format!("there is no chip `{chip}`: give one of {names}").into());
    };
    let (costs, cycles) = (Part::Cost.figures(&counted), Part::Cost.figures(&modelled));
    let of = |what: &'static str| move |cell: &Cell<'_>| joined(cell, &[what]);
    let all = |_: &str| true;
    let is_set = |row: &str| SETS.iter().any(|(_, set)| *set == row);
    let is_set_in_tier = |row: &str| is_set(row.split("; ").next().unwrap_or(row));
    let size = Part::Size.figures(&counted);
    let solids: Figures = size
        .iter()
        .filter(|(name, _)| !name.ends_with(" | bytes"))
        .map(|(name, bytes)| (format!("{name} | bytes"), *bytes))
        .collect();
    let least = Part::LeastCost.figures(&modelled);
    let tables = [
        ("The nearest hit, instructions: hit / miss", query(costs, "nearest", hit_and_miss)),
        ("The nearest hit, modelled cycles: hit / miss", query(cycles, "nearest", hit_and_miss)),
        ("The nearest hit, the least of the model's ranges", query(least, "nearest", hit_and_miss)),
        ("The nearest hit, bytes of stack", query(costs, "nearest", of("stack"))),
        ("All hits, instructions: hit / miss", query(costs, "all hits", hit_and_miss)),
        ("Occlusion, instructions: hit / miss", query(costs, "occlusion", hit_and_miss)),
        ("Normal at a known hit, instructions", query(costs, "normal", hit_and_miss)),
        ("Surface coordinates at a known hit, instructions", query(costs, "uv", hit_and_miss)),
        (
            "What users do, instructions: the mean (the worst)",
            others(Part::Workload.figures(&counted), all, mean_and_worst),
        ),
        ("What users do, modelled cycles: the mean", others(Part::Workload.figures(&modelled), all, of("mean"))),
        ("Bytes of a program with one solid", others(&solids, all, of("bytes"))),
        (
            "Bytes of pictures and of programs of chosen kinds",
            others(size, |row| is_set(row) || row.contains(", "), of("bytes")),
        ),
        (
            "Effects, instructions a pixel: alone / among all",
            others(Part::Effects.figures(&counted), is_set_in_tier, |cell| {
                joined(cell, &["instructions", "instructions among all"])
            }),
        ),
        ("Effects, modelled cycles a pixel", others(Part::Effects.figures(&modelled), is_set, of("instructions"))),
        (
            "Effects, bytes of stack: alone / among all",
            others(Part::Effects.figures(&counted), is_set_in_tier, |cell| joined(cell, &["stack", "stack among all"])),
        ),
        (
            "The gallery, instructions a pixel / rays",
            others(Part::Gallery.figures(&counted), all, |cell| joined(cell, &GALLERY_FIGURES)),
        ),
    ];
    let shown = tables.iter().filter(|(_, table)| table.lines().count() > 3);
    let text = shown.fold(String::new(), |text, (title, table)| text + &format!("\n## {title}\n\n{table}"));
    Ok(format!("# {name}\n\nCompiler: {}.\n{text}", counted.compiler))
}

/// Writes the tables of the pages, or says whether they are as they should be.
pub fn write(verify: bool) -> Outcome {
    let chips = chips()?;
    for path in ["docs/microcontrollers.md", "docs/gallery.md", "docs/errors.md", "docs/displays.md"] {
        let text = page::renewed(path, |name, about, _| table(&chips, name, about))?;
        page::put(path, &text, verify, ".ci/measure --document")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pages_show_the_baselines() {
        write(true).unwrap();
    }

    #[test]
    fn every_chip_is_printed() {
        for (target, name) in CHIPS {
            let text = printed(target).unwrap();
            assert_eq!(text, printed(name).unwrap());
            let rows = ["| sphere |", "| triangle, framed |", "| none |", "| range sensor |", "| shape |"];
            assert!(rows.iter().all(|row| text.contains(row)), "{name}: {text}");
            assert!(!text.contains("|---|\n\n"), "{name}: an empty table");
        }
        assert!(printed("6502").is_err());
    }
}
