//! Planes, discs, rectangles and triangles on the fast path of floats.

/// Defines the intersection with flat primitives for a float.
macro_rules! flat {
    ($Float:ident) => {
        /// Where the line crosses each of the heights, and the error of that due to a frame. A line of constant height crosses none of them.
        #[inline(always)]
        pub(crate) fn crossings(
            line: LocalLine<$Float>,
            [low, high]: [$Float; 2],
        ) -> Attempt<([$Float; 2], [$Float; 2])> {
            let ([_, y, _], [_, dy, _]) = (line.origin, line.direction);
            if line.extra_bits == 0 && dy == 0.0 {
                return Attempt::Miss;
            }
            if line.is_doubled {
                return crossings_doubled(&line, [low, high]);
            }
            // Division, not multiplication by a reciprocal: then coplanar planes of different primitives are crossed at the same `t`.
            let ends = [(low - y) / dy, (high - y) / dy];
            let is_finite = $Float::abs(ends[0]) < $Float::MAX && $Float::abs(ends[1]) < $Float::MAX;
            if !is_finite {
                return Attempt::Unsure;
            }
            if !line.is_rounded {
                return Attempt::Hit((ends, [0.0; 2]));
            }
            let Limits { epsilon, .. } = Limits::of(&line);
            if $Float::abs(dy) < 32.0 * epsilon {
                return Attempt::Unsure;
            }
            let off = |t: $Float| crossing_off(&line, y, $Float::abs(dy), t);
            Attempt::Hit((ends, [off(ends[0]), off(ends[1])]))
        }

        /// Whether the crossing of the plane `y = 0` at `t` is accurate enough.
        #[inline(always)]
        fn is_crossing_good(line: &LocalLine<$Float>, climb: $Float, t: $Float) -> bool {
            is_steady(line, t, 1.0, climb, 0.0)
                && (!line.is_rounded || is_good(line, t, crossing_off(line, line.origin[1], climb, t)))
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
            let dy = $Float::abs(dy);
            if !is_crossing_good(&line, dy, t) {
                return Attempt::Unsure;
            }
            let Limits { epsilon, .. } = Limits::of(&line);
            // The error of each coordinate is at most three roundings of its terms, and the line's error along the plane.
            let length = $Float::abs(x) + $Float::abs(z) + $Float::abs(across) + $Float::abs(along);
            let off = off_at(&line, t) / dy;
            let moved = off * (4.0 * epsilon);
            let doubt = length * (length + off) * (16.0 * epsilon) + moved * moved;
            if inside > doubt {
                Attempt::Hit(t)
            } else if inside < -doubt {
                Attempt::Miss
            } else {
                Attempt::Unsure
            }
        }

        /// Where the line crosses the rectangle with these half extents about the origin in the plane `y = 0`.
        #[inline(always)]
        pub(crate) fn rectangle(line: LocalLine<$Float>, [hx, hz]: [$Float; 2]) -> Attempt<$Float> {
            let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
            if !(is_handy::<2>(hx) && is_handy::<2>(hz)) || dy == 0.0 {
                return Attempt::Unsure;
            }
            let t = -y / dy;
            let (across, along) = (t * dx, t * dz);
            let dy = $Float::abs(dy);
            if !is_crossing_good(&line, dy, t) {
                return Attempt::Unsure;
            }
            let Limits { epsilon, .. } = Limits::of(&line);
            // The same error as for a disc: three roundings of the terms, and the line's error along the plane.
            let off = off_at(&line, t) / dy;
            let beyond = |o: $Float, step: $Float, h: $Float| {
                let doubt = ($Float::abs(o) + $Float::abs(step) + h + off) * (8.0 * epsilon);
                ($Float::abs(o + step) - h, doubt)
            };
            let ((beyond_x, doubt_x), (beyond_z, doubt_z)) = (beyond(x, across, hx), beyond(z, along, hz));
            if beyond_x > doubt_x || beyond_z > doubt_z {
                Attempt::Miss
            } else if beyond_x < -doubt_x && beyond_z < -doubt_z {
                Attempt::Hit(t)
            } else {
                Attempt::Unsure
            }
        }

        /// Whether the line's point at `t` lies below `y = 0`, between that and the height, or above.
        #[inline(always)]
        pub(crate) fn between_seams(line: LocalLine<$Float>, t: $Float, height: $Float) -> Attempt<Ordering> {
            let ([_, y, _], climb) = (line.origin, t * line.direction[1]);
            let Limits { epsilon, .. } = Limits::of(&line);
            let off = if line.is_rounded { ($Float::abs(y) + off_at(&line, t)) * (2.0 * epsilon) } else { 0.0 };
            let (low, high) = (-y, height - y);
            if are_close(&line, climb, low, off) || are_close(&line, climb, high, off) {
                Attempt::Unsure
            } else if climb < low {
                Attempt::Hit(Ordering::Less)
            } else if climb > high {
                Attempt::Hit(Ordering::Greater)
            } else {
                Attempt::Hit(Ordering::Equal)
            }
        }

        /// Whether a quotient of sums of three products of three factors is accurate to a few units in its last place, or in that of the `t` from the
        /// ray's start.
        #[inline(always)]
        fn is_quotient_clear(line: &LocalLine<$Float>, n: $Float, d: $Float, n_terms: $Float, d_terms: $Float) -> bool {
            let whole = $Float::abs(n * d + line.start * (d * d));
            let (n, d) = ($Float::abs(n), $Float::abs(d));
            if !line.is_rounded {
                return d * FLAT_CANCELLED >= d_terms && n * FLAT_CANCELLED >= n_terms;
            }
            n_terms * d + n * d_terms <= (1.5 * FLAT_CANCELLED) * whole
        }

        /// Where the line crosses the triangle, and whether it comes from the front.
        #[inline(always)]
        pub(crate) fn triangle(line: LocalLine<$Float>, vertices: [[$Float; 3]; 3]) -> Attempt<($Float, bool)> {
            let (o, d) = (line.origin, line.direction);
            let [a, b, c] = [minus(vertices[0], o), minus(vertices[1], o), minus(vertices[2], o)];
            // From differences of the vertices themselves, which are close together however far away the ray starts.
            let (u, v) = (minus(vertices[1], vertices[0]), minus(vertices[2], vertices[0]));
            // d . (p x q): the side on which the line passes each edge, from p to q; and, for the edges from the first vertex, the cosine of the line
            // and the triangle's normal u x v, times its length. Side by side, which processors with vectors compute at once.
            let (p, q) = ([a, b, c, u], [b, c, a, v]);
            let of_each = |f: fn([$Float; 3], [$Float; 3]) -> $Float| {
                [f(p[0], q[0]), f(p[1], q[1]), f(p[2], q[2]), f(p[3], q[3])]
            };
            let x = of_each(|p, q| p[1] * q[2] - p[2] * q[1]);
            let y = of_each(|p, q| p[2] * q[0] - p[0] * q[2]);
            let z = of_each(|p, q| p[0] * q[1] - p[1] * q[0]);
            let volume = |i: usize| d[0] * x[i] + d[1] * y[i] + d[2] * z[i];
            let volumes = [volume(0), volume(1), volume(2), volume(3)];
            let from_front = match is_within(&volumes, edge_doubt(&line, [a, b, c])) {
                Attempt::Hit(from_front) => from_front,
                Attempt::Miss => return Attempt::Miss,
                Attempt::Unsure => found!(is_closely_within(&line, [a, b, c], [volumes[0], volumes[1], volumes[2]])),
            };
            let normal = [x[3], y[3], z[3]];
            let (facing, distance) = (volumes[3], dot(normal, a));
            // The error of a rounded origin is a rounding of itself.
            let own = if line.is_rounded { size(o) } else { 0.0 };
            let (u, v) = (magnitudes(u), magnitudes(v));
            let terms = [u[1] * v[2] + u[2] * v[1], u[2] * v[0] + u[0] * v[2], u[0] * v[1] + u[1] * v[0]];
            let most = |v: [$Float; 3], least: $Float| v.map(|c| if c > least { c } else { least });
            let (d_sizes, a_sizes) = (magnitudes(d), most(magnitudes(a), own));
            let (facing_terms, distance_terms) = (dot(terms, d_sizes), dot(terms, a_sizes));
            let is_clear = is_handy::<2>(facing_terms)
                && is_handy::<2>(distance_terms)
                && is_quotient_clear(&line, distance, facing, distance_terms, facing_terms);
            let t = distance / facing;
            let is_clear = is_clear && is_steady(&line, t, size(normal), $Float::abs(facing), 0.0);
            if is_clear && (facing < 0.0) == from_front { Attempt::Hit((t, from_front)) } else { Attempt::Unsure }
        }

        /// The result of [`within_edges`] for edges with one error bound: of the first three volumes.
        #[inline(always)]
        fn is_within(&[a, b, c, _]: &[$Float; 4], doubt: $Float) -> Attempt<bool> {
            let (low, high) = if a < b { (a, b) } else { (b, a) };
            let (least, most) = (if c < low { c } else { low }, if c > high { c } else { high });
            if least < -doubt && most > doubt {
                Attempt::Miss
            } else if least > doubt || most < -doubt {
                Attempt::Hit(most < 0.0)
            } else {
                Attempt::Unsure
            }
        }

        /// A bound on the error of each d . (p x q) of two of these vectors. Seven roundings of its terms are less than 5 eps |p| |q|, and a change
        /// of p and q by `off` eps changes it by off eps (|p| + |q|). Both are less than a few times the sum of the squares.
        #[inline(always)]
        fn edge_doubt(line: &LocalLine<$Float>, vectors: [[$Float; 3]; 3]) -> $Float {
            let Limits { epsilon, .. } = Limits::of(line);
            let squares = dot(vectors[0], vectors[0]) + dot(vectors[1], vectors[1]) + dot(vectors[2], vectors[2]);
            let doubt = if line.is_rounded {
                // The change of p and q is a rounding of the origin, off[0], and off[1] times their length.
                let (o, [off, along_off]) = (line.origin, line.off);
                (4.0 + 2.0 * along_off) * squares + dot(o, o) + off * off
            } else {
                squares
            };
            if is_handy::<2>(doubt) { doubt * (8.0 * epsilon) } else { $Float::INFINITY }
        }

        /// The result of [`within_edges`] with an error bound for each edge, for lines next to an edge.
        #[cold]
        #[inline(never)]
        fn is_closely_within(
            line: &LocalLine<$Float>,
            [a, b, c]: [[$Float; 3]; 3],
            volumes: [$Float; 3],
        ) -> Attempt<bool> {
            // The error of a rounded origin is a rounding of itself.
            let own = if line.is_rounded { size(line.origin) } else { 0.0 };
            let sizes = [size(a) + own, size(b) + own, size(c) + own];
            let terms = [sizes[0] * sizes[1], sizes[1] * sizes[2], sizes[2] * sizes[0]];
            if !(is_handy::<2>(terms[0]) && is_handy::<2>(terms[1]) && is_handy::<2>(terms[2])) {
                return Attempt::Unsure;
            }
            let Limits { epsilon, .. } = Limits::of(line);
            // The line's error acts on each of its two vertices; a volume's error is at most seven roundings of its terms.
            let off = off_at(line, sizes[0]) * (sizes[0] + sizes[1] + sizes[2]);
            let edge = |i: usize| (volumes[i], (terms[i] + off) * (16.0 * epsilon));
            within_edges([edge(0), edge(1), edge(2)])
        }
    };
}
