//! The tables and plots that are made of a study.
//!
//! | module | what it holds |
//! |---|---|
//! | `front` | what to expect and what it costs: docs/accuracy.md |
//! | `placed` | placed solids against those that are not placed |
//! | `by_number` | the rows that are timed, a page a number type |
//! | `rows` | rows that a page cites, and claims about them: docs/which-one.md |
//! | `readme` | the tables of the README and of docs/overview.md |
//! | `findings` | rows in which accuracy costs less, and combinations that others beat |
//! | `plots` | error against distance, grazing and cost |
//! | `rays` | the page of a file of rays |
//! | `markdown` | figures as text |

mod by_number;
mod findings;
mod front;
mod markdown;
mod placed;
mod plots;
mod rays;
mod readme;
mod rows;

use crate::chips;
use crate::study::Study;
use raylet_tables::{Outcome, page};
use support::figures::{NUMBERS, TIERS};

pub use front::printed as summary;
pub use rays::{as_json as rays_as_json, documents as rays_documents, printed as rays_summary};

/// The pages of the repository whose tables are made here.
const PAGES: [&str; 4] = ["README.md", "docs/overview.md", "docs/accuracy.md", "docs/which-one.md"];

/// The pages and plots of the repository, with their paths; of the pages the tables are new.
pub fn documents(study: &Study) -> Outcome<Vec<(String, String)>> {
    let host = chips::host()?;
    let table = |name: &str, about: &str, held: &str| -> Outcome<String> {
        let missing = "a row that the page shows was not measured";
        Ok(match name {
            "placed" => readme::placed(study, &host).ok_or(missing)?,
            "bounds" => readme::errors(study).ok_or(missing)?,
            "costs" => readme::costs(study),
            "summary" => front::summary(study),
            "benign" => front::costs(study, &["cone capped"]),
            "places" => placed::table(study, true),
            "rows" => rows::table(study, held)?,
            "holds" => rows::check(study, about).map(|()| String::new())?,
            _ => return Err(format!("there is no table `{name}`").into()),
        })
    };
    let pages = PAGES.into_iter().map(|path| Ok((path.to_string(), page::renewed(path, table)?)));
    let plots = plots::all(study)?.into_iter().filter(|(name, _)| plots::SHOWN.contains(&name.as_str()));
    let plots = plots.map(|(name, plot)| Ok((format!("docs/plots/{name}"), plot)));
    pages.chain(plots).collect()
}

/// What [`printed`] prints beside number types and tiers.
const OTHERS: [&str; 4] = ["costs", "placed", "integers", "surprises"];

/// The names of all pages that can be printed.
pub fn names() -> Vec<&'static str> {
    NUMBERS.into_iter().chain(TIERS).chain(OTHERS).collect()
}

/// A page of tables: the rows of a number type or a tier, or what `name` says.
pub fn printed(study: &Study, name: &str) -> String {
    match name {
        "costs" => format!(
            "# What it costs\n\nThe nearest hit of benign rays, hit / miss: time on the host, instructions on the \
             chips.\n\n{}",
            front::costs(study, &plots::COMPARED)
        ),
        "placed" => format!(
            "# Placed solids\n\nThe largest error of `t` in units in the last place, of well-aimed rays / of all \
             workloads.\n\n{}",
            placed::table(study, false)
        ),
        "integers" => format!(
            "# How often integers decide\n\nOf a million rays, how many the doubles of `Exact` cannot decide.\n\n{}",
            front::integers(study)
        ),
        "surprises" => format!(
            "# Faster and more accurate\n\nThe number of rows in which one tier is both more accurate (99.9 % error, \
             no more wrong hits) and cheaper than another of the same number type; hits and misses are two rows. In \
             brackets is the smallest ratio of their costs. On the host a time is shorter if it is below nine tenths \
             of the other.\n\n{}# Beaten by another\n\nThe share of rows in which another combination costs no more, \
             has no larger error as a length and no more wrong hits, and is better in one of them. On the chips the \
             instructions of benign rays are used for every workload.\n\n{}",
            findings::faster_and_more_accurate(study),
            findings::dominated_everywhere(study)
        ),
        tier if TIERS.contains(&tier) => NUMBERS.map(|number| by_number::page(study, number, Some(tier))).concat(),
        number => by_number::page(study, number, None),
    }
}

/// All pages that can be printed and all plots, with the names of their files.
pub fn everything(study: &Study) -> Outcome<Vec<(String, String)>> {
    let pages = names().into_iter().filter(|name| !TIERS.contains(name));
    let pages = pages.map(|name| (format!("{}.md", name.to_lowercase()), printed(study, name)));
    Ok(pages.chain(plots::all(study)?).collect())
}
