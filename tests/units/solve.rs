//! The solver over numbers with random signs, orders and values: its ends are always sorted and paired.

use super::{Attempt, Goal, LocalRay, Stop};
use super::{
    annulus, ball, capsule, cone, cuboid, cylinder, disc, plane, polyhedron, prism, rectangle, round_cone,
    rounded_cuboid, torus, triangle, tube,
};
use crate::half_space::{CutBox, HalfSpace};
use crate::hit::Crossing;
use crate::intersection::Intersection;
use crate::number::{Estimate, Number, Ring};
use crate::outline::{Extent, Outline};
use crate::part::Part;
use crate::polygon::Polygon;
use crate::random::Random;
use crate::ray::{Leaving, Range};
use crate::scalar::{FromScalar, ToScalar};
use crate::vector::Vec3;
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};
use std::cell::Cell;
use std::format;
use std::vec::Vec;

std::thread_local! {
    static STATE: Cell<u64> = const { Cell::new(1) };
}

fn random() -> u64 {
    let mut random = Random(STATE.get());
    let number = random.next() >> 8;
    STATE.set(random.0);
    number
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
    type Long = Self;
    const DECIDES_BY_SIGNS: bool = true;
    fn sign(self) -> Option<Ordering> {
        Some(random_order())
    }
    fn estimate(self) -> Self {
        Self
    }
    fn long(self) -> Self {
        Self
    }
    fn apart<A>(work: impl FnOnce() -> A) -> A {
        work()
    }
}
impl Estimate for Fickle {
    const INFINITY: Self = Self;
    const DIGITS: i32 = 24;
    type Rough = Self;
    fn rough(self) -> Self {
        Self
    }
    fn exactly(_: Self) -> Self {
        Self
    }
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
    fn of(_: f32) -> Self {
        Self
    }
    fn rounded(self) -> Option<f32> {
        Some(match random() % 8 {
            0 => f32::INFINITY,
            1 => f32::NEG_INFINITY,
            2 => 0.0,
            n => (random() % 9) as f32 - n as f32,
        })
    }
}

/// What cuts the box of the polyhedron.
static CUTS: [HalfSpace<f32>; 2] = [
    HalfSpace { point: Vec3::new(0.5, 0.5, 0.5), normal: Vec3::new(1.0, 1.0, 1.0) },
    HalfSpace { point: Vec3::new(-0.5, 0.0, 0.0), normal: Vec3::new(-1.0, 2.0, 0.0) },
];

/// A solver of this module.
#[derive(Clone, Copy, Debug)]
enum Solver {
    Ball,
    Capsule,
    RoundCone([f32; 2]),
    Tube,
    Torus,
    Cylinder(Extent<f32>),
    Cone(Outline<f32>, Extent<f32>),
    Plane,
    Disc,
    Annulus,
    Triangle,
    Cuboid,
    RoundedCuboid([f32; 3]),
    Prism,
    Polyhedron,
    Rectangle,
}

impl Solver {
    fn all() -> Vec<Self> {
        let mut all = Vec::from([
            Self::Ball,
            Self::Capsule,
            Self::RoundCone([1.0, 0.5]),
            Self::RoundCone([0.5, 3.0]),
            Self::Tube,
            Self::Torus,
            Self::Plane,
            Self::Disc,
            Self::Annulus,
            Self::Triangle,
            Self::Cuboid,
            Self::RoundedCuboid([1.0, 2.0, 0.5]),
            Self::RoundedCuboid([0.0, 1.0, 0.0]),
            Self::Prism,
            Self::Polyhedron,
            Self::Rectangle,
        ]);
        for extent in [Extent::Infinite, Extent::Open(2.0), Extent::Capped(2.0)] {
            all.push(Self::Cylinder(extent));
            for outline in [Outline::Slope(1.0), Outline::Radii(1.0, 0.5, 2.0), Outline::Radii(0.0, 1.0, 2.0)] {
                all.push(Self::Cone(outline, extent));
            }
        }
        all.push(Self::Cone(Outline::Slope(1.0), Extent::Double));
        all
    }

    /// True if the crossings of a line with it need not pair up.
    const fn is_surface(self) -> bool {
        matches!(
            self,
            Self::Plane
                | Self::Disc
                | Self::Annulus
                | Self::Rectangle
                | Self::Triangle
                | Self::Cylinder(Extent::Open(_))
                | Self::Cone(_, Extent::Open(_))
        )
    }

