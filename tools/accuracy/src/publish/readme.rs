//! The tables of the README and of docs/overview.md.

use super::markdown::{Table, between_marks, length, row_ratios, short};
use crate::study::Study;
use support::figures::{Figures, NUMBERS, TIERS};

/// Few rows of errors.
fn errors(study: &Study) -> Option<String> {
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
        let tier = if row.tier == "Textbook" { String::from("textbook") } else { format!("`{}`", row.tier) };
        let mut cells = vec![format!("`{}`", row.number), tier, length(row.lengths[1]), row_ratios(study, row)];
        cells.extend(study.chips.iter().map(|chip| super::markdown::instructions(chip, row)));
        table.row(&cells);
    }
    table.done()
}

/// The README with its table written anew.
pub fn document(readme: &str, study: &Study) -> Result<String, String> {
    let costs = few_costs(study).ok_or("a row that the README shows was not measured")?;
    replaced(readme, "README.md", "placed", &costs)
}

/// docs/overview.md with its tables written anew.
pub fn overview(page: &str, study: &Study) -> Result<String, String> {
    const PAGE: &str = "docs/overview.md";
    let errors = errors(study).ok_or("a row that docs/overview.md shows was not measured")?;
    replaced(&replaced(page, PAGE, "bounds", &errors)?, PAGE, "costs", &costs(study))
}

/// The text of a page with the table between its marks replaced.
fn replaced(text: &str, page: &str, name: &str, table: &str) -> Result<String, String> {
    let missing = || format!("{page} has no marks `<!-- {name}: ... -->` and `<!-- /{name} -->` for its table");
    between_marks(text, name, table).ok_or_else(missing)
}
