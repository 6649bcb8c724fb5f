//! From a ray to the light at its first interface, and to the rays that it sends on from there.

use super::compiled::Effects;
use super::cutoff::DEPTH;
use super::media::{Along, Media, Place};
use super::paths::{Gathered, Segment};
use super::set::{Effect, EffectSet};
use super::shading_point::ShadingPoint;
use super::trace_context::TraceContext;
use super::tracer::Tracer;
use super::{ambient, bump, diffuse, fog, reflection, refraction, shadow, specular, texture};
use crate::hit::Crossing;
use crate::part::Part;
use crate::ray::{Range, Ray};
use crate::scalar::{Ring, Scalar, UnitScalar};
use crate::scene::{Candidates, Color, MOST_AT_ONE_PLACE, Material, Observer, SceneHit, Waves};
use crate::shape::Surface;
use crate::shape::kinds::Kinds;
use crate::tier::Tier;
use crate::vector::Vec3;

/// The most surfaces between equal media that a ray passes; the next one is seen.
const MOST_PASSED: u32 = 256;

/// How light changes along a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Course<S> {
    /// Not at all.
    Same,
    /// Smoothly, but for shadows.
    Smooth,
    /// The same, and with highlights of this exponent, which are narrow where the surface is curved.
    Glossy(S),
    /// In any way.
    Any,
}

impl<'a, S: Scalar, E: Effects, T: Tier<S>, K: Kinds> Tracer<'a, S, E, T, K> {
    /// Casts a ray, which meets no other objects than these, gathers the light at the first interface, and returns the
    /// secondary rays.
    pub(super) fn meet<O: Observer>(
        &self,
        mut segment: Segment<S>,
        candidates: Candidates,
        gathered: &mut Gathered<S>,
        context: &mut TraceContext<O>,
    ) -> [Option<Segment<S>>; 2] {
        match segment.cause {
            Some(Effect::Reflection) => context.counters.reflection_rays += 1,
            Some(_) => context.counters.refraction_rays += 1,
            None => {}
        }
        let mut weight = segment.weight;
        for passed in 0..=MOST_PASSED {
            let Some((nearest, is_alone)) = self.nearest(&segment, candidates, context) else {
                if segment.cause.is_none() {
                    gathered.first = None;
                }
                let weight = self.through_fog(&segment, weight, None, gathered, context);
                gathered.add(self.scene.background(), weight);
                return [None, None];
            };
            let several;
            let met = if is_alone {
                core::slice::from_ref(&nearest)
            } else {
                several = self.at_one_place(&segment, candidates, nearest, context);
                &several
            };
            let mut place = Place::of(met, nearest);
            let (media, is_interface) = self.sides(&mut segment, &mut place, is_alone);
            let on = place.seen;
            if segment.cause.is_none() {
                gathered.first = Some(on);
            }
            weight = self.through_fog(&segment, weight, Some(on.hit.t), gathered, context);
            if !self.shows_surfaces() {
                return [None, None];
            }
            let Some(object) = self.scene.object(on.object) else { return [None, None] };
            let Some(material) = self.scene.material_of(object, on.hit.part) else { return [None, None] };
            if is_interface && !self.is_seen(material) {
                return [None, None];
            }
            let surface = object.shape.surface(&segment.ray, &on.hit);
            if !is_interface && passed < MOST_PASSED {
                // The same medium on both sides: the ray goes on as if there were nothing.
                let passage = segment.passage.at(&place, true, &segment.ray, self.scene);
                let Some(ray) = continued(&segment.ray, surface.point(), on.hit.t) else { return [None, None] };
                segment = Segment { ray, passage, enclosed: media.is_enclosed(), ..segment };
                continue;
            }
            context.counters.hits_refined += 1;
            let near = segment.passage.at(&place, false, &segment.ray, self.scene);
            let mut site = ShadingPoint::new(self.scene, object, &surface, &segment.ray, &on, &near);
            let color = self.dress(material, &surface, &mut site, context);
            let lit_by = self.shade(material, color, &site, weight, gathered, context);
            if segment.cause.is_none() {
                gathered.lit_by = lit_by;
            }
            return self.onward(&segment, material, &site, &place, media, weight);
        }
        [None, None]
    }

    /// The first hit of a ray among these objects, of which none refracts: what a picture sees.
    pub(crate) fn first<O: Observer>(
        &self,
        ray: &Ray<S>,
        candidates: Candidates,
        context: &mut TraceContext<O>,
    ) -> Option<SceneHit<S>> {
        let segment = Segment::from_eye(*ray);
        let (nearest, is_alone) = self.nearest(&segment, candidates, context)?;
        if is_alone {
            return Some(nearest);
        }
        let met = self.at_one_place(&segment, candidates, nearest, context);
        let mut place = Place::of(&met, nearest);
        place.see_last(self.scene);
        Some(place.seen)
    }

