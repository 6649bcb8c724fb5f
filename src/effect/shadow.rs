//! Shadow rays: whether a light reaches a point (Appel, *Some Techniques for Shading Machine Renderings of Solids*,
//! 1968).

use super::compiled::Effects;
use super::media::{Along, Passage, Place};
use super::set::Effect;
use super::shading_point::{ShadingPoint, Towards};
use super::trace_context::TraceContext;
use super::tracer::Tracer;
use crate::ray::{Range, Ray};
use crate::scalar::Scalar;
use crate::scene::{Observer, SceneHit};
use crate::shape::kinds::Kinds;
use crate::tier::Tier;

/// True if an object occludes the light of this index from the shading point.
///
/// Casts one ray with the range `[0, distance]` and stops at any hit. The object that last occluded this light is
/// tested first. No point or normal is computed. Transparent objects cast full shadows too: caustics are not computed,
/// and shadows do not depend on whether refraction is compiled in. A one-sided surface casts a shadow only if the
/// shadow ray hits it from its visible side. A point beyond the number type's budget, from which no ray can start, is
/// not in shadow.
pub(super) fn is_shadowed<S: Scalar, E: Effects, T: Tier<S>, O: Observer, K: Kinds>(
    tracer: &Tracer<'_, S, E, T, K>,
    site: &ShadingPoint<'_, S>,
    light: u32,
    towards: &Towards<S>,
    context: &mut TraceContext<O>,
) -> bool {
    let (scene, refracts, may_shade) = (tracer.scene(), tracer.uses(Effect::Refraction), context.may_shade);
    if may_shade.are_none() {
        return false;
    }
    let Some(ray) = ray_to_light(site, towards) else { return false };
    context.counters.shadow_rays += 1;
    let along = Along::<'_, S, T, K, E>::new(scene, &ray, site.near, refracts);
    if let Some(last) = context.last_occluder(light).filter(|last| may_shade.contain(*last))
        && scene.is_hit_known(last, &ray, &along, &mut context.counters, &mut context.observer)
    {
        return true;
    }
    let along = along.among(tracer.candidates(&ray).and(may_shade));
    let occluder = scene.occluder_known(&ray, &along, &mut context.counters, &mut context.observer);
    context.remember_occluder(light, occluder);
    occluder.is_some()
}

/// The ray from a shading point to a light; `None` beyond the number type's budget.
fn ray_to_light<S: Scalar>(site: &ShadingPoint<'_, S>, towards: &Towards<S>) -> Option<Ray<S>> {
    let ray = site.ray(towards.direction)?;
    Some(match Range::new(S::ZERO, towards.distance) {
        Ok(range) => ray.with_range(range),
        Err(_) => ray,
    })
}

impl<S: Scalar, E: Effects, T: Tier<S>, K: Kinds> Tracer<'_, S, E, T, K> {
    /// True if an object occludes the light of this index from the point where a ray hits another; as [`is_shadowed`].
    pub(crate) fn is_shadowed_by<O: Observer>(
        &self,
        occluder: u32,
        light: u32,
        (ray, on): (&Ray<S>, SceneHit<S>),
        context: &mut TraceContext<O>,
    ) -> bool {
        let (Some(object), Some(light)) = (self.scene.object(on.object), self.scene.lights().get(light as usize))
        else {
            return false;
        };
        let near = Passage::new().at(&Place::of(&[on], on), false, ray, self.scene);
        let surface = object.shape.surface(ray, &on.hit);
        let site = ShadingPoint::new(self.scene, object, &surface, ray, &on, &near);
        let Some(ray) = site.towards(light).and_then(|towards| ray_to_light(&site, &towards)) else { return false };
        context.counters.shadow_rays += 1;
        let along = Along::<'_, S, T, K, E>::new(self.scene, &ray, site.near, self.uses(Effect::Refraction));
        self.scene.is_hit_known(occluder, &ray, &along, &mut context.counters, &mut context.observer)
    }
}
