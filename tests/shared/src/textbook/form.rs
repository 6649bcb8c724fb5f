//! The formulas of all primitives, each as one value.

use super::{Extent, Formula, Number, PlainRay, Quadric, Side, Sphere, ball, cross, dot, ends, roots, slabs};

/// A primitive of any kind.
#[derive(Clone, Copy)]
pub enum Form<N> {
    Sphere {
        radius: N,
    },
    Side(Side<N>),
    Capsule {
        radius: N,
        height: N,
    },
    Revolved(Quadric<N>),
    RoundCone {
        radii: [N; 2],
        height: N,
    },
    Tube {
        radii: [N; 2],
        height: N,
    },
    Torus {
        radii: [N; 2],
    },
    Plane,
    Disc {
        radius: N,
    },
    Annulus {
        radii: [N; 2],
    },
    Cuboid {
        half: [N; 3],
    },
    RoundedCuboid {
        half: [N; 3],
        radius: N,
    },
    /// Of each face a normal and a point; a face without a normal bounds nothing.
    HalfSpaces {
        faces: [[[N; 3]; 2]; 8],
    },
    Rectangle {
        half: [N; 2],
    },
    Triangle {
        vertices: [[N; 3]; 3],
    },
}

impl<N: Number> Formula<N> for Form<N> {
    #[inline(always)]
    fn meet(&self, ray: &PlainRay<N>, root: impl Fn(N) -> N + Copy, report: &mut impl FnMut(N)) {
        match *self {
            Self::Sphere { radius } => Sphere(radius).meet(ray, root, report),
            Self::Side(side) => side.meet(ray, root, report),
            Self::Capsule { radius, height } => {
                let side = Side { base: radius, slope: None, extent: Extent::To(height), caps: [None; 2] };
                side.meet(ray, root, report);
                for (centre, is_base) in [(N::ZERO, true), (height, false)] {
                    ball(radius, centre, ray, root, |t, y| {
                        if if is_base { y < N::ZERO } else { y > height } {
                            report(t);
                        }
                    });
                }
            }
            Self::Revolved(quadric) => quadric.meet(ray, root, report),
            Self::RoundCone { radii: [base, top], height } => {
                // The sine and the cosine of the angle between axis and side, and the heights where that begins and
                // ends.
                let sine = (base - top) / height;
                let cosine = root(N::ONE - sine * sine);
                let [low, high] = [base * sine, height + top * sine];
                let side = Side {
                    base: base / cosine,
                    slope: Some(-sine / cosine),
                    extent: Extent::Between([low, high]),
                    caps: [None; 2],
                };
                side.meet(ray, root, report);
                for (radius, centre, is_base) in [(base, N::ZERO, true), (top, height, false)] {
                    ball(radius, centre, ray, root, |t, y| {
                        if if is_base { y < low } else { y > high } {
                            report(t);
                        }
                    });
                }
            }
            Self::Tube { radii, height } => {
                for radius in radii {
                    let side = Side { base: radius, slope: None, extent: Extent::To(height), caps: [None; 2] };
                    side.meet(ray, root, report);
                }
                ring(N::ZERO, radii, ray, report);
                ring(height, radii, ray, report);
            }
            Self::Torus { radii } => torus(radii, ray, root, report),
            Self::Plane => {
                if ray.direction[1] != N::ZERO {
                    report(-ray.origin[1] / ray.direction[1]);
                }
            }
            Self::Disc { radius } => ends([Some((N::ZERO, radius)), None], ray, report),
            Self::Annulus { radii } => ring(N::ZERO, radii, ray, report),
            Self::Cuboid { half } => {
                if let Some(ends) = slabs(half, ray) {
                    ends.into_iter().for_each(&mut *report);
                }
            }
            Self::RoundedCuboid { half, radius } => rounded_cuboid(half, radius, ray, root, report),
            Self::HalfSpaces { faces } => half_spaces(faces, ray, report),
            Self::Rectangle { half: [x, z] } => {
                let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
                if dy != N::ZERO {
                    let t = -oy / dy;
                    let (px, pz) = (ox + t * dx, oz + t * dz);
                    if -x <= px && px <= x && -z <= pz && pz <= z {
                        report(t);
                    }
                }
            }
            Self::Triangle { vertices } => triangle(vertices, ray, report),
        }
    }
}

/// The faces, a cylinder about each edge and a ball about each corner, each where no coordinate is another's.
#[inline(always)]
fn rounded_cuboid<N: Number>(
    half: [N; 3],
    radius: N,
    ray: &PlainRay<N>,
    root: impl Fn(N) -> N + Copy,
    report: &mut impl FnMut(N),
) {
    let (origin, direction) = (ray.origin, ray.direction);
    // All choices of sides: below the cuboid along an axis, between its planes, or above.
    for i in 0..27 {
        let sides = [i % 3, i / 3 % 3, i / 9];
        let (mut o, mut d, mut beyond) = ([N::ZERO; 3], [N::ZERO; 3], 0);
        for axis in 0..3 {
            if sides[axis] != 1 {
                let plane = if sides[axis] == 0 { -half[axis] } else { half[axis] };
                (o[axis], d[axis], beyond) = (origin[axis] - plane, direction[axis], beyond + 1);
            }
        }
        let is_there = |t: N| {
            (0..3).all(|axis| {
                let c = origin[axis] + t * direction[axis];
                match sides[axis] {
                    0 => c < -half[axis],
                    1 => -half[axis] <= c && c <= half[axis],
                    _ => c > half[axis],
                }
            })
        };
        if beyond == 1 {
            for axis in 0..3 {
                if sides[axis] != 1 && d[axis] != N::ZERO {
                    let t = (if sides[axis] == 0 { -radius - o[axis] } else { radius - o[axis] }) / d[axis];
                    if is_there(t) {
                        report(t);
                    }
                }
            }
        } else if beyond > 1 {
            for t in roots(dot(d, d), dot(o, d), dot(o, o) - radius * radius, root).into_iter().flatten() {
                if is_there(t) {
                    report(t);
                }
            }
        }
    }
}

