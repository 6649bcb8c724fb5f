//! Texture lookup.

use super::field::field;
use crate::scalar::{Real, Scalar};
use crate::scene::{Color, Coordinate, Texture};
use crate::vector::pairs;

/// The texture's colour at these surface coordinates, or at the solid coordinates `uvw`.
pub(super) fn color<S: Scalar>(
    texture: &Texture<'_, S>,
    (u, v): (S::Unit, S::Unit),
    uvw: impl FnOnce() -> [S::Unit; 3],
) -> Color<S> {
    let [even, odd] = match texture {
        Texture::Checker { colors, .. } | Texture::Stripes { colors, .. } | Texture::Cells { colors, .. } => *colors,
        Texture::Image { .. } => [Color::BLACK; 2],
    };
    let is_odd = match *texture {
        Texture::Checker { columns, rows, .. } => (field::<S>(u, columns).0 ^ field::<S>(v, rows).0) & 1 != 0,
        Texture::Stripes { along: Coordinate::U, count, .. } => field::<S>(u, count).0 & 1 != 0,
        Texture::Stripes { along: Coordinate::V, count, .. } => field::<S>(v, count).0 & 1 != 0,
        Texture::Cells { counts, .. } => {
            let parity = |cells, (coordinate, count)| cells ^ field::<S>(coordinate, count).0;
            pairs(uvw(), counts).into_iter().fold(0, parity) & 1 != 0
        }
        Texture::Image { width, height, pixels } => {
            let (column, row) = (field::<S>(u, width).0, field::<S>(v, height).0);
            // The first row is the upper one, where v is 1.
            let row = height.saturating_sub(1).saturating_sub(row);
            let index = u32::from(row) * u32::from(width) + u32::from(column);
            let levels = pixels.get(index as usize).copied().unwrap_or_default();
            let brightest = S::Real::from_int(255);
            return levels.map(|level| S::unit_round(S::Real::from_int(i32::from(level)) / brightest)).into();
        }
    };
    if is_odd { odd } else { even }
}
