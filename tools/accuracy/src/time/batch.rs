//! A query at some rays, again and again.

use super::rays::Query;
use raylet::tier::Tier;
use raylet::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Hit, Plane, Polyhedron, Primitive, Prism, Ray, Rectangle, Revolved,
    RoundCone, RoundedCuboid, Scalar, Shape, Sphere, Torus, Triangle, Tube,
};
use std::hint::black_box;
use std::time::Instant;
use support::oracle::Solid;
use support::textbook::{self, Form, Formula, Place, Plain, PlainRay};

/// A batch goes on for at least this long: well above the grain of the clock, well below a slice of the scheduler.
const NANOSECONDS: f64 = 25_000.0;

/// A query, ready to be timed.
pub struct Batch {
    run: Box<dyn Fn(u32)>,
    passes: u32,
    queries: usize,
}

#[inline(never)]
fn pass<I>(inputs: &[I], query: fn(&I)) {
    for input in inputs {
        query(black_box(input));
    }
}

impl Batch {
    fn new<I: 'static>(inputs: Vec<I>, query: fn(&I)) -> Self {
        let queries = inputs.len();
        let run = move |passes| {
            // The compiler must not know which function it is: it would make a copy of the loop for each.
            let query = black_box(query);
            for _ in 0..passes {
                pass(&inputs, query);
            }
        };
        let mut batch = Self { run: Box::new(run), passes: 1, queries };
        // Once to warm up, once to see.
        batch.nanoseconds();
        let once = batch.nanoseconds() * queries as f64;
        batch.passes = (NANOSECONDS / once.max(1.0)).ceil().clamp(1.0, 1e4) as u32;
        batch
    }

    /// Of a query, in the mean.
    pub fn nanoseconds(&self) -> f64 {
        let start = Instant::now();
        (self.run)(self.passes);
        start.elapsed().as_nanos() as f64 / (f64::from(self.passes) * self.queries as f64)
    }
}

/// What has a nearest hit.
trait Nearest<S: Scalar>: Copy + 'static {
    fn nearest<T: Tier<S>>(&self, ray: &Ray<S>) -> Option<Hit<S>>;
}

macro_rules! primitives {
    ($($Primitive:ident)+) => {
        $(
            impl<S: Scalar> Nearest<S> for $Primitive<S> {
                #[inline(always)]
                fn nearest<T: Tier<S>>(&self, ray: &Ray<S>) -> Option<Hit<S>> {
                    self.nearest_at::<T>(ray)
                }
            }
        )+
    };
}
primitives!(Sphere Cylinder Cone Capsule Plane Disc Triangle Cuboid Rectangle Revolved Tube Annulus RoundCone);
primitives!(RoundedCuboid Prism Polyhedron Torus Shape);

#[inline(never)]
fn nearest<S: Scalar, T: Tier<S>, P: Nearest<S>>((subject, ray): &(P, Ray<S>)) {
    black_box(subject.nearest::<T>(ray));
}

fn of<S: Scalar, T: Tier<S>, P: Nearest<S>>(inputs: Vec<(P, Ray<S>)>) -> Batch {
    Batch::new(inputs, nearest::<S, T, P>)
}

/// A tier: through the primitive's own method, where it is not placed.
pub fn tier<S: Plain, T: Tier<S>>(queries: &[Query<S>]) -> Batch {
    macro_rules! own {
        ($($Variant:ident)+) => {
            match queries.first().map(|query| *query.shape.primitive()) {
                $(
                    Some(Primitive::$Variant(primitive)) if queries.iter().all(|query| query.place.is_none()) => {
                        of::<S, T, _>(queries.iter().map(|query| (primitive, query.ray)).collect())
                    }
                )+
                _ => of::<S, T, _>(queries.iter().map(|query| (query.shape, query.ray)).collect()),
            }
        };
    }
    own!(
        Sphere Cylinder Cone Capsule Plane Disc Triangle Cuboid Rectangle Revolved Tube Annulus RoundCone RoundedCuboid
        Prism Polyhedron Torus
    )
}

type TextbookQuery<N> = (Form<N>, Option<Place<N>>, PlainRay<N>);

#[inline(never)]
fn ask_textbook<S: Plain>((form, place, ray): &TextbookQuery<S::Number>) {
    black_box(form.nearest(place.as_ref(), ray));
}

/// The textbook.
pub fn textbook<S: Plain>(solid: &Solid, queries: &[Query<S>]) -> Batch {
    let form = textbook::form::<S>(solid);
    let inputs = queries.iter().map(|query| (form, query.place, PlainRay::of(&query.ray))).collect();
    Batch::new(inputs, ask_textbook::<S>)
}

#[inline(never)]
fn ask_nothing<S: Scalar>(query: &Ray<S>) {
    black_box(query);
}

/// A query that does nothing.
pub fn nothing<S: Plain>(queries: &[Query<S>]) -> Batch {
    Batch::new(queries.iter().map(|query| query.ray).collect(), ask_nothing::<S>)
}
