//! How much the tests do: a quick look for everybody, and the same at length in `.ci/long`.

use std::sync::LazyLock;

/// How many times as much the long form does.
const LONG: u64 = 25;

static IS_LONG: LazyLock<bool> = LazyLock::new(|| std::env::var_os("RAYLET_LONG").is_some());

/// One of two amounts: of a quick look, or, if the environment has `RAYLET_LONG`, of the long form.
pub fn amount<N>(quick: N, long: N) -> N {
    if *IS_LONG { long } else { quick }
}

/// So many random cases, or as many times more in the long form.
pub fn times(cases: u64) -> u64 {
    amount(cases, cases * LONG)
}
