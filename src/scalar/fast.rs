//! The grid of fixed point: integers of a common unit, in which a line meets a primitive in the type's own width. Where
//! that is unsure, the solver decides.

use super::{Attempt, InCuboid, InSide, NappeOutline, Numbers};
use core::cmp::Ordering;

/// A line in a primitive's frame, for the grid.
#[derive(Clone, Copy, Debug)]
pub struct LocalLine<S: Numbers> {
    /// The origin, in units of `2^-extra_bits` of the type's.
    pub origin: [S; 3],
    /// Extra bits of the origin below the type's unit; for floats 1 if the line has been rounded.
    pub extra_bits: i32,
    /// The direction.
    pub direction: [S::Unit; 3],
    /// The ray's `t` at the line's origin.
    pub start: S,
    /// True if the line is accurate enough only to decide a miss.
    pub is_coarse: bool,
    /// True for the tier [`Exact`](crate::tier::Exact): a result that passes the guards is certain, except that `t` is
    /// rounded, by less than a unit. `f32` then computes in doubles, in which nearly all rays pass; fixed point
    /// computes in its own 32 bits.
    pub is_strict: bool,
    /// If given, only the first end at or after this `t` of the ray is needed: an entry is enough, and a line without
    /// such an end may be a miss.
    pub since: Option<S>,
}

impl<S: Numbers + Copy> LocalLine<S> {
    /// The line of a ray in world coordinates.
    #[inline(always)]
    pub(crate) const fn along(origin: [S; 3], direction: [S::Unit; 3], zero: S) -> Self {
        Self { origin, extra_bits: 0, direction, start: zero, is_coarse: false, is_strict: false, since: None }
    }
}

impl<S: super::Scalar> LocalLine<S> {
    /// Whether no end is needed but the entry at this `t` of the line.
    #[inline(always)]
    pub(crate) fn needs_only(&self, enter: S) -> bool {
        self.since.is_some_and(|since| enter.plus(self.start) >= since)
    }

    /// The line mirrored in the plane `y = 0`.
    #[inline]
    pub(crate) fn mirrored(&self) -> Self {
        let mut line = *self;
        line.origin[1] = -line.origin[1];
        line.direction[1] = -line.direction[1];
        line
    }
}

/// A line in the frame of an affine placement, in fixed point, with a unit of length that is finer than the type's.
#[derive(Clone, Copy, Debug)]
pub struct FinerLine<S: Numbers> {
    /// The line, for a solid that is `2^scale` times as large.
    pub line: LocalLine<S>,
    /// Extra bits of the unit of length below the type's.
    pub scale: i32,
    /// The ray's `t` divided by the line's, in the type's unit over the line's.
    pub inverse_length: InverseLength,
}

/// A ratio of lengths, at most a half: `digits * 2^-shift`, or `(digits * 2^32 + below) * 2^-shift` for the types of 64
/// bits.
#[derive(Clone, Copy, Debug)]
pub struct InverseLength {
    /// At least 2^31.
    pub digits: u32,
    /// The digits below these; zero for the types of 32 bits.
    pub below: u32,
    /// From 33 to 62, or from 65 to 126.
    pub shift: u32,
}

/// Intersection of a local line with the surfaces of primitives, on the grid. The results are
/// [`Attempt::Unsure`] where rounding may decide.
pub trait FastPath: Numbers {
    /// The direction of a vector, equal to that of [`Computing::normalize`](super::Computing::normalize) or next to it;
    /// a miss for the zero vector.
    #[inline(always)]
    fn fast_direction(_: [Self; 3]) -> Attempt<[Self::Unit; 3]> {
        Attempt::Unsure
    }

    /// The two ends of the line inside the sphere of radius `r` about the origin: from the point of closest approach,
    /// or, if `by_moment`, from the Pluecker moment. `is_strict` is that of the line, passed as a constant of the tier
    /// so that it costs the other tiers nothing.
    #[inline(always)]
    fn fast_ball(_: LocalLine<Self>, _r: Self, _by_moment: bool, _is_strict: bool) -> Attempt<[Self; 2]> {
        Attempt::Unsure
    }

    /// Whether one of these ends is at `t >= 0`; unsure if an end is beyond the number type.
    #[inline(always)]
    fn fast_ball_ahead(_: LocalLine<Self>, _r: Self, _by_moment: bool) -> Attempt<()> {
        Attempt::Unsure
    }

    /// The interval of the line inside the infinite cylinder of radius `r` about the y axis.
    #[inline(always)]
    fn fast_tube(_: LocalLine<Self>, _r: Self) -> Attempt<InSide<Self>> {
        Attempt::Unsure
    }

    /// The interval of the line inside the nappe.
    #[inline(always)]
    fn fast_nappe(_: LocalLine<Self>, _: NappeOutline<Self>) -> Attempt<InSide<Self>> {
        Attempt::Unsure
    }

    /// Where the line is inside a double cone of this slope: between the two ends, or, if `true`, outside them.
    #[inline(always)]
    fn fast_double_cone(_: LocalLine<Self>, _slope: Self) -> Attempt<([Self; 2], bool)> {
        Attempt::Unsure
    }

