use super::*;
use core::fmt::Debug;

/// Compares with exact arithmetic: the numbers of crossings inwards and outwards, of lines inside, of misses, and of
/// unsure results.
fn agree<N: Length + Debug + TryFrom<i128> + Into<i128>>(bits: u32, extra_bits: i32) -> [u32; 5]
where
    <N as TryFrom<i128>>::Error: Debug,
{
    let mut state = 1_u64;
    let mut below = |n: i128| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as i128 * (2 * n + 1)) / (1 << 53) - n
    };
    let number = |n: i128| N::try_from(n).expect("within the type");
    let unit = 1_i128 << N::FRACTION;
    let mut counted = [0; 5];
    for round in 0..60_000_u32 {
        let size = 1_i128 << (3 + round % bits);
        let point = [0; 3].map(|_: i32| below(size));
        let normal = [0; 3].map(|_: i32| below(1 << (1 + (round / 3) % bits)));
        let o = [0; 3].map(|_: i32| below(size << extra_bits));
        let mut d = [0; 3].map(|_: i32| below(unit / 2));
        // In every fifth round along an axis, in every seventh nearly along the plane.
        if round % 5 == 0 {
            d = [unit, 0, 0];
        } else if round % 7 == 0 && normal[2] != 0 {
            d[2] = -(normal[0] * d[0] + normal[1] * d[1]) / normal[2];
        }
        if normal == [0; 3] || d.iter().any(|c| c.abs() > unit) {
            continue;
        }
        let dot = |a: [i128; 3], b: [i128; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let seen = [0, 1, 2].map(|i| (point[i] << extra_bits) - o[i]);
        let (distance, slope) = (dot(normal, seen), dot(normal, d));
        let plane = [point.map(number), normal.map(number)];
        let found = half_space(o.map(number), extra_bits, d.map(number), plane);
        // The error of the direction of a framed line, in its own units.
        let is_far = |limit: i128| (distance.abs() << N::FRACTION) >> extra_bits > slope.abs() * limit;
        let index = match found {
            Attempt::Hit(Crossed::Enters(t) | Crossed::Leaves(t)) => {
                let leaves = matches!(found, Attempt::Hit(Crossed::Leaves(_)));
                assert_eq!(leaves, slope > 0, "{o:?} {d:?} {plane:?}");
                // |t - distance 2^FRACTION / (slope 2^extra_bits)| <= 3/4
                let t: i128 = t.into();
                let off = ((t * slope) << extra_bits) - (distance << N::FRACTION);
                assert!(4 * off.abs() <= (3 * slope.abs()) << extra_bits, "{o:?} {d:?} {plane:?}: {t}");
                usize::from(leaves)
            }
            Attempt::Hit(Crossed::Inside) => {
                assert!(distance > 0 && is_far(2 * unit), "{o:?} {d:?} {plane:?}");
                2
            }
            Attempt::Miss => {
                assert!(distance < 0 && is_far(2 * unit), "{o:?} {d:?} {plane:?}");
                3
            }
            Attempt::Unsure => 4,
        };
        counted[index] += 1;
    }
    counted
}

fn is_usual([enters, leaves, inside, misses, unsure]: [u32; 5], most_unsure: u32) -> bool {
    enters > 10_000 && leaves > 10_000 && inside > 50 && misses > 50 && unsure < most_unsure
}

#[test]
fn crossings_are_those_of_exact_arithmetic_in_32_bits() {
    let found = agree::<i32>(20, 0);
    assert!(is_usual(found, 6_000), "{found:?}");
    let framed = agree::<i32>(16, 8);
    assert!(is_usual(framed, 20_000), "{framed:?}");
}

#[test]
fn crossings_are_those_of_exact_arithmetic_in_64_bits() {
    let found = agree::<i64>(30, 0);
    assert!(is_usual(found, 6_000), "{found:?}");
}
