//! The oracle's numbers: roots against high-precision enclosures, and units in the last place.

use crate::oracle_drawn::*;
use std::cmp::Ordering;

use dashu::integer::IBig;
use dashu::rational::RBig;
use support::amount::times;
use support::oracle::{Dyadic, Root, exact_f32, exact_f64, exact_fixed};

fn random_root(random: &mut Random) -> Root {
    let rational = |random: &mut Random, bound| RBig::from(random.within(bound)) / RBig::from(random.below(4) + 1);
    let square_class = RBig::from([0, 1, 2, 3, 8][random.below(5) as usize]);
    let factor = rational(random, 3);
    let q = loop {
        let q = rational(random, 4);
        if q != RBig::ZERO {
            break q;
        }
    };
    let d = square_class * &factor * factor;
    Root::from_rationals(&rational(random, 5), random.within(1) as i8, &d, &q)
}

#[test]
fn roots_compare_as_their_enclosures_do() {
    let mut random = Random(8);
    let mut found = [0; 3];
    for _ in 0..times(40_000) {
        let (left, right) = (random_root(&mut random), random_root(&mut random));
        let ((left_low, left_high), (right_low, right_high)) = (left.enclosure(400), right.enclosure(400));
        // Numbers of this size are equal, or much further apart than their enclosures are wide.
        let expected = if left_high < right_low {
            Ordering::Less
        } else if left_low > right_high {
            Ordering::Greater
        } else {
            Ordering::Equal
        };
        found[(expected as i8 + 1) as usize] += 1;
        assert_eq!(left.cmp(&right), expected, "{left:?} {right:?}");
        assert_eq!((-&left).cmp(&-&right), expected.reverse());
        assert_eq!(left.signum() as i32, left.cmp_rational(&RBig::ZERO) as i32);
    }
    assert!(found.iter().all(|&count| count > 300), "{found:?}");
}

#[test]
fn roots_that_differ_by_almost_nothing_are_told_apart() {
    let root_two = Root::from_rationals(&RBig::ZERO, 1, &RBig::from(2), &RBig::ONE);
    for bits in [10, 100, 1000] {
        let (low, high) = root_two.enclosure(bits);
        assert!(low < high);
        assert_eq!(root_two.cmp_dyadic(&low), Ordering::Greater);
        assert_eq!(root_two.cmp_dyadic(&high), Ordering::Less);
        let square = low.squared();
        let nearly = Root::from_rationals(&RBig::ZERO, 1, &square.to_rational(), &RBig::ONE);
        assert_eq!(nearly, Root::from(&low));
        let tripled = Root::from_rationals(&RBig::from(1), 1, &RBig::from(18), &RBig::from(3));
        let shifted = root_two.mul_add(&Dyadic::from(3), &Dyadic::from(1));
        assert_eq!(tripled.mul_add(&Dyadic::from(3), &Dyadic::zero()), shifted);
        let other = Root::from_rationals(&RBig::from(1), 1, &(square.to_rational() * RBig::from(9)), &RBig::from(3));
        assert_eq!(other.cmp(&tripled), Ordering::Less);
    }
}

#[test]
fn enclosures_hold_the_number_and_are_as_narrow_as_needed() {
    let mut random = Random(9);
    for round in 0..times(20_000) {
        let root = random_root(&mut random);
        // Cancellation: less a number close to itself.
        let root = if round % 2 == 0 { root } else { root.mul_add(&Dyadic::from(1), &-&root.approximation(30)) };
        for bits in [1, 24, 120] {
            let (low, high) = root.enclosure(bits);
            assert!(root.cmp_dyadic(&low) != Ordering::Less && root.cmp_dyadic(&high) != Ordering::Greater);
            let widest = low.magnitude().min(high.magnitude()).scaled(-(bits as isize));
            assert!(&high - &low <= widest, "{root:?} {bits} {low:?} {high:?}");
        }
    }
}

