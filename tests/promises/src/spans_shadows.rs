//! The promise: by spans, shadows are whole, and rays are cast to lights only where one may fall.

use super::spans::{Differing, on_floor};
use fixed::types::I16F16;
use raylet::effect::{Diffuse, Shadows};
use raylet::{
    Camera, Cylinder, Frame, Light, Material, Object, Picture, Plane, Scene, Shape, Size, Sphere, UnitVec3, Vec3,
    Visible,
};
use support::cases::{n as number, v as point};

#[test]
fn the_shadow_of_a_wire_is_not_missed() {
    // It is as wide as a pixel or less, in the middle of a floor that is else evenly lit.
    let eye = point::<f32>([1.0, 6.0, 9.0]);
    for (index, radius) in [0.08, 0.03, 0.01].into_iter().enumerate() {
        let lying = UnitVec3::new(Vec3::new(1.0, 0.2 * index as f32, 0.4)).unwrap();
        let wire = |axis, at| {
            let frame = Frame::from_base_and_axis(point(at), axis).unwrap();
            Shape::new(Cylinder::capped(number(radius), 2.0).unwrap()).placed(frame)
        };
        let shapes = [wire(UnitVec3::Y, [-2.0, 1.0, 0.0]), wire(lying, [0.5, 1.0, 1.0])];
        for light in [Light::new(Vec3::new(3.0, 9.0, 2.0), 0.9), Light::distant(UnitVec3::Y, 0.9)] {
            let all = on_floor(&shapes, eye, light, Size::new(120, 90));
            assert!(all.seen == 0 && all.lit == 0 && all.levels[1] == 0, "{radius}: {all:?}");
        }
    }
}

#[test]
fn a_shadow_goes_on_behind_what_stands_before_it() {
    // Thin posts before the shadow of a ball.
    let eye = point::<I16F16>([0.0, 2.0, 9.0]);
    let post = |x: f64| {
        let frame = Frame::at(point([x, 0.0, 4.0])).unwrap();
        Shape::new(Cylinder::capped(number(0.05), number(2.0)).unwrap()).placed(frame)
    };
    let ball = Shape::new(Sphere::new(number(0.8)).unwrap()).placed(Frame::at(point([0.0, 3.0, 0.0])).unwrap());
    let shapes = [post(-0.5), post(0.0), post(0.5), ball];
    let all = on_floor(&shapes, eye, Light::distant(UnitVec3::Y, number(0.9)), Size::new(120, 90));
    assert!(all.seen == 0 && all.lit == 0 && all.levels[1] == 0, "{all:?}");
    assert!(2 * all.rays[1] < all.rays[0], "{all:?}");
}

#[test]
fn more_shadows_than_there_is_room_for_are_not_missed() {
    // Fifteen balls, close to each other, in one light and in four: 15 shadows on the floor, and 60; on balls more.
    let at = |index: u16| {
        let (x, z) = (f32::from(index % 5) - 2.0, f32::from(index / 5) - 1.0);
        Frame::at(Vec3::new(1.1 * x, 0.4 + 0.3 * z.abs(), 1.1 * z)).unwrap()
    };
    let ball = Shape::new(Sphere::new(0.4_f32).unwrap());
    let balls = (0..15).map(|index| Object::new(ball.placed(at(index)), 0));
    let objects: Vec<_> = [Object::new(Shape::new(Plane::new()), 0)].into_iter().chain(balls).collect();
    let lights = [[6.0, 1.5, 0.5], [-5.0, 2.0, 3.0], [0.5, 2.0, 7.0], [2.0, 3.0, -6.0]];
    let lights = lights.map(|position| Light::new(point(position), 0.4));
    let (materials, up) = ([Material::default()], point([0.0, 1.0, 0.0]));
    let camera = Camera::new(point([0.0, 3.0, 8.0]), Vec3::ZERO, up, 40.0).unwrap();
    for lights in [&lights[..1], &lights] {
        let scene = Scene::new(&objects, &materials, lights, camera).unwrap();
        let all = Differing::of(&Picture::<f32, (Diffuse, Shadows)>::leaving_out(&scene, Size::new(160, 120)));
        assert!(all.seen == 0 && all.lit == 0 && all.levels[1] == 0, "{} lights: {all:?}", lights.len());
    }
}

