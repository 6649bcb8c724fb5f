//! What a picture took, for printing.

use core::fmt;
use raylet::Counters;
use shared::picture::PIXELS;

/// What one picture took in one number type.
#[derive(Clone, Copy, Debug)]
pub struct Figures {
    /// The number type.
    pub number: &'static str,
    /// Instructions of all pixels, without the writing of the file.
    pub instructions: u64,
    /// Rays and tests of all pixels.
    pub counters: Counters,
    /// Bytes of the stack at most, from the program's first frame, with the reading of the scene.
    pub stack: usize,
    /// Bytes of these that hold the scene.
    pub scene: usize,
}

impl fmt::Display for Figures {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { number, instructions, counters, stack, scene } = self;
        let hundredths = |count: u64| count * 100 / PIXELS;
        let (rays, tests) = (hundredths(counters.rays()), hundredths(counters.intersection_tests));
        write!(f, "{number}: {} instructions a pixel (", instructions / PIXELS)?;
        write!(f, "{}.{:02} rays, {}.{:02} intersection tests), ", rays / 100, rays % 100, tests / 100, tests % 100)?;
        write!(f, "stack {stack} bytes (of which scene {scene})")
    }
}
