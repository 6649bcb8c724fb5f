//! A digest of every answer to a fixed set of rays: equal bits on every machine make equal digests.
//!
//! Nothing here depends on the machine: rays come from integers, and of every answer each bit is taken.

use crate::borrowed::{self, Borrowed};
use crate::{milled, returns};
use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::types::{I16F16, I32F32};
use fixed::{FixedI32, FixedI64};
use raylet::thick::ThickRay;
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{
    Affine, Annulus, Capsule, Combination, Cone, Cuboid, Cylinder, Departure, Disc, Frame, Leaving, Plane, Primitive,
    Range, Ray, Rectangle, Revolved, RoundCone, RoundedCuboid, Scalar, Shape, Size, Sphere, Torus, Triangle, Tube,
    UnitVec3, Vec3,
};

/// Rays at each primitive. An emulated M0+ takes two minutes for them: what differs between chips is how numbers are
/// computed, which every ray shows.
const RAYS: u32 = 400;

/// Moving balls at each of them.
const CONTACTS: u32 = 40;

/// Every bit of a number.
pub trait Bits {
    /// The bits.
    fn bits(self) -> u64;
}

impl Bits for f32 {
    fn bits(self) -> u64 {
        self.to_bits().into()
    }
}

impl Bits for f64 {
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

impl<F: LeEqU32> Bits for FixedI32<F> {
    fn bits(self) -> u64 {
        self.to_bits() as u64
    }
}

impl<F: LeEqU64> Bits for FixedI64<F> {
    fn bits(self) -> u64 {
        self.to_bits() as u64
    }
}

/// FNV-1a (Fowler, Noll, Vo), over words instead of bytes.
pub(crate) struct Digest(u64);

impl Digest {
    pub(crate) const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    pub(crate) const fn bits(&self) -> u64 {
        self.0
    }

    pub(crate) fn take(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01b3);
        self.0 ^= self.0 >> 29;
    }
}

/// xorshift64* (Marsaglia; Vigna, *An experimental exploration of Marsaglia's xorshift generators*, 2016).
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 32) as u32
    }

    /// A multiple of 1/1024 between `-size` and `size`, which every number type holds.
    fn number<S: Scalar>(&mut self, size: u32) -> S {
        let steps = size * 1024;
        let step = (self.next() % (2 * steps + 1)) as i32 - steps as i32;
        S::from_f64(step as f64 / 1024.0).unwrap_or(S::ZERO)
    }

    /// A point between `-size` and `size` in each coordinate.
    pub fn point<S: Scalar>(&mut self, size: u32) -> Vec3<S> {
        Vec3::new(self.number(size), self.number(size), self.number(size))
    }

    /// From far or near, through or past the solid, sometimes along an axis.
    fn ray<S: Scalar>(&mut self) -> Option<Ray<S>> {
        let kind = self.next();
        let origin = self.point(if kind.is_multiple_of(4) { 500 } else { 6 });
        let ray = if (kind >> 2).is_multiple_of(4) {
            let axis = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z][(kind >> 8) as usize % 3];
            Ray::new(origin, if kind & 0x10 == 0 { axis } else { -axis })
        } else {
            Ray::towards(origin, self.point(2))
        };
        let ray = ray.ok()?;
        Some(if kind & 0x20 == 0 { ray.with_range(Range::line()) } else { ray })
    }
}

