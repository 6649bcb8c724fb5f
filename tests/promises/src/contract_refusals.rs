//! Rules 9 and 10 of the contract: what one-sided surfaces and constructors refuse.

use crate::contract::random_rays;
use fixed::types::I16F16;
use raylet::{
    Capsule, Cone, Crossing, Cylinder, Disc, Error, Frame, FrameError, Range, Ray, RayError, SizeError, Sphere,
    Triangle, UnitVec3, ValueError, Vec3, Visible,
};
use support::cases::{cases, edge_rays, n, v};
use support::exact_types::Exact;

every_type!(
    rule_09_one_sided_surfaces_ignore_crossings_from_the_back,
    rule_10_sizes_are_refused_outside_the_budget_and_taken_at_its_edge,
    rule_10_rays_are_refused_outside_the_budget_and_taken_at_its_edge,
);

fn rule_09_one_sided_surfaces_ignore_crossings_from_the_back<S: Exact>() {
    for case in cases::<S>() {
        let both = case.shape();
        for (ray, _) in random_rays::<S>(13, 300).chain(edge_rays(&case).into_iter().step_by(3)) {
            let all = both.hits(&ray);
            for (visible, unseen) in [(Visible::Outside, Crossing::Exit), (Visible::Inside, Crossing::Enter)] {
                let shape = both.seen_from(visible);
                let hits = shape.hits(&ray);
                let seen: Vec<_> = all.iter().filter(|hit| hit.crossing != unseen).copied().collect();
                assert_eq!(hits.to_vec(), seen, "{}: {visible:?} {ray:?}", case.name);
                assert_eq!(shape.nearest(&ray), seen.first().copied());
                assert_eq!(shape.occludes(&ray), !seen.is_empty());
                assert_eq!(hits.starts_inside(), all.starts_inside());
            }
        }
    }
}

/// Values that no size may have.
fn bad_sizes<S: Exact>() -> Vec<S> {
    let budget = S::BUDGET.size;
    vec![S::ZERO, -n::<S>(1.0), S::INFINITY, -S::INFINITY, budget.next_up(), -budget, -S::BUDGET.smallest_size]
}

/// What is wrong with a value that is not between the least and the largest of the budget.
pub(crate) fn fault<S: Exact>(bad: S) -> ValueError {
    match bad {
        bad if !bad.is_finite() => ValueError::NotFinite,
        bad if bad < S::ZERO => ValueError::Negative,
        bad if bad == S::ZERO => ValueError::Zero,
        _ => ValueError::BeyondBudget,
    }
}

