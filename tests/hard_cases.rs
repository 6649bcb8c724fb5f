//! The promise: rays that break the usual formulas get the answer of exact arithmetic, in every number type that can hold
//! them: far, tiny, huge, grazing, in the wall, in a cap's plane, rim to rim, through the apex, parallel to a generator.
//!
//! Each case is stated in a frame, as it is met in the world; the exact answer is that of the stored bits.

#[macro_use]
mod support;

use raylet::{Capsule, Cone, Cylinder, Frame, Primitive, Range, Ray, Scalar, Shape, SizeError, Sphere, UnitVec3, Vec3};
use support::cases::direction;
use support::exact_types::{Exact, same_crossing, same_part};
use support::oracle::{self, ConeExtent, CylinderExtent, Dyadic, Solid};

every_type!(every_hard_case_has_its_exact_answer);

/// A primitive by its sizes.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Sphere(f64),
    Cylinder(f64, f64),
    Capsule(f64, f64),
    DoubleCone(f64),
    Nappe(f64),
}
use Kind::{Capsule as Pill, Cylinder as Can, DoubleCone, Nappe, Sphere as Ball};

/// The direction of the primitive's axis in the world.
#[derive(Clone, Copy, Debug)]
enum Axis {
    X,
    Y,
    Z,
}

