//! Glass and mirrors on a chessboard.

use super::{Stage, all, floor, matte, number, on_y, point};
use crate::{Capsule, Color, Cone, Cylinder, Material, Scalar, Sphere, Texture};

pub(super) fn build<S: Scalar>() -> Option<Stage<S>> {
    let clear = |refraction| -> Option<Material<S>> {
        let glass = Material { diffuse: number(0.02)?, ..matte([1.0; 3])? };
        Some(glass.with_highlight(number(0.5)?, number(200.0)?).with_refraction(number(0.95)?, number(refraction)?))
    };
    let silver = Material { diffuse: number(0.1)?, ..matte([0.9, 0.92, 0.95])? };
    let materials = [
        matte([1.0; 3])?.with_texture(0),
        clear(1.5)?,
        clear(1.33)?,
        silver.with_highlight(number(0.5)?, number(100.0)?).with_mirror(number(0.8)?),
        matte([0.85, 0.25, 0.20])?.with_highlight(number(0.4)?, number(30.0)?).with_mirror(number(0.1)?),
        matte([0.30, 0.65, 0.35])?,
        clear(1.0)?,
    ];
    let [board, crown, water, silver, red, green, pane] = [0, 1, 2, 3, 4, 5, 6];
    let objects = [
        floor(1.6, board)?,
        on_y(Sphere::new(number(1.0)?).ok()?, point(-0.4, 1.0, 1.2)?, crown)?,
        on_y(Cylinder::capped(number(0.6)?, number(1.5)?).ok()?, point(2.1, 0.0, 1.0)?, water)?,
        on_y(Sphere::new(number(1.2)?).ok()?, point(1.0, 1.2, -2.2)?, silver)?,
        on_y(Cone::capped(number(0.4)?, number(1.6)?).ok()?, point(-2.6, 0.0, 0.3)?, red)?,
        on_y(Capsule::new(number(0.35)?, number(0.9)?).ok()?, point(-1.7, 0.35, -1.6)?, green)?,
        on_y(Sphere::new(number(0.45)?).ok()?, point(-2.0, 0.45, 2.0)?, pane)?,
    ];
    let [dark, light] = [[0.2, 0.22, 0.25], [0.85, 0.83, 0.78]].map(Color::from_f64);
    let textures = [Texture::Checker { columns: 2, rows: 2, colors: [light, dark] }];
    Some(Stage {
        textures: all(textures)?,
        ..Stage::new(objects, materials, [([-6.0, 9.0, 7.0], 0.85), ([5.0, 6.0, 8.0], 0.35)])?
    })
}
