//! The promise: by spans, no light and no highlight is missed between traced pixels.

use super::spans::{Differing, direction};
use fixed::types::I16F16;
use raylet::effect::{Diffuse, Effects, Specular};
use raylet::{
    Camera, Color, Cone, Cuboid, Cylinder, Fog, Frame, Light, Material, Object, Picture, Plane, Rectangle, Scene,
    Shape, Size, Sphere, UnitVec3, Vec3,
};
use support::amount::amount;
use support::cases::{n as number, v as point};
use support::exact_types::Exact as Number;
use support::random::Random;

#[test]
fn highlights_are_not_missed() {
    let up = point([0.0, 1.0, 0.0]);
    let camera = Camera::new(point([0.0, 2.0, 9.0]), Vec3::ZERO, up, number(40.0)).unwrap();
    let lights = [Light::new(point([4.0, 9.0, 6.0]), number(0.8)), Light::new(point([-6.0, 5.0, 7.0]), number(0.6))];
    for exponent in [5.0, 40.0, 300.0, 1_000.0] {
        let glossy = Material::matte(Color::from_f64([0.5; 3])).with_highlight(number::<I16F16>(0.5), number(exponent));
        let at = |v| Frame::at(point(v)).unwrap();
        let objects = [
            Object::new(Shape::new(Plane::new()).placed(at([0.0, -1.0, 0.0])), 0),
            Object::new(Shape::new(Sphere::new(number(0.7)).unwrap()).placed(at([1.0, 0.0, 0.0])), 0),
            Object::new(
                Shape::new(Cylinder::capped(number(0.7), number(1.5)).unwrap()).placed(at([-1.5, -1.0, 0.0])),
                0,
            ),
            Object::new(Shape::new(Cone::capped(number(0.6), number(1.5)).unwrap()).placed(at([2.6, -1.0, 0.5])), 0),
        ];
        let materials = [glossy];
        let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
        let all = Differing::of(&Picture::<_, (Diffuse, Specular)>::leaving_out(&scene, Size::new(160, 120)));
        assert!(all.seen == 0 && all.lit == 0 && all.levels[1] == 0, "{exponent}: {all:?}");
        assert!(all.rays[1] < all.rays[0], "{exponent}: {all:?}");
    }
}

/// A picture of one white shape in one light.
fn white<S: Number, E: Effects>(shape: Shape<S>, eye: [f64; 3], angle: f64, light: Light<S>, size: Size) -> Differing {
    let (objects, up) = ([Object::new(shape, 0)], point([0.0, 1.0, 0.0]));
    let camera = Camera::new(point(eye), Vec3::ZERO, up, number(angle)).unwrap();
    let materials = [Material::matte(Color::from_f64([1.0; 3])).with_highlight(number(0.5), number(60.0))];
    let lights = [light];
    let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
    Differing::of(&Picture::<S, E>::leaving_out(&scene, size))
}

#[test]
fn a_light_next_to_a_receding_wall_is_not_missed() {
    // What it brightens is narrow where the wall is seen at a grazing angle, and wide on a floor.
    let mut all = Differing::default();
    for turned in [UnitVec3::X, direction(&mut Random(34)), UnitVec3::Y] {
        let wall = Shape::new(Plane::new()).placed(Frame::from_base_and_axis(Vec3::ZERO, turned).unwrap());
        for height in [0.2, 0.5, 1.0, 2.0, 5.0] {
            let lamp = turned.to_array().map(|axis| f64::from(axis) * height);
            let lights = [[0.3, 0.1, 0.0], [0.0, 0.5, 2.0], [0.2, 0.0, -3.0]].map(|along| {
                let [x, y, z] = std::array::from_fn(|axis| lamp[axis] + along[axis]);
                Light::new(point::<f32>([x, y, z]), 0.9)
            });
            for (light, eye) in
                lights.iter().flat_map(|light| [([1.0, 0.8, 6.0]), ([0.3, 0.5, 9.0])].map(|e| (light, e)))
            {
                all = all.and(white::<f32, (Diffuse,)>(wall, eye, 40.0, *light, Size::new(160, 120)));
            }
        }
    }
    assert!(all.seen == 0 && all.lit == 0 && all.levels[1] == 0 && 2 * all.rays[1] < all.rays[0], "{all:?}");
}

#[test]
fn fog_over_what_recedes_is_not_missed() {
    // What is long, or goes on to the horizon, vanishes within few columns.
    let turned =
        |axis: [f64; 3]| Frame::from_base_and_axis(Vec3::ZERO, UnitVec3::new(point::<f32>(axis)).unwrap()).unwrap();
    let [plane, floor] = [Shape::new(Plane::new()), Shape::new(Rectangle::new(40.0, 40.0).unwrap())];
    let slab = Shape::new(Cuboid::new(0.1, 10.0, 40.0).unwrap());
    let pipe = Shape::new(Cylinder::capped(0.5, 40.0).unwrap());
    let (materials, lights) = ([Material::default()], [Light::distant(UnitVec3::Y, 0.8)]);
    let mut all = Differing::default();
    for shape in [
        plane,
        plane.placed(turned([1.0, 0.3, 0.2])),
        floor.placed(turned([0.1, 1.0, 0.0])),
        floor.placed(turned([1.0, 0.2, 0.1])),
        slab.placed(Frame::at(point([0.0, 0.0, -30.0])).unwrap()),
        pipe.placed(turned([0.3, 0.1, -1.0])),
    ] {
        let objects = [Object::new(shape, 0)];
        for (clarity, eye) in
            [0.95, 0.8, 0.5].into_iter().flat_map(|c| [[0.6, 1.0, 6.0], [0.3, 0.2, 3.0]].map(|e| (c, e)))
        {
            let camera = Camera::new(point(eye), Vec3::ZERO, point([0.0, 1.0, 0.0]), 50.0).unwrap();
            let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
            let scene = scene.with_fog(Fog::new(Color::from_f64([0.7; 3]), clarity));
            all = all.and(Differing::of(&Picture::new(&scene, Size::new(160, 120))));
        }
    }
    assert!(all.seen == 0 && all.lit == 0 && all.most <= 2 && 2 * all.rays[1] < all.rays[0], "{all:?}");
}