#[test]
fn no_ray_is_cast_to_lights_where_no_shadow_may_fall() {
    let objects = [-3.0, 0.0, 3.0].map(|x| {
        let frame = Frame::at(point([x, 0.8, 0.0])).unwrap();
        Object::new(Shape::new(Sphere::new(number::<I16F16>(0.8)).unwrap()).placed(frame), 0)
    });
    let (eye, up, materials) = (point([0.0, 3.0, 9.0]), point([0.0, 1.0, 0.0]), [Material::default()]);
    let camera = Camera::new(eye, Vec3::ZERO, up, number(50.0)).unwrap();
    // From above none is in the shadow of another; from the side two may be.
    for (light, is_shaded) in [([0.0, 9.0, 3.0], false), ([30.0, 2.0, 1.0], true)] {
        let lights = [Light::new(point(light), number(0.9))];
        let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
        let picture = Picture::<_, (Diffuse, Shadows)>::leaving_out(&scene, Size::new(160, 120));
        let all = Differing::of(&picture);
        assert!(all.seen == 0 && all.lit == 0 && all.levels[1] == 0, "{all:?}");
        let rays = picture.in_spans().render(|_, _, _| ()).shadow_rays;
        assert_eq!(rays > 0, is_shaded, "{rays}");
    }
}

#[test]
fn shadows_are_right_when_there_are_too_many_to_be_known() {
    // 33 pairs of a ball and a light, and 36.
    for lights in [3, 4] {
        let balls = (0..if lights == 3 { 11 } else { 9 }).map(|index| {
            let (x, z) = (f64::from(index % 4) - 1.5, f64::from(index / 4) - 1.0);
            let frame = Frame::at(point([1.2 * x, 0.5, 1.3 * z])).unwrap();
            Object::new(Shape::new(Sphere::new(0.5_f32).unwrap()).placed(frame), 0)
        });
        let objects: Vec<_> = [Object::new(Shape::new(Plane::new()), 0)].into_iter().chain(balls).collect();
        let light = |index: usize| Light::new(point([4.0 - 3.0 * index as f64, 6.0, 5.0]), 0.3);
        let (lights, materials): (Vec<_>, _) = ((0..lights).map(light).collect(), [Material::default()]);
        let camera = Camera::new(Vec3::new(0.0, 3.0, 7.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 50.0).unwrap();
        let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
        let all = Differing::of(&Picture::<f32, (Diffuse, Shadows)>::leaving_out(&scene, Size::new(80, 60)));
        assert!(all.seen == 0 && all.lit == 0 && all.levels[1] == 0, "{all:?}");
    }
}

#[test]
fn a_plane_shades_what_is_seen_in_a_light_on_its_other_side() {
    let ball = Shape::new(Sphere::new(1.0_f32).unwrap()).placed(Frame::at(point([0.0, 1.5, 0.0])).unwrap());
    for height in [-5.0, -0.1, 0.1, 5.0] {
        let light = Light::new(Vec3::new(6.0, height, 4.0), 0.9);
        for light in [light, Light::distant(UnitVec3::new(light.position).unwrap(), 0.9)] {
            let all = on_floor(&[ball], Vec3::new(0.0, 3.0, 7.0), light, Size::new(120, 90));
            assert!(all.seen == 0 && all.lit == 0 && all.levels[1] == 0, "{height}: {all:?}");
        }
    }
}

#[test]
fn a_shadow_of_a_one_sided_ball_that_is_sunk_into_the_floor_is_whole() {
    let at = |y| Frame::at(Vec3::new(0.3_f32, y, 0.0)).unwrap();
    for height in [0.0, 0.3, -0.4] {
        let ball = Shape::new(Sphere::new(1.0_f32).unwrap()).seen_from(Visible::Outside).placed(at(height));
        for light in [Vec3::new(1.0, 4.0, 6.0), Vec3::new(5.0, 2.0, 2.0), Vec3::new(-3.0, 1.0, 5.0)] {
            let light = Light::new(light, 0.9);
            let all = on_floor(&[ball], Vec3::new(0.0, 3.0, 7.0), light, Size::new(120, 90));
            // But where the floor and the ball are at one place.
            assert!(all.seen == 0 && all.lit <= 1 && all.most <= 2, "{height}: {all:?}");
        }
    }
}
