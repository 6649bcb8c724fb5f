//! A point on a surface, and which way things are from it: what every effect starts from.

use crate::hit::Crossing;
use crate::part::Part;
use crate::ray::{Departure, Leaving, Ray};
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{Light, Object, Scene, SceneHit};
use crate::shape::Surface;
use crate::tier::Tier;
use crate::vector::{UnitVec3, Vec3};

/// A point on a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site<S: Scalar> {
    /// Index of the object that the point lies on.
    pub(super) object: u32,
    /// On which part of it.
    pub(super) part: Part,
    /// The point.
    pub(super) point: Vec3<S>,
    /// The normal of the surface on the side that the ray comes from. It decides which side things are on.
    pub(super) facing: UnitVec3<S>,
    /// The normal for shading, on the same side but for a ray that grazes.
    pub(super) normal: UnitVec3<S>,
    /// True if the ray comes from outside. The crossing says so, whatever the rounding of the normal.
    pub(super) from_outside: bool,
    /// Back along the ray.
    pub(super) to_viewer: UnitVec3<S>,
}

/// A light as seen from a site.
#[derive(Clone, Copy, Debug)]
pub(super) struct Towards<S: Scalar> {
    /// Direction of the light.
    pub(super) direction: UnitVec3<S>,
    /// Distance of the light; [`Scalar::INFINITY`] beyond the range of the type.
    pub(super) distance: S,
    /// Cosine between the shading normal and the light: positive, or there is nothing to shade.
    pub(super) cosine: S::Real,
}

impl<S: Scalar> Site<S> {
    /// The site of a hit, without textures and bumps.
    pub(super) fn new(
        scene: &Scene<'_, S, impl Tier<S>>,
        object: &Object<S>,
        surface: &Surface<S>,
        ray: &Ray<S>,
        on: &SceneHit<S>,
    ) -> Self {
        let to_viewer = -ray.direction();
        let from_outside = on.hit.crossing != Crossing::Exit;
        let outward = surface.normal();
        let facing = if from_outside { outward } else { -outward };
        let smooth = scene.corner_normals(object).and_then(|[a, b, c]| {
            let (u, v) = surface.uv();
            let (u, v) = (S::unit_real(u), S::unit_real(v));
            let rest = S::Real::ONE - u - v;
            let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a.real(), b.real(), c.real());
            let mix = |a, b, c| S::Real::sum_of_products([[a, rest], [b, u], [c, v]]);
            UnitVec3::from_real([mix(ax, bx, cx), mix(ay, by, cy), mix(az, bz, cz)])
        });
        // By the true normal, not by the viewer: near a silhouette the smooth one leans away from whoever looks.
        let normal = smooth.map_or(facing, |smooth| if smooth.dot(facing).is_negative() { -smooth } else { smooth });
        let (object, part) = (on.object, on.hit.part);
        Self { object, part, point: surface.point(), facing, normal, from_outside, to_viewer }
    }

    /// The way to a light; `None` if it stands behind the surface, or in the very point.
    pub(super) fn towards(&self, light: &Light<S>) -> Option<Towards<S>> {
        let from = if light.distant { Vec3::ZERO } else { self.point };
        let ([lx, ly, lz], [px, py, pz]) = (light.position.real(), from.real());
        let (components, distance) = S::normalize([lx - px, ly - py, lz - pz])?;
        let direction = UnitVec3::rotated(components);
        let cosine = self.normal.dot(direction);
        let zero = S::Real::ZERO;
        (cosine > zero && self.facing.dot(direction) > zero).then(|| Towards {
            direction,
            distance: if light.distant { S::INFINITY } else { S::round(distance) },
            cosine,
        })
    }

    /// A ray that leaves the surface, to the viewer's side or through to the other. No offset keeps it off the surface that
    /// it starts on, the [`Departure`] does. `None` if the point is beyond the number type's budget, where no ray can start.
    pub(super) fn ray(&self, direction: UnitVec3<S>, through: bool) -> Option<Ray<S>> {
        let leaving = if self.from_outside == through { Leaving::Inwards } else { Leaving::Outwards };
        let departure = Departure { object: self.object, part: self.part, leaving };
        Ray::new(self.point, direction).ok().map(|ray| ray.departing(departure))
    }
}
