//! The crossings of many solids along one ray, in order.

use super::start::MOST_DEPARTURES;
use super::{SolidSet, Start, StartError, queries};
use crate::hierarchy::Shapes;
use crate::hit::{Crossing, Hit, HitList};
use crate::ray::{Departure, Leaving, Ray};
use crate::scalar::Scalar;
use crate::shape::known::stays;
use crate::shape::order::{self, Entry, Ordered};
use crate::shape::{Shape, Shaped};
use crate::tier::{Stable, Tier};
use core::fmt;
use core::ops::ControlFlow;

mod sealed {
    pub trait Sealed {}
}

/// A list of solids: a slice of [`Shape`](crate::Shape)s or of anything else that is [`Shaped`], or [`Shapes`] with
/// their hierarchy. Sealed.
pub trait List<S: Scalar>: sealed::Sealed {
    /// What is in the list.
    type Item: Shaped<S>;

    /// The list.
    fn list(&self) -> &[Self::Item];
    /// Calls `test` with the index of every solid that a ray without departure may meet, until it breaks.
    #[doc(hidden)]
    fn visit(&self, ray: &Ray<S>, test: impl FnMut(u32) -> ControlFlow<()>);
}

impl<X> sealed::Sealed for [X] {}

impl<S: Scalar, X: Shaped<S>> List<S> for [X] {
    type Item = X;

    fn list(&self) -> &[X] {
        self
    }
    fn visit(&self, _: &Ray<S>, mut test: impl FnMut(u32) -> ControlFlow<()>) {
        for (index, _) in (0_u32..).zip(self) {
            if test(index).is_break() {
                return;
            }
        }
    }
}

impl<X, const N: usize> sealed::Sealed for [X; N] {}

impl<S: Scalar, X: Shaped<S>, const N: usize> List<S> for [X; N] {
    type Item = X;

    fn list(&self) -> &[X] {
        self
    }
    fn visit(&self, ray: &Ray<S>, test: impl FnMut(u32) -> ControlFlow<()>) {
        List::<S>::visit(self.as_slice(), ray, test);
    }
}

impl<S: Scalar, X> sealed::Sealed for Shapes<'_, S, X> {}

impl<S: Scalar, X: Shaped<S>> List<S> for Shapes<'_, S, X> {
    type Item = X;

    fn list(&self) -> &[X] {
        Shapes::list(self)
    }
    fn visit(&self, ray: &Ray<S>, test: impl FnMut(u32) -> ControlFlow<()>) {
        self.visit_near(ray, test);
    }
}

/// All crossings of the solids of a list by a ray, in order, at most `N`; and the set of solids that the ray is inside
/// of between them. `W` is the number of words of a [`SolidSet`].
///
/// The order, and the rule at equal `t`, are those of [`solids`](super). Open surfaces (a disc, a triangle, a cylinder
/// without caps) have crossings too, at which the set does not change. A one-sided shape is crossed from both sides.
/// A ray that lies in a surface does not cross it.
///
/// A thickness, as the sum of the lengths inside of any solid:
///
/// ```
/// use raylet::solids::Crossings;
/// use raylet::{Cuboid, Frame, Ray, Shape, UnitVec3, Vec3};
/// let slab = Shape::new(Cuboid::new(0.5_f32, 1.0, 1.0)?);
/// // The first two touch at x = 1.5; the third stands apart.
/// let mut slabs = [slab; 3];
/// for (slab, x) in slabs.iter_mut().zip([1.0, 2.0, 4.0]) {
///     *slab = slab.placed(Frame::at(Vec3::new(x, 0.0, 0.0))?);
/// }
/// let ray = Ray::new(Vec3::ZERO, UnitVec3::X)?;
/// let crossings = Crossings::<f32, 6>::of(&slabs, &ray)?;
/// let ts: Vec<_> = crossings.iter().map(|crossing| (crossing.solid, crossing.hit.t)).collect();
/// assert_eq!(ts, [(0, 0.5), (0, 1.5), (1, 1.5), (1, 2.5), (2, 3.5), (2, 4.5)]);
///
/// let mut thickness = 0.0;
/// let mut entered = 0.0;
/// for crossing in &crossings {
///     match (crossing.before.is_empty(), crossing.after.is_empty()) {
///         (true, false) => entered = crossing.hit.t,
///         (false, true) => thickness += crossing.hit.t - entered,
///         _ => {}
///     }
/// }
/// assert_eq!(thickness, 3.0);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Crossings<S: Scalar, const N: usize, const W: usize = 1> {
    list: Ordered<S, N>,
    inside: SolidSet<W>,
    ray: Ray<S>,
    departures: heapless::Vec<Departure, MOST_DEPARTURES>,
}

