//! The usual ray in plain doubles: far from every decision, no error needs to be carried along.
//!
//! Each sign is that of a sum of products of single-precision numbers, of which the sizes of its terms add up
//! to a bound. No product here has more than eight factors, and no factor more than a dozen roundings of 2^-53 behind it, the way into a
//! frame included: together they move the sum by less than 2^-44 of the bound. A sum above 2^-40 of it has a certain sign, and
//! one above 2^-14 is good to 2^-30. ("Semi-static filter": Devillers and Pion, *Efficient Exact
//! Geometric Predicates for Delaunay Triangulations*, 2003.) Anything else is left to the numbers that know their error.

use super::quick::Quick;
use crate::figure::{Extent, Figure, Side};
use crate::intersection::{self, Intersection, Span};
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::Real;

/// Sums above this part of their bound are good to 2^-30.
const CLEAR: f64 = 1.0 / (1u32 << 14) as f64;
/// Sums above this part of their bound have a certain sign.
const CERTAIN: f64 = 1.0 / (1u64 << 40) as f64;
/// Parameters of the line are good to 2^-26: those that differ by this part of themselves are in their true order.
const APART: f64 = 1.0 / (1u32 << 22) as f64;

/// A line, and the sizes of the terms that its coordinates are sums of, added up.
struct Line {
    origin: [f64; 3],
    direction: [f64; 3],
    sizes: [f64; 3],
    paces: [f64; 3],
}

/// Where a line is inside a convex surface: nowhere, or between two parameters, of which one may be infinite.
type Between = Option<[f64; 2]>;

/// How a line meets both nappes of a cone.
struct Cone {
    roots: [f64; 2],
    is_flat: bool,
    slope: f64,
    /// A number with the sign of the nappe, and its bound.
    middle: (f64, f64),
}

/// An end, and the part that it lies on.
type End = (f64, Part);

/// How the line meets the figure; `None` if that is not clear.
#[inline(always)]
pub(super) fn find(figure: &Figure<f32>, line: [[Quick; 3]; 2], range: Range<f32>) -> Option<Intersection<f32>> {
    let line = Line::new(line);
    match *figure {
        Figure::Ball { radius } => ball(&line, radius as f64, range),
        Figure::Capsule { radius, height } => capsule(&line, radius as f64, height as f64, range),
        Figure::Round { side, extent } => round(&line, side, extent, range),
        Figure::DoubleCone { slope } => double_cone(&line, slope as f64, range),
        Figure::Plane => plane(&line, range),
        Figure::Disc { radius } => disc(&line, radius as f64, range),
        Figure::Triangle { vertices } => triangle(&line, vertices, range),
    }
}

/// Whether the sum is positive; `None` if it is too small to be sure.
#[inline(always)]
fn is_positive(sum: f64, bound: f64) -> Option<bool> {
    // What overflowed compares false.
    (sum.abs() > bound * CERTAIN).then_some(sum > 0.0)
}

/// Whether the sum is positive; `None` if it is too small to be sure, or to compute with.
#[inline(always)]
fn is_clearly_positive(sum: f64, bound: f64) -> Option<bool> {
    (sum.abs() > bound * CLEAR).then_some(sum > 0.0)
}

/// Whether a parameter of the line comes after another; `None` if they are too close to be sure.
#[inline(always)]
fn is_after(t: f64, other: f64) -> Option<bool> {
    let difference = t - other;
    (difference.abs() > t.abs() * APART).then_some(difference > 0.0)
}

