//! The axis-aligned box of a primitive as it is placed.
//!
//! A placement is stored as a position `o` and rows `R` that take the world to the primitive: `local = R (p - o)`. The
//! primitive's points are at `p = o + M v` with `M = adj(R) / det(R)`, the exact inverse: a frame's rows are
//! perpendicular and unit only to their last bits (a direction from
//! [`UnitVec3::from_components`](crate::UnitVec3::from_components) to 2^-20), so that the transpose would not do. With
//! `m` a row of `M`, the primitive reaches along that axis of the world up to
//!
//! | part | reach |
//! |---|---|
//! | a ball of radius `r` about `(0, y, 0)` | `o + m_y y + r sqrt(m_x^2 + m_y^2 + m_z^2)` |
//! | a disc of radius `r` in the plane of height `y` | `o + m_y y + r sqrt(m_x^2 + m_z^2)` |
//! | a vertex, a corner of a prism or of the box of a polyhedron | `o + m_x x + m_y y + m_z z` |
//! | a cuboid of half extents `h` | `o + abs(m_x) h_x + abs(m_y) h_y + abs(m_z) h_z` |
//! | a torus of the radii `R` and `r` | `o + R sqrt(m_x^2 + m_z^2) + r sqrt(m_x^2 + m_y^2 + m_z^2)` |
//! | a rounded cuboid | as its core, and `r sqrt(m_x^2 + m_y^2 + m_z^2)` more |
//!
//! and down to the negative of the same expression with the signs of `o` and `m` reversed. The convex hull of several
//! parts reaches as far as the farthest of them.
//!
//! Intermediate results have twice the precision and an error bound ([`Near`]). Only the last step goes to the number
//! type, upwards. A box is thus as small as the type allows but for some 2^-36 (`f32`) of the terms that it is a sum
//! of, which shows where they cancel. (A placement pressed nearly flat loses as many bits again as its axes' directions
//! lose volume.)

use crate::affine::Affine;
use crate::equations::{Described, EquationKinds};
use crate::frame::Frame;
use crate::geometry::{Bounds, Hull};
use crate::scalar::{Real, Ring, Scalar, Unit, largest};
use crate::vector::{UnitVec3, Vec3, pairs, transposed};

/// A row of the map to a primitive: its components are to be multiplied by the power of two.
type Row<S> = ([Unit<S>; 3], i32);

/// The box of a primitive in its canonical pose.
pub(crate) fn unplaced<S: Scalar, G: Described>(hull: &Hull<S>) -> Bounds<S> {
    placed::<S, G>(hull, Vec3::ZERO, unturned::<S>())
}

/// The box of a primitive in a frame.
pub(crate) fn in_frame<S: Scalar, G: Described>(hull: &Hull<S>, frame: &Frame<S>) -> Bounds<S> {
    let rows = match hull {
        // A ball in a frame is a ball whatever the last bits of the axes are.
        Hull::Ball(_) if G::EQUATIONS.has(EquationKinds::BALL) => unturned::<S>(),
        _ => [frame.left(), frame.up(), frame.forward()].map(|axis| (axis.to_array(), 0)),
    };
    placed::<S, G>(hull, frame.position(), rows)
}

/// The box of a primitive as a matrix places it.
pub(crate) fn in_affine<S: Scalar, G: Described>(hull: &Hull<S>, affine: &Affine<S>) -> Bounds<S> {
    placed::<S, G>(hull, affine.position(), affine.inverse())
}

fn unturned<S: Scalar>() -> [Row<S>; 3] {
    [UnitVec3::<S>::X, UnitVec3::Y, UnitVec3::Z].map(|axis| (axis.to_array(), 0))
}

fn placed<S: Scalar, G: Described>(hull: &Hull<S>, position: Vec3<S>, rows: [Row<S>; 3]) -> Bounds<S> {
    let everywhere = [-S::INFINITY, S::INFINITY];
    let [x, y, z] = match inverse(rows) {
        Some(matrix) => pairs(position.to_array(), matrix).map(|(o, row)| interval::<S, G>(hull, o, row)),
        None => [everywhere; 3],
    };
    Bounds { low: Vec3::new(x[0], y[0], z[0]), high: Vec3::new(x[1], y[1], z[1]) }
}

