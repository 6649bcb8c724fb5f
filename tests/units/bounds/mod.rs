//! Boxes against the exact reach of what they hold: nothing reaches out of them, and they are at most a unit too large.

mod exact;

use crate::random::Random;
use crate::scalar::UnitScalar;
use crate::{
    Affine, Bounds, Capsule, Cone, Cuboid, Cylinder, Disc, Frame, Placement, Plane, Primitive, Rectangle, Shape,
    Sphere, Triangle, UnitVec3, Vec3,
};
use exact::{Exact, Exactly, Number, Part};
use fixed::types::{I16F16, I32F32};
use std::vec;
use std::vec::Vec;

impl Random {
    fn below(&mut self, count: u32) -> u32 {
        (self.unit() * f64::from(count)) as u32
    }

    /// Of any magnitude between these powers of ten.
    fn sized<S: Number>(&mut self, low: f64, high: f64) -> S {
        number(libm::pow(10.0, self.between(low, high)))
    }

    /// Of either sign and any magnitude, one in five times zero.
    fn point<S: Number>(&mut self, low: f64, high: f64) -> Vec3<S> {
        [(); 3]
            .map(|()| match self.below(5) {
                0 => S::ZERO,
                1 | 2 => -self.sized::<S>(low, high),
                _ => self.sized(low, high),
            })
            .into()
    }

    /// Of a length that is off by up to 2^-21, as a direction may be.
    fn direction<S: Number>(&mut self) -> UnitVec3<S> {
        loop {
            let v = [(); 3].map(|()| if self.below(8) == 0 { 0.0 } else { self.between(-1.0, 1.0) });
            let length = libm::sqrt(v.iter().map(|c| c * c).sum());
            let stretch = if self.below(2) == 0 { 1.0 } else { 1.0 + self.between(-0.5, 0.5) * libm::exp2(-20.0) };
            let components = v.map(|c| <S::Unit as UnitScalar>::from_f64(c / length * stretch));
            if let Some(direction) = UnitVec3::from_components(components).ok().filter(|_| length > 0.1) {
                return direction;
            }
        }
    }

    /// In the world, moved, turned, turned and moved, stretched, sheared.
    fn placement<S: Number>(&mut self) -> Placement<S> {
        loop {
            let position = if self.below(4) == 0 { Vec3::ZERO } else { self.point(-2.0, S::MOST) };
            let placement = match self.below(7) {
                0 => Some(Placement::World),
                1 => Frame::at(position).ok().map(Placement::Frame),
                2 | 3 => Frame::from_base_and_axis(position, self.direction()).ok().map(Placement::Frame),
                4 => Frame::looking(position, self.direction(), self.direction()).ok().map(Placement::Frame),
                5 => {
                    let frame = Frame::from_base_and_axis(position, self.direction()).ok();
                    let scale = [(); 3].map(|()| self.sized(-1.0, 1.0));
                    frame.and_then(|frame| Affine::stretched(frame, scale.into()).ok()).map(Placement::Affine)
                }
                _ => {
                    let axes = [(); 3].map(|()| self.point(-1.0, 1.0));
                    let is_solid = volume(axes) > 1.0 / 64.0;
                    Affine::new(position, axes).ok().filter(|_| is_solid).map(Placement::Affine)
                }
            };
            if let Some(placement) = placement {
                return placement;
            }
        }
    }
}

/// Of the parallelepiped that the directions span.
fn volume<S: Number>(axes: [Vec3<S>; 3]) -> f64 {
    let [[a, b, c], [d, e, f], [g, h, i]] = axes.map(|axis| {
        let v = axis.to_f64();
        let length = libm::sqrt(v.iter().map(|c| c * c).sum());
        v.map(|c| c / length)
    });
    libm::fabs(a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g))
}

fn number<S: Number>(value: f64) -> S {
    S::from_f64(value).expect("within the type")
}

fn balls<S: Number>(r: S, heights: &[S]) -> Vec<Part> {
    heights.iter().map(|y| Part::Ball(y.exact(), r.exact())).collect()
}

fn discs<S: Number>(discs: &[[S; 2]]) -> Vec<Part> {
    discs.iter().map(|[y, r]| Part::Disc(y.exact(), r.exact())).collect()
}

/// The corners of a cuboid.
fn corners<S: Number>(half: [S; 3]) -> Vec<Part> {
    let corner = |bits: u32| [0, 1, 2].map(|i| if bits >> i & 1 == 0 { half[i].exact() } else { -half[i].exact() });
    (0..8).map(|bits| Part::Point(corner(bits))).collect()
}

