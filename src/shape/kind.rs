//! The primitives and placements by name, and sets of them.

use core::fmt;

/// A primitive, or a placement other than [`Placement::World`](super::Placement::World). The order is that in which
/// sets list them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Kind {
    /// A [`Sphere`](crate::Sphere).
    Sphere,
    /// A [`Cylinder`](crate::Cylinder).
    Cylinder,
    /// A [`Cone`](crate::Cone).
    Cone,
    /// A [`Capsule`](crate::Capsule).
    Capsule,
    /// A [`Plane`](crate::Plane).
    Plane,
    /// A [`Disc`](crate::Disc).
    Disc,
    /// A [`Triangle`](crate::Triangle).
    Triangle,
    /// A [`Cuboid`](crate::Cuboid).
    Cuboid,
    /// A [`Rectangle`](crate::Rectangle).
    Rectangle,
    /// A [`Revolved`](crate::Revolved).
    Revolved,
    /// A [`Tube`](crate::Tube).
    Tube,
    /// An [`Annulus`](crate::Annulus).
    Annulus,
    /// A [`RoundCone`](crate::RoundCone).
    RoundCone,
    /// A [`RoundedCuboid`](crate::RoundedCuboid).
    RoundedCuboid,
    /// A [`Prism`](crate::Prism).
    Prism,
    /// A [`Polyhedron`](crate::Polyhedron).
    Polyhedron,
    /// A [`Torus`](crate::Torus).
    Torus,
    /// A [`Frame`](crate::Frame).
    Frame,
    /// An [`Affine`](crate::Affine).
    Affine,
}

impl Kind {
    /// Every kind, in order.
    pub const EVERY: [Self; 19] = [
        Self::Sphere,
        Self::Cylinder,
        Self::Cone,
        Self::Capsule,
        Self::Plane,
        Self::Disc,
        Self::Triangle,
        Self::Cuboid,
        Self::Rectangle,
        Self::Revolved,
        Self::Tube,
        Self::Annulus,
        Self::RoundCone,
        Self::RoundedCuboid,
        Self::Prism,
        Self::Polyhedron,
        Self::Torus,
        Self::Frame,
        Self::Affine,
    ];

    /// The name of its type.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sphere => "Sphere",
            Self::Cylinder => "Cylinder",
            Self::Cone => "Cone",
            Self::Capsule => "Capsule",
            Self::Plane => "Plane",
            Self::Disc => "Disc",
            Self::Triangle => "Triangle",
            Self::Cuboid => "Cuboid",
            Self::Rectangle => "Rectangle",
            Self::Revolved => "Revolved",
            Self::Tube => "Tube",
            Self::Annulus => "Annulus",
            Self::RoundCone => "RoundCone",
            Self::RoundedCuboid => "RoundedCuboid",
            Self::Prism => "Prism",
            Self::Polyhedron => "Polyhedron",
            Self::Torus => "Torus",
            Self::Frame => "Frame",
            Self::Affine => "Affine",
        }
    }

    const fn bit(self) -> u32 {
        1 << self as u32
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A set of kinds: a bit for each.
///
/// ```
/// use raylet::shape::kinds::{Kind, KindSet};
/// const ROUND: KindSet = KindSet::of(Kind::Sphere).with(Kind::Capsule);
/// assert!(ROUND.contains(Kind::Sphere) && !ROUND.contains(Kind::Plane));
/// assert_eq!(ROUND.to_string(), "Sphere, Capsule");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct KindSet(u32);

impl KindSet {
    /// Every kind.
    pub const ALL: Self = Self((1 << Kind::EVERY.len()) - 1);

    /// One kind.
    pub const fn of(kind: Kind) -> Self {
        Self(kind.bit())
    }

    /// True if the kind is in the set.
    #[inline(always)]
    pub const fn contains(self, kind: Kind) -> bool {
        self.0 & kind.bit() != 0
    }

    /// True if every kind of the other set is in this one.
    #[inline(always)]
    pub const fn contains_all(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// The set with this kind added.
    #[must_use]
    pub const fn with(self, kind: Kind) -> Self {
        Self(self.0 | kind.bit())
    }

    /// How many kinds are in the set, 0 to 19.
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// True if no kind is in the set.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }
}

/// Names, with commas between them.
impl fmt::Display for KindSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut separator = "";
        for kind in Kind::EVERY.into_iter().filter(|kind| self.contains(*kind)) {
            write!(f, "{separator}{kind}")?;
            separator = ", ";
        }
        Ok(())
    }
}

/// A primitive or placement that is not among the kinds of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct KindError {
    /// Its kind.
    pub kind: Kind,
    /// The kinds of the shape.
    pub among: KindSet,
}

impl fmt::Display for KindError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, among } = self;
        write!(f, "a shape of the kinds {among} cannot have the kind {kind}: name it among the kinds")
    }
}

impl core::error::Error for KindError {}
