//! The promise: a picture by spans shows what the picture made pixel by pixel shows, and casts fewer rays.

use fixed::types::{I16F16, I32F32};
use raylet::effect::{All, Ambient, Diffuse, EffectSet, Effects, Shadows, Specular};
use raylet::gallery::BuiltIn;
use raylet::scalar::UnitScalar;
use raylet::scene::Texture;
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{
    Affine, Camera, Capsule, Color, Cone, Cuboid, Cylinder, Disc, Fog, Frame, Light, Material, Object, Picture, Pixel,
    Plane, Rectangle, Revolved, RoundCone, RoundedCuboid, Scene, Shape, Size, Sphere, Torus, Triangle, Tube, UnitVec3,
    Vec3, Visible,
};
use support::amount::amount;
use support::cases::{n as number, v as point};
use support::exact_types::Exact as Number;
use support::random::Random;

fn anywhere<S: Number>(random: &mut Random, most: f64) -> Vec3<S> {
    point([0; 3].map(|_| random.between(-most, most)))
}

fn direction<S: Number>(random: &mut Random) -> UnitVec3<S> {
    UnitVec3::new(point(random.direction())).unwrap()
}

/// A solid or a surface of about this size.
fn shape<S: Number>(random: &mut Random, size: f64) -> Shape<S> {
    let [large, middle, small] = [1.0, 0.6, 0.3].map(|share| number::<S>(share * size));
    let corner = |random: &mut Random| anywhere::<S>(random, size);
    match random.below(24) {
        0..3 => Shape::new(Sphere::new(large).unwrap()),
        3..5 => Shape::new(Cylinder::capped(middle, large).unwrap()),
        5 => Shape::new(Cylinder::open(middle, large).unwrap()),
        6 => Shape::new(Cone::capped(number(0.6), large).unwrap()),
        7 => Shape::new(Cone::frustum(large, small, middle).unwrap()),
        8..10 => Shape::new(Cuboid::new(small, large, middle).unwrap()),
        10 => Shape::new(Disc::new(large).unwrap()),
        11 => Shape::new(Rectangle::new(large, small).unwrap()),
        12 => {
            let corners = [(); 3].map(|()| corner(random));
            Triangle::new(corners[0], corners[1], corners[2])
                .map_or(Shape::new(Sphere::new(small).unwrap()), Shape::new)
        }
        13 => Shape::new(Capsule::new(small, large).unwrap()),
        14 => Shape::new(Torus::new(middle, small).unwrap()),
        15 => Shape::new(Tube::new(small, middle, large).unwrap()),
        16..18 => Shape::new(Sphere::new(large).unwrap()).seen_from(random.pick(&[Visible::Outside, Visible::Inside])),
        18 => Shape::new(RoundCone::new(middle, small, large).unwrap()),
        19 => Shape::new(RoundedCuboid::new(small, middle, small, small).unwrap()),
        20 => Shape::new(Revolved::spheroid(middle, large, [-middle, middle]).unwrap()),
        21 => Shape::new(Revolved::paraboloid(small, large).unwrap()),
        22 => Shape::new(Rectangle::new(small, large).unwrap()).seen_from(Visible::Outside),
        _ => Shape::new(Cylinder::infinite(small).unwrap()),
    }
}

/// A floor, or none, or two, and shapes that stand on it, hang over it, are sunk into it, or are placed by a matrix.
fn objects<S: Number>(random: &mut Random, away: Vec3<S>) -> Vec<Object<S>> {
    let mut objects = vec![];
    let below = away + point([0.0, -2.0, 0.0]);
    for _ in 0..random.pick(&[0, 1, 1, 1, 1, 2]) {
        let floor = Shape::new(Plane::new());
        let frame =
            if random.below(4) == 0 { Frame::from_base_and_axis(below, direction(random)) } else { Frame::at(below) };
        let visible = random.pick(&[Visible::Both, Visible::Both, Visible::Both, Visible::Outside, Visible::Inside]);
        objects.push(Object::new(floor.placed(frame.unwrap()).seen_from(visible), 0));
    }
    for _ in 0..=random.below(6) {
        let size = random.between(0.1, 1.3);
        let shape = shape::<S>(random, size);
        let base = away + anywhere::<S>(random, 2.5);
        let on_floor = Vec3::new(base.x, below.y, base.z);
        let placed = match random.below(6) {
            0..2 => shape.placed(Frame::at(on_floor).unwrap()),
            2 => shape.placed(
                Affine::new(base, [(); 3].map(|()| anywhere(random, 1.0)))
                    .unwrap_or_else(|_| Affine::stretched(Frame::at(base).unwrap(), point([1.0, 0.5, 2.0])).unwrap()),
            ),
            _ => shape.placed(Frame::from_base_and_axis(base, direction(random)).unwrap()),
        };
        let material = [0, 0, 0, 0, 1, 2, 3][random.below(7)];
        objects.push(Object::new(placed, material).with_top(random.below(2) as u32));
    }
    objects
}

