//! The guards of the fast path of floats, and its local lines.

/// Defines the guards and the local lines for a float.
macro_rules! guards {
    ($Float:ident, $bits:ty, $bias:literal, $mantissa:literal, sqrt: $sqrt:path, may_have_spare_bits: $spare:literal) => {
        /// The limits of the guards.
        struct Limits {
            /// The relative rounding error that they assume.
            epsilon: $Float,
            /// The largest ratio of a difference's operands to the difference that is accepted; the relative error grows by that factor.
            cancelled: $Float,
            /// The same for the sum of these ratios of a quotient's numerator and denominator.
            together: $Float,
            /// The largest accepted error of an end due to the error of its line, in roundings of the end.
            moved: $Float,
            /// How much more than a unit the rounding of a difference of squares may move an end next to the start, squared.
            near: $Float,
        }

        #[inline(always)]
        const fn is_strict(line: &LocalLine<$Float>) -> bool {
            $spare && line.is_strict
        }

        /// The error bound of the line's point at `t`, in units of the relative rounding error.
        #[inline(always)]
        fn off_at(line: &LocalLine<$Float>, t: $Float) -> $Float {
            if line.is_rounded { line.off[0] + line.off[1] * $Float::abs(t) } else { 0.0 }
        }

        /// Whether an end is accurate enough in spite of the error of its line. The error of the end is that of the line, divided by the cosine of the
        /// angle between the line and the surface's normal, which is the derivative along the line divided by the gradient's length. Next to
        /// a double root it is larger; `a` is half the second derivative.
        #[inline(always)]
        fn is_steady(line: &LocalLine<$Float>, t: $Float, gradient: $Float, derivative: $Float, a: $Float) -> bool {
            if !line.is_rounded {
                return true;
            }
            let (limits, off) = (Limits::of(line), off_at(line, t) * gradient);
            off <= limits.moved * derivative * $Float::abs(line.start + t)
                && off * a * (32.0 * limits.epsilon) <= derivative * derivative
        }

        impl Limits {
            /// For results with as many bits as the computation has.
            const OWN: Self = Self { epsilon: $Float::EPSILON, cancelled: 16.0, together: 7.0, moved: 8.0, near: 8.0 };
            /// The same for a line whose components have been rounded once.
            const ROUNDED: Self = Self { cancelled: 12.0, together: 6.0, near: 8.0, ..Self::OWN };
            /// For results with so many fewer bits that guards may assume roundings 2^13 times as large. Whatever a guard neglects is less than that,
            /// so that its decisions are certain.
            const SPARE: Self =
                Self { epsilon: 8192.0 * $Float::EPSILON, cancelled: 64.0, together: 36.0, moved: 64.0, near: 2048.0 };

            #[inline(always)]
            const fn of(line: &LocalLine<$Float>) -> Self {
                if is_strict(line) {
                    Self::SPARE
                } else if line.is_rounded {
                    Self::ROUNDED
                } else {
                    Self::OWN
                }
            }

            /// A bound on the error of a difference of squares; it allows for more than a hundred roundings.
            #[inline(always)]
            fn doubt(&self) -> $Float {
                128.0 * self.epsilon
            }

            /// A bound on the error of the square of a line's distance, if it is near `rr` or larger. If the closest point is `k` away from the
            /// start, the error of the distance `p` is less than 3 epsilon (|k| + p), and 2 |k| p <= k^2 / 64 + 64 p^2.
            #[inline(always)]
            fn of_distance(&self, pp: $Float, rr: $Float, kk: $Float) -> $Float {
                (pp + rr) * self.doubt() + kk * (self.epsilon / 16.0)
            }
        }

        /// The square of the largest distance, in sizes, from which rays at spheres and infinite cylinders may start: their error grows in proportion
        /// to `t`, until it is as large as the chord.
        const FAR_SQUARE: $Float = 1024.0 * 1024.0;
        /// Sums of three products of three factors are accepted if their terms are at most this many times larger.
        const FLAT_CANCELLED: $Float = 4.0;

        /// The line from `o` along `d` in the frame with these axes at `position`.
        #[inline(always)]
        pub(crate) fn turned(
            o: [$Float; 3],
            d: [$Float; 3],
            position: [$Float; 3],
            axes: [[$Float; 3]; 3],
        ) -> LocalLine<$Float> {
            let from = minus(o, position);
            let start = closest(from, d, 4.0);
            let from = at(from, d, start);
            let origin = [dot(axes[0], from), dot(axes[1], from), dot(axes[2], from)];
            let direction = [dot(axes[0], d), dot(axes[1], d), dot(axes[2], d)];
            LocalLine {
                start,
                extra_bits: 1,
                off: [off(start, origin), 1.0],
                is_rounded: true,
                ..LocalLine::along(origin, direction, 0.0)
            }
        }

        /// True if the line from `o` along `d` passes the axis through `position` at a distance greater than `r`. The distance of the lines is
        /// `|n . from| / |n|`, `n = d x a` (Ericson, Real-Time Collision Detection, 5.1.8).
        #[inline(always)]
        pub(crate) fn passes_axis(
            o: [$Float; 3],
            d: [$Float; 3],
            position: [$Float; 3],
            a: [$Float; 3],
            r: $Float,
        ) -> bool {
            // Far above all rounding errors, and above the errors of the right angles of frames that were read from files.
            const DOUBT: $Float = 1.0 / 4096.0;
            let (from, n) = (minus(o, position), cross(d, a));
            let (moment, rr) = (dot(n, from), r * r);
            moment * moment > rr * dot(n, n) + (dot(from, from) + rr) * DOUBT
        }

        /// Whether the line from `o` along `d` begins more than sixteen times as far from zero as it passes.
        #[inline(always)]
        pub(crate) fn is_far(o: [$Float; 3], d: [$Float; 3]) -> bool {
            closest(o, d, 256.0) != 0.0
        }

        /// The line from `o` along `d`, with its origin moved next to zero.
        #[inline(always)]
        pub(crate) fn from_afar(o: [$Float; 3], d: [$Float; 3]) -> LocalLine<$Float> {
            let start = -dot(o, d);
            let origin = at(o, d, start);
            let line = LocalLine::along(origin, d, 0.0);
            LocalLine { start, off: [off(start, origin), 0.0], is_rounded: true, ..line }
        }

        /// The `t` of the line's point closest to the origin, if the line starts far away (the squared ratio of its start's distance to the closest
        /// distance is the criterion); otherwise zero. (The length of the direction is nearly 1, and `t` need not be accurate.)
        #[inline(always)]
        fn closest(from: [$Float; 3], d: [$Float; 3], far: $Float) -> $Float {
            let k = dot(from, d);
            // It passes the origin at a distance of the square root of |from|^2 - k^2.
            if k * k * (1.0 + far) > far * dot(from, from) { -k } else { 0.0 }
        }

        #[inline(always)]
        fn at(from: [$Float; 3], d: [$Float; 3], t: $Float) -> [$Float; 3] {
            [from[0] + t * d[0], from[1] + t * d[1], from[2] + t * d[2]]
        }

        /// The error bound of a line whose origin was moved to `start`: half a rounding each for a difference, a product and their sum, and four
        /// halves for a rotation.
        #[inline(always)]
        fn off(start: $Float, origin: [$Float; 3]) -> $Float {
            0.75 * $Float::abs(start) + size(origin)
        }

        /// The line from `o` along `d` in the frame of the affine map with this inverse, with its origin moved next to the map's position if it
        /// starts far away; `None` if the powers of two overflow or underflow.
        #[inline]
        pub(crate) fn stretched(
            o: [$Float; 3],
            d: [$Float; 3],
            position: [$Float; 3],
            rows: [([$Float; 3], i32); 3],
        ) -> Option<LocalLine<$Float>> {
            let (scales, [x, y, z]) = (scales(rows)?, rows);
            let applied = |v: [$Float; 3]| [dot(x.0, v) * scales[0], dot(y.0, v) * scales[1], dot(z.0, v) * scales[2]];
            let matrix = [magnitudes(x.0), magnitudes(y.0), magnitudes(z.0)];
            let terms = |v: [$Float; 3]| {
                let [x, y, z] =
                    [dot(matrix[0], v) * scales[0], dot(matrix[1], v) * scales[1], dot(matrix[2], v) * scales[2]];
                x.max(y).max(z)
            };
            let (from, direction) = (minus(o, position), applied(d));
            let square = dot(direction, direction);
            if !is_handy::<4>(square) {
                return None;
            }
            let start = closest_along(applied(from), direction, 0.0);
            let from = at(from, d, start);
            let origin = applied(from);
            let (length, far) = ($sqrt(square), $Float::abs(start));
            let inverse_length = 1.0 / length;
            let d_terms = terms(magnitudes(d));
            let off = [terms(magnitudes(from)) + 0.75 * far * d_terms, d_terms * inverse_length];
            let line = LocalLine::along(origin, direction.map(|component| component * inverse_length), 0.0);
            Some(LocalLine { start: start * length, extra_bits: 1, inverse_length, off, is_rounded: true, ..line })
        }

        /// The powers of two of the rows; `None` if one leaves a quarter of the type's range.
        #[inline(always)]
        fn scales([x, y, z]: [([$Float; 3], i32); 3]) -> Option<[$Float; 3]> {
            const MOST: i32 = $bias / 4;
            let is_within = |e: i32| -MOST < e && e < MOST;
            let scale = |e: i32| $Float::from_bits((($bias + e) as $bits) << $mantissa);
            (is_within(x.1) && is_within(y.1) && is_within(z.1)).then(|| [scale(x.1), scale(y.1), scale(z.1)])
        }

        /// True for a positive size whose eighth power is within the type's range (its square, for `NARROW` of 2).
        #[inline(always)]
        fn is_handy<const NARROW: u32>(size: $Float) -> bool {
            // By the exponent's bits: between 2^-(bias / NARROW) and its reciprocal.
            const fn least(narrow: u32) -> $bits {
                ($bias - $bias / narrow as $bits) << $mantissa
            }
            size.to_bits().wrapping_sub(least(NARROW)) < 2 * (($bias << $mantissa) - least(NARROW))
        }

        /// The power of two that brings a positive number near 1.
        #[inline(always)]
        fn near_one(size: $Float) -> $Float {
            $Float::from_bits((2 * $bias << $mantissa) - (size.to_bits() & (((2 * $bias + 1) as $bits) << $mantissa)))
        }

        #[inline(always)]
        fn dot(a: [$Float; 3], b: [$Float; 3]) -> $Float {
            a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
        }

        /// Whether rounding, or a further error of the two, may decide which comes first.
        #[inline(always)]
        pub(crate) fn are_close(line: &LocalLine<$Float>, a: $Float, b: $Float, off: $Float) -> bool {
            // The comparison is false if one or both are infinite.
            $Float::abs(a - b)
                < ($Float::abs(a) + $Float::abs(b) + line.off[0]) * (64.0 * Limits::of(line).epsilon) + off
        }

        /// Whether an end with this error is accurate to some units in the last place.
        #[inline(always)]
        pub(crate) fn is_good(line: &LocalLine<$Float>, t: $Float, off: $Float) -> bool {
            off <= $Float::abs(t + line.start) * (11.0 * Limits::of(line).epsilon)
        }

        /// The error of the crossing of a plane at `t`, due to the line: the rounding of the coordinate `o` perpendicular to the plane, some units of
        /// twice the precision of the longest coordinate and of the terms of compensated sums, and the line's own error. `climb` is the magnitude
        /// of the direction's component perpendicular to the plane.
        #[inline(always)]
        fn crossing_off(line: &LocalLine<$Float>, o: $Float, climb: $Float, t: $Float) -> $Float {
            let Limits { epsilon, .. } = Limits::of(line);
            let [low_off, low_along_off] = line.low_words.off;
            let low = 2.0 * size(line.origin) + low_off + low_along_off * $Float::abs(t);
            let own = $Float::abs(o) + 8.0 * epsilon * low;
            (own + off_at(line, t)) * epsilon / climb
        }

        #[inline(always)]
        fn minus(a: [$Float; 3], b: [$Float; 3]) -> [$Float; 3] {
            [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
        }

        #[inline(always)]
        fn size([x, y, z]: [$Float; 3]) -> $Float {
            $Float::abs(x) + $Float::abs(y) + $Float::abs(z)
        }

        #[inline(always)]
        fn magnitudes(a: [$Float; 3]) -> [$Float; 3] {
            [$Float::abs(a[0]), $Float::abs(a[1]), $Float::abs(a[2])]
        }

        #[inline(always)]
        fn cross(a: [$Float; 3], b: [$Float; 3]) -> [$Float; 3] {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        }
    };
}
