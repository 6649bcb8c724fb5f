//! What is known of a ray's start among solids, beside its coordinates.

use super::SolidSet;
use crate::hit::Crossing;
use crate::ray::{Departure, Leaving, Ray};
use crate::scalar::Scalar;
use crate::shape::kinds::Kinds;
use crate::shape::order::{Entry, Located};
use crate::shape::{Shape, Shaped, known};
use crate::tier::Tier;
use core::fmt;

/// The most surfaces that a ray can depart from at once.
pub(super) const MOST_DEPARTURES: usize = 8;

/// What is known of a ray's start among many solids, beside its coordinates: the solids that it is inside of, and the
/// surfaces that it departs from.
///
/// A new ray knows nothing ([`Start::new`]); its coordinates decide. A ray that continues from a crossing takes the
/// start that the crossing gives: see [`Crossings::start_across`](super::Crossings::start_across) and
/// [`Crossings::start_before`](super::Crossings::start_before). Its rounded coordinates then decide neither of what it
/// is inside nor of what it departs from.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Start<const W: usize = 1> {
    /// The solids that it is inside of; `None` if the coordinates decide.
    inside: Option<SolidSet<W>>,
    departures: heapless::Vec<Departure, MOST_DEPARTURES>,
    left_out: SolidSet<W>,
    arrival: Option<Departure>,
}

impl<const W: usize> Start<W> {
    /// Nothing is known.
    pub const fn new() -> Self {
        Self { inside: None, departures: heapless::Vec::new(), left_out: SolidSet::EMPTY, arrival: None }
    }

    /// Inside of these solids and no others, whatever the coordinates.
    pub const fn inside_of(solids: SolidSet<W>) -> Self {
        Self { inside: Some(solids), departures: heapless::Vec::new(), left_out: SolidSet::EMPTY, arrival: None }
    }

    /// The same start, departing from one more surface. A ray that departs from a solid inwards is inside of it, and
    /// one that departs outwards is not, whatever set was given.
    ///
    /// # Errors
    ///
    /// [`StartError::TooManyDepartures`] if it departs from eight already.
    pub fn departing(mut self, departure: Departure) -> Result<Self, StartError> {
        match self.departures.push(departure) {
            Ok(()) => Ok(self),
            Err(_) => Err(StartError::TooManyDepartures),
        }
    }

    /// The same start for a ray that does not see these solids, neither at its start nor later.
    #[must_use]
    pub fn leaving_out(self, solids: SolidSet<W>) -> Self {
        Self { left_out: solids, ..self }
    }

    /// The same start of a segment that ends at a surface: the crossing there does not [occlude](super::occludes) it.
    /// The surface is given as the departure of the reversed segment; so [`Leaving::Outwards`] is one that is reached
    /// from outside.
    #[must_use]
    pub fn arriving(self, at: Departure) -> Self {
        Self { arrival: Some(at), ..self }
    }

    /// The solids that the ray is inside of; `None` if its coordinates decide.
    pub const fn inside(&self) -> Option<SolidSet<W>> {
        self.inside
    }

    /// The solids that it is known to be inside of, without those that it does not see.
    pub(super) fn inside_seen(&self) -> SolidSet<W> {
        let inside = self.inside.unwrap_or(SolidSet::EMPTY);
        self.left_out.iter().fold(inside, SolidSet::without)
    }

    /// The surfaces that it departs from.
    pub fn departures(&self) -> &[Departure] {
        &self.departures
    }

    /// How it departs from this solid.
    pub(super) fn departure_from(&mut self, solid: u32) -> Option<&mut Departure> {
        self.departures.iter_mut().find(|departure| departure.object == solid)
    }

    /// True if the solid is not seen.
    pub(super) fn leaves_out(&self, solid: u32) -> bool {
        self.left_out.contains(solid)
    }

    /// How the ray crosses the solid at its end, if it arrives at it.
    pub(super) fn arrives_at(&self, solid: u32) -> Option<Crossing> {
        let arrival = self.arrival.filter(|arrival| arrival.object == solid)?;
        Some(if arrival.leaving == Leaving::Outwards { Crossing::Enter } else { Crossing::Exit })
    }

    /// True if the result for this solid does not follow from the coordinates alone.
    pub(super) fn knows(&self, solid: u32) -> bool {
        self.inside.is_some_and(|inside| inside.contains(solid))
            || self.departures.iter().any(|departure| departure.object == solid)
    }

    /// The ray for this solid: with a departure if it departs from it.
    pub(super) fn ray_for<S: Scalar>(&self, ray: &Ray<S>, solid: u32) -> Ray<S> {
        if let Some(departure) = self.departures.iter().find(|departure| departure.object == solid) {
            return ray.departing(*departure);
        }
        match ray.departure() {
            Some(departure) if departure.object == solid => *ray,
            _ => ray.without_departure(),
        }
    }

    /// Finds the solid of a crossing in its list, and the ray that it was tested with.
    pub(super) fn located<'a, S: Scalar, T, X: Shaped<S>>(
        &self,
        shapes: &'a [X],
        ray: &Ray<S>,
    ) -> impl Fn(&Entry<S>) -> Option<Located<'a, S, X::Kinds, T>> {
        |entry| {
            let shape = shapes.get(entry.solid as usize)?.shape();
            Some(Located::new(self.ray_for(ray, entry.solid), shape, entry))
        }
    }

    /// The crossings of one solid by its ray. They alternate, beginning with an exit if the ray is inside. Also whether
    /// the first of them was moved to the start.
    pub(super) fn crossings_of<S: Scalar, T: Tier<S>, K: Kinds>(
        &self,
        ray: &Ray<S>,
        solid: u32,
        shape: &Shape<S, K>,
    ) -> (K::Hits<S>, bool) {
        let is_inside = self.inside.map(|inside| inside.contains(solid));
        known::crossings::<S, T, K>(ray, shape, is_inside)
    }
}

impl<const W: usize> Default for Start<W> {
    fn default() -> Self {
        Self::new()
    }
}

/// Why a start cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum StartError {
    /// The ray departs from more surfaces than a start can hold.
    TooManyDepartures,
}

impl fmt::Display for StartError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooManyDepartures => {
                write!(f, "a ray departs from at most {MOST_DEPARTURES} surfaces at once")
            }
        }
    }
}

impl core::error::Error for StartError {}
