//! Round solids in double-word numbers, on the fast path of floats: for lines for which a guard of the plain formulas fails.
//!
//! In coordinates in which a quadric is `u . u = v^2` a line `u + t u'`, `v + t v'` meets it where `a t^2 + 2 k t + c = 0` with
//! `a = u' . u' - v'^2`, `k = u . u' - v v'` and `c = u . u - v^2`. The coefficients and `D = k^2 - a c` are computed in numbers of twice the
//! precision, so that each is accurate to some units in the last place in spite of cancellation. The line has twice the precision too, in any frame.

/// Defines the intersection with round solids for a float.
macro_rules! doubled {
    ($Float:ident, sqrt: $sqrt:path) => {
        type DoubleWord = Twofold<$Float>;

        /// A sum of products that is less than this fraction of its terms may be only rounding error. (Its error is some squares of the relative
        /// rounding error, times the terms.)
        const LEFT: $Float = 8.0 * $Float::EPSILON;
        /// If a term is less than this, the low words of its products underflow.
        const LEAST: $Float = $Float::MIN_POSITIVE / LEFT;

        /// A point or a vector in the coordinates `u` and, last, `v`.
        struct FormVector<const N: usize> {
            parts: [DoubleWord; N],
            /// The error of these coordinates, in squares of the relative rounding error.
            off: $Float,
        }

        /// A line in the coordinates `u` and, last, `v`.
        struct FormLine<const N: usize> {
            point: FormVector<N>,
            along: FormVector<N>,
        }

        /// The roots, in order, and the coefficients, rounded.
        struct Quadratic {
            roots: [$Float; 2],
            a: $Float,
            k: $Float,
        }

        /// A line's origin and direction, with their low words.
        #[inline(always)]
        fn double_words(line: &LocalLine<$Float>) -> [[DoubleWord; 3]; 2] {
            let component = |i: usize| DoubleWord { high: line.origin[i], low: line.low_words.origin[i] };
            let along = |i: usize| DoubleWord { high: line.direction[i], low: line.low_words.direction[i] };
            [[component(0), component(1), component(2)], [along(0), along(1), along(2)]]
        }

        impl<const N: usize> FormVector<N> {
            /// `x . y` of the coordinates `u`, less the product of the last coordinates; and the sum of the magnitudes of its terms, enlarged by the
            /// errors of `x` and `y`.
            #[inline(always)]
            fn product(&self, y: &Self) -> (DoubleWord, $Float) {
                let (mut sum, mut terms) = (DoubleWord::ZERO, 0.0);
                for i in 0..N {
                    let product = self.parts[i] * y.parts[i];
                    sum = if i == N - 1 { sum - product } else { sum + product };
                    terms += $Float::abs(product.high)
                        + self.off * $Float::abs(y.parts[i].high)
                        + y.off * $Float::abs(self.parts[i].high);
                }
                (sum, terms)
            }
        }

        impl<const N: usize> FormLine<N> {
            /// `v`, and its growth along the line.
            #[inline(always)]
            fn rim(&self) -> [$Float; 2] {
                [self.point.parts[N - 1].high, self.along.parts[N - 1].high]
            }

            /// The roots, if both are accurate to some units in the last place; a miss if there are certainly none.
            #[inline(never)]
            fn quadratic(&self) -> Attempt<Quadratic> {
                let (a, a_terms) = self.along.product(&self.along);
                let (k, k_terms) = self.point.product(&self.along);
                let (c, c_terms) = self.point.product(&self.point);
                let discriminant = (k * k - a * c).high;
                let (a, k, c) = (a.high, k.high, c.high);
                let [a_size, k_size, c_size] = [$Float::abs(a), $Float::abs(k), $Float::abs(c)];
                let doubt = LEFT * (k_size * k_terms + a_size * c_terms + c_size * a_terms);
                let are_clear = a_size >= LEFT * a_terms && c_size >= LEFT * c_terms;
                // (The error of k by underflow is less than the doubt.)
                let is_in_range = a_terms >= LEAST && c_terms >= LEAST && doubt >= $Float::MIN_POSITIVE;
                if !(are_clear && is_in_range) {
                    return Attempt::Unsure;
                }
                if discriminant < -doubt && a > 0.0 {
                    return Attempt::Miss;
                }
                let is_clear = discriminant > doubt;
                if !is_clear {
                    return Attempt::Unsure;
                }
                let root = $sqrt(discriminant);
                // -k and the root are added where they have the same sign; the other root is c over that sum.
                let sum = if k > 0.0 { -k - root } else { root - k };
                let (by_a, by_c) = (sum / a, c / sum);
                let [low, high] = if (k > 0.0) == (a > 0.0) { [by_a, by_c] } else { [by_c, by_a] };
                // Rounding may exchange the roots if they are close to each other relative to their magnitude. Neither may overflow.
                let are_apart = low < high && high - low < $Float::MAX;
                if are_apart { Attempt::Hit(Quadratic { roots: [low, high], a, k }) } else { Attempt::Unsure }
            }

            /// The other root of `a t^2 + 2 k t`, for a line that begins in the quadric; with `a` and `k`.
            #[inline(never)]
            fn other_root(&self, line: &LocalLine<$Float>) -> Attempt<($Float, $Float, $Float)> {
                let (a, a_terms) = self.along.product(&self.along);
                let (k, k_terms) = self.point.product(&self.along);
                // If the line's origin was moved to `start`, the roots are -start and another one; the sum of both is -2 k / a.
                let n = (DoubleWord::of(line.start) * a - k).high;
                let (a, k) = (a.high, k.high);
                let (a_size, n_size) = ($Float::abs(a), $Float::abs(n));
                let n_terms = k_terms + $Float::abs(line.start) * a_terms;
                let is_clear = is_handy::<2>(a_size)
                    && is_handy::<2>(n_size)
                    && a_size >= LEFT * a_terms
                    && n_size >= LEFT * n_terms;
                if is_clear { Attempt::Hit((2.0 * n / a - line.start, a, k)) } else { Attempt::Unsure }
            }
        }

        /// A ball about the origin.
        #[inline(always)]
        fn ball_form(line: &LocalLine<$Float>, r: $Float) -> FormLine<4> {
            let ([[x, y, z], [dx, dy, dz]], [off, along_off]) = (double_words(line), line.low_words.off);
            FormLine {
                point: FormVector { parts: [x, y, z, DoubleWord::of(r)], off },
                along: FormVector { parts: [dx, dy, dz, DoubleWord::ZERO], off: along_off },
            }
        }

        /// An infinite cylinder about the y axis.
        #[inline(always)]
        fn tube_form(line: &LocalLine<$Float>, r: $Float) -> FormLine<3> {
            let ([[x, _, z], [dx, _, dz]], [off, along_off]) = (double_words(line), line.low_words.off);
            FormLine {
                point: FormVector { parts: [x, z, DoubleWord::of(r)], off },
                along: FormVector { parts: [dx, dz, DoubleWord::ZERO], off: along_off },
            }
        }

        /// A cone about the y axis with radius `r` at `y = 0` and `top` at the height `h`: see `nappe`.
        #[inline(always)]
        fn cone_form(line: &LocalLine<$Float>, [r, top, h]: [$Float; 3]) -> FormLine<3> {
            let ([[x, y, z], [dx, dy, dz]], off) = (double_words(line), line.low_words.off);
            let [r, top, h] = [r, top, h].map(DoubleWord::of);
            let g = top - r;
            let scale = $Float::abs(g.high) + h.high;
            // The outline is a sum, which cancels towards the apex.
            let (at_origin, growth) = (h * r, g * y);
            let rim = at_origin.high + $Float::abs(growth.high);
            FormLine {
                point: FormVector { parts: [h * x, h * z, at_origin + growth], off: scale * off[0] + rim },
                along: FormVector { parts: [h * dx, h * dz, g * dy], off: scale * off[1] },
            }
        }

        /// The function `crossings` in double-word numbers.
        #[cold]
        #[inline(never)]
        fn crossings_doubled(line: &LocalLine<$Float>, heights: [$Float; 2]) -> Attempt<([$Float; 2], [$Float; 2])> {
            let [[_, y, _], [_, dy, _]] = double_words(line);
            let speed = $Float::abs(dy.high);
            let crossing = |height: $Float| {
                // The quotient of double-word numbers, accurate to some units in the last place of a float.
                let way = DoubleWord::of(height) - y;
                let terms = $Float::abs(height) + $Float::abs(y.high) + line.low_words.off[0];
                (way.high / dy.high, terms * (LEFT * $Float::EPSILON) / speed)
            };
            let [(low, low_off), (high, high_off)] = heights.map(crossing);
            let is_clear =
                speed >= (4.0 + line.low_words.off[1]) * LEFT && $Float::abs(low) + $Float::abs(high) < $Float::MAX;
            if is_clear { Attempt::Hit(([low, high], [low_off, high_off])) } else { Attempt::Unsure }
        }

        /// The line with its origin moved back to the start of the ray.
        #[cold]
        #[inline(never)]
        pub(crate) fn moved_back(line: &LocalLine<$Float>) -> LocalLine<$Float> {
            let ([origin, along], start) = (double_words(line), DoubleWord::of(line.start));
            let point = |i: usize| origin[i] - start * along[i];
            let [x, y, z] = [point(0), point(1), point(2)];
            let [off, along_off] = line.low_words.off;
            let off = off + $Float::abs(line.start) * (2.0 + along_off);
            let low_words = LowWords { origin: [x.low, y.low, z.low], off: [off, along_off], ..line.low_words };
            LocalLine { origin: [x.high, y.high, z.high], low_words, start: 0.0, ..*line }
        }

        /// The ends of a line in a ball.
        #[cold]
        #[inline(never)]
        pub(crate) fn ball_doubled(line: &LocalLine<$Float>, r: $Float) -> Attempt<[$Float; 2]> {
            Attempt::Hit(found!(ball_form(line, r).quadratic()).roots)
        }

        /// The ends of a line in a tube.
        #[cold]
        #[inline(never)]
        fn tube_doubled(line: &LocalLine<$Float>, r: $Float) -> Attempt<[$Float; 2]> {
            Attempt::Hit(found!(tube_form(line, r).quadratic()).roots)
        }
    };
}
