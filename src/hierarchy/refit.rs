//! New boxes around a shape that has moved, in a tree whose division stays.

use super::Node;
use super::build::around_leaves;
use crate::scalar::Scalar;

/// Writes the new leaf of an object, and the boxes of the nodes above it. False if the tree has no leaf of this object,
/// or the new leaf has no box: then the tree is to be built anew.
pub(super) fn refit<S: Scalar>(tree: &mut [Node<S>], leaf: Node<S>) -> bool {
    let is_own = |node: &Node<S>| node.objects == 1 && node.object == leaf.object;
    let Some(place) = tree.iter().position(is_own).filter(|_| leaf.objects == 1) else { return false };
    if let Some(node) = tree.get_mut(place) {
        *node = leaf;
    }
    let mut at = 0;
    // From the root down to the leaf.
    while at < place
        && let Some((node, below)) = tree.get_mut(at..).and_then(<[_]>::split_first_mut)
    {
        let descendants = below.get(..2 * (node.objects as usize - 1)).unwrap_or(below);
        let (_, [centre, half]) = around_leaves(descendants.iter().filter(|node| node.objects == 1));
        *node = Node { centre, half, ..*node };
        let upper = at + 2 * node.lower() as usize;
        at = if place < upper { at + 1 } else { upper };
    }
    true
}
