//! `docs/which-one.md`: each piece of advice with the rows that back it, and the claims that it makes checked against
//! them.

use super::advice::{self, Advice, Claim, Row};
use super::markdown::{Table, instructions, length, link, row_ratios, short};
use crate::study::Study;
use std::error::Error;
use std::fmt::Write;
use support::figures::Figures;

const HEAD: &str = "\
# Which one do I take?

In short: take **`Stable` in the number type that your chip computes in**: `f32` with a single-precision unit, `f64` with a double-precision one,
`I16F16` (or another split of 32 bits) without. Take `Plain` where flash and time count most and rays start
near and do not graze, `Fast` where rays are aimed well and a few units do not matter, and `Exact` where a wrong hit,
miss or part would be a fault.

Below each piece of advice are the rows that support it: the 99.9 % error of `t` in units in the last place and as a length, hits lost or invented
of some 4,000 (*wrong*), the time on the host (1 is the textbook's sphere in `f32`) and instructions on the chips, hit / miss. Instructions in brackets are those of rays from 2 to 6
away; the rays of the row may take more. `cargo run --release -p raylet-accuracy -- --write` writes this page from the figures of [accuracy.md](accuracy.md), which has all other rows.
It compares what the advice claims of errors and instructions with these figures.

";

/// The first row of these names, or an error that says which there is not.
fn find<'a>(study: &'a Study, row: &Row) -> Result<&'a Figures, Box<dyn Error>> {
    let Row(number, tier, primitive, workload) = *row;
    study.row(number, tier, primitive, workload).ok_or_else(|| {
        format!("docs/which-one.md cites a row that is not measured: {number} {tier}, {primitive}, {workload}").into()
    })
}

fn evidence(study: &Study, rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let titles = ["number", "tier", "row", "99.9%", "length", "wrong", "host"].into_iter();
    let titles: Vec<_> = titles.chain(study.chips.iter().map(|chip| chip.name)).collect();
    let mut table = Table::new(&titles, 3);
    for name in rows {
        let row = find(study, name)?;
        let mut cells = vec![
            format!("`{}`", row.number),
            row.tier.to_string(),
            format!("[{}, {}]({})", row.primitive, row.name(), link(&row.number, row.primitive)),
            short(row.errors[1]),
            length(row.lengths[1]),
            row.wrong().to_string(),
            row_ratios(study, row),
        ];
        cells.extend(study.chips.iter().map(|chip| instructions(chip, row)));
        table.row(&cells);
    }
    Ok(table.done())
}

/// Instructions of a hit on a chip.
pub fn cost(study: &Study, chip: &str, row: &Row) -> Option<u64> {
    let row = find(study, row).ok()?;
    Some(study.chips.iter().find(|it| it.name == chip)?.instructions(row)?.hit)
}

/// What is wrong with a claim, if anything.
fn broken(study: &Study, claim: &Claim) -> Option<String> {
    match claim {
        Claim::Cheaper(chips, a, b) => chips.iter().find_map(|chip| {
            let costs = (cost(study, chip, a)?, cost(study, chip, b)?);
            (costs.0 >= costs.1).then(|| {
                format!("on {chip} `{}` {} takes {} instructions, `{}` {} {}", a.0, a.1, costs.0, b.0, b.1, costs.1)
            })
        }),
        Claim::Within(row, units) => {
            let found = find(study, row).ok()?;
            (found.errors[1] > *units)
                .then(|| format!("`{}` {}, {}, {}: {} units", row.0, row.1, row.2, row.3, found.errors[1]))
        }
        Claim::NeverWrong(number, tier) => {
            let of = |row: &&Figures| row.number == *number && row.tier == *tier;
            let wrong = study.rows.iter().filter(of).find(|row| row.counts[..4] != [0; 4])?;
            Some(format!("`{number}` {tier} is wrong in {}, {}", wrong.primitive, wrong.name()))
        }
        Claim::Wrong(row) => {
            let found = find(study, row).ok()?;
            (found.wrong() == 0).then(|| format!("`{}` {} is right in {}, {}", row.0, row.1, row.2, row.3))
        }
    }
}

fn one(study: &Study, advice: &Advice) -> Result<String, Box<dyn Error>> {
    let mut text = format!("**{}** {}\n\n", advice.situation, advice.take);
    for claim in &advice.claims {
        if let Some(why) = broken(study, claim) {
            let _ = write!(text, "**This does not hold any more:** {why}.\n\n");
        }
    }
    Ok(text + &evidence(study, &advice.rows)?)
}

/// The whole page.
pub fn document(study: &Study) -> Result<String, Box<dyn Error>> {
    let mut text = HEAD.to_string();
    for (title, all) in advice::sections(study) {
        let _ = write!(text, "## {title}\n\n");
        for advice in all {
            text.push_str(&one(study, &advice)?);
        }
    }
    Ok(text.trim_end().to_string() + "\n")
}
