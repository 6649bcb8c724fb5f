//! Round solids in double-word numbers, on the fast path of floats: for lines of which a guard of the plain formulas fails.
//!
//! In coordinates in which a quadric is `u . u = v^2` a line `u + t u'`, `v + t v'` meets it where `a t^2 + 2 k t + c = 0` with
//! `a = u' . u' - v'^2`, `k = u . u' - v v'` and `c = u . u - v^2`. The coefficients and `D = k^2 - a c` are computed in numbers of twice the
//! precision, so that some units in the last place remain of each in spite of cancellation. The line has twice the precision too, in any frame.

/// Defines them for a float.
macro_rules! doubled {
    ($Float:ident, sqrt: $sqrt:path) => {
        type Twice = Twofold<$Float>;

        /// A sum of products that is less than this part of its terms may be rounding. (It is off by some squares of the relative rounding
        /// error of them.)
        const LEFT: $Float = 8.0 * $Float::EPSILON;

        /// A line in the coordinates `u` and, last, `v`.
        pub(crate) struct InForm<const N: usize> {
            point: [Twice; N],
            along: [Twice; N],
        }

        /// The roots, in order, and the coefficients, rounded.
        struct Quadratic {
            roots: [$Float; 2],
            a: $Float,
            k: $Float,
        }

        /// A line's origin and direction, with what rounding left over of them.
        #[inline(always)]
        fn in_twice(line: &LocalLine<$Float>) -> [[Twice; 3]; 2] {
            let component = |i: usize| Twice { high: line.origin[i], low: line.rests.origin[i] };
            let along = |i: usize| Twice { high: line.direction[i], low: line.rests.direction[i] };
            [[component(0), component(1), component(2)], [along(0), along(1), along(2)]]
        }

        impl<const N: usize> InForm<N> {
            /// `v`, and by how much it grows along the line.
            #[inline(always)]
            fn rim(&self) -> [$Float; 2] {
                [self.point[N - 1].high, self.along[N - 1].high]
            }

            /// `x . y` of the coordinates `u` less the product of the last, and the sum of the magnitudes of its terms.
            #[inline(always)]
            fn product(x: &[Twice; N], y: &[Twice; N]) -> (Twice, $Float) {
                let (mut sum, mut terms) = (Twice::ZERO, 0.0);
                for i in 0..N {
                    let product = x[i] * y[i];
                    sum = if i == N - 1 { sum - product } else { sum + product };
                    terms += $Float::abs(product.high);
                }
                (sum, terms)
            }

            /// The roots, if some units in the last place of both are left; a miss if there are certainly none.
            #[inline(never)]
            fn quadratic(&self) -> Attempt<Quadratic> {
                let (a, a_terms) = Self::product(&self.along, &self.along);
                let (k, k_terms) = Self::product(&self.point, &self.along);
                let (c, c_terms) = Self::product(&self.point, &self.point);
                let discriminant = (k * k - a * c).high;
                let (a, k, c) = (a.high, k.high, c.high);
                let [a_size, k_size, c_size] = [$Float::abs(a), $Float::abs(k), $Float::abs(c)];
                let are_clear = a_size >= LEFT * a_terms && c_size >= LEFT * c_terms;
                if !are_clear {
                    return Attempt::Unsure;
                }
                let doubt = LEFT * (k_size * k_terms + a_size * c_terms + c_size * a_terms);
                if discriminant < -doubt && a > 0.0 {
                    return Attempt::Miss;
                }
                let is_clear = discriminant > doubt;
                if !is_clear {
                    return Attempt::Unsure;
                }
                let root = $sqrt(discriminant);
                // -k and the root are added where they have one sign; the other root is c over that sum.
                let sum = if k > 0.0 { -k - root } else { root - k };
                let (by_a, by_c) = (sum / a, c / sum);
                let roots = if (k > 0.0) == (a > 0.0) { [by_a, by_c] } else { [by_c, by_a] };
                // Next to each other, beside their distance, rounding may exchange them.
                if roots[0] < roots[1] { Attempt::Found(Quadratic { roots, a, k }) } else { Attempt::Unsure }
            }

            /// The other root of `a t^2 + 2 k t`, for a line that begins in the quadric; with `a` and `k`.
            #[inline(never)]
            fn other_root(&self, line: &LocalLine<$Float>) -> Attempt<($Float, $Float, $Float)> {
                let (a, a_terms) = Self::product(&self.along, &self.along);
                let (k, k_terms) = Self::product(&self.point, &self.along);
                // If the line's origin was moved to `start`, the roots are -start and another one; the sum of both is -2 k / a.
                let n = (Twice::of(line.start) * a - k).high;
                let (a, k) = (a.high, k.high);
                let (a_size, n_size) = ($Float::abs(a), $Float::abs(n));
                let n_terms = k_terms + $Float::abs(line.start) * a_terms;
                let is_clear = is_handy::<2>(a_size)
                    && is_handy::<2>(n_size)
                    && a_size >= LEFT * a_terms
                    && n_size >= LEFT * n_terms;
                if is_clear { Attempt::Found((2.0 * n / a - line.start, a, k)) } else { Attempt::Unsure }
            }
        }

        /// A ball about the origin.
        #[inline(always)]
        fn ball_form(line: &LocalLine<$Float>, r: $Float) -> InForm<4> {
            let [[x, y, z], [dx, dy, dz]] = in_twice(line);
            InForm { point: [x, y, z, Twice::of(r)], along: [dx, dy, dz, Twice::ZERO] }
        }

        /// An infinite cylinder about the y axis.
        #[inline(always)]
        fn tube_form(line: &LocalLine<$Float>, r: $Float) -> InForm<3> {
            let [[x, _, z], [dx, _, dz]] = in_twice(line);
            InForm { point: [x, z, Twice::of(r)], along: [dx, dz, Twice::ZERO] }
        }

        /// A cone about the y axis: see `nappe`.
        #[inline(always)]
        fn cone_form(line: &LocalLine<$Float>, [r, g, h]: [$Float; 3]) -> InForm<3> {
            let [[x, y, z], [dx, dy, dz]] = in_twice(line);
            let [r, g, h] = [r, g, h].map(Twice::of);
            InForm { point: [h * x, h * z, h * r + g * y], along: [h * dx, h * dz, g * dy] }
        }

        /// `crossings` of heights.
        #[cold]
        #[inline(never)]
        fn crossings_in_twice(line: &LocalLine<$Float>, heights: [$Float; 2]) -> Attempt<([$Float; 2], [$Float; 2])> {
            let [[_, y, _], [_, dy, _]] = in_twice(line);
            let speed = $Float::abs(dy.high);
            let crossing = |height: $Float| {
                // The quotient of double-word numbers, to some units of the rounded one.
                let way = Twice::of(height) - y;
                (way.high / dy.high, ($Float::abs(height) + $Float::abs(y.high)) * (LEFT * $Float::EPSILON) / speed)
            };
            let [(low, low_off), (high, high_off)] = heights.map(crossing);
            let is_clear = speed >= 32.0 * $Float::EPSILON && $Float::abs(low) + $Float::abs(high) < $Float::MAX;
            if is_clear { Attempt::Found(([low, high], [low_off, high_off])) } else { Attempt::Unsure }
        }

        /// The line with its origin moved back to the start of the ray.
        #[cold]
        #[inline(never)]
        pub(crate) fn moved_back(line: &LocalLine<$Float>) -> LocalLine<$Float> {
            let ([origin, along], start) = (in_twice(line), Twice::of(line.start));
            let point = |i: usize| origin[i] - start * along[i];
            let [x, y, z] = [point(0), point(1), point(2)];
            let rests = LowWords { origin: [x.low, y.low, z.low], ..line.rests };
            LocalLine { origin: [x.high, y.high, z.high], rests, start: 0.0, ..*line }
        }

        /// The ends of a line in a ball.
        #[cold]
        #[inline(never)]
        pub(crate) fn ball_in_twice(line: &LocalLine<$Float>, r: $Float) -> Attempt<[$Float; 2]> {
            if is_handy::<4>(r) {
                Attempt::Found(found!(ball_form(line, r).quadratic()).roots)
            } else {
                Attempt::Unsure
            }
        }

        /// The ends of a line in a tube.
        #[cold]
        #[inline(never)]
        fn tube_in_twice(line: &LocalLine<$Float>, r: $Float) -> Attempt<[$Float; 2]> {
            if is_handy::<4>(r) {
                Attempt::Found(found!(tube_form(line, r).quadratic()).roots)
            } else {
                Attempt::Unsure
            }
        }
    };
}
