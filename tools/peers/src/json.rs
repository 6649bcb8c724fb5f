//! The figures as JSON.

use crate::environment::Environment;
use crate::measure::Row;
use crate::speed::Speed;
use serde_json::{Value, json};

fn speed(speed: &Option<Speed>) -> Value {
    speed.as_ref().map_or(Value::Null, |speed| {
        json!({
            "nanoseconds": speed.nanoseconds,
            "to_textbook_sphere_quartiles": speed.to_sphere,
            "to_stable_quartiles": speed.to_stable,
        })
    })
}

/// What was compared, and one object a row.
///
/// # Errors
///
/// If a figure is not finite.
pub fn json(environment: &Environment, rows: &[Row]) -> Result<String, serde_json::Error> {
    let versions: serde_json::Map<_, _> =
        environment.versions.iter().map(|(name, version)| ((*name).into(), json!(version))).collect();
    let head = json!({
        "versions": versions, "commit": environment.commit, "compiler": environment.compiler,
        "processor": environment.processor, "embedded_3dgfx_has_exact_square_roots": environment.has_exact_roots,
    });
    let row = |row: &Row| {
        let errors = &row.errors;
        serde_json::to_string(&json!({
            "number": row.number, "primitive": row.primitive, "workload": row.workload.name(),
            "contestant": row.contestant, "rays": errors.rays, "exact_hits": errors.hits,
            "units_median_p999_worst": errors.units, "lengths_median_p999_worst": errors.lengths,
            "lost": errors.lost, "phantom": errors.phantom, "wrong": errors.wrong,
            "hits": speed(&row.hits), "misses": speed(&row.misses),
        }))
    };
    // One row a line: readable, and small differences stay small.
    let lines: Result<Vec<String>, _> = rows.iter().map(row).collect();
    Ok(format!("{{\"environment\": {head},\n\"rows\": [\n{}\n]}}\n", lines?.join(",\n")))
}