    /// The exit of a line that starts on a sphere about the origin, or on a cylinder about the y axis, and leads
    /// inwards.
    #[inline(always)]
    fn fast_exit_from_round(_: &LocalLine<Self>, _is_ball: bool) -> Attempt<Self> {
        Attempt::Unsure
    }

    /// The exit of a line that starts on the side of the nappe and leads inwards; infinite if there is none.
    #[inline(always)]
    fn fast_exit_from_nappe(_: &LocalLine<Self>, _: NappeOutline<Self>) -> Attempt<Self> {
        Attempt::Unsure
    }

    /// Whether the line's point at `t` lies below `y = 0` (`Less`), between that and the height (`Equal`), or above
    /// (`Greater`).
    #[inline(always)]
    fn fast_seams(_: LocalLine<Self>, _t: Self, _height: Self) -> Attempt<Ordering> {
        Attempt::Unsure
    }

    /// The line relative to the point `(0, y, 0)`.
    #[inline(always)]
    fn fast_lowered(_: LocalLine<Self>, _y: Self) -> Attempt<LocalLine<Self>> {
        Attempt::Unsure
    }

    /// Where the line crosses two heights. A line of constant height crosses neither.
    #[inline(always)]
    fn fast_crossings(_: LocalLine<Self>, _y: [Self; 2]) -> Attempt<[Self; 2]> {
        Attempt::Unsure
    }

    /// Where the line crosses the disc of radius `r` about the origin in the plane `y = 0`.
    #[inline(always)]
    fn fast_disc(_: LocalLine<Self>, _r: Self) -> Attempt<Self> {
        Attempt::Unsure
    }

    /// Where the line crosses the rectangle about the origin in the plane `y = 0`, with these half extents along x and
    /// z.
    #[inline(always)]
    fn fast_rectangle(_: LocalLine<Self>, _half: [Self; 2]) -> Attempt<Self> {
        Attempt::Unsure
    }

    /// The interval of the line inside the cuboid about the origin with these half extents along x, y and z. Unsure if
    /// an end is next to an edge.
    #[inline(always)]
    fn fast_cuboid(_: &LocalLine<Self>, _half: [Self; 3]) -> Attempt<InCuboid<Self>> {
        Attempt::Unsure
    }

    /// Where a line that starts on the surface of that cuboid leaves it, and the axis perpendicular to the face by
    /// which it leaves.
    #[inline(always)]
    fn fast_exit_from_cuboid(_: &LocalLine<Self>, _half: [Self; 3]) -> Attempt<(Self, usize)> {
        Attempt::Unsure
    }

    /// Where the line crosses the triangle with these vertices, and whether it comes from the side from which they are
    /// counter-clockwise.
    #[inline(always)]
    fn fast_triangle(_: LocalLine<Self>, _vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)> {
        Attempt::Unsure
    }

    /// Whether two ends are so close that their order may be decided by rounding. Only a strict line has this guard:
    /// otherwise two ends within a unit of each other may be in either order.
    #[inline(always)]
    fn are_close(_: &LocalLine<Self>, _: Self, _: Self) -> bool {
        false
    }

    /// Whether rounding may decide the order of two fixed-point ends.
    #[inline(always)]
    fn are_doubtful(_: Self, _: Self) -> bool {
        true
    }

    /// The line from `o` along `d` in the frame with these axes at `position`. In floats, the origin of a line that
    /// starts far away is moved next to `position`.
    #[inline(always)]
    fn fast_turned(
        _o: [Self; 3],
        _d: [Self::Unit; 3],
        _position: [Self; 3],
        _axes: [[Self::Unit; 3]; 3],
    ) -> Option<LocalLine<Self>> {
        None
    }

    /// True if the line from `o` along `d` passes the axis through `position` at a distance greater than `r`; false
    /// where rounding may decide.
    #[inline(always)]
    fn passes_axis(_o: [Self; 3], _d: [Self::Unit; 3], _position: [Self; 3], _axis: [Self::Unit; 3], _r: Self) -> bool {
        false
    }

    /// The same for fixed point, for a solid whose lengths are at most `bounding_radius`. `None` if they do not fit.
    #[inline(always)]
    fn fast_stretched_finely(
        _o: [Self; 3],
        _d: [Self::Unit; 3],
        _position: [Self; 3],
        _rows: [([Self::Unit; 3], i32); 3],
        _bounding_radius: Self,
    ) -> Option<FinerLine<Self>> {
        None
    }

    /// Converts a `t` of that line to the ray's; `None` if it is too large.
    #[inline(always)]
    fn fast_along_ray(_line: &FinerLine<Self>, _t: Self) -> Option<Self> {
        None
    }

    /// Reduces the extra bits of the origin in fixed point so far that lengths up to the solid's bounding radius
    /// `bounding_radius` fit in the same unit.
    #[inline(always)]
    fn fast_fit(_line: &mut LocalLine<Self>, _bounding_radius: Self) {}

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
