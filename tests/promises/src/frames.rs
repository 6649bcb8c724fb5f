//! Frames and matrices: built as people have them in hand, orthonormal, and refused where they span nothing.

use crate::contract_refusals::fault;
use raylet::{Affine, Capsule, Cone, Cylinder, Frame, FrameError, Placement, SizeError, UnitVec3, ValueError, Vec3};
use support::amount::times;
use support::cases::{n, v};
use support::exact_types::Exact;
use support::oracle;
use support::random::Random;

every_type!(
    a_frame_at_a_position_is_not_turned,
    a_frame_from_base_and_axis_has_that_axis,
    a_frame_between_two_points_has_their_distance,
    a_frame_between_equal_points_is_not_turned_and_has_no_height,
    a_frame_looking_forward_leans_up,
    a_frame_from_left_up_forward_keeps_them,
    a_frame_from_the_centre_begins_half_of_the_height_below,
    a_frame_is_turned_about_an_axis,
    a_cone_has_the_slope_of_its_aperture,
    a_capsule_from_end_to_end_has_its_ends_there,
    frames_are_orthonormal,
    frames_refuse_what_spans_no_frame,
    a_placement_tells_its_axes_and_takes_points_both_ways,
    singular_matrices_are_refused,
);

pub(crate) fn unit<S: Exact>() -> f64 {
    S::unit_at(&oracle::Root::from(&1.0_f32.exact())).to_f64()
}

/// The direction to all the bits of the type, where one given in `f64` has 53.
pub(crate) fn direction<S: Exact>(components: [f64; 3]) -> UnitVec3<S> {
    UnitVec3::new(v(components)).expect("the vector has a length")
}

pub(crate) fn any_direction<S: Exact>(random: &mut Random) -> UnitVec3<S> {
    UnitVec3::from_real(random.unit_vector::<S>().real()).expect("the vector has a length")
}

pub(crate) fn component<S: Exact>() -> f64 {
    match S::name().as_str() {
        "f32" => 2.0_f64.powi(-24),
        "f64" => 2.0_f64.powi(-53),
        "I16F16" => 2.0_f64.powi(-30),
        _ => 2.0_f64.powi(-62),
    }
}

pub(crate) fn exact_dot<S: Exact>(a: UnitVec3<S>, b: UnitVec3<S>) -> oracle::Dyadic {
    let (a, b) = (a.to_array().map(S::exact_unit), b.to_array().map(S::exact_unit));
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

pub(crate) fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
}

fn a_frame_from_the_centre_begins_half_of_the_height_below<S: Exact>() {
    let frame = Frame::from_centre_and_axis(v::<S>([1.0, 2.0, -3.0]), UnitVec3::Z, n(4.0)).expect("position");
    assert_eq!((frame.position(), frame.up()), (v([1.0, 2.0, -5.0]), UnitVec3::Z));
    let edge = Vec3::new(S::BUDGET.coordinate, S::ZERO, S::ZERO);
    let beyond = Frame::from_centre_and_axis(edge, -UnitVec3::X, S::BUDGET.coordinate);
    assert!(matches!(beyond, Err(FrameError::Position(_))), "{beyond:?}");
}

fn a_frame_is_turned_about_an_axis<S: Exact>() {
    let mut random = Random(163);
    let tolerance = 16.0 * component::<S>().max(2.0_f64.powi(-53));
    for _ in 0..times(300) {
        let axis = any_direction::<S>(&mut random);
        let degrees = n::<S>(random.between(-360.0, 360.0));
        let frame = Frame::turned_about(v([0.5, 1.0, 2.0]), axis, degrees).expect("an angle");
        assert_eq!(frame.position(), v([0.5, 1.0, 2.0]));
        // Rodrigues' formula in doubles.
        let (sine, cosine) = degrees.to_f64().to_radians().sin_cos();
        let k = axis.to_f64();
        for (i, axis) in frame.axes().into_iter().enumerate() {
            let mut unit = [0.0; 3];
            unit[i] = 1.0;
            let cross = |j: usize| k[(j + 1) % 3] * unit[(j + 2) % 3] - k[(j + 2) % 3] * unit[(j + 1) % 3];
            let expected = [0, 1, 2].map(|j| unit[j] * cosine + cross(j) * sine + k[j] * k[i] * (1.0 - cosine));
            let got = axis.to_f64();
            assert!(close(got, expected, tolerance), "{}: {got:?}, not {expected:?}, {degrees:?}", S::name());
        }
    }
    let still = Frame::turned_about(v::<S>([0.0; 3]), UnitVec3::X, S::ZERO).expect("an angle");
    assert_eq!(still, Frame::at(v([0.0; 3])).expect("position"));
    for bad in [n(361.0), n(-361.0), S::INFINITY, -S::INFINITY] {
        assert_eq!(Frame::turned_about(v::<S>([0.0; 3]), UnitVec3::X, bad).err(), Some(FrameError::Angle), "{bad:?}");
    }
}

