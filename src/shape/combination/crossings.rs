//! Where a combination begins and ends along a ray: the crossings of its leaves in order, and the predicate before and
//! after each place.

use super::departing::Rays;
use super::{Combination, LeafHit, MOST_CROSSINGS};
use crate::hit::{Crossing, Hit, HitList, Hits};
use crate::ray::{Leaving, Range, Ray};
use crate::scalar::{Scalar, largest};
use crate::shape::kinds::Primitives;
use crate::shape::known::{is_behind, stays};
use crate::shape::order::{self, Entry, Located, Ordered};
use crate::shape::{Leaf, OnLeaf, Shape, Visible};
use crate::tier::Tier;
use crate::vector::Vec3;
use core::marker::PhantomData;

/// The hits of a combination, in order, with their leaves.
#[derive(Clone, Debug)]
pub(super) struct Changes<'c, S: Scalar, L: Primitives, T> {
    of: &'c Combination<'c, S, L>,
    rays: Rays<S>,
    list: Ordered<S, MOST_CROSSINGS>,
    /// The index of the next crossing, and the leaves that the ray is inside of before it: a bit for each.
    next: usize,
    inside: u32,
    /// Whether that is inside of the result.
    is_in: bool,
    starts_inside: bool,
    /// A hit that was moved to the start of the range, before all others.
    at_start: Option<LeafHit<S>>,
    tier: PhantomData<T>,
}

impl<S: Scalar, L: Primitives> Combination<'_, S, L> {
    /// The hits of a ray.
    pub(super) fn changes<T: Tier<S>>(&self, ray: &Ray<S>) -> Changes<'_, S, L, T> {
        let mut changes = Changes::new(self, ray);
        changes.list(ray);
        changes
    }

    /// All hits as a list.
    pub(crate) fn all_hits<T: Tier<S>>(&self, ray: &Ray<S>, hits: &mut Hits<S, MOST_CROSSINGS>) {
        let mut changes = Changes::<S, L, T>::new(self, ray);
        changes.list(ray);
        if changes.starts_inside {
            hits.start_inside();
        }
        for on in &mut changes {
            hits.push(on.hit);
        }
    }

    /// The first hit that is seen from these sides.
    pub(crate) fn nearest_seen<T: Tier<S>>(&self, ray: &Ray<S>, visible: Visible) -> Option<Hit<S>> {
        let mut changes = Changes::<S, L, T>::new(self, ray);
        changes.list(ray);
        loop {
            let hit = changes.next()?.hit;
            if visible.sees(hit.crossing) {
                return Some(hit);
            }
        }
    }

    /// True if the point lies in the leaves of the result.
    pub(crate) fn holds_at<T: Tier<S>>(&self, point: Vec3<S>) -> bool {
        let bits = self.with_bits().filter(|(_, shape)| shape.contains_at::<T>(point));
        self.holds(bits.fold(0, |inside, (bit, _)| inside | bit))
    }

    /// A hit of this ray as one of its leaf. If the hits of the tier `T` are others, of the leaf with the nearest such
    /// crossing; if it has none, of the leaf that is nearest.
    pub(crate) fn on_leaf<T: Tier<S>>(&self, ray: &Ray<S>, hit: &Hit<S>) -> Option<OnLeaf<'_, S, L, Option<Leaf>>> {
        let mut changes = self.changes::<T>(ray);
        let exactly = changes.find(|on| on.hit == *hit).map(|on| on.leaf);
        let point = ray.at(hit.t);
        let index = exactly.or_else(|| changes.like(hit, point)).or_else(|| self.owner(hit.part, point))?;
        let (is_turned, crossing) = (self.is_subtracted(index), self.turned_crossing(index, hit.crossing));
        let (ray, hit) = (changes.rays.of(index), Hit { crossing, ..*hit });
        Some(OnLeaf { shape: self.leaves().get(index as usize)?, ray, hit, leaf: Some(Leaf { index, is_turned }) })
    }

    /// A crossing of the result as one of the leaf, or the reverse.
    fn turned_crossing(&self, leaf: u32, crossing: Crossing) -> Crossing {
        match crossing {
            Crossing::Enter if self.is_subtracted(leaf) => Crossing::Exit,
            Crossing::Exit if self.is_subtracted(leaf) => Crossing::Enter,
            crossing => crossing,
        }
    }
}

