//! Lines that a frame has rounded: the true line differs from the given one by up to three quarters of the origin's
//! unit and of the direction's. (The rounding of a coordinate is half of that, that of the axes a part.) What the
//! kernels decide holds for the true line, and their ends are less than a unit off.

use super::*;
use departing::exit_from_round;

/// Quarters of a unit by which a true line differs.
const QUARTERS: u64 = 3;

/// A line at a ball or a cylinder: as given, with an origin that has so many extra bits, and as it is, in quarters of
/// the units.
struct Rounded {
    o: [i64; 3],
    d: [i64; 3],
    /// In the type's unit.
    r: i64,
    extra_bits: i32,
    true_o: [i128; 3],
    true_d: [i128; 3],
    true_r: i128,
}

impl Rounded {
    /// `None` for coordinates that are too large for quarters.
    fn new<N: Tested>(random: &mut Random) -> Option<Self> {
        let (o, d, r) = line_and_ball::<N>(random);
        let most = if N::BITS == 32 { 12 } else { N::FINER };
        let extra_bits = N::FINER + random.below((most - N::FINER + 1) as u64) as i32;
        // A turned line has as many extra bits as its solid has room for.
        let r = (r >> extra_bits).max(1);
        if o.iter().chain([&(r << extra_bits)]).any(|length| length.unsigned_abs() >> (N::FRACTION - 3) != 0) {
            return None;
        }
        let mut off = |n: i64| 4 * i128::from(n) + i128::from(random.below(2 * QUARTERS + 1)) - i128::from(QUARTERS);
        let (true_o, true_d) = (o.map(&mut off), d.map(off));
        Some(Self { o, d, r, extra_bits, true_o, true_d, true_r: 4 * i128::from(r << extra_bits) })
    }
}

#[test]
fn balls_are_met_where_the_true_line_meets_them() {
    met_round::<i32>(true, 768);
    met_round::<i64>(true, 768);
}

#[test]
fn cylinders_are_met_where_the_true_line_meets_them() {
    met_round::<i32>(false, 640);
    met_round::<i64>(false, 640);
}

fn met_round<N: Tested>(is_ball: bool, of_unit: i64) {
    let mut random = Random(21);
    let (mut found, mut missed) = (0, 0);
    for _ in 0..LINES {
        let Some(line) = Rounded::new::<N>(&mut random) else { continue };
        let Rounded { o, d, r, extra_bits, true_o, true_d, true_r } = line;
        let across = |[x, y, z]: [i128; 3]| [x, if is_ball { y } else { 0 }, z];
        let exactly = Exactly::new::<N>(across(true_o), across(true_d), true_r);
        let (given_o, given_d, given_r) = (o.map(N::of), d.map(N::of), N::of(r));
        let ends = if is_ball {
            match ByMoment::new(given_o, extra_bits, given_d, given_r) {
                Attempt::Hit(ball) => ball.ends(true),
                Attempt::Miss => Attempt::Miss,
                Attempt::Unsure => Attempt::Unsure,
            }
        } else {
            cylinder(given_o, extra_bits, given_d, given_r, true)
        };
        let told = std::format!("{o:?} {d:?} {r}, extra bits: {extra_bits}, in truth {true_o:?} {true_d:?}");
        missed += u32::from(matches!(ends, Attempt::Miss));
        found += u32::from(exactly.check(ends, extra_bits, of_unit, &told));
    }
    assert!(found > LINES / 20 && missed > LINES / 100, "{found} {missed}");
}

#[test]
fn planes_are_crossed_where_the_true_line_crosses_them() {
    crossed_planes::<i32>();
    crossed_planes::<i64>();
}

fn crossed_planes<N: Tested>() {
    let mut random = Random(22);
    let mut found = 0;
    for _ in 0..LINES {
        let Some(line) = Rounded::new::<N>(&mut random) else { continue };
        let Rounded { o, d, r: y, extra_bits, true_o, true_d, true_r: true_y } = line;
        let Attempt::Hit([t, _]) = crossings(N::of(o[1]), extra_bits, N::of(d[1]), [N::of(y); 2]) else { continue };
        found += 1;
        let dy = IBig::from(true_d[1]);
        let beyond = (IBig::from(true_y - true_o[1]) << N::FRACTION as usize)
            - (IBig::from(t.into()) << extra_bits as usize) * &dy;
        let unit = IBig::from(true_d[1].unsigned_abs()) << extra_bits as usize;
        assert!(is_within(beyond, 640, unit), "{t:?}: {o:?} {d:?} {y} {extra_bits}");
    }
    assert!(found > LINES / 10, "{found}");
}

#[test]
fn departing_lines_leave_where_the_true_line_leaves() {
    left_round::<i32>();
    left_round::<i64>();
}

/// The other root of `a t^2 + 2 k t`.
fn left_round<N: Tested>() {
    let mut random = Random(23);
    let mut found = 0;
    for round in 0..LINES {
        let Some(line) = Rounded::new::<N>(&mut random) else { continue };
        let Rounded { o, d, extra_bits, true_o, true_d, .. } = line;
        let is_ball = round % 2 == 0;
        let Attempt::Hit(t) = exit_from_round(o.map(N::of), extra_bits, d.map(N::of), is_ball) else { continue };
        found += 1;
        let across = |[x, y, z]: [i128; 3]| [x, if is_ball { y } else { 0 }, z];
        let Exactly { a, k, .. } = Exactly::new::<N>(across(true_o), across(true_d), 0);
        let beyond = (IBig::from(t.into()) << extra_bits as usize) * &a + (k << 1);
        assert!(is_within(beyond, 640, a << extra_bits as usize), "{t:?}: {o:?} {d:?} {extra_bits} {is_ball}");
    }
    assert!(found > LINES / 10, "{found}");
}
