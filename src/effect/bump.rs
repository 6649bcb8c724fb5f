//! Bump mapping: Blinn, *Simulation of Wrinkled Surfaces* (1978).

use super::field::field;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::Waves;
use crate::shape::Surface;
use crate::shape::kinds::Kinds;
use crate::vector::{UnitVec3, pairs};

/// The normal perturbed by the slopes of the waves: the direction of `N - s_u T_u - s_v T_v`, on the side of `normal`.
///
/// `normal` is the shading normal on the viewer's side. `from_outside` is true if that is the outside; seen from the
/// other side the slopes have the opposite sign.
pub(super) fn bent<S: Scalar>(
    waves: &Waves<S>,
    surface: &Surface<S, impl Kinds>,
    (u, v): (S::Unit, S::Unit),
    normal: UnitVec3<S>,
    from_outside: bool,
) -> UnitVec3<S> {
    let (along_u, along_v) = surface.tangents();
    let slope = if from_outside { waves.slope.real() } else { -waves.slope.real() };
    let (rise_u, rise_v) = (slope * steepness::<S>(u, waves.along_u), slope * steepness::<S>(v, waves.along_v));
    let leaning =
        pairs(pairs(along_u.real(), along_v.real()), normal.real()).map(|((u, v), n)| n - rise_u * u - rise_v * v);
    UnitVec3::from_real(leaning).unwrap_or(normal)
}

/// The slope of `count` waves at a coordinate, relative to the largest: 1 where a wave begins, -1 in its middle, 1 at
/// its end, and linear between. (A sine would need doubles in `f32` builds.)
fn steepness<S: Scalar>(coordinate: S::Unit, count: u16) -> S::Real {
    if count == 0 {
        return S::Real::ZERO;
    }
    let (one, two) = (S::Real::ONE, S::Real::from_int(2));
    let (_, within) = field::<S>(coordinate, count);
    (within.scaled(2) - two).abs() - one
}
