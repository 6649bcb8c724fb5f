//! Prisms: random ones beside exact arithmetic, edges and corners, and what is refused. Rows and laws of some of them
//! stand among those of all primitives.

use crate::drawn::{departures_pair_up, is_exact};
use fixed::types::{I8F24, I16F16};
use raylet::shape::kinds::All;
use raylet::{
    Combination, Crossing, Cuboid, Cylinder, Departure, Exact, Leaving, Part, Prism, Ray, Shape, SizeError, Tier,
    UnitVec3, ValueError, Vec3, constant,
};
use support::amount::times;
use support::call_in_every_tier;
use support::cases::v;
use support::exact_types::Exact as Number;
use support::oracle::{self, Solid};
use support::random::Random;
use support::subject::Subject;

/// A prism of 3 to 16 corners on an ellipse about some point; every other one with corners at multiples of a quarter,
/// so that some of its edges are parallel to axes and to each other.
fn prism<S: Number>(random: &mut Random) -> Option<(Shape<S>, Solid)> {
    let [x, z, width, depth] = [(-1.0, 1.0), (-1.0, 1.0), (0.2, 2.0), (0.2, 2.0)].map(|(a, b)| random.between(a, b));
    let mut angles = vec![0.0; 3 + random.below(14)];
    angles.fill_with(|| random.between(0.0, std::f64::consts::TAU));
    angles.sort_by(f64::total_cmp);
    let (height, is_coarse) = (random.between(0.1, 2.0), random.below(2) == 0);
    let rounded = |c: f64| S::from_f64(if is_coarse { (c * 4.0).round() / 4.0 } else { c }).ok();
    let corner = |angle: &f64| Some([rounded(x + angle.cos() * width)?, rounded(z - angle.sin() * depth)?]);
    let mut corners = angles.iter().map(corner).collect::<Option<Vec<_>>>()?;
    corners.dedup();
    made(corners, rounded(height)?)
}

