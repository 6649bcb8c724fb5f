//! Polyhedra: random ones beside exact arithmetic, boxes that are computed, and what is refused. Rows and laws of one
//! of them stand among those of all primitives.

use crate::drawn::{departures_pair_up, is_exact};
use fixed::types::{I8F24, I16F16};
use raylet::{Exact, HalfSpace, Part, Polyhedron, Ray, Shape, SizeError, Tier, UnitVec3, ValueError, Vec3};
use support::amount::times;
use support::call_in_every_tier;
use support::cases::v;
use support::exact_types::Exact as Number;
use support::oracle::{self, Solid};
use support::random::Random;

/// A box that up to 16 half-spaces cut, some of them through its corners, some parallel to its faces, some to nothing.
fn polyhedron<S: Number>(random: &mut Random) -> Option<(Shape<S>, Solid)> {
    let quarters = |x: f64| (x * 4.0).round() / 4.0;
    let is_coarse = random.below(2) == 0;
    let mut vector = |low: f64, high: f64| {
        let v = [(); 3].map(|()| random.between(low, high));
        v.map(|c| S::from_f64(if is_coarse { quarters(c) } else { c }).expect("small"))
    };
    let (low, high) = (vector(-1.5, -0.3), vector(0.3, 1.5));
    let facets: Vec<_> = (0..16).map(|_| [vector(-1.0, 1.0), vector(-1.0, 1.0)]).collect();
    let count = 1 + random.below(16);
    // Those that leave the origin inside, so that most of the solids are not empty.
    let leaves_origin =
        |[point, normal]: &&[[S; 3]; 2]| (0..3).map(|i| point[i].to_f64() * normal[i].to_f64()).sum::<f64>() >= 0.0;
    let facets: Vec<_> = facets.iter().filter(leaves_origin).take(count).copied().collect();
    let half_spaces = facets.iter().map(|[point, normal]| HalfSpace::new((*point).into(), (*normal).into()));
    let half_spaces = half_spaces.collect::<Result<Vec<_>, _>>().ok()?;
    let shape = Shape::new(Polyhedron::within(low.into(), high.into(), half_spaces.leak()).ok()?);
    let exact = |v: [S; 3]| v.map(S::exact);
    let facets: Vec<_> = facets.into_iter().map(|facet| facet.map(exact)).collect();
    Some((shape, Solid::HalfSpaces(oracle::HalfSpaces::polyhedron([&exact(low), &exact(high)], &facets))))
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_f32() {
    let hits_of = is_exact::<f32, Exact>(polyhedron);
    assert_eq!(hits_of[3..], [0, 0]);
}

#[test]
fn exact_is_that_of_exact_arithmetic_in_fixed_point() {
    let hits_of = is_exact::<I16F16, Exact>(polyhedron);
    assert_eq!(hits_of[3..], [0, 0]);
    let hits_of = is_exact::<I8F24, Exact>(polyhedron);
    assert_eq!(hits_of[3..], [0, 0]);
}

fn leaves<S: Number, T: Tier<S>>() {
    departures_pair_up::<S, T>(polyhedron);
}

#[test]
fn rays_leave_in_every_tier() {
    call_in_every_tier!(leaves);
}

/// Half-spaces that touch the unit ball, in these directions.
fn around_the_ball<S: Number>(normals: &[[f64; 3]]) -> &'static [HalfSpace<S>] {
    let half_space = |normal: &[f64; 3]| {
        let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
        HalfSpace::new(v(normal.map(|c| c / length)), v(*normal)).expect("a normal")
    };
    normals.iter().map(half_space).collect::<Vec<_>>().leak()
}

/// The computed box is around the solid: it cuts nothing, and is not much larger.
fn has_its_box<S: Number>() {
    let mut random = Random(0x0b0c);
    let mut bounded = 0;
    for _ in 0..times(300) {
        let normals: Vec<_> = (0..4 + random.below(13)).map(|_| random.direction()).collect();
        let half_spaces = around_the_ball::<S>(&normals);
        let Ok(polyhedron) = Polyhedron::new(half_spaces) else { continue };
        bounded += 1;
        let bounds = polyhedron.bounds();
        let reach = [bounds.low, bounds.high].map(|corner| corner.to_f64().map(f64::abs));
        assert!(reach.as_flattened().iter().all(|c| *c >= 1.0), "{polyhedron:?}");
        for _ in 0..20 {
            let ray = Ray::new(Vec3::ZERO, random.unit_vector::<S>()).expect("near");
            let hit = polyhedron.nearest(&ray).expect("the origin is inside");
            // The first plane, by doubles.
            let d = ray.direction().to_f64();
            let t = |face: &HalfSpace<S>| {
                let (n, p) = (face.normal().to_f64(), face.point().to_f64());
                let slope = (0..3).map(|i| n[i] * d[i]).sum::<f64>();
                if slope > 0.0 { (0..3).map(|i| n[i] * p[i]).sum::<f64>() / slope } else { f64::INFINITY }
            };
            let wanted = half_spaces.iter().map(t).fold(f64::INFINITY, f64::min);
            assert!(hit.part.facet_number().is_some(), "{polyhedron:?} {ray:?}: the box cuts it");
            assert!((hit.t.to_f64() / wanted - 1.0).abs() < 1e-3, "{polyhedron:?} {ray:?}: {hit:?} {wanted}");
        }
    }
    assert!(bounded > times(300) / 4, "{bounded}");
}

