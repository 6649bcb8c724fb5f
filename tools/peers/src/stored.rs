//! What was measured as a table of `data`: a row a workload and contestant.

use crate::environment::Environment;
use crate::measure::Row;
use crate::speed::Speed;
use raylet_tables::Table;

/// Where it is.
pub const PATH: &str = "data/peers.tsv";

/// The command that writes it.
pub const WRITTEN_BY: &str = "cargo run --release --manifest-path tools/peers/Cargo.toml -- --write";

/// The columns. Errors are those of `t` in units in the last place, and the worst as a length; *wrong* hits are lost,
/// phantom or far off. Times are nanoseconds, and ratios to that of `Stable` at the same rays.
pub const COLUMNS: [&str; 15] = [
    "number",
    "solid",
    "rays",
    "contestant",
    "hits",
    "median",
    "p999",
    "worst",
    "worst_length",
    "lost",
    "phantom",
    "wrong",
    "hit_ns",
    "miss_ns",
    "to_stable",
];

/// What stands where there is no figure.
pub const NONE: &str = "-";

/// Three digits.
fn short(value: f64) -> String {
    match value {
        0.0..10.0 => format!("{value:.2}"),
        10.0..100.0 => format!("{value:.1}"),
        100.0..1e5 => format!("{value:.0}"),
        _ => format!("{value:.0e}"),
    }
}

fn nanoseconds(speed: &Option<Speed>) -> String {
    speed.as_ref().map_or(NONE.into(), |speed| short(speed.nanoseconds))
}

fn ratio(speed: &Option<Speed>) -> String {
    speed.as_ref().map_or(NONE.into(), |speed| short(speed.to_stable))
}

/// The rows of the workloads, then those of users, which have been made already.
pub fn table(environment: &Environment, rows: &[Row], users: Vec<Vec<String>>) -> Table {
    let versions: Vec<_> = environment.versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let roots = if environment.has_exact_roots { "the standard library" } else { "micromath" };
    let mut table = Table::new(&COLUMNS)
        .with_note("versions", &versions.join(", "))
        .with_note("commit", &environment.commit)
        .with_note("compiler", &environment.compiler)
        .with_note("processor", &environment.processor)
        .with_note("square roots of embedded-3dgfx", roots);
    for Row { number, primitive, workload, contestant, errors, hits, misses } in rows {
        let mut cells = vec![number.clone(), (*primitive).into(), workload.name(), (*contestant).into()];
        cells.push(format!("{} of {}", errors.hits, errors.rays));
        cells.extend(errors.units.map(short));
        cells.push(format!("{:.0e}", errors.lengths[2]));
        cells.extend([errors.lost, errors.phantom, errors.wrong].map(|count| count.to_string()));
        cells.extend([nanoseconds(hits), nanoseconds(misses), ratio(hits)]);
        table.rows.push(cells);
    }
    table.rows.extend(users);
    table
}

/// What users do.
#[cfg(feature = "parry")]
pub fn of_users(rows: &[crate::users::UserRow]) -> Vec<Vec<String>> {
    let row = |row: &crate::users::UserRow| {
        let speed = Some(row.speed.clone());
        let names = ["f32".into(), row.what.clone(), row.rays.clone(), row.contestant.into(), row.queries.to_string()];
        let mut cells = names.to_vec();
        cells.resize(COLUMNS.len() - 4, NONE.into());
        cells.extend([row.wrong.to_string(), nanoseconds(&speed), NONE.into(), ratio(&speed)]);
        cells
    };
    rows.iter().map(row).collect()
}
