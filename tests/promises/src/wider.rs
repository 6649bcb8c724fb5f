//! Fixed point with many fraction bits has a second attempt, in 64 bits: its results are those of exact arithmetic, for
//! all kinds, placed anyhow, and for rays that depart.

use fixed::FixedI32;
use fixed::types::I8F24;
use fixed::types::extra::U20;
use raylet::scalar::Scalar;
use raylet::tier::{Exact, Fast, Stable, Tier};
use raylet::{
    Annulus, Capsule, Cone, Crossing, Cuboid, Cylinder, Disc, Frame, Hits, Leaving, Plane, Primitive, Range, Ray,
    Rectangle, Revolved, RoundCone, RoundedCuboid, Shape, Sphere, Torus, Triangle, Tube, UnitVec3, Vec3,
};
use support::random::{Random, add, cross, dot, normalize, scale};

/// Rays for each type.
const RAYS: u32 = 40_000;

fn solid<S: Scalar>(random: &mut Random, size: f64) -> Option<Primitive<S>> {
    let mut any = |size: f64| S::from_f64(size * random.between(-3.0, 3.0).exp2()).ok();
    let (a, b, c, slope) = (any(size)?, any(size)?, any(size)?, any(1.0)?);
    let wall = -(random.below(6) as i32) - 1;
    let mut corner = || Vec3::from_f64(scale(random.direction(), size)).ok();
    let (p, q, r) = (corner()?, corner()?, corner()?);
    Some(match random.below(19) {
        0 => Sphere::new(a).ok()?.into(),
        1 => Cylinder::infinite(a).ok()?.into(),
        2 => Cylinder::open(a, b).ok()?.into(),
        3 => Cylinder::capped(a, b).ok()?.into(),
        4 => Capsule::new(a, b).ok()?.into(),
        5 => Cone::capped(slope, a).ok()?.into(),
        6 => Cone::frustum(a, b, c).ok()?.into(),
        7 => Cone::double(slope).ok()?.into(),
        8 => Plane::new().into(),
        9 => Disc::new(a).ok()?.into(),
        10 => Rectangle::new(a, b).ok()?.into(),
        11 => Triangle::new(p, q, r).ok()?.into(),
        12 => Revolved::paraboloid(a, b).ok()?.into(),
        13 => Revolved::hyperboloid(a, slope, [-b, c]).ok()?.into(),
        16 => RoundCone::new(a, b, c).ok()?.into(),
        17 => RoundedCuboid::new(a, b, c, slope).ok()?.into(),
        14 => Tube::with_wall(a, a.scaled(wall), b).ok()?.into(),
        15 => Annulus::new(a.scaled(-1), a).ok()?.into(),
        18 => Torus::new(a, a.scaled(wall)).ok()?.into(),
        _ => Cuboid::new(a, b, c).ok()?.into(),
    })
}

/// A shape and a ray at it: from near or far, along its surface, or departing.
fn drawn<S: Scalar>(random: &mut Random, large: f64) -> Option<(Shape<S>, Ray<S>)>
where
    Exact: Tier<S>,
{
    let size = large * random.between(-3.0, 0.0).exp2();
    let position = scale(random.direction(), large * random.between(-6.0, 2.0).exp2());
    let unit = |v: [f64; 3]| UnitVec3::<S>::from_f64(v).ok();
    let frame = Frame::looking(Vec3::from_f64(position).ok()?, unit(random.direction())?, unit(random.direction())?);
    let shape = Shape::new(solid(random, size)?).placed(frame.ok()?);
    let direction = unit(random.direction())?;
    let target = add(position, scale(random.direction(), size * random.unit()));
    let from = add(target, scale(direction.to_f64(), -size * random.between(-2.0, 4.0).exp2()));
    let ray = Ray::new(Vec3::from_f64(from).ok()?, direction).ok()?.with_range(Range::line());
    let kind = random.below(4);
    if kind < 2 {
        return Some((shape, ray));
    }
    let hit = shape.nearest_at::<Exact>(&ray)?;
    let surface = shape.surface(&ray, &hit);
    let (point, normal) = (surface.point().to_f64(), surface.normal().to_f64());
    if kind == 2 {
        let beside = scale(normal, size * random.sign() * (-random.between(2.0, 20.0)).exp2());
        let along = normalize(cross(normal, random.direction()));
        let from = add(add(point, beside), scale(along, -size * random.between(-2.0, 3.0).exp2()));
        return Some((shape, Ray::new(Vec3::from_f64(from).ok()?, unit(along)?).ok()?.with_range(Range::line())));
    }
    let direction = unit(random.direction())?;
    let leaving = if dot(direction.to_f64(), normal) > 0.0 { Leaving::Outwards } else { Leaving::Inwards };
    let departure = surface.departure(0, leaving);
    Some((shape, Ray::new(surface.point(), direction).ok()?.departing(departure)))
}

