//! Building the bounding volume hierarchy.

use super::split::{nothing, split, united};
use super::{AXIS, Hierarchy, HierarchyError, LEVELS, MOST_OBJECTS, Node};
use crate::geometry::Bounds;
use crate::scalar::{Real, Scalar};
use crate::scalar::{Ring, slabs::MARGIN_BITS};
use crate::shape::combination;
use crate::shape::kinds::{Kind, Kinds};
use crate::shape::{Placement, Primitive, Shape, Shaped};
use crate::vector::{Vec3, pairs};

impl<'a, S: Scalar> Hierarchy<'a, S> {
    /// The hierarchy of these objects, or of these shapes, in borrowed storage of at least [`Hierarchy::nodes_for`]
    /// nodes.
    ///
    /// Divides the objects in two along the axis on which the centres of their boxes are farthest apart, at the place
    /// with the least surface area cost, and then each part again. That takes time in proportion to `n log n`. The same
    /// objects always give the same hierarchy.
    ///
    /// # Errors
    ///
    /// [`HierarchyError::Storage`] if the storage is too small; [`HierarchyError::TooManyObjects`] for more than 2^30 -
    /// 1 objects.
    pub fn build(objects: &[impl Shaped<S>], nodes: &'a mut [Node<S>]) -> Result<Self, HierarchyError> {
        if objects.len() > MOST_OBJECTS {
            return Err(HierarchyError::TooManyObjects);
        }
        let (needed, given) = (Self::nodes_for(objects.len()), nodes.len());
        let Some((nodes, _)) = nodes.split_at_mut_checked(needed) else {
            return Err(HierarchyError::Storage { needed, given });
        };
        // Objects without a box are written at the beginning and leaves at the end, where the tree overwrites none that
        // is still needed.
        let (mut unbounded, mut leaves) = (0, 0);
        for (index, object) in (0_u32..).zip(objects) {
            let leaf = Node::leaf(index, object.shape());
            let place = if leaf.objects == 0 { unbounded } else { needed - 1 - leaves };
            if let Some(node) = nodes.get_mut(place) {
                *node = leaf;
            }
            if leaf.objects == 0 { unbounded += 1 } else { leaves += 1 }
        }
        let tree = needed.saturating_sub(Self::nodes_for(leaves));
        if let Some((_, tree)) = nodes.split_at_mut_checked(tree) {
            grow(tree, leaves as u32);
        }
        let nodes: &'a [Node<S>] = nodes;
        Ok(Self { unbounded: nodes.get(..unbounded).unwrap_or(&[]), tree: nodes.get(tree..).unwrap_or(&[]) })
    }
}

/// Makes a tree of the leaves at the end of the list, in place.
///
/// A node is never written over a leaf that is still needed: before the node at a place there are fewer inner nodes
/// than leaves, so that the remaining leaves begin after it, or, if it is a leaf, with it.
fn grow<S: Scalar>(tree: &mut [Node<S>], leaves: u32) {
    let mut written = 0;
    for place in 0..tree.len() {
        let (objects, levels) = below(tree, place, leaves);
        let first = (leaves as usize).saturating_sub(1) + written;
        let Some(below) = tree.get_mut(first..first + objects as usize) else { return };
        let node = match below {
            [leaf] => {
                written += 1;
                *leaf
            }
            _ => divide(below, levels),
        };
        if let Some(slot) = tree.get_mut(place) {
            *slot = node;
        }
    }
}

/// How many objects are below the node at this place of a tree of `objects` leaves, and how many levels are allowed
/// below it.
fn below<S: Scalar>(tree: &[Node<S>], place: usize, mut objects: u32) -> (u32, u32) {
    let (mut at, mut levels) = (0, LEVELS);
    // One step down in each round, from the root.
    while at < place
        && let Some(node) = tree.get(at)
    {
        let (lower, upper) = (node.lower(), at + 2 * node.lower() as usize);
        levels -= 1;
        (at, objects) = if place < upper { (at + 1, lower) } else { (upper, objects - lower) };
    }
    (objects, levels)
}

