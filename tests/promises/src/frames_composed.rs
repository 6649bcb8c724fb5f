//! Frames and solids as people have them in hand elsewhere: quaternions, frames in frames, corners, equations.

use crate::frames::{any_direction, close, component, exact_dot, unit};
use raylet::scalar::{UnitScalar, ValueError};
use raylet::{Cuboid, Frame, FrameError, Plane, Ray, Shape, SizeError, UnitVec3, Vec3};
use support::amount::times;
use support::cases::{n, v};
use support::exact_types::Exact;
use support::random::Random;

every_type!(
    a_quaternion_turns_as_its_axis_and_angle_do,
    quaternions_of_no_length_are_refused,
    a_frame_in_a_frame_takes_points_through_both,
    a_cuboid_between_corners_has_its_faces_there,
    corners_in_the_wrong_order_are_refused,
    a_plane_from_its_equation_holds_its_points,
    the_cosine_of_incidence_is_that_of_the_normal,
);

fn tolerance<S: Exact>() -> f64 {
    32.0 * component::<S>().max(2.0_f64.powi(-53))
}

fn are_orthonormal<S: Exact>(frame: &Frame<S>) -> bool {
    let [x, y, z] = frame.axes();
    let limit = 4.0 * component::<S>();
    let right = [(x, y), (y, z), (z, x)].into_iter().all(|(a, b)| exact_dot(a, b).to_f64().abs() <= limit);
    right && [x, y, z].into_iter().all(|a| (exact_dot(a, a).to_f64() - 1.0).abs() <= limit)
}

fn a_quaternion_turns_as_its_axis_and_angle_do<S: Exact>() {
    let mut random = Random(164);
    for _ in 0..times(300) {
        let axis = any_direction::<S>(&mut random);
        let degrees = n::<S>(random.between(-180.0, 180.0));
        let (sine, cosine) = (degrees.to_f64().to_radians() / 2.0).sin_cos();
        let length = random.pick(&[1.0, 1.0, 0.01, 1.3]);
        let [x, y, z] = axis.to_f64().map(|c| c * sine);
        let quaternion = [x, y, z, cosine].map(|c| <S::Unit as UnitScalar>::from_f64(c * length));
        let position = v([0.5, 1.0, 2.0]);
        let turned = Frame::<S>::from_quaternion(position, quaternion).expect("it has a length");
        let expected = Frame::turned_about(position, axis, degrees).expect("an angle");
        assert_eq!(turned.position(), position);
        assert!(are_orthonormal(&turned), "{turned:?}");
        for (a, b) in turned.axes().into_iter().zip(expected.axes()) {
            assert!(close(a.to_f64(), b.to_f64(), tolerance::<S>() / length), "{turned:?} {expected:?}");
        }
    }
}

fn quaternions_of_no_length_are_refused<S: Exact>() {
    let number = <S::Unit as UnitScalar>::from_f64;
    for quaternion in [[0.0; 4], [1e-4, 0.0, 0.0, -1e-4]] {
        assert_eq!(Frame::<S>::from_quaternion(Vec3::ZERO, quaternion.map(number)), Err(FrameError::Quaternion));
    }
    let far = Vec3::new(S::INFINITY, S::ZERO, S::ZERO);
    let turned = Frame::<S>::from_quaternion(far, [0.0, 0.0, 0.0, 1.0].map(number));
    assert!(matches!(turned, Err(FrameError::Position(_))), "{turned:?}");
}

#[test]
fn quaternions_that_are_not_finite_or_very_long_are_refused() {
    for bad in [f32::NAN, f32::INFINITY, 1e6] {
        let quaternion = [0.0, bad, 0.0, 1.0];
        assert_eq!(Frame::<f32>::from_quaternion(Vec3::ZERO, quaternion), Err(FrameError::Quaternion), "{bad}");
    }
}

fn a_frame_in_a_frame_takes_points_through_both<S: Exact>() {
    let mut random = Random(165);
    for _ in 0..times(300) {
        let mut frame = || {
            let degrees = n::<S>(random.between(-180.0, 180.0));
            Frame::turned_about(random.point::<S>(2.0), any_direction(&mut random), degrees).expect("an angle")
        };
        let (outer, inner) = (frame(), frame());
        let both = outer.frame_to_world(&inner).expect("near");
        assert!(are_orthonormal(&both), "{both:?}");
        let point = random.point::<S>(2.0);
        let twice = outer.point_to_world(inner.point_to_world(point));
        assert!(close(both.point_to_world(point).to_f64(), twice.to_f64(), 32.0 * unit::<S>()), "{outer:?} {inner:?}");
    }
    let far = Frame::at(Vec3::new(S::BUDGET.coordinate, S::ZERO, S::ZERO)).expect("within the budget");
    assert!(matches!(far.frame_to_world(&far), Err(FrameError::Position(_))));
}

