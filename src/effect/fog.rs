//! How much of a colour the air lets through: Beer's law (1852).

use crate::scalar::{Ring, Scalar};
use crate::scene::Fog;

/// Over the distance `t` (`None`: without end), the part of a colour that comes through.
pub(super) fn visibility<S: Scalar>(fog: &Fog<S>, t: Option<S>) -> S::Real {
    // What is infinitely far is seen through infinitely much of it.
    t.map_or(S::Real::ZERO, |t| S::unit_real(fog.visibility(t)))
}
