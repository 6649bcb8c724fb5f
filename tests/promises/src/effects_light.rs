//! The promise: light goes where optics sends it: mirrors, glass, fog, waves, patterns; and rays that leave a surface
//! do not find it again.

use fixed::types::{I8F24, I16F16, I32F32};
use raylet::effect::DEPTH;
use raylet::scalar::UnitScalar;
use raylet::scene::{Coordinate, Fog, Texture, Waves};
use raylet::{
    Camera, Color, Counters, Cylinder, Disc, Frame, Light, Material, Object, Picture, Plane, Ray, Scalar, Scene, Shape,
    Size, Sphere, TraceContext, Tracer, UnitVec3, Vec3,
};

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value).unwrap()
}

fn point<S: Scalar>(x: f64, y: f64, z: f64) -> Vec3<S> {
    Vec3::from_f64([x, y, z]).unwrap()
}

fn camera<S: Scalar>() -> Camera<S> {
    Camera::new(point(0.0, 0.0, 9.0), point(0.0, 0.0, 0.0), point(0.0, 1.0, 0.0), number(30.0)).unwrap()
}

fn ball<S: Scalar>(centre: [f64; 3], radius: f64, material: u32) -> Object<S> {
    let frame = Frame::at(Vec3::from_f64(centre).unwrap()).unwrap();
    Object::new(Shape::new(Sphere::new(number(radius)).unwrap()).placed(frame), material)
}

fn black<S: Scalar>() -> Material<S> {
    Material { diffuse: S::ZERO, ..Material::matte(Color::WHITE) }
}

fn glass<S: Scalar>(index: f64) -> Material<S> {
    black().with_refraction(number(1.0), number(index))
}

/// What a ray sees of unlit objects before a background that shines: red, and the counters.
fn seen<S: Scalar>(objects: &[Object<S>], materials: &[Material<S>], from: [f64; 3], to: [f64; 3]) -> (f64, Counters) {
    let scene = Scene::new(objects, materials, &[], camera()).unwrap().with_background(Color::WHITE);
    let ray = Ray::towards(Vec3::from_f64(from).unwrap(), Vec3::from_f64(to).unwrap()).unwrap();
    let mut context = TraceContext::new(());
    let sight = Tracer::new(&scene).uncut().look(&ray, &mut context);
    (sight.color.red.to_f64(), context.counters)
}

#[test]
fn a_mirror_shows_what_stands_in_the_mirrored_place() {
    // From (-3, 4, 0) by the origin to (3, 4, 0): a black ball there is seen, and nothing beside it is.
    let materials = [black().with_mirror(0.5_f64), black()];
    let (from, to) = ([-3.0, 4.0, 0.0], [0.0; 3]);
    let red = |centre| {
        let objects = [Object::new(Shape::new(Plane::new()), 0), ball(centre, 0.1, 1)];
        seen(&objects, &materials, from, to).0
    };
    assert_eq!(red([3.0, 4.0, 0.0]), 0.0);
    assert_eq!(red([3.0, 4.0, 0.2]), 0.5);
    assert_eq!(red([3.0, 4.2, 0.0]), 0.5);
}

#[test]
fn paths_end_at_the_published_depth() {
    fn check<S: Scalar>() {
        let facing = |y, axis| {
            let frame = Frame::from_base_and_axis(point(0.0, y, 0.0), axis).unwrap();
            Object::new(Shape::new(Plane::new()).placed(frame), 0)
        };
        let objects = [facing(0.0, UnitVec3::Y), facing(2.0, -UnitVec3::Y)];
        let (red, counters) =
            seen::<S>(&objects, &[black().with_mirror(number(1.0))], [0.0, 1.0, 0.0], [0.1, 0.0, 0.0]);
        assert_eq!((red, counters.reflection_rays), (0.0, u64::from(DEPTH)));
        // A mirror that is transparent as well sends two rays on from each of DEPTH surfaces, at most.
        let both = black().with_mirror(number(0.5)).with_refraction(number(0.5), number(1.0));
        // Between equal media there is no surface.
        let shade = |i: u32| Color::from_f64([f64::from(i) / 20.0; 3]);
        let materials: Vec<_> = (0..20).map(|i| Material { color: shade(i), ..both }).collect();
        let inside: Vec<_> = (0..20).map(|i| ball([0.0; 3], 20.0 - f64::from(i), i)).collect();
        let (_, counters) = seen::<S>(&inside, &materials, [0.0; 3], [0.1, 0.3, 0.2]);
        assert_eq!(counters.reflection_rays + counters.refraction_rays, (1 << (DEPTH + 1)) - 2);
    }
    check::<f32>();
    check::<I16F16>();
}

