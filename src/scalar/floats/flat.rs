//! Planes, discs and triangles on the fast path of floats.

/// Defines them for a float.
macro_rules! flat {
    ($Float:ident) => {
        /// Where the line crosses each of the heights, and how much of that may be off because of a frame. A line that stays in one height
        /// meets none of them.
        #[inline(always)]
        pub(crate) fn crossings(
            line: LocalLine<$Float>,
            [low, high]: [$Float; 2],
        ) -> Attempt<([$Float; 2], [$Float; 2])> {
            let ([x, y, z], [_, dy, _]) = (line.origin, line.direction);
            if line.finer == 0 && dy == 0.0 {
                return Attempt::Miss;
            }
            // Divided, not multiplied by a reciprocal: then planes that lie in each other are crossed at the same `t`, whatever they belong to.
            let ends = [(low - y) / dy, (high - y) / dy];
            let is_finite = $Float::abs(ends[0]) < $Float::MAX && $Float::abs(ends[1]) < $Float::MAX;
            if !is_finite {
                return Attempt::Unsure;
            }
            let Limits { epsilon, .. } = Limits::of(&line);
            let length = $Float::abs(x) + $Float::abs(y) + $Float::abs(z);
            if line.is_compensated {
                // A rounding of each, and some units of twice the precision of the longest.
                if $Float::abs(dy) < 32.0 * epsilon {
                    return Attempt::Unsure;
                }
                let off = ($Float::abs(y) + 16.0 * epsilon * length) * epsilon / $Float::abs(dy);
                return Attempt::Found((ends, [off; 2]));
            }
            if line.finer == 0 {
                return Attempt::Found((ends, [0.0; 2]));
            }
            // Four roundings of the longest coordinate, and three of one.
            let each = (2.0 * epsilon) / $Float::abs(dy);
            let off = |t: $Float| (length + $Float::abs(t)) * each;
            Attempt::Found((ends, [off(ends[0]), off(ends[1])]))
        }

        /// Where the line crosses the disc of this radius about the origin in the plane `y = 0`.
        #[inline(always)]
        pub(crate) fn disc(line: LocalLine<$Float>, r: $Float) -> Attempt<$Float> {
            let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
            if !is_handy::<2>(r) || dy == 0.0 {
                return Attempt::Unsure;
            }
            let t = -y / dy;
            let (across, along) = (t * dx, t * dz);
            let (px, pz) = (x + across, z + along);
            let inside = r * r - (px * px + pz * pz);
            let Limits { epsilon, level, .. } = Limits::of(&line);
            // Each coordinate is off by at most three roundings of its terms.
            let length = if !is_turned(&line) {
                $Float::abs(x) + $Float::abs(z) + $Float::abs(across) + $Float::abs(along)
            } else {
                // So is the crossing, by as many units.
                let all = $Float::abs(x) + $Float::abs(y) + $Float::abs(z) + $Float::abs(t);
                if !(dy * dy >= level && $Float::abs(y) * 4.0 >= all) {
                    return Attempt::Unsure;
                }
                2.0 * all
            };
            let doubt = length * length * (16.0 * epsilon);
            if inside > doubt {
                Attempt::Found(t)
            } else if inside < -doubt {
                Attempt::Miss
            } else {
                Attempt::Unsure
            }
        }

        /// Whether the line's point at `t` lies below `y = 0`, between that and the height, or above.
        #[inline(always)]
        pub(crate) fn between_seams(line: LocalLine<$Float>, t: $Float, height: $Float) -> Attempt<Ordering> {
            let ([x, y, z], climb) = (line.origin, t * line.direction[1]);
            let all = $Float::abs(x) + $Float::abs(y) + $Float::abs(z) + $Float::abs(t);
            let Limits { epsilon, .. } = Limits::of(&line);
            let off = if is_turned(&line) {
                all * (4.0 * epsilon)
            } else if line.is_compensated {
                $Float::abs(y) * (2.0 * epsilon)
            } else {
                0.0
            };
            let (low, high) = (-y, height - y);
            if are_close(&line, climb, low, off) || are_close(&line, climb, high, off) {
                Attempt::Unsure
            } else if climb < low {
                Attempt::Found(Ordering::Less)
            } else if climb > high {
                Attempt::Found(Ordering::Greater)
            } else {
                Attempt::Found(Ordering::Equal)
            }
        }

        /// Whether a quotient of sums of three products of three factors is good to a few units of itself, or of what begins at the line's start.
        #[inline(always)]
        fn is_quotient_clear(line: &LocalLine<$Float>, n: $Float, d: $Float, n_terms: $Float, d_terms: $Float) -> bool {
            let whole = $Float::abs(n * d + line.start * (d * d));
            let (n, d) = ($Float::abs(n), $Float::abs(d));
            if !line.is_compensated {
                return d * FLAT_CANCELLED >= d_terms && n * FLAT_CANCELLED >= n_terms;
            }
            n_terms * d + n * d_terms <= (1.5 * FLAT_CANCELLED) * whole
        }

        /// Where the line crosses the triangle, and whether it comes from the front.
        #[inline(always)]
        pub(crate) fn triangle(line: LocalLine<$Float>, vertices: [[$Float; 3]; 3]) -> Attempt<($Float, bool)> {
            let (o, d) = (line.origin, line.direction);
            let [a, b, c] = [minus(vertices[0], o), minus(vertices[1], o), minus(vertices[2], o)];
            let size = |v: [$Float; 3]| $Float::abs(v[0]) + $Float::abs(v[1]) + $Float::abs(v[2]);
            // In a frame the origin is off by roundings of all of it, and the direction by those of one.
            let (own, one) = if is_turned(&line) {
                (4.0 * size(o), 1.0)
            } else if line.is_compensated {
                (size(o), 0.0)
            } else {
                (0.0, 0.0)
            };
            let sizes = [size(a) + own, size(b) + own, size(c) + own];
            // d . (p x q): the side on which the line passes the edge from p to q; off by at most seven roundings of its terms.
            let volumes = [dot(d, cross(a, b)), dot(d, cross(b, c)), dot(d, cross(c, a))];
            let terms = [sizes[0] * sizes[1], sizes[1] * sizes[2], sizes[2] * sizes[0]];
            if !(is_handy::<2>(terms[0]) && is_handy::<2>(terms[1]) && is_handy::<2>(terms[2])) {
                return Attempt::Unsure;
            }
            let Limits { epsilon, .. } = Limits::of(&line);
            let (mut left, mut right) = (0, 0);
            for (volume, terms) in core::iter::zip(volumes, terms) {
                let doubt = terms * (16.0 * epsilon);
                left += (volume > doubt) as u32;
                right += (volume < -doubt) as u32;
            }
            if left != 0 && right != 0 {
                return Attempt::Miss;
            }
            if left + right != 3 {
                return Attempt::Unsure;
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
                && is_quotient_clear(&line, distance, facing, distance_terms, facing_terms);
            if is_clear && (facing < 0.0) == from_front {
                Attempt::Found((distance / facing, from_front))
            } else {
                Attempt::Unsure
            }
        }
    };
}
