//! The promise: every tier in every number type agrees with exact arithmetic, within the bounds of one table.
//!
//! The table is `data/bounds`: tier, number type, primitive, placement and workload, with the errors of `t` in units in
//! the last place, the hit-or-miss errors, and how many rays break the tier's promise. Rays are seeded and results are
//! the same bits everywhere, so that the bounds are what was measured, rounded up in the third digit.
//! `cargo run --release -p raylet-accuracy -- --write` renews it.

use fixed::types::{I16F16, I32F32};
use raylet::Ray;
use raylet::tier::Stable;
use std::collections::HashMap;
use std::fmt::Write;
use support::amount::{amount, times};
use support::exact_types::{Exact, exact_line};
use support::figures::{Figures, measure_all};
use support::measure::{measure, measure_where};
use support::random::Random;
use support::subject::{SUBJECTS, Subject};
use support::workload::{WORKLOADS, Workload};
use support::{bounds, oracle};

/// How much smaller than its bound a figure may be: a bound is what was measured plus little.
const SLACK: f64 = 0.05;

/// A row's names.
type Key<'a> = [&'a str; 5];

fn key(row: &Figures) -> Key<'_> {
    [row.tier, &row.number, row.primitive, &row.placed, &row.workload]
}

/// Every row over all of its rays: nothing is worse than its bound, and no bound is larger than it must be. The quick
/// look takes the first rays of each row, which can only tell that none of them is worse than the worst.
#[test]
fn every_row_of_the_table_holds() {
    let rays = amount(bounds::QUICK, bounds::RAYS);
    let measured = measure_all(rays, &|_, _| true, &mut || ());
    let bounds = bounds::all();
    let of: HashMap<_, _> = bounds.iter().map(|row| (key(row), row)).collect();
    let mut broken = String::new();
    for row in &measured {
        let name = format!("{} {} {}, {}", row.tier, row.number, row.primitive, row.name());
        let Some(bound) = of.get(&key(row)) else {
            writeln!(broken, "{name}: the table has no row for it").unwrap();
            continue;
        };
        if rays == bounds::RAYS {
            compare_all(row, bound, &name, &mut broken);
        } else {
            compare_worst(row, bound, &name, &mut broken);
        }
    }
    assert!(
        broken.is_empty(),
        "the table does not hold (cargo run --release -p raylet-accuracy -- --write renews it):\n{broken}"
    );
    assert_eq!(bounds.len(), measured.len(), "the table has rows that nothing measures");
}

const COUNTS: [&str; 5] = ["lost", "phantom", "edge", "part", "integers"];

fn compare_all(row: &Figures, bound: &Figures, name: &str, broken: &mut String) {
    for (column, (value, bound)) in ["median", "99.9%", "worst"].iter().zip(row.errors.iter().zip(&bound.errors)) {
        if value > bound {
            writeln!(broken, "{name}: {column} is {value}, its bound {bound}").unwrap();
        }
        if *value < bound * (1.0 - SLACK) - 0.01 {
            writeln!(broken, "{name}: {column} is {value}, its bound {bound} too large").unwrap();
        }
    }
    for (value, bound) in row.lengths.iter().zip(&bound.lengths) {
        if value > bound || *value < bound * (1.0 - SLACK) {
            writeln!(broken, "{name}: a length is {value:e}, its bound {bound:e}").unwrap();
        }
    }
    for (column, (value, bound)) in COUNTS.iter().zip(row.counts.iter().zip(&bound.counts)) {
        if value != bound {
            writeln!(broken, "{name}: {column} is {value}, in the table {bound}").unwrap();
        }
    }
    compare_broken(row, bound, name, broken);
}

/// No more rays break the tier's promise than the table says.
fn compare_broken(row: &Figures, bound: &Figures, name: &str, broken: &mut String) {
    if let Some(worst) = row.worst.as_ref().filter(|_| row.broken > bound.broken) {
        let (found, known) = (row.broken, bound.broken);
        writeln!(broken, "{name}: {found} rays break the promise, in the table {known}: {}", worst.told).unwrap();
    }
}

fn compare_worst(row: &Figures, bound: &Figures, name: &str, broken: &mut String) {
    let ([.., error], [.., most]) = (row.errors, bound.errors);
    let ([.., length], [.., longest]) = (row.lengths, bound.lengths);
    if error > most || length > longest {
        writeln!(broken, "{name}: the worst is {error} or {length:e}, its bounds {most} and {longest:e}").unwrap();
    }
    for (column, (value, bound)) in COUNTS.iter().zip(row.counts.iter().zip(&bound.counts)) {
        if value > bound {
            writeln!(broken, "{name}: {column} is {value}, in the table {bound}").unwrap();
        }
    }
    compare_broken(row, bound, name, broken);
}

/// `Exact`: nothing wrong, and every `t` of floats rounded correctly but for ties, of fixed point nearly so; placed or
/// not, departing or not.
#[test]
fn the_bar_of_the_exact_tier_holds() {
    for row in bounds::all().iter().filter(|row| row.tier == "Exact") {
        let most = if row.number.starts_with('f') { 0.51 } else { 0.6 };
        assert!(row.errors[2] <= most, "{row:?}");
        assert_eq!(row.counts[..4], [0; 4], "{row:?}");
    }
}

