//! A flat polygon of any number of corners, cut into triangles.
//!
//! A convex polygon becomes a fan about its first corner; any other loses one "ear" after the other (Meisters,
//! *Polygons have ears*, 1975). Nothing is allocated: ears are cut out of the caller's list of corners.
//!
//! The time grows with the square of the number of corners, or faster: a star of 20,000 corners takes seconds on a
//! host. For convex polygons it is proportional to the number of corners.

use crate::scalar::{Real, Ring, Scalar};
use crate::vector::{UnitVec3, Vec3, cross};

/// A corner of a polygon. The reader needs a slice of them as scratch: as many as the largest polygon has corners
/// (see [`Counts`](super::Counts)).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
pub struct Corner<S: Scalar> {
    pub(super) point: Vec3<S>,
    pub(super) normal: UnitVec3<S>,
}

impl<S: Scalar> Corner<S> {
    /// A corner at this point, with this normal.
    pub const fn new(point: Vec3<S>, normal: UnitVec3<S>) -> Self {
        Self { point, normal }
    }

    /// Where it is.
    pub const fn point(&self) -> Vec3<S> {
        self.point
    }

    /// The normal for shading.
    pub const fn normal(&self) -> UnitVec3<S> {
        self.normal
    }
}

impl<S: Scalar> Default for Corner<S> {
    fn default() -> Self {
        Self { point: Vec3::ZERO, normal: UnitVec3::Y }
    }
}

/// Calls `each` with the triangles of a polygon, whose corners are in the polygon's order. Stops at the first error,
/// and returns the number of triangles.
///
/// The corners are counterclockwise as seen from the front. The triangles cover exactly the polygon's area. Triangles
/// without area (three corners on a line) are left out, so that a polygon without area has none. The order of `corners`
/// is changed. If a polygon intersects itself, which NFF does not allow, its counterclockwise parts are covered as far
/// as ears are found.
///
/// # Errors
///
/// The first error that `each` returns.
pub fn triangulate<S: Scalar, E>(
    corners: &mut [Corner<S>],
    mut each: impl FnMut([Corner<S>; 3]) -> Result<(), E>,
) -> Result<usize, E> {
    let Some(plane) = Projection::of(corners) else { return Ok(0) };
    // A triangle needs no cutting, and is the most frequent case.
    if let [a, b, c] = &*corners {
        return each([*a, *b, *c]).map(|()| 1);
    }
    let mut count = 0;
    let mut emit = |triangle| {
        count += 1;
        each(triangle)
    };
    if is_convex(corners, plane) {
        if let [first, rest @ ..] = &*corners {
            for pair in rest.windows(2) {
                if let [b, c] = pair
                    && plane.turn(first, b, c) > S::Real::ZERO
                {
                    emit([*first, *b, *c])?;
                }
            }
        }
        return Ok(count);
    }
    let mut left = corners;
    while left.len() >= 3 {
        let (index, is_ear) = next_cut(left, plane);
        if is_ear && let Some((a, b, c)) = around(left, index) {
            emit([*a, *b, *c])?;
        }
        if let Some(tail) = left.get_mut(index..)
            && !tail.is_empty()
        {
            tail.rotate_left(1);
        }
        let shorter = left.len() - 1;
        left = left.get_mut(..shorter).unwrap_or_default();
    }
    Ok(count)
}

/// The corner at `index` with its two neighbours.
fn around<S: Scalar>(corners: &[Corner<S>], index: usize) -> Option<(&Corner<S>, &Corner<S>, &Corner<S>)> {
    let before = index.checked_sub(1).or(corners.len().checked_sub(1))?;
    let after = corners.get(index + 1).or(corners.first())?;
    Some((corners.get(before)?, corners.get(index)?, after))
}

/// The corner to cut off next, and whether a triangle goes with it.
fn next_cut<S: Scalar>(corners: &[Corner<S>], plane: Projection) -> (usize, bool) {
    // Corners on a line are cut off first: with a spike left, an ear could be cut across it.
    let is_straight = |index: &usize| around(corners, *index).is_some_and(|(a, b, c)| plane.turn(a, b, c).is_zero());
    if let Some(index) = (0..corners.len()).find(is_straight) {
        return (index, false);
    }
    // If no corner is an ear, the polygon intersects itself (at least after rounding): the first convex corner is cut
    // off.
    let mut fallback = None;
    for index in 0..corners.len() {
        let Some((a, b, c)) = around(corners, index) else { continue };
        if plane.turn(a, b, c) < S::Real::ZERO {
            continue;
        }
        let blocked = corners.iter().any(|p| {
            // Two corners may share a point, where a polygon touches itself or a slit leads to a hole.
            let is_corner = [a, b, c].iter().any(|corner| corner.point == p.point);
            !is_corner
                && plane.turn(a, b, p) >= S::Real::ZERO
                && plane.turn(b, c, p) >= S::Real::ZERO
                && plane.turn(c, a, p) >= S::Real::ZERO
        });
        if !blocked {
            return (index, true);
        }
        fallback = fallback.or(Some(index));
    }
    fallback.map_or((0, false), |index| (index, true))
}

