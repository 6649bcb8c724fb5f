//! Tubes and annuli: random ones beside exact arithmetic, lines along their surfaces, and walls that are thin. Rows and
//! laws of some of them stand among those of all primitives.

use crate::drawn::{departures_pair_up, is_exact};
use crate::values::n;
use fixed::types::{I8F24, I16F16};
use raylet::{
    Annulus, Combination, Crossing, Cylinder, Departure, Exact, Frame, Leaving, Part, Range, Ray, Shape, SizeError,
    Stable, Tier, Tube, UnitVec3, ValueError, Vec3,
};
use support::amount::times;
use support::call_in_every_tier;
use support::cases::{direction, v};
use support::described::Described;
use support::exact_types::Exact as Number;
use support::oracle::Solid;
use support::random::Random;

/// A tube or an annulus, whose radii are multiples of a quarter, or any; with a wall down to a ten-thousandth.
fn hollow<S: Number>(random: &mut Random) -> Option<(Shape<S>, Solid)> {
    let quarters = |x: f64| (x * 4.0).round() / 4.0;
    let (outer, height) = (random.between(0.5, 2.0), random.between(0.25, 3.0));
    let (inner, outer, height) = match random.below(4) {
        0 => (quarters(outer * random.unit()), quarters(outer), quarters(height)),
        1 => (outer * random.unit(), outer, height),
        2 => (outer * (1.0 - 10.0_f64.powf(random.between(-4.0, -1.0))), outer, height),
        _ => (outer * 10.0_f64.powf(random.between(-3.0, -1.0)), outer, height),
    };
    let described = if random.next().is_multiple_of(4) {
        Described::Annulus { inner, outer }
    } else {
        Described::Tube { inner, outer, height }
    };
    let sized = described.try_map(|size| S::from_f64(*size)).ok()?;
    Some((sized.shape().ok()?, sized.solid()))
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_f32() {
    let hits_of = is_exact::<f32, Exact>(hollow);
    assert!(hits_of[3] > 1 && hits_of[4] > 9, "{hits_of:?}");
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_fixed_point() {
    let hits_of = is_exact::<I16F16, Exact>(hollow);
    assert!(hits_of[3] > 1 && hits_of[4] > 9, "{hits_of:?}");
    let hits_of = is_exact::<I8F24, Exact>(hollow);
    assert!(hits_of[3] > 1 && hits_of[4] > 9, "{hits_of:?}");
}

fn leaves<S: Number, T: Tier<S>>() {
    departures_pair_up::<S, T>(hollow);
}

#[test]
fn rays_leave_in_every_tier() {
    call_in_every_tier!(leaves);
}

fn told<S: Number, T: Tier<S>>(shape: Shape<S>, from: [f64; 3], along: [f64; 3]) -> Vec<(f64, Part, Crossing)> {
    let ray = Ray::new(v::<S>(from), direction(along)).expect("near").with_range(Range::line());
    shape.hits_at::<T>(&ray).iter().map(|hit| (hit.t.to_f64(), hit.part, hit.crossing)).collect()
}

/// Lines along the surfaces of a tube with the radii 0.75 and 1.25, and along its axis: in every tier, since all
/// numbers are small multiples of a quarter.
fn lines_along_the_surfaces<S: Number, T: Tier<S>>() {
    use Crossing::{Enter, Exit, Touch};
    use Part::{Base, Inner, Side, Top};
    let tube = Shape::new(Tube::new(n::<S>(0.75), n(1.25), n(2.0)).expect("sizes"));
    let up = |x: f64| told::<S, T>(tube, [x, -1.0, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(up(0.5), [], "along the hole");
    assert_eq!(up(0.75), [(1.0, Inner, Enter), (3.0, Inner, Exit)], "along the inner side");
    assert_eq!(up(1.0), [(1.0, Base, Enter), (3.0, Top, Exit)], "in the wall");
    assert_eq!(up(1.25), [(1.0, Side, Enter), (3.0, Side, Exit)], "along the outer side");
    assert_eq!(up(1.5), [], "beside it");
    let across = |y: f64, z: f64| told::<S, T>(tube, [-3.0, y, z], [1.0, 0.0, 0.0]);
    for y in [0.0, 1.0, 2.0] {
        // In the planes of the ends too.
        let four = [(1.75, Side, Enter), (2.25, Inner, Exit), (3.75, Inner, Enter), (4.25, Side, Exit)];
        assert_eq!(across(y, 0.0), four, "across the hole");
        assert_eq!(across(y, 0.75), [(2.0, Side, Enter), (4.0, Side, Exit)], "touching the hole, within the wall");
        assert_eq!(across(y, 1.25), [(3.0, Side, Touch)], "touching the outer side");
    }
    assert_eq!(across(-0.25, 0.0), [], "below");
    // Down the hole, in by the upper end's hole, out through the wall.
    let inside = told::<S, T>(tube, [-0.5, 3.0, 0.0], [0.6, -0.8, 0.0]);
    let seen: Vec<_> = inside.iter().map(|(_, part, crossing)| (*part, *crossing)).collect();
    assert_eq!(seen, [(Inner, Enter), (Side, Exit)], "{inside:?}");
    let washer = Shape::new(Annulus::new(n::<S>(0.75), n(1.25)).expect("sizes"));
    let down = |x: f64| told::<S, T>(washer, [x, 2.0, 0.0], [0.0, -1.0, 0.0]);
    for (x, hits) in [(0.5, 0), (0.75, 1), (1.0, 1), (1.25, 1), (1.5, 0)] {
        assert_eq!(down(x), [(2.0, Side, Enter)][..hits], "{x}");
    }
    let in_its_plane = Ray::new(v::<S>([-3.0, 0.0, 0.0]), UnitVec3::X).expect("near");
    let stretch = washer.hits_at::<T>(&in_its_plane).coincident().expect("in the plane");
    assert_eq!([stretch.start(), stretch.end()].map(S::to_f64), [1.75, 4.25]);
}

#[test]
fn lines_along_the_surfaces_are_defined() {
    call_in_every_tier!(lines_along_the_surfaces);
}

/// From the inner side outwards of the wall, which is into the hole, a ray meets the other side of the hole; inwards it
/// leaves by the outer side; and from the outer side inwards it meets the hole.
fn departures<S: Number, T: Tier<S>>() {
    let tube = Shape::new(Tube::new(n::<S>(0.75), n(1.25), n(2.0)).expect("sizes"));
    let from = |x: f64, along: f64, part, leaving| {
        let ray = Ray::new(v::<S>([x, 1.0, 0.0]), direction([along, 0.0, 0.0])).expect("near");
        let ray = ray.departing(Departure { object: 0, part, leaving });
        let hits = tube.hits_at::<T>(&ray);
        let all: Vec<_> = hits.iter().map(|hit| (hit.t.to_f64(), hit.part)).collect();
        assert_eq!(tube.nearest_at::<T>(&ray), hits.first().copied());
        assert_eq!(tube.occludes_at::<T>(&ray), !hits.is_empty());
        all
    };
    use Leaving::{Inwards, Outwards};
    use Part::{Base, Inner, Side};
    assert_eq!(from(-0.75, 1.0, Inner, Outwards), [(1.5, Inner), (2.0, Side)]);
    assert_eq!(from(-0.75, -1.0, Inner, Inwards), [(0.5, Side)]);
    assert_eq!(from(-1.25, 1.0, Side, Inwards), [(0.5, Inner), (2.0, Inner), (2.5, Side)]);
    assert_eq!(from(-1.25, -1.0, Side, Outwards), []);
    assert_eq!(from(-1.0, 1.0, Base, Outwards), []);
}

#[test]
fn a_ray_that_departs_into_the_hole_meets_the_other_side() {
    call_in_every_tier!(departures);
}

/// Into the hole beside a thin wall: the entry was known by one number, and the exit by another, so that the nearest
/// hit was not the first of all.
fn nearest_is_the_first<T: Tier<f32>>() {
    let tube = Tube::new(1.878_627_9_f32, 1.878_956_1, 2.889_433).expect("sizes");
    let along = UnitVec3::from_components([-0.415_473_22_f32, 0.877_429_8, 0.239_789_47]).expect("a length");
    let ray = Ray::new(Vec3::new(0.943_267_3, 0.584_906_4, 1.624_650_6), along).expect("near");
    let ray = ray.departing(Departure { object: 0, part: Part::Inner, leaving: Leaving::Outwards });
    assert_eq!(tube.nearest_at::<T>(&ray), tube.hits_at::<T>(&ray).first().copied());
}

#[test]
fn the_nearest_hit_of_a_departing_ray_is_the_first() {
    nearest_is_the_first::<raylet::Plain>();
    nearest_is_the_first::<raylet::Fast>();
    nearest_is_the_first::<raylet::Stable>();
    nearest_is_the_first::<raylet::Exact>();
}

/// The hits are those of a cylinder less another, to the bit, where both are exact; and as many in every tier.
fn is_a_difference<S: Number, T: Tier<S>>(is_exact: bool) {
    let mut random = Random(0x70be);
    let mut met = 0;
    for _ in 0..times(3_000) {
        let [inner, wall, height] = [0.5, 0.25, 1.0].map(|least| n::<S>(least + random.unit()));
        let outer = inner.plus(wall);
        let frame = Frame::looking(v(random.direction()), random.unit_vector(), random.unit_vector()).expect("axes");
        let cylinder = |radius: S, height: S| Shape::new(Cylinder::capped(radius, height).expect("sizes"));
        let below = frame.moved_to(frame.point_to_world(Vec3::new(S::ZERO, n(-1.0), S::ZERO))).expect("near");
        let hole = if is_exact {
            Cylinder::infinite(inner).map(Shape::new).expect("a size").placed(frame)
        } else {
            cylinder(inner, height.plus(n(2.0))).placed(below)
        };
        let leaves = [cylinder(outer, height).placed(frame), hole];
        let less = Combination::difference(&leaves).expect("two solids");
        let tube = Shape::new(Tube::new(inner, outer, height).expect("sizes")).placed(frame);
        let (from, at) = (random.direction().map(|c| 5.0 * c), random.direction());
        let Ok(ray) = Ray::towards(v::<S>(from), v(at)) else { continue };
        let (own, other) = (tube.hits_at::<T>(&ray), less.shape().hits_at::<T>(&ray));
        let unit = S::unit_at(&(&n::<S>(8.0).exact()).into()).to_f64();
        let near = |a: S, b: S| (a.to_f64() - b.to_f64()).abs() <= if is_exact { 0.0 } else { 64.0 * unit };
        let same = own.len() == other.len()
            && own.iter().zip(other.iter()).all(|(a, b)| near(a.t, b.t) && a.crossing == b.crossing);
        assert!(same, "{tube:?} {ray:?}: {own:?} {other:?}");
        met += own.len();
    }
    assert!(met > times(3_000) as usize, "{met}");
}

#[test]
fn a_tube_is_a_cylinder_less_another() {
    is_a_difference::<f32, Exact>(true);
    is_a_difference::<I16F16, Exact>(true);
    is_a_difference::<f32, Stable>(false);
    is_a_difference::<f64, Stable>(false);
}

/// The normal of the inner side points to the axis, out of the wall.
#[test]
fn the_inner_side_faces_the_axis() {
    let tube = Shape::new(Tube::new(0.5_f64, 1.0, 2.0).unwrap());
    let ray = Ray::new(Vec3::new(0.0, 1.0, 0.0), UnitVec3::X).unwrap();
    let hit = tube.nearest(&ray).unwrap();
    let surface = tube.surface(&ray, &hit);
    assert_eq!((hit.t, hit.part, surface.normal()), (0.5, Part::Inner, -UnitVec3::X));
    assert_eq!((surface.point(), surface.uv()), (Vec3::new(0.5, 1.0, 0.0), (0.0, 0.5)));
    assert!(tube.contains(Vec3::new(0.5, 0.0, 0.0)) && !tube.contains(Vec3::new(0.25, 1.0, 0.0)));
}

#[test]
fn radii_in_the_wrong_order_are_refused() {
    let message = SizeError::Radii.message();
    assert_eq!(message, "the inner radius is not below the outer one");
    for (inner, outer) in [(1.0_f32, 1.0), (2.0, 1.0)] {
        assert_eq!(Tube::new(inner, outer, 1.0), Err(SizeError::Radii));
        assert_eq!(Annulus::new(inner, outer), Err(SizeError::Radii));
    }
    assert_eq!(Tube::with_wall(1.0, 1.0, 1.0), Err(SizeError::Radii));
    // So thin that both radii are the same number.
    assert_eq!(Tube::with_wall(1.0_f32, 1e-9, 1.0), Err(SizeError::Radii));
    assert_eq!(Tube::new(0.0, 1.0, 1.0), Err(SizeError::Radius(ValueError::Zero)));
    assert_eq!(Tube::new(0.5, 1.0, f32::NAN), Err(SizeError::Height(ValueError::NotFinite)));
}