/// Moves the leaves of the lower child before the others, and returns their parent node.
fn divide<S: Scalar>(leaves: &mut [Node<S>], levels: u32) -> Node<S> {
    let (corners, [centre, half]) = around_leaves(leaves.iter());
    let objects = leaves.len() as u32;
    let (axis, lower) = split(leaves, corners, levels);
    Node { centre, half, objects, object: lower | axis << AXIS }
}

/// The corners that contain the boxes of these leaves, and the centre and the half extents of their parent.
pub(super) fn around_leaves<'n, S: Scalar>(leaves: impl Iterator<Item = &'n Node<S>>) -> ([[S; 3]; 2], [[S; 3]; 2]) {
    let corners = leaves.fold(nothing(), |corners, leaf| united(corners, leaf.corners()));
    let [low, high] = corners;
    let (centre, half) = padded(low.into(), high.into(), None, S::Real::ZERO);
    (corners, [centre, half])
}

impl<S: Scalar> Node<S> {
    /// The lowest and the highest corner.
    pub(super) fn corners(&self) -> [[S; 3]; 2] {
        let reaches = pairs(self.centre, self.half);
        [reaches.map(|(centre, half)| centre.minus(half)), reaches.map(|(centre, half)| centre.plus(half))]
    }

    /// The box of an object; of no objects if it has none.
    pub(super) fn leaf<K: Kinds>(index: u32, shape: &Shape<S, K>) -> Self {
        match shape.combined() {
            Some((leaves, operations)) => {
                // Each leaf's box has the margin that its hits need.
                Self::within(
                    index,
                    &combination::bounds(leaves, operations, |leaf| Self::of_primitive(0, leaf).around()),
                )
            }
            None => Self::of_primitive(index, shape),
        }
    }

    /// The leaf of an object in this box.
    fn within(index: u32, bounds: &Bounds<S>) -> Self {
        if !(bounds.low.is_within_budget() && bounds.high.is_within_budget()) {
            return Self { object: index, ..Self::EMPTY };
        }
        let (centre, half) = padded(bounds.low, bounds.high, None, S::Real::ZERO);
        Self { centre, half, objects: 1, object: index }
    }

    /// The box, not smaller by rounding; an infinite one if there is none.
    fn around(&self) -> Bounds<S> {
        if self.objects == 0 {
            let infinite = Vec3::new(S::INFINITY, S::INFINITY, S::INFINITY);
            return Bounds { low: -infinite, high: infinite };
        }
        let [low, high] = self.corners();
        Bounds { low: low.map(|c| -(-c).next_up()).into(), high: high.map(S::next_up).into() }
    }

    /// The box of a primitive; of no objects if it has none.
    fn of_primitive<K: Kinds>(index: u32, shape: &Shape<S, K>) -> Self {
        let nothing = Self { object: index, ..Self::EMPTY };
        let bounds = simple_bounds(shape).unwrap_or_else(|| shape.own_bounds());
        let Some(sharpness) = sharpness(shape) else { return nothing };
        if !(bounds.low.is_within_budget() && bounds.high.is_within_budget()) {
            return nothing;
        }
        let position = match shape.own().1 {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => Some(frame.position()),
            Placement::Affine(affine) if K::SET.contains(Kind::Affine) => Some(affine.position()),
            _ => None,
        };
        // Two units of a fixed type; zero for a float.
        let units = sharpness * S::BUDGET.smallest_size.real().scaled(1);
        let (centre, half) = padded(bounds.low, bounds.high, position, units);
        Self { centre, half, objects: 1, object: index }
    }
}

