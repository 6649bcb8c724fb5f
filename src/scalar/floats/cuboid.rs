//! Cuboids on the fast path of floats.

/// Defines them for a float.
macro_rules! cuboid {
    ($Float:ident) => {
        /// Where a line crosses the plane of a face: at `t`, from `o` along `d`, on the axis that the plane lies across.
        #[derive(Clone, Copy)]
        struct Crossing {
            t: $Float,
            axis: usize,
            o: $Float,
            d: $Float,
            half: $Float,
        }

        impl Crossing {
            #[inline(always)]
            const fn none(t: $Float) -> Self {
                Self { t, axis: 0, o: 0.0, d: 0.0, half: 0.0 }
            }
        }

        /// The interval of the line inside the cuboid with these half extents about the origin. Of the planes by which the line enters a slab the last
        /// is that of its entry, if the point there lies in the other two slabs; otherwise it misses.
        #[inline(always)]
        pub(crate) fn cuboid(line: &LocalLine<$Float>, half: [$Float; 3]) -> Attempt<InCuboid<$Float>> {
            if line.is_doubled || !(is_handy::<2>(half[0]) && is_handy::<2>(half[1]) && is_handy::<2>(half[2])) {
                return Attempt::Unsure;
            }
            let least = least_climb(line);
            let mut enter = Crossing::none(-$Float::INFINITY);
            for axis in 0..3 {
                let (o, d, h) = (line.origin[axis], line.direction[axis], half[axis]);
                if $Float::abs(d) <= least {
                    // Only in the world is it known on which side of the planes such a line lies; in the plane of a face, that owns the ends.
                    if line.is_rounded || $Float::abs(o) == h {
                        return Attempt::Unsure;
                    }
                    if $Float::abs(o) > h {
                        return Attempt::Miss;
                    }
                    continue;
                }
                let t = (if d < 0.0 { h } else { -h } - o) / d;
                if t > enter.t {
                    enter = Crossing { t, axis, o, d, half: h };
                }
            }
            found!(in_face(line, half, enter));
            if line.since.is_some_and(|since| enter.t >= since) {
                return Attempt::Found(InCuboid { ends: [enter.t, $Float::INFINITY], axes: [enter.axis; 2] });
            }
            let (t, axis) = found!(exit_from_cuboid(line, half));
            if enter.t >= t {
                return Attempt::Unsure;
            }
            Attempt::Found(InCuboid { ends: [enter.t, t], axes: [enter.axis, axis] })
        }

        /// Where the line leaves the cuboid that it has been in: by the first of the planes by which it leaves a slab.
        #[inline(always)]
        pub(crate) fn exit_from_cuboid(line: &LocalLine<$Float>, half: [$Float; 3]) -> Attempt<($Float, usize)> {
            let (mut exit, least) = (Crossing::none($Float::INFINITY), least_climb(line));
            if line.is_doubled {
                return Attempt::Unsure;
            }
            for axis in 0..3 {
                let (o, d, h) = (line.origin[axis], line.direction[axis], half[axis]);
                let t = (if d < 0.0 { -h } else { h } - o) / d;
                if $Float::abs(d) <= least {
                    // In the plane of a face, which owns the end.
                    if line.is_rounded || $Float::abs(o) >= h {
                        return Attempt::Unsure;
                    }
                } else if t < exit.t {
                    exit = Crossing { t, axis, o, d, half: h };
                }
            }
            match in_face(line, half, exit) {
                Attempt::Found(()) => Attempt::Found((exit.t, exit.axis)),
                _ => Attempt::Unsure,
            }
        }

        /// The component of a direction that is certain not to be zero, or of the other sign, if it is larger.
        #[inline(always)]
        fn least_climb(line: &LocalLine<$Float>) -> $Float {
            if line.is_rounded { 32.0 * Limits::of(line).epsilon } else { 0.0 }
        }

        /// Whether the line crosses the plane of a face inside that face, and how far along is accurate enough.
        #[inline(always)]
        fn in_face(line: &LocalLine<$Float>, half: [$Float; 3], crossing: Crossing) -> Attempt<()> {
            let Crossing { t, axis, o, d, half: h } = crossing;
            let is_finite = $Float::abs(t) < $Float::MAX;
            if !is_finite {
                return Attempt::Unsure;
            }
            let Limits { epsilon, .. } = Limits::of(line);
            // What a rounding of each coordinate of the origin, and the line's own error, make of the crossing.
            let (own, climb) = ($Float::abs(o), $Float::abs(d));
            let off = if line.is_rounded { (own + h + off_at(line, t)) / climb } else { 0.0 };
            // As for a rectangle: three roundings of the terms, and what the line is off along the plane.
            let beyond = |other: usize| {
                let (o, step, h) = (line.origin[other], t * line.direction[other], half[other]);
                let doubt = ($Float::abs(o) + $Float::abs(step) + h + off) * (8.0 * epsilon);
                ($Float::abs(o + step) - h, doubt)
            };
            let [first, second] = match axis {
                0 => [beyond(1), beyond(2)],
                1 => [beyond(0), beyond(2)],
                _ => [beyond(0), beyond(1)],
            };
            if first.0 > first.1 || second.0 > second.1 {
                return Attempt::Miss;
            }
            let is_good = !line.is_rounded || {
                let own = own + 16.0 * epsilon * size(line.origin);
                is_good(line, t, (own + off_at(line, t)) * epsilon / climb)
            };
            if first.0 < -first.1 && second.0 < -second.1 && is_good { Attempt::Found(()) } else { Attempt::Unsure }
        }
    };
}
