//! The figures as JSON.

use crate::support::measure::Figures;
use serde_json::{Value, json};

/// One object a row.
pub fn json(rows: &[Figures]) -> Result<String, serde_json::Error> {
    let row = |row: &Figures| {
        let ([median, most, worst], [lost, phantom, edge, part, integers]) = (row.errors, row.counts);
        json!({
            "tier": row.tier, "number": row.number, "primitive": row.primitive, "workload": row.workload,
            "hits": row.hits, "median": median, "p999": most, "worst": worst,
            "lost": lost, "phantom": phantom, "edge": edge, "part": part, "integers": integers,
        })
    };
    // One row a line: readable, and small differences stay small.
    let lines: Result<Vec<String>, _> = rows.iter().map(row).map(|row: Value| serde_json::to_string(&row)).collect();
    Ok(format!("[\n{}\n]\n", lines?.join(",\n")))
}
