//! Fault 10 of the first solver: a placed shape's box holds it, to the last bit, and is at most a few units larger.
//!
//! The exact extreme points: a frame stores the rows of the map from the world to the solid, so that a local point v
//! stands at p + B v of their exact inverse B. Along the i-th axis, with g the i-th row of B, a point reaches p_i +
//! v.g, a circle of radius r about the y axis r sqrt(gx^2 + gz^2) further, and a ball of radius r (in a frame it has no
//! axes) r |g| further.

use crate::named::{any_frame, axes, seen, to_world};
use dashu::rational::RBig;
use raylet::scene::Object;
use raylet::{Affine, Bounds, Capsule, Cone, Cylinder, Disc, Frame, Ray, Shape, Sphere, Triangle, UnitVec3, Vec3};
use support::amount::times;
use support::cases::{direction, n, v};
use support::exact_types::Exact as Number;
use support::oracle::{ConeExtent, CylinderExtent, Dyadic, Root, Solid};
use support::random::{Random, add, scale};
use support::subject::Subject;

every_type!(
    placed_bounds_hold_the_exact_extreme_points_and_are_tight,
    bounds_hold_triangles_whose_coordinates_cancel_the_position,
    the_box_of_a_ball_does_not_grow_when_it_is_turned,
    the_box_of_a_turned_can_is_that_of_its_discs,
    the_ends_of_a_ball_about_a_point_of_the_grid_are_not_cut_off,
);

/// The most that a box may be too large, in units at the largest number on the way.
const FEW: f64 = 4.0;

/// Of what the extremes are made: a local point, the radius of a circle about the y axis there, and that of a ball.
type Outline = ([Dyadic; 3], Dyadic, Dyadic);

fn outline(solid: &Solid) -> Vec<Outline> {
    let zero = Dyadic::zero;
    let up = |y: &Dyadic| [zero(), y.clone(), zero()];
    let circle = |y: &Dyadic, r: &Dyadic| (up(y), r.clone(), zero());
    let ball = |y: &Dyadic, r: &Dyadic| (up(y), zero(), r.clone());
    match solid {
        Solid::Sphere { radius } => vec![ball(&zero(), radius)],
        Solid::Cylinder { radius, extent: CylinderExtent::Open(height) | CylinderExtent::Capped(height) } => {
            vec![circle(&zero(), radius), circle(height, radius)]
        }
        Solid::Cone { slope, extent: ConeExtent::Open(height) | ConeExtent::Capped(height) } => {
            vec![circle(&zero(), &zero()), circle(height, &(slope * height))]
        }
        Solid::Frustum { base_radius, top_radius, height, .. } => {
            vec![circle(&zero(), base_radius), circle(height, top_radius)]
        }
        Solid::Capsule { radius, height } => vec![ball(&zero(), radius), ball(height, radius)],
        Solid::Disc { radius } => vec![circle(&zero(), radius)],
        Solid::Triangle { vertices } => vertices.iter().map(|v| (v.clone(), zero(), zero())).collect(),
        _ => vec![],
    }
}

/// The exact inverse of three rows, as its rows.
fn inverse(rows: &[[Dyadic; 3]; 3]) -> [[RBig; 3]; 3] {
    let m = rows.each_ref().map(|row| row.each_ref().map(Dyadic::to_rational));
    let cross = |a: &[RBig; 3], b: &[RBig; 3]| [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i]);
    let columns = [cross(&m[1], &m[2]), cross(&m[2], &m[0]), cross(&m[0], &m[1])];
    let determinant = product(&m[0], &columns[0]);
    [0, 1, 2].map(|i| columns.each_ref().map(|column| &column[i] / &determinant))
}

fn product(a: &[RBig; 3], b: &[RBig; 3]) -> RBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// How far the solid reaches along a row of the inverse, from the position, to the side of the sign.
fn reach(outline: &[Outline], row: &[RBig; 3], position: &Dyadic, sign: i64) -> Root {
    let across = &row[0] * &row[0] + &row[2] * &row[2];
    let whole = &across + &row[1] * &row[1];
    let ends = outline.iter().map(|(point, circle, ball)| {
        let along = product(&point.each_ref().map(Dyadic::to_rational), row) + position.to_rational();
        let [circle, ball] = [circle, ball].map(|radius| radius.squared().to_rational());
        Root::from_rationals(&(along * RBig::from(sign)), 1, &(circle * &across + ball * &whole), &RBig::ONE)
    });
    ends.max().expect("a bounded solid")
}

