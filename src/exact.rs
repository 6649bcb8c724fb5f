//! The tier `Exact`, and the precision that it needed.

/// The exact tier: hit, miss, touch, part, order, pairing and inside or outside are always those of exact arithmetic on
/// the stored numbers. `t` is within one unit in the last place of the exact value.
///
/// The stored numbers are those of ray, primitive and placement: the frame's position and axes, or the inverse matrix
/// of an [`Affine`](crate::Affine), as they are after construction.
///
/// It exists for `f32` and for every `FixedI32<F>`. For `f64` and the 64-bit fixed types it does not compile:
///
/// ```compile_fail
/// use raylet::{Ray, Sphere, UnitVec3, Vec3, tier::Exact};
/// let ray = Ray::new(Vec3::new(0.0_f64, 0.0, 3.0), -UnitVec3::Z).unwrap();
/// Sphere::new(1.0).unwrap().hits_at::<Exact>(&ray);
/// ```
///
/// In fixed point integers on a grid decide most rays, with guards that only certain results pass. Doubles with an
/// error bound decide nearly all other rays of fixed point and nearly all of `f32`; numbers of 128 bits with an error
/// bound decide nearly all that remain. Integers that are wide enough for every case decide the rest, at some hundred
/// times the cost. [`Shape::precision`](crate::Shape::precision) says which of them decided.
///
/// A ray that [departs](crate::Departure) is taken to start exactly on its surface, whatever its coordinates: the
/// constant term of the quadric that it leaves is set to zero, or the height of its origin above the plane that it
/// leaves. All other equations use the stored coordinates. The result is exact for these equations.
///
/// In fixed point `t` is rounded on the grid, and in doubles where a hit lies next to an end of the range or to the
/// ray's origin. The two may differ by a unit. So `t` is the same for all ranges, unless an end of one, other than
/// zero, lies within four units of a hit.
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

/// The precision that the exact tier used for a query.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Precision {
    /// Numbers with an error bound decided every sign.
    Filter,
    /// Wide integers were needed.
    Integers,
}
