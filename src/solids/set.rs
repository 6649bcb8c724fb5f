//! Sets of solids.

use core::fmt;

/// A set of solids, by their indices in a list: a bit for each. `W` is the number of 32-bit words, so that it can hold
/// the first `32 W` solids of a list.
///
/// ```
/// use raylet::solids::SolidSet;
/// let glass_and_water = SolidSet::<1>::EMPTY.with(0).with(2);
/// assert!(glass_and_water.contains(2) && !glass_and_water.contains(1));
/// assert_eq!(glass_and_water.last(), Some(2));
/// assert_eq!(glass_and_water.without(2).iter().collect::<Vec<_>>(), [0]);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SolidSet<const W: usize = 1> {
    words: [u32; W],
}

impl<const W: usize> SolidSet<W> {
    /// No solid.
    pub const EMPTY: Self = Self { words: [0; W] };

    /// The number of solids that it can hold: those of smaller indices.
    pub const CAPACITY: usize = 32 * W;

    /// The set with this solid. One that it cannot hold is left out.
    #[must_use]
    pub fn with(mut self, solid: u32) -> Self {
        if let Some(word) = self.words.get_mut(solid as usize / 32) {
            *word |= 1 << (solid % 32);
        }
        self
    }

    /// The set without this solid.
    #[must_use]
    pub fn without(mut self, solid: u32) -> Self {
        if let Some(word) = self.words.get_mut(solid as usize / 32) {
            *word &= !(1 << (solid % 32));
        }
        self
    }

    /// True if the solid is in the set.
    #[inline]
    pub fn contains(&self, solid: u32) -> bool {
        self.words.get(solid as usize / 32).is_some_and(|word| word >> (solid % 32) & 1 != 0)
    }

    /// True if there is no solid in it.
    pub fn is_empty(&self) -> bool {
        self.words.iter().all(|word| *word == 0)
    }

    /// The number of solids in it.
    pub fn len(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// The solid with the largest index; `None` of an empty set.
    pub fn last(&self) -> Option<u32> {
        let (index, word) = (0_u32..).zip(&self.words).filter(|(_, word)| **word != 0).last()?;
        Some(32 * index + 31 - word.leading_zeros())
    }

    /// The solids, in the order of their indices.
    pub fn iter(&self) -> impl Iterator<Item = u32> + '_ {
        (0_u32..)
            .zip(&self.words)
            .flat_map(|(index, word)| (0..32).filter(move |bit| word >> bit & 1 != 0).map(move |bit| 32 * index + bit))
    }
}

/// As the list of its solids.
#[cfg(feature = "serde")]
impl<const W: usize> serde::Serialize for SolidSet<W> {
    fn serialize<T: serde::Serializer>(&self, serializer: T) -> Result<T::Ok, T::Error> {
        serializer.collect_seq(self.iter())
    }
}

#[cfg(feature = "serde")]
impl<'de, const W: usize> serde::Deserialize<'de> for SolidSet<W> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(Listed)
    }
}

/// Reads a list of solids.
#[cfg(feature = "serde")]
struct Listed<const W: usize>;

#[cfg(feature = "serde")]
impl<'de, const W: usize> serde::de::Visitor<'de> for Listed<W> {
    type Value = SolidSet<W>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a list of solids with indices below {}", SolidSet::<W>::CAPACITY)
    }

    fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut list: A) -> Result<SolidSet<W>, A::Error> {
        let mut set = SolidSet::EMPTY;
        while let Some(solid) = list.next_element::<u32>()? {
            set = set.with(solid);
            if !set.contains(solid) {
                return Err(serde::de::Error::invalid_value(serde::de::Unexpected::Unsigned(solid.into()), &self));
            }
        }
        Ok(set)
    }
}

impl<const W: usize> Default for SolidSet<W> {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl<const W: usize> fmt::Debug for SolidSet<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}
