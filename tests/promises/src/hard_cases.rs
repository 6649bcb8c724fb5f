//! The promise: rays that break the usual formulas get the answer of exact arithmetic, in every number type that can
//! hold them: far, tiny, huge, grazing, in the wall, in a cap's plane, rim to rim, through the apex, parallel to a
//! generator.
//!
//! The cases are tables, a module a class (`tests/support/src/hard_case`). Each is written as it is met in the world,
//! with what it breaks elsewhere and with its exact answer; the tables themselves are checked against the oracle. A
//! number type rounds the inputs, and its answer is held to the exact one of the bits that it received.
//! `cargo test -p raylet-promises hard_cases -- --nocapture` prints what was held and how well.

use fixed::types::{I8F24, I16F16, I20F12, I32F32};
use raylet::{Exact as ExactTier, Stable, Tier};
use support::exact_types::Exact;
use support::hard_case::check::{Policy, check, check_written};
use support::hard_case::sweeps::{self, Sweep, Tally};
use support::hard_case::{Case, classes};

/// Every written case.
fn cases() -> Vec<Case> {
    classes().into_iter().flat_map(|(_, cases)| cases).copied().collect()
}

#[test]
fn the_written_answers_are_the_exact_ones() {
    let wrong: Vec<String> = cases().iter().flat_map(check_written).collect();
    assert!(wrong.is_empty(), "{} in the tables:\n{}", wrong.len(), wrong.join("\n"));
}

/// A module for each tier, with a test for each number type that has it, and how many written cases that one holds.
macro_rules! tiers {
    ($($tier:ident: $Tier:ty, $policy:expr => { $($number:ident: $Number:ty, $least:expr;)+ })+) => {
        $(
            mod $tier {
                use super::*;
                $(
                    mod $number {
                        use super::*;
                        #[test]
                        fn every_written_case_has_its_exact_answer() {
                            every_written_case::<$Number, $Tier>(&$policy, $least);
                        }
                        #[test]
                        fn every_class_of_rays_has_its_exact_answers() {
                            every_class::<$Number, $Tier>(&$policy);
                        }
                    }
                )+
            }
        )+
    };
}

tiers! {
    stable: Stable, Policy::STABLE => {
        f32: f32, 233; f64: f64, 233; i16f16: I16F16, 208; i32f32: I32F32, 219; i8f24: I8F24, 185; i20f12: I20F12, 208;
    }
    exact: ExactTier, Policy::EXACT => {
        f32: f32, 233; i16f16: I16F16, 208; i8f24: I8F24, 185; i20f12: I20F12, 208;
    }
}

fn every_written_case<S: Exact, T: Tier<S>>(policy: &Policy, least: usize) {
    let cases = cases();
    let results: Vec<(f64, Vec<String>)> = cases.iter().filter_map(|case| check::<S, T>(case, policy)).collect();
    let wrong: Vec<String> = results.iter().flat_map(|(_, wrong)| wrong.clone()).collect();
    // The rows that say more of this type are told by what they say.
    let unlimited = |case: &&Case| !policy.limits || case.limits.iter().all(|(name, _)| *name != S::name());
    let rest = cases.iter().filter(unlimited).filter_map(|case| check::<S, T>(case, policy));
    let worst = rest.fold(0.0, |worst: f64, (error, _)| worst.max(error));
    let (held, all) = (results.len(), cases.len());
    println!("{}: {held} of {all} cases are held, the worst without a limit within {worst} units", S::name());
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
    assert!(held >= least, "{}: only {held} cases fit the type", S::name());
}

fn every_class<S: Exact, T: Tier<S>>(policy: &Policy) {
    let mut wrong = vec![];
    let mut run = |sweep: &Sweep, rays: fn(&mut Tally<'_, S>)| {
        let mut tally = Tally::new(sweep, policy);
        rays(&mut tally);
        let (rays, worst, broken) = tally.finish();
        println!("{}: {rays} rays {}, the worst within {worst} units", S::name(), sweep.name);
        wrong.extend(broken);
    };
    run(&sweeps::CENTRE, sweeps::from_the_centre::<S, T>);
    run(&sweeps::SURFACE, sweeps::from_the_surface::<S, T>);
    run(&sweeps::ZEROS, sweeps::zero_components::<S, T>);
    run(&sweeps::FARTHER, sweeps::ever_farther::<S, T>);
    run(&sweeps::ENDS, sweeps::at_the_ends_of_the_type::<S, T>);
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}
