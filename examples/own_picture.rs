//! A picture of your own: no scene, no materials; a ray a pixel, and what you make of its hit.

use raylet::{Camera, Capsule, Frame, Plane, Ray, Shape, ShapeTree, Size, Sphere, Surface, UnitVec3, Vec3};

const SIZE: Size = Size::new(64, 28);
const INK: &[u8] = b" .:-=+*#%@";

/// Lambert's law, with a shadow: the cosine to the light, or nearly nothing.
fn brightness(
    surface: &Surface<f32>,
    object: u32,
    light: UnitVec3<f32>,
    things: &ShapeTree<f32, [Shape<f32>; 3]>,
) -> f32 {
    let cosine = surface.normal_towards_ray().dot(light);
    // The ray to the light departs from the surface, so that it needs no offset.
    let departure = surface.departure(object, raylet::Leaving::Outwards);
    let lit = Ray::new(surface.point(), light).is_ok_and(|ray| !things.occludes(&ray.departing(departure)));
    if lit && cosine > 0.0 { 0.15 + 0.85 * cosine } else { 0.15 }
}

pub fn main() -> Result<(), raylet::Error> {
    let ball = Shape::new(Sphere::new(1.0)?).placed(Frame::at(Vec3::new(-1.0, 1.0, 0.0))?);
    let (frame, length) = Frame::between(Vec3::new(1.0, 0.4, -0.5), Vec3::new(2.0, 1.6, 0.5))?;
    let things =
        ShapeTree::new([Shape::new(Plane::new()), ball, Shape::new(Capsule::new(0.4, length)?).placed(frame)])?;
    let light = UnitVec3::new(Vec3::new(-0.5, 1.0, 0.6))?;
    let camera = Camera::new(Vec3::new(0.0, 2.0, 7.0), Vec3::new(0.3, 0.8, 0.0), Vec3::new(0.0, 1.0, 0.0), 32.0)?;
    // Characters are twice as high as wide.
    let view = camera.raster(Size::new(SIZE.width, SIZE.height * 2));

    let mut shades = [0; INK.len()];
    for y in 0..SIZE.height {
        for x in 0..SIZE.width {
            let seen = view.ray([x, 2 * y], [0, 0]).and_then(|ray| Some((ray, things.nearest(&ray)?)));
            let ink = seen.map_or(0, |(ray, (object, hit))| {
                let surface = things.list()[object as usize].surface(&ray, &hit);
                (brightness(&surface, object, light, &things) * (INK.len() - 1) as f32) as usize
            });
            shades[ink] += 1;
            print!("{}", char::from(INK[ink]));
        }
        println!();
    }
    assert!(shades[0] > 50 && shades[1] > 20 && shades[9] + shades[8] > 20, "{shades:?}");
    Ok(())
}
