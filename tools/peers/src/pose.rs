//! Where a library puts a primitive that raylet stands on its base, and how the rays follow it there.

use crate::number::Number;
use raylet::{Ray, Vec3};
use support::exact_types::exact_line;
use support::oracle::Line;

/// The library's primitive has its middle in the origin, or that and its apex above instead of below.
#[derive(Clone, Copy, PartialEq)]
pub struct Pose<S> {
    /// The height of the subject's middle: what is subtracted from a ray's y.
    middle: S,
    /// Whether the primitive is the subject seen through its middle, every coordinate negated.
    is_mirrored: bool,
}

impl<S: Number> Pose<S> {
    /// As the subject stands.
    pub const fn same() -> Self {
        Self { middle: <S as raylet::Scalar>::ZERO, is_mirrored: false }
    }

    /// With its middle, which is so high, in the origin.
    pub const fn centred(middle: S) -> Self {
        Self { middle, is_mirrored: false }
    }

    /// With its middle, which is so high, in the origin, and upside down.
    pub const fn mirrored(middle: S) -> Self {
        Self { middle, is_mirrored: true }
    }

    /// Whether it is as the subject stands.
    pub fn is_same(&self) -> bool {
        *self == Self::same()
    }

    /// The ray at the library's primitive. Its y is rounded, which is held against nobody: the oracle has the ray
    /// that came of it.
    pub fn own_ray(&self, ray: &Ray<S>) -> Ray<S> {
        let [x, y, z] = ray.origin().to_array();
        let y = y - self.middle;
        let (origin, direction) = (Vec3::new(x, y, z), ray.direction());
        let (origin, direction) = if self.is_mirrored { (-origin, -direction) } else { (origin, direction) };
        Ray::new(origin, direction).expect("a ray that is in range stays there when it is moved by half a height")
    }

    /// A ray at the library's primitive as the oracle sees it: its base in the origin.
    pub fn exact_line(&self, own: &Ray<S>) -> Line {
        let Line { origin: [x, y, z], direction } = exact_line(own);
        Line::new([x, &y + &self.middle.exact(), z], direction)
    }
}