/// How far it reaches down and up along an axis of the world, for the position's component and the matrix's row of that
/// axis.
fn interval<S: Scalar, G: Described>(hull: &Hull<S>, o: S, [x, y, z]: [Near<S>; 3]) -> [S; 2] {
    let one = S::Real::ONE;
    let moved = (o, Near::exact(one));
    let mirrored = (-o, Near::exact(one));
    let both = |up: S, down: S| [S::ZERO.minus(down), up];
    let round = |[height, radius]: [S; 2], spread: Near<S>| {
        both(no_less([moved, (height, y), (radius, spread)]), no_less([mirrored, (-height, y), (radius, spread)]))
    };
    let point = |[a, b, c]: [S; 3]| {
        both(no_less([moved, (a, x), (b, y), (c, z)]), no_less([mirrored, (-a, x), (-b, y), (-c, z)]))
    };
    let nothing = [S::INFINITY, -S::INFINITY];
    // Only the hulls of the geometry's kinds are linked.
    let has = |kind| G::EQUATIONS.has(kind);
    let between_discs =
        EquationKinds::CYLINDER.and(EquationKinds::CONE).and(EquationKinds::REVOLVED).and(EquationKinds::TUBE);
    let flat = EquationKinds::PLANE.and(EquationKinds::DISC).and(EquationKinds::ANNULUS);
    match hull {
        Hull::Ball(radius) if has(EquationKinds::BALL) => round([S::ZERO, *radius], length([x, y, z])),
        Hull::Balls(balls) if has(EquationKinds::CAPSULE) => {
            let spread = length([x, y, z]);
            united(balls.map(|ball| round(ball, spread)))
        }
        Hull::Discs(discs) if has(between_discs.and(flat)) => {
            let spread = length([x, z]);
            united(discs.map(|disc| round(disc, spread)))
        }
        Hull::Cone { slope, height } if has(EquationKinds::CONE) => {
            let spread = length([x, z]);
            let [rise, fall] = [one, -one].map(|sign| sum([(sign, y), (slope.real(), spread)]));
            united([[o; 2], both(no_less([moved, (*height, rise)]), no_less([mirrored, (*height, fall)]))])
        }
        Hull::Points(points) if has(EquationKinds::TRIANGLE) => united(points.map(|vertex| point(vertex.to_array()))),
        Hull::Cuboid([a, b, c]) if has(EquationKinds::CUBOID.and(EquationKinds::RECTANGLE)) => {
            let terms = [(*a, x.magnitude()), (*b, y.magnitude()), (*c, z.magnitude())];
            let furthest = |centre: S| no_less([(centre, Near::exact(one)), terms[0], terms[1], terms[2]]);
            both(furthest(o), furthest(-o))
        }
        Hull::RoundedCuboid([a, b, c], radius) if has(EquationKinds::ROUNDED_CUBOID) => {
            let terms = [(*a, x.magnitude()), (*b, y.magnitude()), (*c, z.magnitude()), (*radius, length([x, y, z]))];
            let furthest = |centre: S| no_less([(centre, Near::exact(one)), terms[0], terms[1], terms[2], terms[3]]);
            both(furthest(o), furthest(-o))
        }
        Hull::Torus([major, minor]) if has(EquationKinds::TORUS) => {
            let terms = [(*major, length([x, z])), (*minor, length([x, y, z]))];
            let furthest = |centre: S| no_less([(centre, Near::exact(one)), terms[0], terms[1]]);
            both(furthest(o), furthest(-o))
        }
        Hull::Prism(polygon, height) if has(EquationKinds::PRISM) => {
            let columns = polygon.corners().flat_map(|[x, z]| [[x, S::ZERO, z], [x, *height, z]]);
            columns.map(point).fold(nothing, |all, own| united([all, own]))
        }
        Hull::Box(solid) if has(EquationKinds::POLYHEDRON) => {
            solid.box_corners().map(point).fold(nothing, |all, own| united([all, own]))
        }
        // The geometry has no other hull.
        _ => [o; 2],
    }
}

/// The interval that holds all of them.
fn united<S: Scalar, const N: usize>(intervals: [[S; 2]; N]) -> [S; 2] {
    let [mut low, mut high] = [S::INFINITY, -S::INFINITY];
    for [down, up] in intervals {
        low = if down < low { down } else { low };
        high = if up > high { up } else { high };
    }
    [low, high]
}

/// The inverse, by rows, of the matrix with these rows; `None` if its determinant may be zero.
fn inverse<S: Scalar>(rows: [Row<S>; 3]) -> Option<[[Near<S>; 3]; 3]> {
    // The rows are diag(2^e) C, and the inverse is adj(C) / det(C) diag(2^-e): C alone is of the size of 1.
    let [x, y, z] = rows.map(|(components, _)| components.map(S::unit_real));
    let columns = [minors::<S>(y, z), minors::<S>(z, x), minors::<S>(x, y)];
    let determinant = sum(pairs(x, columns[0]));
    // Not the negated comparison: NaN must fail.
    let is_certain = determinant.off.scaled(2) < determinant.high.abs();
    let columns = pairs(columns, rows)
        .map(|(column, (_, exponent))| column.map(|minor| minor.over(determinant).scaled(-exponent)));
    is_certain.then_some(transposed(columns))
}

