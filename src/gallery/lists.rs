//! What a prism and a polyhedron of the built-in scenes borrow: a list cannot be a constant of generic code, so each
//! number type has its own.

use crate::half_space::HalfSpace;
use crate::scalar::Scalar;
use crate::vector::Vec3;

/// The lists of a number type.
pub trait Lists: Sized + 'static {
    /// The corners of a right-angled triangle.
    const TRIANGLE: &'static [[Self; 2]];
    /// `x + y + z <= 2`, which cuts a corner from the cube up to `(1, 1, 1)`.
    const CUT: &'static [HalfSpace<Self>];
}

macro_rules! lists {
    ([$($generics:tt)*] $Number:ty) => {
        impl<$($generics)*> Lists for $Number {
            const TRIANGLE: &'static [[Self; 2]] = &[
                [Self::ROUNDED_ONE, <Self as Scalar>::ZERO],
                [<Self as Scalar>::ZERO, <Self as Scalar>::ZERO],
                [<Self as Scalar>::ZERO, Self::ROUNDED_ONE],
            ];
            const CUT: &'static [HalfSpace<Self>] = &[HalfSpace {
                point: Vec3::new(Self::ROUNDED_ONE, Self::ROUNDED_ONE, <Self as Scalar>::ZERO),
                normal: Vec3::new(Self::ROUNDED_ONE, Self::ROUNDED_ONE, Self::ROUNDED_ONE),
            }];
        }
    };
}

lists!([] f32);
lists!([] f64);
#[cfg(feature = "fixed")]
lists!([F: fixed::types::extra::LeEqU32 + Send + Sync + 'static] fixed::FixedI32<F>);
#[cfg(feature = "fixed")]
lists!([F: fixed::types::extra::LeEqU64 + Send + Sync + 'static] fixed::FixedI64<F>);
