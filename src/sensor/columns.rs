//! The columns of zones, or their rows, that see the bounds of an obstacle.
//!
//! An obstacle is in the convex hull of two balls, which is seen by the columns of zones between two planes through the
//! eye, and by the rows between two others. In the coordinates of the sensor, to the right, upwards and forwards, the
//! plane between two columns is `f x = u z`, where `u / f` is the tangent of its angle. The ball of radius `r` about
//! `(x, y, z)` is wholly to the right of it if `f x - u z > r sqrt(f^2 + u^2)`, and the hull of two balls if both are.
//!
//! Lengths have 14 bits, `u` and `f` 15, so that products and their sums have 31, and the balls are larger by as much
//! as their rounding may change.

use crate::number::machine::leading_zeros;
use crate::scalar::{Ring, Scalar};

/// A ball in the coordinates of a sensor.
pub(super) struct End {
    pub(super) c: [i32; 3],
    pub(super) r: i32,
}

/// Two balls, each with the unit of its own.
pub(super) struct Rod {
    /// The index of the obstacle.
    pub(super) index: u8,
    pub(super) ends: [End; 2],
}

/// The bits of the parts of a tangent.
const WIDE: i32 = 21;

/// A radius, and as much as rounding may matter: a centre is off by less than 7, `f` and `u` by less than 1, which
/// moves a plane by less than 4 at the centre. Directions of rays are rounded too.
pub(super) const fn enlarged(r: i32) -> i32 {
    r + 13 + (r >> 10)
}

/// Calls `covers` with each obstacle and each column that it may be seen by: columns of a field of view with this
/// tangent at its edge, along a coordinate of the centre. The same for rows.
pub(super) fn each_column<S: Scalar>(
    tangent: S::Real,
    count: u8,
    rods: &[Rod],
    coordinate: impl Fn([i32; 3]) -> i32,
    mut covers: impl FnMut(u8, u8),
) {
    // The tangent as a fraction whose larger part is 2^WIDE.
    let part = |share: S::Real| S::unit_parts(S::unit_round(share.scaled(-1))).truncated(WIDE + 1);
    let is_wide = tangent > S::Real::ONE;
    let (edge, far) = if is_wide { (1 << WIDE, part(S::Real::ONE / tangent)) } else { (part(tangent), 1 << WIDE) };
    // The planes of a wider field of view would be off by more.
    if far < 1 << (WIDE - 6) {
        for rod in rods {
            (0..count).for_each(|column| covers(rod.index, column));
        }
        return;
    }
    // Bit `i` is set if obstacle `i` is to the left of the last plane.
    let mut left = 0_u16;
    for plane in 0..=count {
        let u = edge * (2 * i32::from(plane) - i32::from(count)) / i32::from(count.max(1));
        // The larger part has 15 bits.
        let down = (17 - leading_zeros((u.abs() | far) as u32) as i32).max(0);
        let (u, f) = (u >> down, far >> down);
        let length = (f * f + u * u).unsigned_abs().isqrt() as i32 + 1;
        for (i, rod) in rods.iter().enumerate() {
            // Of each ball how far its centre is to the right, and its radius.
            let sides = [&rod.ends[0], &rod.ends[1]].map(|end| (f * coordinate(end.c) - u * end.c[2], end.r * length));
            if plane > 0 && left & 1 << i == 0 && !sides.iter().all(|(off, reach)| off > reach) {
                covers(rod.index, plane - 1);
            }
            let is_left = sides.iter().all(|(off, reach)| *off < -reach);
            left = left & !(1 << i) | u16::from(is_left) << i;
        }
    }
}
