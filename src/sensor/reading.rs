//! A measurement.

use super::search::{Search, first_entry};
use super::{Noise, Obstacles, SensorError};
use crate::hit::{Hit, Undecided};
use crate::ray::{Range, Ray};
use crate::scalar::Scalar;
use crate::shape::kinds::Kinds;
use crate::shape::{Shape, Shaped};
use crate::tier::Stable;

/// What a measurement came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Status {
    /// There is at least one return.
    Measured,
    /// Nothing is in the sensor's range.
    NoTarget,
    /// Something is nearer than the least distance.
    TooNear,
    /// The measurement was lost, as [`Noise`] has it.
    DroppedOut,
    /// [`Try`](super::Try) did not decide a ray.
    Undecided,
}

/// A distance that was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Return<S> {
    /// The distance along the ray, with the sensor's error.
    pub distance: S,
    /// The index of the obstacle.
    pub obstacle: u32,
    /// Which of the rays it is of, counted as they were given.
    pub ray: u16,
    /// Where that ray meets the obstacle: the true distance, the part, and how it is crossed.
    pub hit: Hit<S>,
}

impl<S: Scalar> Return<S> {
    /// The cosine of incidence at the obstacle: of the angle between the surface's normal and the way back to the
    /// sensor, from 0 where it grazes to 1 where it meets the surface straight on. The ray is that of this return.
    pub fn incidence<K: Kinds>(&self, obstacle: &Shape<S, K>, ray: &Ray<S>) -> S {
        obstacle.surface(ray, &self.hit).cosine()
    }
}

/// A measurement with up to `N` returns, the nearest first. There is one at least if, and only if, the status is
/// [`Status::Measured`].
#[derive(Clone, Debug, PartialEq)]
pub struct Reading<S, const N: usize> {
    /// What it came to.
    pub status: Status,
    /// What was measured.
    pub returns: heapless::Vec<Return<S>, N>,
}

impl<S, const N: usize> Reading<S, N> {
    const fn without_returns(status: Status) -> Self {
        Self { status, returns: heapless::Vec::new() }
    }
}

/// What a sensor can measure: distances, the separation of returns, and its errors. See [the module](super).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RangeSensor<S> {
    least: S,
    greatest: S,
    separation: S,
    noise: Noise<S>,
}

impl<S: Scalar> RangeSensor<S> {
    /// A sensor without errors, with the least and the greatest distance that it measures. All returns are apart.
    ///
    /// # Errors
    ///
    /// [`SensorError::Least`] if the least distance is negative or not finite; [`SensorError::Greatest`] if the
    /// greatest is not above it, or is beyond the number type's largest distance.
    pub fn new(least: S, greatest: S) -> Result<Self, SensorError> {
        // Comparisons are false for NaN.
        if !(least >= S::ZERO && least.is_finite()) {
            return Err(SensorError::Least);
        }
        if !(greatest > least && greatest <= S::BUDGET.distance) {
            return Err(SensorError::Greatest);
        }
        Ok(Self { least, greatest, separation: S::ZERO, noise: Noise::NONE })
    }

    /// The same sensor, of which a return is at least this much farther than the one before. What is nearer to that is
    /// part of it.
    ///
    /// # Errors
    ///
    /// [`SensorError::Separation`] if the separation is negative or not finite.
    pub fn separating(self, separation: S) -> Result<Self, SensorError> {
        if separation >= S::ZERO && separation.is_finite() {
            Ok(Self { separation, ..self })
        } else {
            Err(SensorError::Separation)
        }
    }

    /// The same sensor with these errors.
    #[must_use]
    pub const fn with_noise(self, noise: Noise<S>) -> Self {
        Self { noise, ..self }
    }

    /// The distances that it measures: the least and the greatest.
    pub const fn limits(&self) -> [S; 2] {
        [self.least, self.greatest]
    }

    /// What it measures along these rays, which are those of one zone or the only one of a beam. Ranges and departures
    /// of rays have no effect. `number` is that of the measurement: with it the errors repeat.
    #[inline(always)]
    pub fn read<const N: usize>(
        &self,
        obstacles: &(impl Obstacles<S> + ?Sized),
        rays: impl IntoIterator<Item = Ray<S>, IntoIter: Clone>,
        number: u32,
    ) -> Reading<S, N> {
        self.read_at::<Stable, N>(obstacles, rays, number)
    }

    /// As [`RangeSensor::read`], in a chosen accuracy tier, or by [`Try`](super::Try) of one.
    pub fn read_at<T: Search<S>, const N: usize>(
        &self,
        obstacles: &(impl Obstacles<S> + ?Sized),
        rays: impl IntoIterator<Item = Ray<S>, IntoIter: Clone>,
        number: u32,
    ) -> Reading<S, N> {
        let mut reading = Reading::without_returns(Status::NoTarget);
        if self.noise.loses(number) {
            return Reading::without_returns(Status::DroppedOut);
        }
        let (rays, mut from) = (rays.into_iter(), S::ZERO);
        while reading.returns.len() < N {
            match self.nearest::<T>(obstacles, rays.clone(), from) {
                Err(Undecided) => return Reading::without_returns(Status::Undecided),
                Ok(None) => break,
                Ok(Some(seen)) if seen.hit.t < self.least => return Reading::without_returns(Status::TooNear),
                Ok(Some(seen)) => {
                    let distance = self.noise.of(seen.hit.t, number, reading.returns.len());
                    // There is room for N.
                    let _ = reading.returns.push(Return { distance, ..seen });
                    reading.status = Status::Measured;
                    let separated = seen.hit.t.plus(self.separation);
                    from = if separated > seen.hit.t { separated } else { seen.hit.t.next_up() };
                }
            }
        }
        reading
    }

    /// The nearest return at this distance or beyond.
    #[inline(always)]
    fn nearest<T: Search<S>>(
        &self,
        obstacles: &(impl Obstacles<S> + ?Sized),
        rays: impl Iterator<Item = Ray<S>>,
        from: S,
    ) -> Result<Option<Return<S>>, Undecided> {
        let (mut nearest, mut end) = (None, self.greatest);
        for (number, ray) in rays.enumerate() {
            let Ok(range) = Range::new(from, end) else { break };
            let mut ray = ray.without_departure().with_range(range);
            let mut decided = Ok(());
            obstacles.each(&ray.clone(), |index| {
                let shape = obstacles.list().get(index as usize)?.shape();
                // Inside of a solid the way out is the first that is seen.
                let found = if from > S::ZERO { first_entry::<S, T, _>(shape, &ray) } else { T::nearest(shape, &ray) };
                match found {
                    Err(Undecided) => {
                        decided = Err(Undecided);
                        return None;
                    }
                    Ok(Some(hit)) => {
                        let (t, obstacle) = (hit.t, index);
                        let is_nearer = nearest.is_none_or(|Return { hit, ray, obstacle, .. }: Return<S>| {
                            t < hit.t || (t == hit.t && usize::from(ray) == number && index < obstacle)
                        });
                        if is_nearer {
                            nearest = Some(Return { distance: t, obstacle, ray: number as u16, hit });
                            // The result of an obstacle must not depend on that of another.
                            if !T::EXACT_ENDS
                                && let Ok(range) = Range::new(from, t)
                            {
                                end = t;
                                ray = ray.with_range(range);
                            }
                        }
                    }
                    Ok(None) => {}
                }
                Some(end)
            });
            decided?;
        }
        Ok(nearest)
    }
}
