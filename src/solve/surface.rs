//! The exact point of a hit on its surface, and the surface's gradient there.

use super::polyhedra::{half_space, over_edge};
use super::quadric::{Ball, Cylinder, Nappe, Profile, Quadric, Revolution, Tangent};
use super::rounded::piece;
use super::side::planes_through;
use super::torus::Torus;
use crate::equations::{Described, EquationKinds, Equations};
use crate::hit::{Crossing, Hit};
use crate::number::{Estimate, Ring, cross, difference, dot};
use crate::outline::Extent;
use crate::part::Part;
use crate::scalar::{FromScalar, Scalar};
use core::cmp::Ordering;

/// A line in a primitive's frame. Its direction may have any length, since `t` is the parameter of the ray as stored.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line<N> {
    pub(crate) origin: [N; 3],
    pub(crate) direction: [N; 3],
}

impl<N: Ring> Line<N> {
    /// A point alone: its direction is zero.
    #[inline(always)]
    pub(crate) const fn at(point: [N; 3]) -> Self {
        Self { origin: point, direction: [N::ZERO; 3] }
    }
}

/// The surface that a part lies on along the line `p + x d`: `f(p + x d) = f + 2 h x + a x^2`, negative inside. For a
/// flat part `f` is twice the distance times the length of the [`gradient`](Self::gradient).
pub(crate) enum Surface<N> {
    Ball(Ball<N>),
    Cylinder(Cylinder<N>),
    /// A cylinder with the inside of the solid around it.
    Inner(Cylinder<N>),
    Nappe(Nappe<N>, Profile<N>),
    Revolution(Revolution<N>),
    Tangent(Tangent<N>),
    /// Only up to the second order.
    Torus(Torus<N>),
    /// A plane perpendicular to an axis, with the inside below it.
    Face(Face<N>),
    /// A plane by its normal, of any length; from a point of it to `p`; and `d`.
    Plane([[N; 3]; 3]),
}

/// A plane perpendicular to an axis.
pub(crate) struct Face<N> {
    axis: usize,
    /// True if its normal points along the axis, false if against it.
    is_along: bool,
    /// The distance of `p` along the normal, and its growth along the line.
    distance: [N; 2],
}

impl<N: Ring> Surface<N> {
    /// `f` at `p`, negative inside.
    #[inline(always)]
    pub(crate) fn value(&self) -> N {
        let distance = match *self {
            Self::Ball(ball) => return ball.c(),
            Self::Cylinder(cylinder) => return cylinder.c(),
            Self::Inner(cylinder) => return -cylinder.c(),
            Self::Nappe(nappe, _) => return nappe.c(),
            Self::Revolution(revolution) => return revolution.c(),
            Self::Tangent(cone) => return cone.c(),
            Self::Torus(torus) => return torus.value(),
            Self::Face(Face { distance: [distance, _], .. }) => distance,
            Self::Plane([normal, from, _]) => dot(normal, from),
        };
        distance + distance
    }

    /// `h`, the scalar product of the [`gradient`](Self::gradient) (half of that of `f`) and the direction.
    #[inline(always)]
    pub(crate) fn slope(&self) -> N {
        match *self {
            Self::Ball(ball) => ball.k(),
            Self::Cylinder(cylinder) => cylinder.k(),
            Self::Inner(cylinder) => -cylinder.k(),
            Self::Nappe(nappe, _) => nappe.k(),
            Self::Revolution(revolution) => revolution.k(),
            Self::Tangent(cone) => cone.k(),
            Self::Torus(torus) => torus.slope(),
            Self::Face(Face { distance: [_, growth], .. }) => growth,
            Self::Plane([normal, _, d]) => dot(normal, d),
        }
    }

    /// `a`, the quadratic part of `f` at the direction; zero for a flat part.
    #[inline(always)]
    pub(crate) fn bending(&self) -> N {
        match *self {
            Self::Ball(ball) => ball.a(),
            Self::Cylinder(cylinder) => cylinder.a(),
            Self::Inner(cylinder) => -cylinder.a(),
            Self::Nappe(nappe, _) => nappe.a(),
            Self::Revolution(revolution) => revolution.a(),
            Self::Tangent(cone) => cone.a(),
            Self::Torus(torus) => torus.bending(),
            Self::Face(_) | Self::Plane(_) => N::ZERO,
        }
    }

