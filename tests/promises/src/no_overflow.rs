//! Nothing overflows, nothing panics, no result is NaN: at the budget's limits and on every raw value that a
//! constructor lets in, for floats and for fixed point of every kind. The tests are built with overflow checks.

use fixed::types::extra::{LeEqU32, LeEqU64, U0, U16, U30, U32, U64};
use fixed::{FixedI32, FixedI64};
use raylet::scalar::UnitScalar;
use raylet::{
    Affine, Annulus, Capsule, Cone, Cuboid, Cylinder, Departure, Disc, Frame, HalfSpace, Leaving, Part, Plane,
    Polyhedron, Primitive, Prism, Range, Ray, Rectangle, Revolved, RoundCone, RoundedCuboid, Scalar, Shape, Sphere,
    Torus, Triangle, Tube, UnitVec3, Vec3, Visible,
};
use support::amount::times;
use support::random::Random;

/// A number type with raw values to try.
trait Raw: Scalar {
    /// From any bits.
    fn from_random(random: &mut Random) -> Self;
    /// Values at the ends of the type, of the budget, and around one and zero.
    fn extremes() -> Vec<Self>;
    /// True if the square of the smallest number beside the largest is zero: a solid may be 2^200 times as long as
    /// wide, and what is decided there by squares is decided by nothing.
    const SQUARES_VANISH: bool;
    /// Components of a direction.
    fn unit_from(value: f64) -> Self::Unit;
}

macro_rules! raw_fixed {
    ($Fixed:ident, $LeEq:ident, $raw:ty, $bits:literal) => {
        impl<F: $LeEq + Send + Sync + 'static> Raw for $Fixed<F> {
            fn from_random(random: &mut Random) -> Self {
                // Any number of leading zeros is as likely as any other.
                let shift = random.below($bits) as u32;
                Self::from_bits((random.next() as $raw) >> shift)
            }
            fn extremes() -> Vec<Self> {
                let budget: $raw = 1 << ($bits - 2);
                let raws = [
                    <$raw>::MIN,
                    <$raw>::MIN + 1,
                    -budget - 1,
                    -budget,
                    -budget + 1,
                    -(budget >> 1),
                    -1,
                    0,
                    1,
                    2,
                    3,
                    1 << ($bits / 2),
                    budget >> 1,
                    budget - 1,
                    budget,
                    budget + 1,
                    <$raw>::MAX - 1,
                    <$raw>::MAX,
                ];
                raws.map(Self::from_bits).to_vec()
            }
            const SQUARES_VANISH: bool = false;
            fn unit_from(value: f64) -> Self::Unit {
                <Self::Unit as UnitScalar>::from_f64(value)
            }
        }
    };
}
raw_fixed!(FixedI32, LeEqU32, i32, 32);
raw_fixed!(FixedI64, LeEqU64, i64, 64);

macro_rules! raw_float {
    ($Float:ident, $bits:ty) => {
        impl Raw for $Float {
            fn from_random(random: &mut Random) -> Self {
                $Float::from_bits(random.next() as $bits)
            }
            fn extremes() -> Vec<Self> {
                let budget = <$Float as Scalar>::BUDGET.coordinate;
                let positive = [
                    0.0,
                    $Float::from_bits(1),
                    $Float::from_bits(12345),
                    $Float::MIN_POSITIVE,
                    $Float::MIN_POSITIVE.sqrt(),
                    $Float::EPSILON,
                    1.0,
                    3.0,
                    $Float::MAX.sqrt(),
                    budget / 3.0,
                    budget,
                    $Float::MAX,
                    $Float::INFINITY,
                    $Float::NAN,
                ];
                positive.into_iter().flat_map(|x: $Float| [x, -x]).collect()
            }
            const SQUARES_VANISH: bool = true;
            fn unit_from(value: f64) -> $Float {
                value as $Float
            }
        }
    };
}
raw_float!(f32, u32);
raw_float!(f64, u64);

