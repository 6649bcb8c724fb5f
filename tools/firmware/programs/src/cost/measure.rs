//! Instructions and stack of a query.

use crate::stack::{depth, used_since};
use core::hint::black_box;
use raylet_firmware::clock;

/// A measurement goes on until it took this many instructions, so that the grain of the clock does not show.
const ENOUGH: u64 = 2_000 * clock::GRAIN;

/// Without a clock, on the host, it goes on no longer than this.
pub const MOST_ROUNDS: u64 = 1 << 16;

/// Instructions for all inputs, `rounds` times.
#[inline(never)]
pub fn run<P, I>(subject: &P, inputs: &[I], query: fn(&P, &I), rounds: u64) -> u64 {
    let start = clock::instructions();
    for _ in 0..rounds {
        for input in inputs {
            query(black_box(subject), black_box(input));
        }
    }
    clock::instructions() - start
}

/// A query that does nothing.
#[inline(never)]
pub fn nothing<P, I>(subject: &P, input: &I) {
    black_box((subject, input));
}

/// Instructions a query, in the mean over the inputs, less those of a function that does nothing.
pub fn instructions<P, I>(subject: &P, inputs: &[I], query: fn(&P, &I)) -> u64 {
    // The compiler must not know which function it is: it would make a copy of the loop for each.
    let (query, nothing) = (black_box(query), black_box(nothing::<P, I> as fn(&P, &I)));
    let mut rounds = 1;
    let taken = loop {
        let taken = run(subject, inputs, query, rounds);
        if taken >= ENOUGH || rounds >= MOST_ROUNDS {
            break taken;
        }
        rounds *= 2;
    };
    let queries = rounds * inputs.len() as u64;
    let net = taken.saturating_sub(run(subject, inputs, nothing, rounds));
    (net + queries / 2) / queries
}

/// Bytes of stack that a query takes at most for these inputs, the caller's frames not counted.
pub fn stack<P, I>(subject: &P, inputs: &[I], query: fn(&P, &I)) -> u64 {
    let start = depth();
    run(subject, inputs, black_box(query), 1);
    used_since(start) as u64
}
