//! The oracle against known answers.

use crate::oracle::*;
use crate::oracle_drawn::*;

use support::amount::times;
use support::oracle::{
    Answer, ConeExtent, CylinderExtent, Dyadic, ExpectedCrossing, Line, Membership, Part, Root, Solid, contains,
    gradient, hits_in_range, margin, normal, solve,
};

#[test]
fn lines_and_solids_scale_together() {
    // Far apart exponents leave the answer alone, but for the unit of the direction.
    let mut random = Random(6);
    for _ in 0..times(300) {
        let line = random.line();
        let scaled =
            Line::new(line.origin.each_ref().map(|x| x.scaled(-90)), line.direction.each_ref().map(|x| x.scaled(70)));
        let back = Dyadic::power_of_two(160);
        for (solid, small) in [
            (capsule(1.5, 2.0), capsule(1.5 * 2f64.powi(-90), 2f64.powi(-89))),
            (frustum(2.0, 1.0, 2.0, true), frustum(2f64.powi(-89), 2f64.powi(-90), 2f64.powi(-89), true)),
            (cone(0.5, ConeExtent::Capped(number(2.0))), cone(0.5, ConeExtent::Capped(number(2f64.powi(-89))))),
        ] {
            let expected = ends(&solve(&solid, &line));
            let found = ends(&solve(&small, &scaled));
            assert_eq!(expected.len(), found.len());
            for ((t, part), (small_t, small_part)) in expected.iter().zip(&found) {
                assert_eq!(*t, small_t.mul_add(&back, &Dyadic::zero()));
                assert_eq!(part, small_part);
            }
        }
    }
}

#[test]
fn normals_are_unit_and_face_outwards() {
    let mut random = Random(7);
    let little = Dyadic::power_of_two(-60);
    let mut checked = 0;
    for _ in 0..times(300) {
        let line = random.line();
        for solid in solids() {
            let Answer::Spans(spans) = solve(&solid, &line) else {
                continue;
            };
            for (end, entering) in spans
                .iter()
                .flat_map(|span| [(&span.enter, true), (&span.exit, false)])
                .filter_map(|(end, entering)| Some((end.as_ref()?, entering)))
            {
                let facing = normal(&solid, end.part, &end.t, &line);
                let square = facing.iter().map(Dyadic::squared).reduce(|sum, next| &sum + &next).unwrap();
                let excess = (&square - &Dyadic::from(1)).magnitude();
                assert!(excess < Dyadic::power_of_two(-110), "{facing:?}");
                let longer = gradient(&solid, end.part, &end.t, &line);
                assert!((0..3).all(|axis| longer[axis].signum() == facing[axis].signum()));
                // A little along the normal from the point is outside, whatever part shares the point.
                let point: [Dyadic; 3] =
                    std::array::from_fn(|axis| line.coordinate_at(&end.t, axis).approximation(200));
                let beyond: [Dyadic; 3] = std::array::from_fn(|axis| &point[axis] + &(&little * &facing[axis]));
                // But at the apex of a double cone, where the axis leads into the other nappe.
                let double = matches!(&solid, Solid::Cone { extent: ConeExtent::Double, .. });
                if double && line.coordinate_at(&end.t, 1).signum() == 0 {
                    continue;
                }
                assert_eq!(contains(&solid, &beyond), Membership::Outside, "{solid:?}\n{line:?}\n{end:?}");
                let along =
                    (0..3).map(|axis| &facing[axis] * &line.direction[axis]).reduce(|sum, next| &sum + &next).unwrap();
                // At a rim the line may come in by way of the cap, against the side's normal.
                let smooth = matches!(solid, Solid::Sphere { .. } | Solid::Capsule { .. });
                if smooth && along.magnitude() > Dyadic::power_of_two(-100) {
                    assert_eq!(along.signum() < 0, entering, "{solid:?}\n{line:?}\n{end:?}");
                }
                // The normal is that of the tangent plane: the surface leaves it only in the second order.
                let lateral = matches!(solid, Solid::Cone { .. } | Solid::Frustum { .. });
                if lateral && end.part == Part::Side && !facing[0].is_zero() {
                    let across = [facing[2].clone(), Dyadic::zero(), -&facing[0]];
                    let zero = &(&across[0] * &facing[0]) + &(&across[2] * &facing[2]);
                    assert!(zero.magnitude() < Dyadic::power_of_two(-110));
                }
                checked += 1;
            }
        }
    }
    assert!(checked > 2000, "{checked}");
}

