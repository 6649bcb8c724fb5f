//! The law of `try_nearest_at`: what it answers is what `nearest_at` answers, to the bit.

use raylet::hit::Undecided;
use raylet::shape::kinds::Combining;
use raylet::{Combination, Ray, Scalar, Shape, Tier, Visible};
use shared::borrowed::Borrowed;
use shared::workload::{PLACEMENTS, QUERIES, Query, RAYS, Rays, SENSED, SOLIDS_BY_NAME, query, sensed};
use support::amount::amount;
use support::call_in_every_tier;

/// Queries of all solids.
fn queries<S: Borrowed>() -> impl Iterator<Item = (&'static str, Rays, Query<S>)> {
    SOLIDS_BY_NAME.into_iter().flat_map(|solid| {
        PLACEMENTS.into_iter().flat_map(move |placed| {
            RAYS.into_iter().flat_map(move |rays| {
                (0..QUERIES)
                    .step_by(amount(4, 1))
                    .filter_map(move |i| Some((solid, rays, query::<S>(solid, placed, rays, i)?)))
            })
        })
    })
}

fn agrees<S: Borrowed, T: Tier<S>>() {
    let [mut decided, mut hits] = [0; 2];
    for (solid, rays, Query { shape, ray }) in queries::<S>() {
        for visible in [Visible::Both, Visible::Outside, Visible::Inside] {
            let shape = shape.seen_from(visible);
            if let Ok(hit) = shape.try_nearest_at::<T>(&ray) {
                assert_eq!(hit, shape.nearest_at::<T>(&ray), "{solid}: {ray:?}");
                (decided, hits) = (decided + 1, hits + usize::from(hit.is_some()));
            }
            if rays == Rays::Departing {
                assert_eq!(shape.try_nearest_at::<T>(&ray), Err(Undecided));
            }
        }
    }
    assert!(decided > 1_000 && hits > 500, "{decided} {hits}");
}

#[test]
fn what_the_first_numbers_decide_all_numbers_do() {
    call_in_every_tier!(agrees);
    call_in_every_tier!(agrees: fixed::types::I8F24, raylet::Plain, raylet::Fast, raylet::Stable, raylet::Exact);
}

/// Of the tests of a range sensor's rays how many it does not decide.
fn undecided<S: Scalar, T: Tier<S>>() -> usize {
    let queries = (0..SENSED).filter_map(sensed::<S>);
    queries.filter(|Query { shape, ray }| shape.try_nearest_at::<T>(ray).is_err()).count()
}

#[test]
fn the_first_numbers_decide_nearly_all_rays_of_a_sensor() {
    use fixed::types::I16F16;
    use raylet::{Fast, Plain, Stable};
    assert_eq!(SENSED, 2_560);
    // What was measured.
    assert_eq!(undecided::<f32, Plain>(), 0);
    assert_eq!(undecided::<I16F16, Plain>(), undecided::<I16F16, Fast>());
    let [fixed, stable, single] =
        [undecided::<I16F16, Fast>(), undecided::<I16F16, Stable>(), undecided::<f32, Fast>()];
    assert_eq!([fixed, stable, single], [17, 17, 0]);
}

#[test]
fn a_combination_is_not_decided() {
    use raylet::{Sphere, UnitVec3, Vec3};
    let ball = Shape::new(Sphere::new(1.0_f32).expect("a radius"));
    let leaves = [ball, ball];
    let both = Combination::union(&leaves).expect("two solids");
    let ray = Ray::new(Vec3::new(0.0, 0.0, 5.0), -UnitVec3::Z).expect("a ray");
    let shape: Shape<f32, Combining<'_, _>> = both.shape();
    assert!(shape.nearest(&ray).is_some());
    assert_eq!(shape.try_nearest(&ray), Err(Undecided));
    assert!(ball.try_nearest(&ray).is_ok_and(|hit| hit.is_some()));
}
