//! Instructions a question.

use crate::clock;
use core::hint::black_box;

/// A measurement goes on until it took this many instructions, so that the grain of the clock does not show.
const ENOUGH: u64 = 2_000 * clock::GRAIN;

/// Without a clock, on the host, it goes on no longer than this.
const MOST_ROUNDS: u64 = 1 << 16;

/// Instructions for all inputs, `rounds` times.
#[inline(never)]
fn run<P, I>(subject: &P, inputs: &[I], question: fn(&P, &I), rounds: u64) -> u64 {
    let start = clock::instructions();
    for _ in 0..rounds {
        for input in inputs {
            question(black_box(subject), black_box(input));
        }
    }
    clock::instructions() - start
}

/// A question that asks nothing.
#[inline(never)]
fn nothing<P, I>(subject: &P, input: &I) {
    black_box((subject, input));
}

/// Instructions a question, in the mean over the inputs: what a function takes that asks it, less what a function takes that
/// does nothing.
pub fn instructions<P, I>(subject: &P, inputs: &[I], question: fn(&P, &I)) -> u64 {
    // The compiler must not know which function it is: it would make a copy of the loop for each.
    let (question, nothing) = (black_box(question), black_box(nothing::<P, I> as fn(&P, &I)));
    let mut rounds = 1;
    let taken = loop {
        let taken = run(subject, inputs, question, rounds);
        if taken >= ENOUGH || rounds >= MOST_ROUNDS {
            break taken;
        }
        rounds *= 2;
    };
    let questions = rounds * inputs.len() as u64;
    let net = taken.saturating_sub(run(subject, inputs, nothing, rounds));
    (net + questions / 2) / questions
}
