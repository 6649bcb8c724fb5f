//! The formulas that everyone writes first, `k^2 - a c` and what follows from it, in the operators of the number type:
//! what the tiers are compared with, in errors, time and instructions, on the host and on the chips.
//!
//! Floats take the square root of `libm`. Fixed point has the operators of the crate `fixed`, wrapping where a square
//! overflows, as its plain operators do in a release build. A direction is not taken to be exactly unit.

mod form;

pub use form::Form;

use crate::subject::{eighths, frame, framed};
use core::ops::{Add, Div, Mul, Neg, Sub};
use fixed::Wrapping;
use fixed::types::{I8F24, I16F16, I20F12, I32F32};
use raylet::{Cone, Cylinder, Frame, Ray, Scalar, Shape};

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
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// The square root.
    fn root(self) -> Self;
}

/// A scalar, and the number with which the textbook computes.
pub trait Plain: Scalar {
    /// That number.
    type Number: Number;
    /// The same value.
    fn plain(self) -> Self::Number;
    /// The value of a component of a direction, rounded.
    fn plain_unit(unit: Self::Unit) -> Self::Number;
    /// The answer, if it is one.
    fn told(number: Self::Number) -> Option<Self>;
}

macro_rules! floats {
    ($($Float:ty, $sqrt:path;)+) => {
        $(
            impl Number for $Float {
                const ZERO: Self = 0.0;
                const ONE: Self = 1.0;
                #[inline(always)]
                fn root(self) -> Self {
                    $sqrt(self)
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
floats!(f32, libm::sqrtf; f64, libm::sqrt;);

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
fixed_point!(I8F24 I16F16 I20F12 I32F32);

/// Origin and direction.
#[derive(Clone, Copy)]
pub struct PlainRay<N> {
    /// Where it starts.
    pub origin: [N; 3],
    /// Where it goes.
    pub direction: [N; 3],
}

impl<N: Number> PlainRay<N> {
    /// The ray in the textbook's numbers.
    pub fn of<S: Plain<Number = N>>(ray: &Ray<S>) -> Self {
        Self { origin: ray.origin().to_array().map(S::plain), direction: ray.direction().to_array().map(S::plain_unit) }
    }
}

/// Where a solid stands: the rows of the way into its frame, and its position.
#[derive(Clone, Copy)]
pub struct Place<N> {
    /// The rows.
    pub axes: [[N; 3]; 3],
    /// What each axis was stretched by.
    pub stretch: Option<[N; 3]>,
    /// The position.
    pub position: [N; 3],
}

impl<N: Number> Place<N> {
    /// A frame.
    pub fn of<S: Plain<Number = N>>(frame: &Frame<S>) -> Self {
        let axes = frame.axes().map(|axis| axis.to_array().map(S::plain_unit));
        Self { axes, stretch: None, position: frame.position().to_array().map(S::plain) }
    }

    /// The ray as the solid sees it.
    #[inline(always)]
    pub fn local(&self, ray: &PlainRay<N>) -> PlainRay<N> {
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

/// Both roots of `a t^2 + 2 k t + c`, by this square root.
#[inline(always)]
fn roots<N: Number>(a: N, k: N, c: N, root: impl Fn(N) -> N) -> Option<[N; 2]> {
    let discriminant = k * k - a * c;
    if discriminant < N::ZERO || a == N::ZERO {
        return None;
    }
    let root = root(discriminant);
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
    /// Without end.
    Everywhere,
    /// From the height 0 up.
    Upwards,
    /// From there to this height.
    To(N),
    /// From one height to another.
    Between([N; 2]),
}

impl<N: Number> Extent<N> {
    #[inline(always)]
    fn holds(self, y: N) -> bool {
        match self {
            Self::Everywhere => true,
            Self::Upwards => y >= N::ZERO,
            Self::To(height) => y >= N::ZERO && y <= height,
            Self::Between([low, high]) => y >= low && y <= high,
        }
    }
}

/// A cap: the height that it is at, and its radius.
pub type Cap<N> = (N, N);

/// A solid, as its formula wants it.
pub trait Formula<N: Number>: Copy {
    /// Every `t` of the ray's line, in no order, by this square root.
    fn meet(&self, ray: &PlainRay<N>, root: impl Fn(N) -> N + Copy, report: &mut impl FnMut(N));

    /// The smallest `t` that is not negative.
    #[inline(always)]
    fn nearest(&self, place: Option<&Place<N>>, ray: &PlainRay<N>) -> Option<N> {
        match place {
            None => self.nearest_by(ray, N::root),
            Some(place) => self.nearest_by(&place.local(ray), N::root),
        }
    }

    /// The same of a solid that is not placed, by this square root.
    #[inline(always)]
    fn nearest_by(&self, ray: &PlainRay<N>, root: impl Fn(N) -> N + Copy) -> Option<N> {
        let mut best = None;
        self.meet(ray, root, &mut |t: N| {
            if t >= N::ZERO && best.is_none_or(|best| t < best) {
                best = Some(t);
            }
        });
        best
    }
}

/// A sphere about the origin, of this radius.
#[derive(Clone, Copy)]
pub struct Sphere<N>(pub N);

impl<N: Number> Formula<N> for Sphere<N> {
    #[inline(always)]
    fn meet(&self, ray: &PlainRay<N>, root: impl Fn(N) -> N + Copy, report: &mut impl FnMut(N)) {
        ball(self.0, N::ZERO, ray, root, |t, _| report(t));
    }

    /// The second root is computed only if the first one lies behind.
    #[inline(always)]
    fn nearest_by(&self, ray: &PlainRay<N>, root: impl Fn(N) -> N + Copy) -> Option<N> {
        ball_roots(self.0, N::ZERO, ray, root)?.into_iter().find(|t| *t >= N::ZERO)
    }
}

/// A cylinder or a cone about the y axis: the side's radius at the height 0 and how fast it grows, and the caps.
#[derive(Clone, Copy)]
pub struct Side<N> {
    /// The radius at the height 0.
    pub base: N,
    /// How much the radius grows with the height; `None` for a cylinder.
    pub slope: Option<N>,
    /// How far it reaches.
    pub extent: Extent<N>,
    /// Its caps.
    pub caps: [Option<Cap<N>>; 2],
}

impl<N: Number> Side<N> {
    /// A capped cylinder.
    pub fn cylinder(radius: N, height: N) -> Self {
        let caps = [Some((N::ZERO, radius)), Some((height, radius))];
        Self { base: radius, slope: None, extent: Extent::To(height), caps }
    }

    /// A capped cone with its apex in the origin.
    pub fn cone(slope: N, height: N) -> Self {
        let caps = [Some((height, slope * height)), None];
        Self { base: N::ZERO, slope: Some(slope), extent: Extent::To(height), caps }
    }
}

impl<N: Number> Formula<N> for Side<N> {
    #[inline(always)]
    fn meet(&self, ray: &PlainRay<N>, root: impl Fn(N) -> N + Copy, report: &mut impl FnMut(N)) {
        let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
        let (a, k, c) = (dx * dx + dz * dz, ox * dx + oz * dz, ox * ox + oz * oz);
        let side = match self.slope {
            None => roots(a, k, c - self.base * self.base, root),
            Some(slope) => {
                // The side's radius at the ray's origin, and how fast it grows along the ray.
                let (radius, growth) = (self.base + slope * oy, slope * dy);
                roots(a - growth * growth, k - radius * growth, c - radius * radius, root)
            }
        };
        along(side, self.extent, ray, report);
        ends(self.caps, ray, report);
    }
}

/// A quadric of revolution between two heights: `x^2 + z^2 = a y^2 + 2 b y + r^2`.
#[derive(Clone, Copy)]
pub struct Quadric<N> {
    /// `a`, `b` and `r`.
    pub coefficients: [N; 3],
    /// The heights of its ends.
    pub heights: [N; 2],
    /// True if it has caps.
    pub capped: bool,
}

impl<N: Number> Formula<N> for Quadric<N> {
    #[inline(always)]
    fn meet(&self, ray: &PlainRay<N>, root: impl Fn(N) -> N + Copy, report: &mut impl FnMut(N)) {
        let ([ox, oy, oz], [dx, dy, dz], [a, b, r]) = (ray.origin, ray.direction, self.coefficients);
        let square = |y: N| (a * y + b + b) * y + r * r;
        let growth = a * oy + b;
        let (a, k) = (dx * dx + dz * dz - a * dy * dy, ox * dx + oz * dz - growth * dy);
        let side = roots(a, k, ox * ox + oz * oz - square(oy), root);
        along(side, Extent::Between(self.heights), ray, report);
        if self.capped && dy != N::ZERO {
            for height in self.heights {
                let t = (height - oy) / dy;
                let (x, z) = (ox + t * dx, oz + t * dz);
                if x * x + z * z <= square(height) {
                    report(t);
                }
            }
        }
    }
}

/// A solid where it stands.
#[derive(Clone, Copy)]
pub struct Placed<F, N>(pub F, pub Place<N>);

impl<N: Number, F: Formula<N>> Formula<N> for Placed<F, N> {
    #[inline(always)]
    fn meet(&self, ray: &PlainRay<N>, root: impl Fn(N) -> N + Copy, report: &mut impl FnMut(N)) {
        self.0.meet(&self.1.local(ray), root, report);
    }
    #[inline(always)]
    fn nearest_by(&self, ray: &PlainRay<N>, root: impl Fn(N) -> N + Copy) -> Option<N> {
        self.0.nearest_by(&self.1.local(ray), root)
    }
}

/// What is done with each subject that has a formula.
pub trait Visit<S: Plain> {
    /// A subject by its name, as the library has it and as its formula.
    fn visit<F: Formula<S::Number> + Send + Sync + 'static>(
        &mut self,
        name: &'static str,
        shape: &Shape<S>,
        formula: F,
    );
}

/// Visits the subjects whose formulas are counted, each of a type of its own; the names are those of `subject`.
pub fn every_formula<S: Plain<Number: Send + Sync>>(visit: &mut impl Visit<S>) {
    let (radius, slope, height) = (eighths::<S>(8), eighths::<S>(6), eighths::<S>(12));
    let ball = Sphere(radius.plain());
    let tube = Side::cylinder(radius.plain(), height.plain());
    let cone = Side::cone(slope.plain(), height.plain());
    let place = frame().map(|frame| Place::of::<S>(&frame));
    if let Ok(shape) = raylet::Sphere::new(radius).map(Shape::new) {
        visit.visit("sphere", &shape, ball);
        if let (Some(shape), Some(place)) = (framed(shape), place) {
            visit.visit("sphere, framed", &shape, Placed(ball, place));
        }
    }
    if let Ok(shape) = Cylinder::capped(radius, height).map(Shape::new) {
        visit.visit("cylinder, capped", &shape, tube);
    }
    if let Ok(shape) = Cone::capped(slope, height).map(Shape::new) {
        visit.visit("cone, capped", &shape, cone);
        if let (Some(shape), Some(place)) = (framed(shape), place) {
            visit.visit("cone, capped, framed", &shape, Placed(cone, place));
        }
    }
}

/// A ball around a point of the axis; reports `t` and the height there.
#[inline(always)]
fn ball<N: Number>(radius: N, centre: N, ray: &PlainRay<N>, root: impl Fn(N) -> N, mut report: impl FnMut(N, N)) {
    for t in ball_roots(radius, centre, ray, root).into_iter().flatten() {
        report(t, ray.origin[1] + t * ray.direction[1]);
    }
}

/// Both roots of that ball's equation.
#[inline(always)]
fn ball_roots<N: Number>(radius: N, centre: N, ray: &PlainRay<N>, root: impl Fn(N) -> N) -> Option<[N; 2]> {
    let ([x, y, z], d) = (ray.origin, ray.direction);
    let o = [x, y - centre, z];
    roots(dot(d, d), dot(o, d), dot(o, o) - radius * radius, root)
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
