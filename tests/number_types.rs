//! The promise: every number type agrees with exact arithmetic, within the bounds of one table.
//!
//! `tests/bounds.tsv` is that table: primitive, workload and number type, with the errors of `t` in units in the last
//! place and the hit-or-miss errors. Rays are seeded and results are the same bits everywhere, so that the bounds are what
//! was measured, rounded up in the third digit. `RAYLET_WRITE_BOUNDS=1 cargo test --test number_types` writes it anew;
//! `cargo test --test number_types -- --nocapture` prints it.

mod support;

use fixed::types::{I16F16, I32F32};
use raylet::Ray;
use std::collections::HashMap;
use std::fmt::Write;
use support::exact_types::{Exact, exact_line, expected, same_crossing, same_part};
use support::oracle;
use support::random::Random;
use support::subject::{SUBJECTS, Subject};
use support::workload::{WORKLOADS, Workload};

/// Rays a row.
const RAYS: usize = 2000;
const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/bounds.tsv");

/// What was measured over one row.
#[derive(Default)]
struct Row {
    hits: usize,
    errors: Vec<f64>,
    /// Hits of exact arithmetic that are missing.
    lost: usize,
    /// Hits that exact arithmetic does not have.
    phantom: usize,
    /// Hits within one unit of the range's start that are on the other side of it, in either direction.
    edge: usize,
    /// Hits on another part, or with another crossing.
    part: usize,
}

impl Row {
    fn quantile(&self, fraction: f64) -> f64 {
        if self.errors.is_empty() { 0.0 } else { self.errors[((self.errors.len() - 1) as f64 * fraction) as usize] }
    }
}

fn measure<S: Exact>(subject: &Subject<S>, workload: Workload, seed: u64) -> Option<Row> {
    measure_where(subject, workload, seed, |_| true)
}

/// Of the workload's rays those for which `counts` holds.
fn measure_where<S: Exact>(
    subject: &Subject<S>,
    workload: Workload,
    seed: u64,
    counts: impl Fn(&Ray<S>) -> bool,
) -> Option<Row> {
    let mut random = Random(seed);
    let mut row = Row::default();
    let mut rays = 0;
    for _ in 0..RAYS {
        let Some(ray) = workload.ray(subject, &mut random) else { continue };
        if !counts(&ray) {
            continue;
        }
        rays += 1;
        let (want, got) = (expected(&subject.solid, &ray), subject.shape.hits(&ray));
        assert_eq!(subject.shape.nearest(&ray), got.first().copied(), "nearest is the first of all hits: {ray:?}");
        assert_eq!(subject.shape.occludes(&ray), !got.is_empty(), "occlusion agrees with the hits: {ray:?}");
        let (mut want, mut got) = (want.hits, got.to_vec());
        if want.len() != got.len() {
            // A t of less than half a unit rounds onto the range's start, or off it.
            let unit = |t: &oracle::Root| t.error_in(&S::ZERO.exact(), &S::unit_at(t)) <= 1.0;
            let before = want.len() + got.len();
            want.retain(|hit| !unit(&hit.t));
            got.retain(|hit| hit.t.to_f64().abs() > f64::from(f32::MIN_POSITIVE).max(unit_of::<S>()));
            row.edge += before - want.len() - got.len();
        }
        if want.len() != got.len() {
            row.lost += want.len().saturating_sub(got.len());
            row.phantom += got.len().saturating_sub(want.len());
            continue;
        }
        for (want, got) in want.iter().zip(&got) {
            row.hits += 1;
            if !same_part(got.part, want.part) || !same_crossing(got.crossing, want.crossing) {
                row.part += 1;
            }
            row.errors.push(want.t.error_in(&got.t.exact(), &S::unit_at(&want.t)));
        }
    }
    row.errors.sort_by(f64::total_cmp);
    (rays > 0).then_some(row)
}

/// The smallest positive value of a fixed type; of a float, next to nothing.
fn unit_of<S: Exact>() -> f64 {
    S::BUDGET.smallest_size.to_f64()
}

/// Rounded up in the third significant digit.
fn rounded_up(value: f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let digit = 10.0_f64.powf(value.log10().floor() - 2.0);
    (value / digit).ceil() * digit
}

/// Every row of one number type: key, and the columns median, 99.9 %, worst, lost, phantom, edge, part.
fn rows<S: Exact>() -> Vec<(String, usize, [f64; 7])> {
    let mut rows = vec![];
    for name in SUBJECTS {
        let subject = Subject::<S>::new(name);
        for (index, workload) in WORKLOADS.into_iter().enumerate() {
            let Some(row) = measure(&subject, workload, 1000 + index as u64) else { continue };
            let key = format!("{}\t{name}\t{}", S::name(), workload.name());
            let counts = [row.lost, row.phantom, row.edge, row.part].map(|count| count as f64);
            rows.push((
                key,
                row.hits,
                [row.quantile(0.5), row.quantile(0.999), row.quantile(1.0), counts[0], counts[1], counts[2], counts[3]],
            ));
        }
    }
    rows
}

