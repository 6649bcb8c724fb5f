//! Picking: what is under the pointer, where, and how it faces the viewer.

use raylet::{Camera, Cone, Cuboid, Frame, Plane, Shape, ShapeTree, Shaped, Size, Sphere, Vec3, shape::kinds::All};

struct Thing {
    name: &'static str,
    shape: Shape<f32>,
}

impl Shaped<f32> for Thing {
    type Kinds = All;
    fn shape(&self) -> &Shape<f32> {
        &self.shape
    }
}

pub fn main() -> Result<(), raylet::Error> {
    let (cuboid, frame) = Cuboid::between(Vec3::new(-2.5, 0.0, -0.5), Vec3::new(-1.5, 1.0, 0.5))?;
    let ball = Shape::new(Sphere::new(0.75)?).placed(Frame::at(Vec3::new(0.0, 0.75, 0.0))?);
    let tent = Shape::new(Cone::frustum(0.75, 0.0, 1.5)?).placed(Frame::at(Vec3::new(2.0, 0.0, 0.0))?);
    let things = ShapeTree::new([
        Thing { name: "floor", shape: Shape::new(Plane::new()) },
        Thing { name: "box", shape: Shape::new(cuboid).placed(frame) },
        Thing { name: "ball", shape: ball },
        Thing { name: "tent", shape: tent },
    ])?;
    let camera = Camera::new(Vec3::new(0.0, 2.0, 8.0), Vec3::new(0.0, 0.7, 0.0), Vec3::new(0.0, 1.0, 0.0), 35.0)?;
    let view = camera.raster(Size::new(320, 240));

    for (pixel, expected) in [([70, 120], "box"), ([160, 130], "ball"), ([250, 130], "tent"), ([160, 220], "floor")] {
        let Some(ray) = view.ray(pixel, [0, 0]) else { continue };
        let Some((index, hit)) = things.nearest(&ray) else { continue };
        let thing = &things.list()[index as usize];
        let surface = thing.shape.surface(&ray, &hit);
        let [x, y, z] = surface.point().to_array();
        println!("{pixel:?}: {} at ({x:.3}, {y:.3}, {z:.3}), cosine {:.2}", thing.name, surface.cosine());
        assert_eq!(thing.name, expected);
    }
    Ok(())
}
