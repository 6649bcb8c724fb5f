//! Faults 2, 7 and 9 of the first solver: `Stable` keeps its promise unplaced, `Exact` is right for every size that a
//! constructor takes, and a line that misses by far touches nothing.

use crate::named::{Want, assert_hits, bits, extreme, extreme_ray, extreme_solid, judge, line_in, ray, seen};
use fixed::types::I16F16;
use raylet::tier::{Exact, Fast, Stable, Tier};
use raylet::{
    Affine, Capsule, Cone, Crossing, Cylinder, Frame, Object, Part, Range, Ray, Revolved, Scalar, Shape, Sphere,
    UnitVec3, Vec3,
};
use support::amount::times;
use support::cases::{direction, n, v};
use support::exact_types::{Exact as Number, exact_line};
use support::oracle::{self, CylinderExtent, Line, Solid};
use support::random::{Random, add, scale};

const SIDE_IN: (Part, Crossing) = (Part::Side, Crossing::Enter);
const SIDE_OUT: (Part, Crossing) = (Part::Side, Crossing::Exit);

fn at(t: f64, (part, crossing): (Part, Crossing)) -> Want {
    (t, part, crossing)
}

/// Was 34.1 units off. From .017 of the radius inside, .022 of it deep; the line enters behind the start.
#[test]
fn a_ball_is_left_from_inside_within_16_units() {
    let ball = Shape::new(Sphere::new(f32::from_bits(0x419a_86ef)).unwrap());
    let ray = ray(bits([0xc0c7_4cf1, 0x4187_d86e, 0xc0b8_677a]), bits([0xbf5b_6608, 0xbef8_aace, 0xbe30_3f1f]));
    let both = [at(-2.1369514682962583, SIDE_IN), at(5.972205340441352, SIDE_OUT)];
    for (ray, want) in [(ray, &both[1..]), (ray.with_range(Range::line()), &both[..])] {
        assert_hits::<f32, Stable>(&ball, &ray, want, 16.0);
        assert_hits::<f32, Exact>(&ball, &ray, want, 1.0);
    }
    assert!(ball.hits(&ray).starts_inside());
}

/// Was 20.9 units off. Both ends are on the upper nappe, at y = .269 and 7.16.
#[test]
fn a_double_cone_is_met_within_16_units() {
    let cone = Shape::new(Cone::double(f32::from_bits(0x3f9f_f831)).unwrap());
    let ray = ray(bits([0x4077_c8f1, 0xc05a_84cb, 0xc05a_47b1]), bits([0xbf13_7788, 0x3f19_98b9, 0x3f0e_1e47]));
    let want = [at(6.13838669436982, SIDE_IN), at(17.627619301415656, SIDE_OUT)];
    assert_hits::<f32, Stable>(&cone, &ray, &want, 16.0);
    assert_hits::<f32, Exact>(&cone, &ray, &want, 1.0);
}

/// Components of a direction by their bits.
fn unit_bits(raw: [i32; 3]) -> [raylet::scalar::Unit<I16F16>; 3] {
    raw.map(raylet::scalar::Unit::<I16F16>::from_bits)
}

/// Was 1.22 units off.
#[test]
fn a_ball_in_fixed_point_is_met_within_a_unit() {
    let ball = Shape::new(Sphere::new(I16F16::from_bits(611_173_980)).unwrap());
    let origin = [412_965_660, 818_508_205, -113_212_755].map(I16F16::from_bits);
    let ray = ray(origin, unit_bits([-963_782_068, -473_017_270, -17_328_920]));
    let want = [at(7641.16904878648, SIDE_IN), at(14619.15602440238, SIDE_OUT)];
    assert_hits::<I16F16, Stable>(&ball, &ray, &want, 1.0);
    assert_hits::<I16F16, Exact>(&ball, &ray, &want, 1.0);
}

/// Was 4.11 units off. Behind the start the line leaves the nappe at y = 43,504; the other root is the lower nappe's,
/// beyond the type.
#[test]
fn a_nappe_in_fixed_point_is_met_within_a_unit() {
    let nappe = Shape::new(Cone::nappe(I16F16::from_bits(37_405)).unwrap());
    let origin = [-547_557_535, 1_056_298_600, -787_040_413].map(I16F16::from_bits);
    let ray = ray(origin, unit_bits([-150_575_558, -967_399_043, 440_894_088])).with_range(Range::line());
    let want = [at(-30396.83242631692, SIDE_OUT)];
    assert_hits::<I16F16, Stable>(&nappe, &ray, &want, 1.0);
    assert_hits::<I16F16, Exact>(&nappe, &ray, &want, 1.0);
    assert!(nappe.hits(&ray).starts_inside());
}