fn materials<S: Number>() -> [Material<S>; 4] {
    let matte = Material::matte(Color::from_f64([0.9, 0.6, 0.3]));
    let glossy = matte.with_highlight(number(0.3), number(20.0));
    [matte, glossy, matte.with_mirror(number(0.5)), matte.with_texture(0)]
}

fn lights<S: Number>(random: &mut Random, away: Vec3<S>) -> Vec<Light<S>> {
    let light = |random: &mut Random| {
        let far = random.pick(&[3.0, 9.0, 40.0]);
        let at = point(random.direction().map(|c| c * far));
        if random.below(3) == 0 {
            Light { distant: true, ..Light::new(at, number(0.6)) }
        } else {
            Light::new(away + at, number(0.6))
        }
    };
    (0..random.below(3)).map(|_| light(random)).collect()
}

/// How a picture by spans differs from the one made pixel by pixel.
#[derive(Clone, Copy, Debug, Default)]
struct Differing {
    pixels: usize,
    /// What is seen.
    seen: usize,
    /// The lights that reach it.
    lit: usize,
    /// By a level, and by more than two.
    levels: [usize; 2],
    /// The most levels.
    most: u8,
    rays: [u64; 2],
}

impl Differing {
    fn of<S: Number, E: Effects, T: Tier<S>>(picture: &Picture<'_, S, E, T>) -> Self {
        let (mut one, mut other) = (vec![], vec![]);
        let counters = picture.render(|_, _, pixel| one.push(pixel));
        let fewer = picture.in_spans().render(|_, _, pixel| other.push(pixel));
        assert_eq!(one.len(), other.len());
        let mut differing = Self { pixels: one.len(), rays: [counters.rays(), fewer.rays()], ..Self::default() };
        for (a, b) in one.iter().zip(&other) {
            if a.seen != b.seen {
                differing.seen += 1;
                continue;
            }
            differing.lit += usize::from(a.lit_by != b.lit_by);
            let off = levels(a).into_iter().zip(levels(b)).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0);
            differing.levels[0] += usize::from(off > 0);
            differing.levels[1] += usize::from(off > 2);
            if a.lit_by == b.lit_by {
                differing.most = differing.most.max(off);
            }
        }
        differing
    }

    fn and(self, other: Self) -> Self {
        let sum = |a: [usize; 2], b: [usize; 2]| [a[0] + b[0], a[1] + b[1]];
        Self {
            pixels: self.pixels + other.pixels,
            seen: self.seen + other.seen,
            lit: self.lit + other.lit,
            levels: sum(self.levels, other.levels),
            most: self.most.max(other.most),
            rays: [self.rays[0] + other.rays[0], self.rays[1] + other.rays[1]],
        }
    }
}

fn levels<S: Number>(pixel: &Pixel<S>) -> [u8; 3] {
    pixel.color.to_srgb888()
}

