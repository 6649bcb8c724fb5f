//! The grid of fixed point: integers of a common unit, in which a line meets a primitive in the type's own width. Where
//! that is unsure, the solver decides.

use super::{Attempt, InCuboid, InSide, Including, NappeOutline, Numbers, Scalar};
use core::cmp::Ordering;

/// A line in a primitive's frame, for the grid.
#[derive(Clone, Copy, Debug)]
pub struct LocalLine<S: Numbers> {
    /// The origin, in units of `2^-extra_bits` of the type's.
    pub origin: [S; 3],
    /// Extra bits of the origin below the type's unit.
    pub extra_bits: i32,
    /// The direction.
    pub direction: [S::Unit; 3],
    /// The ray's `t` at the line's origin.
    pub start: S,
    /// True if the line is accurate enough only to decide a miss.
    pub is_coarse: bool,
    /// True for the tier [`Exact`](crate::tier::Exact): a result that passes the guards is certain, except that `t` is
    /// rounded, by less than a unit.
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

impl<S: Scalar> LocalLine<S> {
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

/// A fixed-point type, whose lines meet primitives on the grid. The results are [`Attempt::Unsure`] where rounding may
/// decide.
pub trait GridScalar: Scalar {
    /// The type of the second attempt, which holds every value of this one; the type itself if that has none.
    type Wider: GridScalar + Including<Self>;
    /// True if there is such a second attempt.
    const WIDENS: bool = false;
    /// Rounded as [`Scalar::from_limbs`].
    fn narrowed(value: Self::Wider) -> Self;

    /// The two ends of the line inside the sphere of radius `r` about the origin: from the point of closest approach,
    /// or, if `by_moment`, from the Pluecker moment. `is_strict` is that of the line, passed as a constant of the tier
    /// so that it costs the other tiers nothing.
    fn ball(line: LocalLine<Self>, r: Self, by_moment: bool, is_strict: bool) -> Attempt<[Self; 2]>;

    /// Whether one of these ends is at `t >= 0`; unsure if an end is beyond the number type.
    fn ball_ahead(line: LocalLine<Self>, r: Self, by_moment: bool) -> Attempt<()>;

    /// The interval of the line inside the infinite cylinder of radius `r` about the y axis.
    fn tube(line: LocalLine<Self>, r: Self) -> Attempt<InSide<Self>>;

    /// The interval of the line inside the nappe.
    fn nappe(line: LocalLine<Self>, nappe: NappeOutline<Self>) -> Attempt<InSide<Self>>;

    /// Where the line is inside a double cone of this slope: between the two ends, or, if `true`, outside them.
    fn double_cone(line: LocalLine<Self>, slope: Self) -> Attempt<([Self; 2], bool)>;

    /// The exit of a line that starts on a sphere about the origin, or on a cylinder about the y axis, and leads
    /// inwards.
    fn exit_from_round(line: &LocalLine<Self>, is_ball: bool) -> Attempt<Self>;

    /// The exit of a line that starts on the side of the nappe and leads inwards; infinite if there is none.
    fn exit_from_nappe(line: &LocalLine<Self>, nappe: NappeOutline<Self>) -> Attempt<Self>;

    /// Whether the line's point at `t` lies below `y = 0` (`Less`), between that and the height (`Equal`), or above
    /// (`Greater`).
    fn seams(line: LocalLine<Self>, t: Self, height: Self) -> Attempt<Ordering>;

    /// The line relative to the point `(0, y, 0)`.
    fn lowered(line: LocalLine<Self>, y: Self) -> Attempt<LocalLine<Self>>;

    /// Where the line crosses two heights. A line of constant height crosses neither.
    fn crossings(line: LocalLine<Self>, y: [Self; 2]) -> Attempt<[Self; 2]>;

    /// Where the line crosses the disc of radius `r` about the origin in the plane `y = 0`.
    fn disc(line: LocalLine<Self>, r: Self) -> Attempt<Self>;

    /// Where the line crosses the rectangle about the origin in the plane `y = 0`, with these half extents along x and
    /// z.
    fn rectangle(line: LocalLine<Self>, half: [Self; 2]) -> Attempt<Self>;

    /// The interval of the line inside the cuboid about the origin with these half extents along x, y and z. Unsure if
    /// an end is next to an edge.
    fn cuboid(line: &LocalLine<Self>, half: [Self; 3]) -> Attempt<InCuboid<Self>>;

    /// Where a line that starts on the surface of that cuboid leaves it, and the axis perpendicular to the face by
    /// which it leaves.
    fn exit_from_cuboid(line: &LocalLine<Self>, half: [Self; 3]) -> Attempt<(Self, usize)>;

    /// Where the line crosses the triangle with these vertices, and whether it comes from the side from which they are
    /// counter-clockwise.
    fn triangle(line: LocalLine<Self>, vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)>;

    /// Whether two ends are so close that their order may be decided by rounding. Only a strict line has this guard:
    /// otherwise two ends within a unit of each other may be in either order.
    fn are_close(line: &LocalLine<Self>, a: Self, b: Self) -> bool;

    /// Whether rounding may decide the order of two fixed-point ends.
    fn are_doubtful(a: Self, b: Self) -> bool;

    /// The line from `o` along `d` in the frame with these axes at `position`; `None` if it is too far away.
    fn turned(
        o: [Self; 3],
        d: [Self::Unit; 3],
        position: [Self; 3],
        axes: [[Self::Unit; 3]; 3],
    ) -> Option<LocalLine<Self>>;

    /// The same in a matrix whose inverse has these rows, for a solid whose lengths are at most `bounding_radius`.
    /// `None` if they do not fit.
    fn stretched(
        o: [Self; 3],
        d: [Self::Unit; 3],
        position: [Self; 3],
        rows: [([Self::Unit; 3], i32); 3],
        bounding_radius: Self,
    ) -> Option<FinerLine<Self>>;

    /// Converts a `t` of that line to the ray's; `None` if it is too large.
    fn along_ray(line: &FinerLine<Self>, t: Self) -> Option<Self>;

    /// Reduces the extra bits of the origin so far that lengths up to the solid's bounding radius
    /// `bounding_radius` fit in the same unit.
    fn fit(line: &mut LocalLine<Self>, bounding_radius: Self);
}