fn made<S: Number>(corners: Vec<[S; 2]>, height: S) -> Option<(Shape<S>, Solid)> {
    let exact: Vec<_> = corners.iter().map(|corner| corner.map(S::exact)).collect();
    let prism = Prism::new(corners.leak(), height).ok()?;
    Some((Shape::new(prism), Solid::HalfSpaces(oracle::HalfSpaces::prism(&exact, &height.exact()))))
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_f32() {
    let hits_of = is_exact::<f32, Exact>(prism);
    assert_eq!(hits_of[3..], [0, 0]);
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_fixed_point() {
    let hits_of = is_exact::<I16F16, Exact>(prism);
    assert_eq!(hits_of[3..], [0, 0]);
    let hits_of = is_exact::<I8F24, Exact>(prism);
    assert_eq!(hits_of[3..], [0, 0]);
}

fn leaves<S: Number, T: Tier<S>>() {
    departures_pair_up::<S, T>(prism);
}

#[test]
fn rays_leave_in_every_tier() {
    call_in_every_tier!(leaves);
}

/// A hexagonal prism with corners that every type holds.
static HEXAGON: [[f32; 2]; 6] = [[1.0, 0.5], [1.0, -0.5], [0.0, -1.0], [-1.0, -0.5], [-1.0, 0.5], [0.0, 1.0]];

type Seen = Vec<(f32, Part, Crossing)>;

fn seen(shape: &Shape<f32>, origin: [f32; 3], direction: [f32; 3]) -> Seen {
    let ray = Ray::new(origin.into(), UnitVec3::new(direction.into()).unwrap()).unwrap();
    let hits = shape.hits_at::<Exact>(&ray);
    assert_eq!(shape.nearest_at::<Exact>(&ray), hits.first().copied());
    hits.iter().map(|hit| (hit.t, hit.part, hit.crossing)).collect()
}

#[test]
fn edges_belong_to_the_first_of_their_faces() {
    use Part::{Base, Facet0, Facet1, Facet2, Facet3, Facet4, Facet5, Top};
    let nut = Shape::new(Prism::new(&HEXAGON, 1.0).unwrap());
    let (enter, exit, touch) = (Crossing::Enter, Crossing::Exit, Crossing::Touch);
    let seen = |origin, direction| seen(&nut, origin, direction);
    assert_eq!(seen([3.0, 0.5, 0.0], [-1.0, 0.0, 0.0]), [(2.0, Facet0, enter), (4.0, Facet3, exit)]);
    assert_eq!(seen([0.0, 3.0, 0.0], [0.0, -1.0, 0.0]), [(2.0, Top, enter), (3.0, Base, exit)]);
    // Through an edge to the opposite one.
    assert_eq!(seen([0.0, 0.5, -3.0], [0.0, 0.0, 1.0]), [(2.0, Facet1, enter), (4.0, Facet4, exit)]);
    // In the plane of the top: through its edges, which the facets own.
    assert_eq!(seen([3.0, 1.0, 0.0], [-1.0, 0.0, 0.0]), [(2.0, Facet0, enter), (4.0, Facet3, exit)]);
    // In the plane of a facet, which owns the edges at both ends.
    assert_eq!(seen([1.0, 0.5, 3.0], [0.0, 0.0, -1.0]), [(2.5, Facet0, enter), (3.5, Facet0, exit)]);
    // Along an edge between two facets; up the edge of the last facet and the first.
    assert_eq!(seen([1.0, -1.0, 0.5], [0.0, 1.0, 0.0]), [(1.0, Facet0, enter), (2.0, Facet0, exit)]);
    assert_eq!(seen([-1.0, -1.0, 0.5], [0.0, 1.0, 0.0]), [(1.0, Facet3, enter), (2.0, Facet3, exit)]);
    // Touching an edge, and a corner.
    assert_eq!(seen([-1.0, 0.5, -1.0], [1.0, 0.0, 0.0]), [(1.0, Facet1, touch)]);
    assert_eq!(seen([-1.0, 1.0, -1.0], [1.0, 0.0, 0.0]), [(1.0, Facet1, touch)]);
    // From inside.
    assert_eq!(seen([0.0, 0.5, 0.0], [0.0, 0.0, 1.0]), [(1.0, Facet4, exit)]);
    assert_eq!(seen([0.25, 0.5, 0.0], [0.0, 0.0, 1.0])[0].1, Facet5);
    assert_eq!(seen([-0.25, 0.5, 0.0], [0.0, 0.0, -1.0])[0].1, Facet2);
}

/// What is on the surface: normals, coordinates, tangents, bounds and solid coordinates.
#[test]
fn the_surface() {
    let nut = Shape::new(Prism::new(&HEXAGON, 2.0).unwrap());
    let at = |origin: [f32; 3], direction: [f32; 3]| {
        let ray = Ray::new(origin.into(), UnitVec3::new(direction.into()).unwrap()).unwrap();
        nut.surface(&ray, &nut.nearest(&ray).unwrap())
    };
    let side = at([3.0, 0.5, 0.25], [-1.0, 0.0, 0.0]);
    assert_eq!((side.point(), side.normal()), (Vec3::new(1.0, 0.5, 0.25), UnitVec3::X));
    assert_eq!((side.uv(), side.tangents()), ((0.25, 0.25), (-UnitVec3::Z, UnitVec3::Y)));
    assert_eq!(side.uvw(), [1.0, 0.25, 0.625]);
    let top = at([0.5, 3.0, 0.5], [0.0, -1.0, 0.0]);
    assert_eq!((top.point(), top.normal()), (Vec3::new(0.5, 2.0, 0.5), UnitVec3::Y));
    assert_eq!((top.uv(), top.tangents()), ((0.75, 0.75), (UnitVec3::X, UnitVec3::Z)));
    let slanted = at([0.5, 0.5, 3.0], [0.0, 0.0, -1.0]);
    assert!(slanted.normal().dot(UnitVec3::new(Vec3::new(1.0, 0.0, 2.0)).unwrap()) > 0.999_999);
    let bounds = nut.bounds();
    assert_eq!((bounds.low, bounds.high), (Vec3::new(-1.0, 0.0, -1.0), Vec3::new(1.0, 2.0, 1.0)));
}

/// A box as a prism has the hits of the cuboid, face by face.
fn of_a_box<S: Number, T: Tier<S>>() {
    let n = |value: f64| S::from_f64(value).expect("a size");
    let corners = [[1.0, 0.5], [1.0, -0.5], [-1.0, -0.5], [-1.0, 0.5]].map(|corner| corner.map(n));
    let (prism, _) = made(corners.to_vec(), n(1.5)).expect("a rectangle");
    let cuboid = Cuboid::new(n(1.0), n(0.75), n(0.5)).expect("sizes");
    let (mut random, mut is_off) = (Random(0xb0c5), 0);
    for _ in 0..times(1_000) {
        let [from, at] = [3.0, 0.9].map(|reach| random.direction().map(|c| c * reach));
        let [low, high] = [from, at].map(|[x, y, z]| (v::<S>([x, y, z]), v::<S>([x, y + 0.75, z])));
        let (Ok(of_cuboid), Ok(of_prism)) = (Ray::towards(low.0, high.0), Ray::towards(low.1, high.1)) else {
            continue;
        };
        let (own, other) = (prism.hits_at::<T>(&of_prism), cuboid.hits_at::<T>(&of_cuboid));
        let part = |part: Part| match part {
            Part::Facet0 => Part::Right,
            Part::Facet1 => Part::Back,
            Part::Facet2 => Part::Left,
            Part::Facet3 => Part::Front,
            part => part,
        };
        let unit = S::unit_at(&(&n(4.0).exact()).into()).to_f64();
        let is_same = |(own, other): (&raylet::Hit<S>, &raylet::Hit<S>)| {
            let is_near = (own.t.to_f64() - other.t.to_f64()).abs() <= 64.0 * unit;
            is_near && part(own.part) == other.part && own.crossing == other.crossing
        };
        is_off += (own.len() != other.len() || own.iter().zip(&other).any(|pair| !is_same(pair))) as u64;
    }
    // Next to an edge the two may differ: the rays are rounded.
    assert!(is_off <= times(1_000) / 100, "{is_off}");
}

#[test]
fn a_box_is_the_cuboid() {
    call_in_every_tier!(of_a_box);
}

/// A nut: the prism less a cylinder.
#[test]
fn a_nut_is_a_combination() {
    static NUT: [Shape<f32>; 2] = [
        constant!(Prism::<f32>::const_new(&HEXAGON, 0.5)).into_shape(),
        constant!(Cylinder::<f32>::const_infinite(0.5)).into_shape(),
    ];
    let nut = Combination::<'_, f32, All>::difference(&NUT).unwrap();
    let ray = Ray::new(Vec3::new(3.0, 0.25, 0.0), -UnitVec3::X).unwrap();
    let hits: Vec<_> = nut.shape().hits(&ray).iter().map(|hit| (hit.t, hit.part)).collect();
    assert_eq!(hits, [(2.0, Part::Facet0), (2.5, Part::Side), (3.5, Part::Side), (4.0, Part::Facet3)]);
}

#[test]
fn a_departing_ray_meets_no_facet_that_it_starts_on() {
    let nut = Shape::new(Prism::new(&HEXAGON, 1.0).unwrap());
    for (leaving, wanted) in [(Leaving::Inwards, Some((2.0, Part::Facet3))), (Leaving::Outwards, None)] {
        let ray = Ray::new(Vec3::new(1.0, 0.5, 0.0), -UnitVec3::X).unwrap();
        let ray = ray.departing(Departure { object: 0, part: Part::Facet0, leaving });
        assert_eq!(nut.nearest(&ray).map(|hit| (hit.t, hit.part)), wanted);
        assert_eq!(nut.nearest_at::<Exact>(&ray).map(|hit| (hit.t, hit.part)), wanted);
    }
}

/// Said to enter, the ray leads out of the facet by 1e-10: it ends where it starts. By its rounded coordinates it is
/// half a unit inside, and the facet's plane is farther away than any `t`.
#[test]
fn a_ray_that_is_said_to_enter_along_a_facet_ends_at_once() {
    let prism = Subject::<I16F16>::new("prism").shape;
    let origin = Vec3::from([31974, 49437, -60140].map(I16F16::from_bits));
    let along = [670607953, 836709663, 55887549].map(raylet::scalar::Unit::<I16F16>::from_bits);
    let ray = Ray::new(origin, UnitVec3::from_components(along).unwrap()).unwrap();
    let ray = ray.departing(Departure { object: 0, part: Part::Facet1, leaving: Leaving::Inwards });
    let wanted = Some((I16F16::ZERO, Part::Facet1));
    assert_eq!(prism.nearest(&ray).map(|hit| (hit.t, hit.part)), wanted);
    assert_eq!(prism.nearest_at::<Exact>(&ray).map(|hit| (hit.t, hit.part)), wanted);
}

#[test]
fn corners_that_are_none_are_refused() {
    let refused = |corners: &[[f32; 2]], height: f32| {
        let error = Prism::new(corners.to_vec().leak(), height).unwrap_err();
        assert_eq!(Prism::<f32>::const_new(corners.to_vec().leak(), height), Err(error));
        error
    };
    let square = [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]];
    assert!(Prism::new(square.to_vec().leak(), 1.0).is_ok());
    assert_eq!(refused(&square[..2], 1.0), SizeError::CornerCount);
    assert_eq!(refused(&[[0.0; 2]; 17], 1.0).to_string(), "there are fewer than 3 corners, or more than 16");
    assert_eq!(refused(&square, 0.0), SizeError::Height(ValueError::Zero));
    let with = |corner: [f32; 2]| [square[0], square[1], square[2], corner];
    assert_eq!(refused(&with([f32::NAN, 1.0]), 1.0), SizeError::Corner(ValueError::NotFinite));
    assert_eq!(refused(&with([f32::MAX, 1.0]), 1.0), SizeError::Corner(ValueError::BeyondBudget));
    let message = "the corners do not turn to the left, as seen from +y, once around a convex polygon";
    let mut clockwise = square;
    clockwise.reverse();
    assert_eq!(refused(&clockwise, 1.0).to_string(), message);
    // A corner twice, one that is on an edge, one that is inside, one that is between two edges' ends.
    for corner in [[-1.0, -1.0], [1.0, 1.0], [0.0, 0.0], [-1.0, -3.0], [1.0, -0.5]] {
        assert_eq!(refused(&with(corner), 1.0), SizeError::Corners, "{corner:?}");
    }
    assert_eq!(refused(&[[1.0, 1.0], [1.0, 0.0], [1.0, -1.0], [-1.0, 0.0]], 1.0), SizeError::Corners);
    // A star turns to the left at each corner, and goes around twice.
    let star = [0.0, 2.0, 4.0, 1.0, 3.0].map(|step: f32| {
        let angle = step * std::f32::consts::TAU / 5.0;
        [angle.cos(), -angle.sin()]
    });
    assert_eq!(refused(&star, 1.0), SizeError::Corners);
    // Not too nearly straight: by the sine of the turn.
    let bent = |by: f32| [[0.0, 1.0], [1.0, 0.0], [1.0 + by, -1.0], [1.0, -2.0], [-1.0, 0.0]];
    assert_eq!(refused(&bent(1e-5), 1.0), SizeError::Corners);
    assert!(Prism::new(bent(1e-3).to_vec().leak(), 1.0).is_ok());
}
