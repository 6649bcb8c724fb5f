use super::*;
use crate::number::{Estimate, Robust};
use crate::random::Random;
use crate::scalar::FromScalar;
use core::cmp::Ordering;

type Wide = Robust<u128>;

/// A coordinate of a line that is translated, moved and turned: the error is within the bound, and at times within
/// a factor of 2^9 of it, so that the bound says something.
#[test]
fn a_coordinate_is_within_its_bound() {
    let rounds = if std::env::var_os("RAYLET_LONG").is_some() { 10_000_000 } else { 300_000 };
    let (mut random, mut reached) = (Random(7), false);
    for _ in 0..rounds {
        let size = libm::exp2(random.between(-40.0, 30.0));
        let mut number = |size: f64| random.between(-size, size) as f32;
        let (o, p, d, k) = ([(); 3].map(|()| number(size)), [(); 3].map(|()| number(size)), [(); 3], number(size));
        let (d, row) = (d.map(|()| number(1.0)), [(); 3].map(|()| number(1.0)));
        let near = |i: usize| {
            let moved = Doubled::exact(k) * Doubled::exact(d[i]);
            [Doubled::difference(o[i], p[i]) + moved, Doubled::exact(row[i])]
        };
        let Doubled { value, magnitude } = Doubled::sum([near(0), near(1), near(2)]);
        let wide = <Wide as FromScalar<f32>>::scalar;
        let near = |i: usize| [wide(o[i]) - wide(p[i]) + wide(k) * wide(d[i]), wide(row[i])];
        let exact = Wide::sum([near(0), near(1), near(2)]);
        let off = (exact - (wide(value.high) + wide(value.low))).magnitude();
        let bound = wide(magnitude).scaled(2 * <f32 as Real>::ROUNDING + DOUBT);
        assert_ne!(off.compare(bound), Some(Ordering::Greater), "{o:?} {p:?} {d:?} {k:?} {row:?}");
        reached |= off.compare(bound.scaled(-9)) == Some(Ordering::Greater);
    }
    assert!(reached);
}