#[test]
fn a_light_that_grazes_a_ball_is_not_missed() {
    // Between two columns that it does not reach there may be a sliver that it does.
    let ball = Shape::new(Sphere::new(1.0_f32).unwrap());
    let mut random = Random(31);
    let check = |towards: &mut dyn FnMut() -> UnitVec3<f32>, lights: usize, angle: f64, size: Size| {
        let mut all = Differing::default();
        for _ in 0..lights {
            let light = Light::distant(towards(), 1.0);
            all = all.and(white::<f32, (Diffuse,)>(ball, [0.0, 0.0, 6.0], angle, light, size));
        }
        let few = all.pixels / 300_000;
        assert!(all.seen == 0 && all.lit <= few && all.levels[1] <= few, "{all:?}");
        assert!(3 * all.rays[1] < all.rays[0], "{all:?}");
    };
    check(&mut || direction(&mut random), amount(40, 1_000), 22.0, Size::new(160, 120));
    // Next to the outline, where the surface turns away in few columns.
    let mut random = Random(32);
    let mut beside = || UnitVec3::new(point([0.59 + random.between(-0.03, 0.03), -0.8, 0.13])).unwrap();
    check(&mut beside, amount(6, 60), 18.2, Size::new(520, 480));
}

#[test]
fn light_on_lying_cones_and_receding_pipes_is_not_missed() {
    // Their normals turn in few columns: next to the apex, and far away.
    let lying = |base: [f64; 3], axis: [f64; 3]| {
        Frame::from_base_and_axis(point(base), UnitVec3::new(point(axis)).unwrap()).unwrap()
    };
    let cone = Shape::new(Cone::capped(0.5_f32, 4.0).unwrap()).placed(lying([2.0, 0.0, 0.0], [-1.0, 0.0, 0.0]));
    let pipe = Shape::new(Cylinder::capped(0.3_f32, 40.0).unwrap()).placed(lying([-1.0, -0.5, 5.0], [0.2, 0.0, -1.0]));
    let (mut random, size) = (Random(33), Size::new(240, 120));
    let [mut grazing, mut all] = [Differing::default(); 2];
    for _ in 0..amount(40, 1_000) {
        let [x, y, z] = random.direction().map(|c| 0.03 * c);
        let light = Light::distant(UnitVec3::new(point([0.89 + x, 0.349 + y, 0.292 + z])).unwrap(), 1.0);
        grazing = grazing.and(white::<f32, (Diffuse,)>(cone, [0.0, 0.0, 30.0], 3.8, light, size));
        let light = Light::distant(direction(&mut random), 1.0);
        for (shape, eye, angle) in [(cone, [0.0, 0.0, 30.0], 3.8), (pipe, [0.0, 0.3, 7.0], 20.0)] {
            all = all.and(white::<f32, (Specular,)>(shape, eye, angle, light, size));
        }
    }
    assert!(grazing.seen == 0 && grazing.lit == 0 && 50_000 * grazing.levels[1] <= grazing.pixels, "{grazing:?}");
    assert!(all.seen == 0 && all.lit == 0 && 100_000 * all.levels[1] <= all.pixels, "{all:?}");
}

#[test]
fn highlights_of_distant_lights_are_not_missed_on_a_small_picture() {
    let (up, materials) =
        (Vec3::new(0.0_f32, 1.0, 0.0), |shine| [Material::matte(Color::from_f64([0.4; 3])).with_highlight(0.5, shine)]);
    let objects = [Object::new(Shape::new(Plane::new()), 0)];
    for (index, shine) in [5.0_f32, 50.0, 300.0, 1_000.0].into_iter().enumerate() {
        for across in [-0.35_f32, -0.12, 0.0, 0.21, 0.4] {
            let camera = Camera::new(Vec3::new(0.0, 3.0, 5.0), Vec3::ZERO, up, 60.0 + 10.0 * index as f32).unwrap();
            // Mirrored at the floor into the picture.
            let towards = UnitVec3::new(Vec3::new(across, 0.7, -0.9)).unwrap();
            let (lights, materials) = ([Light::distant(towards, 0.8)], materials(shine));
            let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
            let all = Differing::of(&Picture::new(&scene, Size::new(64, 48)));
            assert!(all.seen == 0 && all.lit == 0 && all.most <= 2, "{shine} {across}: {all:?}");
        }
    }
}