#[test]
fn light_divides_by_fresnels_equations() {
    fn check<S: Scalar>(tolerance: f64) {
        // A black lid takes what is reflected; what passes meets the background.
        let lid = Frame::from_base_and_axis(point(0.0, 2.0, 0.0), -UnitVec3::Y).unwrap();
        let objects = [Object::new(Shape::new(Plane::new()), 0), Object::new(Shape::new(Plane::new()).placed(lid), 1)];
        let materials = [glass(1.5), black::<S>()];
        for degrees in [0.0_f64, 20.0, 45.0, 60.0, 80.0, 89.0] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let refracted = (sine / 1.5).asin().cos();
            let across = (cosine - 1.5 * refracted) / (cosine + 1.5 * refracted);
            let within = (refracted - 1.5 * cosine) / (refracted + 1.5 * cosine);
            let passing = 1.0 - f64::midpoint(across * across, within * within);
            let (red, _) = seen::<S>(&objects, &materials, [-sine, cosine, 0.0], [0.0; 3]);
            assert!((red - passing).abs() < tolerance, "{degrees}: {red} {passing}");
        }
    }
    check::<f32>(1e-5);
    check::<f64>(1e-13);
    check::<I16F16>(1e-3);
    check::<I32F32>(1e-8);
}

#[test]
fn a_glass_ball_bends_light_by_snells_law() {
    // In at height b on a ball of radius 1, out on the other side: turned by twice the difference of the angles.
    for (index, b) in [(1.5_f64, 0.5_f64), (1.5, 0.9), (1.33, 0.3), (0.8, 0.5), (1.0, 0.7)] {
        let turn = 2.0 * (b.asin() - (b / index).asin());
        // The ray leaves at the angle pi - 2 asin(b / n) from where it came in, seen from the centre.
        let entry = std::f64::consts::PI - b.asin();
        let exit = entry - std::f64::consts::PI + 2.0 * (b / index).asin();
        let (out, way) = ((exit.cos(), exit.sin()), ((-turn).cos(), (-turn).sin()));
        let target = |aside: f64| [out.0 + 50.0 * way.0 - aside * way.1, out.1 + 50.0 * way.1 + aside * way.0, 0.0];
        let look = |aside| {
            let objects = [ball([0.0; 3], 1.0, 0), ball(target(aside), 0.05, 1)];
            seen(&objects, &[glass(index), black::<f64>()], [-10.0, b, 0.0], [0.0, b, 0.0]).0
        };
        // Only the light that is thrown back and forth inside is left if the target stands in the way.
        assert!(look(0.0) < 0.35 && look(0.2) > 0.65 && look(-0.2) > 0.65, "{index} {b}: {} {}", look(0.0), look(0.2));
    }
}