fn a_cone_has_the_slope_of_its_aperture<S: Exact>() {
    for degrees in [1.0, 20.0, 60.0, 90.0, 120.0, 170.0] {
        let slope = Cone::slope_of_aperture(n::<S>(degrees)).expect("an aperture").to_f64();
        let expected = (degrees / 2.0).to_radians().tan();
        let unit = S::unit_at(&oracle::Root::from(&expected.exact())).to_f64();
        // What rounding moves of the angle, the tangent multiplies by x / (sin x cos x).
        let half = (degrees / 2.0).to_radians();
        let most = 4.0 + half / (half.sin() * half.cos());
        assert!((slope - expected).abs() <= most * unit, "{}: {slope}, not {expected}, {degrees} degrees", S::name());
    }
}

fn a_capsule_from_end_to_end_has_its_ends_there<S: Exact>() {
    let capsule = Capsule::from_end_to_end(n::<S>(1.0), n(5.0)).expect("sizes");
    assert_eq!((capsule.radius(), capsule.height()), (n(1.0), n(3.0)));
    assert_eq!(Capsule::from_end_to_end(n::<S>(1.0), n(2.0)).map(|ball| ball.height()), Ok(S::ZERO));
    assert_eq!(Capsule::from_end_to_end(n::<S>(1.0), n(1.5)), Err(SizeError::Height(ValueError::Negative)));
}

fn a_frame_at_a_position_is_not_turned<S: Exact>() {
    let frame = Frame::at(v::<S>([1.0, 2.0, -3.0])).expect("position");
    assert_eq!((frame.left(), frame.up(), frame.forward()), (UnitVec3::X, UnitVec3::Y, UnitVec3::Z));
    assert_eq!(frame.position(), v([1.0, 2.0, -3.0]));
    assert_eq!(frame.point_to_local(v([2.0, 2.5, -3.0])), v([1.0, 0.5, 0.0]));
    assert_eq!(frame.point_to_world(v([1.0, 0.5, 0.0])), v([2.0, 2.5, -3.0]));
    assert_eq!(frame.direction_to_world(UnitVec3::Z), UnitVec3::Z);
}

fn a_frame_from_base_and_axis_has_that_axis<S: Exact>() {
    for along in support::cases::lattice_directions() {
        let axis = direction::<S>(along);
        let frame = Frame::from_base_and_axis(v([1.0, 2.0, 3.0]), axis).expect("position");
        assert_eq!((frame.up(), frame.position()), (axis, v([1.0, 2.0, 3.0])));
        assert_right_handed(&frame);
    }
}

fn a_frame_between_two_points_has_their_distance<S: Exact>() {
    let (frame, height) = Frame::between(v::<S>([1.0, 1.0, 1.0]), v([3.0, 4.0, 7.0])).expect("points");
    assert_eq!((height, frame.position()), (n(7.0), v([1.0, 1.0, 1.0])));
    assert!(close(frame.up().to_f64(), [2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0], 2.0 * component::<S>()));
    assert!(close(
        frame.point_to_world(Vec3::new(S::ZERO, height, S::ZERO)).to_f64(),
        [3.0, 4.0, 7.0],
        4.0 * unit::<S>()
    ));
    assert_right_handed(&frame);
}

fn a_frame_between_equal_points_is_not_turned_and_has_no_height<S: Exact>() {
    let p = v::<S>([1.0, 2.0, 3.0]);
    let (frame, height) = Frame::between(p, p).expect("a point");
    assert_eq!((frame, height), (Frame::at(p).expect("a point"), S::ZERO));
    assert!(Capsule::new(n::<S>(1.0), height).is_ok());
    assert_eq!(Cylinder::capped(n::<S>(1.0), height), Err(SizeError::Height(ValueError::Zero)));
}