/// A faster computation with the same bits, for the shapes of which large scenes consist: their bounds are sums without
/// rounding.
fn simple_bounds<S: Scalar, K: Kinds>(shape: &Shape<S, K>) -> Option<Bounds<S>> {
    match shape.own() {
        (Primitive::Triangle(triangle), Placement::World) if K::SET.contains(Kind::Triangle) => {
            Some(around(triangle.vertices()))
        }
        (Primitive::Sphere(sphere), Placement::Frame(frame))
            if !S::RELATIVE && K::SET.contains(Kind::Frame) && K::SET.contains(Kind::Sphere) =>
        {
            let (centre, radius) = (frame.position().to_array(), sphere.radius());
            let [low, high] = [centre.map(|c| c.minus(radius)), centre.map(|c| c.plus(radius))];
            Some(Bounds { low: low.into(), high: high.into() })
        }
        _ => None,
    }
}

/// The box of three points.
fn around<S: Scalar>([a, b, c]: [Vec3<S>; 3]) -> Bounds<S> {
    let corners = [a, b, c].map(|point| [point.to_array(); 2]).into_iter().fold(nothing(), united);
    let [low, high] = corners.map(Vec3::from);
    Bounds { low, high }
}

/// The factor by which the distance of a reported hit from the solid may exceed the error of `t`. At a sharp rim, where
/// two surfaces meet at a small angle, two ends that round to the same `t` may be far from the rim. `None` beyond 2^8,
/// which the margin of a box does not cover.
fn sharpness<S: Scalar, K: Kinds>(shape: &Shape<S, K>) -> Option<S::Real> {
    let one = S::Real::ONE;
    let (primitive, placement) = shape.own();
    let rim = match primitive {
        Primitive::Cone(cone) if K::SET.contains(Kind::Cone) => {
            let (top, height) = (cone.top_radius()?, cone.height()?);
            let slope = (top.real() - cone.base_radius().real()).abs() / height.real();
            if slope > one { slope } else { one }
        }
        _ => one,
    };
    let placed = match placement {
        Placement::Affine(affine) if K::SET.contains(Kind::Affine) => affine.sharpness()?,
        _ => 0,
    };
    let most = one.scaled(8);
    // Not the negated comparison: a slope beyond a float's range must fail.
    let sharpness = rim.scaled(placed.min(16));
    if sharpness <= most { Some(sharpness) } else { None }
}

/// Centre and half extents of a box, enlarged by `units` and by the fraction [`MARGIN_BITS`] of its size and, if its
/// object is placed at a position that may be far from the box, of the distance from that position.
fn padded<S: Scalar>(low: Vec3<S>, high: Vec3<S>, position: Option<Vec3<S>>, units: S::Real) -> ([S; 3], [S; 3]) {
    // Halved before they are added: the sum may be beyond the type.
    let half_of = |c: S::Real| c.scaled(-1);
    let centre = pairs(low.real(), high.real()).map(|(low, high)| S::round(half_of(low) + half_of(high)));
    let middle = centre.map(S::real);
    let larger = |a: S::Real, b: S::Real| if b > a { b } else { a };
    let to_low = pairs(middle, low.real()).map(|(centre, low)| centre - low);
    let to_high = pairs(middle, high.real()).map(|(centre, high)| high - centre);
    let half = pairs(to_low, to_high).map(|(low, high)| larger(low, high));
    let largest = |[x, y, z]: [S::Real; 3]| larger(larger(x, y), z);
    let away = position.map_or(S::Real::ZERO, |position| {
        largest(pairs(middle, position.real()).map(|(centre, position)| (centre - position).abs()))
    });
    let margin = (largest(half) + away).scaled(-MARGIN_BITS) + units;
    // The rounding to nearest may be downwards.
    (centre, half.map(|half| S::round(half + margin).next_up()))
}

#[cfg(all(units, feature = "fixed"))]
#[expect(clippy::unwrap_used, reason = "a test may panic")]
#[path = "../../tests/units/hierarchy/build.rs"]
mod tests;
