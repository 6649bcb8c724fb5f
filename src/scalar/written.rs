//! How stored numbers are written: for `serde` and for `defmt`.
//!
//! In formats that people read, a fixed-point number is decimal text, with as many digits as are needed to read the
//! same bits back. In binary formats it is its bits.

/// What stored numbers and unit components do for the optional features.
pub trait Written: ForSerde + ForDefmt {}
impl<T: ForSerde + ForDefmt> Written for T {}

#[cfg(not(feature = "serde"))]
pub trait ForSerde {}
#[cfg(not(feature = "serde"))]
impl<T> ForSerde for T {}

#[cfg(not(feature = "defmt"))]
pub trait ForDefmt {}
#[cfg(not(feature = "defmt"))]
impl<T> ForDefmt for T {}

/// A number for the optional features, whose traits cannot be implemented for foreign types.
#[cfg(any(feature = "serde", feature = "defmt"))]
pub(crate) struct Plain<T>(pub T);

#[cfg(feature = "serde")]
pub use with_serde::ForSerde;
#[cfg(feature = "serde")]
pub(crate) use with_serde::{deserialize, serialize, three};

#[cfg(feature = "serde")]
mod with_serde {
    use super::Plain;
    #[cfg(feature = "fixed")]
    use crate::scalar::block::{Block64, Block128};
    use core::fmt;
    use core::marker::PhantomData;
    use serde::de::{Error, Unexpected, Visitor};
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    /// A number that is written and read.
    pub trait ForSerde: Sized {
        fn write<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error>;
        fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error>;
    }

    /// For `serde(with = ..)` on a field.
    pub(crate) fn serialize<T: ForSerde, Z: Serializer>(value: &T, serializer: Z) -> Result<Z::Ok, Z::Error> {
        value.write(serializer)
    }

    /// For `serde(with = ..)` on a field of three numbers.
    pub(crate) mod three {
        use super::{ForSerde, Plain};
        use serde::{Deserialize, Deserializer, Serialize, Serializer};

        pub(crate) fn serialize<T: ForSerde + Copy, Z: Serializer>(values: &[T; 3], to: Z) -> Result<Z::Ok, Z::Error> {
            values.map(Plain).serialize(to)
        }

        pub(crate) fn deserialize<'de, T: ForSerde, D: Deserializer<'de>>(from: D) -> Result<[T; 3], D::Error> {
            <[Plain<T>; 3]>::deserialize(from).map(|values| values.map(|Plain(value)| value))
        }
    }

