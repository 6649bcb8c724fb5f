//! Conversions to and from other crates' types: `mint` vectors and points, `serde`, `defmt`.

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
    use crate::affine::Affine;
    use crate::effect::{Effect, EffectSet};
    use crate::frame::Frame;
    use crate::part::Part;
    use crate::ray::{Along, Departure, Leaving, Range, Ray};
    use crate::scalar::Scalar;
    use crate::scalar::written::Plain;
    use crate::scene::nff::Scale;
    use crate::shape::kinds::{Kind, KindSet};
    use crate::vector::{UnitVec3, Vec3};
    use core::fmt;
    use serde::de::{Error, SeqAccess, Visitor};
    use serde::ser::SerializeSeq;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    /// Implements both traits by the form in which a value is stored; a constructor checks a value that is read.
    macro_rules! stored {
        ($Type:ident, $Stored:ty, |$value:ident| $to:expr, |$stored:pat_param| $from:expr) => {
            impl<S: Scalar> Serialize for $Type<S> {
                fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
                    let $value = self;
                    let stored: $Stored = $to;
                    stored.serialize(serializer)
                }
            }

            impl<'de, S: Scalar> Deserialize<'de> for $Type<S> {
                fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                    let $stored = <$Stored>::deserialize(deserializer)?;
                    $from.map_err(D::Error::custom)
                }
            }
        };
    }

    impl<S: Scalar> Serialize for UnitVec3<S> {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            self.to_array().map(Plain).serialize(serializer)
        }
    }

    /// Only a vector of length 1 becomes a [`UnitVec3`].
    impl<'de, S: Scalar> Deserialize<'de> for UnitVec3<S> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let components = <[Plain<S::Unit>; 3]>::deserialize(deserializer)?.map(|Plain(component)| component);
            Self::from_components(components).map_err(|error| {
                D::Error::custom(format_args!("the direction {}: normalise it before it is stored", error.predicate()))
            })
        }
    }

    stored!(Range, (Plain<S>, Plain<S>), |range| (Plain(range.start()), Plain(range.end())), |(
        Plain(start),
        Plain(end),
    )| Range::new(
        start, end
    ));

    #[derive(Serialize, Deserialize)]
    #[serde(bound = "")]
    struct StoredRay<S: Scalar> {
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        range: Range<S>,
        departure: Option<(u32, Part, Leaving)>,
    }
    stored!(
        Ray,
        StoredRay<S>,
        |ray| StoredRay {
            origin: ray.origin(),
            direction: ray.direction(),
            range: ray.range(),
            departure: ray.departure().map(|d| (d.object, d.part, d.leaving)),
        },
        |stored| Ray::new(stored.origin, stored.direction).map(|ray| {
            let ray = ray.with_range(stored.range);
            match stored.departure {
                Some((object, part, leaving)) => ray.departing(Departure { object, part, leaving }),
                None => ray,
            }
        })
    );

    stored!(Along, (Ray<S>, Plain<S>), |along| (along.ray(), Plain(along.length())), |(ray, Plain(length))| {
        Along::from_stored(ray, length)
    });

    /// Implements both traits of a set, as a list of the names of its elements.
    macro_rules! set {
        ($Set:ident, $Member:ident, $expecting:literal) => {
            impl Serialize for $Set {
                fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
                    let mut list = serializer.serialize_seq(Some(self.len()))?;
                    for member in $Member::EVERY.into_iter().filter(|member| self.contains(*member)) {
                        list.serialize_element(&member)?;
                    }
                    list.end()
                }
            }

            impl<'de> Deserialize<'de> for $Set {
                fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                    struct List;
                    impl<'de> Visitor<'de> for List {
                        type Value = $Set;
                        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                            f.write_str($expecting)
                        }
                        fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<$Set, A::Error> {
                            let mut set = $Set::default();
                            while let Some(member) = list.next_element::<$Member>()? {
                                set = set.with(member);
                            }
                            Ok(set)
                        }
                    }
                    deserializer.deserialize_seq(List)
                }
            }
        };
    }
    set!(EffectSet, Effect, "a list of effects");
    set!(KindSet, Kind, "a list of primitives and placements");

    impl Serialize for Scale {
        fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
            self.power().serialize(serializer)
        }
    }

    /// A power outside of [`Scale::LEAST`] and [`Scale::LARGEST`] is clamped, as by [`Scale::power_of_two`].
    impl<'de> Deserialize<'de> for Scale {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            i8::deserialize(deserializer).map(Self::power_of_two)
        }
    }

    #[derive(Serialize, Deserialize)]
    #[serde(bound = "")]
    struct StoredFrame<S: Scalar> {
        position: Vec3<S>,
        axes: [UnitVec3<S>; 3],
    }
    stored!(Frame, StoredFrame<S>, |frame| StoredFrame { position: frame.position(), axes: frame.axes() }, |stored| {
        Frame::from_axes(stored.position, stored.axes)
    });

    /// The rows of the inverse, each with its power of two: all that an affine placement holds.
    #[derive(Serialize, Deserialize)]
    #[serde(bound = "")]
    struct StoredAffine<S: Scalar> {
        position: Vec3<S>,
        inverse: [([Plain<S::Unit>; 3], i32); 3],
    }
    stored!(
        Affine,
        StoredAffine<S>,
        |affine| StoredAffine {
            position: affine.position(),
            inverse: affine.inverse().map(|(row, exponent)| (row.map(Plain), exponent)),
        },
        |stored| {
            let inverse = stored.inverse.map(|(row, exponent)| (row.map(|Plain(component)| component), exponent));
            Affine::from_stored(stored.position, inverse)
        }
    );
}

