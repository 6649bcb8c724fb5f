//! Division of surface coordinates into equal fields, for patterns and waves.

use crate::scalar::{Real, Scalar};

/// `[0, 1]` is divided into `count` equal fields: the index of the field of a coordinate, from 0, and the position in
/// it, in `[0, 1]`. A coordinate of 1 belongs to the last field. A count of 0 gives the field 0, without extent.
pub(super) fn field<S: Scalar>(coordinate: S::Unit, count: u16) -> (u16, S::Real) {
    use crate::scalar::UnitScalar;
    let place = S::unit_real(coordinate) * S::Real::from_int(i32::from(count));
    // The nearest field boundary is this one, or the next.
    let nearest = coordinate.level(count);
    let beyond = S::Real::from_int(i32::from(nearest)) > place;
    let field = if beyond { nearest.saturating_sub(1) } else { nearest };
    let field = field.min(count.saturating_sub(1));
    (field, place - S::Real::from_int(i32::from(field)))
}

#[cfg(units)]
#[path = "../../tests/units/effect/field.rs"]
mod tests;
