//! The promise: laws that hold for every primitive, ray, number type and tier, placed or not, whatever the numbers
//! (`proptest`).
//!
//! Rays are drawn by workload, so that edge cases come as often as plain ones, and run along everything special
//! besides. The generator's seed is fixed: every run sees the same cases. Laws of symmetry are in `laws_symmetry.rs`,
//! laws between tiers in `laws_tiers.rs`, laws of departure in `reintersection.rs`.
//!
//! One bound serves them all, [`support::laws::bound`]: how far from the surface a hit may lie in *space*. It knows
//! nothing of angles, so that a grazing ray is excused of nothing but of `t`.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use raylet::{Crossing, Range, Visible};
use support::exact_types::Exact as Number;
use support::laws::{Graded, Law, Nature, Setting, bound};
use support::oracle::Solid;
use support::random::Random;

laws!(
    a_hit_lies_on_its_part_of_the_surface,
    crossings_pair_up_and_a_start_inside_explains_a_lone_exit,
    nearest_and_occlusion_say_what_the_full_list_says,
    the_inside_test_agrees_with_the_crossings,
    the_interval_holds_the_inside_points_on_the_ray,
    cutting_the_range_drops_hits_and_changes_none,
    a_normal_is_the_gradient_and_faces_the_side_that_the_crossing_tells,
);

mod law {
    use super::*;
    use raylet::{Hit, Ray};
    use support::exact_types::{expected_of, same_crossing, same_part};
    use support::laws::{Grade, number, unit, unit_at, unit_on_the_way};
    use support::laws_distance::{depth, gradient};
    use support::oracle::{self, Dyadic, Membership};
    use support::random::{dot, normalize};

