//! The running error bounds of the coefficients of quadrics, beside the same coefficients in 128 bits.

use super::LocalRay;
use super::local_ray::{Localize, rounded_ray};
use super::quadric::{Ball, Cylinder, Nappe, Quadric, Revolution, Tangent};
use crate::affine::Affine;
use crate::frame::Frame;
use crate::line::{InWorld, Needs, Place};
use crate::number::{Estimate, Number, Ring, Robust, Running};
use crate::outline::Meridian;
use crate::random::Random;
use crate::ray::Ray;
use crate::scalar::FromScalar;
use crate::vector::{UnitVec3, Vec3};
use std::format;
use std::string::String;

type Wide = Robust<u128>;

impl Random {
    /// Between -1 and 1.
    fn part(&mut self) -> f32 {
        self.between(-1.0, 1.0) as f32
    }

    fn vector(&mut self, size: f32) -> Vec3<f32> {
        Vec3::new(self.part() * size, self.part() * size, self.part() * size)
    }

    /// A direction; one in four is close to an axis.
    fn unit_vector(&mut self) -> UnitVec3<f32> {
        loop {
            let mut v = self.vector(1.0);
            if self.next().is_multiple_of(4) {
                let size = f32::powi(2.0, -((self.next() % 30) as i32));
                v = Vec3::new(v.x, v.y * size, v.z * size);
            }
            if let Ok(direction) = UnitVec3::new(v) {
                return direction;
            }
        }
    }

    /// A length of a solid: most are near 1, some near the ends of the type.
    fn size(&mut self) -> f32 {
        let exponent = match self.next() % 16 {
            0 => 25 + (self.next() % 5) as i32,
            1 => -60 - (self.next() % 66) as i32,
            _ => (self.next() % 12) as i32 - 6,
        };
        (1.5 + self.part() / 2.0) * f32::powi(2.0, exponent)
    }

    /// A ray at a solid of this size at a position, from near or far: through it, past it, or along its surface.
    fn ray(&mut self, position: Vec3<f32>, size: f32) -> Option<Ray<f32>> {
        let distance = size * f32::powi(2.0, (self.next() % 16) as i32);
        let beside = self.vector(size);
        let target = Vec3::new(position.x + beside.x, position.y + beside.y, position.z + beside.z);
        let from = self.vector(distance);
        let origin = Vec3::new(target.x + from.x, target.y + from.y, target.z + from.z);
        if self.next().is_multiple_of(4) {
            Ray::new(origin, self.unit_vector()).ok()
        } else {
            Ray::towards(origin, target).ok()
        }
    }
}

/// The ray in the frame from the origin to which `moved` moved it, in 128 bits.
fn exactly<P: Place<f32>>(place: &P, ray: &Ray<f32>, needs: Needs, moved: f32) -> [[Wide; 3]; 2] {
    let [o, d] = match needs {
        Needs::Translation => place.ball_line::<Wide>(ray),
        _ => place.line::<Wide>(ray),
    };
    let k = Wide::scalar(moved);
    [[o[0] + k * d[0], o[1] + k * d[1], o[2] + k * d[2]], d]
}

