//! A shape: any primitive, placed in the world.

mod surface;

pub use surface::Surface;

use crate::affine::Affine;
use crate::bounds;
use crate::exact::Certain;
use crate::fast::Guards;
use crate::figure::Figure;
use crate::frame::Frame;
use crate::geometry::{Bounds, Geometry, Hull};
use crate::hit::{Crossing, Hit, Hits};
use crate::intersection::{End, Intersection};
use crate::ladder;
use crate::line::{InWorld, Place};
use crate::part::Part;
use crate::primitive::{Capsule, Cone, Cylinder, Disc, Plane, Sphere, Triangle};
use crate::ray::Ray;
use crate::scalar::{Attempt, LocalLine, Scalar};
use crate::tier::{Effort, Stable, Tier};
use crate::vector::{UnitVec3, Vec3};

/// Defines the enum of all primitives and passes every call on to the one that it holds.
macro_rules! primitives {
    ($($Variant:ident),+) => {
        /// Any primitive, without allocation or dynamic dispatch.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub enum Primitive<S: Scalar> {
            $(
                #[doc = concat!("A [`", stringify!($Variant), "`].")]
                $Variant($Variant<S>),
            )+
        }

        $(
            impl<S: Scalar> From<$Variant<S>> for Primitive<S> {
                fn from(primitive: $Variant<S>) -> Self {
                    Self::$Variant(primitive)
                }
            }
        )+

        $(
            impl<S: Scalar> $Variant<S> {
                /// The surface at a hit: point, normal, surface coordinates, tangents. See [`Shape::surface`].
                pub fn surface(&self, ray: &Ray<S>, hit: &Hit<S>) -> Surface<S> {
                    Shape::new(*self).surface(ray, hit)
                }
                /// The axis-aligned bounding box: see [`Shape::bounds`].
                pub fn bounds(&self) -> Bounds<S> {
                    bounds::unplaced(&self.hull())
                }
            }
        )+

        impl<S: Scalar> Geometry<S> for Primitive<S> {
            type Doubles = Primitive<f64>;

            #[inline(always)]
            fn in_doubles(&self) -> Self::Doubles {
                match self { $(Self::$Variant(p) => Primitive::$Variant(p.in_doubles()),)+ }
            }
            fn reach(&self) -> S {
                match self { $(Self::$Variant(p) => p.reach(),)+ }
            }
            fn scaled(&self, e: i32) -> Self {
                match self { $(Self::$Variant(p) => Self::$Variant(p.scaled(e)),)+ }
            }
            #[inline(always)]
            fn fast_line(&self, place: &impl Place<S>, ray: &Ray<S>) -> Option<LocalLine<S>> {
                match self { $(Self::$Variant(p) => p.fast_line(place, ray),)+ }
            }
            fn lengths(&self) -> S {
                match self { $(Self::$Variant(p) => p.lengths(),)+ }
            }
            #[inline(always)]
            fn fit(&self, line: &mut LocalLine<S>) {
                match self { $(Self::$Variant(p) => p.fit(line),)+ }
            }
            #[inline(always)]
            fn far_line(&self, place: &impl Place<S>, ray: &Ray<S>) -> Option<LocalLine<S>> {
                match self { $(Self::$Variant(p) => p.far_line(place, ray),)+ }
            }
            #[inline(always)]
            fn second_line(&self, place: &impl Place<S>, ray: &Ray<S>) -> Option<LocalLine<S>> {
                match self { $(Self::$Variant(p) => p.second_line(place, ray),)+ }
            }
            #[inline(always)]
            fn fast_intersection<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>> {
                match self { $(Self::$Variant(p) => fast_intersection::<S, T, _>(p, line),)+ }
            }
            #[inline(always)]
            fn fast_occlusion<T: Guards>(&self, line: &LocalLine<S>) -> Attempt<()> {
                match self { $(Self::$Variant(p) => fast_occlusion::<S, T, _>(p, line),)+ }
            }
            #[inline(always)]
            fn fast_exit<T: Guards>(&self, line: &LocalLine<S>, from: Part) -> Attempt<End<S>> {
                match self { $(Self::$Variant(p) => p.fast_exit::<T>(line, from),)+ }
            }
            fn figure(&self) -> Figure<S> {
                match self { $(Self::$Variant(p) => p.figure(),)+ }
            }
            fn hull(&self) -> Hull<S> {
                match self { $(Self::$Variant(p) => p.hull(),)+ }
            }
            fn on_surface(&self, point: Vec3<S>, part: Part) -> Vec3<S> {
                match self { $(Self::$Variant(p) => p.on_surface(point, part),)+ }
            }
            fn normal(&self, point: Vec3<S>, part: Part) -> UnitVec3<S> {
                match self { $(Self::$Variant(p) => p.normal(point, part),)+ }
            }
            fn bend(&self, point: Vec3<S>, part: Part) -> S {
                match self { $(Self::$Variant(p) => p.bend(point, part),)+ }
            }
            fn uv(&self, point: Vec3<S>, part: Part) -> (S::Unit, S::Unit) {
                match self { $(Self::$Variant(p) => p.uv(point, part),)+ }
            }
            fn tangents(&self, point: Vec3<S>, part: Part) -> (UnitVec3<S>, UnitVec3<S>) {
                match self { $(Self::$Variant(p) => p.tangents(point, part),)+ }
            }
        }
    };
}

