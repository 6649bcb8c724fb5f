//! A primitive as a set of equations and inequalities, for the solver.

use crate::half_space::CutBox;
use crate::outline::{Extent, Meridian, Outline};
use crate::polygon::Polygon;
use core::cmp::Ordering;

/// The equations and inequalities of a primitive, in the numbers that it was built from.
#[derive(Clone, Copy, Debug)]
pub enum Equations<S: 'static> {
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
    /// The convex hull of two balls, about the origin and about `(0, height, 0)`.
    RoundCone {
        /// The radii of the lower and of the upper ball.
        radii: [S; 2],
        /// The height of the upper ball's centre.
        height: S,
    },
    /// The inside of a cylinder about the y axis, or its side alone.
    Cylinder {
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
    /// The inside of a quadric of revolution about the y axis between two planes, or its side alone.
    Revolved {
        /// Its equation and its ends.
        meridian: Meridian<S>,
    },
    /// What lies between two cylinders about the y axis, and between the planes `y = 0` and `y = height`.
    Tube {
        /// The inner and the outer radius.
        radii: [S; 2],
        /// The height.
        height: S,
    },
    /// All points within the minor radius of a circle about the y axis in the plane `y = 0`.
    Torus {
        /// The major and the minor radius.
        radii: [S; 2],
    },
    /// The plane `y = 0`.
    Plane,
    /// The part of the plane `y = 0` within `radius` of the origin.
    Disc {
        /// The radius.
        radius: S,
    },
    /// The part of the plane `y = 0` between two circles about the origin.
    Annulus {
        /// The inner and the outer radius.
        radii: [S; 2],
    },
    /// All points whose coordinates are at most these in magnitude.
    Cuboid {
        /// The half extents.
        half: [S; 3],
    },
    /// All points within `radius` of a cuboid about the origin.
    RoundedCuboid {
        /// The half extents of that cuboid.
        half: [S; 3],
        /// The radius.
        radius: S,
        /// The region of the point whose surface is asked for; of no interest to a query.
        region: Region,
    },
    /// The part of an infinite prism over a polygon between the planes `y = 0` and `y = height`.
    Prism {
        /// The polygon.
        polygon: Polygon<S>,
        /// The height.
        height: S,
    },
    /// A box that half-spaces cut.
    Polyhedron {
        /// The box and the half-spaces.
        solid: CutBox<S>,
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

/// Along each axis, whether a point is below a cuboid about the origin, between its planes, or above it.
pub type Region = [Ordering; 3];

/// The only axis along which a region is beyond the cuboid, if it is that of a face.
#[inline(always)]
pub(crate) fn axis_of_face(region: Region) -> Option<usize> {
    match region.map(|side| side != Ordering::Equal) {
        [true, false, false] => Some(0),
        [false, true, false] => Some(1),
        [false, false, true] => Some(2),
        _ => None,
    }
}

/// Kinds of equations: a bit for each kind for which the solver has a separate function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EquationKinds(u32);

impl EquationKinds {
    /// None.
    pub(crate) const NONE: Self = Self(0);
    /// [`Equations::Ball`].
    pub(crate) const BALL: Self = Self(1);
    /// [`Equations::Capsule`].
    pub(crate) const CAPSULE: Self = Self(1 << 1);
    /// [`Equations::Cylinder`].
    pub(crate) const CYLINDER: Self = Self(1 << 2);
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
    /// [`Equations::Revolved`].
    pub(crate) const REVOLVED: Self = Self(1 << 9);
    /// [`Equations::Tube`].
    pub(crate) const TUBE: Self = Self(1 << 10);
    /// [`Equations::Annulus`].
    pub(crate) const ANNULUS: Self = Self(1 << 11);
    /// [`Equations::RoundCone`].
    pub(crate) const ROUND_CONE: Self = Self(1 << 12);
    /// [`Equations::RoundedCuboid`].
    pub(crate) const ROUNDED_CUBOID: Self = Self(1 << 13);
    /// [`Equations::Prism`].
    pub(crate) const PRISM: Self = Self(1 << 14);
    /// [`Equations::Polyhedron`].
    pub(crate) const POLYHEDRON: Self = Self(1 << 15);
    /// [`Equations::Torus`].
    pub(crate) const TORUS: Self = Self(1 << 16);

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
            Self::Cylinder { extent, .. } | Self::Cone { extent, .. } => !matches!(extent, Extent::Open(_)),
            Self::Revolved { meridian } => !meridian.is_open,
            _ => !self.is_flat(),
        }
    }

    /// True if they describe a part of a plane.
    pub(crate) const fn is_flat(&self) -> bool {
        matches!(
            self,
            Self::Plane | Self::Disc { .. } | Self::Annulus { .. } | Self::Rectangle { .. } | Self::Triangle { .. }
        )
    }

    /// The kind of these.
    pub(crate) const fn kind(&self) -> EquationKinds {
        match self {
            Self::Ball { .. } => EquationKinds::BALL,
            Self::Capsule { .. } => EquationKinds::CAPSULE,
            Self::RoundCone { .. } => EquationKinds::ROUND_CONE,
            Self::Cylinder { .. } => EquationKinds::CYLINDER,
            Self::Cone { .. } => EquationKinds::CONE,
            Self::Revolved { .. } => EquationKinds::REVOLVED,
            Self::Tube { .. } => EquationKinds::TUBE,
            Self::Torus { .. } => EquationKinds::TORUS,
            Self::Plane => EquationKinds::PLANE,
            Self::Disc { .. } => EquationKinds::DISC,
            Self::Annulus { .. } => EquationKinds::ANNULUS,
            Self::Cuboid { .. } => EquationKinds::CUBOID,
            Self::RoundedCuboid { .. } => EquationKinds::ROUNDED_CUBOID,
            Self::Prism { .. } => EquationKinds::PRISM,
            Self::Polyhedron { .. } => EquationKinds::POLYHEDRON,
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
