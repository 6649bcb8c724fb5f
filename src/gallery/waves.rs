//! Bump-mapped water and solids in front of rows of columns in fog.

use super::{Stage, floor, matte, number, on_y, point};
use crate::scalar::UnitScalar;
use crate::scene::Waves;
use crate::{Color, Cylinder, Fog, Material, Object, Scalar, Sphere};
use heapless::Vec;

pub(super) fn build<S: Scalar>() -> Option<Stage<S>> {
    let ripples =
        |along_u, along_v, slope| -> Option<Waves<S>> { Some(Waves { along_u, along_v, slope: number(slope)? }) };
    let water = Material { diffuse: number(0.25)?, ..matte([0.25, 0.45, 0.55])? };
    let shiny = |color| -> Option<Material<S>> { Some(matte(color)?.with_highlight(number(0.5)?, number(25.0)?)) };
    let materials = [
        water.with_mirror(number(0.5)?).with_bump(ripples(1, 2, 0.06)?),
        shiny([0.85, 0.45, 0.20])?.with_bump(ripples(24, 12, 0.5)?),
        shiny([0.75, 0.75, 0.70])?.with_bump(ripples(16, 0, 0.7)?),
        matte([0.80, 0.78, 0.72])?,
    ];
    let [water, orange, fluted, plain] = [0, 1, 2, 3];
    let mut objects = Vec::<Object<S>, 18>::new();
    objects.push(floor(1.3, water)?).ok()?;
    objects.push(on_y(Sphere::new(number(0.8)?).ok()?, point(-1.0, 0.9, 1.4)?, orange)?).ok()?;
    for row in 0..8 {
        let z = -1.0 - 5.0 * f64::from(row);
        for x in [-2.6, 2.6] {
            let column = on_y(Cylinder::capped(number(0.5)?, number(3.0)?).ok()?, point(x, 0.0, z)?, fluted)?;
            objects.push(column.with_top(plain)).ok()?;
        }
    }
    let fog = Fog::new(Color::from_f64([0.62, 0.68, 0.72]), S::Unit::from_f64(0.955));
    Some(Stage { fog: Some(fog), ..Stage::new(objects, materials, [([-6.0, 9.0, 7.0], 0.9), ([5.0, 6.0, 8.0], 0.3)])? })
}
