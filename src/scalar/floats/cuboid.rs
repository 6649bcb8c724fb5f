//! Cuboids on the fast path of floats.

/// Defines the intersection with cuboids for a float.
macro_rules! cuboid {
    ($Float:ident) => {
        /// The interval of the line inside the cuboid with these half extents about the origin. The line enters the cuboid by the last of the planes
        /// by which it enters a slab, if the point there lies in the other two slabs; otherwise it misses.
        #[inline(always)]
        pub(crate) fn cuboid(line: &LocalLine<$Float>, half: [$Float; 3]) -> Attempt<InCuboid<$Float>> {
            if !is_clear_of_planes(line, half) {
                return Attempt::Unsure;
            }
            let [x, y, z] = crossed(line, half.map(|h| -h));
            let (enter, first) = if y > x { (y, 1) } else { (x, 0) };
            let (enter, first) = if z > enter { (z, 2) } else { (enter, first) };
            found!(in_face(line, half, enter, first));
            let entry_alone = Attempt::Hit(InCuboid { ends: [enter, $Float::INFINITY], axes: [first; 2] });
            if line.needs_only(enter) {
                return entry_alone;
            }
            match exit_from_cuboid(line, half) {
                Attempt::Hit((exit, last)) if enter < exit => {
                    Attempt::Hit(InCuboid { ends: [enter, exit], axes: [first, last] })
                }
                _ => entry_alone,
            }
        }

        /// Where the line leaves the cuboid: by the first of the planes by which it leaves a slab.
        #[inline(always)]
        pub(crate) fn exit_from_cuboid(line: &LocalLine<$Float>, half: [$Float; 3]) -> Attempt<($Float, usize)> {
            if !is_clear_of_planes(line, half) {
                return Attempt::Unsure;
            }
            let [x, y, z] = crossed(line, half);
            let (exit, last) = if y < x { (y, 1) } else { (x, 0) };
            let (exit, last) = if z < exit { (z, 2) } else { (exit, last) };
            match in_face(line, half, exit, last) {
                Attempt::Hit(()) => Attempt::Hit((exit, last)),
                _ => Attempt::Unsure,
            }
        }

        /// Whether the sizes neither overflow nor underflow in this computation, and rounding cannot have changed the sign of a component of the
        /// direction, or that sign does not matter: the line stays between these planes as far as it comes near the cuboid.
        #[inline(always)]
        fn is_clear_of_planes(line: &LocalLine<$Float>, half: [$Float; 3]) -> bool {
            let least = 32.0 * Limits::of(line).epsilon;
            let may_turn = |axis: usize| {
                $Float::abs(line.direction[axis]) <= least && $Float::abs(line.origin[axis]) > 0.875 * half[axis]
            };
            // There are no formulas in double-word numbers; but an end next to the ray's start may be accurate if the line's origin is moved back there.
            let is_new = !line.is_doubled || line.start == 0.0;
            is_new
                && is_handy::<2>(half[0])
                && is_handy::<2>(half[1])
                && is_handy::<2>(half[2])
                && !(line.is_rounded && (may_turn(0) || may_turn(1) || may_turn(2)))
        }

        /// Where the line crosses one of the two planes perpendicular to each axis: the farther one for half extents, the nearer one for their
        /// negatives. For a line parallel to the planes that is infinity if the line lies between them, and NaN if it lies in one of them.
        #[inline(always)]
        fn crossed(line: &LocalLine<$Float>, half: [$Float; 3]) -> [$Float; 3] {
            let along = |axis: usize| {
                let (o, d, h) = (line.origin[axis], line.direction[axis], half[axis]);
                (if d.is_sign_negative() { -h } else { h } - o) / d
            };
            [along(0), along(1), along(2)]
        }

        /// Whether the line crosses the plane of a face, which is perpendicular to this axis, inside that face; and whether `t` is accurate enough.
        #[inline(always)]
        fn in_face(line: &LocalLine<$Float>, half: [$Float; 3], t: $Float, axis: usize) -> Attempt<()> {
            let Limits { epsilon, .. } = Limits::of(line);
            let is_finite = $Float::abs(t) < $Float::MAX;
            if !is_finite {
                let is_beyond =
                    |axis: usize| line.direction[axis] == 0.0 && $Float::abs(line.origin[axis]) > half[axis];
                let misses = !line.is_rounded && (is_beyond(0) || is_beyond(1) || is_beyond(2));
                return if misses { Attempt::Miss } else { Attempt::Unsure };
            }
            // The error of the crossing from a rounding of each coordinate of the origin, and from the line's own error.
            let (mut off, mut is_accurate) = (0.0, true);
            if line.is_rounded {
                let of_axis = |v: [$Float; 3]| match axis {
                    0 => v[0],
                    1 => v[1],
                    _ => v[2],
                };
                let (own, climb) = ($Float::abs(of_axis(line.origin)), $Float::abs(of_axis(line.direction)));
                is_accurate = is_good(line, t, crossing_off(line, own, climb, t));
                off = (own + of_axis(half) + off_at(line, t)) / climb;
            }
            // The same error as for a rectangle: three roundings of the terms, and the line's error along the plane.
            let beyond = |[o, d, h]: [$Float; 3]| {
                let step = t * d;
                let doubt = ($Float::abs(o) + $Float::abs(step) + h + off) * (8.0 * epsilon);
                ($Float::abs(o + step) - h, doubt)
            };
            let along = |axis: usize| [line.origin[axis], line.direction[axis], half[axis]];
            let (beyond_first, doubt_first) = beyond(if axis == 0 { along(1) } else { along(0) });
            let (beyond_second, doubt_second) = beyond(if axis == 2 { along(1) } else { along(2) });
            let is_outside = beyond_first > doubt_first || beyond_second > doubt_second;
            let is_inside = beyond_first < -doubt_first && beyond_second < -doubt_second;
            if is_outside {
                Attempt::Miss
            } else if is_inside && is_accurate {
                Attempt::Hit(())
            } else {
                Attempt::Unsure
            }
        }
    };
}
