//! A line and a cone's side.

use super::framed_bits;
use super::length::{Divisor, Length, Normalized, Product};
use crate::scalar::{Attempt, InSide, found};

/// The divisor of a line's roots, with its reciprocal.
type DivisorOf<N> = <<N as Length>::Normalized as Normalized<N>>::Divisor;

/// A line in coordinates in which a cone is `X^2 + Z^2 = Y^2`, and the `a` of its roots.
///
/// The cone, `h^2 (x^2 + z^2) = (h r + g y)^2`, has the radius `r` at `y = 0` and grows by `g` over the height `h`. The
/// coordinates are scaled by `h` across the axis and by the outline along it: `X = h x`, `Z = h z`, `Y = h r + g y`.
#[derive(Clone, Copy)]
struct Scaled<N: Length> {
    /// The moved origin.
    point: [N; 3],
    direction: [N; 3],
    a: N::Product,
    digits: N::Normalized,
    /// Lengths are in units of `2^-unit`.
    unit: i32,
    /// The whole unit of `t` at that point.
    start: N,
    /// The origin was in units of `2^-extra_bits`.
    extra_bits: i32,
    /// Decisions must be certain.
    is_strict: bool,
}

impl<N: Length> Scaled<N> {
    /// The origin is in units of `2^-extra_bits` of the sizes'. It is moved to a point next to the line's closest
    /// point, unless the line `departs`.
    // Not inlined: a shape that may be any cone would contain it twice.
    #[inline(never)]
    fn new(o: [N; 3], extra_bits: i32, d: [N; 3], [r, g, h]: [N; 3], departs: bool, is_strict: bool) -> Attempt<Self> {
        let Some(radius) = r.refined(extra_bits) else { return Attempt::Unsure };
        // The proportions, the larger one above 1/2 and at most 1.
        let free = N::zeros([g, h - N::from(1)]);
        if free < 2 || !N::have_room(o) {
            return Attempt::Unsure;
        }
        let (g, h) = (g.up(free - 2), h.up(free - 2));
        // The origin is moved to the whole unit of t next to the point closest to the frame's origin. The products are
        // exact, and the lengths are those of the cone and of the line's distance from it, however far away the ray
        // starts.
        let closest =
            if departs { Some(N::ZERO) } else { N::narrowed(-(N::dot(o, d) >> (N::FRACTION + extra_bits as u32))) };
        let Some((start, walk)) = closest.and_then(|start| Some((start, start.refined_time(extra_bits)?))) else {
            return Attempt::Unsure;
        };
        let walked = |i: usize| o[i].at_unit() + N::dot([walk], [d[i]]);
        let near = [walked(0), walked(1), walked(2)];
        let radius = radius.at_unit();
        // Lengths on a grid on which none has more than BITS - 3 bits.
        let [x, y, z] = near.map(N::high);
        let zeros = N::zeros([x, y, z, N::high(radius)]);
        let unit = zeros as i32 - 5 + extra_bits;
        // Beyond the second limit, next to an apex, a quotient of the roots would be shifted by more than 2 BITS.
        if zeros < 4 || !(0..=N::BITS as i32 + 2).contains(&unit) {
            return Attempt::Unsure;
        }
        // Truncated towards zero, so that a mirrored line has mirrored points.
        let on_grid = |length: N::Product| {
            let truncated = N::truncated(length.magnitude(), N::BITS + 3 - zeros);
            if N::high(length) < N::ZERO { -truncated } else { truncated }
        };
        let along = |length: N, proportion: N| N::nearest(N::dot([length], [proportion]));
        let [x, y, z] = near.map(on_grid);
        let point = [along(x, h), along(on_grid(radius), h) + along(y, g), along(z, h)];
        let [dx, dy, dz] = [along(d[0], h), along(d[1], g), along(d[2], h)];

        let a = N::squared_length([dx, dz]) - N::squared_length([dy]);
        let Some(digits) = N::Normalized::new(a) else {
            return Attempt::Unsure;
        };
        Attempt::Hit(Self { point, direction: [dx, dy, dz], a, digits, unit, start, extra_bits, is_strict })
    }

    /// The number of bits by which the coordinates are finer than an eighth of the type's unit, and a framed origin
    /// than a fourth, if the roots multiply errors by `2^shift`.
    #[inline(always)]
    fn spare(&self) -> i32 {
        let shift = self.digits.shift();
        let spare = self.unit - 3 - shift;
        // The error of a framed origin is half of its own unit.
        if self.extra_bits == 0 { spare } else { spare.min(self.extra_bits - 2 - shift) }
    }

