//! The test of a box never reports a miss for a ray that meets it, and reports one for a ray that passes it at a
//! sufficient distance.

use super::super::{Scalar, UnitScalar};
use super::MARGIN_BITS;
use crate::random::Random;
use crate::scalar::Culling;
use std::vec::Vec;

impl Random {
    fn components(&mut self, most: f64) -> [f64; 3] {
        [(); 3].map(|()| self.between(-most, most))
    }

    /// Along an axis, in the plane of two axes, or in any direction.
    fn components_of_direction(&mut self) -> [f64; 3] {
        let mut v = self.components(1.0);
        for component in &mut v {
            if self.unit() < 0.3 {
                *component = 0.0;
            }
        }
        let square: f64 = v.iter().map(|c| c * c).sum();
        if square < 1e-3 { [0.0, -1.0, 0.0] } else { v.map(|c| c / libm::sqrt(square)) }
    }
}

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value).unwrap_or(S::INFINITY)
}

fn unit<S: Scalar>(d: [f64; 3]) -> [S::Unit; 3] {
    d.map(<S::Unit as UnitScalar>::from_f64)
}

/// For a box of about this size at about this distance.
fn meets_what_it_meets<S: Scalar>(size: f64, away: f64) {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    for _ in 0..20_000 {
        let centre = random.components(away).map(number::<S>);
        // Half extents as a hierarchy makes them: larger than the content of the box by the fraction of its size.
        let within = [(); 3].map(|()| if random.unit() < 0.2 { 0.0 } else { size * random.unit() });
        let part = within.iter().fold(0.0_f64, |most, half| most.max(*half)) * f64::from(MARGIN_BITS).exp2().recip();
        let half = within.map(|half| number::<S>(half + part));
        // A point in the box, often on a face, an edge or a corner.
        let inner = [0, 1, 2].map(|i| {
            let side = (random.between(-2.0, 2.0)).clamp(-1.0, 1.0);
            centre[i].to_f64() + side * within[i]
        });
        let (d, t) = (random.components_of_direction(), away * random.unit());
        let origin = [0, 1, 2].map(|i| number::<S>(inner[i] - t * d[i]));
        let hit = number::<S>(t);
        for range in [[S::ZERO, S::BUDGET.distance], [hit, hit], [S::ZERO, hit], [-hit, S::BUDGET.distance]] {
            assert!(
                !S::misses_box(&S::slabs(origin, unit::<S>(d)), range, centre, half),
                "{origin:?} {d:?} {range:?} {centre:?} {half:?}"
            );
        }
    }
}

/// If a ray passes a ball by more than a thousandth of its distance and size, the test reports a miss of the ball's
/// box.
fn misses_what_it_passes<S: Scalar>(size: f64, away: f64) {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let clear = (away + size) * 1e-3;
    for _ in 0..2_000 {
        let centre = random.components(away);
        let half = [(); 3].map(|()| size * random.between(0.1, 1.0));
        let (h, d) = (half.map(number::<S>), random.components_of_direction());
        let missed = |origin: [f64; 3], d: [f64; 3], range| {
            S::misses_box(&S::slabs(origin.map(number), unit::<S>(d)), range, centre.map(number), h)
        };
        let whole = [S::ZERO, S::BUDGET.distance];
        let half_width: f64 = (0..3).map(|i| half[i] * d[i].abs()).sum();
        let at = |t: f64| [0, 1, 2].map(|i| centre[i] + t * d[i]);
        // Behind the origin, beyond the end of the range, before its start.
        assert!(missed(at(half_width + clear), d, whole), "behind {centre:?} {half:?} {d:?}");
        let (near, far) = (at(-away), at(-away - half_width));
        assert!(
            missed(near, d, [S::ZERO, number(away - half_width - clear)]) || away < half_width + clear,
            "beyond the end"
        );
        assert!(missed(far, d, [number(away + 2.0 * half_width + clear), S::BUDGET.distance]), "before the start");
        // Past an edge, perpendicular to it: along the axis of the plane of the two others.
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let (mut along, mut off) = ([0.0; 3], [0.0; 3]);
            let angle = random.between(0.0, core::f64::consts::TAU);
            (along[i], along[j]) = (libm::cos(angle), libm::sin(angle));
            (off[i], off[j]) = (-along[j], along[i]);
            let by = half[i] * off[i].abs() + half[j] * off[j].abs() + clear;
            let origin = [0, 1, 2].map(|k| centre[k] + by * off[k] - away * along[k]);
            assert!(missed(origin, along, whole), "past an edge: {origin:?} {along:?} {centre:?} {half:?}");
        }
    }
}

