//! The tables that the README shows.

use super::markdown::{Table, between_marks, length, row_ratios, short};
use crate::study::Study;
use support::figures::{NUMBERS, TIERS};

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

/// What a placed sphere costs.
pub fn costs(study: &Study) -> String {
    let chips = study.chips.iter().map(|chip| chip.name.to_string());
    let titles = ["number", "tier", "99.9 % error", "host"].map(String::from).into_iter().chain(chips);
    let mut table = Table::new(&titles.collect::<Vec<_>>(), 2);
    for number in NUMBERS {
        for tier in TIERS {
            let Some(row) = study.row(number, tier, "sphere", "benign, turned") else { continue };
            let mut cells = vec![format!("`{number}`"), format!("`{tier}`"), length(row.lengths[1])];
            if tier == "Textbook" {
                cells[1] = "textbook".into();
            }
            cells.push(row_ratios(study, row));
            cells.extend(study.chips.iter().map(|chip| super::markdown::instructions(chip, row)));
            table.row(&cells);
        }
    }
    table.done()
}

/// The README with its tables written anew.
pub fn document(readme: &str, study: &Study) -> Result<String, String> {
    let missing =
        |name: &str| format!("README.md has no marks `<!-- {name}: ... -->` and `<!-- /{name} -->` for its table");
    let errors = errors(study).ok_or("a row that the README shows was not measured")?;
    let text = between_marks(readme, "bounds", &errors).ok_or_else(|| missing("bounds"))?;
    between_marks(&text, "costs", &costs(study)).ok_or_else(|| missing("costs"))
}
