//! A scene of which nothing is computed in the program: objects, materials, lights and camera are constants, in flash.
//! And the same made at run time.

use fixed::types::I16F16;
use raylet::scene::SceneError;
use raylet::{
    Camera, Capsule, Color, Cone, Cuboid, Cylinder, Error, Frame, Light, Material, Object, Picture, Plane, Scalar,
    Scene, Shape, Size, Sphere, UnitVec3, Vec3, constant,
};

/// How many objects.
pub const OBJECTS: usize = 6;

/// The lists of a scene, and its camera.
#[derive(Debug)]
pub struct Constants<S: Scalar> {
    /// A floor, and a solid of each kind in a row.
    pub objects: [Object<S>; OBJECTS],
    /// That of the floor, one that shines, one with a cap.
    pub materials: [Material<S>; 3],
    /// A lamp.
    pub lights: [Light<S>; 1],
    /// Above the floor, along -z.
    pub camera: Camera<S>,
}

/// Columns and rows of the picture.
pub const SIZE: Size = Size::new(48, 36);

/// Defines the scene in a number type, of literals in eighths.
macro_rules! scene {
    ($(#[$doc:meta])* $SCENE:ident, $S:ty, $number:expr, $unit:expr) => {
        $(#[$doc])*
        pub static $SCENE: Constants<$S> = {
            type S = $S;
            const fn point(x: i32, y: i32, z: i32) -> Vec3<S> {
                Vec3::new($number(x), $number(y), $number(z))
            }
            const fn color(red: i32, green: i32, blue: i32) -> Color<S> {
                Color::new($unit(red), $unit(green), $unit(blue))
            }
            Constants {
                objects: [
                    Object::const_new(Plane::new().into_shape(), 0),
                    Object::const_new(
                        constant!(Sphere::<S>::const_new($number(6)))
                            .into_shape()
                            .in_frame(constant!(Frame::<S>::const_at(point(-20, 6, -40)))),
                        1,
                    ),
                    Object::const_new(
                        constant!(Cylinder::<S>::const_capped($number(5), $number(12)))
                            .into_shape()
                            .in_frame(constant!(Frame::<S>::const_at(point(-7, 0, -44)))),
                        2,
                    )
                    .with_top(1),
                    Object::const_new(
                        constant!(Cone::<S>::const_frustum($number(6), $number(2), $number(14)))
                            .into_shape()
                            .in_frame(constant!(Frame::<S>::const_at(point(6, 0, -40)))),
                        1,
                    ),
                    Object::const_new(
                        constant!(Capsule::<S>::const_new($number(4), $number(10)))
                            .into_shape()
                            .in_frame(constant!(Frame::<S>::const_from_axes(
                                point(14, 4, -36),
                                // Lying along x.
                                [UnitVec3::<S>::Y.const_neg(), UnitVec3::X, UnitVec3::Z],
                            ))),
                        1,
                    ),
                    Object::const_new(
                        constant!(Cuboid::<S>::const_new($number(4), $number(4), $number(4)))
                            .into_shape()
                            .in_frame(constant!(Frame::<S>::const_at(point(2, 4, -24)))),
                        2,
                    ),
                ],
                materials: [
                    Material::matte(color(6, 6, 6)),
                    Material::matte(color(8, 4, 2)).with_highlight($number(4), $number(240)),
                    Material::matte(color(2, 4, 8)).with_mirror($number(2)),
                ],
                lights: [Light::new(point(30, 60, 10), $number(7))],
                camera: constant!(Camera::<S>::const_in_frame(
                    constant!(Frame::<S>::const_from_axes(
                        point(0, 14, 16),
                        [UnitVec3::<S>::X.const_neg(), UnitVec3::Y, UnitVec3::<S>::Z.const_neg()],
                    )),
                    $number(4),
                )),
            }
        };
    };
}

const fn single(eighths: i32) -> f32 {
    eighths as f32 / 8.0
}

const fn fixed(eighths: i32) -> I16F16 {
    I16F16::from_bits(eighths << 13)
}

const fn fixed_unit(eighths: i32) -> raylet::scalar::Unit<I16F16> {
    raylet::scalar::Unit::<I16F16>::from_bits(eighths << 27)
}

scene!(
    /// The scene in floats.
    SINGLE, f32, single, single
);
scene!(
    /// The scene in fixed point.
    FIXED, I16F16, fixed, fixed_unit
);

/// The same scene, made at run time.
///
/// # Errors
///
/// None: its values are good.
pub fn made<S: Scalar>() -> Result<Constants<S>, Error> {
    let number = |eighths: f64| S::from_f64(eighths / 8.0);
    let point = |x: f64, y: f64, z: f64| Vec3::from_f64([x / 8.0, y / 8.0, z / 8.0]);
    let color = |channels: [f64; 3]| Color::from_f64(channels.map(|channel| channel / 8.0));
    let at = |x, y, z| -> Result<_, Error> { Ok(Frame::at(point(x, y, z)?)?) };
    let lying = [-UnitVec3::Y, UnitVec3::X, UnitVec3::Z];
    let capsule = Shape::new(Capsule::new(number(4.0)?, number(10.0)?)?);
    let objects = [
        Object::new(Shape::new(Plane::new()), 0),
        Object::new(Shape::new(Sphere::new(number(6.0)?)?).placed(at(-20.0, 6.0, -40.0)?), 1),
        Object::new(Shape::new(Cylinder::capped(number(5.0)?, number(12.0)?)?).placed(at(-7.0, 0.0, -44.0)?), 2)
            .with_top(1),
        Object::new(
            Shape::new(Cone::frustum(number(6.0)?, number(2.0)?, number(14.0)?)?).placed(at(6.0, 0.0, -40.0)?),
            1,
        ),
        Object::new(capsule.placed(Frame::from_axes(point(14.0, 4.0, -36.0)?, lying)?), 1),
        Object::new(Shape::new(Cuboid::new(number(4.0)?, number(4.0)?, number(4.0)?)?).placed(at(2.0, 4.0, -24.0)?), 2),
    ];
    let materials = [
        Material::matte(color([6.0, 6.0, 6.0])),
        Material::matte(color([8.0, 4.0, 2.0])).with_highlight(number(4.0)?, number(240.0)?),
        Material::matte(color([2.0, 4.0, 8.0])).with_mirror(number(2.0)?),
    ];
    let lights = [Light::new(point(30.0, 60.0, 10.0)?, number(7.0)?)];
    let axes = [-UnitVec3::X, UnitVec3::Y, -UnitVec3::Z];
    let camera = Camera::in_frame(Frame::from_axes(point(0.0, 14.0, 16.0)?, axes)?, number(4.0)?)?;
    Ok(Constants { objects, materials, lights, camera })
}

/// A picture in a number, and how many pixels show each object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest {
    /// FNV-1a over the levels of all pixels.
    pub levels: u64,
    /// Pixels of each object.
    pub seen: [u32; OBJECTS],
}

/// The digest of the scene's picture.
///
/// # Errors
///
/// None: its indices are good.
pub fn digest<S: Scalar>(scene: &Constants<S>) -> Result<Digest, SceneError> {
    let Constants { objects, materials, lights, camera } = scene;
    let scene = Scene::new(objects, materials, lights, *camera)?;
    let mut digest = Digest { levels: 0xcbf2_9ce4_8422_2325, seen: [0; OBJECTS] };
    Picture::new(&scene, SIZE).render(|_, _, pixel| {
        for level in pixel.color.to_srgb888() {
            digest.levels = (digest.levels ^ u64::from(level)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        if let Some(count) = pixel.seen.and_then(|(object, _)| digest.seen.get_mut(object as usize)) {
            *count += 1;
        }
    });
    Ok(digest)
}
