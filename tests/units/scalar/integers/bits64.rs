use super::digits::{joined, root_of_normalized};
use super::*;
use crate::scalar::integers::length::Stretch;
use crate::scalar::integers::tests::{LINES, Random, coordinate, unit};
use dashu_int::IBig;

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
        let longest = 1 << (20 + index % 24);
        let Some(line) = i64::stretched(o, d, position, rows, longest) else { continue };
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
            let places = 62 - exponent - line.scale - i64::FINER;
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
