//! The numbers themselves: reading, angles, sines, powers, directions and levels, each against a reference.

use dashu::rational::RBig;
use fixed::types::extra::{LeEqU32, LeEqU64, U0, U8, U16, U30, U32, U64};
use fixed::{FixedI32, FixedI64};
use raylet::scalar::{Real, Scalar, UnitScalar};
use raylet::{UnitVec3, ValueError, Vec3};
use support::amount::times;
use support::exact_types::Exact;
use support::oracle::{Dyadic, Root};
use support::random::Random;

every_type!(
    text_that_is_no_number_is_refused,
    numbers_are_read_correctly_rounded,
    angles_agree_with_the_arc_tangent,
    sines_and_cosines_agree_with_the_reference,
    powers_agree_with_the_reference,
    the_fraction_is_what_is_above_the_integer_below,
    levels_are_the_nearest_and_clamped,
    directions_are_unit_for_every_length,
    directions_of_doubles_have_all_the_bits_of_the_type,
);

/// The spacing of the type's unit components at one half, and of the type itself at one.
fn units<S: Exact>() -> (f64, f64) {
    match S::name().as_str() {
        "f32" => (2.0_f64.powi(-24), 2.0_f64.powi(-23)),
        "f64" => (2.0_f64.powi(-53), 2.0_f64.powi(-52)),
        "I16F16" => (2.0_f64.powi(-30), 2.0_f64.powi(-16)),
        _ => (2.0_f64.powi(-62), 2.0_f64.powi(-32)),
    }
}

fn text_that_is_no_number_is_refused<S: Exact>() {
    for text in [
        "",
        " ",
        "+",
        "-",
        ".",
        "+.",
        "-.",
        "e",
        "e5",
        ".e1",
        "1e",
        "1e+",
        "1e-",
        "inf",
        "-inf",
        "infinity",
        "nan",
        "NaN",
        "1_000",
        "_1",
        "1_",
        "0x10",
        "0b1",
        "0o7",
        "1.2.3",
        "--1",
        "+-1",
        "1-",
        "1 ",
        " 1",
        "1,5",
        "1f32",
        "1e1.5",
        "1e1e1",
        "\u{663}",
        "1\u{0}",
        "1e999999999999",
        "-1e400",
    ] {
        assert_eq!(S::parse(text), None, "{}: {text:?}", S::name());
    }
    for text in ["1e39", "-3.5e38", "1e308", "2e9", "-2e9"] {
        let exact = S::parse(text).map(S::to_f64);
        let expected: f64 = text.parse().expect("a float");
        // Read where it fits, refused where it does not.
        assert!(exact.is_none_or(|value| (value / expected - 1.0).abs() < 1e-7), "{}: {text}", S::name());
        assert_eq!(exact.is_some(), expected.abs() <= S::BUDGET.distance.to_f64(), "{}: {text}", S::name());
    }
}

/// The decimal number, exactly.
fn rational(text: &str) -> RBig {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let negative = mantissa.starts_with('-');
    let mantissa = mantissa.trim_start_matches(['+', '-']);
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: dashu::integer::IBig = format!("0{whole}{fraction}").parse().expect("digits");
    let exponent = exponent.parse::<i32>().expect("an exponent") - fraction.len() as i32;
    let power = dashu::integer::IBig::from(10).pow(exponent.unsigned_abs() as usize);
    let value =
        if exponent < 0 { RBig::from(digits) / RBig::from(power) } else { RBig::from(digits) * RBig::from(power) };
    if negative { -value } else { value }
}

/// True if no neighbour is nearer; on a tie the even one is right.
fn is_nearest<S: Exact>(value: S, exact: &RBig) -> bool {
    let distance = |value: S| {
        let off = value.exact().to_rational() - exact.clone();
        if off < RBig::ZERO { -off } else { off }
    };
    let (here, above, below) = (distance(value), distance(value.next_up()), distance(-(-value).next_up()));
    here <= above && here <= below
}

