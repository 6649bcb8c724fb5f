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

        /// True if the first of two numbers is below the second.
        pub(crate) const fn is_less<$($generics)*>(a: $Number, b: $Number) -> bool {
            raw!(a) < raw!(b)
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

        /// What is wrong with a number of any sign and of at most this magnitude, if anything is.
        pub(crate) const fn within<$($generics)*>(value: $Number, most: $Number) -> Option<ValueError> {
            if magnitude!(value) <= raw!(most) {
                None
            } else if infinite!(value) {
                Some(ValueError::NotFinite)
            } else {
                Some(ValueError::BeyondBudget)
            }
        }

        /// True for components whose length is 1 within 2^-20.
        pub(crate) const fn is_unit(v: [Unit; 3]) -> bool {
            is_short(v[0]) && is_short(v[1]) && is_short(v[2]) && is_square_of_unit(dot(widened(v), v))
        }

        /// The axes of a frame that a quaternion of length 1 turns: the columns of its matrix. `None` for another
        /// length.
        pub(crate) const fn axes_of([x, y, z, w]: [Unit; 4]) -> Option<[[Unit; 3]; 3]> {
            if !(is_short(x) && is_short(y) && is_short(z) && is_short(w)) {
                return None;
            }
            let ([x, y, z], [w, _, _]) = (widened([x, y, z]), widened([w, w, w]));
            let square = x * x + y * y + z * z + w * w;
            if !is_square_of_unit(square) {
                return None;
            }
            let (xy, xz, yz) = (x * y + x * y, x * z + x * z, y * z + y * z);
            let (wx, wy, wz) = (w * x + w * x, w * y + w * y, w * z + w * z);
            Some([
                [over(w * w + x * x - y * y - z * z, square), over(xy + wz, square), over(xz - wy, square)],
                [over(xy - wz, square), over(w * w - x * x + y * y - z * z, square), over(yz + wx, square)],
                [over(xz + wy, square), over(yz - wx, square), over(w * w - x * x - y * y + z * z, square)],
            ])
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

            /// The limit that keeps squares in the type, as at run time. A NaN compares false.
            const fn is_short(component: Unit) -> bool {
                $Float::abs(component) < 1.25
            }

            pub(crate) const fn negated([x, y, z]: [Unit; 3]) -> [Unit; 3] {
                [-x, -y, -z]
            }

            const fn widened([x, y, z]: [Unit; 3]) -> [$Float; 3] {
                [x, y, z]
            }

            const fn is_square_of_unit(square: $Float) -> bool {
                $Float::abs(square - 1.0) < 1.0 / 524_288.0
            }

            const fn over(dividend: $Float, divisor: $Float) -> Unit {
                dividend / divisor
            }

            /// The value as a double, for checks alone.
            pub(crate) const fn double(value: $Float) -> f64 {
                value as f64
            }

            /// The number to compute in.
            pub(crate) const fn real(value: $Float) -> $Float {
                value
            }

            /// Half of the number, to compute in.
            pub(crate) const fn half(value: $Float) -> $Float {
                value / 2.0
            }

            /// The sum of two sizes.
            pub(crate) const fn plus(a: $Float, b: $Float) -> $Float {
                a + b
            }

            /// The difference of two coordinates.
            pub(crate) const fn minus(a: $Float, b: $Float) -> $Float {
                a - b
            }

            /// The magnitude.
            pub(crate) const fn magnitude(value: $Float) -> $Float {
                $Float::abs(value)
            }
        }
    };
}
floats!(single, f32);
floats!(double, f64);

/// The module of a width of fixed point.
#[cfg(feature = "fixed")]
macro_rules! fixed {
    (
        $module:ident, $Fixed:ident, $LeEq:ident, $UnitBits:ident, $unit_bits:literal, $raw:ty, $wide:ty, $Block:ident
    ) => {
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

            /// The limit that keeps squares in the width, as at run time.
            const fn is_short(component: Unit) -> bool {
                component.to_bits().saturating_abs() < 5 << ($unit_bits - 2)
            }

            pub(crate) const fn negated([x, y, z]: [Unit; 3]) -> [Unit; 3] {
                [
                    Unit::from_bits(x.to_bits().wrapping_neg()),
                    Unit::from_bits(y.to_bits().wrapping_neg()),
                    Unit::from_bits(z.to_bits().wrapping_neg()),
                ]
            }

            /// True for 1 within 2^-19, with twice the fraction bits.
            const fn is_square_of_unit(square: $wide) -> bool {
                (square - (1 << (2 * $unit_bits))).abs() < 1 << (2 * $unit_bits - 19)
            }

            /// The quotient of two numbers of twice the fraction bits, rounded to nearest.
            const fn over(dividend: $wide, divisor: $wide) -> Unit {
                let divisor = divisor >> $unit_bits;
                Unit::from_bits((dividend + divisor / 2).div_euclid(divisor) as $raw)
            }

            /// The value as a double, rounded, for checks alone.
            pub(crate) const fn double<F: $LeEq>(value: $Fixed<F>) -> f64 {
                value.to_bits() as f64 / (1_u128 << F::U32) as f64
            }

            /// The number to compute in.
            pub(crate) const fn real<F: $LeEq>(value: $Fixed<F>) -> $Block {
                $Block::new(value.to_bits() as $wide, -(F::I32))
            }

            /// Half of the number, to compute in.
            pub(crate) const fn half<F: $LeEq>(value: $Fixed<F>) -> $Block {
                $Block::new(value.to_bits() as $wide, -(F::I32) - 1)
            }

            /// The sum of two sizes; the end of the type if that is beyond.
            pub(crate) const fn plus<F: $LeEq>(a: $Fixed<F>, b: $Fixed<F>) -> $Fixed<F> {
                a.saturating_add(b)
            }

            /// The difference of two coordinates; the end of the type if that is beyond.
            pub(crate) const fn minus<F: $LeEq>(a: $Fixed<F>, b: $Fixed<F>) -> $Fixed<F> {
                a.saturating_sub(b)
            }

            /// The magnitude.
            pub(crate) const fn magnitude<F: $LeEq>(value: $Fixed<F>) -> $Fixed<F> {
                value.saturating_abs()
            }
        }
    };
}
#[cfg(feature = "fixed")]
fixed!(narrow, FixedI32, LeEqU32, U30, 30, i32, i64, Block64);
#[cfg(feature = "fixed")]
fixed!(wide, FixedI64, LeEqU64, U62, 62, i64, i128, Block128);
