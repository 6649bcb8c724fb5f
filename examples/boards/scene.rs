//! The picture that all boards draw: three solids on the ground, in daylight with shadows, 160 by 128 pixels.

use raylet::effect::{Ambient, Diffuse, Shadows};
use raylet::{
    Camera, Color, Cone, Cylinder, Fast, Frame, Light, Material, Object, Picture, Plane, Scalar, Scene, Shape, Size,
    Sphere, Vec3,
};

/// Columns and rows of the display, in landscape.
pub const SIZE: Size = Size::new(160, 128);

/// The program has code for these solids alone, in the tier `Fast`.
type Kinds<S> = (Sphere<S>, Plane<S>, Cylinder<S>, Cone<S>, Frame<S>);
/// What the scene calls for.
type Shaded = (Ambient, Diffuse, Shadows);

/// Hands over the picture. `None` if the number type does not hold the scene, whose numbers go up to 45.
pub fn with_picture<S: Scalar, A>(then: impl FnOnce(&Picture<'_, S, Shaded, Fast, Kinds<S>>) -> A) -> Option<A> {
    let number = |value| S::from_f64(value).ok();
    let point = |x, y, z| Vec3::from_f64([x, y, z]).ok();
    let at = |x, y, z| Frame::at(point(x, y, z)?).ok();
    let ball = Sphere::new(number(0.75)?).ok()?;
    let can = Cylinder::capped(number(0.5)?, number(1.5)?).ok()?;
    let bucket = Cone::frustum(number(0.75)?, number(0.25)?, number(1.25)?).ok()?;
    let objects = [
        Object::new(Shape::of(Plane::new()), 0),
        Object::new(Shape::of(ball).placed(at(-1.5, 0.75, 0.0)?), 1),
        Object::new(Shape::of(can).placed(at(0.25, 0.0, -0.75)?), 2),
        Object::new(Shape::of(bucket).placed(at(1.75, 0.0, 0.25)?), 3),
    ];
    let materials = [[0.75, 0.75, 0.7], [0.9, 0.45, 0.25], [0.4, 0.6, 0.8], [0.6, 0.75, 0.4]]
        .map(|color| Material::matte(Color::from_f64(color)));
    let lights = [Light::new(point(4.0, 7.0, 5.0)?, number(0.9)?)];
    let (eye, target, up) = (point(0.0, 2.5, 6.0)?, point(0.0, 0.5, 0.0)?, point(0.0, 1.0, 0.0)?);
    let camera = Camera::new(eye, target, up, number(36.0)?).ok()?;
    let scene = Scene::new(&objects, &materials, &lights, camera).ok()?;
    let scene = scene.with_ambient(Color::from_f64([0.15; 3])).with_background(Color::from_f64([0.5, 0.7, 0.9]));
    Some(then(&Picture::leaving_out(&scene.at_tier(), SIZE)))
}
