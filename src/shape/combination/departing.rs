//! A ray that departs from a combination departs from its leaves.
//!
//! A departure names the part of the surface, and on which side the ray leaves. The leaf is found from where the ray
//! starts; several may meet there, in a common face, in an edge or in a rim.

use super::{Combination, MOST_LEAVES};
use crate::hit::{Crossing, Hit};
use crate::part::Part;
use crate::ray::{Departure, Leaving, Ray};
use crate::scalar::{Real, Scalar};
use crate::shape::kinds::Primitives;
use crate::vector::Vec3;

/// A ray as the leaves see it: with a departure from each leaf that it departs from.
#[derive(Clone, Debug)]
pub(super) struct Rays<S: Scalar> {
    ray: Ray<S>,
    /// The departures, which name leaves.
    departures: heapless::Vec<Departure, MOST_LEAVES>,
}

impl<S: Scalar> Rays<S> {
    #[inline(always)]
    pub(super) const fn without_departure(ray: &Ray<S>) -> Self {
        Self { ray: ray.without_departure(), departures: heapless::Vec::new() }
    }

    /// From every leaf whose surface the ray starts on, to the side that it leads to.
    #[inline(never)]
    pub(super) fn depart<L: Primitives>(&mut self, of: &Combination<'_, S, L>, departure: Departure) {
        let (ray, mut is_known) = (self.ray, false);
        for (leaf, shape) in (0_u32..).zip(of.leaves()) {
            let Some(part) = shape.part_at(departure.part, ray.origin()) else { continue };
            let hit = Hit { t: S::ZERO, part, crossing: Crossing::Enter };
            let is_inwards = ray.direction().dot(shape.surface(&ray, &hit).normal()).is_negative();
            let leaving = if is_inwards { Leaving::Inwards } else { Leaving::Outwards };
            is_known |= part == departure.part && of.turned_around(leaf, leaving) == departure.leaving;
            // Cannot be full: there are no more leaves.
            let _ = self.departures.push(Departure { object: leaf, part, leaving });
        }
        // If no leaf agrees with what is known, the nearest one with the part does, whatever the rounded direction.
        if !is_known && let Some(leaf) = of.owner(departure.part, ray.origin()) {
            let leaving = of.turned_around(leaf, departure.leaving);
            let own = Departure { object: leaf, part: departure.part, leaving };
            match self.departures.iter_mut().find(|departure| departure.object == leaf) {
                Some(departure) => *departure = own,
                None => {
                    let _ = self.departures.push(own);
                }
            }
        }
    }

    /// The ray of this leaf.
    #[inline]
    pub(super) fn of(&self, leaf: u32) -> Ray<S> {
        match self.departures.iter().find(|departure| departure.object == leaf) {
            Some(departure) => self.ray.departing(*departure),
            None => self.ray,
        }
    }

    /// True if it departs.
    pub(super) fn departs(&self) -> bool {
        !self.departures.is_empty()
    }

    /// A leaf and a part that it departs from: to this side of the result, if it does from one.
    pub(super) fn departed<L: Primitives>(&self, of: &Combination<'_, S, L>, to: Leaving) -> Option<(u32, Part)> {
        let is_to = |departure: &&Departure| of.turned_around(departure.object, departure.leaving) == to;
        let departure = self.departures.iter().find(is_to).or(self.departures.first())?;
        Some((departure.object, departure.part))
    }
}

impl<S: Scalar, L: Primitives> Combination<'_, S, L> {
    /// The leaf that has this part at the point, or is nearest to that; of several the first.
    pub(super) fn owner(&self, part: Part, point: Vec3<S>) -> Option<u32> {
        let mut nearest: Option<(S, u32)> = None;
        for (leaf, shape) in (0_u32..).zip(self.leaves()) {
            let distance = shape.distance_to(part, point);
            if distance.is_finite() && nearest.is_none_or(|(least, _)| distance < least) {
                nearest = Some((distance, leaf));
            }
        }
        nearest.map(|(_, leaf)| leaf)
    }

    /// Out of the result is into a leaf that is subtracted, and the reverse.
    fn turned_around(&self, leaf: u32, leaving: Leaving) -> Leaving {
        match (self.is_subtracted(leaf), leaving) {
            (true, Leaving::Inwards) => Leaving::Outwards,
            (true, Leaving::Outwards) => Leaving::Inwards,
            (false, leaving) => leaving,
        }
    }
}