    /// Half the gradient of `f` at `p`: an outward normal; zero at an apex.
    #[inline(always)]
    pub(crate) fn gradient(&self) -> [N; 3] {
        let zero = N::ZERO;
        match *self {
            Self::Ball(Ball { o, .. }) => o,
            Self::Cylinder(Cylinder { o: [x, z], .. }) => [x, zero, z],
            Self::Inner(Cylinder { o: [x, z], .. }) => [-x, zero, -z],
            Self::Nappe(Nappe { o: [x, z, g], .. }, Profile { growth, h, .. }) => [h * x, -(growth * g), h * z],
            Self::Revolution(revolution) => revolution.gradient(),
            Self::Tangent(cone) => cone.gradient(),
            Self::Torus(torus) => torus.gradient(),
            Self::Face(Face { axis, is_along, .. }) => {
                let component = if is_along { N::ONE } else { -N::ONE };
                core::array::from_fn(|i| if i == axis { component } else { zero })
            }
            Self::Plane([normal, ..]) => normal,
        }
    }
}

/// The surface of a part along a line.
#[inline(always)]
pub(crate) fn surface_of<S: Scalar, N: Ring, G: Described>(
    equations: &Equations<S>,
    part: Part,
    line: &Line<N>,
    number: impl Fn(S) -> N + Copy,
) -> Surface<N> {
    let (zero, kind) = (N::ZERO, G::EQUATIONS);
    let (p, d) = (line.origin, line.direction);
    let ball = |radius: S, height: N| {
        let [x, y, z] = p;
        Surface::Ball(Ball { o: [x, y - height, z], d, r: number(radius) })
    };
    let cylinder = |radius: S| Surface::Cylinder(Cylinder::along(p, d, number(radius)));
    // The planes at a coordinate along an axis, with a normal along it or against it.
    let along =
        |axis: usize, [p, d]: [N; 2], at: N| Surface::Face(Face { axis, is_along: true, distance: [p - at, d] });
    let against =
        |axis: usize, [p, d]: [N; 2], at: N| Surface::Face(Face { axis, is_along: false, distance: [at - p, -d] });
    let [x, y, z] = [[p[0], d[0]], [p[1], d[1]], [p[2], d[2]]];
    // A face of the box between two corners.
    let face = |low: [N; 3], high: [N; 3]| match part {
        Part::Left => against(0, x, low[0]),
        Part::Right => along(0, x, high[0]),
        Part::Base => against(1, y, low[1]),
        Part::Back => against(2, z, low[2]),
        Part::Front => along(2, z, high[2]),
        _ => along(1, y, high[1]),
    };
    match *equations {
        Equations::Ball { radius } if kind.has(EquationKinds::BALL) => ball(radius, zero),
        Equations::Capsule { radius, height } if kind.has(EquationKinds::CAPSULE) => match part {
            Part::Base => ball(radius, zero),
            Part::Top => ball(radius, number(height)),
            _ => cylinder(radius),
        },
        Equations::RoundCone { radii: [base, top], height } if kind.has(EquationKinds::ROUND_CONE) => match part {
            Part::Base => ball(base, zero),
            Part::Top => ball(top, number(height)),
            _ => Surface::Tangent(Tangent::along(p, d, [number(base), number(height), number(base) - number(top)])),
        },
        Equations::Cylinder { radius, .. } if kind.has(EquationKinds::CYLINDER) && part == Part::Side => {
            cylinder(radius)
        }
        Equations::Cone { outline, .. } if kind.has(EquationKinds::CONE) && part == Part::Side => {
            let profile = Profile::of(outline, number);
            Surface::Nappe(Nappe::along(p, d, profile), profile)
        }
        Equations::Cylinder { extent, .. } | Equations::Cone { extent, .. }
            if kind.has(EquationKinds::CYLINDER.and(EquationKinds::CONE)) =>
        {
            match (extent, part) {
                (Extent::Open(height) | Extent::Capped(height), Part::Top) => along(1, y, number(height)),
                _ => against(1, y, zero),
            }
        }
        Equations::Revolved { meridian } if kind.has(EquationKinds::REVOLVED) => match (part, meridian.heights) {
            (Part::Base, [low, _]) => against(1, y, number(low)),
            (Part::Top, [_, high]) => along(1, y, number(high)),
            _ => Surface::Revolution(Revolution::along(p, d, &meridian, number)),
        },
        Equations::Tube { radii: [inner, outer], height } if kind.has(EquationKinds::TUBE) => match part {
            Part::Base => against(1, y, zero),
            Part::Top => along(1, y, number(height)),
            Part::Inner => Surface::Inner(Cylinder::along(p, d, number(inner))),
            _ => cylinder(outer),
        },
        Equations::Triangle { vertices } if kind.has(EquationKinds::TRIANGLE) => {
            let [a, b, c] = vertices.map(|vertex| vertex.map(number));
            Surface::Plane([cross(difference(b, a), difference(c, a)), difference(p, a), d])
        }
        Equations::Cuboid { half } if kind.has(EquationKinds::CUBOID) => {
            let half = half.map(number);
            face(half.map(|h| -h), half)
        }
        Equations::RoundedCuboid { half, radius, region } if kind.has(EquationKinds::ROUNDED_CUBOID) => {
            let (half, r) = (half.map(number), number(radius));
            if matches!(part, Part::Side | Part::Inner) {
                Surface::Ball(piece(p, d, half, r, region))
            } else {
                face(half.map(|h| -h - r), half.map(|h| h + r))
            }
        }
        Equations::Prism { polygon, height } if kind.has(EquationKinds::PRISM) => match polygon.edge(part) {
            Some(edge) => Surface::Plane(over_edge(edge, [p, d], number)),
            None => {
                if part == Part::Base {
                    against(1, y, zero)
                } else {
                    along(1, y, number(height))
                }
            }
        },
        Equations::Polyhedron { solid } if kind.has(EquationKinds::POLYHEDRON) => {
            let [low, high] = solid.corners.map(|corner| corner.map(number));
            let facet = solid.facet(part).map(|facet| Surface::Plane(half_space(facet, [p, d], number)));
            facet.unwrap_or_else(|| face(low, high))
        }
        Equations::Torus { radii } if kind.has(EquationKinds::TORUS) => {
            Surface::Torus(Torus { o: p, d, radii: radii.map(number) })
        }
        // A plane, a disc, an annulus or a rectangle; the geometry has none of the others.
        _ => along(1, y, zero),
    }
}

