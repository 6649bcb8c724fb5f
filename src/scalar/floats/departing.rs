//! Lines that depart inwards from a surface, on the fast path of floats.

/// Defines the exit of such lines for a float.
macro_rules! departing {
    ($Float:ident) => {
        /// A line in the coordinates in which a quadric is `X^2 + s Y^2 + Z^2`.
        struct InQuadric {
            point: [$Float; 3],
            /// The magnitudes of the terms whose sums they are.
            terms: [$Float; 3],
            along: [$Float; 3],
            s: $Float,
            /// The largest ratio of these coordinates to those of the line.
            scale: $Float,
        }

        /// The other root of `a t^2 + 2 k t`, with `a` and `k`: the line begins in the quadric, whatever its rounded coordinates are.
        #[inline(always)]
        fn other_root(line: &LocalLine<$Float>, seen: InQuadric) -> Attempt<($Float, $Float, $Float)> {
            let InQuadric { point, terms, along, s, scale } = seen;
            let (squares, sizes) = (along.map(|d| d * d), magnitudes(along));
            let a = (squares[0] + squares[2]) + s * squares[1];
            let k = (point[0] * along[0] + point[2] * along[2]) + s * (point[1] * along[1]);
            // If the line's origin was moved to `start`, the roots are -start and another one; the sum of both is -2 k / a.
            let n = line.start * a - k;
            let off = if line.is_rounded { line.off } else { [0.0; 2] };
            // The errors of these, in units of the relative rounding error: three roundings of their terms, and the error of the line. (.6 times the
            // sum of a vector's components is about its length: the roundings do not all have the same sign.)
            let length = |v: [$Float; 3]| 0.6 * size(v);
            let a_off = 3.0 * size(squares) + 2.0 * scale * off[1] * length(sizes);
            let k_off = 3.0 * dot(terms, sizes) + scale * (off[0] * length(sizes) + off[1] * length(terms));
            let n_off = k_off + $Float::abs(line.start) * (a_off + $Float::abs(a));
            let (a_size, n_size) = ($Float::abs(a), $Float::abs(n));
            let is_clear = is_handy::<2>(a_size)
                && is_handy::<2>(n_size)
                && n_off * a_size + n_size * a_off <= 2.0 * Limits::of(line).moved * (n_size * a_size);
            if is_clear { Attempt::Hit((2.0 * n / a - line.start, a, k)) } else { Attempt::Unsure }
        }

        /// Where a line that begins in the surface of a ball about the origin, or of a cylinder about the y axis, leaves it.
        #[inline(always)]
        pub(crate) fn exit_from_round(line: &LocalLine<$Float>, is_ball: bool) -> Attempt<$Float> {
            let s = if is_ball { 1.0 } else { 0.0 };
            if line.is_doubled {
                let (t, ..) = found!(if is_ball {
                    ball_form(line, 0.0).other_root(line)
                } else {
                    tube_form(line, 0.0).other_root(line)
                });
                return if t > -line.start { Attempt::Hit(t) } else { Attempt::Unsure };
            }
            let [[x, y, z], [dx, dy, dz]] = [line.origin, line.direction];
            let (point, along) = ([x, s * y, z], [dx, s * dy, dz]);
            let seen = InQuadric { point, terms: magnitudes(point), along, s, scale: 1.0 };
            let (t, ..) = found!(other_root(line, seen));
            // An end before the start of the ray would be outside.
            if t > -line.start { Attempt::Hit(t) } else { Attempt::Unsure }
        }

        /// Where a line that begins in the side of [`nappe`] leaves that nappe; infinite if it does not.
        #[inline(always)]
        pub(crate) fn exit_from_nappe(line: &LocalLine<$Float>, [r, top, h]: [$Float; 3]) -> Attempt<$Float> {
            let [[x, y, z], [dx, dy, dz]] = [line.origin, line.direction];
            let (g0, g) = (r * h, top - r);
            let scale = $Float::abs(g) + h;
            if !is_handy::<8>(scale) || !is_handy::<8>(scale * size(line.origin) + g0) {
                return Attempt::Unsure;
            }
            let (point, along) = ([h * x, g0 + g * y, h * z], [h * dx, g * dy, h * dz]);
            let rim = g0 + $Float::abs(g * y);
            let terms = [$Float::abs(point[0]), rim, $Float::abs(point[2])];
            let (t, a, k) = found!(if line.is_doubled {
                cone_form(line, [r, top, h]).other_root(line)
            } else {
                other_root(line, InQuadric { point, terms, along, s: -1.0, scale })
            });
            let (outline, slope, is_ahead) = (point[1], along[1], t > -line.start);
            if a < 0.0 {
                // The line is steeper than the side: a half-line lies in each nappe, and that of this nappe has no end.
                return if !is_ahead && slope > 0.0 { Attempt::Hit($Float::INFINITY) } else { Attempt::Unsure };
            }
            // The outline halfway between the roots, where it is positive in this nappe.
            let middle = outline * a - slope * k;
            let doubt = (rim * a + $Float::abs(slope * k)) * (2.0 * Limits::of(line).doubt());
            if is_ahead && middle > doubt { Attempt::Hit(t) } else { Attempt::Unsure }
        }
    };
}
