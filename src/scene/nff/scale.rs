//! The units in which a scene is read.

use super::decimal::{self, Decimal, Magnitude};
use super::lexer::Lexer;
use crate::scalar::{Scalar, is_decimal, is_zero_decimal};
use core::fmt;

/// A light that is `2^12` times as far away as everything else is read as a distant light: its direction is the same
/// from every surface to `2^-12`, which changes a colour by less than a level.
const DISTANT: i8 = 12;

/// The number of units of the scene for one unit of a file: a power of two.
///
/// Fixed-point numbers have an absolute precision, so that the relative error of small objects is larger than that of
/// large ones: a sphere of radius 0.02 has an error of 0.04 percent in `I16F16`, which mirrors magnify. If all
/// coordinates of a file are within 12, nine bits of the type are unused. Read 512 times as large, the scene gives the
/// same picture with errors 512 times as small. (NFF has no other measure of length, so that the picture does not
/// depend on the units. Values that are added to the scene afterwards, such as the clarity of fog or a texture on a
/// plane, are in the scene's units.) This is block floating point: numbers that share one exponent (J. H. Wilkinson,
/// Rounding Errors in Algebraic Processes, 1963).
///
/// ```
/// use raylet::scene::nff::Scale;
/// use fixed::types::I16F16;
/// let text = "s  0.5 -2 1  0.75   l 3 4 5";
/// // The largest coordinate is 5, and 5 * 1024 the last doubling within 8192.
/// assert_eq!(Scale::fitting::<I16F16>(text).power(), 10);
/// // The accuracy of a float does not depend on the units.
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
    /// [`Budget`](crate::scalar::Budget), and those of cones and cylinders within a quarter, so that distances and
    /// heights fit too; for floats, whose accuracy does not depend on it, 1.
    ///
    /// A light more than 4096 times as far away as everything else is ignored here; read at this scale it becomes
    /// [distant](crate::Light::distant).
    ///
    /// For a malformed text it is the scale of the part that can be read.
    pub fn fitting<S: Scalar>(text: &str) -> Self {
        if S::RELATIVE {
            return Self::ONE;
        }
        let mut extent = Extent::new();
        let mut lights = Extent::new();
        each_length(text, |kind, text| match kind {
            Kind::Light => lights.take::<S>(text, 1),
            Kind::Other { spare } => extent.take::<S>(text, spare),
        });
        let Some(others) = extent.scale::<S>() else { return lights.scale::<S>().unwrap_or(Self::ONE) };
        let Some(all) = lights.scale::<S>() else { return others };
        if all >= others {
            return others;
        }
        // A light is beyond the scale of all other objects. Lights that are not too far away are fitted.
        let least = Self::power_of_two(others.power.saturating_sub(DISTANT));
        if all >= least {
            return all;
        }
        let (mut scale, mut coordinates, mut of_light, mut near) = (others, 0, others, true);
        each_length(text, |kind, text| {
            if !matches!(kind, Kind::Light) {
                return;
            }
            near &= least.fits::<S>(text, 1);
            of_light = of_light.shrunk_to_fit::<S>(text, 1);
            coordinates += 1;
            if coordinates == 3 {
                if near {
                    scale = scale.min(of_light);
                }
                (coordinates, of_light, near) = (0, others, true);
            }
        });
        scale
    }

    /// The binary logarithm of the scale.
    pub const fn power(self) -> i8 {
        self.power
    }

    /// True if a number is within the budget, and as many doublings of it.
    fn fits<S: Scalar>(self, text: &str, spare: i32) -> bool {
        decimal::parse_scaled::<S>(text, i32::from(self.power) + spare)
            .is_some_and(|value| value.magnitude() <= S::BUDGET.coordinate)
    }

    /// The largest scale, at most this one, at which the number is within the budget; [`Scale::LEAST`] if it never is.
    fn shrunk_to_fit<S: Scalar>(mut self, text: &str, spare: i32) -> Self {
        while self > Self::LEAST && !self.fits::<S>(text, spare) {
            self.power -= 1;
        }
        self
    }
}

/// The largest of some numbers, and what it is the scale of.
struct Extent<'t> {
    /// The scale of numbers that are too long to compare; [`Scale::LARGEST`] without them.
    scale: Scale,
    /// The largest of the others, for each number of doublings to spare.
    largest: [Option<(Magnitude, &'t str)>; 3],
    any: bool,
}

impl<'t> Extent<'t> {
    const fn new() -> Self {
        Self { scale: Scale::LARGEST, largest: [None; 3], any: false }
    }

    /// Includes a word that should be a number. Zeros and words that are not numbers have no influence on the scale.
    fn take<S: Scalar>(&mut self, text: &'t str, spare: usize) {
        let decimal = Decimal::parse(text);
        if let Some(decimal) = decimal.filter(|decimal| decimal.is_exact()) {
            let Some(magnitude) = decimal.magnitude() else { return };
            self.any = true;
            if let Some(largest) = self.largest.get_mut(spare)
                && largest.is_none_or(|(largest, _)| magnitude > largest)
            {
                *largest = Some((magnitude, text));
            }
        } else if is_decimal(text) && !is_zero_decimal(text) {
            self.any = true;
            self.scale = self.scale.shrunk_to_fit::<S>(text, spare as i32);
        }
    }

    /// The largest scale at which all of them fit; `None` if there are none.
    fn scale<S: Scalar>(&self) -> Option<Scale> {
        let mut scale = self.scale;
        for (spare, largest) in (0..).zip(self.largest) {
            if let Some((_, text)) = largest {
                scale = scale.shrunk_to_fit::<S>(text, spare);
            }
        }
        self.any.then_some(scale)
    }
}

/// The kind of object that a coordinate or size belongs to.
#[derive(Clone, Copy)]
enum Kind {
    Light,
    /// An object whose numbers must stay below the budget by this many powers of two.
    Other {
        spare: usize,
    },
}

/// Calls `each` with every word of a text that should be a coordinate or a size.
fn each_length<'t>(text: &'t str, mut each: impl FnMut(Kind, &'t str)) {
    let mut words = Lexer::new(text);
    while let Some(word) = words.next() {
        let point = Kind::Other { spare: 1 };
        let (groups, coordinates, others, kind) = match word.text {
            "from" | "at" => (1, 3, 0, point),
            "l" => (1, 3, 0, Kind::Light),
            "s" => (1, 4, 0, point),
            // From corner to corner of a cube it is 3.5 times half its side.
            "c" => (1, 8, 0, Kind::Other { spare: 2 }),
            "p" => (corners(&mut words), 3, 0, point),
            "pp" => (corners(&mut words), 3, 3, point),
            _ => continue,
        };
        for _ in 0..groups {
            let looked_at = words.by_ref().take(coordinates).map(|word| each(kind, word.text)).count();
            // At the end of the text there are no more corners, whatever number was announced.
            if looked_at < coordinates || words.by_ref().take(others).count() < others {
                break;
            }
        }
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
