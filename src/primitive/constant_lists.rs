//! Prisms and polyhedra, which borrow lists, in constants: as the other primitives in `constant.rs`.

use super::constant::checked;
use super::polyhedron::MOST_FACES;
use super::prism::{LEAST_TURN, MOST_CORNERS};
use super::{HalfSpace, Polyhedron, Prism, SizeError};
use crate::half_space::CutBox;
use crate::polygon::Polygon;
use crate::scalar::constant::{self, each_number};
use crate::vector::Vec3;

/// The least product of the directions of two edges: `2^LEAST_TURN`.
const LEAST: f64 = 1.0 / (1 << -LEAST_TURN) as f64;

/// True if the first corners of the list, so many, are those of a convex polygon whose edges are no shorter than this:
/// as `Prism::new` decides it.
const fn is_convex(corners: &[[f64; 2]; MOST_CORNERS], count: usize, shortest: f64) -> bool {
    let (mut reversals, mut index) = (0, 0);
    let Some(mut before) = direction_to(corners, count, 0, shortest) else { return false };
    while index < count {
        index += 1;
        let Some(after) = direction_to(corners, count, if index < count { index } else { 0 }, shortest) else {
            return false;
        };
        if before[1] * after[0] - before[0] * after[1] < LEAST {
            return false;
        }
        if is_first_half(before) != is_first_half(after) {
            reversals += 1;
        }
        before = after;
    }
    reversals == 2
}

/// The direction from a corner to the next, divided by the magnitude of its larger component; `None` if the edge is too
/// short.
const fn direction_to(corners: &[[f64; 2]; MOST_CORNERS], count: usize, index: usize, least: f64) -> Option<[f64; 2]> {
    let next = if index + 1 < count { index + 1 } else { 0 };
    if index >= MOST_CORNERS || next >= MOST_CORNERS {
        return None;
    }
    let ([ax, az], [bx, bz]) = (corners[index], corners[next]);
    let (x, z) = (bx - ax, bz - az);
    let length = x.abs().max(z.abs());
    if length < least {
        return None;
    }
    Some([x / length, z / length])
}

/// True for a direction towards -z, or along +x: for one half of all directions.
const fn is_first_half([x, z]: [f64; 2]) -> bool {
    z < 0.0 || z == 0.0 && x >= 0.0
}

macro_rules! constants {
    ([$($generics:tt)*] $Number:ty, $checks:ident) => {
        impl<$($generics)*> Prism<$Number> {
            /// [`Prism::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Prism::new`].
            pub const fn const_new(corners: &'static [[$Number; 2]], height: $Number) -> Result<Self, SizeError> {
                if corners.len() < 3 || corners.len() > MOST_CORNERS {
                    return Err(SizeError::CornerCount);
                }
                let mut index = 0;
                let (mut list, most) = ([[0.0; 2]; MOST_CORNERS], <$Number as crate::scalar::Scalar>::BUDGET.size);
                while index < corners.len() && index < MOST_CORNERS {
                    let [x, z] = corners[index];
                    checked!(
                        constant::$checks::within(x, most) => SizeError::Corner,
                        constant::$checks::within(z, most) => SizeError::Corner,
                    );
                    list[index] = [constant::$checks::double(x), constant::$checks::double(z)];
                    index += 1;
                }
                let shortest = constant::$checks::double(<$Number as crate::scalar::Scalar>::BUDGET.smallest_size);
                if !is_convex(&list, corners.len(), shortest) {
                    return Err(SizeError::Corners);
                }
                checked!(constant::$checks::size(height) => SizeError::Height);
                Ok(Self { polygon: Polygon::new(corners), height })
            }
        }

        impl<$($generics)*> HalfSpace<$Number> {
            /// [`HalfSpace::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`HalfSpace::new`].
            pub const fn const_new(point: Vec3<$Number>, normal: Vec3<$Number>) -> Result<Self, SizeError> {
                let budget = <$Number as crate::scalar::Scalar>::BUDGET;
                let [x, y, z] = normal.to_array();
                checked!(
                    constant::$checks::point(point) => SizeError::Corner,
                    constant::$checks::within(x, budget.slope) => SizeError::Normal,
                    constant::$checks::within(y, budget.slope) => SizeError::Normal,
                    constant::$checks::within(z, budget.slope) => SizeError::Normal,
                );
                let (x, y) = (constant::$checks::magnitude(x), constant::$checks::magnitude(y));
                let larger = if constant::$checks::is_less(x, y) { y } else { x };
                let z = constant::$checks::magnitude(z);
                let largest = if constant::$checks::is_less(larger, z) { z } else { larger };
                checked!(constant::$checks::slope(largest) => SizeError::Normal);
                Ok(Self { point, normal })
            }
        }

        impl<$($generics)*> Polyhedron<$Number> {
            /// [`Polyhedron::within`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Polyhedron::within`].
            pub const fn const_within(
                low: Vec3<$Number>,
                high: Vec3<$Number>,
                faces: &'static [HalfSpace<$Number>],
            ) -> Result<Self, SizeError> {
                if faces.is_empty() || faces.len() > MOST_FACES {
                    return Err(SizeError::FaceCount);
                }
                checked!(
                    constant::$checks::point(low) => SizeError::Corner,
                    constant::$checks::point(high) => SizeError::Corner,
                );
                let (from, to) = (low.to_array(), high.to_array());
                checked!(
                    constant::$checks::size(constant::$checks::minus(to[0], from[0])) => SizeError::HalfExtent,
                    constant::$checks::size(constant::$checks::minus(to[1], from[1])) => SizeError::HalfExtent,
                    constant::$checks::size(constant::$checks::minus(to[2], from[2])) => SizeError::HalfExtent,
                );
                Ok(Self { solid: CutBox::new([from, to], faces) })
            }
        }
    };
}
each_number!(constants);
