//! The objects that the rays of a row of pixels may meet, so that all others are not tested. A picture has the same
//! bits with them as without, but for hits that `Plain` and `Fast` may invent far away from an object.

use super::{Directions, Raster, Scene, View};
use crate::scalar::Scalar;
use crate::shape::kinds::Kinds;

/// The most objects of which columns are computed; all others may be met anywhere. A picture of more needs a
/// hierarchy.
const MOST: usize = 16;

/// A set of objects of a scene, among which all are that a ray may meet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidates {
    /// Bit `i` is object `i`.
    first: u16,
}

impl Candidates {
    /// All objects.
    pub(crate) const ALL: Self = Self { first: u16::MAX };

    /// True if the ray may meet the object of this index.
    #[inline(always)]
    pub(crate) fn contain(self, object: u32) -> bool {
        object >= MOST as u32 || self.first & (1 << object) != 0
    }
}

/// The candidates of each column of a row.
#[derive(Clone, Debug)]
pub(crate) struct CandidatesOfRow {
    /// The first column of each object, and the one after its last.
    columns: heapless::Vec<[u16; 2], MOST>,
    /// Those of the columns from the last one on that was asked for, to before this one.
    until: u16,
    these: Candidates,
}

impl CandidatesOfRow {
    /// All objects in each column.
    pub(crate) const fn all() -> Self {
        Self { columns: heapless::Vec::new(), until: u16::MAX, these: Candidates::ALL }
    }

    /// Those of row `y` of a picture with one sample a pixel.
    pub(crate) fn new<S: Scalar, T, K: Kinds>(scene: &Scene<'_, S, T, K>, raster: &Raster<S>, y: u16) -> Self {
        // A hierarchy finds them at less cost.
        let row = if scene.hierarchy.is_none() { Directions::of_row(raster, u32::from(y)) } else { None };
        let Some(row) = row else { return Self::all() };
        let (view, mut columns) = (View::of(raster), heapless::Vec::new());
        for object in scene.objects.iter().take(MOST) {
            // There is room for MOST.
            let _ = columns.push(row.columns(view.ball(&object.shape)));
        }
        Self { columns, until: 0, these: Candidates::ALL }
    }

    /// Those of a column, which is not left of the last one that was asked for.
    #[inline(always)]
    pub(crate) fn of(&mut self, column: u16) -> Candidates {
        if column >= self.until {
            self.advance(column);
        }
        self.these
    }

    #[inline(never)]
    fn advance(&mut self, column: u16) {
        (self.until, self.these) = (u16::MAX, Candidates::ALL);
        for (index, columns) in self.columns.iter().enumerate() {
            let [first, end] = *columns;
            if column < first || column >= end {
                self.these.first &= !(1 << index);
            }
            let change = if column < first { first } else { end };
            if column < change && change < self.until {
                self.until = change;
            }
        }
    }
}

#[cfg(units)]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../../tests/units/scene/candidates.rs"]
mod tests;
