//! The grid of fixed point: integers of a common unit, without exponents.
//!
//! For most rays all lengths can be scaled to a common unit (the *grid*) so that they fit in 32 bits and their products
//! in 64 bits, with a rounding error far below one unit of the type. Other rays are [`Attempt::Unsure`], and the robust
//! number decides: grazing rays, sizes near the budget, and directions along an axis.
//!
//! All rounding is symmetric, so that a mirrored line has mirrored ends. Multiplications are those of [`product`],
//! which is inlined on chips without a 64-bit product. Shifts of 64 bits by a variable count are done in two halves,
//! because compilers for these chips would call a function.
//!
//! In comments, a number "in units of `2^-extra_bits`" has `extra_bits` extra bits below the unit of the type, and the
//! origin of a line is "framed" if it has been transformed to a frame.

mod axis;
mod ball;
mod cone;
mod cuboid;
mod departing;
mod direction;
mod flat;
mod nappes;
mod path;
mod quotient;
mod round;
mod stretched;
mod triangle;
mod turned;
pub(super) mod wide;

pub(super) use axis::{passes, passes_wide};
pub(super) use ball::{ByApproach, ByMoment};
pub(super) use cone::{double_cone, exit_from_nappe, nappe};
pub(super) use cuboid::{cuboid, exit_from_cuboid};
pub(super) use departing::exit_from_round;
pub(super) use direction::direction;
pub(super) use flat::{crossings, disc, height, lowered, rectangle};
pub(super) use round::tube;
pub(super) use stretched::{along_ray, stretched};
pub(super) use triangle::triangle;
pub(super) use turned::{FINER, coarser, fitting, turned};

pub(super) use crate::number::machine::product;
use crate::number::machine::{
    high_product, high_product_signed, leading_zeros, leading_zeros_of_64, product_unsigned, reciprocal_of_normalized,
    reciprocal_root, root_of_normalized, square,
};

/// The number of bits by which an origin with `extra_bits` extra bits exceeds [`FINER`], limited to those that a radius
/// has too: on a grid of `2^-grid` units it has 29 bits.
#[inline(always)]
fn more_bits(extra_bits: i32, grid: i32) -> i32 {
    (extra_bits - FINER).min(grid - 5).max(0)
}

/// The number of bits by which the error of a length on a grid of `2^-grid` units exceeds that unit, if it comes from a
/// framed origin. The error of each coordinate of the origin is less than 2 of its own units: from its rounding, from
/// that of the point to which it was moved, and from that of the direction.
#[inline(always)]
fn framed_bits(extra_bits: i32, grid: i32) -> i32 {
    if extra_bits == 0 { 0 } else { 1 + (grid - extra_bits).max(0) }
}

/// The square root of a number of at least 2^32 and below 2^62, to within one.
#[inline(always)]
fn root(n: u64) -> u32 {
    let (high, low) = ((n >> 32) as u32, n as u32);
    // An even shift: 2, and up to 28 further bits.
    let more = leading_zeros(high).wrapping_sub(2) & 0x1e;
    let root = root_of_normalized((high << more << 2) | (low >> (30 - more)), low << more << 2);
    ((root >> (more / 2)) + 1) >> 1
}

/// The high word.
#[inline(always)]
const fn high(n: i64) -> i32 {
    (n >> 32) as i32
}

/// `n * 2^-shift` rounded to nearest, ties to even, so that a line in the opposite direction has the negated ends.
#[inline(always)]
pub(super) const fn round_off(n: i64, shift: u32) -> i64 {
    let odd = (n >> shift) & 1;
    (n + ((1 << (shift - 1)) - 1) + odd) >> shift
}

/// Half of a number, rounded to nearest.
#[inline(always)]
const fn half(n: u32) -> i32 {
    ((n >> 1) + (n & 1)) as i32
}

/// The bits of a number's magnitude, or, for a negative number, those of the magnitude less one.
#[inline(always)]
const fn magnitude_bits(n: i32) -> u32 {
    (n ^ (n >> 31)) as u32
}

#[cfg(test)]
mod tests;
