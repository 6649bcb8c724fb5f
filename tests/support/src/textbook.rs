//! The formulas that everyone writes first, `k^2 - a c` and what follows from it, in the operators of the number type:
//! what the tiers are compared with.
//!
//! Floats take the square root of the machine. Fixed point has the operators of the crate `fixed`, wrapping where a
//! square overflows, as its plain operators do in a release build. A direction is not taken to be exactly unit. The
//! firmware's cost table counts the instructions of the same formulas (sphere, capped cylinder, capped cone).

use super::exact_types::Exact;
use super::oracle::{ConeExtent, CylinderExtent, Dyadic, Solid};
use super::placed::{Placed, Placement};
use fixed::Wrapping;
use fixed::types::{I16F16, I32F32};
use raylet::scalar::UnitScalar;
use raylet::{Frame, Ray};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number with operators.
pub trait Number:
    Copy
    + PartialOrd
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + 'static
{
    const ZERO: Self;
    const ONE: Self;
    fn root(self) -> Self;
}

/// A scalar, and the number with which the textbook computes.
pub trait Plain: Exact {
    type Number: Number;
    fn plain(self) -> Self::Number;
    /// The value of a component of a direction, rounded.
    fn plain_unit(unit: Self::Unit) -> Self::Number;
    /// The answer, if it is one.
    fn told(number: Self::Number) -> Option<Self>;
}

macro_rules! floats {
    ($($Float:ty)+) => {
        $(
            impl Number for $Float {
                const ZERO: Self = 0.0;
                const ONE: Self = 1.0;
                #[inline(always)]
                fn root(self) -> Self {
                    self.sqrt()
                }
            }

            impl Plain for $Float {
                type Number = Self;
                fn plain(self) -> Self {
                    self
                }
                fn plain_unit(unit: Self) -> Self {
                    unit
                }
                fn told(number: Self) -> Option<Self> {
                    number.is_finite().then_some(number)
                }
            }
        )+
    };
}
floats!(f32 f64);

macro_rules! fixed_point {
    ($($Fixed:ty)+) => {
        $(
            impl Number for Wrapping<$Fixed> {
                const ZERO: Self = Self(<$Fixed>::ZERO);
                const ONE: Self = Self(<$Fixed>::ONE);
                #[inline(always)]
                fn root(self) -> Self {
                    self.sqrt()
                }
            }

            impl Plain for $Fixed {
                type Number = Wrapping<$Fixed>;
                fn plain(self) -> Self::Number {
                    Wrapping(self)
                }
                fn plain_unit(unit: Self::Unit) -> Self::Number {
                    Wrapping(unit.to_num())
                }
                fn told(number: Self::Number) -> Option<Self> {
                    Some(number.0)
                }
            }
        )+
    };
}
fixed_point!(I16F16 I32F32);

/// Origin and direction.
#[derive(Clone, Copy)]
pub struct PlainRay<N> {
    pub origin: [N; 3],
    pub direction: [N; 3],
}

impl<N: Number> PlainRay<N> {
    pub fn of<S: Plain<Number = N>>(ray: &Ray<S>) -> Self {
        Self { origin: ray.origin().to_array().map(S::plain), direction: ray.direction().to_array().map(S::plain_unit) }
    }
}

/// The range of `t` in which hits are told.
#[derive(Clone, Copy)]
pub struct Reach<N> {
    start: N,
    /// `None`: as far as the number type reaches.
    end: Option<N>,
}

impl<N: Number> Reach<N> {
    pub fn of<S: Plain<Number = N>>(ray: &Ray<S>) -> Self {
        let (start, end) = (ray.range().start(), ray.range().end());
        Self { start: start.plain(), end: (end < S::BUDGET.distance).then(|| end.plain()) }
    }

    fn holds(self, t: N) -> bool {
        t >= self.start && self.end.is_none_or(|end| t <= end)
    }
}

/// Where a solid stands: the rows of the way into its frame, and its position.
#[derive(Clone, Copy)]
pub struct Place<N> {
    axes: [[N; 3]; 3],
    /// What each axis was stretched by.
    stretch: Option<[N; 3]>,
    position: [N; 3],
}

