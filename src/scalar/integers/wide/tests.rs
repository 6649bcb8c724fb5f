use super::*;
use crate::scalar::{Attempt, InSide, found};
use dashu_int::IBig;

/// The number of lines of each test; two million have been tried.
const LINES: u32 = 20_000;

/// Random words.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let n = self.0 ^ (self.0 >> 29);
        n.wrapping_mul(0xbf58_476d_1ce4_e5b9) ^ (n >> 32)
    }
    fn below(&mut self, bound: u64) -> u64 {
        (self.next() >> 8) % bound
    }
    /// In `[-1, 1)`.
    fn either(&mut self) -> f64 {
        (self.next() as i64) as f64 * 2.0_f64.powi(-63)
    }
    /// A number of any size up to this number of bits.
    fn sized(&mut self, bits: u64) -> i64 {
        let n = self.next() >> 1 >> (63 - 1 - self.below(bits - 1)).min(62);
        (n as i64).max(1)
    }
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

/// A line at a ball: near or far, grazing, from inside or from the surface; coordinates of all sizes below 2^62.
fn line_and_ball(random: &mut Random) -> ([i64; 3], [i64; 3], i64) {
    loop {
        let r = random.sized(62);
        let r = if random.below(2) == 0 { r } else { ((r >> FINER) + 1) << FINER };
        let mut d = unit([random.either(), random.either(), random.either()]);
        match random.below(8) {
            0 => d = [1.0, 0.0, 0.0],
            1 => d = unit([random.either() * 1e-9, 1.0, random.either() * 1e-9]),
            2 => d = unit([0.0, random.either(), random.either()]),
            _ => {}
        }
        let other = unit([random.either(), random.either(), random.either()]);
        let along: f64 = (0..3).map(|i| other[i] * d[i]).sum();
        let side = unit([0, 1, 2].map(|i| other[i] - along * d[i]));
        let radius = r as f64;
        let impact = match random.below(4) {
            0 => random.either() * 0.9,
            1 => random.either() * 1.5,
            2 => 1.0 + random.either() * 2.0_f64.powi(-(random.below(40) as i32)),
            _ => random.either().abs().sqrt(),
        } * radius;
        let back = match random.below(4) {
            0 => (radius * radius - impact * impact).max(0.0).sqrt() * if random.below(2) == 0 { 1.0 } else { -1.0 },
            1 => random.either() * radius,
            2 => radius * 16.0 * random.either(),
            _ => random.sized(62) as f64,
        };
        let at = [0, 1, 2].map(|i| side[i] * impact - d[i] * back);
        if at.iter().any(|c| c.abs() >= 2.0_f64.powi(62)) {
            continue;
        }
        // The bits below the precision of doubles are random.
        let mut bits = |c: f64, one: f64| {
            (c * one) as i64 ^ (random.next() & ((1 << 8) - 1) & ((c.abs() * one) as u64 >> 53)) as i64
        };
        let o = at.map(|c| bits(c, 1.0));
        let mut d = d.map(|c| (c * 2.0_f64.powi(62)) as i64);
        match random.below(4) {
            // With the length of a rounded unit vector.
            0 | 1 => {
                let largest = (0..3).fold(0, |i, j| if d[j].abs() > d[i].abs() { j } else { i });
                let others: i128 = (0..3).filter(|i| *i != largest).map(|i| (d[i] as i128) * d[i] as i128).sum();
                d[largest] = d[largest].signum() * ((1 << 124) - others).isqrt() as i64;
            }
            // With the length of one of a type of 32 bits.
            2 => d = d.map(|c| ((c + (1 << 31)) >> 32) << 32),
            _ => {}
        }
        return (o, d, r);
    }
}

/// The length in the unit of the type, which it is half of the time, or as many times coarser as that of a frame.
fn units(length: i64) -> (i32, i64) {
    if length % (1 << FINER) == 0 { (FINER, length >> FINER) } else { (0, length) }
}

/// `a t^2 + 2 k t + c` in numbers of any size; `t` is in units of 2^-10.
struct Exactly {
    a: IBig,
    k: IBig,
    c: IBig,
}