/// The README shows a few rows: the same figures, or written anew together with the table.
fn check_readme(table: &str) {
    let column = |number: &str, solid: &str, rays: &str| -> Vec<String> {
        let key = format!("{number}\t{solid}\t{rays}\t");
        let line = table.lines().find(|line| line.starts_with(&key)).unwrap();
        line.split('\t').map(String::from).collect()
    };
    let short = |figure: &str| {
        let value: f64 = figure.parse().unwrap();
        if value < 10.0 { format!("{value:.2}") } else { format!("{value:.0}") }
    };
    let mut lines = String::new();
    for solid in ["sphere", "cylinder capped", "capsule", "cone capped"] {
        for rays in ["benign", "10000 away", "grazing 1e-4", "inside"] {
            let mut line = format!("| {solid} | {rays} |");
            let mut wrong = 0;
            for number in ["f32", "I16F16", "I32F32"] {
                let row = column(number, solid, rays);
                write!(line, " {} / {} |", short(&row[4]), short(&row[6])).unwrap();
                wrong += row[7].parse::<usize>().unwrap() + row[8].parse::<usize>().unwrap();
            }
            writeln!(lines, "{line} {wrong} |").unwrap();
        }
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
    let readme = std::fs::read_to_string(path).unwrap();
    let start = readme.find("|---|---|---|---|---|---|\n").expect("the README has the table") + 26;
    let end = readme.find("<!-- /bounds -->").expect("the README marks the table's end");
    if std::env::var_os("RAYLET_WRITE_BOUNDS").is_some() {
        std::fs::write(path, format!("{}{lines}{}", &readme[..start], &readme[end..])).unwrap();
    } else {
        assert_eq!(&readme[start..end], lines, "the README's table is not that of tests/bounds.tsv");
    }
}

#[test]
fn every_row_of_the_table_holds() {
    let rows: Vec<_> = [rows::<f32>(), rows::<f64>(), rows::<I16F16>(), rows::<I32F32>()].concat();
    let mut text = String::from("type\tprimitive\tworkload\thits\tmedian\t99.9%\tworst\tlost\tphantom\tedge\tpart\n");
    for (key, hits, columns) in &rows {
        write!(text, "{key}\t{hits}").unwrap();
        for (index, column) in columns.iter().enumerate() {
            let column = rounded_up(*column);
            if index < 3 { write!(text, "\t{column:.3}").unwrap() } else { write!(text, "\t{column:.0}").unwrap() }
        }
        text.push('\n');
    }
    println!("{text}");
    if std::env::var_os("RAYLET_WRITE_BOUNDS").is_some() {
        std::fs::write(TABLE, &text).unwrap();
    }
    check_readme(&text);
    let bounds = std::fs::read_to_string(TABLE).unwrap();
    let bounds: HashMap<String, Vec<f64>> = bounds
        .lines()
        .skip(1)
        .map(|line| {
            let columns: Vec<&str> = line.split('\t').collect();
            (columns[..3].join("\t"), columns[4..].iter().map(|column| column.parse().unwrap()).collect())
        })
        .collect();
    let mut broken = String::new();
    for (key, _, columns) in &rows {
        let bound = bounds.get(key).unwrap_or_else(|| panic!("tests/bounds.tsv has no row for {key:?}"));
        for (index, (value, bound)) in columns.iter().zip(bound).enumerate() {
            let column = ["median", "99.9%", "worst", "lost", "phantom", "edge", "part"][index];
            // Three decimals are kept.
            if *value > bound + 0.0005 {
                writeln!(broken, "{key}: {column} is {value}, its bound {bound}").unwrap();
            }
        }
    }
    assert!(broken.is_empty(), "bounds broken:\n{broken}");
    assert_eq!(bounds.len(), rows.len(), "tests/bounds.tsv has rows that nothing measures");
}

/// `f32`: half an ulp in the middle, 16 at worst, at every distance, away from grazing.
#[test]
fn the_bar_of_the_default_tier_holds_for_f32() {
    for name in SUBJECTS {
        let subject = Subject::<f32>::new(name);
        for (workload, median) in [
            (Workload::Benign, 0.6),
            (Workload::Away(100.0), 0.6),
            (Workload::Away(1_000.0), 0.6),
            (Workload::Away(10_000.0), 0.6),
            (Workload::ZeroComponents, 0.6),
        ] {
            let row = measure(&subject, workload, 77).unwrap();
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
                let Some(row) = measure_where(&subject, workload, 78, off_asymptotes) else { continue };
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
        for _ in 0..40_000 {
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