#[test]
fn reflection_inside_glass_is_total_beyond_the_critical_angle() {
    fn check<S: Scalar>() {
        // From inside, at (0, h): a ray along x meets the ball's wall at the angle asin(h).
        let objects = [ball::<S>([0.0; 3], 1.0, 0)];
        let critical = 1.0 / 1.5;
        let red = |h: f64| seen(&objects, &[glass(1.5)], [0.0, h, 0.0], [0.5, h, 0.0]);
        let (bright, _) = red(critical - 0.01);
        assert!(bright > 0.98, "{bright}");
        let (dark, counters) = red(critical + 0.01);
        assert_eq!((dark, counters.refraction_rays), (0.0, u64::from(DEPTH)), "round and round inside");
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

/// The darkest pixel of a picture of one object from far away, and how many pixels it covers.
fn darkest<S: Scalar>(radius: f64, away: f64, material: Material<S>, lamp: bool) -> (u8, usize) {
    let (x, y) = (away * 0.6, away * -0.48);
    let centre = [x, y, away * 0.64];
    let objects = [ball::<S>(centre, radius, 0)];
    let materials = [material];
    let eye = point(1.0, 2.0, 3.0);
    let angle = number((2.4 * (radius / away).atan()).to_degrees());
    let camera = Camera::new(eye, Vec3::from_f64(centre).unwrap(), point(0.0, 1.0, 0.0), angle).unwrap();
    // As bright as it must be for the picture's corners to be white too.
    let lights = [Light::new(eye, number(30.0))];
    let lights = if lamp { &lights[..] } else { &[] };
    let scene = Scene::new(&objects, &materials, lights, camera).unwrap().with_background(Color::WHITE);
    let (mut darkest, mut covered) = (255, 0);
    Picture::new(&scene, Size::new(160, 120)).in_linear_levels().render(|_, _, pixel| {
        if pixel.seen.is_some() {
            covered += 1;
            darkest = darkest.min(pixel.color.to_linear888()[0]);
        }
    });
    (darkest, covered)
}

#[test]
fn large_balls_far_away_have_no_speckles() {
    // Lit from the eye, all that is seen is lit; in a white room, clear glass is white. A ray that met its own surface
    // again, or missed the far wall, would leave a dark pixel.
    fn check<S: Scalar>() {
        for away in [300.0, 3000.0, 12000.0] {
            let (darkest_lit, covered) = darkest::<S>(100.0, away, Material::matte(Color::WHITE), true);
            assert!(covered > 5000, "{covered}");
            // Next to the outline the cosine is small: there a pixel may be grey, but not black.
            assert!(darkest_lit > 0, "lit, {away} away: {darkest_lit}");
            let (darkest_glass, _) = darkest::<S>(100.0, away, glass(1.5), false);
            // Of the light that goes round and round inside, reflected to a part F each time, (1 - F) F^15 is still
            // there where the path ends: at most 1 / 16 (15 / 16)^15, six levels.
            assert!(darkest_glass >= 248, "glass, {away} away: {darkest_glass}");
            let (darkest_pane, _) = darkest::<S>(100.0, away, glass(1.0), false);
            assert_eq!(darkest_pane, 255, "clear, {away} away");
        }
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

/// What the air lets through is the power of its clarity, however far the way.
#[test]
fn fog_follows_beers_law_at_every_distance() {
    fn check<S: Scalar>(farthest: f64) {
        for clarity in [0.0, 0.3, 0.9, 0.999, 0.99999] {
            let fog = Fog::<S>::new(Color::WHITE, S::Unit::from_f64(clarity));
            let exact = |t: f64| if t == 0.0 { 1.0 } else { fog.clarity().to_f64().powf(t) };
            let mut last = 1.0;
            for t in [0.0, 1e-3, 0.5, 1.0, 3.0, 60.0, 1000.0, 16000.0, 32000.0] {
                if t > farthest {
                    continue;
                }
                let t = number::<S>(t);
                let visible = fog.visibility(t).to_f64();
                assert!((visible - exact(t.to_f64())).abs() < 1e-5 && visible <= last, "{clarity} {t:?}: {visible}");
                last = visible;
            }
        }
        assert!(!Fog::<S>::new(Color::WHITE, S::Unit::ONE).is_visible());
        let clarity = |clarity| Fog::<S>::new(Color::WHITE, S::Unit::from_f64(clarity)).clarity();
        assert_eq!((clarity(-0.5), clarity(1.5)), (S::Unit::ZERO, S::Unit::ONE), "brought into [0, 1]");
    }
    check::<f32>(1e9);
    check::<f64>(1e9);
    check::<I8F24>(100.0);
    check::<I16F16>(32000.0);
    check::<I32F32>(1e9);
}

#[test]
fn fog_hides_what_is_far_and_fills_no_glass() {
    fn check<S: Scalar>() {
        let fog = Fog::new(Color::from_f64([1.0, 0.5, 0.0]), S::Unit::from_f64(0.9));
        let look = |objects: &[Object<S>], materials: &[Material<S>]| {
            let scene = Scene::new(objects, materials, &[], camera()).unwrap().with_fog(fog);
            let ray = Ray::new(point(0.0, 0.0, 9.0), -UnitVec3::Z).unwrap();
            Tracer::new(&scene).look(&ray, &mut TraceContext::new(())).color.to_array().map(UnitScalar::to_f64)
        };
        let near = |[red, green, blue]: [f64; 3], hidden: f64| {
            assert!(
                (red - hidden).abs() < 1e-4 && (green - hidden / 2.0).abs() < 1e-4 && blue == 0.0,
                "{red} {hidden}"
            );
        };
        near(look(&[], &[]), 1.0);
        near(look(&[ball([0.0; 3], 2.0, 0)], &[black()]), 1.0 - 0.9_f64.powi(7));
        // 7 units of fog, 4 of clear glass, 5 of fog again. (So little denser than air that almost nothing is
        // reflected.)
        let through = [ball([0.0; 3], 2.0, 0), ball([0.0, 0.0, -9.0], 2.0, 1)];
        near(look(&through, &[glass(THIN), black()]), 1.0 - 0.9_f64.powi(12));
        // What has the index of air is full of air: behind a pane, from either side, the fog goes on.
        near(look(&through, &[glass(1.0), black()]), 1.0 - 0.9_f64.powi(16));
        let pane = Object::new(lying_disc(UnitVec3::Z), 0);
        near(look(&[pane, ball([0.0, 0.0, -9.0], 2.0, 1)], &[glass(1.0), black()]), 1.0 - 0.9_f64.powi(16));
        let turned = Object::new(lying_disc(-UnitVec3::Z), 0);
        near(look(&[turned, ball([0.0, 0.0, -9.0], 2.0, 1)], &[glass(1.0), black()]), 1.0 - 0.9_f64.powi(16));
        // 7 units of fog, 4 of glass up to its silvered back, these 4 again, and 10 units of fog to the wall behind the
        // eye.
        let can = Cylinder::capped(number(1.0), number(4.0)).unwrap();
        let lying = |z, primitive: Shape<S>| {
            primitive.placed(Frame::from_base_and_axis(point(0.0, 0.0, z), -UnitVec3::Z).unwrap())
        };
        let silvered = [
            Object::new(lying(2.0, Shape::new(can)), 0).with_top(1),
            Object::new(lying(12.0, Shape::new(Plane::new())), 2),
        ];
        let mirror = black().with_mirror(number(1.0));
        near(look(&silvered, &[glass(THIN), mirror, black()]), 1.0 - 0.9_f64.powi(17));
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

/// An index so near to 1 that Fresnel's equations leave almost nothing to reflect.
const THIN: f64 = 1.001;

/// A disc of radius 1 about the origin.
fn lying_disc<S: Scalar>(axis: UnitVec3<S>) -> Shape<S> {
    Shape::new(Disc::new(number(1.0)).unwrap()).placed(Frame::from_base_and_axis(Vec3::ZERO, axis).unwrap())
}

/// A plane seen from above at (x, z), lit by a lamp in a direction, far away.
fn plane_at<S: Scalar>(
    material: Material<S>,
    textures: &[Texture<'_, S>],
    [x, z]: [f64; 2],
    lamp: [f64; 3],
) -> [f64; 3] {
    let (objects, materials) = ([Object::new(Shape::new(Plane::new()), 0)], [material]);
    let lamp = lamp.map(|component| component * 100.0);
    let lights = [Light::new(point(x + lamp[0], lamp[1], z + lamp[2]), number(1.0))];
    let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap().with_textures(textures).unwrap();
    let eye = if lamp[1] > 0.0 { 5.0 } else { -5.0 };
    let ray = Ray::towards(point(x, eye, z), point(x, 0.0, z)).unwrap();
    Tracer::new(&scene).look(&ray, &mut TraceContext::new(())).color.to_array().map(UnitScalar::to_f64)
}

#[test]
fn waves_lean_the_normal_against_their_slope() {
    fn check<S: Scalar>() {
        let bumpy = Material::matte(Color::WHITE).with_bump(Waves { along_u: 2, along_v: 0, slope: number(0.75) });
        let (left, right) = ([-0.6, 0.8, 0.0], [0.6, 0.8, 0.0]);
        // Two waves a unit: uphill along +x at 0, so that the normal leans back along -x, to (-0.6, 0.8); downhill at
        // 1/4.
        for (x, lamp, cosine) in [
            (0.0, left, 1.0),
            (0.0, right, 0.28),
            (0.25, right, 1.0),
            (0.25, left, 0.28),
            (0.125, [0.0, 1.0, 0.0], 1.0),
        ] {
            let [red, ..] = plane_at::<S>(bumpy, &[], [x, 0.3], lamp);
            assert!((red - cosine).abs() < 1e-3, "{x}: {red} {cosine}");
        }
        // Along v alone, which is z, the same.
        let along_v = Material { bump: Some(Waves { along_u: 0, along_v: 2, slope: number(0.75) }), ..bumpy };
        let [red, ..] = plane_at::<S>(along_v, &[], [0.3, 0.0], [0.0, 0.8, -0.6]);
        assert!((red - 1.0).abs() < 1e-3, "along v: {red}");
        // From below the hill is a valley with the same flanks.
        let [red, ..] = plane_at::<S>(bumpy, &[], [0.0, 0.3], [0.6, -0.8, 0.0]);
        assert!((red - 1.0).abs() < 1e-3, "{red}");
        // The normal leans towards this lamp, but it stands below the plane.
        let steep = Material { bump: Some(Waves { along_u: 2, along_v: 0, slope: number(8.0) }), ..bumpy };
        let (objects, materials) = ([Object::new(Shape::new(Plane::new()), 0)], [steep]);
        let lights = [Light::new(point(-100.0, -1.0, 0.0), number(1.0))];
        let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap();
        let ray = Ray::towards(point::<S>(0.0, 5.0, 0.0), point(0.0, 0.0, 0.0)).unwrap();
        assert_eq!(Tracer::new(&scene).look(&ray, &mut TraceContext::new(())).color, Color::BLACK);
        // And the other way round: above the plane, and behind the leaning normal. It takes no light away, nor costs a
        // ray.
        let lights = [Light::new(point(100.0, 1.0, 0.0), number(1.0))];
        let scene = Scene::new(&objects, &materials, &lights, camera()).unwrap();
        let mut context = TraceContext::new(());
        let sight = Tracer::new(&scene).look(&ray, &mut context);
        assert_eq!((sight.color, sight.lit_by, context.counters.shadow_rays), (Color::BLACK, 0, 0));
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

#[test]
fn textures_lie_along_the_surface_coordinates() {
    fn check<S: Scalar>() {
        let (up, white) = ([0.0, 1.0, 0.0], Material::matte(Color::WHITE));
        let pixels = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255], [0, 0, 0], [255, 255, 0]];
        let image = [Texture::Image { width: 3, height: 2, pixels: &pixels }];
        for (column, row) in (0..3).flat_map(|column| [(column, 0), (column, 1)]) {
            // The first row is the one at large v.
            let at = [(f64::from(column) + 0.5) / 3.0, 0.75 - 0.5 * f64::from(row)];
            let expected = pixels[row as usize * 3 + column as usize].map(|level| f64::from(level) / 255.0);
            assert_eq!(plane_at::<S>(white.with_texture(0), &image, at, up), expected, "{column} {row}");
        }
        let colors = [Color::WHITE, Color::BLACK];
        let red = |texture, at| plane_at::<S>(white.with_texture(0), &[texture], at, up)[0];
        let checker = Texture::Checker { columns: 4, rows: 2, colors };
        assert_eq!([[0.1, 0.1], [0.3, 0.1], [0.1, 0.6], [0.3, 0.6]].map(|at| red(checker, at)), [1.0, 0.0, 0.0, 1.0]);
        let stripes = Texture::Stripes { along: Coordinate::U, count: 2, colors };
        assert_eq!([[0.1, 0.1], [0.1, 0.9], [0.6, 0.1]].map(|at| red(stripes, at)), [1.0, 1.0, 0.0]);
        let stripes = Texture::Stripes { along: Coordinate::V, count: 2, colors };
        assert_eq!([[0.1, 0.1], [0.9, 0.1], [0.1, 0.6]].map(|at| red(stripes, at)), [1.0, 1.0, 0.0]);
        // A texture multiplies the material's own colour.
        let own = Material::matte(Color::from_f64([0.5, 1.0, 0.25])).with_texture(0);
        assert_eq!(plane_at::<S>(own, &[stripes], [0.1, 0.1], up), [0.5, 1.0, 0.25]);
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

#[test]
fn a_disc_of_index_one_lets_light_pass_straight() {
    let pane = Object::new(Shape::new(Disc::new(number(1.0)).unwrap()), 0);
    let behind = ball([1.0, -2.0, 0.0], 0.05, 1);
    let look = |index| seen(&[pane, behind], &[glass(index), black::<I16F16>()], [-1.0, 2.0, 0.0], [0.0; 3]).0;
    assert_eq!(look(1.0), 0.0);
    assert_eq!(look(0.0), 0.0, "as NFF files have it where nothing transmits");
    assert!(look(1.2) > 0.9);
}

/// No material gives back more than it gets: a weight above 1 would make light out of nothing, mirror by mirror.
#[test]
fn a_weight_above_one_counts_as_one() {
    fn check<S: Scalar>() {
        let pane = |y, material| {
            let frame = Frame::at(point(0.0, y, 0.0)).unwrap();
            Object::new(Shape::new(Disc::new(number(1.0)).unwrap()).placed(frame), material)
        };
        let half = black().with_refraction(number(0.5), number(1.0));
        let look =
            |farther: Material<S>| seen(&[pane(1.0, 0), pane(0.0, 1)], &[half, farther], [0.0, 3.0, 0.0], [0.0; 3]).0;
        assert_eq!(look(black().with_refraction(number(2.0), number(1.0))), 0.5);
        assert_eq!(look(black().with_mirror(number(2.0))), 0.25, "back through the first");
        let both = black().with_mirror(number(0.75)).with_refraction(number(2.0), number(1.0));
        assert_eq!(look(both), 0.5 * (0.25 + 0.75 * 0.5), "what the mirror leaves passes");
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

/// A normal that leans as far as the waves of a steep sea may send a grazing ray to the wrong side of the surface.
#[test]
fn waves_send_no_ray_to_the_wrong_side() {
    fn check<S: Scalar>() {
        let waves = Waves { along_u: 2, along_v: 2, slope: number(4.0) };
        let black_at = |y, axis| {
            let frame = Frame::from_base_and_axis(point(0.0, y, 0.0), axis).unwrap();
            Object::new(Shape::new(Plane::new()).placed(frame), 1)
        };
        let water = Object::new(Shape::new(Plane::new()), 0);
        let (below, above) = (black_at(-5.0, UnitVec3::Y), black_at(5.0, -UnitVec3::Y));
        let mut passed = 0;
        for i in 0..40_u8 {
            let x = f64::from(i) * 0.061;
            let look = |other, material: Material<S>, height| {
                let materials = [material.with_bump(waves), black()];
                seen(&[water, other], &materials, [x - 1.0, height, 0.2], [x, 0.0, 0.1])
            };
            assert_eq!(look(below, black().with_mirror(number(1.0)), 0.1).0, 1.0, "mirrored at {x}");
            // What passes meets the background, what is reflected the lid: if two rays go on, one of them must bring
            // light.
            for height in [1.0, 0.2] {
                let (red, counters) = look(above, glass(0.8), height);
                assert_eq!(red > 0.0, counters.refraction_rays > 1, "refracted at {x}, from {height}");
                passed += u32::from(red > 0.0);
            }
        }
        assert!((10..80).contains(&passed), "{passed}");
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

/// A ray that only touches a ball of glass is not in it: no fog is left out, and it goes straight on.
#[test]
fn a_ray_that_only_touches_glass_stays_outside() {
    fn check<S: Scalar>() {
        let objects = [ball([0.0; 3], 1.0, 0), ball([0.0, 1.0, -9.0], 2.0, 1)];
        let waves = Waves { along_u: 5, along_v: 3, slope: number(0.5) };
        let fog = Fog::<S>::new(Color::WHITE, S::Unit::from_f64(0.9));
        for touched in [glass(1.5), glass(1.0), glass(1.5).with_bump(waves)] {
            let materials = [touched, black()];
            let scene = Scene::new(&objects, &materials, &[], camera()).unwrap().with_fog(fog);
            let ray = Ray::new(point(0.0, 1.0, 9.0), -UnitVec3::Z).unwrap();
            let mut context = TraceContext::new(());
            let sight = Tracer::new(&scene).uncut().look(&ray, &mut context);
            let red = sight.color.red.to_f64();
            assert_eq!((sight.seen.map(|(object, _)| object), context.counters.refraction_rays), (Some(0), 1));
            assert!((red - (1.0 - 0.9_f64.powi(16))).abs() < 1e-4, "{red}");
        }
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}
