//! The flat primitives: planes, discs and triangles.

use super::attempt::{Attempt, Stop, known};
use super::end::{End, Flat, Fraction, Goal, Interval, Of, span};
use super::local_ray::LocalRay;
use super::quadratic::{Inside, Quadratic};
use super::quadric::Cylinder;
use crate::intersection::{self, Intersection, Span};
use crate::number::{Difference, Estimate, Number, cross, difference, dot};
use crate::part::Part;
use crate::scalar::{Scalar, ToScalar};
use core::cmp::Ordering;

/// The crossing of a plane at `t`, from the front if the direction and the normal have opposite signs.
#[inline(always)]
pub(super) fn crossing<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    t: Fraction<N>,
    along_normal: Ordering,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let end = super::end::settled(&Flat, line, &End::at(t, Part::Side), goal.range)?;
    Ok(Intersection::Surface(if along_normal == Ordering::Less {
        Span::new(end, intersection::End::none(S::INFINITY))
    } else {
        Span::new(intersection::End::none(-S::INFINITY), end)
    }))
}

/// The plane `y = 0`.
#[inline(always)]
pub(crate) fn plane<S: Scalar, N: Of<S>>(line: &LocalRay<N>, goal: Goal<S>) -> Attempt<Intersection<S>> {
    let (y, dy) = (line.origin[1], line.direction[1]);
    match known(dy.sign_among(Difference::Signs, || N::ONE))? {
        Ordering::Equal if known(y.sign())? == Ordering::Equal => Ok(Intersection::LiesIn(Span::everywhere())),
        Ordering::Equal => Err(Stop::Miss),
        climb => crossing(line, Fraction { n: -y, e: dy }, climb, goal),
    }
}

/// The disc of this radius in the plane `y = 0`.
#[inline(always)]
pub(crate) fn disc<S: Scalar, N: Of<S>>(line: &LocalRay<N>, radius: S, goal: Goal<S>) -> Attempt<Intersection<S>> {
    let climb = known(line.direction[1].sign_among(Difference::Signs, || N::ONE))?;
    if climb == Ordering::Equal {
        return chord_of_disc(line, N::scalar(radius), goal);
    }
    if from_circle(line, N::scalar(radius))? == Ordering::Greater {
        return Err(Stop::Miss);
    }
    crossing(line, Fraction { n: -line.origin[1], e: line.direction[1] }, climb, goal)
}

/// The part of the plane `y = 0` between two circles.
#[inline(always)]
pub(crate) fn annulus<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    [inner, outer]: [S; 2],
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let hit = disc(line, outer, goal)?;
    let is_in_the_hole = match hit {
        // In the plane the chord of the disc counts, also across the hole.
        Intersection::LiesIn(_) => false,
        _ => from_circle(line, N::scalar(inner))? == Ordering::Less,
    };
    if is_in_the_hole { Err(Stop::Miss) } else { Ok(hit) }
}

/// Where the line crosses the plane `y = 0`: inside the circle of radius `r` about the origin (`Less`), on it, or
/// outside.
#[inline(always)]
fn from_circle<N: Number>(line: &LocalRay<N>, r: N) -> Attempt<Ordering> {
    let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
    // |p|^2 <= r^2 where the line crosses the plane, times dy^2.
    let (wx, wz, rim) = (N::sum([[x, dy], [-y, dx]]), N::sum([[z, dy], [-y, dz]]), r * dy);
    let inside = N::sum([[rim, rim], [-wx, wx], [-wz, wz]]);
    let terms = || {
        let terms = N::sum([[rim, rim], [wx, wx], [wz, wz]]);
        if line.start.is_some() {
            return terms + line.far(-19);
        }
        // The square of an error of four roundings of the products in `w` is less than a 4096th of these.
        let cancelled = |c: N, dc: N| (c * dy).magnitude() + (y * dc).magnitude();
        let [sx, sz] = [cancelled(x, dx), cancelled(z, dz)];
        terms + N::sum([[sx, sx], [sz, sz]]).scaled(-19)
    };
    Ok(known(inside.sign_among(Difference::Signs, terms))?.reverse())
}

/// A line parallel to the plane of a disc.
#[cold]
#[inline(never)]
fn chord_of_disc<S: Scalar, N: Of<S>>(line: &LocalRay<N>, r: N, goal: Goal<S>) -> Attempt<Intersection<S>> {
    let ([x, y, z], [dx, _, dz]) = (line.origin, line.direction);
    if known(y.sign())? != Ordering::Equal {
        return Err(Stop::Miss);
    }
    let chord = Quadratic::new(Cylinder { o: [x, z], d: [dx, dz], r }, line, false)?;
    let Inside::Between(touch) = chord.inside else { return Err(Stop::Miss) };
    Ok(Intersection::LiesIn(span(&chord, line, &chord.between(touch), goal.range)?))
}

