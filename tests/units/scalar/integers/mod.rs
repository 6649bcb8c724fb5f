use super::*;
use crate::scalar::{Attempt, InSide, found};
use ball::{ByApproach, ByMoment};
use cone::{Nappe, nappe};
use core::fmt::Debug;
use dashu_int::IBig;
use flat::{crossings, height};
use length::Normalized;
use round::cylinder;
use triangle::triangle;

mod framed;
mod surfaces;

/// The number of lines of each test; two million have been tried.
pub(super) const LINES: u32 = 20_000;

/// A length of a test.
trait Tested: Length + Into<i64> + Debug {
    fn of(n: i64) -> Self;
}

impl Tested for i32 {
    fn of(n: i64) -> Self {
        n as Self
    }
}

impl Tested for i64 {
    fn of(n: i64) -> Self {
        n
    }
}

/// Random words.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let n = self.0 ^ (self.0 >> 29);
        n.wrapping_mul(0xbf58_476d_1ce4_e5b9) ^ (n >> 32)
    }
    pub(super) fn below(&mut self, bound: u64) -> u64 {
        (self.next() >> 8) % bound
    }
    /// In `[-1, 1)`.
    pub(super) fn either(&mut self) -> f64 {
        (self.next() as i64) as f64 * 2.0_f64.powi(-63)
    }
    /// A number of any size up to this number of bits.
    pub(super) fn sized(&mut self, bits: u64) -> i64 {
        let n = self.next() >> 1 >> (63 - 1 - self.below(bits - 1)).min(62);
        (n as i64).max(1)
    }
}

pub(super) fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

/// A line at a ball: near or far, grazing, from inside or from the surface; coordinates of all sizes below
/// `2^FRACTION`.
fn line_and_ball<N: Tested>(random: &mut Random) -> ([i64; 3], [i64; 3], i64) {
    let fraction = N::FRACTION;
    let one = 2.0_f64.powi(fraction as i32);
    loop {
        let r = random.sized(fraction.into());
        let r = if random.below(2) == 0 { r } else { ((r >> N::FINER) + 1) << N::FINER };
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
            _ => random.sized(fraction.into()) as f64,
        };
        let at = [0, 1, 2].map(|i| side[i] * impact - d[i] * back);
        if at.iter().any(|c| c.abs() >= one) {
            continue;
        }
        // The bits below the precision of doubles are random.
        let mut bits = |c: f64, one: f64| {
            (c * one) as i64 ^ (random.next() & ((1 << 8) - 1) & ((c.abs() * one) as u64 >> 53)) as i64
        };
        let o = at.map(|c| bits(c, 1.0));
        let mut d = d.map(|c| (c * one) as i64);
        match random.below(4) {
            // With the length of a rounded unit vector.
            0 | 1 => {
                let largest = (0..3).fold(0, |i, j| if d[j].abs() > d[i].abs() { j } else { i });
                let others: i128 = (0..3).filter(|i| *i != largest).map(|i| (d[i] as i128) * d[i] as i128).sum();
                d[largest] = d[largest].signum() * ((1 << (2 * fraction)) - others).isqrt() as i64;
            }
            // With the length of one of a type of 32 bits.
            2 if fraction > 32 => d = d.map(|c| ((c + (1 << 31)) >> 32) << 32),
            _ => {}
        }
        return (o, d, r);
    }
}

/// The length in the unit of the type, which it is half of the time, or as many times coarser as that of a frame.
fn units<N: Tested>(length: i64) -> (i32, i64) {
    if length % (1 << N::FINER) == 0 { (N::FINER, length >> N::FINER) } else { (0, length) }
}

/// `a t^2 + 2 k t + c` in numbers of any size; `t` is in units of 2^-10.
struct Exactly {
    a: IBig,
    k: IBig,
    c: IBig,
    fraction: usize,
}

