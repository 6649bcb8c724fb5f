//! The formulas that everyone writes first (`shared::textbook`), for their cost. Their errors are what raylet was
//! written to avoid: see `docs/accuracy.md`.

use super::measure::instructions;
use super::{Names, Of, Report};
use core::hint::black_box;
use raylet::Shape;
use shared::rays::{RAYS, rays};
use shared::textbook::{Formula, Number, Plain, PlainRay, Visit, every_formula};

#[inline(never)]
fn nearest<N: Number, F: Formula<N>>(formula: &F, ray: &PlainRay<N>) {
    black_box(formula.nearest(None, ray));
}

/// With the square root that raylet itself uses: an instruction, where the chip has one.
#[inline(never)]
fn nearest_with_the_chips_root<F: Formula<f32>>(formula: &F, ray: &PlainRay<f32>) {
    black_box(formula.nearest_by(ray, raylet::scalar::Real::sqrt));
}

/// Measures a formula at the rays that hit a shape, and at those that miss it.
fn measure<S: Plain, F: Formula<S::Number>>(
    names: Names,
    shape: &Shape<S>,
    formula: F,
    query: fn(&F, &PlainRay<S::Number>),
    report: Report<'_>,
) {
    for (hits, of) in [(true, Of::Hit), (false, Of::Miss)] {
        let rays: [PlainRay<S::Number>; RAYS] = rays(shape, hits).map(|ray| PlainRay::of(&ray));
        report(names.row("nearest", of, instructions(&formula, &rays, query)));
    }
}

struct Usual<'a> {
    number: &'static str,
    report: Report<'a>,
}

impl<S: Plain> Visit<S> for Usual<'_> {
    fn visit<F: Formula<S::Number> + Send + Sync + 'static>(
        &mut self,
        subject: &'static str,
        shape: &Shape<S>,
        formula: F,
    ) {
        let names = Names { subject, number: self.number, tier: "textbook" };
        measure(names, shape, formula, nearest::<S::Number, F>, self.report);
    }
}

/// Every formula in a number type.
pub fn every<S: Plain<Number: Send + Sync>>(number: &'static str, report: Report<'_>) {
    every_formula::<S>(&mut Usual { number, report });
}

struct ChipsRoot<'a>(Report<'a>);

impl Visit<f32> for ChipsRoot<'_> {
    fn visit<F: Formula<f32> + Send + Sync + 'static>(
        &mut self,
        subject: &'static str,
        shape: &Shape<f32>,
        formula: F,
    ) {
        if matches!(subject, "sphere" | "sphere, framed" | "cone, capped, framed") {
            let names = Names { subject, number: "f32", tier: "textbook, VSQRT" };
            measure(names, shape, formula, nearest_with_the_chips_root::<F>, self.0);
        }
    }
}

/// Some of them again, for the one chip whose square root is an instruction that `libm` does not use.
pub fn with_the_chips_root(report: Report<'_>) {
    if cfg!(all(target_arch = "arm", target_abi = "eabihf")) {
        every_formula(&mut ChipsRoot(report));
    }
}
