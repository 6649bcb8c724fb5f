//! Where a node is divided: by the surface area heuristic.
//!
//! The probability that a ray that hits a box also hits a box within it is about the ratio of their surface areas
//! (Goldsmith and Salmon, *Automatic creation of object hierarchies for ray tracing*, 1987). The cost of a division is
//! therefore the surface area of each part times its number of objects. Only divisions between [`BINS`] slices of equal
//! width are considered (Wald, *On fast construction of SAH-based bounding volume hierarchies*, 2007).

use super::Node;
use crate::scalar::{Real, Ring, Scalar};
use crate::vector::pairs;
use core::mem;

/// Slices along the axis; a power of two.
const BINS: usize = 16;

/// So few objects are divided into halves.
const FEW: usize = 3;

/// The lowest and the highest corner of a box.
type Corners<S> = [[S; 3]; 2];

/// The coordinate of a leaf's centre along an axis.
fn along<S: Scalar>(leaf: &Node<S>, axis: usize) -> S {
    leaf.centre[axis % 3]
}

/// Moves the leaves of the lower part before the others, such that at most `levels` levels are needed below. Returns
/// the axis of the division and the number of leaves in the lower part.
pub(super) fn split<S: Scalar>(leaves: &mut [Node<S>], corners: Corners<S>, levels: u32) -> (u32, u32) {
    if leaves.len() > FEW
        && let Some((axis, start)) = cheapest(leaves, corners)
    {
        let lower = partition(leaves, |leaf| along(leaf, axis) < start);
        if has_levels(lower.max(leaves.len() - lower), levels) {
            return (axis as u32, lower as u32);
        }
    }
    let [low, high] = middles(leaves);
    let [x, y, z] = pairs(low, high).map(|(low, high)| high.minus(low));
    let axis = if x >= y && x >= z {
        0
    } else if y >= z {
        1
    } else {
        2
    };
    let half = leaves.len() / 2;
    // Leaves with the same centre are ordered by index.
    select(leaves, half, |a, b| {
        let (at_a, at_b) = (along(a, axis), along(b, axis));
        at_a < at_b || (at_a == at_b && a.object < b.object)
    });
    (axis as u32, half as u32)
}

/// True if repeated halving reaches single objects within one level less than these.
fn has_levels(objects: usize, levels: u32) -> bool {
    usize::BITS - objects.saturating_sub(1).leading_zeros() < levels
}

/// The box of the leaves' middles.
fn middles<S: Scalar>(leaves: &[Node<S>]) -> Corners<S> {
    leaves.iter().fold(nothing(), |middles, leaf| united(middles, [leaf.centre; 2]))
}

/// The axis to divide along, and the coordinate from which on centres belong to the upper part. `None` if all centres
/// coincide.
fn cheapest<S: Scalar>(leaves: &[Node<S>], corners: Corners<S>) -> Option<(usize, S)> {
    let size = size_of(corners);
    if size.is_zero() {
        return None;
    }
    let [low, high] = middles(leaves);
    let mut best: Option<(S::Real, usize, S)> = None;
    for (axis, (low, high)) in pairs(low, high).into_iter().enumerate() {
        let starts = starts(low, high);
        let bins = in_bins(leaves, axis, &starts);
        // The cost of the upper part if it begins with a slice, computed from the last slice backwards.
        let (mut corners, mut count, mut costs) = (nothing(), 0, [S::Real::ZERO; BINS]);
        let mut last = S::Real::ZERO;
        for ((bin, more), cost) in bins.iter().zip(&mut costs).rev() {
            // If there are few objects, most slices are empty.
            if *more > 0 {
                (corners, count) = (united(corners, *bin), count + more);
                last = cost_of(corners, count, size);
            }
            *cost = last;
        }
        let (mut corners, mut count) = (nothing(), 0);
        for (((bin, more), upper), start) in bins.iter().zip(costs).zip(starts) {
            if count > 0 && *more > 0 {
                let cost = upper + cost_of(corners, count, size);
                if best.is_none_or(|(least, _, _)| cost < least) {
                    best = Some((cost, axis, start));
                }
            }
            (corners, count) = (united(corners, *bin), count + more);
        }
    }
    best.map(|(_, axis, start)| (axis, start))
}

