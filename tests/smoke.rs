//! Every solid in every number type and in every tier, once. The tests of all that raylet promises are in
//! `tests/promises`.

use fixed::types::{I16F16, I32F32};
use raylet::{
    Affine, Annulus, Capsule, Cone, Crossing, Cuboid, Cylinder, Disc, Exact, Fast, Frame, HalfSpace, Part, Plain,
    Plane, Polyhedron, Prism, Ray, Rectangle, Revolved, RoundCone, RoundedCuboid, Scalar, Shape, Sphere, Stable, Tier,
    Torus, Triangle, Tube, UnitVec3, Vec3,
};

fn n<S: Scalar>(value: f64) -> S {
    S::from_f64(value).expect("every number type holds numbers of a few eighths")
}

fn v<S: Scalar>(x: f64, y: f64, z: f64) -> Vec3<S> {
    Vec3::new(n(x), n(y), n(z))
}

/// A solid, unplaced, and where a ray along -z from (.25, .5, 8) meets it: `t` of each hit, with its part.
type Row<S> = (&'static str, Shape<S>, &'static [(f64, Part)]);

/// Solids whose hits on that ray are exact numbers of few bits, or irrational and known.
fn solids<S: Scalar>() -> [Row<S>; 13] {
    // The sphere of radius 1.25 is met at z = +-sqrt(1.25^2 - .25^2 - .5^2), the cylinder of radius 1.25 at
    // +-sqrt(1.5).
    const SPHERE: &[(f64, Part)] =
        &[(8.0 - 1.118_033_988_749_895, Part::Side), (8.0 + 1.118_033_988_749_895, Part::Side)];
    const ROUND: &[(f64, Part)] =
        &[(8.0 - 1.224_744_871_391_589, Part::Side), (8.0 + 1.224_744_871_391_589, Part::Side)];
    // The cone of slope 2 has radius 1 at y = .5, the frustum from 1.5 to .5 over 2 has 1.25.
    const CONE: &[(f64, Part)] =
        &[(8.0 - 0.968_245_836_551_854, Part::Side), (8.0 + 0.968_245_836_551_854, Part::Side)];
    // The wall of the tube is left at +-sqrt(.5) and entered again.
    const WALL: &[(f64, Part)] = &[
        (8.0 - 1.224_744_871_391_589, Part::Side),
        (8.0 - core::f64::consts::FRAC_1_SQRT_2, Part::Inner),
        (8.0 + core::f64::consts::FRAC_1_SQRT_2, Part::Inner),
        (8.0 + 1.224_744_871_391_589, Part::Side),
    ];
    // At y = .5 the torus reaches from .375 within its middle circle of radius 1 to .375 beyond.
    const RING: &[(f64, Part)] = &[
        (8.0 - 1.352_081_728_298_996, Part::Side),
        (8.0 - 0.572_821_961_869_480, Part::Side),
        (8.0 + 0.572_821_961_869_480, Part::Side),
        (8.0 + 1.352_081_728_298_996, Part::Side),
    ];
    [
        ("sphere", Shape::new(Sphere::new(n(1.25)).unwrap()), SPHERE),
        ("infinite cylinder", Shape::new(Cylinder::infinite(n(1.25)).unwrap()), ROUND),
        ("open cylinder", Shape::new(Cylinder::open(n(1.25), n(2.0)).unwrap()), ROUND),
        ("capped cylinder", Shape::new(Cylinder::capped(n(1.25), n(2.0)).unwrap()), ROUND),
        ("capsule", Shape::new(Capsule::new(n(1.25), n(2.0)).unwrap()), ROUND),
        ("round cone", Shape::new(RoundCone::new(n(1.25), n(1.25), n(2.0)).unwrap()), ROUND),
        ("ball zone", Shape::new(Revolved::ball_zone(n(1.25), [n(-1.0), n(1.0)]).unwrap()), SPHERE),
        ("tube", Shape::new(Tube::new(n(0.75), n(1.25), n(2.0)).unwrap()), WALL),
        ("torus", Shape::new(Torus::new(n(1.0), n(0.625)).unwrap()), RING),
        ("double cone", Shape::new(Cone::double(n(2.0)).unwrap()), CONE),
        ("capped cone", Shape::new(Cone::capped(n(2.0), n(2.0)).unwrap()), CONE),
        ("frustum", Shape::new(Cone::frustum(n(1.5), n(0.5), n(2.0)).unwrap()), ROUND),
        (
            "triangle",
            Shape::new(Triangle::new(v(-2.0, -2.0, 1.0), v(4.0, -2.0, 1.0), v(-2.0, 4.0, 1.0)).unwrap()),
            &[(7.0, Part::Side)],
        ),
    ]
}

