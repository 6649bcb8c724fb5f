//! The digests that the tests in C print, by the library itself: the same rays at the same solids.

use fixed::types::I16F16;
use raylet::hierarchy::{Hierarchy, Node};
use raylet::scalar::UnitScalar;
use raylet::solids::{Crossings, SolidCrossing, SolidSet, Start};
use raylet::{
    Affine, Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Ellipsoid, Exact, ExactScalar, Fast, Frame, HalfSpace,
    Plain, Plane, Polyhedron, Prism, Ray, Rectangle, Revolved, RoundCone, RoundedCuboid, Scalar, Shape, Shapes, Sphere,
    Stable, Tier, Torus, Triangle, Tube, UnitVec3, Vec3,
};
use std::fmt::Write as _;
use std::path::Path;

/// The bits of a number and of a component of a direction.
trait Bits: ExactScalar {
    fn bits(self) -> u32;
    fn unit_bits(unit: Self::Unit) -> u32;
}

impl Bits for f32 {
    fn bits(self) -> u32 {
        self.to_bits()
    }
    fn unit_bits(unit: f32) -> u32 {
        unit.to_bits()
    }
}

impl Bits for I16F16 {
    fn bits(self) -> u32 {
        self.to_bits() as u32
    }
    fn unit_bits(unit: Self::Unit) -> u32 {
        (UnitScalar::to_f64(unit) * f64::from(1 << 30)) as i32 as u32
    }
}

fn n<S: Scalar>(value: f64) -> S {
    S::from_f64(value).expect("every number type holds numbers of a few eighths")
}

fn v<S: Scalar>(x: f64, y: f64, z: f64) -> Vec3<S> {
    Vec3::new(n(x), n(y), n(z))
}

fn shapes<S: Scalar>() -> Result<[Shape<S>; 24], raylet::Error> {
    let corners = [[n(1.0), n(1.0)], [n(1.0), n(-1.0)], [n(-1.0), n(0.0)]];
    let slope = HalfSpace::new(v(0.25, 1.0, 0.0), v(1.0, 1.0, 0.0))?;
    Ok([
        Shape::new(Sphere::new(n(1.25))?),
        Shape::new(Cylinder::infinite(n(1.25))?),
        Shape::new(Cylinder::open(n(1.25), n(2.0))?),
        Shape::new(Cylinder::capped(n(1.25), n(2.0))?),
        Shape::new(Capsule::new(n(1.25), n(2.0))?),
        Shape::new(RoundCone::new(n(1.25), n(1.25), n(2.0))?),
        Shape::new(Revolved::ball_zone(n(1.25), [n(-1.0), n(1.0)])?),
        Shape::new(Tube::new(n(0.75), n(1.25), n(2.0))?),
        Shape::new(Torus::new(n(1.0), n(0.625))?),
        Shape::new(Cone::double(n(2.0))?),
        Shape::new(Cone::capped(n(2.0), n(2.0))?),
        Shape::new(Cone::frustum(n(1.5), n(0.5), n(2.0))?),
        Shape::new(Triangle::new(v(-2.0, -2.0, 1.0), v(4.0, -2.0, 1.0), v(-2.0, 4.0, 1.0))?),
        Shape::new(Plane::new()),
        Shape::new(Disc::new(n(1.0))?),
        Shape::new(Annulus::new(n(0.25), n(1.0))?),
        Shape::new(RoundedCuboid::new(n(1.0), n(0.5), n(2.0), n(0.25))?),
        Shape::new(Prism::new(corners.to_vec().leak(), n(2.0))?),
        Shape::new(Polyhedron::within(v(-1.0, 0.0, -1.0), v(1.0, 2.0, 1.0), vec![slope].leak())?),
        Shape::new(Cuboid::new(n(1.0), n(0.5), n(2.0))?),
        Shape::new(Rectangle::new(n(1.0), n(1.0))?),
        Shape::new(Cone::nappe(n(0.5))?),
        Shape::new(Revolved::hyperboloid(n(0.5), n(1.0), [n(-1.0), n(1.0)])?),
        Ellipsoid::new(n(1.5), n(0.5), n(1.0))?.shape()?,
    ])
}

fn add(digest: u32, word: u32) -> u32 {
    (digest ^ word).wrapping_mul(16_777_619)
}

fn of_hits<S: Bits, T: Tier<S>>(mut digest: u32, shape: &Shape<S>, ray: &Ray<S>) -> u32 {
    let hits = shape.hits_at::<T>(ray);
    digest = add(digest, hits.len() as u32);
    for hit in &*hits {
        let surface = shape.surface(ray, hit);
        let part = raylet::Part::EVERY.iter().position(|part| *part == hit.part).expect("it is among all parts");
        let (u, v) = surface.uv();
        let words = [hit.t.bits(), part as u32 * 4 + hit.crossing as u32].into_iter();
        let words = words.chain(surface.normal().to_array().map(S::unit_bits));
        let words = words.chain(surface.point().to_array().map(S::bits)).chain([u, v].map(S::unit_bits));
        digest = words.fold(digest, add);
    }
    digest
}

