//! The fast path: the usual case in the type's own width. What it does not answer is left to the solver.

use super::Numbers;
use core::cmp::Ordering;
use core::ops::Neg;

/// What the fast path makes of a line and a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Attempt<T> {
    /// The line misses.
    Miss,
    /// The answer.
    Found(T),
    /// A guard fails: the solver decides.
    Unsure,
}

/// Where a line is inside a nappe of a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InNappe<S> {
    /// The ends; infinite where there is none.
    pub ends: [S; 2],
    /// Whether the line ends there; otherwise somewhere beyond.
    pub certain: [bool; 2],
}

/// What was found; otherwise the caller's answer is the same miss or doubt. (As `?`, and without closures, which are not surely
/// compiled inline.)
macro_rules! found {
    ($attempt:expr) => {
        match $attempt {
            $crate::scalar::Attempt::Found(answer) => answer,
            $crate::scalar::Attempt::Miss => return $crate::scalar::Attempt::Miss,
            $crate::scalar::Attempt::Unsure => return $crate::scalar::Attempt::Unsure,
        }
    };
}
pub(crate) use found;

/// Whether the line passes within a triangle, on the same side of its three edges, and comes from the front: from the volume that it
/// spans with each edge, negative from the front, and what that may be off.
#[inline(always)]
pub(crate) fn within_edges<V: Copy + PartialOrd + Neg<Output = V>>(edges: [(V, V); 3]) -> Attempt<bool> {
    let (mut left, mut right) = (0, 0);
    for (volume, doubt) in edges {
        left += (volume > doubt) as u32;
        right += (volume < -doubt) as u32;
    }
    if left != 0 && right != 0 {
        Attempt::Miss
    } else if left + right == 3 {
        Attempt::Found(right == 3)
    } else {
        Attempt::Unsure
    }
}

/// A line in a primitive's frame, for the fast path.
#[expect(clippy::struct_excessive_bools, reason = "properties that do not depend on each other")]
#[derive(Clone, Copy, Debug)]
pub struct LocalLine<S: Numbers> {
    /// The origin, in units of `2^-finer` of the type's.
    pub origin: [S; 3],
    /// What rounding left over of the origin of a ball's line, to be added to it.
    pub rest: [S; 3],
    /// How much finer the origin's unit is than the type's; for floats 1 if the line has been rounded.
    pub finer: i32,
    /// The direction.
    pub direction: [S::Unit; 3],
    /// The ray's `t` over the line's own, where a placement stretches; not used elsewhere.
    pub pace: S,
    /// The ray's `t` at the line's origin.
    pub start: S,
    /// True if the line is only good enough to tell a miss.
    pub is_coarse: bool,
    /// How far the coordinates of the origin and the components of the direction may be off because of a float's way to them, in
    /// roundings of one. Zero after compensated sums.
    pub off: [S; 2],
    /// True if the origin is relative to a point that the primitive has named.
    pub is_relative: bool,
    /// True if the components of a float line are not the ray's own: each is off by a rounding of itself, and by `off`.
    pub is_rounded: bool,
    /// True of doubles that stand for numbers of 32 bits: guards may be strict, and yet let nearly all through.
    pub has_spare_bits: bool,
}

impl<S: Numbers + Copy> LocalLine<S> {
    /// The line of a ray as it stands in the world.
    #[inline(always)]
    pub(crate) const fn along(origin: [S; 3], direction: [S::Unit; 3], zero: S) -> Self {
        Self {
            origin,
            rest: [zero, zero, zero],
            finer: 0,
            direction,
            pace: zero,
            start: zero,
            is_coarse: false,
            off: [zero, zero],
            is_relative: false,
            is_rounded: false,
            has_spare_bits: false,
        }
    }
}

/// A line in the frame of a placement that stretches, in a unit of length that is finer than the type's.
#[derive(Clone, Copy, Debug)]
pub struct FinerLine<S: Numbers> {
    /// The line, for a solid that is `2^scale` times as large.
    pub line: LocalLine<S>,
    /// By how many bits the unit is finer than the type's.
    pub scale: i32,
    /// The ray's `t` over the line's own, in units of the type's over the line's.
    pub pace: Pace,
}

/// A ratio of lengths: `digits * 2^-shift`.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    /// At least 2^31.
    pub digits: u32,
    /// From 33 to 62.
    pub shift: u32,
}

