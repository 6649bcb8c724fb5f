//! What is measured.

use super::super::{placement, solid};
use super::{at, command, measured};
use crate::rays::ALL_NUMBERS;
use std::fmt::Write;
use support::figures::{NUMBERS, TIERS};

/// A ray that grazes a moved cylinder in 1.6e-8 of its radius: `Stable` in `f32` once lost it. Its direction is that
/// which `f32` has stored, of a length that is off by 7.5e-8: it has to come back to the bit.
#[test]
fn a_known_grazing_ray_has_its_known_hits() {
    let options = at("cylinder capped radius 1 height 2", "at -1.66302097 -1.77427542 -1.96638811");
    let outcome = measured(&options, "-2.23305225, -.17313285, 2.11712313, .37017453, -.1486167, -.91699713").unwrap();
    for tier in ["Stable", "Exact"] {
        let (row, extra) = outcome.row("f32", tier);
        assert_eq!((row.hits, row.wrong(), row.broken), (2, 0, 0), "{tier}");
        let worst = extra.worst.as_ref().unwrap();
        let wanted = [("Enter", 4.04474134629404), ("Exit", 4.045097858054859)];
        for (hit, (crossing, t)) in worst.exact.iter().zip(wanted) {
            assert_eq!(hit.surface, Some(["Side".into(), crossing.into()]), "{tier}");
            assert!((hit.t - t).abs() < 1e-14, "{tier}: {}", hit.t);
        }
        assert_eq!(worst.line, 1);
    }
    let answer = &outcome.row("f32", "Exact").1.worst.as_ref().unwrap().hits;
    let nearest = ["4.0447413", "4.0450979"].map(|t| t.parse::<f32>().unwrap());
    assert_eq!(answer.iter().map(|hit| hit.t as f32).collect::<Vec<_>>(), nearest);
}

/// A direction of any length is normalised.
#[test]
fn a_direction_may_have_any_length() {
    let lines = "-3,0.25,0.5, 1,-0.125,-0.25\n-3,0.25,0.5, 8e100,-1e100,-2e100\n-3,0.25,0.5, 8e-100,-1e-100,-2e-100";
    for number in ALL_NUMBERS {
        let options = command(&["my.csv", "-e", "--solid", "sphere radius 1.1", "--number", number]);
        let outcome = measured(&options, lines).unwrap();
        let (row, extra) = outcome.row(number, "Stable");
        assert_eq!((row.hits, row.wrong(), extra.rays, extra.not_held), (6, 0, 3, 0), "{number}");
    }
}

/// Beyond the 32,768 of `I16F16` a ray is counted apart, and the others are measured.
#[test]
fn a_ray_that_a_type_does_not_hold_is_counted_apart() {
    let text = "0,0,100000,0,0,-1,,\n0,0,5,0,0,-1,,\n0,0,5,0,0,-1,40000,";
    let outcome = measured(&at("sphere radius 1", ""), text).unwrap();
    for (number, held, hits) in [("f32", 3, 4), ("f64", 3, 4), ("I16F16", 1, 2), ("I32F32", 3, 4)] {
        let (row, extra) = outcome.row(number, "Stable");
        assert_eq!((extra.rays, extra.not_held, row.hits, row.wrong()), (held, 3 - held, hits, 0), "{number}");
    }
}

#[test]
fn names_of_number_types_take_either_case() {
    let options = command(&["my.csv", "--solid", "plane", "--number", "i16f16", "--number", "F32"]);
    assert_eq!(options.number, ["I16F16", "f32"]);
}

/// A number type that holds none of the rays has a row all the same.
#[test]
fn a_type_that_holds_no_ray_has_a_row() {
    let options = command(&["my.csv", "--solid", "plane", "--number", "I16F16"]);
    let outcome = measured(&options, "0,100000,0,0,-1,0").unwrap();
    let (row, extra) = outcome.row("I16F16", "Stable");
    assert_eq!((row.hits, extra.rays, extra.not_held, &extra.worst), (0, 0, 1, &None));
}

/// All solids at rays from about, in every number type and tier, unplaced and placed: `Exact` has every hit, and
/// `Stable` keeps its promise.
#[test]
fn every_solid_is_measured_in_every_placement() {
    let mut lines = String::new();
    for step in 0..12 {
        let angle = f64::from(step) * 0.55;
        let origin = [6.0 * angle.cos(), 1.3 + 0.4 * f64::from(step % 3), 6.0 * angle.sin()];
        let target = [0.3, f64::from(step % 2) * 0.6, 0.2];
        // At the solid as it is, and at one that is moved.
        for by in [[0.0; 3], [1.0, 2.0, 3.0]] {
            let [x, y, z] = [0, 1, 2].map(|i| origin[i] + by[i]);
            let [dx, dy, dz] = [0, 1, 2].map(|i| target[i] - origin[i]);
            let _ = writeln!(lines, "{x},{y},{z},{dx},{dy},{dz}");
        }
    }
    for solid in solid::EXAMPLES {
        for placement in std::iter::once("").chain(placement::EXAMPLES) {
            let about = format!("{solid}, {placement}");
            let outcome = measured(&at(solid, placement), &lines).unwrap_or_else(|error| panic!("{about}: {error}"));
            assert_eq!(outcome.left_out, [], "{about}");
            for number in NUMBERS {
                for tier in TIERS.into_iter().filter(|tier| *tier != "Exact" || ["f32", "I16F16"].contains(&number)) {
                    let (row, extra) = outcome.row(number, tier);
                    assert!(solid.starts_with(row.primitive), "{about}");
                    assert_eq!((extra.rays, extra.not_held), (24, 0), "{about}");
                    assert!(row.hits + row.counts[0] > 0, "{about}: {number} {tier} has no hit");
                    let is_kept = tier == "Textbook" || row.broken == 0 && row.counts[3] == 0;
                    assert!(is_kept, "{about}: {number} {tier}: {row:?}");
                    let holds_exactly = tier != "Exact" || row.wrong() == 0 && row.errors[2] <= 1.0;
                    assert!(holds_exactly, "{about}: {number} {tier}: {row:?}");
                }
            }
            // The textbook of doubles finds the same hits: the placement is the same for both.
            assert_eq!(outcome.row("f64", "Textbook").0.wrong(), 0, "{about}");
        }
    }
}

