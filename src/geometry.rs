//! What every primitive knows of itself.

use crate::fast::Guards;
use crate::figure::Figure;
use crate::intersection::{End, Intersection};
use crate::line::Place;
use crate::part::Part;
use crate::ray::{Range, Ray};
use crate::scalar::{Attempt, LocalLine, Scalar, found};
use crate::vector::{UnitVec3, Vec3};

/// What every primitive knows of itself, in its own frame.
pub trait Geometry<S: Scalar>: Copy {
    /// The same primitive in doubles.
    type Doubles: Geometry<f64>;

    /// Itself in doubles, which hold the numbers of 32-bit types.
    fn in_doubles(&self) -> Self::Doubles;
    /// A distance from the origin within which the primitive lies; its characteristic size if it is unbounded.
    fn reach(&self) -> S;
    /// The primitive with all lengths multiplied by `2^e`, as [`Computing::scaled`](crate::scalar::Computing::scaled) has it.
    #[must_use]
    fn scaled(&self, e: i32) -> Self;
    /// The line for the fast path, as this primitive sees it.
    #[inline(always)]
    fn fast_line(&self, place: &impl Place<S>, ray: &Ray<S>) -> Option<LocalLine<S>> {
        place.fast_line(ray)
    }
    /// The largest length that its equations have beside the line's, or more.
    #[inline(always)]
    fn lengths(&self) -> S {
        self.reach()
    }
    /// Makes the line suit its lengths ([`FastPath::fast_fit`](crate::scalar::FastPath::fast_fit)).
    #[inline(always)]
    fn fit(&self, line: &mut LocalLine<S>) {
        S::fast_fit(line, self.lengths());
    }
    /// The line for the fast path where [`Geometry::fast_line`] has none because the ray begins far away.
    #[inline(always)]
    fn far_line(&self, _place: &impl Place<S>, _ray: &Ray<S>) -> Option<LocalLine<S>> {
        None
    }
    /// The line for the fast path's second attempt, as this primitive sees it.
    #[inline(always)]
    fn second_line(&self, place: &impl Place<S>, ray: &Ray<S>) -> Option<LocalLine<S>> {
        place.second_line(ray, Vec3::ZERO)
    }
    /// Where the line meets it, if the fast path tells.
    fn fast_intersection<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>>;
    /// Whether the half-line `t >= 0` hits it, if the fast path tells; agrees with [`Geometry::fast_intersection`].
    #[inline(always)]
    fn fast_occlusion<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<()> {
        let intersection = found!(self.fast_intersection::<T>(line));
        if intersection.nearest(Range::FORWARD, |_| true).is_some() { Attempt::Found(()) } else { Attempt::Miss }
    }
    /// Where a line that begins on this part and leads inwards leaves the primitive, if it is convex and the fast path tells.
    #[inline(always)]
    fn fast_exit<T: Guards>(&self, _line: &LocalLine<S>, _from: Part) -> Attempt<End<S>> {
        Attempt::Unsure
    }
    /// The equations and inequalities of its points.
    fn figure(&self) -> Figure<S>;
    /// What its box follows from, however it is placed.
    fn hull(&self) -> Hull<S>;
    /// The point of the part that is nearest, or nearly so, to a point close to it.
    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S>;
    /// The outward unit normal at a point of the part.
    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S>;
    /// The radius of the surface's curvature at a point of the part, or less; infinite where it is flat.
    fn bend(&self, point: Vec3<S>, part: Part) -> S;
    /// Surface coordinates at a point of the part, each in `[0, 1]`.
    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit);
    /// The directions in which `u` and `v` grow at a point of the part.
    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>);
}

/// The parts of a primitive that reach as far as it does along every axis: it lies in their convex hull and touches all of its sides.
///
/// Balls and discs about points of the y axis are written as a height and a radius. Both may be infinite.
#[derive(Clone, Copy, Debug)]
pub enum Hull<S> {
    /// A ball of this radius about the origin.
    Ball(S),
    /// Two balls.
    Balls([[S; 2]; 2]),
    /// Two discs in planes of constant height.
    Discs([[S; 2]; 2]),
    /// The apex at the origin, and the disc at this height whose radius is the height times the slope, not rounded.
    Cone {
        /// Radius over height.
        slope: S,
        /// The height.
        height: S,
    },
    /// Three points.
    Points([Vec3<S>; 3]),
}

/// An axis-aligned box; components may be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bounds<S> {
    /// The corner with the smallest coordinates.
    pub low: Vec3<S>,
    /// The corner with the largest coordinates.
    pub high: Vec3<S>,
}