/// Pictures of random scenes, this far from the origin.
fn random<S: Number, T: Tier<S>>(seed: u64, away: f64) -> Differing {
    let (mut random, mut all, size) = (Random(seed), Differing::default(), Size::new(64, 48));
    let away: Vec3<S> = point([away, -0.5 * away, 0.8 * away]);
    let materials = materials::<S>();
    let [light, dark] = [0.9, 0.2].map(|share| Color::from_f64([share; 3]));
    let textures = [Texture::Checker { columns: 4, rows: 4, colors: [light, dark] }];
    for _ in 0..amount(60, 2_000) {
        let (objects, lights) = (objects::<S>(&mut random, away), lights::<S>(&mut random, away));
        let near = random.below(8) == 0;
        let distance = if near { random.between(0.1, 2.0) } else { random.between(2.0, 8.0) };
        let eye: Vec3<S> = point(random.direction().map(|c| c * distance));
        let angle = number(random.between(15.0, 90.0));
        let Ok(camera) = Camera::new(away + eye, away + anywhere(&mut random, 1.0), anywhere(&mut random, 1.0), angle)
        else {
            continue;
        };
        let scene = Scene::new(&objects, &materials, &lights, camera).unwrap().at_tier::<T>();
        let scene = scene.with_textures(&textures).unwrap().with_background(Color::from_f64([0.2, 0.3, 0.5]));
        let scene = match random.below(3) {
            0 => scene.with_ambient(Color::from_f64([0.1; 3])),
            1 => scene.with_fog(Fog::new(light, S::Unit::from_f64(0.95))),
            _ => scene,
        };
        let of = match random.below(4) {
            0 => Differing::of(&Picture::<S, (), T>::leaving_out(&scene, size)),
            1 => Differing::of(&Picture::<S, (Ambient, Diffuse), T>::leaving_out(&scene, size)),
            2 => Differing::of(&Picture::<S, (Ambient, Diffuse, Specular, Shadows), T>::leaving_out(&scene, size)),
            _ => Differing::of(&Picture::new(&scene, size)),
        };
        all = all.and(of);
    }
    println!("{} {}: {all:?}", std::any::type_name::<S>(), std::any::type_name::<T>());
    all
}

#[test]
fn pictures_of_random_scenes_are_the_same_by_spans() {
    for all in [
        random::<f32, Stable>(1, 0.0),
        random::<f64, Stable>(2, 0.0),
        random::<I16F16, Stable>(3, 0.0),
        random::<I32F32, Stable>(4, 0.0),
        random::<f32, Exact>(5, 0.0),
        random::<f32, Fast>(6, 0.0),
        random::<I16F16, Plain>(7, 0.0),
        random::<f32, Stable>(8, 1e4),
        random::<f64, Fast>(9, 1e6),
        random::<I16F16, Stable>(10, 8_000.0),
    ] {
        assert!(all.seen == 0 && all.lit * 50_000 <= all.pixels, "{all:?}");
        assert!(all.levels[1] * 100_000 <= all.pixels && all.most <= amount(2, 9), "{all:?}");
        assert!(5 * all.rays[1] < 4 * all.rays[0], "{all:?}");
    }
}

fn built_in<S: Number, T: Tier<S>>(size: Size) {
    for built_in in BuiltIn::EVERY {
        let stage = built_in.build::<S>().unwrap();
        let scene = stage.scene().unwrap().at_tier::<T>();
        for effects in [EffectSet::EMPTY, EffectSet::ALL] {
            let all = Differing::of(&Picture::<S, All, T>::new(&scene, size).only(effects));
            assert!(all.seen == 0 && all.lit == 0 && all.levels[1] == 0, "{} {all:?}", built_in.name());
            assert!(effects == EffectSet::ALL || all.rays[1] <= all.rays[0], "{} {all:?}", built_in.name());
        }
    }
}

#[test]
fn built_in_scenes_are_the_same_by_spans_in_every_tier() {
    let size = Size::new(96, 72);
    built_in::<f32, Plain>(size);
    built_in::<f32, Stable>(size);
    built_in::<I16F16, Fast>(size);
    built_in::<I16F16, Stable>(size);
    built_in::<I16F16, Exact>(size);
}

