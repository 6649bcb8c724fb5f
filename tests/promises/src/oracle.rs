//! The oracle is right: checked against definitions and sampled membership.
//!
//! Every random case is drawn from a seeded generator, on a coarse grid, so that degenerate lines are common.

use std::cmp::Ordering;

use dashu::rational::RBig;
use support::amount::times;
use support::oracle::{
    Answer, Approach, ConeExtent, CylinderExtent, Dyadic, End, HalfSpaces, Line, Membership, Part, Revolved, Root,
    RoundCone, RoundedCuboid, Solid, contains, exact_f64, solve,
};

/// SplitMix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, bound: u64) -> i64 {
        (self.next() % bound) as i64
    }

    /// Within -bound..=bound.
    pub(crate) fn within(&mut self, bound: i64) -> i64 {
        self.below(2 * bound as u64 + 1) - bound
    }

    /// A line with coordinates in halves from -3 to 3, its direction in small integers; one in four on whole numbers
    /// and along axes and diagonals, where walls and generators are.
    pub(crate) fn line(&mut self) -> Line {
        loop {
            let (origin, direction): ([Dyadic; 3], [Dyadic; 3]) = if self.below(4) == 0 {
                (
                    std::array::from_fn(|_| Dyadic::from(self.within(2))),
                    std::array::from_fn(|_| Dyadic::from(self.within(1))),
                )
            } else {
                (
                    std::array::from_fn(|_| Dyadic::new(self.within(6), -1)),
                    std::array::from_fn(|_| Dyadic::from(self.within(3))),
                )
            };
            if direction.iter().any(|component| !component.is_zero()) {
                return Line::new(origin, direction);
            }
        }
    }
}

pub(crate) fn number(value: f64) -> Dyadic {
    exact_f64(value)
}

pub(crate) fn line(origin: [f64; 3], direction: [f64; 3]) -> Line {
    Line::new(origin.map(number), direction.map(number))
}

pub(crate) fn sphere(radius: f64) -> Solid {
    Solid::Sphere { radius: number(radius) }
}

pub(crate) fn cylinder(radius: f64, extent: CylinderExtent) -> Solid {
    Solid::Cylinder { radius: number(radius), extent }
}

pub(crate) fn capped_cylinder(radius: f64, height: f64) -> Solid {
    cylinder(radius, CylinderExtent::Capped(number(height)))
}

pub(crate) fn cone(slope: f64, extent: ConeExtent) -> Solid {
    Solid::Cone { slope: number(slope), extent }
}

pub(crate) fn frustum(base_radius: f64, top_radius: f64, height: f64, capped: bool) -> Solid {
    Solid::Frustum { base_radius: number(base_radius), top_radius: number(top_radius), height: number(height), capped }
}

pub(crate) fn capsule(radius: f64, height: f64) -> Solid {
    Solid::Capsule { radius: number(radius), height: number(height) }
}

pub(crate) fn triangle(vertices: [[f64; 3]; 3]) -> Solid {
    Solid::Triangle { vertices: vertices.map(|vertex| vertex.map(number)) }
}

pub(crate) fn cuboid(half: [f64; 3]) -> Solid {
    Solid::Cuboid { half: half.map(number) }
}

/// Solids whose answers are spans.
fn prism(corners: &[[f64; 2]], height: f64) -> Solid {
    let corners: Vec<_> = corners.iter().map(|corner| corner.map(number)).collect();
    Solid::HalfSpaces(HalfSpaces::prism(&corners, &number(height)))
}

fn torus(major: f64, minor: f64) -> Solid {
    Solid::Torus { major: number(major), minor: number(minor) }
}

fn polyhedron(corners: [[f64; 3]; 2], facets: &[[[f64; 3]; 2]]) -> Solid {
    let [low, high] = corners.map(|corner| corner.map(number));
    let facets: Vec<_> = facets.iter().map(|facet| facet.map(|v| v.map(number))).collect();
    Solid::HalfSpaces(HalfSpaces::polyhedron([&low, &high], &facets))
}

