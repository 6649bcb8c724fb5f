use super::{passes, passes_wide};

const ONE: i32 = 1 << 30;

#[test]
fn a_line_passes_a_post_or_not() {
    let to_the_side = [ONE, 0, 0];
    let up = [0, ONE, 0];
    for (aside, is_passed) in [(0, false), (90_000, false), (100_000, false), (101_000, true), (1 << 28, true)] {
        assert_eq!(passes([7_000, 5_000, aside], to_the_side, up, 100_000), is_passed, "{aside}");
        let wide = [7_000 << 30, 5_000 << 30, i64::from(aside) << 30];
        assert_eq!(passes_wide(wide, to_the_side, up, 100_000 << 30), is_passed, "{aside}");
    }
}

#[test]
fn lines_along_the_axis_of_a_large_radius_and_across_the_budget_are_in_doubt() {
    let up = [0, ONE, 0];
    assert!(!passes([1_000, 0, 0], up, up, 1));
    assert!(!passes([1 << 20, 0, 0], [ONE, 0, 0], up, i32::MAX));
    assert!(!passes_wide([1 << 20, 0, 0], [ONE, 0, 0], up, i64::MAX));
    assert!(!passes([0; 3], [ONE, 0, 0], up, 0));
    assert!(!passes([i32::MIN, 0, 1 << 29], [-ONE, 0, 1 << 28], up, 1 << 20));
    assert!(!passes_wide([i64::MIN, 0, 1 << 61], [-ONE, 0, 1 << 28], up, 1 << 52));
}
