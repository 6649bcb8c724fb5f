//! The documents and plots that are made of a study.
//!
//! | module | what it holds |
//! |---|---|
//! | `front` | docs/accuracy.md |
//! | `placed` | of that the table of placed solids |
//! | `by_number` | docs/accuracy/: the rows that are timed, a page a number type |
//! | `which_one`, `advice` | docs/which-one.md: how it is made, what it says |
//! | `readme` | the tables of the README and of docs/overview.md |
//! | `findings`, `explanations` | unexpected rows, and their explanations |
//! | `plots` | docs/plots/ |
//! | `rays` | the page of a file of rays |
//! | `markdown` | figures and tables as text |

mod advice;
mod by_number;
mod explanations;
mod findings;
mod front;
mod markdown;
mod placed;
mod plots;
mod rays;
mod readme;
mod which_one;

use crate::chips;
use crate::study::Study;
use std::error::Error;
use std::path::Path;
use support::figures::NUMBERS;

pub use front::printed as summary;
pub use rays::{as_json as rays_as_json, documents as rays_documents, printed as rays_summary};

/// All of them, with their paths in the repository; of the README and of docs/overview.md the tables are new.
pub fn documents(study: &Study, root: &Path) -> Result<Vec<(String, String)>, Box<dyn Error>> {
    let readme = std::fs::read_to_string(root.join("README.md"))?;
    let overview = std::fs::read_to_string(root.join("docs/overview.md"))?;
    let mut files = vec![
        ("docs/accuracy.md".to_string(), front::document(study)),
        ("docs/which-one.md".into(), which_one::document(study)?),
        ("README.md".into(), readme::document(&readme, study, &chips::host()?)?),
        ("docs/overview.md".into(), readme::overview(&overview, study)?),
    ];
    files
        .extend(NUMBERS.map(|number| (format!("docs/{}", markdown::page(number)), by_number::document(study, number))));
    files.extend(plots::all(study)?);
    Ok(files)
}
