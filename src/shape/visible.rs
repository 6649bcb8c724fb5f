//! The sides from which a surface is seen.

use crate::hit::Crossing;
use crate::query::Reported;

/// Culling: from which sides rays hit a surface. A one-sided surface ignores crossings from its other side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Visible {
    /// From both sides.
    #[default]
    Both,
    /// From outside (of an open surface, from the front) only: no [`Crossing::Exit`] is reported.
    Outside,
    /// From inside (of an open surface, from the back) only: no [`Crossing::Enter`] is reported.
    Inside,
}

impl Visible {
    /// The crossings that are reported.
    #[inline(always)]
    pub(super) fn reported(self) -> Reported {
        Reported { enter: self != Self::Inside, exit: self != Self::Outside }
    }

    /// True if such a crossing is reported. A touch always is.
    #[inline]
    pub(crate) const fn sees(self, crossing: Crossing) -> bool {
        !matches!((self, crossing), (Self::Outside, Crossing::Exit) | (Self::Inside, Crossing::Enter))
    }
}
