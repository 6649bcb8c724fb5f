//! Built-in scenes that show what the Neutral File Format cannot say: materials for caps, textures, waves, fog, glass.

use crate::load::Loaded;
use crate::still_life::{self, number, on_y, point};
use clap::ValueEnum;
use raylet::scalar::UnitScalar;
use raylet::scene::nff::Scale;
use raylet::scene::{Coordinate, Waves};
use raylet::{
    Affine, Camera, Capsule, Color, Cone, Cylinder, Fog, Frame, Light, Material, Object, Plane, Scalar, Shape, Sphere,
    Texture, UnitVec3,
};
use std::error::Error;
use std::fmt;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// The scenes by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum BuiltIn {
    /// Every solid once, on a plane: diffuse, specular, shadows
    StillLife,
    /// Solids with materials of their own on base and top, and patterns and an image on them
    Patterns,
    /// Glass and mirrors on a chessboard
    Glass,
    /// Waves on water and on solids, before a hazy row of columns
    Waves,
}

impl fmt::Display for BuiltIn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::StillLife => "still_life",
            Self::Patterns => "patterns",
            Self::Glass => "glass",
            Self::Waves => "waves",
        })
    }
}

impl BuiltIn {
    /// The scene in any number type that holds numbers up to 100.
    pub(crate) fn build<S: Scalar>(self) -> Result<Loaded<S>> {
        match self {
            Self::StillLife => still_life::build(),
            Self::Patterns => patterns(),
            Self::Glass => glass(),
            Self::Waves => waves(),
        }
    }
}

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

fn matte<S: Scalar>(color: [f64; 3]) -> Result<Material<S>> {
    Ok(Material { diffuse: number(0.8)?, ..Material::matte(Color::from_f64(color)) })
}

/// A plane whose texture repeats every `size` units.
fn floor<S: Scalar>(size: f64, material: u32) -> Result<Object<S>> {
    let stretched = Affine::stretched(Frame::at(point(0.0, 0.0, 0.0)?)?, point(size, 1.0, size)?)?;
    Ok(Object::new(Shape::new(Plane::new()).placed(stretched), material))
}

fn stage<S: Scalar>(
    objects: Vec<Object<S>>,
    materials: Vec<Material<S>>,
    lights: &[([f64; 3], f64)],
) -> Result<Loaded<S>> {
    let mut placed = Vec::new();
    for ([x, y, z], strength) in lights {
        placed.push(Light::new(point(*x, *y, *z)?, number(*strength)?));
    }
    Ok(Loaded {
        objects,
        materials,
        lights: placed,
        normals: Vec::new(),
        textures: Vec::new(),
        fog: None,
        background: Color::from_f64([0.30, 0.42, 0.55]),
        camera: Camera::new(point(0.2, 3.4, 9.0)?, point(0.0, 0.9, 0.0)?, point(0.0, 1.0, 0.0)?, number(34.0)?)?,
        resolution: [320, 240],
        invisible: 0,
        scale: Scale::ONE,
    })
}

fn patterns<S: Scalar>() -> Result<Loaded<S>> {
    let white = matte([1.0; 3])?;
    let materials = vec![
        white.with_texture(0),
        white.with_texture(1).with_highlight(number(0.4)?, number(30.0)?),
        white.with_texture(2),
        white.with_texture(3),
        matte([0.85, 0.25, 0.20])?,
        matte([0.95, 0.75, 0.20])?,
        white.with_texture(4).with_highlight(number(0.4)?, number(30.0)?),
    ];
    let [board, globe, banded, image, red, yellow, spiral] = [0, 1, 2, 3, 4, 5, 6];
    let can = on_y(Cylinder::capped(number(0.8)?, number(1.6)?)?, point(-2.3, 0.0, 0.2)?, banded)?;
    let frustum = on_y(Cone::frustum(number(0.9)?, number(0.5)?, number(1.2)?)?, point(2.4, 0.0, 0.0)?, spiral)?;
    let turned = Frame::between(point(-0.6, 0.42, 2.2)?, point(0.9, 0.42, 1.6)?)?;
    let (lying, length) = turned;
    let pill = Object::new(Shape::new(Capsule::new(number(0.42)?, length)?).placed(lying), yellow);
    let coin_axis = UnitVec3::new(point(-0.5, 0.25, 1.0)?).ok_or("no direction")?;
    let coin = Shape::new(Cylinder::capped(number(0.6)?, number(0.12)?)?);
    let coin = coin.placed(Frame::from_base_and_axis(point(2.5, 0.6, 1.8)?, coin_axis)?);
    let objects = vec![
        floor(1.5, board)?,
        can.with_top(image),
        on_y(Sphere::new(number(0.9)?)?, point(0.0, 0.9, -0.4)?, globe)?,
        frustum.with_top(red),
        pill.with_base(red).with_top(red),
        Object::new(coin, red).with_top(image),
    ];
    let [dark, light] = [[0.25, 0.28, 0.30], [0.85, 0.83, 0.78]].map(Color::from_f64);
    let [blue, sand, green] = [[0.15, 0.35, 0.75], [0.9, 0.8, 0.55], [0.2, 0.6, 0.3]].map(Color::from_f64);
    let textures = vec![
        Texture::Checker { columns: 2, rows: 2, colors: [light, dark] },
        Texture::Checker { columns: 12, rows: 8, colors: [blue, sand] },
        Texture::Stripes { along: Coordinate::V, count: 7, colors: [light, blue] },
        Texture::Image { width: 8, height: 8, pixels: &FACE },
        Texture::Stripes { along: Coordinate::U, count: 16, colors: [green, sand] },
    ];
    Ok(Loaded { textures, ..stage(objects, materials, &[([-6.0, 9.0, 7.0], 0.85), ([5.0, 6.0, 8.0], 0.35)])? })
}