/// The triangle. Its front is the side from which its vertices are in counter-clockwise order.
///
/// The line passes inside if the three signed volumes that it spans with the edges have the same sign (Segura and
/// Feito, *Algorithms to test ray-triangle intersection*, 2001). With vertices relative to a point of the line the
/// volume of the edge from `p` to `q` is `d . (p x q)`. It depends only on the edge's end points and the line, and
/// changes its sign exactly when the points are swapped, so that no line passes between two triangles that share an
/// edge. The sum of the volumes is `d . n`, by which `t` is divided.
#[inline(always)]
pub(crate) fn triangle<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    vertices: [[S; 3]; 3],
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let (o, d) = (line.origin, line.direction);
    let [va, vb, vc] = vertices.map(|vertex| vertex.map(N::scalar));
    let (u, v) = (difference(vb, va), difference(vc, va));
    let mut seen = *line;
    let mut a = difference(va, o);
    if N::STARTS_AT_VERTEX {
        // The point of the line next to the first vertex; its parameter need not be accurate.
        let k = if line.is_unit { dot(a, d) } else { dot(a, d).rounded_quotient(dot(d, d)).unwrap_or(N::ZERO) };
        let k = k.without_error();
        a = [a[0] - k * d[0], a[1] - k * d[1], a[2] - k * d[2]];
        seen.start = Some(ToScalar::<S>::whole(k.estimate(), line.start));
        seen.moved = line.moved + k;
    }
    let [b, c] = if N::STARTS_AT_VERTEX {
        [[a[0] + u[0], a[1] + u[1], a[2] + u[2]], [a[0] + v[0], a[1] + v[1], a[2] + v[2]]]
    } else {
        [difference(vb, o), difference(vc, o)]
    };
    let squares = dot(u, u) + dot(v, v) + dot(a, a);
    let terms = squares + seen.far(if N::STARTS_AT_VERTEX { -18 } else { -3 });
    let volumes = if N::IS_WIDE {
        // With the Pluecker moment the start of a far line cancels before anything is rounded.
        let m = product(o, d);
        [[va, vb], [vb, vc], [vc, va]].map(|[p, q]| volume(d, p, q) + dot(m, difference(q, p)))
    } else {
        [volume(d, a, b), volume(d, b, c), volume(d, c, a)]
    };
    let mut along_normal = Ordering::Equal;
    for volume in volumes {
        match known(volume.sign_among(Difference::Volumes, || terms))? {
            Ordering::Equal => {}
            sign if along_normal == Ordering::Equal => along_normal = sign,
            sign if sign == along_normal => {}
            _ => return Err(Stop::Miss),
        }
    }
    let normal = product(u, v);
    if along_normal == Ordering::Equal {
        return in_the_plane(line, normal, [va, vb, vc], goal);
    }
    let (distance, facing) = (dot(normal, a), dot(d, normal));
    if N::STARTS_AT_VERTEX {
        if known(facing.sign())? != along_normal {
            return Err(Stop::Unsure);
        }
        let t = ToScalar::<S>::whole(distance.estimate().over(facing.estimate()), seen.start);
        // The error of `n . a`, by that of the normal and by that of a moved origin.
        let reach = || {
            let size = |v: [N; 3]| v[0].magnitude() + v[1].magnitude() + v[2].magnitude();
            size(a).scaled(-1) * squares + seen.moved.magnitude().scaled(-3) * size(normal)
        };
        if !N::is_far(t, facing.estimate(), reach) {
            return Err(Stop::Unsure);
        }
    }
    crossing(&seen, Fraction { n: distance, e: facing }, along_normal, goal)
}

/// `d . (p x q)`: on which side of the edge from `p` to `q` the line passes.
#[inline(always)]
fn volume<N: Number>(d: [N; 3], p: [N; 3], q: [N; 3]) -> N {
    N::apart(
        #[inline(always)]
        || dot(d, cross(p, q)),
    )
}

/// `a x b`
#[inline(always)]
fn product<N: Number>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    N::apart(
        #[inline(always)]
        || cross(a, b),
    )
}

/// True for the zero vector.
pub(super) fn is_zero<N: Number>(v: [N; 3]) -> Option<bool> {
    Some(v[0].sign()? == Ordering::Equal && v[1].sign()? == Ordering::Equal && v[2].sign()? == Ordering::Equal)
}

/// The interval of a line in the triangle's plane that lies in the triangle: clipped by each edge in turn.
#[cold]
#[inline(never)]
fn in_the_plane<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    normal: [N; 3],
    [a, b, c]: [[N; 3]; 3],
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let distance = dot(normal, difference(a, line.origin));
    // Exactly collinear vertices have no area.
    if known(is_zero(normal))? || known(distance.sign())? != Ordering::Equal {
        return Err(Stop::Miss);
    }
    let (mut enter, mut exit): (Option<Fraction<N>>, Option<Fraction<N>>) = (None, None);
    for (p, q) in [(a, b), (b, c), (c, a)] {
        // Points x with inward . (x - p) >= 0 are on the inner side.
        let inward = product(normal, difference(q, p));
        let (at_origin, slope) = (dot(inward, difference(line.origin, p)), dot(inward, line.direction));
        let t = Fraction { n: -at_origin, e: slope };
        match known(slope.sign())? {
            Ordering::Equal if known(at_origin.sign())? == Ordering::Less => return Err(Stop::Miss),
            Ordering::Equal => {}
            Ordering::Greater => {
                let is_later = match enter {
                    Some(own) => known(t.order(own))? == Ordering::Greater,
                    None => true,
                };
                enter = if is_later { Some(t) } else { enter };
            }
            Ordering::Less => {
                let is_earlier = match exit {
                    Some(own) => known(t.order(own))? == Ordering::Less,
                    None => true,
                };
                exit = if is_earlier { Some(t) } else { exit };
            }
        }
    }
    if let (Some(first), Some(last)) = (enter, exit)
        && known(first.order(last))? == Ordering::Greater
    {
        return Err(Stop::Miss);
    }
    let end = |t: Fraction<N>| End::at(t, Part::Side);
    let interval = Interval::new(enter.map_or_else(End::never_entered, end), exit.map_or_else(End::never_left, end));
    Ok(Intersection::LiesIn(span(&Flat, line, &interval, goal.range)?))
}
