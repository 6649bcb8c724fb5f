//! The flat figures: where a line crosses a plane, a disc and a triangle, decided by signs.

use super::form::{Form, Line, cross, difference};
use super::found::Found;
use super::solve::{End, Fraction, Inside, Interval, Of, Quadratic, piece, times};
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::certain::{Certain, Number, dot};
use core::cmp::Ordering;

/// The one crossing of a plane at `t`, from the front if the direction runs against the normal.
fn crossing<S: Certain, N: Of<S>>(t: Fraction<N>, along_normal: Ordering, range: Range<S>) -> Option<Found<S>> {
    let end = Some(End::at(t, Part::Side));
    let interval = if along_normal == Ordering::Less { Interval::new(end, None) } else { Interval::new(None, end) };
    Some(Found::Surface(piece(None, interval, range)?))
}

/// The plane `y = 0`.
pub(super) fn plane<S: Certain, N: Of<S>>(line: &Line<N>, range: Range<S>) -> Option<Found<S>> {
    let ([_, y, _], [_, dy, _]) = (line.origin, line.direction);
    match dy.sign()? {
        Ordering::Equal if y.sign()? == Ordering::Equal => {
            Some(Found::LiesIn(piece(None, Interval::<N>::EVERYWHERE, range)?))
        }
        Ordering::Equal => Some(Found::Miss),
        climb => crossing(Fraction { n: -y, e: dy }, climb, range),
    }
}

/// The disc of this radius in the plane `y = 0`.
pub(super) fn disc<S: Certain, N: Of<S>>(line: &Line<N>, r: N, range: Range<S>) -> Option<Found<S>> {
    if line.direction[1].sign()? != Ordering::Equal {
        // |p|^2 <= r^2 where the line crosses the plane, times dy^2.
        let [wx, _, wz] = cross(line.origin, line.direction);
        let reach = r * line.direction[1];
        let outside = (wx * wx + wz * wz - reach * reach).sign()? == Ordering::Greater;
        return if outside { Some(Found::Miss) } else { plane(line, range) };
    }
    match plane(line, range)? {
        Found::LiesIn(..) => {
            let chord = Quadratic::new(Form::Tube { r }, line)?;
            Some(match chord.inside()? {
                Inside::Between(touch) => {
                    let [enter, exit] = chord.ends().map(Some);
                    Found::LiesIn(piece(Some(&chord), Interval { enter, exit, touch }, range)?)
                }
                _ => Found::Miss,
            })
        }
        found => Some(found),
    }
}

/// The triangle, whose front is where its vertices run counter-clockwise.
pub(super) fn triangle<S: Certain, N: Of<S>>(
    line: &Line<N>,
    vertices: [[N; 3]; 3],
    range: Range<S>,
) -> Option<Found<S>> {
    let [a, b, c] = vertices.map(|vertex| difference(vertex, line.origin));
    let [va, vb, vc] = vertices;
    let normal = cross(difference(vb, va), difference(vc, va));
    let (facing, distance) = (dot(normal, line.direction), dot(normal, a));
    let along_normal = facing.sign()?;
    if along_normal == Ordering::Equal {
        if is_zero(normal)? {
            // Corners on a line, as exact arithmetic sees them: no area, no hit.
            return Some(Found::Miss);
        }
        return if distance.sign()? == Ordering::Equal {
            lies_in(normal, line, vertices, range)
        } else {
            Some(Found::Miss)
        };
    }
    // d . (p x q): the side on which the line passes the edge from p to q.
    for (p, q) in [(a, b), (b, c), (c, a)] {
        if times(dot(line.direction, cross(p, q)).sign()?, along_normal) == Ordering::Less {
            return Some(Found::Miss);
        }
    }
    crossing(Fraction { n: distance, e: facing }, along_normal, range)
}

/// True for the zero vector.
pub(super) fn is_zero<N: Number>(v: [N; 3]) -> Option<bool> {
    Some(v[0].sign()? == Ordering::Equal && v[1].sign()? == Ordering::Equal && v[2].sign()? == Ordering::Equal)
}

/// The piece of a line of its plane that lies in the triangle: cut off by each edge in turn.
fn lies_in<S: Certain, N: Of<S>>(
    normal: [N; 3],
    line: &Line<N>,
    vertices: [[N; 3]; 3],
    range: Range<S>,
) -> Option<Found<S>> {
    let [a, b, c] = vertices;
    let (mut enter, mut exit): (Option<Fraction<N>>, Option<Fraction<N>>) = (None, None);
    for (p, q) in [(a, b), (b, c), (c, a)] {
        // Points x with inward . (x - p) >= 0 are on the inner side.
        let inward = cross(normal, difference(q, p));
        let (at_origin, slope) = (dot(inward, difference(line.origin, p)), dot(inward, line.direction));
        let t = Fraction { n: -at_origin, e: slope };
        match slope.sign()? {
            Ordering::Equal if at_origin.sign()? == Ordering::Less => return Some(Found::Miss),
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
        return Some(Found::Miss);
    }
    let end = |t: Fraction<N>| End::at(t, Part::Side);
    Some(Found::LiesIn(piece(None, Interval::new(enter.map(end), exit.map(end)), range)?))
}
