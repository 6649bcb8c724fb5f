//! What a line meets on the grid of fixed point: from stored numbers to raw integers and back. The results are
//! [`Attempt::Unsure`] where rounding may decide.

use super::length::{Length, Stretch};
use super::{ball, cone, cuboid, departing, flat, round, triangle, turned};
use crate::outline::Outline;
use crate::scalar::{Attempt, FinerLine, GridScalar, InCuboid, InSide, LocalLine, found};
use core::cmp::Ordering;

/// The error of an end is at most a unit, that of the height there less than two: rounding may decide the order of two
/// that are less than 2 to the power of this apart.
const DOUBTFUL_BITS: u32 = 2;

/// The raw integers of a point or of an outline.
#[inline(always)]
fn raw<S: GridScalar, const M: usize>(numbers: [S; M]) -> [S::Raw; M] {
    numbers.map(S::to_raw)
}

/// Whether rounding may decide the order of two ends.
#[inline(always)]
pub(crate) fn are_doubtful<S: GridScalar>(a: S, b: S) -> bool {
    a.to_raw().are_within(b.to_raw(), DOUBTFUL_BITS)
}

impl<S: GridScalar> LocalLine<S> {
    #[inline(always)]
    fn o(&self) -> [S::Raw; 3] {
        raw(self.origin)
    }
    #[inline(always)]
    fn d(&self) -> [S::Raw; 3] {
        self.direction.map(S::unit_to_raw)
    }

    /// The two ends of the line inside the sphere of radius `r` about the origin: from the point of closest approach,
    /// or, if `by_moment`, from the Pluecker moment. `is_strict` is that of the line, passed as a constant of the tier
    /// so that it costs the other tiers nothing.
    #[inline(always)]
    pub(crate) fn ball(&self, r: S, by_moment: bool, is_strict: bool) -> Attempt<[S; 2]> {
        let (o, d, r) = (self.o(), self.d(), r.to_raw());
        let ends = found!(if by_moment {
            found!(ball::ByMoment::new(o, self.extra_bits, d, r)).ends(is_strict)
        } else {
            found!(ball::ByApproach::new(o, self.extra_bits, d, r)).ends()
        });
        Attempt::Hit(ends.map(S::from_raw))
    }

    /// Whether one of these ends is at `t >= 0`; unsure if an end is beyond the number type.
    #[inline(always)]
    pub(crate) fn ball_ahead(&self, r: S, by_moment: bool) -> Attempt<()> {
        let (o, d, r) = (self.o(), self.d(), r.to_raw());
        if by_moment {
            found!(ball::ByMoment::new(o, self.extra_bits, d, r)).meets_ahead()
        } else {
            found!(ball::ByApproach::new(o, self.extra_bits, d, r)).meets_ahead()
        }
    }

    /// The interval of the line inside the infinite cylinder of radius `r` about the y axis.
    #[inline(always)]
    pub(crate) fn tube(&self, r: S) -> Attempt<InSide<S>> {
        let ends = found!(round::tube(self.o(), self.extra_bits, self.d(), r.to_raw(), self.is_strict));
        Attempt::Hit(InSide { ends: ends.map(S::from_raw), beyond: [S::ZERO; 2] })
    }

    /// The raw integers of a nappe: its radius at `y = 0`, and by how much it grows over its height.
    #[inline(always)]
    fn outline(outline: Outline<S>) -> Option<[S::Raw; 3]> {
        let (base, top, height) = match outline {
            Outline::Slope(slope) => (S::ZERO, slope, S::one()?),
            Outline::Radii(base, top, height) => (base, top, height.to_raw()),
        };
        if height <= S::Raw::ZERO {
            return None;
        }
        Some([base.to_raw(), top.minus(base).to_raw(), height])
    }

    /// The interval of the line inside the nappe.
    #[inline(always)]
    pub(crate) fn nappe(&self, outline: Outline<S>) -> Attempt<InSide<S>> {
        let Some(outline) = Self::outline(outline) else { return Attempt::Unsure };
        let InSide { ends, beyond } = found!(cone::nappe(self.o(), self.extra_bits, self.d(), outline, self.is_strict));
        Attempt::Hit(InSide { ends: ends.map(S::from_raw), beyond: beyond.map(S::from_raw) })
    }

    /// Where the line is inside a double cone of this slope: between the two ends, or, if `true`, outside them.
    #[inline(always)]
    pub(crate) fn double_cone(&self, slope: S) -> Attempt<([S; 2], bool)> {
        let Some(one) = S::one() else { return Attempt::Unsure };
        let outline = [slope.to_raw(), one];
        let (ends, beyond) = found!(cone::double_cone(self.o(), self.extra_bits, self.d(), outline, self.is_strict));
        Attempt::Hit((ends.map(S::from_raw), beyond))
    }

