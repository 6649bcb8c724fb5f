//! A glass of water with a straw: solids that overlap and share faces.

use super::{Stage, all, floor, matte, number, on_y, point};
use crate::{Color, Cylinder, Frame, Material, Object, Scalar, Shape, Texture};

pub(super) fn build<S: Scalar>() -> Option<Stage<S>> {
    let clear = |transmittance, refraction| -> Option<Material<S>> {
        let clear = Material { diffuse: S::ZERO, ..matte([1.0; 3])? };
        Some(clear.with_refraction(number(transmittance)?, number(refraction)?))
    };
    let shining = |material: Material<S>| Some(material.with_highlight(number(0.5)?, number(200.0)?));
    let materials = [
        matte([1.0; 3])?.with_texture(0),
        shining(clear(0.97, 1.5)?)?,
        clear(1.0, 1.0)?,
        clear(0.97, 1.333)?,
        matte([1.0; 3])?.with_texture(1),
    ];
    let [board, glass, air, water, paper] = [0, 1, 2, 3, 4];
    let cylinder = |radius, height| Cylinder::capped(number(radius)?, number(height)?).ok();
    let (straw, length) = Frame::between(point(-0.55, 0.26, 0.2)?, point(1.1, 3.3, -0.2)?).ok()?;
    let straw = Object::new(Shape::new(Cylinder::capped(number(0.07)?, length).ok()?).placed(straw), paper);
    // Where solids overlap, the one that is listed last counts: the air is cut out of the glass, and the water, which
    // has the same wall and the same base as the air, fills it up to its own height. The straw is opaque.
    let objects = [
        floor(1.6, board)?,
        on_y(cylinder(1.0, 2.4)?, point(0.0, 0.0, 0.0)?, glass)?,
        on_y(cylinder(0.9, 2.3)?, point(0.0, 0.2, 0.0)?, air)?,
        on_y(cylinder(0.9, 1.4)?, point(0.0, 0.2, 0.0)?, water)?,
        straw,
    ];
    let [dark, light] = [[0.2, 0.22, 0.25], [0.85, 0.83, 0.78]].map(Color::from_f64);
    let [red, white] = [[0.85, 0.15, 0.12], [0.95, 0.95, 0.92]].map(Color::from_f64);
    let textures = [
        Texture::Checker { columns: 2, rows: 2, colors: [light, dark] },
        Texture::Checker { columns: 1, rows: 14, colors: [red, white] },
    ];
    Some(Stage {
        textures: all(textures)?,
        // No light passes through glass to what it shades: caustics are not computed.
        ambient: Color::from_f64([0.45; 3]),
        ..Stage::new(objects, materials, [([-6.0, 9.0, 7.0], 0.6), ([5.0, 6.0, 8.0], 0.25)])?
    })
}
