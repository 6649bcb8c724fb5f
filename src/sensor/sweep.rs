//! The beams of a scanning lidar.

use super::SensorError;
use crate::frame::Frame;
use crate::ray::Ray;
use crate::scalar::{Real, Ring, Scalar};
use crate::vector::{UnitVec3, pairs};

/// The beams of a lidar that turns about the y axis of its frame, in the plane across it, at equal angles. It looks
/// along the z axis, and turns from the left to the right.
///
/// ```
/// use raylet::sensor::Sweep;
/// use raylet::{Frame, UnitVec3, Vec3};
/// let sweep = Sweep::new(Frame::at(Vec3::ZERO)?, 181, 180.0_f32)?;
/// assert_eq!(sweep.beam(90).map(|ray| ray.direction()), Some(UnitVec3::Z));
/// assert!(sweep.beam(0).is_some_and(|ray| ray.direction().x() > 0.999));
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sweep<S: Scalar> {
    frame: Frame<S>,
    beams: u16,
    /// The angle between neighbouring beams, in turns.
    step: S::Real,
    /// That of the first one.
    first: S::Real,
}

impl<S: Scalar> Sweep<S> {
    /// So many beams, from one end of an angle in degrees to the other. Those of a whole turn are all apart: the last
    /// one is next to the first, which looks backwards.
    ///
    /// # Errors
    ///
    /// [`SensorError::Beams`] for fewer than two beams; [`SensorError::Sweep`] if the angle is not above 0, or more
    /// than 360.
    pub fn new(frame: Frame<S>, beams: u16, angle: S) -> Result<Self, SensorError> {
        let (turn, angle) = (S::Real::from_int(360), angle.real());
        if beams < 2 {
            return Err(SensorError::Beams);
        }
        // A comparison with NaN is false.
        if !(angle > S::Real::ZERO && angle <= turn) {
            return Err(SensorError::Sweep);
        }
        let steps = i32::from(beams) - i32::from(angle < turn);
        let turns = angle / turn;
        Ok(Self { frame, beams, step: turns / S::Real::from_int(steps), first: turns.scaled(-1) })
    }

    /// The number of beams.
    pub const fn beams(&self) -> u16 {
        self.beams
    }

    /// Where the lidar is.
    pub const fn frame(&self) -> &Frame<S> {
        &self.frame
    }

    /// A beam; `None` beyond the last. It takes a sine and a cosine, which `libm` computes in doubles for `f32`: on a
    /// chip keep the beams.
    pub fn beam(&self, number: u16) -> Option<Ray<S>> {
        if number >= self.beams {
            return None;
        }
        let turns = self.first - self.step * S::Real::from_int(number.into());
        let (sine, cosine) = S::sine_cosine(S::unit_round(turns));
        let [sine, cosine] = [sine, cosine].map(S::unit_real);
        let [left, forward] = [self.frame.left(), self.frame.forward()].map(UnitVec3::real);
        let direction = S::direction(pairs(left, forward).map(|(left, forward)| left * sine + forward * cosine))?;
        Ray::new(self.frame.position(), UnitVec3::rotated(direction)).ok()
    }

    /// All beams, from the left to the right.
    pub fn all(&self) -> impl Iterator<Item = Ray<S>> + Clone {
        let sweep = *self;
        (0..self.beams).filter_map(move |number| sweep.beam(number))
    }
}