/// A name, the primitive, where its base lies and where its axis points, and the ray's origin and direction.
type Case = (&'static str, Kind, [f64; 3], Axis, [f64; 3], [f64; 3]);

const HOME: [f64; 3] = [0.0; 3];

const CASES: [Case; 30] = [
    ("sphere from 4,100 away", Ball(1.0), HOME, Axis::Y, [-4100.0, 0.5, 0.0], [1.0, 0.0, 0.0]),
    ("small sphere from 400 away", Ball(0.1), HOME, Axis::Y, [-400.0, 0.095, 0.0], [1.0, 0.0, 0.0]),
    ("one above a planet", Ball(6.4e6), [0.0, 0.0, -6.4e6], Axis::Y, [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]),
    ("tangent to a sphere", Ball(0.5), [0.5; 3], Axis::Y, [0.0, 0.0, 0.5], [1.0, 0.0, 0.0]),
    ("past a tangent point", Ball(0.5), [0.5; 3], Axis::Y, [0.6, 0.0, 0.5], [1.0, 0.0, 0.0]),
    ("cylinder of radius 1e20", Can(1e20, 1.0), HOME, Axis::Z, [-2e20, 0.0, 0.5], [1.0, 0.0, 0.0]),
    ("sphere of radius 1e-20", Ball(1e-20), HOME, Axis::Y, [-3e-20, 0.5e-20, 0.0], [1.0, 0.0, 0.0]),
    ("nearly along a capsule", Pill(1.0, 10.0), HOME, Axis::Y, [1.0001, 100.0, 0.0], [-0.001, -200.0, 0.0]),
    ("in a cylinder's wall", Can(1.0, 2.0), [0.0, 0.0, -1.0], Axis::Z, [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
    ("just outside the wall", Can(1.0, 2.0), [0.0, 0.0, -1.0], Axis::Z, [1.0001, 0.0, 0.0], [0.0, 0.0, 1.0]),
    ("along the axis", Can(1.0, 2.0), [0.0, 0.0, -1.0], Axis::Z, [0.25, 0.5, -7.0], [0.0, 0.0, 1.0]),
    ("in a cap's plane", Can(1.0, 2.0), [0.0, 0.0, -1.0], Axis::Z, [2.0, 0.5, 1.0], [-1.0, 0.0, 0.0]),
    ("just above a cap's plane", Can(1.0, 2.0), [0.0, 0.0, -1.0], Axis::Z, [2.0, 0.5, 1.0001], [-1.0, 0.0, 0.0]),
    ("from rim to rim", Can(1.0, 2.0), [0.0, 0.0, -1.0], Axis::Z, [2.0, 0.0, 1.0], [-1.0, 0.0, 0.0]),
    ("at a seam", Pill(1.0, 2.0), [0.0, 0.0, -1.0], Axis::Z, [2.0, 0.0, 1.0], [-1.0, 0.0, 0.0]),
    ("touching a seam", Pill(1.0, 2.0), HOME, Axis::Y, [-3.0, 2.0, 1.0], [1.0, 0.0, 0.0]),
    ("touching an end", Pill(1.0, 2.0), HOME, Axis::Y, [-3.0, 3.0, 0.0], [1.0, 0.0, 0.0]),
    ("parallel to a generator, outside", DoubleCone(0.75), HOME, Axis::Y, [-3.0, -2.0, 0.0], [0.6, 0.8, 0.0]),
    ("parallel to a generator, inside", DoubleCone(0.75), HOME, Axis::X, [4.0, 1.0, 0.0], [0.8, 0.6, 0.0]),
    ("parallel to a generator of one nappe", Nappe(0.75), HOME, Axis::Y, [3.0, -1.0, 0.0], [-0.6, 0.8, 0.0]),
    ("through the apex from outside", Nappe(1.0), HOME, Axis::X, [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]),
    ("into the nappe", Nappe(1.0), HOME, Axis::X, [0.0, 1.0, 0.0], [1.0, -1.0, 0.0]),
    ("into the nappe that is not there", Nappe(1.0), HOME, Axis::X, [0.0, 1.0, 0.0], [-1.0, -1.0, 0.0]),
    ("the same on the double cone", DoubleCone(1.0), HOME, Axis::X, [0.0, 1.0, 0.0], [-1.0, -1.0, 0.0]),
    ("along the axis through the apex", DoubleCone(0.5), HOME, Axis::Z, [0.0, 0.0, -3.0], [0.0, 0.0, 1.0]),
    ("close to the apex from 100 away", Nappe(0.5), HOME, Axis::Z, [-100.0, 1e-4, 1e-3], [1.0, 0.0, 0.0]),
    ("past the apex from 100 away", Nappe(0.5), HOME, Axis::Z, [-100.0, 1e-3, 0.0], [1.0, 0.0, 0.0]),
    ("from the outer of two shells", Ball(1.0), HOME, Axis::Y, [0.0, 0.0, 1.00004], [0.0, 0.0, -1.0]),
    ("from the centre", Ball(1.0), HOME, Axis::Y, HOME, [0.6, 0.0, -0.8]),
    ("from the surface inwards", Ball(1.0), HOME, Axis::Y, [1.0, 0.0, 0.0], [-0.8, -0.0, 0.6]),
];

/// The primitive and the oracle's solid; `None` where the type cannot hold a size.
fn build<S: Exact>(kind: Kind) -> Option<(Primitive<S>, Solid)> {
    fn built<S: Scalar, P: Into<Primitive<S>>>(primitive: Result<P, SizeError>) -> Option<Primitive<S>> {
        primitive.ok().map(Into::into)
    }
    let size = |value: f64| S::from_f64(value).filter(|size| *size > S::ZERO).map(|size| (size, size.exact()));
    Some(match kind {
        Kind::Sphere(r) => {
            let (r, radius) = size(r)?;
            (built(Sphere::new(r))?, Solid::Sphere { radius })
        }
        Kind::Cylinder(r, h) => {
            let ((r, radius), (h, height)) = (size(r)?, size(h)?);
            (built(Cylinder::capped(r, h))?, Solid::Cylinder { radius, extent: CylinderExtent::Capped(height) })
        }
        Kind::Capsule(r, h) => {
            let ((r, radius), (h, height)) = (size(r)?, size(h)?);
            (built(Capsule::new(r, h))?, Solid::Capsule { radius, height })
        }
        Kind::DoubleCone(m) => {
            let (m, slope) = size(m)?;
            (built(Cone::double(m))?, Solid::Cone { slope, extent: ConeExtent::Double })
        }
        Kind::Nappe(m) => {
            let (m, slope) = size(m)?;
            (built(Cone::nappe(m))?, Solid::Cone { slope, extent: ConeExtent::Nappe })
        }
    })
}

/// The ray in the frame's coordinates, exactly.
fn local<S: Exact>(ray: &Ray<S>, frame: &Frame<S>) -> oracle::Line {
    let [o, p] = [ray.origin(), frame.position()].map(|v| v.to_array().map(S::exact));
    let offset = [0, 1, 2].map(|i| &o[i] - &p[i]);
    let d = ray.direction().to_array().map(S::exact_unit);
    let axes = [frame.right(), frame.up(), frame.forward()].map(|axis| axis.to_array().map(S::exact_unit));
    let dot = |a: &[Dyadic; 3], b: &[Dyadic; 3]| &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2]);
    oracle::Line::new(axes.each_ref().map(|axis| dot(axis, &offset)), axes.each_ref().map(|axis| dot(axis, &d)))
}

fn every_hard_case_has_its_exact_answer<S: Exact>() {
    let mut held = 0;
    for (name, kind, base, axis, origin, towards) in CASES {
        let axis = match axis {
            Axis::X => UnitVec3::X,
            Axis::Y => UnitVec3::Y,
            Axis::Z => UnitVec3::Z,
        };
        let (Some((primitive, solid)), Some(base), Some(origin)) =
            (build::<S>(kind), Vec3::from_f64(base), Vec3::<S>::from_f64(origin))
        else {
            continue;
        };
        let (Ok(frame), Ok(ray)) = (Frame::from_base_and_axis(base, axis), Ray::new(origin, direction::<S>(towards)))
        else {
            continue;
        };
        held += 1;
        let shape = Shape::new(primitive).placed(frame);
        for ray in [ray, ray.with_range(Range::line())] {
            let hits = shape.hits(&ray);
            let answer = oracle::solve(&solid, &local(&ray, &frame));
            let (start, end) = (ray.range().start().exact(), ray.range().end().exact());
            let exact = oracle::hits_in_range(&answer, &start, Some(&end));
            let told = || format!("{}, {name}: {hits:?}, exactly {:?}", S::name(), exact.hits);
            assert_eq!(hits.len(), exact.hits.len(), "{}", told());
            assert_eq!(hits.starts_inside(), exact.starts_inside, "{}", told());
            assert_eq!(hits.coincident().is_some(), exact.coincident, "{}", told());
            for (hit, exact) in hits.iter().zip(&exact.hits) {
                assert!(same_part(hit.part, exact.part) && same_crossing(hit.crossing, exact.crossing), "{}", told());
                let error = exact.t.error_in(&hit.t.exact(), &S::unit_at(&exact.t));
                // Measured: 1 at worst, for the far root of a ray parallel to a generator but for its rounding.
                assert!(error <= 1.0, "{error} units: {}", told());
            }
        }
    }
    println!("{}: {held} of {} cases are held by the type", S::name(), CASES.len());
    assert!(held >= 26, "{}: only {held} cases fit the type", S::name());
}