/// True if the point at `t` may be the ray's start, as far as leaves are found to be there: within eight units of its
/// largest coordinate.
fn is_next<S: Scalar>(ray: &Ray<S>, t: S) -> bool {
    let reach = largest(ray.origin().to_array());
    reach.plus(t.magnitude().scaled(-4)) == reach
}

/// Finds the leaf of a crossing, and the ray that it was tested with.
fn located<'c, S: Scalar, L: Primitives, T>(
    leaves: &'c [Shape<S, L>],
    rays: &'c Rays<S>,
) -> impl Fn(&Entry<S>) -> Option<Located<'c, S, L, T>> {
    |entry| Some(Located::new(rays.of(entry.solid), leaves.get(entry.solid as usize)?, entry))
}

impl<'c, S: Scalar, L: Primitives, T: Tier<S>> Changes<'c, S, L, T> {
    /// No hits yet. It is large, and filled where it stands: a copy of it takes 900 instructions on an M0+.
    #[inline(always)]
    fn new(of: &'c Combination<'_, S, L>, ray: &Ray<S>) -> Self {
        Self {
            of,
            rays: Rays::without_departure(ray),
            list: Ordered::new(),
            next: 0,
            inside: 0,
            is_in: false,
            starts_inside: false,
            at_start: None,
            tier: PhantomData,
        }
    }

    /// Lists the crossings of this ray, which may depart from leaves.
    fn list(&mut self, ray: &Ray<S>) {
        let departure = ray.departure();
        if let Some(departure) = departure {
            self.rays.depart(self.of, departure);
        }
        self.begin();
        // Of a range that does not begin where the ray departs, nothing is known.
        if let Some(departure) = departure
            && ray.range().start() == S::ZERO
            && (departure.leaving == Leaving::Inwards) != self.starts_inside
        {
            self.correct(ray);
        }
    }

    /// Lists the crossings of the leaves, as their rays have them.
    fn begin(&mut self) {
        self.inside = self.list_crossings();
        self.is_in = self.of.holds(self.inside);
        self.starts_inside = self.is_in;
    }

    /// Lists the crossings of all leaves in order, and returns the leaves that the ray starts inside of. Nothing, as
    /// soon as it is known that the ray does not meet the result.
    fn list_crossings(&mut self) -> u32 {
        let Self { of, rays, list, .. } = self;
        let located = located::<S, L, T>(of.leaves(), rays);
        // The leaves that a point of the ray may be in, as far as they are known: of those that add to the result at
        // most, of those that are subtracted at least.
        let (mut inside, mut possible) = (0, of.added());
        for (leaf, (bit, shape)) in (0_u32..).zip(of.with_bits()) {
            let own = rays.of(leaf);
            let hits = (shape.crossings_at::<T>(&own), false);
            // What a departure says holds whatever the rounded coordinates are.
            let starts_inside = match own.departure() {
                Some(departure) if own.range().start() == S::ZERO => departure.leaving == Leaving::Inwards,
                _ => HitList::starts_inside(&hits.0),
            };
            inside |= if starts_inside { bit } else { 0 };
            if hits.0.is_empty() {
                possible = if starts_inside { possible | bit } else { possible & !bit };
                if !of.holds(possible) {
                    list.clear();
                    return 0;
                }
            }
            for entry in order::entries::<S, T, _, _>(leaf, shape, &hits, &located) {
                // What touches a departing ray where it starts is what it departs from.
                if entry.hit.crossing == Crossing::Touch && rays.departs() && stays(&own, entry.hit.t) {
                    continue;
                }
                // Cannot be full: the leaves have no more crossings.
                let inserted = list.insert::<T, _>(entry, &located);
                debug_assert!(inserted.is_ok());
            }
        }
        inside
    }

