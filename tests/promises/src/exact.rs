//! The promise of the tier `Exact`: hit, miss, touch, part, order, pairing and inside or outside are those of exact
//! arithmetic on the given numbers, always; `t` is within one unit in the last place.
//!
//! In the long form (`.ci/long`) a million rays a primitive.

use fixed::types::{I2F30, I8F24, I16F16, I20F12, I28F4};
use raylet::ExactScalar;
use raylet::tier::{Exact, Precision, Tier};
use raylet::{Range, Ray, Shape};
use std::fmt::Write;
use support::amount::{amount, times};
use support::cases::{Verdict, cases, compare_answers, edge_rays};
use support::exact_types::{Exact as Number, expected};
use support::random::Random;
use support::subject::{SUBJECTS, Subject};
use support::workload::{WORKLOADS, Workload};

/// Fails unless all queries give the exact answer; the error of the worst `t`.
fn assert_exact<S: Number>(name: &str, shape: &Shape<S>, solid: &support::oracle::Solid, ray: &Ray<S>) -> f64
where
    Exact: Tier<S>,
{
    let hits = shape.hits_at::<Exact>(ray);
    let told = match compare_answers(&hits, &expected(solid, ray)) {
        Verdict::Same(error) if error <= 1.0 => {
            assert_eq!(shape.nearest_at::<Exact>(ray), hits.first().copied(), "{name}: {ray:?}");
            assert_eq!(shape.occludes_at::<Exact>(ray), !hits.is_empty(), "{name}: {ray:?}");
            return error;
        }
        Verdict::Same(error) => format!("{error} units off"),
        _ => "another answer".into(),
    };
    panic!("{name} in {}: {told}: {ray:?} gives {hits:?}, exactly {:?}", S::name(), expected(solid, ray))
}

/// The ray with ranges of all kinds: forwards, the whole line, and ending exactly where a hit was reported.
fn ranges<S: Number>(ray: Ray<S>, shape: &Shape<S>, random: &mut Random) -> [Ray<S>; 3]
where
    Exact: Tier<S>,
{
    let line = ray.with_range(Range::line());
    let hits = shape.hits_at::<Exact>(&line);
    let cut = match hits.len() {
        0 => ray,
        n => {
            let t = hits[(random.next() % n as u64) as usize].t;
            let (low, high) = (Range::<S>::line().start(), Range::<S>::line().end());
            let (start, end) = if random.next() & 1 == 0 { (t, high) } else { (low, t) };
            ray.with_range(Range::new(start, end).unwrap())
        }
    };
    [ray, line, cut]
}

/// Beyond the workloads of every tier: what only exact arithmetic gets right.
const HARDER: [Workload; 6] = [
    Workload::Grazing(1e-5),
    Workload::Grazing(1e-6),
    Workload::Grazing(1e-7),
    Workload::NearAxis(1e-7),
    Workload::NearGenerator(1e-7),
    Workload::Away(1e6),
];

struct Tally {
    rays: usize,
    in_integers: usize,
    worst: f64,
}

fn try_workload<S: Number + ExactScalar>(subject: &Subject<S>, workload: Workload, rays: usize, seed: u64) -> Tally
where
    Exact: Tier<S>,
{
    let mut random = Random(seed);
    let mut tally = Tally { rays: 0, in_integers: 0, worst: 0.0 };
    for _ in 0..rays.div_ceil(3) {
        let Some(ray) = workload.ray(subject, &mut random) else { continue };
        for ray in ranges(ray, &subject.shape, &mut random) {
            let error = assert_exact(subject.name, &subject.shape, &subject.solid, &ray);
            tally.worst = tally.worst.max(error);
            tally.rays += 1;
            tally.in_integers += usize::from(subject.shape.precision(&ray) == Precision::Integers);
        }
    }
    tally
}

fn never_wrong<S: Number + ExactScalar>(rays_a_primitive: usize)
where
    Exact: Tier<S>,
{
    println!("{}: in integers, of a million", S::name());
    for name in SUBJECTS {
        let subject = Subject::<S>::new(name);
        let workloads = WORKLOADS.iter().chain(&HARDER).copied();
        let (mut rays, mut worst) = (0, 0.0_f64);
        let mut line = format!("{name:18}");
        for (index, workload) in workloads.enumerate() {
            let tally = try_workload(&subject, workload, rays_a_primitive / 16, 5000 + index as u64);
            rays += tally.rays;
            worst = worst.max(tally.worst);
            if tally.in_integers > 0 {
                let of_a_million = 1e6 * tally.in_integers as f64 / tally.rays as f64;
                write!(line, " {}: {of_a_million:.0}", workload.name()).expect("a string takes everything");
            }
        }
        println!("{line}; {rays} rays, worst {worst:.3} units");
        assert!(rays * 2 > rays_a_primitive, "{name}: only {rays} rays fit the type");
    }
}

