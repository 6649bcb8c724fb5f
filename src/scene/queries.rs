//! The queries of a scene: the nearest hit of a ray, occlusion, and which hits have one place.

use super::{Counters, Observer, Scene};
use crate::hierarchy::search::{self, Known, Watch};
use crate::hit::Hit;
use crate::ray::{Departure, Ray};
use crate::scalar::{Real, Scalar, largest};
use crate::shape::kinds::Kinds;
use crate::tier::Tier;

/// The most surfaces at one place that are told apart.
pub(crate) const MOST_AT_ONE_PLACE: usize = 8;

impl<S: Scalar, T: Tier<S>, K: Kinds> Scene<'_, S, T, K> {
    /// The nearest hit of a ray, and the index of its object. If two objects are hit at the same `t`, the one with the
    /// lower index is returned.
    ///
    /// A departure of the ray (see [`Departure`]) applies to the object that it names; the other objects are tested
    /// with the ray without departure. Counts every test in `counters`.
    pub fn nearest(&self, ray: &Ray<S>, counters: &mut Counters) -> Option<SceneHit<S>> {
        self.nearest_for(ray, counters, &mut ())
    }

    /// As [`Scene::nearest`], with an [`Observer`] that is called after every test.
    pub fn nearest_for(
        &self,
        ray: &Ray<S>,
        counters: &mut Counters,
        observer: &mut impl Observer,
    ) -> Option<SceneHit<S>> {
        self.nearest_known(ray, ray, counters, observer).map(|(on, _)| on)
    }

    /// What a picture shows along a ray: the nearest hit, or, of surfaces that the number type cannot tell apart, the
    /// opaque object that is listed last; if none is opaque, the last of all. So of a polygon that is given twice, or
    /// that lies in the plane of another, the later one is seen.
    ///
    /// Such surfaces are at most four units in the last place of `t` or of the ray's start apart, whichever is larger;
    /// two units in fixed point.
    ///
    /// ```
    /// # use raylet::{Camera, Counters, Disc, Material, Object, Plane, Ray, Scene, Shape, UnitVec3, Vec3};
    /// # let camera = Camera::new(Vec3::new(0.0_f32, 2.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0)?;
    /// // A sign on the floor.
    /// let objects = [Object::new(Shape::new(Plane::new()), 0), Object::new(Shape::new(Disc::new(1.0)?), 1)];
    /// let materials = [Material::default(); 2];
    /// let scene = Scene::new(&objects, &materials, &[], camera)?;
    /// let down = Ray::new(Vec3::new(0.5, 3.0, 0.0), -UnitVec3::Y)?;
    /// assert_eq!(scene.seen(&down, &mut Counters::default()).map(|on| on.object), Some(1));
    /// assert_eq!(scene.nearest(&down, &mut Counters::default()).map(|on| on.object), Some(0));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn seen(&self, ray: &Ray<S>, counters: &mut Counters) -> Option<SceneHit<S>> {
        self.seen_for(ray, counters, &mut ())
    }

    /// As [`Scene::seen`], with an [`Observer`] that is called after every test.
    pub fn seen_for(&self, ray: &Ray<S>, counters: &mut Counters, observer: &mut impl Observer) -> Option<SceneHit<S>> {
        let known = Departing(ray);
        let (mut seen, is_alone) = self.nearest_known(ray, &known, counters, observer)?;
        if !is_alone {
            self.at_one_place(ray, &known, seen.hit.t, counters, observer, |on| {
                if self.rank(&on) > self.rank(&seen) {
                    seen = on;
                }
            });
        }
        Some(seen)
    }

    /// Of surfaces at one place that of the largest rank is seen: whether it is opaque, and its index.
    pub(crate) fn rank(&self, on: &SceneHit<S>) -> (bool, u32) {
        (!self.transmits(on), on.object)
    }

    /// True if light passes through the material at a hit.
    pub(crate) fn transmits(&self, on: &SceneHit<S>) -> bool {
        let material = self.object(on.object).and_then(|object| self.material_of(object, on.hit.part));
        material.is_some_and(super::Material::transmits)
    }

    /// The nearest hit of a ray of which more is known than its coordinates, and whether it is certain that no other
    /// object is hit at the same place.
    #[inline(always)]
    pub(crate) fn nearest_known(
        &self,
        ray: &Ray<S>,
        known: &impl Known<S>,
        counters: &mut Counters,
        observer: &mut impl Observer,
    ) -> Option<(SceneHit<S>, bool)> {
        let mut watch = Watched { counters, observer };
        let nearest = search::nearest::<S, T, _>(self.objects, self.hierarchy.as_ref(), ray, known, &mut watch);
        nearest.map(|(object, hit, coincides)| (SceneHit { object, hit }, !coincides))
    }

    /// Calls `each` with the first hit of every object at the place of the nearest one, whose `t` is given.
    #[cold]
    #[inline(never)]
    pub(crate) fn at_one_place<N: Known<S>>(
        &self,
        ray: &Ray<S>,
        known: &N,
        t: S,
        counters: &mut Counters,
        observer: &mut impl Observer,
        mut each: impl FnMut(SceneHit<S>),
    ) {
        let (end, hierarchy) = (known.near(t), self.hierarchy.as_ref());
        let mut watch = Watched { counters, observer };
        let thickness = indistinct(ray, t);
        let is_same = |object: u32, hit: &Hit<S>| {
            let behind = hit.t.minus(t);
            behind <= thickness
                || N::SHADES
                    && self.object(object).is_some_and(|object| {
                        let cosine = ray.direction().dot(object.shape.surface(ray, hit).normal());
                        behind.real() * cosine.abs() <= thickness.real()
                    })
        };
        search::up_to::<S, T, _>(self.objects, hierarchy, ray, known, end, &mut watch, &mut |object, hit| {
            if is_same(object, &hit) {
                each(SceneHit { object, hit });
            }
        });
    }

    /// Occlusion test, for shadows: true if the ray hits any object within its range. Stops at the first object that it
    /// hits.
    pub fn occludes(&self, ray: &Ray<S>, counters: &mut Counters) -> bool {
        self.occluder(ray, counters, &mut ()).is_some()
    }

    /// Any object that the ray hits within its range, not necessarily the nearest; `None` if there is none.
    pub fn occluder(&self, ray: &Ray<S>, counters: &mut Counters, observer: &mut impl Observer) -> Option<u32> {
        self.occluder_known(ray, ray, counters, observer)
    }

    /// The same for a ray of which more is known.
    #[inline(always)]
    pub(crate) fn occluder_known(
        &self,
        ray: &Ray<S>,
        known: &impl Known<S>,
        counters: &mut Counters,
        observer: &mut impl Observer,
    ) -> Option<u32> {
        let mut watch = Watched { counters, observer };
        search::occluder::<S, T, _>(self.objects, self.hierarchy.as_ref(), ray, known, &mut watch)
    }

    /// True if the ray hits the object of this index within its range; false beyond the last object.
    pub fn stands_on(&self, index: u32, ray: &Ray<S>, counters: &mut Counters, observer: &mut impl Observer) -> bool {
        self.is_hit_known(index, ray, ray, counters, observer)
    }

    /// The same for a ray of which more is known.
    #[inline(always)]
    pub(crate) fn is_hit_known(
        &self,
        index: u32,
        ray: &Ray<S>,
        known: &impl Known<S>,
        counters: &mut Counters,
        observer: &mut impl Observer,
    ) -> bool {
        let mut watch = Watched { counters, observer };
        search::is_hit::<S, T, _>(self.objects, index, &ray.without_departure(), known, &mut watch)
    }
}