pub(crate) fn solids() -> Vec<Solid> {
    vec![
        sphere(1.5),
        cylinder(1.0, CylinderExtent::Infinite),
        capped_cylinder(1.0, 2.0),
        capped_cylinder(2.5, 0.5),
        cone(1.0, ConeExtent::Double),
        cone(0.5, ConeExtent::Double),
        cone(1.0, ConeExtent::Nappe),
        cone(0.5, ConeExtent::Nappe),
        cone(1.0, ConeExtent::Capped(number(2.0))),
        cone(2.0, ConeExtent::Capped(number(1.0))),
        frustum(2.0, 1.0, 2.0, true),
        frustum(1.0, 2.0, 1.0, true),
        frustum(1.0, 1.0, 1.5, true),
        frustum(0.0, 1.0, 1.0, true),
        frustum(2.0, 0.0, 2.0, true),
        cuboid([1.0, 2.0, 1.0]),
        cuboid([2.0, 0.5, 1.5]),
        capsule(1.0, 2.0),
        capsule(1.5, 0.0),
        capsule(0.5, 1.0),
        torus(1.5, 0.5),
        torus(2.0, 1.0),
        torus(1.0, 0.75),
        prism(&[[1.0, 0.5], [1.0, -0.5], [0.0, -1.0], [-1.0, -0.5], [-1.0, 1.0]], 2.0),
        polyhedron(
            [[-1.0, 0.0, -1.0], [1.0, 2.0, 0.5]],
            &[[[1.0, 1.0, 0.0], [1.0, 1.0, 0.0]], [[0.0; 3], [-1.0, -1.0, 1.0]]],
        ),
    ]
}

/// Open sides, each with the solid that it becomes by adding caps.
pub(crate) fn open_and_capped() -> Vec<(Solid, Solid)> {
    let mut pairs = vec![];
    for (radius, height) in [(1.0, 2.0), (2.5, 0.5)] {
        pairs.push((cylinder(radius, CylinderExtent::Open(number(height))), capped_cylinder(radius, height)));
    }
    for (slope, height) in [(1.0, 2.0), (0.5, 2.0), (2.0, 1.0)] {
        pairs.push((cone(slope, ConeExtent::Open(number(height))), cone(slope, ConeExtent::Capped(number(height)))));
    }
    for (base, top, height) in [(2.0, 1.0, 2.0), (1.0, 2.0, 1.0), (1.0, 1.0, 1.5), (0.0, 1.0, 1.0), (2.0, 0.0, 2.0)] {
        pairs.push((frustum(base, top, height, false), frustum(base, top, height, true)));
    }
    pairs
}

/// A number `first + second * sqrt(radicand)`, with arithmetic of its own.
#[derive(Clone)]
pub(crate) struct Surd {
    first: RBig,
    second: RBig,
    radicand: RBig,
}

impl Surd {
    pub(crate) fn coordinate(line: &Line, t: &Root, axis: usize) -> Self {
        let (first, second, radicand) = t.parts();
        let factor = line.direction[axis].to_rational();
        Self { first: line.origin[axis].to_rational() + first * &factor, second: second * factor, radicand }
    }

    pub(crate) fn plus(&self, rational: RBig) -> Self {
        Self { first: &self.first + rational, ..self.clone() }
    }

    pub(crate) fn squared(&self) -> Self {
        Self {
            first: &self.first * &self.first + &self.second * &self.second * &self.radicand,
            second: RBig::from(2) * &self.first * &self.second,
            radicand: self.radicand.clone(),
        }
    }

    pub(crate) fn sum(&self, other: &Self) -> Self {
        Self {
            first: &self.first + &other.first,
            second: &self.second + &other.second,
            radicand: self.radicand.clone(),
        }
    }

