//! The workloads of users as Markdown.

use crate::document::{bold, line, short};
use crate::names::{EXACT, PARRY, STABLE};
use crate::users::{NAMES, OFF, UserRow};
use std::fmt::Write;

/// At most so many times parry's time: a sphere and a triangle, whose loops in parry tell no part, no crossing and keep
/// no range.
const MOST: [(&str, f64); 2] = [("sphere", 1.7), ("triangle", 1.8)];

fn most(what: &str) -> f64 {
    MOST.iter().find(|(known, _)| *known == what).map_or(1.0, |(_, most)| *most)
}

/// The rows of each workload, in the order of the contestants.
fn workloads(rows: &[UserRow]) -> impl Iterator<Item = &[UserRow]> {
    rows.chunks(NAMES.len())
}

fn of<'a>(rows: &'a [UserRow], contestant: &str) -> Option<&'a UserRow> {
    rows.iter().find(|row| row.contestant == contestant)
}

/// `Stable`'s time over parry's.
fn ratio(rows: &[UserRow]) -> Option<f64> {
    Some(1.0 / of(rows, PARRY)?.speed.to_stable[1])
}

/// The section.
pub fn section(rows: &[UserRow]) -> String {
    let mut text = format!(
        "## What users do, `f32`\n\n\
         Placed solids, near and far, and a range sensor: the queries of [benches.md](benches.md), each with a solid and a ray of its own. \
         Each library transforms the ray to the solid's frame itself. parry has no frustum and no stretched solids: such queries are left out for both. \
         Times are nanoseconds a query. In brackets is the number of wrong answers, compared with `{EXACT}`: hits for misses, misses for hits, and distances off by more than {OFF} \
         (the solids are about as large as the unit ball). parry returns the distance. raylet also returns the part and the crossing, \
         and respects the ray's range. The last column is the limit that was set for the ratio; a ratio in **bold** is within it.\n\n\
         | what | queries | {} | {STABLE} over {PARRY} | at most |\n|---|---|{}\n",
        NAMES.join(" | "),
        "---:|".repeat(NAMES.len() + 2)
    );
    let (mut count, mut reached) = (0, 0);
    for rows in workloads(rows) {
        let (Some(first), Some(ratio)) = (rows.first(), ratio(rows)) else { continue };
        let most = most(&first.what);
        count += 1;
        reached += usize::from(ratio <= most);
        let queries = format!("{}, {}", first.queries, first.rays);
        let times = rows.iter().map(|row| {
            let wrong = if row.wrong > 0 { format!(" ({})", row.wrong) } else { String::new() };
            format!("{}{wrong}", short(row.speed.nanoseconds))
        });
        let cells: Vec<_> = [first.what.clone(), queries]
            .into_iter()
            .chain(times)
            .chain([bold(short(ratio), ratio <= most), most.to_string()])
            .collect();
        line(&mut text, &cells.iter().map(String::as_str).collect::<Vec<_>>());
    }
    let _ = writeln!(text, "\nOf these {count} rows, {reached} are within the limit.\n");
    text
}
