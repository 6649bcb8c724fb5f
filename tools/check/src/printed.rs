//! What a firmware program printed: a row of JSON in each line.

use raylet_tables::Outcome;
use serde::de::DeserializeOwned;
use std::fs;
use std::path::Path;

/// All rows.
pub fn rows<R: DeserializeOwned>(path: &Path) -> Outcome<Vec<R>> {
    let text = fs::read_to_string(path)?;
    let row = |line: &str| serde_json::from_str(line).map_err(|error| format!("{line}: {error}").into());
    text.lines().map(row).collect()
}