    pub(crate) fn times(&self, factor: &RBig) -> Self {
        Self { first: &self.first * factor, second: &self.second * factor, radicand: self.radicand.clone() }
    }

    pub(crate) fn sign(&self) -> i32 {
        let sign = |value: &RBig| value.partial_cmp(&RBig::ZERO).unwrap() as i32;
        let (first, second) = (sign(&self.first), sign(&self.second) * sign(&self.radicand));
        if first * second >= 0 {
            return (first + second).signum();
        }
        let difference = &self.first * &self.first - &self.second * &self.second * &self.radicand;
        first * sign(&difference)
    }
}

/// Whether the point is on that face of the cuboid: inside of the others, and on none that owns the edge.
fn is_on_face(half: &[Dyadic; 3], part: Part, [x, y, z]: [&Surd; 3]) -> bool {
    // On which side of both faces across an axis it is.
    let beside = |c: &Surd, h: &Dyadic| [c.plus(-h.to_rational()).sign(), c.plus(h.to_rational()).sign()];
    let [x, y, z] = [(x, &half[0]), (y, &half[1]), (z, &half[2])].map(|(c, h)| beside(c, h));
    let inside = |[above, below]: [i32; 2]| above < 0 && below > 0;
    let within = |[above, below]: [i32; 2]| above <= 0 && below >= 0;
    match part {
        Part::Left => x[1] == 0 && within(y) && within(z),
        Part::Right => x[0] == 0 && within(y) && within(z),
        Part::Back => z[1] == 0 && inside(x) && within(y),
        Part::Front => z[0] == 0 && inside(x) && within(y),
        Part::Base => y[1] == 0 && inside(x) && inside(z),
        Part::Top => y[0] == 0 && inside(x) && inside(z),
        Part::Side | Part::Inner | Part::Facet(_) => false,
    }
}

/// Whether a point of this height, and of this square of the distance from the axis, is on the part of a quadric.
fn is_on_quadric(revolved: &Revolved, part: Part, from_axis: &Surd, y: &Surd) -> bool {
    let Revolved { a, b, r, low, high, capped } = revolved;
    // The square of the radius there, negated.
    let wider = y.squared().times(&-a.to_rational()).sum(&y.times(&-b.scaled(1).to_rational()));
    let wall = from_axis.sum(&wider.plus(-r.squared().to_rational())).sign();
    let above = |height: &Dyadic| y.plus(-height.to_rational()).sign();
    match part {
        Part::Side => wall == 0 && above(low) >= 0 && above(high) <= 0,
        Part::Base => *capped && above(low) == 0 && wall < 0,
        Part::Top => *capped && above(high) == 0 && wall < 0,
        _ => false,
    }
}

/// Whether such a point is on the part of a rounded cuboid.
fn is_on_rounded_cuboid(cuboid: &RoundedCuboid, part: Part, point: [&Surd; 3]) -> bool {
    let radius = cuboid.radius.to_rational();
    // Zero, as a number along the line.
    let zero = point[0].times(&RBig::ZERO);
    let mut square = zero.plus(-(&radius * &radius));
    let sides = [0, 1, 2].map(|axis: usize| {
        let half = cuboid.half[axis].to_rational();
        for (side, plane) in [(1_i8, half.clone()), (-1, -half)] {
            let beyond = point[axis].plus(-plane);
            if beyond.sign() == i32::from(side) {
                square = square.sum(&beyond.squared());
                return side;
            }
        }
        0
    });
    square.sign() == 0 && RoundedCuboid::part_of(sides) == part
}