fn rule_10_sizes_are_refused_outside_the_budget_and_taken_at_its_edge<S: Exact>() {
    let one = n::<S>(1.0);
    for bad in bad_sizes::<S>() {
        assert_eq!(Sphere::new(bad), Err(SizeError::Radius(fault(bad))), "{bad:?}");
        assert_eq!(Disc::new(bad), Err(SizeError::Radius(fault(bad))), "{bad:?}");
        assert_eq!(Cylinder::infinite(bad), Err(SizeError::Radius(fault(bad))), "{bad:?}");
        assert_eq!(Cylinder::open(bad, one), Err(SizeError::Radius(fault(bad))), "{bad:?}");
        assert_eq!(Cylinder::open(one, bad), Err(SizeError::Height(fault(bad))), "{bad:?}");
        assert_eq!(Cylinder::capped(bad, one), Err(SizeError::Radius(fault(bad))), "{bad:?}");
        assert_eq!(Cylinder::capped(one, bad), Err(SizeError::Height(fault(bad))), "{bad:?}");
        assert_eq!(Capsule::new(bad, one), Err(SizeError::Radius(fault(bad))), "{bad:?}");
        assert_eq!(Cone::open(one, bad), Err(SizeError::Height(fault(bad))), "{bad:?}");
        assert_eq!(Cone::capped(one, bad), Err(SizeError::Height(fault(bad))), "{bad:?}");
        assert_eq!(Cone::frustum(one, one, bad), Err(SizeError::Height(fault(bad))), "{bad:?}");
        assert_eq!(Cone::frustum_open(one, one, bad), Err(SizeError::Height(fault(bad))), "{bad:?}");
        // Zero may be one radius of a frustum, or a capsule's height.
        let refused = bad != S::ZERO;
        assert_eq!(Capsule::new(one, bad).is_err(), refused, "{bad:?}");
        assert_eq!(Capsule::new(one, bad).err(), refused.then_some(SizeError::Height(fault(bad))));
        assert_eq!(Cone::frustum(bad, one, one).err(), refused.then_some(SizeError::Radius(fault(bad))), "{bad:?}");
        assert_eq!(Cone::frustum(one, bad, one).err(), refused.then_some(SizeError::Radius(fault(bad))), "{bad:?}");
        assert_eq!(
            Cone::frustum_open(bad, one, one).err(),
            refused.then_some(SizeError::Radius(fault(bad))),
            "{bad:?}"
        );
    }
    assert_eq!(Cone::frustum(S::ZERO, S::ZERO, one), Err(SizeError::Radius(ValueError::Zero)));
    let slopes = [S::ZERO, -one, S::INFINITY, -S::INFINITY, S::BUDGET.slope.next_up(), -S::BUDGET.smallest_slope];
    for bad in slopes {
        assert_eq!(Cone::double(bad), Err(SizeError::Slope(fault(bad))), "{bad:?}");
        assert_eq!(Cone::nappe(bad), Err(SizeError::Slope(fault(bad))), "{bad:?}");
        assert_eq!(Cone::open(bad, one), Err(SizeError::Slope(fault(bad))), "{bad:?}");
        assert_eq!(Cone::capped(bad, one), Err(SizeError::Slope(fault(bad))), "{bad:?}");
    }
    for bad in [S::ZERO, -one, n(180.0), n(200.0), S::INFINITY, -S::INFINITY] {
        assert!(matches!(Cone::slope_of_aperture(bad), Err(SizeError::Slope(_))), "{bad:?}");
    }
    for bad in bad_sizes::<S>() {
        assert_eq!(Capsule::from_end_to_end(bad, one), Err(SizeError::Radius(fault(bad))), "{bad:?}");
    }
    for edge in [S::BUDGET.size, S::BUDGET.smallest_size] {
        assert!(Sphere::new(edge).is_ok() && Disc::new(edge).is_ok() && Cylinder::infinite(edge).is_ok(), "{edge:?}");
        assert!(Cylinder::open(edge, edge).is_ok() && Cylinder::capped(edge, edge).is_ok(), "{edge:?}");
        assert!(Capsule::new(edge, edge).is_ok() && Cone::frustum(edge, edge, edge).is_ok(), "{edge:?}");
        assert!(Cone::frustum_open(edge, S::ZERO, edge).is_ok(), "{edge:?}");
    }
    for edge in [S::BUDGET.slope, S::BUDGET.smallest_slope] {
        assert!(Cone::double(edge).is_ok() && Cone::nappe(edge).is_ok(), "{edge:?}");
        assert!(Cone::open(edge, one).is_ok() && Cone::capped(edge, one).is_ok(), "{edge:?}");
    }
    // Vertices: beyond the budget, or on a line.
    let (o, x, y) = (Vec3::ZERO, v::<S>([1.0, 0.0, 0.0]), v::<S>([0.0, 1.0, 0.0]));
    assert!(Triangle::new(o, x, y).is_ok());
    assert_eq!(Triangle::new(o, x, x), Err(SizeError::Vertices));
    assert_eq!(Triangle::new(o, x, -x), Err(SizeError::Vertices));
    assert_eq!(Triangle::new(o, v([0.5, 0.25, 0.75]), v([1.0, 0.5, 1.5])), Err(SizeError::Vertices));
    let most = S::BUDGET.coordinate;
    assert!(Triangle::new(o, Vec3::new(most, S::ZERO, S::ZERO), Vec3::new(S::ZERO, -most, S::ZERO)).is_ok());
    for bad in [most.next_up(), -most.next_up(), S::INFINITY, -S::INFINITY] {
        assert_eq!(
            Triangle::new(o, x, Vec3::new(S::ZERO, bad, S::ZERO)),
            Err(SizeError::Vertex(fault(bad.magnitude()))),
            "{bad:?}"
        );
    }
}

