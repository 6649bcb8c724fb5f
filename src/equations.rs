//! A primitive as a set of equations and inequalities, for the solver.

use crate::outline::{Extent, Outline};

/// The equations and inequalities of a primitive, in the numbers that it was built from.
#[derive(Clone, Copy, Debug)]
pub enum Equations<S> {
    /// All points within `radius` of the origin.
    Ball {
        /// The radius.
        radius: S,
    },
    /// All points within `radius` of the segment from the origin to `(0, height, 0)`.
    Capsule {
        /// The radius.
        radius: S,
        /// The length of the segment.
        height: S,
    },
    /// The inside of a cylinder about the y axis, or its side alone.
    Tube {
        /// The radius.
        radius: S,
        /// Its ends.
        extent: Extent<S>,
    },
    /// The inside of a cone about the y axis, or its side alone.
    Cone {
        /// The radius as a function of the height.
        outline: Outline<S>,
        /// Its ends.
        extent: Extent<S>,
    },
    /// The plane `y = 0`.
    Plane,
    /// The part of the plane `y = 0` within `radius` of the origin.
    Disc {
        /// The radius.
        radius: S,
    },
    /// All points whose coordinates are at most these in magnitude.
    Cuboid {
        /// The half extents.
        half: [S; 3],
    },
    /// The part of the plane `y = 0` with `x` and `z` at most these in magnitude.
    Rectangle {
        /// The half extents along x and z.
        half: [S; 2],
    },
    /// The triangle with these vertices.
    Triangle {
        /// The vertices.
        vertices: [[S; 3]; 3],
    },
}

/// Kinds of equations: a bit for each kind for which the solver has a separate function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EquationKinds(u16);

impl EquationKinds {
    /// None.
    pub(crate) const NONE: Self = Self(0);
    /// [`Equations::Ball`].
    pub(crate) const BALL: Self = Self(1);
    /// [`Equations::Capsule`].
    pub(crate) const CAPSULE: Self = Self(1 << 1);
    /// [`Equations::Tube`].
    pub(crate) const TUBE: Self = Self(1 << 2);
    /// [`Equations::Cone`].
    pub(crate) const CONE: Self = Self(1 << 3);
    /// [`Equations::Plane`].
    pub(crate) const PLANE: Self = Self(1 << 4);
    /// [`Equations::Disc`].
    pub(crate) const DISC: Self = Self(1 << 5);
    /// [`Equations::Triangle`].
    pub(crate) const TRIANGLE: Self = Self(1 << 6);
    /// [`Equations::Cuboid`].
    pub(crate) const CUBOID: Self = Self(1 << 7);
    /// [`Equations::Rectangle`].
    pub(crate) const RECTANGLE: Self = Self(1 << 8);

    /// Those of both sets.
    pub(crate) const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// True if any of `other` is in the set.
    #[inline(always)]
    pub(crate) const fn has(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }
}

impl<S> Equations<S> {
    /// True if they describe a solid, false for a surface without an inside.
    pub(crate) const fn is_solid(&self) -> bool {
        match self {
            Self::Ball { .. } | Self::Capsule { .. } | Self::Cuboid { .. } => true,
            Self::Tube { extent, .. } | Self::Cone { extent, .. } => !matches!(extent, Extent::Open(_)),
            Self::Plane | Self::Disc { .. } | Self::Rectangle { .. } | Self::Triangle { .. } => false,
        }
    }

    /// The kind of these.
    pub(crate) const fn kind(&self) -> EquationKinds {
        match self {
            Self::Ball { .. } => EquationKinds::BALL,
            Self::Capsule { .. } => EquationKinds::CAPSULE,
            Self::Tube { .. } => EquationKinds::TUBE,
            Self::Cone { .. } => EquationKinds::CONE,
            Self::Plane => EquationKinds::PLANE,
            Self::Disc { .. } => EquationKinds::DISC,
            Self::Cuboid { .. } => EquationKinds::CUBOID,
            Self::Rectangle { .. } => EquationKinds::RECTANGLE,
            Self::Triangle { .. } => EquationKinds::TRIANGLE,
        }
    }
}

/// The equations that a type may have. The solver tests this constant before the equations themselves, so that the
/// compiler removes the functions for all others.
pub trait Described {
    /// Their kinds.
    const EQUATIONS: EquationKinds;
}