/// Whether such a point is on the part of a round cone.
fn is_on_round_cone(cone: &RoundCone, part: Part, from_axis: &Surd, y: &Surd) -> bool {
    let square = |value: &Dyadic| value.to_rational() * value.to_rational();
    let ball = |radius: &Dyadic, y: &Surd| from_axis.sum(&y.squared()).plus(-square(radius)).sign() == 0;
    if let Some((of, radius, centre)) = cone.ball() {
        return part == of && ball(radius, &y.plus(-centre.to_rational()));
    }
    let [low, high] = cone.seams().map(|seam| y.times(&cone.height.to_rational()).plus(-seam.to_rational()).sign());
    match part {
        Part::Base => low < 0 && ball(&cone.base_radius, y),
        Part::Top => high > 0 && ball(&cone.top_radius, &y.plus(-cone.height.to_rational())),
        Part::Side => {
            let [w, v] = cone.cone_at(&Dyadic::zero()).map(|c| c.to_rational());
            let v = y.times(&-cone.difference().to_rational()).plus(v);
            v.squared().sum(&from_axis.times(&-w)).sign() == 0 && low >= 0 && high <= 0
        }
        _ => false,
    }
}

/// Whether such a point is on the part of a tube.
fn is_on_tube([inner, outer, height]: [&Dyadic; 3], part: Part, from_axis: &Surd, y: &Surd) -> bool {
    let [hole, wall] = [inner, outer].map(|radius| {
        let radius = radius.to_rational();
        from_axis.plus(-(radius.clone() * radius)).sign()
    });
    let [above, below] = [y.sign(), y.plus(-height.to_rational()).sign()];
    match part {
        Part::Side => wall == 0 && above >= 0 && below <= 0,
        Part::Inner => hole == 0 && above >= 0 && below <= 0,
        Part::Base => above == 0 && wall < 0 && hole > 0,
        Part::Top => below == 0 && wall < 0 && hole > 0,
        _ => false,
    }
}

/// Whether such a point is on its own face's plane, within all others, and inside of those that come before it.
fn is_on_half_spaces(of: &HalfSpaces, part: Part, [x, y, z]: [&Surd; 3]) -> bool {
    let mut is_before = true;
    of.faces.iter().all(|face| {
        let [nx, ny, nz] = face.normal.each_ref().map(Dyadic::to_rational);
        let inside = face.margin(&[(); 3].map(|()| Dyadic::zero())).to_rational();
        let beyond = x.times(&nx).sum(&y.times(&ny)).sum(&z.times(&nz)).plus(-inside).sign();
        let is_own = face.part == part;
        is_before &= !is_own;
        if is_own {
            beyond == 0
        } else if is_before {
            beyond < 0
        } else {
            beyond <= 0
        }
    })
}

/// Whether the equation of a torus is zero as nearly as it must be so near to the point at `t`.
fn is_on_torus([major, minor]: [&Dyadic; 2], line: &Line, t: &Root) -> bool {
    let [x, y, z] = line.point_at(&t.enclosure(200).0);
    let [across, square] = [&x.squared() + &z.squared(), major.squared()];
    let power = &(&(&across + &y.squared()) - &square) - &minor.squared();
    let value = &power.squared() + &(&square.scaled(2) * &(&y.squared() - &minor.squared()));
    value.magnitude() < Dyadic::power_of_two(-160)
}

