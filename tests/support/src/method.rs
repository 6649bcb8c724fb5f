//! The ways to answer that are compared: the tiers, and the textbook.

use super::exact_types::Exact as Number;
use super::oracle::Solid;
use super::placed::Placed;
use super::subject::Subject;
use super::textbook::{self, Plain, PlainRay, Reach};
use fixed::types::{I8F24, I16F16, I20F12, I32F32};
use raylet::tier::{self, Exact, Fast, Precision, Stable, Tier};
use raylet::{Crossing, Part, Ray, Shape};

/// A primitive where it stands, which a method intersects with a ray.
pub struct Target<'a, S: Number> {
    /// Where it was placed.
    pub shape: &'a Shape<S>,
    /// In its own frame.
    pub solid: &'a Solid,
    /// About the size of the solid in its own frame.
    pub size: f64,
    pub placed: Option<&'a Placed<S>>,
}

impl<'a, S: Number> Target<'a, S> {
    /// A subject of the tables, of size about 1.
    pub fn of(subject: &'a Subject<S>, placed: Option<&'a Placed<S>>) -> Self {
        let shape = placed.map_or(&subject.shape, |placed| &placed.shape);
        Self { shape, solid: &subject.solid, size: 1.0, placed }
    }
}

/// A hit as it was told.
#[derive(Clone, Copy)]
pub struct Told<S> {
    pub t: S,
    /// The textbook tells `t` alone.
    pub surface: Option<(Part, Crossing)>,
}

/// A way to answer in one number type.
#[derive(Clone, Copy)]
pub struct Method<S: Number> {
    pub tier: &'static str,
    /// All hits, sorted.
    pub hits: fn(&Target<'_, S>, &Ray<S>) -> Vec<Told<S>>,
    /// Whether a ray is decided in integers.
    pub in_integers: fn(&Shape<S>, &Ray<S>) -> bool,
}

/// A tier's hits; and its other answers must agree with them.
fn hits_of_tier<S: Number, T: Tier<S>>(target: &Target<'_, S>, ray: &Ray<S>) -> Vec<Told<S>> {
    let shape = target.shape;
    let hits = shape.hits_at::<T>(ray);
    assert_eq!(shape.nearest_at::<T>(ray), hits.first().copied(), "nearest is the first hit: {ray:?}");
    assert_eq!(shape.occludes_at::<T>(ray), !hits.is_empty(), "occlusion agrees with the hits: {ray:?}");
    hits.iter().map(|hit| Told { t: hit.t, surface: Some((hit.part, hit.crossing)) }).collect()
}

fn hits_of_textbook<S: Plain + Number>(target: &Target<'_, S>, ray: &Ray<S>) -> Vec<Told<S>> {
    let (form, place) = (textbook::form::<S>(target.solid), target.placed.map(textbook::place));
    let hits = textbook::hits(&form, place.as_ref(), &PlainRay::of(ray), Reach::of(ray));
    hits.into_iter().filter_map(S::told).map(|t| Told { t, surface: None }).collect()
}

impl<S: Number> Method<S> {
    pub fn tier<T: Tier<S>>(tier: &'static str) -> Self {
        Self { tier, hits: hits_of_tier::<S, T>, in_integers: |_, _| false }
    }
}

impl<S: Plain + Number> Method<S> {
    fn textbook() -> Self {
        Self { tier: "Textbook", hits: hits_of_textbook::<S>, in_integers: |_, _| false }
    }
}

/// A number type of the tables, with all ways to answer in it, the plainest first.
pub trait Measurable: Plain + Number {
    fn methods() -> Vec<Method<Self>>;
}

macro_rules! measurable {
    ($($Number:ty: $($exact:expr)?;)+) => {
        $(
            impl Measurable for $Number {
                fn methods() -> Vec<Method<Self>> {
                    vec![
                        Method::textbook(),
                        Method::tier::<tier::Plain>("Plain"),
                        Method::tier::<Fast>("Fast"),
                        Method::tier::<Stable>("Stable"),
                        $($exact,)?
                    ]
                }
            }
        )+
    };
}
measurable! {
    f32: Method {
        in_integers: |shape, ray| shape.precision(ray) == Precision::Integers,
        ..Method::tier::<Exact>("Exact")
    };
    f64:;
    I16F16: Method {
        in_integers: |shape, ray| shape.precision(ray) == Precision::Integers,
        ..Method::tier::<Exact>("Exact")
    };
    I32F32:;
    I8F24: Method {
        in_integers: |shape, ray| shape.precision(ray) == Precision::Integers,
        ..Method::tier::<Exact>("Exact")
    };
    I20F12: Method {
        in_integers: |shape, ray| shape.precision(ray) == Precision::Integers,
        ..Method::tier::<Exact>("Exact")
    };
}
