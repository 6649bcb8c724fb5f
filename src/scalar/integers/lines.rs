//! What a line meets on the grid of fixed point: from stored numbers to raw integers and back. The results are
//! [`Attempt::Unsure`] where rounding may decide.

use super::cone::Nappe;
use super::length::{Length, Product, Stretch};
use super::revolved::Quadric;
use super::{ball, cone, cuboid, departing, flat, half_space, revolved, round, torus, triangle, turned};
use crate::equations::Region;
use crate::outline::{Meridian, Outline};
use crate::scalar::{Attempt, Crossed, FinerLine, GridScalar, InCuboid, InSide, LocalLine, found};
use crate::vector::component;
use core::cmp::Ordering;

/// The error of an end is at most a unit, that of the height there less than two: rounding may decide the order of two
/// that are less than 2 to the power of this apart.
const DOUBTFUL_BITS: u32 = 2;

/// The raw integers of a point or of an outline.
#[inline(always)]
fn raw<S: GridScalar, const M: usize>(numbers: [S; M]) -> [S::Raw; M] {
    numbers.map(S::to_raw)
}

/// The interval of raw integers in the type.
#[inline(always)]
fn from_raw<S: GridScalar>(InSide { ends, beyond }: InSide<S::Raw>) -> InSide<S> {
    InSide { ends: ends.map(S::from_raw), beyond: beyond.map(S::from_raw) }
}

/// Whether rounding may decide the order of two ends.
#[inline(always)]
pub(crate) fn are_doubtful<S: GridScalar>(a: S, b: S) -> bool {
    a.to_raw().are_within(b.to_raw(), DOUBTFUL_BITS)
}

/// The nappe of an outline.
#[inline(always)]
fn of_outline<S: GridScalar>(outline: Outline<S>) -> Option<Nappe<S::Raw>> {
    let (base, top, height) = match outline {
        Outline::Slope(slope) => (S::ZERO, slope, S::one()?),
        Outline::Radii(base, top, height) => (base, top, height.to_raw()),
    };
    (height > S::Raw::ZERO).then(|| Nappe::of_radii([base.to_raw(), top.minus(base).to_raw(), height]))
}

