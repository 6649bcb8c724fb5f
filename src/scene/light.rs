//! Point lights and distant lights.

use crate::scalar::{Real, Ring, Scalar};
use crate::vector::{UnitVec3, Vec3};

/// A point light without distance falloff, or a distant (directional) light.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
pub struct Light<S> {
    /// The position; for a distant light, a vector of any length that points to the light.
    pub position: Vec3<S>,
    /// Strength of red, green and blue, at least 0. A white matte surface that faces a light of strength 1 is white.
    /// The type is that of coordinates and not [`Color`](super::Color), so that a light may be stronger than 2.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written::three"))]
    pub strength: [S; 3],
    /// True for a distant light, such as the sun: it is in the same direction from all points, and every object in that
    /// direction casts a shadow.
    pub distant: bool,
}

impl<S: Scalar> Light<S> {
    /// A white point light.
    pub const fn new(position: Vec3<S>, strength: S) -> Self {
        Self { position, strength: [strength; 3], distant: false }
    }

    /// A white distant light; `direction` points to the light.
    pub fn distant(direction: UnitVec3<S>, strength: S) -> Self {
        let half = S::BUDGET.coordinate.real().scaled(-1);
        let [x, y, z] = direction.real().map(|component| S::round(component * half));
        Self { distant: true, ..Self::new(Vec3::new(x, y, z), strength) }
    }

    /// The strength of each of `count` lights if a scene file does not define it: `1 / sqrt(count)`, as in the Standard
    /// Procedural Databases. The sum grows with the number of lights, but slower, since not all lights reach the same
    /// point.
    pub fn usual_strength(count: u32) -> S {
        let count = i32::try_from(count.max(1)).unwrap_or(i32::MAX);
        S::round(S::Real::ONE / S::Real::from_int(count).sqrt())
    }
}
