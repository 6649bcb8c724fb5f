//! A shape: any primitive, placed in the world.
//!
//! | module | what it holds |
//! |---|---|
//! | `primitive` | any primitive, and any of a set |
//! | `placement`, `visible` | how a primitive is placed, and from which sides it is seen |
//! | [`kinds`] | the primitives and placements that a program is compiled with |
//! | `surface` | the surface at a hit |
//! | `shaped` | what has a shape |
//! | `known` | the crossings by a ray that is known to start inside, or outside |
//! | [`combination`] | solids combined into one: union, intersection, difference |
//! | `order` | the order of the crossings of many solids |
//! | `combined` | what a shape holds if it is a [combination](crate::Combination) |
//! | `ellipsoid` | balls that are stretched along the axes of a frame |
//! | `distance` | which part of a solid's surface a point is on |

pub mod combination;
mod combined;
mod distance;
mod ellipsoid;
mod kind;
pub mod kinds;
pub(crate) mod known;
pub(crate) mod order;
mod outlined;
mod placement;
mod primitive;
mod queries;
mod section;
mod shaped;
#[cfg(any(feature = "serde", feature = "defmt"))]
mod stored;
mod surface;
mod visible;

pub(crate) use combined::{Leaf, OnLeaf};
pub use ellipsoid::Ellipsoid;
pub(crate) use outlined::Outlined;
pub use placement::Placement;
pub use primitive::Primitive;
pub(crate) use section::Section;
pub use shaped::{HitsOf, Shaped};
pub use surface::Surface;
pub use visible::Visible;

use crate::bounds;
use crate::frame::Frame;
use crate::geometry::{Bounds, Geometry};
use crate::hit::{Hit, HitList, Undecided};
use crate::ladder::{self, ExactScalar};
use crate::line::InWorld;
use crate::part::Part;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::solve::{self, Of, Root};
use crate::tier::{Precision, Stable, Tier};
use crate::vector::{UnitVec3, Vec3};
use combination::{Combination, Op};
use combined::{Combined, Parts};
use core::fmt;
use distance::Beside;
use kinds::{All, Combining, Kind, KindError, Kinds, OfKind, Places, Primitives};
use primitive::Member;
use queries::{AllHits, Contains, Nearest, NeededPrecision, Occludes, TryNearest};

/// Any primitive of the kinds `K`, placed in the world, one-sided or two-sided; or a
/// [`Combination`], if the kinds are [`Combining`].
///
/// ```
/// use raylet::{Cone, Frame, Ray, Shape, UnitVec3, Vec3, Visible};
/// let frame = Frame::from_base_and_axis(Vec3::new(0.0_f32, 0.0, 10.0), UnitVec3::X)?;
/// let horn = Shape::new(Cone::open(0.5, 2.0)?).placed(frame).seen_from(Visible::Outside);
/// let ray = Ray::new(Vec3::new(1.0, 0.0, 0.0), UnitVec3::Z)?;
/// assert_eq!(horn.nearest(&ray).map(|hit| hit.t), Some(9.5));
/// # Ok::<(), raylet::Error>(())
/// ```
///
/// [`Shape::new`] makes a shape of any kind, and a program with one links the code of all of them. To link only some,
/// name them: see [`Kinds`].
///
/// ```
/// use raylet::{Cylinder, Frame, Plane, Ray, Shape, UnitVec3, Vec3};
/// type Seen = Shape<f32, (Cylinder<f32>, Plane<f32>, Frame<f32>)>;
/// let post = Seen::of(Cylinder::capped(0.5, 2.0)?).placed(Frame::at(Vec3::new(0.0, 0.0, 10.0))?);
/// let floor = Seen::of(Plane::new());
/// let ray = Ray::new(Vec3::new(0.0, 1.0, 0.0), UnitVec3::Z)?;
/// assert_eq!([post, floor].map(|shape| shape.nearest(&ray).map(|hit| hit.t)), [Some(9.5), None]);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct Shape<S: Scalar, K: Kinds = All> {
    member: Member<S, K>,
    placement: Placement<S>,
    visible: Visible,
    /// If it is a combination, that is what counts, and not primitive and placement.
    combined: K::Combined<S>,
}

