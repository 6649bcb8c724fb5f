//! Rays, ranges and vectors as people have them in hand: segments, vectors of any length, sums and multiples.

use crate::frames::unit;
use dashu::rational::RBig;
use raylet::{Along, Range, Ray, RayError, UnitVec3, ValueError, Vec3};
use support::amount::times;
use support::cases::{n, v};
use support::exact_types::{Exact, exact_line};
use support::random::Random;

every_type!(
    a_segment_ends_where_its_line_is_closest_to_the_end,
    a_segment_longer_than_the_type_is_refused,
    a_range_from_a_start_reaches_as_far_as_the_type,
    a_ray_along_a_vector_tells_distance_in_its_lengths,
    multiples_and_quotients_of_vectors_are_rounded_to_nearest,
    operators_that_assign_do_what_the_others_do,
    a_vector_beyond_the_type_saturates,
);

/// True if no neighbour of the value is closer to the exact one.
fn is_nearest<S: Exact>(value: S, exact: &RBig) -> bool {
    let error = |value: S| {
        let difference = value.exact().to_rational() - exact;
        if difference < RBig::ZERO { -difference } else { difference }
    };
    error(value) <= error(value.next_up()) && error(value) <= error(-(-value).next_up())
}

fn a_segment_ends_where_its_line_is_closest_to_the_end<S: Exact>() {
    let mut random = Random(21);
    for _ in 0..times(1000) {
        let (a, b) = (random.point::<S>(50.0), random.point::<S>(50.0));
        let ray = Ray::segment(a, b).expect("the points differ");
        assert_eq!(ray.without_departure(), Ray::towards(a, b).expect("they differ").with_range(ray.range()));
        assert_eq!(ray.range().start(), S::ZERO);
        let line = exact_line(&ray);
        let direction = ray.direction().to_array().map(|c| S::exact_unit(c).to_rational());
        let (mut product, mut square) = (RBig::ZERO, RBig::ZERO);
        for ((to, from), along) in b.to_array().into_iter().zip(a.to_array()).zip(direction) {
            product += (to.exact().to_rational() - from.exact().to_rational()) * along.clone();
            square += along.clone() * along;
        }
        assert!(is_nearest(ray.range().end(), &(product / square)), "{}: {line:?}", S::name());
    }
    let p = v::<S>([1.0, 2.0, 3.0]);
    assert_eq!(Ray::segment(p, p), Err(RayError::Direction(ValueError::NoDirection)));
}

fn a_segment_longer_than_the_type_is_refused<S: Exact>() {
    let most = S::BUDGET.coordinate;
    let corner = Vec3::new(most, most, most);
    // Across the whole cube: twice the root of three times the coordinate, of which the distance of a fixed type is
    // twice.
    let expected = if S::RELATIVE { None } else { Some(RayError::RangeEnd(ValueError::BeyondBudget)) };
    assert_eq!(Ray::segment(-corner, corner).err(), expected, "{}", S::name());
    assert!(Ray::segment(Vec3::ZERO, corner).is_ok());
}

fn a_range_from_a_start_reaches_as_far_as_the_type<S: Exact>() {
    let far = S::BUDGET.distance;
    for start in [-far, -n::<S>(1.0), S::ZERO, n(2.5), far] {
        assert_eq!(Range::from(start), Range::new(start, far));
    }
    assert_eq!(Range::from(S::ZERO), Ok(Range::FORWARD));
    for bad in [S::INFINITY, -S::INFINITY] {
        assert_eq!(Range::from(bad), Err(RayError::RangeEnd(ValueError::NotFinite)));
    }
}

fn a_ray_along_a_vector_tells_distance_in_its_lengths<S: Exact>() {
    let (origin, vector) = (v::<S>([1.0, 2.0, 3.0]), v::<S>([3.0, 0.0, -4.0]));
    let path = Ray::along(origin, vector).expect("it has a length");
    assert_eq!(path.ray(), Ray::new(origin, UnitVec3::new(vector).expect("a length")).expect("near"));
    assert_eq!(path.length(), n(5.0));
    assert_eq!(path.in_lengths(n(2.0)), n(0.4));
    assert_eq!(path.in_lengths(n(-7.5)), n(-1.5));
    assert_eq!(path.in_lengths(path.length()), n(1.0));
    let mut random = Random(22);
    for _ in 0..times(200) {
        let vector = random.point::<S>(20.0);
        let path: Along<S> = Ray::along(origin, vector).expect("it has a length");
        assert_eq!(path.length(), vector.length());
        let t = n::<S>(random.between(-100.0, 100.0));
        assert!(is_nearest(path.in_lengths(t), &(t.exact().to_rational() / path.length().exact().to_rational())));
    }
    let bad = Vec3::new(S::BUDGET.coordinate.next_up(), S::ZERO, S::ZERO);
    let fault = if bad.x.is_finite() { ValueError::BeyondBudget } else { ValueError::NotFinite };
    assert_eq!(Ray::along(origin, Vec3::ZERO), Err(RayError::Direction(ValueError::NoDirection)));
    assert_eq!(Ray::along(origin, bad), Err(RayError::Direction(fault)));
    assert_eq!(Ray::along(bad, vector), Err(RayError::Origin(fault)));
}

fn multiples_and_quotients_of_vectors_are_rounded_to_nearest<S: Exact>() {
    let mut random = Random(23);
    for _ in 0..times(500) {
        let (vector, factor) = (random.point::<S>(20.0), n::<S>(random.between(-9.0, 9.0)));
        let exact = vector.to_array().map(|c| c.exact().to_rational());
        let by = factor.exact().to_rational();
        for (got, exact) in (vector * factor).to_array().into_iter().zip(&exact) {
            assert!(is_nearest(got, &(exact * &by)), "{}: {vector:?} * {factor:?}", S::name());
        }
        if factor.magnitude() > n(unit::<S>() * 1000.0) {
            for (got, exact) in (vector / factor).to_array().into_iter().zip(&exact) {
                assert!(is_nearest(got, &(exact / &by)), "{}: {vector:?} / {factor:?}", S::name());
            }
        }
    }
}

fn operators_that_assign_do_what_the_others_do<S: Exact>() {
    let (a, b, factor) = (v::<S>([1.0, -2.0, 3.5]), v::<S>([0.25, 8.0, -1.0]), n::<S>(3.0));
    let done = |change: fn(&mut Vec3<S>, Vec3<S>, S)| {
        let mut changed = a;
        change(&mut changed, b, factor);
        changed
    };
    assert_eq!(done(|a, b, _| *a += b), a + b);
    assert_eq!(done(|a, b, _| *a -= b), a - b);
    assert_eq!(done(|a, _, factor| *a *= factor), a * factor);
    assert_eq!(done(|a, _, factor| *a /= factor), a / factor);
}

fn a_vector_beyond_the_type_saturates<S: Exact>() {
    let most = S::BUDGET.distance;
    let vector = Vec3::new(most, -most, S::ZERO);
    let infinite = Vec3::new(S::INFINITY, -S::INFINITY, S::ZERO);
    assert_eq!(vector * n(4.0), infinite, "{}", S::name());
    assert_eq!(vector / n(0.25), infinite, "{}", S::name());
    if !S::RELATIVE {
        assert_eq!(vector / S::ZERO, Vec3::ZERO);
    }
}
