//! Attenuation by fog: Beer's law (1852).

use crate::scalar::{Scalar, UnitScalar};
use crate::scene::Fog;

/// The fraction of the light that is transmitted over the distance `t`; `None` is an infinite distance.
pub(super) fn visibility<S: Scalar>(fog: &Fog<S>, t: Option<S>) -> S::Unit {
    // Over an infinite distance nothing is transmitted.
    t.map_or(S::Unit::ZERO, |t| fog.visibility(t))
}
