//! Of `docs/accuracy.md`: placed solids against those that are not placed.

use super::front::{KINDS, largest};
use super::markdown::{NONE, Table, short};
use crate::study::Study;
use support::figures::{Figures, NUMBERS, TIERS};
use support::subject::SUBJECTS;

/// How the solid is placed, and how the table calls it. Nothing is promised of larger stretches.
const PLACES: [(&str, &str); 4] =
    [("-", "not placed"), ("moved", "moved"), ("turned", "turned"), ("stretched by 1/30 to 30", "stretched")];

const TEXT: &str = "\
## Placed solids

The promise of a tier holds for the solid as it is placed. The axes of a frame and the inverse of a stretch are taken as they are
stored; for a sphere in a frame only the position counts, since a turned sphere is the same sphere. The table has the largest error of `t` in units in the last place, of
well-aimed rays / of all workloads; how many hits are lost, invented or on another part (*wrong*); and for how many rays the tier does
not keep its promise (*broken*). The promise excuses wrong hits within a unit of touching or of a rim. Stretched solids are not measured with rays
along an axis or a generator, from inside, from the surface or departing. All rows are in [data/bounds](../data/bounds).

";

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

/// The section: one table, a line a primitive and placement, a column a number type and tier.
pub fn section(study: &Study) -> String {
    let of = |number: &str, tier: &str| study.rows.iter().any(|row| row.number == number && row.tier == tier);
    let all = NUMBERS.iter().flat_map(|number| TIERS.iter().map(move |tier| (*number, *tier)));
    let columns: Vec<_> = all.filter(|(number, tier)| *tier != "Textbook" && of(number, tier)).collect();
    let titles = columns.iter().map(|(number, tier)| format!("`{number}` {tier}"));
    let titles: Vec<_> = ["primitive".to_string(), "placed".into()].into_iter().chain(titles).collect();
    let mut table = Table::new(&titles, 2);
    for primitive in SUBJECTS {
        for (placed, name) in PLACES {
            let rows = study.rows.iter().filter(|row| row.primitive == primitive && row.placed == placed);
            let cells = columns
                .iter()
                .map(|(number, tier)| cell(rows.clone().filter(|row| row.number == *number && row.tier == *tier)));
            table.row(&[primitive.to_string(), name.into()].into_iter().chain(cells).collect::<Vec<_>>());
        }
    }
    format!("{TEXT}{}", table.done())
}
