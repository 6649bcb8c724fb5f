//! The effects by name, and sets of them.

use core::fmt;

/// An effect. The order is that in which sets list them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Effect {
    /// Light of the same strength from everywhere.
    Ambient,
    /// Diffuse shading.
    Diffuse,
    /// Specular highlights.
    Specular,
    /// Shadows: an occluded light contributes nothing.
    Shadows,
    /// Mirror reflection.
    Reflection,
    /// Refraction by transparent objects, with Fresnel reflection.
    Refraction,
    /// Colours from a pattern or an image.
    Texture,
    /// Bump mapping.
    Bump,
    /// Attenuation by fog.
    Fog,
    /// Adaptive supersampling where a pixel's corners differ.
    Antialiasing,
    /// Lines around what is seen.
    Outline,
}

impl Effect {
    /// Every effect, in order.
    pub const EVERY: [Self; 11] = [
        Self::Ambient,
        Self::Diffuse,
        Self::Specular,
        Self::Shadows,
        Self::Reflection,
        Self::Refraction,
        Self::Texture,
        Self::Bump,
        Self::Fog,
        Self::Antialiasing,
        Self::Outline,
    ];

    /// The name in messages and on command lines, in lower case.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ambient => "ambient",
            Self::Diffuse => "diffuse",
            Self::Specular => "specular",
            Self::Shadows => "shadows",
            Self::Reflection => "reflection",
            Self::Refraction => "refraction",
            Self::Texture => "texture",
            Self::Bump => "bump",
            Self::Fog => "fog",
            Self::Antialiasing => "antialiasing",
            Self::Outline => "outline",
        }
    }

    /// The effect of this name; `None` if there is none.
    ///
    /// ```
    /// use raylet::effect::Effect;
    /// assert_eq!(Effect::named("fog"), Some(Effect::Fog));
    /// assert_eq!(Effect::named("Fog"), None);
    /// ```
    pub fn named(name: &str) -> Option<Self> {
        Self::EVERY.into_iter().find(|effect| effect.name() == name)
    }

    const fn bit(self) -> u16 {
        1 << self as u16
    }
}

impl fmt::Display for Effect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A set of effects: a bit for each.
///
/// ```
/// use raylet::effect::{Effect, EffectSet};
/// const LIGHT: EffectSet = EffectSet::of(Effect::Diffuse).with(Effect::Shadows);
/// assert!(LIGHT.contains(Effect::Shadows) && !LIGHT.contains(Effect::Fog));
/// assert_eq!(LIGHT.to_string(), "diffuse, shadows");
/// assert_eq!(LIGHT.into_iter().count(), 2);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EffectSet(u16);

impl EffectSet {
    /// No effect.
    pub const EMPTY: Self = Self(0);
    /// Every effect.
    pub const ALL: Self = Self((1 << Effect::EVERY.len()) - 1);

    /// One effect.
    pub const fn of(effect: Effect) -> Self {
        Self(effect.bit())
    }

    /// True if the effect is in the set.
    #[inline(always)]
    pub const fn contains(self, effect: Effect) -> bool {
        self.0 & effect.bit() != 0
    }

    /// True if every effect of `other` is in the set.
    pub const fn includes(self, other: Self) -> bool {
        other.0 & !self.0 == 0
    }

    /// True if no effect is in the set.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// How many effects are in the set, 0 to 11.
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// The set with this effect added.
    #[must_use]
    pub const fn with(self, effect: Effect) -> Self {
        self.union(Self::of(effect))
    }

    /// The set with this effect removed.
    #[must_use]
    pub const fn without(self, effect: Effect) -> Self {
        self.difference(Self::of(effect))
    }

    /// The union of two sets.
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The intersection of two sets.
    #[must_use]
    pub const fn intersection(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// The effects that are in this set and not in the other.
    #[must_use]
    pub const fn difference(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// The effects in order.
    pub fn iter(self) -> Iter {
        Iter(self)
    }
}

impl From<Effect> for EffectSet {
    fn from(effect: Effect) -> Self {
        Self::of(effect)
    }
}

impl FromIterator<Effect> for EffectSet {
    fn from_iter<I: IntoIterator<Item = Effect>>(effects: I) -> Self {
        effects.into_iter().fold(Self::EMPTY, Self::with)
    }
}

/// The names in order, with commas; `none` for the empty set.
impl fmt::Display for EffectSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return f.write_str("none");
        }
        for (index, effect) in self.iter().enumerate() {
            if index > 0 {
                f.write_str(", ")?;
            }
            f.write_str(effect.name())?;
        }
        Ok(())
    }
}

impl IntoIterator for EffectSet {
    type Item = Effect;
    type IntoIter = Iter;
    fn into_iter(self) -> Iter {
        self.iter()
    }
}

/// The effects of a set, in order.
#[derive(Clone, Debug)]
pub struct Iter(EffectSet);

impl Iterator for Iter {
    type Item = Effect;

    fn next(&mut self) -> Option<Effect> {
        let effect = Effect::EVERY.into_iter().find(|effect| self.0.contains(*effect))?;
        self.0 = self.0.without(effect);
        Some(effect)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.0.len(), Some(self.0.len()))
    }
}

impl ExactSizeIterator for Iter {}

impl core::iter::FusedIterator for Iter {}
