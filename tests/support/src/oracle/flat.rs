//! Where a line meets a plane, a disc and a triangle.

use dashu::integer::IBig;

use super::algebraic::Root;
use super::dyadic::sign_of;
use super::quadric::{EVERYWHERE, IntegerLine, sphere_overlap};
use super::solids::Part;
use super::solve::{Answer, Approach, Crossing, coincident};

/// One crossing of a plane by a line whose inner product with its normal has the sign given.
fn plane_crossing(t: Root, along_normal: i8) -> Answer {
    Answer::Crossings(vec![Crossing {
        t,
        side: if along_normal < 0 { Approach::FromOutside } else { Approach::FromInside },
        part: Part::Side,
    }])
}

pub(super) fn plane(line: &IntegerLine) -> Answer {
    match sign_of(&line.direction[1]) {
        0 if line.origin[1].is_zero() => coincident(EVERYWHERE),
        0 => Answer::Crossings(vec![]),
        climb => plane_crossing(line.at_height(&IBig::ZERO), climb),
    }
}

pub(super) fn disc(line: &IntegerLine, radius: &IBig) -> Answer {
    let [x, y, z] = &line.origin;
    let [dx, dy, dz] = &line.direction;
    let climb = sign_of(dy);
    if climb != 0 {
        // The point of the plane, times dy.
        let (px, pz) = (x * dy - y * dx, z * dy - y * dz);
        return if &px * &px + &pz * &pz <= (radius * dy).sqr().into() {
            plane_crossing(line.at_height(&IBig::ZERO), climb)
        } else {
            Answer::Crossings(vec![])
        };
    }
    let chord = if y.is_zero() { sphere_overlap(line, radius, &IBig::ZERO) } else { None };
    chord.map_or(Answer::Crossings(vec![]), coincident)
}

/// The disc of the larger radius, less what is nearer to the origin than the smaller one; in its plane the disc's.
pub(super) fn annulus(line: &IntegerLine, [inner, outer]: [IBig; 2]) -> Answer {
    let is_in = |radius: &IBig| matches!(disc(line, radius), Answer::Crossings(crossings) if !crossings.is_empty());
    let ([x, y, z], [dx, dy, dz]) = (&line.origin, &line.direction);
    let (px, pz) = (x * dy - y * dx, z * dy - y * dz);
    // The inner circle itself belongs to the annulus.
    let is_on_the_inner = &px * &px + &pz * &pz == IBig::from((&inner * dy).sqr());
    if is_in(&inner) && !is_on_the_inner { Answer::Crossings(vec![]) } else { disc(line, &outer) }
}

fn integer_subtract(left: &[IBig; 3], right: &[IBig; 3]) -> [IBig; 3] {
    std::array::from_fn(|axis| &left[axis] - &right[axis])
}

fn integer_dot(left: &[IBig; 3], right: &[IBig; 3]) -> IBig {
    &left[0] * &right[0] + &left[1] * &right[1] + &left[2] * &right[2]
}

fn integer_cross(left: &[IBig; 3], right: &[IBig; 3]) -> [IBig; 3] {
    std::array::from_fn(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        &left[next] * &right[last] - &left[last] * &right[next]
    })
}

pub(super) fn triangle(line: &IntegerLine, vertices: &[[IBig; 3]; 3]) -> Answer {
    let [first, second, third] = vertices;
    let normal = integer_cross(&integer_subtract(second, first), &integer_subtract(third, first));
    let spokes: [[IBig; 3]; 3] = std::array::from_fn(|corner| integer_subtract(&vertices[corner], &line.origin));
    let along = integer_dot(&normal, &line.direction);
    let above = integer_dot(&normal, &spokes[0]);
    let direction_sign = sign_of(&along);
    if direction_sign != 0 {
        // The line passes on the inner side of each edge, or through it.
        let inside = (0..3).all(|start| {
            let turn = integer_cross(&spokes[start], &spokes[(start + 1) % 3]);
            sign_of(&integer_dot(&line.direction, &turn)) * direction_sign >= 0
        });
        return if inside {
            plane_crossing(line.ratio(above, &along), direction_sign)
        } else {
            Answer::Crossings(vec![])
        };
    }
    if !above.is_zero() {
        return Answer::Crossings(vec![]);
    }
    let mut overlap = EVERYWHERE;
    for start in 0..3 {
        let edge = integer_subtract(&vertices[(start + 1) % 3], &vertices[start]);
        let inward = integer_cross(&normal, &edge);
        // Within means distance <= t * speed.
        let distance = integer_dot(&inward, &spokes[start]);
        let speed = integer_dot(&inward, &line.direction);
        let pace = sign_of(&speed);
        if pace == 0 {
            if sign_of(&distance) > 0 {
                return Answer::Crossings(vec![]);
            }
            continue;
        }
        let bound = line.ratio(distance, &speed);
        if pace > 0 {
            if overlap.enter.as_ref().is_none_or(|enter| bound > *enter) {
                overlap.enter = Some(bound);
            }
        } else if overlap.exit.as_ref().is_none_or(|exit| bound < *exit) {
            overlap.exit = Some(bound);
        }
    }
    if overlap.enter > overlap.exit { Answer::Crossings(vec![]) } else { coincident(overlap) }
}
