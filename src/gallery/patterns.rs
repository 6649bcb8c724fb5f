//! Solids with different materials on base and top, with procedural textures and an image. The Neutral File Format has
//! none of these.

use super::{Stage, all, floor, matte, number, on_y, point};
use crate::scene::Coordinate;
use crate::{
    Capsule, Color, Cone, Cuboid, Cylinder, Frame, Object, Rectangle, Scalar, Shape, Sphere, Texture, UnitVec3,
};

/// A smiling face, 8 by 8.
const FACE: [[u8; 3]; 64] = {
    let rows: [&[u8; 8]; 8] =
        [b"..####..", b".######.", b"##o##o##", b"########", b"#o####o#", b"##oooo##", b".######.", b"..####.."];
    let mut pixels = [[70, 130, 200]; 64];
    let mut index = 0;
    while index < 64 {
        pixels[index] = match rows[index / 8][index % 8] {
            b'#' => [250, 210, 60],
            b'o' => [60, 30, 20],
            _ => pixels[index],
        };
        index += 1;
    }
    pixels
};

pub(super) fn build<S: Scalar>() -> Option<Stage<S>> {
    let white = matte([1.0; 3])?;
    let materials = [
        white.with_texture(0),
        white.with_texture(1).with_highlight(number(0.4)?, number(30.0)?),
        white.with_texture(2),
        white.with_texture(3),
        matte([0.85, 0.25, 0.20])?,
        white.with_texture(5),
        white.with_texture(4).with_highlight(number(0.4)?, number(30.0)?),
    ];
    let [board, globe, banded, image, red, carved, spiral] = [0, 1, 2, 3, 4, 5, 6];
    let can = on_y(Cylinder::capped(number(0.8)?, number(1.6)?).ok()?, point(-2.3, 0.0, 0.2)?, banded)?;
    let frustum = on_y(Cone::frustum(number(0.9)?, number(0.5)?, number(1.2)?).ok()?, point(2.4, 0.0, 0.0)?, spiral)?;
    let turned = Frame::between(point(-0.6, 0.42, 2.2)?, point(0.9, 0.42, 1.6)?).ok()?;
    let (lying, length) = turned;
    let pill = Object::new(Shape::new(Capsule::new(number(0.42)?, length).ok()?).placed(lying), carved);
    let coin_axis = UnitVec3::new(point(-0.5, 0.25, 1.0)?).ok()?;
    let coin = Shape::new(Cylinder::capped(number(0.6)?, number(0.12)?).ok()?);
    let coin = coin.placed(Frame::from_base_and_axis(point(2.5, 0.6, 1.8)?, coin_axis).ok()?);
    let half = number(0.38)?;
    let (forward, up) = (UnitVec3::new(point(0.5, 0.0, 1.0)?).ok()?, UnitVec3::Y);
    let die = Shape::new(Cuboid::new(half, half, half).ok()?);
    let die = die.placed(Frame::looking(point(-1.55, 0.38, 2.3)?, forward, up).ok()?);
    // A mat on the floor: z, along which the image's rows are stacked, leads away from the camera.
    let away = UnitVec3::new(point(0.15, 0.0, -1.0)?).ok()?;
    let mat = Shape::new(Rectangle::new(number(0.5)?, number(0.45)?).ok()?);
    let mat = mat.placed(Frame::looking(point(1.25, 0.02, 2.75)?, away, UnitVec3::Y).ok()?);
    let objects = [
        floor(1.5, board)?,
        can.with_top(image),
        on_y(Sphere::new(number(0.9)?).ok()?, point(0.0, 0.9, -0.4)?, globe)?,
        frustum.with_top(red),
        pill,
        Object::new(coin, red).with_top(image),
        Object::new(die, image).with_top(carved),
        Object::new(mat, image),
    ];
    let [dark, light] = [[0.25, 0.28, 0.30], [0.85, 0.83, 0.78]].map(Color::from_f64);
    // In space: the pattern continues from the side to the round ends, as if the pill were carved from it.
    let [yellow, brown] = [[0.95, 0.75, 0.2], [0.35, 0.2, 0.1]].map(Color::from_f64);
    let [blue, sand, green] = [[0.15, 0.35, 0.75], [0.9, 0.8, 0.55], [0.2, 0.6, 0.3]].map(Color::from_f64);
    let textures = [
        Texture::Checker { columns: 2, rows: 2, colors: [light, dark] },
        Texture::Checker { columns: 12, rows: 8, colors: [blue, sand] },
        Texture::Stripes { along: Coordinate::V, count: 7, colors: [light, blue] },
        Texture::Image { width: 8, height: 8, pixels: &FACE },
        Texture::Stripes { along: Coordinate::U, count: 16, colors: [green, sand] },
        Texture::Cells { counts: [3, 8, 3], colors: [yellow, brown] },
    ];
    Some(Stage {
        textures: all(textures)?,
        ..Stage::new(objects, materials, [([-6.0, 9.0, 7.0], 0.85), ([5.0, 6.0, 8.0], 0.35)])?
    })
}
