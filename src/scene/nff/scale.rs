//! In which units a scene is read.

use super::lexer::Lexer;
use crate::scalar::{Scalar, is_decimal, is_zero_decimal};
use core::fmt;

/// How many units of the scene one unit of a file is: a power of two.
///
/// Fixed-point numbers have steps of one size, so that small objects are known worse than large ones: a sphere of radius 0.02 in
/// `I16F16` only to 0.04 percent, which each mirror in which it is seen magnifies. A file that keeps its coordinates within
/// 12 leaves nine bits of the type unused; read 512 times as large, its picture is the same, and its spheres are known 512 times
/// better. (NFF has no other measure of length, so that the picture does not change with the units; what is added to the scene
/// afterwards, such as the clarity of fog or a texture on a plane, counts in the scene's units.) This is block floating
/// point: numbers that share one exponent (J. H. Wilkinson, Rounding Errors in Algebraic Processes, 1963).
///
/// ```
/// use raylet::scene::nff::Scale;
/// use fixed::types::I16F16;
/// let text = "s  0.5 -2 1  0.75   l 3 4 5";
/// // The largest coordinate is 5, and 5 * 1024 the last doubling within 8192.
/// assert_eq!(Scale::fitting::<I16F16>(text).power(), 10);
/// // A float is as accurate in any units.
/// assert_eq!(Scale::fitting::<f32>(text), Scale::ONE);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scale {
    power: i8,
}

impl Scale {
    /// The units of the file.
    pub const ONE: Self = Self { power: 0 };

    /// The smallest scale: a unit of the scene is 65536 of the file.
    pub const LEAST: Self = Self { power: -16 };

    /// The largest scale: a unit of the file is 2^32 of the scene.
    pub const LARGEST: Self = Self { power: 32 };

    /// A scale of `2^power`, of at least [`Scale::LEAST`] and at most [`Scale::LARGEST`].
    pub const fn power_of_two(power: i8) -> Self {
        if power < Self::LEAST.power {
            Self::LEAST
        } else if power > Self::LARGEST.power {
            Self::LARGEST
        } else {
            Self { power }
        }
    }

    /// The largest scale that leaves every coordinate and size of a text within half of the number type's
    /// [`Budget`](crate::scalar::Budget), and those of cones and cylinders within a quarter, so that distances and heights fit
    /// too; for floats, whose accuracy does not depend on it, 1.
    ///
    /// Of a malformed text, the scale of what can be read.
    pub fn fitting<S: Scalar>(text: &str) -> Self {
        if S::RELATIVE {
            return Self::ONE;
        }
        let (mut scale, mut any) = (Self::LARGEST, false);
        let mut look = |text: &str, spare: i32| {
            if !is_decimal(text) || is_zero_decimal(text) {
                return;
            }
            any = true;
            while !scale.fits::<S>(text, spare) && scale > Self::LEAST {
                scale.power -= 1;
            }
        };
        let mut words = Lexer::new(text);
        while let Some(word) = words.next() {
            let (groups, coordinates, others, spare) = match word.text {
                "from" | "at" | "l" => (1, 3, 0, 1),
                "s" => (1, 4, 0, 1),
                // From corner to corner of a cube it is 3.5 times half its side.
                "c" => (1, 8, 0, 2),
                "p" => (corners(&mut words), 3, 0, 1),
                "pp" => (corners(&mut words), 3, 3, 1),
                _ => continue,
            };
            for _ in 0..groups {
                let looked_at = words.by_ref().take(coordinates).map(|word| look(word.text, spare)).count();
                // A text that ends has no more, whatever the number of corners that it announced.
                if looked_at < coordinates || words.by_ref().take(others).count() < others {
                    break;
                }
            }
        }
        if any { scale } else { Self::ONE }
    }

    /// The binary logarithm of the scale.
    pub const fn power(self) -> i8 {
        self.power
    }

    /// True if a number is within the budget, and as many doublings of it.
    fn fits<S: Scalar>(self, text: &str, spare: i32) -> bool {
        S::parse_scaled(text, i32::from(self.power) + spare)
            .is_some_and(|value| value.magnitude() <= S::BUDGET.coordinate)
    }
}

/// The number of corners that follows; 0 if none does.
fn corners(words: &mut Lexer<'_>) -> u32 {
    words.next().and_then(|word| word.text.parse().ok()).unwrap_or(0)
}

impl Default for Scale {
    fn default() -> Self {
        Self::ONE
    }
}

impl fmt::Display for Scale {
    /// As a multiplier: `512`, or `1/4`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of_two = 1_u64 << self.power.unsigned_abs().min(63);
        if self.power < 0 { write!(f, "1/{of_two}") } else { write!(f, "{of_two}") }
    }
}