    /// The exponent of the error of a coordinate, in its units, if it comes from a framed origin.
    #[inline(always)]
    fn framed_bits(&self) -> u32 {
        framed_bits(self.extra_bits, self.unit) as u32
    }

    /// Whether the line is steeper than the side: then it is inside before its first end and after its second.
    #[inline(always)]
    fn is_steep(&self) -> bool {
        N::high(self.a) < N::ZERO
    }

    #[inline(always)]
    fn k(&self) -> N::Product {
        let ([x, y, z], [dx, dy, dz]) = (self.point, self.direction);
        N::dot([x, z], [dx, dz]) - N::dot([y], [dy])
    }

    /// Whether the point halfway between the roots, at `t = -k / a`, is in the nappe whose outline is positive: the
    /// sign there is that of `Y a - dY k`.
    #[inline(always)]
    fn is_middle_inside(&self, k: N::Product) -> Attempt<bool> {
        let (a, k) = (N::high(self.a << 2), N::high(k << 2));
        let middle = N::minor([self.point[1], self.direction[1]], [k, a]);
        // If strict: the sum of the errors of Y a and dY k is 2^(BITS + 3), and 2^(BITS - 0.6) more for each unit of
        // error of a framed origin.
        let doubtful = if self.is_strict { 4.max(2 + self.framed_bits()) } else { 2 };
        if middle.magnitude() >> (N::BITS + doubtful) == N::Product::ZERO {
            Attempt::Unsure
        } else {
            Attempt::Hit(N::high(middle) >= N::ZERO)
        }
    }
}

/// The line and both nappes: the line's moment `W` gives `D = Wx^2 + Wz^2 - Wy^2`, so that `t = (-k -+ sqrt(D)) / a`.
struct AtCone<N: Length> {
    line: Scaled<N>,
    k: N::Product,
    root: N,
    divisor: DivisorOf<N>,
    /// The largest distance of an end from the moved origin of the line at which the end is accurate enough.
    farthest: N,
}

impl<N: Length> AtCone<N> {
    /// The origin is in units of `2^-extra_bits` of the sizes'.
    // Not inlined, as above.
    #[inline(never)]
    fn new(o: [N; 3], extra_bits: i32, d: [N; 3], outline: [N; 3], is_strict: bool) -> Attempt<Self> {
        let line = found!(Scaled::new(o, extra_bits, d, outline, false, is_strict));
        let ([x, y, z], [dx, dy, dz]) = (line.point, line.direction);
        let w = [N::minor([y, z], [dy, dz]), N::minor([z, x], [dz, dx]), N::minor([x, y], [dx, dy])].map(N::nearest);
        let [wx, wy, wz] = w;
        let discriminant = N::squared_length([wx, wz]) - N::squared_length([wy]);
        // The rounding of the coordinates, up to 1.5 units perpendicular to the axis and 3 along it, changes D by at
        // most ten times this.
        let [p, q, r] = w.map(|w| N::Product::from(w).magnitude());
        let moment = p + q + r;
        // If strict: by 16 times this, and by 4 times this for each unit of error of a framed origin.
        let doubt = moment << if is_strict { 5.max(3 + line.framed_bits()) } else { 4 };
        if discriminant < -doubt && !line.is_steep() {
            return Attempt::Miss;
        }
        if is_strict && discriminant <= doubt {
            return Attempt::Unsure;
        }
        // It changes t by at most half a unit (a twentieth in all measurements), if the root is not small relative to
        // the moment.
        let spare = line.spare();
        let Some(moment) = N::narrowed(moment >> 2) else { return Attempt::Unsure };
        if N::high(discriminant) <= N::ZERO || spare < 0 {
            return Attempt::Unsure;
        }
        let root = N::root(discriminant);
        if root.down(2) < moment.down(spare.min(31) as u32) {
            return Attempt::Unsure;
        }
        let k = line.k();
        let divisor = line.digits.divisor();
        // Farther away the rounding of a turned direction matters: an error of 2^-(BITS - 1) of t, which a small root
        // enlarges likewise.
        let (bits, more) = (N::CONE_BITS as i32, N::zeros([root]) as i32 - N::zeros([moment]) as i32 + 3);
        let bits = if extra_bits == 0 { bits } else { (bits + 4 - more).min(bits).max(0) };
        let farthest = N::from(1).up(bits as u32).down(line.digits.shift() as u32);
        Attempt::Hit(Self { line, k, root, divisor, farthest })
    }

