//! The oracle is right: checked against definitions, sampled membership, high-precision enclosures and known answers.
//!
//! Every random case is drawn from a seeded generator, on a coarse grid, so that degenerate lines are common.

use std::cmp::Ordering;

use dashu::integer::IBig;
use dashu::rational::RBig;
use support::amount::times;
use support::oracle::{
    Answer, Approach, ConeExtent, CylinderExtent, Dyadic, End, ExpectedCrossing, Line, Membership, Part, Root, Solid,
    contains, exact_f32, exact_f64, exact_fixed, gradient, hits_in_range, margin, normal, solve,
};

/// SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: u64) -> i64 {
        (self.next() % bound) as i64
    }

    /// Within -bound..=bound.
    fn within(&mut self, bound: i64) -> i64 {
        self.below(2 * bound as u64 + 1) - bound
    }

    /// A line with coordinates in halves from -3 to 3, its direction in small integers; one in four on whole numbers
    /// and along axes and diagonals, where walls and generators are.
    fn line(&mut self) -> Line {
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

fn number(value: f64) -> Dyadic {
    exact_f64(value)
}

fn line(origin: [f64; 3], direction: [f64; 3]) -> Line {
    Line::new(origin.map(number), direction.map(number))
}

fn sphere(radius: f64) -> Solid {
    Solid::Sphere { radius: number(radius) }
}

fn cylinder(radius: f64, extent: CylinderExtent) -> Solid {
    Solid::Cylinder { radius: number(radius), extent }
}

fn capped_cylinder(radius: f64, height: f64) -> Solid {
    cylinder(radius, CylinderExtent::Capped(number(height)))
}

fn cone(slope: f64, extent: ConeExtent) -> Solid {
    Solid::Cone { slope: number(slope), extent }
}

fn frustum(base_radius: f64, top_radius: f64, height: f64, capped: bool) -> Solid {
    Solid::Frustum { base_radius: number(base_radius), top_radius: number(top_radius), height: number(height), capped }
}

fn capsule(radius: f64, height: f64) -> Solid {
    Solid::Capsule { radius: number(radius), height: number(height) }
}

fn triangle(vertices: [[f64; 3]; 3]) -> Solid {
    Solid::Triangle { vertices: vertices.map(|vertex| vertex.map(number)) }
}

/// Solids whose answers are spans.
fn solids() -> Vec<Solid> {
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
        capsule(1.0, 2.0),
        capsule(1.5, 0.0),
        capsule(0.5, 1.0),
    ]
}

/// Open sides, each with the solid that it becomes by adding caps.
fn open_and_capped() -> Vec<(Solid, Solid)> {
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
struct Surd {
    first: RBig,
    second: RBig,
    radicand: RBig,
}

impl Surd {
    fn coordinate(line: &Line, t: &Root, axis: usize) -> Self {
        let (first, second, radicand) = t.parts();
        let factor = line.direction[axis].to_rational();
        Self { first: line.origin[axis].to_rational() + first * &factor, second: second * factor, radicand }
    }

    fn plus(&self, rational: RBig) -> Self {
        Self { first: &self.first + rational, ..self.clone() }
    }

    fn squared(&self) -> Self {
        Self {
            first: &self.first * &self.first + &self.second * &self.second * &self.radicand,
            second: RBig::from(2) * &self.first * &self.second,
            radicand: self.radicand.clone(),
        }
    }

    fn sum(&self, other: &Self) -> Self {
        Self {
            first: &self.first + &other.first,
            second: &self.second + &other.second,
            radicand: self.radicand.clone(),
        }
    }

    fn times(&self, factor: &RBig) -> Self {
        Self { first: &self.first * factor, second: &self.second * factor, radicand: self.radicand.clone() }
    }

    fn sign(&self) -> i32 {
        let sign = |value: &RBig| value.partial_cmp(&RBig::ZERO).unwrap() as i32;
        let (first, second) = (sign(&self.first), sign(&self.second) * sign(&self.radicand));
        if first * second >= 0 {
            return (first + second).signum();
        }
        let difference = &self.first * &self.first - &self.second * &self.second * &self.radicand;
        first * sign(&difference)
    }
}

/// Whether the point at `t` is on the part named, by that part's own equation.
fn is_on_part(solid: &Solid, part: Part, line: &Line, t: &Root) -> bool {
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
            }
        }
        Solid::Capsule { radius, height } => {
            let round = |y: &Surd| from_axis.sum(&y.squared()).plus(-square(radius)).sign() == 0;
            match part {
                Part::Side => within(height) && from_axis.plus(-square(radius)).sign() == 0,
                Part::Base => y.sign() < 0 && round(&y),
                Part::Top => level(height).sign() > 0 && round(&level(height)),
            }
        }
        Solid::Plane => y.sign() == 0,
        Solid::Disc { radius } => y.sign() == 0 && from_axis.plus(-square(radius)).sign() <= 0,
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
fn samples(reported: &[Root]) -> Vec<Dyadic> {
    let mut samples: Vec<Dyadic> = (-96..=96).map(|step| Dyadic::new(step, -3)).collect();
    let little = Dyadic::power_of_two(-40);
    for t in reported {
        let (low, high) = t.enclosure(90);
        samples.extend([&low - &little, low, high.clone(), &high + &little]);
    }
    samples
}

