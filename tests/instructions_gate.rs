//! The promise: `.ci/instructions` fails if a query takes more than 2 % more instructions than the baseline says, or 15 % if another
//! compiler made it, and if a figure comes or goes. (Counting itself needs valgrind, and is not done here.)

#[path = "../benches/counting/baseline.rs"]
#[allow(dead_code)]
mod baseline;

use baseline::Baseline;

fn counted(compiler: &str, figures: &[(&str, u64)]) -> Baseline {
    Baseline::new(compiler, figures.iter().map(|(name, figure)| ((*name).to_string(), *figure)).collect())
}

/// Whether the gate lets a figure of 1000 instructions become another.
fn passes(compiler: &str, now: u64) -> bool {
    counted("a", &[("query", 1000)]).compare(&counted(compiler, &[("query", now)])).is_ok()
}

#[test]
fn two_percent_pass_and_more_do_not() {
    assert!(passes("a", 1000) && passes("a", 1020));
    assert!(!passes("a", 1021));
    assert!(passes("a", 500), "what got better is no fault");
}

#[test]
fn another_compiler_may_be_fifteen_percent_worse() {
    assert!(passes("b", 1150));
    assert!(!passes("b", 1151));
}

#[test]
fn a_figure_that_comes_or_goes_is_a_fault() {
    let (one, two) = (counted("a", &[("query", 1000)]), counted("a", &[("query", 1000), ("another", 1)]));
    assert!(one.compare(&two).is_err());
    assert!(two.compare(&one).is_err());
}

#[test]
fn two_instructions_more_are_no_change() {
    let before = counted("a", &[("query", 10)]);
    assert!(before.compare(&counted("a", &[("query", 12)])).is_ok());
    assert!(before.compare(&counted("a", &[("query", 13)])).is_err());
}

#[test]
fn figures_of_another_architecture_are_not_compared() {
    let before = Baseline { architecture: "another".into(), ..counted("a", &[("query", 1000)]) };
    assert!(before.compare(&counted("a", &[("query", 1000)])).is_err());
}

#[test]
fn the_baseline_in_the_repository_can_be_read() {
    let baseline = Baseline::read().expect("it is in the repository");
    assert!(baseline.figures.len() > 700 && baseline.figures.values().all(|figure| *figure > 0));
}