/// True if the fan about the first corner is the polygon: every corner and every triangle turns left, or not at all.
fn is_convex<S: Scalar>(corners: &[Corner<S>], plane: Projection) -> bool {
    let all_turn_left = (0..corners.len()).all(|index| match around(corners, index) {
        Some((a, b, c)) => plane.turn(a, b, c) >= S::Real::ZERO,
        None => false,
    });
    let Some((first, rest)) = corners.split_first() else { return false };
    // A pentagram turns left at every corner, too, but winds twice.
    all_turn_left
        && rest.windows(2).all(|pair| match pair {
            [b, c] => plane.turn(first, b, c) >= S::Real::ZERO,
            _ => false,
        })
        && !turns_back(corners)
}

/// True if the polygon has a spike: an edge that runs back along the one before, which also "does not turn".
fn turns_back<S: Scalar>(corners: &[Corner<S>]) -> bool {
    (0..corners.len()).any(|index| {
        around(corners, index).is_some_and(|(a, b, c)| {
            let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a.point.real(), b.point.real(), c.point.real());
            let along = [[bx - ax, cx - bx], [by - ay, cy - by], [bz - az, cz - bz]];
            let straight = {
                let (u, v) = ([bx - ax, by - ay, bz - az], [cx - bx, cy - by, cz - bz]);
                cross(u, v).iter().all(|component| component.is_zero())
            };
            straight && S::Real::sum_of_products(along) < S::Real::ZERO
        })
    })
}

/// Twice the area, along the normal of the side from which the corners run counterclockwise. It is computed by Newell's
/// method (Tampieri, *Newell's method for computing the plane equation of a polygon*, Graphics Gems III), which allows
/// corners on a line and a reflex first corner.
fn area_vector<S: Scalar>(corners: &[Corner<S>]) -> [S::Real; 3] {
    let mut normal = [S::Real::ZERO; 3];
    let Some((first, rest)) = corners.split_first() else { return normal };
    let [ox, oy, oz] = first.point.real();
    for pair in rest.windows(2) {
        let [a, b] = pair else { continue };
        let [u, v] = [a, b].map(|corner| corner.point.real()).map(|[x, y, z]| [x - ox, y - oy, z - oz]);
        for (sum, term) in normal.iter_mut().zip(cross(u, v)) {
            *sum = *sum + term;
        }
    }
    normal
}

/// True if the corners run clockwise as seen from the side that the mean of their normals points to.
pub(super) fn contradicts_its_normals<S: Scalar>(corners: &[Corner<S>]) -> bool {
    let mut sum = [S::Real::ZERO; 3];
    for corner in corners {
        for (sum, component) in sum.iter_mut().zip(corner.normal.real()) {
            *sum = *sum + component;
        }
    }
    let [[x, y, z], [a, b, c]] = [area_vector(corners), sum];
    S::Real::sum_of_products([[x, a], [y, b], [z, c]]) < S::Real::ZERO
}

/// A flat view of the polygon: along the axis nearest to its normal, from the front.
#[derive(Clone, Copy, Debug)]
enum Projection {
    AlongX { mirrored: bool },
    AlongY { mirrored: bool },
    AlongZ { mirrored: bool },
}

impl Projection {
    /// `None` for a polygon without area.
    fn of<S: Scalar>(corners: &[Corner<S>]) -> Option<Self> {
        let normal = area_vector(corners);
        let [x, y, z] = normal;
        let [wide, high, deep] = normal.map(Real::abs);
        // Seen from behind, left and right are exchanged.
        let (projection, largest) = if wide > high && wide > deep {
            (Self::AlongX { mirrored: x.is_negative() }, x)
        } else if high > deep {
            (Self::AlongY { mirrored: y.is_negative() }, y)
        } else {
            (Self::AlongZ { mirrored: z.is_negative() }, z)
        };
        (!largest.is_zero()).then_some(projection)
    }

    /// Twice the area of the triangle in this view: positive if it turns left.
    fn turn<S: Scalar>(self, a: &Corner<S>, b: &Corner<S>, c: &Corner<S>) -> S::Real {
        let [a, b, c] = [a, b, c].map(|corner| {
            let [x, y, z] = corner.point.real();
            match self {
                Self::AlongX { .. } => [y, z],
                Self::AlongY { .. } => [z, x],
                Self::AlongZ { .. } => [x, y],
            }
        });
        let (ux, uy) = (b[0] - a[0], b[1] - a[1]);
        let (vx, vy) = (c[0] - a[0], c[1] - a[1]);
        let turn = S::Real::sum_of_products([[ux, vy], [-uy, vx]]);
        match self {
            Self::AlongX { mirrored } | Self::AlongY { mirrored } | Self::AlongZ { mirrored } if mirrored => -turn,
            _ => turn,
        }
    }
}
