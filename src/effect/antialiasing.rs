//! More rays where a pixel's corners differ: Whitted, *An Improved Illumination Model for Shaded Display* (1980), section 4.

use super::Sight;
use crate::scalar::{Real, Scalar, UnitScalar};

/// How far apart the corners' channels may be, as a power of two: 1/32, eight levels of 255.
const THRESHOLD: i32 = -5;

/// True if a pixel whose corners see this needs a closer look: another object or part, other lights, or a channel,
/// brought into `[0, 1]`, that differs by more than 1/32.
///
/// What lies between four corners that agree is missed. The mean of such corners is off by at most the threshold from what
/// the whole grid of samples would give, as long as nothing lies between them.
pub(crate) fn differ<S: Scalar>(corners: &[Sight<S>; 4]) -> bool {
    let threshold = S::unit_round(S::Real::ONE.times_power_of_two(THRESHOLD));
    let [first, others @ ..] = corners;
    let (mut low, mut high) = (first.color.clamped().to_array(), first.color.clamped().to_array());
    for other in others {
        if other.seen != first.seen || other.lit_by != first.lit_by {
            return true;
        }
        for ((low, high), channel) in low.iter_mut().zip(&mut high).zip(other.color.clamped().to_array()) {
            if channel < *low {
                *low = channel;
            }
            if channel > *high {
                *high = channel;
            }
        }
    }
    low.into_iter().zip(high).any(|(low, high)| high.minus(low) > threshold)
}
