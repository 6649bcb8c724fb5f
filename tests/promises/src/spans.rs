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

pub(crate) fn direction<S: Number>(random: &mut Random) -> UnitVec3<S> {
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
pub(crate) struct Differing {
    pub(crate) pixels: usize,
    /// What is seen.
    pub(crate) seen: usize,
    /// The lights that reach it.
    pub(crate) lit: usize,
    /// By a level, and by more than two.
    pub(crate) levels: [usize; 2],
    /// The most levels.
    pub(crate) most: u8,
    pub(crate) rays: [u64; 2],
}

impl Differing {
    pub(crate) fn of<S: Number, E: Effects, T: Tier<S>>(picture: &Picture<'_, S, E, T>) -> Self {
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

    pub(crate) fn and(self, other: Self) -> Self {
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
pub(crate) fn on_floor<S: Number>(shapes: &[Shape<S>], eye: Vec3<S>, light: Light<S>, size: Size) -> Differing {
    let floor = Object::new(Shape::new(Plane::new()), 0);
    let objects: Vec<_> = [floor].into_iter().chain(shapes.iter().map(|shape| Object::new(*shape, 0))).collect();
    let (materials, up) = ([Material::default()], point([0.0, 1.0, 0.0]));
    let camera = Camera::new(eye, Vec3::ZERO, up, number(50.0)).unwrap();
    let scene = Scene::new(&objects, &materials, core::slice::from_ref(&light), camera).unwrap();
    Differing::of(&Picture::<S, (Diffuse, Shadows), Stable>::leaving_out(&scene, size))
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