/// Whether the point at `t` is on the part named, by that part's own equation.
pub(crate) fn is_on_part(solid: &Solid, part: Part, line: &Line, t: &Root) -> bool {
    if let Solid::Torus { major, minor } = solid {
        return part == Part::Side && is_on_torus([major, minor], line, t);
    }
    let [x, y, z] = [0, 1, 2].map(|axis| Surd::coordinate(line, t, axis));
    let from_axis = x.squared().sum(&z.squared());
    let square = |value: &Dyadic| value.to_rational() * value.to_rational();
    let level = |height: &Dyadic| y.plus(-height.to_rational());
    let within = |height: &Dyadic| y.sign() >= 0 && level(height).sign() <= 0;
    // The wall's equation, and the cap's radius squared less the point's distance from the axis squared.
    match solid {
        Solid::Sphere { radius } => part == Part::Side && from_axis.sum(&y.squared()).plus(-square(radius)).sign() == 0,
        Solid::Cylinder { radius, extent } => {
            let wall = from_axis.plus(-square(radius)).sign();
            match (part, extent) {
                (Part::Side, CylinderExtent::Infinite) => wall == 0,
                (Part::Side, CylinderExtent::Open(h) | CylinderExtent::Capped(h)) => wall == 0 && within(h),
                (Part::Base, CylinderExtent::Capped(_)) => y.sign() == 0 && wall < 0,
                (Part::Top, CylinderExtent::Capped(h)) => level(h).sign() == 0 && wall < 0,
                _ => false,
            }
        }
        Solid::Cone { slope, extent } => {
            let wall = from_axis.sum(&y.squared().times(&-square(slope))).sign();
            match (part, extent) {
                (Part::Side, ConeExtent::Double) => wall == 0,
                (Part::Side, ConeExtent::Nappe) => wall == 0 && y.sign() >= 0,
                (Part::Side, ConeExtent::Open(h) | ConeExtent::Capped(h)) => wall == 0 && within(h),
                (Part::Top, ConeExtent::Capped(h)) => level(h).sign() == 0 && wall < 0,
                _ => false,
            }
        }
        Solid::Frustum { base_radius, top_radius, height, capped } => {
            let slope = (top_radius - base_radius).to_rational() / height.to_rational();
            let reach = y.times(&slope).plus(base_radius.to_rational());
            let wall = from_axis.sum(&reach.squared().times(&RBig::from(-1))).sign();
            match part {
                Part::Side => wall == 0 && within(height),
                Part::Base => *capped && y.sign() == 0 && wall < 0,
                Part::Top => *capped && level(height).sign() == 0 && wall < 0,
                _ => false,
            }
        }
        Solid::Capsule { radius, height } => {
            let round = |y: &Surd| from_axis.sum(&y.squared()).plus(-square(radius)).sign() == 0;
            match part {
                Part::Side => within(height) && from_axis.plus(-square(radius)).sign() == 0,
                Part::Base => y.sign() < 0 && round(&y),
                Part::Top => level(height).sign() > 0 && round(&level(height)),
                _ => false,
            }
        }
        Solid::Revolved(revolved) => is_on_quadric(revolved, part, &from_axis, &y),
        Solid::RoundCone(cone) => is_on_round_cone(cone, part, &from_axis, &y),
        Solid::Tube { inner, outer, height } => is_on_tube([inner, outer, height], part, &from_axis, &y),
        Solid::Annulus { inner, outer } => {
            let [hole, rim] = [inner, outer].map(|radius| from_axis.plus(-square(radius)).sign());
            y.sign() == 0 && rim <= 0 && hole >= 0
        }
        Solid::Torus { .. } => unreachable!("its crossings are no square roots"),
        Solid::Plane => y.sign() == 0,
        Solid::Disc { radius } => y.sign() == 0 && from_axis.plus(-square(radius)).sign() <= 0,
        Solid::Rectangle { half: [along_x, along_z] } => {
            let is_between =
                |c: &Surd, h: &Dyadic| c.plus(-h.to_rational()).sign() <= 0 && c.plus(h.to_rational()).sign() >= 0;
            y.sign() == 0 && is_between(&x, along_x) && is_between(&z, along_z)
        }
        Solid::Cuboid { half } => is_on_face(half, part, [&x, &y, &z]),
        Solid::RoundedCuboid(cuboid) => is_on_rounded_cuboid(cuboid, part, [&x, &y, &z]),
        Solid::HalfSpaces(of) => is_on_half_spaces(of, part, [&x, &y, &z]),
        Solid::Triangle { vertices } => {
            // Barycentric: the point on either side of each edge, by the coordinates that are left when one is dropped.
            let v = vertices.each_ref().map(|vertex| vertex.each_ref().map(Dyadic::to_rational));
            let p = [x, y, z];
            let mut projections = 0;
            for drop in 0..3 {
                let (i, j) = ((drop + 1) % 3, (drop + 2) % 3);
                let area =
                    (&v[1][i] - &v[0][i]) * (&v[2][j] - &v[0][j]) - (&v[2][i] - &v[0][i]) * (&v[1][j] - &v[0][j]);
                let orientation = area.partial_cmp(&RBig::ZERO).unwrap() as i32;
                if orientation == 0 {
                    continue;
                }
                projections += 1;
                for k in 0..3 {
                    let (a, b) = (&v[k], &v[(k + 1) % 3]);
                    let turn = p[j]
                        .plus(-a[j].clone())
                        .times(&(&b[i] - &a[i]))
                        .sum(&p[i].plus(-a[i].clone()).times(&(&a[j] - &b[j])));
                    if turn.sign() * orientation < 0 {
                        return false;
                    }
                }
            }
            // In the plane: the point's volume with the triangle is zero.
            let volume = (0..3)
                .map(|axis| {
                    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                    let area =
                        (&v[1][i] - &v[0][i]) * (&v[2][j] - &v[0][j]) - (&v[2][i] - &v[0][i]) * (&v[1][j] - &v[0][j]);
                    p[axis].plus(-v[0][axis].clone()).times(&area)
                })
                .reduce(|sum, next| sum.sum(&next))
                .unwrap();
            projections > 0 && volume.sign() == 0
        }
    }
}

