//! Rows of errors and costs that a page cites, and what it claims of them: `docs/which-one.md`.

use super::markdown::{Table, instructions, length, row_ratios, short};
use crate::study::Study;
use raylet_tables::Outcome;
use support::figures::Figures;

/// The row that a text names, such as `f32 Stable, sphere, benign, turned`.
fn find<'a>(study: &'a Study, name: &str) -> Outcome<&'a Figures> {
    let row = match name.splitn(3, ", ").collect::<Vec<_>>()[..] {
        [kind, primitive, workload] => kind
            .split_once(' ')
            .and_then(|(number, tier)| study.row(number.trim(), tier.trim(), primitive, workload.trim())),
        _ => None,
    };
    row.ok_or_else(|| format!("there is no row `{name}` (number tier, primitive, workload)").into())
}

/// A table with the rows that a table has, their figures written anew: to add a row, add its three names.
pub fn table(study: &Study, held: &str) -> Outcome<String> {
    let titles = ["number", "tier", "row", "99.9%", "length", "wrong", "host"].into_iter();
    let titles: Vec<_> = titles.chain(study.chips.iter().map(|chip| chip.name)).collect();
    let mut table = Table::new(&titles, 3);
    for line in held.lines().filter(|line| line.starts_with("| `")) {
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        let [_, number, tier, row, ..] = cells[..] else { return Err(format!("`{line}` names no row").into()) };
        let row = find(study, &format!("{} {tier}, {row}", number.trim_matches('`')))?;
        let mut cells = vec![
            format!("`{}`", row.number),
            row.tier.to_string(),
            format!("{}, {}", row.primitive, row.name()),
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
fn cost(study: &Study, chip: &str, name: &str) -> Outcome<u64> {
    let chip = study.chips.iter().find(|it| it.name == chip).ok_or(format!("there is no chip `{chip}`"))?;
    let told = chip.instructions(find(study, name)?).ok_or(format!("{name} is not counted on chips"))?;
    Ok(told.hit)
}

/// Whether a claim holds:
///
/// - `ROW within UNITS`: its 99.9 % error is at most so many units in the last place;
/// - `ROW < ROW on CHIP, CHIP`: it takes fewer instructions there, of rays that hit;
/// - `ROW is wrong`: hits are lost or invented there;
/// - `NUMBER TIER is never wrong`: no hit of any row is lost, invented or on another part.
fn holds(study: &Study, claim: &str) -> Outcome<bool> {
    if let Some((row, units)) = claim.split_once(" within ") {
        return Ok(find(study, row)?.errors[1] <= units.parse::<f64>()?);
    }
    if let Some(kind) = claim.strip_suffix(" is never wrong") {
        let of = |row: &&Figures| format!("{} {}", row.number, row.tier) == kind;
        let mut rows = study.rows.iter().filter(of).peekable();
        return Ok(rows.peek().is_some() && rows.all(|row| row.counts[..4] == [0; 4]));
    }
    if let Some(row) = claim.strip_suffix(" is wrong") {
        return Ok(find(study, row)?.wrong() > 0);
    }
    let parts = claim.split_once(" < ").and_then(|(less, rest)| Some((less, rest.split_once(" on ")?)));
    let (less, (more, chips)) = parts.ok_or("that is no claim")?;
    for chip in chips.split(", ") {
        if cost(study, chip, less)? >= cost(study, chip, more)? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// An error if one of the claims, one a line, does not hold.
pub fn check(study: &Study, claims: &str) -> Outcome {
    for claim in claims.lines() {
        match holds(study, claim) {
            Ok(true) => {}
            Ok(false) => return Err(format!("this does not hold any more: {claim}").into()),
            Err(error) => return Err(format!("{claim}: {error}").into()),
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stored;

    #[test]
    fn claims_hold_or_do_not() {
        let study = stored::study().unwrap();
        for (claim, wanted) in [
            ("f32 Stable, sphere, benign within 16", Some(true)),
            ("f32 Stable, sphere, benign within 0.1", Some(false)),
            ("f32 Fast, sphere, benign < f32 Exact, sphere, benign on Cortex-M0+, RV32IMC", Some(true)),
            ("f32 Exact, sphere, benign < f32 Fast, sphere, benign on Cortex-M0+, RV32IMC", Some(false)),
            ("f32 Textbook, sphere, 10000 away is wrong", Some(true)),
            ("f32 Exact, sphere, benign is wrong", Some(false)),
            ("f32 Exact is never wrong", Some(true)),
            ("f32 Fast is never wrong", Some(false)),
            ("f32 Fsat is never wrong", Some(false)),
            ("f32 Exact, sphere, nowhere within 1", None),
            ("all is well", None),
        ] {
            assert_eq!(holds(&study, claim).ok(), wanted, "{claim}");
        }
    }
}