/// Evaluates an expression with the shape's primitive and placement, the placement in its own type.
macro_rules! through {
    ($shape:ident, |$primitive:ident, $place:ident| $query:expr) => {{
        let $primitive = &$shape.member;
        match &$shape.placement {
            Placement::Affine($place) if K::SET.contains(Kind::Affine) => $query,
            Placement::Frame($place) if K::SET.contains(Kind::Frame) => $query,
            _ => {
                let $place = &InWorld;
                $query
            }
        }
    }};
}

use through;

impl<S: Scalar> Shape<S> {
    /// A primitive in its canonical pose, seen from both sides.
    pub fn new(primitive: impl Into<Primitive<S>>) -> Self {
        Self::unplaced(primitive.into())
    }
}

impl<S: Scalar, K: Kinds> Shape<S, K> {
    /// A primitive in its canonical pose, seen from both sides. The program does not compile if it is not among the
    /// kinds.
    pub fn of<P: OfKind + Into<Primitive<S>>>(primitive: P) -> Self {
        const { assert!(K::SET.contains(P::KIND), "this primitive is not among the kinds of the shape: name it there") }
        Self::unplaced(primitive.into())
    }

    /// The primitive must be among the kinds.
    const fn unplaced(primitive: Primitive<S>) -> Self {
        let combined = <K::Combined<S> as Combined<S>>::NONE;
        Self { member: Member::new(primitive), placement: Placement::World, visible: Visible::Both, combined }
    }

    /// The same shape, seen only from the given sides.
    #[must_use]
    pub const fn seen_from(self, visible: Visible) -> Self {
        Self { visible, ..self }
    }

    /// The sides from which it is seen.
    pub const fn visible(&self) -> Visible {
        self.visible
    }
}

/// What only a shape that is certainly a primitive has. A combination is placed by its leaves: see
/// [`combination`](crate::shape::combination#placement).
impl<S: Scalar, K: Primitives> Shape<S, K> {
    /// The same shape, placed by a [`Frame`], an [`Affine`](crate::Affine) or a [`Placement`]. The program does not
    /// compile if that is not among the kinds.
    #[must_use]
    pub fn placed(self, placement: impl Places<S>) -> Self {
        among::<K, _, _>(&placement);
        Self { placement: placement.into(), ..self }
    }

    /// The same shape, placed by a frame as by [`Shape::placed`]; also for constants. The program does not compile if
    /// frames are not among the kinds.
    #[must_use]
    pub const fn in_frame(self, frame: Frame<S>) -> Self {
        const {
            assert!(K::SET.contains(Kind::Frame), "this placement is not among the kinds of the shape: name it there");
        }
        Self { placement: Placement::Frame(frame), ..self }
    }