    /// The exit of a line that starts on a sphere about the origin, or on a cylinder about the y axis, and leads
    /// inwards.
    #[inline(always)]
    pub(crate) fn exit_from_round(&self, is_ball: bool) -> Attempt<S> {
        found!(self.starts_at_origin());
        Attempt::Hit(S::from_raw(found!(departing::exit_from_round(self.o(), self.extra_bits, self.d(), is_ball))))
    }

    /// The exit of a line that starts on the side of the nappe and leads inwards; infinite if there is none.
    #[inline(always)]
    pub(crate) fn exit_from_nappe(&self, outline: Outline<S>) -> Attempt<S> {
        found!(self.starts_at_origin());
        let Some(outline) = Self::outline(outline) else { return Attempt::Unsure };
        let exit = found!(cone::exit_from_nappe(self.o(), self.extra_bits, self.d(), outline, self.is_strict));
        Attempt::Hit(S::from_raw(exit))
    }

    /// Where a line that starts on the surface of a cuboid with these half extents leaves it, and the axis
    /// perpendicular to the face by which it leaves.
    #[inline(always)]
    pub(crate) fn exit_from_cuboid(&self, half: [S; 3]) -> Attempt<(S, usize)> {
        found!(self.starts_at_origin());
        let (t, axis) = found!(cuboid::exit_from_cuboid(self.o(), self.extra_bits, self.d(), raw(half)));
        Attempt::Hit((S::from_raw(t), axis))
    }

    /// A departing line must not have been moved.
    #[inline(always)]
    fn starts_at_origin(&self) -> Attempt<()> {
        if self.start == S::ZERO { Attempt::Hit(()) } else { Attempt::Unsure }
    }

    /// Whether the line's point at `t` lies below `y = 0` (`Less`), between that and the height (`Equal`), or above
    /// (`Greater`).
    #[inline(always)]
    pub(crate) fn seams(&self, t: S, height: S) -> Attempt<Ordering> {
        let (oy, dy) = (self.origin[1].to_raw(), S::unit_to_raw(self.direction[1]));
        let y = found!(flat::height(oy, self.extra_bits, dy, t.to_raw()));
        let (low, high) = (S::Raw::ZERO, height.to_raw());
        if self.is_strict && (y.are_within(low, DOUBTFUL_BITS) || y.are_within(high, DOUBTFUL_BITS)) {
            return Attempt::Unsure;
        }
        Attempt::Hit(if y < low {
            Ordering::Less
        } else if y > high {
            Ordering::Greater
        } else {
            Ordering::Equal
        })
    }

    /// Whether two ends are so close that their order may be decided by rounding. Only a strict line has this guard:
    /// otherwise two ends within a unit of each other may be in either order.
    #[inline(always)]
    pub(crate) fn are_close(&self, a: S, b: S) -> bool {
        self.is_strict && are_doubtful(a, b)
    }

    /// The line relative to the point `(0, y, 0)`.
    #[inline(always)]
    pub(crate) fn lowered(&self, y: S) -> Attempt<Self> {
        let [ox, oy, oz] = self.origin;
        match y.to_raw().relative_to(oy.to_raw(), self.extra_bits) {
            Some(above) => Attempt::Hit(Self { origin: [ox, S::from_raw(-above), oz], ..*self }),
            None => Attempt::Unsure,
        }
    }

    /// Where the line crosses a height. A line of constant height crosses none.
    #[inline(always)]
    pub(crate) fn crossing(&self, y: S) -> Attempt<S> {
        let (oy, dy) = (self.origin[1].to_raw(), S::unit_to_raw(self.direction[1]));
        Attempt::Hit(S::from_raw(found!(flat::crossing(oy, self.extra_bits, dy, y.to_raw()))))
    }

    /// Where the line crosses two heights. A line of constant height crosses neither.
    #[inline(always)]
    pub(crate) fn crossings(&self, y: [S; 2]) -> Attempt<[S; 2]> {
        let (oy, dy) = (self.origin[1].to_raw(), S::unit_to_raw(self.direction[1]));
        Attempt::Hit(found!(flat::crossings(oy, self.extra_bits, dy, raw(y))).map(S::from_raw))
    }