impl<S: Scalar, const N: usize, const W: usize> Crossings<S, N, W> {
    /// The crossings of a ray of which nothing is known but its coordinates, in the tier [`Stable`].
    ///
    /// # Errors
    ///
    /// As [`Crossings::with_start`].
    pub fn of(solids: &(impl List<S> + ?Sized), ray: &Ray<S>) -> Result<Self, CrossingsError> {
        Self::with_start::<Stable>(solids, ray, &Start::new())
    }

    /// The crossings of a ray with this start, in a chosen accuracy tier.
    ///
    /// # Errors
    ///
    /// [`CrossingsError::Full`] if there are more than `N` crossings, [`CrossingsError::TooManySolids`] if the list is
    /// longer than a set of `W` words can hold.
    pub fn with_start<T: Tier<S>>(
        solids: &(impl List<S> + ?Sized),
        ray: &Ray<S>,
        start: &Start<W>,
    ) -> Result<Self, CrossingsError> {
        let shapes = solids.list();
        if shapes.len() > SolidSet::<W>::CAPACITY {
            return Err(CrossingsError::TooManySolids { given: shapes.len(), most: SolidSet::<W>::CAPACITY });
        }
        let (inside, mut departures) = (start.inside_seen(), heapless::Vec::new());
        for departure in start.departures() {
            // Cannot be full: the start has as much room.
            let _ = departures.push(*departure);
        }
        // Filled where it is returned: it is large.
        let mut result = Ok(Self { list: Ordered::new(), inside, ray: *ray, departures });
        queries::each(solids, ray, start, |solid, shape, own| {
            if let Ok(found) = &mut result
                && let Err(full) = found.add::<T, _>(shapes, solid, shape.shape(), own, start)
            {
                result = Err(full);
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
        result
    }

    /// Adds the crossings of one solid.
    fn add<T: Tier<S>, X: Shaped<S>>(
        &mut self,
        shapes: &[X],
        solid: u32,
        shape: &Shape<S, X::Kinds>,
        own: &Ray<S>,
        start: &Start<W>,
    ) -> Result<(), CrossingsError> {
        let knows_nothing = start.inside().is_none() && own.departure().is_none();
        let hits = if knows_nothing {
            let hits = shape.crossings_at::<T>(own);
            // Of many solids most are missed.
            if hits.is_empty() && !hits.starts_inside() {
                return Ok(());
            }
            (hits, false)
        } else {
            start.crossings_of::<S, T, X::Kinds>(own, solid, shape)
        };
        // What a departure says holds whatever else is known of the start.
        let is_inside = match own.departure() {
            Some(departure) if shape.is_solid() => Some(departure.leaving == Leaving::Inwards),
            _ => start.inside().is_none().then(|| hits.0.starts_inside()),
        };
        if let Some(is_inside) = is_inside
            && is_inside != self.inside.contains(solid)
        {
            self.inside = if is_inside { self.inside.with(solid) } else { self.inside.without(solid) };
        }
        let ray = self.ray;
        let located = start.located::<S, T, _>(shapes, &ray);
        for entry in order::entries::<S, T, _, _>(solid, shape, &hits, &located) {
            self.list.insert::<T, _>(entry, &located).map_err(|_| CrossingsError::Full { capacity: N })?;
        }
        Ok(())
    }

    /// The solids that the ray is inside of at its start.
    pub const fn inside(&self) -> SolidSet<W> {
        self.inside
    }

    /// The number of crossings.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// True if there is no crossing.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The crossings, in order.
    pub fn iter(&self) -> Iter<'_, S, W> {
        Iter { left: &self.list, inside: self.inside }
    }

    /// The start of the ray that goes on straight, or refracted, through the crossing of this index: inside of what it
    /// is inside of behind it, and departing from all surfaces with the same `t`, since they coincide there.
    ///
    /// The new ray begins at the point of the crossing. With an index beyond the last crossing it departs from none.
    ///
    /// # Errors
    ///
    /// [`StartError::TooManyDepartures`] if more than eight surfaces coincide.
    pub fn start_across(&self, index: usize) -> Result<Start<W>, StartError> {
        self.start_at(index, true)
    }

    /// The start of the ray that is mirrored at the crossing of this index: inside of what it is inside of before it,
    /// and departing from all surfaces with the same `t`.
    ///
    /// # Errors
    ///
    /// As [`Crossings::start_across`].
    pub fn start_before(&self, index: usize) -> Result<Start<W>, StartError> {
        self.start_at(index, false)
    }

    fn start_at(&self, index: usize, crosses: bool) -> Result<Start<W>, StartError> {
        let Some(t) = self.list.get(index).map(|entry| entry.hit.t) else {
            return Ok(Start::inside_of(self.iter().last().map_or(self.inside, |crossing| crossing.after)));
        };
        let earlier = self.list.iter().take(index).rev().take_while(|entry| entry.hit.t == t).count();
        let there = || self.iter().skip(index - earlier).take_while(|crossing| crossing.hit.t == t);
        let inside = match (there().next(), there().last()) {
            (Some(first), Some(last)) => {
                if crosses {
                    last.after
                } else {
                    first.before
                }
            }
            _ => self.inside,
        };
        let mut start = Start::inside_of(inside);
        // Where the point is still the ray's start, it is on the surfaces that the ray departed from, too.
        if stays(&self.ray, t) {
            for departure in &self.departures {
                start = start.departing(*departure)?;
            }
        }
        for (place, crossing) in there().enumerate() {
            let leaving = match crossing.hit.crossing {
                Crossing::Enter if crosses => Leaving::Inwards,
                Crossing::Exit if !crosses => Leaving::Inwards,
                _ => Leaving::Outwards,
            };
            let departure = Departure { object: crossing.solid, part: crossing.hit.part, leaving };
            // The chord of a solid may round to a point: behind it its last crossing counts, before it the first.
            let is_repeated = there().take(place).any(|earlier| earlier.solid == crossing.solid);
            match start.departure_from(crossing.solid) {
                Some(own) if crosses || !is_repeated => *own = departure,
                Some(_) => {}
                None => start = start.departing(departure)?,
            }
        }
        Ok(start)
    }
}

impl<'a, S: Scalar, const N: usize, const W: usize> IntoIterator for &'a Crossings<S, N, W> {
    type Item = SolidCrossing<S, W>;
    type IntoIter = Iter<'a, S, W>;

    fn into_iter(self) -> Iter<'a, S, W> {
        self.iter()
    }
}

/// A crossing of one of many solids.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
pub struct SolidCrossing<S, const W: usize = 1> {
    /// The index of the solid in its list.
    pub solid: u32,
    /// Where, on which part, and how the ray crosses it.
    pub hit: Hit<S>,
    /// The solids that the ray is inside of before the crossing.
    pub before: SolidSet<W>,
    /// The solids that it is inside of behind the crossing.
    pub after: SolidSet<W>,
}

/// Iterator over the crossings of a ray, in order.
#[derive(Clone, Debug)]
pub struct Iter<'a, S, const W: usize = 1> {
    left: &'a [Entry<S>],
    inside: SolidSet<W>,
}