#[test]
fn a_computed_box_is_around_the_solid() {
    has_its_box::<f32>();
    has_its_box::<f64>();
    has_its_box::<I16F16>();
}

#[test]
fn half_spaces_that_bound_nothing_are_refused() {
    let told = "the half-spaces bound no solid, or only by planes that are nearly parallel";
    let cube =
        [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let built = |normals: &[[f64; 3]]| Polyhedron::<f32>::new(around_the_ball(normals));
    let whole = built(&cube).unwrap();
    let ray = Ray::new(Vec3::new(-3.0, 0.5, 0.5), UnitVec3::X).unwrap();
    let hits: Vec<_> = whole.hits(&ray).iter().map(|hit| (hit.t, hit.part)).collect();
    assert_eq!(hits, [(2.0, Part::Facet1), (4.0, Part::Facet0)]);
    for without in 0..6 {
        let mut faces = cube.to_vec();
        faces.remove(without);
        assert_eq!(built(&faces).unwrap_err().to_string(), told, "{without}");
    }
    for few in 1..3 {
        assert_eq!(built(&cube[..few]), Err(SizeError::Unbounded));
    }
    assert_eq!(
        built(&[[0.0, 1.0, 1e-5], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]]),
        Err(SizeError::Unbounded)
    );
    // Empty: below -1 and above 1.
    let apart =
        [[-1.0, 1.0], [1.0, -1.0]].map(|[at, n]| HalfSpace::new(Vec3::new(at, 0.0, 0.0), Vec3::new(n, 0.0, 0.0)));
    let mut faces: Vec<HalfSpace<f32>> = apart.into_iter().flatten().collect();
    faces.extend(around_the_ball(&cube[2..]));
    assert_eq!(Polyhedron::new(faces.leak()), Err(SizeError::Unbounded));
}

#[test]
fn sizes_that_are_none_are_refused() {
    let y = Vec3::new(0.0_f32, 1.0, 0.0);
    let normal = |x: f32| HalfSpace::new(Vec3::ZERO, Vec3::new(x, 0.0, 0.0)).map(|_| ());
    assert_eq!(normal(0.0), Err(SizeError::Normal(ValueError::Zero)));
    let told = normal(0.0).unwrap_err().to_string();
    assert!(told.starts_with("the largest component of the normal is zero"), "{told}");
    assert_eq!(normal(f32::NAN), Err(SizeError::Normal(ValueError::NotFinite)));
    assert_eq!(normal(f32::MAX), Err(SizeError::Normal(ValueError::BeyondBudget)));
    assert_eq!(normal(1e-12), Err(SizeError::Normal(ValueError::BelowBudget)));
    let far = HalfSpace::new(Vec3::new(f32::INFINITY, 0.0, 0.0), y);
    assert_eq!(far, Err(SizeError::Corner(ValueError::NotFinite)));
    let faces: &[HalfSpace<f32>] = vec![HalfSpace::new(Vec3::ZERO, y).unwrap(); 17].leak();
    let within = |high: f32, faces| Polyhedron::within(Vec3::new(-1.0, -1.0, -1.0), Vec3::new(1.0, high, 1.0), faces);
    let told = "there is no half-space, or there are more than 16";
    assert_eq!(within(1.0, &faces[..0]).unwrap_err().to_string(), told);
    assert_eq!(within(1.0, faces), Err(SizeError::FaceCount));
    assert_eq!(within(-1.0, &faces[..1]), Err(SizeError::HalfExtent(ValueError::Zero)));
    assert_eq!(within(f32::NAN, &faces[..1]), Err(SizeError::Corner(ValueError::NotFinite)));
    assert!(within(1.0, &faces[..16]).is_ok());
}

/// The corner of three planes that span a volume of 1e-4 is 21,000 away: the box that was computed without it cut the
/// solid.
#[test]
fn a_needle_has_no_box() {
    let normals = [
        [-0.34422255, 0.9068288, -0.24325365],
        [0.44205794, 0.3203836, 0.8378181],
        [0.8160084, -0.18675134, 0.5470414],
        [-0.09140208, 0.6836252, 0.7240872],
        [-0.47154424, -0.81688225, 0.33218879],
        [0.1232567, 0.8409802, -0.5268398],
    ];
    assert_eq!(Polyhedron::new(around_the_ball::<f32>(&normals)), Err(SizeError::Unbounded));
    assert_eq!(Polyhedron::new(around_the_ball::<I16F16>(&normals)), Err(SizeError::Unbounded));
}

/// Two half-spaces that leave nothing of the box: no ray meets it, and no point is inside.
#[test]
fn an_empty_solid_is_never_met() {
    let above = HalfSpace::new(Vec3::new(0.0_f32, 0.5, 0.0), Vec3::new(0.0, -1.0, 0.0)).unwrap();
    let below = HalfSpace::new(Vec3::new(0.0_f32, -0.5, 0.0), Vec3::new(0.0, 1.0, 0.0)).unwrap();
    let empty = Polyhedron::within(v([-1.0; 3]), v([1.0; 3]), vec![above, below].leak()).unwrap();
    let mut random = Random(0xe);
    for _ in 0..times(500) {
        let Ok(ray) = Ray::towards(v::<f32>(random.direction().map(|c| 3.0 * c)), random.point(1.0)) else { continue };
        assert!(empty.hits(&ray).is_empty() && empty.hits_at::<Exact>(&ray).is_empty());
        assert!(!empty.contains(random.point(1.0)));
    }
}