/// What each tier promises of every ray holds in every row (`support::promise`), and with it for solids as they are
/// placed.
#[test]
fn no_row_breaks_what_its_tier_promises() {
    let broken: Vec<_> = bounds::all().into_iter().filter(|row| row.broken > 0).collect();
    let list: Vec<_> = broken.iter().map(|row| format!("{:?}: {} rays", key(row), row.broken)).collect();
    assert!(
        broken.is_empty(),
        "{} rows (cargo run --release -p raylet-accuracy -- --broken shows the rays):\n{}",
        broken.len(),
        list.join("\n")
    );
}

/// `f32`: half an ulp in the middle, 16 at worst, at every distance, away from grazing.
#[test]
fn the_bar_of_the_default_tier_holds_for_f32() {
    for name in SUBJECTS {
        let subject = Subject::<f32>::new(name);
        for (workload, median) in [
            // The formulas: .645 for the open frustum, which has the most of them, and .615 for the infinite cylinder
            // far away.
            (Workload::Benign, 0.66),
            (Workload::Away(100.0), 0.6),
            (Workload::Away(1_000.0), 0.66),
            (Workload::Away(10_000.0), 0.6),
            (Workload::ZeroComponents, 0.6),
        ] {
            let row = measure::<f32, Stable>(&subject, workload, bounds::RAYS.unplaced, 77).unwrap();
            assert!(row.quantile(0.5) <= median, "{name}, {}: median {}", workload.name(), row.quantile(0.5));
            assert!(row.quantile(1.0) <= 16.0, "{name}, {}: worst {}", workload.name(), row.quantile(1.0));
            assert_eq!((row.lost, row.phantom), (0, 0), "{name}, {}", workload.name());
        }
    }
}

/// Fixed point: half a unit in the middle, one at worst, away from axis- and generator-parallel rays.
#[test]
fn the_bar_of_the_default_tier_holds_for_fixed_point() {
    fn check<S: Exact>() {
        for name in SUBJECTS {
            let subject = Subject::<S>::new(name);
            for workload in WORKLOADS {
                if matches!(workload, Workload::NearAxis(_) | Workload::NearGenerator(_)) {
                    continue;
                }
                // A hundredth off an asymptote a hit is far away, and its t as ill-conditioned as it is long.
                let off_asymptotes = |ray: &Ray<S>| {
                    let [x, y, z] = ray.direction().to_f64();
                    (x.hypot(z) - (subject.slope() * y).abs()).abs() > 0.02 || subject.is_flat()
                };
                let Some(row) = measure_where::<S, Stable>(
                    &subject,
                    workload,
                    amount(200, bounds::RAYS.unplaced),
                    78,
                    off_asymptotes,
                    |_, _| false,
                ) else {
                    continue;
                };
                let (median, worst) = (row.quantile(0.5), row.quantile(1.0));
                assert!(median <= 0.5, "{} {name}, {}: median {median}", S::name(), workload.name());
                assert!(worst <= 1.0, "{} {name}, {}: worst {worst}", S::name(), workload.name());
            }
        }
    }
    check::<I16F16>();
    check::<I32F32>();
}

/// From 1,000 away no ray whose impact parameter is 1e-5 (`f32`) or 1e-4 (I16F16) off touching is judged wrongly.
#[test]
fn hit_or_miss_is_right_a_hair_off_touching_from_a_thousand_away() {
    fn check<S: Exact>(off: f64) {
        use raylet::scalar::UnitScalar;
        use raylet::{Cylinder, Shape, Sphere, UnitVec3, Vec3};
        let radius = S::from_f64(1.0).unwrap();
        let solids = [
            (Shape::new(Sphere::new(radius).unwrap()), oracle::Solid::Sphere { radius: radius.exact() }),
            (
                Shape::new(Cylinder::infinite(radius).unwrap()),
                oracle::Solid::Cylinder { radius: radius.exact(), extent: oracle::CylinderExtent::Infinite },
            ),
        ];
        let mut random = Random(5);
        let mut judged = 0;
        for _ in 0..times(40_000) {
            let direction = random.direction();
            let side = random.perpendicular(direction);
            let impact = 1.0 + off * random.sign() * random.between(1.0, 30.0);
            let origin = [0, 1, 2].map(|i| side[i] * impact - direction[i] * 1000.0);
            let origin = Vec3::<S>::from_f64(origin).unwrap();
            let direction = UnitVec3::from_components(direction.map(S::Unit::from_f64)).unwrap();
            let ray = Ray::new(origin, direction).unwrap();
            for (shape, solid) in &solids {
                // The coordinates are rounded at 1,000 away: what the ray as stored does is what counts.
                let exact = oracle::margin(solid, &exact_line(&ray)).unwrap();
                if (exact - 1.0).abs() < off {
                    continue;
                }
                judged += 1;
                assert_eq!(shape.occludes(&ray), exact < 1.0, "{}: impact {exact}: {ray:?}", S::name());
            }
        }
        assert!(judged > 20_000, "{judged} rays were far enough from touching");
    }
    check::<f32>(1e-5);
    check::<I16F16>(1e-4);
    check::<f64>(1e-12);
    check::<I32F32>(1e-8);
}