/// All queries about one ray agree with what is known, and with each other.
fn check<S: Scalar, T: Tier<S>>(name: &str, shape: &Shape<S>, ray: &Ray<S>, expected: &[(f64, Part)]) {
    let hits = shape.hits_at::<T>(ray);
    assert_eq!(hits.len(), expected.len(), "{name}: {hits:?}");
    for (hit, (t, part)) in hits.iter().zip(expected) {
        // 16 units in the last place of an f32 near 8, and far more of any other type; all of this is a smoke test.
        assert!((hit.t.to_f64() - t).abs() < 1e-3, "{name}: {hit:?}, not {t}");
        assert_eq!(hit.part, *part, "{name}");
        let normal = shape.surface(ray, hit).normal().to_f64();
        assert!((normal.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-5, "{name}: {normal:?}");
    }
    assert_eq!(shape.nearest_at::<T>(ray), hits.first().copied(), "{name}");
    assert_eq!(shape.occludes_at::<T>(ray), !hits.is_empty(), "{name}");
}

fn every_solid<S: Scalar, T: Tier<S>>() {
    let ray = Ray::new(v(0.25, 0.5, 8.0), -UnitVec3::<S>::Z).unwrap();
    let aside = Ray::new(v(7.0, 7.0, 7.0), UnitVec3::<S>::X).unwrap();
    let frame = Frame::at(v(1.0, -2.0, 3.0)).unwrap();
    let doubled = Affine::stretched(frame, v(2.0, 2.0, 2.0)).unwrap();
    let moved = Ray::new(v(1.25, -1.5, 11.0), -UnitVec3::<S>::Z).unwrap();
    for (name, shape, expected) in solids::<S>() {
        check::<S, T>(name, &shape, &ray, expected);
        check::<S, T>(name, &shape.placed(frame), &moved, expected);
        if name != "double cone" && name != "infinite cylinder" {
            check::<S, T>(name, &shape.placed(doubled), &aside, &[]);
        }
    }
    let down = Ray::new(v(0.25, 4.0, 0.5), -UnitVec3::<S>::Y).unwrap();
    check::<S, T>("plane", &Shape::new(Plane::new()), &down, &[(4.0, Part::Side)]);
    check::<S, T>("disc", &Shape::new(Disc::new(n(1.0)).unwrap()), &down, &[(4.0, Part::Side)]);
    check::<S, T>("annulus", &Shape::new(Annulus::new(n(0.25), n(1.0)).unwrap()), &down, &[(4.0, Part::Side)]);
    let soap = RoundedCuboid::new(n(1.0), n(0.5), n(2.0), n(0.25)).unwrap();
    check::<S, T>("rounded cuboid", &Shape::new(soap), &down, &[(3.25, Part::Top), (4.75, Part::Base)]);
    let corners = [[n(1.0), n(1.0)], [n(1.0), n(-1.0)], [n(-1.0), n(0.0)]];
    let wedge = Prism::new(corners.to_vec().leak(), n(2.0)).unwrap();
    check::<S, T>("prism", &Shape::new(wedge), &down, &[(2.0, Part::Top), (4.0, Part::Base)]);
    let slope = HalfSpace::new(v(0.25, 1.0, 0.0), v(1.0, 1.0, 0.0)).unwrap();
    let ramp = Polyhedron::within(v(-1.0, 0.0, -1.0), v(1.0, 2.0, 1.0), vec![slope].leak()).unwrap();
    check::<S, T>("polyhedron", &Shape::new(ramp), &down, &[(3.0, Part::Facet0), (4.0, Part::Base)]);
    // Through the caps: the top is entered, the base left.
    let can = Cylinder::capped(n::<S>(1.25), n(2.0)).unwrap();
    let cuboid = Shape::new(Cuboid::new(n(1.0), n(0.5), n(2.0)).unwrap());
    check::<S, T>("cuboid", &cuboid, &down, &[(3.5, Part::Top), (4.5, Part::Base)]);
    check::<S, T>("rectangle", &Shape::new(Rectangle::new(n(1.0), n(1.0)).unwrap()), &down, &[(4.0, Part::Side)]);
    check::<S, T>("capped cylinder", &Shape::new(can), &down, &[(2.0, Part::Top), (4.0, Part::Base)]);
    let [top, base] = &can.hits_at::<T>(&down)[..] else { panic!("two hits") };
    assert_eq!((top.crossing, base.crossing), (Crossing::Enter, Crossing::Exit));
    assert!(can.contains(v(1.0, 1.0, 0.0)) && !can.contains(v(1.0, 2.5, 0.0)));
}

// The tests of the promises have all fourteen pairs of a number type and a tier; each takes ten seconds to compile.

#[test]
fn f32_exact() {
    every_solid::<f32, Exact>();
}

#[test]
fn f64_plain() {
    every_solid::<f64, Plain>();
}

#[test]
fn i16f16_stable() {
    every_solid::<I16F16, Stable>();
}

#[test]
fn i32f32_fast() {
    every_solid::<I32F32, Fast>();
}
