//! How a primitive is placed in the world.

use super::kind::Kind;
use crate::affine::Affine;
use crate::frame::{Frame, FrameError};
use crate::scalar::Scalar;
use crate::vector::{UnitVec3, Vec3};

/// How a primitive is placed in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
#[non_exhaustive]
pub enum Placement<S: Scalar> {
    /// In its canonical pose (see [`crate::primitive`]): the primitive's coordinates are world coordinates.
    World,
    /// Rotated and translated.
    Frame(Frame<S>),
    /// Transformed by any invertible affine map.
    Affine(Affine<S>),
}

impl<S: Scalar> Placement<S> {
    /// Which of the placements it is; `None` in the canonical pose.
    pub const fn kind(&self) -> Option<Kind> {
        match self {
            Self::World => None,
            Self::Frame(_) => Some(Kind::Frame),
            Self::Affine(_) => Some(Kind::Affine),
        }
    }

    /// Where the primitive's origin lies.
    pub fn position(&self) -> Vec3<S> {
        match self {
            Self::World => Vec3::ZERO,
            Self::Frame(frame) => frame.position(),
            Self::Affine(affine) => affine.position(),
        }
    }

    /// The same placement with the primitive's origin at another position: a [`Frame`] if there was none.
    ///
    /// # Errors
    ///
    /// [`FrameError::Position`] as for [`Frame::at`].
    ///
    /// ```
    /// # use raylet::{Cuboid, Frame, Shape, UnitVec3, Vec3};
    /// // A turned box is moved, and stays as it is turned.
    /// let turned = Frame::turned_about(Vec3::new(1.0_f32, 0.0, 0.0), UnitVec3::Y, 30.0)?;
    /// let mut cuboid = Shape::new(Cuboid::new(0.5, 1.0, 0.25)?).placed(turned);
    /// let by = Vec3::new(0.0, 0.0, -2.0);
    /// cuboid = cuboid.placed(cuboid.placement().moved_to(cuboid.placement().position() + by)?);
    /// assert_eq!(cuboid.frame(), Some(&Frame::turned_about(Vec3::new(1.0, 0.0, -2.0), UnitVec3::Y, 30.0)?));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn moved_to(self, position: Vec3<S>) -> Result<Self, FrameError> {
        match self {
            Self::World => Frame::at(position).map(Self::Frame),
            Self::Frame(frame) => frame.moved_to(position).map(Self::Frame),
            Self::Affine(affine) => affine.moved_to(position).map(Self::Affine),
        }
    }

    /// The images of the primitive's x, y and z axes, rounded to the number type; see [`Affine::axes`].
    ///
    /// ```
    /// # use raylet::{Frame, Placement, UnitVec3, Vec3};
    /// let lying = Placement::from(Frame::from_base_and_axis(Vec3::new(1.0_f32, 0.0, 0.0), UnitVec3::X)?);
    /// assert_eq!(lying.axes()[1], Vec3::new(1.0, 0.0, 0.0));
    /// let point = lying.point_to_world(Vec3::new(0.0, 3.0, 0.0));
    /// assert_eq!((point, lying.point_to_local(point)), (Vec3::new(4.0, 0.0, 0.0), Vec3::new(0.0, 3.0, 0.0)));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn axes(&self) -> [Vec3<S>; 3] {
        let in_coordinates = |axes: [UnitVec3<S>; 3]| axes.map(|axis| Vec3::round(axis.real()));
        match self {
            Self::World => in_coordinates([UnitVec3::X, UnitVec3::Y, UnitVec3::Z]),
            Self::Frame(frame) => in_coordinates(frame.axes()),
            Self::Affine(affine) => affine.axes(),
        }
    }

    /// A point of the primitive in the world, rounded to nearest.
    pub fn point_to_world(&self, point: Vec3<S>) -> Vec3<S> {
        match self {
            Self::World => point,
            Self::Frame(frame) => frame.point_to_world(point),
            Self::Affine(affine) => affine.point_to_world(point),
        }
    }

    /// A point of the world in the primitive's coordinates, rounded to nearest: the inverse of the placement.
    pub fn point_to_local(&self, point: Vec3<S>) -> Vec3<S> {
        match self {
            Self::World => point,
            Self::Frame(frame) => frame.point_to_local(point),
            Self::Affine(affine) => affine.point_to_local(point),
        }
    }
}

impl<S: Scalar> From<Frame<S>> for Placement<S> {
    fn from(frame: Frame<S>) -> Self {
        Self::Frame(frame)
    }
}

impl<S: Scalar> From<Affine<S>> for Placement<S> {
    fn from(affine: Affine<S>) -> Self {
        Self::Affine(affine)
    }
}
