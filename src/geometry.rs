//! The interface of a primitive.

use crate::equations::{Described, Equations};
use crate::grid::Guards;
use crate::half_space::CutBox;
use crate::intersection::{End, Intersection};
use crate::line::{Needs, Place};
use crate::part::Part;
use crate::polygon::Polygon;
use crate::ray::Ray;
use crate::scalar::{Attempt, GridScalar, Including, LocalLine, Real, Ring, Scalar, found};
use crate::solve::{self, Goal, LocalRay, Of};
use crate::vector::{UnitVec3, Vec3, pairs};

/// The interface of a primitive, in its own frame.
pub trait Geometry<S: Scalar>: Copy + Described {
    /// The same primitive in another number type.
    type In<R: Scalar>: Geometry<R>;

    /// The primitive in a type that holds all values of this one; `None` if it borrows its sizes.
    fn in_type<R: Including<S>>(&self) -> Option<Self::In<R>>;
    /// At least the magnitude of every coordinate of its points. For an infinite primitive a characteristic size.
    fn largest_coordinate(&self) -> S;
    /// The primitive with all lengths multiplied by `2^e`, as [`Computing::scaled`](crate::scalar::Computing::scaled)
    /// has it.
    #[must_use]
    fn scaled(&self, e: i32) -> Self;
    /// A radius about the y axis that contains the geometry, if it is known.
    #[inline(always)]
    fn radius_about_axis(&self) -> Option<S> {
        None
    }
    /// The local line for the grid.
    #[inline(always)]
    fn grid_line(&self, place: &impl Place<S>, ray: &Ray<S>) -> Option<LocalLine<S>>
    where
        S: GridScalar,
    {
        place.grid_line(ray)
    }
    /// An upper bound of the lengths in its equations, besides those of the line.
    #[inline(always)]
    fn lengths(&self) -> S {
        self.largest_coordinate()
    }
    /// Reduces the extra bits of the line as far as the primitive's lengths require
    /// ([`LocalLine::fit`]).
    #[inline(always)]
    fn fit(&self, line: &mut LocalLine<S>)
    where
        S: GridScalar,
    {
        line.fit(self.lengths());
    }
    /// The intersection on the grid; that may be the entry alone where the exit is uncertain or not needed: see
    /// [`LocalLine::since`].
    #[inline(always)]
    fn meets_on_grid<T: Guards>(&self, _line: &LocalLine<S>) -> Attempt<Intersection<S>>
    where
        S: GridScalar,
    {
        Attempt::Unsure
    }
    /// Occlusion of the half-line `t >= 0` on the grid; agrees with [`Geometry::meets_on_grid`].
    #[inline(always)]
    fn occludes_on_grid<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<()>
    where
        S: GridScalar,
    {
        found!(self.meets_on_grid::<T>(line)).occlusion()
    }
    /// The exit of a line that starts on the part `from` and leads inwards, on the grid. Unsure if the line may enter
    /// again.
    #[inline(always)]
    fn exit_on_grid<T: Guards>(&self, _line: &LocalLine<S>, _from: Part) -> Attempt<End<S>>
    where
        S: GridScalar,
    {
        Attempt::Unsure
    }
    /// What its intersection needs of the transformation into its frame.
    const NEEDS: Needs = Needs::All;
    /// True if constant bounds on the errors of its formulas, which are short, replace running ones: see
    /// [`Guarded`](crate::number::Guarded).
    const HAS_CONSTANT_BOUNDS: bool = false;
    /// True if the terms of its polynomials have so few factors that their magnitudes bound their errors: see
    /// [`Filtered`](crate::number::Filtered).
    const HAS_FEW_FACTORS: bool = false;
    /// True if its formulas are so long that constant bounds on their errors would leave most rays to the next number.
    const HAS_LONG_FORMULAS: bool = false;
    /// Where a ray in its frame meets it.
    fn intersect<N: Of<S>>(&self, ray: &LocalRay<N>, goal: Goal<S>) -> solve::Attempt<Intersection<S>>;
    /// The equations and inequalities that its points satisfy.
    fn equations(&self) -> Equations<S>;
    /// The points, discs or balls whose convex hull determines its bounding box in any placement.
    fn hull(&self) -> Hull<S>;
    /// The point of the part that is nearest, or nearly nearest, to a point close to it.
    fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S>;
    /// The outward unit normal at a point of the part.
    fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S>;
    /// A lower bound of the surface's radius of curvature at a point of the part; infinite where it is flat.
    fn bend(&self, point: Vec3<S>, part: Part) -> S;
    /// Surface coordinates at a point of the part, each in `[0, 1]`.
    fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit);
    /// The directions in which `u` and `v` grow at a point of the part.
    fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>);
}

/// Simple sets whose convex hull has the same bounding box as the primitive in any placement.
///
/// Balls and discs about points of the y axis are written as a height and a radius. Both may be infinite.
#[derive(Clone, Copy, Debug)]
pub enum Hull<S: 'static> {
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
    /// A cuboid about the origin with these half extents.
    Cuboid([S; 3]),
    /// All points within a radius of such a cuboid.
    RoundedCuboid([S; 3], S),
    /// The corners of a polygon in the plane `y = 0`, and in the plane of this height.
    Prism(Polygon<S>, S),
    /// A box.
    Box(CutBox<S>),
    /// A disc about the origin in the plane `y = 0`, and all points within a distance of it: both radii.
    Torus([S; 2]),
}