/// Parameters to sample: a grid, and a little to either side of everything reported.
pub(crate) fn samples(reported: &[Root]) -> Vec<Dyadic> {
    let mut samples: Vec<Dyadic> = (-96..=96).map(|step| Dyadic::new(step, -3)).collect();
    let little = Dyadic::power_of_two(-40);
    for t in reported {
        let (low, high) = t.enclosure(90);
        samples.extend([&low - &little, low, high.clone(), &high + &little]);
    }
    samples
}

pub(crate) fn ends(answer: &Answer) -> Vec<(Root, Part)> {
    match answer {
        Answer::Spans(spans) => spans
            .iter()
            .flat_map(|span| [&span.enter, &span.exit])
            .flatten()
            .map(|end| (end.t.clone(), end.part))
            .collect(),
        Answer::Crossings(crossings) => crossings.iter().map(|crossing| (crossing.t.clone(), crossing.part)).collect(),
        Answer::Coincident { from, to } => [from, to].into_iter().flatten().map(|t| (t.clone(), Part::Side)).collect(),
    }
}

pub(crate) fn parameters(answer: &Answer) -> Vec<Root> {
    ends(answer).into_iter().map(|(t, _)| t).collect()
}

pub(crate) fn reaches(from: Option<&Root>, to: Option<&Root>, t: &Dyadic) -> bool {
    from.is_none_or(|from| from.cmp_dyadic(t) != Ordering::Greater)
        && to.is_none_or(|to| to.cmp_dyadic(t) != Ordering::Less)
}