impl Exactly {
    fn new(o: [i64; 3], d: [i64; 3], r: i64) -> Self {
        let dot = |a: [i64; 3], b: [i64; 3]| (0..3).map(|i| IBig::from(a[i]) * IBig::from(b[i])).sum::<IBig>();
        let one = IBig::from(1) << 62;
        Self { a: dot(d, d), k: dot(o, d) * &one, c: (dot(o, o) - IBig::from(r) * IBig::from(r)) * &one * one }
    }
    /// Whether the direction's length is 1 within 2^-60.
    fn is_unit(&self) -> bool {
        let e: IBig = (IBig::from(1) << 124) - &self.a;
        e < IBig::from(1) << 64 && e > -(IBig::from(1) << 64)
    }
    fn misses(&self) -> bool {
        &self.k * &self.k < &self.a * &self.c
    }
    fn at(&self, t: &IBig) -> IBig {
        &self.a * t * t + ((&self.k * t) << 11) + (&self.c << 20)
    }
    /// Whether the first (or the second) end is within so many 1024ths of this one, which is in units that are coarser.
    fn is_end(&self, t: i64, extra_bits: i32, second: bool, within: i64) -> bool {
        let t = if second { -IBig::from(t) } else { IBig::from(t) } << (10 + extra_bits as usize);
        let within = within << extra_bits;
        let turned = Self { a: self.a.clone(), k: if second { -&self.k } else { self.k.clone() }, c: self.c.clone() };
        let (low, high) = (&t - IBig::from(within), &t + IBig::from(within));
        let beyond = |t: &IBig| &turned.a * t + (&turned.k << 10) >= IBig::ZERO;
        turned.at(&low) >= IBig::ZERO && !beyond(&low) && (turned.at(&high) <= IBig::ZERO || beyond(&high))
    }
}

/// The result on the grid for a line: its ends, and whether one is ahead.
fn queried(o: [i64; 3], extra_bits: i32, d: [i64; 3], r: i64, by_moment: bool) -> (Attempt<[i64; 2]>, Attempt<()>) {
    let ends = || {
        Attempt::Hit(if by_moment {
            found!(found!(ByMoment::new(o, extra_bits, d, r)).ends())
        } else {
            found!(found!(ByApproach::new(o, extra_bits, d, r)).ends())
        })
    };
    let ahead = || {
        if by_moment {
            found!(ByMoment::new(o, extra_bits, d, r)).meets_ahead()
        } else {
            found!(ByApproach::new(o, extra_bits, d, r)).meets_ahead()
        }
    };
    (ends(), ahead())
}

#[test]
fn balls_are_met_where_they_are() {
    let mut random = Random(1);
    let mut found = 0;
    for _ in 0..LINES {
        let (o, d, r) = line_and_ball(&mut random);
        let exactly = Exactly::new(o, d, r);
        let (extra_bits, r) = units(r);
        // The closest approach assumes a direction of length 1. Half a unit, of 1024ths, is that of rounding.
        for (by_moment, within) in [(true, 528), (false, 1024)] {
            if !by_moment && !exactly.is_unit() {
                continue;
            }
            let (ends, ahead) = queried(o, extra_bits, d, r, by_moment);
            let line = std::format!("{o:?} {d:?} {r}, extra bits: {extra_bits}, by moment: {by_moment}");
            match ends {
                Attempt::Unsure => {}
                Attempt::Miss => assert!(exactly.misses(), "lost: {line}"),
                Attempt::Hit([low, high]) => {
                    found += 1;
                    assert!(!exactly.misses(), "phantom: {line}");
                    assert!(exactly.is_end(low, extra_bits, false, within), "{low} is no end: {line}");
                    assert!(exactly.is_end(high, extra_bits, true, within), "{high} is no end: {line}");
                }
            }
            match (ahead, ends) {
                (Attempt::Unsure, _) | (_, Attempt::Unsure) => {}
                (ahead, Attempt::Miss) => assert_eq!(ahead, Attempt::Miss, "missed, but met ahead: {line}"),
                (Attempt::Miss, Attempt::Hit([_, high])) => assert!(high < 0, "{high} is ahead: {line}"),
                (Attempt::Hit(()), Attempt::Hit([_, high])) => assert!(high >= 0, "{high} is not ahead: {line}"),
            }
        }
    }
    assert!(found > LINES * 9 / 10, "{found}");
}

