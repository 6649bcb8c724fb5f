//! The bound table: primitive x tier x number type x workload. The rows are code, written by
//! `cargo run --release --example accuracy -- --write`; `tests/number_types.rs` holds the library to them.

// Some figures happen to look like famous ones.
#![allow(clippy::approx_constant)]

mod exact;
mod fast;
mod stable;
mod textbook;

use super::figures::Figures;
use std::fmt::Write;

/// Rays a row.
pub const RAYS: usize = 2000;

/// One row.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    pub number: &'static str,
    pub primitive: &'static str,
    pub workload: &'static str,
    pub hits: usize,
    /// Median, 99.9 % and worst error of `t`, in units in the last place.
    pub errors: [f64; 3],
    /// The same as lengths.
    pub lengths: [f64; 3],
    /// Lost, phantom, on the other side of the range's start, on another part or with another crossing, in integers.
    pub counts: [usize; 5],
}

const fn bound(
    number: &'static str,
    primitive: &'static str,
    workload: &'static str,
    hits: usize,
    errors: [f64; 3],
    lengths: [f64; 3],
    counts: [usize; 5],
) -> Bound {
    Bound { number, primitive, workload, hits, errors, lengths, counts }
}

/// The tables of all tiers, by name.
pub const TIERS: [(&str, &[Bound]); 4] =
    [("Textbook", textbook::ROWS), ("Fast", fast::ROWS), ("Stable", stable::ROWS), ("Exact", exact::ROWS)];

/// All rows as figures.
pub fn all() -> Vec<Figures> {
    let figures = |(tier, rows): (&'static str, &[Bound])| {
        let row = |row: &Bound| Figures {
            tier,
            number: row.number.into(),
            primitive: row.primitive,
            workload: row.workload.into(),
            hits: row.hits,
            errors: row.errors,
            lengths: row.lengths,
            counts: row.counts,
        };
        rows.iter().map(row).collect::<Vec<_>>()
    };
    TIERS.into_iter().flat_map(figures).collect()
}

/// The source file of a tier's rows.
pub fn source(tier: &str, rows: &[Figures]) -> String {
    let mut text = format!(
        "//! `{tier}`: written by `cargo run --release --example accuracy -- --write`.\n\nuse super::{{Bound, bound}};\n\n#[rustfmt::skip]\npub(super) const ROWS: &[Bound] = &[\n"
    );
    for row in rows.iter().filter(|row| row.tier == tier) {
        let Figures { number, primitive, workload, hits, errors: [median, most, worst], lengths, counts, .. } = row;
        let errors = format!("[{median:.3}, {most:.3}, {worst:.3}]");
        let lengths = lengths.map(|length| format!("{length:.2e}")).join(", ");
        writeln!(
            text,
            "    bound({number:?}, {primitive:?}, {workload:?}, {hits}, {errors}, [{lengths}], {counts:?}),"
        )
        .expect("a string takes everything");
    }
    text + "];\n"
}
