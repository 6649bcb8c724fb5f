//! The outline of a prism: a convex polygon in the plane `y = 0`, in the numbers that it was built from.

use crate::part::Part;
use crate::scalar::{Scalar, largest};

/// A convex polygon: its corners, each as x and z, counter-clockwise as seen from +y.
///
/// It borrows the corners, so that a shape, which may be any primitive, does not become larger by sixteen of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon<S: 'static> {
    corners: &'static [[S; 2]],
    /// The corners are to be multiplied by `2^exponent`; zero but in the polygon of [`Polygon::scaled`].
    exponent: i32,
}

impl<S> Polygon<S> {
    /// The polygon with these corners, which are those of a convex polygon.
    pub(crate) const fn new(corners: &'static [[S; 2]]) -> Self {
        Self { corners, exponent: 0 }
    }

    /// The corners as they are stored.
    pub(crate) const fn stored(&self) -> &'static [[S; 2]] {
        self.corners
    }
}

impl<S: Scalar> Polygon<S> {
    /// The polygon with all lengths multiplied by `2^e`.
    pub(crate) const fn scaled(self, e: i32) -> Self {
        Self { exponent: self.exponent + e, ..self }
    }

    /// The corners.
    #[inline]
    pub(crate) fn corners(self) -> impl DoubleEndedIterator<Item = [S; 2]> + Clone {
        self.corners.iter().map(move |corner| self.at_scale(*corner))
    }

    /// The facets in order, each with the two corners of its edge.
    #[inline]
    pub(crate) fn edges(self) -> impl Iterator<Item = (Part, [[S; 2]; 2])> + Clone {
        let next = self.corners.iter().skip(1).chain(self.corners.first());
        Part::facets()
            .zip(self.corners.iter().zip(next))
            .map(move |(part, (from, to))| (part, [self.at_scale(*from), self.at_scale(*to)]))
    }

    /// The edge of a facet; `None` if there is no such facet.
    pub(crate) fn edge(self, part: Part) -> Option<[[S; 2]; 2]> {
        let number = part.facet_number()?;
        let from = self.corners.get(number)?;
        let to = self.corners.get(number + 1).or_else(|| self.corners.first())?;
        Some([self.at_scale(*from), self.at_scale(*to)])
    }

    /// The lowest and the highest x and z.
    pub(crate) fn extents(self) -> [[S; 2]; 2] {
        let mut extents = [[S::INFINITY, -S::INFINITY]; 2];
        for corner in self.corners() {
            for ([low, high], c) in extents.iter_mut().zip(corner) {
                *low = if c < *low { c } else { *low };
                *high = if c > *high { c } else { *high };
            }
        }
        extents
    }

    /// The largest magnitude of a coordinate.
    pub(crate) fn largest(self) -> S {
        self.corners().fold(S::ZERO, |most, [x, z]| largest([most, x, z]))
    }

    #[inline(always)]
    fn at_scale(self, corner: [S; 2]) -> [S; 2] {
        if self.exponent == 0 { corner } else { corner.map(|c| c.scaled(self.exponent)) }
    }
}
