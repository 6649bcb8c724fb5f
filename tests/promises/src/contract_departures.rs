//! Rule 8 of the contract: rays that depart from a surface.

use crate::contract::{off, some_hits};
use raylet::{
    Cone, Crossing, Cylinder, Departure, Leaving, Part, Primitive, Range, Ray, Shape, Sphere, UnitVec3, Vec3,
};
use support::cases::{Kind, cases, cases_of, n, summary, v};
use support::exact_types::{Exact, exact_line};
use support::oracle;
use support::random::Random;

every_type!(
    rule_08_a_ray_leaving_outwards_never_meets_a_convex_solid_again,
    rule_08_a_ray_leaving_inwards_always_meets_the_far_end,
    rule_08_a_ray_said_to_enter_a_cap_that_it_leads_away_from_ends_at_once,
    rule_08_two_surfaces_a_hair_apart_are_both_met,
    rule_08_a_departing_ray_crosses_an_open_surface_only_elsewhere,
);

fn rule_08_a_ray_leaving_outwards_never_meets_a_convex_solid_again<S: Exact>() {
    for case in cases::<S>() {
        if !case.is_convex() {
            continue;
        }
        some_hits(&case, &mut Random(10), 20000, |shape, ray, hit, random| {
            let surface = shape.surface(ray, hit);
            let (any, cosine) = off(surface.normal(), random);
            let any = if cosine < 0.0 { -any } else { any };
            let leaving = Ray::new(surface.point(), any).expect("a point of the surface");
            let leaving = leaving.departing(surface.departure(0, Leaving::Outwards));
            let hits = shape.hits(&leaving);
            assert!(hits.is_empty() && !hits.starts_inside(), "{} in {}: {leaving:?}: {hits:?}", case.name, S::name());
            assert!(!shape.occludes(&leaving) && shape.nearest(&leaving).is_none());
        });
    }
}

fn rule_08_a_ray_leaving_inwards_always_meets_the_far_end<S: Exact>() {
    for case in cases_of::<S>(Kind::Bounded) {
        let mut checked = 0;
        some_hits(&case, &mut Random(11), 20000, |shape, ray, hit, random| {
            let surface = shape.surface(ray, hit);
            let (any, cosine) = off(surface.normal(), random);
            let (any, cosine) = if cosine > 0.0 { (-any, -cosine) } else { (any, cosine) };
            let leaving = Ray::new(surface.point(), any).expect("a point of the surface");
            let leaving = leaving.departing(surface.departure(0, Leaving::Inwards));
            let hits = shape.hits(&leaving);
            let met = hits.len() == 1 && hits[0].crossing == Crossing::Exit && hits[0].t >= S::ZERO;
            assert!(met && hits.starts_inside(), "{} in {}: {leaving:?}: {hits:?}", case.name, S::name());
            assert_eq!(shape.nearest(&leaving), Some(hits[0]));
            // Clear of the surface, the far end is where exact arithmetic has it from the same point.
            checked += 1;
            if matches!(shape.placement(), raylet::Placement::World) && cosine < -0.2 && checked % 8 == 0 {
                let answer = oracle::solve(&case.solid, &exact_line(&leaving));
                let oracle::Answer::Spans(spans) = answer else { panic!("a solid has spans") };
                let far = spans.last().and_then(|span| span.exit.as_ref()).map(|end| end.t.to_f64());
                let Some(far) = far else { panic!("{}: {leaving:?} has no far end", case.name) };
                // The start is off the surface by an ulp or two; at this angle the far end moves by five times that.
                let error = (hits[0].t.to_f64() - far).abs();
                let bound = S::unit_at(&oracle::Root::from(&1.0_f32.exact())).to_f64() * 24.0;
                assert!(error < bound, "{} in {}: {leaving:?}: {hits:?}, exactly {far}", case.name, S::name());
            }
        });
    }
}

fn rule_08_a_ray_said_to_enter_a_cap_that_it_leads_away_from_ends_at_once<S: Exact>() {
    let solids: [Primitive<S>; 3] = [
        Cylinder::capped(n(1.0), n(2.0)).expect("sizes").into(),
        Cone::capped(n(0.5), n(2.0)).expect("sizes").into(),
        Cone::frustum(n(0.5), n(1.5), n(2.0)).expect("sizes").into(),
    ];
    for solid in solids {
        for (part, y, along) in [(Part::Top, 2.0, UnitVec3::Y), (Part::Base, 0.0, -UnitVec3::Y)] {
            // The base of the other two is the apex, or the side closes below it.
            if part == Part::Base && solid != solids[0] {
                continue;
            }
            let shape = Shape::new(solid);
            let ray = Ray::new(v::<S>([0.25, y, 0.0]), along).expect("origin");
            let ray = ray.departing(Departure { object: 0, part, leaving: Leaving::Inwards });
            let hits = shape.hits(&ray);
            assert_eq!(summary(&hits), [(0.0, part, Crossing::Exit)], "{solid:?} in {}", S::name());
            assert_eq!(shape.nearest(&ray), Some(hits[0]));
        }
    }
}

