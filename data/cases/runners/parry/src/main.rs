//! Prints parry3d's nearest hit of each case of the standard input, in f32 or f64: the case's name, a tab, and the
//! distance, or `none`. Cases of solids that parry does not have are left out.

use serde_json::Value;
use std::io::{BufRead, stdin};

/// The three numbers of a vector.
fn three(value: &Value) -> Option<[f64; 3]> {
    let list = value.as_array()?;
    Some([list.first()?.as_f64()?, list.get(1)?.as_f64()?, list.get(2)?.as_f64()?])
}

/// A size: a number, or a fraction as text.
fn size(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some(fraction) => {
            let (p, q) = fraction.split_once('/')?;
            Some(p.parse::<f64>().ok()? / q.parse::<f64>().ok()?)
        }
        None => value.as_f64(),
    }
}

/// The runner in a number type: the types of parry's two crates have the same names.
macro_rules! runner {
    ($Float:ident, $parry:ident, $Quat:ident) => {
        pub mod $Float {
            use super::{Value, size, three};
            use $parry::glamx::$Quat;
            use $parry::math::{Pose, Vector};
            use $parry::query::{Ray, RayCast};
            use $parry::shape::{Ball, Capsule, Cone, Cuboid, Cylinder, HalfSpace, Triangle};

            fn vector([x, y, z]: [f64; 3]) -> Vector {
                Vector::new(x as $Float, y as $Float, z as $Float)
            }

            /// `None` if parry does not have the solid.
            pub fn nearest(case: &Value) -> Option<Option<$Float>> {
                let solid = &case["solid"];
                let base = vector(three(&case["base"])?);
                // The axis, and the height where the axis ends at a point.
                let (axis, length) = match three(&case["axis"]["to"]) {
                    Some(to) => ((vector(to) - base).normalize(), Some((vector(to) - base).length())),
                    None => (vector(three(&case["axis"])?), None),
                };
                let sized = |name: &str| size(&solid[name]).map(|value| value as $Float);
                let height = || length.or_else(|| sized("height"));
                let pose = Pose::from_parts(base, $Quat::from_rotation_arc(Vector::Y, axis));
                let raised = |height: $Float| pose * Pose::translation(0.0, height / 2.0, 0.0);
                // Its apex is above.
                let over = Pose::from_rotation($Quat::from_rotation_x(std::$Float::consts::PI));
                let direction = vector(three(&case["direction"])?).normalize();
                let ray = Ray::new(vector(three(&case["origin"])?), direction);
                let cast = |shape: &dyn RayCast, pose: &Pose| shape.cast_ray(pose, &ray, $Float::MAX, false);
                Some(match solid["kind"].as_str()? {
                    "sphere" => cast(&Ball::new(sized("radius")?), &pose),
                    "cylinder" => cast(&Cylinder::new(height()? / 2.0, sized("radius")?), &raised(height()?)),
                    "cone" => {
                        let radius = sized("slope")? * height()?;
                        cast(&Cone::new(height()? / 2.0, radius), &(raised(height()?) * over))
                    }
                    "capsule" => cast(&Capsule::new(Vector::ZERO, Vector::Y * height()?, sized("radius")?), &pose),
                    "plane" => cast(&HalfSpace::new(Vector::Y), &pose),
                    "box" => {
                        let half = Vector::new(sized("half_x")?, sized("half_y")?, sized("half_z")?);
                        cast(&Cuboid::new(half), &pose)
                    }
                    "triangle" => {
                        let corner = |i: usize| three(&solid["vertices"][i]).map(vector);
                        cast(&Triangle::new(corner(0)?, corner(1)?, corner(2)?), &pose)
                    }
                    _ => return None,
                })
            }
        }
    };
}

runner!(f32, parry3d, Quat);
runner!(f64, parry3d_f64, DQuat);

fn main() {
    let wide = std::env::args().nth(1).as_deref() == Some("f64");
    for line in stdin().lock().lines() {
        let case: Value = serde_json::from_str(&line.expect("a line")).expect("a case");
        let answer = if wide {
            f64::nearest(&case).map(|hit| hit.map(|t| format!("{t:?}")))
        } else {
            f32::nearest(&case).map(|hit| hit.map(|t| format!("{t:?}")))
        };
        if let Some(hit) = answer {
            println!("{}\t{}", case["name"].as_str().expect("a name"), hit.unwrap_or("none".to_owned()));
        }
    }
}
