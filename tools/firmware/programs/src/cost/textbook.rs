//! The formulas that everyone writes first: `k^2 - a c` and what follows from it, in the operators of the number type.
//!
//! They are here for their cost. In fixed point they wrap where a square overflows (`fixed::Wrapping`; the plain
//! operators of a release build do the same), and their errors are what raylet was written to avoid: see
//! `docs/accuracy.md`.

use super::Of;
use super::measure::instructions;
use core::hint::black_box;
use core::ops::{Add, Div, Mul, Neg, Sub};
use fixed::Wrapping;
use fixed::types::{I16F16, I32F32};
use raylet::{Cone, Cylinder, Frame, Ray, Scalar, Shape, Sphere};
use shared::rays::{RAYS, rays};
use shared::subject::{Subject, eighths, frame, framed};

/// A number with operators.
pub trait Number:
    Copy
    + PartialOrd
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// Zero.
    const ZERO: Self;
    /// The square root.
    fn root(self) -> Self;
}

/// A scalar, and the number with which the textbook computes.
pub trait Plain: Scalar {
    /// That number.
    type Number: Number;
    /// The same value.
    fn plain(self) -> Self::Number;
    /// The same value of a component of a direction, rounded.
    fn plain_unit(unit: Self::Unit) -> Self::Number;
}

macro_rules! floats {
    ($($Float:ty, $sqrt:path;)+) => {
        $(
            impl Number for $Float {
                const ZERO: Self = 0.0;
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
            }
        )+
    };
}
floats!(f32, libm::sqrtf; f64, libm::sqrt;);

macro_rules! fixed {
    ($($Fixed:ty)+) => {
        $(
            impl Number for Wrapping<$Fixed> {
                const ZERO: Self = Self(<$Fixed>::ZERO);
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
            }
        )+
    };
}
fixed!(I16F16 I32F32);

/// Origin and direction.
struct PlainRay<N> {
    origin: [N; 3],
    direction: [N; 3],
}

impl<N> PlainRay<N> {
    fn of<S: Plain<Number = N>>(ray: &Ray<S>) -> Self {
        let (origin, direction) = (ray.origin().to_array(), ray.direction().to_array());
        Self { origin: origin.map(S::plain), direction: direction.map(S::plain_unit) }
    }
}

/// Radius and height, or slope and height.
type Sizes<N> = [N; 2];

/// A solid that is turned and moved: its sizes, where it stands, and its axes.
struct Placed<N> {
    sizes: Sizes<N>,
    position: [N; 3],
    axes: [[N; 3]; 3],
}

impl<N: Number> Placed<N> {
    fn new<S: Plain<Number = N>>(sizes: Sizes<S>, frame: &Frame<S>) -> Self {
        Self {
            sizes: sizes.map(S::plain),
            position: frame.position().to_array().map(S::plain),
            axes: frame.axes().map(|axis| axis.to_array().map(S::plain_unit)),
        }
    }

    /// The ray as the solid sees it.
    #[inline(always)]
    fn to_local(&self, ray: &PlainRay<N>) -> PlainRay<N> {
        let ([x, y, z], [px, py, pz]) = (ray.origin, self.position);
        let from = [x - px, y - py, z - pz];
        PlainRay {
            origin: self.axes.map(|axis| dot(axis, from)),
            direction: self.axes.map(|axis| dot(axis, ray.direction)),
        }
    }
}

fn dot<N: Number>(a: [N; 3], b: [N; 3]) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The smaller of two `t` that are not negative.
fn sooner<N: Number>(best: Option<N>, t: N) -> Option<N> {
    if t < N::ZERO || best.is_some_and(|best| best <= t) { best } else { Some(t) }
}

/// Both roots of `a t^2 + 2 k t + c`.
#[inline(always)]
fn roots<N: Number>(a: N, k: N, c: N, root: impl Fn(N) -> N) -> Option<[N; 2]> {
    let discriminant = k * k - a * c;
    if discriminant < N::ZERO || a == N::ZERO {
        return None;
    }
    let root = root(discriminant);
    Some([(-k - root) / a, (-k + root) / a])
}