    /// The same shape among other kinds, for a primitive or a placement that is not known when the program is compiled.
    ///
    /// # Errors
    ///
    /// [`KindError`] if its primitive or its placement is not among them.
    ///
    /// ```
    /// use raylet::{Primitive, Plane, Shape, Sphere};
    /// let any: Primitive<f32> = Sphere::new(1.0)?.into();
    /// assert!(Shape::new(any).among::<(Sphere<f32>, Plane<f32>)>().is_ok());
    /// let error = Shape::new(any).among::<(Plane<f32>,)>().unwrap_err();
    /// let message = "a shape of the kinds Plane cannot have the kind Sphere: name it among the kinds";
    /// assert_eq!(error.to_string(), message);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn among<L: Kinds>(self) -> Result<Shape<S, L>, KindError> {
        for kind in [Some(self.primitive().kind()), self.placement.kind()].into_iter().flatten() {
            if !L::SET.contains(kind) {
                return Err(KindError { kind, among: L::SET });
            }
        }
        Ok(self.of_other_kinds())
    }

    /// Its primitive and placement must be among the other kinds.
    const fn of_other_kinds<L: Kinds>(self) -> Shape<S, L> {
        let (member, combined) = (Member::new(self.member.primitive), <L::Combined<S> as Combined<S>>::NONE);
        Shape { member, placement: self.placement, visible: self.visible, combined }
    }

    /// The same primitive for a list that holds combinations of such primitives, too: see [`Combining`]. Also for
    /// constants.
    pub const fn beside_combinations<'a>(self) -> Shape<S, Combining<'a, K>> {
        self.of_other_kinds()
    }

    /// The primitive.
    pub const fn primitive(&self) -> &Primitive<S> {
        &self.member.primitive
    }

    /// Its placement.
    pub const fn placement(&self) -> &Placement<S> {
        &self.placement
    }

    /// The frame that places it, to move or to turn the shape; `None` if an [`Affine`](crate::Affine) or nothing does.
    /// [`Placement::moved_to`] moves a shape however it is placed.
    ///
    /// ```
    /// use raylet::{Frame, Shape, Sphere, Vec3};
    /// let mut ball = Shape::new(Sphere::new(0.5_f32)?).placed(Frame::at(Vec3::new(1.0, 0.0, 0.0))?);
    /// if let Some(frame) = ball.frame() {
    ///     ball = ball.placed(frame.moved_to(frame.position() + Vec3::new(0.0, 0.25, 0.0))?);
    /// }
    /// assert_eq!(ball.placement().position(), Vec3::new(1.0, 0.25, 0.0));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub const fn frame(&self) -> Option<&Frame<S>> {
        match &self.placement {
            Placement::Frame(frame) => Some(frame),
            _ => None,
        }
    }

    /// How far a point is from a part of the solid's surface; infinite if there is no such part.
    pub(crate) fn distance_to(&self, part: Part, point: Vec3<S>) -> S {
        Beside::new(&self.member, &self.placement, point).distance_to(part)
    }

    /// The part of the solid's surface that a point is on, but for rounding: this one, if it is on that.
    pub(crate) fn part_at(&self, preferred: Part, point: Vec3<S>) -> Option<Part> {
        Beside::new(&self.member, &self.placement, point).part(preferred)
    }
}

impl<'a, S: Scalar, L: Primitives> Shape<S, Combining<'a, L>> {
    /// The shape of a combination, seen from both sides.
    pub(crate) const fn combining(combination: &'a Combination<'a, S, L>) -> Self {
        Self { combined: Some(combination), ..Self::unplaced(Primitive::Plane(crate::primitive::Plane::new())) }
    }

    /// The combination; `None` if the shape is a primitive.
    ///
    /// ```
    /// use raylet::{Combination, Shape, Sphere};
    /// let balls = [Shape::new(Sphere::new(1.0_f32)?); 2];
    /// let both = Combination::union(&balls)?;
    /// assert_eq!(both.shape().combination(), Some(&both));
    /// assert_eq!(balls[0].beside_combinations().combination(), None);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub const fn combination(&self) -> Option<&'a Combination<'a, S, L>> {
        self.combined
    }
}

impl<S: Scalar, K: Kinds> Shape<S, K> {
    /// All hits, sorted by `t`.
    pub fn hits(&self, ray: &Ray<S>) -> K::Hits<S> {
        self.hits_at::<Stable>(ray)
    }

    /// All hits, in a chosen accuracy tier.
    pub fn hits_at<T: Tier<S>>(&self, ray: &Ray<S>) -> K::Hits<S> {
        if self.visible == Visible::Both {
            return self.crossings_at::<T>(ray);
        }
        let mut hits = self.crossings_at::<T>(ray);
        hits.retain(|hit| self.visible.sees(hit.crossing));
        hits
    }

    /// All hits, from whichever side the shape is seen. A function of its own, so that a program finds the kind of a
    /// shape for its hits in one place.
    #[inline(never)]
    pub(crate) fn crossings_at<T: Tier<S>>(&self, ray: &Ray<S>) -> K::Hits<S> {
        let of_primitive = || through!(self, |member, place| member.visit(AllHits::<S, T, _>::new(place, ray)));
        self.combined.hits::<T>(ray, of_primitive)
    }

    /// The root at a hit of the ray in the tier `T` of its part's equation; `None` if the number `N` does not know a
    /// sign.
    pub(crate) fn root<N: Of<S>, T: Tier<S>>(&self, ray: &Ray<S>, hit: &Hit<S>) -> Option<Root<N>> {
        match self.combined.at::<T>(ray, hit) {
            Some(on) => on.shape.own_root(&on.ray, &on.hit),
            None => self.own_root(ray, hit),
        }
    }