impl<S: Copy, const W: usize> Iterator for Iter<'_, S, W> {
    type Item = SolidCrossing<S, W>;

    fn next(&mut self) -> Option<SolidCrossing<S, W>> {
        let (Entry { solid, hit, is_solid, .. }, left) = self.left.split_first()?;
        let before = self.inside;
        self.left = left;
        self.inside = match hit.crossing {
            Crossing::Enter if *is_solid => before.with(*solid),
            Crossing::Exit if *is_solid => before.without(*solid),
            _ => before,
        };
        Some(SolidCrossing { solid: *solid, hit: *hit, before, after: self.inside })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left.len(), Some(self.left.len()))
    }
}

impl<S: Copy, const W: usize> ExactSizeIterator for Iter<'_, S, W> {}

impl<S: Copy, const W: usize> core::iter::FusedIterator for Iter<'_, S, W> {}

/// Why the crossings of a ray cannot be listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CrossingsError {
    /// There are more crossings than the list can hold.
    Full {
        /// How many it can hold.
        capacity: usize,
    },
    /// There are more solids than a set can hold.
    TooManySolids {
        /// How many there are.
        given: usize,
        /// How many a set can hold.
        most: usize,
    },
}

impl fmt::Display for CrossingsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Full { capacity } => {
                write!(f, "the ray has more than {capacity} crossings: give their list more room")
            }
            Self::TooManySolids { given, most } => {
                write!(f, "a set holds {most} solids, and the list has {given}: give the set more words of 32")
            }
        }
    }
}

impl core::error::Error for CrossingsError {}