impl<N: Number> Place<N> {
    pub fn of<S: Plain<Number = N>>(placed: &Placed<S>) -> Self {
        let position = placed.placement.position().to_array().map(S::plain);
        let turned = |frame: Frame<S>| frame.axes().map(|axis| axis.to_array().map(S::plain_unit));
        let (axes, stretch) = match placed.placement {
            Placement::Frame(frame) => (turned(frame), None),
            Placement::Stretched(frame, factors) => (turned(frame), Some(factors.map(S::plain))),
            Placement::Matrix(affine) => (affine.inverse().map(inverse_row::<S>), None),
        };
        Self { axes, stretch, position }
    }

    #[inline(always)]
    fn local(&self, ray: &PlainRay<N>) -> PlainRay<N> {
        let o = [0, 1, 2].map(|i| ray.origin[i] - self.position[i]);
        let mut local = PlainRay {
            origin: self.axes.map(|axis| dot(axis, o)),
            direction: self.axes.map(|axis| dot(axis, ray.direction)),
        };
        if let Some(stretch) = self.stretch {
            local.origin = divided(local.origin, stretch);
            local.direction = divided(local.direction, stretch);
        }
        local
    }
}

/// A row of an inverse in the number type; what is beyond the type is its largest number.
fn inverse_row<S: Plain>((row, exponent): ([S::Unit; 3], i32)) -> [S::Number; 3] {
    row.map(|component| {
        let value = component.to_f64() * 2.0_f64.powi(exponent);
        let largest = S::BUDGET.distance;
        S::from_f64(value).unwrap_or(if value < 0.0 { -largest } else { largest }).plain()
    })
}

#[inline(always)]
fn divided<N: Number>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[0] / b[0], a[1] / b[1], a[2] / b[2]]
}

#[inline(always)]
fn dot<N: Number>(a: [N; 3], b: [N; 3]) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<N: Number>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Both roots of `a t^2 + 2 k t + c`.
#[inline(always)]
fn roots<N: Number>(a: N, k: N, c: N) -> Option<[N; 2]> {
    let discriminant = k * k - a * c;
    if discriminant < N::ZERO || a == N::ZERO {
        return None;
    }
    let root = discriminant.root();
    Some([(-k - root) / a, (-k + root) / a])
}

/// Both ends of the line in a cuboid, by slabs.
#[inline(always)]
fn slabs<N: Number>(half: [N; 3], ray: &PlainRay<N>) -> Option<[N; 2]> {
    let mut ends: Option<[N; 2]> = None;
    for ((o, d), h) in ray.origin.into_iter().zip(ray.direction).zip(half) {
        if d == N::ZERO {
            if o < -h || o > h {
                return None;
            }
            continue;
        }
        let (a, b) = ((-h - o) / d, (h - o) / d);
        let (near, far) = if a < b { (a, b) } else { (b, a) };
        ends = Some(match ends {
            None => [near, far],
            Some([enter, exit]) => [if near > enter { near } else { enter }, if far < exit { far } else { exit }],
        });
    }
    ends.filter(|[enter, exit]| enter <= exit)
}

/// How far a side reaches along its axis.
#[derive(Clone, Copy)]
pub enum Extent<N> {
    Everywhere,
    Upwards,
    To(N),
}

impl<N: Number> Extent<N> {
    #[inline(always)]
    fn holds(self, y: N) -> bool {
        match self {
            Self::Everywhere => true,
            Self::Upwards => y >= N::ZERO,
            Self::To(height) => y >= N::ZERO && y <= height,
        }
    }
}

/// A cap: the height that it is at, and its radius.
type Cap<N> = (N, N);

/// A primitive, as its formula wants it.
#[derive(Clone, Copy)]
pub enum Form<N> {
    Sphere { radius: N },
    Cylinder { radius: N, extent: Extent<N>, caps: [Option<Cap<N>>; 2] },
    Cone { base: N, slope: N, extent: Extent<N>, caps: [Option<Cap<N>>; 2] },
    Capsule { radius: N, height: N },
    Plane,
    Disc { radius: N },
    Cuboid { half: [N; 3] },
    Rectangle { half: [N; 2] },
    Triangle { vertices: [[N; 3]; 3] },
}