fn a_cuboid_between_corners_has_its_faces_there<S: Exact>() {
    let mut random = Random(166);
    for _ in 0..times(300) {
        let (a, b) = (random.point::<S>(4.0).to_f64(), random.point::<S>(4.0).to_f64());
        if (0..3).any(|i| (a[i] - b[i]).abs() < 0.01) {
            continue;
        }
        let low: [f64; 3] = core::array::from_fn(|i| a[i].min(b[i]));
        let high: [f64; 3] = core::array::from_fn(|i| a[i].max(b[i]));
        let (cuboid, frame) = Cuboid::between(v::<S>(low), v(high)).expect("corners in order");
        // Within one unit in the last place of the largest coordinate, which is below 4.
        let most = if S::RELATIVE { 2.0 * unit::<S>() } else { unit::<S>() };
        let (low, high) = (v::<S>(low).to_f64(), v::<S>(high).to_f64());
        let (half, centre) = (cuboid.half_extents().map(S::to_f64), frame.position().to_f64());
        for i in 0..3 {
            let faces = [centre[i] - half[i], centre[i] + half[i]];
            assert!((faces[0] - low[i]).abs() <= most && (faces[1] - high[i]).abs() <= most, "{low:?} {high:?}");
        }
    }
}

fn corners_in_the_wrong_order_are_refused<S: Exact>() {
    let (low, high) = (v::<S>([0.0, 0.0, 0.0]), v([1.0, 1.0, 1.0]));
    assert_eq!(Cuboid::between(high, low), Err(SizeError::HalfExtent(ValueError::Negative)));
    assert_eq!(Cuboid::between(low, v([1.0, 0.0, 1.0])), Err(SizeError::HalfExtent(ValueError::Zero)));
    let beyond = Cuboid::between(low, Vec3::new(S::INFINITY, S::ZERO, S::ZERO));
    assert!(matches!(beyond, Err(SizeError::Corner(_))), "{beyond:?}");
}

fn a_plane_from_its_equation_holds_its_points<S: Exact>() {
    let mut random = Random(167);
    for _ in 0..times(300) {
        let normal = random.point::<S>(3.0);
        let [a, b, c] = normal.to_f64();
        let length = (a * a + b * b + c * c).sqrt();
        if length < 0.5 {
            continue;
        }
        let distance = n::<S>(random.between(-4.0, 4.0));
        let (_, frame) = Plane::from_equation(normal, distance).expect("a normal");
        assert!(close(frame.up().to_f64(), [a, b, c].map(|c| c / length), tolerance::<S>()), "{frame:?}");
        let [x, y, z] = frame.position().to_f64();
        let away = (a * x + b * y + c * z - distance.to_f64()).abs() / length;
        assert!(away < 16.0 * unit::<S>(), "{away} {normal:?} {distance:?}");
    }
    assert_eq!(Plane::from_equation(Vec3::<S>::ZERO, n(1.0)), Err(FrameError::Normal(ValueError::NoDirection)));
    let up = v::<S>([0.0, 1.0, 0.0]);
    assert_eq!(Plane::from_equation(up, S::INFINITY), Err(FrameError::Position(ValueError::NotFinite)));
}

fn the_cosine_of_incidence_is_that_of_the_normal<S: Exact>() {
    let mut random = Random(168);
    let floor = Shape::<S>::new(Plane::new());
    for _ in 0..times(100) {
        let direction = any_direction::<S>(&mut random);
        let ray = Ray::new(v::<S>([0.0, 2.0, 0.0]), direction).expect("near");
        let Some(hit) = floor.nearest(&ray) else { continue };
        let cosine = floor.surface(&ray, &hit).cosine().to_f64();
        assert!((cosine + direction.to_f64()[1]).abs() < 2.0 * unit::<S>(), "{cosine} {direction:?}");
    }
    let up = Ray::new(v::<S>([0.0, -2.0, 0.0]), UnitVec3::Y).expect("near");
    let hit = floor.nearest(&up).expect("it looks up");
    assert_eq!(floor.surface(&up, &hit).cosine(), n(1.0));
}