// Not inlined, so that the program has one copy for each primitive, and not one for each placement and query.
#[inline(never)]
fn fast_intersection<S: Scalar, T: Guards, G: Geometry<S>>(
    geometry: &G,
    line: &LocalLine<S>,
) -> Attempt<Intersection<S>> {
    geometry.fast_intersection::<T>(line)
}
#[inline(never)]
fn fast_occlusion<S: Scalar, T: Guards, G: Geometry<S>>(geometry: &G, line: &LocalLine<S>) -> Attempt<()> {
    geometry.fast_occlusion::<T>(line)
}

primitives!(Sphere, Cylinder, Cone, Capsule, Plane, Disc, Triangle);

/// How a primitive is placed in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Placement<S: Scalar> {
    /// In its canonical pose (see [`crate::primitive`]): the primitive's coordinates are world coordinates.
    World,
    /// Rotated and translated.
    Frame(Frame<S>),
    /// Transformed by any invertible affine map.
    Affine(Affine<S>),
}

impl<S: Scalar> Placement<S> {
    /// Where the primitive's origin lies.
    pub fn position(&self) -> Vec3<S> {
        match self {
            Self::World => Vec3::ZERO,
            Self::Frame(frame) => frame.position(),
            Self::Affine(affine) => affine.position(),
        }
    }

    /// The images of the primitive's x, y and z axes, rounded to the number type; see [`Affine::axes`].
    ///
    /// ```
    /// # use raylet::{Frame, Placement, UnitVec3, Vec3};
    /// let lying = Placement::from(Frame::from_base_and_axis(Vec3::new(1.0_f32, 0.0, 0.0), UnitVec3::X)?);
    /// assert_eq!(lying.axes()[1], Vec3::new(1.0, 0.0, 0.0));
    /// let point = lying.point_to_world(Vec3::new(0.0, 3.0, 0.0));
    /// assert_eq!((point, lying.point_to_local(point)), (Vec3::new(4.0, 0.0, 0.0), Vec3::new(0.0, 3.0, 0.0)));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn axes(&self) -> [Vec3<S>; 3] {
        let in_coordinates = |axes: [UnitVec3<S>; 3]| axes.map(|axis| Vec3::round(axis.real()));
        match self {
            Self::World => in_coordinates([UnitVec3::X, UnitVec3::Y, UnitVec3::Z]),
            Self::Frame(frame) => in_coordinates(frame.axes()),
            Self::Affine(affine) => affine.axes(),
        }
    }

    /// A point of the primitive in the world, rounded to nearest.
    pub fn point_to_world(&self, point: Vec3<S>) -> Vec3<S> {
        match self {
            Self::World => point,
            Self::Frame(frame) => frame.point_to_world(point),
            Self::Affine(affine) => affine.point_to_world(point),
        }
    }

    /// A point of the world in the primitive's coordinates, rounded to nearest: the inverse of the placement.
    pub fn point_to_local(&self, point: Vec3<S>) -> Vec3<S> {
        match self {
            Self::World => point,
            Self::Frame(frame) => frame.point_to_local(point),
            Self::Affine(affine) => affine.point_to_local(point),
        }
    }
}

