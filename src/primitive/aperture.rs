//! Cones by their aperture.

use super::cone::checked_slope;
use super::{Cone, SizeError};
use crate::outline::Outline;
use crate::scalar::{Real, Scalar, UnitScalar, ValueError};

impl<S: Scalar> Cone<S> {
    /// The slope of a cone whose aperture, the angle at the apex between opposite generators, is this number of
    /// degrees: `tan(aperture / 2)`, for the constructors that take a slope. It is accurate to a few units of the
    /// number type; close to 180 degrees the rounding of the angle has a larger effect.
    ///
    /// # Errors
    ///
    /// [`SizeError::Slope`] if the aperture is not between 0 and 180 degrees, or so near to either that the slope is
    /// beyond the budget.
    ///
    /// ```
    /// use raylet::Cone;
    /// let right_angled = Cone::capped(Cone::slope_of_aperture(90.0_f64)?, 2.0)?;
    /// assert!((right_angled.top_radius().unwrap() - 2.0).abs() < 1e-14);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn slope_of_aperture(aperture: S) -> Result<S, SizeError> {
        // The comparison is false for NaN.
        let is_angle = aperture > S::ZERO && aperture.real() < S::Real::from_int(180);
        if !is_angle {
            return Err(SizeError::Slope(ValueError::of_size(aperture, S::BUDGET.smallest_slope)));
        }
        let (sine, cosine) = S::sine_cosine(S::unit_round(aperture.real() / S::Real::from_int(720)));
        let slope =
            if cosine > S::Unit::ZERO { S::round(S::unit_real(sine) / S::unit_real(cosine)) } else { S::INFINITY };
        let (Outline::Slope(slope) | Outline::Radii(slope, ..)) = checked_slope(slope)?;
        Ok(slope)
    }
}