/// The sphere about the origin. A direction is not taken to be exactly unit.
#[inline(always)]
fn sphere<N: Number>(radius: N, ray: &PlainRay<N>, root: impl Fn(N) -> N) -> Option<N> {
    let (o, d) = (ray.origin, ray.direction);
    let [near, far] = roots(dot(d, d), dot(o, d), dot(o, o) - radius * radius, root)?;
    if near >= N::ZERO { Some(near) } else { sooner(None, far) }
}

/// The capped cylinder about the y axis: side and caps by themselves.
#[inline(always)]
fn cylinder<N: Number>([radius, height]: Sizes<N>, ray: &PlainRay<N>) -> Option<N> {
    let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
    let mut best = None;
    let side = roots(dx * dx + dz * dz, ox * dx + oz * dz, ox * ox + oz * oz - radius * radius, N::root);
    for t in side.into_iter().flatten() {
        let y = oy + t * dy;
        if y >= N::ZERO && y <= height {
            best = sooner(best, t);
        }
    }
    if dy != N::ZERO {
        for cap in [N::ZERO, height] {
            let t = (cap - oy) / dy;
            let (x, z) = (ox + t * dx, oz + t * dz);
            if x * x + z * z <= radius * radius {
                best = sooner(best, t);
            }
        }
    }
    best
}

/// The capped cone about the y axis, its apex in the origin.
#[inline(always)]
fn cone<N: Number>([slope, height]: Sizes<N>, ray: &PlainRay<N>, root: impl Fn(N) -> N) -> Option<N> {
    let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
    let mut best = None;
    let m = slope * slope;
    let side =
        roots(dx * dx + dz * dz - m * dy * dy, ox * dx + oz * dz - m * oy * dy, ox * ox + oz * oz - m * oy * oy, root);
    for t in side.into_iter().flatten() {
        let y = oy + t * dy;
        if y >= N::ZERO && y <= height {
            best = sooner(best, t);
        }
    }
    if dy != N::ZERO {
        let t = (height - oy) / dy;
        let (x, z) = (ox + t * dx, oz + t * dz);
        if x * x + z * z <= m * height * height {
            best = sooner(best, t);
        }
    }
    best
}

#[inline(never)]
fn nearest_of_sphere<N: Number>([radius, _]: &Sizes<N>, ray: &PlainRay<N>) {
    black_box(sphere(*radius, ray, N::root));
}

#[inline(never)]
fn nearest_of_cylinder<N: Number>(sizes: &Sizes<N>, ray: &PlainRay<N>) {
    black_box(cylinder(*sizes, ray));
}

#[inline(never)]
fn nearest_of_cone<N: Number>(sizes: &Sizes<N>, ray: &PlainRay<N>) {
    black_box(cone(*sizes, ray, N::root));
}

#[inline(never)]
fn nearest_of_placed_sphere<N: Number>(placed: &Placed<N>, ray: &PlainRay<N>) {
    black_box(sphere(placed.sizes[0], &placed.to_local(ray), N::root));
}

#[inline(never)]
fn nearest_of_placed_cone<N: Number>(placed: &Placed<N>, ray: &PlainRay<N>) {
    black_box(cone(placed.sizes, &placed.to_local(ray), N::root));
}

/// With the square root that raylet itself uses: an instruction, where the chip has one.
#[inline(never)]
fn nearest_of_sphere_with_the_chips_root([radius, _]: &Sizes<f32>, ray: &PlainRay<f32>) {
    black_box(sphere(*radius, ray, raylet::scalar::Real::sqrt));
}

#[inline(never)]
fn nearest_of_placed_sphere_with_the_chips_root(placed: &Placed<f32>, ray: &PlainRay<f32>) {
    black_box(sphere(placed.sizes[0], &placed.to_local(ray), raylet::scalar::Real::sqrt));
}

