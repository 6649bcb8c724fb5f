//! Floor 8: what makes a hit a colour, a file an effect.
//!
//! | room | what it does |
//! |---|---|
//! | `diffuse` | light that a matte surface scatters (Lambert) |
//! | `specular` | highlights (Phong) |
//! | `shadow` | whether a light reaches the point at all |
//!
//! There is no ambient light: what no lamp reaches is black. Mirror and refracted rays are not cast yet: a scene
//! whose materials call for them is shaded as if `transmittance` were 0 and nothing were mirrored.

mod diffuse;
mod shadow;
mod specular;

use crate::part::Part;
use crate::ray::Ray;
use crate::scalar::{Real, Scalar};
use crate::scene::{Color, Counters, Material, Scene, SceneHit};
use crate::vector::{UnitVec3, Vec3};

/// What a ray sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight<S: Scalar> {
    /// The colour.
    pub color: Color<S>,
    /// The object and the part of its surface; `None` for the background.
    pub seen: Option<(u32, Part)>,
    /// Which of the first 32 lights reach the point, a bit for each, the first light in the lowest.
    pub lit_by: u32,
}

/// A point on a surface, and which way things are from it: what every effect starts from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Site<S: Scalar> {
    /// The object that the point lies on, and where.
    pub(crate) on: SceneHit<S>,
    /// The point.
    pub(crate) point: Vec3<S>,
    /// The outward normal of the surface.
    pub(crate) outward: UnitVec3<S>,
    /// The normal for shading, on the viewer's side.
    pub(crate) normal: UnitVec3<S>,
    /// True if the viewer is on the outside.
    pub(crate) seen_from_outside: bool,
    /// Towards the viewer.
    pub(crate) to_viewer: UnitVec3<S>,
}

/// A light as seen from a site.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Towards<S: Scalar> {
    /// Direction of the light.
    pub(crate) direction: UnitVec3<S>,
    /// Distance of the light; [`Scalar::INFINITY`] beyond the range of the type.
    pub(crate) distance: S,
    /// Cosine between the shading normal and the light: positive, or there is nothing to shade.
    pub(crate) cosine: S::Real,
}

/// What a ray sees: the nearest surface, shaded, or the background.
///
/// Only what is called for is computed: no shadow ray goes towards a light behind the surface or one that could add
/// nothing, no highlight is computed for a material without. All work is counted in `counters`.
pub fn look<S: Scalar>(scene: &Scene<'_, S>, ray: &Ray<S>, counters: &mut Counters) -> Sight<S> {
    let Some(on) = scene.nearest(ray, counters) else {
        return Sight { color: scene.background(), seen: None, lit_by: 0 };
    };
    let seen = Some((on.object, on.hit.part));
    let Some(object) = scene.object(on.object) else {
        return Sight { color: Color::BLACK, seen, lit_by: 0 };
    };
    counters.hits_refined += 1;
    let material = scene.material(object);
    let site = Site::new(scene, ray, on);
    let (mut color, mut lit_by) = (Color::BLACK, 0);
    for (index, light) in (0_u32..).zip(scene.lights()) {
        let Some(towards) = site.towards(light.position) else { continue };
        let light_of = shade(&material, light.strength, &site, &towards);
        if light_of == Color::BLACK || shadow::is_shadowed(scene, &site, &towards, counters) {
            continue;
        }
        lit_by |= 1_u32.checked_shl(index).unwrap_or(0);
        color = color.plus(light_of);
    }
    Sight { color, seen, lit_by }
}

/// The light of one lamp that goes from a site to the viewer if nothing stands between.
fn shade<S: Scalar>(material: &Material<S>, strength: [S; 3], site: &Site<S>, towards: &Towards<S>) -> Color<S> {
    let scattered = diffuse::weight(material, towards);
    let mirrored = specular::weight(material, site, towards);
    let [red, green, blue] = material.color.to_array();
    let [r, g, b] = strength;
    let channel =
        |own: S::Unit, strength: S| S::unit_round((S::unit_real(own) * scattered + mirrored) * strength.real());
    Color::new(channel(red, r), channel(green, g), channel(blue, b))
}

impl<S: Scalar> Site<S> {
    fn new(scene: &Scene<'_, S>, ray: &Ray<S>, on: SceneHit<S>) -> Self {
        let to_viewer = -ray.direction();
        // The caller has looked the object up already; a scene's hits name its own objects.
        let (mut point, mut outward, mut smooth) = (ray.at(on.hit.t), to_viewer, None);
        if let Some(object) = scene.object(on.object) {
            let surface = object.shape.surface(ray, &on.hit);
            (point, outward) = (surface.point(), surface.normal());
            smooth = scene.corner_normals(object).and_then(|[a, b, c]| {
                let (u, v) = surface.uv();
                let (u, v) = (S::unit_real(u), S::unit_real(v));
                let rest = S::Real::ONE - u - v;
                let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a.real(), b.real(), c.real());
                let mix = |a, b, c| S::Real::sum_of_products([[a, rest], [b, u], [c, v]]);
                UnitVec3::from_real([mix(ax, bx, cx), mix(ay, by, cy), mix(az, bz, cz)])
            });
        }
        let seen_from_outside = !outward.dot(to_viewer).is_negative();
        let shading = smooth.unwrap_or(outward);
        let normal = if shading.dot(to_viewer).is_negative() { -shading } else { shading };
        Self { on, point, outward, normal, seen_from_outside, to_viewer }
    }

    /// The way to a light; `None` if it stands behind the surface, or in the very point.
    fn towards(&self, light: Vec3<S>) -> Option<Towards<S>> {
        let ([lx, ly, lz], [px, py, pz]) = (light.real(), self.point.real());
        let (components, distance) = S::normalize([lx - px, ly - py, lz - pz])?;
        let direction = UnitVec3::rotated(components);
        let cosine = self.normal.dot(direction);
        let outside = self.outward.dot(direction) > S::Real::ZERO;
        (cosine > S::Real::ZERO && outside == self.seen_from_outside).then(|| Towards {
            direction,
            distance: S::round(distance),
            cosine,
        })
    }
}
