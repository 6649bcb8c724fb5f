//! The exact point of a hit on its surface, and the surface's gradient there.

use super::form::{Ball, Cone, Form, Homogeneous, Line, Quadric, Tube, Weight};
use crate::equations::{Described, EquationKinds, Equations, Extent};
use crate::hit::{Crossing, Hit};
use crate::number::{Estimate, Ring, cross, difference, dot};
use crate::part::Part;
use crate::scalar::{FromScalar, Scalar};
use core::cmp::Ordering;

/// The surface that a part lies on.
enum Surface<N> {
    Quadric(Form<N>),
    /// At this height.
    Across(N),
    /// Through a point, with a normal of any length.
    Plane([N; 3], [N; 3]),
}

/// The surface of a part, and the height of its centre.
fn surface_of<S: Copy, N: Ring, G: Described>(
    equations: &Equations<S>,
    part: Part,
    number: impl Fn(S) -> N + Copy,
) -> (Surface<N>, N) {
    let (zero, kind) = (N::ZERO, G::EQUATIONS);
    let ball = |radius: S| Surface::Quadric(Form::Ball(Ball { r: number(radius) }));
    let surface = match *equations {
        Equations::Ball { radius } if kind.has(EquationKinds::BALL) => ball(radius),
        Equations::Capsule { radius, height } if kind.has(EquationKinds::CAPSULE) => match part {
            Part::Base => ball(radius),
            Part::Top => return (ball(radius), number(height)),
            _ => Surface::Quadric(Form::Tube(Tube { r: number(radius) })),
        },
        Equations::DoubleCone { slope } if kind.has(EquationKinds::DOUBLE_CONE) => {
            Surface::Quadric(Form::Cone(Cone::slope(number(slope))))
        }
        Equations::Round { side, extent } if kind.has(EquationKinds::TUBE.and(EquationKinds::CONE)) => {
            match (extent, part) {
                (_, Part::Side) => Surface::Quadric(Form::of_side::<S, G>(side, number)),
                (Extent::Open(height) | Extent::Capped(_, Some(height)), Part::Top) => Surface::Across(number(height)),
                _ => Surface::Across(zero),
            }
        }
        Equations::Triangle { vertices } if kind.has(EquationKinds::TRIANGLE) => {
            let [a, b, c] = vertices.map(|vertex| vertex.map(number));
            Surface::Plane(a, cross(difference(b, a), difference(c, a)))
        }
        Equations::Cuboid { half } if kind.has(EquationKinds::CUBOID) => {
            let [x, y, z] = half;
            let one = N::ONE;
            let (vertex, normal) = match part {
                Part::Left => ([-number(x), zero, zero], [-one, zero, zero]),
                Part::Right => ([number(x), zero, zero], [one, zero, zero]),
                Part::Back => ([zero, zero, -number(z)], [zero, zero, -one]),
                Part::Front => ([zero, zero, number(z)], [zero, zero, one]),
                Part::Base => ([zero, -number(y), zero], [zero, -one, zero]),
                Part::Top | Part::Side => ([zero, number(y), zero], [zero, one, zero]),
            };
            Surface::Plane(vertex, normal)
        }
        // A plane, a disc or a rectangle; the geometry has none of the others.
        Equations::Ball { .. }
        | Equations::Capsule { .. }
        | Equations::Round { .. }
        | Equations::DoubleCone { .. }
        | Equations::Plane
        | Equations::Disc { .. }
        | Equations::Cuboid { .. }
        | Equations::Rectangle { .. }
        | Equations::Triangle { .. } => Surface::Across(zero),
    };
    (surface, zero)
}

/// If `a f` is smaller than `h^2` by this many bits, `-f / 2 h` is the root with a relative error of as many bits.
const SMALL: i32 = 36;

/// `numerator / denominator`; zero if the denominator is zero.
fn quotient<N: Estimate>(numerator: N, denominator: N) -> N {
    if denominator.sign() == Some(Ordering::Equal) { N::ZERO } else { numerator.over(denominator) }
}

/// The value of the equation `f` of a part's surface at a point, negative inside. For a flat part it is twice the
/// distance times the length of its [`gradient`].
pub(crate) fn value<S: Copy, N: Ring, G: Described>(
    equations: &Equations<S>,
    part: Part,
    [x, y, z]: [N; 3],
    number: impl Fn(S) -> N + Copy,
) -> N {
    let (surface, centre) = surface_of::<S, N, G>(equations, part, number);
    let p = [x, y - centre, z];
    match surface {
        Surface::Across(height) => {
            let above = p[1] - height;
            let outside = if part == Part::Base { -above } else { above };
            outside + outside
        }
        Surface::Plane(vertex, normal) => {
            let distance = dot(normal, difference(p, vertex));
            distance + distance
        }
        Surface::Quadric(form) => {
            let here = Homogeneous { v: p, w: Weight::One };
            form.at(here)
        }
    }
}

