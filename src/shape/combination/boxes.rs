//! The box of a combination, made of those of its leaves.

use super::{MOST_LEAVES, Op};
use crate::geometry::Bounds;
use crate::scalar::Scalar;
use crate::vector::{Vec3, pairs};

/// The box that the operations make of those of the leaves; `of_leaf` gives one that holds all points of a leaf.
pub(crate) fn bounds<S: Scalar, L>(
    leaves: &[L],
    operations: impl Iterator<Item = Op>,
    of_leaf: impl Fn(&L) -> Bounds<S>,
) -> Bounds<S> {
    let nothing = Bounds { low: Vec3::ZERO, high: Vec3::ZERO };
    let mut boxes = heapless::Vec::<Bounds<S>, MOST_LEAVES>::new();
    let mut leaves = leaves.iter();
    for op in operations {
        if op == Op::Leaf {
            // Cannot be full: a combination has no more leaves.
            let _ = boxes.push(leaves.next().map_or(nothing, &of_leaf));
        } else if let (Some(last), Some(other)) = (boxes.pop(), boxes.last_mut()) {
            *other = match op {
                Op::Union => union(*other, last),
                Op::Intersection => intersection(*other, last),
                Op::Leaf | Op::Difference => *other,
            };
        }
    }
    boxes.pop().unwrap_or(nothing)
}

fn lower<S: Scalar>((a, b): (S, S)) -> S {
    if b < a { b } else { a }
}

fn higher<S: Scalar>((a, b): (S, S)) -> S {
    if b > a { b } else { a }
}

fn union<S: Scalar>(a: Bounds<S>, b: Bounds<S>) -> Bounds<S> {
    let low = pairs(a.low.to_array(), b.low.to_array()).map(lower);
    let high = pairs(a.high.to_array(), b.high.to_array()).map(higher);
    Bounds { low: low.into(), high: high.into() }
}

/// Of boxes apart, a flat one: nothing is in it.
fn intersection<S: Scalar>(a: Bounds<S>, b: Bounds<S>) -> Bounds<S> {
    let low = pairs(a.low.to_array(), b.low.to_array()).map(higher);
    let high = pairs(a.high.to_array(), b.high.to_array()).map(lower);
    Bounds { low: low.into(), high: pairs(low, high).map(higher).into() }
}
