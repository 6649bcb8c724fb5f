//! The obstacles that the rays of a zone may meet, by balls about each.

use super::columns::{End, Rod, each_column, enlarged};
use super::{Obstacles, Zones};
use crate::ray::Ray;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{Ball, BallInWorld, MOST, View, ends};
use crate::shape::Shaped;

/// A list of shapes, of which the first 16 are each bounded by two balls, made once: a post by those about its ends.
/// As seen from a sensor these tell which obstacles the rays of a zone may meet. For a dozen obstacles that takes the
/// least time; for many a tree does ([`Shapes`](crate::Shapes)).
///
/// ```
/// use raylet::sensor::{Bounded, RangeSensor, Reading, Zones};
/// use raylet::{Frame, Shape, Sphere, Vec3};
/// let list = [Shape::new(Sphere::new(1.0_f32)?)];
/// let bounded = Bounded::new(&list);
/// // For each place of the sensor.
/// let zones = Zones::new(Frame::at(Vec3::new(0.0, 0.0, -5.0))?, [8, 8], [45.0, 45.0])?;
/// let seen = bounded.seen_by(&zones);
/// let sensor = RangeSensor::new(0.0, 10.0)?;
/// let reading: Reading<_, 1> = sensor.read(&seen.in_zone(3, 4), zones.rays(3, 4), 0);
/// assert!(reading.returns[0].distance < 4.1);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Bounded<'a, S: Scalar, X> {
    list: &'a [X],
    ends: heapless::Vec<Option<[BallInWorld<S>; 2]>, MOST>,
}

impl<'a, S: Scalar, X: Shaped<S>> Bounded<'a, S, X> {
    /// The bounds of these shapes.
    pub fn new(list: &'a [X]) -> Self {
        Self { list, ends: list.iter().take(MOST).map(|of| ends(of.shape())).collect() }
    }

    /// As seen by the zones of a sensor, for the rays of these.
    pub fn seen_by(&self, zones: &Zones<S>) -> SeenByZones<'a, S, X> {
        let eye = zones.frame().position();
        let seen = self.ends.iter().map(|ends| {
            let [a, b] = (*ends)?;
            Some([Ball::seen(a, eye)?, Ball::seen(b, eye)?])
        });
        SeenByZones::new(self.list, seen, zones)
    }
}

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

/// Obstacles as seen by the zones of a sensor: [`Bounded::seen_by`].
#[derive(Clone, Debug)]
pub struct SeenByZones<'a, S, X> {
    list: &'a [X],
    /// The nearest first.
    seen: heapless::Vec<Seen<S>, MOST>,
    /// Columns and rows.
    counts: [u8; 2],
}

impl<'a, S: Scalar, X: Shaped<S>> SeenByZones<'a, S, X> {
    fn new(list: &'a [X], ends: impl Iterator<Item = Option<[Ball; 2]>>, zones: &Zones<S>) -> Self {
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