/// The primitives: those of the canonical pose, then some of them placed.
fn shape<S: Borrowed>(index: usize) -> Option<(&'static str, Shape<S>)> {
    let n = |eighths: i32| S::from_f64(eighths as f64 / 8.0).unwrap_or(S::ZERO);
    let v = |x: i32, y: i32, z: i32| Vec3::new(n(x), n(y), n(z));
    let frame =
        || Frame::looking(v(8, -4, 2), UnitVec3::new(v(8, 16, 16)).ok()?, UnitVec3::new(v(-3, 9, 1)).ok()?).ok();
    let affine = || Affine::new(v(3, -2, 5), [v(12, 1, 0), v(-2, 5, 3), v(0, 2, 20)]).ok();
    let (name, primitive): (&str, Primitive<S>) = match index {
        0 | 13 => ("sphere", Sphere::new(n(9)).ok()?.into()),
        1 => ("cylinder infinite", Cylinder::infinite(n(9)).ok()?.into()),
        2 => ("cylinder open", Cylinder::open(n(9), n(14)).ok()?.into()),
        3 | 14 => ("cylinder capped", Cylinder::capped(n(9), n(14)).ok()?.into()),
        4 => ("capsule", Capsule::new(n(9), n(14)).ok()?.into()),
        5 => ("cone double", Cone::double(n(6)).ok()?.into()),
        6 => ("cone nappe", Cone::nappe(n(6)).ok()?.into()),
        7 => ("cone open", Cone::open(n(6), n(14)).ok()?.into()),
        8 | 15 => ("cone capped", Cone::capped(n(6), n(14)).ok()?.into()),
        9 => ("frustum capped", Cone::frustum(n(11), n(5), n(14)).ok()?.into()),
        10 => ("plane", Plane::new().into()),
        11 => ("disc", Disc::new(n(9)).ok()?.into()),
        12 => ("triangle", Triangle::new(v(-9, 0, -6), v(7, 2, -5), v(2, -2, 10)).ok()?.into()),
        16 => ("capsule", Capsule::new(n(9), n(14)).ok()?.into()),
        17..20 => ("cuboid", Cuboid::new(n(9), n(7), n(12)).ok()?.into()),
        20 | 21 => ("rectangle", Rectangle::new(n(9), n(12)).ok()?.into()),
        22 | 23 => ("paraboloid", Revolved::paraboloid(n(4), n(14)).ok()?.into()),
        24 => ("ball zone", Revolved::ball_zone(n(9), [n(-4), n(7)]).ok()?.into()),
        25 | 26 => ("hyperboloid", Revolved::hyperboloid(n(6), n(7), [n(-7), n(9)]).ok()?.into()),
        27..30 => ("tube", Tube::new(n(6), n(9), n(14)).ok()?.into()),
        32..35 => ("round cone", RoundCone::new(n(9), n(5), n(14)).ok()?.into()),
        35..38 => ("rounded cuboid", RoundedCuboid::new(n(6), n(4), n(9), n(3)).ok()?.into()),
        38..41 => ("prism", borrowed::prism(n(14))?.into()),
        41..44 => ("polyhedron", borrowed::polyhedron::<S>()?.into()),
        44..47 => ("torus", Torus::new(n(9), n(3)).ok()?.into()),
        30 | 31 => ("annulus", Annulus::new(n(4), n(9)).ok()?.into()),
        _ => return None,
    };
    let shape = Shape::new(primitive);
    Some(match index {
        13 => ("sphere framed", shape.placed(frame()?)),
        14 => ("cylinder capped framed", shape.placed(frame()?)),
        15 => ("cone capped stretched", shape.placed(affine()?)),
        16 => ("capsule stretched", shape.placed(affine()?)),
        18 => ("cuboid framed", shape.placed(frame()?)),
        19 => ("cuboid stretched", shape.placed(affine()?)),
        21 => ("rectangle framed", shape.placed(frame()?)),
        23 => ("paraboloid framed", shape.placed(frame()?)),
        26 => ("hyperboloid stretched", shape.placed(affine()?)),
        28 => ("tube framed", shape.placed(frame()?)),
        29 => ("tube stretched", shape.placed(affine()?)),
        31 => ("annulus framed", shape.placed(frame()?)),
        33 => ("round cone framed", shape.placed(frame()?)),
        34 => ("round cone stretched", shape.placed(affine()?)),
        36 => ("rounded cuboid framed", shape.placed(frame()?)),
        37 => ("rounded cuboid stretched", shape.placed(affine()?)),
        39 => ("prism framed", shape.placed(frame()?)),
        40 => ("prism stretched", shape.placed(affine()?)),
        42 => ("polyhedron framed", shape.placed(frame()?)),
        43 => ("polyhedron stretched", shape.placed(affine()?)),
        45 => ("torus framed", shape.placed(frame()?)),
        46 => ("torus stretched", shape.placed(affine()?)),
        _ => (name, shape),
    })
}

/// The digest of one shape in one tier.
fn digest<S: Scalar<Unit: Bits> + Bits, T: Tier<S>>(shape: &Shape<S>) -> u64 {
    let mut digest = Digest::new();
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for _ in 0..RAYS {
        let Some(ray) = random.ray::<S>() else { continue };
        let hits = shape.hits_at::<T>(&ray);
        digest.take(hits.len() as u64);
        digest.take(u64::from(hits.starts_inside()) | u64::from(shape.occludes_at::<T>(&ray)) << 1);
        if let Some(range) = hits.coincident() {
            digest.take(range.start().bits());
            digest.take(range.end().bits());
        }
        digest.take(shape.nearest_at::<T>(&ray).map_or(0, |hit| hit.t.bits()));
        digest.take(u64::from(shape.contains_at::<T>(ray.origin())));
        for hit in &hits {
            digest.take(hit.t.bits());
            digest.take(hit.part as u64 | (hit.crossing as u64) << 8);
            let surface = shape.surface(&ray, hit);
            surface.point().to_array().into_iter().for_each(|c| digest.take(c.bits()));
            surface.normal().to_array().into_iter().for_each(|c| digest.take(c.bits()));
            let (u, v) = surface.uv();
            digest.take(u.bits());
            digest.take(v.bits());
            let (along_u, along_v) = surface.tangents();
            along_u.to_array().into_iter().chain(along_v.to_array()).for_each(|c| digest.take(c.bits()));
            for leaving in [Leaving::Inwards, Leaving::Outwards] {
                let Ok(next) = Ray::new(surface.point(), ray.direction()) else { continue };
                let departure = Departure { object: 0, part: hit.part, leaving };
                let far = shape.nearest_at::<T>(&next.departing(departure));
                digest.take(far.map_or(1, |hit| hit.t.bits()));
            }
        }
    }
    digest.bits()
}