/// Fails unless the box holds the solid, whose map from the world has these rows, and is hardly larger.
fn assert_bounds<S: Number>(bounds: &Bounds<S>, solid: &Solid, rows: &[[Dyadic; 3]; 3], position: Vec3<S>, what: &str) {
    let (outline, inverse) = (outline(solid), inverse(rows));
    let (low, high, position) = (bounds.low.to_array(), bounds.high.to_array(), position.to_array());
    for axis in 0..3 {
        let at = position[axis].exact();
        let [least, most] = [-1, 1].map(|sign| reach(&outline, &inverse[axis], &at, sign));
        // The largest number on the way: a coordinate of the box or the position, or a local one as the row scales it.
        let scaled =
            |(point, ..): &Outline| (0..3).map(|i| (point[i].to_f64() * inverse[axis][i].to_f64().value()).abs()).sum();
        let local: f64 = outline.iter().map(scaled).fold(0.0, f64::max);
        let largest = [at.to_f64().abs(), least.to_f64().abs(), most.to_f64().abs()].into_iter().fold(local, f64::max);
        let unit = S::unit_at(&Root::from(&largest.exact()));
        for (end, exact, side) in [(low[axis], -&least, -1), (high[axis], most, 1)] {
            assert!(end.is_finite(), "{what} in {}: {bounds:?}", S::name());
            let beyond = exact.cmp_dyadic(&end.exact());
            let holds = beyond.is_eq() || beyond.is_lt() == (side > 0);
            let (exact_end, slack) = (exact.to_f64(), exact.error_in(&end.exact(), &unit));
            assert!(
                holds,
                "{what} in {}: {end:?} on axis {axis} cuts off {exact_end}, {slack} units: {bounds:?}",
                S::name()
            );
            assert!(slack <= FEW, "{what} in {}: {end:?} on axis {axis} is {slack} units off {exact_end}", S::name());
        }
    }
}

fn identity() -> [[Dyadic; 3]; 3] {
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|row| row.map(Dyadic::from))
}

/// The map from the world to a solid in the frame; a ball has no axes there.
fn rows<S: Number>(frame: &Frame<S>, solid: &Solid) -> [[Dyadic; 3]; 3] {
    if matches!(solid, Solid::Sphere { .. }) { identity() } else { axes(frame) }
}

fn placed_bounds_hold_the_exact_extreme_points_and_are_tight<S: Number>() {
    let bounded = [
        "sphere",
        "cylinder open",
        "cylinder capped",
        "capsule",
        "cone open",
        "cone capped",
        "frustum open",
        "frustum capped",
        "frustum widening",
        "frustum pointed",
        "disc",
        "triangle",
    ];
    for name in bounded {
        let (subject, mut random) = (Subject::<S>::new(name), Random(41));
        let Subject { shape, solid, .. } = &subject;
        assert_bounds(&shape.bounds(), solid, &identity(), Vec3::ZERO, name);
        for distance in [0.0, 4.0, 1_000.0, 8_000.0] {
            for _ in 0..times(25) {
                let frame = any_frame::<S>(&mut random, distance);
                let moved = Frame::at(frame.position()).unwrap();
                assert_bounds(
                    &shape.placed(moved).bounds(),
                    solid,
                    &identity(),
                    frame.position(),
                    &format!("{name}, moved"),
                );
                let turned = shape.placed(frame).bounds();
                assert_bounds(&turned, solid, &rows(&frame, solid), frame.position(), &format!("{name}, turned"));
                // Stretched by powers of two, which an affine stores exactly for axes of which no component is nearly
                // 1.
                let stored = [frame.left(), frame.up(), frame.forward()].map(UnitVec3::to_f64);
                if stored.iter().flatten().any(|c| c.abs() > 0.99) {
                    continue;
                }
                let exponents = [(); 3].map(|()| random.pick(&[-3, 0, 1, 4]));
                let factors = exponents.map(|e| n::<S>(libm::ldexp(1.0, e)));
                let stretched = shape.placed(Affine::stretched(frame, factors.into()).unwrap()).bounds();
                let axes = axes(&frame);
                let shrunk = [0, 1, 2].map(|i| axes[i].each_ref().map(|c| c.scaled(-(exponents[i] as isize))));
                assert_bounds(&stretched, solid, &shrunk, frame.position(), &format!("{name}, stretched"));
            }
        }
    }
}

fn triangle<S: Number>(corners: [Vec3<S>; 3]) -> Option<(Shape<S>, Solid)> {
    let [a, b, c] = corners;
    let vertices = corners.map(|corner| corner.to_array().map(S::exact));
    Some((Shape::new(Triangle::new(a, b, c).ok()?), Solid::Triangle { vertices }))
}

/// In a frame of the axis (1, 2, 3), moved so that the first corner lands at 0, the box was thousands of units off.
#[test]
fn the_box_of_a_triangle_that_lands_at_the_origin_holds_it() {
    let corners = [[1000.0_f32, 1000.0, 0.0], [1000.1, 1000.0, 0.0], [1000.0, 1000.1, 0.0]].map(Vec3::from);
    let (shape, solid) = triangle(corners).expect("vertices");
    let axis = direction::<f32>([1.0, 2.0, 3.0]);
    let turned = Frame::from_base_and_axis(Vec3::ZERO, axis).unwrap();
    let frame = Frame::from_base_and_axis(-turned.point_to_world(corners[0]), axis).unwrap();
    assert_bounds(&shape.placed(frame).bounds(), &solid, &axes(&frame), frame.position(), "the triangle");
}

