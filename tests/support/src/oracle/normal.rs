//! Which way a surface faces: outwards, or away from the axis where nothing is enclosed.

use super::algebraic::Root;
use super::dyadic::{Dyadic, sign_of};
use super::solids::{Line, Part, Solid, dot, triangle_normal};

/// The precision of the components of a gradient, in bits.
const GRADIENT_BITS: usize = 120;

fn along(axis: usize, sign: i64) -> [Dyadic; 3] {
    std::array::from_fn(|i| if i == axis { Dyadic::from(sign) } else { Dyadic::zero() })
}

fn upwards(sign: i64) -> [Dyadic; 3] {
    along(1, sign)
}

/// An outward normal of the part at the point where the line is at `t`, of some length, each component to 120 bits.
///
/// At the apex of a cone it is the axis, pointing away from the body; the apex of a double cone takes that of its upper
/// nappe, (0, -1, 0).
///
/// # Panics
///
/// If the solid has no such part, or a triangle no area.
pub fn gradient(solid: &Solid, part: Part, t: &Root, line: &Line) -> [Dyadic; 3] {
    let coordinate = |axis| line.coordinate_at(t, axis).approximation(GRADIENT_BITS);
    match (solid, part) {
        (Solid::Sphere { .. }, Part::Side) => [coordinate(0), coordinate(1), coordinate(2)],
        (Solid::Capsule { .. }, Part::Base) => [coordinate(0), coordinate(1), coordinate(2)],
        (Solid::Capsule { height, .. }, Part::Top) => {
            let above = &line.origin[1] - height;
            let y = t.mul_add(&line.direction[1], &above);
            [coordinate(0), y.approximation(GRADIENT_BITS), coordinate(2)]
        }
        (Solid::Plane | Solid::Disc { .. } | Solid::Annulus { .. } | Solid::Rectangle { .. }, Part::Side) => upwards(1),
        (Solid::Tube { .. }, Part::Side) => [coordinate(0), Dyadic::zero(), coordinate(2)],
        (_, Part::Inner) => [-&coordinate(0), Dyadic::zero(), -&coordinate(2)],
        (Solid::Torus { major, minor }, Part::Side) => {
            super::torus::gradient([major, minor], &[coordinate(0), coordinate(1), coordinate(2)])
        }
        (Solid::RoundCone(_), Part::Base) => [coordinate(0), coordinate(1), coordinate(2)],
        (Solid::RoundCone(cone), Part::Top) => {
            let y = t.mul_add(&line.direction[1], &(&line.origin[1] - &cone.height));
            [coordinate(0), y.approximation(GRADIENT_BITS), coordinate(2)]
        }
        (Solid::RoundCone(cone), Part::Side) => {
            let ([w, v], k) = (cone.cone_at(&line.origin[1]), cone.difference());
            let v = t.mul_add(&-&(&k * &line.direction[1]), &v).approximation(GRADIENT_BITS);
            [&w * &coordinate(0), &k * &v, &w * &coordinate(2)]
        }
        (Solid::RoundedCuboid(cuboid), Part::Side) => std::array::from_fn(|axis| {
            let (half, c) = (&cuboid.half[axis], line.coordinate_at(t, axis));
            let beyond = |plane: &Dyadic| {
                t.mul_add(&line.direction[axis], &(&line.origin[axis] - plane)).approximation(GRADIENT_BITS)
            };
            if c.cmp_dyadic(half).is_gt() {
                beyond(half)
            } else if c.cmp_dyadic(&-half).is_lt() {
                beyond(&-half)
            } else {
                Dyadic::zero()
            }
        }),
        (Solid::HalfSpaces(of), _) => of.normal(part),
        (_, Part::Left) => along(0, -1),
        (_, Part::Right) => along(0, 1),
        (_, Part::Back) => along(2, -1),
        (_, Part::Front) => along(2, 1),
        (Solid::Triangle { vertices }, Part::Side) => triangle_normal(vertices),
        (_, Part::Base) => upwards(-1),
        (_, Part::Top) => upwards(1),
        (Solid::Revolved(revolved), Part::Side) => {
            let (growth, height) = (&revolved.a * &line.direction[1], &revolved.a * &line.origin[1]);
            let growth = t.mul_add(&growth, &(&height + &revolved.b)).approximation(GRADIENT_BITS);
            [coordinate(0), -&growth, coordinate(2)]
        }
        (_, Part::Facet(_)) => panic!("only a prism has facets"),
        (_, Part::Side) => {
            // The gradient of weight^2 (x^2 + z^2) - (offset + growth y)^2.
            let lateral = solid.lateral().expect("every other side is lateral");
            let weight = lateral.weight.squared();
            let reach = t
                .mul_add(
                    &(&lateral.growth * &line.direction[1]),
                    &(&lateral.offset + &(&lateral.growth * &line.origin[1])),
                )
                .approximation(GRADIENT_BITS);
            if reach.is_zero() {
                return upwards(-i64::from(lateral.growth.signum()));
            }
            [&weight * &coordinate(0), &-&lateral.growth * &reach, &weight * &coordinate(2)]
        }
    }
}

/// The outward unit normal, each component to about 100 bits.
///
/// # Panics
///
/// If the solid has no such part, or a triangle no area.
pub fn normal(solid: &Solid, part: Part, t: &Root, line: &Line) -> [Dyadic; 3] {
    let gradient = gradient(solid, part, t, line);
    let square = dot(&gradient, &gradient);
    gradient.map(|component| {
        // component / sqrt(square), as the signed root of component^2 / square.
        let ratio = component.squared();
        Root::new(
            dashu::integer::IBig::ZERO,
            sign_of(&component.mantissa),
            &ratio.mantissa * &square.mantissa,
            square.mantissa.clone(),
            // Both squares have even exponents, which halve.
            (ratio.exponent - square.exponent) / 2,
        )
        .approximation(GRADIENT_BITS)
    })
}