fn glass<S: Scalar>() -> Result<Loaded<S>> {
    let clear = |refraction| -> Result<Material<S>> {
        let glass = Material { diffuse: number(0.02)?, ..matte([1.0; 3])? };
        Ok(glass.with_highlight(number(0.5)?, number(200.0)?).with_refraction(number(0.95)?, number(refraction)?))
    };
    let silver = Material { diffuse: number(0.1)?, ..matte([0.9, 0.92, 0.95])? };
    let materials = vec![
        matte([1.0; 3])?.with_texture(0),
        clear(1.5)?,
        clear(1.33)?,
        silver.with_highlight(number(0.5)?, number(100.0)?).with_mirror(number(0.8)?),
        matte([0.85, 0.25, 0.20])?.with_highlight(number(0.4)?, number(30.0)?).with_mirror(number(0.1)?),
        matte([0.30, 0.65, 0.35])?,
        clear(1.0)?,
    ];
    let [board, crown, water, silver, red, green, pane] = [0, 1, 2, 3, 4, 5, 6];
    let objects = vec![
        floor(1.6, board)?,
        on_y(Sphere::new(number(1.0)?)?, point(-0.4, 1.0, 1.2)?, crown)?,
        on_y(Cylinder::capped(number(0.6)?, number(1.5)?)?, point(2.1, 0.0, 1.0)?, water)?,
        on_y(Sphere::new(number(1.2)?)?, point(1.0, 1.2, -2.2)?, silver)?,
        on_y(Cone::capped(number(0.4)?, number(1.6)?)?, point(-2.6, 0.0, 0.3)?, red)?,
        on_y(Capsule::new(number(0.35)?, number(0.9)?)?, point(-1.7, 0.35, -1.6)?, green)?,
        on_y(Sphere::new(number(0.45)?)?, point(-2.0, 0.45, 2.0)?, pane)?,
    ];
    let [dark, light] = [[0.2, 0.22, 0.25], [0.85, 0.83, 0.78]].map(Color::from_f64);
    let textures = vec![Texture::Checker { columns: 2, rows: 2, colors: [light, dark] }];
    Ok(Loaded { textures, ..stage(objects, materials, &[([-6.0, 9.0, 7.0], 0.85), ([5.0, 6.0, 8.0], 0.35)])? })
}

fn waves<S: Scalar>() -> Result<Loaded<S>> {
    let ripples =
        |along_u, along_v, slope| -> Result<Waves<S>> { Ok(Waves { along_u, along_v, slope: number(slope)? }) };
    let water = Material { diffuse: number(0.25)?, ..matte([0.25, 0.45, 0.55])? };
    let shiny = |color| -> Result<Material<S>> { Ok(matte(color)?.with_highlight(number(0.5)?, number(25.0)?)) };
    let materials = vec![
        water.with_mirror(number(0.5)?).with_bump(ripples(1, 2, 0.06)?),
        shiny([0.85, 0.45, 0.20])?.with_bump(ripples(24, 12, 0.5)?),
        shiny([0.75, 0.75, 0.70])?.with_bump(ripples(16, 0, 0.7)?),
        matte([0.80, 0.78, 0.72])?,
    ];
    let [water, orange, fluted, plain] = [0, 1, 2, 3];
    let mut objects = vec![floor(1.3, water)?, on_y(Sphere::new(number(0.8)?)?, point(-1.0, 0.9, 1.4)?, orange)?];
    for row in 0..8 {
        let z = -1.0 - 5.0 * f64::from(row);
        for x in [-2.6, 2.6] {
            let column = on_y(Cylinder::capped(number(0.5)?, number(3.0)?)?, point(x, 0.0, z)?, fluted)?;
            objects.push(column.with_top(plain));
        }
    }
    let fog = Fog::new(Color::from_f64([0.62, 0.68, 0.72]), S::Unit::from_f64(0.955));
    Ok(Loaded { fog: Some(fog), ..stage(objects, materials, &[([-6.0, 9.0, 7.0], 0.9), ([5.0, 6.0, 8.0], 0.3)])? })
}