/// Every primitive that these sizes make.
fn primitives<S: Raw>(a: S, b: S, c: S, vertices: [Vec3<S>; 3]) -> Vec<Primitive<S>> {
    let [p, q, r] = vertices;
    let mut all: Vec<Primitive<S>> = vec![Plane::new().into()];
    all.extend(Sphere::new(a).map(Primitive::from));
    all.extend(Disc::new(a).map(Primitive::from));
    all.extend(Rectangle::new(a, b).map(Primitive::from));
    all.extend(Cuboid::new(a, b, c).map(Primitive::from));
    all.extend(Cylinder::infinite(a).map(Primitive::from));
    all.extend(Cylinder::open(a, b).map(Primitive::from));
    all.extend(Cylinder::capped(a, b).map(Primitive::from));
    all.extend(Capsule::new(a, b).map(Primitive::from));
    all.extend(Cone::double(a).map(Primitive::from));
    all.extend(Cone::nappe(a).map(Primitive::from));
    all.extend(Cone::open(a, b).map(Primitive::from));
    all.extend(Cone::capped(a, b).map(Primitive::from));
    all.extend(Cone::frustum(a, b, c).map(Primitive::from));
    all.extend(Cone::frustum_open(a, b, c).map(Primitive::from));
    let negative = |size: S| if size.is_finite() { -size } else { size };
    let (zero, heights, one) = (S::ZERO, [negative(b), c], S::from_f64(1.0).unwrap_or(a));
    all.extend(Revolved::new(zero, a, c, [zero, b]).map(Primitive::from));
    all.extend(Revolved::new(negative(one), zero, a, [negative(a), a]).map(Primitive::from));
    all.extend(Revolved::new(one, b, a, heights).map(|revolved| Primitive::from(revolved.open())));
    all.extend(Revolved::hyperboloid(a, b, heights).map(Primitive::from));
    all.extend(Revolved::spheroid(a, b, [negative(b), b]).map(Primitive::from));
    all.extend(Revolved::tower(c, a, b, c).map(Primitive::from));
    all.extend(Revolved::optical(a, negative(one), b).map(Primitive::from));
    all.extend(Tube::new(a, b, c).map(Primitive::from));
    all.extend(RoundCone::new(a, b, c).map(Primitive::from));
    all.extend(RoundedCuboid::new(a, b, zero, c).map(Primitive::from));
    all.extend(Tube::with_wall(a, b, c).map(Primitive::from));
    all.extend(Annulus::new(a, b).map(Primitive::from));
    all.extend(Torus::new(a, b).map(Primitive::from));
    all.extend(
        Prism::new(vec![[a, zero], [zero, negative(b)], [negative(c), zero], [zero, a]].leak(), b).map(Primitive::from),
    );
    let half_spaces: Vec<_> = [(p, q), (q, r), (r, p)].iter().flat_map(|(p, q)| HalfSpace::new(*p, *q)).collect();
    all.extend(Polyhedron::within(p, q, half_spaces.clone().leak()).map(Primitive::from));
    all.extend(Polyhedron::new(half_spaces.leak()).map(Primitive::from));
    all.extend(Triangle::new(p, q, r).map(Primitive::from));
    all
}

/// False for NaN of any kind.
fn is_number<S: Scalar>(value: S) -> bool {
    value.partial_cmp(&S::ZERO).is_some()
}

fn is_unit_number<S: Scalar>(value: S::Unit) -> bool {
    value.partial_cmp(&<S::Unit as UnitScalar>::ZERO).is_some()
}

/// Calls everything.
fn call_everything<S: Raw>(shape: &Shape<S>, ray: &Ray<S>) {
    let hits = shape.hits(ray);
    assert!(hits.len() <= raylet::hit::MOST_HITS);
    assert!(hits.windows(2).all(|pair| pair[0].t <= pair[1].t), "unsorted or NaN: {hits:?} {shape:?} {ray:?}");
    assert_eq!(shape.nearest(ray), hits.first().copied(), "{shape:?} {ray:?}");
    // Where squares vanish a small solid is a point for the solver, and the signs know better.
    if !S::SQUARES_VANISH {
        assert_eq!(shape.occludes(ray), !hits.is_empty(), "{shape:?} {ray:?}");
    }
    if let Some(range) = hits.coincident() {
        assert!(range.start() <= range.end());
    }
    for hit in &hits {
        assert!(hit.t.is_finite() && ray.range().contains(hit.t), "{hit:?} {shape:?} {ray:?}");
        let surface = shape.surface(ray, hit);
        let (point, local) = (surface.point(), surface.local_point());
        let numbers = point.to_array().into_iter().chain(local.to_array()).all(is_number);
        assert!(numbers, "{point:?} {local:?} of {hit:?} {shape:?} {ray:?}");
        let (u, v) = surface.uv();
        let (tu, tv) = surface.tangents();
        let units = [surface.normal(), surface.normal_towards_ray(), tu, tv];
        let units = units.into_iter().flat_map(UnitVec3::to_array).chain([u, v]).all(is_unit_number::<S>);
        assert!(
            units,
            "{:?} {:?} {:?} of {hit:?} {shape:?} {ray:?}",
            surface.normal(),
            surface.uv(),
            surface.tangents()
        );
        for leaving in [Leaving::Inwards, Leaving::Outwards] {
            if let Ok(next) = Ray::new(point, ray.direction()) {
                let again = shape.hits(&next.departing(surface.departure(0, leaving)));
                assert!(again.iter().all(|hit| hit.t.is_finite()), "{again:?} {shape:?} {next:?}");
            }
        }
    }
    let bounds = shape.bounds();
    assert!(bounds.low.to_array().into_iter().chain(bounds.high.to_array()).all(is_number), "{bounds:?} {shape:?}");
    assert!((0..3).all(|i| bounds.low.to_array()[i] <= bounds.high.to_array()[i]), "{bounds:?} {shape:?}");
    let _ = shape.contains(ray.origin());
}

