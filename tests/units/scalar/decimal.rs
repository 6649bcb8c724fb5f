use super::{Decimal, digits, parse, shortest};
use std::format;

#[test]
fn the_shortest_decimal_number_comes_back() {
    let same = |magnitude: u64, fraction_bits: u32| {
        let Decimal { whole, places, fraction } = shortest(magnitude, fraction_bits);
        let text = if places == 0 { format!("{whole}") } else { format!("{whole}.{fraction:0places$}") };
        assert_eq!(parse(&text, fraction_bits), Some((false, u128::from(magnitude))), "{text}, {fraction_bits}");
    };
    let mut state = 1_u64;
    for fraction_bits in 0..=64 {
        for edge in [0, 1, 2, (1 << 31) - 1, 1 << 31, (1 << 63) - 1, 1 << 63] {
            same(edge, fraction_bits);
        }
        for _ in 0..300 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            same((state >> 1) >> (state % 61), fraction_bits);
        }
    }
    assert_eq!(shortest(3, 1), Decimal { whole: 1, places: 1, fraction: 5 });
    assert_eq!(shortest(1, 16), Decimal { whole: 0, places: 5, fraction: 2 });
    assert_eq!(shortest(28_842_393, 16), Decimal { whole: 440, places: 5, fraction: 9_999 });
}

#[test]
fn digits_are_those_of_the_decimal_number() {
    assert_eq!(digits(0b11, 1, 10), (1, 5_000_000_000));
    assert_eq!(digits(1, 16, 10), (0, 152_587));
    assert_eq!(digits(u64::from(u32::MAX), 32, 10), (0, 9_999_999_997));
    assert_eq!(digits(u64::MAX, 64, 19), (0, 9_999_999_999_999_999_999));
    assert_eq!(digits(u64::MAX, 0, 19), (u64::MAX, 0));
    assert_eq!(digits(3 << 62, 62, 19), (3, 0));
}