/// The cross product.
fn minors<S: Scalar>([ax, ay, az]: [S::Real; 3], [bx, by, bz]: [S::Real; 3]) -> [Near<S>; 3] {
    let minor = |p, q, r: S::Real, s| sum([(p, Near::exact(q)), (-r, Near::exact(s))]);
    [minor(ay, bz, az, by), minor(az, bx, ax, bz), minor(ax, by, ay, bx)]
}

/// The least value of the type, or the one after it, that is surely no less than the sum of lengths times factors.
/// Beyond the type, or if an intermediate float overflows, it is infinite.
fn no_less<S: Scalar, const N: usize>(terms: [(S, Near<S>); N]) -> S {
    let mut infinite = None;
    for (length, factor) in terms {
        if !length.is_finite() && !factor.is_zero() {
            let is_sure = factor.off.scaled(1) < factor.high.abs();
            let is_down = is_sure && (length < S::ZERO) != factor.high.is_negative();
            // A positive infinity decides.
            if infinite != Some(S::INFINITY) {
                infinite = Some(if is_down { -S::INFINITY } else { S::INFINITY });
            }
        }
    }
    if let Some(end) = infinite {
        return end;
    }
    let finite = |length: S| if length.is_finite() { length.real() } else { S::Real::ZERO };
    sum(terms.map(|(length, factor)| (finite(length), factor))).rounded_up()
}

/// A number of twice the precision, `high + low`, and a bound `off` on its error. With `u = 2^Real::ROUNDING`, by
/// which an operation rounds at most, `low` is never more than `3 u high`.
///
/// What is derived of `off` below are bounds of second order in `u`; they are themselves computed with relative errors
/// of some `u`, which an addition of 2^-8 of them covers. Next to zero a float's products lose absolute amounts:
/// [`lost_next_to_zero`].
#[derive(Clone, Copy)]
struct Near<S: Scalar> {
    high: S::Real,
    low: S::Real,
    off: S::Real,
}

/// More than what a product of two floats, held as a rounded product and its rest, loses where these are subnormal:
/// each of five roundings at most half of the smallest number, each for both parts of a factor.
fn lost_next_to_zero<S: Scalar>() -> S::Real {
    if S::RELATIVE { S::BUDGET.smallest_size.real().scaled(3) } else { S::Real::ZERO }
}

/// `times u^2`
fn rounding<S: Scalar>(times: i32) -> S::Real {
    S::Real::from_int(times).scaled(2 * S::Real::ROUNDING)
}

impl<S: Scalar> Near<S> {
    fn exact(value: S::Real) -> Self {
        Self { high: value, low: S::Real::ZERO, off: S::Real::ZERO }
    }

    /// The number with this further error, and with that of rounding the bound.
    fn off_by(self, off: S::Real) -> Self {
        Self { off: off + off.scaled(-8), ..self }
    }

    /// True if it is certainly zero.
    fn is_zero(self) -> bool {
        self.high.is_zero() && self.low.is_zero() && self.off.is_zero()
    }

    fn is_exactly(self, value: S::Real) -> bool {
        self.high == value && self.low.is_zero() && self.off.is_zero()
    }

    fn magnitude(self) -> Self {
        if self.high.is_negative() { Self { high: -self.high, low: -self.low, ..self } } else { self }
    }

    fn scaled(self, n: i32) -> Self {
        if n == 0 || self.is_zero() {
            return self;
        }
        let [high, low, off] = [self.high, self.low, self.off].map(|part| part.scaled(n));
        Self { high, low, off: off + lost_next_to_zero::<S>() }
    }

    /// The quotient by a number that is at least four times its error bound.
    ///
    /// `n / d - q = (n - q d) / d`, whose numerator is a compensated sum of four terms that are together less than
    /// `2.2 n`: it errs by less than `44 u^2 n`; to compute with the rounded `d` and to round the correction is another
    /// `9 u^2`.
    fn over(self, d: Self) -> Self {
        let one = S::Real::ONE;
        if self.is_zero() || d.is_exactly(one) {
            return self;
        }
        let high = self.high / d.high;
        let rest = S::Real::sum_of_products([[self.high, one], [self.low, one], [-high, d.high], [-high, d.low]]);
        let least = d.high.abs() - d.off.scaled(1);
        let off = (self.off + high.abs() * d.off + lost_next_to_zero::<S>()) / least;
        Self { high, low: rest / d.high, off: S::Real::ZERO }.off_by(off + high.abs() * rounding::<S>(64))
    }

