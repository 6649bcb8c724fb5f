//! Hits and hit lists.

use crate::part::Part;
use crate::ray::Range;
use crate::scalar::Scalar;
use core::fmt::{self, Debug};
use core::ops::Deref;

/// The most crossings that a line can have with any primitive: two intervals of a double cone, of a tube, of a torus,
/// or of a solid with a waist.
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

/// The first method of a tier does not decide a ray: see [`Shape::try_nearest_at`](crate::Shape::try_nearest_at).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Undecided;

impl fmt::Display for Undecided {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the first numbers of this tier do not decide the ray: call the query that tries them all")
    }
}

impl core::error::Error for Undecided {}

/// All hits of a ray with a shape, sorted by `t`; a slice of [`Hit`].
///
/// The list has a fixed capacity, so that no hit is ever dropped: [`MOST_HITS`] of a primitive, and of a
/// [`Combination`](crate::Combination) [`MOST_CROSSINGS`](crate::shape::combination::MOST_CROSSINGS).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(bound = "S: Scalar"))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hits<S, const N: usize = MOST_HITS> {
    list: heapless::Vec<Hit<S>, N>,
    starts_inside: bool,
    coincident: Option<Range<S>>,
}

impl<S: Scalar, const N: usize> Hits<S, N> {
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
        // Cannot be full: no shape has more ends than the capacity of its list.
        let pushed = self.list.push(hit);
        debug_assert!(pushed.is_ok());
    }

    /// Becomes another list, which has no more hits than there is room for.
    pub(crate) fn take(&mut self, other: &Hits<S>) {
        other.list.iter().for_each(|hit| self.push(*hit));
        (self.starts_inside, self.coincident) = (other.starts_inside, other.coincident);
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

impl<S, const N: usize> Deref for Hits<S, N> {
    type Target = [Hit<S>];
    #[inline]
    fn deref(&self) -> &[Hit<S>] {
        &self.list
    }
}

impl<S: Copy, const N: usize> IntoIterator for Hits<S, N> {
    type Item = Hit<S>;
    type IntoIter = IntoIter<S, N>;
    fn into_iter(self) -> IntoIter<S, N> {
        IntoIter { list: self.list, next: 0 }
    }
}

/// Iterator over the hits of a list, by value. (The iterator of `heapless` is not used because its `drop` can panic.)
#[derive(Clone, Debug)]
pub struct IntoIter<S, const N: usize = MOST_HITS> {
    list: heapless::Vec<Hit<S>, N>,
    next: usize,
}

impl<S: Copy, const N: usize> Iterator for IntoIter<S, N> {
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

impl<S: Copy, const N: usize> ExactSizeIterator for IntoIter<S, N> {}

impl<S: Copy, const N: usize> core::iter::FusedIterator for IntoIter<S, N> {}

impl<'a, S, const N: usize> IntoIterator for &'a Hits<S, N> {
    type Item = &'a Hit<S>;
    type IntoIter = core::slice::Iter<'a, Hit<S>>;
    fn into_iter(self) -> Self::IntoIter {
        self.list.iter()
    }
}

mod sealed {
    pub trait Sealed {}
}

/// A list of all hits, whatever its capacity: [`Hits`]. Sealed.
pub trait HitList<S: Scalar>: Deref<Target = [Hit<S>]> + Clone + Debug + PartialEq + sealed::Sealed {
    /// A miss.
    #[doc(hidden)]
    fn none() -> Self;
    /// Adds a hit after all others.
    #[doc(hidden)]
    fn push(&mut self, hit: Hit<S>);
    /// Notes that the start of the range lies inside.
    #[doc(hidden)]
    fn start_inside(&mut self);
    /// Keeps the hits for which `keep` holds.
    #[doc(hidden)]
    fn retain(&mut self, keep: impl FnMut(&Hit<S>) -> bool);
    /// As [`Hits::starts_inside`].
    fn starts_inside(&self) -> bool;
    /// As [`Hits::coincident`].
    fn coincident(&self) -> Option<Range<S>>;
}

impl<S, const N: usize> sealed::Sealed for Hits<S, N> {}

impl<S: Scalar, const N: usize> HitList<S> for Hits<S, N> {
    #[inline(always)]
    fn none() -> Self {
        Self::none()
    }
    #[inline(always)]
    fn push(&mut self, hit: Hit<S>) {
        self.push(hit);
    }
    #[inline(always)]
    fn start_inside(&mut self) {
        self.start_inside();
    }
    #[inline(always)]
    fn retain(&mut self, keep: impl FnMut(&Hit<S>) -> bool) {
        self.retain(keep);
    }
    #[inline(always)]
    fn starts_inside(&self) -> bool {
        self.starts_inside()
    }
    #[inline(always)]
    fn coincident(&self) -> Option<Range<S>> {
        self.coincident()
    }
}
