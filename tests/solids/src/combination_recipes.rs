//! Solids that are made of others: tubes and spherical shells whose walls are a ten-thousandth of their radius, domes,
//! lenses and bowls.

use crate::values::{n, point};
use fixed::types::{I8F24, I16F16, I32F32};
use raylet::{
    Combination, Crossing, Cuboid, Cylinder, Exact as ExactTier, Fast, Frame, Hit, Plain, Range, Ray, Scalar, Shape,
    Sphere, Stable, Tier, Tube, UnitVec3, Vec3,
};
use std::fmt::Debug;
use support::call_in_every_tier;
use support::random::{Random, add, scale};

/// The part of a chord at this distance from the centre that is in the wall, once.
fn wall([inner, outer]: [f64; 2], away: f64) -> f64 {
    (outer * outer - away * away).sqrt() - (inner * inner - away * away).sqrt()
}

/// Where a ray enters and leaves: `t` and crossing, checked to alternate.
fn hits<S: Scalar, T: Tier<S>>(hollow: &Combination<'_, S>, ray: &Ray<S>) -> Vec<f64> {
    alternating(&hollow.shape().hits_at::<T>(ray), &(hollow, ray))
}

/// The `t` of hits, which are checked to alternate.
fn alternating<S: Scalar>(hits: &[Hit<S>], what: &dyn Debug) -> Vec<f64> {
    for (index, hit) in hits.iter().enumerate() {
        let expected = if index % 2 == 0 { Crossing::Enter } else { Crossing::Exit };
        assert_eq!(hit.crossing, expected, "{what:#?} {hits:?}");
    }
    hits.iter().map(|hit| hit.t.to_f64()).collect()
}

/// Rays across a tube, as a difference and as a primitive, and across a shell meet the wall twice, and it is as thick
/// as it should be, within `bound`.
fn walls_hold<S: Scalar, T: Tier<S>>(bound: f64) {
    let (radius, thin) = (n::<S>(1.0), n::<S>(1.0 - 1e-4));
    let radii = [thin, radius].map(S::to_f64);
    assert!(thin < radius);
    let mut random = Random(0x7a11);
    for _ in 0..300 {
        let axis = UnitVec3::new(point::<S>(random.direction())).expect("no zero");
        let base = point::<S>(random.direction().map(|x| 4.0 * x));
        let frame = Frame::from_base_and_axis(base, axis).expect("inside the budget");
        let longer = frame.moved_to(frame.point_to_world(Vec3::new(S::ZERO, n(-0.5), S::ZERO))).expect("near");
        let cylinder = |radius: S, height: f64| Shape::new(Cylinder::capped(radius, n(height)).expect("sizes"));
        let tube = [cylinder(radius, 2.0).placed(frame), cylinder(thin, 3.0).placed(longer)];
        let ball = |radius: S| Shape::new(Sphere::new(radius).expect("a size")).placed(frame);
        let shell = [ball(radius), ball(thin)];
        let [tube, shell] = [&tube, &shell].map(|leaves| Combination::difference(leaves).expect("two solids"));

        // Across, beside the axis by up to nine tenths of the radius.
        let away = 1.8 * random.unit() - 0.9;
        let [left, up, forward] = frame.axes().map(UnitVec3::to_f64);
        let at = |y: f64| add(base.to_f64(), add(scale(left, away), add(scale(up, y), scale(forward, -3.0))));
        let across = |y: f64| {
            Ray::new(point(at(y)), UnitVec3::new(point(forward)).expect("no zero")).expect("inside the budget")
        };
        let primitive = Shape::new(Tube::new(thin, radius, n(2.0)).expect("sizes")).placed(frame);
        for (ts, ray) in [
            (hits::<S, T>(&tube, &across(1.0)), across(1.0)),
            (hits::<S, T>(&shell, &across(0.0)), across(0.0)),
            (alternating(&primitive.hits_at::<T>(&across(1.0)), &primitive), across(1.0)),
        ] {
            assert_eq!(ts.len(), 4, "{ray:?} {ts:?}");
            let expected = wall(radii, away);
            for thickness in [ts[1] - ts[0], ts[3] - ts[2]] {
                assert!((thickness - expected).abs() <= bound, "{thickness} and not {expected}: {ray:?}");
            }
        }

        // Along the axis: through the hole, beside the tube, and, in coordinates that are exact, within the wall.
        let beside = |away: f64| {
            let origin = add(base.to_f64(), add(scale(left, away), scale(up, -3.0)));
            Ray::new(point(origin), axis).expect("inside the budget").with_range(Range::line())
        };
        assert_eq!(hits::<S, T>(&tube, &beside(0.9)), [0.0; 0]);
        assert_eq!(hits::<S, T>(&tube, &beside(1.1)), [0.0; 0]);
    }
    let upright = [(radius, 2.0, 0.0), (thin, 3.0, -0.5)].map(|(radius, height, base)| {
        let frame = Frame::at(point([0.0, base, 0.0])).expect("near");
        Shape::new(Cylinder::capped(radius, n(height)).expect("sizes")).placed(frame)
    });
    let tube = Combination::difference(&upright).expect("two solids");
    let within = n::<S>(f64::midpoint(radii[0], radii[1]));
    let ray = Ray::new(Vec3::new(within, n(-3.0), S::ZERO), UnitVec3::Y).expect("inside the budget");
    assert_eq!(hits::<S, T>(&tube, &ray), [3.0, 5.0]);
}

