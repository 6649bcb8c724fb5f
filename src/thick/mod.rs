//! Thick rays: where a ball that moves along a ray first touches a solid.
//!
//! | module | what it holds |
//! |---|---|
//! | `set` | a solid as all points within a radius of a simple set; the nearest point of that |
//! | `grown` | where a ray enters the same set with a larger radius |
//!
//! The centre of a ball of radius `r` that touches a solid lies on the surface of the solid grown by `r`: of all points
//! within `r` of it. So the ball touches first where its centre's ray enters the grown solid (Ericson, *Real-Time
//! Collision Detection*, 2005, 5.5.3). A sphere grows to a sphere, a capsule to a capsule, a plane to a slab, a cuboid
//! and a rectangle to a rounded cuboid. A triangle grows to pieces: its copies at the distance `r`, and a capsule about
//! each edge.
//!
//! # Accuracy
//!
//! The pieces are rounded to the number type, each coordinate by at most two units of the largest one, and then tested
//! as any shape is, in the tier of the query. At a contact the distance of the ball's centre from the solid is the
//! radius within a few such units; `t` is as much more uncertain as the ray grazes the grown solid.
//!
//! # A ball that goes on
//!
//! A ball that was moved to a contact touches the solid there, within rounding, or overlaps it by as much. It is in
//! contact again only if it moves closer, so that it can leave and slide:
//!
//! - It *touches* if its distance is at most eight units in the last place of the largest of the numbers that it is
//!   computed from (in fixed point less than sixteen).
//! - It *moves closer* if, along a path of the length of its radius, it comes closer by more than that, or
//!   if it moves against the normal by more than a sixteenth of its path. Where it touches, its normal is not more
//!   certain than that.
//!
//! A ball that slides for long, or overlaps for another reason, is pushed out by what [`ThickRay::at_start`] returns.

mod grown;
mod set;

use self::set::Core;
use crate::frame::FrameError;
use crate::primitive::{SizeError, checked_size};
use crate::ray::Ray;
use crate::scalar::{Ring, Scalar, largest};
use crate::shape::Shape;
use crate::shape::kinds::{Kind, Primitives};
use crate::tier::{Stable, Tier};
use crate::vector::{UnitVec3, Vec3};
use core::fmt;

/// A ball whose centre moves along a ray, within the ray's range.
///
/// ```
/// use raylet::thick::ThickRay;
/// use raylet::{Cuboid, Frame, Ray, Shape, UnitVec3, Vec3};
/// let crate_ = Shape::new(Cuboid::new(1.0_f32, 1.0, 1.0)?).placed(Frame::at(Vec3::new(5.0, 0.0, 0.0))?);
/// let ball = ThickRay::new(Ray::new(Vec3::new(0.0, 0.5, 0.0), UnitVec3::X)?, 0.5)?;
/// let contact = ball.contact(&crate_)?.expect("it is in the way");
/// // The centre stops at x = 3.5, the ball's radius in front of the face.
/// assert_eq!((contact.t, contact.point), (3.5, Vec3::new(4.0, 0.5, 0.0)));
/// assert_eq!(contact.normal, -UnitVec3::X);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThickRay<S: Scalar> {
    ray: Ray<S>,
    radius: S,
}

/// Where a moving ball first touches a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
pub struct Contact<S: Scalar> {
    /// The ray's `t` at the ball's centre.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub t: S,
    /// The point of the solid's surface that is nearest to the centre. If the centre is inside of a cuboid, the centre.
    pub point: Vec3<S>,
    /// The direction in which the ball is pushed: from that point to the centre; if the centre is inside of a sphere or
    /// capsule, from the centre to that point. Where no single point is nearest (the centre lies in a flat part, on an
    /// axis, at the centre of a sphere or inside of a cuboid or of a rounded one's core), the direction of those that
    /// is most against the ray.
    pub normal: UnitVec3<S>,
    /// The ball overlaps the solid where the range of its ray starts, by more than rounding.
    pub overlaps: bool,
}