/// The queries of a tier about a shape and about all shapes, but for all hits of a shape.
fn of_queries<S: Bits, T: Tier<S>>(
    mut digest: u32,
    shape: &Shape<S>,
    all: &Shapes<'_, S>,
    ray: &Ray<S>,
    point: Vec3<S>,
) -> u32 {
    let mut words: Vec<u32> = vec![];
    let hit = shape.nearest_at::<T>(ray);
    words.push(hit.is_some().into());
    words.extend(hit.map(|hit| hit.t.bits()));
    words.extend([shape.occludes_at::<T>(ray), shape.contains_at::<T>(point)].map(u32::from));
    let nearest = all.nearest_at::<T>(ray);
    words.push(nearest.is_some().into());
    words.extend(nearest.into_iter().flat_map(|(index, hit)| [index, hit.t.bits()]));
    words.push(all.occludes_at::<T>(ray).into());
    let mut count = 0;
    all.hits_at::<T>(ray, |index, hits| {
        count += 1;
        words.extend([index, hits.len() as u32]);
    });
    words.push(count);
    match Crossings::<S, 32>::with_start::<T>(all.list(), ray, &Start::new()) {
        Ok(crossings) => {
            words.push(crossings.len() as u32);
            let bits = |set: SolidSet| set.iter().fold(0, |bits, solid| bits | 1 << solid);
            for SolidCrossing { hit, solid, before, after } in &crossings {
                words.extend([hit.t.bits(), solid, bits(before), bits(after)]);
            }
        }
        Err(_) => words.push(0xffff),
    }
    for word in words {
        digest = add(digest, word);
    }
    digest
}

fn of_first_numbers<S: Bits, T: Tier<S>>(digest: u32, shape: &Shape<S>, ray: &Ray<S>) -> u32 {
    match shape.try_nearest_at::<T>(ray) {
        Ok(None) => add(digest, 0),
        Ok(Some(hit)) => add(add(digest, 1), hit.t.bits()),
        Err(_) => add(digest, 0xffff),
    }
}

/// Of all hits with their surfaces, and of all other queries.
fn digests<S: Bits>(rays: u32) -> Result<[u32; 2], raylet::Error>
where
    Exact: Tier<S>,
{
    let shapes = shapes::<S>()?;
    let mut nodes = [Node::EMPTY; Hierarchy::<f32>::nodes_for(24)];
    let all = Shapes::new(&shapes, &mut nodes)?;
    let (mut digest, mut queries, mut state) = (2_166_136_261_u32, 2_166_136_261_u32, 1_u32);
    for i in 0..rays {
        let numbers: [f64; 12] = core::array::from_fn(|k| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let number = ((state >> 12) as i32 - (1 << 19)) >> if k < 3 { 0 } else { 3 };
            f64::from(number) / 65536.0
        });
        let point = |k: usize| v::<S>(numbers[k], numbers[k + 1], numbers[k + 2]);
        let (Ok(ray), Ok(axis)) = (Ray::towards(point(0), point(3)), UnitVec3::new(point(6))) else { continue };
        let frame = Frame::from_base_and_axis(point(9), axis)?;
        let mut shape = shapes[i as usize % shapes.len()];
        match i % 3 {
            1 => shape = shape.placed(frame),
            2 => shape = shape.placed(Affine::stretched(frame, v(0.5, 1.0, 2.0))?),
            _ => {}
        }
        let to = point(3);
        queries = of_queries::<S, Plain>(queries, &shape, &all, &ray, to);
        queries = of_queries::<S, Fast>(queries, &shape, &all, &ray, to);
        queries = of_queries::<S, Stable>(queries, &shape, &all, &ray, to);
        queries = of_queries::<S, Exact>(queries, &shape, &all, &ray, to);
        queries = of_first_numbers::<S, Plain>(queries, &shape, &ray);
        queries = of_first_numbers::<S, Fast>(queries, &shape, &ray);
        queries = of_first_numbers::<S, Stable>(queries, &shape, &ray);
        digest = of_hits::<S, Plain>(digest, &shape, &ray);
        digest = of_hits::<S, Fast>(digest, &shape, &ray);
        digest = of_hits::<S, Stable>(digest, &shape, &ray);
        digest = of_hits::<S, Exact>(digest, &shape, &ray);
    }
    Ok([digest, queries])
}

/// What the tests in C must print, on the host and on every chip. `RAYLET_WRITE_EXPECTED=1` renews it.
#[test]
fn the_digests_are_stored() {
    let mut text = String::new();
    for (name, [of_hits, of_queries]) in [("f32", digests::<f32>(480)), ("i16f16", digests::<I16F16>(480))]
        .map(|(name, digests)| (name, digests.expect("all are made")))
    {
        writeln!(text, "digest of {name}: {of_hits}\ndigest of queries in {name}: {of_queries}")
            .expect("there is room");
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/expected.txt");
    if std::env::var_os("RAYLET_WRITE_EXPECTED").is_some() {
        std::fs::write(&path, &text).expect("the file can be written");
    }
    let stored = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(stored, text, "set RAYLET_WRITE_EXPECTED=1 to renew {}", path.display());
}