fn rule_08_two_surfaces_a_hair_apart_are_both_met<S: Exact>() {
    // Concentric spheres, 4e-5 or the type's unit apart: a fixed epsilon jumps over the inner one.
    let unit = S::unit_at(&oracle::Root::from(&1.0_f32.exact())).to_f64();
    for gap in [4e-5_f64, 4.0 * unit] {
        let outer = Sphere::new(n::<S>(1.0 + gap)).expect("size");
        let inner = Sphere::new(n::<S>(1.0)).expect("size");
        let ray = Ray::new(v::<S>([0.0, 0.0, 5.0]), -UnitVec3::Z).expect("origin");
        let hit = outer.nearest(&ray).expect("the outer sphere is met");
        let surface = outer.surface(&ray, &hit);
        let inwards = Ray::new(surface.point(), -UnitVec3::Z).expect("a point of the surface");
        let inwards = inwards.departing(surface.departure(7, Leaving::Inwards));
        let exit = outer.nearest(&inwards).expect("the far end is met");
        assert!((exit.t.to_f64() - 2.0 - 2.0 * gap).abs() <= 4.0 * unit, "{}: {exit:?}", S::name());
        // The departure is from the other object: a scene strips it, and so does the test.
        let hit = inner.nearest(&inwards.without_departure()).expect("the inner sphere is met");
        assert!((hit.t.to_f64() - gap).abs() <= 2.0 * unit && hit.t > S::ZERO, "{}: {hit:?}", S::name());
    }
}

fn rule_08_a_departing_ray_crosses_an_open_surface_only_elsewhere<S: Exact>() {
    let mut cases = cases_of::<S>(Kind::Open);
    cases.extend(cases_of(Kind::Unbounded));
    for case in cases {
        some_hits(&case, &mut Random(12), 4000, |shape, ray, hit, random| {
            if !matches!(shape.placement(), raylet::Placement::World) {
                return;
            }
            let surface = shape.surface(ray, hit);
            let (any, cosine) = off(surface.normal(), random);
            let side = if cosine < 0.0 { Leaving::Inwards } else { Leaving::Outwards };
            let start = Ray::new(surface.point(), any).expect("a point of the surface");
            let hits = shape.hits(&start.departing(surface.departure(0, side)));
            if cosine.abs() < 0.05 {
                return;
            }
            // All the ends that exact arithmetic finds from that point, but the one that it starts at.
            let expected = support::exact_types::expected(&case.solid, &start.with_range(Range::line()));
            let apart = 1e-2;
            let elsewhere = expected.hits.iter().filter(|end| end.t.to_f64() > apart).count();
            let here = expected.hits.iter().filter(|end| end.t.to_f64().abs() <= apart).count();
            let near_rim = expected.hits.iter().any(|end| {
                let y = start.origin().y.to_f64() + end.t.to_f64() * start.direction().to_f64()[1];
                case.seams.iter().any(|seam| (y - seam).abs() < apart)
            });
            // At a rim or the apex, or from flat surfaces' own rounding, the start may count as elsewhere or nowhere.
            if near_rim || here > 1 {
                return;
            }
            assert_eq!(hits.len(), elsewhere, "{} in {}: {start:?} {side:?}: {hits:?}", case.name, S::name());
        });
    }
}

#[test]
fn rule_08_a_departure_names_object_part_and_side() {
    let ball = Sphere::new(1.0_f32).expect("size");
    let ray = Ray::new(Vec3::new(0.0, 0.0, 3.0), -UnitVec3::Z).expect("origin");
    let hit = ball.nearest(&ray).expect("a hit");
    let departure = ball.surface(&ray, &hit).departure(42, Leaving::Outwards);
    assert_eq!(departure, Departure { object: 42, part: Part::Side, leaving: Leaving::Outwards });
    assert_eq!(ray.departing(departure).departure(), Some(departure));
    assert_eq!(ray.departing(departure).without_departure(), ray);
}

/// A ray cannot enter through a cap and lead away from it: told so, it ends where it starts, and not on the side's
/// continuation beyond the cap.
#[test]
fn rule_08_a_departure_that_contradicts_its_direction_ends_at_once() {
    let frustum = Cone::frustum(0.5_f32, 1.5, 2.0).expect("sizes");
    let departure = Departure { object: 0, part: Part::Base, leaving: Leaving::Inwards };
    let ray = Ray::new(Vec3::ZERO, -UnitVec3::Y).expect("inside the budget").departing(departure);
    let hits = frustum.hits(&ray);
    assert_eq!(hits.iter().map(|hit| (hit.t, hit.part)).collect::<Vec<_>>(), [(0.0, Part::Base)]);
}
