//! Rules 9 and 10 of the contract: what one-sided surfaces and constructors refuse.

use crate::contract::random_rays;
use raylet::{
    Capsule, Cone, Crossing, Cylinder, Disc, Frame, Range, Ray, RayError, SizeError, Sphere, Triangle, UnitVec3, Vec3,
    Visible,
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

fn rule_10_sizes_are_refused_outside_the_budget_and_taken_at_its_edge<S: Exact>() {
    let one = n::<S>(1.0);
    for bad in bad_sizes::<S>() {
        assert_eq!(Sphere::new(bad), Err(SizeError::Radius), "{bad:?}");
        assert_eq!(Disc::new(bad), Err(SizeError::Radius), "{bad:?}");
        assert_eq!(Cylinder::infinite(bad), Err(SizeError::Radius), "{bad:?}");
        assert_eq!(Cylinder::open(bad, one), Err(SizeError::Radius), "{bad:?}");
        assert_eq!(Cylinder::open(one, bad), Err(SizeError::Height), "{bad:?}");
        assert_eq!(Cylinder::capped(bad, one), Err(SizeError::Radius), "{bad:?}");
        assert_eq!(Cylinder::capped(one, bad), Err(SizeError::Height), "{bad:?}");
        assert_eq!(Capsule::new(bad, one), Err(SizeError::Radius), "{bad:?}");
        assert_eq!(Cone::open(one, bad), Err(SizeError::Height), "{bad:?}");
        assert_eq!(Cone::capped(one, bad), Err(SizeError::Height), "{bad:?}");
        assert_eq!(Cone::frustum(one, one, bad), Err(SizeError::Height), "{bad:?}");
        assert_eq!(Cone::frustum_open(one, one, bad), Err(SizeError::Height), "{bad:?}");
        // Zero may be one radius of a frustum, or a capsule's height.
        let refused = bad != S::ZERO;
        assert_eq!(Capsule::new(one, bad).is_err(), refused, "{bad:?}");
        assert_eq!(Capsule::new(one, bad).err(), refused.then_some(SizeError::Height));
        assert_eq!(Cone::frustum(bad, one, one).err(), refused.then_some(SizeError::Radius), "{bad:?}");
        assert_eq!(Cone::frustum(one, bad, one).err(), refused.then_some(SizeError::Radius), "{bad:?}");
        assert_eq!(Cone::frustum_open(bad, one, one).err(), refused.then_some(SizeError::Radius), "{bad:?}");
    }
    assert_eq!(Cone::frustum(S::ZERO, S::ZERO, one), Err(SizeError::Radius));
    let slopes = [S::ZERO, -one, S::INFINITY, -S::INFINITY, S::BUDGET.slope.next_up(), -S::BUDGET.smallest_slope];
    for bad in slopes {
        assert_eq!(Cone::double(bad), Err(SizeError::Slope), "{bad:?}");
        assert_eq!(Cone::nappe(bad), Err(SizeError::Slope), "{bad:?}");
        assert_eq!(Cone::open(bad, one), Err(SizeError::Slope), "{bad:?}");
        assert_eq!(Cone::capped(bad, one), Err(SizeError::Slope), "{bad:?}");
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
        assert_eq!(Triangle::new(o, x, Vec3::new(S::ZERO, bad, S::ZERO)), Err(SizeError::Vertices), "{bad:?}");
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
            assert_eq!(Ray::new(at(bad), UnitVec3::X), Err(RayError::Origin), "{bad:?}");
            assert_eq!(Ray::towards(at(bad), Vec3::ZERO).err(), Some(RayError::Origin), "{bad:?}");
            assert_eq!(Ray::towards(Vec3::ZERO, at(bad)), Err(RayError::Direction), "{bad:?}");
        }
        assert!(Ray::new(at(most), UnitVec3::X).is_ok() && Ray::new(at(-most), UnitVec3::X).is_ok());
        assert!(Ray::towards(at(-most), at(most)).is_ok(), "{}: across the whole budget", S::name());
        assert_eq!(Ray::towards(at(most), at(most)), Err(RayError::Direction));
        assert_eq!(UnitVec3::new(at(S::INFINITY)), None);
    }
    assert_eq!(UnitVec3::<S>::new(Vec3::ZERO), None);
    let (one, far) = (n::<S>(1.0), S::BUDGET.distance);
    assert_eq!(Range::new(one, S::ZERO), Err(RayError::Range));
    assert_eq!(Range::new(S::ZERO, S::INFINITY), Err(RayError::Range));
    assert_eq!(Range::new(-S::INFINITY, S::ZERO), Err(RayError::Range));
    assert!(Range::new(one, one).is_ok() && Range::new(-far, far).is_ok());
    assert_eq!(Range::new(-far, far), Ok(Range::line()));
    assert_eq!(Range::new(S::ZERO, far), Ok(Range::FORWARD));
}

