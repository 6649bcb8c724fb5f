//! The operations of a combination: a predicate over the set of leaves that a point lies in.

use super::CombinationError;

/// An operation of a combination, in postfix notation: each takes the last one or two sets, and leaves one.
///
/// The leaves are taken in their order: the first [`Op::Leaf`] is the first of them, and so on. See
/// [`Combination::new`](super::Combination::new).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Op {
    /// The next leaf.
    Leaf,
    /// What is in either of the last two sets.
    Union,
    /// What is in both of the last two sets.
    Intersection,
    /// What is in the last but one of the sets and not in the last.
    Difference,
}

/// The operations of a combination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Operations<'a> {
    /// The same operation between all leaves, from the first to the last.
    Every(Op),
    /// As they were given, and checked.
    Listed(&'a [Op]),
}

impl<'a> Operations<'a> {
    /// The error of operations that do not combine this number of leaves.
    pub(super) const fn check(&self, leaves: usize) -> Result<(), CombinationError> {
        let Self::Listed(mut left) = *self else { return Ok(()) };
        let (mut sets, mut named, mut operation) = (0_usize, 0_usize, 0_usize);
        while let Some((op, behind)) = left.split_first() {
            (sets, named) = match op {
                Op::Leaf => (sets.saturating_add(1), named.saturating_add(1)),
                _ if sets < 2 => return Err(CombinationError::NoOperands { operation }),
                _ => (sets.saturating_sub(1), named),
            };
            left = behind;
            operation = operation.saturating_add(1);
        }
        if named != leaves {
            return Err(CombinationError::OtherLeaves { named, leaves });
        }
        if sets == 1 { Ok(()) } else { Err(CombinationError::NotOne { sets }) }
    }

    /// The leaves, of this number, that are subtracted: an odd number of times, so that what is in them more is in the
    /// result less. A bit for each.
    pub(super) const fn turned(&self, leaves: u32) -> u32 {
        let mut left = match *self {
            Self::Every(Op::Difference) => return mask(leaves) & !1,
            Self::Every(_) => return 0,
            Self::Listed(list) => list,
        };
        // From the last operation to the first: for each operand that is still to come, the next one in the lowest bit,
        // whether it is subtracted.
        let (mut waiting, mut leaf, mut turned) = (0_u32, leaves, 0_u32);
        while let Some((op, before)) = left.split_last() {
            let own = waiting & 1;
            match op {
                Op::Leaf => {
                    waiting >>= 1;
                    leaf = leaf.saturating_sub(1);
                    turned |= own.wrapping_shl(leaf);
                }
                Op::Union | Op::Intersection => waiting = waiting << 1 | own,
                Op::Difference => waiting = waiting << 1 | (own ^ 1),
            }
            left = before;
        }
        turned
    }

    /// True if a point that lies in these leaves, of this number, lies in the result.
    pub(super) fn hold(&self, mut leaves_in: u32, leaves: u32) -> bool {
        let list = match *self {
            Self::Every(Op::Intersection) => return leaves_in == mask(leaves),
            Self::Every(Op::Difference) => return leaves_in == 1,
            Self::Every(_) => return leaves_in != 0,
            Self::Listed(list) => list,
        };
        // The last of the sets is the lowest bit.
        let mut sets = 0_u32;
        for op in list {
            let last = sets & 1;
            sets = match op {
                Op::Leaf => {
                    let is_in = leaves_in & 1;
                    leaves_in >>= 1;
                    sets << 1 | is_in
                }
                Op::Union => sets >> 1 | last,
                Op::Intersection => sets >> 1 & !(last ^ 1),
                Op::Difference => sets >> 1 & !last,
            };
        }
        sets & 1 != 0
    }

    /// The operations, with each leaf.
    pub(super) fn iter(self, leaves: usize) -> impl Iterator<Item = Op> + use<'a> {
        let (op, listed) = match self {
            Self::Every(op) => (op, [].as_slice()),
            Self::Listed(listed) => (Op::Leaf, listed),
        };
        let leaves = if listed.is_empty() { leaves } else { 0 };
        let of_every = move |place: usize| if place != 0 && place.is_multiple_of(2) { op } else { Op::Leaf };
        // The first two leaves, and the operation; then a leaf and the operation for each other one.
        (0..(2 * leaves).saturating_sub(1)).map(of_every).chain(listed.iter().copied())
    }
}

/// The bits of all leaves, of which there are at most 31.
pub(super) const fn mask(leaves: u32) -> u32 {
    1_u32.wrapping_shl(leaves).wrapping_sub(1)
}