/// Where each slice begins.
fn starts<S: Scalar>(low: S, high: S) -> [S; BINS] {
    let (mut starts, extent) = ([low; BINS], high.minus(low).real());
    for (index, start) in (0..).zip(&mut starts) {
        *start = S::round(low.real() + (extent * S::Real::from_int(index)).scaled(-(BINS.ilog2() as i32)));
    }
    starts
}

/// The box and the number of the leaves whose middles lie in each slice.
fn in_bins<S: Scalar>(leaves: &[Node<S>], axis: usize, starts: &[S; BINS]) -> [(Corners<S>, u32); BINS] {
    let mut bins = [(nothing(), 0); BINS];
    for leaf in leaves {
        let (at, mut bin, mut step) = (along(leaf, axis), 0, BINS / 2);
        while step > 0 {
            if starts.get(bin + step).is_some_and(|start| at >= *start) {
                bin += step;
            }
            step /= 2;
        }
        if let Some((corners, count)) = bins.get_mut(bin) {
            *corners = united(*corners, leaf.corners());
            *count += 1;
        }
    }
    bins
}

/// The longest edge of a box.
fn size_of<S: Scalar>([low, high]: Corners<S>) -> S::Real {
    let [x, y, z] = pairs(low, high).map(|(low, high)| high.minus(low).real());
    let larger = |a: S::Real, b: S::Real| if b > a { b } else { a };
    larger(larger(x, y), z)
}

/// The surface of the box of some objects, in units of a length, times their number.
fn cost_of<S: Scalar>([low, high]: Corners<S>, objects: u32, unit: S::Real) -> S::Real {
    if objects == 0 {
        return S::Real::ZERO;
    }
    // In units of the longest edge of all objects no product is beyond the type.
    let [x, y, z] = pairs(low, high).map(|(low, high)| high.minus(low).real() / unit);
    (x * y + y * z + z * x) * S::Real::from_int(objects as i32)
}

/// The box of nothing: united with a box it is that box.
pub(super) fn nothing<S: Scalar>() -> Corners<S> {
    let infinite = [S::INFINITY; 3];
    [infinite, infinite.map(|c| -c)]
}

/// The box of two boxes.
pub(super) fn united<S: Scalar>([low, high]: Corners<S>, [other_low, other_high]: Corners<S>) -> Corners<S> {
    [
        pairs(low, other_low).map(|(a, b)| if b < a { b } else { a }),
        pairs(high, other_high).map(|(a, b)| if b > a { b } else { a }),
    ]
}

/// Moves the items of the first kind before the others, and returns their number.
fn partition<T>(items: &mut [T], is_first: impl Fn(&T) -> bool) -> usize {
    let mut first = 0;
    for index in 0..items.len() {
        if items.get(index).is_some_and(&is_first) {
            // Fails if both are the same item, which stays in place.
            if let Ok([a, b]) = items.get_disjoint_mut([first, index]) {
                mem::swap(a, b);
            }
            first += 1;
        }
    }
    first
}

/// Moves the items that come before the one of rank `rank` before it, and the others after it (Hoare, *Algorithm 65:
/// find*, 1961). No two may be equal.
fn select<T: Copy>(items: &mut [T], rank: usize, is_before: impl Fn(&T, &T) -> bool) {
    let (mut first, mut end) = (0, items.len());
    while first + 1 < end {
        let Some(pivot) = items.get(rank).copied() else { return };
        let (mut i, mut j) = (first, end);
        // No item before i comes after the pivot, and no item from j on comes before it.
        while i < j {
            while items.get(i).is_some_and(|item| is_before(item, &pivot)) {
                i += 1;
            }
            while j > i && items.get(j - 1).is_some_and(|item| is_before(&pivot, item)) {
                j -= 1;
            }
            if i < j {
                if let Ok([a, b]) = items.get_disjoint_mut([i, j - 1]) {
                    mem::swap(a, b);
                }
                i += 1;
                j -= 1;
            }
        }
        if j <= rank {
            first = i;
        }
        if rank < i {
            end = j;
        }
    }
}
