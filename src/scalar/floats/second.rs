//! The local lines of the second attempt on the fast path of floats: with the origin moved next to the solid, computed by sums of twice the
//! precision.
//!
//! The error of each component is then one rounding of itself, in any frame and however far away the ray starts.

/// Defines these lines for a float.
macro_rules! second {
    ($Float:ident) => {
        /// A vector, and the low word of each component.
        type Compensated = [[$Float; 2]; 3];

        /// The line of a ray in world coordinates, with its origin moved next to `base`, and relative to it; `None` if it begins there.
        #[inline(never)]
        pub(crate) fn closer(o: [$Float; 3], d: [$Float; 3], base: [$Float; 3]) -> Option<LocalLine<$Float>> {
            let start = closest_along(minus(o, base), d, 0.0);
            if start == 0.0 {
                return None;
            }
            let direction = [[d[0], 0.0], [d[1], 0.0], [d[2], 0.0]];
            let origin = point(o, d, base, start);
            let off = [2.0 * ($Float::abs(start) + size(origin.map(|[high, _]| high))), 0.0];
            compensated(origin, direction, start, 0, off)
        }

        /// The line in the frame with these axes at `position`, with its origin moved next to the frame's point `base`, and relative to it.
        #[inline(never)]
        pub(crate) fn turned_again(
            o: [$Float; 3],
            d: [$Float; 3],
            position: [$Float; 3],
            axes: [[$Float; 3]; 3],
            base: [$Float; 3],
            near: $Float,
        ) -> Option<LocalLine<$Float>> {
            let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = axes;
            let [x, y, z] = base;
            let target = [x * ax + y * bx + z * cx, x * ay + y * by + z * cy, x * az + y * bz + z * cz];
            let start = closest_along(minus(minus(o, position), target), d, near);
            let from = point(o, d, position, start);
            let seen = [dot_with_rest(axes[0], from), dot_with_rest(axes[1], from), dot_with_rest(axes[2], from)];
            let direction = [dot_compensated(axes[0], d), dot_compensated(axes[1], d), dot_compensated(axes[2], d)];
            // Terms of the coordinates seen from `position`, and of the components.
            let terms = $Float::abs(start) + size(from.map(|[high, _]| high)) + size(base);
            compensated(relative(seen, base), direction, start, 1, [4.0 * terms, 4.0])
        }

        /// The line in the frame of a matrix at `position` whose inverse has these rows, with its origin moved next to the frame's point `base`, and
        /// relative to it; `None` if the powers of two are beyond the type.
        #[inline(never)]
        pub(crate) fn stretched_again(
            o: [$Float; 3],
            d: [$Float; 3],
            position: [$Float; 3],
            rows: [([$Float; 3], i32); 3],
            base: [$Float; 3],
            near: $Float,
        ) -> Option<LocalLine<$Float>> {
            let scales = scales(rows)?;
            let each = |i: usize| dot_compensated(rows[i].0, d).map(|part| part * scales[i]);
            let seen = [each(0), each(1), each(2)];
            let direction = seen.map(|[high, _]| high);
            let from = minus(o, position);
            let each = |i: usize| dot(rows[i].0, from) * scales[i];
            let start = closest_along(minus([each(0), each(1), each(2)], base), direction, near);
            let from = point(o, d, position, start);
            let each = |i: usize| dot_with_rest(rows[i].0, from).map(|part| part * scales[i]);
            let origin = relative([each(0), each(1), each(2)], base);
            let longest = $Float::abs(direction[0]).max($Float::abs(direction[1])).max($Float::abs(direction[2]));
            if !is_handy::<2>(longest) {
                return None;
            }
            // A power of two, which rounds nothing.
            let inverse_length = near_one(longest);
            let terms = |v: [$Float; 3]| {
                let each = |i: usize| dot(magnitudes(rows[i].0), v) * scales[i];
                each(0).max(each(1)).max(each(2))
            };
            let d_terms = terms(magnitudes(d));
            let from_terms = terms(magnitudes(from.map(|[high, _]| high)));
            let off = [4.0 * ($Float::abs(start) * d_terms + from_terms + size(base)), 4.0 * d_terms * inverse_length];
            let direction = seen.map(|parts| parts.map(|part| part * inverse_length));
            let line = compensated(origin, direction, start / inverse_length, 1, off)?;
            Some(LocalLine { inverse_length, ..line })
        }

        /// [`closest`] along a direction of any length; zero also if that point is nearer to the start than `near`.
        #[inline(always)]
        fn closest_along(from: [$Float; 3], d: [$Float; 3], near: $Float) -> $Float {
            let square = dot(d, d);
            let k = dot(from, d) / square;
            let p = [from[0] - k * d[0], from[1] - k * d[1], from[2] - k * d[2]];
            let (along, across) = (k * k * square, dot(p, p));
            if along > 16.0 * across && along > near * near { -k } else { 0.0 }
        }

        /// The line's point at `t` relative to `base`.
        #[inline(always)]
        fn point(o: [$Float; 3], d: [$Float; 3], base: [$Float; 3], t: $Float) -> Compensated {
            let component = |i: usize| {
                let [from, e] = o[i].plus_with_rest(-base[i]);
                if t == 0.0 {
                    return [from, e];
                }
                let [step, f] = t.times_with_rest(d[i]);
                let [sum, g] = from.plus_with_rest(step);
                sum.plus_with_rest(e + f + g)
            };
            [component(0), component(1), component(2)]
        }

        #[inline(always)]
        fn relative(v: Compensated, base: [$Float; 3]) -> Compensated {
            let component = |i: usize| {
                if base[i] == 0.0 {
                    return v[i];
                }
                let [from, rest] = v[i][0].plus_with_rest(-base[i]);
                from.plus_with_rest(rest + v[i][1])
            };
            [component(0), component(1), component(2)]
        }

        /// The sum of the products as a rounded value and a low word (Ogita, Rump and Oishi, *Accurate sum and dot product*, 2005,
        /// algorithm 5.3).
        #[inline(always)]
        fn sum_and_rest(a: [$Float; 3], b: [$Float; 3]) -> [$Float; 2] {
            let ([x, e], [y, f], [z, g]) =
                (a[0].times_with_rest(b[0]), a[1].times_with_rest(b[1]), a[2].times_with_rest(b[2]));
            let [sum, h] = x.plus_with_rest(y);
            let [sum, i] = sum.plus_with_rest(z);
            [sum, e + f + g + (h + i)]
        }

        #[inline(always)]
        fn dot_compensated(a: [$Float; 3], b: [$Float; 3]) -> [$Float; 2] {
            let [sum, rest] = sum_and_rest(a, b);
            sum.plus_with_rest(rest)
        }

        #[inline(always)]
        fn dot_with_rest(row: [$Float; 3], v: Compensated) -> [$Float; 2] {
            let ([x, y, z], [a, b, c]) = (row, v.map(|[_, low]| low));
            let [sum, rest] = sum_and_rest(row, v.map(|[high, _]| high));
            sum.plus_with_rest(rest + (x * a + y * b + z * c))
        }

        #[inline(always)]
        fn compensated(
            origin: Compensated,
            direction: Compensated,
            start: $Float,
            extra_bits: i32,
            off: [$Float; 2],
        ) -> Option<LocalLine<$Float>> {
            let part = |of: Compensated, i: usize| [of[0][i], of[1][i], of[2][i]];
            let along = LocalLine::along(part(origin, 0), part(direction, 0), 0.0);
            let low_words = LowWords { origin: part(origin, 1), direction: part(direction, 1), off };
            let line = LocalLine { low_words, start, extra_bits, is_relative: true, is_rounded: true, ..along };
            // If something has overflowed, a low word is NaN.
            let is_finite = line.low_words.origin.iter().chain(&line.direction).all(|part| part.is_finite());
            (is_finite && start.is_finite()).then_some(line)
        }
    };
}