impl<S: Scalar> Hull<S> {
    /// A ball that holds the primitive but for rounding: its centre, and lengths whose squares add up to that of its
    /// radius.
    pub(crate) fn ball(&self) -> (Vec3<S>, [S; 3]) {
        let [x, y, z] = self.extents().map(|[low, high]| {
            let whole = high.minus(low);
            if !low.is_finite() || !high.is_finite() || !whole.is_finite() {
                return (S::ZERO, S::INFINITY);
            }
            let half = whole.scaled(-1);
            (low.plus(half), half)
        });
        let is_finite = x.1.is_finite() && y.1.is_finite();
        let legs = match self {
            Self::Ball(_) | Self::Balls(_) => [y.1, S::ZERO, S::ZERO],
            Self::Torus(_) => [x.1, S::ZERO, S::ZERO],
            Self::Discs([below, above]) if is_finite => return Self::ball_around([*below, *above]),
            Self::Cone { height, .. } if is_finite => return Self::ball_around([[S::ZERO; 2], [*height, x.1]]),
            Self::Discs(_) | Self::Cone { .. } => [x.1, y.1, S::ZERO],
            _ => [x.1, y.1, z.1],
        };
        (Vec3::new(x.0, y.0, z.0), legs)
    }

    /// The smallest ball around two discs, the heights and radii of which are finite.
    fn ball_around([below, above]: [[S; 2]; 2]) -> (Vec3<S>, [S; 3]) {
        let ([from, large], [to, small]) = if above[1] > below[1] { (above, below) } else { (below, above) };
        let (apart, [large_real, small_real]) = (to.real() - from.real(), [large, small].map(S::real));
        // The edges of both discs are on it: c^2 + large^2 = (apart - c)^2 + small^2; or that of the large one, about
        // its centre.
        let taper = if large == small {
            S::Real::ZERO
        } else {
            (large_real + small_real) * ((large_real - small_real) / apart.abs())
        };
        let rise = apart.abs() - taper;
        let c = if rise > S::Real::ZERO { S::round(rise.scaled(-1)) } else { S::ZERO };
        let centre = if apart.is_negative() { from.minus(c) } else { from.plus(c) };
        (Vec3::new(S::ZERO, centre, S::ZERO), [large, c, S::ZERO])
    }

    /// Two balls whose convex hull holds the primitive but for rounding, each as [`Hull::ball`] has it. Those of a post
    /// are about its ends.
    pub(crate) fn ends(&self) -> [(Vec3<S>, [S; 3]); 2] {
        let about = |[y, radius]: [S; 2]| (Vec3::new(S::ZERO, y, S::ZERO), [radius, S::ZERO, S::ZERO]);
        match *self {
            Self::Discs(ends) | Self::Balls(ends) if ends.as_flattened().iter().all(|c| c.is_finite()) => {
                ends.map(about)
            }
            Self::Cone { slope, height } if height.is_finite() => {
                [[S::ZERO; 2], [height, S::round(slope.real() * height.real())]].map(about)
            }
            _ => [self.ball(); 2],
        }
    }

    /// The lowest and the highest coordinate of the primitive along each of its own axes, rounded.
    pub(crate) fn extents(&self) -> [[S; 2]; 3] {
        let around = |radius: S| [S::ZERO.minus(radius), radius];
        let larger = |a: S, b: S| if a > b { a } else { b };
        match *self {
            Self::Ball(radius) => [around(radius); 3],
            Self::Cuboid(half_extents) => half_extents.map(around),
            Self::Prism(polygon, height) => {
                let [x, z] = polygon.extents();
                [x, [S::ZERO, height], z]
            }
            Self::Box(CutBox { corners: [low, high], .. }) => pairs(low, high).map(|(low, high)| [low, high]),
            Self::RoundedCuboid(half, radius) => half.map(|half| around(half.plus(radius))),
            Self::Balls([[low, below], [high, above]]) => {
                let across = around(larger(below, above));
                let along = [(low, below), (high, above)].map(|(y, radius)| [y.minus(radius), y.plus(radius)]);
                let [[low, a], [other, b]] = along;
                [across, [if other < low { other } else { low }, larger(a, b)], across]
            }
            Self::Torus([major, minor]) => [around(major.plus(minor)), around(minor), around(major.plus(minor))],
            Self::Discs([[low, below], [high, above]]) => {
                let across = around(larger(below, above));
                [across, [low, high], across]
            }
            Self::Cone { slope, height } => {
                let is_endless = !height.is_finite();
                let across = around(if is_endless { S::INFINITY } else { S::round(slope.real() * height.real()) });
                [across, [S::ZERO, height], across]
            }
            Self::Points(points) => [0, 1, 2].map(|axis| {
                let along = points.map(|point| point.to_array()[axis]);
                along.into_iter().fold([along[0]; 2], |[low, high], c| [if c < low { c } else { low }, larger(c, high)])
            }),
        }
    }
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

impl<S: Scalar> Bounds<S> {
    /// The ball through the corners but for rounding, as [`Hull::ball`]; `None` of a box that is infinite.
    pub(crate) fn ball(&self) -> Option<(Vec3<S>, [S; 3])> {
        let (low, high) = (self.low.to_array(), self.high.to_array());
        let whole = pairs(low, high).map(|(low, high)| high.minus(low));
        let halves = whole.map(|whole| whole.scaled(-1));
        // Of fixed point a difference beyond the type is infinite, and its half is not.
        let is_finite = [low, high, whole].as_flattened().iter().all(|c| c.is_finite());
        is_finite.then(|| (self.low + Vec3::from(halves), halves))
    }
}
