//! Conservative tests that a ray misses an object.

use super::Numbers;

/// Conservative tests that a ray misses: a result of true is certain.
pub trait Culling: Numbers {
    /// True if the line from `o` along `d` passes the axis through `position` at a distance greater than `r`; false
    /// where rounding may decide.
    fn passes_axis(o: [Self; 3], d: [Self::Unit; 3], position: [Self; 3], axis: [Self::Unit; 3], r: Self) -> bool;

    /// The values that all tests of a ray against boxes share.
    type Slabs: Copy;

    /// Computes these values for the ray from `o` along `d`.
    fn slabs(o: [Self; 3], d: [Self::Unit; 3]) -> Self::Slabs;

    /// Conservative test: true only if the ray certainly misses the box about `centre` with these half extents, within
    /// the closed `range` of `t`. Then no query reports a hit of a solid in the box, in spite of rounding. The result
    /// may be false for a ray that passes close to the box. All numbers except the range must be within the
    /// [`Budget`](super::Budget) of coordinates.
    fn misses_box(slabs: &Self::Slabs, range: [Self; 2], centre: [Self; 3], half: [Self; 3]) -> bool;
}