/// One of each, and the parts that it is the hull of, of sizes between these powers of ten.
fn solids<S: Number>(random: &mut Random, low: f64, high: f64) -> Vec<(Primitive<S>, Vec<Part>)> {
    let zero = S::ZERO;
    let [r, top, h] = [(); 3].map(|()| random.sized::<S>(low, high));
    let vertices = [(); 3].map(|()| random.point::<S>(low, high));
    let mut solids: Vec<(Primitive<S>, Vec<Part>)> = vec![
        (Sphere::new(r).expect("size").into(), balls(r, &[zero])),
        (Capsule::new(r, h).expect("size").into(), balls(r, &[zero, h])),
        (Cylinder::capped(r, h).expect("size").into(), discs(&[[zero, r], [h, r]])),
        (Cone::frustum(r, top, h).expect("size").into(), discs(&[[zero, r], [h, top]])),
        (Cone::frustum_open(r, zero, h).expect("size").into(), discs(&[[zero, r], [h, zero]])),
        (Disc::new(r).expect("size").into(), discs(&[[zero, r]])),
        (Cuboid::new(r, top, h).expect("size").into(), corners([r, top, h])),
        (Rectangle::new(r, h).expect("size").into(), corners([r, zero, h])),
    ];
    let slope = random.sized::<S>(-1.0, 1.0);
    if let Ok(cone) = Cone::capped(slope, h) {
        solids.push((
            cone.into(),
            vec![Part::Disc(zero.exact(), zero.exact()), Part::Disc(h.exact(), &slope.exact() * &h.exact())],
        ));
    }
    if let Ok(triangle) = Triangle::new(vertices[0], vertices[1], vertices[2]) {
        solids.push((triangle.into(), vertices.map(|v| Part::Point(v.to_array().map(S::exact))).to_vec()));
    }
    solids
}

fn sides<S: Number>(bounds: Bounds<S>) -> [(usize, bool, S); 6] {
    let (low, high) = (bounds.low.to_array(), bounds.high.to_array());
    let [x, y, z] = [0, 1, 2].map(|i| [(i, false, low[i]), (i, true, high[i])]);
    [x[0], x[1], y[0], y[1], z[0], z[1]]
}

/// True if the box is no smaller than the solid.
fn holds<S: Number>(shape: &Shape<S>, exactly: &Exactly) -> bool {
    let is_held = |(axis, up, bound): (usize, bool, S)| {
        if bound.is_finite() { exactly.is_held_by(axis, up, &bound.exact()) } else { (bound > S::ZERO) == up }
    };
    sides(shape.bounds()).into_iter().all(is_held)
}

/// By how many units of the largest coordinate the box is larger than the solid, rounded up: 1 is the least number of
/// the type that is no less. `None` where it is infinite.
fn looseness<S: Number>(shape: &Shape<S>, exactly: &Exactly) -> Option<u32> {
    let mut largest = match shape.placement() {
        Placement::World => 0.0,
        Placement::Frame(frame) => largest(frame.position()),
        Placement::Affine(affine) => largest(affine.position()),
    };
    if let Primitive::Triangle(triangle) = shape.primitive() {
        largest = triangle.vertices().into_iter().map(self::largest).fold(largest, f64::max);
    }
    let mut loosest = 0;
    for (axis, up, bound) in sides(shape.bounds()) {
        if !bound.is_finite() {
            return None;
        }
        let unit = Exact::power_of_two(S::unit_at(largest.max(bound.to_f64().abs())));
        let mut units = 0;
        let mut inner = bound.exact();
        while units < 1000 && exactly.is_held_by(axis, up, &inner) {
            inner = if up { inner - unit.clone() } else { inner + unit.clone() };
            units += 1;
        }
        loosest = loosest.max(units);
    }
    Some(loosest)
}

fn largest<S: Number>(v: Vec3<S>) -> f64 {
    v.to_f64().into_iter().map(f64::abs).fold(0.0, f64::max)
}

fn hold_tightly<S: Number>() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let (mut boxes, mut infinite, mut counted) = (0, 0, [0; 4]);
    for _ in 0..rounds(300) {
        for (primitive, parts) in solids::<S>(&mut random, -2.0, 2.0) {
            let shape = Shape::new(primitive).placed(random.placement());
            let exactly = Exactly::new(&shape, &parts);
            assert!(holds(&shape, &exactly), "{shape:?} reaches out of {:?}", shape.bounds());
            match looseness(&shape, &exactly) {
                None => infinite += 1,
                Some(units) => {
                    assert!(units <= 2, "{shape:?} leaves {units} units in {:?}", shape.bounds());
                    counted[units as usize] += 1;
                }
            }
            boxes += 1;
        }
    }
    assert_eq!(infinite, 0, "all of it is well within the type");
    // Two only where the solid reaches as far as a number of the type: that it does is not known.
    assert!(counted[2] * 10 < boxes, "{counted:?} of {boxes}");
}

