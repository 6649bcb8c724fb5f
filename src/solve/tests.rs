//! The solver over numbers with random signs, orders and values: its ends are always sorted and paired.

use super::{Line, intersect, meets_nothing};
use crate::equations::{Described, EquationKinds, Equations, Extent, Side};
use crate::hit::Crossing;
use crate::number::{Estimate, Number, Ring};
use crate::part::Part;
use crate::ray::{Leaving, Range};
use crate::scalar::{FromScalar, ToScalar};
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};
use std::cell::Cell;
use std::format;
use std::vec::Vec;

/// A geometry with equations of every kind.
struct Any;

impl Described for Any {
    const EQUATIONS: EquationKinds = EquationKinds::ALL;
}

std::thread_local! {
    static STATE: Cell<u64> = const { Cell::new(1) };
}

/// Marsaglia, *Xorshift RNGs*, 2003.
fn random() -> u64 {
    let mut state = STATE.get();
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    STATE.set(state);
    state >> 8
}

fn random_order() -> Ordering {
    [Ordering::Less, Ordering::Equal, Ordering::Greater][(random() % 3) as usize]
}

/// A number whose comparisons contradict each other.
#[derive(Clone, Copy, Debug)]
struct Fickle;

impl Add for Fickle {
    type Output = Self;
    fn add(self, _: Self) -> Self {
        Self
    }
}
impl Sub for Fickle {
    type Output = Self;
    fn sub(self, _: Self) -> Self {
        Self
    }
}
impl Mul for Fickle {
    type Output = Self;
    fn mul(self, _: Self) -> Self {
        Self
    }
}
impl Neg for Fickle {
    type Output = Self;
    fn neg(self) -> Self {
        Self
    }
}
impl Ring for Fickle {
    const ZERO: Self = Self;
    const ONE: Self = Self;
    fn scaled(self, _: i32) -> Self {
        Self
    }
}
impl Number for Fickle {
    type Estimate = Self;
    fn sign(self) -> Option<Ordering> {
        Some(random_order())
    }
    fn estimate(self) -> Self {
        Self
    }
}
impl Estimate for Fickle {
    fn over(self, _: Self) -> Self {
        Self
    }
    fn square_root(self) -> Self {
        Self
    }
    fn compare(self, _: Self) -> Option<Ordering> {
        // Sometimes the order is unknown, so that the decision by signs is tested too.
        (!random().is_multiple_of(4)).then(random_order)
    }
    fn top(self) -> Option<i32> {
        None
    }
}
impl FromScalar<f32> for Fickle {
    fn scalar(_: f32) -> Self {
        Self
    }
    fn unit(_: f32) -> Self {
        Self
    }
}
impl ToScalar<f32> for Fickle {
    const ROUNDING_DECIDES: bool = true;
    fn rounded(self) -> Option<f32> {
        Some(match random() % 8 {
            0 => f32::INFINITY,
            1 => f32::NEG_INFINITY,
            2 => 0.0,
            n => (random() % 9) as f32 - n as f32,
        })
    }
}

fn all() -> Vec<Equations<f32>> {
    let mut all = Vec::from([
        Equations::Ball { radius: 1.0 },
        Equations::Capsule { radius: 1.0, height: 2.0 },
        Equations::DoubleCone { slope: 1.0 },
        Equations::Plane,
        Equations::Disc { radius: 1.0 },
        Equations::Cuboid { half: [1.0, 2.0, 3.0] },
        Equations::Rectangle { half: [1.0, 2.0] },
        Equations::Triangle { vertices: [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] },
    ]);
    for side in [Side::Straight(1.0), Side::Slope(1.0), Side::Radii(1.0, 0.5, 2.0)] {
        for extent in
            [Extent::Infinite, Extent::Open(2.0), Extent::Capped(Some(0.0), Some(2.0)), Extent::Capped(None, Some(2.0))]
        {
            all.push(Equations::Round { side, extent });
        }
    }
    all
}

#[test]
fn contradicting_signs_leave_ends_sorted_and_paired() {
    let ranges = [Range::FORWARD, Range::line(), Range::new(-1.0, 2.0).unwrap_or(Range::FORWARD)];
    let mut departures = Vec::from([None]);
    for part in [Part::Side, Part::Base, Part::Top, Part::Left, Part::Front] {
        departures.extend([Some((part, Leaving::Inwards)), Some((part, Leaving::Outwards))]);
    }
    let mut met = 0;
    for equations in all() {
        let is_surface = matches!(
            equations,
            Equations::Plane
                | Equations::Disc { .. }
                | Equations::Rectangle { .. }
                | Equations::Triangle { .. }
                | Equations::Round { extent: Extent::Open(_), .. }
        );
        for departure in &departures {
            if meets_nothing(&equations, *departure) {
                continue;
            }
            let line = Line { origin: [Fickle; 3], direction: [Fickle; 3], departure: *departure };
            for _ in 0..2_000 {
                let range = ranges[(random() % 3) as usize];
                // `None` if a sign is unknown too.
                let Some(intersection) = intersect::<_, _, Any>(&equations, &line, range) else { continue };
                let hits = intersection.hits(range);
                met += hits.len();
                let told = || format!("{equations:?} {departure:?} {range:?}: {intersection:?} {hits:?}");
                assert!(hits.iter().all(|hit| range.contains(hit.t)), "{}", told());
                assert!(hits.windows(2).all(|pair| pair[0].t <= pair[1].t), "{}", told());
                let mut is_inside = hits.starts_inside();
                for hit in hits.iter().filter(|_| !is_surface) {
                    assert!(is_inside == (hit.crossing == Crossing::Exit), "{}", told());
                    is_inside = hit.crossing == Crossing::Enter;
                }
                let nearest = intersection.nearest(range, |_| true);
                assert_eq!(nearest, hits.first().copied(), "{}", told());
            }
        }
    }
    assert!(met > 10_000, "{met}");
}
