//! Primitives in constants: the constructors as `const fn`, for each number type.

use super::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Rectangle, Revolved, RoundCone, RoundedCuboid, SizeError, Sphere,
    Torus, Tube,
};
use crate::outline::{Extent, Meridian, Outline, has_waist};
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
pub(super) use checked;

/// A quadric of revolution in doubles, for the checks of [`Revolved::new`]: they allow for some roundings, so that they
/// need not be exact.
struct Doubles {
    a: f64,
    b: f64,
    r: f64,
    low: f64,
    high: f64,
    /// The exponent of a rounding of the number type.
    rounding: i32,
}

/// The exponent of the leading bit, plus 1; of zero and of subnormal numbers that of the smallest normal one.
const fn exponent(value: f64) -> i32 {
    ((value.to_bits() >> 52) & 0x7ff) as i32 - 1022
}

const fn sign(value: f64) -> i8 {
    (value > 0.0) as i8 - (value < 0.0) as i8
}

/// `value * 2^e`, in steps that are powers of two themselves.
const fn scaled(value: f64, e: i32) -> f64 {
    let (mut value, mut left) = (value, e);
    while left != 0 {
        let step = if left > 1000 {
            1000
        } else if left < -1000 {
            -1000
        } else {
            left
        };
        value *= f64::from_bits(((1023 + step) as u64) << 52);
        left -= step;
    }
    value
}

impl Doubles {
    /// The square of the radius at a height.
    const fn square_at(&self, y: f64) -> f64 {
        self.a * y * y + 2.0 * self.b * y + self.r * self.r
    }

    /// What rounding may have added or lost: some roundings of the terms where they are largest.
    const fn doubt(&self) -> f64 {
        let y = self.low.abs().max(self.high.abs());
        let size = self.a.abs() * y * y + 2.0 * self.b.abs() * y + self.r * self.r;
        scaled(size, self.rounding + 4)
    }

    /// The same solid with its height divided by a power of two, and its radii by another, so that no term overflows
    /// and the largest is near 1; and the exponent of the latter.
    const fn near_one(&self) -> (Self, i32) {
        let h = exponent(self.low.abs().max(self.high.abs()));
        let exponents = [exponent(self.a) + 2 * h, exponent(self.b) + h + 1, 2 * exponent(self.r)];
        let most = [
            if self.a == 0.0 { i32::MIN / 2 } else { exponents[0] },
            if self.b == 0.0 { i32::MIN / 2 } else { exponents[1] },
            if self.r == 0.0 { i32::MIN / 2 } else { exponents[2] },
        ];
        let most = if most[0] > most[1] { [most[0], most[2]] } else { [most[1], most[2]] };
        let most = if most[0] > most[1] { most[0] } else { most[1] };
        let e = if most == i32::MIN / 2 { 0 } else { most.div_euclid(2) };
        let one = Self {
            a: scaled(self.a, 2 * (h - e)),
            b: scaled(self.b, h - 2 * e),
            r: scaled(self.r, -e),
            low: scaled(self.low, -h),
            high: scaled(self.high, -h),
            rounding: self.rounding,
        };
        (one, e)
    }

    const fn fault(&self, largest: f64) -> Option<SizeError> {
        if self.low >= self.high {
            return Some(SizeError::Heights);
        }
        let (one, e) = self.near_one();
        let vertex = if one.a == 0.0 { one.low } else { -one.b / one.a };
        let vertex = if vertex > one.low && vertex < one.high { vertex } else { one.low };
        let squares = [one.square_at(one.low), one.square_at(one.high), one.square_at(vertex)];
        let least = squares[0].min(squares[1]).min(squares[2]);
        let most = squares[0].max(squares[1]).max(squares[2]);
        let limit = scaled(largest, 1 - e);
        if !(least >= -one.doubt() && most > 0.0) {
            Some(SizeError::Outline)
        } else if most > limit * limit {
            Some(SizeError::Radius(ValueError::BeyondBudget))
        } else {
            None
        }
    }

    /// The signs of the numbers.
    const fn signs(&self) -> [i8; 5] {
        [sign(self.a), sign(self.b), sign(self.r), sign(self.low), sign(self.high)]
    }
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

