//! Combinations as they are stored and written: the leaves and the operations.

use super::Combination;
#[cfg(feature = "defmt")]
use super::LeafHit;
use crate::scalar::Scalar;
use crate::shape::kinds::Primitives;

#[cfg(feature = "serde")]
mod with_serde {
    use super::{Combination, Primitives, Scalar};
    use serde::ser::{SerializeSeq, SerializeStruct};
    use serde::{Serialize, Serializer};

    /// A struct of the list of leaves and that of the operations: what [`Combination::new`] takes. It is read as these
    /// two lists, into storage of the program's, since a combination borrows them.
    impl<S: Scalar, L: Primitives> Serialize for Combination<'_, S, L> {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            let mut stored = serializer.serialize_struct("Combination", 2)?;
            stored.serialize_field("leaves", self.leaves())?;
            stored.serialize_field("operations", &List(self))?;
            stored.end()
        }
    }

    /// The operations as a list.
    struct List<'c, 'a, S: Scalar, L: Primitives>(&'c Combination<'a, S, L>);

    impl<S: Scalar, L: Primitives> Serialize for List<'_, '_, S, L> {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            let mut list = serializer.serialize_seq(Some(self.0.operations().count()))?;
            for op in self.0.operations() {
                list.serialize_element(&op)?;
            }
            list.end()
        }
    }
}

#[cfg(feature = "defmt")]
mod with_defmt {
    use super::{Combination, LeafHit, Primitives, Scalar};
    use crate::shape::combination::operation::Operations;
    use defmt::{Format, Formatter, write};

    impl<S: Scalar, L: Primitives> Format for Combination<'_, S, L> {
        fn format(&self, f: Formatter<'_>) {
            match self.operations {
                Operations::Every(op) => write!(f, "Combination {{ leaves: {}, every: {} }}", self.leaves, op),
                Operations::Listed(list) => {
                    write!(f, "Combination {{ leaves: {}, operations: {} }}", self.leaves, list);
                }
            }
        }
    }

    impl<S: Scalar> Format for LeafHit<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "LeafHit {{ leaf: {}, hit: {} }}", self.leaf, self.hit);
        }
    }
}