fn numbers_are_read_correctly_rounded<S: Exact>() {
    let mut random = Random(1);
    let mut texts: Vec<String> = [
        "0",
        "-0",
        "0.0",
        ".5",
        "5.",
        "1e0",
        "1E2",
        "+1.5e+2",
        "-12.5",
        "1.5e-3",
        "0.1",
        "0.2",
        "0.3",
        "00012.50",
        "1e-45",
        "1e-10",
        "3.14159265358979323846264338327950288",
        "0.00000762939453125",
        "0.0000228881835937500000000001",
        "0.000022888183593749999999",
        "16383.99999237060546875",
        "123.456789e1",
        "1e-400",
        "12345.678901234567890123456789",
    ]
    .map(String::from)
    .to_vec();
    for _ in 0..times(3000) {
        let digits = 1 + random.below(24);
        let mut text = String::from(if random.below(2) == 0 { "-" } else { "" });
        let point = random.below(digits.min(4) + 1);
        for i in 0..digits {
            if i == point {
                text.push('.');
            }
            text.push(char::from(b'0' + random.below(10) as u8));
        }
        if random.below(2) == 0 {
            text.push('e');
            text.push_str(&(random.below(8) as i32 - 7).to_string());
        }
        texts.push(text);
    }
    // Exactly between two values of the type, and a hair beside.
    for _ in 0..times(500) {
        let half = (random.below(1 << 20) as f64 + 0.5) * units::<S>().1.max(2.0_f64.powi(-33));
        texts.push(format!("{half:.40}"));
        texts.push(format!("{half:.40}00000000000000000000001"));
    }
    for text in texts {
        let value = S::parse(&text).unwrap_or_else(|| panic!("{}: {text} is a number", S::name()));
        let exact = rational(&text);
        assert!(is_nearest(value, &exact), "{}: {text} read as {value:?}", S::name());
    }
}

#[test]
fn numbers_are_read_at_the_ends_of_every_fixed_type() {
    fn check<S: Scalar>(text: &str, expected: Option<f64>) {
        assert_eq!(S::parse(text).map(S::to_f64), expected, "{text} in {}", std::any::type_name::<S>());
    }
    fn check_32<F: LeEqU32 + Send + Sync + 'static>(text: &str, expected: Option<f64>) {
        check::<FixedI32<F>>(text, expected);
    }
    fn check_64<F: LeEqU64 + Send + Sync + 'static>(text: &str, expected: Option<f64>) {
        check::<FixedI64<F>>(text, expected);
    }
    check_32::<U0>("2147483646", Some(2_147_483_646.0));
    check_32::<U0>("2147483647", None);
    check_32::<U0>("-2147483646.4", Some(-2_147_483_646.0));
    check_32::<U0>("2.5", Some(2.0));
    check_32::<U0>("3.5", Some(4.0));
    check_32::<U16>("32768", None);
    check_32::<U16>("-32768", None);
    check_32::<U8>("0.001953125", Some(0.0));
    check_32::<U8>("0.00195312500000000000000000000001", Some(0.003_906_25));
    check_32::<U30>("1.75", Some(1.75));
    check_32::<U30>("2", None);
    check_32::<U32>("0.4375", Some(0.4375));
    check_32::<U32>("0.5", None);
    check_64::<U64>("-0.4375", Some(-0.4375));
    check_64::<U64>("0.5", None);
    check_64::<U0>("9007199254740993e2", Some(900_719_925_474_099_300.0));
    check_64::<U0>("1e19", None);
    check_64::<U32>("1e-10", Some(0.0));
    check_64::<U32>("2e-10", Some(2.0_f64.powi(-32)));
}

fn apart_in_turns(a: f64, b: f64) -> f64 {
    (a - b - (a - b).round()).abs()
}

fn angles_agree_with_the_arc_tangent<S: Exact>() {
    let (component, _) = units::<S>();
    let angle = |y: S, x: S| <S::Unit as UnitScalar>::to_f64(S::turns(y.real(), x.real()));
    let n = |value: f64| S::from_f64(value).expect("within the type");
    for (y, x, turns) in [
        (0.0, 0.0, 0.0),
        (0.0, 1.0, 0.0),
        (1.0, 1.0, 0.125),
        (1.0, 0.0, 0.25),
        (1.0, -1.0, 0.375),
        (0.0, -1.0, 0.5),
        (-1.0, -1.0, 0.625),
        (-1.0, 0.0, 0.75),
        (-1.0, 1.0, 0.875),
    ] {
        assert!(apart_in_turns(angle(n(y), n(x)), turns) <= 2.0 * component, "{}: {y} {x}", S::name());
    }
    let mut random = Random(2);
    let mut worst = 0.0_f64;
    for _ in 0..times(20_000) {
        let size = 2.0_f64.powi(random.below(22) as i32 - 8);
        let (y, x) = (n(random.between(-size, size)), n(random.between(-size, size)));
        let got = angle(y, x);
        assert!((0.0..1.0).contains(&got), "{}: {got}", S::name());
        if y != S::ZERO || x != S::ZERO {
            let exact = y.to_f64().atan2(x.to_f64()) / std::f64::consts::TAU;
            worst = worst.max(apart_in_turns(got, exact));
        }
    }
    println!("{}: angles off by {worst:e} turns", S::name());
    // The reference itself is good to 2^-53 or so.
    assert!(worst <= (3.0 * component).max(4.0 * 2.0_f64.powi(-53)), "{}: {worst:e}", S::name());
    // A hair below the x axis is nearly a whole turn, or none.
    let hair = S::from_f64(-2.0_f64.powi(-16)).expect("within the type");
    let got = angle(hair, n(16000.0));
    assert!((0.0..1.0).contains(&got) && apart_in_turns(got, 0.0) < 1e-8, "{}: {got}", S::name());
}

