//! How far a point is from a surface, straight from the definitions of the solids: differences in exact numbers, so
//! that a distance of `2^-60` is as right as one of 1; the quotients that make lengths of them in `f64`.

use super::oracle::{self, ConeExtent, CylinderExtent, Dyadic, HalfSpace, Part, RoundCone, Solid};

/// A point in exact numbers.
pub type Point = [Dyadic; 3];

/// `sqrt(a) - sqrt(b)`, from the exact difference of the squares.
fn difference_of_roots(a: &Dyadic, b: &Dyadic) -> f64 {
    let sum = a.to_f64().sqrt() + b.to_f64().sqrt();
    if sum == 0.0 { 0.0 } else { (a - b).to_f64() / sum }
}

fn dot(a: &Point, b: &Point) -> Dyadic {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

fn minus(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|i| &a[i] - &b[i])
}

fn cross(a: &Point, b: &Point) -> Point {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &(&a[j] * &b[k]) - &(&a[k] * &b[j])
    })
}

/// The axis that a cuboid's face is across, and whether it is at the positive half extent.
fn face(part: Part) -> (usize, bool) {
    match part {
        Part::Left => (0, false),
        Part::Right => (0, true),
        Part::Base => (1, false),
        Part::Top => (1, true),
        Part::Back => (2, false),
        Part::Front => (2, true),
        Part::Side | Part::Inner | Part::Facet(_) => panic!("a cuboid has no such part"),
    }
}

/// The heights between which the solid or its side lies.
fn heights(solid: &Solid) -> Option<[Dyadic; 2]> {
    match solid {
        Solid::Cylinder { extent: CylinderExtent::Open(height) | CylinderExtent::Capped(height), .. }
        | Solid::Cone { extent: ConeExtent::Open(height) | ConeExtent::Capped(height), .. }
        | Solid::Frustum { height, .. }
        | Solid::Capsule { height, .. }
        | Solid::Tube { height, .. } => Some([Dyadic::zero(), height.clone()]),
        Solid::Revolved(revolved) => Some([revolved.low.clone(), revolved.high.clone()]),
        _ => None,
    }
}

