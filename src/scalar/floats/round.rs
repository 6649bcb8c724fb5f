//! Spheres and cylinders on the fast path of floats.

/// Defines the intersection with spheres and cylinders for a float.
macro_rules! round {
    ($Float:ident, sqrt: $sqrt:path) => {
        /// `k = o . d` and `D = r^2 - |o - k d|^2`; a miss if `D < 0`.
        #[inline(always)]
        pub(crate) fn closest_approach(line: LocalLine<$Float>, r: $Float) -> Attempt<($Float, $Float)> {
            if !is_handy::<2>(r) {
                return Attempt::Unsure;
            }
            let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
            let k = dot(line.origin, line.direction);
            let p = [x - k * dx, y - k * dy, z - k * dz];
            // If this overflows, the line is far away from the ball: a miss.
            let pp = dot(p, p);
            let rr = r * r;
            if pp > rr { Attempt::Miss } else { Attempt::Hit((k, rr - pp)) }
        }

        /// `k` and `D` of a closest approach, if both are accurate to a few units in the last place; and `c`, if `-k -+ sqrt(D)` are not.
        #[inline(always)]
        fn clear_approach(line: LocalLine<$Float>, r: $Float) -> Attempt<($Float, $Float, Option<$Float>)> {
            if !is_handy::<2>(r) {
                return Attempt::Unsure;
            }
            let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
            let limits = Limits::of(&line);
            let (along, mut a) = (dot(line.origin, line.direction), dot(line.direction, line.direction));
            if !is_strict(&line) {
                // The formula assumes a direction of length 1; one that was given by its components may have another.
                if $Float::abs(a - 1.0) > 4.0 * $Float::EPSILON {
                    return Attempt::Unsure;
                }
                a = 1.0;
            }
            let k = along / a;
            let p = [x - k * dx, y - k * dy, z - k * dz];
            let (rr, kk) = (r * r, k * along);
            let pp = dot(p, p);
            let discriminant = rr - pp;
            // Not the negated comparisons: a value that has overflowed must fail.
            if !(kk <= rr * FAR_SQUARE && 2.0 * discriminant * limits.cancelled >= rr) {
                let off = off_at(&line, k);
                let doubt = limits.of_distance(pp, rr, kk + off * off);
                if discriminant < -doubt {
                    return Attempt::Miss;
                }
                // If the line's origin was moved next to the sphere, only the sign must be certain: below, errors are compared with `start`.
                if !(line.start != 0.0 && discriminant > doubt) {
                    return Attempt::Unsure;
                }
            }
            let mut moved = rr * rr;
            if line.is_rounded {
                moved += rr * (kk + pp);
            }
            if line.start != 0.0 {
                let is_clear = is_clear_of_start(line.start, kk, discriminant, moved, limits.near);
                return if is_clear { Attempt::Hit((k, discriminant / a, None)) } else { Attempt::Unsure };
            }
            if are_clear_of_the_start(kk, discriminant, moved, limits.near) {
                return Attempt::Hit((k, discriminant / a, None));
            }
            if line.off[0] != 0.0 || is_strict(&line) {
                return Attempt::Unsure;
            }
            // Next to the surface the nearer end is c over the farther one. c = |o|^2 - r^2 cancels, and is therefore compensated.
            let c = Real::sum_of_products([[x, x], [y, y], [z, z], [-r, r]])
                + 2.0 * dot(line.origin, line.low_words.origin);
            let is_known = $Float::abs(c) * 4096.0 >= rr && is_handy::<4>(r);
            // The farther end is at least sqrt(k^2 + D) away.
            let is_known = is_known && moved <= limits.near * discriminant * (kk + discriminant);
            if is_known { Attempt::Hit((k, discriminant, Some(c))) } else { Attempt::Unsure }
        }

        /// Whether both ends `-k -+ sqrt(D)` are large relative to their error, which is some `eps` times the root of `moved`, over `sqrt(D)`. The
        /// smaller end is `|k^2 - D| / (|k| + sqrt(D))`, and the square of that sum at most `2 (k^2 + D)`.
        #[inline(always)]
        fn are_clear_of_the_start(kk: $Float, discriminant: $Float, moved: $Float, near: $Float) -> bool {
            let c = kk - discriminant;
            let most = near * (c * c) * discriminant;
            if IN_RANGE.contains(&most) {
                moved * (kk + discriminant) <= most
            } else {
                is_clear_near_one(kk, discriminant, moved, near)
            }
        }

        /// Whether the errors of the ends of a line whose origin was moved to `start` are small relative to `start`, as for
        /// [`are_clear_of_the_start`].
        #[inline(always)]
        fn is_clear_of_start(start: $Float, kk: $Float, discriminant: $Float, moved: $Float, near: $Float) -> bool {
            let most = near * discriminant * (start * start);
            IN_RANGE.contains(&most) && moved + kk * discriminant <= most
        }

        /// Values that have neither overflowed nor underflowed, so that comparisons are meaningful.
        const IN_RANGE: core::ops::Range<$Float> = $Float::MIN_POSITIVE / $Float::EPSILON..$Float::MAX;

        /// The comparison of [`are_clear_of_the_start`] with lengths brought near 1.
        #[cold]
        fn is_clear_near_one(kk: $Float, discriminant: $Float, moved: $Float, near: $Float) -> bool {
            let scale = near_one(discriminant);
            let (kk, discriminant, scaled) = (kk * scale, discriminant * scale, moved * scale * scale);
            let c = kk - discriminant;
            let most = near * (c * c) * discriminant;
            moved >= $Float::MIN_POSITIVE && IN_RANGE.contains(&most) && scaled * (kk + discriminant) <= most
        }

        /// The two ends of the line inside the ball.
        #[inline(always)]
        pub(crate) fn ball(line: LocalLine<$Float>, r: $Float) -> Attempt<[$Float; 2]> {
            match clear_approach(line, r) {
                Attempt::Hit((k, discriminant, c)) => {
                    let root = $sqrt(discriminant);
                    let ends = match c {
                        None => [-k - root, root - k],
                        Some(c) if k > 0.0 => [-k - root, c / (-k - root)],
                        Some(c) => [c / (root - k), root - k],
                    };
                    if is_steady(&line, ends[0], r, root, 1.0) && is_steady(&line, ends[1], r, root, 1.0) {
                        Attempt::Hit(ends)
                    } else {
                        Attempt::Unsure
                    }
                }
                Attempt::Miss => Attempt::Miss,
                Attempt::Unsure => Attempt::Unsure,
            }
        }

        /// Whether the line has an end on the ball's surface at `t >= 0`; the same result as that of [`ball`].
        #[inline(always)]
        pub(crate) fn ball_ahead(line: LocalLine<$Float>, r: $Float) -> Attempt<()> {
            if line.off[0] != 0.0 {
                let [_, far] = found!(ball(line, r));
                return if far >= 0.0 { Attempt::Hit(()) } else { Attempt::Miss };
            }
            match clear_approach(line, r) {
                Attempt::Hit((k, ..)) if k <= 0.0 => Attempt::Hit(()),
                Attempt::Hit((k, discriminant, c)) if c.unwrap_or(k * k - discriminant) <= 0.0 => Attempt::Hit(()),
                Attempt::Hit(_) | Attempt::Miss => Attempt::Miss,
                Attempt::Unsure => Attempt::Unsure,
            }
        }

        /// The interval of the line inside the cylinder about the y axis: `a = dx^2 + dz^2`, `D = a r^2 - w_y^2`,
        /// `t = (-k -+ sqrt(D)) / a`.
        #[inline(always)]
        pub(crate) fn tube(line: LocalLine<$Float>, r: $Float) -> Attempt<InSide<$Float>> {
            if line.is_doubled {
                return Attempt::Hit(InSide { ends: found!(tube_doubled(&line, r)), beyond: [0.0; 2] });
            }
            let ([x, _, z], [dx, _, dz]) = (line.origin, line.direction);
            let a = dx * dx + dz * dz;
            if !is_handy::<4>(r) || !is_handy::<4>(a) {
                return Attempt::Unsure;
            }
            let k = x * dx + z * dz;
            let w = z * dx - x * dz;
            let limits = Limits::of(&line);
            let (positive, kk, ww) = (a * (r * r), k * k, w * w);
            let discriminant = positive - ww;
            if !(kk <= positive * FAR_SQUARE && discriminant * limits.cancelled >= positive) {
                let off = off_at(&line, k / a);
                let doubt = limits.of_distance(ww, positive, kk + a * (off * off));
                if discriminant < -doubt {
                    return Attempt::Miss;
                }
                // As for a sphere.
                if !(line.start != 0.0 && discriminant > doubt) {
                    return Attempt::Unsure;
                }
            }
            let moved = positive * positive * if line.is_rounded { 4.0 } else { 1.0 };
            let root = $sqrt(discriminant);
            let inverse = 1.0 / a;
            let ends = [(-k - root) * inverse, (root - k) * inverse];
            let is_clear = if line.start == 0.0 {
                are_clear_of_the_start(kk, discriminant, moved, limits.near)
            } else {
                is_clear_of_start(a * line.start, kk, discriminant, moved, limits.near)
            };
            if !is_clear {
                return Attempt::Unsure;
            }
            let [enter, exit] = ends;
            let are_steady = [is_steady(&line, enter, r, root, a), is_steady(&line, exit, r, root, a)];
            if are_steady == [true; 2] {
                return Attempt::Hit(InSide { ends, beyond: [0.0; 2] });
            }
            // The error of an end is that of the line over the derivative, which is the root.
            let off = |is_steady: bool, t: $Float| {
                if is_steady { 0.0 } else { off_at(&line, t) * r * limits.doubt() / root }
            };
            let [off_enter, off_exit] = [off(are_steady[0], enter), off(are_steady[1], exit)];
            let ends = [enter + off_enter, exit - off_exit];
            let is_inside = ends[0] < ends[1];
            if is_inside {
                Attempt::Hit(InSide { ends, beyond: [2.0 * off_enter, 2.0 * off_exit] })
            } else {
                Attempt::Unsure
            }
        }
    };
}