    /// An end, and true if the interval ends there, false if it ends somewhere beyond.
    #[inline(always)]
    fn end(&self, numerator: N::Product) -> (N, bool) {
        let (Scaled { start, unit, .. }, farthest) = (self.line, self.farthest);
        match self.divisor.quotient(numerator, unit as u32) {
            Some(t) if -farthest < t && t < farthest => match start.checked_plus(t) {
                Some(t) => (t, true),
                None => (start.saturating_plus(t), false),
            },
            _ if (N::high(numerator) < N::ZERO) == self.line.is_steep() => (start.saturating_plus(farthest), false),
            _ => (start.saturating_plus(-farthest), false),
        }
    }

    /// The end at the lower root for a positive `a`, and at the higher one for a negative `a`.
    #[inline(always)]
    fn first(&self) -> (N, bool) {
        self.end(-self.k - self.root.at_unit())
    }

    /// The other one.
    #[inline(always)]
    fn second(&self) -> (N, bool) {
        self.end(self.root.at_unit() - self.k)
    }
}

/// Where the line is inside the nappe in which `h r + g y >= 0`.
///
/// The origin is in units of `2^-extra_bits` of the sizes'; the answer is in the sizes'.
#[inline(always)]
pub(in crate::scalar) fn nappe<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    outline: [N; 3],
    is_strict: bool,
) -> Attempt<InSide<N>> {
    let cone = found!(AtCone::new(o, extra_bits, d, outline, is_strict));
    let line = &cone.line;
    let (low, high) = if line.is_steep() {
        // A half-line lies in each nappe. Along the one in the upper nappe the outline grows.
        if line.direction[1] > N::ZERO { (cone.first(), (N::MAX, true)) } else { ((-N::MAX, true), cone.second()) }
    } else if found!(line.is_middle_inside(cone.k)) {
        (cone.first(), cone.second())
    } else {
        return Attempt::Miss;
    };
    // An interval that begins or ends somewhere beyond an inaccurate end may be anywhere, or empty.
    if (!low.1 && low.0 > line.start) || (!high.1 && high.0 < line.start) {
        return Attempt::Unsure;
    }
    let beyond = |is_end: bool| if is_end { N::ZERO } else { N::MAX };
    Attempt::Hit(InSide { ends: [low.0, high.0], beyond: [beyond(low.1), beyond(high.1)] })
}

/// Where the line is inside both nappes of the cone of slope `g / h` about its apex at the origin: between its ends, or
/// (`true`) before the first and after the second.
#[inline(always)]
pub(in crate::scalar) fn double_cone<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    [g, h]: [N; 2],
    is_strict: bool,
) -> Attempt<([N; 2], bool)> {
    let cone = found!(AtCone::new(o, extra_bits, d, [N::ZERO, g, h], is_strict));
    match (cone.first(), cone.second()) {
        ((first, true), (second, true)) if cone.line.is_steep() => Attempt::Hit(([second, first], true)),
        ((first, true), (second, true)) => Attempt::Hit(([first, second], false)),
        _ => Attempt::Unsure,
    }
}

/// Where a line that begins in the side of [`nappe`] leaves that nappe: the other root of `a t^2 + 2 k t`, whatever its
/// rounded coordinates are; infinite if it does not leave it.
#[inline]
pub(in crate::scalar) fn exit_from_nappe<N: Length>(
    o: [N; 3],
    extra_bits: i32,
    d: [N; 3],
    outline: [N; 3],
    is_strict: bool,
) -> Attempt<N> {
    let line = found!(Scaled::new(o, extra_bits, d, outline, true, is_strict));
    let k = line.k();
    // The rounding of the coordinates changes t by at most a fourth of a unit.
    if line.spare() < 3 {
        return Attempt::Unsure;
    }
    let Some(t) = line.digits.divisor().quotient(-(k << 1), line.unit as u32) else {
        return Attempt::Unsure;
    };
    if line.is_steep() {
        // A half-line lies in each nappe, and that of this nappe has no end.
        let leads_in = t < -N::from(1) && line.direction[1] > N::ZERO;
        return if leads_in { Attempt::Hit(N::MAX) } else { Attempt::Unsure };
    }
    let is_near = N::ZERO < t && t < N::from(1).up(N::CONE_BITS).down(line.digits.shift() as u32);
    if is_near && found!(line.is_middle_inside(k)) { Attempt::Hit(t) } else { Attempt::Unsure }
}
