//! Cones on the fast path of floats.

/// Defines the intersection with cones for a float.
macro_rules! cone {
    ($Float:ident, sqrt: $sqrt:path) => {
        /// Where the line is inside the nappe `h^2 (x^2 + z^2) <= (h r + g y)^2`, `h r + g y >= 0`, of a cone with radius `r` at
        /// `y = 0` and `r + g` at the height `h`; see `integers::nappe`, whose moment is here that of the unscaled line.
        #[inline(always)]
        pub(crate) fn nappe(line: LocalLine<$Float>, outline: [$Float; 3]) -> Attempt<InSide<$Float>> {
            let Roots { first, second, a, a_terms, k, k_terms, outline, rim, slope } = found!(roots(line, outline));
            let limits = Limits::of(&line);
            let (enter, exit) = if a < 0.0 {
                // The line is steeper than the side: a half-line lies in each nappe. Along the one in the upper nappe the outline grows.
                if slope > 0.0 { (second, ($Float::INFINITY, 0.0)) } else { ((-$Float::INFINITY, 0.0), first) }
            } else {
                // The sign of the outline halfway between the ends, at t = -k / a.
                let middle = outline * a - slope * k;
                let is_clear =
                    $Float::abs(middle) >= (rim * a_terms + $Float::abs(slope) * k_terms) * (2.0 * limits.doubt());
                if !is_clear {
                    return Attempt::Unsure;
                }
                if middle < 0.0 {
                    return Attempt::Miss;
                }
                (first, second)
            };
            Attempt::Hit(InSide { ends: [enter.0 + enter.1, exit.0 - exit.1], beyond: [2.0 * enter.1, 2.0 * exit.1] })
        }

        /// Where the line is inside both nappes of the cone `x^2 + z^2 = m^2 y^2`: between its ends, or (`true`) before the first and after the
        /// second.
        #[inline(always)]
        pub(crate) fn double_cone(line: LocalLine<$Float>, m: $Float) -> Attempt<([$Float; 2], bool)> {
            let Roots { first, second, a, .. } = found!(roots(line, [0.0, m, 1.0]));
            let is_clear = first.1 == 0.0 && second.1 == 0.0;
            if is_clear { Attempt::Hit(([first.0, second.0], a < 0.0)) } else { Attempt::Unsure }
        }

        /// `h^2 (dx^2 + dz^2) - (g dy)^2` where it cancels, by compensated products and with the low word of the growth `g`.
        #[inline(never)]
        fn compensated_a([dx, dy, dz]: [$Float; 3], [g, g_rest]: [$Float; 2], h: $Float) -> $Float {
            let [[x, e], [y, f], [z, i]] = [h.times_with_rest(dx), g.times_with_rest(dy), h.times_with_rest(dz)];
            Real::sum_of_products([[x, x], [z, z], [-y, y]]) + 2.0 * (x * e + z * i - y * (f + g_rest * dy))
        }

        /// The roots of a cone's quadric in order, each with its error bound if that is too large to accept it, and the values that distinguish the
        /// nappes.
        struct Roots {
            first: ($Float, $Float),
            second: ($Float, $Float),
            a: $Float,
            a_terms: $Float,
            k: $Float,
            k_terms: $Float,
            outline: $Float,
            rim: $Float,
            slope: $Float,
        }

        /// The discriminant of the quadric of [`nappe`], whose leading coefficient is `a`, if its sign is certain; and the magnitude of the terms whose
        /// rounding changes it, which is zero if that changes no end by more than a few units.
        #[inline(always)]
        fn discriminant(line: &LocalLine<$Float>, [r, g, h]: [$Float; 3], a: $Float) -> Attempt<($Float, $Float)> {
            let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
            let [ax, ay, az] = magnitudes(line.origin);
            let (g0, steepness, length) = (r * h, $Float::abs(g) + h, ax + ay + az);
            let limits = Limits::of(line);
            let [wx, wy, wz] = [y * dz - z * dy, z * dx - x * dz, x * dy - y * dx];
            let (p, q, s) = (g * wz - g0 * dx, g * wx + g0 * dz, h * wy);
            let (discriminant, moment) = ((p * p + q * q) - s * s, $Float::abs(p) + $Float::abs(q) + $Float::abs(s));
            // The terms of p and q are at most |g| times the distance of the origin, and g0; those of s at most h times its distance from the axis.
            // Their rounding moves D by a few halves of epsilon times them and p, q and s; where these cancel, by its square.
            let (pq_terms, s_terms) = ($Float::abs(g) * length + g0, h * (ax + az));
            let least = 4.0 * limits.epsilon;
            let terms = ($Float::abs(p) + $Float::abs(q) + least * pq_terms) * pq_terms
                + ($Float::abs(s) + least * s_terms) * s_terms;
            let is_close = $Float::abs(discriminant) * limits.cancelled <= terms;
            let off = steepness * off_at(line, length);
            let moved = off * (4.0 * limits.epsilon);
            let doubt = (terms + moment * off) * limits.doubt() + moved * moved;
            if discriminant > doubt {
                let counts = is_close || line.start != 0.0;
                Attempt::Hit((discriminant, if counts { terms } else { 0.0 }))
            } else if discriminant < -doubt && a > 0.0 {
                Attempt::Miss
            } else {
                Attempt::Unsure
            }
        }

        /// [`roots`] in double-word numbers.
        #[cold]
        #[inline(never)]
        fn roots_doubled(line: &LocalLine<$Float>, outline: [$Float; 3]) -> Attempt<Roots> {
            let form = cone_form(line, outline);
            let Quadratic { roots: [first, second], a, k } = found!(form.quadratic());
            let [outline, slope] = form.rim();
            let rim = $Float::abs(outline);
            let (first, second) = ((first, 0.0), (second, 0.0));
            let (a_terms, k_terms) = (2.0 * $Float::abs(a), 2.0 * $Float::abs(k));
            Attempt::Hit(Roots { first, second, a, a_terms, k, k_terms, outline, rim, slope })
        }

        /// The roots of the quadric of [`nappe`].
        #[inline(always)]
        fn roots(line: LocalLine<$Float>, [r, top, h]: [$Float; 3]) -> Attempt<Roots> {
            if line.is_doubled {
                return roots_doubled(&line, [r, top, h]);
            }
            let [g, g_rest] = top.plus_with_rest(-r);
            let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
            let (g0, steepness) = (r * h, $Float::abs(g) + h);
            let [ax, ay, az] = [$Float::abs(x), $Float::abs(y), $Float::abs(z)];
            let bounding_radius = steepness * (ax + ay + az) + g0;
            if !is_handy::<8>(steepness) || !is_handy::<8>(bounding_radius) {
                return Attempt::Unsure;
            }
            let (slope, outline) = (g * dy, g0 + g * y);
            let (across, along) = (h * h * (dx * dx + dz * dz), slope * slope);
            let mut a = across - along;
            let mut a_terms = across + along;
            if a_terms > 4.0 * $Float::abs(a) && line.extra_bits == 0 && !is_strict(&line) {
                a = compensated_a(line.direction, [g, g_rest], h);
                let is_clear = $Float::abs(a) >= a_terms * LEFT;
                if !is_clear {
                    return Attempt::Unsure;
                }
                a_terms = 2.0 * $Float::abs(a);
            }
            let limits = Limits::of(&line);
            // The line is nearly parallel to a generator: a direction with an error may be on either side of it.
            let most = if line.off[0] == 0.0 { a_terms } else { steepness * steepness };
            let is_clear = $Float::abs(a) >= most * limits.doubt();
            if !is_clear {
                return Attempt::Unsure;
            }
            let (discriminant, terms) = found!(discriminant(&line, [r, g, h], a));
            let k = h * h * (x * dx + z * dz) - outline * slope;
            let root = h * $sqrt(discriminant);
            // -k and the root are added where they have the same sign; the other end is c over that sum.
            let sum = $Float::abs(k) + root;
            // The outline cancels towards the apex.
            let rim = g0 + $Float::abs(g) * ay;
            let (outside, inside) = (h * h * (x * x + z * z), outline * outline);
            let (c, c_terms) = (outside - inside, outside + ($Float::abs(outline) + 4.0 * limits.epsilon * rim) * rim);
            let k_terms = h * h * (ax + az) + rim * $Float::abs(slope);
            let is_clear = sum * limits.cancelled >= k_terms;
            if !is_clear {
                return Attempt::Unsure;
            }
            let q = if k > 0.0 { -sum } else { sum };
            let start = line.start;
            // The root's error, which may be larger than that of k.
            let sum_terms = if terms == 0.0 { k_terms } else { k_terms + 0.5 * (h * h) * terms / root };
            // If the terms of an end cancel, the interval is given only as far as it certainly reaches: the planes may cut off that end. The relative
            // errors of numerator and denominator add up.
            let off = |difference: $Float, terms: $Float, divisor: $Float| {
                let magnitude = $Float::abs(difference);
                let whole = if start == 0.0 {
                    magnitude * sum
                } else {
                    $Float::abs(difference * q + start * (divisor * divisor))
                };
                let is_good = terms * sum + sum_terms * magnitude <= limits.together * whole;
                if is_good { 0.0 } else { (terms / magnitude + sum_terms / sum) * limits.doubt() }
            };
            // The length of half the quadric's gradient is at most that of its derivative along a generator: the outline there times h^2 + g^2.
            let moved = |t: $Float| {
                let gradient = $Float::abs(outline + t * slope) * steepness;
                // Next to the apex the gradient itself has an error.
                let is_off_apex = off_at(&line, t) * (steepness * steepness * 32.0 * limits.epsilon) <= gradient;
                if is_off_apex && is_steady(&line, t, gradient, root, $Float::abs(a)) {
                    0.0
                } else {
                    off_at(&line, t) * (gradient + steepness * steepness) * limits.doubt() / root
                }
            };
            let (by_a, by_c) = (q / a, c / q);
            let by_a = (by_a, off(a, a_terms, a) * $Float::abs(by_a) + moved(by_a));
            let by_c = (by_c, off(c, c_terms, q) * $Float::abs(by_c) + moved(by_c));
            let (first, second) = if (k > 0.0) == (a > 0.0) { (by_a, by_c) } else { (by_c, by_a) };
            // If the ends are so close to each other, relative to their distance from the start, rounding may exchange them.
            let are_apart = first.0 < second.0;
            if !are_apart {
                return Attempt::Unsure;
            }
            let (a_terms, rim) = (most, rim + steepness * off_at(&line, k / a));
            Attempt::Hit(Roots { first, second, a, a_terms, k, k_terms, outline, rim, slope })
        }
    };
}
