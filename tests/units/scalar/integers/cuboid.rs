use super::*;
use core::cmp::Ordering;
use core::fmt::Debug;

/// A line in quarters of the units of the tested code, so that it can lie between its values.
struct Exactly {
    o: [i128; 3],
    d: [i128; 3],
    half: [i128; 3],
}

/// `n / d`, with a divisor of at least zero. With a divisor of zero it is infinite.
type Quotient = (i128, i128);

fn compared((n, d): Quotient, (m, e): Quotient) -> Ordering {
    (n * e).cmp(&(m * d))
}

impl Exactly {
    /// Both ends, each with the axis of its plane; `None` for a miss.
    fn ends(&self) -> Option<[(Quotient, usize); 2]> {
        let along = |axis: usize, bound: i128| {
            let (o, d) = (self.o[axis], self.d[axis]);
            let sign = if d < 0 { -1 } else { 1 };
            ((bound * self.half[axis] - sign * o, d.abs()), axis)
        };
        let by_t = |a: &(Quotient, usize), b: &(Quotient, usize)| compared(a.0, b.0);
        // A line along the planes is between them, or it misses.
        let crossed = || (0..3).filter(|axis| self.d[*axis] != 0);
        if (0..3).any(|axis| self.d[axis] == 0 && self.o[axis].abs() > self.half[axis]) {
            return None;
        }
        let enter = crossed().map(|axis| along(axis, -1)).max_by(by_t)?;
        let exit = crossed().map(|axis| along(axis, 1)).min_by(by_t)?;
        (compared(enter.0, exit.0) != Ordering::Greater).then_some([enter, exit])
    }
}

/// The numbers of hits, misses and unsure results.
fn agree<N: Length + Debug + TryFrom<i128> + Into<i128>>(unit: u32, bits: u32, extra_bits: i32) -> [u32; 3]
where
    <N as TryFrom<i128>>::Error: Debug,
{
    let mut state = 1_u64;
    let mut below = |n: i128| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as i128 * (2 * n + 1)) / (1 << 53) - n
    };
    let number = |n: i128| N::try_from(n).expect("within the type");
    let mut counted = [0; 3];
    for round in 0..60_000 {
        let size = 1_i128 << (3 + round % bits);
        let half = [0; 3].map(|_: i32| below(size).abs() + 1);
        let o = [0; 3].map(|_: i32| below(size << (extra_bits + (round as i32 / 7) % 3)));
        // At a point of the cuboid or next to it; in every fifth round next to an edge; in every ninth along a plane.
        let mut aim = half.map(|h| below(h + h / 4) << extra_bits);
        if round % 5 == 0 {
            aim[0] = half[0] << extra_bits;
            aim[1] = (half[1] << extra_bits) + below(3);
        }
        let mut along = [0, 1, 2].map(|i| aim[i] - o[i]);
        if round % 9 == 0 {
            along[(round % 3) as usize] = below(1);
        }
        // The start is next to the surface.
        let (o, along) =
            if round % 11 == 0 { (aim.map(|c| c + below(1 << extra_bits)), half.map(&mut below)) } else { (o, along) };
        let length = along.iter().map(|c| c * c).sum::<i128>().isqrt() + 1;
        let d = along.map(|c| (c << unit) / length);
        if d == [0; 3] {
            continue;
        }
        // The line itself: with an error of less than two units, if it is framed.
        let mut off = |n: i128| 4 * n + if extra_bits == 0 { 0 } else { below(7) };
        let exactly = Exactly { o: o.map(&mut off), d: d.map(&mut off), half: half.map(|h| (4 * h) << extra_bits) };
        let ends = exactly.ends();
        let told = |since: Option<N>| cuboid(o.map(number), extra_bits, d.map(number), half.map(number), since);
        let is_near = |t: N, (n, d): Quotient| {
            // In the units of t, multiplied by 2^(unit - extra_bits).
            let (n, d) = (n << unit, d << extra_bits);
            let (n, d) = if d == 0 { (n, 1) } else { (n, d) };
            (t.into() * d - n).abs() <= d
        };
        let found = told(None);
        match (found, ends) {
            (Attempt::Hit(InCuboid { ends: [t, u], axes }), Some([enter, exit])) => {
                assert_eq!(axes[0], enter.1, "{o:?} {d:?} {half:?}");
                assert!(is_near(t, enter.0), "{t:?}: {o:?} {d:?} {half:?}");
                if u == N::MAX {
                    // The exit is in doubt, and only the entry is given.
                    counted[2] += 1;
                } else {
                    assert_eq!(axes[1], exit.1, "{o:?} {d:?} {half:?}");
                    assert!(is_near(u, exit.0), "{u:?}: {o:?} {d:?} {half:?}");
                    counted[0] += 1;
                }
            }
            (Attempt::Hit(_), None) => panic!("found: {o:?} {d:?} {half:?}"),
            (Attempt::Miss, ends) => {
                assert_eq!(ends, None, "missed: {o:?} {d:?} {half:?}");
                counted[1] += 1;
            }
            (Attempt::Unsure, _) => counted[2] += 1,
        }
        match told(Some(N::ZERO)) {
            // The same entry, or the same ends.
            Attempt::Hit(first) => {
                let InCuboid { ends: [t, _], axes } = first;
                assert_eq!(ends.map(|[enter, _]| enter.1), Some(axes[0]), "{o:?} {d:?} {half:?}");
                assert!(ends.is_some_and(|[enter, _]| is_near(t, enter.0)), "{t:?}: {o:?} {d:?} {half:?}");
                assert!(t >= N::ZERO || found == Attempt::Hit(first));
            }
            // It misses, or the interval lies so far behind the start that rounding cannot move it to the start.
            Attempt::Miss => {
                let is_behind = |((n, d), _): (Quotient, usize)| 2 * (n << unit) < -(d << extra_bits);
                assert!(ends.is_none_or(|[_, exit]| is_behind(exit)), "{o:?} {d:?} {half:?}");
            }
            Attempt::Unsure => {}
        }
    }
    counted
}

#[test]
fn slabs_are_crossed_where_exact_arithmetic_says() {
    let counted = [
        agree::<i32>(30, 24, 0),
        agree::<i32>(30, 18, 6),
        agree::<i32>(30, 14, 12),
        agree::<i64>(62, 24, 0),
        agree::<i64>(62, 24, i64::FINER),
    ];
    for [found, missed, unsure] in counted {
        assert!(found > 15_000 && missed > 8_000 && unsure < 20_000, "{counted:?}");
    }
}