    /// How the light changes over the columns of a row that see a part of an object, or the background.
    pub(crate) fn course(&self, seen: Option<(u32, Part)>) -> Course<S> {
        let material = seen.and_then(|(index, part)| self.scene.material_of(self.scene.object(index)?, part));
        let Some(material) = material else { return Course::Same };
        let is_used = |effect, share| self.uses(effect) && share > S::ZERO;
        let is_shown = self.shows_surfaces() && self.is_seen(material);
        let is_textured = self.uses(Effect::Texture) && material.texture.is_some();
        let is_bent = self.uses(Effect::Bump) && material.bump.is_some();
        if is_shown && (is_textured || is_bent) || is_used(Effect::Reflection, material.mirror) {
            Course::Any
        } else if is_used(Effect::Specular, material.specular) {
            Course::Glossy(material.shine)
        } else if is_shown && is_used(Effect::Diffuse, material.diffuse) || self.uses(Effect::Fog) {
            Course::Smooth
        } else {
            Course::Same
        }
    }

    /// The nearest hit of a ray, and whether it is certain that nothing else is hit at the same place.
    #[inline(always)]
    fn nearest<O: Observer>(
        &self,
        segment: &Segment<S>,
        candidates: Candidates,
        context: &mut TraceContext<O>,
    ) -> Option<(SceneHit<S>, bool)> {
        let along = self.along(segment).among(candidates);
        self.scene.nearest_known(&segment.ray, &along, &mut context.counters, &mut context.observer)
    }

    #[inline(always)]
    fn along<'s>(&'s self, segment: &'s Segment<S>) -> Along<'s, S, T, K, E> {
        Along::new(self.scene, &segment.ray, &segment.passage, self.uses(Effect::Refraction))
    }

    /// The nearest hit of a ray, and those of other objects at the same place, as far as there is room.
    #[cold]
    #[inline(never)]
    fn at_one_place<O: Observer>(
        &self,
        segment: &Segment<S>,
        candidates: Candidates,
        nearest: SceneHit<S>,
        context: &mut TraceContext<O>,
    ) -> heapless::Vec<SceneHit<S>, MOST_AT_ONE_PLACE> {
        let (mut met, along) = (heapless::Vec::from_array([nearest]), self.along(segment).among(candidates));
        let (counters, observer) = (&mut context.counters, &mut context.observer);
        self.scene.at_one_place(&segment.ray, &along, nearest.hit.t, counters, observer, |on| {
            if !met.iter().any(|other| other.object == on.object) {
                let _ = met.push(on);
            }
        });
        met
    }

    /// Decides what is seen of a place, and returns the media on its sides, and whether they differ.
    #[inline(always)]
    fn sides(&self, segment: &mut Segment<S>, place: &mut Place<'_, S>, is_alone: bool) -> (Media<'a, S>, bool) {
        let is_opaque = !is_alone && place.see_last(self.scene);
        if is_opaque || !self.uses(Effect::Refraction) || !self.scene.transmits(&place.seen) {
            return (Media::none(), true);
        }
        if segment.passage.begins() {
            segment.passage = if segment.ray.origin() == self.scene.camera().position() {
                self.around_camera
            } else {
                self.around(&segment.ray)
            };
        }
        place.separate(self.scene, &segment.passage)
    }

    /// True if any effect is in use that makes surfaces other than black.
    fn shows_surfaces(&self) -> bool {
        let light = EffectSet::of(Effect::Ambient).with(Effect::Diffuse).with(Effect::Specular);
        let shows = light.with(Effect::Reflection).with(Effect::Refraction);
        !E::SET.intersection(shows).intersection(self.active).is_empty()
    }

    /// True if point and normal are needed to shade the material; otherwise the surface is black.
    fn is_seen(&self, material: &Material<S>) -> bool {
        (self.uses(Effect::Ambient) || self.uses(Effect::Diffuse)) && material.diffuse > S::ZERO
            || self.uses(Effect::Specular) && material.specular > S::ZERO
            || self.uses(Effect::Reflection) && material.mirror > S::ZERO
            || self.uses(Effect::Refraction) && material.transmits()
    }

    /// Adds the light of the fog along a ray, if there is any, and returns the weight of what is behind it.
    #[inline(always)]
    fn through_fog<O: Observer>(
        &self,
        segment: &Segment<S>,
        weight: S::Unit,
        t: Option<S>,
        gathered: &mut Gathered<S>,
        context: &mut TraceContext<O>,
    ) -> S::Unit {
        let Some(haze) = self.scene.fog().filter(|_| self.uses(Effect::Fog) && !segment.enclosed) else {
            return weight;
        };
        context.counters.fogged_rays += 1;
        let visible = weight.times(fog::visibility(haze, t));
        gathered.add(haze.color(), weight.minus(visible));
        visible
    }

    /// The colour of the surface at a shading point, and its normal after bump mapping. Surface coordinates are
    /// computed once, and only if there is a texture or a bump map.
    fn dress<O: Observer>(
        &self,
        material: &Material<S>,
        surface: &Surface<S, K>,
        site: &mut ShadingPoint<'_, S>,
        context: &mut TraceContext<O>,
    ) -> Color<S> {
        let pattern = if self.uses(Effect::Texture) { self.scene.texture(material) } else { None };
        let waves = if self.uses(Effect::Bump) { material.bump.filter(Waves::are_visible) } else { None };
        if pattern.is_none() && waves.is_none() {
            return material.color;
        }
        let uv = surface.uv();
        if let Some(waves) = waves {
            context.counters.bumps += 1;
            site.normal = bump::bent(&waves, surface, uv, site.normal, site.from_outside);
        }
        pattern.map_or(material.color, |pattern| {
            context.counters.texture_lookups += 1;
            material.color.times(texture::color(pattern, uv, || surface.uvw()))
        })
    }

