//! Primitives in constants: the constructors as `const fn`, for each number type.

use super::{Capsule, Cone, Cuboid, Cylinder, Disc, Rectangle, SizeError, Sphere};
use crate::outline::{Extent, Outline};
use crate::scalar::ValueError;
use crate::scalar::constant::{self, each_number};

/// Returns the error of the first value that has one; the checks are in the order of those at run time.
macro_rules! checked {
    ($($fault:expr => $error:path),+ $(,)?) => {
        $(if let Some(fault) = $fault {
            return Err($error(fault));
        })+
    };
}

macro_rules! constants {
    ([$($generics:tt)*] $Number:ty, $checks:ident) => {
        impl<$($generics)*> Sphere<$Number> {
            /// [`Sphere::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Sphere::new`].
            pub const fn const_new(radius: $Number) -> Result<Self, SizeError> {
                checked!(constant::$checks::size(radius) => SizeError::Radius);
                Ok(Self { radius })
            }
        }

        impl<$($generics)*> Disc<$Number> {
            /// [`Disc::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Disc::new`].
            pub const fn const_new(radius: $Number) -> Result<Self, SizeError> {
                checked!(constant::$checks::size(radius) => SizeError::Radius);
                Ok(Self { radius })
            }
        }

        impl<$($generics)*> Capsule<$Number> {
            /// [`Capsule::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Capsule::new`].
            pub const fn const_new(radius: $Number, height: $Number) -> Result<Self, SizeError> {
                checked!(
                    constant::$checks::size(radius) => SizeError::Radius,
                    constant::$checks::size_or_zero(height) => SizeError::Height,
                );
                // A negative zero is stored as zero.
                let zero = <$Number as crate::scalar::Scalar>::ZERO;
                Ok(Self { radius, height: if constant::$checks::is_zero(height) { zero } else { height } })
            }
        }

        impl<$($generics)*> Cuboid<$Number> {
            /// [`Cuboid::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cuboid::new`].
            pub const fn const_new(half_x: $Number, half_y: $Number, half_z: $Number) -> Result<Self, SizeError> {
                checked!(
                    constant::$checks::size(half_x) => SizeError::HalfExtent,
                    constant::$checks::size(half_y) => SizeError::HalfExtent,
                    constant::$checks::size(half_z) => SizeError::HalfExtent,
                );
                Ok(Self { half: [half_x, half_y, half_z] })
            }
        }

        impl<$($generics)*> Rectangle<$Number> {
            /// [`Rectangle::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Rectangle::new`].
            pub const fn const_new(half_x: $Number, half_z: $Number) -> Result<Self, SizeError> {
                checked!(
                    constant::$checks::size(half_x) => SizeError::HalfExtent,
                    constant::$checks::size(half_z) => SizeError::HalfExtent,
                );
                Ok(Self { half: [half_x, half_z] })
            }
        }

        impl<$($generics)*> Cylinder<$Number> {
            /// [`Cylinder::infinite`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cylinder::infinite`].
            pub const fn const_infinite(radius: $Number) -> Result<Self, SizeError> {
                checked!(constant::$checks::size(radius) => SizeError::Radius);
                Ok(Self { radius, extent: Extent::Infinite })
            }

            /// [`Cylinder::open`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cylinder::open`].
            pub const fn const_open(radius: $Number, height: $Number) -> Result<Self, SizeError> {
                checked!(
                    constant::$checks::size(height) => SizeError::Height,
                    constant::$checks::size(radius) => SizeError::Radius,
                );
                Ok(Self { radius, extent: Extent::Open(height) })
            }

            /// [`Cylinder::capped`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cylinder::capped`].
            pub const fn const_capped(radius: $Number, height: $Number) -> Result<Self, SizeError> {
                checked!(
                    constant::$checks::size(height) => SizeError::Height,
                    constant::$checks::size(radius) => SizeError::Radius,
                );
                Ok(Self { radius, extent: Extent::Capped(height) })
            }
        }

        impl<$($generics)*> Cone<$Number> {
            /// [`Cone::double`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cone::double`].
            pub const fn const_double(slope: $Number) -> Result<Self, SizeError> {
                checked!(constant::$checks::slope(slope) => SizeError::Slope);
                Ok(Self { outline: Outline::Slope(slope), extent: Extent::Double })
            }

            /// [`Cone::nappe`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cone::nappe`].
            pub const fn const_nappe(slope: $Number) -> Result<Self, SizeError> {
                checked!(constant::$checks::slope(slope) => SizeError::Slope);
                Ok(Self { outline: Outline::Slope(slope), extent: Extent::Infinite })
            }

            /// [`Cone::open`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cone::open`].
            pub const fn const_open(slope: $Number, height: $Number) -> Result<Self, SizeError> {
                checked!(
                    constant::$checks::slope(slope) => SizeError::Slope,
                    constant::$checks::size(height) => SizeError::Height,
                );
                Ok(Self { outline: Outline::Slope(slope), extent: Extent::Open(height) })
            }

            /// [`Cone::capped`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cone::capped`].
            pub const fn const_capped(slope: $Number, height: $Number) -> Result<Self, SizeError> {
                checked!(
                    constant::$checks::slope(slope) => SizeError::Slope,
                    constant::$checks::size(height) => SizeError::Height,
                );
                Ok(Self { outline: Outline::Slope(slope), extent: Extent::Capped(height) })
            }

            const fn const_radii(base: $Number, top: $Number, height: $Number) -> Result<Outline<$Number>, SizeError> {
                checked!(
                    constant::$checks::size_or_zero(base) => SizeError::Radius,
                    constant::$checks::size_or_zero(top) => SizeError::Radius,
                );
                let are_zero = [constant::$checks::is_zero(base), constant::$checks::is_zero(top)];
                if are_zero[0] && are_zero[1] {
                    return Err(SizeError::Radius(ValueError::Zero));
                }
                checked!(constant::$checks::size(height) => SizeError::Height);
                // A negative zero is stored as zero.
                let zero = <$Number as crate::scalar::Scalar>::ZERO;
                let (base, top) = (if are_zero[0] { zero } else { base }, if are_zero[1] { zero } else { top });
                Ok(Outline::Radii(base, top, height))
            }

            /// [`Cone::frustum_open`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cone::frustum_open`].
            pub const fn const_frustum_open(
                base_radius: $Number,
                top_radius: $Number,
                height: $Number,
            ) -> Result<Self, SizeError> {
                match Self::const_radii(base_radius, top_radius, height) {
                    Ok(outline) => Ok(Self { outline, extent: Extent::Open(height) }),
                    Err(error) => Err(error),
                }
            }

            /// [`Cone::frustum`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Cone::frustum`].
            pub const fn const_frustum(
                base_radius: $Number,
                top_radius: $Number,
                height: $Number,
            ) -> Result<Self, SizeError> {
                match Self::const_radii(base_radius, top_radius, height) {
                    Ok(outline) => Ok(Self { outline, extent: Extent::Capped(height) }),
                    Err(error) => Err(error),
                }
            }
        }
    };
}
each_number!(constants);
