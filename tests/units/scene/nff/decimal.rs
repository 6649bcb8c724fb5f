use super::*;
use fixed::types::{I4F28, I16F16, I20F12, I32F32};
use std::format;

fn is_parsed_as_the_scalar_does<S: Scalar>(text: &str, power: i32) {
    assert_eq!(parse_scaled::<S>(text, power), S::parse_scaled(text, power), "{text} times 2^{power}");
}

fn in_every_type(text: &str, power: i32) {
    is_parsed_as_the_scalar_does::<I4F28>(text, power);
    is_parsed_as_the_scalar_does::<I16F16>(text, power);
    is_parsed_as_the_scalar_does::<I20F12>(text, power);
    is_parsed_as_the_scalar_does::<I32F32>(text, power);
    is_parsed_as_the_scalar_does::<f32>(text, power);
}

#[test]
fn hard_numbers_are_rounded_as_the_scalar_rounds_them() {
    // Ties, last places, the limits of the digits that are read together, and texts that are not numbers.
    let numbers = "0 -0 +.5 5. 1e0 1E-3 1e+4 12e-1 0.00000762939453125 0.00002288818359375 -0.00002288818359375 \
        1.00000762939453125 1.000007629394531250000000000000001 0.000007629394531249999999999999999 \
        9999999999999999999e-19 9999999999999999999e-16 1234567890123456789e-15 0.1234567890123456789 \
        0.12345678901234567890000 0.12345678901234567891 18446744073709551616e-18 18446744073709551615e-18 \
        0000000000000000000000001.5 1.5000000000000000000000000 0.00000000000000000000000000000001 1e-40 1e-9999 \
        1e-10000 100000000000000000000e-19 0.0000000000000000000 3e-19 3e-20 32767.99998 32767.99999 32767.999992 32768 \
        2147483647.9999999999 2147483648 1e9 1e19 1e20 1e99999 99999999999999999999999999 \
        . + - e e5 1e 1e+ 1e5. 1.2.3 +-1 1e5e5 1_0 0x10 inf nan 1e99999999999999999999 0e99999999999999999999";
    for number in numbers.split_whitespace() {
        for power in [-40, -28, -16, -3, 0, 1, 10, 26, 32, 36, 48, 60] {
            in_every_type(number, power);
        }
    }
}

#[test]
fn any_number_is_rounded_as_the_scalar_rounds_it() {
    let mut state = 1_u64;
    let mut below = |bound: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 16) % bound
    };
    for _ in 0..20_000 {
        let (power, places) = (below(52) as i32 - 16, below(23));
        let digits = (u128::from(below(1 << 48)) * u128::from(below(1 << 48))) >> below(90);
        in_every_type(&format!("{digits}e-{places}"), power);
        // Ties of 16 fraction bits, which have 17 places, and their neighbours.
        let tie = (2 * below(1 << 20) + 1) * 762_939_453_125;
        in_every_type(&format!("-{}e-17", tie + below(3) - 1), 0);
    }
}

#[test]
fn magnitudes_are_ordered_as_the_numbers_are() {
    let numbers =
        "1e-400 3e-20 0.1 0.11 9.99e-1 1 1.0000000000000000001 -1.5 2 9.99999999999999999 10 -11 99.5 1e2 1e300";
    let magnitudes: std::vec::Vec<_> =
        numbers.split_whitespace().map(|number| Decimal::parse(number).and_then(Decimal::magnitude)).collect();
    assert!(magnitudes.iter().all(Option::is_some));
    assert!(magnitudes.windows(2).all(|pair| pair[0] <= pair[1]), "{magnitudes:?}");
    for equal in ["100", "1e2", "100.000", "0.0001e6", "+100"] {
        assert_eq!(
            Decimal::parse(equal).and_then(Decimal::magnitude),
            Decimal::parse("-1e2").and_then(Decimal::magnitude)
        );
    }
    assert_eq!(Decimal::parse("-0.00e7").and_then(Decimal::magnitude), None);
}
