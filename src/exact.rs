//! The tier `Exact`: its number types, and the numbers that decide for each.

#[cfg(feature = "fixed")]
use crate::number::FIXED_LIMBS;
use crate::number::{Bounded, FLOAT_LIMBS, Filtered, Integer, Number};
use crate::scalar::{FromScalar, Scalar, ToScalar};

/// The tier that is never wrong: hit, miss, touch, part, order, pairing and inside or outside are those of exact
/// arithmetic on the given numbers, always; `t` is within one unit in the last place of the exact value.
///
/// The given numbers are those that ray, primitive and placement *store*. A placed solid is one whose frame or
/// affine inverse is taken at its word, to the last bit.
///
/// Exists for `f32` and for every `FixedI32<F>`. For `f64` and the 64-bit fixed types it does not compile rather than
/// promise less:
///
/// ```compile_fail
/// use raylet::{Ray, Sphere, UnitVec3, Vec3, tier::Exact};
/// let ray = Ray::new(Vec3::new(0.0_f64, 0.0, 3.0), -UnitVec3::Z).unwrap();
/// Sphere::new(1.0).unwrap().hits_at::<Exact>(&ray);
/// ```
///
/// Doubles with an error bound decide nearly always, and 128 bits with an error bound what these cannot tell; what is left is decided by
/// integers that are wide enough for everything, at some hundred times the cost. [`Shape::effort`](crate::Shape::effort) tells which it was.
///
/// A ray that [departs](crate::Departure) starts on its surface by decree and not by its coordinates: of the quadric that it leaves the
/// constant term is zero, of the plane that it leaves the height, and all other equations keep the stored coordinates. What it meets is
/// exact for these polynomials.
///
/// ```
/// use raylet::{Crossing, Ray, Sphere, UnitVec3, Vec3, tier::Exact};
/// // One part in ten million inside the sphere's silhouette.
/// let ray = Ray::new(Vec3::new(-2.0_f32, 0.99999994, 0.0), UnitVec3::X)?;
/// let hits = Sphere::new(1.0)?.hits_at::<Exact>(&ray);
/// assert_eq!((hits[0].t, hits[1].t), (1.9996548, 2.0003452));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Exact;

/// Which numbers an exact answer took.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Effort {
    /// Those with an error bound.
    Filter,
    /// Wide integers too.
    Integers,
}

/// A scalar that has an exact tier.
pub trait Certain: Scalar {
    /// The first number, which decides nearly always.
    type Filter: FromScalar<Self> + Number<Estimate: ToScalar<Self> + FromScalar<Self>>;
    /// The number that decides where [`Certain::Filter`] cannot tell.
    type Bounded: FromScalar<Self> + ToScalar<Self>;
    /// The integer that decides when [`Certain::Bounded`] cannot tell: wide enough for every polynomial of the solvers.
    type Integer: FromScalar<Self> + Number<Estimate = Self::Bounded>;
}

#[cfg(feature = "libm")]
impl Certain for f32 {
    type Filter = Filtered;
    type Bounded = Bounded<u128>;
    type Integer = Integer<FLOAT_LIMBS>;
}

#[cfg(feature = "fixed")]
impl<F: fixed::types::extra::LeEqU32 + Send + Sync + 'static> Certain for fixed::FixedI32<F> {
    type Filter = Filtered;
    type Bounded = Bounded<u128>;
    type Integer = Integer<FIXED_LIMBS>;
}
