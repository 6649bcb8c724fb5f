//! The rows in which a tier does not keep its promise, worst first, each with a ray that shows it.

use std::error::Error;
use support::figures::Figures;

/// Prints them; an error if there are any.
pub fn report(rows: &[Figures]) -> Result<(), Box<dyn Error>> {
    let mut broken: Vec<_> = rows.iter().filter_map(|row| Some((row, row.worst.as_ref()?))).collect();
    broken.sort_by(|(_, one), (_, other)| other.by.total_cmp(&one.by));
    for (row, worst) in &broken {
        let [lost, phantom, edge, part, _] = row.counts;
        let Figures { tier, number, primitive, broken, hits, errors: [.., most], .. } = row;
        println!(
            "{tier} {number} {primitive}, {}: {broken} rays, {hits} hits, worst {most} units, {lost} lost, {phantom} \
             phantom, {edge} edge, {part} part\n    {:.2} of the limit: {}",
            row.name(),
            worst.by,
            worst.told
        );
    }
    if broken.is_empty() {
        println!("{} rows, and in all of them every tier keeps its promise", rows.len());
        return Ok(());
    }
    Err(format!("in {} of {} rows a tier does not keep its promise", broken.len(), rows.len()).into())
}