    /// The same of a primitive.
    #[inline(always)]
    fn own_root<N: Of<S>>(&self, ray: &Ray<S>, hit: &Hit<S>) -> Option<Root<N>> {
        let equations = self.member.equations();
        let line = through!(self, |_member, place| ladder::line::<S, N, Member<S, K>>(&equations, place, ray));
        let departed = ray.departure().map(|departure| departure.part);
        solve::root_at::<S, N, Member<S, K>>(&equations, hit, &line, departed)
    }

    /// True for a solid, such as every combination; false for a surface without an inside: an open cylinder or cone, a
    /// plane, disc, triangle or rectangle.
    ///
    /// ```
    /// use raylet::{Cylinder, Shape};
    /// assert!(Shape::new(Cylinder::capped(1.0_f32, 2.0)?).is_solid());
    /// assert!(!Shape::new(Cylinder::open(1.0_f32, 2.0)?).is_solid());
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn is_solid(&self) -> bool {
        self.combined.is_combination() || self.member.equations().is_solid()
    }

    /// The visible hit with the smallest `t`.
    pub fn nearest(&self, ray: &Ray<S>) -> Option<Hit<S>> {
        self.nearest_at::<Stable>(ray)
    }

    /// The visible hit with the smallest `t`, in a chosen accuracy tier.
    pub fn nearest_at<T: Tier<S>>(&self, ray: &Ray<S>) -> Option<Hit<S>> {
        if self.combined.is_combination() {
            return self.combined.nearest::<T>(ray, self.visible);
        }
        through!(self, |member, place| member.visit(Nearest::<S, T, _>::new(place, ray, self.visible)))
    }

    /// As [`Shape::try_nearest_at`], in the tier [`Stable`].
    ///
    /// # Errors
    ///
    /// [`Undecided`] if the first numbers of the tier do not decide.
    pub fn try_nearest(&self, ray: &Ray<S>) -> Result<Option<Hit<S>>, Undecided> {
        self.try_nearest_at::<Stable>(ray)
    }