fn coefficients<N: Number, Q: Quadric<N>>(quadric: &Q) -> [(&'static str, N); 6] {
    let a = quadric.a();
    let [outline, growth] = quadric.outline();
    [
        ("a", a),
        ("k", quadric.k()),
        ("c", quadric.c()),
        ("the discriminant", quadric.discriminant(a)),
        ("the outline", outline),
        ("the outline's growth", growth),
    ]
}

/// The error of each coefficient may not exceed its bound.
fn check<Q: Quadric<Running<f32>>, E: Quadric<Wide>>(quadric: &Q, exact: &E, told: impl Fn() -> String) {
    for ((name, found), (_, exact)) in coefficients(quadric).into_iter().zip(coefficients(exact)) {
        if !found.value.is_finite() || !found.error.is_finite() {
            continue;
        }
        let off = (exact - Wide::scalar(found.value)).magnitude();
        // The bound itself may be rounded to a subnormal number, and 128 bits are rounded too.
        let bound = Wide::scalar(Running::<f32>::sure(found.error));
        let bound = bound + exact.magnitude().scaled(-100) + Wide::ONE.scaled(-149);
        assert!(
            !off.compare(bound).is_some_and(core::cmp::Ordering::is_gt),
            "{name}: {found:?}, which is off by {off:?}, {}",
            told()
        );
    }
}

/// The coefficients of the line in values, and of that in double-words.
fn check_all<P: Place<f32>>(place: &P, ray: &Ray<f32>, lengths: [f32; 3]) {
    check_lines(place, ray, lengths, |needs| <Running<f32> as Localize<f32>>::local_ray(place, ray, needs, None));
    check_lines(place, ray, lengths, |needs| rounded_ray::<f32, f32, P>(place, ray, needs, None));
}

fn check_lines<P: Place<f32>>(
    place: &P,
    ray: &Ray<f32>,
    [r, top, height]: [f32; 3],
    line: impl Fn(Needs) -> LocalRay<Running<f32>>,
) {
    let told = || format!("{ray:?} {:?} {:?} {r:e} {top:e} {height:e}", place.position(), core::any::type_name::<P>());
    let near = line(Needs::Translation);
    let [o, d] = exactly(place, ray, Needs::Translation, near.moved.value);
    let ball = Ball { o: near.origin, d: near.direction, r: Running::scalar(r) };
    check(&ball, &Ball { o, d, r: Wide::scalar(r) }, told);

    let near = line(Needs::All);
    let [[x, y, z], [dx, dy, dz]] = exactly(place, ray, Needs::All, near.moved.value);
    let ([nx, ny, nz], [ndx, ndy, ndz]) = (near.origin, near.direction);
    let cylinder = Cylinder { o: [nx, nz], d: [ndx, ndz], r: Running::scalar(r) };
    check(&cylinder, &Cylinder { o: [x, z], d: [dx, dz], r: Wide::scalar(r) }, told);

    // Any numbers of the size of the solid; `a` from -1 to some hundreds.
    let (a, heights) = ((top - r) / height, [0.0, height]);
    let meridian = Meridian { a, b: height - r, r: top, heights, is_open: false, has_waist: false };
    let revolution = Revolution::along(near.origin, near.direction, &meridian, Running::scalar);
    check(&revolution, &Revolution::along([x, y, z], [dx, dy, dz], &meridian, Wide::scalar), told);

    let growth = Running::scalar(top) - Running::scalar(r);
    let Some(m) = growth.rounded_quotient(Running::scalar(height)) else { return };
    let nappe = Nappe { o: [nx, nz, Running::scalar(r) + m * ny], d: [ndx, ndz, m * ndy] };
    let (one, own) = (Running::ONE, Running::scalar(r) + m * ny);
    let (o, d) = ([nx, nz], [ndx, ndz]);
    let tangent = Tangent { o, d, w: (one + m) * (one - m), v: [own, m * ndy], k: -m };
    let m = (Wide::scalar(top) - Wide::scalar(r)).over(Wide::scalar(height));
    check(&nappe, &Nappe { o: [x, z, Wide::scalar(r) + m * y], d: [dx, dz, m * dy] }, told);
    let v = [Wide::scalar(r) + m * y, m * dy];
    check(&tangent, &Tangent { o: [x, z], d: [dx, dz], w: (Wide::ONE + m) * (Wide::ONE - m), v, k: -m }, told);
}

#[test]
fn bounds_hold_for_every_coefficient() {
    let rounds = if std::env::var_os("RAYLET_LONG").is_some() { 10_000_000 } else { 100_000 };
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let mut checked = [0; 3];
    for _ in 0..rounds {
        let size = random.size();
        let distance = size * f32::powi(2.0, (random.next() % 10) as i32);
        let position = random.vector(distance);
        let Some(ray) = random.ray(position, size) else { continue };
        let radii = [size, (random.part() + 1.0) * size, (random.part() + 1.5) * size];
        match random.next() % 3 {
            0 => {
                checked[0] += 1;
                check_all(&InWorld, &ray, radii);
            }
            kind => {
                let degrees = random.part() * 180.0;
                let Ok(frame) = Frame::turned_about(position, random.unit_vector(), degrees) else { continue };
                if kind == 1 {
                    checked[1] += 1;
                    check_all(&frame, &ray, radii);
                    continue;
                }
                let scale = [random.part(), random.part(), random.part()]
                    .map(|part| f32::powi(2.0, (part * 6.0) as i32) * (1.5 + part / 2.0));
                let Ok(affine) = Affine::stretched(frame, scale.into()) else { continue };
                checked[2] += 1;
                check_all(&affine, &ray, radii);
            }
        }
    }
    assert!(checked.iter().all(|count| count * 5 > rounds), "{checked:?}");
}
