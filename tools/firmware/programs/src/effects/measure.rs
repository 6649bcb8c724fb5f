//! Instructions, stack and colours of a picture.

use crate::stack::{depth, used_since};
use core::fmt::{self, Display};
use core::hint::black_box;
use raylet::effect::Effects;
use raylet::tier::Tier;
use raylet::{Counters, Picture, Pixel, Scalar, Size, TraceContext};
use raylet_firmware::clock;

/// What a picture took.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// Instructions a pixel, in the mean.
    pub instructions: u64,
    /// Bytes of stack that tracing a row takes at most; 0 on the host, which does not measure it.
    pub stack: usize,
    /// Rays, for all pixels.
    pub rays: u64,
    /// A sum over the levels of all pixels: the same for the same picture.
    pub levels: u32,
}

impl Display for Measured {
    /// An object of JSON.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { instructions, stack, rays, levels } = self;
        write!(f, r#"{{"instructions":{instructions},"stack":{stack},"rays":{rays},"levels":{levels}}}"#)
    }
}

/// Measures a picture, row by row.
pub fn picture<S: Scalar, E: Effects, T: Tier<S>>(picture: &Picture<'_, S, E, T>) -> Measured {
    every(1, picture)
}

/// Measures one of so many rows of a picture, from the middle of the first ones on.
pub fn every<S: Scalar, E: Effects, T: Tier<S>>(rows: u16, picture: &Picture<'_, S, E, T>) -> Measured {
    measure(rows, picture.size(), |y, context, sum| levels(black_box(picture).row(y, context), sum))
}

/// The same by spans.
pub fn every_in_spans<S: Scalar, E: Effects, T: Tier<S>>(rows: u16, picture: &Picture<'_, S, E, T>) -> Measured {
    let (start, taken, size) = (depth(), clock::instructions(), picture.size());
    let spans = black_box(picture).in_spans();
    let once = clock::instructions() - taken;
    let stack = used_since(start);
    let mut measured = measure(rows, size, |y, context, sum| levels(black_box(&spans).row(y, context), sum));
    measured.instructions += once / (u64::from(size.width) * u64::from(size.height));
    measured.stack = stack.max(measured.stack + size_of_val(&spans));
    measured
}

/// One of so many rows: `row` traces it, and makes a sum with its levels.
fn measure(rows: u16, size: Size, mut row: impl FnMut(u16, &mut TraceContext, u32) -> u32) -> Measured {
    let mut measured = Measured { instructions: 0, stack: 0, rays: 0, levels: 0 };
    let (mut context, mut instructions, mut pixels) = (TraceContext::new(()), 0, 0);
    for y in (rows / 2..size.height).step_by(rows.into()) {
        let (start, taken) = (depth(), clock::instructions());
        measured.levels = row(y, &mut context, measured.levels);
        instructions += clock::instructions() - taken;
        pixels += u64::from(size.width);
        measured.stack = measured.stack.max(used_since(start));
    }
    measured.rays = Counters::rays(&context.counters);
    measured.instructions = instructions / pixels.max(1);
    measured
}

/// A sum with the levels of all pixels of a row, of eight bits a channel.
#[inline(never)]
fn levels<S: Scalar>(row: impl Iterator<Item = Pixel<S>>, sum: u32) -> u32 {
    let mix = |sum: u32, level: u8| (sum ^ u32::from(level)).wrapping_mul(0x0100_0193);
    row.fold(sum, |sum, pixel| pixel.color.to_srgb888().into_iter().fold(sum, mix))
}
