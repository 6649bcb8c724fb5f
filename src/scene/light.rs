//! What shines.

use crate::scalar::{Real, Ring, Scalar};
use crate::vector::{UnitVec3, Vec3};

/// A point that shines in all directions, with the same strength at every distance; or one so far away that only its
/// direction counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light<S> {
    /// Where it stands; of a distant light, the way to it from anywhere, of any length.
    pub position: Vec3<S>,
    /// Strength of red, green and blue, at least 0; a white matte surface that faces a light of strength 1 is
    /// white. A coordinate type and not a [`Color`](super::Color), so that a lamp may be stronger than 2.
    pub strength: [S; 3],
    /// True if it is as far away as the sun: all points see it in the same direction, and whatever stands there is in its way.
    pub distant: bool,
}

impl<S: Scalar> Light<S> {
    /// A white light.
    pub const fn new(position: Vec3<S>, strength: S) -> Self {
        Self { position, strength: [strength; 3], distant: false }
    }

    /// A white light that is seen in this direction from everywhere.
    pub fn distant(direction: UnitVec3<S>, strength: S) -> Self {
        let half = S::BUDGET.coordinate.real().scaled(-1);
        let [x, y, z] = direction.real().map(|component| S::round(component * half));
        Self { distant: true, ..Self::new(Vec3::new(x, y, z), strength) }
    }

    /// The strength that `count` equal lights should have where nobody says: `1 / sqrt(count)` each, the custom of
    /// the Standard Procedural Databases. One light of 1 lights a scene well, and the sum grows slowly, since not all
    /// lights reach the same spot.
    pub fn usual_strength(count: u32) -> S {
        let count = i32::try_from(count.max(1)).unwrap_or(i32::MAX);
        S::round(S::Real::ONE / S::Real::from_int(count).sqrt())
    }
}
