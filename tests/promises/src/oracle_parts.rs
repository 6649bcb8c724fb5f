//! Whether a point where a line meets a solid is on the part that is named, by the equation of that part.

use dashu::rational::RBig;
use support::oracle::{
    ConeExtent, CylinderExtent, Dyadic, HalfSpaces, Line, Part, Revolved, Root, RoundCone, RoundedCuboid, Solid,
};

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

/// Whether a point is in the plane of a triangle and on no outer side of an edge.
fn is_on_triangle(vertices: &[[Dyadic; 3]; 3], p: [&Surd; 3]) -> bool {
    // Barycentric: the point on either side of each edge, by the coordinates that are left when one is dropped.
    let v = vertices.each_ref().map(|vertex| vertex.each_ref().map(Dyadic::to_rational));
    let mut projections = 0;
    for drop in 0..3 {
        let (i, j) = ((drop + 1) % 3, (drop + 2) % 3);
        let area = (&v[1][i] - &v[0][i]) * (&v[2][j] - &v[0][j]) - (&v[2][i] - &v[0][i]) * (&v[1][j] - &v[0][j]);
        let orientation = area.partial_cmp(&RBig::ZERO).unwrap() as i32;
        if orientation == 0 {
            continue;
        }
        projections += 1;
        for k in 0..3 {
            let (a, b) = (&v[k], &v[(k + 1) % 3]);
            let turn =
                p[j].plus(-a[j].clone()).times(&(&b[i] - &a[i])).sum(&p[i].plus(-a[i].clone()).times(&(&a[j] - &b[j])));
            if turn.sign() * orientation < 0 {
                return false;
            }
        }
    }
    // In the plane: the point's volume with the triangle is zero.
    let volume = (0..3)
        .map(|axis| {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let area = (&v[1][i] - &v[0][i]) * (&v[2][j] - &v[0][j]) - (&v[2][i] - &v[0][i]) * (&v[1][j] - &v[0][j]);
            p[axis].plus(-v[0][axis].clone()).times(&area)
        })
        .reduce(|sum, next| sum.sum(&next))
        .unwrap();
    projections > 0 && volume.sign() == 0
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
        Solid::Triangle { vertices } => is_on_triangle(vertices, [&x, &y, &z]),
    }
}