#[test]
fn cylinders_are_met_where_they_are() {
    let mut random = Random(2);
    let mut found = 0;
    for _ in 0..LINES {
        let (o, d, r) = line_and_ball(&mut random);
        let exactly = Exactly::new([o[0], 0, o[2]], [d[0], 0, d[2]], r);
        let (extra_bits, r) = units(r);
        let line = std::format!("{o:?} {d:?} {r}, extra bits: {extra_bits}");
        match tube(o, extra_bits, d, r) {
            Attempt::Unsure => {}
            Attempt::Miss => assert!(exactly.misses(), "lost: {line}"),
            Attempt::Hit([low, high]) => {
                found += 1;
                assert!(!exactly.misses(), "phantom: {line}");
                assert!(exactly.is_end(low, extra_bits, false, 560), "{low} is no end: {line}");
                assert!(exactly.is_end(high, extra_bits, true, 560), "{high} is no end: {line}");
            }
        }
    }
    assert!(found > LINES / 4, "{found}");
}

#[test]
fn planes_are_met_where_they_are() {
    let mut random = Random(3);
    let mut found = 0;
    for _ in 0..LINES {
        let (o, d, fine) = line_and_ball(&mut random);
        let (extra_bits, y) = units(fine);
        let Attempt::Hit([first, second]) = crossings(o[1], extra_bits, d[1], [y, 0]) else { continue };
        found += 1;
        for (t, y) in [(first, fine), (second, 0)] {
            // dy (t -+ 1/2 and a bit) on both sides of the height
            let beyond = (IBig::from(y - o[1]) << 62) - (IBig::from(t) << extra_bits as usize) * IBig::from(d[1]);
            let half = IBig::from(d[1].unsigned_abs()) * IBig::from(560 << extra_bits);
            assert!(beyond.clone() << 10 <= half && -beyond << 10 <= half, "{t}: {o:?} {d:?} {y}");
        }
        match height(o[1], extra_bits, d[1], first) {
            Attempt::Hit(there) => assert!((there - y).abs() <= 1, "{there}: {o:?} {d:?} {y}"),
            _ => assert!(first.unsigned_abs() >> 52 != 0, "{o:?} {d:?} {y}"),
        }
    }
    assert!(found > LINES / 4, "{found}");
}

/// Numbers of all sizes.
fn numbers() -> impl Iterator<Item = u64> {
    let mut random = Random(1);
    (0..400_000).map(move |_| random.next())
}

#[test]
fn root_is_within_its_bound() {
    let normalized = numbers().map(|n| if n >> 62 == 0 { n | 1 << 62 } else { n });
    let squares = (1 << 31..1_u64 << 32).step_by(54_321).flat_map(|n| [n * n - 1, n * n, n * n + 1]);
    let bytes = (64..256).flat_map(|n| [n << 56, (n << 56) | ((1 << 56) - 1), (n << 56) | (1 << 55)]);
    for n in normalized.chain(squares).chain(bytes).chain([1 << 62, u64::MAX]).filter(|n| n >> 62 != 0) {
        let got = root_of_normalized((n >> 32) as u32, n as u32);
        let floor = ((n as u128) << 64).isqrt() as u64;
        assert!(got.abs_diff(floor) <= 64, "root({n:#x}) = {got}, not {floor}");
    }
}

#[test]
fn reciprocal_is_within_its_bound() {
    let bytes = (128..256).flat_map(|n| [n << 56, (n << 56) | ((1 << 56) - 1), (n << 56) | (1 << 55)]);
    for n in numbers().map(|n| n | 1 << 63).chain(bytes).chain([1 << 63, u64::MAX]) {
        let got = quotient::reciprocal_of_digits(n);
        let exact = ((1_u128 << 127) / n as u128).min(u64::MAX as u128) as u64;
        assert!(got.abs_diff(exact) <= 32, "1 / {n:#x} = {got}, not {exact}");
    }
}

/// Numbers of all sizes that a type accepts, of either sign.
fn coordinate(random: &mut Random, bits: u64) -> i64 {
    let n = random.sized(bits);
    if random.below(2) == 0 { n } else { -n }
}

