//! Tracing of a ray and its secondary rays.

use super::called_for::{EffectError, missing};
use super::compiled::{All, Effects};
use super::cutoff::{self, DEPTH, brightest};
use super::set::{Effect, EffectSet};
use super::shading_point::ShadingPoint;
use super::trace_context::TraceContext;
use super::{Sample, ambient, bump, diffuse, fog, outline, reflection, refraction, shadow, specular, texture};
use crate::hit::Crossing;
use crate::ray::Ray;
use crate::scalar::{Ring, Scalar};
use crate::scene::{Color, Levels, Material, Observer, Scene, SceneHit, Waves};
use crate::shape::Surface;
use crate::shape::kinds::{self, Kinds};
use crate::tier::{Stable, Tier};
use core::marker::PhantomData;

/// Rays of a smaller weight than this power of two are deferred.
const FAINT: i32 = -7;

/// Computes what rays see in a scene, with the effects `E` compiled in, in the scene's accuracy tier `T`.
///
/// ```
/// # use raylet::{Camera, Color, Light, Material, Object, Ray, Scene, Shape, Sphere, Tracer, UnitVec3, Vec3};
/// # use raylet::TraceContext;
/// # use raylet::effect::{Diffuse, Shadows};
/// # let y = Vec3::new(0.0_f32, 1.0, 0.0);
/// # let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, y, 40.0)?;
/// let objects = [Object::new(Shape::new(Sphere::new(1.0_f32)?), 0)];
/// let materials = [Material::matte(Color::WHITE)];
/// let lights = [Light::new(Vec3::new(0.0, 0.0, 9.0), 0.5)];
/// let scene = Scene::new(&objects, &materials, &lights, camera)?;
/// let ray = Ray::new(Vec3::new(0.0, 0.0, 5.0), -UnitVec3::Z)?;
///
/// let tracer = Tracer::<f32, (Diffuse, Shadows)>::try_new(&scene)?;
/// assert_eq!(tracer.look(&ray, &mut TraceContext::<()>::default()).color.red, 0.5);
/// let error = Tracer::<f32, (Diffuse,)>::try_new(&scene).unwrap_err();
/// let message = "object 0 calls for shadows, which is not compiled in: name `Shadows` among the effects";
/// assert_eq!(error.to_string(), message);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Tracer<'a, S: Scalar, E = All, T = Stable, K: Kinds = kinds::All> {
    scene: &'a Scene<'a, S, T, K>,
    /// The effects in use: needed by the scene, compiled in, and not switched off.
    active: EffectSet,
    /// Upper bound of the radiance of any ray, for each channel.
    brightest: [S::Real; 3],
    uncut: bool,
    compiled: PhantomData<E>,
}

/// A ray that is to be cast, with its weight and depth.
#[derive(Clone, Copy, Debug)]
struct Segment<S: Scalar> {
    ray: Ray<S>,
    /// The fraction of its radiance that reaches the eye, in `[0, 1]`.
    weight: S::Unit,
    /// The number of surfaces on the path before it.
    depth: u8,
    /// Reflection or refraction; `None` for the primary ray.
    cause: Option<Effect>,
    /// True inside a transparent object.
    enclosed: bool,
}

/// The light that has been gathered for one primary ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gathered<S: Scalar> {
    /// The light.
    light: [S::Real; 3],
    /// The first hit of the primary ray, and the lights that reach it.
    pub(crate) first: Option<SceneHit<S>>,
    lit_by: u32,
}

impl<'a, S: Scalar, T: Tier<S>, K: Kinds> Tracer<'a, S, All, T, K> {
    /// A tracer with all effects compiled in. It uses those that the scene needs.
    pub fn new(scene: &'a Scene<'a, S, T, K>) -> Self {
        Self::leaving_out(scene)
    }
}

impl<'a, S: Scalar, E: Effects, T: Tier<S>, K: Kinds> Tracer<'a, S, E, T, K> {
    /// A tracer with the effects `E` compiled in.
    ///
    /// # Errors
    ///
    /// [`EffectError`] if the scene needs an effect that is not among them.
    pub fn try_new(scene: &'a Scene<'a, S, T, K>) -> Result<Self, EffectError> {
        missing(scene, E::SET)?;
        Ok(Self::leaving_out(scene))
    }

