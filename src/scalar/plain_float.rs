//! The usual case of floats in plain arithmetic: nothing scaled, and nothing compensated but the moment of a line that passes
//! a cone so closely that it is mostly rounding.
//!
//! A benign ray needs neither: where nothing cancels, the textbook is right to a few units in the last place. Here stands what
//! "nothing cancels" means, a comparison for each difference; the other rays (grazing ones, starts far away or next to a
//! surface, sizes whose powers leave the type) are [`Plain::Unclear`].

use super::{Plain, PlainLine, PlainNappe, found};

macro_rules! plain_float {
    ($name:ident, $Float:ident, $bits:ty, $bias:literal, $mantissa:literal, sqrt: $sqrt:path, may_have_spare_bits: $spare:literal) => {
        pub(super) mod $name {
            use super::{Plain, PlainLine, PlainNappe, found};
            use crate::scalar::Real;
            use core::cmp::Ordering;

            /// What the guards allow.
            struct Limits {
                /// The rounding that they count with.
                epsilon: $Float,
                /// Differences of numbers up to this many times larger than themselves are taken; their relative error grows by as much.
                cancelled: $Float,
                /// The square of a component that a frame's rounding leaves good to a few units.
                level: $Float,
                /// How much more than a unit the rounding of a difference of squares may move an end next to the start, squared.
                near: $Float,
            }

            #[inline(always)]
            const fn has_spare_bits(line: &PlainLine<$Float>) -> bool {
                $spare && line.has_spare_bits
            }

            impl Limits {
                /// Of answers in as many bits as the computation has.
                const OWN: Self = Self { epsilon: $Float::EPSILON, cancelled: 16.0, level: 0.0625, near: 8.0 };
                /// Of answers in so many bits less that guards may count with roundings 2^13 times as large: whatever a guard leaves out of
                /// account is less than that, and what it decides is certain.
                const SPARE: Self =
                    Self { epsilon: 8192.0 * $Float::EPSILON, cancelled: 64.0, level: 0.0625, near: 2048.0 };

                #[inline(always)]
                const fn of(line: &PlainLine<$Float>) -> Self {
                    if has_spare_bits(line) { Self::SPARE } else { Self::OWN }
                }

                /// How much a difference of squares may be off, by more than a hundred roundings.
                #[inline(always)]
                fn doubt(&self) -> $Float {
                    128.0 * self.epsilon
                }

                /// How much the square of a line's distance may be off, next to `rr` or beyond: a distance `p` from a start of which the closest point
                /// is `k` away is off by less than 3 epsilon (|k| + p), and 2 |k| p <= k^2 / 64 + 64 p^2.
                #[inline(always)]
                fn of_distance(&self, pp: $Float, rr: $Float, kk: $Float) -> $Float {
                    (pp + rr) * self.doubt() + kk * (self.epsilon / 16.0)
                }

                /// How much a quotient may be off for a difference that is taken for what it is; nothing, if that keeps enough of its terms.
                #[inline(always)]
                fn off(&self, difference: $Float, terms: $Float) -> $Float {
                    let magnitude = $Float::abs(difference);
                    if magnitude * self.cancelled >= 2.0 * terms { 0.0 } else { terms * self.doubt() / magnitude }
                }
            }

            /// Rays of balls and tubes start at most this many sizes away, squared: their error grows as `t` itself does, until it is as large as
            /// the chord.
            const FAR_SQUARE: $Float = 1024.0 * 1024.0;
            /// Starts next to the axis are at most this many sizes up, squared, if a frame's rounding makes units of that; and moments of
            /// rays that start at most so many sizes away are compensated.
            const HIGH_SQUARE: $Float = HIGH * HIGH;
            const HIGH: $Float = 16.0;
            /// Sums of three products of three factors are taken where their terms are up to this many times larger.
            const FLAT_CANCELLED: $Float = 4.0;

            /// The line from `o` along `d` in the frame with these axes at `position`.
            #[inline(always)]
            pub(crate) fn turned(
                o: [$Float; 3],
                d: [$Float; 3],
                position: [$Float; 3],
                axes: [[$Float; 3]; 3],
            ) -> PlainLine<$Float> {
                let from = minus(o, position);
                let origin = [dot(axes[0], from), dot(axes[1], from), dot(axes[2], from)];
                let direction = [dot(axes[0], d), dot(axes[1], d), dot(axes[2], d)];
                PlainLine { origin, finer: 1, direction, pace: 0.0, has_spare_bits: false }
            }

            /// The line from `o` along `d` in the frame of a matrix that has this inverse; `None` where the products
            /// are together more than three times as large as the coordinates, or the powers of two leave the type.
            #[inline]
            pub(crate) fn stretched(
                o: [$Float; 3],
                d: [$Float; 3],
                position: [$Float; 3],
                rows: [([$Float; 3], i32); 3],
            ) -> Option<PlainLine<$Float>> {
                const MOST: i32 = $bias / 4;
                let [x, y, z] = rows;
                let is_within = |e: i32| -MOST < e && e < MOST;
                if !(is_within(x.1) && is_within(y.1) && is_within(z.1)) {
                    return None;
                }
                let scale = |e: i32| $Float::from_bits((($bias + e) as $bits) << $mantissa);
                let scales = [scale(x.1), scale(y.1), scale(z.1)];
                let applied = |v: [$Float; 3]| {
                    let [a, b, c] = [dot(x.0, v), dot(y.0, v), dot(z.0, v)];
                    let image = [a * scales[0], b * scales[1], c * scales[2]];
                    let v = magnitudes(v);
                    let [a, b, c] = [dot(magnitudes(x.0), v), dot(magnitudes(y.0), v), dot(magnitudes(z.0), v)];
                    let terms = a * scales[0] + b * scales[1] + c * scales[2];
                    let [a, b, c] = magnitudes(image);
                    (terms <= 3.0 * (a + b + c)).then_some(image)
                };
                let (origin, [dx, dy, dz]) = (applied(minus(o, position))?, applied(d)?);
                let square = dx * dx + dy * dy + dz * dz;
                if !is_handy::<4>(square) {
                    return None;
                }
                let pace = 1.0 / $sqrt(square);
                let direction = [dx * pace, dy * pace, dz * pace];
                Some(PlainLine { origin, finer: 1, direction, pace, has_spare_bits: false })
            }

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
                let limits = Limits::of(&line);
                let (along, mut a) = (dot(line.origin, line.direction), dot(line.direction, line.direction));
                if !has_spare_bits(&line) {
                    // The formula takes the direction for unit; one that was given by its components may be next to it.
                    if $Float::abs(a - 1.0) > 4.0 * $Float::EPSILON {
                        return Plain::Unclear;
                    }
                    a = 1.0;
                }
                let k = along / a;
                let p = [x - k * dx, y - k * dy, z - k * dz];
                let (rr, kk) = (r * r, k * along);
                let pp = dot(p, p);
                let discriminant = rr - pp;
                // Not the comparisons' negations: what overflowed must fail.
                if !(kk <= rr * FAR_SQUARE && 2.0 * discriminant * limits.cancelled >= rr) {
                    return if discriminant < -limits.of_distance(pp, rr, kk) { Plain::Miss } else { Plain::Unclear };
                }
                clear_of_the_start(kk, discriminant, rr, limits.near, (k, discriminant / a))
            }

            /// `answer`, if neither of the ends `-k -+ sqrt(D)` is small beside what the rounding of `D`, a difference from `positive`, moves it.
            ///
            /// A root moves by some `eps positive / sqrt(D)`; the smaller end is `|k^2 - D| / (|k| + sqrt(D))`, and the square of that sum at
            /// most `2 (k^2 + D)`.
            #[inline(always)]
            fn clear_of_the_start<T>(
                kk: $Float,
                discriminant: $Float,
                positive: $Float,
                near: $Float,
                answer: T,
            ) -> Plain<T> {
                let c = kk - discriminant;
                // What overflows fails.
                let is_clear = positive * positive * (kk + discriminant) <= near * (c * c) * discriminant;
                if is_clear { Plain::Found(answer) } else { Plain::Unclear }
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
                let y = line.origin[1];
                let limits = Limits::of(&line);
                let (positive, kk, ww) = (a * (r * r), k * k, w * w);
                let discriminant = positive - ww;
                let mut doubt = limits.of_distance(ww, positive, kk);
                if line.finer != 0 {
                    // Rounded on their way into a frame, coordinates are off by roundings of the longest, and components by those of one.
                    doubt *= 8.0;
                    let is_level = a >= limits.level && a * (y * y) <= positive * HIGH_SQUARE + 4.0 * kk;
                    if !is_level || (discriminant > 0.0 && discriminant * a * (4.0 * limits.cancelled) < positive) {
                        return Plain::Unclear;
                    }
                }
                if !(kk <= positive * FAR_SQUARE && discriminant * limits.cancelled >= positive) {
                    return if discriminant < -doubt { Plain::Miss } else { Plain::Unclear };
                }
                let root = $sqrt(discriminant);
                let inverse = 1.0 / a;
                clear_of_the_start(
                    kk,
                    discriminant,
                    positive,
                    limits.near,
                    [(-k - root) * inverse, (root - k) * inverse],
                )
            }

            /// Where the line is inside the nappe `h^2 (x^2 + z^2) <= (h r + g y)^2`, `h r + g y >= 0`, of a cone with radius `r` at
            /// `y = 0` that grows by `g` over the height `h`; see `plain::nappe`, whose moment is here that of the unscaled line.
            #[inline(always)]
            pub(crate) fn nappe(
                line: PlainLine<$Float>,
                [r, g, h]: [$Float; 3],
                top: Option<$Float>,
            ) -> Plain<PlainNappe<$Float>> {
                let Roots { first, second, a, a_terms, k, k_terms, outline, rim, slope } =
                    found!(roots(line, [r, g, h], top));
                let limits = Limits::of(&line);
                let (enter, exit) = if a < 0.0 {
                    // Steeper than the side: a half-line in each nappe; the outline grows along the one in the upper.
                    if slope > 0.0 { (second, ($Float::INFINITY, 0.0)) } else { ((-$Float::INFINITY, 0.0), first) }
                } else {
                    // The sign of the outline halfway between the ends, at t = -k / a.
                    let middle = outline * a - slope * k;
                    let is_clear =
                        $Float::abs(middle) >= (rim * a_terms + $Float::abs(slope) * k_terms) * (2.0 * limits.doubt());
                    if !is_clear {
                        return Plain::Unclear;
                    }
                    if middle < 0.0 {
                        return Plain::Miss;
                    }
                    (first, second)
                };
                Plain::Found(PlainNappe {
                    ends: [enter.0 + enter.1, exit.0 - exit.1],
                    certain: [enter.1 == 0.0, exit.1 == 0.0],
                })
            }

            /// Where the line is inside both nappes of the cone `x^2 + z^2 = m^2 y^2`: between its ends, or (`true`) beyond them.
            #[inline(always)]
            pub(crate) fn double_cone(line: PlainLine<$Float>, m: $Float) -> Plain<([$Float; 2], bool)> {
                let Roots { first, second, a, .. } = found!(roots(line, [0.0, m, 1.0], None));
                let is_clear = first.1 == 0.0 && second.1 == 0.0;
                if is_clear { Plain::Found(([first.0, second.0], a < 0.0)) } else { Plain::Unclear }
            }

            /// The roots of a cone's quadric in order, each with how much it may be off if that is too much to take it, and what tells the
            /// nappes apart.
            struct Roots {
                first: ($Float, $Float),
                second: ($Float, $Float),
                a: $Float,
                a_terms: $Float,
                k: $Float,
                k_terms: $Float,
                outline: $Float,
                rim: $Float,
                slope: $Float,
            }

            /// The roots of the quadric of [`nappe`].
            #[inline(always)]
            fn roots(line: PlainLine<$Float>, [r, g, h]: [$Float; 3], top: Option<$Float>) -> Plain<Roots> {
                let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
                let (g0, steepness) = (r * h, $Float::abs(g) + h);
                let [ax, ay, az] = [$Float::abs(x), $Float::abs(y), $Float::abs(z)];
                // Each term of p, q and s is at most this: the rounding of all of them moves D by a few halves of epsilon times it and the
                // moment. (That is crude: let through with D a 256th of it, the worst ray measured was 12 units off.)
                let length = ax + ay + az;
                // In a frame any coordinate is off by roundings of the longest, and any component by those of one.
                let is_turned = line.finer != 0;
                let [ax, ay, az] = if is_turned { [length; 3] } else { [ax, ay, az] };
                let reach = steepness * length + g0;
                if !is_handy::<8>(steepness) || !is_handy::<8>(reach) {
                    return Plain::Unclear;
                }
                let (slope, outline) = (g * dy, g0 + g * y);
                let (across, along) = (h * h * (dx * dx + dz * dz), slope * slope);
                let a = across - along;
                let a_terms = if is_turned { steepness * steepness } else { across + along };
                let limits = Limits::of(&line);
                // Nearly parallel to a generator.
                let is_clear = $Float::abs(a) >= a_terms * limits.doubt();
                if !is_clear {
                    return Plain::Unclear;
                }
                let difference = |[wx, wy, wz]: [$Float; 3]| {
                    let (p, q, s) = (g * wz - g0 * dx, g * wx + g0 * dz, h * wy);
                    let moment = $Float::abs(p) + $Float::abs(q) + $Float::abs(s);
                    ((p * p + q * q) - s * s, moment)
                };
                let (mut discriminant, moment) = difference([y * dz - z * dy, z * dx - x * dz, x * dy - y * dx]);
                let terms = moment * reach;
                if $Float::abs(discriminant) * (16.0 * limits.cancelled) <= terms {
                    if discriminant < -terms * limits.doubt() && a > 0.0 {
                        return Plain::Miss;
                    }
                    // From far away it takes more than that; what is infinite has no measure for far.
                    let is_near = match top {
                        Some(top) => length <= HIGH * top,
                        None => false,
                    };
                    // Compensation makes up for the moment's own rounding, not for that of a frame.
                    if !is_near || is_turned {
                        return Plain::Unclear;
                    }
                    // The moment of a line that passes closely is small, and its rounding is not: without that.
                    let careful = |[a, b]: [$Float; 2], [c, d]: [$Float; 2]| Real::sum_of_products([[a, b], [-c, d]]);
                    let w = [careful([y, dz], [z, dy]), careful([z, dx], [x, dz]), careful([x, dy], [y, dx])];
                    (discriminant, _) = difference(w);
                    let (p, q) =
                        ($Float::abs(g * w[2]) + g0 * $Float::abs(dx), $Float::abs(g * w[0]) + g0 * $Float::abs(dz));
                    let terms = p * p + q * q + h * h * (w[1] * w[1]);
                    let is_clear = $Float::abs(discriminant) * limits.cancelled > terms;
                    if !is_clear {
                        return Plain::Unclear;
                    }
                }
                if discriminant < 0.0 && a > 0.0 {
                    return Plain::Miss;
                }
                if discriminant < 0.0 {
                    return Plain::Unclear;
                }
                let k = h * h * (x * dx + z * dz) - outline * slope;
                let root = h * $sqrt(discriminant);
                // -k and the root are added where they have one sign; the other end is c over that sum.
                let sum = $Float::abs(k) + root;
                // The outline cancels towards the apex.
                let rim = g0 + $Float::abs(g) * ay;
                let (outside, inside) = (h * h * (x * x + z * z), outline * outline);
                let c_across = if is_turned { h * h * (length * length) } else { outside };
                let (c, c_terms) = (outside - inside, c_across + $Float::abs(outline) * rim);
                let k_along = rim * if is_turned { $Float::abs(g) } else { $Float::abs(slope) };
                let k_terms = h * h * (ax + az) + k_along;
                // Where a cancels, so does k.
                let margin = if $Float::abs(a) * limits.cancelled >= 2.0 * a_terms { 1.0 } else { 2.0 };
                let is_clear = sum * limits.cancelled >= margin * k_terms;
                if !is_clear {
                    return Plain::Unclear;
                }
                let q = if k > 0.0 { -sum } else { sum };
                // Of an end whose numbers cancel only that is said which lies surely inside: the planes may cut it off.
                let by_a = (q / a, limits.off(a, a_terms) * $Float::abs(q / a));
                let by_c = (c / q, limits.off(c, c_terms) * $Float::abs(c / q));
                let (first, second) = if (k > 0.0) == (a > 0.0) { (by_a, by_c) } else { (by_c, by_a) };
                Plain::Found(Roots { first, second, a, a_terms, k, k_terms, outline, rim, slope })
            }

            /// Where the line crosses each of the heights, and how much of that may be off because of a frame. A line that stays in one height
            /// meets none of them.
            #[inline(always)]
            pub(crate) fn crossings(
                line: PlainLine<$Float>,
                [low, high]: [$Float; 2],
            ) -> Plain<([$Float; 2], [$Float; 2])> {
                let ([x, y, z], [_, dy, _]) = (line.origin, line.direction);
                if line.finer == 0 && dy == 0.0 {
                    return Plain::Miss;
                }
                let inverse = 1.0 / dy;
                let ends = [(low - y) * inverse, (high - y) * inverse];
                let is_finite = $Float::abs(ends[0]) < $Float::MAX && $Float::abs(ends[1]) < $Float::MAX;
                if !is_finite {
                    return Plain::Unclear;
                }
                if line.finer == 0 {
                    return Plain::Found(([(low - y) / dy, (high - y) / dy], [0.0; 2]));
                }
                let Limits { epsilon, .. } = Limits::of(&line);
                // Four roundings of the longest coordinate, and three of one.
                let length = $Float::abs(x) + $Float::abs(y) + $Float::abs(z);
                let off = |t: $Float| (length + $Float::abs(t)) * $Float::abs(inverse) * (2.0 * epsilon);
                Plain::Found((ends, [off(ends[0]), off(ends[1])]))
            }

            /// Where the line crosses the disc of this radius about the origin in the plane `y = 0`.
            #[inline(always)]
            pub(crate) fn disc(line: PlainLine<$Float>, r: $Float) -> Plain<$Float> {
                let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
                if !is_handy::<2>(r) || dy == 0.0 {
                    return Plain::Unclear;
                }
                let t = -y / dy;
                let (across, along) = (t * dx, t * dz);
                let (px, pz) = (x + across, z + along);
                let inside = r * r - (px * px + pz * pz);
                let Limits { epsilon, level, .. } = Limits::of(&line);
                // Each coordinate is off by at most three roundings of its terms.
                let length = if line.finer == 0 {
                    $Float::abs(x) + $Float::abs(z) + $Float::abs(across) + $Float::abs(along)
                } else {
                    // So is the crossing, by as many units.
                    let all = $Float::abs(x) + $Float::abs(y) + $Float::abs(z) + $Float::abs(t);
                    if !(dy * dy >= level && $Float::abs(y) * 4.0 >= all) {
                        return Plain::Unclear;
                    }
                    2.0 * all
                };
                let doubt = length * length * (16.0 * epsilon);
                if inside > doubt {
                    Plain::Found(t)
                } else if inside < -doubt {
                    Plain::Miss
                } else {
                    Plain::Unclear
                }
            }

            /// Whether the line's point at `t` lies below `y = 0`, between that and the height, or above.
            #[inline(always)]
            pub(crate) fn between_seams(line: PlainLine<$Float>, t: $Float, height: $Float) -> Plain<Ordering> {
                let ([x, y, z], climb) = (line.origin, t * line.direction[1]);
                let all = $Float::abs(x) + $Float::abs(y) + $Float::abs(z) + $Float::abs(t);
                let off = if line.finer == 0 { 0.0 } else { all * (4.0 * Limits::of(&line).epsilon) };
                let (low, high) = (-y, height - y);
                if are_close(&line, climb, low, off) || are_close(&line, climb, high, off) {
                    Plain::Unclear
                } else if climb < low {
                    Plain::Found(Ordering::Less)
                } else if climb > high {
                    Plain::Found(Ordering::Greater)
                } else {
                    Plain::Found(Ordering::Equal)
                }
            }

            /// Whether rounding, or what they may be off beside it, decides which comes first.
            #[inline(always)]
            pub(crate) fn are_close(line: &PlainLine<$Float>, a: $Float, b: $Float, off: $Float) -> bool {
                // Not if one is infinite, or both are: that compares false.
                $Float::abs(a - b) < ($Float::abs(a) + $Float::abs(b)) * (64.0 * Limits::of(line).epsilon) + off
            }

            /// Whether an end that may be off by so much is good to some units.
            #[inline(always)]
            pub(crate) fn is_good(line: &PlainLine<$Float>, t: $Float, off: $Float) -> bool {
                off <= $Float::abs(t) * (24.0 * Limits::of(line).epsilon)
            }

            #[inline(always)]
            fn minus(a: [$Float; 3], b: [$Float; 3]) -> [$Float; 3] {
                [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
            }

            #[inline(always)]
            fn magnitudes(a: [$Float; 3]) -> [$Float; 3] {
                [$Float::abs(a[0]), $Float::abs(a[1]), $Float::abs(a[2])]
            }

            #[inline(always)]
            fn cross(a: [$Float; 3], b: [$Float; 3]) -> [$Float; 3] {
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            }

            /// Where the line crosses the triangle, and whether it comes from the front.
            #[inline(always)]
            pub(crate) fn triangle(line: PlainLine<$Float>, vertices: [[$Float; 3]; 3]) -> Plain<($Float, bool)> {
                let (o, d) = (line.origin, line.direction);
                let [a, b, c] = [minus(vertices[0], o), minus(vertices[1], o), minus(vertices[2], o)];
                let size = |v: [$Float; 3]| $Float::abs(v[0]) + $Float::abs(v[1]) + $Float::abs(v[2]);
                // In a frame the origin is off by roundings of all of it, and the direction by those of one.
                let (own, one) = if line.finer == 0 { (0.0, 0.0) } else { (4.0 * size(o), 1.0) };
                let sizes = [size(a) + own, size(b) + own, size(c) + own];
                // d . (p x q): the side on which the line passes the edge from p to q; off by at most seven roundings of its terms.
                let volumes = [dot(d, cross(a, b)), dot(d, cross(b, c)), dot(d, cross(c, a))];
                let terms = [sizes[0] * sizes[1], sizes[1] * sizes[2], sizes[2] * sizes[0]];
                if !(is_handy::<2>(terms[0]) && is_handy::<2>(terms[1]) && is_handy::<2>(terms[2])) {
                    return Plain::Unclear;
                }
                let Limits { epsilon, .. } = Limits::of(&line);
                let (mut left, mut right) = (0, 0);
                for (volume, terms) in core::iter::zip(volumes, terms) {
                    let doubt = terms * (16.0 * epsilon);
                    left += (volume > doubt) as u32;
                    right += (volume < -doubt) as u32;
                }
                if left != 0 && right != 0 {
                    return Plain::Miss;
                }
                if left + right != 3 {
                    return Plain::Unclear;
                }
                let from_front = right == 3;
                // From the vertices themselves, which are close together however far the ray starts.
                let (u, v) = (minus(vertices[1], vertices[0]), minus(vertices[2], vertices[0]));
                let normal = cross(u, v);
                let (facing, distance) = (dot(normal, d), dot(normal, a));
                let (u, v) = (magnitudes(u), magnitudes(v));
                let terms = [u[1] * v[2] + u[2] * v[1], u[2] * v[0] + u[0] * v[2], u[0] * v[1] + u[1] * v[0]];
                let most = |v: [$Float; 3], least: $Float| v.map(|c| if c > least { c } else { least });
                let (d_sizes, a_sizes) = (most(magnitudes(d), one), most(magnitudes(a), own));
                let (facing_terms, distance_terms) = (dot(terms, d_sizes), dot(terms, a_sizes));
                let is_clear = is_handy::<2>(facing_terms)
                    && is_handy::<2>(distance_terms)
                    && $Float::abs(facing) * FLAT_CANCELLED >= facing_terms
                    && $Float::abs(distance) * FLAT_CANCELLED >= distance_terms;
                if is_clear && (facing < 0.0) == from_front {
                    Plain::Found((distance / facing, from_front))
                } else {
                    Plain::Unclear
                }
            }
        }
    };
}
plain_float!(plain_f32, f32, u32, 127, 23, sqrt: crate::scalar::square_root::square_root_f32, may_have_spare_bits: false);
plain_float!(plain_f64, f64, u64, 1023, 52, sqrt: libm::sqrt, may_have_spare_bits: true);