/// A hundred times as many in the long form: a million sides a type.
fn rounds(few: u32) -> u32 {
    if std::env::var_os("RAYLET_LONG").is_some() { 100 * few } else { few }
}

#[test]
fn boxes_hold_what_is_placed_within_a_unit() {
    hold_tightly::<f32>();
    hold_tightly::<f64>();
    hold_tightly::<I16F16>();
    hold_tightly::<I32F32>();
}

/// Axes that lie nearly in a plane, along a line, or in the same direction; of very different lengths.
fn hold_what_is_nearly_flat<S: Number>() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut boxes = 0;
    while boxes < rounds(300) {
        let near = number::<S>(libm::exp2(random.between(-8.0, -1.0)));
        let common = random.point::<S>(-1.0, 1.0);
        let axes = [(); 3].map(|()| {
            let own = random.point::<S>(-1.0, 1.0);
            let [x, y, z] = own.to_array().map(|c| S::round(c.real() * near.real()));
            common + Vec3::new(x, y, z)
        });
        let Ok(affine) = Affine::new(random.point(-2.0, S::MOST), axes) else { continue };
        for (primitive, parts) in solids::<S>(&mut random, -1.0, 1.0) {
            let shape = Shape::new(primitive).placed(affine);
            let exactly = Exactly::new(&shape, &parts);
            assert!(holds(&shape, &exactly), "{shape:?} reaches out of {:?}", shape.bounds());
            // 2^-36 of the terms, by the volume of the directions, 2^-16 at least.
            assert!(looseness(&shape, &exactly).is_some_and(|units| units <= 16), "{shape:?} in {:?}", shape.bounds());
            boxes += 1;
        }
    }
}

#[test]
fn boxes_hold_what_is_nearly_flat() {
    hold_what_is_nearly_flat::<f32>();
    hold_what_is_nearly_flat::<f64>();
    hold_what_is_nearly_flat::<I16F16>();
    hold_what_is_nearly_flat::<I32F32>();
}

/// Sizes and places of all magnitudes of a float, to where it overflows and underflows.
fn hold_at_the_extremes<S: Number>(tens: f64) {
    let mut random = Random(0x1234_5678_9abc_def1);
    let (mut boxes, mut infinite) = (0, 0);
    for _ in 0..rounds(200) {
        let size = random.between(-tens, tens - 2.0);
        for (primitive, parts) in solids::<S>(&mut random, size, size + 2.0) {
            let far = random.between(-tens, tens);
            let place = if random.below(2) == 0 { [size, size + 1.0] } else { [far - 1.0, far] };
            let Ok(frame) = Frame::from_base_and_axis(random.point(place[0], place[1]), random.direction()) else {
                continue;
            };
            let scale = random.between(-tens, tens - 4.0);
            let scale = [(); 3].map(|()| random.sized::<S>(scale, scale + 4.0));
            let placed = Affine::stretched(frame, scale.into()).map_or(Placement::Frame(frame), Placement::Affine);
            for placement in [Placement::Frame(frame), placed] {
                let shape = Shape::new(primitive).placed(placement);
                let exactly = Exactly::new(&shape, &parts);
                assert!(holds(&shape, &exactly), "{shape:?} reaches out of {:?}", shape.bounds());
                if let (Placement::Frame(_), Some(units)) = (placement, looseness(&shape, &exactly)) {
                    // One for what subnormal products lose; near the smallest float also what the low words of products
                    // lose.
                    let most = if size < 2.0 - tens { 8 } else { 3 };
                    assert!(units <= most, "{shape:?} leaves {units} units in {:?}", shape.bounds());
                }
                infinite += u32::from(sides(shape.bounds()).iter().any(|(_, _, bound)| !bound.is_finite()));
                boxes += 1;
            }
        }
    }
    assert!(infinite * 2 < boxes);
}

#[test]
fn boxes_hold_at_the_ends_of_a_float() {
    hold_at_the_extremes::<f32>(37.0);
    hold_at_the_extremes::<f64>(306.0);
}

/// Vertices whose images cancel the position.
#[test]
fn a_triangle_whose_vertices_cancel_the_position_is_held() {
    let v = Vec3::<f32>::new;
    let vertices = [v(1000.0, 1000.0, 0.0), v(1000.1, 1000.0, 0.0), v(1000.0, 1000.1, 0.0)];
    let parts = vertices.map(|v| Part::Point(v.to_array().map(f32::exact)));
    let axis = UnitVec3::new(v(1.0, 2.0, 3.0)).expect("a direction");
    let turned = Frame::from_base_and_axis(Vec3::ZERO, axis).expect("axes");
    let moved = Frame::from_base_and_axis(-turned.point_to_world(vertices[0]), axis).expect("position");
    let [a, b, c] = vertices;
    let shape = Shape::new(Triangle::new(a, b, c).expect("a triangle")).placed(moved);
    let exactly = Exactly::new(&shape, &parts);
    assert!(holds(&shape, &exactly));
    assert!(looseness(&shape, &exactly).is_some_and(|units| units <= 1));
    // Seen from the position the box is not larger than the triangle: 0.15 and some units of 1000.
    let (low, high) = (shape.bounds().low.to_f64(), shape.bounds().high.to_f64());
    assert!((0..3).all(|i| high[i] - low[i] < 0.15), "{:?}", shape.bounds());
}

