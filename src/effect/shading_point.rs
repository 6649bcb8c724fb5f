//! Shading point: the point, its normals and the directions that all effects use.

use super::media::Passage;
use crate::hit::Crossing;
use crate::ray::Ray;
use crate::scalar::{Real, Ring, Scalar, UnitScalar};
use crate::scene::{Light, Object, Scene, SceneHit};
use crate::shape::Surface;
use crate::shape::kinds::Kinds;
use crate::tier::Tier;
use crate::vector::{UnitVec3, Vec3};

/// A shading point.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShadingPoint<'p, S: Scalar> {
    /// What is known of a ray that starts there, to the viewer's side.
    pub(super) near: &'p Passage,
    /// The point.
    pub(super) point: Vec3<S>,
    /// The geometric normal, on the side that the ray comes from. It decides on which side of the surface a direction
    /// is.
    pub(super) facing: UnitVec3<S>,
    /// The shading normal, on the same side except for some grazing rays.
    pub(super) normal: UnitVec3<S>,
    /// True if the ray comes from outside. It is taken from the crossing and does not depend on the rounding of the
    /// normal.
    pub(super) from_outside: bool,
    /// The direction to the viewer, opposite to that of the ray.
    pub(super) to_viewer: UnitVec3<S>,
}

/// A light as seen from a shading point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Towards<S: Scalar> {
    /// Direction of the light.
    pub(super) direction: UnitVec3<S>,
    /// Distance of the light; [`Scalar::INFINITY`] beyond the range of the type.
    pub(super) distance: S,
    /// Cosine of the angle between the shading normal and the direction of the light. It is positive.
    pub(super) cosine: S::Unit,
}

impl<'p, S: Scalar> ShadingPoint<'p, S> {
    /// The shading point of a hit, before bump mapping.
    pub(super) fn new<K: Kinds, T: Tier<S>>(
        scene: &Scene<'_, S, T, K>,
        object: &Object<S, K>,
        surface: &Surface<S, K>,
        ray: &Ray<S>,
        on: &SceneHit<S>,
        near: &'p Passage,
    ) -> Self {
        let to_viewer = -ray.direction();
        let from_outside = on.hit.crossing != Crossing::Exit;
        let (point, outward) = if T::SHADES_ROUGHLY { surface.rough() } else { (surface.point(), surface.normal()) };
        let facing = if from_outside { outward } else { -outward };
        let smooth = scene.corner_normals(object).and_then(|[a, b, c]| {
            let (u, v) = surface.uv();
            let (u, v) = (S::unit_real(u), S::unit_real(v));
            let rest = S::Real::ONE - u - v;
            let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a.real(), b.real(), c.real());
            let mix = |a, b, c| S::Real::sum_of_products([[a, rest], [b, u], [c, v]]);
            UnitVec3::from_real([mix(ax, bx, cx), mix(ay, by, cy), mix(az, bz, cz)])
        });
        // Oriented by the geometric normal and not by the viewer: near a silhouette an interpolated normal may point
        // away from the viewer.
        let normal = smooth.map_or(facing, |smooth| if smooth.dot(facing).is_negative() { -smooth } else { smooth });
        Self { near, point, facing, normal, from_outside, to_viewer }
    }

    /// The direction to a light; `None` if the light is behind the surface or at the point itself. Inlined, so that the
    /// distance takes no time where nothing needs it.
    #[inline(always)]
    pub(super) fn towards(&self, light: &Light<S>) -> Option<Towards<S>> {
        let from = if light.distant { Vec3::ZERO } else { self.point };
        let (components, distance) = S::towards(from.to_array(), light.position.to_array())?;
        let direction = UnitVec3::rotated(components);
        let cosine = self.normal.cosine(direction);
        let is_before =
            cosine > S::Unit::ZERO && (self.normal == self.facing || self.facing.dot(direction) > S::Real::ZERO);
        let distance = if light.distant { S::INFINITY } else { distance };
        is_before.then_some(Towards { direction, distance, cosine })
    }

    /// A secondary ray. What is known of its start (`Passage`) keeps it from hitting the surface that it starts on;
    /// there is no offset. `None` if the point is beyond the number type's budget, where no ray can start.
    pub(super) fn ray(&self, direction: UnitVec3<S>) -> Option<Ray<S>> {
        Ray::new(self.point, direction).ok()
    }
}