impl<S: Scalar> From<Frame<S>> for Placement<S> {
    fn from(frame: Frame<S>) -> Self {
        Self::Frame(frame)
    }
}

impl<S: Scalar> From<Affine<S>> for Placement<S> {
    fn from(affine: Affine<S>) -> Self {
        Self::Affine(affine)
    }
}

/// Culling: from which sides rays hit a surface. A one-sided surface ignores crossings from its other side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Visible {
    /// From both sides.
    #[default]
    Both,
    /// From outside (of an open surface, from the front) only: no [`Crossing::Exit`] is reported.
    Outside,
    /// From inside (of an open surface, from the back) only: no [`Crossing::Enter`] is reported.
    Inside,
}

impl Visible {
    /// True if such a crossing is reported. A touch always is.
    #[inline]
    const fn sees(self, crossing: Crossing) -> bool {
        !matches!((self, crossing), (Self::Outside, Crossing::Exit) | (Self::Inside, Crossing::Enter))
    }
}

/// Any primitive, placed in the world, one-sided or two-sided.
///
/// ```
/// use raylet::{Cone, Frame, Ray, Shape, UnitVec3, Vec3, Visible};
/// let frame = Frame::from_base_and_axis(Vec3::new(0.0_f32, 0.0, 10.0), UnitVec3::X)?;
/// let horn = Shape::new(Cone::open(0.5, 2.0)?).placed(frame).seen_from(Visible::Outside);
/// let ray = Ray::new(Vec3::new(1.0, 0.0, 0.0), UnitVec3::Z)?;
/// assert_eq!(horn.nearest(&ray).map(|hit| hit.t), Some(9.5));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shape<S: Scalar> {
    primitive: Primitive<S>,
    placement: Placement<S>,
    visible: Visible,
}

/// Evaluates a query with the shape's primitive and placement, each in its own type.
macro_rules! through {
    ($shape:ident, |$primitive:ident, $place:ident| $query:expr) => {{
        let $primitive = &$shape.primitive;
        match &$shape.placement {
            Placement::World => {
                let $place = &InWorld;
                $query
            }
            Placement::Frame($place) => $query,
            Placement::Affine($place) => $query,
        }
    }};
}

use through;

impl<S: Scalar> Shape<S> {
    /// A primitive in its canonical pose, seen from both sides.
    pub fn new(primitive: impl Into<Primitive<S>>) -> Self {
        Self { primitive: primitive.into(), placement: Placement::World, visible: Visible::Both }
    }

    /// The same shape, placed by a [`Frame`] or an [`Affine`].
    #[must_use]
    pub fn placed(self, placement: impl Into<Placement<S>>) -> Self {
        Self { placement: placement.into(), ..self }
    }

    /// The same shape, seen only from the given sides.
    #[must_use]
    pub const fn seen_from(self, visible: Visible) -> Self {
        Self { visible, ..self }
    }

    /// The primitive.
    pub const fn primitive(&self) -> &Primitive<S> {
        &self.primitive
    }

    /// Its placement.
    pub const fn placement(&self) -> &Placement<S> {
        &self.placement
    }

    /// The sides from which it is seen.
    pub const fn visible(&self) -> Visible {
        self.visible
    }

    /// All hits, sorted by `t`.
    pub fn hits(&self, ray: &Ray<S>) -> Hits<S> {
        self.hits_at::<Stable>(ray)
    }

