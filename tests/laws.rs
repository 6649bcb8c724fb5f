//! The promise: laws that hold for every primitive, ray and number type, whatever the numbers (`proptest`).
//!
//! Rays are drawn by workload, so that edge cases come as often as plain ones. The generator's seed is fixed: every run sees the
//! same cases.

mod support;

use fixed::types::{I16F16, I32F32};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use raylet::{Crossing, Frame, Range, Ray, Shape, UnitVec3, Vec3};
use support::exact_types::Exact;
use support::random::Random;
use support::subject::{SUBJECTS, Subject};
use support::workload::{WORKLOADS, Workload};

/// A subject, a workload, and the seed of one ray.
type Case = (&'static str, Workload, u64);

/// A law on one ray with a subject.
type LawOn<S> = fn(&Subject<S>, Ray<S>, &mut Random) -> Result<(), TestCaseError>;

fn cases() -> impl Strategy<Value = Case> {
    (prop::sample::select(&SUBJECTS[..]), prop::sample::select(&WORKLOADS[..]), any::<u64>())
}

/// Checks a law on one ray; a draw that fits no ray of the type holds trivially.
fn on<S: Exact>((name, workload, seed): Case, law: LawOn<S>) -> Result<(), TestCaseError> {
    let subject = Subject::<S>::new(name);
    let mut random = Random(seed);
    match workload.ray(&subject, &mut random) {
        Some(ray) => law(&subject, ray, &mut random),
        None => Ok(()),
    }
}

/// What a law may forgive at `t`: some units of the type there, or of the coordinates that went into it.
fn slack<S: Exact>(ray: &Ray<S>, t: f64) -> f64 {
    let reach = ray.origin().to_f64().iter().fold(t.abs(), |most, c| most.max(c.abs())).max(1.0);
    let unit = match S::name().as_str() {
        "f32" => f64::from(f32::EPSILON) * reach,
        "f64" => f64::EPSILON * reach,
        _ => S::BUDGET.smallest_size.to_f64(),
    };
    8.0 * unit
}

/// Defines each law as a `proptest` for every number type.
macro_rules! laws {
    ($($law:ident),+ $(,)?) => {
        $(
            proptest! {
                #![proptest_config(ProptestConfig { cases: 20000, failure_persistence: None, rng_seed: RngSeed::Fixed(0x7261_796c_6574), ..ProptestConfig::default() })]
                #[test]
                fn $law(case in cases()) {
                    on::<f32>(case, law::$law)?;
                    on::<f64>(case, law::$law)?;
                    on::<I16F16>(case, law::$law)?;
                    on::<I32F32>(case, law::$law)?;
                }
            }
        )+
    };
}

laws!(
    enters_and_exits_pair_up,
    nearest_and_occlusion_say_what_the_full_list_says,
    a_hit_lies_on_the_surface,
    a_normal_faces_the_side_that_the_crossing_tells,
    the_interval_holds_the_inside_points_on_the_ray,
    cutting_the_range_drops_hits_and_changes_none,
    the_mirrored_ray_has_the_mirrored_hits,
    turning_the_world_turns_the_hits,
);

mod law {
    use super::*;

    type Law = Result<(), TestCaseError>;

    pub(super) fn enters_and_exits_pair_up<S: Exact>(subject: &Subject<S>, ray: Ray<S>, _: &mut Random) -> Law {
        let hits = subject.shape.hits(&ray.with_range(Range::line()));
        prop_assert!(hits.is_sorted_by(|a, b| a.t <= b.t), "{hits:?}");
        let bounded = [
            "sphere",
            "capsule",
            "cylinder capped",
            "cone capped",
            "frustum capped",
            "frustum widening",
            "frustum pointed",
        ];
        if bounded.contains(&subject.name) {
            let crossings: Vec<Crossing> = hits.iter().map(|hit| hit.crossing).collect();
            prop_assert!(
                matches!(crossings[..], [] | [Crossing::Touch] | [Crossing::Enter, Crossing::Exit]),
                "{ray:?}: {hits:?}"
            );
            prop_assert!(hits.coincident().is_none());
        }
        Ok(())
    }

    pub(super) fn nearest_and_occlusion_say_what_the_full_list_says<S: Exact>(
        subject: &Subject<S>,
        ray: Ray<S>,
        random: &mut Random,
    ) -> Law {
        let end = S::from_f64(random.between(0.0, 10.0)).expect("in range");
        for ray in [ray, ray.with_range(Range::new(S::ZERO, end).expect("in order")), ray.with_range(Range::line())] {
            let hits = subject.shape.hits(&ray);
            prop_assert_eq!(subject.shape.nearest(&ray), hits.first().copied(), "{:?}", ray);
            prop_assert_eq!(subject.shape.occludes(&ray), !hits.is_empty(), "{:?}", ray);
        }
        Ok(())
    }

    pub(super) fn a_hit_lies_on_the_surface<S: Exact>(subject: &Subject<S>, ray: Ray<S>, _: &mut Random) -> Law {
        for hit in &subject.shape.hits(&ray) {
            let (on_ray, on_surface) = (ray.at(hit.t).to_f64(), subject.shape.surface(&ray, hit).point().to_f64());
            let slack = slack(&ray, hit.t.to_f64());
            // Moved onto the surface, a point moves the farther the flatter the ray meets it.
            let normal = subject.shape.surface(&ray, hit).normal().to_f64();
            let facing = support::random::dot(normal, ray.direction().to_f64()).abs().max(1e-6);
            for axis in 0..3 {
                let moved = (on_ray[axis] - on_surface[axis]).abs();
                prop_assert!(moved <= slack / facing, "{ray:?} {hit:?}: {on_ray:?} {on_surface:?}");
            }
        }
        Ok(())
    }

    pub(super) fn a_normal_faces_the_side_that_the_crossing_tells<S: Exact>(
        subject: &Subject<S>,
        ray: Ray<S>,
        _: &mut Random,
    ) -> Law {
        for hit in &subject.shape.hits(&ray) {
            let surface = subject.shape.surface(&ray, hit);
            let facing = support::random::dot(surface.normal().to_f64(), ray.direction().to_f64());
            let slack = slack(&ray, hit.t.to_f64()).sqrt();
            // At an apex the normal is the axis, which no crossing can tell.
            let [x, _, z] = surface.local_point().to_f64();
            if x.hypot(z) < 1e-2 {
                continue;
            }
            match hit.crossing {
                Crossing::Enter => prop_assert!(facing <= slack, "{ray:?} {hit:?}: {facing}"),
                Crossing::Exit => prop_assert!(facing >= -slack, "{ray:?} {hit:?}: {facing}"),
                Crossing::Touch => {}
            }
        }
        Ok(())
    }

    pub(super) fn the_interval_holds_the_inside_points_on_the_ray<S: Exact>(
        subject: &Subject<S>,
        ray: Ray<S>,
        random: &mut Random,
    ) -> Law {
        let hits = subject.shape.hits(&ray.with_range(Range::line()));
        let [enter, exit] = &hits[..] else { return Ok(()) };
        if (enter.crossing, exit.crossing) != (Crossing::Enter, Crossing::Exit) || subject.name.ends_with("open") {
            return Ok(());
        }
        let (low, high) = (enter.t.to_f64(), exit.t.to_f64());
        let margin = slack(&ray, high.abs().max(low.abs())).sqrt();
        // Along the wall, or along a generator, a point of the interval is inside only by rounding.
        let normal = |hit| subject.shape.surface(&ray, hit).normal().to_f64();
        if [enter, exit].iter().any(|hit| support::random::dot(normal(hit), ray.direction().to_f64()).abs() < 1e-2) {
            return Ok(());
        }
        let middle = random.between(low, high);
        if middle - low > margin && high - middle > margin {
            let t = S::from_f64(middle).expect("between two values of the type");
            prop_assert!(subject.shape.contains(ray.at(t)), "{ray:?} at {middle}: {hits:?}");
        }
        let beyond = high + margin * 4.0 + 0.1;
        if let Some(t) = S::from_f64(beyond) {
            prop_assert!(!subject.shape.contains(ray.at(t)), "{ray:?} at {beyond}: {hits:?}");
        }
        Ok(())
    }

    pub(super) fn cutting_the_range_drops_hits_and_changes_none<S: Exact>(
        subject: &Subject<S>,
        ray: Ray<S>,
        random: &mut Random,
    ) -> Law {
        let whole = subject.shape.hits(&ray.with_range(Range::line()));
        let (a, b) = (random.between(-5.0, 10.0), random.between(0.0, 10.0));
        let range = Range::new(S::from_f64(a).expect("in range"), S::from_f64(a + b).expect("in range"));
        let range = range.expect("in order");
        let cut = subject.shape.hits(&ray.with_range(range));
        let kept: Vec<_> = whole.iter().filter(|hit| range.contains(hit.t)).copied().collect();
        prop_assert_eq!(&cut[..], &kept[..]);
        Ok(())
    }

    pub(super) fn the_mirrored_ray_has_the_mirrored_hits<S: Exact>(
        subject: &Subject<S>,
        ray: Ray<S>,
        _: &mut Random,
    ) -> Law {
        if subject.name == "triangle" {
            return Ok(());
        }
        // x to -x: no product changes but in its sign.
        let (o, [dx, dy, dz]) = (ray.origin(), ray.direction().to_array());
        let mirrored =
            Ray::new(Vec3::new(-o.x, o.y, o.z), UnitVec3::from_components([-dx, dy, dz]).expect("as long as before"));
        let mirrored = mirrored.expect("as far as before");
        let (hits, other) = (subject.shape.hits(&ray), subject.shape.hits(&mirrored));
        prop_assert_eq!(&hits[..], &other[..], "{:?}", ray);
        Ok(())
    }

    pub(super) fn turning_the_world_turns_the_hits<S: Exact>(subject: &Subject<S>, ray: Ray<S>, _: &mut Random) -> Law {
        // Quarter turns about the axes change no bit of a coordinate.
        let quarter = |v: Vec3<S>| Vec3::new(v.y, v.z, v.x);
        let (o, [dx, dy, dz]) = (ray.origin(), ray.direction().to_array());
        let turned = Ray::new(quarter(o), UnitVec3::from_components([dy, dz, dx]).expect("as long as before"));
        let frame = Frame::looking(Vec3::ZERO, UnitVec3::Y, UnitVec3::X).expect("perpendicular");
        let shape = Shape::new(*subject.shape.primitive()).placed(frame);
        let (hits, other) = (subject.shape.hits(&ray), shape.hits(&turned.expect("as far as before")));
        if S::name().starts_with('I') {
            prop_assert_eq!(&hits[..], &other[..], "{:?}", ray);
        } else {
            // A float sum depends on the order of its terms, and with it how far the ray steps before it is solved.
            prop_assert_eq!(hits.len(), other.len(), "{:?}", ray);
            for (hit, other) in hits.iter().zip(&other) {
                let slack = slack(&ray, hit.t.to_f64()).sqrt();
                prop_assert!((hit.t.to_f64() - other.t.to_f64()).abs() <= slack, "{ray:?}: {hit:?} {other:?}");
            }
        }
        Ok(())
    }
}