fn a_frame_looking_forward_leans_up<S: Exact>() {
    let frame = Frame::looking(v::<S>([0.0, 1.0, 0.0]), UnitVec3::Z, direction([0.0, 1.0, 1.0])).expect("axes");
    assert_eq!((frame.left(), frame.up(), frame.forward()), (UnitVec3::X, UnitVec3::Y, UnitVec3::Z));
    let forward = direction::<S>([1.0, -2.0, 2.0]);
    let frame = Frame::looking(v([0.0, 1.0, 0.0]), forward, UnitVec3::Y).expect("axes");
    assert_eq!(frame.forward(), forward);
    assert!(frame.up().to_f64()[1] > 0.5 && frame.left().to_f64()[1].abs() < 4.0 * component::<S>());
    assert_right_handed(&frame);
}

fn a_frame_from_left_up_forward_keeps_them<S: Exact>() {
    let [left, up, forward] = [[1.0, 2.0, 2.0], [2.0, 1.0, -2.0], [-2.0, 2.0, -1.0]].map(direction::<S>);
    let frame = Frame::from_left_up_forward(Vec3::ZERO, left, up, forward).expect("axes");
    assert_eq!(frame.up(), up);
    assert!(close(frame.left().to_f64(), left.to_f64(), 4.0 * component::<S>()));
    assert!(close(frame.forward().to_f64(), forward.to_f64(), 4.0 * component::<S>()));
    assert_right_handed(&frame);
}

fn assert_right_handed<S: Exact>(frame: &Frame<S>) {
    let (x, y, z) = (frame.left(), frame.up(), frame.forward());
    let one = oracle::Dyadic::from(1);
    let mut worst = 0.0_f64;
    for (a, b) in [(x, y), (y, z), (z, x)] {
        worst = worst.max(exact_dot(a, b).to_f64().abs());
    }
    for a in [x, y, z] {
        worst = worst.max((&exact_dot(a, a) - &one).to_f64().abs());
    }
    // Measured 4.2 for floats, 2.5 for fixed point.
    let bound = if S::name().starts_with('f') { 5.0 } else { 3.0 };
    assert!(worst <= bound * component::<S>(), "{}: {} units off: {frame:?}", S::name(), worst / component::<S>());
    let ([a, b, c], [d, e, f], [g, h, i]) = (x.to_f64(), y.to_f64(), z.to_f64());
    let handed = (b * f - c * e) * g + (c * d - a * f) * h + (a * e - b * d) * i;
    assert!(handed > 0.999, "{}: {frame:?}", S::name());
}

fn frames_are_orthonormal<S: Exact>() {
    let mut random = Random(1);
    for _ in 0..times(3000) {
        let (a, b) = (any_direction::<S>(&mut random), any_direction::<S>(&mut random));
        let position = random.point(100.0);
        assert_right_handed(&Frame::from_base_and_axis(position, a).expect("position"));
        assert_right_handed(&Frame::between(position, random.point(100.0)).expect("points").0);
        if let Ok(frame) = Frame::looking(position, a, b) {
            // Of nearly parallel directions the cross product is all rounding, and still perpendicular to both.
            if exact_dot(a, b).to_f64().abs() < 0.99 {
                assert_right_handed(&frame);
            }
        }
    }
}

fn frames_refuse_what_spans_no_frame<S: Exact>() {
    let most = S::BUDGET.coordinate;
    for bad in [most.next_up(), -most.next_up(), S::INFINITY, -S::INFINITY] {
        let error = FrameError::Position(fault(bad.magnitude()));
        let bad = Vec3::new(S::ZERO, bad, S::ZERO);
        assert_eq!(Frame::at(bad), Err(error));
        assert_eq!(Frame::from_base_and_axis(bad, UnitVec3::X), Err(error));
        assert_eq!(Frame::between(bad, Vec3::ZERO), Err(error));
        assert_eq!(Frame::between(Vec3::ZERO, bad), Err(error));
        assert_eq!(Frame::looking(bad, UnitVec3::X, UnitVec3::Y), Err(error));
    }
    assert!(Frame::at(Vec3::new(most, -most, most)).is_ok());
    let p = v::<S>([1.0, 2.0, 3.0]);
    assert_eq!(Frame::looking(p, UnitVec3::X, UnitVec3::X), Err(FrameError::Axes));
    assert_eq!(Frame::looking(p, UnitVec3::X, -UnitVec3::X), Err(FrameError::Axes));
    // Left-handed, or skew.
    let (x, y, z) = (UnitVec3::X, UnitVec3::Y, UnitVec3::Z);
    assert_eq!(Frame::from_left_up_forward(p, x, y, -z), Err(FrameError::Axes));
    assert_eq!(Frame::from_left_up_forward(p, x, x, z), Err(FrameError::Axes));
    assert_eq!(Frame::from_left_up_forward(p, x, direction([0.5, 1.0, 0.0]), z), Err(FrameError::Axes));
    assert!(Frame::from_left_up_forward(p, x, y, z).is_ok());
}