impl<S: Scalar> ThickRay<S> {
    /// A ball of this radius. A departure of the ray has no effect.
    ///
    /// # Errors
    ///
    /// [`SizeError::Radius`] if the radius is not positive, not finite or beyond the budget.
    pub fn new(ray: Ray<S>, radius: S) -> Result<Self, SizeError> {
        Ok(Self { ray: ray.without_departure(), radius: checked_size(radius, SizeError::Radius)? })
    }

    /// The ray of the centre.
    pub const fn ray(&self) -> &Ray<S> {
        &self.ray
    }

    /// The ball's radius.
    pub const fn radius(&self) -> S {
        self.radius
    }

    /// Where the ball first touches the shape: a sphere, capsule, plane, cuboid, rounded cuboid, rectangle or triangle
    /// in a frame or in the world, from both sides. `None` if it does not within the range.
    ///
    /// A ball that touches or overlaps the shape where the range starts is in contact there if it moves closer, and
    /// otherwise not at all: see [the module](self).
    ///
    /// # Errors
    ///
    /// [`ThickError`] for another primitive, for an affine placement, and if a piece of the grown shape is beyond the
    /// budget.
    pub fn contact<K: Primitives>(&self, shape: &Shape<S, K>) -> Result<Option<Contact<S>>, ThickError> {
        self.contact_at::<Stable, K>(shape)
    }

    /// As [`ThickRay::contact`], in a chosen accuracy tier.
    ///
    /// # Errors
    ///
    /// As [`ThickRay::contact`].
    pub fn contact_at<T: Tier<S>, K: Primitives>(&self, shape: &Shape<S, K>) -> Result<Option<Contact<S>>, ThickError> {
        let (core, start) = (Core::of(shape)?, self.start());
        if !core.is_apart(&self.ray, start, self.radius) {
            let first = self.place(&core, start);
            if first.touches {
                return Ok(first.comes_closer(self).then_some(first.contact));
            }
        }
        let t = grown::entry::<S, T>(&core, &self.ray, self.radius)?;
        Ok(t.map(|t| Contact { overlaps: false, ..self.place(&core, t).contact }))
    }

    /// The contact where the range starts, if the ball touches or overlaps the shape there, wherever it moves. To push
    /// it out, its centre is moved to the point, and from there by the radius along the normal. (If the centre is
    /// inside of a cuboid or of a rounded one's core, that is not enough.)
    ///
    /// # Errors
    ///
    /// As [`ThickRay::contact`].
    ///
    /// ```
    /// use raylet::thick::ThickRay;
    /// use raylet::{Plane, Ray, Shape, UnitVec3, Vec3};
    /// let floor = Shape::new(Plane::new());
    /// let ball = ThickRay::new(Ray::new(Vec3::new(0.0_f32, 0.25, 0.0), UnitVec3::X)?, 0.5)?;
    /// // It slides, and is a quarter too deep.
    /// assert_eq!(ball.contact(&floor)?, None);
    /// let contact = ball.at_start(&floor)?.expect("it overlaps the floor");
    /// assert!(contact.overlaps && contact.normal == UnitVec3::Y);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn at_start<K: Primitives>(&self, shape: &Shape<S, K>) -> Result<Option<Contact<S>>, ThickError> {
        let first = self.place(&Core::of(shape)?, self.start());
        Ok(first.touches.then_some(first.contact))
    }

    /// The start of the range; if that is at the limit of a float, a `t` whose distances do not overflow.
    fn start(&self) -> S {
        let start = self.ray.range().start();
        let far = if S::RELATIVE { S::BUDGET.distance.scaled(-2) } else { S::BUDGET.distance };
        if start > far {
            far
        } else if start < -far {
            -far
        } else {
            start
        }
    }

    /// The ball at `t` beside a solid.
    fn place(&self, core: &Core<'_, S>, t: S) -> Beside<S> {
        let offset = core.offset(&self.ray, t);
        let distance = offset.length.minus(core.radius);
        let normal = offset.direction.unwrap_or_else(|| core.outwards(-self.ray.direction()));
        let centre = self.ray.at(t);
        let point = S::advance(centre.to_array(), normal.to_array(), S::ZERO.minus(distance));
        let (gap, reach) = (distance.minus(self.radius), largest([core.reach(centre), self.radius]));
        let is_rounding = is_rounding(gap, reach);
        let contact = Contact { t, point: point.into(), normal, overlaps: gap < S::ZERO && !is_rounding };
        Beside { contact, touches: is_rounding || gap < S::ZERO, reach }
    }
}

