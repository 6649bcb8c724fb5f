//! The built-in scene: every solid once, on a plane.

use crate::load::Loaded;
use raylet::scene::nff::Scale;
use raylet::{
    Affine, Camera, Capsule, Color, Cone, Cylinder, Disc, Frame, Light, Material, Object, Plane, Scalar, Shape, Sphere,
    Triangle, UnitVec3, Vec3,
};
use std::error::Error;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// The still life in any number type that holds numbers up to 20.
pub(crate) fn build<S: Scalar>() -> Result<Loaded<S>> {
    let colors = [
        [0.82, 0.80, 0.76], // floor
        [0.85, 0.25, 0.20], // red
        [0.20, 0.55, 0.80], // blue
        [0.95, 0.75, 0.20], // yellow
        [0.30, 0.65, 0.35], // green
        [0.65, 0.40, 0.70], // violet
    ];
    let mut materials = Vec::new();
    for (index, color) in colors.into_iter().enumerate() {
        let matte = Material { diffuse: number(0.8)?, ..Material::matte(Color::from_f64(color)) };
        materials.push(if index == 0 { matte } else { matte.with_highlight(number(0.4)?, number(30.0)?) });
    }
    let [floor, red, blue, yellow, green, violet] = [0, 1, 2, 3, 4, 5];
    let (centred, pi) = (|x, z| point(x, 0.0, z), std::f64::consts::PI);
    let mut objects = vec![
        Object::new(Shape::new(Plane::new()), floor),
        // Back row.
        on_y(Cylinder::capped(number(0.6)?, number(2.0)?)?, centred(-3.3, -1.2)?, blue)?,
        on_y(Cone::frustum(number(0.9)?, number(0.4)?, number(1.6)?)?, centred(-1.2, -1.4)?, yellow)?,
        Object::new(
            Shape::new(Cone::capped(number(0.4)?, number(2.2)?)?)
                .placed(Frame::from_base_and_axis(point(1.0, 2.2, -1.5)?, -UnitVec3::Y)?),
            red,
        ),
        on_y(Cylinder::open(number(0.7)?, number(1.3)?)?, centred(3.1, -1.0)?, green)?,
        // Front row.
        Object::new(Shape::new(Sphere::new(number(0.7)?)?).placed(Frame::at(point(-2.2, 0.7, 0.6)?)?), red),
        Object::new(
            Shape::new(Sphere::new(number(1.0)?)?)
                .placed(Affine::stretched(Frame::at(point(-0.4, 0.4, 1.0)?)?, point(0.9, 0.4, 0.5)?)?),
            violet,
        ),
    ];
    let (lying, length) = Frame::between(point(1.2, 0.35, 1.6)?, point(2.3, 0.35, 0.5)?)?;
    objects.push(Object::new(Shape::new(Capsule::new(number(0.35)?, length)?).placed(lying), blue));
    let lean = UnitVec3::new(point(-0.25, 0.6, 0.6)?).ok_or("no direction")?;
    objects.push(Object::new(
        Shape::new(Disc::new(number(0.5)?)?).placed(Frame::from_base_and_axis(point(0.9, 0.55, 0.2)?, lean)?),
        yellow,
    ));
    // A funnel, standing on its apex.
    objects.push(on_y(Cone::open(number(0.6)?, number(0.9)?)?, point(2.1, 0.0, -0.5)?, violet)?);
    // A pyramid over a square, turned by 30 degrees.
    let (apex, mut corners) = (point(3.3, 1.0, 1.2)?, Vec::new());
    for quarter in 0..4 {
        let (sine, cosine) = (f64::from(quarter) * pi / 2.0 + pi / 6.0).sin_cos();
        corners.push(point(3.3 + 0.7 * cosine, 0.0, 1.2 - 0.7 * sine)?);
    }
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        objects.push(Object::new(Shape::new(Triangle::new(*a, *b, apex)?), green));
    }
    Ok(Loaded {
        objects,
        materials,
        lights: vec![
            Light::new(point(-6.0, 9.0, 7.0)?, number(0.85)?),
            Light::new(point(5.0, 6.0, 8.0)?, number(0.45)?),
        ],
        normals: Vec::new(),
        textures: Vec::new(),
        fog: None,
        background: Color::from_f64([0.30, 0.42, 0.55]),
        camera: Camera::new(point(0.2, 4.2, 9.0)?, point(0.2, 0.7, 0.0)?, point(0.0, 1.0, 0.0)?, number(38.0)?)?,
        resolution: [160, 120],
        invisible: 0,
        scale: Scale::ONE,
    })
}

/// A solid whose axis points up, with its base at a point.
pub(crate) fn on_y<S: Scalar>(
    primitive: impl Into<raylet::Primitive<S>>,
    base: Vec3<S>,
    material: u32,
) -> Result<Object<S>> {
    Ok(Object::new(Shape::new(primitive).placed(Frame::at(base)?), material))
}

pub(crate) fn number<S: Scalar>(value: f64) -> Result<S> {
    S::from_f64(value).ok_or_else(|| format!("{value} is beyond the number type").into())
}

pub(crate) fn point<S: Scalar>(x: f64, y: f64, z: f64) -> Result<Vec3<S>> {
    Vec3::from_f64([x, y, z]).ok_or_else(|| "a coordinate is beyond the number type".into())
}