fn a_placement_tells_its_axes_and_takes_points_both_ways<S: Exact>() {
    let mut random = Random(31);
    for _ in 0..times(200) {
        let position = random.point::<S>(4.0);
        let frame = Frame::looking(position, any_direction(&mut random), any_direction(&mut random)).expect("a frame");
        let scale = [0.5, 1.0, 3.0];
        let affine = Affine::stretched(frame, v(scale)).expect("positive factors");
        let directions = frame.axes().map(UnitVec3::to_f64);
        let placements = [(Placement::World, [1.0; 3]), (frame.into(), [1.0; 3]), (Placement::from(affine), scale)];
        for (placement, scale) in placements {
            let is_world = placement == Placement::World;
            let expected_position = if is_world { Vec3::ZERO } else { position };
            assert_eq!(placement.position(), expected_position);
            let local = random.point::<S>(2.0).to_f64();
            let mut world = expected_position.to_f64();
            for (i, axis) in placement.axes().into_iter().enumerate() {
                let direction =
                    if is_world { [UnitVec3::<f64>::X, UnitVec3::Y, UnitVec3::Z][i].to_f64() } else { directions[i] };
                assert!(close(axis.to_f64(), direction.map(|c| c * scale[i]), 8.0 * unit::<S>()), "{placement:?}");
                for (world, c) in world.iter_mut().zip(direction) {
                    *world += c * scale[i] * local[i];
                }
            }
            let in_world = placement.point_to_world(v(local));
            assert!(close(in_world.to_f64(), world, 64.0 * unit::<S>()), "{placement:?}");
            assert!(close(placement.point_to_local(in_world).to_f64(), local, 64.0 * unit::<S>()), "{placement:?}");
        }
    }
}

fn singular_matrices_are_refused<S: Exact>() {
    let (x, y, z) = (v::<S>([1.0, 0.0, 0.0]), v::<S>([0.0, 1.0, 0.0]), v::<S>([0.0, 0.0, 1.0]));
    let o = Vec3::ZERO;
    for axes in [[o, y, z], [x, o, z], [x, y, o], [x, x, z], [x, y, y], [x, y, v([3.0, 4.0, 0.0])], [x, -x, z]] {
        assert_eq!(Affine::new(o, axes), Err(FrameError::Singular), "{axes:?}");
    }
    assert!(Affine::new(o, [x, y, z]).is_ok() && Affine::new(o, [x, y, v([3.0, 4.0, 0.5])]).is_ok());
    // Left-handed is no reason: a mirror image has an inverse.
    assert!(Affine::new(o, [x, y, -z]).is_ok());
    let far = Vec3::new(S::BUDGET.coordinate.next_up(), S::ZERO, S::ZERO);
    let error = fault(far.x);
    assert_eq!(Affine::new(far, [x, y, z]), Err(FrameError::Position(error)));
    assert_eq!(Affine::new(o, [far, y, z]), Err(FrameError::Axis(error)));
    let frame = Frame::at(o).expect("position");
    for bad in [S::ZERO, -n::<S>(1.0), S::BUDGET.size.next_up(), S::INFINITY] {
        assert_eq!(
            Affine::stretched(frame, Vec3::new(n(1.0), bad, n(1.0))),
            Err(FrameError::Scale(fault(bad))),
            "{bad:?}"
        );
    }
    assert!(Affine::stretched(frame, v([0.5, 1.0, 2.0])).is_ok());
}
