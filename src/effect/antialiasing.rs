//! Adaptive supersampling where a pixel's corners differ: Whitted, *An Improved Illumination Model for Shaded Display*
//! (1980), section 4.

use super::Sample;
use crate::scalar::Scalar;
use crate::scene::Levels;

/// The largest difference of the corners' channels that is not refined: eight levels of 255, encoded by sRGB.
const THRESHOLD: u16 = 16 * 8;

/// True if the corners of a pixel differ, so that it must be refined: in object or part, in the lights that reach them,
/// or by more than eight levels in a channel.
///
/// Detail between four corners that agree is missed. Otherwise the mean of such corners differs by at most the
/// threshold from the mean of the whole grid of samples.
pub(crate) fn differ<S: Scalar>(corners: &[Sample<S>; 4]) -> bool {
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
    low.into_iter().zip(high).any(|(low, high)| Levels::Fine.of(high) - Levels::Fine.of(low) > THRESHOLD)
}

#[cfg(units)]
#[path = "../../tests/units/effect/antialiasing.rs"]
mod tests;
