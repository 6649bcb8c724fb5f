//! A scene that calls for a set of effects.

use raylet::effect::{Effect, EffectSet};
use raylet::scalar::UnitScalar;
use raylet::scene::{SceneError, Waves};
use raylet::{
    Camera, Color, Cone, Cylinder, Fog, Frame, Light, Material, Object, Outline, Plane, Scalar, Scene, Shape, Sphere,
    Texture, Vec3,
};

/// A ball, a can and a cone on a plane, whose materials call for a set of effects.
#[derive(Debug)]
pub struct Stage<S: Scalar> {
    effects: EffectSet,
    objects: [Object<S>; 4],
    /// Of the plane, and of what stands on it.
    materials: [Material<S>; 2],
    lights: [Light<S>; 2],
    textures: [Texture<'static, S>; 1],
    fog: Fog<S>,
    camera: Camera<S>,
}

impl<S: Scalar> Stage<S> {
    /// The scene that calls for these effects; `None` if the number type cannot hold it.
    pub fn calling_for(effects: EffectSet) -> Option<Self> {
        let point = |x, y, z| Vec3::from_f64([x, y, z]).ok();
        let number = |value| S::from_f64(value).ok();
        let standing = |shape: Shape<S>, x, z| Some(Object::new(shape.placed(Frame::at(point(x, 0.0, z)?).ok()?), 1));
        let objects = [
            Object::new(Shape::new(Plane::new()), 0),
            Object::new(Shape::new(Sphere::new(number(0.8)?).ok()?).placed(Frame::at(point(-1.2, 0.8, 0.6)?).ok()?), 1),
            standing(Shape::new(Cylinder::capped(number(0.6)?, number(1.4)?).ok()?), 0.6, -0.8)?,
            standing(Shape::new(Cone::capped(number(0.6)?, number(1.2)?).ok()?), 1.5, 0.9)?,
        ];
        let lit = effects.contains(Effect::Diffuse) || effects.contains(Effect::Specular);
        let strength = number(if lit { 0.7 } else { 0.0 })?;
        let lights =
            [([-5.0, 8.0, 6.0]), ([4.0, 6.0, 7.0])].map(|at| Some(Light::new(Vec3::from_f64(at).ok()?, strength)));
        let [first, second] = lights;
        let mut materials = [Material::matte(Color::from_f64([0.8, 0.7, 0.6])); 2];
        for material in &mut materials {
            let scatters = effects.contains(Effect::Ambient) || effects.contains(Effect::Diffuse);
            material.diffuse = number(if scatters { 0.8 } else { 0.0 })?;
            if effects.contains(Effect::Specular) {
                *material = material.with_highlight(number(0.4)?, number(20.0)?);
            }
            if effects.contains(Effect::Texture) {
                *material = material.with_texture(0);
            }
            if effects.contains(Effect::Bump) {
                *material = material.with_bump(Waves { along_u: 4, along_v: 4, slope: number(0.3)? });
            }
        }
        let [_, solid] = &mut materials;
        if effects.contains(Effect::Reflection) {
            *solid = solid.with_mirror(number(0.3)?);
        }
        if effects.contains(Effect::Refraction) {
            *solid = solid.with_refraction(number(0.5)?, number(1.5)?);
        }
        let [light, dark] = [[0.9, 0.9, 0.8], [0.3, 0.3, 0.4]].map(Color::from_f64);
        Some(Self {
            effects,
            objects,
            materials,
            lights: [first?, second?],
            textures: [Texture::Checker { columns: 4, rows: 4, colors: [light, dark] }],
            fog: Fog::new(light, S::Unit::from_f64(0.97)),
            camera: Camera::new(point(0.0, 2.6, 7.0)?, point(0.0, 0.6, 0.0)?, point(0.0, 1.0, 0.0)?, number(32.0)?)
                .ok()?,
        })
    }

    /// The scene in its two lights.
    ///
    /// # Errors
    ///
    /// [`SceneError`] if the lists do not fit together.
    pub fn scene(&self) -> Result<Scene<'_, S>, SceneError> {
        self.in_lights(&self.lights)
    }

    /// The scene in the first light.
    ///
    /// # Errors
    ///
    /// As of [`Stage::scene`].
    pub fn in_one_light(&self) -> Result<Scene<'_, S>, SceneError> {
        self.in_lights(self.lights.split_at(1).0)
    }

    fn in_lights<'a>(&'a self, lights: &'a [Light<S>]) -> Result<Scene<'a, S>, SceneError> {
        let scene = Scene::new(&self.objects, &self.materials, lights, self.camera)?;
        let scene = scene.with_background(Color::from_f64([0.2, 0.3, 0.5])).with_textures(&self.textures)?;
        let ambient = if self.effects.contains(Effect::Ambient) { Color::from_f64([0.1; 3]) } else { Color::BLACK };
        let scene = scene.with_ambient(ambient);
        let scene = if self.effects.contains(Effect::Fog) { scene.with_fog(self.fog) } else { scene };
        let outlined = self.effects.contains(Effect::Outline);
        Ok(if outlined { scene.with_outline(Outline::new(Color::BLACK)) } else { scene })
    }

    /// Samples along each side of a pixel.
    pub fn samples(&self) -> u8 {
        if self.effects.contains(Effect::Antialiasing) { 2 } else { 1 }
    }
}
