//! The side of a cylinder, a cone or another quadric: a surface of revolution about the y axis, in the numbers that it
//! was built from.

use crate::scalar::{Real, Ring, Scalar, largest};

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

    /// The most crossings that a line can have with a solid of this extent; zero of an open surface.
    pub(crate) const fn most_crossings(&self) -> usize {
        match self {
            Self::Double => 4,
            Self::Infinite | Self::Capped(_) => 2,
            Self::Open(_) => 0,
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

/// A quadric of revolution between two planes: `x^2 + z^2 = a y^2 + 2 b y + r^2` with `low <= y <= high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meridian<S> {
    /// The coefficient of `y^2`: negative of a spheroid, zero of a paraboloid, positive of a hyperboloid or a cone.
    pub a: S,
    /// Half the coefficient of `y`, a length.
    pub b: S,
    /// The radius at `y = 0`, at least zero.
    pub r: S,
    /// The heights of the lower and the upper plane.
    pub heights: [S; 2],
    /// True if it is the surface alone, without caps.
    pub is_open: bool,
    /// True if a line may enter it twice: see [`has_waist`].
    pub has_waist: bool,
}

/// True if a line may enter the solid twice: if it may have a waist, or parts of two nappes or sheets may lie between
/// the planes. From the signs of `a`, `b`, `r` and the two heights. If `a` is positive and `r` is zero, the sheets are
/// `y >= 0` and `y <= -2 b / a`, or their mirror images; a solid of one sheet counts too unless it ends at the origin.
pub(crate) const fn has_waist([a, b, r, low, high]: [i8; 5]) -> bool {
    let has_two_sheets = match b {
        0 => low < 0 && high > 0,
        1.. => low < 0,
        _ => high > 0,
    };
    a > 0 && (r > 0 || has_two_sheets)
}

impl<S: Copy> Meridian<S> {
    /// The meridian with `of_ratio` applied to `a`, and `of_length` to its lengths.
    #[inline(always)]
    pub(crate) fn map<R>(self, of_ratio: impl Fn(S) -> R, of_length: impl Fn(S) -> R) -> Meridian<R> {
        let Self { a, b, r, heights, is_open, has_waist } = self;
        let heights = heights.map(&of_length);
        Meridian { a: of_ratio(a), b: of_length(b), r: of_length(r), heights, is_open, has_waist }
    }
}

/// The square root; zero of a negative number.
fn root<R: Real>(square: R) -> R {
    if square.is_negative() { R::ZERO } else { square.sqrt() }
}

/// The square of the radius as a function of the height, in numbers to compute in: divided by `2^2e`, and of the height
/// divided by `2^h`, so that no term overflows and the largest is near 1.
pub(crate) struct SquareOfRadius<S: Scalar> {
    /// Of the square of the height, of the height, and of 1.
    terms: [S::Real; 3],
    heights: [S::Real; 2],
    h: i32,
    pub(crate) e: i32,
}

impl<S: Scalar> SquareOfRadius<S> {
    pub(crate) fn of(&Meridian { a, b, r, heights: [low, high], .. }: &Meridian<S>) -> Self {
        let [of_a, of_b, of_r, h] = [a.magnitude(), b.magnitude(), r, largest([low, high])].map(S::binary_exponent);
        let near_one = |value: S, exponent: i32| value.real().scaled(-exponent);
        let [a, b, r] = [near_one(a, of_a), near_one(b, of_b), near_one(r, of_r)];
        let exponents = [of_a + 2 * h, of_b + h + 1, 2 * of_r];
        let none = i32::MIN / 2;
        let most = [a, b, r].into_iter().zip(exponents).map(|(c, e)| if c.is_zero() { none } else { e }).max();
        let e = most.filter(|most| *most > none).unwrap_or(0).div_euclid(2);
        let terms = [a.scaled(exponents[0] - 2 * e), b.scaled(exponents[1] - 2 * e), (r * r).scaled(2 * (of_r - e))];
        Self { terms, heights: [low, high].map(|y| near_one(y, h)), h, e }
    }

    /// The square of the radius at a height.
    fn square_at(&self, y: S::Real) -> S::Real {
        let [a, b, square] = self.terms;
        S::Real::sum_of_products([[a * y, y], [b, y], [square, S::Real::ONE]])
    }

    /// What rounding may have added or lost: some roundings of the terms where they are largest.
    pub(crate) fn doubt(&self) -> S::Real {
        let ([a, b, square], [low, high]) = (self.terms.map(S::Real::abs), self.heights.map(S::Real::abs));
        let y = if low > high { low } else { high };
        (a * y * y + b * y + square).scaled(S::Real::ROUNDING + 4)
    }

    /// The radius at a height.
    pub(crate) fn radius_at(&self, y: S::Real) -> S::Real {
        root(self.square_at(y.scaled(-self.h))).scaled(self.e)
    }

    /// The least and the largest square of the radius between the heights.
    pub(crate) fn extremes(&self) -> (S::Real, S::Real) {
        let [low, high] = self.heights;
        let ends = [self.square_at(low), self.square_at(high)];
        let [mut least, mut most] = if ends[1] < ends[0] { [ends[1], ends[0]] } else { ends };
        let [a, b, _] = self.terms;
        if !a.is_zero() {
            let vertex = -(b / a).scaled(-1);
            if vertex > low && vertex < high {
                let square = self.square_at(vertex);
                least = if square < least { square } else { least };
                most = if square > most { square } else { most };
            }
        }
        (least, most)
    }

    /// The radius of a cylinder about it.
    pub(crate) fn largest_radius(&self) -> S {
        S::round(root(self.extremes().1 + self.doubt()).scaled(self.e)).next_up()
    }
}
