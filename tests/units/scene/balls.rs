//! No ball that shades a point of another is left out, and most of those that do not are.

use super::*;
use crate::random::Random;
use fixed::types::I16F16;

fn vector<S: Scalar>(random: &mut Random, most: f64) -> Vec3<S> {
    Vec3::from([0; 3].map(|_| S::from_f64(random.between(-most, most)).expect("a value of the type")))
}

/// A ball around a point, which is inside of it.
fn around_point<S: Scalar>(random: &mut Random, inside: [f64; 3], size: f64) -> BallInWorld<S> {
    let radius = size * random.between(0.05, 1.0);
    // In a cube inside of the ball.
    let off = [0; 3].map(|_| 0.5 * radius * random.between(-1.0, 1.0));
    let value = |value| S::from_f64(value).expect("a value of the type");
    let [x, y, z] = [0, 1, 2].map(|axis| value(inside[axis] + off[axis]));
    (Vec3::new(x, y, z), [value(radius), S::ZERO, S::ZERO])
}

/// Returns how many of those that need not shade another may do so, and of how many.
fn check<S: Scalar>(seed: u64, size: f64, away: f64) -> [u32; 2] {
    let (mut random, mut others, pairs) = (Random(seed), 0, 2_000);
    let f64s = |v: Vec3<S>| v.to_array().map(S::to_f64);
    for _ in 0..pairs {
        let lit = [0; 3].map(|_| away + random.between(-size, size));
        let receiver = around_point::<S>(&mut random, lit, size);
        let far = size * random.between(1.0, 10.0);
        let offset: Vec3<S> = vector(&mut random, far);
        let light = if random.between(0.0, 1.0) < 0.5 {
            let Some(towards) = UnitVec3::new(offset).ok() else { continue };
            Light::distant(towards, S::ZERO)
        } else {
            Light::new(
                Vec3::from(
                    [0, 1, 2].map(|axis| S::from_f64(lit[axis] + f64s(offset)[axis]).expect("a value of the type")),
                ),
                S::ZERO,
            )
        };
        // A point between the lit one and the light, or beside that.
        let share = random.between(0.0, 0.95);
        let lamp = f64s(light.position);
        let length = lamp.iter().map(|c| c * c).sum::<f64>().sqrt();
        let way =
            [0, 1, 2].map(|axis| if light.distant { 5.0 * size * lamp[axis] / length } else { lamp[axis] - lit[axis] });
        let between = [0, 1, 2].map(|axis| lit[axis] + share * way[axis]);
        let occluder = around_point::<S>(&mut random, between, size);
        assert!(may_shade(occluder, receiver, &light), "{occluder:?} {receiver:?} {light:?}");
        let anywhere = [0, 1, 2].map(|axis| lit[axis] + f64s(vector::<S>(&mut random, 4.0 * size))[axis]);
        let other = around_point::<S>(&mut random, anywhere, 0.5 * size);
        others += u32::from(may_shade(other, receiver, &light));
    }
    [others, pairs]
}

#[test]
fn a_ball_that_shades_a_point_of_another_is_known_to() {
    for [others, pairs] in [
        check::<f32>(1, 1.0, 0.0),
        check::<f64>(2, 1.0, 1e6),
        check::<I16F16>(3, 1.0, 0.0),
        check::<I16F16>(4, 30.0, 6_000.0),
        check::<f32>(5, 1e-3, 0.0),
        check::<f32>(6, 1e4, 0.0),
        check::<f32>(7, 1e15, 0.0),
        check::<f32>(8, 1e-15, 0.0),
    ] {
        assert!(3 * others < pairs, "{others} of {pairs}");
    }
    // Squares have no digits: any may.
    check::<f32>(9, 3e-23, 0.0);
}