    /// A tracer with the effects `E` compiled in, which leaves out any other effects that the scene needs: for instance
    /// shading without shadows, to save time.
    pub fn leaving_out(scene: &'a Scene<'a, S, T, K>) -> Self {
        let active = scene.effects().intersection(E::SET);
        let refracts = E::SET.contains(Effect::Refraction) && active.contains(Effect::Refraction);
        let brightest = if refracts {
            brightest(scene, |material| reflection::weight(material) + refraction::transmittance(material))
        } else if active.contains(Effect::Reflection) {
            brightest(scene, reflection::weight)
        } else {
            [S::Real::ZERO; 3]
        };
        Self { scene, active, brightest, uncut: false, compiled: PhantomData }
    }

    /// The same tracer with only those of its effects that are in the set. The others are switched off: without shading
    /// surfaces are black, without reflection and refraction mirrors and glass show only their own shading, without
    /// textures the material's colour, and so on.
    #[must_use]
    pub fn only(self, effects: EffectSet) -> Self {
        Self { active: self.active.intersection(effects), ..self }
    }

    /// The same tracer without the cut-off: it casts every ray down to [`DEPTH`], however small its weight. For tests
    /// and measurements.
    #[must_use]
    pub fn uncut(self) -> Self {
        Self { uncut: true, ..self }
    }

    /// The scene.
    pub const fn scene(&self) -> &'a Scene<'a, S, T, K> {
        self.scene
    }

    /// The effects in use: those that the scene needs, that are compiled in, and that are not switched off.
    pub const fn effects(&self) -> EffectSet {
        self.active
    }

    /// True if the effect is in use. For an effect that is not compiled in this is a constant, and the compiler removes
    /// the code that depends on it.
    #[inline(always)]
    pub(crate) fn uses(&self, effect: Effect) -> bool {
        E::SET.contains(effect) && self.active.contains(effect)
    }

    /// What a ray sees: the radiance from the nearest surface, with reflection and refraction, or that of the
    /// background.
    ///
    /// Rays and tests are counted in `context`. A ray whose light could not change the colour's eight-bit
    /// level is not cast; see [`effect`](crate::effect#the-cut-off).
    pub fn look<O: Observer>(&self, ray: &Ray<S>, context: &mut TraceContext<O>) -> Sample<S> {
        self.gather(ray, Levels::Srgb, context).sample()
    }

    /// True if there is an edge between what a ray sees, whose first hit is `on`, and what the ray `beside` it sees.
    pub(crate) fn sees_edge<O: Observer>(
        &self,
        [ray, beside]: [&Ray<S>; 2],
        on: Option<SceneHit<S>>,
        context: &mut TraceContext<O>,
    ) -> bool {
        context.counters.outline_rays += 1;
        let other = self.scene.nearest_for(beside, &mut context.counters, &mut context.observer);
        outline::is_edge(self.scene, [ray, beside], [on, other])
    }

    /// The light that a ray brings and its first hit; as [`Tracer::look`], with other levels for the cut-off, for
    /// displays and for sums of samples.
    #[inline(always)]
    pub(crate) fn gather<O: Observer>(
        &self,
        ray: &Ray<S>,
        levels: Levels,
        context: &mut TraceContext<O>,
    ) -> Gathered<S> {
        let mut gathered = Gathered::new();
        if self.uses(Effect::Refraction) {
            self.follow_tree(ray, &mut gathered, levels, context);
        } else if self.uses(Effect::Reflection) {
            self.follow_chain(ray, &mut gathered, levels, context);
        } else {
            self.meet(&Segment::from_eye(*ray), &mut gathered, context);
        }
        gathered
    }

    /// Upper bound of the light that rays of this weight contribute.
    fn at_most(&self, weight: S::Real) -> [S::Real; 3] {
        self.brightest.map(|brightest| weight * brightest)
    }

    /// Follows a path that does not branch, until the rest of it cannot change a level.
    ///
    /// Not inlined, so that tracing a scene without reflection does not take its stack frame.
    #[inline(never)]
    fn follow_chain<O: Observer>(
        &self,
        ray: &Ray<S>,
        gathered: &mut Gathered<S>,
        levels: Levels,
        context: &mut TraceContext<O>,
    ) {
        let mut next = Some(Segment::from_eye(*ray));
        while let Some(segment) = next {
            [next, _] = self.meet(&segment, gathered, context);
            next = next.filter(|next| {
                let left = self.at_most(S::unit_real(next.weight));
                self.uncut || !cutoff::is_settled::<S>(gathered.light, left, levels)
            });
        }
    }

