use super::integer::FLOAT_LIMBS;
use super::word::Word;
use super::{Bounded, Estimate, Integer, Limbs, Number, Ring, Robust};
use crate::random::Random;
use crate::scalar::{FromScalar, ToScalar};
use core::cmp::Ordering;

impl Random {
    /// A float of any of 80 exponents, sometimes zero, sometimes with few bits.
    fn float(&mut self) -> f32 {
        let bits = self.next();
        let exponent = 87 + (bits >> 40) as u32 % 80;
        let fraction = bits as u32 & 0x007f_ffff;
        let fraction = if bits >> 60 & 1 == 0 { fraction } else { fraction & 0x0070_0000 };
        if bits >> 61 == 0 { 0.0 } else { f32::from_bits((bits >> 63 << 31) as u32 | exponent << 23 | fraction) }
    }
}

fn number<N: FromScalar<f32>>(value: f32) -> N {
    N::scalar(value)
}

/// A polynomial of nested sums of products that cancel.
fn polynomial<N: FromScalar<f32>>([a, b, c, d, e, f]: [f32; 6]) -> N {
    let [a, b, c, d, e, f] = [a, b, c, d, e, f].map(number::<N>);
    let w = [N::sum([[a, d], [-b, c]]), N::sum([[b, e], [-c, d]]), N::sum([[c, f], [-e, a]])];
    let k = N::sum([[w[0], a], [w[1], b], [w[2], c], [-f, f]]);
    N::sum([[k, k], [-w[0], w[0]], [-w[1], w[2]]]) - (a + e) * w[1]
}

#[test]
fn a_bounded_number_holds_the_exact_one() {
    let mut random = Random(1);
    let (mut known, mut exact) = (0, 0);
    for _ in 0..20_000 {
        let inputs = [0; 6].map(|_| random.float());
        let truth = polynomial::<Integer<FLOAT_LIMBS>>(inputs);
        let (narrow, wide) = (polynomial::<Bounded<u64>>(inputs), polynomial::<Bounded<u128>>(inputs));
        for sign in [narrow.sign(), wide.sign()].into_iter().flatten() {
            known += 1;
            assert_eq!(Some(sign), truth.sign(), "{inputs:?}");
        }
        let difference = wide - truth.estimate();
        assert!(difference.sign().is_none() || difference.sign() == Some(Ordering::Equal), "{inputs:?}");
        exact += (difference.sign() == Some(Ordering::Equal)) as u32;
    }
    assert!(known > 15_000, "{known}");
    assert!(exact > 500, "{exact}");
}

#[test]
fn a_robust_number_is_the_rounded_exact_one() {
    let mut random = Random(2);
    for _ in 0..20_000 {
        let [a, b, c, d, e, f] = [0; 6].map(|_| random.float() as f64);
        let sum = |terms: [[f64; 2]; 3]| {
            let robust: f32 = Robust::<u64>::sum(terms.map(|term| term.map(|x| number::<Robust<u64>>(x as f32))))
                .rounded()
                .unwrap_or(f32::NAN);
            let exact = Integer::<FLOAT_LIMBS>::sum(terms.map(|term| term.map(|x| number(x as f32))));
            let exact: f32 = exact.estimate().rounded().unwrap_or(f32::NAN);
            assert!((robust.to_bits() as i64 - exact.to_bits() as i64).abs() <= 1, "{terms:?}: {robust} {exact}");
        };
        sum([[a, b], [c, d], [e, f]]);
        sum([[a, b], [-b, a], [0.0, f]]);
        sum([[a, b], [-c, b], [c, b]]);
    }
}

