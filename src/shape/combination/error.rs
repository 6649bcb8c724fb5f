//! Why solids cannot be combined.

use super::{MOST_CROSSINGS, MOST_LEAVES};
use core::fmt;

/// Why solids cannot be combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CombinationError {
    /// There is no leaf, or there are more than [`MOST_LEAVES`].
    Leaves {
        /// How many there are.
        given: usize,
    },
    /// A leaf is a surface without an inside.
    NotSolid {
        /// Its index.
        leaf: u32,
    },
    /// A leaf is seen from one side only. That can be said of the shape of the combination.
    OneSided {
        /// Its index.
        leaf: u32,
    },
    /// A line may cross the leaves more than [`MOST_CROSSINGS`] times.
    Crossings {
        /// How often.
        most: usize,
    },
    /// An operation has fewer than two sets before it.
    NoOperands {
        /// Its index.
        operation: usize,
    },
    /// The operations name fewer leaves than there are, or more.
    OtherLeaves {
        /// How many they name.
        named: usize,
        /// How many there are.
        leaves: usize,
    },
    /// The operations leave more than one set.
    NotOne {
        /// How many sets.
        sets: usize,
    },
}

impl CombinationError {
    /// The message without numbers; also for constants.
    pub const fn message(self) -> &'static str {
        match self {
            Self::Leaves { .. } => "a combination has 1 to 16 leaves",
            Self::NotSolid { .. } => "a leaf is a surface without an inside: take a solid",
            Self::OneSided { .. } => "a leaf is seen from one side only: say that of the combination's shape",
            Self::Crossings { .. } => "a line may cross the leaves more than 32 times: take fewer leaves",
            Self::NoOperands { .. } => "an operation stands before its operands",
            Self::OtherLeaves { .. } => "the operations do not name each leaf once",
            Self::NotOne { .. } => "the operations leave several sets: combine them",
        }
    }
}

impl fmt::Display for CombinationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Leaves { given } => write!(f, "a combination has 1 to {MOST_LEAVES} leaves, and not {given}"),
            Self::NotSolid { leaf } => write!(f, "leaf {leaf} is a surface without an inside: take a solid"),
            Self::OneSided { leaf } => {
                write!(f, "leaf {leaf} is seen from one side only: say that of the combination's shape")
            }
            Self::Crossings { most } => {
                write!(f, "a line may cross the leaves {most} times, and at most {MOST_CROSSINGS} are listed: ")?;
                f.write_str("take fewer leaves")
            }
            Self::NoOperands { operation } => write!(f, "operation {operation} stands before its two operands"),
            Self::OtherLeaves { named, leaves } => {
                write!(f, "the operations name {named} leaves, and there are {leaves}: name each once")
            }
            Self::NotOne { sets } => write!(f, "the operations leave {sets} sets: combine them"),
        }
    }
}

impl core::error::Error for CombinationError {}