/// How deep the point lies under the curved side, as if that had no ends; below zero outside.
fn under_side(solid: &Solid, p: &Point) -> f64 {
    let [x, y, z] = p;
    let from_axis = &x.squared() + &z.squared();
    // (reach - weight rho) / length, where reach is the radius there times the weight.
    let slanted = |reach: Dyadic, weight: &Dyadic, length: f64| {
        if reach.signum() < 0 {
            (reach.to_f64() - weight.to_f64() * from_axis.to_f64().sqrt()) / length
        } else {
            difference_of_roots(&reach.squared(), &(&weight.squared() * &from_axis)) / length
        }
    };
    match solid {
        Solid::Sphere { radius } => difference_of_roots(&radius.squared(), &dot(p, p)),
        Solid::Cylinder { radius, .. } | Solid::Capsule { radius, .. } => {
            difference_of_roots(&radius.squared(), &from_axis)
        }
        Solid::Cone { slope, extent } => {
            let reach = slope * y;
            let reach = if *extent == ConeExtent::Double { reach.magnitude() } else { reach };
            slanted(reach, &Dyadic::from(1), slope.to_f64().hypot(1.0))
        }
        Solid::Frustum { base_radius, top_radius, height, .. } => {
            let reach = &(base_radius * &(height - y)) + &(top_radius * y);
            slanted(reach, height, height.to_f64().hypot((top_radius - base_radius).to_f64()))
        }
        // To the first order: the value of the equation over the length of its gradient.
        Solid::Revolved(revolved) => {
            let gradient = gradient(solid, Part::Side, p);
            let length = gradient.into_iter().map(|c| c * c).sum::<f64>().sqrt();
            let value = oracle::revolved_margin(revolved, y, &from_axis).to_f64();
            if value == 0.0 { 0.0 } else { value / (2.0 * length) }
        }
        Solid::RoundCone(cone) => {
            let [w, v] = cone.cone_at(y);
            let sum = v.to_f64() + (w.to_f64() * from_axis.to_f64()).sqrt();
            (&v.squared() - &(&w * &from_axis)).to_f64() / (cone.height.to_f64() * sum)
        }
        Solid::Tube { inner, outer, .. } => {
            difference_of_roots(&outer.squared(), &from_axis).min(difference_of_roots(&from_axis, &inner.squared()))
        }
        Solid::Torus { major, minor } => {
            // The equation is the product of r^2 - d^2, where d is the distance from the circle in the middle, and of
            // the same with the distance from the point of the circle on the other side.
            let power = &(&dot(p, p) - &major.squared()) - &minor.squared();
            let value = &power.squared() + &(&major.squared().scaled(2) * &(&y.squared() - &minor.squared()));
            let [rho, y, major, minor] = [from_axis.to_f64().sqrt(), y.to_f64(), major.to_f64(), minor.to_f64()];
            let other = (rho + major).powi(2) + y * y - minor * minor;
            -value.to_f64() / (other * (minor + (rho - major).hypot(y)))
        }
        Solid::RoundedCuboid(cuboid) => {
            let excess = cuboid.excess(p);
            let square = dot(&excess, &excess);
            if square.is_zero() {
                // Deeper than any face.
                let core = (0..3).map(|i| (&cuboid.half[i] - &p[i].magnitude()).to_f64());
                return cuboid.radius.to_f64() + core.fold(f64::INFINITY, f64::min);
            }
            difference_of_roots(&cuboid.radius.squared(), &square)
        }
        Solid::Plane | Solid::Disc { .. } | Solid::Annulus { .. } | Solid::Rectangle { .. } => -y.to_f64(),
        Solid::Cuboid { half } => (0..3).map(|i| (&half[i] - &p[i].magnitude()).to_f64()).fold(f64::INFINITY, f64::min),
        Solid::HalfSpaces(of) => of.faces.iter().map(|face| inside_of(face, p)).fold(f64::INFINITY, f64::min),
        Solid::Triangle { vertices } => {
            let [a, b, c] = vertices;
            let normal = cross(&minus(b, a), &minus(c, a));
            -dot(&normal, &minus(p, a)).to_f64() / dot(&normal, &normal).to_f64().sqrt()
        }
    }
}

/// How far inside of a face's plane the point is.
fn inside_of(face: &HalfSpace, p: &Point) -> f64 {
    face.margin(p).to_f64() / dot(&face.normal, &face.normal).to_f64().sqrt()
}

/// How far below the top and above the base.
fn between_ends(solid: &Solid, y: &Dyadic) -> f64 {
    heights(solid).map_or(f64::INFINITY, |[low, high]| (y - &low).to_f64().min((&high - y).to_f64()))
}

/// How deep the point lies in a solid; outside, less its distance or something nearer to zero.
pub fn depth(solid: &Solid, p: &Point) -> f64 {
    let [x, y, z] = p;
    match solid {
        Solid::Capsule { radius, height } => {
            let beyond = if y.signum() < 0 {
                y.clone()
            } else if y > height {
                y - height
            } else {
                Dyadic::zero()
            };
            difference_of_roots(&radius.squared(), &(&(&x.squared() + &z.squared()) + &beyond.squared()))
        }
        Solid::RoundCone(cone) => match cone.part_at(y) {
            Part::Side => under_side(solid, p),
            part => under_ball(cone, part, p),
        },
        _ => under_side(solid, p).min(between_ends(solid, y)),
    }
}

/// How deep the point lies in one of the balls.
fn under_ball(cone: &RoundCone, part: Part, [x, y, z]: &Point) -> f64 {
    let from_axis = &x.squared() + &z.squared();
    let (radius, above) = match part {
        Part::Top => (&cone.top_radius, y - &cone.height),
        _ => (&cone.base_radius, y.clone()),
    };
    difference_of_roots(&radius.squared(), &(&from_axis + &above.squared()))
}