/// The placements as tables name them.
#[test]
fn placements_have_the_names_of_the_tables() {
    let name = |text| placement::parse(text).unwrap().map(|placement| placement.name());
    assert_eq!(name(""), None);
    let names = placement::EXAMPLES.map(|example| name(example).unwrap());
    assert_eq!(names, ["moved", "turned", "turned", "turned", "stretched", "stretched", "stretched"]);
    assert_eq!(name("stretched 2 1 1"), Some("stretched"));
}

/// A ray that departs does not meet where it starts, whichever side of the surface its rounded start is on; the
/// textbook, which knows no departures, does.
#[test]
fn a_ray_departs_from_a_part() {
    // From a point next to the side of a cylinder, inwards to the far side and outwards; from the top inwards to the
    // base, and past the start.
    let text = "1.0001,1,0,-1,0,0,,,side,inwards\n0.9999,1,0,1,0,0,,,Side,OUTWARDS\n0.25,2,0,0,-1,0,0,,top,inwards\n\
                0.25,2,0,0,-1,0,3,,top,inwards";
    let outcome = measured(&at("cylinder capped radius 1 height 2", ""), text).unwrap();
    for number in NUMBERS {
        for tier in TIERS.into_iter().filter(|tier| *tier != "Exact" || ["f32", "I16F16"].contains(&number)) {
            let (row, extra) = outcome.row(number, tier);
            if tier == "Textbook" {
                // The side where the first two start, and the top where the third does.
                assert!(row.wrong() > 0, "{number}: {row:?}");
                continue;
            }
            assert_eq!((row.hits, row.wrong(), row.counts[3], row.broken), (2, 0, 0, 0), "{number} {tier}: {row:?}");
            let worst = extra.worst.as_ref().unwrap();
            assert!(worst.exact.iter().all(|hit| hit.surface.as_ref().unwrap()[1] == "Exit"), "{worst:?}");
        }
    }
    // Of the quadric that it leaves, the roots are 0 and -2k/a: 2.0002, where the chord through the start is 2.0001
    // long.
    let first = text.lines().next().unwrap();
    let outcome = measured(&at("cylinder capped radius 1 height 2", ""), first).unwrap();
    let t = outcome.row("f64", "Stable").1.worst.as_ref().unwrap().hits[0].t;
    assert!((t - 2.0002).abs() < 1e-12, "{t}");
}

/// From every part of every solid, to both sides, where the solid stands: `Exact` has every hit.
#[test]
fn every_part_of_every_solid_is_departed_from() {
    for text in solid::EXAMPLES {
        let parts = solid::parts(&solid::parse(text).unwrap());
        let mut lines = String::new();
        for part in parts {
            for leaving in ["inwards", "outwards"] {
                let _ = writeln!(lines, "0.9,1.1,0.3,-0.6,0.2,0.5,,,{part:?},{leaving}");
            }
        }
        for placement in ["", "at 0.1 0.2 0.3 axis 0 0.2 1"] {
            let outcome = measured(&at(text, placement), &lines).unwrap_or_else(|error| panic!("{text}: {error}"));
            for number in ["f32", "I16F16"] {
                let (row, extra) = outcome.row(number, "Exact");
                assert_eq!(
                    (extra.rays, row.wrong(), row.broken),
                    (2 * parts.len(), 0, 0),
                    "{text}, {placement}: {row:?}"
                );
            }
        }
    }
}

/// A range leaves hits out, in the textbook too.
#[test]
fn a_range_of_t_counts() {
    let text = "ox,oy,oz,dx,dy,dz,start,end\n0,0,5,0,0,-1,,\n0,0,5,0,0,-1,4.5,\n0,0,5,0,0,-1,,5.5\n0,0,5,0,0,1,-7,\n0,0,5,0,0,-1,,1e300";
    let outcome = measured(&at("sphere radius 1", ""), text).unwrap();
    for (row, extra) in outcome.study.rows.iter().zip(&outcome.extras) {
        assert_eq!((row.hits, row.wrong(), extra.not_held), (8, 0, 0), "{row:?}");
    }
}

/// The worst ray of a row is told by its line in the file, comments and empty lines counted.
#[test]
fn the_worst_ray_is_told_by_its_line() {
    let text = "# Rays.\r\n\r\nox,oy,oz,dx,dy,dz\r\n5,0.5,0,-1,0,0\r\n# From far away.\r\n4100,0.5,0,-1,0,0\r\n";
    let outcome = measured(&at("sphere radius 1", ""), text).unwrap();
    let (_, extra) = outcome.row("f32", "Textbook");
    assert_eq!(extra.worst.as_ref().map(|worst| worst.line), Some(6));
}

/// What each number type does not hold is left out, with the reason; the others are measured.
#[test]
fn a_type_that_does_not_hold_the_solid_is_left_out() {
    let outcome = measured(&at("sphere radius 100000", ""), "200000,0,0,-1,0,0").unwrap();
    let why = "the radius is beyond what the number type can hold";
    assert_eq!(outcome.left_out, [("I16F16".to_string(), why.to_string())]);
    assert!(outcome.study.rows.iter().all(|row| row.number != "I16F16"));
    assert_eq!(outcome.row("f32", "Stable").0.hits, 2);
}
