//! The formulas that every tutorial has: `shared::textbook`.

use crate::contestant::{Contestant, Entrant};
use crate::names::TEXTBOOK;
use crate::number::Number;
use raylet::Ray;
use shared::textbook::{Form, Formula, PlainRay, Sphere};
use support::oracle::Solid;
use support::textbook::form;

struct Textbook<F>(F);

impl<S: Number, F: Formula<S>> Contestant<S> for Textbook<F> {
    type Ray = PlainRay<S>;
    type Answer = Option<S>;
    fn ray(ray: &Ray<S>) -> PlainRay<S> {
        PlainRay::of(ray)
    }
    #[inline]
    fn nearest(&self, ray: &PlainRay<S>) -> Option<S> {
        self.0.nearest(None, ray)
    }
    fn distance(answer: &Option<S>) -> Option<S> {
        *answer
    }
}

/// The textbook, for this solid: the formula alone, where it is one of few.
pub fn entrant<S: Number>(solid: &Solid) -> Entrant<S> {
    match form::<S>(solid) {
        Form::Sphere { radius } => Entrant::new(TEXTBOOK, solid, Textbook(Sphere(radius))),
        Form::Side(side) => Entrant::new(TEXTBOOK, solid, Textbook(side)),
        form => Entrant::new(TEXTBOOK, solid, Textbook(form)),
    }
}
