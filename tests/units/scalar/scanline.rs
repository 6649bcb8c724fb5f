//! In integers a row has the directions that it has in numbers, to within some units.

use super::*;
use crate::frame::Frame;
use crate::random::Random;
use crate::scalar::block::Block64;
use crate::vector::{UnitVec3, Vec3};
use fixed::types::I16F16;

type Number = I16F16;
type Axis = [<Number as crate::scalar::Numbers>::Unit; 3];

fn in_integers(forward: Axis, across: [Axis; 2], steps: [Block64; 2], y: i32) -> InIntegers {
    let row = <InIntegers as Scanline<Number>>::new(forward, across, steps);
    Scanline::<Number>::above(row, y)
}

/// The largest difference, in units of a component, between directions of rows of this step, up to so many steps away;
/// rows are so many times as far apart as columns.
fn difference(seed: u64, step: f64, most: i32, wider: f64) -> i64 {
    let (mut random, mut largest) = (Random(seed), 0);
    for _ in 0..400 {
        let axis = [0; 3].map(|_| random.between(-1.0, 1.0));
        let axis = UnitVec3::<Number>::new(Vec3::from_f64(axis).expect("a vector")).expect("a direction");
        let [right, up, forward] = Frame::from_base_and_axis(Vec3::ZERO, axis).expect("a frame").axes();
        let [forward, right, up] = [forward, right, up].map(UnitVec3::to_array);
        // Steps of as many bits as a quotient has.
        let step = step * random.between(0.5, 1.0);
        let steps = [step, step * wider].map(|step| Block64::new((step * 2_f64.powi(58)) as i64, -58));
        let [x, y] = [0; 2].map(|_| random.between(-f64::from(most), f64::from(most)) as i32);
        let integers = in_integers(forward, [right, up], steps, y);
        let integers = Scanline::<Number>::direction(&integers, x);
        let numbers = InNumbers::<Number>::new(forward, [right, up], steps).above(y).direction(x);
        let pairs = pairs(integers.expect("it has a length"), numbers.expect("it has a length"));
        for (a, b) in pairs {
            largest = largest.max((i64::from(a.to_bits()) - i64::from(b.to_bits())).abs());
        }
    }
    largest
}

#[test]
fn directions_in_integers_are_those_in_numbers() {
    // Pictures, one of 8,000 rows, a telescope, and pictures of two rows and of one.
    for (step, most) in [(4e-3, 240), (1e-4, 8000), (1e-6, 1000), (0.3, 3), (1.0, 2), (4.0, 1)] {
        // Zones of sensors may be higher than wide, or wider than high.
        for wider in [1.0, 2.5, 0.125] {
            let difference = difference(most as u64, step, most, wider);
            // Both steps are rounded to the unit of the longer.
            let tangent = step * f64::from(most) * if wider > 1.0 { 1.0 + wider } else { 1.0 };
            assert!(difference <= 3 + tangent as i64, "{difference} units at {step}, {wider}");
        }
    }
}

#[test]
fn steps_of_no_length_and_of_any_length_overflow_nowhere() {
    let [right, up, forward] = Frame::<Number>::at(Vec3::ZERO).expect("a frame").axes().map(UnitVec3::to_array);
    for exponent in [-5000, -200, -90, -61, -60, -31, -30, -1, 0, 1, 30, 62, 5000] {
        for mantissa in [0, 1, 3, (1 << 30) - 1, i64::MAX >> 1] {
            for most in [0, 1, -1, (1 << 26) - 1, -(1 << 26)] {
                let step = Block64::new(mantissa, exponent);
                for steps in [[step, Block64::new(1, -20)], [Block64::new(1, -20), step]] {
                    let _ = Scanline::<Number>::direction(&in_integers(forward, [right, up], steps, most), most);
                }
            }
        }
    }
    let still = in_integers(forward, [right, up], [Block64::new(0, 0); 2], 9);
    assert_eq!(Scanline::<Number>::direction(&still, 9), Some(forward));
}