/// What the half-spaces have in common (Cyrus and Beck, 1978).
#[inline(always)]
fn half_spaces<N: Number>(faces: [[[N; 3]; 2]; 8], ray: &PlainRay<N>, report: &mut impl FnMut(N)) {
    let (mut enter, mut exit, mut misses) = (None, None, false);
    let mut clip = |value: N, slope: N| {
        if slope == N::ZERO {
            misses |= value > N::ZERO;
            return;
        }
        let t = -value / slope;
        if slope < N::ZERO {
            enter = Some(enter.filter(|own| *own > t).unwrap_or(t));
        } else {
            exit = Some(exit.filter(|own| *own < t).unwrap_or(t));
        }
    };
    for [n, p] in faces {
        let o = ray.origin;
        clip(dot(n, [o[0] - p[0], o[1] - p[1], o[2] - p[2]]), dot(n, ray.direction));
    }
    if let (Some(enter), Some(exit)) = (enter, exit)
        && !misses
        && enter <= exit
    {
        report(enter);
        report(exit);
    }
}

/// The quartic of `(|p|^2 - R^2 - r^2)^2 + 4 R^2 (y^2 - r^2) = 0`, without its cubic term, as the product of two
/// quadratic ones (Descartes, 1637).
#[inline(always)]
fn torus<N: Number>(
    [major, minor]: [N; 2],
    ray: &PlainRay<N>,
    root: impl Fn(N) -> N + Copy,
    report: &mut impl FnMut(N),
) {
    let (o, d, two) = (ray.origin, ray.direction, N::ONE + N::ONE);
    let (square, four) = (major * major, two * two);
    let (dd, m, rest) = (dot(d, d), dot(o, d), dot(o, o) - square - minor * minor);
    let lead = dd * dd;
    // Squares of small numbers are zero in fixed point.
    if lead == N::ZERO {
        return;
    }
    let k = m / dd;
    let a = (four * m * m + two * dd * rest + four * square * d[1] * d[1]) / lead;
    let b = four * (m * rest + two * square * o[1] * d[1]) / lead;
    let c = (rest * rest + four * square * (o[1] * o[1] - minor * minor)) / lead;
    // With t = u - k that is u^4 + p u^2 + q u + r.
    let p = a - (four + two) * k * k;
    let q = b - two * a * k + two * four * k * k * k;
    let r = c - b * k + a * k * k - (two + N::ONE) * k * k * k * k;
    if q == N::ZERO {
        for square in roots(N::ONE, p / two, r, root).into_iter().flatten().filter(|square| *square >= N::ZERO) {
            report(root(square) - k);
            report(-root(square) - k);
        }
        return;
    }
    let z = largest_root(two * p, p * p - four * r, -q * q);
    let s = if z > N::ZERO { root(z) } else { N::ZERO };
    if s > N::ZERO {
        for (s, other) in [(s, q / s), (-s, -q / s)] {
            let ends = roots(N::ONE, s / two, (p + z - other) / two, root);
            ends.into_iter().flatten().for_each(|u| report(u - k));
        }
    }
}

/// The largest root of `z^3 + a z^2 + b z + c`, by Newton's method from above all roots.
#[inline(always)]
fn largest_root<N: Number>(a: N, b: N, c: N) -> N {
    let larger = |a: N, b: N| if a < b { b } else { a };
    let mut z = N::ONE + [a, b, c].into_iter().fold(N::ZERO, |most, c| larger(most, larger(c, -c)));
    for _ in 0..64 {
        let slope = ((z + z + z) + a + a) * z + b;
        if slope <= N::ZERO {
            break;
        }
        let next = z - (((z + a) * z + b) * z + c) / slope;
        if next >= z {
            break;
        }
        z = next;
    }
    z
}

/// The plane at this height, between two circles about the axis.
#[inline(always)]
fn ring<N: Number>(height: N, [inner, outer]: [N; 2], ray: &PlainRay<N>, report: &mut impl FnMut(N)) {
    let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
    if dy != N::ZERO {
        let t = (height - oy) / dy;
        let (x, z) = (ox + t * dx, oz + t * dz);
        let square = x * x + z * z;
        if inner * inner <= square && square <= outer * outer {
            report(t);
        }
    }
}

/// Möller and Trumbore, *Fast, Minimum Storage Ray/Triangle Intersection*, 1997.
#[inline(always)]
fn triangle<N: Number>([a, b, c]: [[N; 3]; 3], ray: &PlainRay<N>, report: &mut impl FnMut(N)) {
    let from = |p: [N; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (first, second, o) = (from(b), from(c), from(ray.origin));
    let p = cross(ray.direction, second);
    let determinant = dot(first, p);
    if determinant == N::ZERO {
        return;
    }
    let q = cross(o, first);
    let (u, v) = (dot(o, p) / determinant, dot(ray.direction, q) / determinant);
    if u >= N::ZERO && v >= N::ZERO && u + v <= N::ONE {
        report(dot(second, q) / determinant);
    }
}