fn sines_and_cosines_agree_with_the_reference<S: Exact>() {
    let (component, _) = units::<S>();
    let mut worst = 0.0_f64;
    let mut random = Random(3);
    let angles = (-16..=16).map(|i| f64::from(i) / 16.0).chain((0..20_000).map(|_| random.between(-1.0, 1.0)));
    for turns in angles.collect::<Vec<_>>() {
        let turns = <S::Unit as UnitScalar>::from_f64(turns);
        let (sine, cosine) = S::sine_cosine(turns);
        let (s, c) = (turns.to_f64() * std::f64::consts::TAU).sin_cos();
        worst = worst.max((sine.to_f64() - s).abs()).max((cosine.to_f64() - c).abs());
    }
    println!("{}: sines off by {worst:e}", S::name());
    // A float's angle is rounded in radians: up to 2 pi, half a unit of 2^-21 in f32.
    let bound =
        if S::name().starts_with('f') { 7.5 * component } else { (2.8 * component).max(8.0 * 2.0_f64.powi(-53)) };
    assert!(worst <= bound, "{}: {worst:e}", S::name());
    if S::name().starts_with('I') {
        let quarter = <S::Unit as UnitScalar>::from_f64(0.25);
        assert_eq!(S::sine_cosine(quarter), (S::Unit::ONE, S::Unit::ZERO));
        assert_eq!(S::sine_cosine(S::Unit::ZERO), (S::Unit::ZERO, S::Unit::ONE));
    }
}

fn powers_agree_with_the_reference<S: Exact>() {
    let (component, _) = units::<S>();
    let mut worst = 0.0_f64;
    let mut random = Random(4);
    for _ in 0..times(20_000) {
        let base = <S::Unit as UnitScalar>::from_f64(random.unit());
        let size = random.pick(&[1.0, 8.0, 100.0, 10_000.0]);
        let exponent = S::from_f64(random.between(0.0, size)).expect("within the type");
        let got = S::power(base, exponent).to_f64();
        let exact = base.to_f64().powf(exponent.to_f64());
        assert!((0.0..=1.0).contains(&got), "{}: {base:?} {exponent:?} {got}", S::name());
        worst = worst.max((got - exact).abs());
    }
    println!("{}: powers off by {worst:e}", S::name());
    assert!(worst <= (2.0 * component).max(16.0 * 2.0_f64.powi(-53)), "{}: {worst:e}", S::name());
    let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
    let n = |value: f64| S::from_f64(value).expect("within the type");
    assert_eq!(S::power(one, n(27.0)), one);
    assert_eq!(S::power(zero, n(27.0)), zero);
    assert_eq!(S::power(zero, S::ZERO), one);
    let half = <S::Unit as UnitScalar>::from_f64(0.5);
    assert_eq!(S::power(half, n(3.0)).to_f64(), 0.125);
    assert_eq!(S::power(half, n(1.0)), half);
    assert_eq!(S::power(half, S::BUDGET.distance), zero);
}

fn the_fraction_is_what_is_above_the_integer_below<S: Exact>() {
    let mut random = Random(5);
    let edges = [0.0, 1.0, -1.0, 0.5, -0.5, 2.25, -2.25, 1000.75, -1000.75, -1e-9, 1e-9];
    for value in edges.into_iter().chain((0..5000).map(|_| random.between(-100.0, 100.0))).collect::<Vec<_>>() {
        let value = S::from_f64(value).expect("within the type");
        let got = value.fraction();
        let exact = value.to_f64() - value.to_f64().floor();
        let got = got.to_f64();
        assert!((0.0..1.0).contains(&got), "{}: {value:?} {got}", S::name());
        assert!(apart_in_turns(got, exact) <= units::<S>().0, "{}: {value:?} {got} {exact}", S::name());
    }
}

fn levels_are_the_nearest_and_clamped<S: Exact>() {
    let level = |value: f64, levels: u16| <S::Unit as UnitScalar>::from_f64(value).level(levels);
    for levels in [1, 31, 63, 255, 1023, u16::MAX] {
        assert_eq!((level(0.0, levels), level(1.0, levels)), (0, levels));
        assert_eq!((level(-0.5, levels), level(1.5, levels)), (0, levels));
        let mut random = Random(6);
        for _ in 0..times(2000) {
            let value = random.unit();
            let exact = value * f64::from(levels);
            let off = (f64::from(level(value, levels)) - exact).abs();
            assert!(off <= 0.5 + f64::from(levels) * 2.0 * units::<S>().0, "{}: {value} of {levels}", S::name());
        }
    }
    assert_eq!(level(f64::NAN, 255), 0);
}