impl Exactly {
    fn new<N: Tested>(o: [i128; 3], d: [i128; 3], r: i128) -> Self {
        let fraction = N::FRACTION as usize;
        let dot = |a: [i128; 3], b: [i128; 3]| (0..3).map(|i| IBig::from(a[i]) * IBig::from(b[i])).sum::<IBig>();
        let one = IBig::from(1) << fraction;
        let c = (dot(o, o) - IBig::from(r) * IBig::from(r)) * &one * &one;
        Self { a: dot(d, d), k: dot(o, d) * one, c, fraction }
    }
    /// Whether the direction's length is 1 within 2^-60.
    fn is_unit(&self) -> bool {
        let e: IBig = (IBig::from(1) << (2 * self.fraction)) - &self.a;
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
        let k = if second { -&self.k } else { self.k.clone() };
        let turned = Self { a: self.a.clone(), k, c: self.c.clone(), fraction: self.fraction };
        let (low, high) = (&t - IBig::from(within), &t + IBig::from(within));
        let beyond = |t: &IBig| &turned.a * t + (&turned.k << 10) >= IBig::ZERO;
        turned.at(&low) >= IBig::ZERO && !beyond(&low) && (turned.at(&high) <= IBig::ZERO || beyond(&high))
    }
    /// Holds what a kernel says against the exact roots; `true` if it hits.
    fn check<N: Into<i64>>(&self, ends: Attempt<[N; 2]>, extra_bits: i32, within: i64, line: &str) -> bool {
        match ends {
            Attempt::Unsure => false,
            Attempt::Miss => {
                assert!(self.misses(), "lost: {line}");
                false
            }
            Attempt::Hit(ends) => {
                assert!(!self.misses(), "phantom: {line}");
                for (end, is_second) in ends.map(N::into).into_iter().zip([false, true]) {
                    assert!(self.is_end(end, extra_bits, is_second, within), "{end} is no end: {line}");
                }
                true
            }
        }
    }
}

/// True if the magnitude is at most so many 1024ths of the other.
fn is_within(beyond: IBig, within: i64, of: IBig) -> bool {
    let (beyond, most) = (beyond << 10, of * IBig::from(within));
    beyond <= most && -beyond <= most
}