#[test]
fn walls_of_a_ten_thousandth_of_the_radius_hold() {
    // Some units in the last place of coordinates up to 8, over the cosine at nine tenths of the radius.
    let units = |unit: i32| 16.0 * 2f64.powi(unit);
    walls_hold::<f32, Plain>(units(-21));
    walls_hold::<f32, Fast>(units(-21));
    walls_hold::<f32, Stable>(units(-22));
    walls_hold::<f32, ExactTier>(units(-22));
    walls_hold::<f64, Stable>(units(-51));
    walls_hold::<I16F16, Plain>(units(-16));
    walls_hold::<I16F16, Stable>(units(-16));
    walls_hold::<I16F16, ExactTier>(units(-16));
    walls_hold::<I8F24, Stable>(units(-24));
    walls_hold::<I32F32, Stable>(units(-32));
}

/// Whether points along the y axis, and beside it, are in a combination, and whether a ray down that axis agrees.
fn is_made<S: Scalar, T: Tier<S>>(made: &Combination<'_, S>, beside: f64, heights: &[(f64, bool)]) {
    let shape = made.shape();
    let down = Ray::new(point([beside, 8.0, 0.0]), -UnitVec3::<S>::Y).expect("inside the budget");
    let hits = hits::<S, T>(made, &down);
    for (y, is_in) in heights {
        assert_eq!(shape.contains_at::<T>(point([beside, *y, 0.0])), *is_in, "{y} {made:#?}");
        assert_eq!(hits.iter().filter(|t| **t < 8.0 - y).count() % 2 == 1, *is_in, "{y} {hits:?} {made:#?}");
    }
}

#[test]
fn domes_lenses_and_bowls_are_what_the_page_says() {
    fn of<S: Scalar, T: Tier<S>>() {
        let at = |y: f64| Frame::at(point([0.0, y, 0.0])).expect("near");
        let ball = |radius: f64, y: f64| Shape::new(Sphere::new(n::<S>(radius)).expect("a size")).placed(at(y));
        let block = |y: f64| Shape::new(Cuboid::new(n::<S>(3.0), n(2.0), n(3.0)).expect("sizes")).placed(at(y));
        let dome = [ball(2.0, 0.0), block(2.0)];
        let dome = Combination::intersection(&dome).expect("two solids");
        is_made::<S, T>(&dome, 0.5, &[(-0.25, false), (0.25, true), (1.75, true), (2.0, false)]);
        let lens = [ball(2.0, 1.5), ball(2.0, -1.5)];
        let lens = Combination::intersection(&lens).expect("two solids");
        is_made::<S, T>(&lens, 0.25, &[(-0.75, false), (-0.25, true), (0.25, true), (0.75, false)]);
        is_made::<S, T>(&lens, 1.5, &[(-0.25, false), (0.25, false)]);
        let stopped = Shape::new(Cylinder::infinite(n::<S>(0.5)).expect("a size"));
        let stopped = [ball(2.0, 1.5), stopped, ball(2.0, -1.5)];
        let stopped = Combination::intersection(&stopped).expect("three solids");
        is_made::<S, T>(&stopped, 0.25, &[(-0.75, false), (-0.25, true), (0.25, true)]);
        is_made::<S, T>(&stopped, 0.75, &[(-0.25, false), (0.25, false)]);
        let bowl = [ball(2.0, 0.0), ball(1.75, 0.0), block(2.0)];
        let bowl = Combination::difference(&bowl).expect("three solids");
        is_made::<S, T>(&bowl, 0.5, &[(-2.25, false), (-1.8125, true), (-1.0, false), (0.5, false), (1.8125, false)]);
    }
    call_in_every_tier!(of);
}