fn a_ball_does_not_grow<S: Number>() {
    let (mut random, r) = (Random(7), number::<S>(1.5));
    let ball = Shape::new(Sphere::new(r).expect("size"));
    for _ in 0..200 {
        let position = random.point::<S>(-2.0, S::MOST);
        let moved = ball.placed(Frame::at(position).expect("position"));
        let turned = ball.placed(Frame::from_base_and_axis(position, random.direction()).expect("position"));
        assert_eq!(moved.bounds(), turned.bounds());
    }
}

#[test]
fn a_ball_does_not_grow_when_it_is_turned() {
    a_ball_does_not_grow::<f32>();
    a_ball_does_not_grow::<f64>();
    a_ball_does_not_grow::<I16F16>();
    a_ball_does_not_grow::<I32F32>();
}

/// Along the world's axes nothing is rounded, and what is infinite is so along its own axes only.
fn exact_along_axes<S: Number>() {
    let n = number::<S>;
    let v = |x, y, z| Vec3::new(x, y, z);
    let (one, two, zero, infinite) = (n(1.0), n(2.0), S::ZERO, S::INFINITY);
    let at = Frame::at(v(n(10.0), n(20.0), n(30.0))).expect("position");
    // The solids' y along the world's x, x along z.
    let lying = Frame::from_left_up_forward(at.position(), UnitVec3::Z, UnitVec3::X, UnitVec3::Y).expect("axes");
    let cases: [(Primitive<S>, [S; 3], [S; 3]); 8] = [
        (Sphere::new(one).expect("size").into(), [-one; 3], [one; 3]),
        (Capsule::new(one, two).expect("size").into(), [-one; 3], [one, n(3.0), one]),
        (Cylinder::capped(one, two).expect("size").into(), [-one, zero, -one], [one, two, one]),
        (Cylinder::infinite(one).expect("size").into(), [-one, -infinite, -one], [one, infinite, one]),
        (Cone::frustum(one, two, n(4.0)).expect("size").into(), [-two, zero, -two], [two, n(4.0), two]),
        (Cone::nappe(one).expect("size").into(), [-infinite, zero, -infinite], [infinite; 3]),
        (Cone::double(one).expect("size").into(), [-infinite; 3], [infinite; 3]),
        (Plane::new().into(), [-infinite, zero, -infinite], [infinite, zero, infinite]),
    ];
    for (primitive, low, high) in cases {
        let moved = |c: S, by: f64| if c.is_finite() { c.plus(n(by)) } else { c };
        let shape = Shape::new(primitive);
        assert_eq!(shape.bounds(), Bounds { low: low.into(), high: high.into() }, "{shape:?}");
        for (frame, [x, y, z]) in [(at, [0, 1, 2]), (lying, [1, 2, 0])] {
            let bounds = shape.placed(frame).bounds();
            let [low, high] = [low, high].map(|c| v(moved(c[x], 10.0), moved(c[y], 20.0), moved(c[z], 30.0)));
            assert_eq!(bounds.low, low, "{primitive:?} {frame:?}");
            // A capsule's end is a sum of three numbers, which a float may hold and not know to be exact.
            let next = high.to_array().map(S::next_up);
            let is_next = |(bound, (c, next))| bound == c || bound == next;
            assert!(
                bounds.high.to_array().into_iter().zip(high.to_array().into_iter().zip(next)).all(is_next),
                "{bounds:?} {high:?}"
            );
        }
    }
    let turned =
        Frame::from_base_and_axis(at.position(), UnitVec3::new(v(one, two, one)).expect("axis")).expect("axes");
    for primitive in [
        Primitive::from(Plane::new()),
        Cylinder::infinite(one).expect("size").into(),
        Cone::nappe(two).expect("size").into(),
    ] {
        let everywhere = Bounds { low: [-infinite; 3].into(), high: [infinite; 3].into() };
        assert_eq!(Shape::new(primitive).placed(turned).bounds(), everywhere, "{primitive:?}");
    }
}

#[test]
fn boxes_along_the_axes_of_the_world_are_exact() {
    exact_along_axes::<f32>();
    exact_along_axes::<f64>();
    exact_along_axes::<I16F16>();
    exact_along_axes::<I32F32>();
}
