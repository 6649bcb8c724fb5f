//! The built-in scene: quadrics of revolution, closed and open, a tube, an annulus, a torus, a round cone, a rounded
//! cuboid, a prism and a cube without a corner, on a plane.

use super::{Stage, all, matte, number, on_y, point};
use crate::primitive::SizeError;
use crate::{
    Annulus, Frame, Material, Object, Plane, Polyhedron, Prism, Revolved, RoundCone, RoundedCuboid, Scalar, Shape,
    Torus, Tube, UnitVec3, Vec3,
};

pub(super) fn build<S: Scalar>() -> Option<Stage<S>> {
    let colors = [
        [0.82, 0.80, 0.76], // floor
        [0.75, 0.74, 0.70], // concrete
        [0.85, 0.25, 0.20], // red
        [0.20, 0.55, 0.80], // blue
        [0.95, 0.75, 0.20], // yellow
        [0.30, 0.65, 0.35], // green
        [0.90, 0.90, 0.92], // mirror
    ];
    let materials = colors.into_iter().enumerate().map(|(index, color)| -> Option<Material<S>> {
        let matte = matte(color)?;
        let shiny = matte.with_highlight(number(0.4)?, number(30.0)?);
        Some(match index {
            0 | 1 => matte,
            6 => Material { diffuse: number(0.1)?, ..shiny }.with_mirror(number(0.8)?),
            _ => shiny,
        })
    });
    let [floor, concrete, red, blue, yellow, green, mirror] = [0, 1, 2, 3, 4, 5, 6];
    let standing = |solid: Result<Revolved<S>, SizeError>, x: f64, z: f64, material: u32| {
        let solid = solid.ok()?;
        let [low, _] = solid.heights();
        // Its lower end is on the floor.
        on_y(solid, point(x, -low.to_f64(), z)?, material)
    };
    let tower =
        |x, z| standing(Revolved::tower(number(1.1)?, number(0.6)?, number(0.72)?, number(2.6)?), x, z, concrete);
    let leaning = |from: [f64; 3], axis: [f64; 3]| {
        let [x, y, z] = from;
        Frame::from_base_and_axis(point(x, y, z)?, UnitVec3::from_f64(axis).ok()?).ok()
    };
    let dish = Revolved::paraboloid(number(0.6)?, number(0.45)?).ok()?.open();
    let egg = Revolved::spheroid(number(0.55)?, number(0.8)?, [number(-0.8)?, number(0.8)?]).ok()?;
    // Upside down on the floor.
    let bowl = Revolved::<S>::optical(number(0.25)?, number(-1.5)?, number(1.2)?).ok()?;
    let pipe = Tube::with_wall(number(0.42)?, number(0.1)?, number(1.4)?).ok()?;
    let pear = RoundCone::new(number(0.45)?, number(0.2)?, number(0.9)?).ok()?;
    let soap = RoundedCuboid::new(number(0.4)?, number(0.12)?, number(0.2)?, number(0.14)?).ok()?;
    let turned = UnitVec3::from_f64([0.5, 0.0, 0.85]).ok()?;
    let lying = Frame::looking(point(-0.75, 0.26, 3.15)?, turned, UnitVec3::Y).ok()?;
    let washer = Annulus::new(number(0.22)?, number(0.5)?).ok()?;
    let ring = Torus::new(number(0.32)?, number(0.11)?).ok()?;
    let wedge = Prism::new(S::TRIANGLE, number(0.45)?).ok()?;
    let cube = Polyhedron::within(Vec3::ZERO, point(1.0, 1.0, 1.0)?, S::CUT).ok()?;
    let facing = |at: [f64; 3], towards: [f64; 2]| {
        let ([x, y, z], [along_x, along_z]) = (at, towards);
        Frame::looking(point(x, y, z)?, UnitVec3::from_f64([along_x, 0.0, along_z]).ok()?, UnitVec3::Y).ok()
    };
    let objects = [
        Object::new(Shape::new(Plane::new()), floor),
        tower(-3.4, -2.6)?.with_top(red),
        tower(-0.9, -3.4)?.with_top(red),
        Object::new(Shape::new(dish).placed(leaning([2.3, 0.75, -1.4], [-0.45, 0.45, 0.9])?), mirror),
        Object::new(Shape::new(egg).placed(leaning([0.2, 0.55, 0.2], [1.0, 0.0, 0.5])?), yellow),
        standing(Revolved::ball_zone(number(0.75)?, [S::ZERO, number(0.75)?]), -2.4, 0.4, blue)?,
        standing(Revolved::cone(number(0.6)?, [number(-0.8)?, number(0.8)?]), 1.9, 1.2, green)?.with_top(blue),
        standing(
            Revolved::hyperboloid(number(0.2)?, number(0.7)?, [number(-0.4)?, number(0.8)?]).map(Revolved::open),
            -0.7,
            1.8,
            red,
        )?,
        Object::new(
            Shape::new(bowl).placed(leaning([3.2, bowl.heights()[1].to_f64(), 1.6], [0.0, -1.0, 0.0])?),
            yellow,
        ),
        Object::new(Shape::new(pipe).placed(leaning([1.05, 0.42, 2.6], [-0.35, 0.0, -0.9])?), blue),
        Object::new(Shape::new(washer).placed(leaning([-2.3, 0.3, 2.0], [0.35, 0.85, 0.35])?), green),
        Object::new(Shape::new(soap).placed(lying), yellow),
        on_y(pear, point(3.6, 0.45, -0.2)?, red)?,
        Object::new(Shape::new(wedge).placed(facing([1.75, 0.0, 2.75], [0.9, 0.3])?), green),
        on_y(ring, point(-1.85, 0.11, 3.1)?, blue)?,
        Object::new(Shape::new(cube).placed(facing([0.45, 0.0, -1.9], [-0.3, 0.9])?), red),
    ];
    let materials: heapless::Vec<_, 8> = all(materials)?;
    let materials = materials.into_iter().collect::<Option<heapless::Vec<_, 8>>>()?;
    Stage::new(objects, materials, [([-6.0, 9.0, 7.0], 0.85), ([5.0, 6.0, 8.0], 0.45)])
}
