//! Inputs of the unit tests: the same on every run and machine.

/// A stream of numbers (Marsaglia, *Xorshift RNGs*, 2003). The tests add the inputs that they need.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Any number but zero.
    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// In `[0, 1)`.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In `[low, high)`.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}