/// A floor, and what stands over it, in a light.
fn on_floor<S: Number>(shapes: &[Shape<S>], eye: Vec3<S>, light: Light<S>, size: Size) -> Differing {
    let floor = Object::new(Shape::new(Plane::new()), 0);
    let objects: Vec<_> = [floor].into_iter().chain(shapes.iter().map(|shape| Object::new(*shape, 0))).collect();
    let (materials, up) = ([Material::default()], point([0.0, 1.0, 0.0]));
    let camera = Camera::new(eye, Vec3::ZERO, up, number(50.0)).unwrap();
    let scene = Scene::new(&objects, &materials, core::slice::from_ref(&light), camera).unwrap();
    Differing::of(&Picture::<S, (Diffuse, Shadows), Stable>::leaving_out(&scene, size))
}

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
fn spans_are_right_inside_of_solids() {
    // From the inside of a solid the floor is seen between two parts of it. The rows are tilted.
    let up = Vec3::new(0.7, 1.0, 0.2);
    let materials = [Material::default()];
    let room = Shape::new(Cuboid::new(3.0_f32, 2.0, 3.0).unwrap());
    let ball = Shape::new(Sphere::new(1.5_f32).unwrap());
    let can = Shape::new(Cylinder::capped(1.0_f32, 1.0).unwrap());
    let floor = Shape::new(Plane::new()).placed(Frame::at(point([0.0, -1.2, 0.0])).unwrap());
    for shapes in [&[room, can, floor][..], &[ball, floor], &[can, ball, floor], &[room, ball, can], &[ball, can]] {
        let objects: Vec<_> = shapes.iter().map(|shape| Object::new(*shape, 0)).collect();
        for (eye, to) in [
            ([0.0, 1.0, 2.9], [0.5, 0.2, 0.0]),
            ([0.5, 0.7, 0.4], [0.0, 0.5, 1.0]),
            ([0.1, 0.3, 0.2], [1.0, 0.2, 0.4]),
            ([0.1, 0.3, 0.2], [-1.0, 0.2, 0.4]),
            ([3.0, 1.0, 0.1], [0.0, 0.5, 0.0]),
            ([0.0, 0.1, 0.0], [1.0, -1.0, 0.3]),
            ([0.0, 0.1, 0.0], [0.3, -1.0, 1.0]),
        ] {
            let camera = Camera::new(point(eye), point(to), up, 80.0).unwrap();
            let scene = Scene::new(&objects, &materials, &[], camera).unwrap();
            let all = Differing::of(&Picture::new(&scene, Size::new(64, 48)));
            assert!(all.seen == 0, "{eye:?}: {all:?}");
        }
    }
}

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
fn rows_do_not_depend_on_each_other() {
    let stage = BuiltIn::StillLife.build::<f32>().unwrap();
    let scene = stage.scene().unwrap();
    let picture = Picture::new(&scene, Size::new(60, 45));
    let spans = picture.in_spans();
    let mut all = vec![vec![]; 45];
    spans.render(|_, y, pixel| all[usize::from(y)].push(pixel));
    let mut context = raylet::TraceContext::new(());
    for y in (0..45).rev() {
        let row = spans.row(y, &mut context);
        assert_eq!(row.len(), 60);
        assert!(row.eq(all[usize::from(y)].iter().copied()));
    }
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

#[test]
fn a_picture_without_pixels_has_no_spans() {
    let stage = BuiltIn::StillLife.build::<f32>().unwrap();
    let scene = stage.scene().unwrap();
    for size in
        [Size::new(0, 48), Size::new(64, 0), Size::new(0, 0), Size::new(1, 1), Size::new(64, 1), Size::new(1, 48)]
    {
        let all = Differing::of(&Picture::new(&scene, size));
        assert!(all.pixels == usize::from(size.width) * usize::from(size.height) && all.seen == 0, "{size:?}");
    }
}

#[test]
fn long_shapes_placed_by_a_matrix_are_seen_whole_in_fixed_point() {
    // The box is wider than the half of the type's range.
    let long = Shape::new(Cuboid::new(number::<I16F16>(12_000.0), number(200.0), number(1.0)).unwrap());
    let wide = Affine::stretched(Frame::at(Vec3::ZERO).unwrap(), point([2.0, 1.0, 1.0])).unwrap();
    let objects = [Object::new(long.placed(wide), 0)];
    let materials = [Material::default()];
    // From outside of a ball about the middle of half of that range.
    let (up, eye) = (point([0.0, 1.0, 0.0]), point([0.0, 0.0, 16_000.0]));
    let camera = Camera::new(eye, Vec3::ZERO, up, number(72.0)).unwrap();
    let scene = Scene::new(&objects, &materials, &[], camera).unwrap();
    let picture = Picture::new(&scene, Size::new(64, 47));
    let mut middle = 0;
    picture.render(|_, y, pixel| middle += u32::from(y == 23 && pixel.seen.is_some()));
    let all = Differing::of(&picture);
    assert!(all.seen == 0 && middle == 64, "{middle} {all:?}");
}

#[test]
fn what_is_known_of_a_picture_and_of_a_row_takes_as_much_memory_as_its_documentation_says() {
    type Spans = raylet::render::InSpans<'static, I16F16>;
    type Row = raylet::render::RowInSpans<'static, 'static, I16F16, All, ()>;
    // On a machine with addresses of 64 bits.
    assert!(size_of::<Spans>() <= 2_800 && size_of::<Row>() <= 1_100, "{} {}", size_of::<Spans>(), size_of::<Row>());
}
