//! stub
use crate::study::Study;
use std::error::Error;
use std::path::Path;

pub fn documents(_: &Study, _: &Path) -> Result<Vec<(String, String)>, Box<dyn Error>> {
    Ok(vec![])
}
pub fn summary(_: &Study) -> String {
    String::new()
}