    /// True if a ray that departs outwards meets nothing, so that no solver runs.
    fn meets_nothing(self, departure: Option<(Part, Leaving)>) -> bool {
        let is_flat = matches!(self, Self::Plane | Self::Disc | Self::Annulus | Self::Rectangle | Self::Triangle);
        let is_convex = !matches!(self, Self::Cone(_, Extent::Double));
        let returns = |part: Part| matches!(self, Self::Torus) || matches!(self, Self::Tube) && part == Part::Inner;
        departure
            .is_some_and(|(part, leaving)| is_flat || (is_convex && leaving == Leaving::Outwards && !returns(part)))
    }

    fn run(self, line: LocalRay<Fickle>, goal: Goal<f32>) -> Attempt<Intersection<f32>> {
        let line = &line;
        match self {
            Self::Ball => ball(line, 1.0, goal),
            Self::Capsule => capsule(line, [1.0, 2.0], goal),
            Self::RoundCone(radii) => round_cone(line, radii, 2.0, goal),
            Self::Tube => tube(line, [0.5, 1.0], 2.0, goal),
            Self::Torus => torus(line, [1.0, 0.25], goal),
            Self::Cylinder(extent) => cylinder(line, 1.0, extent, goal),
            Self::Cone(outline, extent) => cone(line, outline, extent, goal),
            Self::Plane => plane(line, goal),
            Self::Disc => disc(line, 1.0, goal),
            Self::Annulus => annulus(line, [0.5, 1.0], goal),
            Self::Triangle => triangle(line, [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], goal),
            Self::Cuboid => cuboid(line, [1.0, 2.0, 3.0], goal),
            Self::RoundedCuboid(half) => rounded_cuboid(line, half, 1.0, goal),
            Self::Prism => prism(line, Polygon::new(&[[1.0, 0.0], [0.0, -1.0], [-1.0, 1.0]]), 2.0, goal),
            Self::Polyhedron => polyhedron(line, CutBox::new([[-1.0; 3], [1.0; 3]], &CUTS), goal),
            Self::Rectangle => rectangle(line, [1.0, 2.0], goal),
        }
    }
}

#[test]
fn contradicting_signs_leave_ends_sorted_and_paired() {
    let ranges = [Range::FORWARD, Range::line(), Range::new(-1.0, 2.0).unwrap_or(Range::FORWARD)];
    let mut departures = Vec::from([None]);
    for part in [Part::Side, Part::Base, Part::Top, Part::Left, Part::Front, Part::Inner] {
        departures.extend([Some((part, Leaving::Inwards)), Some((part, Leaving::Outwards))]);
    }
    for solver in Solver::all() {
        let mut met = 0;
        for departure in &departures {
            if solver.meets_nothing(*departure) {
                continue;
            }
            let line = LocalRay {
                origin: [Fickle; 3],
                direction: [Fickle; 3],
                departure: *departure,
                start: None,
                moved: Fickle,
                is_unit: false,
            };
            for _ in 0..2_000 {
                let range = ranges[(random() % 3) as usize];
                let intersection = match solver.run(line, Goal { range, since: None }) {
                    Ok(intersection) => intersection,
                    Err(Stop::Miss) => Intersection::Miss,
                    Err(Stop::Unsure) => continue,
                };
                let hits = intersection.hits(range);
                met += hits.len();
                let told = || format!("{solver:?} {departure:?} {range:?}: {intersection:?} {hits:?}");
                assert!(hits.iter().all(|hit| range.contains(hit.t)), "{}", told());
                assert!(hits.windows(2).all(|pair| pair[0].t <= pair[1].t), "{}", told());
                let mut is_inside = hits.starts_inside();
                for hit in hits.iter().filter(|_| !solver.is_surface()) {
                    assert!(is_inside == (hit.crossing == Crossing::Exit), "{}", told());
                    is_inside = hit.crossing == Crossing::Enter;
                }
                let nearest = intersection.nearest(range, |_| true);
                assert_eq!(nearest, hits.first().copied(), "{}", told());
            }
        }
        assert!(met > 100, "{solver:?} {met}");
    }
}
