//! The formulas that everyone writes first, at the rays of the subjects: `nearest` of the tier `textbook`.

use super::{Case, KINDS, Name};
use raylet::{Ray, Shape};
use shared::rays::rays;
use shared::textbook::{Formula, Number, Plain, PlainRay, Visit, every_formula};
use std::hint::black_box;

#[inline(never)]
fn nearest<N: Number, F: Formula<N>>(formula: &F, ray: &PlainRay<N>) {
    black_box(formula.nearest(None, ray));
}

struct Cases {
    number: &'static str,
    cases: Vec<Case>,
}

impl<S: Plain<Number: Send + Sync>> Visit<S> for Cases {
    fn visit<F>(&mut self, name: &'static str, shape: &Shape<S>, formula: F)
    where
        F: Formula<S::Number> + Send + Sync + 'static,
    {
        for (hitting, kind) in KINDS {
            let inputs: Vec<_> = rays(shape, hitting).iter().map(|ray: &Ray<S>| PlainRay::of(ray)).collect();
            let name =
                Name { subject: name.into(), query: "nearest", number: self.number, tier: "textbook", rays: kind };
            self.cases.push(Case::new(name, formula, inputs, nearest::<S::Number, F>));
        }
    }
}

/// The cases of a number type.
pub fn cases<S: Plain<Number: Send + Sync>>(number: &'static str) -> Vec<Case> {
    let mut all = Cases { number, cases: vec![] };
    every_formula::<S>(&mut all);
    all.cases
}