/// How far the point is from a part of the surface; beyond the part's rim by how much, or by something less.
pub fn distance_from(solid: &Solid, part: Part, p: &Point) -> f64 {
    let [x, y, z] = p;
    let from_axis = &x.squared() + &z.squared();
    let [low, high] = heights(solid).unwrap_or([Dyadic::zero(), Dyadic::zero()]);
    let level = if part == Part::Top { high } else { low };
    match (solid, part) {
        (Solid::Capsule { radius, .. }, Part::Base | Part::Top) => {
            let above = y - &level;
            let beyond = if part == Part::Top { -above.to_f64() } else { above.to_f64() };
            difference_of_roots(&radius.squared(), &(&from_axis + &above.squared())).abs().max(beyond)
        }
        (Solid::Disc { radius }, _) => y.to_f64().abs().max(difference_of_roots(&from_axis, &radius.squared())),
        (Solid::RoundCone(cone), _) => {
            // How far beyond the circle between the parts.
            let [low, high] = cone.seams().map(|seam| (&(y * &cone.height) - &seam).to_f64() / cone.height.to_f64());
            let is_ball = cone.ball().is_some();
            match part {
                Part::Base | Part::Top => {
                    let beyond = if part == Part::Top { -high } else { low };
                    under_ball(cone, part, p).abs().max(if is_ball { 0.0 } else { beyond })
                }
                _ => under_side(solid, p).abs().max(-low).max(high),
            }
        }
        (Solid::Annulus { inner, outer }, _) => {
            let beyond = difference_of_roots(&from_axis, &outer.squared());
            y.to_f64().abs().max(beyond).max(difference_of_roots(&inner.squared(), &from_axis))
        }
        (Solid::Tube { inner: radius, .. }, Part::Inner) | (Solid::Tube { outer: radius, .. }, Part::Side) => {
            difference_of_roots(&radius.squared(), &from_axis).abs().max(-between_ends(solid, y))
        }
        (Solid::Rectangle { half: [along_x, along_z] }, _) => {
            let beyond = [(x, along_x), (z, along_z)].map(|(c, half)| (&c.magnitude() - half).to_f64());
            beyond.into_iter().fold(y.to_f64().abs(), f64::max)
        }
        (Solid::RoundedCuboid(cuboid), Part::Side) => {
            // The second largest excess is how far it is beyond a face's edge.
            let mut beyond = [0, 1, 2].map(|i: usize| (&p[i].magnitude() - &cuboid.half[i]).to_f64());
            beyond.sort_by(f64::total_cmp);
            under_side(solid, p).abs().max(-beyond[1])
        }
        (Solid::RoundedCuboid(cuboid), _) => {
            let (axis, is_positive) = face(part);
            let off = |i: usize| {
                let beyond = &p[i].magnitude() - &cuboid.half[i];
                if i != axis {
                    return beyond.to_f64();
                }
                let is_on_side = (p[i].signum() < 0) != is_positive;
                if is_on_side { (&beyond - &cuboid.radius).to_f64().abs() } else { p[i].magnitude().to_f64() }
            };
            (0..3).map(off).fold(0.0, f64::max)
        }
        (Solid::Cuboid { half }, _) => {
            let (axis, is_positive) = face(part);
            let off = |i: usize| {
                if i != axis {
                    return (&p[i].magnitude() - &half[i]).to_f64();
                }
                if is_positive { (&p[i] - &half[i]).to_f64().abs() } else { (&p[i] + &half[i]).to_f64().abs() }
            };
            (0..3).map(off).fold(0.0, f64::max)
        }
        (Solid::HalfSpaces(of), _) => {
            let off = |face: &HalfSpace| {
                let inside = inside_of(face, p);
                if face.part == part { inside.abs() } else { -inside }
            };
            of.faces.iter().map(off).fold(0.0, f64::max)
        }
        (Solid::Triangle { vertices }, _) => {
            let [a, b, c] = vertices;
            let normal = cross(&minus(b, a), &minus(c, a));
            let mut distance = under_side(solid, p).abs();
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let inwards = cross(&normal, &minus(to, from));
                let beyond = -dot(&inwards, &minus(p, from)).to_f64() / dot(&inwards, &inwards).to_f64().sqrt();
                distance = distance.max(beyond);
            }
            distance
        }
        (_, Part::Base | Part::Top) => (y - &level).to_f64().abs().max(-under_side(solid, p)),
        _ => under_side(solid, p).abs().max(-between_ends(solid, y)),
    }
}