fn check_quotients_and_roots<W: Word>(seed: u64) {
    let mut random = Random(seed);
    let unit = |value: &Limbs<W>| value.exponent() - Limbs::<W>::BITS;
    for round in 0..5_000 {
        // Also at the ends of the mantissa's range.
        let mut mantissa = || match round % 5 {
            0 => u64::MAX - random.next() % 5,
            1 => (1 << 63) + random.next() % 5,
            _ => random.next() | 1,
        };
        let n = Limbs::<W>::from_integer(mantissa(), (random.next() % 200) as i32 - 100, round & 1 != 0);
        let (d, _) = n.product(&Limbs::from_integer(random.next() | 1, -70, round & 2 != 0));
        let q = n.quotient(&d);
        // n - q d is less than a few units in the last place of q, times d.
        let (rest, _) = Limbs::sum_of_products::<2, true>(&[[n, Limbs::ONE], [q.negative(), d]]);
        assert!(
            rest.is_zero() || rest.exponent() <= unit(&q) + d.exponent() + W::SPARE as i32 + 1,
            "{n:?} / {d:?}: {rest:?}"
        );
        let s = n.root();
        let (rest, _) = Limbs::sum_of_products::<2, true>(&[[n.magnitude(), Limbs::ONE], [s.negative(), s]]);
        assert!(
            rest.is_zero() || rest.exponent() <= unit(&s) + s.exponent() + W::SPARE as i32 + 2,
            "{n:?}: {s:?} {rest:?}"
        );
    }
}

#[test]
fn quotients_and_roots_are_good_to_the_last_places() {
    check_quotients_and_roots::<u64>(3);
    check_quotients_and_roots::<u128>(4);
}

#[test]
fn rounding_is_to_nearest_and_ties_to_even() {
    let number = |mantissa: u64, exponent: i32| Limbs::<u128>::from_integer(mantissa, exponent, false);
    assert_eq!(number(5, -1).to_units(0), Some(2));
    assert_eq!(number(7, -1).to_units(0), Some(4));
    assert_eq!(number(1, -1).to_units(0), Some(0));
    assert_eq!(number(3, -2).to_units(0), Some(1));
    assert_eq!(number(1, 64).to_units(0), None);
    assert_eq!(number(u64::MAX, 0).to_units(0), Some(u64::MAX));
    let (above, _) = number(1, -1).total::<true>(&number(1, -100));
    assert_eq!(above.to_units(0), Some(1));
    assert_eq!(Limbs::<u64>::ZERO.to_units(0), Some(0));
}

#[test]
fn floats_come_back_to_the_bit() {
    let mut random = Random(6);
    for bits in (0..10_000).map(|_| random.next() as u32).chain([0, 1, 0x007f_ffff, 0x0080_0000, 0x7f7f_ffff]) {
        let value = f32::from_bits(bits);
        if value.is_finite() && value != 0.0 {
            assert_eq!(Robust::<u64>::scalar(value).rounded(), Some(value));
            assert_eq!(Robust::<u128>::scalar(value as f64).rounded(), Some(value as f64));
        }
    }
    let largest = number::<Robust<u64>>(f32::MAX);
    assert_eq!((largest + largest).rounded(), Some(f32::INFINITY));
    assert_eq!((-largest - largest).rounded(), Some(f32::NEG_INFINITY));
    // Half of the smallest number is a tie with zero.
    assert_eq!(number::<Robust<u64>>(f32::from_bits(1)).scaled(-1).rounded(), Some(0.0_f32));
    assert_eq!(number::<Robust<u64>>(f32::from_bits(3)).scaled(-1).rounded(), Some(f32::from_bits(2)));
}

#[test]
fn mirrored_operands_have_mirrored_results() {
    let mut random = Random(7);
    for _ in 0..5_000 {
        let inputs = [0; 6].map(|_| random.float());
        let (a, b) = (number::<Robust<u64>>(inputs[0]), number::<Robust<u64>>(inputs[1]));
        let (c, d) = (number::<Robust<u64>>(inputs[2]), number::<Robust<u64>>(inputs[3]));
        let (sum, mirrored) = (Robust::sum([[a, b], [c, d]]), Robust::sum([[-a, b], [c, -d]]));
        assert_eq!(sum.compare(-mirrored), Some(Ordering::Equal));
    }
}