fn directions<S: Raw>(random: &mut Random) -> Vec<UnitVec3<S>> {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let tiny = 2.0_f64.powi(-30);
    let mut all = vec![UnitVec3::X, UnitVec3::Y, UnitVec3::Z, -UnitVec3::X, -UnitVec3::Y, -UnitVec3::Z];
    let [a, b, c] = [(); 3].map(|()| random.between(-1.0, 1.0));
    let length = (a * a + b * b + c * c).sqrt();
    for components in [
        [half, half, 0.0],
        [0.0, -half, half],
        [tiny, 1.0, 0.0],
        [-1.0, tiny, tiny],
        [a / length, b / length, c / length],
    ] {
        all.extend(UnitVec3::from_components(components.map(S::unit_from)));
    }
    all
}

fn at_the_extremes<S: Raw>() {
    let (values, mut random) = (S::extremes(), Random(1));
    let mut called = 0;
    for round in 0..times(2500) {
        let mut pick = || if round % 3 == 2 { S::from_random(&mut random) } else { random.pick(&values) };
        let sizes = [pick(), pick(), pick()];
        let [p, q, r, origin, position, x, y, z, scale] = [(); 9].map(|()| Vec3::new(pick(), pick(), pick()));
        let (start, end) = (pick(), pick());
        let Ok(ray) = Ray::new(origin, UnitVec3::X) else { continue };
        let along = directions::<S>(&mut random);
        let mut placements = vec![];
        let axis = random.pick(&along);
        placements.extend(Frame::at(position).map(raylet::Placement::from));
        placements.extend(Frame::from_base_and_axis(position, axis).map(raylet::Placement::from));
        placements.extend(Frame::between(position, p).map(|(frame, _)| raylet::Placement::from(frame)));
        placements.extend(Frame::looking(position, axis, UnitVec3::Y).map(raylet::Placement::from));
        placements.extend(Affine::new(position, [x, y, z]).map(raylet::Placement::from));
        if let Ok(frame) = Frame::from_base_and_axis(position, axis) {
            placements.extend(Affine::stretched(frame, scale).map(raylet::Placement::from));
        }
        for primitive in primitives(sizes[0], sizes[1], sizes[2], [p, q, r]) {
            let shape = Shape::new(primitive);
            let direction = random.pick(&along);
            let mut rays = vec![Ray::new(ray.origin(), direction).expect("the origin was taken before")];
            rays.push(rays[0].with_range(Range::line()));
            rays.extend(Range::new(start, end).map(|range| rays[0].with_range(range)));
            rays.extend(Ray::towards(ray.origin(), p));
            rays.push(rays[0].departing(Departure {
                object: 0,
                part: random.pick(&[Part::Side, Part::Base, Part::Top]),
                leaving: random.pick(&[Leaving::Inwards, Leaving::Outwards]),
            }));
            for ray in &rays {
                call_everything(&shape, ray);
                call_everything(&shape.seen_from(Visible::Outside), &ray.without_departure());
                for placement in &placements {
                    call_everything(&shape.placed(*placement), ray);
                }
                called += 1;
            }
        }
    }
    assert!(called > 1000, "too few of the values are within the budget: {called}");
}

macro_rules! extremes {
    ($($name:ident: $Type:ty),+ $(,)?) => {
        $(
            #[test]
            fn $name() {
                at_the_extremes::<$Type>();
            }
        )+
    };
}
extremes! {
    f32_at_subnormal_and_largest_magnitudes: f32,
    f64_at_subnormal_and_largest_magnitudes: f64,
    fixed_32_with_0_fraction_bits: FixedI32<U0>,
    fixed_32_with_16_fraction_bits: FixedI32<U16>,
    fixed_32_with_30_fraction_bits: FixedI32<U30>,
    fixed_32_with_32_fraction_bits: FixedI32<U32>,
    fixed_64_with_0_fraction_bits: FixedI64<U0>,
    fixed_64_with_32_fraction_bits: FixedI64<U32>,
    fixed_64_with_64_fraction_bits: FixedI64<U64>,
}

