use super::*;
use crate::part::Part;
use crate::scene::Color;

/// Each reason to refine a pixel, alone and at each corner; in a picture several of them mostly occur together.
#[test]
fn corners_differ_by_object_part_lights_or_a_channel() {
    fn check<S: Scalar>() {
        let sample = |color, seen, lit_by| Sample::<S> { color: Color::from_f64(color), seen, lit_by };
        let (gray, ball) = ([0.5; 3], Some((1, Part::Side)));
        let same = sample(gray, ball, 1);
        for place in 0..4 {
            let with = |other| {
                let mut corners = [same; 4];
                corners[place] = other;
                differ(&corners)
            };
            assert!(!with(same));
            assert!(with(sample(gray, Some((2, Part::Side)), 1)) && with(sample(gray, Some((1, Part::Top)), 1)));
            assert!(with(sample(gray, None, 1)) && with(sample(gray, ball, 3)));
            for channel in 0..3 {
                for (by, expected) in [(0.048, false), (0.050, true), (-0.045, false), (-0.047, true)] {
                    let mut color = gray;
                    color[channel] += by;
                    assert_eq!(with(sample(color, ball, 1)), expected, "{channel} by {by}");
                }
            }
        }
        // Both are white on a display.
        let glaring = |red| sample([red, 0.5, 0.5], ball, 1);
        assert!(!differ(&[glaring(1.1), glaring(1.5), glaring(1.0), glaring(1.2)]));
    }
    check::<f32>();
    check::<f64>();
    #[cfg(feature = "fixed")]
    check::<fixed::types::I16F16>();
    #[cfg(feature = "fixed")]
    check::<fixed::types::I32F32>();
}