    /// Follows a path that may branch at each surface, until the rest of it cannot change a level.
    ///
    /// Rays of small weight are deferred, and cast last in order of decreasing weight. Not inlined, so that tracing a
    /// scene without refraction takes no stack for the lists.
    #[inline(never)]
    fn follow_tree<O: Observer>(
        &self,
        ray: &Ray<S>,
        gathered: &mut Gathered<S>,
        levels: Levels,
        context: &mut TraceContext<O>,
    ) {
        let faint = S::unit_round(S::Real::ONE.scaled(FAINT));
        let mut waiting = heapless::Vec::<Segment<S>, { DEPTH as usize + 1 }>::new();
        let mut aside = heapless::Vec::<Segment<S>, { DEPTH as usize }>::new();
        let mut next = Some(Segment::from_eye(*ray));
        while let Some(segment) = next {
            for mut onward in self.meet(&segment, gathered, context).into_iter().flatten() {
                if onward.weight < faint && !self.uncut {
                    match aside.push(onward) {
                        Ok(()) => continue,
                        Err(no_room) => onward = no_room,
                    }
                }
                // Cannot be full: at most one ray waits for each smaller depth, and two for the current one.
                let pushed = waiting.push(onward);
                debug_assert!(pushed.is_ok());
            }
            next = waiting.pop();
            if next.is_none() {
                let weights = aside.iter().fold(S::Real::ZERO, |sum, segment| sum + S::unit_real(segment.weight));
                if !cutoff::is_settled::<S>(gathered.light, self.at_most(weights), levels) {
                    next = strongest(&mut aside);
                }
            }
        }
    }