/// True if a difference of numbers of this magnitude is at most eight units in the last place (less than sixteen in
/// fixed point).
fn is_rounding<S: Scalar>(difference: S, reach: S) -> bool {
    let sixteenth = difference.magnitude().scaled(-4);
    if S::RELATIVE { reach.plus(sixteenth) == reach } else { sixteenth == S::ZERO }
}

/// A ball beside a solid.
struct Beside<S: Scalar> {
    contact: Contact<S>,
    /// It touches or overlaps it.
    touches: bool,
    /// The largest of the numbers that it was computed from.
    reach: S,
}

impl<S: Scalar> Beside<S> {
    /// True if the ball moves closer: see [the module](self).
    fn comes_closer(&self, ball: &ThickRay<S>) -> bool {
        let rate = S::unit_round(-ball.ray.direction().dot(self.contact.normal));
        let closer = ball.radius.along(rate);
        closer > S::ZERO && (!is_rounding(closer, self.reach) || S::unit_real(rate) > S::Real::ONE.scaled(-4))
    }
}

/// The first contact of a moving ball with the shapes of a list, and the index of its shape; of several at the same `t`
/// that of the lowest index.
///
/// # Errors
///
/// As [`ThickRay::contact`].
///
/// ```
/// use raylet::thick::{self, ThickRay};
/// use raylet::{Frame, Plane, Ray, Shape, Sphere, Stable, UnitVec3, Vec3};
/// let post = Shape::new(Sphere::new(0.5_f32)?).placed(Frame::at(Vec3::new(4.0, 0.5, 0.0))?);
/// let level = [Shape::new(Plane::new()), post];
/// let ball = ThickRay::new(Ray::new(Vec3::new(0.0, 0.5, 0.0), UnitVec3::X)?, 0.25)?;
/// let first = thick::first::<_, Stable, _>(&ball, &level)?;
/// assert_eq!(first.map(|(shape, contact)| (shape, contact.t)), Some((1, 3.25)));
/// # Ok::<(), raylet::Error>(())
/// ```
pub fn first<S: Scalar, T: Tier<S>, K: Primitives>(
    ball: &ThickRay<S>,
    shapes: &[Shape<S, K>],
) -> Result<Option<(u32, Contact<S>)>, ThickError> {
    let mut first: Option<(u32, Contact<S>)> = None;
    for (index, shape) in (0_u32..).zip(shapes) {
        if let Some(contact) = ball.contact_at::<T, K>(shape)?
            && first.is_none_or(|(_, best)| contact.t < best.t)
        {
            first = Some((index, contact));
        }
    }
    Ok(first)
}

/// Why the contact of a ball with a shape cannot be found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ThickError {
    /// A primitive whose grown shape is not known: a cylinder, a cone, a round cone, a tube, a torus, a quadric of
    /// revolution, a disc or an annulus.
    Primitive(Kind),
    /// An affine placement, whose coordinates may be stretched: a ball would be an ellipsoid in them.
    Affine,
    /// A size of a piece of the grown shape is beyond the budget.
    Size(SizeError),
    /// The position of a piece of the grown shape is beyond the budget.
    Frame(FrameError),
}

impl From<SizeError> for ThickError {
    fn from(error: SizeError) -> Self {
        Self::Size(error)
    }
}

impl From<FrameError> for ThickError {
    fn from(error: FrameError) -> Self {
        Self::Frame(error)
    }
}

impl fmt::Display for ThickError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Primitive(kind) => write!(
                f,
                "a ball is tested against a Sphere, Capsule, Plane, Cuboid, RoundedCuboid, Rectangle or Triangle, and \
                 not a {kind}"
            ),
            Self::Affine => {
                f.write_str("a ball is not tested against a shape in an affine placement: place the shape by a frame")
            }
            Self::Size(error) => {
                write!(f, "the shape grown by the ball's radius has a piece that is too large: {error}")
            }
            Self::Frame(error) => write!(f, "the shape grown by the ball's radius has a piece too far away: {error}"),
        }
    }
}

impl core::error::Error for ThickError {}