    /// Adds the ambient light and that of all light sources that reach a shading point, and returns which of the first
    /// 32 do.
    ///
    /// No shadow ray is cast to a light that is behind the surface or would contribute nothing.
    fn shade<O: Observer>(
        &self,
        material: &Material<S>,
        color: Color<S>,
        site: &ShadingPoint<'_, S>,
        weight: S::Unit,
        gathered: &mut Gathered<S>,
        context: &mut TraceContext<O>,
    ) -> u32 {
        let mut lit_by = 0;
        if self.uses(Effect::Ambient) {
            gathered.gather(ambient::light(self.scene.ambient(), material, color, weight));
        }
        if !self.uses(Effect::Diffuse) && !self.uses(Effect::Specular) {
            return lit_by;
        }
        for (index, light) in (0_u32..).zip(self.scene.lights()) {
            let Some(towards) = site.towards(light) else { continue };
            let (mut scattered, mut mirrored) = (S::Unit::ZERO, S::Unit::ZERO);
            if self.uses(Effect::Diffuse) {
                scattered = diffuse::weight(material, &towards);
            }
            if self.uses(Effect::Specular) {
                mirrored = specular::weight(material, site, &towards);
            }
            let [own_red, own_green, own_blue] = color.to_array();
            let [red, green, blue] = light.strength;
            // The strength last: it may be large.
            let channel =
                |own: S::Unit, strength: S| S::times(own.times(scattered).plus(mirrored).times(weight), strength);
            let light_of = [channel(own_red, red), channel(own_green, green), channel(own_blue, blue)];
            if Color::<S>::from(light_of) == Color::BLACK
                || self.uses(Effect::Shadows) && shadow::is_shadowed(self, site, index, &towards, context)
            {
                continue;
            }
            lit_by |= 1_u32.checked_shl(index).unwrap_or(0);
            gathered.gather(light_of);
        }
        lit_by
    }

    /// The secondary rays of a shading point: mirrored and refracted.
    fn onward(
        &self,
        segment: &Segment<S>,
        material: &Material<S>,
        site: &ShadingPoint<'_, S>,
        place: &Place<'_, S>,
        media: Media<'_, S>,
        weight: S::Unit,
    ) -> [Option<Segment<S>>; 2] {
        let mut onward = [None, None];
        if segment.depth >= DEPTH {
            return onward;
        }
        let weight = S::unit_real(weight);
        let mut mirror = S::Real::ZERO;
        let mut cause = Effect::Refraction;
        if self.uses(Effect::Reflection) && material.mirror > S::ZERO {
            (mirror, cause) = (reflection::weight(material), Effect::Reflection);
        }
        let [mirrored, refracted] = &mut onward;
        if self.uses(Effect::Refraction) && material.transmits() {
            let crossing = place.seen.hit.crossing;
            let split = refraction::split(material, site, crossing, media);
            mirror = mirror + split.reflected;
            if let Some(through) = split.through
                && let Some(weight) = stored::<S>(weight * split.passing)
            {
                // A ray that only touches stays on the same side.
                let passes = crossing != Crossing::Touch;
                *refracted = site.ray(through).map(|ray| Segment {
                    ray,
                    passage: segment.passage.at(place, passes, &segment.ray, self.scene),
                    weight,
                    depth: segment.depth + 1,
                    cause: Some(Effect::Refraction),
                    enclosed: if split.changes_medium { media.is_enclosed() } else { segment.enclosed },
                });
            }
        }
        if mirror > S::Real::ZERO
            && let Some(weight) = stored::<S>(weight * mirror)
        {
            *mirrored = site.ray(reflection::direction(site)).map(|ray| Segment {
                ray,
                passage: *site.near,
                weight,
                depth: segment.depth + 1,
                cause: Some(cause),
                enclosed: segment.enclosed,
            });
        }
        onward
    }
}

/// The ray from a point at `t` on, in the same direction and in what is left of its range; `None` beyond the budget.
fn continued<S: Scalar>(ray: &Ray<S>, point: Vec3<S>, t: S) -> Option<Ray<S>> {
    let (onward, end) = (Ray::new(point, ray.direction()).ok()?, ray.range().end());
    let left = if end < Range::FORWARD.end() { end.minus(t) } else { end };
    Some(onward.with_range(Range::new(S::ZERO, left).unwrap_or(Range::FORWARD)))
}

/// A weight as it is stored, at most 1; `None` if it rounds to zero.
fn stored<S: Scalar>(weight: S::Real) -> Option<S::Unit> {
    let weight = S::unit_round(weight);
    let weight = if weight < S::Unit::ONE { weight } else { S::Unit::ONE };
    (weight > S::Unit::ZERO).then_some(weight)
}