/// `Exact` had no hit, and panicked where overflow is checked. The side is z = y / h: in at y = 2^-298, out of the top
/// at y = 2^-149, both at a t that rounds to -2^126.
#[test]
fn exact_meets_the_flattest_frustum_from_the_farthest_start() {
    let (least, most) = (f32::from_bits(1), 2.0_f32.powi(126));
    let frustum = Shape::new(Cone::frustum(0.0, 1.0, least).unwrap());
    let ray = Ray::new(Vec3::new(0.0, most, least), UnitVec3::Y).unwrap().with_range(Range::line());
    let t = -2.0_f64.powi(126);
    assert_hits::<f32, Exact>(&frustum, &ray, &[at(t, SIDE_IN), (t, Part::Top, Crossing::Exit)], 1.0);
    assert!(!frustum.hits_at::<Exact>(&ray).starts_inside());
}

/// The solid and the ray, placed: moved by extreme coordinates, or stretched by extreme powers of two too. (A stretch
/// by powers of two is stored exactly.) `None` where the placement is refused.
fn placed<S: Number>(random: &mut Random, shape: Shape<S>, solid: &Solid, ray: &Ray<S>) -> Option<(Shape<S>, Line)> {
    let coordinate = |random: &mut Random| if random.below(2) == 0 { S::ZERO } else { extreme(random) };
    let frame = Frame::at([(); 3].map(|()| coordinate(random)).into()).ok()?;
    let moved = line_in(&frame, solid, ray);
    match random.below(3) {
        0 => Some((shape, exact_line(ray))),
        1 => Some((shape.placed(frame), moved)),
        _ => {
            let exponents = [(); 3].map(|()| {
                random.pick(if S::name() == "f32" {
                    &[-126, -60, -1, 0, 3, 60, 125]
                } else {
                    &[-8, -3, -1, 0, 1, 3, 8]
                })
            });
            let factors = exponents.map(|e| n::<S>(libm::ldexp(1.0, e)));
            let stretched = Affine::stretched(frame, factors.into()).ok()?;
            let shrink = |v: [oracle::Dyadic; 3]| [0, 1, 2].map(|i| v[i].scaled(-(exponents[i] as isize)));
            Some((shape.placed(stretched), Line::new(shrink(moved.origin), shrink(moved.direction))))
        }
    }
}

/// Either the numbers hold what a constructor takes, or the constructor refuses it: each solid, at extreme sizes, in
/// extreme placements.
fn exact_is_right_for_every_size_that_is_taken<S: Number>()
where
    Exact: Tier<S>,
{
    let (mut random, mut tried) = (Random(18), 0);
    while tried < times(3_000) {
        let Some((primitive, solid)) = extreme_solid::<S>(&mut random) else { continue };
        let ray = extreme_ray::<S>(&mut random);
        let Some((shape, line)) = placed(&mut random, Shape::new(primitive), &solid, &ray) else { continue };
        tried += 1;
        match judge::<S, Exact>(&shape, &solid, &line, &ray) {
            Ok(error) => assert!(error <= 1.0, "{error} units: {ray:?} at {shape:?}"),
            Err(told) => panic!("{} in {}: {told}", tried, S::name()),
        }
    }
}

#[test]
fn exact_is_right_for_every_size_that_is_taken_in_f32() {
    exact_is_right_for_every_size_that_is_taken::<f32>();
}

#[test]
fn exact_is_right_for_every_size_that_is_taken_in_i16f16() {
    exact_is_right_for_every_size_that_is_taken::<I16F16>();
}

/// Was no hit: the two ends, 1e-13 apart at a `t` of 1e10, came out of the doubles in the wrong order.
#[test]
fn exact_finds_a_chord_below_the_rounding_of_doubles() {
    let (top, height) = (1e-3_f32, 1e20_f32);
    let needle = Shape::new(Cone::frustum(0.0, top, height).unwrap());
    let solid =
        Solid::Frustum { base_radius: 0.0_f32.exact(), top_radius: top.exact(), height: height.exact(), capped: true };
    let half = core::f32::consts::FRAC_1_SQRT_2;
    let across = UnitVec3::from_components([-half, half, 0.0]).unwrap();
    let ray = Ray::new(Vec3::new(1e10, 3.0, 1e-20), across).unwrap();
    assert_eq!(needle.hits_at::<Exact>(&ray).len(), 2);
    assert!(judge::<f32, Exact>(&needle, &solid, &exact_line(&ray), &ray).is_ok_and(|error| error <= 1.0));
}

