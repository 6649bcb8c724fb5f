//! The obstacles that the rays of a zone may meet.
//!
//! An obstacle is in the convex hull of two balls, which is seen by the columns of zones between two planes through the
//! eye, and by the rows between two others. In the coordinates of the sensor, to the right, upwards and forwards, the
//! plane between two columns is `f x = u z`, where `u / f` is the tangent of its angle. The ball of radius `r` about
//! `(x, y, z)` is wholly to the right of it if `f x - u z > r sqrt(f^2 + u^2)`, and the hull of two balls if both are.
//!
//! Lengths have 14 bits, `u` and `f` 15, so that products and their sums have 31, and the balls are larger by as much
//! as their rounding may change.

use super::{Obstacles, Zones};
use crate::number::machine::leading_zeros;
use crate::ray::Ray;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{Ball, MOST, View, truncated};
use crate::shape::Shaped;

/// The columns or the rows that a ball may be seen by: the first, and the one after the last.
type Span = [u8; 2];

const ALL: Span = [0, u8::MAX];
const NONE: Span = [u8::MAX, 0];

/// An obstacle as seen by a sensor.
#[derive(Clone, Copy, Debug)]
struct Seen<S> {
    /// Its index.
    index: u8,
    columns: Span,
    rows: Span,
    /// No hit is nearer, but for rounding.
    nearest: S,
}

/// Obstacles as seen by the zones of a sensor: [`Bounded::seen_by`](super::Bounded::seen_by).
#[derive(Clone, Debug)]
pub struct SeenByZones<'a, S, X> {
    list: &'a [X],
    /// The nearest first.
    seen: heapless::Vec<Seen<S>, MOST>,
    /// Columns and rows.
    counts: [u8; 2],
}

impl<'a, S: Scalar, X: Shaped<S>> SeenByZones<'a, S, X> {
    pub(super) fn new(list: &'a [X], ends: impl Iterator<Item = Option<[Ball; 2]>>, zones: &Zones<S>) -> Self {
        let ([left, up, forward], [columns, rows]) = (zones.frame().axes(), zones.counts());
        let view = View::new(zones.frame().position(), [-left, up, forward]);
        let (mut seen, mut rods) = (heapless::Vec::<Seen<S>, MOST>::new(), heapless::Vec::<Rod, MOST>::new());
        for (index, ends) in ends.enumerate() {
            let index = index as u8;
            // No point of the hull is nearer to the plane across the line of sight than one of the balls.
            let (mut nearest, mut is_ahead) = (S::BUDGET.distance, false);
            let rod = ends.map(|ends| {
                let ends = ends.map(|ball| {
                    let at = view.seen(&ball);
                    let end = End { c: at.c.map(|c| c as i32), r: enlarged(at.r as i32) };
                    let depth = (end.c[2] - end.r).max(0);
                    let depth = S::round(S::Real::from_int(depth).scaled(ball.exponent()));
                    nearest = if depth < nearest { depth } else { nearest };
                    is_ahead |= end.c[2] >= -end.r;
                    end
                });
                Rod { index, ends }
            });
            // There is room for MOST of both.
            let _ = seen.push(match rod {
                Some(_) => Seen { index, columns: NONE, rows: NONE, nearest },
                None => Seen { index, columns: ALL, rows: ALL, nearest: S::ZERO },
            });
            if let Some(rod) = rod.filter(|_| is_ahead) {
                let _ = rods.push(rod);
            }
        }
        let [across, upwards] = zones.tangents();
        let with = |span: Span, column: u8| [span[0].min(column), column + 1];
        each_column::<S>(
            across,
            columns,
            &rods,
            |[x, _, _]| x,
            |index, column| {
                if let Some(seen) = seen.get_mut(usize::from(index)) {
                    seen.columns = with(seen.columns, column);
                }
            },
        );
        // Rows are counted from above.
        each_column::<S>(
            upwards,
            rows,
            &rods,
            |[_, y, _]| -y,
            |index, row| {
                if let Some(seen) = seen.get_mut(usize::from(index)) {
                    seen.rows = with(seen.rows, row);
                }
            },
        );
        sort(&mut seen);
        Self { list, seen, counts: [columns, rows] }
    }

    /// The obstacles that the rays of a zone may meet. Beside the field of view these are all.
    #[inline(always)]
    pub const fn in_zone(&self, column: u8, row: u8) -> InZone<'_, S, X> {
        let [columns, rows] = self.counts;
        InZone { seen: self, column, row, is_beside: column >= columns || row >= rows }
    }
}

/// The obstacles that the rays of a zone may meet: [`SeenByZones::in_zone`]. They are for these rays alone.
#[derive(Clone, Copy, Debug)]
pub struct InZone<'a, S, X> {
    seen: &'a SeenByZones<'a, S, X>,
    column: u8,
    row: u8,
    is_beside: bool,
}

impl<S: Scalar, X: Shaped<S>> Obstacles<S> for InZone<'_, S, X> {
    type Item = X;

    #[inline(always)]
    fn list(&self) -> &[X] {
        self.seen.list
    }
    #[inline(always)]
    fn each(&self, ray: &Ray<S>, mut test: impl FnMut(u32) -> Option<S>) {
        let mut end = ray.range().end();
        let holds = |[first, end]: Span, place: u8| first <= place && place < end;
        for seen in &self.seen.seen {
            // A distance and a `t` are rounded by less than a unit each.
            if seen.nearest > end.next_up().next_up() {
                break;
            }
            if self.is_beside || (holds(seen.columns, self.column) && holds(seen.rows, self.row)) {
                match test(seen.index.into()) {
                    Some(nearer) => end = nearer,
                    None => return,
                }
            }
        }
        for index in MOST as u32..self.seen.list.len() as u32 {
            if test(index).is_none() {
                return;
            }
        }
    }
}

/// The nearest first, by insertion: the function of the core library takes 10 KB.
fn sort<S: Scalar>(seen: &mut [Seen<S>]) {
    for sorted in 1..seen.len() {
        for place in (1..=sorted).rev() {
            let Some([a, b]) = seen.get_mut(place - 1..=place) else { break };
            if a.nearest <= b.nearest {
                break;
            }
            core::mem::swap(a, b);
        }
    }
}

/// A ball in the coordinates of a sensor.
struct End {
    c: [i32; 3],
    r: i32,
}

/// Two balls, each with the unit of its own.
struct Rod {
    /// The index of the obstacle.
    index: u8,
    ends: [End; 2],
}

/// The bits of the parts of a tangent.
const WIDE: i32 = 21;

/// A radius, and as much as rounding may matter: a centre is off by less than 7, `f` and `u` by less than 1, which
/// moves a plane by less than 4 at the centre. Directions of rays are rounded too.
const fn enlarged(r: i32) -> i32 {
    r + 13 + (r >> 10)
}

/// Calls `covers` with each obstacle and each column that it may be seen by: columns of a field of view with this
/// tangent at its edge, along a coordinate of the centre. The same for rows.
fn each_column<S: Scalar>(
    tangent: S::Real,
    count: u8,
    rods: &[Rod],
    coordinate: impl Fn([i32; 3]) -> i32,
    mut covers: impl FnMut(u8, u8),
) {
    // The tangent as a fraction whose larger part is 2^WIDE.
    let part = |share: S::Real| truncated(S::unit_parts(S::unit_round(share.scaled(-1))), WIDE + 1);
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
