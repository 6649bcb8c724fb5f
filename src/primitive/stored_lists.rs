//! The lists that a prism and a polyhedron borrow as they are stored.

use super::HalfSpace;
use super::polyhedron::MOST_FACES;
use super::prism::MOST_CORNERS;
use crate::scalar::Scalar;
use crate::scalar::written;
use crate::vector::Vec3;
use core::fmt;
use core::marker::PhantomData;
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
pub(super) struct Corner<S>(#[serde(with = "written")] S, #[serde(with = "written")] S);

impl<S: Copy> From<[S; 2]> for Corner<S> {
    fn from([x, z]: [S; 2]) -> Self {
        Self(x, z)
    }
}

impl<S> From<Corner<S>> for [S; 2] {
    fn from(Corner(x, z): Corner<S>) -> Self {
        [x, z]
    }
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "S: Scalar")]
pub(super) struct Face<S> {
    point: Vec3<S>,
    normal: Vec3<S>,
}

impl<S> From<HalfSpace<S>> for Face<S> {
    fn from(HalfSpace { point, normal }: HalfSpace<S>) -> Self {
        Self { point, normal }
    }
}

impl<S> From<Face<S>> for HalfSpace<S> {
    fn from(Face { point, normal }: Face<S>) -> Self {
        Self { point, normal }
    }
}

/// What a prism or a polyhedron borrows, with the form in which each is stored.
pub(super) trait Listed: Copy + 'static {
    type Stored: Serialize + for<'de> Deserialize<'de> + From<Self> + Into<Self>;
    const MOST: usize;
}

impl<S: Scalar> Listed for [S; 2] {
    type Stored = Corner<S>;
    const MOST: usize = MOST_CORNERS;
}

impl<S: Scalar> Listed for HalfSpace<S> {
    type Stored = Face<S>;
    const MOST: usize = MOST_FACES;
}

/// A list that lives as long as the program.
pub(super) struct Kept<L: 'static>(pub(super) &'static [L]);

impl<L: Listed> Serialize for Kept<L> {
    fn serialize<T: Serializer>(&self, serializer: T) -> Result<T::Ok, T::Error> {
        serializer.collect_seq(self.0.iter().map(|item| L::Stored::from(*item)))
    }
}

impl<'de, L: Listed> Deserialize<'de> for Kept<L> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct List<L>(PhantomData<L>);
        impl<'de, L: Listed> Visitor<'de> for List<L> {
            type Value = heapless::Vec<L, 16>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a list of at most {}", L::MOST)
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
                let mut all = heapless::Vec::new();
                while let Some(item) = list.next_element::<L::Stored>()? {
                    all.push(item.into()).map_err(|_| A::Error::invalid_length(L::MOST + 1, &self))?;
                }
                Ok(all)
            }
        }
        kept(&deserializer.deserialize_seq(List(PhantomData))?).map(Self)
    }
}

/// The list, kept for the rest of the program, since a primitive borrows it.
#[cfg(feature = "std")]
#[expect(clippy::unnecessary_wraps, reason = "without `std` it is an error")]
fn kept<L: Copy, E: Error>(list: &[L]) -> Result<&'static [L], E> {
    Ok(list.to_vec().leak())
}

/// Without a heap there is no place where it could be kept.
#[cfg(not(feature = "std"))]
fn kept<L: Copy, E: Error>(_: &[L]) -> Result<&'static [L], E> {
    Err(E::custom("a Prism or a Polyhedron borrows its list, and without the feature `std` there is no heap for it"))
}