/// Nothing is known but the departure of the ray.
struct Departing<'a, S: Scalar>(&'a Ray<S>);

impl<S: Scalar> Known<S> for Departing<'_, S> {
    const KNOWS_INSIDE: bool = false;
    const SHADES: bool = true;

    #[inline(always)]
    fn shapes(&self) -> impl Iterator<Item = u32> + Clone {
        self.0.shapes()
    }
    #[inline(always)]
    fn departure_from(&self, shape: u32) -> Option<Departure> {
        self.0.departure_from(shape)
    }
    #[inline(always)]
    fn is_inside(&self, _: u32) -> Option<bool> {
        None
    }
    #[inline(always)]
    fn near(&self, t: S) -> S {
        near(self.0, t)
    }
}

/// The thickness of a film at this `t` that cannot be told from none: four units in the last place, two in fixed point.
///
/// Each of two surfaces that coincide is computed with an error of its own, and their placements are rounded. In fixed
/// point both take half a unit each.
#[inline]
fn indistinct<S: Scalar>(ray: &Ray<S>, t: S) -> S {
    if S::RELATIVE {
        let [x, y, z] = ray.origin().to_array();
        // 2^ROUNDING is half a unit.
        largest([x, y, z, t]).scaled(S::Real::ROUNDING + 3)
    } else {
        S::ZERO.next_up().next_up()
    }
}

/// The largest `t` at which a surface may be at the same place as one at this `t`: behind the thickest such film, for a
/// ray that meets it at a cosine of at least 1/16.
#[inline]
pub(crate) fn near<S: Scalar>(ray: &Ray<S>, t: S) -> S {
    (0..4).fold(indistinct(ray, t), |twice, _| twice.plus(twice)).plus(t)
}

/// Counts the tests, and hands them on.
struct Watched<'a, O> {
    counters: &'a mut Counters,
    observer: &'a mut O,
}

impl<O: Observer> Watch for Watched<'_, O> {
    #[inline(always)]
    fn count_test(&mut self) {
        self.counters.intersection_tests += 1;
    }

    #[inline(always)]
    fn count_box(&mut self) {
        self.counters.box_tests += 1;
    }

    #[inline(always)]
    fn tested(&mut self, index: u32, found: bool) {
        self.observer.tested(index, found);
    }
}

/// The nearest hit in a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = "S: Scalar"))]
pub struct SceneHit<S> {
    /// Index of the object.
    pub object: u32,
    /// The hit.
    pub hit: Hit<S>,
}
