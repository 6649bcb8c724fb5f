//! When the fast path of floats takes its own word, and the lines that it takes.

/// Defines them for a float.
macro_rules! guards {
    ($Float:ident, $bits:ty, $bias:literal, $mantissa:literal, sqrt: $sqrt:path, may_have_spare_bits: $spare:literal) => {
        /// What the guards allow.
        struct Limits {
            /// The rounding that they count with.
            epsilon: $Float,
            /// Differences of numbers up to this many times larger than themselves are taken; their relative error grows by as much.
            cancelled: $Float,
            /// The same of the two parts of a quotient, added up.
            together: $Float,
            /// The square of a component that a frame's rounding leaves good to a few units.
            level: $Float,
            /// How much more than a unit the rounding of a difference of squares may move an end next to the start, squared.
            near: $Float,
        }

        #[inline(always)]
        const fn has_spare_bits(line: &LocalLine<$Float>) -> bool {
            $spare && line.has_spare_bits
        }

        /// True if coordinates are off by roundings of the longest, and components of the direction by those of one.
        #[inline(always)]
        const fn is_turned(line: &LocalLine<$Float>) -> bool {
            line.finer != 0 && !line.is_compensated
        }

        impl Limits {
            /// Of answers in as many bits as the computation has.
            const OWN: Self = Self { epsilon: $Float::EPSILON, cancelled: 16.0, together: 9.0, level: 0.1, near: 8.0 };
            /// The same of a line whose components have been rounded once.
            const COMPENSATED: Self = Self { cancelled: 8.0, together: 4.5, near: 4.0, ..Self::OWN };
            /// Of answers in so many bits less that guards may count with roundings 2^13 times as large: whatever a guard leaves out of
            /// account is less than that, and what it decides is certain.
            const SPARE: Self =
                Self { epsilon: 8192.0 * $Float::EPSILON, cancelled: 64.0, together: 36.0, level: 0.1, near: 2048.0 };

            #[inline(always)]
            const fn of(line: &LocalLine<$Float>) -> Self {
                if has_spare_bits(line) {
                    Self::SPARE
                } else if line.is_compensated {
                    Self::COMPENSATED
                } else {
                    Self::OWN
                }
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
        ) -> LocalLine<$Float> {
            let from = minus(o, position);
            let origin = [dot(axes[0], from), dot(axes[1], from), dot(axes[2], from)];
            let direction = [dot(axes[0], d), dot(axes[1], d), dot(axes[2], d)];
            LocalLine { finer: 1, ..LocalLine::along(origin, direction, 0.0) }
        }

        /// The line from `o` along `d` in the frame of a matrix that has this inverse; `None` where the products
        /// are together more than three times as large as the coordinates, or the powers of two leave the type.
        #[inline]
        pub(crate) fn stretched(
            o: [$Float; 3],
            d: [$Float; 3],
            position: [$Float; 3],
            rows: [([$Float; 3], i32); 3],
        ) -> Option<LocalLine<$Float>> {
            let (scales, [x, y, z]) = (scales(rows)?, rows);
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
            Some(LocalLine { finer: 1, pace, ..LocalLine::along(origin, direction, 0.0) })
        }

        /// The powers of two of the rows; `None` if one leaves a quarter of the type's range.
        #[inline(always)]
        fn scales([x, y, z]: [([$Float; 3], i32); 3]) -> Option<[$Float; 3]> {
            const MOST: i32 = $bias / 4;
            let is_within = |e: i32| -MOST < e && e < MOST;
            let scale = |e: i32| $Float::from_bits((($bias + e) as $bits) << $mantissa);
            (is_within(x.1) && is_within(y.1) && is_within(z.1)).then(|| [scale(x.1), scale(y.1), scale(z.1)])
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

        /// The power of two that brings a positive number near 1.
        #[inline(always)]
        fn near_one(size: $Float) -> $Float {
            $Float::from_bits((2 * $bias << $mantissa) - (size.to_bits() & (((2 * $bias + 1) as $bits) << $mantissa)))
        }

        #[inline(always)]
        fn dot(a: [$Float; 3], b: [$Float; 3]) -> $Float {
            a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
        }

        /// Whether rounding, or what they may be off beside it, decides which comes first.
        #[inline(always)]
        pub(crate) fn are_close(line: &LocalLine<$Float>, a: $Float, b: $Float, off: $Float) -> bool {
            // Not if one is infinite, or both are: that compares false.
            $Float::abs(a - b) < ($Float::abs(a) + $Float::abs(b)) * (64.0 * Limits::of(line).epsilon) + off
        }

        /// Whether an end that may be off by so much is good to some units.
        #[inline(always)]
        pub(crate) fn is_good(line: &LocalLine<$Float>, t: $Float, off: $Float) -> bool {
            off <= $Float::abs(t + line.start) * (19.0 * Limits::of(line).epsilon)
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
    };
}
