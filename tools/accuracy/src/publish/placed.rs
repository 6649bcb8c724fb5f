//! Placed solids against those that are not placed.

use super::front::{KINDS, largest};
use super::markdown::{NONE, Table, short};
use crate::study::Study;
use support::figures::{Figures, NUMBERS, TIERS};
use support::subject::SUBJECTS;

/// How the solid is placed, and how the table calls it. Nothing is promised of larger stretches.
const PLACES: [(&str, &str); 4] =
    [("-", "not placed"), ("moved", "moved"), ("turned", "turned"), ("stretched by 1/30 to 30", "stretched")];

/// The largest errors of rows, and how many hits are wrong.
fn cell<'a>(rows: impl Iterator<Item = &'a Figures> + Clone) -> String {
    let (_, is_well_aimed) = KINDS[0];
    let ([.., aimed], _) = largest(rows.clone().filter(|row| is_well_aimed(&row.workload)));
    let ([.., worst], wrong) = largest(rows.clone());
    let wrong = wrong + rows.clone().map(|row| row.counts[3]).sum::<usize>();
    let broken: usize = rows.clone().map(|row| row.broken).sum();
    let told = |count: usize, what: &str| if count > 0 { format!("; {count} {what}") } else { String::new() };
    let told = told(wrong, "wrong") + &told(broken, "broken");
    if rows.count() == 0 { NONE.into() } else { format!("{} / {}{told}", short(aimed), short(worst)) }
}

/// A table with a line a primitive and placement; with a line a placement if all primitives are taken together.
pub fn table(study: &Study, together: bool) -> String {
    let of = |number: &str, tier: &str| study.rows.iter().any(|row| row.number == number && row.tier == tier);
    let all = NUMBERS.iter().flat_map(|number| TIERS.iter().map(move |tier| (*number, *tier)));
    let columns: Vec<_> = all.filter(|(number, tier)| *tier != "Textbook" && of(number, tier)).collect();
    let titles = columns.iter().map(|(number, tier)| format!("`{number}` {tier}"));
    let names = ["primitive", "placed"].map(String::from)[usize::from(together)..].to_vec();
    let mut table = Table::new(&names.iter().cloned().chain(titles).collect::<Vec<_>>(), names.len());
    let primitives: Vec<_> = if together { vec!["all"] } else { SUBJECTS.to_vec() };
    for primitive in primitives {
        for (placed, name) in PLACES {
            let of = |row: &&Figures| row.placed == placed && (together || row.primitive == primitive);
            let rows: Vec<_> = study.rows.iter().filter(of).collect();
            let cells = columns.iter().map(|(number, tier)| {
                cell(rows.iter().copied().filter(|row| row.number == *number && row.tier == *tier))
            });
            let names = [primitive.to_string(), name.into()][usize::from(together)..].to_vec();
            table.row(&names.into_iter().chain(cells).collect::<Vec<_>>());
        }
    }
    table.done()
}
