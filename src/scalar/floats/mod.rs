//! The fast path of floats: nothing scaled, and nothing compensated but the moment of a line that passes
//! a cone so closely that it is mostly rounding.
//!
//! A benign ray needs neither: where nothing cancels, the textbook is right to a few units in the last place. Here stands what
//! "nothing cancels" means, a comparison for each difference; the other rays (grazing ones, starts far away or next to a
//! surface, sizes whose powers leave the type) are [`Attempt::Unsure`].
//!
//! | file | what it holds |
//! |---|---|
//! | `guards` | what is taken, and the lines |
//! | `round` | balls and cylinders |
//! | `cone` | cones |
//! | `flat` | planes, discs, triangles |

#[macro_use]
mod guards;
#[macro_use]
mod round;
#[macro_use]
mod cone;
#[macro_use]
mod flat;

macro_rules! floats {
    (
        $name:ident, $Float:ident, $bits:ty, $bias:literal, $mantissa:literal, sqrt: $sqrt:path,
        may_have_spare_bits: $spare:literal
    ) => {
        pub(super) mod $name {
            use crate::scalar::{Attempt, InNappe, LocalLine, Real, found};
            use core::cmp::Ordering;

            guards!($Float, $bits, $bias, $mantissa, sqrt: $sqrt, may_have_spare_bits: $spare);
            round!($Float, sqrt: $sqrt);
            cone!($Float, sqrt: $sqrt);
            flat!($Float);
        }
    };
}
floats!(fast_f32, f32, u32, 127, 23, sqrt: crate::scalar::square_root::square_root_f32, may_have_spare_bits: false);
floats!(fast_f64, f64, u64, 1023, 52, sqrt: libm::sqrt, may_have_spare_bits: true);