    /// Where the line crosses the disc of radius `r` about the origin in the plane `y = 0`.
    #[inline(always)]
    pub(crate) fn disc(&self, r: S) -> Attempt<S> {
        Attempt::Hit(S::from_raw(found!(flat::disc(self.o(), self.extra_bits, self.d(), r.to_raw()))))
    }

    /// Where the line crosses the rectangle about the origin in the plane `y = 0`, with these half extents along x and
    /// z.
    #[inline(always)]
    pub(crate) fn rectangle(&self, half: [S; 2]) -> Attempt<S> {
        Attempt::Hit(S::from_raw(found!(flat::rectangle(self.o(), self.extra_bits, self.d(), raw(half)))))
    }

    /// The interval of the line inside the cuboid about the origin with these half extents along x, y and z. Unsure if
    /// an end is next to an edge.
    #[inline(always)]
    pub(crate) fn cuboid(&self, half: [S; 3]) -> Attempt<InCuboid<S>> {
        let since = self.since.map(S::to_raw);
        let InCuboid { ends, axes } = found!(cuboid::cuboid(self.o(), self.extra_bits, self.d(), raw(half), since));
        Attempt::Hit(InCuboid { ends: ends.map(S::from_raw), axes })
    }

    /// Where the line crosses the triangle with these vertices, and whether it comes from the side from which they are
    /// counter-clockwise.
    #[inline(always)]
    pub(crate) fn triangle(&self, vertices: [[S; 3]; 3]) -> Attempt<(S, bool)> {
        let (o, d, vertices) = (self.o(), self.d(), vertices.map(raw));
        let finer = S::Raw::FINER;
        let found = match triangle::triangle(o, self.extra_bits, d, vertices) {
            // There may be too little room for the origin beside the vertices.
            Attempt::Unsure if self.extra_bits > finer => {
                triangle::triangle(S::Raw::coarser(o, (self.extra_bits - finer) as u32), finer, d, vertices)
            }
            found => found,
        };
        let (t, from_front) = found!(found);
        Attempt::Hit((S::from_raw(t), from_front))
    }

    /// The line from `o` along `d` in the frame with these axes at `position`; `None` if it is too far away.
    #[inline(always)]
    pub(crate) fn turned(o: [S; 3], d: [S::Unit; 3], position: [S; 3], axes: [[S::Unit; 3]; 3]) -> Option<Self> {
        let axes = axes.map(|axis| axis.map(S::unit_to_raw));
        let line = turned::turned(raw(o), raw(position), axes, d.map(S::unit_to_raw))?;
        Some(Self {
            extra_bits: line.extra_bits,
            start: S::from_raw(line.start),
            is_coarse: line.extra_bits < S::Raw::FINER,
            ..Self::along(line.origin.map(S::from_raw), line.direction.map(S::unit_from_raw), S::ZERO)
        })
    }

    /// Reduces the extra bits of the origin so far that lengths up to `longest` fit in the same unit.
    #[inline(always)]
    pub(crate) fn fit(&mut self, longest: S) {
        let fitting = S::Raw::fitting(longest.to_raw());
        if self.extra_bits > fitting {
            self.origin = S::Raw::coarser(self.o(), (self.extra_bits - fitting) as u32).map(S::from_raw);
            self.extra_bits = fitting;
        }
    }
}

impl<S: GridScalar> FinerLine<S> {
    /// The line from `o` along `d` in the frame at `position` of a matrix whose inverse has these rows, for a solid
    /// whose lengths are at most `longest`; `None` if they do not fit.
    #[inline(always)]
    pub(crate) fn stretched(
        o: [S; 3],
        d: [S::Unit; 3],
        position: [S; 3],
        rows: [([S::Unit; 3], i32); 3],
        longest: S,
    ) -> Option<Self> {
        let rows = rows.map(|(row, exponent)| (row.map(S::unit_to_raw), exponent));
        let d = d.map(S::unit_to_raw);
        let line = S::Raw::stretched(raw(o), d, raw(position), rows, longest.to_raw())?;
        let (scale, inverse_length) = (line.scale, line.inverse_length);
        let line = LocalLine {
            extra_bits: line.extra_bits,
            start: S::from_raw(line.start),
            ..LocalLine::along(line.origin.map(S::from_raw), line.direction.map(S::unit_from_raw), S::ZERO)
        };
        Some(Self { line, scale, inverse_length })
    }

    /// Converts a `t` of the line to the ray's; `None` if it is too large.
    #[inline(always)]
    pub(crate) fn along_ray(&self, t: S) -> Option<S> {
        S::Raw::along_ray(self.inverse_length, self.line.start.to_raw(), t.to_raw()).map(S::from_raw)
    }
}
