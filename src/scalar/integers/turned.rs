//! Transformation of a line to a frame.

use super::length::Length;

/// The origin of a line in a frame, moved next to the frame's origin if the line starts far from there.
pub(in crate::scalar) struct Turned<N> {
    /// The ray's `t` there.
    pub(in crate::scalar) start: N,
    /// The point in units of `2^-extra_bits` of the type's.
    pub(in crate::scalar) origin: [N; 3],
    /// At least [`Length::FINER`], or less for a line that is accurate enough only to decide a miss.
    pub(in crate::scalar) extra_bits: i32,
    pub(in crate::scalar) direction: [N; 3],
}

/// The line in the frame of these axes; `None` if it is too far away for that.
#[inline(always)]
pub(in crate::scalar) fn turned<N: Length>(
    o: [N; 3],
    position: [N; 3],
    axes: [[N; 3]; 3],
    d: [N; 3],
) -> Option<Turned<N>> {
    let (start, point, extra_bits) = N::placed([0, 1, 2].map(|i| o[i].apart(position[i])), d)?;
    let seen = |v: [N; 3]| axes.map(|axis| N::nearest(N::dot(v, axis)));
    Some(Turned { start, origin: seen(point), extra_bits, direction: seen(d) })
}