    /// The value of the type next to it that is no less. The bounds of [`sum`] have room for the rounding of the sum
    /// here.
    fn rounded_up(self) -> S {
        let one = S::Real::ONE;
        let [high, low] = S::Real::sum_with_rest([[self.high, one], [self.low, one], [self.off, one]]);
        let value = S::round(high);
        if !value.is_finite() {
            // If the value is below the type's range, every value of the type is larger.
            return if value < S::ZERO { value.next_up() } else { S::INFINITY };
        }
        let rest = S::Real::sum_of_products([[high, one], [low, one], [-value.real(), one]]);
        if rest.is_negative() || rest.is_zero() { value } else { value.next_up() }
    }
}

/// The sum of products with exact factors.
///
/// Of n products that are not zero, together `t` in magnitude, the compensated sum gathers 2 n roundings, together at
/// most `(n + 1) u t`, in n additions: it errs by less than `(n + 1)^2 u^2 t` (Ogita, Rump, Oishi, *Accurate Sum and
/// Dot Product*, 2005), the plain sum of the low parts by `3 u^2 t`, and to add the two by `(n + 4) u^2 t`: less than
/// `(n + 4)^2 u^2 t`. (The wide block's sums are off by a unit of 2^-125 in each of their 4 n additions, which is
/// less.) A sum of two numbers is exact.
fn sum<S: Scalar, const N: usize>(terms: [(S::Real, Near<S>); N]) -> Near<S> {
    let one = S::Real::ONE;
    let [high, rest] = S::Real::sum_with_rest(terms.map(|(a, b)| [a, b.high]));
    let low = rest + S::Real::sum_of_products(terms.map(|(a, b)| [a, b.low]));
    let [high, low] = S::Real::sum_with_rest([[high, one], [low, one]]);
    let (mut count, mut is_exact) = (0, true);
    let [mut size, mut off, mut lost] = [S::Real::ZERO; 3];
    for (a, b) in terms {
        if a.is_zero() || b.is_zero() {
            continue;
        }
        count += 1;
        is_exact &= b.low.is_zero() && (a.abs() == one || b.high.abs() == one);
        size = size + a.abs() * b.high.abs();
        off = off + a.abs() * b.off;
        lost = lost + lost_next_to_zero::<S>();
    }
    let rounding =
        if is_exact && count <= 2 { S::Real::ZERO } else { size * rounding::<S>((count + 4) * (count + 4)) + lost };
    Near { high, low, off: S::Real::ZERO }.off_by(off + rounding)
}

/// The length of a vector.
///
/// It is off by no more than its components are together, and by its own rounding. The sum of squares errs by what
/// [`sum`] says, and by the squares of the low parts, `9 u^2` of it. The root `h` is corrected by Newton's
/// `(s - h^2) / 2 h`: its square, `u^2 h / 2`, and its rounding, less than `14 u^2 h`, are left.
fn length<S: Scalar, const N: usize>(v: [Near<S>; N]) -> Near<S> {
    let (one, zero) = (S::Real::ONE, S::Real::ZERO);
    // The only component that is not zero, if there is only one.
    let (mut only, mut count, mut off) = (Near::exact(zero), 0, zero);
    for component in v {
        if !component.is_zero() {
            (only, count) = (component, count + 1);
            off = off + component.off;
        }
    }
    if count <= 1 {
        return only.magnitude();
    }
    // Scaled to near 1, so that the square of no float overflows or underflows.
    let exponent = S::binary_exponent(largest(v.map(|component| S::round(component.high))));
    let near_one = v.map(|c| [c.high, c.low].map(|part| part.scaled(-exponent)));
    let square = sum(near_one.map(|[high, low]| (high, Near::<S> { high, low: low.scaled(1), off: zero })));
    let high = square.high.sqrt();
    if high.is_zero() {
        // All components are close to zero; or one has overflowed, and so has the bound.
        return Near::exact(zero).off_by(off + square.off);
    }
    let rest = S::Real::sum_of_products([[square.high, one], [square.low, one], [-high, high]]);
    let low = (rest / high).scaled(-1);
    let root = Near { high, low, off: square.off / high + high * rounding::<S>(32) }.scaled(exponent);
    root.off_by(root.off + off)
}

#[cfg(all(units, feature = "fixed"))]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../tests/units/bounds/mod.rs"]
mod tests;