/// How a line in a primitive's frame meets its surfaces, where rounding does not decide.
pub trait FastPath: Numbers {
    /// The direction of a vector in this type, as [`Computing::normalize`](super::Computing::normalize) has it or next to that; a miss for the zero vector.
    #[inline(always)]
    fn fast_direction(_: [Self; 3]) -> Attempt<[Self::Unit; 3]> {
        Attempt::Unsure
    }

    /// The two ends of the line inside the ball of radius `r` about the origin: from its closest approach, or, if `by_moment`, from its
    /// moment.
    #[inline(always)]
    fn fast_ball(_: LocalLine<Self>, _r: Self, _by_moment: bool) -> Attempt<[Self; 2]> {
        Attempt::Unsure
    }

    /// Whether that line has an end at `t >= 0`, where no end is beyond the type.
    #[inline(always)]
    fn fast_ball_ahead(_: LocalLine<Self>, _r: Self, _by_moment: bool) -> Attempt<()> {
        Attempt::Unsure
    }

    /// The two ends of the line inside the infinite cylinder of radius `r` about the y axis.
    #[inline(always)]
    fn fast_tube(_: LocalLine<Self>, _r: Self) -> Attempt<[Self; 2]> {
        Attempt::Unsure
    }

    /// Where the line is inside the nappe of a cone that has the radius `base` at `y = 0` and grows by `growth` over `height` (`None`: 1).
    /// Of a cone that ends somewhere only what lies between `y = 0` and `top` is wanted.
    #[inline(always)]
    fn fast_nappe(
        _: LocalLine<Self>,
        _outline: (Self, Self, Option<Self>),
        _top: Option<Self>,
    ) -> Attempt<InNappe<Self>> {
        Attempt::Unsure
    }

    /// Where the line is inside both nappes of a cone of this slope: between its ends, or (`true`) beyond them.
    #[inline(always)]
    fn fast_double_cone(_: LocalLine<Self>, _slope: Self) -> Attempt<([Self; 2], bool)> {
        Attempt::Unsure
    }

    /// Where a line that begins in the surface of a ball about the origin, or of a cylinder about the y axis, and leads inwards leaves it.
    #[inline(always)]
    fn fast_exit_from_round(_: &LocalLine<Self>, _is_ball: bool) -> Attempt<Self> {
        Attempt::Unsure
    }

    /// Where a line that begins in the side of [`FastPath::fast_nappe`] and leads inwards leaves that nappe; infinite if it does not.
    #[inline(always)]
    fn fast_exit_from_nappe(_: &LocalLine<Self>, _outline: (Self, Self, Option<Self>)) -> Attempt<Self> {
        Attempt::Unsure
    }

    /// Whether the line's point at `t` lies below `y = 0`, between that and the height, or above; unclear where rounding decides.
    #[inline(always)]
    fn fast_seams(_: LocalLine<Self>, _t: Self, _height: Self) -> Attempt<Ordering> {
        Attempt::Unsure
    }

    /// The line seen from the height `y`.
    #[inline(always)]
    fn fast_lowered(_: LocalLine<Self>, _y: Self) -> Attempt<LocalLine<Self>> {
        Attempt::Unsure
    }

    /// Where the line crosses two heights, and how much more than a few units each may be off; a line that stays in one height crosses
    /// neither.
    #[inline(always)]
    fn fast_crossings(_: LocalLine<Self>, _y: [Self; 2]) -> Attempt<([Self; 2], [Self; 2])> {
        Attempt::Unsure
    }

    /// Where the line crosses the disc of radius `r` about the origin in the plane `y = 0`.
    #[inline(always)]
    fn fast_disc(_: LocalLine<Self>, _r: Self) -> Attempt<Self> {
        Attempt::Unsure
    }

    /// Where the line crosses the triangle with these vertices, and whether it comes from where they run counter-clockwise.
    #[inline(always)]
    fn fast_triangle(_: LocalLine<Self>, _vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)> {
        Attempt::Unsure
    }

    /// Whether two ends of the fast path are so close that rounding, and what they may be `off` beside it, decides which comes first.
    #[inline(always)]
    fn are_close(_: &LocalLine<Self>, _: Self, _: Self, _off: Self) -> bool {
        false
    }