    /// Takes it as known that the ray starts inside, or outside, where the rounded coordinates of the leaves say the
    /// contrary: rounding has moved the start across the nearer of the two hits around it.
    #[cold]
    #[inline(never)]
    fn correct(&mut self, ray: &Ray<S>) {
        let (start, is_inside) = (ray.range().start(), !self.starts_inside);
        // As for the solids of a list: see `shape::known`.
        let (missed, passed, to) = if is_inside {
            (Crossing::Exit, Crossing::Enter, Leaving::Outwards)
        } else {
            (Crossing::Enter, Crossing::Exit, Leaving::Inwards)
        };
        let mut line = Self::new(self.of, &ray.with_range(Range::line()));
        line.begin();
        let passed_by = |t: S| t <= start || is_next(ray, t);
        let behind = line.filter(|on| on.hit.crossing == missed && passed_by(on.hit.t)).last();
        let mut onwards = self.clone();
        let ahead = onwards.find(|on| on.hit.crossing == passed);
        let is_behind = is_behind(start, behind.map(|on| on.hit.t), ahead.map(|on| on.hit.t));
        if !is_behind {
            *self = onwards;
        } else if let Some((leaf, part)) = self.rays.departed(self.of, to).or(behind.map(|on| (on.leaf, on.hit.part))) {
            self.at_start = Some(LeafHit { leaf, hit: Hit { t: start, part, crossing: missed } });
        }
        self.starts_inside = is_inside;
    }

    /// The leaf that is nearest to this hit of another tier: by the point's distance from the part, and along the ray
    /// from a crossing to the same side of the result, whose part may be another one next to a rim.
    fn like(&self, hit: &Hit<S>, point: Vec3<S>) -> Option<u32> {
        let mut nearest: Option<(S, u32)> = None;
        for Entry { solid, hit: own, .. } in self.list.iter() {
            if self.of.turned_crossing(*solid, own.crossing) != hit.crossing {
                continue;
            }
            let Some(leaf) = self.of.leaves().get(*solid as usize) else { continue };
            let distance = leaf.distance_to(hit.part, point);
            let away = distance.plus(own.t.minus(hit.t).magnitude());
            if distance.is_finite() && nearest.is_none_or(|(least, _)| away < least) {
                nearest = Some((away, *solid));
            }
        }
        nearest.map(|(_, leaf)| leaf)
    }

    /// The touch that is a hit of the result, of the crossings from this index on to the next: the ray is outside
    /// before and behind it, and would be inside in the leaf that it touches, even in all subtracted leaves that it
    /// touches.
    fn touched(&self, from: usize, before: u32) -> Option<LeafHit<S>> {
        let here = self.list.get(from..self.next)?;
        let touches = || here.iter().filter(|entry| entry.hit.crossing == Crossing::Touch);
        let bit = |entry: &Entry<S>| 1_u32.wrapping_shl(entry.solid);
        let subtracted = touches().map(bit).fold(0, |all, bit| all | bit) & !self.of.added();
        let is_in = |leaves: u32| self.of.holds(leaves | subtracted);
        let on = touches().find(|entry| is_in(before | bit(entry)) || is_in(self.inside | bit(entry)))?;
        Some(LeafHit { leaf: on.solid, hit: on.hit })
    }
}

impl<S: Scalar, L: Primitives, T: Tier<S>> Iterator for Changes<'_, S, L, T> {
    type Item = LeafHit<S>;

    fn next(&mut self) -> Option<LeafHit<S>> {
        if let Some(on) = self.at_start.take() {
            return Some(on);
        }
        loop {
            let (from, inside, was_in) = (self.next, self.inside, self.is_in);
            let first = self.list.get(from)?;
            // The last crossing at this place with which the predicate changes.
            let (mut changed, mut touches) = (None, false);
            let located = located::<S, L, T>(self.of.leaves(), &self.rays);
            while let Some(entry) = self.list.get(self.next)
                && (self.next == from || order::by_t::<S, T, _>(first, entry, &located).is_eq())
            {
                self.next += 1;
                let bit = 1_u32.wrapping_shl(entry.solid);
                match entry.hit.crossing {
                    Crossing::Enter => self.inside |= bit,
                    Crossing::Exit => self.inside &= !bit,
                    Crossing::Touch => {
                        touches = true;
                        continue;
                    }
                }
                let now = self.of.holds(self.inside);
                if now != self.is_in {
                    (self.is_in, changed) = (now, Some(entry));
                }
            }
            if self.is_in != was_in
                && let Some(entry) = changed
            {
                let crossing = if self.is_in { Crossing::Enter } else { Crossing::Exit };
                return Some(LeafHit { leaf: entry.solid, hit: Hit { crossing, ..entry.hit } });
            }
            if touches
                && !was_in
                && !self.is_in
                && let Some(on) = self.touched(from, inside)
            {
                return Some(on);
            }
        }
    }
}
