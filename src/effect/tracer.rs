//! The tracer: what a ray sees in a scene, with the effects that are compiled in and in use.

use super::called_for::{EffectError, missing};
use super::compiled::{All, Effects};
use super::cutoff::brightest;
use super::media::{self, Passage};
use super::set::{Effect, EffectSet};
use super::trace_context::TraceContext;
use super::{Sample, outline, reflection, refraction};
use crate::hit::Crossing;
use crate::ray::{Range, Ray};
use crate::scalar::{Ring, Scalar};
use crate::scene::{Balls, Candidates, Levels, Observer, Scene, SceneHit};
use crate::shape::kinds::{self, Kinds};
use crate::tier::{Stable, Tier};
use core::marker::PhantomData;

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
    pub(super) scene: &'a Scene<'a, S, T, K>,
    /// The effects in use: needed by the scene, compiled in, and not switched off.
    pub(super) active: EffectSet,
    /// Upper bound of the radiance of any ray, for each channel.
    pub(super) brightest: [S::Real; 3],
    pub(super) uncut: bool,
    /// The transparent solids around the camera.
    pub(super) around_camera: Passage,
    balls: Balls,
    compiled: PhantomData<E>,
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
        let (around_camera, balls) = (Passage::new(), Balls::of(scene));
        let mut tracer = Self { scene, active, brightest, uncut: false, around_camera, balls, compiled: PhantomData };
        if refracts && let Ok(ray) = Ray::new(scene.camera().position(), scene.camera().forward()) {
            tracer.around_camera = tracer.around(&ray);
        }
        tracer
    }

    /// What is known of a ray that begins a path: the transparent solids that it starts inside of.
    pub(super) fn around(&self, ray: &Ray<S>) -> Passage {
        let (mut passage, ray) = (Passage::new(), ray.without_departure().with_range(Range::FORWARD));
        for (index, object) in (0_u32..).zip(self.scene.objects()) {
            if media::is_tracked(self.scene, index)
                && object.shape.nearest_at::<T>(&ray).is_some_and(|hit| hit.crossing == Crossing::Exit)
            {
                passage.enter(index);
            }
        }
        passage
    }

    /// The same tracer with only those of its effects that are in the set. The others are switched off: without shading
    /// surfaces are black, without reflection and refraction mirrors and glass show only their own shading, without
    /// textures the material's colour, and so on.
    #[must_use]
    pub fn only(self, effects: EffectSet) -> Self {
        Self { active: self.active.intersection(effects), ..self }
    }

    /// The same tracer without the cut-off: it casts every ray down to the sixteenth level, however small its weight.
    /// For tests and measurements.
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

    /// True if this tracer is the other one but for the objects of its scene.
    pub(crate) fn differs_only_in_objects(&self, other: &Tracer<'_, S, E, T, K>) -> bool {
        (self.active, self.uncut) == (other.active, other.uncut) && self.scene.differs_only_in_objects(other.scene)
    }

    /// True if the effect is in use. For an effect that is not compiled in this is a constant, and the compiler removes
    /// the code that depends on it.
    #[inline(always)]
    pub(crate) fn uses(&self, effect: Effect) -> bool {
        E::SET.contains(effect) && self.active.contains(effect)
    }

    /// True if rays may start at surfaces.
    pub(crate) fn sends_rays(&self) -> bool {
        [Effect::Shadows, Effect::Reflection, Effect::Refraction].into_iter().any(|effect| self.uses(effect))
    }

    /// True if no light may shine on a surface beside a pixel of it, but not on that pixel.
    pub(crate) fn is_lit_by_all(&self, lit_by: u32) -> bool {
        lit_by.count_ones() as usize == self.scene.lights().len()
    }

    /// What a ray sees: the radiance from the nearest surface, with reflection and refraction, or that of the
    /// background.
    ///
    /// Rays and tests are counted in `context`. A ray whose light could not change the colour's eight-bit
    /// level is not cast; see [`effect`](crate::effect#the-cut-off).
    pub fn look<O: Observer>(&self, ray: &Ray<S>, context: &mut TraceContext<O>) -> Sample<S> {
        self.gather(ray, self.candidates(ray), Levels::Srgb, context).sample()
    }

    /// The balls around the objects.
    pub(crate) const fn balls(&self) -> &Balls {
        &self.balls
    }

    /// The objects that a ray may meet. A picture has the same bits with these alone as with all, but for hits that
    /// `Plain` and `Fast` may invent far away from an object.
    #[inline(never)]
    pub(crate) fn candidates(&self, ray: &Ray<S>) -> Candidates {
        self.balls.met_by(ray, self.scene.camera().position())
    }

    /// True if there is an edge between what a ray sees, whose first hit is `on`, and what the ray `beside` it sees.
    pub(crate) fn sees_edge<O: Observer>(
        &self,
        [ray, beside]: [&Ray<S>; 2],
        on: Option<SceneHit<S>>,
        context: &mut TraceContext<O>,
    ) -> bool {
        context.counters.outline_rays += 1;
        let other = self.scene.seen_for(beside, &mut context.counters, &mut context.observer);
        outline::is_edge(self.scene, [ray, beside], [on, other])
    }
}
