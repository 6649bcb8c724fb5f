//! The bounds of running errors beside doubles, in which operations on floats are exact to 2^-53.

use super::*;
use crate::random::Random;
use crate::scalar::ToScalar;

impl Random {
    /// A float, also next to the ends of the type.
    fn value(&mut self) -> f32 {
        let exponent = match self.next() % 16 {
            0 => 30 + (self.next() % 10) as i32,
            1 => -149 + (self.next() % 24) as i32,
            2 => -70 - (self.next() % 10) as i32,
            _ => (self.next() % 9) as i32 - 4,
        };
        let mantissa = 1.0 + (self.next() % (1 << 23)) as f64 / f64::from(1 << 23);
        let sign = if self.next().is_multiple_of(2) { 1.0 } else { -1.0 };
        (sign * mantissa * f64::powi(2.0, exponent)) as f32
    }

    /// A number, and an exact value that is off by all of its error: often one that cancels `to`.
    fn number(&mut self, to: f32) -> (Running<f32>, f64) {
        let value = if self.next().is_multiple_of(3) && to != 0.0 {
            -to * (1.0 + (self.next() % 8) as f32 * f32::EPSILON)
        } else {
            self.value()
        };
        let factor = [0.0, 1.0, 3.0, 1e3, 1e6][(self.next() % 5) as usize];
        // Only sums are exact next to zero, and a product has at least this error.
        let error =
            if factor == 0.0 { 0.0 } else { (value.abs() * factor).max(f32::MIN_POSITIVE * f32::powi(2.0, 24)) };
        let off = f64::from(error) * f64::powi(2.0, -24) * if self.next().is_multiple_of(2) { 1.0 } else { -1.0 };
        (Running { value, error }, f64::from(value) + off)
    }
}

/// The error of a result may not exceed its bound, except by the rounding of the bound and of doubles.
fn check(what: &str, result: Running<f32>, exact: f64) {
    if !result.value.is_finite() || !result.error.is_finite() {
        return;
    }
    let bound = f64::from(Running::<f32>::sure(result.error));
    let off = (f64::from(result.value) - exact).abs();
    assert!(
        off <= bound + exact.abs() * f64::powi(2.0, -50) + f64::powi(2.0, -149),
        "{what}: {result:?}, exactly {exact:e}: {off:e} > {bound:e}"
    );
}

#[test]
fn bounds_hold_for_every_operation() {
    let rounds = if std::env::var_os("RAYLET_LONG").is_some() { 10_000_000 } else { 300_000 };
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for _ in 0..rounds {
        let (a, exact_a) = random.number(0.0);
        let (b, exact_b) = random.number(a.value);
        let (c, exact_c) = random.number(a.value);
        let (d, exact_d) = random.number(b.value);
        check("sum", a + b, exact_a + exact_b);
        check("difference", a - b, exact_a - exact_b);
        check("product", a * b, exact_a * exact_b);
        check("two products", Running::sum([[a, b], [c, d]]), exact_a * exact_b + exact_c * exact_d);
        let three = Running::sum([[a, b], [c, d], [a, d]]);
        check("three products", three, exact_a * exact_b + exact_c * exact_d + exact_a * exact_d);
        let dot = Running::scalar_product([a, c, a], [b, d, d]);
        check("a scalar product", dot, exact_a * exact_b + exact_c * exact_d + exact_a * exact_d);
        let [x, y, z] = Running::vector_product([a, b, c], [c, d, a]);
        check("a vector product", x, exact_b * exact_a - exact_c * exact_d);
        check("a vector product", y, exact_c * exact_c - exact_a * exact_a);
        check("a vector product", z, exact_a * exact_d - exact_b * exact_c);
        let four = Running::sum([[a, b], [c, d], [a, d], [b, c]]);
        check("four products", four, exact_a * exact_b + exact_c * exact_d + exact_a * exact_d + exact_b * exact_c);
        // A subnormal divisor's bound is itself rounded to a few bits; such a quotient is far beyond the error that is
        // accepted.
        if b.value.abs() >= f32::MIN_POSITIVE && b.sign().is_some_and(|sign| sign != Ordering::Equal) {
            check("quotient", a.over(b), exact_a / exact_b);
        }
        if a.sign() == Some(Ordering::Greater) {
            check("root", a.square_root(), exact_a.sqrt());
        }
        for (number, exact) in [(a, exact_a), (three, exact_a * exact_b + exact_c * exact_d + exact_a * exact_d)] {
            if let Some(sign) = number.sign() {
                let exact = if exact > 0.0 {
                    Ordering::Greater
                } else if exact < 0.0 {
                    Ordering::Less
                } else {
                    Ordering::Equal
                };
                assert_eq!(sign, exact, "{number:?}");
            }
        }
    }
}

/// The end of an infinite solid has no error, whatever is added to its parameter: such solids were computed in the
/// robust number whenever their line was moved.
#[test]
fn a_missing_end_is_known_on_a_moved_line() {
    let whole = |end: f32, start: Running<f32>| {
        let whole = ToScalar::<f32>::whole(Running::<f32>::exact(end), Some(start));
        ToScalar::<f32>::rounded(whole)
    };
    let start = Running { value: 3.0_f32, error: 5.0 };
    assert_eq!(whole(f32::INFINITY, start), Some(f32::INFINITY));
    assert_eq!(whole(-f32::INFINITY, start), Some(-f32::INFINITY));
    assert_eq!(whole(1.0, start), Some(4.0));
    // An overflow is no missing end.
    let overflow = Running { value: f32::MAX, error: 1.0 } + Running { value: f32::MAX, error: 1.0 };
    assert_eq!(ToScalar::<f32>::rounded(ToScalar::<f32>::whole(overflow, Some(start))), None);
}
