//! A way through the tree that needs no stack.

/// Where a walk is, and how it came there: a bit for each level, the lowest bit for the lowest.
///
/// A node with n objects stands before the `2 (n / 2) - 1` nodes of its first part, and these before those of the second. So
/// the way back follows from on which side a node is, and from whether its parent's n was odd.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    position: usize,
    depth: u32,
    is_second: u32,
    was_odd: u32,
    /// The other part has yet to be visited.
    is_pending: u32,
}

impl Path {
    pub(super) const fn root() -> Self {
        Self { position: 0, depth: 0, is_second: 0, was_odd: 0, is_pending: 0 }
    }

    /// The node's place in the tree's list.
    #[inline(always)]
    pub(super) const fn position(&self) -> usize {
        self.position
    }

    /// From a node with this many objects, at least two, to one of its parts, from which the walk will go on to the other.
    #[inline(always)]
    pub(super) const fn descend(&mut self, objects: u32, to_second: bool) {
        self.depth += 1;
        self.is_second = self.is_second << 1 | to_second as u32;
        self.was_odd = self.was_odd << 1 | (objects & 1);
        self.is_pending = self.is_pending << 1 | 1;
        self.position += if to_second { (objects & !1) as usize } else { 1 };
    }

    /// From a node with this many objects, or past it, to the next that has yet to be visited; false if there is none.
    #[inline(always)]
    pub(super) const fn advance(&mut self, mut objects: u32) -> bool {
        while self.depth > 0 {
            let (is_second, was_odd) = (self.is_second & 1 != 0, self.was_odd & 1);
            // The first part has the smaller half.
            let all = if is_second { 2 * objects - was_odd } else { 2 * objects + was_odd };
            let to_second = (all & !1) as usize;
            if self.is_pending & 1 != 0 {
                self.is_pending ^= 1;
                self.is_second ^= 1;
                self.position = if is_second { self.position + 1 - to_second } else { self.position + to_second - 1 };
                return true;
            }
            self.position -= if is_second { to_second } else { 1 };
            self.depth -= 1;
            self.is_second >>= 1;
            self.was_odd >>= 1;
            self.is_pending >>= 1;
            objects = all;
        }
        false
    }
}
