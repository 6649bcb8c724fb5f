//! raylet, in each of its tiers: a primitive's own `nearest_at`.

use crate::contestant::{Contestant, Entrant};
use crate::names::{EXACT, FAST, PLAIN, STABLE};
use crate::number::Number;
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{Capsule, Cone, Cylinder, Disc, Hit, Plane, Primitive, Ray, Sphere, Triangle};
use std::marker::PhantomData;
use support::subject::Subject;

/// A primitive in a tier.
struct In<P, T>(P, PhantomData<T>);

macro_rules! contestants {
    ($($Primitive:ident)+) => {
        $(
            impl<S: Number, T: Tier<S>> Contestant<S> for In<$Primitive<S>, T> {
                type Ray = Ray<S>;
                type Answer = Option<Hit<S>>;
                fn ray(ray: &Ray<S>) -> Ray<S> {
                    *ray
                }
                #[inline]
                fn nearest(&self, ray: &Ray<S>) -> Option<Hit<S>> {
                    self.0.nearest_at::<T>(ray)
                }
                fn distance(answer: &Option<Hit<S>>) -> Option<S> {
                    answer.map(|hit| hit.t)
                }
            }
        )+

        fn entrant<S: Number, T: Tier<S>>(name: &'static str, subject: &Subject<S>) -> Entrant<S> {
            match *subject.shape.primitive() {
                $(
                    Primitive::$Primitive(primitive) => {
                        Entrant::new(name, &subject.solid, In(primitive, PhantomData::<T>))
                    }
                )+
                // The library may get further ones, and then this list does.
                primitive => unreachable!("{primitive:?} is no contestant"),
            }
        }
    };
}
contestants!(Sphere Cylinder Cone Capsule Plane Disc Triangle);

/// The tiers that both floats have.
pub fn entrants<S: Number>(subject: &Subject<S>) -> [Entrant<S>; 3] {
    [entrant::<S, Plain>(PLAIN, subject), entrant::<S, Fast>(FAST, subject), entrant::<S, Stable>(STABLE, subject)]
}

/// The tier of `f32` alone.
pub fn exact_entrant(subject: &Subject<f32>) -> Entrant<f32> {
    entrant::<f32, Exact>(EXACT, subject)
}