macro_rules! types {
    ($($name:ident: $S:ty),+) => {
        $(
            mod $name {
                use super::*;

                #[test]
                fn is_never_wrong() {
                    never_wrong::<$S>(amount(16 * 300, 1_500_000));
                }
                #[test]
                fn is_never_wrong_at_edges() {
                    edges::<$S>();
                }
            }
        )+
    };
}
types!(f32: f32, i16f16: I16F16, i8f24: I8F24, i20f12: I20F12);

/// Rays at, along and through rims, seams, walls, caps and apexes.
fn edges<S: Number + ExactScalar>()
where
    Exact: Tier<S>,
{
    let (mut rays, mut in_integers) = (0, 0);
    for case in cases::<S>() {
        let shape = case.shape();
        for (ray, _) in edge_rays(&case) {
            for ray in [ray, ray.with_range(Range::FORWARD)] {
                assert_exact(case.name, &shape, &case.solid, &ray);
                rays += 1;
                in_integers += usize::from(shape.precision(&ray) == Precision::Integers);
            }
        }
    }
    println!("{}: {in_integers} of {rays} rays at edges are decided in integers", S::name());
}

/// The smallest and the largest sizes, and types of hardly an integer or a fraction bit.
#[test]
fn extremes_of_the_types() {
    fn check<S: Number + ExactScalar>(values: &[S])
    where
        Exact: Tier<S>,
    {
        use raylet::scalar::UnitScalar;
        use raylet::{Capsule, Cone, Cuboid, Cylinder, Disc, Primitive, Rectangle, Sphere, UnitVec3, Vec3};
        use support::oracle::{ConeExtent, CylinderExtent, Solid};
        let mut random = Random(9);
        let mut tried = 0;
        for _ in 0..times(6_000) {
            let pick = |random: &mut Random| values[(random.next() % values.len() as u64) as usize];
            let (r, h) = (pick(&mut random), pick(&mut random));
            let (radius, height) = (r.exact(), h.exact());
            let built: Option<(Primitive<S>, Solid)> = match random.next() % 9 {
                0 => Sphere::new(r).ok().map(|p| (p.into(), Solid::Sphere { radius })),
                1 => Cylinder::capped(r, h)
                    .ok()
                    .map(|p| (p.into(), Solid::Cylinder { radius, extent: CylinderExtent::Capped(height) })),
                2 => Capsule::new(r, h).ok().map(|p| (p.into(), Solid::Capsule { radius, height })),
                3 => Cone::capped(r, h)
                    .ok()
                    .map(|p| (p.into(), Solid::Cone { slope: radius, extent: ConeExtent::Capped(height) })),
                4 => {
                    Cone::double(r).ok().map(|p| (p.into(), Solid::Cone { slope: radius, extent: ConeExtent::Double }))
                }
                5 => {
                    let top = pick(&mut random);
                    Cone::frustum(r, top, h).ok().map(|p| {
                        let top_radius = top.exact();
                        (p.into(), Solid::Frustum { base_radius: radius, top_radius, height, capped: true })
                    })
                }
                6 => {
                    let depth = pick(&mut random);
                    Cuboid::new(r, h, depth).ok().map(|p| {
                        let half = [radius, height, depth.exact()];
                        (p.into(), Solid::Cuboid { half })
                    })
                }
                7 => Rectangle::new(r, h).ok().map(|p| (p.into(), Solid::Rectangle { half: [radius, height] })),
                _ => Disc::new(r).ok().map(|p| (p.into(), Solid::Disc { radius })),
            };
            let Some((primitive, solid)) = built else { continue };
            let signed = |random: &mut Random| {
                let value = pick(random);
                if random.next() & 1 == 0 { value } else { -value }
            };
            let origin = Vec3::new(signed(&mut random), signed(&mut random), signed(&mut random));
            let towards = if random.next() & 1 == 0 {
                random.direction()
            } else {
                let [x, y, z] = [(); 3].map(|()| (random.next() % 3) as f64 - 1.0);
                if [x, y, z] == [0.0; 3] { [0.0, 1.0, 0.0] } else { support::random::normalize([x, y, z]) }
            };
            let Ok(direction) = UnitVec3::from_components(towards.map(<S::Unit as UnitScalar>::from_f64)) else {
                continue;
            };
            let Ok(ray) = Ray::new(origin, direction) else { continue };
            for ray in [ray, ray.with_range(Range::line())] {
                assert_exact("extremes", &Shape::new(primitive), &solid, &ray);
                tried += 1;
            }
        }
        assert!(tried > 5_000, "{}: only {tried} rays", S::name());
    }
    let floats =
        [0.0, f32::from_bits(1), 1e-40, f32::MIN_POSITIVE, 1e-20, 1e-3, 0.75, 1.0, 3.0, 1e10, 1e20, 2.0_f32.powi(126)];
    check::<f32>(&floats);
    fn raw<F: fixed::types::extra::LeEqU32>() -> Vec<fixed::FixedI32<F>> {
        [0, 1, 2, 3, 1000, 65535, 65536, 1 << 24, (1 << 30) - 1, 1 << 30].map(fixed::FixedI32::from_bits).to_vec()
    }
    check::<I16F16>(&raw());
    check::<I2F30>(&raw());
    check::<I28F4>(&raw());
}

