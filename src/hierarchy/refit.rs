//! New boxes around shapes that have moved, in a tree whose division stays.

use super::Node;
use super::build::around_leaves;
use crate::scalar::Scalar;
use crate::shape::Shaped;

/// Writes the boxes of the objects as they are now. False if an object has a box and was without one, or the other way
/// round: then the tree is to be built anew, and is not to be used before.
pub(super) fn refit<S: Scalar>(objects: &[impl Shaped<S>], unbounded: &[Node<S>], tree: &mut [Node<S>]) -> bool {
    let leaf = |index: u32| Some(Node::leaf(index, objects.get(index as usize)?.shape()));
    if !unbounded.iter().all(|node| leaf(node.object) == Some(*node)) {
        return false;
    }
    for node in tree.iter_mut().filter(|node| node.objects == 1) {
        match leaf(node.object) {
            Some(new) if new.objects == 1 => *node = new,
            _ => return false,
        }
    }
    for place in 0..tree.len() {
        let Some((node, below)) = tree.get_mut(place..).and_then(<[_]>::split_first_mut) else { return true };
        if node.objects > 1 {
            let descendants = below.get(..2 * (node.objects as usize - 1)).unwrap_or(below);
            let leaves = descendants.iter().filter(|node| node.objects == 1);
            let (_, [centre, half]) = around_leaves(leaves);
            *node = Node { centre, half, ..*node };
        }
    }
    true
}