impl<N: Number> Form<N> {
    /// The form of a solid whose sizes are values of the scalar.
    pub fn of<S: Plain<Number = N>>(solid: &Solid) -> Self {
        let n = |value: &Dyadic| S::from_f64(value.to_f64()).expect("sizes of subjects are the scalar's own").plain();
        match solid {
            Solid::Sphere { radius } => Self::Sphere { radius: n(radius) },
            Solid::Cylinder { radius, extent } => {
                let radius = n(radius);
                let (extent, caps) = match extent {
                    CylinderExtent::Infinite => (Extent::Everywhere, [None; 2]),
                    CylinderExtent::Open(height) => (Extent::To(n(height)), [None; 2]),
                    CylinderExtent::Capped(height) => {
                        (Extent::To(n(height)), [Some((N::ZERO, radius)), Some((n(height), radius))])
                    }
                };
                Self::Cylinder { radius, extent, caps }
            }
            Solid::Cone { slope, extent } => {
                let slope = n(slope);
                let (extent, caps) = match extent {
                    ConeExtent::Double => (Extent::Everywhere, [None; 2]),
                    ConeExtent::Nappe => (Extent::Upwards, [None; 2]),
                    ConeExtent::Open(height) => (Extent::To(n(height)), [None; 2]),
                    ConeExtent::Capped(height) => (Extent::To(n(height)), [Some((n(height), slope * n(height))), None]),
                };
                Self::Cone { base: N::ZERO, slope, extent, caps }
            }
            Solid::Frustum { base_radius, top_radius, height, capped } => {
                let (base, top, height) = (n(base_radius), n(top_radius), n(height));
                let caps = [(N::ZERO, base), (height, top)].map(|cap| capped.then_some(cap));
                Self::Cone { base, slope: (top - base) / height, extent: Extent::To(height), caps }
            }
            Solid::Capsule { radius, height } => Self::Capsule { radius: n(radius), height: n(height) },
            Solid::Plane => Self::Plane,
            Solid::Disc { radius } => Self::Disc { radius: n(radius) },
            Solid::Cuboid { half } => Self::Cuboid { half: half.each_ref().map(n) },
            Solid::Rectangle { half } => Self::Rectangle { half: half.each_ref().map(n) },
            Solid::Triangle { vertices } => {
                Self::Triangle { vertices: vertices.each_ref().map(|v| v.each_ref().map(n)) }
            }
        }
    }

    /// Every `t` of the ray's line, in no order.
    #[inline(always)]
    pub fn meet(&self, ray: &PlainRay<N>, report: &mut impl FnMut(N)) {
        match *self {
            Self::Sphere { radius } => ball(radius, N::ZERO, ray, |t, _| report(t)),
            Self::Cylinder { radius, extent, caps } => {
                let ([ox, _, oz], [dx, _, dz]) = (ray.origin, ray.direction);
                let side = roots(dx * dx + dz * dz, ox * dx + oz * dz, ox * ox + oz * oz - radius * radius);
                along(side, extent, ray, report);
                ends(caps, ray, report);
            }
            Self::Cone { base, slope, extent, caps } => {
                let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
                // The side's radius at the ray's origin, and how fast it grows along the ray.
                let (radius, growth) = (base + slope * oy, slope * dy);
                let side = roots(
                    dx * dx + dz * dz - growth * growth,
                    ox * dx + oz * dz - radius * growth,
                    ox * ox + oz * oz - radius * radius,
                );
                along(side, extent, ray, report);
                ends(caps, ray, report);
            }
            Self::Capsule { radius, height } => {
                let ([ox, _, oz], [dx, _, dz]) = (ray.origin, ray.direction);
                let side = roots(dx * dx + dz * dz, ox * dx + oz * dz, ox * ox + oz * oz - radius * radius);
                along(side, Extent::To(height), ray, report);
                for (centre, is_base) in [(N::ZERO, true), (height, false)] {
                    ball(radius, centre, ray, |t, y| {
                        if if is_base { y < N::ZERO } else { y > height } {
                            report(t);
                        }
                    });
                }
            }
            Self::Plane => {
                if ray.direction[1] != N::ZERO {
                    report(-ray.origin[1] / ray.direction[1]);
                }
            }
            Self::Disc { radius } => ends([Some((N::ZERO, radius)), None], ray, report),
            Self::Cuboid { half } => {
                if let Some(ends) = slabs(half, ray) {
                    ends.into_iter().for_each(&mut *report);
                }
            }
            Self::Rectangle { half: [x, z] } => {
                let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
                if dy != N::ZERO {
                    let t = -oy / dy;
                    let (px, pz) = (ox + t * dx, oz + t * dz);
                    if -x <= px && px <= x && -z <= pz && pz <= z {
                        report(t);
                    }
                }
            }
            Self::Triangle { vertices } => triangle(vertices, ray, report),
        }
    }

