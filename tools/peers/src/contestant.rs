//! What a contestant is: a primitive of a library, and its query for the nearest hit of a ray.

use crate::number::Number;
use crate::pose::Pose;
use raylet::Ray;
use std::hint::black_box;
use support::oracle::Solid;

/// One primitive in one library.
pub trait Contestant<S: Number> {
    /// A ray in the library's own type.
    type Ray;
    /// What the library answers, whole.
    type Answer;
    /// The same ray, bit for bit.
    fn ray(ray: &Ray<S>) -> Self::Ray;
    /// The query.
    fn nearest(&self, ray: &Self::Ray) -> Self::Answer;
    /// The distance in an answer, if it is a hit.
    fn distance(answer: &Self::Answer) -> Option<S>;
}

/// A contestant and its rays, whatever their types.
pub trait Prepared<S> {
    /// Runs the query with every ray once. The loop is the same for all contestants, and all that is ever timed.
    fn pass(&self);
    /// The answers.
    fn distances(&self) -> Vec<Option<S>>;
    /// How many rays there are.
    fn rays(&self) -> usize;
}

struct Timed<'a, S: Number, C: Contestant<S>> {
    contestant: &'a C,
    rays: Vec<C::Ray>,
}

impl<S: Number, C: Contestant<S>> Prepared<S> for Timed<'_, S, C> {
    #[inline(never)]
    fn pass(&self) {
        for ray in &self.rays {
            // Neither the primitive nor the ray may be known to the compiler, or it computes ahead what they share.
            black_box(black_box(self.contestant).nearest(black_box(ray)));
        }
    }

    fn distances(&self) -> Vec<Option<S>> {
        self.rays.iter().map(|ray| C::distance(&self.contestant.nearest(ray))).collect()
    }

    fn rays(&self) -> usize {
        self.rays.len()
    }
}

/// A contestant of any type, made ready for rays.
pub trait Prepare<S: Number> {
    /// Turns rays into the contestant's own type, which no one times.
    fn prepare(&self, rays: &[Ray<S>]) -> Box<dyn Prepared<S> + '_>;
}

impl<S: Number, C: Contestant<S>> Prepare<S> for C {
    fn prepare(&self, rays: &[Ray<S>]) -> Box<dyn Prepared<S> + '_> {
        Box::new(Timed { contestant: self, rays: rays.iter().map(C::ray).collect() })
    }
}

/// A contestant with a name, and where its primitive stands in its library.
pub struct Entrant<S: Number> {
    pub name: &'static str,
    /// How a ray at the subject becomes a ray at this contestant's primitive.
    pub pose: Pose<S>,
    /// The very solid that the contestant was given; the subject's, but for a size that it stores in another way.
    pub solid: Solid,
    contestant: Box<dyn Prepare<S>>,
}

impl<S: Number> Entrant<S> {
    /// One whose primitive stands as the subject does.
    pub fn new(name: &'static str, solid: &Solid, contestant: impl Prepare<S> + 'static) -> Self {
        Self { name, pose: Pose::same(), solid: solid.clone(), contestant: Box::new(contestant) }
    }

    /// The same, its primitive standing otherwise.
    pub fn standing(self, pose: Pose<S>, solid: Solid) -> Self {
        Self { pose, solid, ..self }
    }

    /// Makes it ready for rays at the subject.
    pub fn prepare(&self, rays: &[Ray<S>]) -> Box<dyn Prepared<S> + '_> {
        let own: Vec<_> = rays.iter().map(|ray| self.pose.own_ray(ray)).collect();
        self.contestant.prepare(&own)
    }
}
