//! Directions in constants.

use super::UnitVec3;
use crate::scalar::constant::{self, each_number};
use crate::scalar::{Unit, ValueError};

macro_rules! constants {
    ([$($generics:tt)*] $Number:ty, $checks:ident) => {
        impl<$($generics)*> UnitVec3<$Number> {
            /// [`UnitVec3::from_components`] in a constant. (The direction of a vector of another length needs a square
            /// root, which is not available in constants: compute the components elsewhere, with all digits of the
            /// type.)
            ///
            /// # Errors
            ///
            /// As [`UnitVec3::from_components`].
            pub const fn const_from_components(components: [Unit<$Number>; 3]) -> Result<Self, ValueError> {
                if constant::$checks::is_unit(components) { Ok(Self { components }) } else { Err(ValueError::NotUnit) }
            }

            /// The opposite direction, in a constant.
            #[must_use]
            pub const fn const_neg(self) -> Self {
                Self { components: constant::$checks::negated(self.components) }
            }
        }
    };
}
each_number!(constants);