/// Whether rounding may decide what is hit: at a touch, or a chord of some units.
fn is_doubtful<S: Scalar>(hits: &Hits<S>, units: f64) -> bool {
    hits.iter().any(|hit| hit.crossing == Crossing::Touch || hit.t.to_f64().abs() < 4.0 * units)
        || hits.windows(2).any(|pair| pair[1].t.to_f64() - pair[0].t.to_f64() < 1024.0 * units)
}

fn agrees_with_exact<S: Scalar>(large: f64, units: f64)
where
    Exact: Tier<S>,
    Stable: Tier<S>,
    Fast: Tier<S>,
{
    let mut random = Random(15);
    let (mut judged, mut found) = (0, 0);
    while judged < RAYS {
        let Some((shape, ray)) = drawn::<S>(&mut random, large) else { continue };
        judged += 1;
        let (exact, stable) = (shape.hits_at::<Exact>(&ray), shape.hits_at::<Stable>(&ray));
        let told = || format!("{ray:?} at {shape:?}: {stable:?}, exactly {exact:?}");
        assert_eq!(shape.nearest_at::<Stable>(&ray), stable.first().copied(), "{}", told());
        assert_eq!(shape.occludes_at::<Stable>(&ray), !stable.is_empty(), "{}", told());
        if is_doubtful(&exact, units) || is_doubtful(&stable, units) {
            continue;
        }
        found += u32::from(!exact.is_empty());
        assert_eq!(stable.len(), exact.len(), "{}", told());
        for (hit, exact) in stable.iter().zip(&exact) {
            assert_eq!((hit.part, hit.crossing), (exact.part, exact.crossing), "{}", told());
            // Each is rounded once: `Exact` within a unit, `Stable` to nearest, from finer ones.
            assert!((hit.t.to_f64() - exact.t.to_f64()).abs() <= units, "{}", told());
        }
    }
    assert!(found > RAYS / 3, "{found}");
}

#[test]
fn i8f24_agrees_with_exact_arithmetic() {
    agrees_with_exact::<I8F24>(8.0, (-24.0_f64).exp2());
}

#[test]
fn twenty_fraction_bits_agree_with_exact_arithmetic() {
    agrees_with_exact::<FixedI32<U20>>(128.0, (-20.0_f64).exp2());
}

/// The end of a ray that crosses a ball at the end of the type: what rounds to more than the largest distance is no
/// hit.
#[test]
fn an_end_beyond_the_type_is_no_hit() {
    let tall = Shape::new(Cylinder::<I8F24>::capped(I8F24::from_num(8), I8F24::from_num(60)).expect("sizes"));
    let at = Vec3::from_f64([0.0, 0.0, 60.0]).expect("a point");
    let along = UnitVec3::from_f64([0.01, 0.02, 1.0]).expect("a direction");
    let placed = tall.placed(Frame::looking(at, along, UnitVec3::Y).expect("a frame"));
    let from = Vec3::from_f64([0.5, 1.0, -63.0]).expect("a point");
    let ray = Ray::new(from, UnitVec3::from_f64([0.01, 0.002, 1.0]).expect("a direction")).expect("a ray");
    // It enters at some 115, and would leave at 131.
    let hits = placed.hits_at::<Stable>(&ray);
    assert_eq!(hits.iter().map(|hit| hit.crossing).collect::<Vec<_>>(), [Crossing::Enter], "{hits:?}");
    assert_eq!(hits.len(), placed.hits_at::<Exact>(&ray).len());
}
