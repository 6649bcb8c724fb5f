//! The flat primitives: intersection of a line with a plane, a disc and a triangle, decided by signs.

use super::form::{Line, Tube};
use super::quadratic::{End, Flat, Fraction, Inside, Interval, Quadratic};
use super::settle::{Of, span};
use crate::intersection::Intersection;
use crate::number::{self, Number, difference, dot};
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// The crossing of a plane at `t`, from the front if the direction and the normal have opposite signs.
pub(super) fn crossing<S: Scalar, N: Of<S>>(
    t: Fraction<N>,
    along_normal: Ordering,
    range: Range<S>,
) -> Option<Intersection<S>> {
    let end = Some(End::at(t, Part::Side));
    let interval = if along_normal == Ordering::Less { Interval::new(end, None) } else { Interval::new(None, end) };
    Some(Intersection::Surface(span(&Flat, interval, range)?))
}

/// The plane `y = 0`.
#[inline(never)]
pub(super) fn plane<S: Scalar, N: Of<S>>(line: &Line<N>, range: Range<S>) -> Option<Intersection<S>> {
    let ([_, y, _], [_, dy, _]) = (line.origin, line.direction);
    match dy.sign()? {
        Ordering::Equal if y.sign()? == Ordering::Equal => {
            Some(Intersection::LiesIn(span(&Flat, Interval::<N>::EVERYWHERE, range)?))
        }
        Ordering::Equal => Some(Intersection::Miss),
        climb => crossing(Fraction { n: -y, e: dy }, climb, range),
    }
}

/// The disc of this radius in the plane `y = 0`.
#[inline(never)]
pub(super) fn disc<S: Scalar, N: Of<S>>(line: &Line<N>, r: N, range: Range<S>) -> Option<Intersection<S>> {
    if line.direction[1].sign()? != Ordering::Equal {
        // |p|^2 <= r^2 where the line crosses the plane, times dy^2.
        let [wx, _, wz] = number::cross(line.origin, line.direction);
        let bounding_radius = r * line.direction[1];
        let outside = N::sum([[wx, wx], [wz, wz], [-bounding_radius, bounding_radius]]).sign()? == Ordering::Greater;
        return if outside { Some(Intersection::Miss) } else { plane(line, range) };
    }
    match plane(line, range)? {
        Intersection::LiesIn(..) => {
            let chord = Quadratic::new(Tube { r }, line, false)?;
            Some(match chord.inside()? {
                Inside::Between(touch) => {
                    let [enter, exit] = chord.ends().map(Some);
                    Intersection::LiesIn(span(&chord, Interval { enter, exit, touch }, range)?)
                }
                _ => Intersection::Miss,
            })
        }
        found => Some(found),
    }
}

/// The triangle. Its front is the side from which its vertices are in counter-clockwise order.
///
/// The line passes inside if the three signed volumes that it spans with the edges have the same sign (Segura and Feito, *Algorithms to
/// test ray-triangle intersection*, 2001). The volume of an edge depends only on its two end points and the line, and changes its
/// sign exactly when the points are swapped, so that no line passes between two triangles that share an edge. No other sign is needed: the
/// sum of the volumes is `d . n`, whose sign tells the side that is hit, and by which `t` is divided.
///
/// With the line's Pluecker moment `m = o x d`, the volume of an edge is the product of two lines in Pluecker coordinates. For a far
/// origin the cancellation is in `m` only, before anything is rounded.
#[inline(never)]
pub(super) fn triangle<S: Scalar, N: Of<S>>(
    line: &Line<N>,
    vertices: [[N; 3]; 3],
    range: Range<S>,
) -> Option<Intersection<S>> {
    let (d, m) = (line.direction, cross(line.origin, line.direction));
    let [va, vb, vc] = vertices;
    let volumes = [[va, vb], [vb, vc], [vc, va]].map(|edge| volume(d, m, edge));
    let mut along_normal = Ordering::Equal;
    for volume in volumes {
        match volume.sign()? {
            Ordering::Equal => {}
            sign if along_normal == Ordering::Equal => along_normal = sign,
            sign if sign == along_normal => {}
            _ => return Some(Intersection::Miss),
        }
    }
    let normal = cross(difference(vb, va), difference(vc, va));
    let distance = dot(normal, difference(va, line.origin));
    if along_normal == Ordering::Equal {
        // The line lies in the plane, or the vertices are exactly collinear: then there is no area and no hit.
        let misses = is_zero(normal)? || distance.sign()? != Ordering::Equal;
        return if misses { Some(Intersection::Miss) } else { lies_in(normal, line, vertices, range) };
    }
    let [u, v, w] = volumes;
    crossing(Fraction { n: distance, e: u + v + w }, along_normal, range)
}

/// `a x b`
#[inline(never)]
fn cross<N: Number>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    number::cross(a, b)
}

/// On which side of the edge from `p` to `q` the line along `d` with the moment `m` passes: the sign of `d . (p x q) + m . (q - p)`
#[inline(never)]
fn volume<N: Number>(d: [N; 3], m: [N; 3], [p, q]: [[N; 3]; 2]) -> N {
    dot(d, cross(p, q)) + dot(m, difference(q, p))
}

/// True for the zero vector.
pub(super) fn is_zero<N: Number>(v: [N; 3]) -> Option<bool> {
    Some(v[0].sign()? == Ordering::Equal && v[1].sign()? == Ordering::Equal && v[2].sign()? == Ordering::Equal)
}

/// The interval of a line in the triangle's plane that lies in the triangle: clipped by each edge in turn.
#[inline(never)]
fn lies_in<S: Scalar, N: Of<S>>(
    normal: [N; 3],
    line: &Line<N>,
    vertices: [[N; 3]; 3],
    range: Range<S>,
) -> Option<Intersection<S>> {
    let [a, b, c] = vertices;
    let (mut enter, mut exit): (Option<Fraction<N>>, Option<Fraction<N>>) = (None, None);
    for (p, q) in [(a, b), (b, c), (c, a)] {
        // Points x with inward . (x - p) >= 0 are on the inner side.
        let inward = cross(normal, difference(q, p));
        let (at_origin, slope) = (dot(inward, difference(line.origin, p)), dot(inward, line.direction));
        let t = Fraction { n: -at_origin, e: slope };
        match slope.sign()? {
            Ordering::Equal if at_origin.sign()? == Ordering::Less => return Some(Intersection::Miss),
            Ordering::Equal => {}
            Ordering::Greater => {
                let is_later = enter.map_or(Some(true), |own| Some(t.order(own)? == Ordering::Greater))?;
                enter = if is_later { Some(t) } else { enter };
            }
            Ordering::Less => {
                let is_earlier = exit.map_or(Some(true), |own| Some(t.order(own)? == Ordering::Less))?;
                exit = if is_earlier { Some(t) } else { exit };
            }
        }
    }
    if let (Some(first), Some(last)) = (enter, exit)
        && first.order(last)? == Ordering::Greater
    {
        return Some(Intersection::Miss);
    }
    let end = |t: Fraction<N>| End::at(t, Part::Side);
    Some(Intersection::LiesIn(span(&Flat, Interval::new(enter.map(end), exit.map(end)), range)?))
}