fn rule_10_rays_are_refused_outside_the_budget_and_taken_at_its_edge<S: Exact>() {
    let most = S::BUDGET.coordinate;
    for axis in 0..3 {
        let at = |value: S| {
            let mut components = [S::ZERO; 3];
            components[axis] = value;
            Vec3::from(components)
        };
        for bad in [most.next_up(), -most.next_up(), S::INFINITY, -S::INFINITY] {
            assert_eq!(Ray::new(at(bad), UnitVec3::X), Err(RayError::Origin(fault(bad.magnitude()))), "{bad:?}");
            assert_eq!(
                Ray::towards(at(bad), Vec3::ZERO).err(),
                Some(RayError::Origin(fault(bad.magnitude()))),
                "{bad:?}"
            );
            assert_eq!(Ray::towards(Vec3::ZERO, at(bad)), Err(RayError::Target(fault(bad.magnitude()))), "{bad:?}");
        }
        assert!(Ray::new(at(most), UnitVec3::X).is_ok() && Ray::new(at(-most), UnitVec3::X).is_ok());
        assert!(Ray::towards(at(-most), at(most)).is_ok(), "{}: across the whole budget", S::name());
        assert_eq!(Ray::towards(at(most), at(most)), Err(RayError::Direction(ValueError::NoDirection)));
        assert_eq!(UnitVec3::new(at(S::INFINITY)), Err(ValueError::NotFinite));
    }
    assert_eq!(UnitVec3::<S>::new(Vec3::ZERO), Err(ValueError::NoDirection));
    assert_eq!(UnitVec3::<S>::from_f64([0.0; 3]), Err(ValueError::NoDirection));
    let (one, far) = (n::<S>(1.0), S::BUDGET.distance);
    assert_eq!(Range::new(one, S::ZERO), Err(RayError::Range));
    assert_eq!(Range::new(S::ZERO, S::INFINITY), Err(RayError::RangeEnd(ValueError::NotFinite)));
    assert_eq!(Range::new(-S::INFINITY, S::ZERO), Err(RayError::RangeEnd(ValueError::NotFinite)));
    assert!(Range::new(one, one).is_ok() && Range::new(-far, far).is_ok());
    assert_eq!(Range::new(-far, far), Ok(Range::line()));
    assert_eq!(Range::new(S::ZERO, far), Ok(Range::FORWARD));
}

#[test]
fn rule_10_nan_is_refused_everywhere() {
    fn check<S: Exact>(nan: S) {
        let one = n::<S>(1.0);
        assert_eq!(Sphere::new(nan).err(), Some(SizeError::Radius(ValueError::NotFinite)));
        assert_eq!(Disc::new(nan).err(), Some(SizeError::Radius(ValueError::NotFinite)));
        assert_eq!(Cylinder::infinite(nan).err(), Some(SizeError::Radius(ValueError::NotFinite)));
        assert_eq!(Cylinder::open(one, nan).err(), Some(SizeError::Height(ValueError::NotFinite)));
        assert_eq!(Cylinder::capped(nan, one).err(), Some(SizeError::Radius(ValueError::NotFinite)));
        assert_eq!(Capsule::new(one, nan).err(), Some(SizeError::Height(ValueError::NotFinite)));
        assert_eq!(Cone::double(nan).err(), Some(SizeError::Slope(ValueError::NotFinite)));
        assert_eq!(Cone::nappe(nan).err(), Some(SizeError::Slope(ValueError::NotFinite)));
        assert_eq!(Cone::open(nan, one).err(), Some(SizeError::Slope(ValueError::NotFinite)));
        assert_eq!(Cone::capped(one, nan).err(), Some(SizeError::Height(ValueError::NotFinite)));
        assert_eq!(Cone::frustum(nan, one, one).err(), Some(SizeError::Radius(ValueError::NotFinite)));
        assert_eq!(Cone::frustum(one, nan, one).err(), Some(SizeError::Radius(ValueError::NotFinite)));
        assert_eq!(Cone::frustum_open(one, one, nan).err(), Some(SizeError::Height(ValueError::NotFinite)));
        let (x, bad) = (v::<S>([1.0, 0.0, 0.0]), Vec3::new(S::ZERO, nan, S::ZERO));
        assert_eq!(Triangle::new(Vec3::ZERO, x, bad).err(), Some(SizeError::Vertex(ValueError::NotFinite)));
        assert_eq!(Ray::new(bad, UnitVec3::X).err(), Some(RayError::Origin(ValueError::NotFinite)));
        assert_eq!(Ray::towards(x, bad).err(), Some(RayError::Target(ValueError::NotFinite)));
        assert_eq!(Range::new(nan, one).err(), Some(RayError::RangeEnd(ValueError::NotFinite)));
        assert_eq!(Range::new(S::ZERO, nan).err(), Some(RayError::RangeEnd(ValueError::NotFinite)));
        assert_eq!(UnitVec3::new(bad), Err(ValueError::NotFinite));
        assert_eq!(Frame::at(bad).err(), Some(raylet::FrameError::Position(ValueError::NotFinite)));
    }
    check(f32::NAN);
    check(f64::NAN);
    assert_eq!(UnitVec3::<f32>::from_components([f32::NAN, 0.0, 1.0]), Err(ValueError::NotUnit));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(UnitVec3::<I16F16>::from_f64([0.0, bad, 0.0]), Err(ValueError::NotFinite));
        assert_eq!(Vec3::<f32>::from_f64([0.0, bad, 0.0]), Err(ValueError::NotFinite));
        assert_eq!(Vec3::<I16F16>::from_f64([0.0, bad, 0.0]), Err(ValueError::NotFinite));
    }
    assert_eq!(Vec3::<f32>::from_f64([0.0, 1e39, 0.0]), Err(ValueError::BeyondType));
    assert_eq!(Vec3::<I16F16>::from_f64([0.0, 32768.0, 0.0]), Err(ValueError::BeyondType));
}

