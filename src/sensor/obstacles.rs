//! What may be in the way of a sensor's rays.

use super::Zones;
use super::seen::SeenByZones;
use crate::hierarchy::Shapes;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::scene::{Ball, BallInWorld, MOST, ends};
use crate::shape::Shaped;

/// What may be in the way: a slice of shapes, [`Bounded`] shapes, or [`Shapes`] with their tree. Every reading is the
/// same of all of them.
///
/// A slice is tested shape by shape. It may lie in flash.
pub trait Obstacles<S: Scalar> {
    /// What has the shapes.
    type Item: Shaped<S>;

    /// The obstacles; [`Return::obstacle`](super::Return::obstacle) is an index of this list.
    fn list(&self) -> &[Self::Item];
    /// Calls `test` with the index of every obstacle that the ray may meet. `test` returns the end of the range that
    /// remains to be searched, or `None` to stop.
    fn each(&self, ray: &Ray<S>, test: impl FnMut(u32) -> Option<S>);
}

impl<S: Scalar, X: Shaped<S>> Obstacles<S> for [X] {
    type Item = X;

    #[inline(always)]
    fn list(&self) -> &[X] {
        self
    }
    #[inline(always)]
    fn each(&self, _: &Ray<S>, mut test: impl FnMut(u32) -> Option<S>) {
        for index in 0..self.len() as u32 {
            if test(index).is_none() {
                return;
            }
        }
    }
}

impl<S: Scalar, O: Obstacles<S> + ?Sized> Obstacles<S> for &O {
    type Item = O::Item;

    #[inline(always)]
    fn list(&self) -> &[O::Item] {
        (**self).list()
    }
    #[inline(always)]
    fn each(&self, ray: &Ray<S>, test: impl FnMut(u32) -> Option<S>) {
        (**self).each(ray, test);
    }
}

impl<S: Scalar, X: Shaped<S>> Obstacles<S> for Shapes<'_, S, X> {
    type Item = X;

    #[inline(always)]
    fn list(&self) -> &[X] {
        Shapes::list(self)
    }
    #[inline(always)]
    fn each(&self, ray: &Ray<S>, test: impl FnMut(u32) -> Option<S>) {
        self.visit(ray, test);
    }
}

/// A list of shapes, of which the first 16 are each bounded by two balls, made once: a post by those about its ends.
/// As seen from a sensor these tell which obstacles the rays of a zone may meet. For a dozen obstacles that takes the
/// least time; for many a tree does ([`Shapes`]).
///
/// ```
/// use raylet::sensor::{Bounded, RangeSensor, Reading, Zones};
/// use raylet::{Frame, Shape, Sphere, Vec3};
/// let list = [Shape::new(Sphere::new(1.0_f32)?)];
/// let bounded = Bounded::new(&list);
/// // For each place of the sensor.
/// let zones = Zones::new(Frame::at(Vec3::new(0.0, 0.0, -5.0))?, [8, 8], [45.0, 45.0])?;
/// let seen = bounded.seen_by(&zones);
/// let sensor = RangeSensor::new(0.0, 10.0)?;
/// let reading: Reading<_, 1> = sensor.read(&seen.in_zone(3, 4), zones.rays(3, 4), 0);
/// assert!(reading.returns[0].distance < 4.1);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Bounded<'a, S: Scalar, X> {
    list: &'a [X],
    ends: heapless::Vec<Option<[BallInWorld<S>; 2]>, MOST>,
}

impl<'a, S: Scalar, X: Shaped<S>> Bounded<'a, S, X> {
    /// The bounds of these shapes.
    pub fn new(list: &'a [X]) -> Self {
        Self { list, ends: list.iter().take(MOST).map(|of| ends(of.shape())).collect() }
    }

    /// As seen by the zones of a sensor, for the rays of these.
    pub fn seen_by(&self, zones: &Zones<S>) -> SeenByZones<'a, S, X> {
        let eye = zones.frame().position();
        let seen = self.ends.iter().map(|ends| {
            let [a, b] = (*ends)?;
            Some([Ball::seen(a, eye)?, Ball::seen(b, eye)?])
        });
        SeenByZones::new(self.list, seen, zones)
    }
}