#[inline(never)]
fn nearest_of_placed_cone_with_the_chips_root(placed: &Placed<f32>, ray: &PlainRay<f32>) {
    black_box(cone(placed.sizes, &placed.to_local(ray), raylet::scalar::Real::sqrt));
}

/// Measures a formula at the rays that hit `subject`, and at those that miss it.
fn measure<S: Plain, P: Subject<S>, Solid>(
    subject: Option<P>,
    solid: Option<Solid>,
    formula: fn(&Solid, &PlainRay<S::Number>),
    report: &mut dyn FnMut(Of, u64),
) {
    let (Some(subject), Some(solid)) = (subject, solid) else { return };
    for (hits, of) in [(true, Of::Hit), (false, Of::Miss)] {
        let rays: [PlainRay<S::Number>; RAYS] = rays(&subject, hits).map(|ray| PlainRay::of(&ray));
        report(of, instructions(&solid, &rays, formula));
    }
}

/// Hands the name of each formula, which rays they are, and its instructions to `report`. The subjects are those of the
/// same names in `subject`.
pub fn every_formula<S: Plain>(report: &mut dyn FnMut(&'static str, Of, u64)) {
    let (radius, slope, height) = (eighths::<S>(8), eighths::<S>(6), eighths::<S>(12));
    let [ball, tube, cone] = [[radius, S::ZERO], [radius, height], [slope, height]];
    let plain = |sizes: Sizes<S>| Some(sizes.map(S::plain));
    measure(Sphere::new(radius).ok(), plain(ball), nearest_of_sphere, &mut |of, n| report("sphere", of, n));
    measure(Cylinder::capped(radius, height).ok(), plain(tube), nearest_of_cylinder, &mut |of, n| {
        report("cylinder, capped", of, n);
    });
    measure(Cone::capped(slope, height).ok(), plain(cone), nearest_of_cone, &mut |of, n| {
        report("cone, capped", of, n);
    });
    measure::<S, _, _>(framed_sphere(), placed(ball), nearest_of_placed_sphere, &mut |of, n| {
        report("sphere, framed", of, n)
    });
    measure::<S, _, _>(framed_cone(), placed(cone), nearest_of_placed_cone, &mut |of, n| {
        report("cone, capped, framed", of, n)
    });
}

/// The solid of these sizes in the frame of the subjects that are framed.
fn placed<S: Plain>(sizes: Sizes<S>) -> Option<Placed<S::Number>> {
    Some(Placed::new(sizes, &frame()?))
}

fn framed_sphere<S: Scalar>() -> Option<Shape<S>> {
    framed(Shape::new(Sphere::new(eighths(8)).ok()?))
}

fn framed_cone<S: Scalar>() -> Option<Shape<S>> {
    framed(Shape::new(Cone::capped(eighths(6), eighths(12)).ok()?))
}

/// As [`every_formula`], for the one chip whose square root is an instruction that `libm` does not use.
pub fn with_the_chips_root(report: &mut dyn FnMut(&'static str, Of, u64)) {
    if cfg!(all(target_arch = "arm", target_abi = "eabihf")) {
        let [ball, cone] = [[1.0_f32, 0.0], [0.75, 1.5]];
        measure(Sphere::new(1.0_f32).ok(), Some(ball), nearest_of_sphere_with_the_chips_root, &mut |of, n| {
            report("sphere", of, n);
        });
        measure::<f32, _, _>(
            framed_sphere(),
            placed(ball),
            nearest_of_placed_sphere_with_the_chips_root,
            &mut |of, n| {
                report("sphere, framed", of, n);
            },
        );
        measure::<f32, _, _>(framed_cone(), placed(cone), nearest_of_placed_cone_with_the_chips_root, &mut |of, n| {
            report("cone, capped, framed", of, n);
        });
    }
}
