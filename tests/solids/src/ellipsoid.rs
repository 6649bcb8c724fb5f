//! Ellipsoids: their points, normals, boxes and insides, straight from the equation; and what is refused.

use crate::values::{n, point};
use fixed::types::{I8F24, I16F16, I32F32};
use raylet::{
    Affine, Crossing, Ellipsoid, Exact as ExactTier, Frame, FrameError, Range, Ray, Scalar, Shape, SizeError, Sphere,
    Stable, Tier, UnitVec3, ValueError, Vec3,
};
use support::random::Random;

/// `(x / a)^2 + (y / b)^2 + (z / c)^2` of a point in the frame's coordinates, and the gradient in the world.
fn equation<S: Scalar>(radii: [S; 3], frame: &Frame<S>, p: [f64; 3]) -> (f64, [f64; 3]) {
    let position = frame.position().to_f64();
    let (axes, mut value, mut gradient) = (frame.axes().map(UnitVec3::to_f64), 0.0, [0.0; 3]);
    for (axis, radius) in axes.into_iter().zip(radii.map(S::to_f64)) {
        let along: f64 = (0..3).map(|i| axis[i] * (p[i] - position[i])).sum();
        value += (along / radius).powi(2);
        (0..3).for_each(|i| gradient[i] += axis[i] * along / (radius * radius));
    }
    (value, gradient)
}

/// Rays through an ellipsoid: each hit satisfies the equation, within `bound` times its slope, and the normal is its
/// gradient; the point between two hits is inside, and both are in the box.
fn satisfies_its_equation<S: Scalar, T: Tier<S>>(bound: f64) {
    let (mut random, mut hits) = (Random(0xe111), 0);
    for _ in 0..1000 {
        let radii: [S; 3] = [(); 3].map(|()| n(0.25 + 3.0 * random.unit()));
        let mut axis = || UnitVec3::new(point::<S>(random.direction())).expect("no zero");
        let axes = [axis(), axis()];
        let position = point(random.direction().map(|x| 4.0 * x));
        let Ok(frame) = Frame::looking(position, axes[0], axes[1]) else { continue };
        let [a, b, c] = radii;
        let shape = Ellipsoid::new(a, b, c).expect("radii").placed(frame).expect("reciprocals");
        let from = random.direction().map(|x| 12.0 * x);
        let target = random.direction();
        let target = [0, 1, 2].map(|i| position.to_f64()[i] + target[i]);
        let Ok(ray) = Ray::towards(point(from), point(target)) else { continue };
        let ray = ray.with_range(Range::line());
        let [o, d] = [ray.origin().to_f64(), ray.direction().to_f64()];
        let own = shape.hits_at::<T>(&ray);
        for hit in own.iter().filter(|hit| hit.crossing != Crossing::Touch) {
            let at = [0, 1, 2].map(|i| o[i] + hit.t.to_f64() * d[i]);
            let (value, gradient) = equation(radii, &frame, at);
            let steep = gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
            assert!((value - 1.0).abs() <= bound * steep, "{value} {shape:?} {ray:?}");
            let normal = shape.surface(&ray, hit).normal().to_f64();
            (0..3).for_each(|i| assert!((normal[i] - gradient[i] / steep).abs() < bound, "{shape:?} {ray:?}"));
            let bounds = shape.bounds();
            let [low, high] = [bounds.low.to_f64(), bounds.high.to_f64()];
            assert!((0..3).all(|i| low[i] - bound <= at[i] && at[i] <= high[i] + bound), "{bounds:?} {at:?}");
            hits += 1;
        }
        if let [enter, exit] = own[..] {
            let middle = point([0, 1, 2].map(|i| o[i] + 0.5 * (enter.t.to_f64() + exit.t.to_f64()) * d[i]));
            let is_thick = exit.t.to_f64() - enter.t.to_f64() > 0.01;
            assert!(!is_thick || shape.contains_at::<T>(middle), "{shape:?} {ray:?}");
        }
    }
    assert!(hits > 1000, "{hits}");
}

#[test]
fn an_ellipsoid_is_where_its_equation_is_one() {
    satisfies_its_equation::<f32, Stable>(1e-5);
    satisfies_its_equation::<f32, ExactTier>(1e-5);
    satisfies_its_equation::<f64, Stable>(1e-14);
    satisfies_its_equation::<I16F16, Stable>(3e-4);
    satisfies_its_equation::<I8F24, Stable>(2e-6);
    satisfies_its_equation::<I32F32, Stable>(5e-9);
}

#[test]
fn an_ellipsoid_is_a_stretched_ball() {
    let frame = Frame::turned_about(Vec3::new(1.0_f32, 2.0, 3.0), UnitVec3::X, 30.0).unwrap();
    let ball = Shape::new(Sphere::new(1.0).unwrap());
    let egg = Ellipsoid::new(0.5, 2.0, 3.0).unwrap();
    assert_eq!(egg.radii(), [0.5, 2.0, 3.0]);
    let by_hand = |frame| ball.placed(Affine::stretched(frame, Vec3::new(0.5, 2.0, 3.0)).unwrap());
    assert_eq!(egg.placed(frame), Ok(by_hand(frame)));
    assert_eq!(egg.shape(), Ok(by_hand(Frame::at(Vec3::ZERO).unwrap())));
}

#[test]
fn radii_that_are_none_are_refused() {
    let fault = |error| Err(SizeError::Radius(error));
    assert_eq!(Ellipsoid::new(1.0_f32, 0.0, 1.0), fault(ValueError::Zero));
    assert_eq!(Ellipsoid::new(-1.0_f32, 1.0, 1.0), fault(ValueError::Negative));
    assert_eq!(Ellipsoid::new(1.0_f32, 1.0, f32::NAN), fault(ValueError::NotFinite));
    let message = Ellipsoid::new(1.0_f32, 0.0, 1.0).unwrap_err().to_string();
    assert_eq!(message, "the radius is zero, or was below one unit of the number type and was rounded to zero");
    // The type does not hold the unit sphere.
    type Fraction = fixed::FixedI32<fixed::types::extra::U31>;
    let quarter = Fraction::from_num(0.25);
    let egg = Ellipsoid::new(quarter, quarter, quarter).unwrap();
    assert_eq!(egg.shape().map(|_| ()), Err(FrameError::Scale(ValueError::BeyondType)));
}

/// Of radii 0.001, 1,000 and 1 the largest is nearly right in a turned frame: what the documentation says.
#[test]
fn very_unequal_radii_are_nearly_right() {
    let (mut random, mut worst) = (Random(0x9a71), 0.0_f64);
    for _ in 0..300 {
        let [up, near] = [(); 2].map(|()| UnitVec3::new(point::<f32>(random.direction())).expect("no zero"));
        let Ok(frame) = Frame::looking(Vec3::ZERO, near, up) else { continue };
        let shape = Ellipsoid::new(0.001, 1000.0, 1.0).expect("radii").placed(frame).expect("an inverse");
        let ray = Ray::new(Vec3::ZERO, frame.up()).expect("a ray").with_range(Range::line());
        let hits = shape.hits_at::<ExactTier>(&ray);
        worst = hits.iter().map(|hit| (hit.t.abs() as f64 / 1000.0 - 1.0).abs()).fold(worst, f64::max);
    }
    println!("{worst}");
    assert!((1e-5..1e-2).contains(&worst), "{worst}");
}