#[test]
fn rule_10_every_error_names_the_value_and_the_kind_of_its_fault() {
    let kinds = [
        (ValueError::NotFinite, "is not finite"),
        (ValueError::Negative, "is negative"),
        (ValueError::Zero, "is zero, or was below one unit of the number type and was rounded to zero"),
        (ValueError::BelowBudget, "is below the least that the number type's budget allows"),
        (ValueError::BeyondBudget, "is beyond the number type's budget"),
        (ValueError::BeyondType, "is beyond what the number type can hold"),
        (ValueError::NotUnit, "has a length that is not 1"),
        (ValueError::NoDirection, "has no direction: it is zero"),
    ];
    for (kind, said) in kinds {
        let messages = [
            (Error::from(kind), "the value ".to_string()),
            (SizeError::Radius(kind).into(), "the radius ".to_string()),
            (SizeError::Height(kind).into(), "the height ".to_string()),
            (SizeError::Slope(kind).into(), "the slope (radius over height) ".to_string()),
            (SizeError::Vertex(kind).into(), "a coordinate of a vertex ".to_string()),
            (SizeError::Corner(kind).into(), "a coordinate of a corner ".to_string()),
            (RayError::Origin(kind).into(), "a coordinate of the ray's origin ".to_string()),
            (RayError::Target(kind).into(), "a coordinate of the ray's target ".to_string()),
            (RayError::RangeEnd(kind).into(), "an end of the ray's range ".to_string()),
            (FrameError::Position(kind).into(), "a coordinate of the position ".to_string()),
            (FrameError::Normal(kind).into(), "the normal ".to_string()),
            (FrameError::Axis(kind).into(), "a component of an axis of the matrix ".to_string()),
            (FrameError::Scale(kind).into(), "a factor of the scale ".to_string()),
        ];
        for (error, value) in messages {
            assert_eq!(error.to_string(), value + said);
        }
        assert_eq!((kind.predicate(), kind.message()), (said, kind.to_string().as_str()));
        if !matches!(kind, ValueError::NoDirection | ValueError::Zero) {
            assert_eq!(RayError::Direction(kind).to_string(), format!("the vector of the ray's direction {said}"));
        }
    }
    let messages: [(Error, &str); 7] = [
        (FrameError::Angle.into(), "the angle must lie between -360 and 360 degrees"),
        (
            FrameError::Quaternion.into(),
            "the quaternion must be finite and neither nearly zero nor very long; of length 1 in a constant",
        ),
        (SizeError::Vertices.into(), "the vertices lie on a line, or too nearly so for the number type"),
        (
            RayError::Direction(ValueError::NoDirection).into(),
            "the ray has no direction: the vector is zero, or origin and target are the same point",
        ),
        (RayError::Range.into(), "the ray's range is empty: its start lies above its end"),
        (
            FrameError::Axes.into(),
            "the axes do not span a right-handed frame: two are parallel, or the third points the other way",
        ),
        (
            FrameError::Singular.into(),
            "the matrix has no inverse that the number type could hold: an axis has no length, or the three lie in a plane",
        ),
    ];
    for (error, expected) in messages {
        assert_eq!(error.to_string(), expected);
    }
    // A millionth is no unit of the type.
    let millionth = Sphere::new(I16F16::from_num(1e-6)).expect_err("it is rounded to zero");
    assert_eq!(millionth, SizeError::Radius(ValueError::Zero));
    // A slope has a least value above zero in floats.
    assert_eq!(Cone::double(1e-12_f32), Err(SizeError::Slope(ValueError::BelowBudget)));
}

#[test]
fn rule_10_one_error_takes_all_others_and_says_what_they_say() {
    use raylet::effect::EffectError;
    use raylet::scene::nff::{NffError, Place, Reason};
    use raylet::scene::{CameraError, HierarchyError, SceneError};
    fn check<E: Copy + std::error::Error + Into<Error>>(error: E) {
        assert_eq!(error.into().to_string(), error.to_string());
    }
    check(ValueError::Zero);
    check(SizeError::Vertices);
    check(RayError::Range);
    check(FrameError::Axes);
    check(CameraError::Up);
    check(SceneError::TooManyObjects);
    check(HierarchyError::TooManyObjects);
    check(NffError { place: Place { line: 1, column: 2 }, reason: Reason::NoView });
    check(EffectError::Fog);
    check(EffectError::Outline);
}
