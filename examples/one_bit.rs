//! A display of 128 by 64 pixels, each on or off (SSD1306): white things on a white floor. A line around each tells
//! them apart, and dark pixels here and there tell which of them are round. In fixed point; the only memory is the
//! display's.

use fixed::types::I16F16;
use raylet::effect::{self, Ambient, Diffuse};
use raylet::{
    Camera, Capsule, Color, Cone, Cuboid, Cylinder, Frame, Light, Material, Object, Outline, Picture, Plane, Scene,
    Shape, Size, Sphere, UnitVec3, Vec3,
};

const WIDTH: usize = 128;
const HEIGHT: usize = 64;
/// The thresholds of ordered dithering (Bayer 1973), in sixteenths of white.
const BAYER: [[u16; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

fn number(value: f64) -> I16F16 {
    I16F16::from_num(value)
}

fn point(x: f64, y: f64, z: f64) -> Vec3<I16F16> {
    Vec3::new(number(x), number(y), number(z))
}

/// The memory of the display: a byte is eight pixels one below the other, a page a row of bytes.
pub type Pages = [[u8; WIDTH]; HEIGHT / 8];

/// The picture.
///
/// # Errors
///
/// None here: every size is positive, and every number small.
pub fn draw() -> Result<Pages, raylet::Error> {
    let at = |x, y, z| Frame::at(point(x, y, z));
    let (lying, length) = Frame::between(point(0.6, 0.35, 1.5), point(1.7, 0.35, 0.9))?;
    let turned = Frame::turned_about(point(-0.4, 0.45, 0.9), UnitVec3::Y, number(35.0))?;
    let things = [
        Shape::new(Plane::new()),
        Shape::new(Cylinder::open(number(0.6), number(1.5))?).placed(at(-3.2, 0.0, -0.6)?),
        Shape::new(Sphere::new(number(0.75))?).placed(at(-1.9, 0.75, 0.6)?),
        Shape::new(Cuboid::new(number(0.55), number(0.45), number(0.4))?).placed(turned),
        Shape::new(Cone::frustum(number(0.7), number(0.0), number(1.8))?).placed(at(0.6, 0.0, -1.0)?),
        Shape::new(Capsule::new(number(0.35), length)?).placed(lying),
        Shape::new(Cylinder::capped(number(0.65), number(1.3))?).placed(at(2.6, 0.0, -0.4)?),
    ];
    // Ambient light lifts the floor to white. What stands on it scatters less, so that it keeps some shade.
    let materials = [1.0, 0.8].map(|diffuse| Material { diffuse: number(diffuse), ..Material::matte(Color::WHITE) });
    let objects = [0, 1, 2, 3, 4, 5, 6].map(|index| Object::new(things[index], u32::from(index > 0)));
    let lights = [Light::distant(UnitVec3::new(point(-0.5, 0.8, 0.6))?, number(0.7))];
    let camera = Camera::new(point(0.0, 3.6, 9.0), point(-0.2, 0.7, 0.0), point(0.0, 1.0, 0.0), number(22.0))?;
    let scene = Scene::new(&objects, &materials, &lights, camera)?
        .with_background(Color::WHITE)
        .with_ambient(Color::from_f64([0.7; 3]))
        .with_outline(Outline::new(Color::BLACK));

    // Shadows are left out: they would join the things.
    type Effects = (Ambient, Diffuse, effect::Outline);
    let picture = Picture::<_, Effects>::leaving_out(&scene, Size::new(WIDTH as u16, HEIGHT as u16));
    let mut pages = [[0; WIDTH]; HEIGHT / 8];
    picture.render(|x, y, pixel| {
        let [level, ..] = pixel.color.to_linear888();
        let is_on = u16::from(level) * 16 / 255 + BAYER[usize::from(y % 4)][usize::from(x % 4)] >= 16;
        pages[usize::from(y / 8)][usize::from(x)] |= u8::from(is_on) << (y % 8);
    });
    Ok(pages)
}

pub fn main() -> Result<(), raylet::Error> {
    let pages = draw()?;
    // Two pixels a character, upper and lower.
    for (page, row) in pages.iter().flat_map(|page| [0, 2, 4, 6].map(|row| (page, row))) {
        let pairs = page.iter().map(|byte| [" ", "▀", "▄", "█"][usize::from(byte >> row & 3)]);
        println!("{}", pairs.collect::<String>());
    }
    let on: u32 = pages.as_flattened().iter().map(|byte| byte.count_ones()).sum();
    assert!((6800..7600).contains(&on), "most of it is white, and not all: {on}");
    Ok(())
}