#[test]
fn spans_are_the_parameters_of_the_points_that_belong_to_the_solid() {
    let mut random = Random(1);
    let (mut touches, mut pairs, mut coincidences) = (0, 0, 0);
    for _ in 0..times(1200) {
        let line = random.line();
        for solid in solids() {
            let answer = solve(&solid, &line);
            for t in samples(&parameters(&answer)) {
                // The roots of a torus are rounded, unless they have few bits.
                let is_root = || parameters(&answer).iter().any(|end| end.cmp_dyadic(&t) == Ordering::Equal);
                let is_rounded = |point| contains(&solid, &point) != Membership::OnSurface;
                if matches!(solid, Solid::Torus { .. }) && is_root() && is_rounded(line.point_at(&t)) {
                    continue;
                }
                let membership = contains(&solid, &line.point_at(&t));
                let expected = match &answer {
                    Answer::Spans(spans) => spans.iter().any(|span| {
                        let t_of = |end: &Option<End>| end.as_ref().map(|end| end.t.clone());
                        reaches(t_of(&span.enter).as_ref(), t_of(&span.exit).as_ref(), &t)
                    }),
                    Answer::Coincident { from, to } => reaches(from.as_ref(), to.as_ref(), &t),
                    Answer::Crossings(_) => panic!("{solid:?} is a solid"),
                };
                assert_eq!(
                    membership != Membership::Outside,
                    expected,
                    "{solid:?}\n{line:?}\nat {t:?}: {membership:?}, but {answer:?}"
                );
                if membership == Membership::Inside {
                    assert!(parameters(&answer).iter().all(|end| end.cmp_dyadic(&t) != Ordering::Equal));
                    assert!(!matches!(answer, Answer::Coincident { .. }));
                }
            }
            match &answer {
                Answer::Spans(spans) => {
                    touches += spans.iter().filter(|span| span.is_touch()).count();
                    pairs += spans.len();
                    assert!(parameters(&answer).is_sorted());
                    let is_convex =
                        !matches!(&solid, Solid::Cone { extent: ConeExtent::Double, .. } | Solid::Torus { .. });
                    assert!(spans.len() < 2 || !is_convex && spans.len() < 3);
                }
                _ => coincidences += 1,
            }
        }
    }
    // The grid must be coarse enough to bring these about.
    assert!(touches > 50 && pairs > 1000 && coincidences > 5, "{touches} {pairs} {coincidences}");
}

#[test]
fn ends_lie_on_the_part_that_they_name() {
    let mut random = Random(2);
    let mut found = [0; 12];
    for _ in 0..times(1200) {
        let line = random.line();
        let flat = [
            Solid::Plane,
            Solid::Disc { radius: number(2.0) },
            Solid::Rectangle { half: [2.0, 1.0].map(number) },
            triangle([[-2.0, 0.0, -1.0], [2.0, 0.0, -1.0], [0.0, 0.0, 2.0]]),
            triangle([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]),
        ];
        let open = open_and_capped().into_iter().map(|(open, _)| open);
        for solid in solids().into_iter().chain(flat).chain(open) {
            for (t, part) in ends(&solve(&solid, &line)) {
                let index = match part {
                    Part::Side => 0,
                    Part::Base => 1,
                    Part::Top => 2,
                    Part::Left => 3,
                    Part::Right => 4,
                    Part::Back => 5,
                    Part::Front => 6,
                    Part::Inner => unreachable!("no tube is among them"),
                    Part::Facet(number) => 7 + usize::from(number).min(4),
                };
                found[index] += 1;
                assert!(is_on_part(&solid, part, &line, &t), "{solid:?}\n{line:?}\n{part:?} at {t:?}");
            }
        }
    }
    let (others, facets) = found.split_at(7);
    assert!(others.iter().all(|&count| count > 200) && facets.iter().all(|&count| count > 40), "{found:?}");
}

#[test]
fn an_open_side_is_met_where_the_capped_solid_is_met_on_its_side() {
    let mut random = Random(3);
    let mut coincidences = 0;
    for _ in 0..times(3000) {
        let line = random.line();
        for (open, capped) in open_and_capped() {
            let answer = solve(&open, &line);
            let solid = solve(&capped, &line);
            let mut of_side: Vec<Root> =
                ends(&solid).into_iter().filter(|(_, part)| *part == Part::Side).map(|(t, _)| t).collect();
            if let Answer::Coincident { from, to } = &answer {
                coincidences += 1;
                assert_eq!(of_side, [from.clone().unwrap(), to.clone().unwrap()]);
                continue;
            }
            of_side.dedup();
            assert_eq!(parameters(&answer), of_side, "{open:?}\n{line:?}");
        }
    }
    assert!(coincidences > 20, "{coincidences}");
}