/// Every number that the equations of these solids have is as small, as ordinary or as large as the type holds it: all
/// of them, with every start of such coordinates, along an axis and across. A size may be refused.
#[test]
fn exact_is_right_where_the_numbers_of_a_solid_are_at_their_extremes() {
    let numbers = [0.0, f32::from_bits(1), 1.0, 2.0_f32.powi(126)];
    let mut solids = vec![];
    for [r, h, s] in (1..64).map(|i| [i % 4, i / 4 % 4, i / 16].map(|i: usize| numbers[i])) {
        let [radius, height, top_radius] = [r, h, s].map(f32::exact);
        let frustum = Cone::frustum(r, s, h).map(Shape::new);
        let exact = |capped| {
            let (base_radius, top_radius, height) = (radius.clone(), top_radius.clone(), height.clone());
            Solid::Frustum { base_radius, top_radius, height, capped }
        };
        solids.extend(frustum.ok().map(|frustum| (frustum, exact(true))));
        solids.extend(Cone::frustum_open(r, s, h).ok().map(|open| (Shape::new(open), exact(false))));
        for a in [-1.0, 0.0, f32::from_bits(1), f32::BUDGET.slope] {
            let [low, high] = if a < 0.0 { [0.0, r] } else { [0.0, h] };
            let (built, b) = (Revolved::new(a, s, r, [low, high]), s.exact());
            let [a, r, low, high] = [a, r, low, high].map(f32::exact);
            let solid = Solid::Revolved(oracle::Revolved { a, b, r, low, high, capped: true });
            solids.extend(built.ok().map(|built| (Shape::new(built), solid)));
        }
        if s == 1.0 {
            let capsule = Solid::Capsule { radius: radius.clone(), height: height.clone() };
            solids.extend(Capsule::new(r, h).ok().map(|built| (Shape::new(built), capsule)));
            let extent = CylinderExtent::Capped(height.clone());
            let cylinder = Solid::Cylinder { radius: radius.clone(), extent };
            solids.extend(Cylinder::capped(r, h).ok().map(|built| (Shape::new(built), cylinder)));
        }
    }
    for (shape, solid) in &solids {
        for origin in (0..64).map(|i| [i % 4, i / 4 % 4, i / 16].map(|i: usize| numbers[i])) {
            for along in [UnitVec3::X, UnitVec3::Y, -UnitVec3::Y, direction([0.6, 0.0, 0.8])] {
                let ray = Ray::new(origin.into(), along).unwrap().with_range(Range::line());
                match judge::<f32, Exact>(shape, solid, &exact_line(&ray), &ray) {
                    Ok(error) => assert!(error <= 1.0, "{error} units: {ray:?} at {shape:?}"),
                    Err(told) => panic!("{told}"),
                }
            }
        }
    }
    assert!(solids.len() > 20, "{} solids", solids.len());
}

/// The frustum of fault 9, and a ray that passes 7e10 from its base.
fn frustum_missed_by_far() -> (Shape<f32>, Ray<f32>) {
    let [base, top, height] = bits([0x3fd2_a4f2, 0x3feb_5e9f, 0x3f23_4174]);
    let ray = ray(bits([0xd15d_429f, 0x518c_ea6e, 0xd04c_6f31]), bits([0xbe1d_b3e4, 0xbf79_e5e6, 0x3e1c_97ca]));
    (Shape::new(Cone::frustum(base, top, height).unwrap()), ray)
}

#[test]
fn a_frustum_missed_by_far_is_not_touched() {
    let (frustum, ray) = frustum_missed_by_far();
    assert_hits::<f32, Stable>(&frustum, &ray, &[], 0.0);
    assert_hits::<f32, Exact>(&frustum, &ray, &[], 0.0);
}

#[test]
fn fast_does_not_touch_a_frustum_missed_by_far_either() {
    let (frustum, ray) = frustum_missed_by_far();
    assert_hits::<f32, Fast>(&frustum, &ray, &[], 0.0);
}

#[test]
fn a_hierarchy_sees_no_frustum_missed_by_far_and_nor_does_a_scene_without() {
    let (frustum, ray) = frustum_missed_by_far();
    let aside = Frame::at(Vec3::new(9.0, 0.0, 0.0)).unwrap();
    let objects =
        [frustum, frustum.placed(aside), Shape::new(Sphere::new(1.0).unwrap())].map(|shape| Object::new(shape, 0));
    let [plain, boxed] = seen(&objects, &ray);
    assert!(plain.is_none() && boxed.is_none(), "{plain:?}, {boxed:?}");
}