// Found by a reviewer.

/// Two roots next to the same midpoint of two floats are reported in order.
#[test]
fn roots_beside_a_midpoint_stay_in_order() {
    use raylet::{Cone, Frame, UnitVec3, Vec3};
    let frame = Frame::at(Vec3::new(0.0_f32, 1.0, 0.0)).unwrap();
    let ray = Ray::new(Vec3::new(2.0_f32.powi(-60), -2.0_f32.powi(-24), 0.0), UnitVec3::Y).unwrap();
    let mut random = Random(4);
    for _ in 0..times(2_000) {
        let slope = random.between(0.5, 2.0) as f32;
        let cone = Shape::new(Cone::double(slope).unwrap()).placed(frame);
        let hits = cone.hits_at::<Exact>(&ray);
        assert!(hits.len() == 2 && hits[0].t <= hits[1].t, "{slope}: {hits:?}");
    }
}

/// Corners on a line as exact arithmetic sees them, though not as rounded differences do: nothing lies in that
/// triangle.
#[test]
fn a_triangle_without_area_holds_nothing() {
    use raylet::{Triangle, UnitVec3, Vec3};
    let tiny = 2.0_f32.powi(-24);
    let corners = [Vec3::new(1.0, 3.0, 0.0), Vec3::new(tiny, 3.0 * tiny, 0.0), Vec3::new(2.0, 6.0, 0.0)];
    let triangle = Triangle::new(corners[0], corners[1], corners[2]).expect("rounded differences see an area");
    let ray = Ray::new(Vec3::new(-50.0, 70.0, 9.0), UnitVec3::Z).unwrap();
    assert!(triangle.hits_at::<Exact>(&ray).coincident().is_none());
    assert!(!triangle.contains_at::<Exact>(Vec3::new(5.0, -7.0, 100.0)));
}

/// Where the coefficients of a far smaller root vanish in doubles, its sign is still decided.
#[test]
fn a_root_below_the_range_of_doubles_has_its_sign() {
    use raylet::{Affine, Cone, Frame, UnitVec3, Vec3};
    let p = |e: i32| f32::from_bits(if e < -126 { 1 << (e + 149) } else { ((e + 127) as u32) << 23 });
    let frame = Frame::at(Vec3::new(0.0, 0.0, p(-149))).unwrap();
    let affine = Affine::stretched(frame, Vec3::new(1.0, p(-127), p(126))).unwrap();
    let shape = Shape::new(Cone::frustum(p(-149), p(126), p(-149)).unwrap()).placed(affine);
    let origin = Vec3::new(p(-149), 0.0, p(-60));
    let hits = shape.hits_at::<Exact>(&Ray::new(origin, -UnitVec3::Y).unwrap());
    assert!(hits.is_empty() && !hits.starts_inside(), "{hits:?}");
    assert!(!shape.contains_at::<Exact>(origin));
}
