//! Triangles in double-word numbers, on the fast path of floats: for lines for which a guard of the plain formulas fails, most of which are at a small
//! angle to the triangle's plane.
//!
//! Every value comes with the sum of the magnitudes of its terms, enlarged by the errors of what it is made of. Its error is at most some squares of
//! the relative rounding error, times that sum.

/// Defines the intersection with triangles for a float.
macro_rules! doubled_triangle {
    ($Float:ident) => {
        /// A value less than this fraction of its terms may have the other sign: a bound on the error of some ten operations.
        const MAY_BE_ZERO: $Float = 32.0 * $Float::EPSILON * $Float::EPSILON;

        /// A double-word number, and the sum of its terms.
        #[derive(Clone, Copy)]
        struct Sum {
            value: DoubleWord,
            terms: $Float,
        }

        impl Sum {
            /// A number with an error of `off` squares of the relative rounding error.
            #[inline(always)]
            fn new(value: DoubleWord, off: $Float) -> Self {
                Self { value, terms: $Float::abs(value.high) + off }
            }

            /// The difference of two floats, which is exact.
            #[inline(always)]
            fn of_difference(a: $Float, b: $Float) -> Self {
                let [high, low] = a.plus_with_rest(-b);
                Self::new(DoubleWord { high, low }, 0.0)
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                Self { value: self.value + other.value, terms: self.terms + other.terms }
            }

            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                Self { value: self.value - other.value, terms: self.terms + other.terms }
            }

            #[inline(always)]
            fn times(self, other: Self) -> Self {
                Self { value: self.value * other.value, terms: self.terms * other.terms }
            }

            /// The value and a bound on its error.
            #[inline(always)]
            fn with_doubt(self) -> ($Float, $Float) {
                (self.value.high, MAY_BE_ZERO * self.terms)
            }
        }

        /// The differences of two points of floats.
        #[inline(always)]
        fn differences([a, b, c]: [$Float; 3], [x, y, z]: [$Float; 3]) -> [Sum; 3] {
            [Sum::of_difference(a, x), Sum::of_difference(b, y), Sum::of_difference(c, z)]
        }

        #[inline(always)]
        fn minus_sums([a, b, c]: [Sum; 3], [x, y, z]: [Sum; 3]) -> [Sum; 3] {
            [a.minus(x), b.minus(y), c.minus(z)]
        }

        #[inline(never)]
        fn cross_of_sums([a, b, c]: [Sum; 3], [x, y, z]: [Sum; 3]) -> [Sum; 3] {
            [b.times(z).minus(c.times(y)), c.times(x).minus(a.times(z)), a.times(y).minus(b.times(x))]
        }

        #[inline(never)]
        fn dot_of_sums([a, b, c]: [Sum; 3], [x, y, z]: [Sum; 3]) -> Sum {
            a.times(x).plus(b.times(y)).plus(c.times(z))
        }

        /// The function `triangle` in double-word numbers.
        #[cold]
        #[inline(never)]
        pub(crate) fn triangle_doubled(
            line: &LocalLine<$Float>,
            vertices: [[$Float; 3]; 3],
        ) -> Attempt<($Float, bool)> {
            let ([o, d], [off, along_off]) = (double_words(line), line.low_words.off);
            let (o, d) = (o.map(|part| Sum::new(part, off)), d.map(|part| Sum::new(part, along_off)));
            let base = if line.is_relative { vertices[0] } else { [0.0; 3] };
            let [a, b, c] = vertices.map(|vertex| minus_sums(differences(vertex, base), o));
            let edge = |p, q| dot_of_sums(d, cross_of_sums(p, q));
            let edges = [edge(a, b), edge(b, c), edge(c, a)];
            if !edges.iter().all(|edge| is_handy::<2>(edge.terms)) {
                return Attempt::Unsure;
            }
            let from_front = found!(within_edges(edges.map(Sum::with_doubt)));
            let normal = cross_of_sums(differences(vertices[1], vertices[0]), differences(vertices[2], vertices[0]));
            let (facing, distance) = (dot_of_sums(normal, d), dot_of_sums(normal, a));
            let (n, n_terms) = (distance.value.high, distance.terms);
            let (cosine, cosine_terms) = (facing.value.high, facing.terms);
            if !(is_handy::<2>(n_terms) && is_handy::<2>(cosine_terms)) {
                return Attempt::Unsure;
            }
            // The error of t must be small against a rounding of the ray's t, and no product may underflow.
            let whole = $Float::abs(n * cosine + line.start * (cosine * cosine));
            let terms = n_terms * $Float::abs(cosine) + $Float::abs(n) * cosine_terms;
            let doubt = (32.0 * $Float::EPSILON) * terms;
            let is_clear = doubt >= $Float::MIN_POSITIVE && doubt <= whole;
            // The edges give the sign of the cosine too.
            if is_clear && (cosine < 0.0) == from_front {
                Attempt::Hit((n / cosine, from_front))
            } else {
                Attempt::Unsure
            }
        }
    };
}
