//! Fog of constant density.

use super::color::Color;
use crate::scalar::{Scalar, UnitScalar};

/// Fog of one colour and constant density, everywhere outside transparent objects.
///
/// Over a distance `t` the fraction `clarity^t` of a colour is transmitted, and the fog's colour replaces the rest
/// (Beer's law). The background is infinitely far away and so has the fog's colour. Light on its way from a light
/// source to a surface is not attenuated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fog<S: Scalar> {
    color: Color<S>,
    clarity: S::Unit,
}

impl<S: Scalar> Fog<S> {
    /// Fog that transmits the fraction `clarity` of the light per unit of length. `clarity` is clamped to `[0, 1]`: at
    /// 0 nothing but fog is visible, at 1 there is no fog.
    ///
    /// ```
    /// # use raylet::{Color, scene::Fog};
    /// let haze = Fog::<f32>::new(Color::WHITE, 0.99);
    /// assert!((haze.visibility(100.0) - 0.366).abs() < 1e-3);
    /// assert_eq!(haze.visibility(0.0), 1.0);
    /// ```
    pub fn new(color: Color<S>, clarity: S::Unit) -> Self {
        // Compared in this order, a NaN becomes 0.
        let clarity = if clarity >= S::Unit::ONE {
            S::Unit::ONE
        } else if clarity > S::Unit::ZERO {
            clarity
        } else {
            S::Unit::ZERO
        };
        Self { color, clarity }
    }

    /// Its colour.
    pub const fn color(&self) -> Color<S> {
        self.color
    }

    /// The fraction of the light that is transmitted over one unit of length, in `[0, 1]`.
    pub const fn clarity(&self) -> S::Unit {
        self.clarity
    }

    /// The fraction of the light that is transmitted over the distance `t`, at least 0: `clarity^t`, in `[0, 1]`.
    pub fn visibility(&self, t: S) -> S::Unit {
        if t <= S::ZERO { S::Unit::ONE } else { S::power(self.clarity, t) }
    }

    /// True if the fog has any effect: its clarity is below 1.
    pub fn is_visible(&self) -> bool {
        self.clarity < S::Unit::ONE
    }
}
