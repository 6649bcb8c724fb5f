//! The checks of constructors as `const fn`: stable Rust calls no trait method in a constant. A module for each width
//! of floats and of fixed point.
//!
//! `tests/promises/src/constants.rs` compares what they accept with what the constructors at run time accept.

/// Calls a macro for each number type: with the generics of an implementation, the type, and the module of its checks.
macro_rules! each_number {
    ($implement:ident) => {
        $implement!([] f32, single);
        $implement!([] f64, double);
        #[cfg(feature = "fixed")]
        $implement!([F: fixed::types::extra::LeEqU32 + Send + Sync + 'static] fixed::FixedI32<F>, narrow);
        #[cfg(feature = "fixed")]
        $implement!([F: fixed::types::extra::LeEqU64 + Send + Sync + 'static] fixed::FixedI64<F>, wide);
    };
}
pub(crate) use each_number;

/// Checks with the same code for floats and for fixed point. `raw!` gives the value to compare; `infinite!` is true for
/// values that are not finite.
macro_rules! checks {
    ([$($generics:tt)*] $Number:ty) => {
        const fn fault<$($generics)*>(value: $Number, least: $Number, most: $Number) -> Option<ValueError> {
            // A NaN compares false.
            if raw!(value) >= raw!(least) && raw!(value) <= raw!(most) {
                None
            } else if infinite!(value) {
                Some(ValueError::NotFinite)
            } else if raw!(value) < raw!(<$Number as Scalar>::ZERO) {
                Some(ValueError::Negative)
            } else if is_zero(value) {
                Some(ValueError::Zero)
            } else if raw!(value) < raw!(least) {
                Some(ValueError::BelowBudget)
            } else {
                Some(ValueError::BeyondBudget)
            }
        }

        /// True for zero.
        pub(crate) const fn is_zero<$($generics)*>(value: $Number) -> bool {
            raw!(value) == raw!(<$Number as Scalar>::ZERO)
        }

        /// What is wrong with a size, if anything is.
        pub(crate) const fn size<$($generics)*>(value: $Number) -> Option<ValueError> {
            fault(value, <$Number as Scalar>::BUDGET.smallest_size, <$Number as Scalar>::BUDGET.size)
        }

        /// The same for a size that may be zero.
        pub(crate) const fn size_or_zero<$($generics)*>(value: $Number) -> Option<ValueError> {
            if is_zero(value) { None } else { size(value) }
        }

        /// What is wrong with a slope, if anything is.
        pub(crate) const fn slope<$($generics)*>(value: $Number) -> Option<ValueError> {
            fault(value, <$Number as Scalar>::BUDGET.smallest_slope, <$Number as Scalar>::BUDGET.slope)
        }

        /// True for a positive number up to the largest coordinate.
        pub(crate) const fn is_extent<$($generics)*>(value: $Number) -> bool {
            raw!(value) > raw!(<$Number as Scalar>::ZERO) && raw!(value) <= raw!(<$Number as Scalar>::BUDGET.coordinate)
        }

        /// What is wrong with a point, if anything is.
        pub(crate) const fn point<$($generics)*>(point: Vec3<$Number>) -> Option<ValueError> {
            let ([x, y, z], most) = (point.to_array(), raw!(<$Number as Scalar>::BUDGET.coordinate));
            if magnitude!(x) <= most && magnitude!(y) <= most && magnitude!(z) <= most {
                None
            } else if infinite!(x) || infinite!(y) || infinite!(z) {
                Some(ValueError::NotFinite)
            } else {
                Some(ValueError::BeyondBudget)
            }
        }

        /// True for axes that are perpendicular within 2^-18, and right-handed.
        pub(crate) const fn are_axes([x, y, z]: [[Unit; 3]; 3]) -> bool {
            is_right(x, y) && is_right(y, z) && is_right(z, x) && is_right_handed(x, y, z)
        }
    };
}

/// The module of a float.
macro_rules! floats {
    ($module:ident, $Float:ident) => {
        pub(crate) mod $module {
            use crate::scalar::{Scalar, ValueError};
            use crate::vector::Vec3;

            type Unit = $Float;

            macro_rules! raw {
                ($value:expr) => {
                    $value
                };
            }
            macro_rules! magnitude {
                ($value:expr) => {
                    $Float::abs($value)
                };
            }
            macro_rules! infinite {
                ($value:expr) => {
                    !$Float::is_finite($value)
                };
            }
            checks!([] $Float);

            const fn dot(a: [Unit; 3], b: [Unit; 3]) -> $Float {
                a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
            }

            const fn is_right(a: [Unit; 3], b: [Unit; 3]) -> bool {
                $Float::abs(dot(a, b)) < 1.0 / 262_144.0
            }

            const fn is_right_handed(x: [Unit; 3], y: [Unit; 3], z: [Unit; 3]) -> bool {
                let cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
                dot(cross, z) > 0.0
            }

            /// True for components whose length is 1 within 2^-20.
            pub(crate) const fn is_unit(v: [Unit; 3]) -> bool {
                let (x, y, z) = ($Float::abs(v[0]), $Float::abs(v[1]), $Float::abs(v[2]));
                // The limit that keeps squares in the type, as at run time. A NaN compares false.
                x < 1.25 && y < 1.25 && z < 1.25 && $Float::abs(dot(v, v) - 1.0) < 1.0 / 524_288.0
            }

            pub(crate) const fn negated([x, y, z]: [Unit; 3]) -> [Unit; 3] {
                [-x, -y, -z]
            }

            /// The axes of a frame that a quaternion of length 1 turns; `None` for another length.
            pub(crate) const fn axes_of([x, y, z, w]: [Unit; 4]) -> Option<[[Unit; 3]; 3]> {
                let square = x * x + y * y + z * z + w * w;
                // A NaN compares false.
                let is_unit = $Float::abs(square - 1.0) < 1.0 / 524_288.0;
                if !is_unit {
                    return None;
                }
                let scale = 2.0 / square;
                Some([
                    [1.0 - scale * (y * y + z * z), scale * (x * y + w * z), scale * (x * z - w * y)],
                    [scale * (x * y - w * z), 1.0 - scale * (x * x + z * z), scale * (y * z + w * x)],
                    [scale * (x * z + w * y), scale * (y * z - w * x), 1.0 - scale * (x * x + y * y)],
                ])
            }

            /// The number to compute in.
            pub(crate) const fn real(value: $Float) -> $Float {
                value
            }

            /// Half of the number, to compute in.
            pub(crate) const fn half(value: $Float) -> $Float {
                value / 2.0
            }
        }
    };
}
floats!(single, f32);
floats!(double, f64);

/// The module of a width of fixed point.
#[cfg(feature = "fixed")]
macro_rules! fixed {
    ($module:ident, $Fixed:ident, $LeEq:ident, $UnitBits:ident, $unit_bits:literal, $raw:ty, $wide:ty, $Block:ident) => {
        #[cfg(feature = "fixed")]
        pub(crate) mod $module {
            use crate::scalar::block::$Block;
            use crate::scalar::{Scalar, ValueError};
            use crate::vector::Vec3;
            use fixed::$Fixed;
            use fixed::types::extra::{$LeEq, $UnitBits};

            type Unit = $Fixed<$UnitBits>;

            macro_rules! raw {
                ($value:expr) => {
                    $value.to_bits()
                };
            }
            macro_rules! magnitude {
                ($value:expr) => {
                    $value.to_bits().saturating_abs()
                };
            }
            macro_rules! infinite {
                ($value:expr) => {
                    $value.to_bits().saturating_abs() == <$raw>::MAX
                };
            }
            checks!([F: $LeEq + Send + Sync + 'static] $Fixed<F>);

            /// With twice the fraction bits. Components up to 1.25 do not leave the width.
            const fn dot(a: [$wide; 3], b: [Unit; 3]) -> $wide {
                a[0] * b[0].to_bits() as $wide + a[1] * b[1].to_bits() as $wide + a[2] * b[2].to_bits() as $wide
            }

            const fn widened([x, y, z]: [Unit; 3]) -> [$wide; 3] {
                [x.to_bits() as $wide, y.to_bits() as $wide, z.to_bits() as $wide]
            }

            const fn is_right(a: [Unit; 3], b: [Unit; 3]) -> bool {
                dot(widened(a), b).abs() < 1 << (2 * $unit_bits - 18)
            }

            const fn is_right_handed(x: [Unit; 3], y: [Unit; 3], z: [Unit; 3]) -> bool {
                let (x, y) = (widened(x), widened(y));
                let cross = [
                    (x[1] * y[2] - x[2] * y[1]) >> $unit_bits,
                    (x[2] * y[0] - x[0] * y[2]) >> $unit_bits,
                    (x[0] * y[1] - x[1] * y[0]) >> $unit_bits,
                ];
                dot(cross, z) > 0
            }

            /// True for components whose length is 1 within 2^-20.
            pub(crate) const fn is_unit(v: [Unit; 3]) -> bool {
                const LIMIT: $raw = 5 << ($unit_bits - 2);
                let (x, y, z) = (v[0].to_bits(), v[1].to_bits(), v[2].to_bits());
                let are_short = x.saturating_abs() < LIMIT && y.saturating_abs() < LIMIT && z.saturating_abs() < LIMIT;
                are_short && (dot(widened(v), v) - (1 << (2 * $unit_bits))).abs() < 1 << (2 * $unit_bits - 19)
            }

            pub(crate) const fn negated([x, y, z]: [Unit; 3]) -> [Unit; 3] {
                [
                    Unit::from_bits(x.to_bits().wrapping_neg()),
                    Unit::from_bits(y.to_bits().wrapping_neg()),
                    Unit::from_bits(z.to_bits().wrapping_neg()),
                ]
            }

            /// The axes of a frame that a quaternion of length 1 turns; `None` for another length.
            pub(crate) const fn axes_of(quaternion: [Unit; 4]) -> Option<[[Unit; 3]; 3]> {
                // Squares of components up to 1.25 do not leave the width.
                const LIMIT: $wide = 5 << ($unit_bits - 2);
                let [x, y, z, w] = quaternion;
                let [x, y, z] = widened([x, y, z]);
                let w = w.to_bits() as $wide;
                if x.abs() >= LIMIT || y.abs() >= LIMIT || z.abs() >= LIMIT || w.abs() >= LIMIT {
                    return None;
                }
                let square = x * x + y * y + z * z + w * w;
                if (square - (1 << (2 * $unit_bits))).abs() >= 1 << (2 * $unit_bits - 19) {
                    return None;
                }
                Some([
                    [
                        over(w * w + x * x - y * y - z * z, square),
                        over(2 * (x * y + w * z), square),
                        over(2 * (x * z - w * y), square),
                    ],
                    [
                        over(2 * (x * y - w * z), square),
                        over(w * w - x * x + y * y - z * z, square),
                        over(2 * (y * z + w * x), square),
                    ],
                    [
                        over(2 * (x * z + w * y), square),
                        over(2 * (y * z - w * x), square),
                        over(w * w - x * x - y * y + z * z, square),
                    ],
                ])
            }

            /// The quotient of two numbers of twice the fraction bits, rounded to nearest.
            const fn over(dividend: $wide, divisor: $wide) -> Unit {
                let divisor = divisor >> $unit_bits;
                Unit::from_bits((dividend + divisor / 2).div_euclid(divisor) as $raw)
            }

            /// The number to compute in.
            pub(crate) const fn real<F: $LeEq>(value: $Fixed<F>) -> $Block {
                $Block::new(value.to_bits() as $wide, -(F::I32))
            }

            /// Half of the number, to compute in.
            pub(crate) const fn half<F: $LeEq>(value: $Fixed<F>) -> $Block {
                $Block::new(value.to_bits() as $wide, -(F::I32) - 1)
            }
        }
    };
}
#[cfg(feature = "fixed")]
fixed!(narrow, FixedI32, LeEqU32, U30, 30, i32, i64, Block64);
#[cfg(feature = "fixed")]
fixed!(wide, FixedI64, LeEqU64, U62, 62, i64, i128, Block128);