/// The outward normal of the part at the point, of some length; zero at an apex.
pub fn gradient(solid: &Solid, part: Part, p: &Point) -> [f64; 3] {
    let [x, y, z] = [0, 1, 2].map(|i: usize| p[i].to_f64());
    match (solid, part) {
        (Solid::Sphere { .. }, _) | (Solid::Capsule { .. }, Part::Base) => [x, y, z],
        (Solid::Capsule { height, .. }, Part::Top) => [x, (&p[1] - height).to_f64(), z],
        (Solid::RoundCone(_), Part::Base) => [x, y, z],
        (Solid::RoundCone(cone), Part::Top) => [x, (&p[1] - &cone.height).to_f64(), z],
        (Solid::RoundCone(cone), _) => {
            let [w, v] = cone.cone_at(&p[1]).map(|c| c.to_f64());
            [w * x, cone.difference().to_f64() * v, w * z]
        }
        (Solid::RoundedCuboid(cuboid), Part::Side) => {
            let excess = cuboid.excess(p).map(|c| c.to_f64());
            [excess[0].copysign(x), excess[1].copysign(y), excess[2].copysign(z)]
        }
        (Solid::HalfSpaces(of), _) => of.normal(part).map(|n| n.to_f64()),
        (Solid::Cuboid { .. } | Solid::RoundedCuboid(_), _) => {
            let (axis, is_positive) = face(part);
            std::array::from_fn(|i| {
                if i != axis {
                    0.0
                } else if is_positive {
                    1.0
                } else {
                    -1.0
                }
            })
        }
        (Solid::Plane | Solid::Disc { .. } | Solid::Annulus { .. } | Solid::Rectangle { .. }, _) | (_, Part::Top) => {
            [0.0, 1.0, 0.0]
        }
        (Solid::Triangle { vertices: [a, b, c] }, _) => cross(&minus(b, a), &minus(c, a)).map(|n| n.to_f64()),
        (_, Part::Base) => [0.0, -1.0, 0.0],
        (_, Part::Inner) => [-x, 0.0, -z],
        (Solid::Cylinder { .. } | Solid::Capsule { .. } | Solid::Tube { .. }, _) => [x, 0.0, z],
        (Solid::Torus { major, .. }, _) => {
            // 1 - R / rho, from the exact difference of the squares.
            let square = &p[0].squared() + &p[2].squared();
            let (rho, off) = (square.to_f64().sqrt(), (&square - &major.squared()).to_f64());
            let share = off / (rho * (rho + major.to_f64()));
            [share * x, y, share * z]
        }
        (Solid::Revolved(oracle::Revolved { a, b, .. }), _) => [x, -(&(a * &p[1]) + b).to_f64(), z],
        (Solid::Cone { slope, .. }, _) => [x, -y * slope.to_f64().powi(2), z],
        (Solid::Frustum { base_radius, top_radius, height, .. }, _) => {
            let growth = (top_radius - base_radius).to_f64() / height.to_f64();
            [x, -growth * (base_radius.to_f64() + growth * y), z]
        }
    }
}