    /// Whether an end that may be `off` by so much is good enough.
    #[inline(always)]
    fn is_good(_: &LocalLine<Self>, _: Self, _off: Self) -> bool {
        true
    }

    /// Whether the line from `o` along `d` begins so far from `base` that the rounding of its coordinates should not grow with that.
    #[inline(always)]
    fn is_far(_o: [Self; 3], _d: [Self::Unit; 3], _base: [Self; 3]) -> bool {
        false
    }

    /// Such a line, taken up next to `base` and relative to it.
    #[inline(always)]
    fn fast_from_afar(_o: [Self; 3], _d: [Self::Unit; 3], _base: [Self; 3]) -> Option<LocalLine<Self>> {
        None
    }

    /// The line from `o` along `d` in the frame with these axes at `position`; of floats taken up next to that, if it begins far away.
    #[inline(always)]
    fn fast_turned(
        _o: [Self; 3],
        _d: [Self::Unit; 3],
        _position: [Self; 3],
        _axes: [[Self::Unit; 3]; 3],
    ) -> Option<LocalLine<Self>> {
        None
    }

    /// The line from `o` along `d` in the frame of a matrix, whose inverse has these rows, each to be multiplied by its power of two. `None` where products cancel, whose rounding would be much of the line.
    #[inline(always)]
    fn fast_stretched(
        _o: [Self; 3],
        _d: [Self::Unit; 3],
        _position: [Self; 3],
        _rows: [([Self::Unit; 3], i32); 3],
    ) -> Option<LocalLine<Self>> {
        None
    }

    /// The same of integers, for a solid whose lengths are at most `reach`. `None` if there is no room for them.
    #[inline(always)]
    fn fast_stretched_finely(
        _o: [Self; 3],
        _d: [Self::Unit; 3],
        _position: [Self; 3],
        _rows: [([Self::Unit; 3], i32); 3],
        _reach: Self,
    ) -> Option<FinerLine<Self>> {
        None
    }

    /// The ray's `t` for one of that line; `None` if it is too large for that.
    #[inline(always)]
    fn fast_along_ray(_line: &FinerLine<Self>, _t: Self) -> Option<Self> {
        None
    }

    /// The line from `o` along `d`, for a second attempt: taken up next to `base` and relative to it; `None` if it begins there.
    #[inline(always)]
    fn fast_closer(_o: [Self; 3], _d: [Self::Unit; 3], _base: [Self; 3]) -> Option<LocalLine<Self>> {
        None
    }

    /// Makes the line suit a solid that reaches so far: of integers its origin keeps no more bits than leave room for the solid's lengths.
    #[inline(always)]
    fn fast_fit(_line: &mut LocalLine<Self>, _reach: Self) {}

    /// The line in the frame of this position and these axes, for a second attempt: by compensated sums, next to the frame's point `base`
    /// and relative to it.
    #[inline(always)]
    fn fast_turned_again(
        _o: [Self; 3],
        _d: [Self::Unit; 3],
        _position: [Self; 3],
        _axes: [[Self::Unit; 3]; 3],
        _base: [Self; 3],
    ) -> Option<LocalLine<Self>> {
        None
    }

    /// The same in the frame of a position and a matrix, as [`FastPath::fast_stretched`] has it.
    #[inline(always)]
    fn fast_stretched_again(
        _o: [Self; 3],
        _d: [Self::Unit; 3],
        _position: [Self; 3],
        _rows: [([Self::Unit; 3], i32); 3],
        _base: [Self; 3],
    ) -> Option<LocalLine<Self>> {
        None
    }

    /// What the tests of a ray against boxes have in common.
    type Slabs: Copy;

    /// The slabs of the ray from `o` along `d`.
    fn slabs(o: [Self; 3], d: [Self::Unit; 3]) -> Self::Slabs;

    /// True only if the ray surely misses, within the closed `range` of `t`, the box about `centre` with these half extents: then no solid
    /// in it, found by a solver that rounds, has a hit there either.
    ///
    /// Conservative: a ray that passes next to the box is not said to miss it. All numbers within the [`Budget`](super::Budget) of
    /// coordinates, but the range.
    fn misses_box(slabs: &Self::Slabs, range: [Self; 2], centre: [Self; 3], half: [Self; 3]) -> bool;
}