    /// All hits, in a chosen accuracy tier.
    pub fn hits_at<T: Tier<S>>(&self, ray: &Ray<S>) -> Hits<S> {
        let mut hits = through!(self, |primitive, place| T::hits(primitive, place, ray));
        if self.visible != Visible::Both {
            hits.retain(|hit| self.visible.sees(hit.crossing));
        }
        hits
    }

    /// The visible hit with the smallest `t`.
    pub fn nearest(&self, ray: &Ray<S>) -> Option<Hit<S>> {
        self.nearest_at::<Stable>(ray)
    }

    /// The visible hit with the smallest `t`, in a chosen accuracy tier.
    pub fn nearest_at<T: Tier<S>>(&self, ray: &Ray<S>) -> Option<Hit<S>> {
        let accept = |crossing| self.visible.sees(crossing);
        through!(self, |primitive, place| T::nearest(primitive, place, ray, accept))
    }

    /// True if there is any visible hit.
    pub fn occludes(&self, ray: &Ray<S>) -> bool {
        self.occludes_at::<Stable>(ray)
    }

    /// True if there is any visible hit, in a chosen accuracy tier.
    pub fn occludes_at<T: Tier<S>>(&self, ray: &Ray<S>) -> bool {
        let accept = |crossing| self.visible.sees(crossing);
        through!(self, |primitive, place| T::occludes(primitive, place, ray, accept))
    }

    /// True if the point belongs to the shape: inside or on a solid, on an open surface.
    pub fn contains(&self, point: Vec3<S>) -> bool {
        self.contains_at::<Stable>(point)
    }

    /// True if the point belongs to the shape, in a chosen accuracy tier.
    pub fn contains_at<T: Tier<S>>(&self, point: Vec3<S>) -> bool {
        through!(self, |primitive, place| T::contains(primitive, place, point))
    }

    /// The precision that the tier [`Exact`](crate::tier::Exact) uses to decide this ray.
    pub fn effort(&self, ray: &Ray<S>) -> Effort
    where
        S: Certain,
    {
        through!(self, |primitive, place| ladder::effort(primitive, place, ray))
    }

    /// The axis-aligned bounding box. It contains every point of the shape, with position, axes or matrix and sizes taken exactly as
    /// they are stored.
    ///
    /// Each side is at the smallest value of the number type that is large enough, or one unit in the last place farther. Where the side's
    /// coordinate is a sum whose terms cancel, that is a unit of the largest term. The box is larger by some units if the axes of an
    /// [`Affine`] lie nearly in a plane (the volume that their directions span is below 1/64), and if numbers are subnormal.
    ///
    /// A side is infinite if the shape is infinite in that direction, if the coordinate is beyond the number type, or if a float
    /// overflows in the computation.
    ///
    /// ```
    /// use raylet::{Capsule, Frame, Shape, UnitVec3, Vec3};
    /// let rod = Shape::new(Capsule::new(1.0_f64, 3.0)?);
    /// let leaning = UnitVec3::new(Vec3::new(1.0, 1.0, 0.0)).expect("it is not zero");
    /// let box_of_it = rod.placed(Frame::from_base_and_axis(Vec3::ZERO, leaning)?).bounds();
    /// // 3 / sqrt(2) + 1, and 1: the box of the unplaced box would reach up to 5 / sqrt(2).
    /// assert!(box_of_it.high.x < 3.122 && box_of_it.high.z < 1.000_001);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn bounds(&self) -> Bounds<S> {
        let hull = self.primitive.hull();
        match &self.placement {
            Placement::World => bounds::unplaced(&hull),
            Placement::Frame(frame) => bounds::in_frame(&hull, frame),
            Placement::Affine(affine) => bounds::in_affine(&hull, affine),
        }
    }

    /// The surface at a hit of this shape: point, normal, surface coordinates, tangents. Each is computed only when its method is
    /// called. `ray` must be the ray of the hit.
    #[inline]
    pub fn surface<'a>(&'a self, ray: &'a Ray<S>, hit: &'a Hit<S>) -> Surface<S> {
        Surface::new(self, ray, hit)
    }
}
