//! A shape with a surface.

use crate::scalar::Scalar;
use crate::shape::Shape;
use crate::vector::UnitVec3;

/// The normals at the corners of a triangle, in the order of the corners; shading interpolates between them.
pub type CornerNormals<S> = [UnitVec3<S>; 3];

/// One thing in a scene: a shape, and the indices of what goes with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object<S: Scalar> {
    /// What a ray meets.
    pub shape: Shape<S>,
    /// Index into the scene's materials.
    pub material: u32,
    /// For a triangle, the index into the scene's corner normals; `None` shades it flat.
    pub smooth: Option<u32>,
}

impl<S: Scalar> Object<S> {
    /// A shape with the material of this index.
    pub fn new(shape: impl Into<Shape<S>>, material: u32) -> Self {
        Self { shape: shape.into(), material, smooth: None }
    }

    /// The same triangle, shaded with the corner normals of this index.
    #[must_use]
    pub fn smooth(self, normals: u32) -> Self {
        Self { smooth: Some(normals), ..self }
    }
}