        impl<$($generics)*> RoundedCuboid<$Number> {
            /// [`RoundedCuboid::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`RoundedCuboid::new`].
            pub const fn const_new(
                half_x: $Number,
                half_y: $Number,
                half_z: $Number,
                radius: $Number,
            ) -> Result<Self, SizeError> {
                checked!(constant::$checks::size(radius) => SizeError::Radius);
                let (mut half, mut axis) = ([half_x, half_y, half_z], 0);
                while axis < 3 {
                    checked!(
                        constant::$checks::size_or_zero(half[axis]) => SizeError::HalfExtent,
                        constant::$checks::size(constant::$checks::plus(half[axis], radius)) => SizeError::HalfExtent,
                    );
                    // A negative zero is stored as zero.
                    if constant::$checks::is_zero(half[axis]) {
                        half[axis] = <$Number as crate::scalar::Scalar>::ZERO;
                    }
                    axis += 1;
                }
                Ok(Self { half, radius })
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

        impl<$($generics)*> RoundCone<$Number> {
            /// [`RoundCone::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`RoundCone::new`].
            pub const fn const_new(
                base_radius: $Number,
                top_radius: $Number,
                height: $Number,
            ) -> Result<Self, SizeError> {
                checked!(constant::$checks::size(base_radius) => SizeError::Radius);
                match Capsule::<$Number>::const_new(top_radius, height) {
                    Ok(Capsule { radius, height }) => Ok(Self { radii: [base_radius, radius], height }),
                    Err(error) => Err(error),
                }
            }
        }

        impl<$($generics)*> Tube<$Number> {
            /// [`Tube::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Tube::new`].
            pub const fn const_new(
                inner_radius: $Number,
                outer_radius: $Number,
                height: $Number,
            ) -> Result<Self, SizeError> {
                match Annulus::<$Number>::const_new(inner_radius, outer_radius) {
                    Ok(annulus) => {
                        checked!(constant::$checks::size(height) => SizeError::Height);
                        Ok(Self { radii: annulus.radii, height })
                    }
                    Err(error) => Err(error),
                }
            }
        }

        impl<$($generics)*> Torus<$Number> {
            /// [`Torus::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Torus::new`].
            pub const fn const_new(major_radius: $Number, minor_radius: $Number) -> Result<Self, SizeError> {
                checked!(
                    constant::$checks::size(major_radius) => SizeError::Radius,
                    constant::$checks::size(minor_radius) => SizeError::Radius,
                );
                if constant::$checks::is_less(minor_radius, major_radius) {
                    Ok(Self { radii: [major_radius, minor_radius] })
                } else {
                    Err(SizeError::Ring)
                }
            }
        }

        impl<$($generics)*> Annulus<$Number> {
            /// [`Annulus::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Annulus::new`].
            pub const fn const_new(inner_radius: $Number, outer_radius: $Number) -> Result<Self, SizeError> {
                checked!(
                    constant::$checks::size(inner_radius) => SizeError::Radius,
                    constant::$checks::size(outer_radius) => SizeError::Radius,
                );
                if constant::$checks::is_less(inner_radius, outer_radius) {
                    Ok(Self { radii: [inner_radius, outer_radius] })
                } else {
                    Err(SizeError::Radii)
                }
            }
        }

        impl<$($generics)*> Revolved<$Number> {
            /// [`Revolved::new`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Revolved::new`].
            pub const fn const_new(
                a: $Number,
                b: $Number,
                radius: $Number,
                heights: [$Number; 2],
            ) -> Result<Self, SizeError> {
                let budget = <$Number as crate::scalar::Scalar>::BUDGET;
                checked!(
                    constant::$checks::within(a, budget.slope) => SizeError::Coefficient,
                    constant::$checks::within(b, budget.size) => SizeError::Coefficient,
                    constant::$checks::size_or_zero(radius) => SizeError::Radius,
                    constant::$checks::within(heights[0], budget.size) => SizeError::Height,
                    constant::$checks::within(heights[1], budget.size) => SizeError::Height,
                );
                let zero = <$Number as crate::scalar::Scalar>::ZERO;
                // A negative zero is stored as zero.
                let is_zero = constant::$checks::is_zero;
                let a = if is_zero(a) { zero } else { a };
                let b = if is_zero(b) { zero } else { b };
                let r = if is_zero(radius) { zero } else { radius };
                let low = if is_zero(heights[0]) { zero } else { heights[0] };
                let high = if is_zero(heights[1]) { zero } else { heights[1] };
                let outline = Doubles {
                    a: constant::$checks::double(a),
                    b: constant::$checks::double(b),
                    r: constant::$checks::double(r),
                    low: constant::$checks::double(low),
                    high: constant::$checks::double(high),
                    rounding: <<$Number as crate::scalar::Numbers>::Real as crate::scalar::Real>::ROUNDING,
                };
                if let Some(error) = outline.fault(constant::$checks::double(budget.size)) {
                    return Err(error);
                }
                let has_waist = has_waist(outline.signs());
                Ok(Self { meridian: Meridian { a, b, r, heights: [low, high], is_open: false, has_waist } })
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
