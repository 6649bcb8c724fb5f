//! The objects that the rays of a row of pixels may meet, so that all others are not tested. A picture has the same
//! bits with them as without, but for hits that `Plain` and `Fast` may invent far away from an object.

use super::balls::{Balls, Candidates, MOST};
use super::{Directions, Raster, View};
use crate::scalar::Scalar;

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
    /// Those of row `y` of a picture with one sample a pixel; `None` without balls, or if its rays are parallel or have
    /// no room.
    pub(crate) fn new<S: Scalar>(balls: &Balls, raster: &Raster<S>, y: u16) -> Option<Self> {
        let row = if balls.are_none() { None } else { Directions::of_row(raster, u32::from(y)) }?;
        let (view, all, mut columns) = (View::of(raster), [0, raster.size().width], heapless::Vec::new());
        for ball in balls.iter() {
            // There is room for MOST.
            let of_ball = |ball| row.columns(&view.seen(ball), all);
            let _ = columns.push(ball.as_ref().map_or(all, of_ball));
        }
        Some(Self { columns, until: 0, these: Candidates::ALL })
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
                self.these.remove(index);
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
