//! Why a solver stops.

/// Why there is no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The line misses.
    Miss,
    /// The number does not know a sign, or its error is too large: a wider number decides.
    Unsure,
}

/// A result, or why there is none. (The kernels of the grid have an enum of their own, which says the same:
/// [`scalar::Attempt`](crate::scalar::Attempt).)
pub type Attempt<T> = Result<T, Stop>;

/// What a number knows.
#[inline(always)]
pub(super) fn known<T>(value: Option<T>) -> Attempt<T> {
    match value {
        Some(value) => Ok(value),
        None => Err(Stop::Unsure),
    }
}
