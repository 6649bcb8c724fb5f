//! Random combinations of the solids of a crowd, and what they are by definition.

use crate::crowd::{Crowd, Of};
use raylet::shape::combination::{MOST_CROSSINGS, MOST_LEAVES, Op};
use raylet::{Combination, Ray, Shape};
use support::amount::times;
use support::exact_types::Exact;
use support::oracle::{Dyadic, Membership, Solid, contains};
use support::placed::Placed;
use support::random::Random;

/// Solids and operations.
pub struct Parts<S: Exact> {
    pub leaves: Vec<Shape<S>>,
    pub operations: Vec<Op>,
    solids: Vec<Solid>,
    placed: Vec<Placed<S>>,
}

/// The predicate, straight from the definition of postfix notation.
pub fn holds(operations: &[Op], is_in: impl Fn(usize) -> bool) -> bool {
    let (mut sets, mut leaf) = (vec![], 0);
    for op in operations {
        if *op == Op::Leaf {
            sets.push(is_in(leaf));
            leaf += 1;
            continue;
        }
        let (last, other) = (sets.pop().unwrap(), sets.pop().unwrap());
        sets.push(match op {
            Op::Union => other || last,
            Op::Intersection => other && last,
            _ => other && !last,
        });
    }
    assert_eq!((sets.len(), leaf), (1, operations.len() / 2 + 1));
    sets[0]
}

/// Operations that combine this number of leaves.
pub fn operations(leaves: usize, random: &mut Random) -> Vec<Op> {
    let (mut operations, mut named, mut sets) = (vec![], 0, 0);
    while named < leaves || sets > 1 {
        if named < leaves && (sets < 2 || random.below(2) == 0) {
            operations.push(Op::Leaf);
            (named, sets) = (named + 1, sets + 1);
        } else {
            operations.push(random.pick(&[Op::Union, Op::Intersection, Op::Difference, Op::Difference]));
            sets -= 1;
        }
    }
    operations
}

impl<S: Exact> Parts<S> {
    /// Of all solids of a random crowd; `None` if there are none.
    pub fn random(random: &mut Random, of: Of) -> Option<(Self, Crowd<S>)> {
        let mut crowd = Crowd::<S>::random(random, of);
        // Two that are equal, now and then.
        let (mut leaves, mut solids, mut placed) = (vec![], vec![], vec![]);
        for ((shape, solid), own) in crowd.shapes.iter().zip(&crowd.solids).zip(crowd.placed.drain(..)) {
            if shape.is_solid() {
                leaves.push(*shape);
                solids.push(solid.clone());
                placed.push(own);
            }
        }
        let operations = operations(leaves.len(), random);
        (!leaves.is_empty()).then_some((Self { leaves, operations, solids, placed }, crowd))
    }

    /// Calls a test with random combinations and five rays through each.
    pub fn each(of: Of, seed: u64, count: u64, mut test: impl FnMut(&Self, &Ray<S>, &mut Random)) {
        let mut random = Random(seed);
        for _ in 0..times(count) {
            let Some((parts, crowd)) = Self::random(&mut random, of) else { continue };
            for _ in 0..5 {
                if let Some(ray) = crowd.ray(&mut random) {
                    test(&parts, &ray, &mut random);
                }
            }
        }
    }

    pub fn combination(&self) -> Combination<'_, S> {
        Combination::new(&self.leaves, &self.operations).expect("at most eight solids")
    }

    /// Whether the ray's point at an exact `t` is in the result; `None` on the surface of a leaf.
    pub fn is_in(&self, ray: &Ray<S>, t: &Dyadic) -> Option<bool> {
        let at = |(solid, placed): (&Solid, &Placed<S>)| match contains(solid, &placed.line(ray).point_at(t)) {
            Membership::Inside => Some(true),
            Membership::Outside => Some(false),
            Membership::OnSurface => None,
        };
        let leaves = self.solids.iter().zip(&self.placed).map(at).collect::<Option<Vec<_>>>()?;
        Some(holds(&self.operations, |leaf| leaves[leaf]))
    }

    pub fn told(&self, ray: &Ray<S>) -> String {
        format!("{ray:?}\n{:#?}\n{:?}", self.leaves, self.operations)
    }
}

#[test]
fn there_is_room_for_what_the_page_says() {
    assert_eq!((MOST_LEAVES, MOST_CROSSINGS), (16, 32));
}
