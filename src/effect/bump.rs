//! Normals that lean as if the surface had waves: Blinn, *Simulation of Wrinkled Surfaces* (1978).

use super::field::field;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::Waves;
use crate::shape::Surface;
use crate::vector::{UnitVec3, pairs};

/// The normal that leans against the slopes of the waves: the direction of `N - s_u T_u - s_v T_v`, on the side of `normal`.
///
/// `normal` is the one for shading, on the viewer's side, and `from_outside` says which side that is: seen from
/// behind a hill is a valley.
pub(super) fn bent<S: Scalar>(
    waves: &Waves<S>,
    surface: &Surface<S>,
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

/// The slope of so many waves here, as a part of the steepest: 1 where a wave begins, -1 in its middle, 1 at its end, and
/// straight between. No sine is needed, and `f32` has none that does without doubles.
fn steepness<S: Scalar>(coordinate: S::Unit, count: u16) -> S::Real {
    if count == 0 {
        return S::Real::ZERO;
    }
    let (one, two) = (S::Real::ONE, S::Real::from_int(2));
    let (_, within) = field::<S>(coordinate, count);
    (within.scaled(2) - two).abs() - one
}