    /// The visible hit with the smallest `t`, as [`Shape::nearest_at`] returns it, if the first numbers of the tier
    /// decide it. No query takes longer, and a program that calls only this has the code of no other numbers.
    ///
    /// In fixed point the first numbers are integers on a grid. They do not decide where there is no room for the
    /// coordinates, along an axis, and next to touching; in `Stable` next to a rim too. In floats `Plain` decides
    /// always, and the other tiers where the error is small.
    ///
    /// # Errors
    ///
    /// [`Undecided`] if they do not decide; always for a ray that departs and for a combination.
    ///
    /// ```
    /// use fixed::types::I16F16;
    /// use raylet::{Cylinder, Fast, Ray, Shape, Vec3, hit::Undecided};
    /// let metres = |x: f64| I16F16::from_num(x);
    /// let post = Shape::new(Cylinder::capped(metres(0.25), metres(2.0))?);
    /// let eye = Vec3::new(metres(4.0), metres(1.0), metres(0.0));
    /// let ahead = Ray::towards(eye, Vec3::new(metres(0.0), metres(1.0), metres(0.125)))?;
    /// assert_eq!(post.try_nearest_at::<Fast>(&ahead), Ok(post.nearest_at::<Fast>(&ahead)));
    /// // Through the caps, along the axis.
    /// let down = Ray::towards(Vec3::new(metres(0.0), metres(4.0), metres(0.0)), Vec3::ZERO)?;
    /// assert_eq!(post.try_nearest_at::<Fast>(&down), Err(Undecided));
    /// assert_eq!(post.nearest_at::<Fast>(&down).map(|hit| hit.t), Some(metres(2.0)));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn try_nearest_at<T: Tier<S>>(&self, ray: &Ray<S>) -> Result<Option<Hit<S>>, Undecided> {
        if self.combined.is_combination() {
            return Err(Undecided);
        }
        through!(self, |member, place| member.visit(TryNearest::<S, T, _>::new(place, ray, self.visible)))
    }

    /// True if there is any visible hit.
    pub fn occludes(&self, ray: &Ray<S>) -> bool {
        self.occludes_at::<Stable>(ray)
    }

    /// True if there is any visible hit, in a chosen accuracy tier.
    pub fn occludes_at<T: Tier<S>>(&self, ray: &Ray<S>) -> bool {
        if self.combined.is_combination() {
            return self.combined.nearest::<T>(ray, self.visible).is_some();
        }
        through!(self, |member, place| member.visit(Occludes::<S, T, _>::new(place, ray, self.visible)))
    }

    /// True if the point belongs to the shape: inside or on a solid, on an open surface; of a combination, as its
    /// operations say of the leaves that contain the point.
    pub fn contains(&self, point: Vec3<S>) -> bool {
        self.contains_at::<Stable>(point)
    }

    /// True if the point belongs to the shape, in a chosen accuracy tier.
    pub fn contains_at<T: Tier<S>>(&self, point: Vec3<S>) -> bool {
        if let Some(contains) = self.combined.contains::<T>(point) {
            return contains;
        }
        through!(self, |member, place| member.visit(Contains::<S, T, _>::new(place, point)))
    }

    /// The precision that the tier [`Exact`](crate::tier::Exact) uses to decide this ray; of a combination, to decide
    /// it at every leaf.
    pub fn precision(&self, ray: &Ray<S>) -> Precision
    where
        S: ExactScalar,
    {
        if let Some((leaves, _)) = self.combined.parts() {
            let needs_integers = leaves.iter().any(|leaf| leaf.own_precision(ray) == Precision::Integers);
            return if needs_integers { Precision::Integers } else { Precision::Filter };
        }
        self.own_precision(ray)
    }

    /// The same of a primitive.
    #[inline(always)]
    fn own_precision(&self, ray: &Ray<S>) -> Precision
    where
        S: ExactScalar,
    {
        through!(self, |member, place| member.visit(NeededPrecision { place, ray }))
    }

    /// The axis-aligned bounding box. It contains every point of the shape, with position, axes or matrix and sizes
    /// taken exactly as they are stored.
    ///
    /// Each side is at the smallest value of the number type that is large enough, or one unit in the last place
    /// farther. Where the side's coordinate is a sum whose terms cancel, that is a unit of the largest term. The box is
    /// larger by some units if the axes of an [`Affine`](crate::Affine) lie nearly in a plane (the volume that their
    /// directions span is below 1/64), and if numbers are subnormal.
    ///
    /// In a frame or a matrix every side depends on all sizes of the solid. The rows are inverted in twice the
    /// precision, so that a component of the inverse whose terms cancel is uncertain by at most 2^-42 in `f32` and
    /// 2^-100 in `f64`; the box is wider by that part of the longest size. It shows only where sizes differ by more
    /// than 2^18 in `f32` and 2^47 in `f64`: a thin cuboid of half extents 2^60 apart in `f32` may be wider by
    /// thousands of units of its thickness, and contains the shape nevertheless.
    ///
    /// That of a combination is made of the boxes of its leaves: the union of them, their intersection, or that of the
    /// solid which others are subtracted from.
    ///
    /// A side is infinite if the shape is infinite in that direction, if the coordinate is beyond the number type, or
    /// if a float overflows in the computation.
    ///
    /// ```
    /// use raylet::{Capsule, Frame, Shape, UnitVec3, Vec3};
    /// let rod = Shape::new(Capsule::new(1.0_f64, 3.0)?);
    /// let leaning = UnitVec3::new(Vec3::new(1.0, 1.0, 0.0)).expect("it is not zero");
    /// let box_of_it = rod.placed(Frame::from_base_and_axis(Vec3::ZERO, leaning)?).bounds();
    /// // 3 / sqrt(2) + 1, and 1: the box of the unplaced box would reach 5 / sqrt(2).
    /// assert!(box_of_it.high.x < 3.122 && box_of_it.high.z < 1.000_001);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn bounds(&self) -> Bounds<S> {
        match self.combined.parts() {
            Some((leaves, operations)) => combination::bounds(leaves, operations, Shape::own_bounds),
            None => self.own_bounds(),
        }
    }

    /// The primitive and its placement, of a shape that is no combination.
    #[inline(always)]
    pub(crate) const fn own(&self) -> (&Primitive<S>, &Placement<S>) {
        (&self.member.primitive, &self.placement)
    }

    /// The leaves and the operations, if it is a combination.
    #[inline(always)]
    pub(crate) fn combined(&self) -> Option<Parts<'_, S, K::Leaves, impl Iterator<Item = Op>>> {
        self.combined.parts()
    }

    /// The box of a primitive.
    pub(crate) fn own_bounds(&self) -> Bounds<S> {
        let hull = self.member.hull();
        match &self.placement {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => {
                bounds::in_frame::<S, Member<S, K>>(&hull, frame)
            }
            Placement::Affine(affine) if K::SET.contains(Kind::Affine) => {
                bounds::in_affine::<S, Member<S, K>>(&hull, affine)
            }
            _ => bounds::unplaced::<S, Member<S, K>>(&hull),
        }
    }

    /// A ball that holds the shape but for rounding, as [`Hull::ball`](crate::geometry::Hull::ball). `None` of a
    /// combination, and of a shape that a matrix places.
    pub(crate) fn ball(&self) -> Option<(Vec3<S>, [S; 3])> {
        self.in_world([self.member.hull().ball()]).map(|[ball]| ball)
    }

    /// The same, and of a combination or a shape that a matrix places the one around its box, which takes much longer.
    pub(crate) fn ball_or_box(&self) -> Option<(Vec3<S>, [S; 3])> {
        match self.ball() {
            None if K::SET.contains(Kind::Affine) || self.combined.parts().is_some() => self.bounds().ball(),
            ball => ball,
        }
    }

    /// Two balls whose convex hull holds the shape, as [`Hull::ends`](crate::geometry::Hull::ends).
    pub(crate) fn ends(&self) -> Option<[(Vec3<S>, [S; 3]); 2]> {
        self.in_world(self.member.hull().ends())
    }

    /// Balls of the primitive's frame in the world.
    fn in_world<const N: usize>(&self, balls: [(Vec3<S>, [S; 3]); N]) -> Option<[(Vec3<S>, [S; 3]); N]> {
        if self.combined.parts().is_some() {
            return None;
        }
        match &self.placement {
            Placement::World => Some(balls),
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => {
                Some(balls.map(|(centre, legs)| (frame.point_to_world(centre), legs)))
            }
            _ => None,
        }
    }

    /// A point of a plane that is seen from both sides, and its normal; `None` of any other shape.
    pub(crate) fn plane(&self) -> Option<(Vec3<S>, UnitVec3<S>)> {
        let is_plane = self.combined.parts().is_none()
            && self.visible == Visible::Both
            && matches!(self.member.primitive, Primitive::Plane(_));
        match &self.placement {
            Placement::World if is_plane => Some((Vec3::ZERO, UnitVec3::Y)),
            Placement::Frame(frame) if is_plane => Some((frame.position(), frame.up())),
            Placement::Affine(affine) if is_plane && K::SET.contains(Kind::Affine) => {
                let [_, (up, _), _] = affine.inverse();
                Some((affine.position(), UnitVec3::from_real(up.map(S::unit_real))?))
            }
            _ => None,
        }
    }

    /// The surface at a hit of this shape: point, normal, surface coordinates, tangents. Each is computed only when its
    /// method is called. `ray` must be the ray of the hit.
    #[inline]
    pub fn surface<'a>(&'a self, ray: &'a Ray<S>, hit: &'a Hit<S>) -> Surface<S, K> {
        match self.combined.at::<Stable>(ray, hit) {
            Some(on) => Surface::new(&on.shape.of_other_kinds(), &on.ray, &on.hit, on.leaf),
            None => Surface::new(self, ray, hit, <K::Combined<S> as Combined<S>>::NO_LEAF),
        }
    }
}

/// Compiles only if the placement is among the kinds.
const fn among<K: Kinds, S: Scalar, P: Places<S>>(_: &P) {
    const {
        assert!(K::SET.contains_all(P::KINDS), "this placement is not among the kinds of the shape: name it there");
    }
}

impl<S: Scalar, K: Kinds> fmt::Debug for Shape<S, K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut written = f.debug_struct("Shape");
        if self.combined.is_combination() {
            return written.field("combination", &self.combined).field("visible", &self.visible).finish();
        }
        written.field("primitive", &self.member.primitive).field("placement", &self.placement);
        written.field("visible", &self.visible).finish()
    }
}