/// The result on the grid for a line: its ends, and whether one is ahead.
fn queried<N: Tested>(
    o: [i64; 3],
    extra_bits: i32,
    d: [i64; 3],
    r: i64,
    by_moment: bool,
) -> (Attempt<[i64; 2]>, Attempt<()>) {
    let (o, d, r) = (o.map(N::of), d.map(N::of), N::of(r));
    let ends = || {
        let ends = found!(if by_moment {
            found!(ByMoment::new(o, extra_bits, d, r)).ends(false)
        } else {
            found!(ByApproach::new(o, extra_bits, d, r)).ends()
        });
        Attempt::Hit(ends.map(N::into))
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
    met_balls::<i32>();
    met_balls::<i64>();
}

/// The ends of a round solid are within so many 1024ths of a unit where the radius, less the shift of the divisor, has
/// at least eight bits below the unit: half a unit from rounding, and less than a thirtieth from that of the moment.
/// With fewer bits the latter is up to a fourth.
fn within<N: Tested>(of_unit: i64, r: i64, extra_bits: i32, shift: i32) -> i64 {
    if radius_grid(N::of(r), extra_bits).is_some_and(|(grid, _)| grid - shift >= 8) { of_unit } else { 768 }
}

fn met_balls<N: Tested>() {
    let mut random = Random(1);
    let mut found = 0;
    for _ in 0..LINES {
        let (o, d, r) = line_and_ball::<N>(&mut random);
        let exactly = Exactly::new::<N>(o.map(i128::from), d.map(i128::from), r.into());
        let (extra_bits, r) = units::<N>(r);
        // The closest approach assumes a direction of length 1.
        for (by_moment, within) in
            [(true, within::<N>(if N::BITS == 64 { 528 } else { 560 }, r, extra_bits, 0)), (false, 1024)]
        {
            let has_length_1 = N::GUARDS_APPROACH && exactly.is_unit();
            if !(by_moment || has_length_1) {
                continue;
            }
            let (ends, ahead) = queried::<N>(o, extra_bits, d, r, by_moment);
            let line = std::format!("{o:?} {d:?} {r}, extra bits: {extra_bits}, by moment: {by_moment}");
            found += u32::from(exactly.check(ends, extra_bits, within, &line));
            match (ahead, ends) {
                (Attempt::Unsure, _) | (_, Attempt::Unsure) => {}
                (ahead, Attempt::Miss) => assert_eq!(ahead, Attempt::Miss, "missed, but met ahead: {line}"),
                (Attempt::Miss, Attempt::Hit([_, high])) => assert!(high < 0, "{high} is ahead: {line}"),
                (Attempt::Hit(()), Attempt::Hit([_, high])) => assert!(high >= 0, "{high} is not ahead: {line}"),
            }
        }
    }
    // With 64 bits by both methods.
    let least = if N::GUARDS_APPROACH { LINES * 9 / 10 } else { LINES / 2 };
    assert!(found > least, "{found}");
}

#[test]
fn cylinders_are_met_where_they_are() {
    met_cylinders::<i32>();
    met_cylinders::<i64>();
}

fn met_cylinders<N: Tested>() {
    let mut random = Random(2);
    let mut found = 0;
    for _ in 0..LINES {
        let (o, d, r) = line_and_ball::<N>(&mut random);
        let exactly = Exactly::new::<N>([o[0], 0, o[2]].map(i128::from), [d[0], 0, d[2]].map(i128::from), r.into());
        let (extra_bits, r) = units::<N>(r);
        let line = std::format!("{o:?} {d:?} {r}, extra bits: {extra_bits}");
        let across = N::Normalized::new(N::squared_length([N::of(d[0]), N::of(d[2])]));
        let of_unit = within::<N>(560, r, extra_bits, across.map_or(0, Normalized::shift));
        let ends = cylinder(o.map(N::of), extra_bits, d.map(N::of), N::of(r), false);
        found += u32::from(exactly.check(ends, extra_bits, of_unit, &line));
    }
    assert!(found > LINES / 4, "{found}");
}

#[test]
fn planes_are_met_where_they_are() {
    met_planes::<i32>();
    met_planes::<i64>();
}

fn met_planes<N: Tested>() {
    let mut random = Random(3);
    let mut found = 0;
    for _ in 0..LINES {
        let (o, d, fine) = line_and_ball::<N>(&mut random);
        let (extra_bits, y) = units::<N>(fine);
        let Attempt::Hit([first, second]) = crossings(N::of(o[1]), extra_bits, N::of(d[1]), [N::of(y), N::ZERO]) else {
            continue;
        };
        found += 1;
        for (t, y) in [(first, fine), (second, 0)] {
            let t: i64 = t.into();
            // dy (t -+ 1/2 and a bit) on both sides of the height
            let beyond = (IBig::from(y - o[1]) << N::FRACTION as usize)
                - (IBig::from(t) << extra_bits as usize) * IBig::from(d[1]);
            let unit = IBig::from(d[1].unsigned_abs()) << extra_bits as usize;
            assert!(is_within(beyond, 560, unit), "{t}: {o:?} {d:?} {y}");
        }
        match height(N::of(o[1]), extra_bits, N::of(d[1]), first) {
            Attempt::Hit(there) => assert!((there.into() - y).abs() <= 1, "{there:?}: {o:?} {d:?} {y}"),
            _ => assert!(first.top() >> 24 != 0, "{o:?} {d:?} {y}"),
        }
    }
    assert!(found > LINES / 4, "{found}");
}

/// Numbers of all sizes that a type accepts, of either sign.
pub(super) fn coordinate(random: &mut Random, bits: u64) -> i64 {
    let n = random.sized(bits);
    if random.below(2) == 0 { n } else { -n }
}

/// Words of all sizes.
pub(super) fn words() -> impl Iterator<Item = u64> {
    let mut state = 1_u64;
    (0..400_000).map(move |_| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        state ^ (state >> 29)
    })
}

#[test]
fn half_a_unit_is_rounded_to_even() {
    assert_eq!([-6, -5, -3, -2, -1, 0, 1, 2, 3, 5, 6].map(|n| round_off(n, 1)), [-3, -2, -2, -1, 0, 0, 0, 1, 2, 2, 3]);
}

