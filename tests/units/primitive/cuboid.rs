use super::*;
use crate::primitive::Rectangle;
use crate::tier::Stable;
use fixed::types::{I16F16, I32F32};

/// For rays from a few units away at a cuboid and at a rectangle, the percentage that the grid leaves to the
/// solver.
fn unsure<S: GridScalar>() -> [usize; 2] {
    let n = |value: f64| S::from_f64(value).expect("within the type");
    let brick = Cuboid::new(n(1.25), n(0.75), n(1.0)).expect("sizes");
    let table = Rectangle::new(n(1.25), n(1.0)).expect("sizes");
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 40) as f64 / f64::from(1 << 23) - 1.0
    };
    let mut left = [0; 2];
    for _ in 0..10_000 {
        let [origin, target] = [6.0, 1.25].map(|far| [random() * far, random() * far, random() * far]);
        let along = core::array::from_fn(|i| target[i] - origin[i]);
        let direction = UnitVec3::<S>::from_f64(along).expect("a length").to_array();
        let line = LocalLine::along(origin.map(n), direction, S::ZERO);
        left[0] += usize::from(brick.meets_on_grid::<Stable>(&line) == Attempt::Unsure);
        left[1] += usize::from(table.meets_on_grid::<Stable>(&line) == Attempt::Unsure);
    }
    left.map(|count| count.div_ceil(100))
}

#[test]
fn the_grid_decides_nearly_all_rays() {
    for left in [unsure::<I16F16>(), unsure::<I32F32>()] {
        assert!(left[0] <= 2 && left[1] <= 2, "{left:?}");
    }
}
