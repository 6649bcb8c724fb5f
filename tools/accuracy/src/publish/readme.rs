//! The tables of the README and of docs/overview.md.

use super::markdown::{NONE, Table, few_digits, instructions, length, row_ratios, short};
use crate::chips::Chip;
use crate::study::Study;
use raylet_tables::grouped;
use support::figures::{Figures, NUMBERS, TIERS};

/// Few rows of errors.
pub fn errors(study: &Study) -> Option<String> {
    const SHOWN: [(&str, &str); 5] =
        [("Fast", "f32"), ("Stable", "f32"), ("Exact", "f32"), ("Stable", "I16F16"), ("Exact", "I16F16")];
    let titles = SHOWN.map(|(tier, number)| format!("`{tier}` `{number}`"));
    let mut table = Table::new(&[vec!["solid".to_string(), "rays".into()], titles.to_vec()].concat(), 7);
    for primitive in ["sphere", "cylinder capped", "cone capped"] {
        for workload in ["benign", "10000 away", "grazing 1e-4", "grazing 1e-7"] {
            let mut cells = vec![primitive.to_string(), workload.to_string()];
            for (tier, number) in SHOWN {
                let row = study.row(number, tier, primitive, workload)?;
                let told = if row.wrong() > 0 { format!(" ({})", row.wrong()) } else { String::new() };
                cells.push(format!("{} / {}{told}", short(row.errors[0]), short(row.errors[2])));
            }
            table.row(&cells);
        }
    }
    Some(table.done())
}

/// What a placed sphere costs, in every number type and tier.
pub fn costs(study: &Study) -> String {
    let mut rows = vec![];
    for number in NUMBERS {
        for tier in TIERS {
            rows.extend(placed_sphere(study, number, tier));
        }
    }
    cost_table(study, &rows)
}

/// The same in the few number types and tiers that the README shows.
fn few_costs(study: &Study) -> Option<String> {
    const SHOWN: [(&str, &str); 4] = [("f32", "Fast"), ("f32", "Stable"), ("I16F16", "Stable"), ("I16F16", "Exact")];
    let mut rows = vec![];
    for (number, tier) in SHOWN {
        rows.push(placed_sphere(study, number, tier)?);
    }
    Some(cost_table(study, &rows))
}

fn placed_sphere<'a>(study: &'a Study, number: &str, tier: &str) -> Option<&'a Figures> {
    study.row(number, tier, "sphere", "benign, turned")
}

fn cost_table(study: &Study, rows: &[&Figures]) -> String {
    let chips = study.chips.iter().map(|chip| chip.name.to_string());
    let titles = ["number", "tier", "99.9 % error", "host"].map(String::from).into_iter().chain(chips);
    let mut table = Table::new(&titles.collect::<Vec<_>>(), 2);
    for row in rows {
        let mut cells =
            vec![format!("`{}`", row.number), tier_name(row.tier), length(row.lengths[1]), row_ratios(study, row)];
        cells.extend(study.chips.iter().map(|chip| instructions(chip, row)));
        table.row(&cells);
    }
    table.done()
}

/// All tiers for two solids in a turned frame: errors near, far away and where rays graze, beside the cost.
/// The textbook is the first row of each.
fn tiers(study: &Study, host: &Chip) -> Option<String> {
    const NUMBER: &str = "f32";
    const CHIP: &str = "Cortex-M4F";
    const RAYS: [(&str, &str); 3] = [
        ("near", "benign, turned"),
        ("grazing to 1e-4", "grazing 1e-4, turned"),
        ("10,000 away", "10000 away, turned"),
    ];
    let chip = study.chips.iter().find(|chip| chip.name == CHIP)?;
    let costs = ["host".to_string(), CHIP.into(), "flash".into()];
    let titles = ["solid", "tier"].into_iter().chain(RAYS.map(|(title, _)| title)).map(String::from).chain(costs);
    let mut table = Table::new(&titles.collect::<Vec<_>>(), 2);
    for primitive in ["sphere", "cone capped"] {
        for tier in TIERS {
            let near = study.row(NUMBER, tier, primitive, RAYS[0].1)?;
            let mut cells = vec![primitive.to_string(), tier_name(tier)];
            for (_, rays) in RAYS {
                let row = study.row(NUMBER, tier, primitive, rays)?;
                let wrong = if row.wrong() > 0 { format!(" ({})", row.wrong()) } else { String::new() };
                let error = row.lengths[1];
                cells.push(format!("{}{wrong}", if error < 1.0 { length(error) } else { few_digits(error) }));
            }
            cells.extend([host, chip].map(|of| instructions(of, near)));
            cells.push(chip.flash(near).map_or(NONE.into(), grouped));
            table.row(&cells);
        }
    }
    Some(format!(
        "All tiers in `{NUMBER}`, for a sphere and a capped cone in a turned frame. The columns *near* (3 to 8 away),\n\
         *grazing to 1e-4* (past the side, at 1e-4 of the size from touching) and *10,000 away* are 99.9 % errors; in\n\
         brackets is how many of some {} hits are lost or invented. *Textbook* is the formula above after the\n\
         same transformation. *Host* and *{CHIP}* are instructions of a nearest hit, hit / miss, of the near\n\
         rays; *flash* is bytes of a program with one such solid on the {CHIP}.\n\n{}",
        grouped(2 * study.rays.placed as u64),
        table.done()
    ))
}

/// A tier as a table calls it.
fn tier_name(tier: &str) -> String {
    if tier == "Textbook" { "textbook".into() } else { format!("`{tier}`") }
}

/// The tables of the README.
pub fn placed(study: &Study, host: &Chip) -> Option<String> {
    Some(few_costs(study)? + &tiers(study, host)?)
}
