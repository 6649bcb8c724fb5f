//! The formulas that every tutorial has: `k^2 - a c` for what is round, Moeller and Trumbore's for the triangle.

use crate::contestant::{Contestant, Entrant, Number};
use crate::names::TEXTBOOK;
use crate::sizes::Sizes;
use raylet::Ray;
use support::oracle::Solid;

/// Origin and direction.
pub struct PlainRay<S> {
    origin: [S; 3],
    direction: [S; 3],
}

fn dot<S: Number>(a: [S; 3], b: [S; 3]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross<S: Number>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn difference<S: Number>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The smaller of two `t` that are not negative.
fn sooner<S: Number>(best: Option<S>, t: S) -> Option<S> {
    if t < S::ZERO || best.is_some_and(|best| best <= t) { best } else { Some(t) }
}

/// Both roots of `a t^2 + 2 k t + c`.
#[inline]
fn roots<S: Number>(a: S, k: S, c: S) -> Option<[S; 2]> {
    let discriminant = k * k - a * c;
    if discriminant < S::ZERO || a == S::ZERO {
        return None;
    }
    let root = discriminant.square_root();
    Some([(-k - root) / a, (-k + root) / a])
}

/// Where a ray meets the whole sphere about `(0, height, 0)`.
#[inline]
fn sphere_roots<S: Number>(ray: &PlainRay<S>, radius: S, height: S) -> Option<[S; 2]> {
    let ([ox, oy, oz], d) = (ray.origin, ray.direction);
    let o = [ox, oy - height, oz];
    roots(dot(d, d), dot(o, d), dot(o, o) - radius * radius)
}

/// Where a ray meets the plane of this height.
#[inline]
fn plane<S: Number>(ray: &PlainRay<S>, height: S) -> Option<S> {
    let (y, climb) = (ray.origin[1], ray.direction[1]);
    (climb != S::ZERO).then(|| (height - y) / climb)
}

/// Where a ray meets the disc about the axis at this height.
#[inline]
fn disc<S: Number>(ray: &PlainRay<S>, radius_squared: S, height: S) -> Option<S> {
    let t = plane(ray, height)?;
    let (x, z) = (ray.origin[0] + t * ray.direction[0], ray.origin[2] + t * ray.direction[2]);
    (x * x + z * z <= radius_squared).then_some(t)
}

/// A contestant for each primitive: its sizes, and its formula.
macro_rules! formulas {
    ($($(#[$about:meta])* $Primitive:ident { $($size:ident: $Size:ty),* }, |$ray:ident| $formula:expr;)+) => {
        $(
            $(#[$about])*
            struct $Primitive<S> {
                $($size: $Size,)*
                _number: std::marker::PhantomData<S>,
            }

            impl<S: Number> Contestant<S> for $Primitive<S> {
                type Ray = PlainRay<S>;
                type Answer = Option<S>;
                fn ray(ray: &Ray<S>) -> PlainRay<S> {
                    PlainRay { origin: ray.origin().to_array(), direction: ray.direction().to_array() }
                }
                #[inline]
                fn nearest(&self, $ray: &PlainRay<S>) -> Option<S> {
                    $(let $size = self.$size;)*
                    $formula
                }
                fn distance(answer: &Option<S>) -> Option<S> {
                    *answer
                }
            }
        )+
    };
}

formulas! {
    Sphere { radius: S }, |ray| {
        let [near, far] = sphere_roots(ray, radius, S::ZERO)?;
        if near >= S::ZERO { Some(near) } else { sooner(None, far) }
    };

    /// Side and caps by themselves.
    Cylinder { radius: S, height: S }, |ray| {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
        let square = radius * radius;
        let mut best = None;
        for t in roots(dx * dx + dz * dz, ox * dx + oz * dz, ox * ox + oz * oz - square).into_iter().flatten() {
            let y = oy + t * dy;
            if y >= S::ZERO && y <= height {
                best = sooner(best, t);
            }
        }
        for cap in [S::ZERO, height] {
            if let Some(t) = disc(ray, square, cap) {
                best = sooner(best, t);
            }
        }
        best
    };

    /// Side and cap by themselves.
    Cone { slope: S, height: S }, |ray| {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
        let square = slope * slope;
        let mut best = None;
        let (a, k, c) = (
            dx * dx + dz * dz - square * dy * dy,
            ox * dx + oz * dz - square * oy * dy,
            ox * ox + oz * oz - square * oy * oy,
        );
        for t in roots(a, k, c).into_iter().flatten() {
            let y = oy + t * dy;
            if y >= S::ZERO && y <= height {
                best = sooner(best, t);
            }
        }
        if let Some(t) = disc(ray, square * height * height, height) {
            best = sooner(best, t);
        }
        best
    };

    /// The side and two spheres, each where it is the surface.
    Capsule { radius: S, height: S }, |ray| {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
        let mut best = None;
        let c = ox * ox + oz * oz - radius * radius;
        for t in roots(dx * dx + dz * dz, ox * dx + oz * dz, c).into_iter().flatten() {
            let y = oy + t * dy;
            if y >= S::ZERO && y <= height {
                best = sooner(best, t);
            }
        }
        for t in sphere_roots(ray, radius, S::ZERO).into_iter().flatten() {
            if oy + t * dy <= S::ZERO {
                best = sooner(best, t);
            }
        }
        for t in sphere_roots(ray, radius, height).into_iter().flatten() {
            if oy + t * dy >= height {
                best = sooner(best, t);
            }
        }
        best
    };

    Plane {}, |ray| plane(ray, S::ZERO).filter(|t| *t >= S::ZERO);

    Disc { radius: S }, |ray| disc(ray, radius * radius, S::ZERO).filter(|t| *t >= S::ZERO);

    /// Moeller and Trumbore, *Fast, minimum storage ray/triangle intersection*, 1997; seen from both sides.
    Triangle { vertices: [[S; 3]; 3] }, |ray| {
        let [a, b, c] = vertices;
        let (e1, e2) = (difference(b, a), difference(c, a));
        let p = cross(ray.direction, e2);
        let determinant = dot(e1, p);
        if determinant == S::ZERO {
            return None;
        }
        let inverse = S::ONE / determinant;
        let from_a = difference(ray.origin, a);
        let u = dot(from_a, p) * inverse;
        if u < S::ZERO || u > S::ONE {
            return None;
        }
        let q = cross(from_a, e1);
        let v = dot(ray.direction, q) * inverse;
        if v < S::ZERO || u + v > S::ONE {
            return None;
        }
        let t = dot(e2, q) * inverse;
        (t >= S::ZERO).then_some(t)
    };
}

/// The textbook, for this primitive.
pub fn entrant<S: Number>(sizes: Sizes<S>, solid: &Solid) -> Entrant<S> {
    let _number = std::marker::PhantomData;
    match sizes {
        Sizes::Sphere { radius } => Entrant::new(TEXTBOOK, solid, Sphere { radius, _number }),
        Sizes::Cylinder { radius, height } => Entrant::new(TEXTBOOK, solid, Cylinder { radius, height, _number }),
        Sizes::Cone { slope, height } => Entrant::new(TEXTBOOK, solid, Cone { slope, height, _number }),
        Sizes::Capsule { radius, height } => Entrant::new(TEXTBOOK, solid, Capsule { radius, height, _number }),
        Sizes::Plane => Entrant::new(TEXTBOOK, solid, Plane { _number }),
        Sizes::Disc { radius } => Entrant::new(TEXTBOOK, solid, Disc { radius, _number }),
        Sizes::Triangle { vertices } => Entrant::new(TEXTBOOK, solid, Triangle { vertices, _number }),
    }
}
