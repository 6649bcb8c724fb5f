//! The grid of fixed point: integers of a common unit, without exponents.
//!
//! For most rays all lengths can be scaled to a common unit (the *grid*) so that they fit in the type's own width and
//! their products in twice that, with a rounding error far below one unit of the type. Other rays are
//! [`Attempt::Unsure`](crate::scalar::Attempt), and the robust number decides: grazing rays, sizes near the budget, and
//! directions along an axis.
//!
//! Each formula is written once, over a [`Length`]: an integer of 32 bits (`bits32`) or of 64 (`bits64`), which knows
//! how its products are made. In comments `BITS` is that width.
//!
//! All rounding is symmetric, so that a mirrored line has mirrored ends. Multiplications are those of [`product`],
//! which is inlined on chips without a 64-bit product. Shifts of a product by a variable count are done in halves,
//! because compilers for these chips would call a function.
//!
//! In comments, a number "in units of `2^-extra_bits`" has `extra_bits` extra bits below the unit of the type, and the
//! origin of a line is "framed" if it has been transformed to a frame.
#![cfg_attr(not(feature = "fixed"), allow(dead_code, unused_imports, reason = "only fixed point has a grid"))]

mod axis;
mod ball;
mod bits32;
mod bits64;
mod cone;
mod cuboid;
mod departing;
mod direction;
mod flat;
mod half_space;
pub(super) mod length;
mod lines;
mod revolved;
mod roots;
mod round;
mod torus;
mod triangle;
mod turned;

pub(super) use axis::{passes, passes_wide};
pub(super) use direction::direction;
pub(crate) use lines::are_doubtful;

use crate::number::machine::leading_zeros;
pub(super) use crate::number::machine::product;
use length::Length;

/// A grid of `2^-grid` units on which the radius has `BITS - 3` bits, and the number of bits by which a moment in units
/// of `2^-(FRACTION + extra_bits)` is finer; `None` if there is no such grid.
#[inline(always)]
fn radius_grid<N: Length>(r: N, extra_bits: i32) -> Option<(i32, u32)> {
    let grid = N::zeros([r]) as i32 - 3;
    let down = N::FRACTION as i32 + extra_bits - grid;
    (grid >= 0 && 3 <= down && down < N::BITS as i32).then_some((grid, down as u32))
}

/// The largest number of bits by which the square of a root may be smaller than that of the radius, on a grid of
/// `2^-grid` units, on which the radius has `BITS - 3` bits: the error of a framed origin, a hundredth of a unit,
/// becomes a sixth of a unit if the root is a sixteenth of the radius. With each further bit of the origin, limited to
/// those that a radius has too, the root may be half as large.
#[inline(always)]
fn most_bits<N: Length>(extra_bits: i32, grid: i32) -> i32 {
    if extra_bits == 0 { 64 } else { 8 + 2 * (extra_bits - N::FINER).min(grid - 5).max(0) }
}

/// The number of bits by which the error of a length on a grid of `2^-grid` units exceeds that unit, if it comes from a
/// framed origin. The error of each coordinate of the origin is less than 2 of its own units: from its rounding, from
/// that of the point to which it was moved, and from that of the direction.
#[inline(always)]
fn framed_bits(extra_bits: i32, grid: i32) -> i32 {
    if extra_bits == 0 { 0 } else { 1 + (grid - extra_bits).max(0) }
}

/// `n * 2^-shift` rounded to nearest, ties to even, so that a line in the opposite direction has the negated ends.
#[inline(always)]
pub(super) const fn round_off(n: i64, shift: u32) -> i64 {
    let odd = (n >> shift) & 1;
    (n + ((1 << (shift - 1)) - 1) + odd) >> shift
}

#[cfg(units)]
#[path = "../../../tests/units/scalar/integers/mod.rs"]
mod tests;