/// The quadric of a meridian.
#[inline(always)]
fn of_meridian<S: GridScalar>(meridian: &Meridian<S>) -> Option<Quadric<S::Raw>> {
    Quadric::new(raw([meridian.a, meridian.b, meridian.r]), S::one()?)
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
    pub(crate) fn cylinder(&self, r: S) -> Attempt<InSide<S>> {
        let ends = found!(round::cylinder(self.o(), self.extra_bits, self.d(), r.to_raw(), self.is_strict));
        Attempt::Hit(InSide { ends: ends.map(S::from_raw), beyond: [S::ZERO; 2] })
    }

    /// The interval of the line inside the nappe of this outline.
    #[inline(always)]
    pub(crate) fn nappe(&self, outline: Outline<S>) -> Attempt<InSide<S>> {
        self.in_nappe(of_outline(outline))
    }

    /// The interval of the line inside the nappe that touches two balls, of these radii about the origin and about
    /// `(0, height, 0)`.
    #[inline(always)]
    pub(crate) fn nappe_around(&self, radii: [S; 2], height: S) -> Attempt<InSide<S>> {
        self.in_nappe(Nappe::around(raw(radii), height.to_raw()))
    }

    #[inline(always)]
    fn in_nappe(&self, nappe: Option<Nappe<S::Raw>>) -> Attempt<InSide<S>> {
        let Some(nappe) = nappe else { return Attempt::Unsure };
        let inside = found!(cone::nappe(self.o(), self.extra_bits, self.d(), nappe, self.is_strict));
        Attempt::Hit(from_raw(inside))
    }

    /// Where the line is inside the quadric of revolution, without its planes: in one interval or in two.
    #[inline(always)]
    pub(crate) fn quadric(&self, meridian: &Meridian<S>) -> Attempt<(InSide<S>, Option<InSide<S>>)> {
        let Some(of) = of_meridian(meridian) else { return Attempt::Unsure };
        let (first, second) = found!(revolved::quadric(self.o(), self.extra_bits, self.d(), of, self.is_strict));
        Attempt::Hit((from_raw(first), second.map(from_raw)))
    }

    /// Where the line is inside the torus with these radii, the major and the minor one: in one interval or in two, or
    /// its entry alone, whose exit is then inaccurate.
    #[inline(always)]
    pub(crate) fn torus(&self, radii: [S; 2]) -> Attempt<(InSide<S>, Option<InSide<S>>)> {
        let since = self.since.map(S::to_raw);
        let (first, second) = found!(torus::torus(self.o(), self.extra_bits, self.d(), raw(radii), since));
        Attempt::Hit((from_raw(first), second.map(from_raw)))
    }

    /// The exit of a line that starts on the quadric and leads inwards; infinite if there is none.
    #[inline(always)]
    pub(crate) fn exit_from_quadric(&self, meridian: &Meridian<S>) -> Attempt<S> {
        found!(self.starts_at_origin());
        let Some(of) = of_meridian(meridian) else { return Attempt::Unsure };
        let exit = found!(revolved::exit_from_quadric(self.o(), self.extra_bits, self.d(), of, self.is_strict));
        Attempt::Hit(S::from_raw(exit))
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

    /// The exit of a line that starts on the side of the nappe of this outline and leads inwards; infinite if there is
    /// none.
    #[inline(always)]
    pub(crate) fn exit_from_nappe(&self, outline: Outline<S>) -> Attempt<S> {
        self.exit_from(of_outline(outline))
    }

    /// The same of the nappe of [`nappe_around`](Self::nappe_around).
    #[inline(always)]
    pub(crate) fn exit_from_nappe_around(&self, radii: [S; 2], height: S) -> Attempt<S> {
        self.exit_from(Nappe::around(raw(radii), height.to_raw()))
    }

    #[inline(always)]
    fn exit_from(&self, nappe: Option<Nappe<S::Raw>>) -> Attempt<S> {
        found!(self.starts_at_origin());
        let Some(nappe) = nappe else { return Attempt::Unsure };
        let exit = found!(cone::exit_from_nappe(self.o(), self.extra_bits, self.d(), nappe, self.is_strict));
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
    /// (`Greater`); unsure next to these, if `is_guarded`.
    #[inline(always)]
    pub(crate) fn seams(&self, t: S, height: S, is_guarded: bool) -> Attempt<Ordering> {
        let (oy, dy) = (self.origin[1].to_raw(), S::unit_to_raw(self.direction[1]));
        let y = found!(flat::height(oy, self.extra_bits, dy, t.to_raw()));
        let (low, high) = (S::Raw::ZERO, height.to_raw());
        if is_guarded && (y.are_within(low, DOUBTFUL_BITS) || y.are_within(high, DOUBTFUL_BITS)) {
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

    /// The same between the seams of two balls of these radii and the nappe that touches them, one at
    /// `base (base - top) / height`, the other at `height + top (base - top) / height`. The `t` may be infinite.
    #[inline(always)]
    pub(crate) fn seams_around(&self, t: S, radii: [S; 2], height: S, is_guarded: bool) -> Attempt<Ordering> {
        let ([base, top], height) = (raw(radii), height.to_raw());
        let (oy, dy) = (self.origin[1].to_raw(), S::unit_to_raw(self.direction[1]));
        if !t.is_finite() {
            let climbs = dy.cmp(&S::Raw::ZERO);
            return Attempt::Hit(if t < S::ZERO { climbs.reverse() } else { climbs });
        }
        let y = found!(flat::height(oy, self.extra_bits, dy, t.to_raw()));
        let Some(above) = y.checked_plus(-height).filter(|above| S::Raw::have_products([y, *above, height])) else {
            return Attempt::Unsure;
        };
        let k = base - top;
        let from = [S::Raw::minor([y, base], [k, height]), S::Raw::minor([above, top], [k, height])];
        let doubt = <S::Raw as Length>::Product::from(height) << DOUBTFUL_BITS;
        if is_guarded && from.into_iter().any(|from| from.magnitude() < doubt) {
            return Attempt::Unsure;
        }
        let [above_low, above_high] = from.map(|from| from.cmp(&Product::ZERO));
        Attempt::Hit(match (above_low, above_high) {
            (Ordering::Less, _) => Ordering::Less,
            (_, Ordering::Greater) => Ordering::Greater,
            _ => Ordering::Equal,
        })
    }

    /// The region of the line's point at `t` beside the cuboid with these half extents, if it is certain.
    #[inline(always)]
    pub(crate) fn region(&self, t: S, half: [S; 3]) -> Attempt<Region> {
        let ([x, y, z], [dx, dy, dz], [hx, hy, hz]) = (self.o(), self.d(), raw(half));
        let side = |o, d, half: S::Raw| {
            let c = found!(flat::height(o, self.extra_bits, d, t.to_raw()));
            let size = if c < S::Raw::ZERO { -c } else { c };
            Attempt::Hit(if size.are_within(half, DOUBTFUL_BITS) {
                return Attempt::Unsure;
            } else if size < half {
                Ordering::Equal
            } else {
                c.cmp(&S::Raw::ZERO)
            })
        };
        Attempt::Hit([found!(side(x, dx, hx)), found!(side(y, dy, hy)), found!(side(z, dz, hz))])
    }

    /// True if the line starts in this plane across an axis, but for rounding.
    #[inline(always)]
    pub(crate) fn starts_at(&self, axis: usize, plane: S) -> bool {
        let (o, d) = (component(self.o(), axis), component(self.d(), axis));
        match flat::height(o, self.extra_bits, d, S::Raw::ZERO) {
            Attempt::Hit(c) => c.are_within(plane.to_raw(), DOUBTFUL_BITS),
            _ => false,
        }
    }

    /// The line with its coordinates in turn, so that this axis is the second.
    #[inline(always)]
    pub(crate) fn about(&self, axis: usize) -> Self {
        let ([x, y, z], [dx, dy, dz]) = (self.origin, self.direction);
        let (origin, direction) = match axis {
            0 => ([z, x, y], [dz, dx, dy]),
            1 => ([x, y, z], [dx, dy, dz]),
            _ => ([y, z, x], [dy, dz, dx]),
        };
        Self { origin, direction, ..*self }
    }

    /// The line relative to the point `(0, y, 0)`.
    #[inline(always)]
    pub(crate) fn lowered(&self, y: S) -> Attempt<Self> {
        let [ox, oy, oz] = self.origin;
        Attempt::Hit(Self { origin: [ox, found!(self.relative_to(y, oy)), oz], ..*self })
    }

    /// A coordinate of the origin, relative to this one of the sizes.
    #[inline(always)]
    pub(crate) fn relative_to(&self, size: S, coordinate: S) -> Attempt<S> {
        match size.to_raw().relative_to(coordinate.to_raw(), self.extra_bits) {
            Some(above) => Attempt::Hit(S::from_raw(-above)),
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

    /// Where the line crosses the plane through a point with this outward normal, of any length.
    #[inline(always)]
    pub(crate) fn half_space(&self, point: [S; 3], normal: [S; 3]) -> Attempt<Crossed<S>> {
        let plane = [raw(point), raw(normal)];
        Attempt::Hit(match found!(half_space::half_space(self.o(), self.extra_bits, self.d(), plane)) {
            Crossed::Enters(t) => Crossed::Enters(S::from_raw(t)),
            Crossed::Leaves(t) => Crossed::Leaves(S::from_raw(t)),
            Crossed::Inside => Crossed::Inside,
        })
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