    /// Casts a ray, gathers the light at its hit, and returns the secondary rays.
    fn meet<O: Observer>(
        &self,
        segment: &Segment<S>,
        gathered: &mut Gathered<S>,
        context: &mut TraceContext<O>,
    ) -> [Option<Segment<S>>; 2] {
        match segment.cause {
            Some(Effect::Reflection) => context.counters.reflection_rays += 1,
            Some(_) => context.counters.refraction_rays += 1,
            None => {}
        }
        let on = self.scene.nearest_for(&segment.ray, &mut context.counters, &mut context.observer);
        if segment.cause.is_none() {
            gathered.first = on;
        }
        let mut weight = S::unit_real(segment.weight);
        if self.uses(Effect::Fog) && !segment.enclosed {
            weight = self.through_fog(weight, on.map(|on| on.hit.t), gathered, context);
        }
        let Some(on) = on else {
            gathered.add(self.scene.background(), weight);
            return [None, None];
        };
        if !self.shows_surfaces() {
            return [None, None];
        }
        let Some(object) = self.scene.object(on.object) else { return [None, None] };
        let Some(material) = self.scene.material_of(object, on.hit.part) else { return [None, None] };
        if !self.is_seen(material) {
            return [None, None];
        }
        context.counters.hits_refined += 1;
        let surface = object.shape.surface(&segment.ray, &on.hit);
        let mut site = ShadingPoint::new(self.scene, object, &surface, &segment.ray, &on);
        let color = self.dress(material, &surface, &mut site, context);
        let lit_by = self.shade(material, color, &site, weight, gathered, context);
        if segment.cause.is_none() {
            gathered.lit_by = lit_by;
        }
        self.onward(segment, material, &site, on.hit.crossing, weight)
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

    /// Adds the light of the fog along a ray, and returns the weight of what is behind it.
    fn through_fog<O: Observer>(
        &self,
        weight: S::Real,
        t: Option<S>,
        gathered: &mut Gathered<S>,
        context: &mut TraceContext<O>,
    ) -> S::Real {
        let Some(haze) = self.scene.fog() else { return weight };
        context.counters.fogged_rays += 1;
        let visible = weight * fog::visibility(haze, t);
        gathered.add(haze.color(), weight - visible);
        visible
    }

    /// The colour of the surface at a shading point, and its normal after bump mapping. Surface coordinates are
    /// computed once, and only if there is a texture or a bump map.
    fn dress<O: Observer>(
        &self,
        material: &Material<S>,
        surface: &Surface<S, K>,
        site: &mut ShadingPoint<S>,
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
        site: &ShadingPoint<S>,
        weight: S::Real,
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
            let (mut scattered, mut mirrored) = (S::Real::ZERO, S::Real::ZERO);
            if self.uses(Effect::Diffuse) {
                scattered = diffuse::weight(material, &towards);
            }
            if self.uses(Effect::Specular) {
                mirrored = specular::weight(material, site, &towards);
            }
            let [own_red, own_green, own_blue] = color.to_array();
            let [red, green, blue] = light.strength;
            let channel =
                |own: S::Unit, strength: S| (S::unit_real(own) * scattered + mirrored) * strength.real() * weight;
            let light_of = [channel(own_red, red), channel(own_green, green), channel(own_blue, blue)];
            if Color::<S>::from(light_of.map(S::unit_round)) == Color::BLACK
                || self.uses(Effect::Shadows) && shadow::is_shadowed(self.scene, site, index, &towards, context)
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
        site: &ShadingPoint<S>,
        crossing: Crossing,
        weight: S::Real,
    ) -> [Option<Segment<S>>; 2] {
        let mut onward = [None, None];
        if segment.depth >= DEPTH {
            return onward;
        }
        let mut mirror = S::Real::ZERO;
        let mut cause = Effect::Refraction;
        if self.uses(Effect::Reflection) && material.mirror > S::ZERO {
            (mirror, cause) = (reflection::weight(material), Effect::Reflection);
        }
        let [mirrored, refracted] = &mut onward;
        if self.uses(Effect::Refraction) && material.transmits() {
            let split = refraction::split(material, site, crossing);
            mirror = mirror + split.reflected;
            if let Some(through) = split.through
                && let Some(weight) = stored::<S>(weight * split.passing)
            {
                // A ray that only touches stays on the same side.
                let passes = crossing != Crossing::Touch;
                *refracted = site.ray(through, passes).map(|ray| Segment {
                    ray,
                    weight,
                    depth: segment.depth + 1,
                    cause: Some(Effect::Refraction),
                    enclosed: if split.changes_medium { site.from_outside } else { segment.enclosed },
                });
            }
        }
        if mirror > S::Real::ZERO
            && let Some(weight) = stored::<S>(weight * mirror)
        {
            *mirrored = site.ray(reflection::direction(site), false).map(|ray| Segment {
                ray,
                weight,
                depth: segment.depth + 1,
                cause: Some(cause),
                enclosed: segment.enclosed,
            });
        }
        onward
    }
}

/// A weight as it is stored, at most 1; `None` if it rounds to zero.
fn stored<S: Scalar>(weight: S::Real) -> Option<S::Unit> {
    use crate::scalar::UnitScalar;
    let weight = S::unit_round(weight);
    let weight = if weight < S::Unit::ONE { weight } else { S::Unit::ONE };
    (weight > S::Unit::ZERO).then_some(weight)
}

/// Takes the ray of the largest weight out of a list.
fn strongest<S: Scalar, const N: usize>(aside: &mut heapless::Vec<Segment<S>, N>) -> Option<Segment<S>> {
    let last = aside.pop()?;
    let mut strongest = None;
    let mut weight = last.weight;
    for segment in aside.iter_mut() {
        if segment.weight > weight {
            weight = segment.weight;
            strongest = Some(segment);
        }
    }
    Some(match strongest {
        Some(segment) => core::mem::replace(segment, last),
        None => last,
    })
}

impl<S: Scalar> Segment<S> {
    fn from_eye(ray: Ray<S>) -> Self {
        use crate::scalar::UnitScalar;
        Self { ray, weight: S::Unit::ONE, depth: 0, cause: None, enclosed: false }
    }
}

impl<S: Scalar> Gathered<S> {
    fn new() -> Self {
        Self { light: [S::Real::ZERO; 3], first: None, lit_by: 0 }
    }

    fn gather(&mut self, light: [S::Real; 3]) {
        for (sum, light) in self.light.iter_mut().zip(light) {
            *sum = *sum + light;
        }
    }

    fn add(&mut self, color: Color<S>, weight: S::Real) {
        self.gather(color.to_array().map(|channel| S::unit_real(channel) * weight));
    }

    pub(crate) fn sample(&self) -> Sample<S> {
        Sample {
            color: self.light.map(S::unit_round).into(),
            seen: self.first.map(|on| (on.object, on.hit.part)),
            lit_by: self.lit_by,
        }
    }
}

#[cfg(units)]
#[path = "../../tests/units/effect/tracer.rs"]
mod tests;