/// The region that an open side bounds when it is continued: 1 inside, 0 on it, -1 outside.
pub(crate) fn side_of_continued(open: &Solid, [x, y, z]: &[Dyadic; 3]) -> i8 {
    let from_axis = &x.squared() + &z.squared();
    let (weight, reach) = match open {
        Solid::Cylinder { radius, .. } => (Dyadic::from(1), radius.clone()),
        Solid::Cone { slope, .. } => (Dyadic::from(1), slope * y),
        Solid::Frustum { base_radius, top_radius, height, .. } => {
            (height.clone(), &(base_radius * &(height - y)) + &(top_radius * y))
        }
        _ => panic!("{open:?} is not an open side"),
    };
    if reach.signum() < 0 {
        return -1;
    }
    (&reach.squared() - &(&weight.squared() * &from_axis)).signum()
}

#[test]
fn crossings_go_the_way_they_say() {
    let mut random = Random(4);
    let mut found = [0; 3];
    let little = Dyadic::power_of_two(-40);
    for _ in 0..times(2000) {
        let line = random.line();
        for (open, _) in open_and_capped() {
            let Answer::Crossings(crossings) = solve(&open, &line) else {
                continue;
            };
            for crossing in crossings {
                let (low, high) = crossing.t.enclosure(90);
                let before = side_of_continued(&open, &line.point_at(&(&low - &little)));
                let after = side_of_continued(&open, &line.point_at(&(&high + &little)));
                let expected = match crossing.side {
                    Approach::FromOutside => (-1, 1),
                    Approach::FromInside => (1, -1),
                    Approach::Touch => (-1, -1),
                };
                found[crossing.side as usize] += 1;
                assert_eq!((before, after), expected, "{open:?}\n{line:?}\n{crossing:?}");
            }
        }
    }
    assert!(found.iter().all(|&count| count > 100), "{found:?}");
}

#[test]
fn flat_surfaces_are_met_where_their_points_are() {
    let surfaces = [
        (Solid::Plane, [0.0, 1.0, 0.0]),
        (Solid::Disc { radius: number(2.0) }, [0.0, 1.0, 0.0]),
        (Solid::Rectangle { half: [2.0, 1.0].map(number) }, [0.0, 1.0, 0.0]),
        (triangle([[-2.0, 0.0, -1.0], [2.0, 0.0, -1.0], [0.0, 0.0, 2.0]]), [0.0, -1.0, 0.0]),
        (triangle([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]), [1.0, 1.0, 1.0]),
    ];
    let mut random = Random(5);
    let (mut crossings, mut coincidences) = (0, 0);
    for _ in 0..times(20_000) {
        let line = random.line();
        for (surface, facing) in &surfaces {
            let facing = facing.map(number);
            let along: Dyadic =
                (0..3).map(|axis| &facing[axis] * &line.direction[axis]).reduce(|sum, next| &sum + &next).unwrap();
            let answer = solve(surface, &line);
            match &answer {
                Answer::Crossings(found) => {
                    crossings += found.len();
                    for crossing in found {
                        let expected = if along.signum() < 0 { Approach::FromOutside } else { Approach::FromInside };
                        assert_eq!(crossing.side, expected);
                        assert_ne!(along.signum(), 0);
                    }
                }
                Answer::Coincident { .. } => coincidences += 1,
                Answer::Spans(_) => panic!("{surface:?} encloses nothing"),
            }
            // A crossing on the grid of samples is a point of the surface, and no other sample is.
            for step in -12..=12 {
                let t = Dyadic::new(step, -2);
                let reported = match &answer {
                    Answer::Coincident { from, to } => reaches(from.as_ref(), to.as_ref(), &t),
                    _ => parameters(&answer).iter().any(|at| at.cmp_dyadic(&t) == Ordering::Equal),
                };
                let belongs = contains(surface, &line.point_at(&t)) == Membership::OnSurface;
                assert_eq!(belongs, reported, "{surface:?}\n{line:?}\nat {t:?}: {answer:?}");
            }
        }
    }
    assert!(crossings > 5000 && coincidences > 500, "{crossings} {coincidences}");
}