    /// A number to compute in: an integer, and the power of two by which it is multiplied.
    #[cfg(feature = "fixed")]
    macro_rules! blocks {
        ($($Block:ident($mantissa:ty),)+) => {$(
            impl ForSerde for $Block {
                fn write<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
                    (self.mantissa(), self.exponent()).serialize(serializer)
                }
                fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                    let (mantissa, exponent) = <($mantissa, i32)>::deserialize(deserializer)?;
                    // The largest mantissa that a block may have, and an exponent with which no computation approaches
                    // the limit of 32 bits.
                    if mantissa.unsigned_abs() <= 1 << (<$mantissa>::BITS - 2) && exponent.unsigned_abs() <= 2048 {
                        Ok(Self::new(mantissa, exponent))
                    } else {
                        Err(D::Error::custom("the number is beyond what the library computes with"))
                    }
                }
            }
        )+};
    }
    #[cfg(feature = "fixed")]
    blocks!(Block64(i64), Block128(i128),);

    /// For `serde(with = ..)` on a field.
    pub(crate) fn deserialize<'de, T: ForSerde, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
        T::read(deserializer)
    }

    impl<T: ForSerde> Serialize for Plain<T> {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            self.0.write(serializer)
        }
    }

    impl<'de, T: ForSerde> Deserialize<'de> for Plain<T> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            T::read(deserializer).map(Self)
        }
    }

    /// Reads a number, or the text that a fixed-point number was written as.
    struct AnyFloat<T>(PhantomData<T>);

    macro_rules! floats {
        ($($Float:ty),+) => {$(
            impl ForSerde for $Float {
                fn write<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
                    self.serialize(serializer)
                }
                fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                    if deserializer.is_human_readable() {
                        deserializer.deserialize_any(AnyFloat::<Self>(PhantomData))
                    } else {
                        Self::deserialize(deserializer)
                    }
                }
            }

            impl Visitor<'_> for AnyFloat<$Float> {
                type Value = $Float;

                fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                    f.write_str("a number, or the text of one")
                }
                fn visit_str<E: Error>(self, text: &str) -> Result<$Float, E> {
                    text.parse().map_err(|_| E::invalid_value(Unexpected::Str(text), &self))
                }
                fn visit_f64<E: Error>(self, value: f64) -> Result<$Float, E> {
                    Ok(value as $Float)
                }
                fn visit_i64<E: Error>(self, value: i64) -> Result<$Float, E> {
                    Ok(value as $Float)
                }
                fn visit_u64<E: Error>(self, value: u64) -> Result<$Float, E> {
                    Ok(value as $Float)
                }
            }
        )+};
    }
    floats!(f32, f64);

    #[cfg(feature = "fixed")]
    mod with_fixed {
        use super::ForSerde;
        use crate::scalar::decimal::{Decimal, parse, shortest};
        use core::fmt;
        use core::marker::PhantomData;
        use fixed::traits::Fixed;
        use fixed::types::extra::{LeEqU32, LeEqU64};
        use fixed::{FixedI32, FixedI64};
        use serde::de::{Error, Unexpected, Visitor};
        use serde::{Deserialize, Deserializer, Serialize, Serializer};

        /// A number of this sign and magnitude, with the fewest decimal places from which the same bits are read.
        struct Text {
            negative: bool,
            magnitude: u64,
            fraction_bits: u32,
        }

        impl fmt::Display for Text {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let Decimal { whole, places, fraction } = shortest(self.magnitude, self.fraction_bits);
                let sign = if self.negative { "-" } else { "" };
                if places == 0 { write!(f, "{sign}{whole}") } else { write!(f, "{sign}{whole}.{fraction:0places$}") }
            }
        }

        /// Reads decimal text, or a number, which people may write instead.
        struct AnyNumber<T>(PhantomData<T>);

        impl<T: Fixed> Visitor<'_> for AnyNumber<T>
        where
            T::Bits: TryFrom<i128>,
        {
            type Value = T;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a decimal number that the number type can hold, such as \"-12.5\"")
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
                let bits = parse(text, T::FRAC_NBITS).and_then(|(negative, units)| {
                    let units = i128::try_from(units).ok()?;
                    T::Bits::try_from(if negative { -units } else { units }).ok()
                });
                bits.map(T::from_bits).ok_or_else(|| E::invalid_value(Unexpected::Str(text), &self))
            }
            fn visit_f64<E: Error>(self, value: f64) -> Result<T, E> {
                let number = if value.is_finite() { T::checked_from_num(value) } else { None };
                number.ok_or_else(|| E::invalid_value(Unexpected::Float(value), &self))
            }
            fn visit_i64<E: Error>(self, value: i64) -> Result<T, E> {
                T::checked_from_num(value).ok_or_else(|| E::invalid_value(Unexpected::Signed(value), &self))
            }
            fn visit_u64<E: Error>(self, value: u64) -> Result<T, E> {
                T::checked_from_num(value).ok_or_else(|| E::invalid_value(Unexpected::Unsigned(value), &self))
            }
        }

        macro_rules! fixed {
            ($Fixed:ident, $LeEq:ident, $raw:ty) => {
                impl<F: $LeEq> ForSerde for $Fixed<F> {
                    fn write<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
                        if serializer.is_human_readable() {
                            let (negative, magnitude) = (self.is_negative(), self.to_bits().unsigned_abs().into());
                            serializer.collect_str(&Text { negative, magnitude, fraction_bits: F::U32 })
                        } else {
                            self.to_bits().serialize(serializer)
                        }
                    }
                    fn read<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                        if deserializer.is_human_readable() {
                            deserializer.deserialize_any(AnyNumber(PhantomData))
                        } else {
                            <$raw>::deserialize(deserializer).map(Self::from_bits)
                        }
                    }
                }
            };
        }
        fixed!(FixedI32, LeEqU32, i32);
        fixed!(FixedI64, LeEqU64, i64);
    }
}

#[cfg(feature = "defmt")]
pub use with_defmt::ForDefmt;

#[cfg(feature = "defmt")]
mod with_defmt {
    use super::Plain;

    /// A number that is logged.
    pub trait ForDefmt {
        fn log(&self, f: defmt::Formatter<'_>);
    }

    impl<T: ForDefmt> defmt::Format for Plain<T> {
        fn format(&self, f: defmt::Formatter<'_>) {
            self.0.log(f);
        }
    }

    macro_rules! floats {
        ($($Float:ty),+) => {$(
            impl ForDefmt for $Float {
                fn log(&self, f: defmt::Formatter<'_>) {
                    defmt::Format::format(self, f);
                }
            }
        )+};
    }
    floats!(f32, f64);

    #[cfg(feature = "fixed")]
    mod with_fixed {
        use super::ForDefmt;
        use crate::scalar::decimal::digits;
        use fixed::types::extra::{LeEqU32, LeEqU64};
        use fixed::{FixedI32, FixedI64};

        // Ten and nineteen places, cut off and not rounded, so that the chip needs no formatter.
        impl<F: LeEqU32> ForDefmt for FixedI32<F> {
            fn log(&self, f: defmt::Formatter<'_>) {
                let (whole, places) = digits(self.to_bits().unsigned_abs().into(), F::U32, 10);
                let sign = if self.is_negative() { "-" } else { "" };
                defmt::write!(f, "{=str}{=u64}.{=u64:010}", sign, whole, places);
            }
        }

        impl<F: LeEqU64> ForDefmt for FixedI64<F> {
            fn log(&self, f: defmt::Formatter<'_>) {
                let (whole, places) = digits(self.to_bits().unsigned_abs(), F::U32, 19);
                let sign = if self.is_negative() { "-" } else { "" };
                defmt::write!(f, "{=str}{=u64}.{=u64:019}", sign, whole, places);
            }
        }
    }
}