#[inline(always)]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl Line {
    #[inline(always)]
    fn new([o, d]: [[Quick; 3]; 2]) -> Self {
        Self {
            origin: o.map(|coordinate| coordinate.value),
            direction: d.map(|component| component.value),
            sizes: o.map(|coordinate| coordinate.magnitude),
            paces: d.map(|component| component.magnitude),
        }
    }

    /// At least what any coordinate of the origin is made of.
    #[inline(always)]
    fn size(&self) -> f64 {
        self.sizes[0] + self.sizes[1] + self.sizes[2]
    }

    /// At least what any coordinate of the direction is made of.
    #[inline(always)]
    fn pace(&self) -> f64 {
        self.paces[0] + self.paces[1] + self.paces[2]
    }

    /// Where it is inside the quadric `a t^2 + 2 k t + ...` of this discriminant; `a` is positive.
    #[inline(always)]
    fn between(a: f64, k: f64, discriminant: f64, bound: f64) -> Option<Between> {
        if discriminant < -bound * CERTAIN {
            return Some(None);
        }
        let root = Real::sqrt(discriminant);
        let (low, high, magnitude) = (-k - root, root - k, k.abs() + root);
        // The discriminant's error moves the root by less than 2^-45 of the bound over the root. No more than four bits may cancel.
        // (Root times magnitude is less than twice the part of the bound that is `a`'s: where it is clear, `a` is good to 2^-28.)
        let is_clear = discriminant > bound * CERTAIN
            && root * magnitude > bound * CLEAR
            && low.abs().min(high.abs()) * 16.0 > magnitude;
        if !is_clear {
            return None;
        }
        let inverse = 1.0 / a;
        Some(Some([low * inverse, high * inverse]))
    }

    /// Where it is inside the ball about `(0, height, 0)`: `D = a r^2 - |w|^2`.
    #[inline(always)]
    fn in_ball(&self, radius: f64, height: f64) -> Option<Between> {
        let ([x, y, z], d, size) = (self.origin, self.direction, self.size() + height);
        let o = [x, y - height, z];
        let (a, k, w) = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2], product(o, d), cross(o, d));
        let (rr, pace) = (radius * radius, self.pace() * self.pace());
        Self::between(a, k, a * rr - product(w, w), pace * (rr + size * size))
    }

    /// Where it is inside the cylinder about the y axis: `a = dx^2 + dz^2`, `D = a r^2 - w_y^2`.
    #[inline(always)]
    fn in_tube(&self, radius: f64) -> Option<Between> {
        let ([x, _, z], [dx, _, dz]) = (self.origin, self.direction);
        let (a, k, w) = (dx * dx + dz * dz, x * dx + z * dz, z * dx - x * dz);
        let (rr, pace) = (radius * radius, self.pace() * self.pace());
        is_clearly_positive(a, pace)?;
        Self::between(a, k, a * rr - w * w, pace * (rr + self.size() * self.size()))
    }

    /// The roots of `h^2 (x^2 + z^2) = (g0 + g y)^2` in order, if any, and whether it is inside between them: `D = h^2 (p^2 + q^2 - s^2)`, as in
    /// [`super::form::Form`].
    #[inline(always)]
    #[expect(clippy::option_option, reason = "a miss, and an unclear ray")]
    fn cone_roots(&self, [g0, g, h]: [f64; 3]) -> Option<Option<Cone>> {
        let ([x, y, z], [dx, dy, dz], size, pace) = (self.origin, self.direction, self.size(), self.pace());
        let [wx, wy, wz] = cross(self.origin, self.direction);
        let (p, q, s) = (g * wz - g0 * dx, g * wx + g0 * dz, h * wy);
        let (steep, base) = (g.abs() + h, g0.abs());
        let reach = steep * size + base;
        let discriminant = p * p + q * q - s * s;
        let bound = reach * reach * (pace * pace);
        let meets = is_positive(discriminant, bound)?;
        let slope = g * dy;
        let a = h * h * (dx * dx + dz * dz) - slope * slope;
        let is_flat = is_clearly_positive(a, steep * steep * (pace * pace))?;
        if !meets {
            // Steeper than the side every line meets it.
            return is_flat.then_some(None);
        }
        let outline = g0 + g * y;
        let k = h * h * (x * dx + z * dz) - outline * slope;
        let k_bound = steep * reach * pace;
        let root = Real::sqrt(discriminant);
        // -k and the root are added where they have one sign; the other end is c over that sum. (The root's error: as above.)
        let sum = k.abs() + h * root;
        is_clearly_positive(sum, k_bound)?;
        is_clearly_positive(root * sum, bound * h)?;
        let c = h * h * (x * x + z * z) - outline * outline;
        is_clearly_positive(c, reach * reach)?;
        let q = if k > 0.0 { -sum } else { sum };
        let (by_a, by_c) = (q / a, c / q);
        let [first, second] = if (k > 0.0) == is_flat { [by_a, by_c] } else { [by_c, by_a] };
        // The outline halfway between the ends, at t = -k / a, has the sign of the nappe.
        let middle = (outline * a - slope * k, 2.0 * steep * steep * reach * (pace * pace));
        Some(Some(Cone { roots: [first, second], is_flat, slope, middle }))
    }

    /// Where it is inside the upper nappe of that cone.
    #[inline(always)]
    fn in_nappe(&self, outline: [f64; 3]) -> Option<Between> {
        let Some(Cone { roots: [first, second], is_flat, slope, middle }) = self.cone_roots(outline)? else {
            return Some(None);
        };
        Some(if is_flat {
            is_positive(middle.0, middle.1)?.then_some([first, second])
        } else if slope > 0.0 {
            // A half-line in each nappe; the outline grows with t if it rises.
            Some([second, f64::INFINITY])
        } else {
            Some([-f64::INFINITY, first])
        })
    }

    /// Where it crosses the plane `y = height`.
    #[inline(always)]
    fn at_height(&self, height: f64) -> Option<f64> {
        let (rise, dy) = (height - self.origin[1], self.direction[1]);
        is_clearly_positive(rise, self.sizes[1] + height)?;
        is_clearly_positive(dy, self.paces[1])?;
        Some(rise / dy)
    }
}