#[cfg(feature = "every-type")]
mod every_type {
    use super::*;
    use fixed::types::extra::{U1, U8, U24, U29, U31, U61, U62, U63};

    extremes! {
        fixed_32_with_1_fraction_bit: FixedI32<U1>,
        fixed_32_with_8_fraction_bits: FixedI32<U8>,
        fixed_32_with_24_fraction_bits: FixedI32<U24>,
        fixed_32_with_29_fraction_bits: FixedI32<U29>,
        fixed_32_with_31_fraction_bits: FixedI32<U31>,
        fixed_64_with_16_fraction_bits: FixedI64<U16>,
        fixed_64_with_61_fraction_bits: FixedI64<U61>,
        fixed_64_with_62_fraction_bits: FixedI64<U62>,
        fixed_64_with_63_fraction_bits: FixedI64<U63>,
    }
}

/// At the budget itself the answers are still right, not merely numbers.
fn right_at_the_limits<S: Raw>() {
    let most = S::BUDGET.coordinate;
    let (far, size) = (most.to_f64(), S::BUDGET.size.to_f64());
    let ball = Sphere::new(S::BUDGET.size).expect("the size is at the budget");
    let ray = Ray::new(Vec3::ZERO, UnitVec3::X).expect("origin").with_range(Range::line());
    let hits: Vec<f64> = ball.hits(&ray).iter().map(|hit| hit.t.to_f64()).collect();
    assert_eq!(hits, [-size, size]);
    let ray = Ray::new(Vec3::new(-most, S::ZERO, S::ZERO), UnitVec3::X).expect("origin");
    let hits: Vec<f64> = ball.hits(&ray).iter().map(|hit| hit.t.to_f64()).collect();
    // From rim to rim is twice the budget: a float holds it, a fixed type does not, and says so by one hit.
    assert!(hits == [0.0, 2.0 * far] || hits == [0.0], "{hits:?}");
    let rod = Cylinder::capped(S::BUDGET.smallest_size, S::BUDGET.size).expect("the sizes are at the budget");
    let ray = Ray::new(Vec3::ZERO, UnitVec3::Y).expect("origin");
    let hits: Vec<f64> = rod.hits(&ray).iter().map(|hit| hit.t.to_f64()).collect();
    assert_eq!(hits, [0.0, size]);
}

#[test]
fn answers_at_the_budget_are_right() {
    right_at_the_limits::<f32>();
    right_at_the_limits::<f64>();
    right_at_the_limits::<FixedI32<U0>>();
    right_at_the_limits::<FixedI32<U16>>();
    right_at_the_limits::<FixedI32<U30>>();
    right_at_the_limits::<FixedI32<U32>>();
    right_at_the_limits::<FixedI64<U0>>();
    right_at_the_limits::<FixedI64<U32>>();
    right_at_the_limits::<FixedI64<U64>>();
}

/// A solid and a ray at opposite ends of the budget: the difference of their coordinates is more than the type holds.
#[test]
fn far_apart_fixed_point_coordinates_saturate_without_a_panic() {
    type I16F16 = FixedI32<U16>;
    let most = <I16F16 as Scalar>::BUDGET.coordinate;
    for sign in [1, -1] {
        let (here, there) = (if sign > 0 { most } else { -most }, if sign > 0 { -most } else { most });
        let frame = Frame::at(Vec3::new(here, here, here)).expect("the position is at the budget");
        let ball = Shape::new(Sphere::new(I16F16::from_num(1)).expect("size")).placed(frame);
        let ray = Ray::towards(Vec3::new(there, here, here), Vec3::new(here, here, here)).expect("origin");
        let hits = ball.hits(&ray);
        // 32767 away: the near side is the last that the type holds, less the unit that is infinity.
        assert_eq!(hits.first().map(|hit| hit.t), Some(I16F16::from_num(32767)), "{hits:?}");
        let diagonal = Ray::towards(Vec3::new(there, there, there), Vec3::new(here, here, here)).expect("origin");
        assert!(ball.hits(&diagonal).is_empty(), "56755 away is beyond the type");
    }
}

#[test]
fn the_negative_of_the_lowest_fixed_point_vector_saturates() {
    use fixed::types::{I16F16, I32F32};
    let lowest = Vec3::new(I16F16::MIN, I16F16::MAX, I16F16::ZERO);
    assert_eq!(-lowest, Vec3::new(I16F16::MAX, -I16F16::MAX, I16F16::ZERO));
    let lowest = Vec3::new(I32F32::MIN, I32F32::MAX, I32F32::ZERO);
    assert_eq!(-lowest, Vec3::new(I32F32::MAX, -I32F32::MAX, I32F32::ZERO));
}