#[test]
fn normals_of_known_points() {
    let close = |found: &[Dyadic; 3], expected: [f64; 3]| {
        for axis in 0..3 {
            assert!((found[axis].to_f64() - expected[axis]).abs() < 1e-15, "{found:?} {expected:?}");
        }
    };
    let across = line([3.0, 1.0, 0.0], [-1.0, 0.0, 0.0]);
    let half = 0.5f64.sqrt();
    let first = |solid: &Solid, line: &Line| {
        let (t, part) = ends(&solve(solid, line)).remove(0);
        normal(solid, part, &t, line)
    };
    close(&first(&cone(1.0, ConeExtent::Nappe), &across), [half, -half, 0.0]);
    close(&first(&cone(1.0, ConeExtent::Double), &line([3.0, -1.0, 0.0], [-1.0, 0.0, 0.0])), [half, half, 0.0]);
    close(&first(&frustum(2.0, 0.0, 2.0, true), &across), [half, half, 0.0]);
    close(&first(&frustum(0.0, 4.0, 2.0, true), &across), [0.2f64.sqrt(), -0.8f64.sqrt(), 0.0]);
    close(&first(&cylinder(1.0, CylinderExtent::Infinite), &line([0.6, 1.0, 5.0], [0.0, 0.0, -1.0])), [0.6, 0.0, 0.8]);
    let above = line([0.25, 9.0, 0.0], [0.0, -1.0, 0.0]);
    close(&first(&capped_cylinder(1.0, 2.0), &above), [0.0, 1.0, 0.0]);
    close(&first(&capped_cylinder(1.0, 2.0), &line([0.25, -9.0, 0.0], [0.0, 1.0, 0.0])), [0.0, -1.0, 0.0]);
    // Apexes face along the axis, away from the body.
    let through = line([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    close(&first(&cone(1.0, ConeExtent::Nappe), &through), [0.0, -1.0, 0.0]);
    close(&first(&frustum(1.0, 0.0, 2.0, true), &line([-1.0, 2.0, 0.0], [1.0, 0.0, 0.0])), [0.0, 1.0, 0.0]);
    close(&first(&capsule(1.0, 2.0), &line([0.0, 9.0, 0.75], [0.0, -1.0, 0.0])), [0.0, (1.0f64 - 0.5625).sqrt(), 0.75]);
}

/// The ends are at the parameters given, to `f64`, on the parts given.
#[track_caller]
fn expect(solid: &Solid, line: &Line, expected: &[(f64, Part)]) {
    let answer = solve(solid, line);
    let found = ends(&answer);
    assert_eq!(found.len(), expected.len(), "{answer:?}");
    for ((t, part), (expected_t, expected_part)) in found.iter().zip(expected) {
        let t = t.to_f64();
        assert!((t - expected_t).abs() <= expected_t.abs() * 3e-16, "{t:.20} {expected_t:.20}");
        assert_eq!(part, expected_part);
    }
}

#[test]
#[expect(clippy::excessive_precision, reason = "the digits are those of the list of hard cases")]
fn hard_cases_have_their_known_answers() {
    use Part::{Base, Side, Top};
    // Numbered as in the list of hard cases; those of decimal or other poses are scaled and moved into this one.
    expect(
        &sphere(1.0),
        &line([-4100.0, 0.5, 0.0], [1.0, 0.0, 0.0]),
        &[(4099.1339745962156, Side), (4100.8660254037844, Side)],
    );
    expect(
        &sphere(100.0),
        &line([-400e3, 95.0, 0.0], [1e3, 0.0, 0.0]),
        &[(399.96877501000801, Side), (400.03122498999199, Side)],
    );
    expect(&sphere(6.4e6), &line([0.0, 0.0, 6.4e6 + 1.0], [0.0, 0.0, -1.0]), &[(1.0, Side), (12_800_001.0, Side)]);
    // 4
    let grazing = line([-0.5, -0.5, 0.0], [1.0, 0.0, 0.0]);
    expect(&sphere(0.5), &grazing, &[(0.5, Side), (0.5, Side)]);
    let hits = hits_in_range(&solve(&sphere(0.5), &grazing), &Dyadic::zero(), None).hits;
    assert_eq!(hits.len(), 1);
    assert_eq!(hits[0].crossing, ExpectedCrossing::Touch);
    let past = solve(&sphere(0.5), &line([0.125, -0.5, 0.0], [1.0, 0.0, 0.0]));
    assert!(hits_in_range(&past, &Dyadic::zero(), None).hits.is_empty());
    // 5
    expect(&capped_cylinder(1e20, 1.0), &line([-2e20, 0.5, 0.0], [1e20, 0.0, 0.0]), &[(1.0, Side), (3.0, Side)]);
    // 6
    expect(&capped_cylinder(1.0, 2.0), &line([0.5, 1.0, 0.0], [2f64.powi(-24), 1.0, 0.0]), &[(-1.0, Base), (1.0, Top)]);
    // 7
    let near_parallel = line([10001.0, 1e6, 0.0], [-10.0, -2e6, 0.0]);
    // The list prints .449867752; that is what the inputs rounded to `f32` give. The decimals themselves give this.
    let near = ends(&solve(&capsule(1e4, 1e5), &near_parallel)).remove(0);
    assert!((near.0.to_f64() - 0.44986774899900603).abs() < 1e-15 && near.1 == Top);
    // 8
    expect(&capped_cylinder(1.0, 2.0), &line([1.0, 1.0, 0.0], [0.0, 1.0, 0.0]), &[(-1.0, Side), (1.0, Side)]);
    expect(&capped_cylinder(1.0, 2.0), &line([1.0f64.next_up(), 1.0, 0.0], [0.0, 1.0, 0.0]), &[]);
    expect(
        &capped_cylinder(1.0, 2.0),
        &line([1.0f64.next_down(), 1.0, 0.0], [0.0, 1.0, 0.0]),
        &[(-1.0, Base), (1.0, Top)],
    );
    // 9
    expect(
        &capped_cylinder(1.0, 2.0),
        &line([2.0, 2.0, 0.5], [-1.0, 0.0, 0.0]),
        &[(1.1339745962155614, Side), (2.8660254037844384, Side)],
    );
    // 10
    expect(&capped_cylinder(1.0, 2.0), &line([2.0, 3.0, 0.0], [-1.0, -1.0, 0.0]), &[(1.0, Side), (3.0, Side)]);
    // 11
    expect(&capsule(1.0, 2.0), &line([2.0, 2.0, 0.0], [-1.0, 0.0, 0.0]), &[(1.0, Side), (3.0, Side)]);
    // 12: the axis scaled by a third, and t by the root of 13.
    let length = 13f64.sqrt();
    for (radial, axial, expected) in [
        (-3.0, -1.0, 4.5069390943299866),
        (-1.0, -1.0, 2.704163456597992),
        (1.0, 1.0, -2.704163456597992),
        (3.0, 1.0, -4.5069390943299866),
    ] {
        let answer = solve(&cone(2.0, ConeExtent::Double), &line([radial, axial, 0.0], [2.0, 1.0, 0.0]));
        let found = ends(&answer);
        assert_eq!(found.len(), 1);
        assert!((found[0].0.to_f64() * length - expected).abs() < 1e-14);
    }
    // 13
    let nappe = cone(1.0, ConeExtent::Nappe);
    expect(&nappe, &line([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]), &[(1.0, Side), (1.0, Side)]);
    expect(&nappe, &line([1.0, 0.0, 0.0], [-1.0, 1.0, 0.0]), &[(0.5, Side)]);
    let downwards = line([1.0, 0.0, 0.0], [-1.0, -1.0, 0.0]);
    expect(&nappe, &downwards, &[]);
    expect(&cone(1.0, ConeExtent::Double), &downwards, &[(0.5, Side)]);
    // 14
    let steep = cone(0.5, ConeExtent::Nappe);
    expect(
        &steep,
        &line([-1e6, 10.0, 1.0], [1e4, 0.0, 0.0]),
        &[(99.999510102051443, Side), (100.00048989794856, Side)],
    );
    expect(&steep, &line([-1e6, 0.0, 10.0], [1e4, 0.0, 0.0]), &[]);
    // 15
    expect(
        &sphere(1.0),
        &line([25001.0 / 25000.0, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        &[(25001.0 / 25000.0 - 1.0, Side), (25001.0 / 25000.0 + 1.0, Side)],
    );
    // Through the apex within both nappes; along the axis.
    expect(&cone(1.0, ConeExtent::Double), &line([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]), &[(1.0, Side), (1.0, Side)]);
    expect(
        &cone(1.0, ConeExtent::Capped(number(3.0))),
        &line([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
        &[(1.0, Side), (4.0, Top)],
    );
    // In the surface.
    let slanted = line([-1.0, -1.0, 0.0], [1.0, 1.0, 0.0]);
    for (solid, from, to) in [
        (cylinder(1.0, CylinderExtent::Infinite), None, None),
        (cylinder(1.0, CylinderExtent::Open(number(2.0))), Some(0.0), Some(2.0)),
    ] {
        let answer = solve(&solid, &line([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
        let bound = |t: Option<f64>| t.map(|t| Root::from(&number(t)));
        assert_eq!(answer, Answer::Coincident { from: bound(from), to: bound(to) });
    }
    for (extent, from, to) in [
        (ConeExtent::Double, None, None),
        (ConeExtent::Nappe, Some(1.0), None),
        (ConeExtent::Open(number(2.0)), Some(1.0), Some(3.0)),
    ] {
        let bound = |t: Option<f64>| t.map(|t| Root::from(&number(t)));
        assert_eq!(solve(&cone(1.0, extent), &slanted), Answer::Coincident { from: bound(from), to: bound(to) });
    }
    // A triangle's corner touched by a line in its plane.
    let corner = solve(
        &triangle([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
        &line([-1.0, 0.0, 1.0], [1.0, 0.0, -1.0]),
    );
    let one = Some(Root::from(&number(1.0)));
    assert_eq!(corner, Answer::Coincident { from: one.clone(), to: one });
}

#[test]
fn ranges_are_closed_and_drop_what_lies_outside() {
    let answer = solve(&sphere(1.0), &line([-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]));
    let kinds = |lo: f64, hi: Option<f64>| {
        let found = hits_in_range(&answer, &number(lo), hi.map(number).as_ref());
        let kinds: Vec<_> = found.hits.iter().map(|hit| hit.crossing).collect();
        (kinds, found.starts_inside)
    };
    use ExpectedCrossing::{Enter, Exit};
    assert_eq!(kinds(0.0, None), (vec![Enter, Exit], false));
    assert_eq!(kinds(1.0, Some(3.0)), (vec![Enter, Exit], false));
    assert_eq!(kinds(1.0f64.next_up(), None), (vec![Exit], true));
    assert_eq!(kinds(3.0, None), (vec![Exit], true));
    assert_eq!(kinds(3.0f64.next_up(), None), (vec![], false));
    assert_eq!(kinds(0.0, Some(3.0f64.next_down())), (vec![Enter], false));
    assert_eq!(kinds(2.0, Some(2.5)), (vec![], true));
    let wall = solve(&cylinder(1.0, CylinderExtent::Open(number(2.0))), &line([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
    assert!(hits_in_range(&wall, &number(2.0), None).coincident);
    assert!(!hits_in_range(&wall, &number(2.5), None).coincident);
    let axis = solve(&cylinder(1.0, CylinderExtent::Infinite), &line([0.0; 3], [0.0, 1.0, 0.0]));
    assert!(hits_in_range(&axis, &Dyadic::zero(), None).starts_inside);
}

#[test]
fn margins_tell_how_near_grazing_a_line_is() {
    let across = line([-9.0, 1.0, 0.5], [2.0, 0.0, 0.0]);
    assert_eq!(margin(&sphere(1.25f64), &line([-9.0, 0.0, 1.25], [2.0, 0.0, 0.0])), Some(1.0));
    assert_eq!(margin(&capped_cylinder(1.0, 2.0), &across), Some(0.5));
    assert_eq!(margin(&cone(1.0, ConeExtent::Nappe), &across), Some(0.5));
    assert_eq!(margin(&capped_cylinder(2.0, 2.0), &line([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])), Some(0.5));
    assert_eq!(margin(&Solid::Plane, &across), None);
}
