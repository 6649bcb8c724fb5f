//! What fills the space between things.

use super::color::Color;
use crate::scalar::{Scalar, UnitScalar};

/// A haze of one colour, the same everywhere outside of transparent objects.
///
/// Over a distance `t` the part `clarity^t` of a colour comes through, and the fog's own colour takes the place of the
/// rest (Beer's law). What is infinitely far, the background, has the fog's colour altogether. Light on its way from
/// a lamp to a surface is not weakened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fog<S: Scalar> {
    color: Color<S>,
    clarity: S::Unit,
}

impl<S: Scalar> Fog<S> {
    /// Fog of which each unit of length lets this part of the light through. A `clarity` outside of `[0, 1]` is brought
    /// into it: at 0 nothing beyond the eye is seen, at 1 there is no fog.
    ///
    /// ```
    /// # use raylet::{Color, scene::Fog};
    /// let haze = Fog::<f32>::new(Color::WHITE, 0.99);
    /// assert!((haze.visibility(100.0) - 0.366).abs() < 1e-3);
    /// assert_eq!(haze.visibility(0.0), 1.0);
    /// ```
    pub fn new(color: Color<S>, clarity: S::Unit) -> Self {
        // Not a comparison's negation: a NaN is no clarity.
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

    /// The part of the light that one unit of length lets through, in `[0, 1]`.
    pub const fn clarity(&self) -> S::Unit {
        self.clarity
    }

    /// The part of the light that the distance `t`, at least 0, lets through: `clarity^t`, in `[0, 1]`.
    pub fn visibility(&self, t: S) -> S::Unit {
        if t <= S::ZERO { S::Unit::ONE } else { S::power(self.clarity, t) }
    }

    /// True if there is anything to see of it.
    pub fn is_visible(&self) -> bool {
        self.clarity < S::Unit::ONE
    }
}
