//! The side of a cylinder or a cone: a surface of revolution about the y axis, in the numbers that it was built from.

/// The outline of a cone: its radius as a function of the height.
///
/// It is stored as it was given, so that no slope is rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outline<S> {
    /// From the apex at the origin upwards: radius over height.
    Slope(S),
    /// Through a radius at `y = 0` and another at `y = height`, which is the third number.
    Radii(S, S, S),
}

/// The extent of a side along the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent<S> {
    /// Both nappes of a cone, without ends.
    Double,
    /// No ends; a solid. Of a cone the nappe above the apex.
    Infinite,
    /// Rims at `y = 0` and at this height; a surface without an inside.
    Open(S),
    /// Flat caps at `y = 0` and at this height; a solid. An apex ends it without a cap.
    Capped(S),
}

impl<S: Copy> Outline<S> {
    /// The outline with `of_slope` applied to its slope, or `of_size` to its sizes.
    #[inline(always)]
    pub(crate) fn map<R>(self, of_slope: impl Fn(S) -> R, of_size: impl Fn(S) -> R) -> Outline<R> {
        match self {
            Self::Slope(slope) => Outline::Slope(of_slope(slope)),
            Self::Radii(base, top, height) => Outline::Radii(of_size(base), of_size(top), of_size(height)),
        }
    }
}

impl<S: Copy> Extent<S> {
    /// The height; `None` for an infinite side.
    pub(crate) const fn height(&self) -> Option<S> {
        match *self {
            Self::Double | Self::Infinite => None,
            Self::Open(height) | Self::Capped(height) => Some(height),
        }
    }

    /// The extent with `f` applied to its height.
    #[inline(always)]
    pub(crate) fn map<R>(self, f: impl Fn(S) -> R) -> Extent<R> {
        match self {
            Self::Double => Extent::Double,
            Self::Infinite => Extent::Infinite,
            Self::Open(height) => Extent::Open(f(height)),
            Self::Capped(height) => Extent::Capped(f(height)),
        }
    }
}