/// Lines from 10 to the power of these exponents away, that miss a ball of radius 8 about the frustum by exact
/// arithmetic.
fn lines_that_miss_by_far_touch_nothing<S: Number, T: Tier<S>>(least: f64, most: f64) {
    let (mut random, mut missed, mut invented) = (Random(19), 0, vec![]);
    let around = Solid::Sphere { radius: n::<S>(8.0).exact() };
    let frustums = [[1.3, 0.6, 1.7], [1.6456587, 1.8388251, 0.6377175], [0.0, 1.0, 1.0], [1.0, 1.0, 2.0]]
        .map(|[base, top, height]| Shape::new(Cone::frustum(n::<S>(base), n(top), n(height)).unwrap()));
    while missed < times(2_000) {
        let (along, frustum) = (random.direction(), random.pick(&frustums));
        let away = 10.0_f64.powf(random.between(least, most));
        let beside = scale(random.perpendicular(along), if random.below(2) == 0 { 100.0 } else { away });
        let ray = Ray::new(v::<S>(add(scale(along, -away), beside)), direction(along)).unwrap();
        if oracle::margin(&around, &exact_line(&ray)).is_some_and(|margin| margin > 1.0) {
            missed += 1;
            let hits = frustum.hits_at::<T>(&ray);
            invented.extend((!hits.is_empty()).then(|| format!("{hits:?} of {ray:?} at {frustum:?}")));
        }
    }
    assert!(invented.is_empty(), "{} of {missed} in {}, first {}", invented.len(), S::name(), invented[0]);
}

#[test]
fn lines_that_miss_a_frustum_by_far_touch_nothing_in_floats() {
    lines_that_miss_by_far_touch_nothing::<f32, Stable>(9.0, 16.0);
    lines_that_miss_by_far_touch_nothing::<f32, Exact>(9.0, 16.0);
    lines_that_miss_by_far_touch_nothing::<f64, Stable>(9.0, 40.0);
}

#[test]
fn fast_touches_no_frustum_that_is_missed_by_far_either() {
    lines_that_miss_by_far_touch_nothing::<f32, Fast>(9.0, 16.0);
    lines_that_miss_by_far_touch_nothing::<f64, Fast>(9.0, 40.0);
}

/// Was one touch of the side where the line enters through one cap and leaves through the other: both are at the same
/// rounded `t`. (In `Stable` rounding decides what is within a unit of touching.)
#[test]
fn a_coin_thinner_than_a_unit_is_entered_and_left() {
    let coin = Shape::new(Cylinder::capped(2.0_f32, 1e-40).unwrap());
    let ray = Ray::new(Vec3::new(0.75, 1.0, 0.0), direction([-1.0, -1.0, 1.0])).unwrap();
    let t = 1.7320508386561266;
    let want = [(t, Part::Top, Crossing::Enter), (t, Part::Base, Crossing::Exit)];
    assert_hits::<f32, Exact>(&coin, &ray, &want, 1.0);
}

/// Was on the side: the height at which the line leaves was rounded to that of the seam.
#[test]
fn a_capsule_is_left_through_its_top_however_high_that_is() {
    let height = 8.507059e37_f32;
    let pill = Shape::new(Capsule::new(1.25, height).unwrap());
    let ray = Ray::new(Vec3::new(0.0, height, 0.0), direction([0.0, 0.6, 0.8])).unwrap();
    let want = [(1.25, Part::Top, Crossing::Exit)];
    assert_hits::<f32, Exact>(&pill, &ray, &want, 1.0);
    assert_hits::<f32, Stable>(&pill, &ray, &want, 1.0);
}

/// The guard of a ball next to the start is a product of six lengths: from a radius of 2.5 million on it overflowed in
/// `f32`, below 3e-8 it vanished, and every end was taken for good.
#[test]
fn balls_of_any_size_are_met_within_16_units() {
    let mut random = Random(17);
    for exponent in (-40..45).step_by(3) {
        let r = n::<f32>(1.37 * 2.0_f64.powi(exponent));
        let (ball, solid) = (Shape::new(Sphere::new(r).unwrap()), Solid::Sphere { radius: r.exact() });
        for _ in 0..times(200) {
            let out = random.direction();
            let origin = scale(out, f64::from(r) * (1.0 + random.between(0.001, 0.1)));
            let aside = add(random.direction(), scale(out, -1.5));
            let ray = Ray::new(v::<f32>(origin), direction(aside)).unwrap();
            let line = exact_line(&ray);
            if oracle::margin(&solid, &line).is_some_and(|margin| (margin - 1.0).abs() > 1e-2)
                && let Ok(units) = crate::named::judge::<f32, Stable>(&ball, &solid, &line, &ray)
            {
                assert!(units <= 16.0, "{units} units at a radius of {r}: {ray:?}");
            }
        }
    }
}