    /// Law 1. In exact numbers, at the `t` that was reported: for `Exact` from the bound of `t` alone.
    pub(super) fn a_hit_lies_on_its_part_of_the_surface<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        _: &mut Random,
    ) -> Law {
        for ray in [setting.ray, setting.ray.with_range(Range::line())] {
            for hit in &setting.shape.hits_at::<T>(&ray) {
                let off = setting.off(&ray, &hit.t.exact(), hit.part);
                let bound = bound::<S, T>(setting, &ray, hit.t);
                support::laws::note::<S, T>("off the surface", setting, off / bound);
                prop_assert!(off <= bound, "{ray:?} {hit:?} is {:.2} bounds off", off / bound);
            }
        }
        Ok(())
    }

    /// Law 2. Whether the ray is inside is told at its start, and every crossing changes it.
    pub(super) fn crossings_pair_up_and_a_start_inside_explains_a_lone_exit<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        random: &mut Random,
    ) -> Law {
        let ends = [(); 2].map(|()| number::<S>(random.between(-8.0, 8.0)).expect("in range"));
        let some = Range::new(ends[0], ends[1]).or(Range::new(ends[1], ends[0])).expect("in order");
        for range in [Range::line(), Range::FORWARD, some] {
            let ray = setting.ray.with_range(range);
            let hits = setting.shape.hits_at::<T>(&ray);
            prop_assert!(hits.is_sorted_by(|a, b| a.t <= b.t), "{ray:?}: {hits:?}");
            prop_assert!(hits.iter().all(|hit| range.contains(hit.t)), "{ray:?}: {hits:?}");
            if hits.coincident().is_some() {
                prop_assert!(hits.is_empty() && !setting.is_bounded(), "{ray:?}: {hits:?}");
                continue;
            }
            if setting.nature == Nature::Open {
                prop_assert!(!hits.starts_inside(), "{ray:?}: {hits:?}");
                // A convex tube is entered before it is left; one of the two may miss it, through an end.
                let crossings: Vec<Crossing> = hits.iter().map(|hit| hit.crossing).collect();
                let flat = ["plane", "disc", "rectangle", "triangle"].contains(&setting.name);
                let paired = match crossings[..] {
                    [] | [Crossing::Enter | Crossing::Exit] => true,
                    [Crossing::Touch] | [Crossing::Enter, Crossing::Exit] => !flat,
                    [Crossing::Exit, Crossing::Enter] => setting.name == "open tower",
                    _ => false,
                };
                prop_assert!(paired, "{ray:?}: {hits:?}");
                continue;
            }
            let mut inside = hits.starts_inside();
            for hit in &hits {
                let fits = match hit.crossing {
                    Crossing::Enter | Crossing::Touch => !inside,
                    Crossing::Exit => inside,
                };
                prop_assert!(fits, "{ray:?}: {hits:?} that starts inside: {}", hits.starts_inside());
                inside = hit.crossing == Crossing::Enter;
            }
            // A convex solid has one interval, a double cone at most two, which make two ends of it.
            let most = if setting.nature == Nature::NotConvex { 4 } else { 2 };
            prop_assert!(hits.len() <= most, "{ray:?}: {hits:?}");
            if setting.is_bounded() && range == Range::line() {
                prop_assert!(!inside && !hits.starts_inside(), "{ray:?}: {hits:?}");
            }
        }
        Ok(())
    }

    /// Law 3, of the three queries.
    pub(super) fn nearest_and_occlusion_say_what_the_full_list_says<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        random: &mut Random,
    ) -> Law {
        let end = number::<S>(random.between(0.0, 10.0)).expect("in range");
        let short = Range::new(S::ZERO, end).expect("in order");
        let mut ranges = vec![setting.ray.range(), short, Range::FORWARD, Range::line()];
        for hit in &setting.shape.hits_at::<T>(&setting.ray.with_range(Range::line())) {
            ranges.extend(support::laws::ranges_next_to(hit.t));
        }
        for range in ranges {
            let ray = setting.ray.with_range(range);
            let hits = setting.shape.hits_at::<T>(&ray);
            prop_assert_eq!(setting.shape.nearest_at::<T>(&ray), hits.first().copied(), "{:?}", ray);
            prop_assert_eq!(setting.shape.occludes_at::<T>(&ray), !hits.is_empty(), "{:?}: {:?}", ray, hits);
            for visible in [Visible::Outside, Visible::Inside] {
                let shape = setting.shape.seen_from(visible);
                let first = shape.hits_at::<T>(&ray).first().copied();
                prop_assert_eq!(shape.nearest_at::<T>(&ray), first, "{:?} from {:?}", ray, visible);
                prop_assert_eq!(shape.occludes_at::<T>(&ray), first.is_some(), "{:?} from {:?}", ray, visible);
            }
        }
        Ok(())
    }

    /// A `t` at which the ray is near the solid, and another at random.
    fn places<S: Number>(setting: &Setting<S>, ray: &Ray<S>, random: &mut Random) -> Vec<S> {
        let from = setting.local_point(ray, &S::ZERO.exact()).map(|c| c.to_f64());
        let one = setting.local_point(ray, &Dyadic::from(1)).map(|c| c.to_f64());
        let along = [0, 1, 2].map(|i| one[i] - from[i]);
        let middle = [from[0], from[1] - 0.8, from[2]];
        let closest = -dot(middle, along) / dot(along, along);
        let mut places: Vec<S> = vec![];
        for t in [closest, closest + random.between(-2.0, 2.0), random.between(-9.0, 9.0)] {
            places.extend(number::<S>(t));
        }
        places
    }

    /// Law 3, of the inside test; for `Exact` it is that of exact arithmetic, without exception.
    pub(super) fn the_inside_test_agrees_with_the_crossings<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        random: &mut Random,
    ) -> Law {
        let ray = setting.ray.with_range(Range::line());
        let hits = setting.shape.hits_at::<T>(&ray);
        for t in places(setting, &ray, random) {
            let point = ray.at(t);
            let exact = setting.pose.point_to_own_frame(&point.to_array().map(S::exact));
            let held = setting.shape.contains_at::<T>(point);
            if T::GRADE == Grade::Exact {
                let holds = oracle::contains(&setting.solid, &exact) != Membership::Outside;
                prop_assert_eq!(held, holds, "{:?} in the frame {:?}", point, exact);
            }
            if setting.nature == Nature::Open {
                continue;
            }
            // Away from the surface: by the bound of the hits and the rounding of the point.
            let deep = depth(&setting.solid, &exact);
            let margin =
                bound::<S, T>(setting, &ray, t) + 2.0 * unit_on_the_way(&ray, t.to_f64()) * setting.pose.growth();
            if deep.abs() <= margin {
                continue;
            }
            let mut inside = hits.starts_inside();
            for hit in hits.iter().take_while(|hit| hit.t <= t) {
                inside = hit.crossing == Crossing::Enter;
            }
            prop_assert_eq!(held, deep > 0.0, "{:?} at {:?} is {} deep", ray, t, deep);
            prop_assert_eq!(held, inside, "{:?} at {:?} is {} deep: {:?}", ray, t, deep, hits);
        }
        Ok(())
    }

    /// Law 7: what is inside in exact numbers lies between the ends; for `Exact` but for the last place of the ends.
    pub(super) fn the_interval_holds_the_inside_points_on_the_ray<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        random: &mut Random,
    ) -> Law {
        if !setting.is_convex() {
            return Ok(());
        }
        let ray = setting.ray.with_range(Range::line());
        let hits = setting.shape.hits_at::<T>(&ray);
        let mut places = places(setting, &ray, random);
        if let [enter, exit] = &hits[..] {
            // A hair inside each end, and anywhere between.
            let (low, high) = (enter.t.to_f64(), exit.t.to_f64());
            for t in [random.between(low, high), low + (high - low) * 1e-6, high - (high - low) * 1e-6] {
                places.extend(number::<S>(t));
            }
        }
        for t in places {
            let exact = setting.local_point(&ray, &t.exact());
            let deep = depth(&setting.solid, &exact);
            let (is_inside, slack) = match T::GRADE {
                Grade::Exact => {
                    let slack = hits.iter().map(|hit| unit_at(hit.t)).fold(0.0, f64::max);
                    (oracle::contains(&setting.solid, &exact) == Membership::Inside, slack)
                }
                _ => (deep > bound::<S, T>(setting, &ray, t), 0.0),
            };
            if !is_inside {
                continue;
            }
            let within = |enter: f64, exit: f64| enter - slack <= t.to_f64() && t.to_f64() <= exit + slack;
            let held = match &hits[..] {
                [] => hits.starts_inside(),
                [one] if one.crossing == Crossing::Enter => within(one.t.to_f64(), f64::INFINITY),
                [one] if one.crossing == Crossing::Exit => within(-f64::INFINITY, one.t.to_f64()),
                [first, .., last] => within(first.t.to_f64(), last.t.to_f64()),
                [touch] => within(touch.t.to_f64(), touch.t.to_f64()),
            };
            prop_assert!(held, "{ray:?} at {t:?} is {deep} deep: {hits:?}");
        }
        Ok(())
    }

    pub(super) fn cutting_the_range_drops_hits_and_changes_none<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        random: &mut Random,
    ) -> Law {
        let whole = setting.shape.hits_at::<T>(&setting.ray.with_range(Range::line()));
        let (a, b) = (random.between(-5.0, 10.0), random.between(0.0, 10.0));
        let range = Range::new(number::<S>(a).expect("in range"), number(a + b).expect("in range")).expect("in order");
        // `Exact` compares the exact end with the range's, not the rounded one: within a unit of each other the two may
        // differ. In fixed point it computes in another number within 4 units.
        let at_end =
            |t: S| [range.start(), range.end()].iter().any(|end| (t.to_f64() - end.to_f64()).abs() <= 4.0 * unit_at(t));
        if T::GRADE == Grade::Exact && whole.iter().any(|hit| at_end(hit.t)) {
            return Ok(());
        }
        let ray = setting.ray.with_range(range);
        let cut = setting.shape.hits_at::<T>(&ray);
        let kept: Vec<_> = whole.iter().filter(|hit| range.contains(hit.t)).copied().collect();
        prop_assert_eq!(&cut[..], &kept[..], "{:?}", ray);
        if whole.coincident().is_none() && setting.nature != Nature::Open {
            let mut inside = whole.starts_inside();
            for hit in whole.iter().take_while(|hit| hit.t < range.start()) {
                inside = hit.crossing == Crossing::Enter;
            }
            prop_assert_eq!(cut.starts_inside(), inside, "{:?}: {:?}, {:?}", ray, cut, whole);
        }
        Ok(())
    }

    /// The parameter of the hit in exact numbers; of a hit that exact arithmetic does not have, within the promise of
    /// its tier, the one that was told.
    fn exact_parameter<S: Number>(setting: &Setting<S>, ray: &Ray<S>, hit: &Hit<S>) -> Dyadic {
        let told = hit.t.exact();
        let exact = expected_of(&setting.solid, &setting.local_line(ray), ray);
        let same =
            exact.hits.iter().filter(|it| same_part(hit.part, it.part) && same_crossing(hit.crossing, it.crossing));
        same.map(|it| it.t.approximation(160)).min_by_key(|t| (t - &told).magnitude()).unwrap_or(told)
    }

    /// Law 10: the normal is the gradient's direction at the exact point of the ray, as far as a point that is off by
    /// the bound can tell; and it faces the side that the crossing tells. In tiers that promise no `t` next to grazing
    /// it may be that of the exact hit.
    pub(super) fn a_normal_is_the_gradient_and_faces_the_side_that_the_crossing_tells<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        _: &mut Random,
    ) -> Law {
        let ray = setting.ray;
        for hit in &setting.shape.hits_at::<T>(&ray) {
            let local = setting.local_point(&ray, &hit.t.exact());
            let outwards = gradient(&setting.solid, support::exact_types::oracle_part(hit.part), &local);
            let off = bound::<S, T>(setting, &ray, hit.t) + 2.0 * unit_on_the_way(&ray, hit.t.to_f64());
            // Around the axis a normal turns the more the nearer to it; at an apex it is the axis, which no crossing
            // can tell.
            let from_axis = local[0].to_f64().hypot(local[2].to_f64());
            let curved = hit.part == raylet::Part::Side || setting.name.starts_with("capsule");
            let around = match &setting.solid {
                Solid::Torus { minor, .. } => minor.to_f64().min(from_axis),
                _ if setting.name.starts_with("sphere") || setting.name.starts_with("capsule") => 1.0,
                _ => from_axis,
            };
            if curved && around < 64.0 * off || outwards == [0.0; 3] {
                continue;
            }
            let normal = setting.shape.surface(&ray, hit).normal().to_f64();
            let exact = normalize(setting.pose.normal_to_world(outwards));
            // A direction of the type is right to its last bits; stretched, angles grow by the square of the greatest
            // stretch.
            let turn = (off / around + unit::<S>().min(2.0_f64.powi(-22))) * setting.pose.growth().powi(2);
            let apart_from = |exact: [f64; 3]| (0..3).fold(0.0, |most: f64, i| most.max((normal[i] - exact[i]).abs()));
            let mut apart = apart_from(exact);
            if apart > turn && matches!(T::GRADE, Grade::Plain | Grade::Fast) {
                let local = setting.local_point(&ray, &exact_parameter(setting, &ray, hit));
                let outwards = gradient(&setting.solid, support::exact_types::oracle_part(hit.part), &local);
                apart = apart.min(apart_from(normalize(setting.pose.normal_to_world(outwards))));
            }
            support::laws::note::<S, T>("normal", setting, apart / turn);
            prop_assert!(apart <= turn, "{ray:?} {hit:?}: {normal:?}, exactly {exact:?}, {:.2} bounds", apart / turn);
            // A ray along the surface may be on either side of it by rounding.
            let facing = dot(exact, ray.direction().to_f64());
            let slack = turn + (2.0 * off).sqrt();
            match hit.crossing {
                Crossing::Enter => prop_assert!(facing <= slack, "{ray:?} {hit:?}: {facing}"),
                Crossing::Exit => prop_assert!(facing >= -slack, "{ray:?} {hit:?}: {facing}"),
                Crossing::Touch => {}
            }
        }
        Ok(())
    }
}
