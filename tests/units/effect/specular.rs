use super::*;
use crate::scalar::Elementary;
use fixed::types::{I0F32, I16F16, I32F32};

/// A whole power is that of real numbers but for as many roundings as it has factors.
#[test]
fn powers_by_squares_are_powers() {
    fn check<S: Scalar>(unit: f64) {
        for exponent in [0_u16, 1, 2, 3, 7, 20, 30, 64, 255, 1000, 1023] {
            for step in 0..=64 {
                let base = f64::from(step) / 64.0;
                let Ok(exact) = S::from_f64(f64::from(exponent)) else { continue };
                let found = S::Unit::to_f64(power::<S>(S::Unit::from_f64(base), exact));
                let off = (found - base.powi(exponent.into())).abs();
                assert!(off <= unit * f64::from(exponent + 1), "{base}^{exponent}: {found}, off by {off:e}");
            }
        }
    }
    check::<f32>(f64::from(f32::EPSILON));
    check::<f64>(f64::EPSILON);
    check::<I16F16>(0.5_f64.powi(30));
    check::<I32F32>(0.5_f64.powi(53));
}

/// Of every bit pattern near the ends of the range, and of numbers with a fraction.
#[test]
fn small_integers_are_known() {
    for n in 0..1024_u16 {
        assert_eq!(f32::from(n).small_integer(), Some(n.into()));
        assert_eq!(I16F16::from_num(n).small_integer(), Some(n.into()));
        assert_eq!((I16F16::from_num(n) + I16F16::DELTA).small_integer(), None);
        assert_eq!((I16F16::from_num(n) - I16F16::DELTA).small_integer(), None);
        assert_eq!((f32::from(n) + 0.25).small_integer(), None);
    }
    for other in [-1.0, -0.25, 1024.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
        assert_eq!(other.small_integer(), None, "{other}");
    }
    assert_eq!(I16F16::from_num(1024).small_integer(), None);
    assert_eq!(I16F16::from_num(-1).small_integer(), None);
    // A type without integers holds zero alone.
    for bits in [0, 1, -1, i32::MIN, i32::MAX] {
        assert_eq!(I0F32::from_bits(bits).small_integer(), (bits == 0).then_some(0));
    }
}