/// If `a f` is smaller than `h^2` by this many bits, `-f / 2 h` is the root with a relative error of as many bits.
const SMALL: i32 = 36;

/// `numerator / denominator`; zero if the denominator is zero.
fn quotient<N: Estimate>(numerator: N, denominator: N) -> N {
    if denominator.sign() == Some(Ordering::Equal) { N::ZERO } else { numerator.over(denominator) }
}

/// The correction `x` of the `t` of the line's origin, so that the point lies on the surface: the root of
/// `f(t + x) = f + 2 h x + a x^2` at which `f` decreases, if the line enters, or increases, if it leaves.
pub(crate) fn correction<S: Scalar, N: FromScalar<S> + Estimate, G: Described>(
    equations: &Equations<S>,
    hit: &Hit<S>,
    line: &Line<N>,
) -> N {
    let surface = surface_of::<S, N, G>(equations, hit.part, line, N::scalar);
    let (f, h) = (surface.value(), surface.slope());
    if matches!(surface, Surface::Face(_) | Surface::Plane(_)) {
        return quotient(-f, h + h);
    }
    let a = surface.bending();
    let is_zero = |n: N| n.sign() == Some(Ordering::Equal);
    if hit.crossing == Crossing::Touch || is_zero(h) && is_zero(a) {
        return touched::<S, N, G>(equations, line, [f, h, a]);
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
fn touched<S: Scalar, N: FromScalar<S> + Estimate, G: Described>(
    equations: &Equations<S>,
    line: &Line<N>,
    [f, h, a]: [N; 3],
) -> N {
    let (y, dy) = (line.origin[1], line.direction[1]);
    let magnitude = |n: N| if n.sign() == Some(Ordering::Less) { -n } else { n };
    let is_less = |n: N, m: N| magnitude(n).compare(magnitude(m)) == Some(Ordering::Less);
    let value = |x: N| N::sum([[f, N::ONE], [h + h, x], [a * x, x]]);
    let rims = if dy.sign() == Some(Ordering::Equal) { [None; 2] } else { planes_through::<S, G>(equations) };
    let vertex = (a.sign() != Some(Ordering::Equal)).then(|| (-h).over(a));
    let crossings = rims.map(|rim| rim.map(|height| (N::scalar(height) - y).over(dy)));
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

/// The line's point at `t`.
pub(crate) fn point_at<N: Ring>(line: &Line<N>, t: N) -> [N; 3] {
    let at = |i: usize| N::sum([[line.origin[i], N::ONE], [line.direction[i], t]]);
    [at(0), at(1), at(2)]
}
