//! Shapes as they are stored and written.

use super::Shape;
use super::combined::Combined;
use super::kinds::Kinds;
use crate::scalar::Scalar;

#[cfg(feature = "serde")]
mod with_serde {
    use super::{Combined, Kinds, Scalar, Shape};
    use crate::shape::kinds::Primitives;
    use crate::shape::{Placement, Primitive, Visible};
    use serde::de::Error;
    use serde::ser::SerializeStruct;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    #[serde(bound = "", rename = "Shape")]
    struct Stored<S: Scalar> {
        primitive: Primitive<S>,
        placement: Placement<S>,
        visible: Visible,
    }

    /// Of a combination, itself in the place of primitive and placement.
    impl<S: Scalar, K: Kinds> Serialize for Shape<S, K> {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            if let Some(combination) = self.combined.combination() {
                let mut stored = serializer.serialize_struct("Shape", 2)?;
                stored.serialize_field("combination", combination)?;
                stored.serialize_field("visible", &self.visible())?;
                return stored.end();
            }
            let ((primitive, placement), visible) = (self.own(), self.visible());
            let (primitive, placement) = (*primitive, *placement);
            Stored { primitive, placement, visible }.serialize(serializer)
        }
    }

    /// Only a shape whose primitive and placement are among the kinds.
    impl<'de, S: Scalar, K: Primitives> Deserialize<'de> for Shape<S, K> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let Stored { primitive, placement, visible } = Stored::deserialize(deserializer)?;
            let shape = Shape::new(primitive).placed(placement).seen_from(visible);
            shape.among().map_err(D::Error::custom)
        }
    }
}

#[cfg(feature = "defmt")]
impl<S: Scalar, K: Kinds> defmt::Format for Shape<S, K> {
    fn format(&self, f: defmt::Formatter<'_>) {
        if let Some(combination) = self.combined.combination() {
            return defmt::write!(f, "Shape {{ combination: {}, visible: {} }}", combination, self.visible());
        }
        let ((primitive, placement), visible) = (self.own(), self.visible());
        defmt::write!(f, "Shape {{ primitive: {}, placement: {}, visible: {} }}", primitive, placement, visible);
    }
}
