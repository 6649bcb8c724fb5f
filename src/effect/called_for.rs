//! Which effects a scene needs, and the error if one of them is not compiled in.

use super::set::{Effect, EffectSet};
use crate::scalar::Scalar;
use crate::scene::{Color, Material, Object, Scene};
use crate::shape::kinds::Kinds;
use crate::tier::Tier;
use core::fmt;

/// Which effects a scene needs. This is determined once, before the first ray.
impl<S: Scalar, T: Tier<S>, K: Kinds> Scene<'_, S, T, K> {
    /// The effects that the scene needs for its materials, lights, fog and outline. [`Effect::Antialiasing`] is never
    /// among them: it depends on the picture's [`Size`](crate::Size).
    ///
    /// ```
    /// # use raylet::{Camera, Color, Light, Material, Object, Plane, Scene, Shape, Vec3};
    /// # let y = Vec3::new(0.0_f32, 1.0, 0.0);
    /// # let camera = Camera::new(Vec3::new(0.0, 1.0, 5.0), Vec3::ZERO, y, 40.0)?;
    /// let objects = [Object::new(Shape::new(Plane::new()), 0)];
    /// let materials = [Material::matte(Color::WHITE).with_mirror(0.5)];
    /// let lights = [Light::new(Vec3::new(0.0, 9.0, 0.0), 1.0)];
    /// let scene = Scene::new(&objects, &materials, &lights, camera)?;
    /// assert_eq!(scene.effects().to_string(), "diffuse, shadows, reflection");
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn effects(&self) -> EffectSet {
        let of_objects = self.objects().iter().map(|object| self.called_for_by(object));
        let own = [(Effect::Fog, self.has_fog()), (Effect::Outline, self.has_outline())];
        let own = own.into_iter().filter_map(|(effect, called_for)| called_for.then_some(effect));
        of_objects.fold(own.collect(), EffectSet::union)
    }

    /// The effects that the object of this index needs on any of its parts; the empty set beyond the last object.
    ///
    /// | effect | is needed for |
    /// |---|---|
    /// | ambient | `diffuse` above 0, if there is ambient light |
    /// | diffuse | `diffuse` above 0, if any light is stronger than 0 |
    /// | specular | `specular` above 0, if any light is stronger than 0 |
    /// | shadows | diffuse or specular |
    /// | reflection | `mirror` above 0 |
    /// | refraction | `transmittance` above 0 |
    /// | texture | a material with a texture |
    /// | bump | waves with a slope and a number above 0 |
    ///
    /// The materials of base and top are included, whether or not the shape has these parts.
    pub fn effects_of(&self, object: u32) -> EffectSet {
        self.object(object).map_or(EffectSet::EMPTY, |object| self.called_for_by(object))
    }

    fn called_for_by(&self, object: &Object<S, K>) -> EffectSet {
        let of = |index: u32| self.materials().get(index as usize).map_or(EffectSet::EMPTY, |m| self.called_for_on(m));
        let mut effects = of(object.material);
        for other in [object.base, object.top] {
            if other != object.material {
                effects = effects.union(of(other));
            }
        }
        effects
    }

    fn called_for_on(&self, material: &Material<S>) -> EffectSet {
        let lit = self.lights().iter().any(|light| light.strength.iter().any(|strength| *strength > S::ZERO));
        let diffuse = lit && material.diffuse > S::ZERO;
        let specular = lit && material.specular > S::ZERO;
        [
            (Effect::Ambient, self.ambient() != Color::BLACK && material.diffuse > S::ZERO),
            (Effect::Diffuse, diffuse),
            (Effect::Specular, specular),
            (Effect::Shadows, diffuse || specular),
            (Effect::Reflection, material.mirror > S::ZERO),
            (Effect::Refraction, material.transmits()),
            (Effect::Texture, material.texture.is_some()),
            (Effect::Bump, material.bump.is_some_and(|waves| waves.are_visible())),
        ]
        .into_iter()
        .filter_map(|(effect, called_for)| called_for.then_some(effect))
        .collect()
    }

    fn has_fog(&self) -> bool {
        self.fog().is_some_and(crate::scene::Fog::is_visible)
    }

    fn has_outline(&self) -> bool {
        self.outline().is_some_and(|outline| outline.width > 0)
    }
}

/// The first effect that a scene needs and that is not in the set, with the object that needs it.
pub(crate) fn missing<S: Scalar, T: Tier<S>, K: Kinds>(
    scene: &Scene<'_, S, T, K>,
    compiled: EffectSet,
) -> Result<(), EffectError> {
    for (index, object) in (0_u32..).zip(scene.objects()) {
        if let Some(effect) = scene.called_for_by(object).difference(compiled).iter().next() {
            return Err(EffectError::Object { effect, object: index });
        }
    }
    if scene.has_fog() && !compiled.contains(Effect::Fog) {
        return Err(EffectError::Fog);
    }
    if scene.has_outline() && !compiled.contains(Effect::Outline) {
        return Err(EffectError::Outline);
    }
    Ok(())
}

/// A scene needs an effect that is not compiled in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum EffectError {
    /// An object's material needs an effect.
    Object {
        /// The effect; the first in order, if several are missing.
        effect: Effect,
        /// Index of the object.
        object: u32,
    },
    /// The scene is in fog, and fog is not compiled in.
    Fog,
    /// The scene has an outline, and outline is not compiled in.
    Outline,
    /// The picture's size has several samples for each pixel, and antialiasing is not compiled in.
    Antialiasing {
        /// The samples along each side of a pixel.
        samples: u8,
    },
}

impl EffectError {
    /// The effect that is missing.
    pub const fn effect(self) -> Effect {
        match self {
            Self::Object { effect, .. } => effect,
            Self::Fog => Effect::Fog,
            Self::Outline => Effect::Outline,
            Self::Antialiasing { .. } => Effect::Antialiasing,
        }
    }
}

impl fmt::Display for EffectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Object { effect, object } => write!(f, "object {object} calls for {effect}")?,
            Self::Fog => f.write_str("the scene's fog calls for fog")?,
            Self::Outline => f.write_str("the scene's outline calls for outline")?,
            Self::Antialiasing { samples } => {
                write!(f, "the size of {samples} x {samples} samples a pixel calls for antialiasing")?;
            }
        }
        write!(f, ", which is not compiled in: name `{:?}` among the effects", self.effect())
    }
}

impl core::error::Error for EffectError {}
