//! The built-in scene: every solid of revolution once, a disc and a pyramid, on a plane.

use super::{Stage, matte, number, on_y, point};
use crate::{
    Affine, Camera, Capsule, Cone, Cylinder, Disc, Frame, Object, Plane, Scalar, Shape, Sphere, Triangle, UnitVec3,
};
use heapless::Vec;

/// The still life in any number type that holds numbers up to 20.
pub(super) fn build<S: Scalar>() -> Option<Stage<S>> {
    let colors = [
        [0.82, 0.80, 0.76], // floor
        [0.85, 0.25, 0.20], // red
        [0.20, 0.55, 0.80], // blue
        [0.95, 0.75, 0.20], // yellow
        [0.30, 0.65, 0.35], // green
        [0.65, 0.40, 0.70], // violet
    ];
    let mut materials = Vec::<_, 6>::new();
    for (index, color) in colors.into_iter().enumerate() {
        let matte = matte(color)?;
        let shiny = matte.with_highlight(number(0.4)?, number(30.0)?);
        materials.push(if index == 0 { matte } else { shiny }).ok()?;
    }
    let [floor, red, blue, yellow, green, violet] = [0, 1, 2, 3, 4, 5];
    let centred = |x, z| point(x, 0.0, z);
    let (lying, length) = Frame::between(point(1.2, 0.35, 1.6)?, point(2.3, 0.35, 0.5)?).ok()?;
    let lean = UnitVec3::new(point(-0.25, 0.6, 0.6)?).ok()?;
    // A pyramid over a square whose half diagonal is 0.7, turned by 30 degrees.
    let (sine, cosine) = (0.7 * 0.5, 0.7 * 0.866_025_403_784_438_6);
    let corners = [[cosine, sine], [-sine, cosine], [-cosine, -sine], [sine, -cosine]];
    let corners = corners.map(|[x, y]| point(3.3 + x, 0.0, 1.2 - y));
    let apex = point(3.3, 1.0, 1.2)?;
    let side = |a, b| Some(Object::new(Shape::new(Triangle::new(a, b, apex).ok()?), green));
    let objects = [
        Object::new(Shape::new(Plane::new()), floor),
        // Back row.
        on_y(Cylinder::capped(number(0.6)?, number(2.0)?).ok()?, centred(-3.3, -1.2)?, blue)?,
        on_y(Cone::frustum(number(0.9)?, number(0.4)?, number(1.6)?).ok()?, centred(-1.2, -1.4)?, yellow)?,
        Object::new(
            Shape::new(Cone::capped(number(0.4)?, number(2.2)?).ok()?)
                .placed(Frame::from_base_and_axis(point(1.0, 2.2, -1.5)?, -UnitVec3::Y).ok()?),
            red,
        ),
        on_y(Cylinder::open(number(0.7)?, number(1.3)?).ok()?, centred(3.1, -1.0)?, green)?,
        // Front row.
        Object::new(Shape::new(Sphere::new(number(0.7)?).ok()?).placed(Frame::at(point(-2.2, 0.7, 0.6)?).ok()?), red),
        Object::new(
            Shape::new(Sphere::new(number(1.0)?).ok()?)
                .placed(Affine::stretched(Frame::at(point(-0.4, 0.4, 1.0)?).ok()?, point(0.9, 0.4, 0.5)?).ok()?),
            violet,
        ),
        Object::new(Shape::new(Capsule::new(number(0.35)?, length).ok()?).placed(lying), blue),
        Object::new(
            Shape::new(Disc::new(number(0.5)?).ok()?)
                .placed(Frame::from_base_and_axis(point(0.9, 0.55, 0.2)?, lean).ok()?),
            yellow,
        ),
        // A funnel, standing on its apex.
        on_y(Cone::open(number(0.6)?, number(0.9)?).ok()?, point(2.1, 0.0, -0.5)?, violet)?,
        side(corners[0]?, corners[1]?)?,
        side(corners[1]?, corners[2]?)?,
        side(corners[2]?, corners[3]?)?,
        side(corners[3]?, corners[0]?)?,
    ];
    let camera =
        Camera::new(point(0.2, 4.2, 9.0)?, point(0.2, 0.7, 0.0)?, point(0.0, 1.0, 0.0)?, number(38.0)?).ok()?;
    Some(Stage { camera, ..Stage::new(objects, materials, [([-6.0, 9.0, 7.0], 0.85), ([5.0, 6.0, 8.0], 0.45)])? })
}