#[test]
fn a_box_that_a_ray_meets_is_not_missed() {
    for (size, away) in [(1.0, 4.0), (1e-3, 4.0), (30.0, 4.0), (0.0, 0.0)] {
        meets_what_it_meets::<f32>(size, away);
        meets_what_it_meets::<f64>(size, away);
    }
    meets_what_it_meets::<f32>(1e-38, 1e-38);
    meets_what_it_meets::<f32>(1e37, 2e37);
    meets_what_it_meets::<f64>(1e-308, 1e-308);
}

#[test]
fn a_box_that_a_ray_passes_is_missed() {
    for (size, away) in [(1.0, 4.0), (1e-3, 4.0), (30.0, 4.0)] {
        misses_what_it_passes::<f32>(size, away);
        misses_what_it_passes::<f64>(size, away);
    }
    misses_what_it_passes::<f32>(1e30, 2e30);
}

#[cfg(feature = "fixed")]
mod in_fixed_point {
    use super::{meets_what_it_meets, misses_what_it_passes};
    use fixed::types::{I2F30, I2F62, I16F16, I20F12, I32F0, I32F32, I64F0};

    #[test]
    fn a_box_that_a_ray_meets_is_not_missed() {
        for (size, away) in [(1.0, 4.0), (1e-3, 4.0), (30.0, 4.0), (2000.0, 6000.0)] {
            meets_what_it_meets::<I16F16>(size, away);
            meets_what_it_meets::<I32F32>(size, away);
            meets_what_it_meets::<I20F12>(size, away);
        }
        // Near the budget, where the difference of two coordinates leaves the type.
        meets_what_it_meets::<I2F30>(0.2, 0.2);
        meets_what_it_meets::<I2F62>(0.2, 0.2);
        meets_what_it_meets::<I32F0>(2e8, 2e8);
        meets_what_it_meets::<I64F0>(1e18, 1e18);
        meets_what_it_meets::<I32F32>(2e8, 2e8);
        meets_what_it_meets::<I32F32>(1.0, 2e8);
    }

    #[test]
    fn a_box_that_a_ray_passes_is_missed() {
        for (size, away) in [(1.0, 4.0), (0.25, 4.0), (30.0, 4.0), (2000.0, 2000.0)] {
            misses_what_it_passes::<I16F16>(size, away);
            misses_what_it_passes::<I32F32>(size, away);
        }
        misses_what_it_passes::<I32F0>(2e8, 2e8);
        misses_what_it_passes::<I64F0>(1e18, 1e18);
    }
}

/// Rays at one box, and past it, with the expected results.
#[test]
fn the_middle_of_a_face_and_the_way_past_it() {
    let (centre, half) = ([10.0_f32, 0.0, 0.0], [1.0_f32; 3]);
    let missed = |o, d, range| f32::misses_box(&f32::slabs(o, d), range, centre, half);
    let forward = [0.0, f32::MAX];
    let (x, z) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let answers: Vec<bool> = [
        missed([0.0; 3], x, forward),
        missed([0.0; 3], [-1.0, 0.0, 0.0], forward),
        missed([0.0; 3], x, [0.0, 8.9]),
        missed([0.0; 3], x, [0.0, 9.0]),
        missed([0.0; 3], x, [11.1, 20.0]),
        missed([0.0, 1.0, 0.0], x, forward),
        missed([0.0, 1.01, 0.0], x, forward),
        missed([10.0, 0.5, 0.0], z, forward),
        missed([10.0, 0.0, 1.1], z, forward),
        missed([10.0, 0.0, 1.1], z, [-5.0, 5.0]),
    ]
    .into();
    assert_eq!(answers, [false, true, true, false, true, false, true, false, true, false]);
}