/// Types with numbers of foreign types. Types that consist of these derive their format.
#[cfg(feature = "defmt")]
mod with_defmt {
    use crate::affine::Affine;
    use crate::effect::Sample;
    use crate::hit::Hit;
    use crate::ray::{Along, Range};
    use crate::render::Pixel;
    use crate::scalar::Scalar;
    use crate::scalar::written::Plain;
    use crate::shape::Ellipsoid;
    use crate::shape::Placement;
    use crate::solids::SolidCrossing;
    use crate::thick::{Contact, ThickRay};
    use crate::vector::{UnitVec3, Vec3};
    use defmt::{Format, Formatter, write};

    impl<S: Scalar> Format for Vec3<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "Vec3 {{ x: {}, y: {}, z: {} }}", Plain(self.x), Plain(self.y), Plain(self.z));
        }
    }

    impl<S: Scalar> Format for UnitVec3<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "[{}, {}, {}]", Plain(self.x()), Plain(self.y()), Plain(self.z()));
        }
    }

    impl<S: Scalar> Format for Range<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "Range {{ start: {}, end: {} }}", Plain(self.start()), Plain(self.end()));
        }
    }

    impl<S: Scalar> Format for Along<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "Along {{ ray: {}, length: {} }}", self.ray(), Plain(self.length()));
        }
    }

    impl<S: Scalar> Format for Affine<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "Affine {{ position: {}, inverse: [", self.position());
            for ([x, y, z], exponent) in self.inverse() {
                write!(f, "([{}, {}, {}], {}), ", Plain(x), Plain(y), Plain(z), exponent);
            }
            write!(f, "] }}");
        }
    }

    impl<S: Scalar> Format for Placement<S> {
        fn format(&self, f: Formatter<'_>) {
            match self {
                Self::World => write!(f, "World"),
                Self::Frame(frame) => frame.format(f),
                Self::Affine(affine) => affine.format(f),
            }
        }
    }

    impl<S: Scalar> Format for Sample<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "Sample {{ color: {}, seen: {}, lit_by: {} }}", self.color, self.seen, self.lit_by);
        }
    }

    impl<S: Scalar> Format for Pixel<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "Pixel {{ color: {}, seen: {}, lit_by: {} }}", self.color, self.seen, self.lit_by);
        }
    }

    impl<S: Scalar> Format for Hit<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "Hit {{ t: {}, part: {}, crossing: {} }}", Plain(self.t), self.part, self.crossing);
        }
    }

    impl<S: Scalar> Format for ThickRay<S> {
        fn format(&self, f: Formatter<'_>) {
            write!(f, "ThickRay {{ ray: {}, radius: {} }}", self.ray(), Plain(self.radius()));
        }
    }

    impl<S: Scalar> Format for Contact<S> {
        fn format(&self, f: Formatter<'_>) {
            let Self { t, point, normal, overlaps } = self;
            write!(f, "Contact {{ t: {}, point: {}, normal: {}, overlaps: {} }}", Plain(*t), point, normal, overlaps);
        }
    }

    impl<S: Scalar> Format for Ellipsoid<S> {
        fn format(&self, f: Formatter<'_>) {
            let [x, y, z] = self.radii().map(Plain);
            write!(f, "Ellipsoid {{ radii: [{}, {}, {}] }}", x, y, z);
        }
    }

    impl<S: Scalar, const W: usize> Format for SolidCrossing<S, W> {
        fn format(&self, f: Formatter<'_>) {
            let Self { solid, hit, before, after } = self;
            write!(f, "SolidCrossing {{ solid: {}, hit: {}, before: {}, after: {} }}", solid, hit, before, after);
        }
    }
}
