use super::*;
use crate::number::machine::reciprocal_of_normalized;
use crate::scalar::Attempt;
use crate::scalar::integers::direction::direction;
use crate::scalar::integers::length::Stretch;
use crate::scalar::integers::tests::words;

#[test]
fn root_is_within_one() {
    let normalized = words().map(|n| if n >> 62 == 0 { n | 1 << 62 } else { n });
    let squares = (1 << 31..1_u64 << 32).step_by(54_321).flat_map(|n| [n * n - 1, n * n, n * n + 1]);
    let bytes = (64..256).flat_map(|n| [n << 56, (n << 56) | ((1 << 56) - 1), (n << 56) | (1 << 55)]);
    for n in normalized.chain(squares).chain(bytes).chain([1 << 62, u64::MAX]).filter(|n| n >> 62 != 0) {
        let got = root_of_normalized((n >> 32) as u32, n as u32);
        let floor = n.isqrt() as u32;
        assert!(got.abs_diff(floor) <= 1, "root({n:#x}) = {got}, not {floor}");
    }
}

#[test]
fn root_of_any_size_is_within_one() {
    for n in words().map(|n| n >> 2 >> (n % 29)).filter(|n| n >> 32 != 0) {
        let (got, floor) = (root(n), n.isqrt() as u32);
        assert!(got.abs_diff(floor) <= 1, "root({n:#x}) = {got}, not {floor}");
    }
    for n in (1 << 16..1_u64 << 31).step_by(54_321) {
        if n * n < 1 << 58 {
            assert_eq!(root(n * n), n as u32, "a square has its root");
        }
    }
}

#[test]
fn reciprocal_is_at_most_one_less() {
    let bytes = (128..256).flat_map(|n| [n << 24, (n << 24) | ((1 << 24) - 1), (n << 24) | (1 << 23)]);
    for n in words().map(|n| n as u32 | 1 << 31).chain(bytes).chain([1 << 31, u32::MAX]) {
        let got = reciprocal_of_normalized(n) as u64;
        let quotient = (1_u64 << 63) / n as u64;
        assert!(got.abs_diff(quotient.min(u32::MAX as u64)) <= 1, "1 / {n:#x} = {got}, not {quotient}");
    }
}

/// The line in the frame of a matrix compared with one in doubles, which hold it exactly: the origin within its own
/// unit, the direction within little more than a unit of its type, the inverse length to all its bits.
#[test]
fn a_stretched_line_is_the_matrix_times_the_line() {
    let mut words = words();
    let mut next = move || words.next().unwrap_or(1);
    let (mut tried, mut found) = (0, 0);
    while tried < 20_000 {
        let mut vector = |bits: u32| [next(), next(), next()].map(|word| word as i32 >> (31 - bits));
        let sizes = 8 + (tried as u32 * 7) % 23;
        let (o, position) = (vector(sizes), vector(sizes.min(12 + tried as u32 % 17)));
        let Attempt::Hit(d) = direction(vector(29)) else { continue };
        // Also with lengths that differ from 1 by 2^-20, as directions that were rounded elsewhere may have.
        let d = d.map(|c| c + (c >> 20) * (tried % 3 - 1));
        let rows = [vector(30), vector(30), vector(30)];
        let spread = tried % 12;
        let exponents = [0, 1, 2].map(|i| (tried / 7 + i * spread) % 13 - 6);
        tried += 1;
        let stored = [0, 1, 2].map(|i| (rows[i], exponents[i]));
        let longest = 1 << (4 + tried % 20);
        let Some(line) = i32::stretched(o, d, position, stored, longest) else { continue };
        found += 1;
        let of = |v: [f64; 3]| {
            [0, 1, 2].map(|i| {
                let row = rows[i].map(|c| f64::from(c) * 2.0_f64.powi(exponents[i] - 30));
                row[0] * v[0] + row[1] * v[1] + row[2] * v[2]
            })
        };
        let d = d.map(|c| f64::from(c) * 2.0_f64.powi(-30));
        let start = f64::from(line.start);
        let origin = of([0, 1, 2].map(|i| f64::from(o[i]) - f64::from(position[i]) + start * d[i]));
        let unit = 2.0_f64.powi(-line.scale - line.extra_bits);
        for (got, exact) in line.origin.into_iter().zip(origin) {
            assert!((f64::from(got) * unit - exact).abs() <= 1.1 * unit, "{line:?} of {o:?} {position:?} {stored:?}");
            assert!(got.unsigned_abs() >> 30 == 0);
        }
        let along = of(d);
        let length = along.iter().map(|c| c * c).sum::<f64>().sqrt();
        for (got, exact) in line.direction.into_iter().zip(along) {
            let off = (f64::from(got) - exact / length * 2.0_f64.powi(30)).abs();
            assert!(off <= 1.3, "{line:?} {along:?} {off}");
        }
        let inverse_length =
            f64::from(line.inverse_length.digits) * 2.0_f64.powi(line.scale - line.inverse_length.shift as i32);
        assert!((inverse_length * length - 1.0).abs() <= 2.0_f64.powi(-29), "{line:?} {inverse_length} {length}");
        assert!(
            inverse_length * 2.0_f64.powi(-line.scale) <= 0.5
                && line.extra_bits >= i32::FINER
                && (longest << line.scale << line.extra_bits) >> 30 == 0
        );
    }
    assert!(found > tried / 4, "{found} of {tried}");
}

/// A ray along a row of a matrix that only turns: the longest component of its image is close to a power of two, with
/// either sign.
#[test]
fn a_line_along_a_row_keeps_its_direction() {
    let mut words = words();
    let mut next = move || words.next().unwrap_or(1);
    let mut found = 0;
    for index in 0..20_000 {
        let vector = [next(), next(), next()].map(|word| word as i32 >> 2);
        let Attempt::Hit(row) = direction(vector) else { continue };
        let axis = index % 3;
        let rows = [0, 1, 2].map(|i| (if i == axis { row } else { [0; 3] }, 0));
        for d in [row, row.map(|c| -c)] {
            let Some(line) = i32::stretched([5 << 16; 3], d, [0; 3], rows, 1 << 16) else { continue };
            found += 1;
            let along = [0, 1, 2].map(|i| if i == axis { if d == row { 1 << 30 } else { -1 << 30 } } else { 0 });
            for (got, along) in line.direction.into_iter().zip(along) {
                assert!(got.abs_diff(along) <= 1, "{line:?} of {d:?} {row:?}");
            }
        }
    }
    // Components that would need another bit are left to wider numbers.
    assert!(found > 20_000, "{found}");
}