fn directions_are_unit_for_every_length<S: Exact>() {
    let (component, unit) = units::<S>();
    let mut random = Random(7);
    let mut worst = 0.0_f64;
    let exponents: Vec<i32> = match S::name().as_str() {
        "f32" => vec![-140, -126, -66, -20, 0, 20, 66, 125],
        "f64" => vec![-1060, -1022, -500, -66, 0, 66, 500, 1020],
        "I16F16" => vec![-8, 0, 7, 13],
        _ => vec![-16, 0, 14, 29],
    };
    for exponent in exponents {
        for _ in 0..times(2000) {
            let size = 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
            let v = [(); 3].map(|()| S::from_f64(random.between(-1.0, 1.0) * size).expect("within the type"));
            let Ok(unit) = UnitVec3::new(Vec3::from(v)) else {
                assert_eq!(v, [S::ZERO; 3], "{}", S::name());
                continue;
            };
            // component^2 |v|^2 = v^2, exactly but for the rounding of the component.
            let square = v.map(S::exact).iter().fold(RBig::ZERO, |sum, c| sum + c.squared().to_rational());
            for (got, exact) in unit.to_array().into_iter().zip(v) {
                worst = worst.max(component_error::<S>(got, &exact.exact(), &square));
                assert!((got < S::Unit::ZERO) == (exact < S::ZERO) || got == S::Unit::ZERO, "{}", S::name());
            }
        }
    }
    println!("{}: components off by {} units ({unit:e})", S::name(), worst / component);
    // Measured 2.1 for floats, 0.71 for fixed point.
    let bound = if S::name().starts_with('f') { 2.3 } else { 0.8 };
    assert!(worst <= bound * component, "{}: {} units", S::name(), worst / component);
    assert_eq!(UnitVec3::<S>::new(Vec3::ZERO), Err(ValueError::NoDirection));
    let length = Vec3::<S>::from_f64([3.0, 0.0, -4.0]).ok().map(|v| v.length().to_f64());
    assert_eq!(length, Some(5.0));
}

/// How far a component of a direction is from that of a vector, whose length has this square.
fn component_error<S: Exact>(got: S::Unit, component: &Dyadic, square: &RBig) -> f64 {
    let ratio = component.squared().to_rational() / square.clone();
    let size = Root::from_rationals(&RBig::ZERO, 1, &ratio, &RBig::ONE);
    size.error_in(&S::exact_unit(got).magnitude(), &Dyadic::from(1))
}

fn directions_of_doubles_have_all_the_bits_of_the_type<S: Exact>() {
    let (component, _) = units::<S>();
    let mut random = Random(11);
    let mut worst = 0.0_f64;
    for exponent in [-1070, -500, -40, 0, 3, 500, 1022] {
        for _ in 0..times(500) {
            let size = 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
            let v = [(); 3].map(|()| random.between(-1.0, 1.0) * size);
            let direction = UnitVec3::<S>::from_f64(v).expect("it has a length");
            let square = v.iter().fold(RBig::ZERO, |sum, c| sum + c.exact().squared().to_rational());
            for (got, exact) in direction.to_array().into_iter().zip(v) {
                worst = worst.max(component_error::<S>(got, &exact.exact(), &square));
                assert!((got < S::Unit::ZERO) == (exact < 0.0) || got == S::Unit::ZERO, "{v:?}");
            }
            assert_eq!(UnitVec3::from_components(direction.to_array()), Ok(direction));
        }
    }
    assert!(worst <= 0.501 * component, "{}: {} units", S::name(), worst / component);
    assert_eq!(UnitVec3::<S>::from_f64([0.0, -1e-300, 0.0]), Ok(-UnitVec3::Y));
}

#[test]
fn sums_of_products_do_not_cancel() {
    // (1 + 2^-12)^2 - (1 + 2^-11) = 2^-24: nothing of it is left in plain f32 arithmetic.
    let (a, b) = (1.0 + 2.0_f32.powi(-12), 1.0 + 2.0_f32.powi(-11));
    assert_eq!(f32::sum_of_products([[a, a], [-b, 1.0]]), 2.0_f32.powi(-24));
    assert_eq!(a * a - b, 0.0);
    let (a, b) = (1.0 + 2.0_f64.powi(-27), 1.0 + 2.0_f64.powi(-26));
    assert_eq!(f64::sum_of_products([[a, a], [-b, 1.0]]), 2.0_f64.powi(-54));
}
