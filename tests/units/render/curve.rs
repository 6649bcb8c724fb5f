//! A curve is a parabola through three pixels, however many columns they are apart.

use super::*;
use fixed::types::I16F16;

fn pixel<S: Scalar>(channels: [f64; 3]) -> Pixel<S> {
    Pixel { color: Color::from_f64(channels), seen: None, lit_by: 0 }
}

fn check<S: Scalar>(most: f64) {
    let one_by = Reciprocals::<S>::new();
    for columns in SHORTEST..=LONGEST {
        // Parabolas that are close to straight lines; one that is straight.
        let n = f64::from(columns);
        let channels = |x: f64| [0.3 + 0.3 * x, 0.5 - 0.1 * x + 0.01 * x * x, 0.4 + 0.02 * x - 0.02 * x * x];
        let at = |column: u16| pixel::<S>(channels(f64::from(column) / n));
        let (first, last) = (at(0), at(columns));
        let mut curve = Curve::through([&first, &at(columns / 2), &last], columns, &one_by).expect("a curve");
        for column in 1..columns {
            let (made, right) = (curve.next().color.to_array(), channels(f64::from(column) / n));
            for (made, right) in pairs(made, right) {
                assert!((made.to_f64() - right).abs() <= most, "{column} of {columns}: {made:?} {right}");
            }
        }
    }
}

#[test]
fn a_curve_is_a_parabola_of_any_length() {
    check::<f32>(3e-6);
    check::<f64>(1e-13);
    check::<I16F16>(3e-6);
}

#[test]
fn what_is_bent_or_sees_other_things_is_no_curve() {
    let one_by = Reciprocals::<f32>::new();
    let [dark, light] = [0.3, 0.5].map(|share| pixel::<f32>([share; 3]));
    for columns in SHORTEST..=LONGEST {
        assert!(Curve::through([&dark, &light, &dark], columns, &one_by).is_none());
        assert!(Curve::through([&dark; 3], columns, &one_by).is_some());
        let other = Pixel { lit_by: 1, ..dark };
        assert!(Curve::through([&dark, &other, &dark], columns, &one_by).is_none());
        assert!(Curve::through([&dark, &dark, &other], columns, &one_by).is_none());
    }
}

#[test]
fn the_middle_is_at_most_a_level_off_a_straight_line() {
    let one_by = Reciprocals::<f32>::new();
    let gray = |level: f64| pixel::<f32>([((level / 255.0 + 0.055) / 1.055).powf(2.4); 3]);
    for (level, is_curve) in [(99.0, true), (100.0, true), (101.0, true), (98.0, false), (102.0, false)] {
        let curve = Curve::through([&gray(100.0), &gray(level), &gray(100.0)], 8, &one_by);
        assert_eq!(curve.is_some(), is_curve, "{level}");
    }
    // Where light is as bright as a pixel can be, it has an edge.
    let [white, less] = [1.0, 0.998].map(|share| pixel::<f32>([share; 3]));
    assert!(Curve::through([&less, &white, &white], 8, &one_by).is_none());
    assert!(Curve::through([&white, &white, &less], 8, &one_by).is_none());
    assert!(Curve::through([&white; 3], 8, &one_by).is_some());
}
