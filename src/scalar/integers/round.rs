//! A line and the round side of a cylinder, without its ends.

use super::length::{Divisor, Length, Normalized, Product};
use super::{framed_bits, most_bits, radius_grid};
use crate::scalar::Attempt;

/// Where the line is inside the infinite cylinder about the y axis: `a = dx^2 + dz^2`, `D = a r^2 - w_y^2`,
/// `t = (-k -+ sqrt(D)) / a`.
///
/// The origin is in units of `2^-extra_bits` of the radius's; the answer is in the radius's. With `is_strict` only if
/// it is certain whether the line is inside.
#[inline(always)]
pub(in crate::scalar) fn cylinder<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    r: N,
    is_strict: bool,
) -> Attempt<[N; 2]> {
    let ([x, _, z], [dx, _, dz]) = (o, d);
    // As for a ball, the moment is shifted down to the radius's grid.
    let Some((grid, down)) = radius_grid(r, extra_bits).filter(|_| N::have_room([x, N::ZERO, z])) else {
        return Attempt::Unsure;
    };
    let wy = N::minor([z, x], [dz, dx]).magnitude();
    // Twice the radius or more.
    if N::reaches(wy, down) {
        return Attempt::Miss;
    }
    let wy = N::rounded_off(wy, down);
    let Some(digits) = N::Normalized::new(N::squared_length([dx, dz])) else {
        return Attempt::Unsure;
    };
    // Before it is shifted down, a r^2 has full precision.
    let positive = digits.of_square(r.up(grid as u32));
    let discriminant = N::high(positive - N::squared_length([wy]));
    // The rounding of the two terms is half a unit of the upper half, that of the moment a fourth, and what a framed
    // origin adds half a unit for each unit of its error.
    let doubt = N::from(1).up(framed_bits(extra_bits, grid) as u32);
    if discriminant < -doubt {
        return Attempt::Miss;
    }
    // With s^2 = D / (a r^2), the rounding of the moment, half a unit of the grid, changes t by at most a thirtieth of
    // a unit (near the upper limit of the radius, a fifth). The error of a framed origin, a hundredth of a unit, is up
    // to 1 / (sqrt(a) s) times as large in t: it becomes a sixth of a unit if that is 16. With each further bit of the
    // origin it may be twice that, as for a ball.
    let spare = grid - digits.shift();
    let most = most_bits::<N>(extra_bits, grid) - 1 - digits.shift();
    if spare < 4 || most < 0 {
        return Attempt::Unsure;
    }
    let least = N::high(positive).down((2 * (spare - 5)).clamp(3, 22).min(most) as u32) + N::from(1);
    if discriminant < least || (is_strict && discriminant <= doubt) {
        return Attempt::Unsure;
    }
    let divisor = digits.divisor();
    let root = N::root(positive - N::squared_length([wy])).raised(down);
    let k = N::dot([x, z], [dx, dz]);
    match (divisor.quotient(-k - root, extra_bits as u32), divisor.quotient(root - k, extra_bits as u32)) {
        (Some(low), Some(high)) => Attempt::Hit([low, high]),
        _ => Attempt::Unsure,
    }
}
