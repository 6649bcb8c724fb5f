//! The comparison is fair: every contestant was given the same primitive, and answers the same query.

use raylet::Ray;
use raylet_peers::embedded_3dgfx_rays::has_exact_roots;
use raylet_peers::entrants::Field;
use raylet_peers::errors::{Truth, judge, truths};
use raylet_peers::names::EMBEDDED_3DGFX;
use raylet_peers::rays::{apart, drawn};
use raylet_peers::sizes::PRIMITIVES;
use support::exact_types::exact_line;
use support::subject::Subject;
use support::workload::Workload;

/// What iterations leave at these rays, and approximated square roots; a primitive of another size or in another place
/// is off by more.
fn tolerance() -> f64 {
    if has_exact_roots() { 0.02 } else { 0.2 }
}

/// Every contestant's answers at rays that hit, that miss and that start inside.
fn everyone_agrees_with_exact_arithmetic<S: Field>() {
    for primitive in PRIMITIVES {
        let subject = Subject::<S>::new(primitive);
        let benign = drawn(&subject, Workload::Benign, 200);
        for (kind, found) in ["hits", "misses"].into_iter().zip(apart(&subject, Workload::Benign, &benign)) {
            let found = found.unwrap_or_else(|| panic!("{primitive}: the workload has no {kind}"));
            let hits = truths(&subject.solid, &found);
            let hits = hits.iter().filter(|truth| matches!(truth, Truth::Hit(_))).count();
            assert_eq!(hits, if kind == "hits" { found.len() } else { 0 }, "{primitive}: rays called {kind}");
            everyone_agrees(&subject, &found, |_| 0);
        }
        // From inside, embedded-3dgfx looks at the first hit of a capsule's spheres only and so loses some.
        let loses = |name: &str| if (name, primitive) == (EMBEDDED_3DGFX, "capsule") { 50 } else { 0 };
        everyone_agrees(&subject, &drawn(&subject, Workload::Inside, 200), loses);
    }
}

fn everyone_agrees<S: Field>(subject: &Subject<S>, rays: &[Ray<S>], may_lose: impl Fn(&str) -> usize) {
    let exact = truths(&subject.solid, rays);
    for entrant in S::entrants(subject) {
        let errors = judge(&entrant, rays, &exact);
        let told = format!("{} in {}, {}: {errors:?}", subject.name, S::name(), entrant.name);
        assert_eq!((errors.rays, errors.phantom), (rays.len(), 0), "{told}");
        assert!(errors.lost <= may_lose(entrant.name), "{told}");
        assert!(errors.lengths[2] < tolerance(), "{told}");
    }
}

#[test]
fn in_single_precision() {
    everyone_agrees_with_exact_arithmetic::<f32>();
}

#[test]
fn in_double_precision() {
    everyone_agrees_with_exact_arithmetic::<f64>();
}

/// A contestant that stores a primitive elsewhere has its rays moved there, and the oracle takes them back: to the same
/// line but for the rounding of one number.
#[test]
fn a_moved_ray_is_the_same_ray() {
    let mut moved = 0;
    for primitive in PRIMITIVES {
        let subject = Subject::<f64>::new(primitive);
        for entrant in f64::entrants(&subject) {
            for ray in drawn(&subject, Workload::Benign, 20) {
                let own = entrant.pose.own_ray(&ray);
                let (back, given) = (entrant.pose.exact_line(&own), exact_line(&ray));
                // Upside down is back to front as well, which these solids do not notice.
                let sign = if back.direction[0] == given.direction[0] { 1.0 } else { -1.0 };
                moved += usize::from(!entrant.pose.is_same());
                for axis in [0, 2] {
                    assert_eq!(back.origin[axis].to_f64(), sign * given.origin[axis].to_f64(), "{primitive}");
                }
                let height = if sign < 0.0 { 1.7 - given.origin[1].to_f64() } else { given.origin[1].to_f64() };
                assert!((back.origin[1].to_f64() - height).abs() < 1e-14, "{primitive}: {}", entrant.name);
            }
        }
    }
    assert_eq!(moved > 0, cfg!(feature = "parry"));
}

/// The build without parry is there to show the square roots of a chip.
#[test]
fn without_parry_the_roots_are_approximations() {
    assert_eq!(has_exact_roots(), cfg!(feature = "parry"));
}
