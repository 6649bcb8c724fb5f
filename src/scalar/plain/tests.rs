use super::*;

/// Words of all sizes.
fn words() -> impl Iterator<Item = u64> {
    let mut state = 1_u64;
    (0..400_000).map(move |_| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        state ^ (state >> 29)
    })
}

#[test]
fn root_is_within_one() {
    let normalized = words().map(|n| if n >> 62 == 0 { n | 1 << 62 } else { n });
    let squares = (1 << 31..1_u64 << 32).step_by(54_321).flat_map(|n| [n * n - 1, n * n, n * n + 1]);
    let bytes = (64..256).flat_map(|n| [n << 56, (n << 56) + (1 << 56) - 1, (n << 56) + (1 << 55)]);
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
    let bytes = (128..256).flat_map(|n| [n << 24, (n << 24) + (1 << 24) - 1, (n << 24) + (1 << 23)]);
    for n in words().map(|n| n as u32 | 1 << 31).chain(bytes).chain([1 << 31, u32::MAX]) {
        let got = reciprocal_of_normalized(n) as u64;
        let quotient = (1_u64 << 63) / n as u64;
        assert!(got.abs_diff(quotient.min(u32::MAX as u64)) <= 1, "1 / {n:#x} = {got}, not {quotient}");
    }
}

#[test]
fn half_a_unit_is_rounded_to_even() {
    assert_eq!([-6, -5, -3, -2, -1, 0, 1, 2, 3, 5, 6].map(|n| round_off(n, 1)), [-3, -2, -2, -1, 0, 0, 0, 1, 2, 2, 3]);
}
#[test]
fn adhoc() {
    extern crate std;
    use crate::scalar::Plain;
    use std::println;
    let mut s = 77_u64;
    let mut next = |size: i32| {
        s ^= s >> 12;
        s ^= s << 25;
        s ^= s >> 27;
        let n = (s.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 32) as u32;
        ((n % (2 * size as u32 * 1024 + 1)) as i32 - size * 1024) * 64
    };
    let (mut u, mut v, mut w, mut m, mut n) = (0, 0, 0, 0, 0);
    for _ in 0..100000 {
        let o = [next(6), next(6), next(6)];
        let t = [next(2), next(2), next(2)];
        let d = [0, 1, 2].map(|i| (t[i] - o[i]) as f64);
        let l = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        let d = d.map(|c| (c / l * (1 << 30) as f64).round() as i32);
        n += 1;
        match tube(o, 0, d, 65536) {
            Plain::Unclear => {
                u += 1;
                if u < 12 {
                    let a = (d[0] as f64 / 2f64.powi(30)).powi(2) + (d[2] as f64 / 2f64.powi(30)).powi(2);
                    println!("{o:?} {:?} a {a}", d.map(|c| c as f64 / 2f64.powi(30)))
                }
            }
            Plain::Miss => m += 1,
            Plain::Found([a, b]) => {
                let a2 = (d[0] as f64 / 2f64.powi(30)).powi(2) + (d[2] as f64 / 2f64.powi(30)).powi(2);
                let k = (o[0] as f64 * d[0] as f64 + o[2] as f64 * d[2] as f64) / 2f64.powi(30);
                let c = o[0] as f64 * o[0] as f64 + o[2] as f64 * o[2] as f64 - 65536.0 * 65536.0;
                let r = (k * k - a2 * c).sqrt();
                let (x, y) = ((-k - r) / a2, (r - k) / a2);
                if (x - a as f64).abs() > 0.53 || (y - b as f64).abs() > 0.53 {
                    v += 1;
                    if v < 10 {
                        println!("{a} {x} {b} {y}")
                    }
                }
            }
        }
        match crossings(o[1], 0, d[1], [0, 98304]) {
            Plain::Unclear => {
                w += 1;
                if w < 5 {
                    println!("cross {} {}", o[1], d[1])
                }
            }
            _ => {}
        }
    }
    println!("{n} unclear {u} wrong {v} miss {m} cross unclear {w}");
}
