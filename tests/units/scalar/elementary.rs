use super::*;

const TURN: f64 = 18_446_744_073_709_551_616.0;

#[test]
fn angles_agree_with_the_arc_tangent() {
    for i in -60..=60_i64 {
        for j in -60..=60_i64 {
            if i == 0 && j == 0 {
                continue;
            }
            let exact = (i as f64).atan2(j as f64) / core::f64::consts::TAU;
            let got = angle(i << 54, j << 54, 62) as i64 as f64 / TURN;
            let difference = (got - exact) - (got - exact).round();
            assert!(difference.abs() < 1e-15, "{i} {j}: {got} {exact}");
        }
    }
}

#[test]
fn sines_agree_with_the_float_function() {
    for i in 0..4096_u64 {
        let (sine, cosine) = sine_cosine(i << 52, 62);
        let (s, c) = (i as f64 / 4096.0 * core::f64::consts::TAU).sin_cos();
        assert!((sine as f64 / ONE as f64 - s).abs() < 2e-15, "{i}");
        assert!((cosine as f64 / ONE as f64 - c).abs() < 2e-15, "{i}");
    }
    assert_eq!(sine_cosine(0, 62), (0, ONE as i64));
    assert_eq!(sine_cosine(1 << 62, 62), (ONE as i64, 0));
}

#[test]
fn powers_agree_with_the_float_function() {
    for i in 1..200_u32 {
        let base = f64::from(i) / 200.0;
        for exponent in [0.25, 0.5, 1.0, 1.5, 3.0827, 27.0, 1000.0] {
            let raw = power((base * ONE as f64) as u64, (exponent * 65536.0) as u64, 16);
            let exact = base.powf((exponent * 65536.0_f64).floor() / 65536.0);
            assert!((raw as f64 / ONE as f64 - exact).abs() < 1e-14, "{base} {exponent}");
        }
    }
    assert_eq!(power(ONE, 5 << 16, 16), ONE);
    assert_eq!(power(ONE / 2, 1 << 16, 16), ONE / 2);
    assert_eq!(power(0, 1 << 16, 16), 0);
    assert_eq!(power(ONE - 1, u64::MAX, 0), power(ONE - 1, u64::MAX, 0));
    assert_eq!(power(1, u64::MAX, 0), 0);
}