/// Triangles a tenth to ten large, so far out in a frame that they land about the world's origin; and a hierarchy loses
/// none of them.
fn bounds_hold_triangles_whose_coordinates_cancel_the_position<S: Number>() {
    let far: &[f64] = if S::name() == "I16F16" { &[100.0, 8_000.0] } else { &[1e2, 1e4, 1e5] };
    let mut random = Random(42);
    for _ in 0..times(200) {
        let far = random.pick(far);
        let away = scale(random.direction(), far);
        let size = random.pick(&[0.1, 1.0, 10.0]);
        let corners = [(); 3].map(|()| v::<S>(add(away, scale(random.direction(), size))));
        let Some((shape, solid)) = triangle(corners) else { continue };
        let turned = any_frame::<S>(&mut random, 0.0);
        let position = v::<S>(scale(to_world(&turned, corners[0].to_f64()), -1.0));
        let frame = Frame::looking(position, turned.forward(), turned.up()).unwrap();
        let shape = shape.placed(frame);
        assert_bounds(&shape.bounds(), &solid, &axes(&frame), frame.position(), "a triangle");
        // A ray at its first corner, which stands about the origin.
        let start = v::<S>(scale(random.direction(), 30.0));
        let Ok(ray) = Ray::towards(start, v(scale(random.direction(), 0.01))) else { continue };
        let aside = Shape::new(Sphere::new(n::<S>(1.0)).unwrap()).placed(Frame::at(v([60.0, 0.0, 0.0])).unwrap());
        let [plain, boxed] = seen(&[shape, aside, aside].map(|shape| Object::new(shape, 0)), &ray);
        assert_eq!(plain, boxed, "{}: {ray:?} at {shape:?}", S::name());
    }
}

/// A ball's box was up to .7 of its size too large.
fn the_box_of_a_ball_does_not_grow_when_it_is_turned<S: Number>() {
    let (mut random, ball) = (Random(43), Shape::new(Sphere::new(n::<S>(1.5)).unwrap()));
    // Coordinates up to 4 have the unit of 2.
    let most = 2.0 * FEW * S::unit_at(&Root::from(&2.0_f64.exact())).to_f64();
    for _ in 0..times(200) {
        let Bounds { low, high } = ball.placed(any_frame::<S>(&mut random, 2.0)).bounds();
        let sides = add(high.to_f64(), scale(low.to_f64(), -1.0));
        assert!(sides.iter().all(|side| (side - 3.0).abs() <= most), "{}: {sides:?}", S::name());
    }
}

/// A can of radius 3 and height 5 along (3, 4, 0) / 5: its axis reaches (3, 4, 0), its discs 3 sqrt(1 - a^2) = (2.4,
/// 1.8, 3) about both ends; and the same for a disc, a capsule (3 about both ends) and a cone.
fn the_box_of_a_turned_can_is_that_of_its_discs<S: Number>() {
    let frame = Frame::from_base_and_axis(Vec3::ZERO, direction::<S>([3.0, 4.0, 0.0])).unwrap();
    let (r, h) = (n::<S>(3.0), n::<S>(5.0));
    let boxes = [
        (Shape::new(Cylinder::capped(r, h).unwrap()), [-2.4, -1.8, -3.0], [5.4, 5.8, 3.0]),
        (Shape::new(Disc::new(r).unwrap()), [-2.4, -1.8, -3.0], [2.4, 1.8, 3.0]),
        (Shape::new(Capsule::new(r, h).unwrap()), [-3.0, -3.0, -3.0], [6.0, 7.0, 3.0]),
        (Shape::new(Cone::frustum(S::ZERO, r, h).unwrap()), [0.0, 0.0, -3.0], [5.4, 5.8, 3.0]),
    ];
    for (shape, low, high) in boxes {
        let bounds = shape.placed(frame).bounds();
        let unit = S::unit_at(&Root::from(&4.0_f64.exact())).to_f64();
        let off =
            |found: [f64; 3], exact: [f64; 3]| (0..3).map(|i| (found[i] - exact[i]).abs() / unit).fold(0.0, f64::max);
        let units = off(bounds.low.to_f64(), low).max(off(bounds.high.to_f64(), high));
        assert!(units <= FEW, "{}: {units} units: {bounds:?} of {shape:?}", S::name());
    }
}

/// What a type holds exactly is held exactly: a ball of radius 1 about whole coordinates, in any quarter turn.
fn the_ends_of_a_ball_about_a_point_of_the_grid_are_not_cut_off<S: Number>() {
    let (x, y, z) = (UnitVec3::X, UnitVec3::Y, UnitVec3::Z);
    for [right, up, forward] in [[x, y, z], [y, z, x], [z, x, y], [-x, z, y], [z, -x, -y]] {
        let frame = Frame::from_left_up_forward(v::<S>([1000.0, -7.0, 3.0]), right, up, forward).unwrap();
        let bounds = Shape::new(Sphere::new(n::<S>(1.0)).unwrap()).placed(frame).bounds();
        let (low, high) = (bounds.low.to_f64(), bounds.high.to_f64());
        let holds = (0..3).all(|i| low[i] <= [999.0, -8.0, 2.0][i] && high[i] >= [1001.0, -6.0, 4.0][i]);
        assert!(holds, "{}: {bounds:?}", S::name());
    }
}
