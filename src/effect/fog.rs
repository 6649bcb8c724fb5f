//! Attenuation by fog: Beer's law (1852).

use crate::scalar::{Ring, Scalar};
use crate::scene::Fog;

/// The fraction of the light that is transmitted over the distance `t`; `None` is an infinite distance.
pub(super) fn visibility<S: Scalar>(fog: &Fog<S>, t: Option<S>) -> S::Real {
    // Over an infinite distance nothing is transmitted.
    t.map_or(S::Real::ZERO, |t| S::unit_real(fog.visibility(t)))
}
