//! Objects: shapes with materials.

use crate::part::Part;
use crate::scalar::Scalar;
use crate::shape::kinds::{All, Kinds};
use crate::shape::{Shape, Shaped};
use crate::vector::UnitVec3;

/// The normals at the corners of a triangle, in the order of the corners; shading interpolates between them.
pub type CornerNormals<S> = [UnitVec3<S>; 3];

/// An object of a scene: a shape of the kinds `K`, and the indices of its materials and corner normals.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "", deserialize = "Shape<S, K>: serde::Deserialize<'de>")))]
pub struct Object<S: Scalar, K: Kinds = All> {
    /// The shape.
    pub shape: Shape<S, K>,
    /// Index into the scene's materials: the material of the side.
    pub material: u32,
    /// The material of the base: of the lower cap or hemisphere or the lowest face, for a shape that has one.
    pub base: u32,
    /// The material of the top: of the upper cap or hemisphere or the highest face, for a shape that has one.
    pub top: u32,
    /// For a triangle, the index into the scene's corner normals; `None` for flat shading.
    pub smooth: Option<u32>,
}

impl<S: Scalar, K: Kinds> Object<S, K> {
    /// A shape with the material of this index on all parts.
    pub fn new(shape: impl Into<Shape<S, K>>, material: u32) -> Self {
        Self { shape: shape.into(), material, base: material, top: material, smooth: None }
    }

    /// [`Object::new`] in a constant.
    pub const fn const_new(shape: Shape<S, K>, material: u32) -> Self {
        Self { shape, material, base: material, top: material, smooth: None }
    }

    /// The same shape with another material on its base.
    ///
    /// ```
    /// use raylet::{Cylinder, Object, Part, Shape};
    /// let can = Object::new(Shape::new(Cylinder::capped(1.0_f32, 2.0)?), 0).with_base(1).with_top(2);
    /// assert_eq!([Part::Side, Part::Base, Part::Top].map(|part| can.material_of(part)), [0, 1, 2]);
    /// # Ok::<(), raylet::SizeError>(())
    /// ```
    #[must_use]
    pub const fn with_base(self, material: u32) -> Self {
        Self { base: material, ..self }
    }

    /// The same shape with another material on its top.
    #[must_use]
    pub const fn with_top(self, material: u32) -> Self {
        Self { top: material, ..self }
    }

    /// The index of the material of a part. The four faces at the sides of a cuboid, and the inner side of a tube,
    /// have that of the side.
    pub const fn material_of(&self, part: Part) -> u32 {
        match part {
            Part::Base => self.base,
            Part::Top => self.top,
            _ => self.material,
        }
    }

    /// The same triangle, shaded with the corner normals of this index.
    #[must_use]
    pub const fn smooth(self, normals: u32) -> Self {
        Self { smooth: Some(normals), ..self }
    }
}

impl<S: Scalar, K: Kinds> Shaped<S> for Object<S, K> {
    type Kinds = K;

    #[inline(always)]
    fn shape(&self) -> &Shape<S, K> {
        &self.shape
    }
}