#[test]
fn rule_10_nan_is_refused_everywhere() {
    fn check<S: Exact>(nan: S) {
        let one = n::<S>(1.0);
        assert_eq!(Sphere::new(nan).err(), Some(SizeError::Radius));
        assert_eq!(Disc::new(nan).err(), Some(SizeError::Radius));
        assert_eq!(Cylinder::infinite(nan).err(), Some(SizeError::Radius));
        assert_eq!(Cylinder::open(one, nan).err(), Some(SizeError::Height));
        assert_eq!(Cylinder::capped(nan, one).err(), Some(SizeError::Radius));
        assert_eq!(Capsule::new(one, nan).err(), Some(SizeError::Height));
        assert_eq!(Cone::double(nan).err(), Some(SizeError::Slope));
        assert_eq!(Cone::nappe(nan).err(), Some(SizeError::Slope));
        assert_eq!(Cone::open(nan, one).err(), Some(SizeError::Slope));
        assert_eq!(Cone::capped(one, nan).err(), Some(SizeError::Height));
        assert_eq!(Cone::frustum(nan, one, one).err(), Some(SizeError::Radius));
        assert_eq!(Cone::frustum(one, nan, one).err(), Some(SizeError::Radius));
        assert_eq!(Cone::frustum_open(one, one, nan).err(), Some(SizeError::Height));
        let (x, bad) = (v::<S>([1.0, 0.0, 0.0]), Vec3::new(S::ZERO, nan, S::ZERO));
        assert_eq!(Triangle::new(Vec3::ZERO, x, bad).err(), Some(SizeError::Vertices));
        assert_eq!(Ray::new(bad, UnitVec3::X).err(), Some(RayError::Origin));
        assert_eq!(Ray::towards(x, bad).err(), Some(RayError::Direction));
        assert_eq!(Range::new(nan, one).err(), Some(RayError::Range));
        assert_eq!(Range::new(S::ZERO, nan).err(), Some(RayError::Range));
        assert_eq!(UnitVec3::new(bad), None);
        assert_eq!(Frame::at(bad).err(), Some(raylet::FrameError::Position));
    }
    check(f32::NAN);
    check(f64::NAN);
    assert_eq!(UnitVec3::<f32>::from_components([f32::NAN, 0.0, 1.0]), None);
}

#[test]
fn rule_10_every_error_says_what_to_do() {
    use raylet::FrameError;
    let messages = [
        (SizeError::Radius.to_string(), "the radius must be positive and within the number type's budget"),
        (SizeError::Height.to_string(), "the height must be positive and within the number type's budget"),
        (
            SizeError::Slope.to_string(),
            "the slope (radius over height) must be positive and within the number type's budget",
        ),
        (
            SizeError::Vertices.to_string(),
            "the vertices must be within the number type's budget and must not lie on a line",
        ),
        (
            RayError::Origin.to_string(),
            "the ray's origin is not finite or beyond the number type's budget: move it closer",
        ),
        (RayError::Direction.to_string(), "the ray's direction is zero or not finite: give a vector with a length"),
        (RayError::Range.to_string(), "the ray's range is empty or not finite: its start must not lie above its end"),
        (
            FrameError::Position.to_string(),
            "the position is not finite or beyond the number type's budget: move it closer",
        ),
        (
            FrameError::Axes.to_string(),
            "the axes do not span a right-handed frame: give points that differ and directions that are not parallel",
        ),
        (
            FrameError::Singular.to_string(),
            "the matrix is singular: every axis needs a length, and no two may be parallel",
        ),
    ];
    for (message, expected) in messages {
        assert_eq!(message, expected);
    }
    // Errors are values that `?` carries into a box.
    let boxed: Box<dyn std::error::Error> = SizeError::Radius.into();
    assert_eq!(boxed.to_string(), "the radius must be positive and within the number type's budget");
}
