use super::*;

#[test]
fn levels_are_those_of_the_standard() {
    assert_eq!([encoded(0), encoded(65535 / 2), encoded(65536)], [0, 48_003, 255 * STEPS]);
    for linear in 0..=65536 {
        let c = f64::from(linear) / 65536.0;
        let exact = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * libm::pow(c, 1.0 / 2.4) - 0.055 };
        let off = f64::from(encoded(linear)) / f64::from(STEPS) - 255.0 * exact;
        assert!(off.abs() < 0.03, "{linear}: {off}");
    }
}

#[test]
fn brighter_is_never_darker() {
    assert!((0..65536).all(|linear| encoded(linear) <= encoded(linear + 1)));
}

#[test]
fn the_nearest_level_is_that_of_the_encoded_channel() {
    assert!((0..=65536).all(|linear| nearest_of_255(linear) == (encoded(linear) + STEPS / 2) / STEPS));
}