#[test]
fn multiples_round_to_nearest_and_ties_to_even() {
    let one = Dyadic::from(1);
    for (value, expected) in [
        (0.5, 0),
        (1.5, 2),
        (2.5, 2),
        (-0.5, 0),
        (-1.5, -2),
        (-2.5, -2),
        (3.0, 3),
        (-3.0, -3),
        (0.0, 0),
        (2.51, 3),
        (-2.49, -2),
    ] {
        assert_eq!(Root::from(&number(value)).nearest_multiple(&one), IBig::from(expected), "{value}");
    }
    let mut random = Random(10);
    for _ in 0..times(20_000) {
        let root = random_root(&mut random);
        let unit = Dyadic::new(random.below(3) + 1, -random.below(40) as isize + 3);
        let multiple = Dyadic::new(root.nearest_multiple(&unit), 0);
        let off = root.error_in(&(&multiple * &unit), &unit);
        assert!(off <= 0.5, "{root:?} {unit:?} {multiple:?} {off}");
        let exact_off = root.mul_add(&one, &-&(&multiple * &unit)).magnitude();
        assert_ne!(exact_off.cmp_dyadic(&unit.scaled(-1)), Ordering::Greater);
    }
}

#[test]
fn units_in_the_last_place_are_the_spacing_of_floats() {
    let mut random = Random(11);
    for _ in 0..times(20_000) {
        let value = f32::from_bits(random.next() as u32 & 0x7fff_ffff);
        if !value.is_finite() || value == f32::MAX {
            continue;
        }
        let spacing = &exact_f32(value.next_up()) - &exact_f32(value);
        let exact = exact_f32(value);
        assert_eq!(Root::from(&exact).ulp_f32(), spacing);
        assert_eq!(Root::from(&-&exact).ulp_f32(), spacing);
        // Just under the next float the spacing is still the same.
        let under = &exact_f32(value.next_up()) - &spacing.scaled(-90);
        assert_eq!(Root::from(&under).ulp_f32(), spacing);
        let value = f64::from_bits(random.next() >> 1);
        if value.is_finite() && value < f64::MAX {
            let spacing = &exact_f64(value.next_up()) - &exact_f64(value);
            assert_eq!(Root::from(&exact_f64(value)).ulp_f64(), spacing);
        }
    }
    let two = Root::from_rationals(&RBig::ZERO, 1, &RBig::from(4), &RBig::ONE);
    assert_eq!(two.ulp_f32(), Dyadic::power_of_two(-22));
    let root = Root::from_rationals(&RBig::ZERO, 1, &RBig::from(2), &RBig::ONE);
    assert_eq!(root.ulp_f32(), Dyadic::power_of_two(-23));
    let nearest = exact_f32(std::f32::consts::SQRT_2);
    let expected = (f64::from(std::f32::consts::SQRT_2) - std::f64::consts::SQRT_2).abs() * 2f64.powi(23);
    assert!((root.error_in(&nearest, &root.ulp_f32()) - expected).abs() < 1e-8);
    assert_eq!(Root::from(&Dyadic::zero()).ulp_f64(), exact_f64(5e-324));
}

#[test]
fn machine_numbers_convert_exactly() {
    let mut random = Random(12);
    for _ in 0..times(20_000) {
        let bits = random.next();
        let wide = f64::from_bits(bits);
        if wide.is_finite() {
            assert_eq!(exact_f64(wide).to_f64(), wide);
        }
        let narrow = f32::from_bits(bits as u32);
        if narrow.is_finite() {
            assert_eq!(exact_f32(narrow), exact_f64(f64::from(narrow)));
        }
        let raw = i64::from(bits as i32);
        assert_eq!(exact_fixed(raw.into(), 16).to_f64(), raw as f64 / 65536.0);
    }
    assert_eq!(exact_f32(f32::from_bits(1)), Dyadic::power_of_two(-149));
    assert_eq!(exact_fixed(-3, 1).to_rational(), RBig::from(-3) / RBig::from(2));
    assert_eq!(exact_fixed(i128::MIN, 127), Dyadic::from(-1));
}