/// The correction `x` of the `t` of a point `p` on the line along `d`, so that the point lies on the surface: the root
/// of `f(t + x) = f + 2 h x + a x^2` at which `f` decreases, if the line enters, or increases, if it leaves.
pub(crate) fn correction<S: Scalar, N: FromScalar<S> + Estimate, G: Described>(
    equations: &Equations<S>,
    hit: &Hit<S>,
    p: [N; 3],
    d: [N; 3],
) -> N {
    let f = value::<S, N, G>(equations, hit.part, p, N::scalar);
    let h = dot(gradient::<S, N, G>(equations, hit.part, p, N::scalar), d);
    let (Surface::Quadric(form), _) = surface_of::<S, N, G>(equations, hit.part, N::scalar) else {
        return quotient(-f, h + h);
    };
    let along = Homogeneous { v: d, w: Weight::Zero };
    let a = form.at(along);
    let is_zero = |n: N| n.sign() == Some(Ordering::Equal);
    if hit.crossing == Crossing::Touch || is_zero(h) && is_zero(a) {
        return touched(equations, p, d, [f, h, a]);
    }
    // If the curvature is negligible, the slope alone gives the correction.
    if let (Some(f_top), Some(h_top), Some(a_top)) = (f.top(), h.top(), a.top())
        && a_top + f_top < 2 * h_top - SMALL
    {
        return quotient(-f, h + h);
    }
    let rest = N::sum([[h, h], [-a, f]]);
    let root = if rest.sign() == Some(Ordering::Greater) { rest.square_root() } else { N::ZERO };
    // Half the slope at the root.
    let slope = if hit.crossing == Crossing::Enter { -root } else { root };
    // (slope - h) / a, or -f / (slope + h): whichever does not cancel.
    if slope.sign() == h.sign() { quotient(-f, slope + h) } else { quotient(slope - h, a) }
}

/// The correction of the `t` of a touch, or of a line in the surface. A line touches a surface where
/// `f + 2 h x + a x^2` is least, or a solid at a rim, where the line crosses the surface beyond the solid: of the
/// vertex and of the points at the rims' heights, the one at which `f` is nearest to zero.
fn touched<S: Scalar, N: FromScalar<S> + Estimate>(
    equations: &Equations<S>,
    p: [N; 3],
    d: [N; 3],
    [f, h, a]: [N; 3],
) -> N {
    let magnitude = |n: N| if n.sign() == Some(Ordering::Less) { -n } else { n };
    let is_less = |n: N, m: N| magnitude(n).compare(magnitude(m)) == Some(Ordering::Less);
    let value = |x: N| N::sum([[f, N::ONE], [h + h, x], [a * x, x]]);
    let is_along = d[1].sign() == Some(Ordering::Equal);
    let rims = match *equations {
        Equations::Round { extent: Extent::Open(height), .. } if !is_along => [Some(S::ZERO), Some(height)],
        Equations::Round { extent: Extent::Capped(low, high), .. } if !is_along => [low, high],
        _ => [None; 2],
    };
    let vertex = (a.sign() != Some(Ordering::Equal)).then(|| (-h).over(a));
    let crossings = rims.map(|rim| rim.map(|height| (N::scalar(height) - p[1]).over(d[1])));
    let mut best: Option<[N; 2]> = None;
    for x in crossings.into_iter().chain([vertex]).flatten() {
        let value = value(x);
        // Of points that are on the surface alike, the nearest.
        let is_better =
            best.is_none_or(|[nearest, least]| is_less(value, least) || !is_less(least, value) && is_less(x, nearest));
        if is_better {
            best = Some([x, value]);
        }
    }
    best.map_or(N::ZERO, |[x, _]| x)
}

/// The form of the direction on a part's surface, `a` in `f(t + x) = f + 2 h x + a x^2`; zero for a flat part.
pub(crate) fn bending<S: Copy, N: Ring, G: Described>(
    equations: &Equations<S>,
    part: Part,
    d: [N; 3],
    number: impl Fn(S) -> N + Copy,
) -> N {
    match surface_of::<S, N, G>(equations, part, number).0 {
        Surface::Quadric(form) => form.at(Homogeneous { v: d, w: Weight::Zero }),
        Surface::Across(_) | Surface::Plane(..) => N::ZERO,
    }
}

/// The line's point at `t`.
pub(crate) fn point_at<N: Ring>(line: &Line<N>, t: N) -> [N; 3] {
    let at = |i: usize| N::sum([[line.origin[i], N::ONE], [line.direction[i], t]]);
    [at(0), at(1), at(2)]
}

/// The outward normal at a point of a part, half the gradient of its equation; zero at an apex.
pub(crate) fn gradient<S: Copy, N: Ring, G: Described>(
    equations: &Equations<S>,
    part: Part,
    [x, y, z]: [N; 3],
    number: impl Fn(S) -> N + Copy,
) -> [N; 3] {
    let (surface, centre) = surface_of::<S, N, G>(equations, part, number);
    let zero = N::ZERO;
    match surface {
        Surface::Quadric(Form::Ball(_)) => [x, y - centre, z],
        Surface::Quadric(Form::Tube(_)) => [x, zero, z],
        Surface::Quadric(Form::Cone(cone @ Cone { h, g1, .. })) => {
            let g = cone.outline(Homogeneous { v: [x, y, z], w: Weight::One });
            let hh = h * h;
            [hh * x, -(g1 * g), hh * z]
        }
        Surface::Across(_) => [zero, if part == Part::Base { -N::ONE } else { N::ONE }, zero],
        Surface::Plane(_, normal) => normal,
    }
}
