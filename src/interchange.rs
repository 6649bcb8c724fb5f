//! Conversions to and from other crates' types: `mint` vectors and points, `serde`.

#[cfg(feature = "mint")]
mod with_mint {
    use crate::scalar::Scalar;
    use crate::vector::{UnitVec3, Vec3};

    /// Defines the conversions of a three-component `mint` type.
    macro_rules! mint {
        ($Type:ident) => {
            impl<S> From<mint::$Type<S>> for Vec3<S> {
                fn from(v: mint::$Type<S>) -> Self {
                    Self { x: v.x, y: v.y, z: v.z }
                }
            }

            impl<S> From<Vec3<S>> for mint::$Type<S> {
                fn from(v: Vec3<S>) -> Self {
                    Self { x: v.x, y: v.y, z: v.z }
                }
            }
        };
    }
    mint!(Vector3);
    mint!(Point3);

    impl<S> mint::IntoMint for Vec3<S> {
        type MintType = mint::Vector3<S>;
    }

    impl<S: Scalar> From<UnitVec3<S>> for mint::Vector3<S::Unit> {
        fn from(v: UnitVec3<S>) -> Self {
            Self { x: v.x(), y: v.y(), z: v.z() }
        }
    }
}

#[cfg(feature = "serde")]
mod with_serde {
    use crate::part::Part;
    use crate::ray::{Departure, Leaving, Range, Ray};
    use crate::scalar::Scalar;
    use crate::vector::{UnitVec3, Vec3};
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    impl<S: Scalar> Serialize for UnitVec3<S>
    where
        S::Unit: Serialize,
    {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            self.to_array().serialize(serializer)
        }
    }

    /// Only a vector of length 1 becomes a [`UnitVec3`].
    impl<'de, S: Scalar> Deserialize<'de> for UnitVec3<S>
    where
        S::Unit: Deserialize<'de>,
    {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let components = <[S::Unit; 3]>::deserialize(deserializer)?;
            Self::from_components(components).map_err(|error| {
                D::Error::custom(format_args!("the direction {error}: normalise it before it is stored"))
            })
        }
    }

    /// A ray as it is stored; checked by the constructor on its way in.
    #[derive(Serialize, Deserialize)]
    struct StoredRay<V, D, R> {
        origin: V,
        direction: D,
        range: R,
        departure: Option<(u32, Part, Leaving)>,
    }

    impl<S: Scalar + Serialize> Serialize for Ray<S>
    where
        S::Unit: Serialize,
    {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            let departure = self.departure().map(|d| (d.object, d.part, d.leaving));
            let (origin, direction) = (self.origin(), self.direction());
            StoredRay { origin, direction, range: (self.range().start(), self.range().end()), departure }
                .serialize(serializer)
        }
    }

    impl<'de, S: Scalar + Deserialize<'de>> Deserialize<'de> for Ray<S>
    where
        S::Unit: Deserialize<'de>,
    {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let stored = StoredRay::<Vec3<S>, UnitVec3<S>, (S, S)>::deserialize(deserializer)?;
            let range = Range::new(stored.range.0, stored.range.1).map_err(D::Error::custom)?;
            let ray = Self::new(stored.origin, stored.direction).map_err(D::Error::custom)?.with_range(range);
            Ok(match stored.departure {
                Some((object, part, leaving)) => ray.departing(Departure { object, part, leaving }),
                None => ray,
            })
        }
    }

    impl<'de, S: Scalar + Deserialize<'de>> Deserialize<'de> for Range<S> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let (start, end) = <(S, S)>::deserialize(deserializer)?;
            Self::new(start, end).map_err(D::Error::custom)
        }
    }

    impl<S: Scalar + Serialize> Serialize for Range<S> {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            (self.start(), self.end()).serialize(serializer)
        }
    }
}