/// For all sizes nothing overflows, and hits lie on the surface; for lines from far and near, in the world and in
/// frames.
#[test]
fn cones_discs_and_triangles_of_every_size_are_met_on_their_surfaces() {
    let mut random = Random(7);
    let (mut cones, mut discs, mut triangles) = (0, 0, 0);
    for index in 0..4 * LINES {
        let extra_bits = if index % 2 == 0 { 0 } else { FINER };
        // Of similar sizes, or of any sizes.
        let bits = 20 + random.below(42);
        let size = |random: &mut Random| if index % 3 == 0 { random.sized(62) } else { random.sized(bits.max(4)) };
        let sizes = [size(&mut random), size(&mut random), size(&mut random)];
        let vertices = [(); 3].map(|()| [(); 3].map(|()| coordinate(&mut random, bits)));
        let o = [(); 3].map(|()| coordinate(&mut random, if index % 5 == 0 { 62 } else { (bits + 3).min(62) }));
        let unit_of = 2.0_f64.powi(-extra_bits);
        let from = o.map(|c| c as f64 * unit_of);
        // Approximately towards the solid.
        let aim = [0, 1, 2]
            .map(|i| vertices[index as usize % 3][i] as f64 / 3.0 - from[i] + random.either() * sizes[0] as f64);
        let d = unit(aim).map(|c| (c * 2.0_f64.powi(62)) as i64);
        let e = d.map(|c| c as f64 * 2.0_f64.powi(-62));
        let at = |t: i64| [0, 1, 2].map(|i| from[i] + t as f64 * e[i]);
        let off = |t: i64| 1e-12 * (from.iter().map(|c| c.abs()).sum::<f64>() + t as f64) + 8.0;
        if let Attempt::Hit(t) = disc(o, extra_bits, d, sizes[0]) {
            discs += 1;
            let [x, y, z] = at(t);
            assert!(
                y.abs() <= off(t.abs()) && x.hypot(z) <= sizes[0] as f64 + 2.0 * off(t.abs()) / e[1].abs(),
                "{o:?} {d:?} {sizes:?}"
            );
        }
        if let Attempt::Hit((t, _)) = triangle(o, extra_bits, d, vertices) {
            triangles += 1;
            let p = at(t);
            let [a, b, c] = vertices.map(|v| [0, 1, 2].map(|i| v[i] as f64 - p[i]));
            let cross = |[x, y, z]: [f64; 3], [u, v, w]: [f64; 3]| [y * w - z * v, z * u - x * w, x * v - y * u];
            let normal = cross([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
            let height: f64 = unit(normal).iter().zip(a).map(|(n, a)| n * a).sum();
            let largest = a.iter().chain(&b).chain(&c).fold(0.0_f64, |all, c| all.max(c.abs()));
            assert!(height.abs() <= off(t.abs()) + 1e-3 * largest, "{o:?} {d:?} {vertices:?}: {height}");
        }
        let [r, g, h] = [sizes[0], if index % 7 == 0 { -sizes[1] } else { sizes[1] }, sizes[2]];
        let on_cone = |t: i64, r: i64| {
            let [x, y, z] = at(t);
            let (ratio, off) = (g as f64 / h as f64, off(t.abs()));
            let outline = r as f64 + ratio * y;
            let near = (x.hypot(z) - outline.abs()).abs()
                <= (1.0 + ratio.abs()) * (off + 1e-9 * (x.abs() + y.abs() + z.abs()));
            assert!(near, "{o:?} {d:?} {:?}: {x} {y} {z} {outline}", [r, g, h]);
        };
        if let Attempt::Hit(InSide { ends, beyond }) = nappe(o, extra_bits, d, [r, g, h]) {
            cones += 1;
            for (end, beyond) in ends.into_iter().zip(beyond) {
                if beyond == 0 && end.unsigned_abs() != i64::MAX as u64 {
                    on_cone(end, r);
                }
            }
        }
        if let Attempt::Hit((ends, _)) = double_cone(o, extra_bits, d, [g.abs(), h]) {
            cones += 1;
            assert!(ends[0] <= ends[1]);
        }
    }
    assert!(
        cones > LINES as i32 / 4 && discs > LINES as i32 / 40 && triangles > LINES as i32 / 40,
        "{cones} {discs} {triangles}"
    );
}

/// The low digit as large as it can be.
fn low_digit_is_largest(n: i64) -> i64 {
    (n >> 32 << 32) | i64::from(i32::MAX)
}

/// Directions of all kinds, among them exactly and nearly along an axis, and matrices of which two thirds map such an
/// axis to itself: the direction has length 1, direction and inverse length have the same reciprocal, and the origin is
/// the image by the matrix.
#[test]
fn a_stretched_line_is_the_matrix_times_the_line() {
    let mut random = Random(9);
    let (mut found, mut along_axes) = (0, 0);
    for index in 0..LINES {
        let [o, position] = [(); 2].map(|()| {
            let bits = 8 + random.below(43);
            [(); 3].map(|()| coordinate(&mut random, bits))
        });
        let axis = random.below(3) as usize;
        let d = match random.below(3) {
            0 => [0, 1, 2].map(|i| f64::from(u8::from(i == axis))),
            1 => unit([0, 1, 2].map(|i| if i == axis { 1.0 } else { random.either() * 1e-7 })),
            _ => unit([(); 3].map(|()| random.either())),
        };
        let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
        let d = d.map(|c| (c * sign * 2.0_f64.powi(62)) as i64);
        let is_diagonal = random.below(3) != 0;
        // All components of a row next to 1, with the signs of the direction's, and low digits with the signs of the
        // high ones.
        let is_full = random.below(8) == 0;
        let d = if is_full { d.map(|c| low_digit_is_largest(c.abs()) * c.signum()) } else { d };
        let rows = [0, 1, 2].map(|i| {
            // As stored: the longest component has all bits. With a power of two, the direction's length may be rounded
            // to below its component.
            let mut row = [(); 3].map(|()| if is_diagonal { 0 } else { coordinate(&mut random, 61) });
            if is_full {
                let mut full = |c: i64| low_digit_is_largest((1 << 62) - 1 - random.below(1 << 40) as i64) * c.signum();
                return (d.map(&mut full), 0);
            }
            row[i] = (1 << 61) + if random.below(2) == 0 { 0 } else { random.below(1 << 61) as i64 };
            (row, random.below(13) as i32 - 6)
        });
        let bounding_radius = 1 << (20 + index % 24);
        let Some(line) = stretched(o, d, position, rows, bounding_radius) else { continue };
        found += 1;
        along_axes += u32::from(d.iter().filter(|c| **c == 0).count() == 2 && is_diagonal && !is_full);
        let length: IBig = line.direction.iter().map(|c| IBig::from(*c) * IBig::from(*c)).sum();
        let off = length - (IBig::from(1) << 124);
        assert!(off.clone() * &off <= IBig::from(1) << (2 * (124 - 54)), "length {line:?} {d:?} {rows:?} {off}");
        let reciprocal = IBig::from(joined([line.inverse_length.below, line.inverse_length.digits]));
        for i in 0..3 {
            let (row, exponent) = rows[i];
            let image = |v: [i64; 3]| (0..3).map(|j| IBig::from(v[j]) * IBig::from(row[j])).sum::<IBig>();
            // In units of 2^-62 times 2^-places.
            let places = (line.inverse_length.shift as i32 - line.scale + 62 - exponent) as usize;
            let off = image(d) * &reciprocal - (IBig::from(line.direction[i]) << places);
            assert!(off.clone() * &off <= IBig::from(9) << (2 * places - 2), "direction {line:?} {d:?} {rows:?}");
            let places = 62 - exponent - line.scale - FINER;
            let from = [0, 1, 2].map(|j| o[j] - position[j]);
            let (got, image) = (IBig::from(line.origin[i]), image(from));
            let (got, image) = if places >= 0 {
                (got << places as usize, image)
            } else {
                (got, image << places.unsigned_abs() as usize)
            };
            let off = got - image;
            // The other rows' bits below the unit of the largest are cut off.
            assert!(
                off.clone() * &off <= IBig::from(9) << (2 * places.max(0) as usize + 1),
                "origin {line:?} {o:?} {position:?} {rows:?}"
            );
        }
    }
    assert!(found > LINES / 3 && along_axes > LINES / 20, "{found} {along_axes}");
}
