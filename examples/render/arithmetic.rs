//! The number types and tiers that a picture may be traced in.

use clap::ValueEnum;
use std::fmt;

/// The number types that the library is compiled for here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Number {
    /// Floating point, single precision (32 bits)
    F32,
    /// Floating point, double precision (64 bits)
    F64,
    /// Fixed point, 32 bits: coordinates up to 16384 in steps of 1/65536
    #[value(name = "i16f16")]
    I16f16,
    /// Fixed point, 64 bits: coordinates up to 10^9 in steps of 2^-32
    #[value(name = "i32f32")]
    I32f32,
    /// Fixed point, 32 bits: coordinates up to 262144 in steps of 1/4096
    #[cfg(feature = "every-type")]
    #[value(name = "i20f12")]
    I20f12,
    /// Fixed point, 32 bits: coordinates up to 64 in steps of 2^-24
    #[cfg(feature = "every-type")]
    #[value(name = "i8f24")]
    I8f24,
}

/// Their names.
#[cfg(not(feature = "every-type"))]
const NAMES: &str =
    "f32, f64, i16f16, i32f32; i20f12 and i8f24 are compiled with `--features raylet-render/every-type`";
#[cfg(feature = "every-type")]
const NAMES: &str = "f32, f64, i16f16, i32f32, i20f12, i8f24";

impl Number {
    /// The types that may hold what this one does not; none for the widest.
    pub(crate) const fn wider(self) -> &'static [Self] {
        match self {
            Self::F64 => &[],
            Self::F32 | Self::I32f32 => &[Self::F64],
            Self::I16f16 => &[Self::I32f32, Self::F32, Self::F64],
            #[cfg(feature = "every-type")]
            Self::I20f12 | Self::I8f24 => &[Self::I16f16, Self::I32f32, Self::F32, Self::F64],
        }
    }

    /// The fraction bits of a fixed-point type.
    pub(crate) const fn fraction_bits(self) -> Option<i32> {
        match self {
            Self::F32 | Self::F64 => None,
            Self::I16f16 => Some(16),
            Self::I32f32 => Some(32),
            #[cfg(feature = "every-type")]
            Self::I20f12 => Some(12),
            #[cfg(feature = "every-type")]
            Self::I8f24 => Some(24),
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::I16f16 => "i16f16",
            Self::I32f32 => "i32f32",
            #[cfg(feature = "every-type")]
            Self::I20f12 => "i20f12",
            #[cfg(feature = "every-type")]
            Self::I8f24 => "i8f24",
        })
    }
}

/// The accuracy tiers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum TierName {
    /// The cheapest: for rays that start near and do not graze a surface
    Plain,
    /// Less accurate for rays that graze a surface or come from far away
    Fast,
    /// Accurate to some units in the last place for any ray
    #[default]
    Stable,
    /// Whether and where a ray hits is decided as exact arithmetic decides it
    Exact,
}

impl fmt::Display for TierName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Plain => "plain",
            Self::Fast => "fast",
            Self::Stable => "stable",
            Self::Exact => "exact",
        })
    }
}

/// What a picture is traced in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Arithmetic {
    pub(crate) number: Number,
    pub(crate) tier: TierName,
}

impl Arithmetic {
    /// The same, or what to do about a tier that the number type does not have.
    pub(crate) fn checked(self) -> Result<Self, String> {
        match self {
            Self { number: Number::F64 | Number::I32f32, tier: TierName::Exact } => {
                Err(format!("there is no exact tier for {}: take f32 or i16f16, or the tier `stable`", self.number))
            }
            _ => Ok(self),
        }
    }

    /// From the command line: `i16f16`, or `i16f16-exact`.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let (number, tier) = text.split_once('-').unwrap_or((text, "stable"));
        let number = Number::from_str(number, true)
            .map_err(|_| format!("there is no number type `{number}`: choose among {NAMES}"))?;
        let tier = TierName::from_str(tier, true).map_err(|_| {
            format!("there is no tier `{tier}`: choose among {}", ["plain", "fast", "stable", "exact"].join(", "))
        })?;
        Self { number, tier }.checked()
    }
}

impl fmt::Display for Arithmetic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = self.number;
        match self.tier {
            TierName::Plain => write!(f, "{number}-plain"),
            TierName::Fast => write!(f, "{number}-fast"),
            TierName::Stable => write!(f, "{number}"),
            TierName::Exact => write!(f, "{number}-exact"),
        }
    }
}