#[test]
fn directions_are_within_a_hair_of_half_a_unit() {
    let all = [i32::MIN, i32::MAX, -1 << 30, (-1 << 30) - 1, 1 << 30, (1 << 30) - 1, 1, 0, -1, 3, -4];
    let special = all.into_iter().flat_map(|x| all.into_iter().flat_map(move |y| all.map(move |z| [x, y, z])));
    let shrunk = |word: u64, by: u64| word as i32 >> (by % 31);
    let mixed = words().zip(words().skip(1)).map(|(a, b)| {
        let by = a >> 40;
        [shrunk(a, by % 3), shrunk(b, by / 3 % 5), shrunk(b >> 32, by / 15)].map(|c| shrunk(c as u64, 2 + by % 29))
    });
    for v in special.chain(mixed) {
        let Attempt::Hit(got) = direction(v) else {
            let large = v.iter().fold(0, |all, &c| all | c.unsigned_abs()) >= i32::MAX as u32;
            assert!(large || v == [0; 3], "no direction of {v:?}");
            continue;
        };
        let exact = v.map(f64::from);
        let length = exact.iter().map(|c| c * c).sum::<f64>().sqrt();
        for (got, exact) in got.iter().zip(exact) {
            let error = (f64::from(*got) - exact / length * f64::from(1 << 30)).abs();
            assert!(error <= 0.51, "{v:?} has the direction {got}, {error} off");
        }
        let Attempt::Hit(mirrored) = direction(v.map(i32::wrapping_neg)) else { continue };
        assert_eq!(mirrored, got.map(|c| -c), "{v:?}");
    }
}

/// A line that is steeper than the side, far away from the nappe that it will enter: neither the place of the entry nor
/// that it is still ahead is certain.
#[test]
fn a_nappe_that_begins_somewhere_beyond_is_unclear() {
    let (o, d) = ([15487837, -82574188, 2456411], [-802209627, 669821284, 246415638]);
    assert_eq!(nappe(o, 6, d, Nappe::of_radii([273, 73268, 16384]), false), Attempt::Unsure);
    // In the opposite direction the line ends there.
    assert_eq!(nappe(o, 6, d.map(|c| -c), Nappe::of_radii([273, 73268, 16384]), false), Attempt::Unsure);
}

/// `a . (b x c)`, exactly.
fn volume(a: [i128; 3], b: [i128; 3], c: [i128; 3]) -> i128 {
    let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
    a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1)
}

/// Triangles of all sizes and proportions, near and far, hit, missed and aimed at their edges: the results are those of
/// exact arithmetic, and `t` is within a unit.
#[test]
fn a_triangle_is_met_where_exact_arithmetic_says() {
    let mut random = words();
    let mut next = |bits: u64| random.next().map_or(0, |word| (word as i64 >> (64 - bits)) as i32);
    let (mut found, mut missed, mut unsure) = (0, 0, 0);
    for round in 0..20_000 {
        let bits = 3 + round % 27;
        let vertices = [(); 3].map(|()| [next(bits), next(bits), next(bits)]);
        let origin = [(); 3].map(|()| next(4 + (round * 7) % 26));
        // Aimed at a point of its plane; about half of these lie inside.
        let (u, v) = (next(31) as i128, next(31) as i128);
        let aim = [0, 1, 2].map(|i| {
            let [a, b, c] = vertices.map(|vertex| vertex[i] as i128);
            (a << 30) + (b - a) * u + (c - a) * v - ((origin[i] as i128) << 30)
        });
        let length = (aim.iter().map(|c| c * c).sum::<i128>() >> 40).isqrt() << 20;
        if length == 0 {
            continue;
        }
        let d = aim.map(|c| (((c << 20) / (length >> 10)) as i64).clamp(-1 << 30, 1 << 30) as i32);
        let seen = vertices.map(|vertex| [0, 1, 2].map(|i| vertex[i] as i128 - origin[i] as i128));
        let along = d.map(|c| c as i128);
        let [a, b, c] = seen;
        let volumes = [volume(along, a, b), volume(along, b, c), volume(along, c, a)];
        let inside = volumes.iter().all(|v| *v > 0) || volumes.iter().all(|v| *v < 0);
        match triangle(origin, 0, d, vertices) {
            Attempt::Hit((t, from_front)) => {
                found += 1;
                assert!(inside, "{vertices:?} from {origin:?} along {d:?}");
                assert_eq!(from_front, volumes[0] < 0);
                // t = a . n / d . n, with d in units of 2^-30
                let (numerator, denominator) = (volume(a, b, c) << 30, volumes.iter().sum::<i128>());
                let off = (t as i128 * denominator - numerator).unsigned_abs();
                assert!(off <= denominator.unsigned_abs(), "{t}: {vertices:?} from {origin:?} along {d:?}");
            }
            Attempt::Miss => {
                missed += 1;
                assert!(!inside, "{vertices:?} from {origin:?} along {d:?}");
            }
            Attempt::Unsure => unsure += 1,
        }
    }
    assert!(found > 1_500 && missed > 10_000 && unsure < 5_000, "{found} found, {missed} missed, {unsure} unsure");
}