/// A digest of all hits of the milled part by the rays of a small picture.
fn milled_part<S: Scalar<Unit: Bits> + Bits, T: Tier<S>>() -> Option<u64> {
    let leaves = milled::leaves::<S>()?;
    let part = Combination::new(&leaves, &milled::OPERATIONS).ok()?;
    let (shape, view) = (part.shape(), milled::camera::<S>()?.raster(Size::new(48, 36)));
    let mut digest = Digest::new();
    for pixel in 0..48 * 36 {
        let Some(ray) = view.ray([pixel % 48, pixel / 48], [0, 0]) else { continue };
        for on in part.leaf_hits_at::<T>(&ray) {
            digest.take(on.hit.t.bits());
            digest.take(u64::from(on.leaf) << 16 | (on.hit.part as u64) << 8 | on.hit.crossing as u64);
            let normal = shape.surface(&ray, &on.hit).normal();
            normal.to_array().into_iter().for_each(|component| digest.take(component.bits()));
        }
    }
    Some(digest.bits())
}

/// A digest of the contacts of a moving ball with each solid that may be tested with one.
fn contacts<S: Borrowed<Unit: Bits> + Bits, T: Tier<S>>() -> u64 {
    let mut digest = Digest::new();
    let radius = S::from_f64(0.375).unwrap_or(S::ZERO);
    let mut index = 0;
    while let Some((_, shape)) = shape::<S>(index) {
        index += 1;
        let mut random = Random(0x510e_527f_ade6_82d1);
        for _ in 0..CONTACTS {
            let Some(ball) = random.ray::<S>().and_then(|ray| ThickRay::new(ray, radius).ok()) else { continue };
            for found in [ball.contact_at::<T, _>(&shape), ball.at_start(&shape)] {
                let Ok(Some(contact)) = found else { continue };
                digest.take(contact.t.bits());
                digest.take(u64::from(contact.overlaps));
                contact.point.to_array().into_iter().for_each(|c| digest.take(c.bits()));
                contact.normal.to_array().into_iter().for_each(|c| digest.take(c.bits()));
            }
        }
    }
    digest.bits()
}

/// Hands every shape, number type, tier and digest to `report`, always in the same order.
pub fn all(report: &mut dyn FnMut(&str, &str, &str, u64)) {
    fn tier<S: Borrowed<Unit: Bits> + Bits, T: Tier<S>>(
        number: &str,
        tier: &str,
        report: &mut dyn FnMut(&str, &str, &str, u64),
    ) {
        let mut index = 0;
        while let Some((name, shape)) = shape::<S>(index) {
            report(number, tier, name, digest::<S, T>(&shape));
            index += 1;
        }
        report(number, tier, "crossings of forty solids", returns::digest::<S, T>());
        report(number, tier, "milled part", milled_part::<S, T>().unwrap_or_default());
    }
    tier::<f32, Plain>("f32", "Plain", report);
    tier::<f32, Fast>("f32", "Fast", report);
    tier::<f32, Stable>("f32", "Stable", report);
    tier::<f32, Exact>("f32", "Exact", report);
    tier::<I16F16, Plain>("I16F16", "Plain", report);
    tier::<I16F16, Fast>("I16F16", "Fast", report);
    tier::<I16F16, Stable>("I16F16", "Stable", report);
    tier::<I16F16, Exact>("I16F16", "Exact", report);
    tier::<I32F32, Plain>("I32F32", "Plain", report);
    tier::<I32F32, Fast>("I32F32", "Fast", report);
    tier::<I32F32, Stable>("I32F32", "Stable", report);
    tier::<f64, Plain>("f64", "Plain", report);
    tier::<f64, Fast>("f64", "Fast", report);
    tier::<f64, Stable>("f64", "Stable", report);
    let mut balls = |number: &str, digest| report(number, "Stable", "contacts of a ball", digest);
    balls("f32", contacts::<f32, Stable>());
    balls("f64", contacts::<f64, Stable>());
    balls("I16F16", contacts::<I16F16, Stable>());
    balls("I32F32", contacts::<I32F32, Stable>());
}
