//! The usual case of floats in plain arithmetic: nothing scaled, nothing compensated.
//!
//! A benign ray needs neither: where nothing cancels, the textbook is right to a few units in the last place. Here stands what
//! "nothing cancels" means, a comparison for each difference; the other rays (grazing ones, starts far away or next to a
//! surface, sizes whose powers leave the type) are [`Plain::Unclear`].

use super::{Plain, PlainLine, PlainNappe};

/// Differences of numbers up to this many times larger than themselves are taken; their relative error grows by as much.
const CANCELLED: u8 = 16;
/// Rays start at most this many sizes away.
const FAR: u8 = 16;

macro_rules! plain_float {
    ($name:ident, $Float:ident, $bits:ty, $bias:literal, $mantissa:literal, sqrt: $sqrt:path) => {
        pub(super) mod $name {
            use super::{CANCELLED, FAR, Plain, PlainLine, PlainNappe};

            /// How much a difference of squares may be off, by more than a hundred roundings.
            const DOUBT: $Float = 128.0 * $Float::EPSILON;
            const CANCELLED_SQUARE: $Float = 1.0 / CANCELLED as $Float;
            const FAR_SQUARE: $Float = (FAR as $Float) * (FAR as $Float);

            /// True for a positive size whose eighth powers stay in the type (its squares, for `NARROW` of 2).
            #[inline(always)]
            fn is_handy<const NARROW: u32>(size: $Float) -> bool {
                // By the exponent's bits: between 2^-(bias / NARROW) and its reciprocal.
                const fn least(narrow: u32) -> $bits {
                    ($bias - $bias / narrow as $bits) << $mantissa
                }
                size.to_bits().wrapping_sub(least(NARROW)) < 2 * (($bias << $mantissa) - least(NARROW))
            }

            #[inline(always)]
            fn dot(a: [$Float; 3], b: [$Float; 3]) -> $Float {
                a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
            }

            /// `k = o . d` and `D = r^2 - |o - k d|^2`; a miss if `D < 0`.
            #[inline(always)]
            pub(crate) fn closest_approach(line: PlainLine<$Float>, r: $Float) -> Plain<($Float, $Float)> {
                if !is_handy::<2>(r) {
                    return Plain::Unclear;
                }
                let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
                let k = dot(line.origin, line.direction);
                let p = [x - k * dx, y - k * dy, z - k * dz];
                // Where this overflows the line is far away from the ball: a miss.
                let pp = dot(p, p);
                let rr = r * r;
                if pp > rr { Plain::Miss } else { Plain::Found((k, rr - pp)) }
            }

            /// `k` and `D` of a closest approach, if both are good to a few units, and so are `-k -+ sqrt(D)`.
            #[inline(always)]
            fn clear_approach(line: PlainLine<$Float>, r: $Float) -> Plain<($Float, $Float)> {
                if !is_handy::<2>(r) {
                    return Plain::Unclear;
                }
                let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
                // The formula takes the direction for unit; one that was given by its components may be next to it.
                if $Float::abs(dot(line.direction, line.direction) - 1.0) > 4.0 * $Float::EPSILON {
                    return Plain::Unclear;
                }
                let k = dot(line.origin, line.direction);
                let p = [x - k * dx, y - k * dy, z - k * dz];
                let (rr, kk) = (r * r, k * k);
                let discriminant = rr - dot(p, p);
                // Not the comparisons' negations: what overflowed must fail.
                if !(kk <= rr * FAR_SQUARE && 2.0 * discriminant >= rr * CANCELLED_SQUARE) {
                    return if discriminant < -(rr + kk) * DOUBT { Plain::Miss } else { Plain::Unclear };
                }
                clear_of_the_start(kk, discriminant, (k, discriminant))
            }

            /// `answer`, if neither of `-k -+ sqrt(D)` cancels to less than half of its terms.
            #[inline(always)]
            fn clear_of_the_start<T>(kk: $Float, discriminant: $Float, answer: T) -> Plain<T> {
                if kk < 4.0 * discriminant && discriminant < 4.0 * kk { Plain::Unclear } else { Plain::Found(answer) }
            }

            /// The two ends of the line inside the ball.
            #[inline(always)]
            pub(crate) fn ball(line: PlainLine<$Float>, r: $Float) -> Plain<[$Float; 2]> {
                match clear_approach(line, r) {
                    Plain::Found((k, discriminant)) => {
                        let root = $sqrt(discriminant);
                        Plain::Found([-k - root, root - k])
                    }
                    Plain::Miss => Plain::Miss,
                    Plain::Unclear => Plain::Unclear,
                }
            }

            /// Whether the line has an end in the ball's surface at `t >= 0`; the same as [`ball`] says.
            #[inline(always)]
            pub(crate) fn ball_ahead(line: PlainLine<$Float>, r: $Float) -> Plain<()> {
                match clear_approach(line, r) {
                    Plain::Found((k, discriminant)) if k <= 0.0 || k * k <= discriminant => Plain::Found(()),
                    Plain::Found(_) | Plain::Miss => Plain::Miss,
                    Plain::Unclear => Plain::Unclear,
                }
            }

            /// The two ends of the line inside the cylinder about the y axis: `a = dx^2 + dz^2`, `D = a r^2 - w_y^2`,
            /// `t = (-k -+ sqrt(D)) / a`.
            #[inline(always)]
            pub(crate) fn tube(line: PlainLine<$Float>, r: $Float) -> Plain<[$Float; 2]> {
                let ([x, _, z], [dx, _, dz]) = (line.origin, line.direction);
                let a = dx * dx + dz * dz;
                if !is_handy::<4>(r) || !is_handy::<4>(a) {
                    return Plain::Unclear;
                }
                let k = x * dx + z * dz;
                let w = z * dx - x * dz;
                let (positive, kk) = (a * (r * r), k * k);
                let discriminant = positive - w * w;
                if !(kk <= positive * FAR_SQUARE && discriminant >= positive * CANCELLED_SQUARE) {
                    return if discriminant < -(positive + kk) * DOUBT { Plain::Miss } else { Plain::Unclear };
                }
                let root = $sqrt(discriminant);
                let inverse = 1.0 / a;
                clear_of_the_start(kk, discriminant, [(-k - root) * inverse, (root - k) * inverse])
            }

            /// Where the line is inside the nappe `h^2 (x^2 + z^2) <= (h r + g y)^2`, `h r + g y >= 0`, of a cone with radius `r` at
            /// `y = 0` that grows by `g` over the height `h`; see `plain::nappe`, whose moment is here that of the unscaled line.
            #[inline(always)]
            pub(crate) fn nappe(line: PlainLine<$Float>, [r, g, h]: [$Float; 3]) -> Plain<PlainNappe<$Float>> {
                let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
                let (g0, steepness) = (r * h, $Float::abs(g) + h);
                let [ax, ay, az] = [$Float::abs(x), $Float::abs(y), $Float::abs(z)];
                // Each term of p, q and s is at most this: the rounding of all of them moves D by a few halves of epsilon times it and the
                // moment. (That is crude: let through with D a 256th of it, the worst ray measured was 12 units off.)
                let length = ax + ay + az;
                let reach = steepness * length + g0;
                if !is_handy::<8>(steepness) || !is_handy::<8>(reach) {
                    return Plain::Unclear;
                }
                let [wx, wy, wz] = [y * dz - z * dy, z * dx - x * dz, x * dy - y * dx];
                let (p, q, s) = (g * wz - g0 * dx, g * wx + g0 * dz, h * wy);
                let (positive, negative) = (p * p + q * q, s * s);
                let discriminant = positive - negative;
                let moment = $Float::abs(p) + $Float::abs(q) + $Float::abs(s);
                let is_clear = $Float::abs(discriminant) * (16.0 * CANCELLED as $Float) > moment * reach;
                if !is_clear {
                    return Plain::Unclear;
                }
                let (slope, outline) = (g * dy, g0 + g * y);
                let (across, along) = (h * h * (dx * dx + dz * dz), slope * slope);
                let a = across - along;
                let is_clear = $Float::abs(a) >= (across + along) * (2.0 * CANCELLED_SQUARE);
                if !is_clear {
                    return Plain::Unclear;
                }
                if discriminant < 0.0 && a > 0.0 {
                    return Plain::Miss;
                }
                if discriminant < 0.0 {
                    return Plain::Unclear;
                }
                let (k_across, k_along) = (h * h * (x * dx + z * dz), outline * slope);
                let k = k_across - k_along;
                let root = h * $sqrt(discriminant);
                // -k and the root are added where they have one sign; the other end is c over that sum.
                let sum = $Float::abs(k) + root;
                // The outline cancels towards the apex.
                let rim = g0 + $Float::abs(g) * ay;
                let (outside, inside) = (h * h * (x * x + z * z), outline * outline);
                let c = outside - inside;
                let is_clear = sum * (CANCELLED as $Float) >= h * h * (ax + az) + rim * $Float::abs(slope)
                    && $Float::abs(c) >= (outside + $Float::abs(outline) * rim) * (2.0 * CANCELLED_SQUARE);
                if !is_clear {
                    return Plain::Unclear;
                }
                let q = if k > 0.0 { -sum } else { sum };
                let (by_a, by_c) = (q / a, c / q);
                let (first, second) = if (k > 0.0) == (a > 0.0) { (by_a, by_c) } else { (by_c, by_a) };
                let ends = if a < 0.0 {
                    // Steeper than the side: a half-line in each nappe; the outline grows along the one in the upper.
                    if slope > 0.0 { [second, $Float::INFINITY] } else { [-$Float::INFINITY, first] }
                } else {
                    // The sign of the outline halfway between the ends, at t = -k / a.
                    let (here, there) = (outline * a, slope * k);
                    let middle = here - there;
                    let is_clear = $Float::abs(middle) >= ($Float::abs(here) + $Float::abs(there)) * CANCELLED_SQUARE;
                    if !is_clear {
                        return Plain::Unclear;
                    }
                    if middle < 0.0 {
                        return Plain::Miss;
                    }
                    [first, second]
                };
                Plain::Found(PlainNappe { ends, certain: [true; 2] })
            }

            /// Where the line crosses each of the heights. A line that stays in one height meets none of them.
            #[inline(always)]
            pub(crate) fn crossings(line: PlainLine<$Float>, [low, high]: [$Float; 2]) -> Plain<[$Float; 2]> {
                let ([_, y, _], [_, dy, _]) = (line.origin, line.direction);
                if dy == 0.0 {
                    return Plain::Miss;
                }
                let ends = [(low - y) / dy, (high - y) / dy];
                let is_finite = $Float::abs(ends[0]) < $Float::MAX && $Float::abs(ends[1]) < $Float::MAX;
                if is_finite { Plain::Found(ends) } else { Plain::Unclear }
            }
        }
    };
}
plain_float!(plain_f32, f32, u32, 127, 23, sqrt: crate::scalar::square_root::square_root_f32);
plain_float!(plain_f64, f64, u64, 1023, 52, sqrt: libm::sqrt);