fn ends(answer: &Answer) -> Vec<(Root, Part)> {
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

fn parameters(answer: &Answer) -> Vec<Root> {
    ends(answer).into_iter().map(|(t, _)| t).collect()
}

fn reaches(from: Option<&Root>, to: Option<&Root>, t: &Dyadic) -> bool {
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
                    assert!(spans.len() < 2 || matches!(&solid, Solid::Cone { extent: ConeExtent::Double, .. }));
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
    let mut found = [0; 3];
    for _ in 0..times(1200) {
        let line = random.line();
        let flat = [
            Solid::Plane,
            Solid::Disc { radius: number(2.0) },
            triangle([[-2.0, 0.0, -1.0], [2.0, 0.0, -1.0], [0.0, 0.0, 2.0]]),
            triangle([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]),
        ];
        let open = open_and_capped().into_iter().map(|(open, _)| open);
        for solid in solids().into_iter().chain(flat).chain(open) {
            for (t, part) in ends(&solve(&solid, &line)) {
                found[part as usize] += 1;
                assert!(is_on_part(&solid, part, &line, &t), "{solid:?}\n{line:?}\n{part:?} at {t:?}");
            }
        }
    }
    assert!(found.iter().all(|&count| count > 500), "{found:?}");
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
fn side_of_continued(open: &Solid, [x, y, z]: &[Dyadic; 3]) -> i8 {
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

#[test]
fn lines_and_solids_scale_together() {
    // Far apart exponents leave the answer alone, but for the unit of the direction.
    let mut random = Random(6);
    for _ in 0..times(300) {
        let line = random.line();
        let scaled =
            Line::new(line.origin.each_ref().map(|x| x.scaled(-90)), line.direction.each_ref().map(|x| x.scaled(70)));
        let back = Dyadic::power_of_two(160);
        for (solid, small) in [
            (capsule(1.5, 2.0), capsule(1.5 * 2f64.powi(-90), 2f64.powi(-89))),
            (frustum(2.0, 1.0, 2.0, true), frustum(2f64.powi(-89), 2f64.powi(-90), 2f64.powi(-89), true)),
            (cone(0.5, ConeExtent::Capped(number(2.0))), cone(0.5, ConeExtent::Capped(number(2f64.powi(-89))))),
        ] {
            let expected = ends(&solve(&solid, &line));
            let found = ends(&solve(&small, &scaled));
            assert_eq!(expected.len(), found.len());
            for ((t, part), (small_t, small_part)) in expected.iter().zip(&found) {
                assert_eq!(*t, small_t.mul_add(&back, &Dyadic::zero()));
                assert_eq!(part, small_part);
            }
        }
    }
}

#[test]
fn normals_are_unit_and_face_outwards() {
    let mut random = Random(7);
    let little = Dyadic::power_of_two(-60);
    let mut checked = 0;
    for _ in 0..times(300) {
        let line = random.line();
        for solid in solids() {
            let Answer::Spans(spans) = solve(&solid, &line) else {
                continue;
            };
            for (end, entering) in spans
                .iter()
                .flat_map(|span| [(&span.enter, true), (&span.exit, false)])
                .filter_map(|(end, entering)| Some((end.as_ref()?, entering)))
            {
                let facing = normal(&solid, end.part, &end.t, &line);
                let square = facing.iter().map(Dyadic::squared).reduce(|sum, next| &sum + &next).unwrap();
                let excess = (&square - &Dyadic::from(1)).magnitude();
                assert!(excess < Dyadic::power_of_two(-110), "{facing:?}");
                let longer = gradient(&solid, end.part, &end.t, &line);
                assert!((0..3).all(|axis| longer[axis].signum() == facing[axis].signum()));
                // A little along the normal from the point is outside, whatever part shares the point.
                let point: [Dyadic; 3] =
                    std::array::from_fn(|axis| line.coordinate_at(&end.t, axis).approximation(200));
                let beyond: [Dyadic; 3] = std::array::from_fn(|axis| &point[axis] + &(&little * &facing[axis]));
                // But at the apex of a double cone, where the axis leads into the other nappe.
                let double = matches!(&solid, Solid::Cone { extent: ConeExtent::Double, .. });
                if double && line.coordinate_at(&end.t, 1).signum() == 0 {
                    continue;
                }
                assert_eq!(contains(&solid, &beyond), Membership::Outside, "{solid:?}\n{line:?}\n{end:?}");
                let along =
                    (0..3).map(|axis| &facing[axis] * &line.direction[axis]).reduce(|sum, next| &sum + &next).unwrap();
                // At a rim the line may come in by way of the cap, against the side's normal.
                let smooth = matches!(solid, Solid::Sphere { .. } | Solid::Capsule { .. });
                if smooth && along.magnitude() > Dyadic::power_of_two(-100) {
                    assert_eq!(along.signum() < 0, entering, "{solid:?}\n{line:?}\n{end:?}");
                }
                // The normal is that of the tangent plane: the surface leaves it only in the second order.
                let lateral = matches!(solid, Solid::Cone { .. } | Solid::Frustum { .. });
                if lateral && end.part == Part::Side && !facing[0].is_zero() {
                    let across = [facing[2].clone(), Dyadic::zero(), -&facing[0]];
                    let zero = &(&across[0] * &facing[0]) + &(&across[2] * &facing[2]);
                    assert!(zero.magnitude() < Dyadic::power_of_two(-110));
                }
                checked += 1;
            }
        }
    }
    assert!(checked > 2000, "{checked}");
}

#[test]
fn normals_of_known_points() {
    let close = |found: &[Dyadic; 3], expected: [f64; 3]| {
        for axis in 0..3 {
            assert!((found[axis].to_f64() - expected[axis]).abs() < 1e-15, "{found:?} {expected:?}");
        }
    };
    let across = line([3.0, 1.0, 0.0], [-1.0, 0.0, 0.0]);
    let half = 0.5f64.sqrt();
    let first = |solid: &Solid, line: &Line| {
        let (t, part) = ends(&solve(solid, line)).remove(0);
        normal(solid, part, &t, line)
    };
    close(&first(&cone(1.0, ConeExtent::Nappe), &across), [half, -half, 0.0]);
    close(&first(&cone(1.0, ConeExtent::Double), &line([3.0, -1.0, 0.0], [-1.0, 0.0, 0.0])), [half, half, 0.0]);
    close(&first(&frustum(2.0, 0.0, 2.0, true), &across), [half, half, 0.0]);
    close(&first(&frustum(0.0, 4.0, 2.0, true), &across), [0.2f64.sqrt(), -0.8f64.sqrt(), 0.0]);
    close(&first(&cylinder(1.0, CylinderExtent::Infinite), &line([0.6, 1.0, 5.0], [0.0, 0.0, -1.0])), [0.6, 0.0, 0.8]);
    let above = line([0.25, 9.0, 0.0], [0.0, -1.0, 0.0]);
    close(&first(&capped_cylinder(1.0, 2.0), &above), [0.0, 1.0, 0.0]);
    close(&first(&capped_cylinder(1.0, 2.0), &line([0.25, -9.0, 0.0], [0.0, 1.0, 0.0])), [0.0, -1.0, 0.0]);
    // Apexes face along the axis, away from the body.
    let through = line([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    close(&first(&cone(1.0, ConeExtent::Nappe), &through), [0.0, -1.0, 0.0]);
    close(&first(&frustum(1.0, 0.0, 2.0, true), &line([-1.0, 2.0, 0.0], [1.0, 0.0, 0.0])), [0.0, 1.0, 0.0]);
    close(&first(&capsule(1.0, 2.0), &line([0.0, 9.0, 0.75], [0.0, -1.0, 0.0])), [0.0, (1.0f64 - 0.5625).sqrt(), 0.75]);
}

fn random_root(random: &mut Random) -> Root {
    let rational = |random: &mut Random, bound| RBig::from(random.within(bound)) / RBig::from(random.below(4) + 1);
    let square_class = RBig::from([0, 1, 2, 3, 8][random.below(5) as usize]);
    let factor = rational(random, 3);
    let q = loop {
        let q = rational(random, 4);
        if q != RBig::ZERO {
            break q;
        }
    };
    let d = square_class * &factor * factor;
    Root::from_rationals(&rational(random, 5), random.within(1) as i8, &d, &q)
}

#[test]
fn roots_compare_as_their_enclosures_do() {
    let mut random = Random(8);
    let mut found = [0; 3];
    for _ in 0..times(40_000) {
        let (left, right) = (random_root(&mut random), random_root(&mut random));
        let ((left_low, left_high), (right_low, right_high)) = (left.enclosure(400), right.enclosure(400));
        // Numbers of this size are equal, or much further apart than their enclosures are wide.
        let expected = if left_high < right_low {
            Ordering::Less
        } else if left_low > right_high {
            Ordering::Greater
        } else {
            Ordering::Equal
        };
        found[(expected as i8 + 1) as usize] += 1;
        assert_eq!(left.cmp(&right), expected, "{left:?} {right:?}");
        assert_eq!((-&left).cmp(&-&right), expected.reverse());
        assert_eq!(left.signum() as i32, left.cmp_rational(&RBig::ZERO) as i32);
    }
    assert!(found.iter().all(|&count| count > 300), "{found:?}");
}

#[test]
fn roots_that_differ_by_almost_nothing_are_told_apart() {
    let root_two = Root::from_rationals(&RBig::ZERO, 1, &RBig::from(2), &RBig::ONE);
    for bits in [10, 100, 1000] {
        let (low, high) = root_two.enclosure(bits);
        assert!(low < high);
        assert_eq!(root_two.cmp_dyadic(&low), Ordering::Greater);
        assert_eq!(root_two.cmp_dyadic(&high), Ordering::Less);
        let square = low.squared();
        let nearly = Root::from_rationals(&RBig::ZERO, 1, &square.to_rational(), &RBig::ONE);
        assert_eq!(nearly, Root::from(&low));
        let tripled = Root::from_rationals(&RBig::from(1), 1, &RBig::from(18), &RBig::from(3));
        let shifted = root_two.mul_add(&Dyadic::from(3), &Dyadic::from(1));
        assert_eq!(tripled.mul_add(&Dyadic::from(3), &Dyadic::zero()), shifted);
        let other = Root::from_rationals(&RBig::from(1), 1, &(square.to_rational() * RBig::from(9)), &RBig::from(3));
        assert_eq!(other.cmp(&tripled), Ordering::Less);
    }
}

#[test]
fn enclosures_hold_the_number_and_are_as_narrow_as_asked() {
    let mut random = Random(9);
    for round in 0..times(20_000) {
        let root = random_root(&mut random);
        // Cancellation: less a number close to itself.
        let root = if round % 2 == 0 { root } else { root.mul_add(&Dyadic::from(1), &-&root.approximation(30)) };
        for bits in [1, 24, 120] {
            let (low, high) = root.enclosure(bits);
            assert!(root.cmp_dyadic(&low) != Ordering::Less && root.cmp_dyadic(&high) != Ordering::Greater);
            let widest = low.magnitude().min(high.magnitude()).scaled(-(bits as isize));
            assert!(&high - &low <= widest, "{root:?} {bits} {low:?} {high:?}");
        }
    }
}

#[test]
fn multiples_round_to_nearest_and_ties_to_even() {
    let one = Dyadic::from(1);
    for (value, expected) in [
        (0.5, 0),
        (1.5, 2),
        (2.5, 2),
        (-0.5, 0),
        (-1.5, -2),
        (-2.5, -2),
        (3.0, 3),
        (-3.0, -3),
        (0.0, 0),
        (2.51, 3),
        (-2.49, -2),
    ] {
        assert_eq!(Root::from(&number(value)).nearest_multiple(&one), IBig::from(expected), "{value}");
    }
    let mut random = Random(10);
    for _ in 0..times(20_000) {
        let root = random_root(&mut random);
        let unit = Dyadic::new(random.below(3) + 1, -random.below(40) as isize + 3);
        let multiple = Dyadic::new(root.nearest_multiple(&unit), 0);
        let off = root.error_in(&(&multiple * &unit), &unit);
        assert!(off <= 0.5, "{root:?} {unit:?} {multiple:?} {off}");
        let exact_off = root.mul_add(&one, &-&(&multiple * &unit)).magnitude();
        assert_ne!(exact_off.cmp_dyadic(&unit.scaled(-1)), Ordering::Greater);
    }
}

#[test]
fn units_in_the_last_place_are_the_spacing_of_floats() {
    let mut random = Random(11);
    for _ in 0..times(20_000) {
        let value = f32::from_bits(random.next() as u32 & 0x7fff_ffff);
        if !value.is_finite() || value == f32::MAX {
            continue;
        }
        let spacing = &exact_f32(value.next_up()) - &exact_f32(value);
        let exact = exact_f32(value);
        assert_eq!(Root::from(&exact).ulp_f32(), spacing);
        assert_eq!(Root::from(&-&exact).ulp_f32(), spacing);
        // Just under the next float the spacing is still the same.
        let under = &exact_f32(value.next_up()) - &spacing.scaled(-90);
        assert_eq!(Root::from(&under).ulp_f32(), spacing);
        let value = f64::from_bits(random.next() >> 1);
        if value.is_finite() && value < f64::MAX {
            let spacing = &exact_f64(value.next_up()) - &exact_f64(value);
            assert_eq!(Root::from(&exact_f64(value)).ulp_f64(), spacing);
        }
    }
    let two = Root::from_rationals(&RBig::ZERO, 1, &RBig::from(4), &RBig::ONE);
    assert_eq!(two.ulp_f32(), Dyadic::power_of_two(-22));
    let root = Root::from_rationals(&RBig::ZERO, 1, &RBig::from(2), &RBig::ONE);
    assert_eq!(root.ulp_f32(), Dyadic::power_of_two(-23));
    let nearest = exact_f32(std::f32::consts::SQRT_2);
    let expected = (f64::from(std::f32::consts::SQRT_2) - std::f64::consts::SQRT_2).abs() * 2f64.powi(23);
    assert!((root.error_in(&nearest, &root.ulp_f32()) - expected).abs() < 1e-8);
    assert_eq!(Root::from(&Dyadic::zero()).ulp_f64(), exact_f64(5e-324));
}

#[test]
fn machine_numbers_convert_exactly() {
    let mut random = Random(12);
    for _ in 0..times(20_000) {
        let bits = random.next();
        let wide = f64::from_bits(bits);
        if wide.is_finite() {
            assert_eq!(exact_f64(wide).to_f64(), wide);
        }
        let narrow = f32::from_bits(bits as u32);
        if narrow.is_finite() {
            assert_eq!(exact_f32(narrow), exact_f64(f64::from(narrow)));
        }
        let raw = i64::from(bits as i32);
        assert_eq!(exact_fixed(raw.into(), 16).to_f64(), raw as f64 / 65536.0);
    }
    assert_eq!(exact_f32(f32::from_bits(1)), Dyadic::power_of_two(-149));
    assert_eq!(exact_fixed(-3, 1).to_rational(), RBig::from(-3) / RBig::from(2));
    assert_eq!(exact_fixed(i128::MIN, 127), Dyadic::from(-1));
}

/// The ends are at the parameters given, to `f64`, on the parts given.
#[track_caller]
fn expect(solid: &Solid, line: &Line, expected: &[(f64, Part)]) {
    let answer = solve(solid, line);
    let found = ends(&answer);
    assert_eq!(found.len(), expected.len(), "{answer:?}");
    for ((t, part), (expected_t, expected_part)) in found.iter().zip(expected) {
        let t = t.to_f64();
        assert!((t - expected_t).abs() <= expected_t.abs() * 3e-16, "{t:.20} {expected_t:.20}");
        assert_eq!(part, expected_part);
    }
}

#[test]
#[allow(clippy::excessive_precision, reason = "the digits are those of the list of hard cases")]
fn hard_cases_have_their_known_answers() {
    use Part::{Base, Side, Top};
    // Numbered as in the list of hard cases; those of decimal or other poses are scaled and moved into this one.
    expect(
        &sphere(1.0),
        &line([-4100.0, 0.5, 0.0], [1.0, 0.0, 0.0]),
        &[(4099.1339745962156, Side), (4100.8660254037844, Side)],
    );
    expect(
        &sphere(100.0),
        &line([-400e3, 95.0, 0.0], [1e3, 0.0, 0.0]),
        &[(399.96877501000801, Side), (400.03122498999199, Side)],
    );
    expect(&sphere(6.4e6), &line([0.0, 0.0, 6.4e6 + 1.0], [0.0, 0.0, -1.0]), &[(1.0, Side), (12_800_001.0, Side)]);
    // 4
    let grazing = line([-0.5, -0.5, 0.0], [1.0, 0.0, 0.0]);
    expect(&sphere(0.5), &grazing, &[(0.5, Side), (0.5, Side)]);
    let hits = hits_in_range(&solve(&sphere(0.5), &grazing), &Dyadic::zero(), None).hits;
    assert_eq!(hits.len(), 1);
    assert_eq!(hits[0].crossing, ExpectedCrossing::Touch);
    let past = solve(&sphere(0.5), &line([0.125, -0.5, 0.0], [1.0, 0.0, 0.0]));
    assert!(hits_in_range(&past, &Dyadic::zero(), None).hits.is_empty());
    // 5
    expect(&capped_cylinder(1e20, 1.0), &line([-2e20, 0.5, 0.0], [1e20, 0.0, 0.0]), &[(1.0, Side), (3.0, Side)]);
    // 6
    expect(&capped_cylinder(1.0, 2.0), &line([0.5, 1.0, 0.0], [2f64.powi(-24), 1.0, 0.0]), &[(-1.0, Base), (1.0, Top)]);
    // 7
    let near_parallel = line([10001.0, 1e6, 0.0], [-10.0, -2e6, 0.0]);
    // The list prints .449867752; that is what the inputs rounded to `f32` give. The decimals themselves give this.
    let near = ends(&solve(&capsule(1e4, 1e5), &near_parallel)).remove(0);
    assert!((near.0.to_f64() - 0.44986774899900603).abs() < 1e-15 && near.1 == Top);
    // 8
    expect(&capped_cylinder(1.0, 2.0), &line([1.0, 1.0, 0.0], [0.0, 1.0, 0.0]), &[(-1.0, Side), (1.0, Side)]);
    expect(&capped_cylinder(1.0, 2.0), &line([1.0f64.next_up(), 1.0, 0.0], [0.0, 1.0, 0.0]), &[]);
    expect(
        &capped_cylinder(1.0, 2.0),
        &line([1.0f64.next_down(), 1.0, 0.0], [0.0, 1.0, 0.0]),
        &[(-1.0, Base), (1.0, Top)],
    );
    // 9
    expect(
        &capped_cylinder(1.0, 2.0),
        &line([2.0, 2.0, 0.5], [-1.0, 0.0, 0.0]),
        &[(1.1339745962155614, Side), (2.8660254037844384, Side)],
    );
    // 10
    expect(&capped_cylinder(1.0, 2.0), &line([2.0, 3.0, 0.0], [-1.0, -1.0, 0.0]), &[(1.0, Side), (3.0, Side)]);
    // 11
    expect(&capsule(1.0, 2.0), &line([2.0, 2.0, 0.0], [-1.0, 0.0, 0.0]), &[(1.0, Side), (3.0, Side)]);
    // 12: the axis scaled by a third, and t by the root of 13.
    let length = 13f64.sqrt();
    for (radial, axial, expected) in [
        (-3.0, -1.0, 4.5069390943299866),
        (-1.0, -1.0, 2.704163456597992),
        (1.0, 1.0, -2.704163456597992),
        (3.0, 1.0, -4.5069390943299866),
    ] {
        let answer = solve(&cone(2.0, ConeExtent::Double), &line([radial, axial, 0.0], [2.0, 1.0, 0.0]));
        let found = ends(&answer);
        assert_eq!(found.len(), 1);
        assert!((found[0].0.to_f64() * length - expected).abs() < 1e-14);
    }
    // 13
    let nappe = cone(1.0, ConeExtent::Nappe);
    expect(&nappe, &line([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]), &[(1.0, Side), (1.0, Side)]);
    expect(&nappe, &line([1.0, 0.0, 0.0], [-1.0, 1.0, 0.0]), &[(0.5, Side)]);
    let downwards = line([1.0, 0.0, 0.0], [-1.0, -1.0, 0.0]);
    expect(&nappe, &downwards, &[]);
    expect(&cone(1.0, ConeExtent::Double), &downwards, &[(0.5, Side)]);
    // 14
    let steep = cone(0.5, ConeExtent::Nappe);
    expect(
        &steep,
        &line([-1e6, 10.0, 1.0], [1e4, 0.0, 0.0]),
        &[(99.999510102051443, Side), (100.00048989794856, Side)],
    );
    expect(&steep, &line([-1e6, 0.0, 10.0], [1e4, 0.0, 0.0]), &[]);
    // 15
    expect(
        &sphere(1.0),
        &line([25001.0 / 25000.0, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        &[(25001.0 / 25000.0 - 1.0, Side), (25001.0 / 25000.0 + 1.0, Side)],
    );
    // Through the apex within both nappes; along the axis.
    expect(&cone(1.0, ConeExtent::Double), &line([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]), &[(1.0, Side), (1.0, Side)]);
    expect(
        &cone(1.0, ConeExtent::Capped(number(3.0))),
        &line([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
        &[(1.0, Side), (4.0, Top)],
    );
    // In the surface.
    let slanted = line([-1.0, -1.0, 0.0], [1.0, 1.0, 0.0]);
    for (solid, from, to) in [
        (cylinder(1.0, CylinderExtent::Infinite), None, None),
        (cylinder(1.0, CylinderExtent::Open(number(2.0))), Some(0.0), Some(2.0)),
    ] {
        let answer = solve(&solid, &line([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
        let bound = |t: Option<f64>| t.map(|t| Root::from(&number(t)));
        assert_eq!(answer, Answer::Coincident { from: bound(from), to: bound(to) });
    }
    for (extent, from, to) in [
        (ConeExtent::Double, None, None),
        (ConeExtent::Nappe, Some(1.0), None),
        (ConeExtent::Open(number(2.0)), Some(1.0), Some(3.0)),
    ] {
        let bound = |t: Option<f64>| t.map(|t| Root::from(&number(t)));
        assert_eq!(solve(&cone(1.0, extent), &slanted), Answer::Coincident { from: bound(from), to: bound(to) });
    }
    // A triangle's corner touched by a line in its plane.
    let corner = solve(
        &triangle([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
        &line([-1.0, 0.0, 1.0], [1.0, 0.0, -1.0]),
    );
    let one = Some(Root::from(&number(1.0)));
    assert_eq!(corner, Answer::Coincident { from: one.clone(), to: one });
}

#[test]
fn ranges_are_closed_and_drop_what_lies_outside() {
    let answer = solve(&sphere(1.0), &line([-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]));
    let kinds = |lo: f64, hi: Option<f64>| {
        let found = hits_in_range(&answer, &number(lo), hi.map(number).as_ref());
        let kinds: Vec<_> = found.hits.iter().map(|hit| hit.crossing).collect();
        (kinds, found.starts_inside)
    };
    use ExpectedCrossing::{Enter, Exit};
    assert_eq!(kinds(0.0, None), (vec![Enter, Exit], false));
    assert_eq!(kinds(1.0, Some(3.0)), (vec![Enter, Exit], false));
    assert_eq!(kinds(1.0f64.next_up(), None), (vec![Exit], true));
    assert_eq!(kinds(3.0, None), (vec![Exit], true));
    assert_eq!(kinds(3.0f64.next_up(), None), (vec![], false));
    assert_eq!(kinds(0.0, Some(3.0f64.next_down())), (vec![Enter], false));
    assert_eq!(kinds(2.0, Some(2.5)), (vec![], true));
    let wall = solve(&cylinder(1.0, CylinderExtent::Open(number(2.0))), &line([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
    assert!(hits_in_range(&wall, &number(2.0), None).coincident);
    assert!(!hits_in_range(&wall, &number(2.5), None).coincident);
    let axis = solve(&cylinder(1.0, CylinderExtent::Infinite), &line([0.0; 3], [0.0, 1.0, 0.0]));
    assert!(hits_in_range(&axis, &Dyadic::zero(), None).starts_inside);
}

#[test]
fn margins_tell_how_near_grazing_a_line_is() {
    let across = line([-9.0, 1.0, 0.5], [2.0, 0.0, 0.0]);
    assert_eq!(margin(&sphere(1.25f64), &line([-9.0, 0.0, 1.25], [2.0, 0.0, 0.0])), Some(1.0));
    assert_eq!(margin(&capped_cylinder(1.0, 2.0), &across), Some(0.5));
    assert_eq!(margin(&cone(1.0, ConeExtent::Nappe), &across), Some(0.5));
    assert_eq!(margin(&capped_cylinder(2.0, 2.0), &line([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])), Some(0.5));
    assert_eq!(margin(&Solid::Plane, &across), None);
}

/// Prints what a solve costs; run with `--release -- --ignored --nocapture`.
#[test]
#[ignore = "measures, and asserts nothing"]
fn cost_of_a_solve() {
    let mut random = Random(13);
    let lines: Vec<Line> = (0..20_000)
        .map(|_| {
            let mut coordinate = |scale: f32| exact_f32((random.next() as i32 as f32) * 2f32.powi(-31) * scale);
            let origin: [Dyadic; 3] = std::array::from_fn(|_| coordinate(20.0));
            let target: [Dyadic; 3] = std::array::from_fn(|_| coordinate(1.5));
            let direction: [Dyadic; 3] =
                std::array::from_fn(|axis| exact_f32((target[axis].to_f64() - origin[axis].to_f64()) as f32 / 17.0));
            Line::new(origin, direction)
        })
        .collect();
    let open = open_and_capped().into_iter().map(|(open, _)| open);
    let flat = [
        Solid::Plane,
        Solid::Disc { radius: number(2.0) },
        triangle([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]),
    ];
    for solid in solids().into_iter().chain(open).chain(flat) {
        let start = std::time::Instant::now();
        let mut hits = 0;
        for line in &lines {
            hits += hits_in_range(&solve(&solid, line), &Dyadic::zero(), None).hits.len();
        }
        let cost = start.elapsed().as_secs_f64() * 1e6 / lines.len() as f64;
        println!("{cost:6.2} us, {hits} hits: {solid:?}");
    }
    let answers: Vec<Root> = lines.iter().flat_map(|line| parameters(&solve(&sphere(1.5), line))).collect();
    let start = std::time::Instant::now();
    let total: f64 = answers.iter().map(|t| t.error_in(&exact_f32(17.0), &t.ulp_f32())).sum();
    println!("{:6.2} us an error in ulp ({total:e})", start.elapsed().as_secs_f64() * 1e6 / answers.len() as f64);
}