#[inline(always)]
fn product(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// An end in the ray's own numbers; `None` if that is not clear. What is infinite stays so: an end that is not there.
#[inline(always)]
fn settled((t, part): End, range: Range<f32>) -> Option<intersection::End<f32>> {
    let t = if t.is_infinite() {
        t as f32
    } else if !is_after(t, range.start() as f64)? {
        f32::NEG_INFINITY
    } else if is_after(t, range.end() as f64)? {
        f32::INFINITY
    } else {
        t as f32
    };
    Some(intersection::End::new(t, part))
}

#[inline(always)]
fn piece(enter: End, exit: End, range: Range<f32>) -> Option<Span<f32>> {
    Some(Span::new(settled(enter, range)?, settled(exit, range)?))
}

#[inline(always)]
fn ball(line: &Line, radius: f64, range: Range<f32>) -> Option<Intersection<f32>> {
    let Some([low, high]) = line.in_ball(radius, 0.0)? else { return Some(Intersection::Miss) };
    Some(Intersection::One(piece((low, Part::Side), (high, Part::Side), range)?))
}

/// As in [`super::round::capsule`].
#[inline(always)]
fn capsule(line: &Line, radius: f64, height: f64, range: Range<f32>) -> Option<Intersection<f32>> {
    let Some(ends) = line.in_tube(radius)? else { return Some(Intersection::Miss) };
    let (y, dy) = (line.origin[1], line.direction[1]);
    let end = |which: usize| -> Option<Option<End>> {
        let own = ends[which];
        let at = y + own * dy;
        let bound = line.size() + own.abs() * line.pace() + height;
        let (part, centre) = if !is_clearly_positive(at, bound)? {
            (Part::Base, 0.0)
        } else if is_clearly_positive(at - height, bound)? {
            (Part::Top, height)
        } else {
            return Some(Some((own, Part::Side)));
        };
        Some(line.in_ball(radius, centre)?.map(|ends| (ends[which], part)))
    };
    let (Some(enter), Some(exit)) = (end(0)?, end(1)?) else { return Some(Intersection::Miss) };
    Some(Intersection::One(piece(enter, exit, range)?))
}

/// As in [`super::round::round`].
#[inline(always)]
fn round(line: &Line, side: Side<f32>, extent: Extent<f32>, range: Range<f32>) -> Option<Intersection<f32>> {
    let within = match side {
        Side::Straight(radius) => line.in_tube(radius as f64)?,
        Side::Slope(slope) => line.in_nappe([0.0, slope as f64, 1.0])?,
        Side::Radii(base, top, height) => {
            let (base, top, height) = (base as f64, top as f64, height as f64);
            line.in_nappe([base * height, top - base, height])?
        }
    };
    let Some([low, high]) = within else { return Some(Intersection::Miss) };
    let (base, top) = match extent {
        Extent::Infinite => (None, None),
        Extent::Open(height) => (Some(0.0), Some(height as f64)),
        Extent::Capped(base, top) => (base.map(f64::from), top.map(f64::from)),
    };
    let is_rising = is_positive(line.direction[1], line.paces[1])?;
    let crossing = |height: Option<f64>, missing: f64| match height {
        Some(height) => line.at_height(height),
        None => Some(missing),
    };
    let infinity = if is_rising { f64::INFINITY } else { -f64::INFINITY };
    let (at_base, at_top) = ((crossing(base, -infinity)?, Part::Base), (crossing(top, infinity)?, Part::Top));
    let (first, last) = if is_rising { (at_base, at_top) } else { (at_top, at_base) };
    let (enter, exit) = ((low, Part::Side), (high, Part::Side));
    if let Extent::Open(_) = extent {
        let between = |t: f64| Some(is_after(t, first.0)? && !is_after(t, last.0)?);
        // On the side where it lies between the rims.
        let enter = if between(enter.0)? { enter } else { (f64::NEG_INFINITY, Part::Side) };
        let exit = if between(exit.0)? { exit } else { (f64::INFINITY, Part::Side) };
        return Some(Intersection::Surface(piece(enter, exit, range)?));
    }
    let is_later = |end: End, other: End| if other.0.is_infinite() { Some(true) } else { is_after(end.0, other.0) };
    let enter = if is_later(enter, first)? { enter } else { first };
    let exit = if last.0.is_infinite() || !is_after(exit.0, last.0)? { exit } else { last };
    if !(exit.0.is_infinite() || enter.0.is_infinite()) && is_after(enter.0, exit.0)? {
        return Some(Intersection::Miss);
    }
    Some(Intersection::One(piece(enter, exit, range)?))
}

/// As in [`crate::solve`].
#[inline(always)]
fn double_cone(line: &Line, slope: f64, range: Range<f32>) -> Option<Intersection<f32>> {
    let Some(Cone { roots: [first, second], is_flat, .. }) = line.cone_roots([0.0, slope, 1.0])? else {
        return Some(Intersection::Miss);
    };
    let side = |t: f64| (t, Part::Side);
    if is_flat {
        return Some(Intersection::One(piece(side(first), side(second), range)?));
    }
    is_after(second, first)?;
    let until = piece(side(f64::NEG_INFINITY), side(first), range)?;
    Some(Intersection::Two(until, piece(side(second), side(f64::INFINITY), range)?))
}

/// The one crossing of a plane, from the front if the direction runs against the normal.
#[inline(always)]
fn crossing(t: f64, along_normal: bool, range: Range<f32>) -> Option<Intersection<f32>> {
    let (end, none) = ((t, Part::Side), |t: f64| (t, Part::Side));
    let span = if along_normal {
        piece(none(f64::NEG_INFINITY), end, range)?
    } else {
        piece(end, none(f64::INFINITY), range)?
    };
    Some(Intersection::Surface(span))
}

#[inline(always)]
fn plane(line: &Line, range: Range<f32>) -> Option<Intersection<f32>> {
    crossing(line.at_height(0.0)?, line.direction[1] > 0.0, range)
}

/// As in [`super::flat::disc`].
#[inline(always)]
fn disc(line: &Line, radius: f64, range: Range<f32>) -> Option<Intersection<f32>> {
    let [wx, _, wz] = cross(line.origin, line.direction);
    let reach = radius * line.direction[1];
    let bound = (line.pace() * line.pace()) * (line.size() * line.size() + radius * radius);
    if is_positive(wx * wx + wz * wz - reach * reach, bound)? {
        // Not where it lies in the plane.
        return is_positive(line.direction[1], line.paces[1]).map(|_| Intersection::Miss);
    }
    plane(line, range)
}

/// As in [`super::flat::triangle`].
#[inline(always)]
fn triangle(line: &Line, vertices: [[f32; 3]; 3], range: Range<f32>) -> Option<Intersection<f32>> {
    let [va, vb, vc] = vertices;
    let [va, vb, vc] = [va, vb, vc].map(|vertex| vertex.map(f64::from));
    let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let span = |v: [f64; 3]| v[0].abs() + v[1].abs() + v[2].abs();
    let extent = span(va).max(span(vb)).max(span(vc));
    let (size, d) = (extent + line.size(), line.direction);
    let [a, b, c] = [minus(va, line.origin), minus(vb, line.origin), minus(vc, line.origin)];
    let normal = cross(minus(vb, va), minus(vc, va));
    let facing = product(normal, d);
    let along_normal = is_clearly_positive(facing, 4.0 * extent * extent * line.pace())?;
    for (p, q) in [(a, b), (b, c), (c, a)] {
        // d . (p x q): the side on which the line passes the edge from p to q.
        if is_positive(product(d, cross(p, q)), size * size * line.pace())? != along_normal {
            return Some(Intersection::Miss);
        }
    }
    let distance = product(normal, a);
    is_clearly_positive(distance, 4.0 * extent * extent * size)?;
    crossing(distance / facing, along_normal, range)
}
