//! A ball that bounces past three posts, on the display of `turntable`: only the rows that may have changed are drawn.
//!
//! In the tier `Fast`, and with code for these primitives alone.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::pixelcolor::Rgb565;
use raylet::effect::{Ambient, Diffuse, Shadows};
use raylet::scalar::{Real, Ring};
use raylet::scene::Observer;
use raylet::tier::Fast;
use raylet::{
    Camera, Color, Cylinder, Frame, Light, Material, Object, Picture, Plane, Scalar, Scene, Shape, Size, Sphere,
    TraceContext, Vec3,
};

use crate::turntable::{HEIGHT, Line, WIDTH, show_rows};

/// Frames until the ball is back.
pub const FRAMES: u8 = 32;
/// Frames from one bounce to the next.
const HOP: u8 = 8;

/// What the program has code for.
pub type Kinds<S> = (Sphere<S>, Plane<S>, Cylinder<S>, Frame<S>);
/// What the scene calls for.
pub type Shaded = (Ambient, Diffuse, Shadows);
/// Its pictures.
pub type Drawn<'a, S> = Picture<'a, S, Shaded, Fast, Kinds<S>>;

/// What the scene of a frame borrows.
#[derive(Debug)]
pub struct Stage<S: Scalar> {
    objects: [Object<S, Kinds<S>>; 5],
    materials: [Material<S>; 3],
    lights: [Light<S>; 1],
    camera: Camera<S>,
}

impl<S: Scalar> Stage<S> {
    /// That of a frame; frames repeat after [`FRAMES`]. `None` if the number type does not hold its numbers, which go
    /// up to 32.
    pub fn of(frame: u8) -> Option<Self> {
        let number = |value| S::from_f64(value).ok();
        let point = |x, y, z| Vec3::from_f64([x, y, z]).ok();
        let post = |radius, height, x, z| {
            let post = Cylinder::capped(number(radius)?, number(height)?).ok()?;
            Some(Object::new(Shape::of(post).placed(Frame::at(point(x, 0.0, z)?).ok()?), 1))
        };
        let ball = Shape::of(Sphere::new(number(0.5)?).ok()?).placed(Frame::at(place(frame)?).ok()?);
        Some(Self {
            objects: [
                Object::new(Shape::of(Plane::new()), 0),
                post(0.3, 1.2, -1.7, -1.0)?,
                post(0.4, 1.8, 0.2, -1.6)?,
                post(0.3, 0.8, 1.8, -0.8)?,
                Object::new(ball, 2),
            ],
            materials: [[0.75, 0.75, 0.7], [0.4, 0.6, 0.8], [0.9, 0.45, 0.25]]
                .map(|color| Material::matte(Color::from_f64(color))),
            lights: [Light::new(point(3.0, 7.0, 5.0)?, number(0.9)?)],
            camera: Camera::new(point(0.0, 3.0, 9.0)?, point(0.0, 0.8, 0.0)?, point(0.0, 1.0, 0.0)?, number(32.0)?)
                .ok()?,
        })
    }

    /// The scene.
    ///
    /// # Panics
    ///
    /// Never: the lists fit together.
    pub fn scene(&self) -> Scene<'_, S, Fast, Kinds<S>> {
        let scene = Scene::new(&self.objects, &self.materials, &self.lights, self.camera);
        let scene = scene.expect("the lists are those of a stage");
        scene.with_ambient(Color::from_f64([0.15; 3])).with_background(Color::from_f64([0.5, 0.7, 0.9])).at_tier()
    }
}

/// Where the ball is: it hops from left to right and back.
fn place<S: Scalar>(frame: u8) -> Option<Vec3<S>> {
    let frame = frame % FRAMES;
    let across = frame.min(FRAMES - frame);
    let shares = |n: u8, of: u8| S::Real::from_int(n.into()) / S::Real::from_int(of.into());
    let [left, width, radius, hop] = [-2.0, 4.0, 0.5, 4.4].map(|value| S::from_f64(value).ok());
    let x = left?.real() + width?.real() * shares(across, FRAMES / 2);
    // A parabola: 4 h u (1 - u).
    let rise = hop?.real() * shares(frame % HOP, HOP) * shares(HOP - frame % HOP, HOP);
    Some(Vec3::new(S::round(x), S::round(radius?.real() + rise), S::round(S::Real::ONE)))
}

/// The picture of a frame.
pub fn picture<'a, S: Scalar>(scene: &'a Scene<'a, S, Fast, Kinds<S>>) -> Drawn<'a, S> {
    Picture::leaving_out(scene, Size::new(WIDTH, HEIGHT))
}

/// Draws the rows of a frame that may differ from the frame before, and returns how many.
///
/// # Errors
///
/// The first error of the display.
pub fn show_changed<S: Scalar, O: Observer, D: DrawTarget<Color = Rgb565>>(
    [now, before]: [&Drawn<'_, S>; 2],
    line: &mut Line,
    context: &mut TraceContext<O>,
    display: &mut D,
) -> Result<u16, D::Error> {
    show_rows(now, now.changed_rows(before), line, context, display)
}
