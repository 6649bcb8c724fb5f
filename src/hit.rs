//! Hits and hit lists.

use crate::part::Part;
use crate::ray::Range;
use crate::scalar::Scalar;
use core::ops::Deref;

/// The most crossings that a line can have with any primitive: two intervals of a double cone.
pub const MOST_HITS: usize = 4;

/// How a ray crosses a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Crossing {
    /// From the outside: into a solid, or through an open surface from its front.
    Enter,
    /// From the inside: out of a solid, or through an open surface from its back.
    Exit,
    /// The line touches the surface in one point and stays on its side.
    Touch,
}

/// A hit: where a ray meets a surface. [`Shape::surface`](crate::Shape::surface) computes point, normal and surface
/// coordinates from it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
pub struct Hit<S> {
    /// Distance along the ray.
    #[cfg_attr(feature = "serde", serde(with = "crate::scalar::written"))]
    pub t: S,
    /// The part of the surface.
    pub part: Part,
    /// How the ray crosses the surface.
    pub crossing: Crossing,
}

/// All hits of a ray with a primitive, sorted by `t`; a slice of [`Hit`].
///
/// The list has a fixed capacity of [`MOST_HITS`], so that no hit is ever dropped.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(bound = "S: Scalar"))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hits<S> {
    list: heapless::Vec<Hit<S>, MOST_HITS>,
    starts_inside: bool,
    coincident: Option<Range<S>>,
}

impl<S: Scalar> Hits<S> {
    /// A miss.
    pub(crate) const fn none() -> Self {
        Self { list: heapless::Vec::new(), starts_inside: false, coincident: None }
    }

    /// A line that lies in the surface over `overlap`.
    pub(crate) const fn lying_in(overlap: Range<S>) -> Self {
        Self { list: heapless::Vec::new(), starts_inside: false, coincident: Some(overlap) }
    }

    /// Adds a hit after all others.
    #[inline]
    pub(crate) fn push(&mut self, hit: Hit<S>) {
        // Cannot be full: no primitive has more ends than the capacity.
        let pushed = self.list.push(hit);
        debug_assert!(pushed.is_ok());
    }

    /// Notes that the start of the range lies inside.
    #[inline]
    pub(crate) const fn start_inside(&mut self) {
        self.starts_inside = true;
    }

    /// True if the ray's range starts inside the solid, or on its surface where the ray leaves the solid. The first hit
    /// is then an exit without an enter. False if the range starts where the ray enters or touches the solid, and
    /// always false for open surfaces.
    #[inline]
    pub const fn starts_inside(&self) -> bool {
        self.starts_inside
    }

    /// The interval of `t` over which the ray lies in an open or infinite surface, such as a ray in a plane. There are
    /// then no hits.
    #[inline]
    pub const fn coincident(&self) -> Option<Range<S>> {
        self.coincident
    }

    /// Keeps the hits for which `keep` holds.
    pub(crate) fn retain(&mut self, keep: impl FnMut(&Hit<S>) -> bool) {
        self.list.retain(keep);
    }
}

impl<S> Deref for Hits<S> {
    type Target = [Hit<S>];
    #[inline]
    fn deref(&self) -> &[Hit<S>] {
        &self.list
    }
}

impl<S: Copy> IntoIterator for Hits<S> {
    type Item = Hit<S>;
    type IntoIter = IntoIter<S>;
    fn into_iter(self) -> IntoIter<S> {
        IntoIter { list: self.list, next: 0 }
    }
}

/// Iterator over the hits of a list, by value. (The iterator of `heapless` is not used because its `drop` can panic.)
#[derive(Clone, Debug)]
pub struct IntoIter<S> {
    list: heapless::Vec<Hit<S>, MOST_HITS>,
    next: usize,
}

impl<S: Copy> Iterator for IntoIter<S> {
    type Item = Hit<S>;

    fn next(&mut self) -> Option<Hit<S>> {
        let hit = self.list.get(self.next).copied()?;
        self.next += 1;
        Some(hit)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.list.len() - self.next;
        (left, Some(left))
    }
}

impl<S: Copy> ExactSizeIterator for IntoIter<S> {}

impl<S: Copy> core::iter::FusedIterator for IntoIter<S> {}

impl<'a, S> IntoIterator for &'a Hits<S> {
    type Item = &'a Hit<S>;
    type IntoIter = core::slice::Iter<'a, Hit<S>>;
    fn into_iter(self) -> Self::IntoIter {
        self.list.iter()
    }
}