    /// The smallest `t` that is not negative.
    #[inline(always)]
    pub fn nearest(&self, place: Option<&Place<N>>, ray: &PlainRay<N>) -> Option<N> {
        let mut best = None;
        let mut report = |t: N| {
            if t >= N::ZERO && best.is_none_or(|best| t < best) {
                best = Some(t);
            }
        };
        match place {
            None => self.meet(ray, &mut report),
            Some(place) => self.meet(&place.local(ray), &mut report),
        }
        best
    }

    /// All `t` in the range, sorted.
    pub fn hits(&self, place: Option<&Place<N>>, ray: &PlainRay<N>, reach: Reach<N>) -> Vec<N> {
        let mut all = vec![];
        let local = place.map_or(*ray, |place| place.local(ray));
        self.meet(&local, &mut |t: N| {
            if reach.holds(t) {
                all.push(t);
            }
        });
        all.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        all
    }
}

/// A ball around a point of the axis; reports `t` and the height there.
#[inline(always)]
fn ball<N: Number>(radius: N, centre: N, ray: &PlainRay<N>, mut report: impl FnMut(N, N)) {
    let d = ray.direction;
    let o = [ray.origin[0], ray.origin[1] - centre, ray.origin[2]];
    for t in roots(dot(d, d), dot(o, d), dot(o, o) - radius * radius).into_iter().flatten() {
        report(t, ray.origin[1] + t * d[1]);
    }
}

/// Those roots whose height the side has.
#[inline(always)]
fn along<N: Number>(side: Option<[N; 2]>, extent: Extent<N>, ray: &PlainRay<N>, report: &mut impl FnMut(N)) {
    for t in side.into_iter().flatten() {
        if extent.holds(ray.origin[1] + t * ray.direction[1]) {
            report(t);
        }
    }
}

#[inline(always)]
fn ends<N: Number>(caps: [Option<Cap<N>>; 2], ray: &PlainRay<N>, report: &mut impl FnMut(N)) {
    let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
    if dy == N::ZERO {
        return;
    }
    for (height, radius) in caps.into_iter().flatten() {
        let t = (height - oy) / dy;
        let (x, z) = (ox + t * dx, oz + t * dz);
        if x * x + z * z <= radius * radius {
            report(t);
        }
    }
}

/// Möller and Trumbore, *Fast, Minimum Storage Ray/Triangle Intersection*, 1997.
#[inline(always)]
fn triangle<N: Number>([a, b, c]: [[N; 3]; 3], ray: &PlainRay<N>, report: &mut impl FnMut(N)) {
    let from = |p: [N; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (first, second, o) = (from(b), from(c), from(ray.origin));
    let p = cross(ray.direction, second);
    let determinant = dot(first, p);
    if determinant == N::ZERO {
        return;
    }
    let q = cross(o, first);
    let (u, v) = (dot(o, p) / determinant, dot(ray.direction, q) / determinant);
    if u >= N::ZERO && v >= N::ZERO && u + v <= N::ONE {
        report(dot(second, q) / determinant);
    }
}
