//! The order of crossings of a torus among those of planes, quadrics and tori, where they are equal.

use super::end::{Fraction, Place};
use super::roots::RootOfQuadric;
use super::{Line, Of, Root, root_at};
use crate::equations::Equations;
use crate::hit::{Crossing, Hit};
use crate::number::Integer;
use crate::part::Part;
use crate::primitive::Torus;
use crate::scalar::FromScalar;
use core::cmp::Ordering;

type Number = Integer<320>;

fn number(value: f32) -> Number {
    <Number as FromScalar<f32>>::scalar(value)
}

/// The line along the x axis from -3, at this height.
fn line(height: f32) -> Line<Number> {
    Line { origin: [-3.0, height, 0.0].map(number), direction: [1.0, 0.0, 0.0].map(number) }
}

fn crossing(height: f32, radii: [f32; 2], t: f32, crossing: Crossing) -> Root<Number> {
    let hit = Hit { t, part: Part::Side, crossing };
    let root = root_at::<f32, Number, Torus<f32>>(&Equations::Torus { radii }, &hit, &line(height), None);
    // Signs are certain: no test expects the other root.
    root.unwrap_or(RootOfQuadric::at(Fraction { n: number(f32::MAX), e: number(1.0) }).into())
}

/// The crossings of the ring with the radii 1 and 0.25 in its own plane.
fn of_ring() -> [(f32, Root<Number>); 4] {
    [(1.75, Crossing::Enter), (2.25, Crossing::Exit), (3.75, Crossing::Enter), (4.25, Crossing::Exit)]
        .map(|(t, kind)| (t, crossing(0.0, [1.0, 0.25], t, kind)))
}

fn same<N: Of<f32>>(a: &Root<N>, b: &Root<N>, order: Ordering) {
    assert_eq!(a.order(b), Some(order));
    assert_eq!(b.order(a), Some(order.reverse()));
}

#[test]
fn a_plane_is_crossed_before_at_or_after_a_torus() {
    for (t, root) in of_ring() {
        for at in [1.5, 1.75, 2.0, 2.25, 3.0, 3.75, 4.0, 4.25, 5.0_f32] {
            for scale in [1.0, -2.0] {
                let plane = RootOfQuadric::at(Fraction { n: number(at * scale), e: number(scale) });
                same(&root, &plane.into(), t.total_cmp(&at));
            }
        }
    }
}

#[test]
fn a_ball_is_crossed_before_at_or_after_a_torus() {
    for (t, root) in of_ring() {
        for radius in [0.5, 0.75, 1.0, 1.25, 1.5_f32] {
            for (place, at) in [(Place::First, 3.0 - radius), (Place::Second, 3.0 + radius)] {
                // (t - 3)^2 - r^2, and its negative.
                let f = [1.0, -3.0, 9.0 - radius * radius];
                for f in [f, f.map(|c| -c)] {
                    same(&root, &RootOfQuadric::new(f.map(number), place).into(), t.total_cmp(&at));
                }
            }
        }
    }
}

#[test]
fn crossings_of_the_same_torus_are_the_same() {
    let ring = of_ring();
    for (t, root) in &ring {
        for (at, other) in &ring {
            same(root, other, t.total_cmp(at));
        }
    }
    // Beside a thinner ring, whose crossings lie between.
    let thin = crossing(0.0, [1.0, 0.125], 1.875, Crossing::Enter);
    assert_eq!(
        ring.map(|(_, root)| root.order(&thin)),
        [Some(Ordering::Less), Some(Ordering::Greater), Some(Ordering::Greater), Some(Ordering::Greater)]
    );
}

/// Double roots, in the plane of the highest circle: they are those of a quadratic equation.
#[test]
fn touches_are_where_a_ball_is_crossed() {
    let touch = |t: f32| crossing(0.25, [1.0, 0.25], t, Crossing::Touch);
    for (t, place) in [(2.0, Place::First), (4.0, Place::Second)] {
        let ball = RootOfQuadric::new([1.0, -3.0, 8.0].map(number), place);
        same(&touch(t), &ball.into(), Ordering::Equal);
        same(&touch(t), &Root::at_parameter(number(3.0)), t.total_cmp(&3.0));
    }
    same(&touch(2.0), &touch(4.0), Ordering::Less);
    same(&touch(2.0), &touch(2.0), Ordering::Equal);
}
