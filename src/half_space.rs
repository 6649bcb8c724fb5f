//! Half-spaces, and a box that some of them cut, in the numbers that they were built from.

use crate::part::Part;
use crate::scalar::Scalar;
use crate::vector::{UnitVec3, Vec3};

/// All points on the inner side of a plane, and the plane: `n . (x - p) <= 0` with a point `p` of it and its outward
/// normal `n`, of any length.
///
/// ```
/// use raylet::{HalfSpace, UnitVec3, Vec3};
/// let below = HalfSpace::new(Vec3::new(0.0_f32, 2.0, 0.0), Vec3::new(0.0, 3.0, 0.0))?;
/// assert_eq!(below.unit_normal(), UnitVec3::Y);
/// # Ok::<(), raylet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct HalfSpace<S> {
    /// A point of the plane.
    pub(crate) point: Vec3<S>,
    /// Its outward normal.
    pub(crate) normal: Vec3<S>,
}

impl<S: Scalar> HalfSpace<S> {
    /// A point of the plane.
    pub const fn point(&self) -> Vec3<S> {
        self.point
    }

    /// The outward normal as it is stored, of any length.
    pub const fn normal(&self) -> Vec3<S> {
        self.normal
    }

    /// The outward unit normal.
    pub fn unit_normal(&self) -> UnitVec3<S> {
        UnitVec3::new_or(self.normal, UnitVec3::Y)
    }

    #[inline(always)]
    fn scaled(self, e: i32) -> Self {
        if e == 0 { self } else { Self { point: self.point.to_array().map(|c| c.scaled(e)).into(), ..self } }
    }
}

/// What a box and some half-spaces have in common. It borrows the half-spaces, so that a shape, which may be any
/// primitive, does not become larger by sixteen of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutBox<S: 'static> {
    /// The lowest and the highest corner of the box.
    pub(crate) corners: [[S; 3]; 2],
    faces: &'static [HalfSpace<S>],
    /// The half-spaces are to be scaled by `2^exponent`; zero but of [`CutBox::scaled`].
    exponent: i32,
}

impl<S> CutBox<S> {
    /// The box between these corners, cut by these half-spaces.
    pub(crate) const fn new(corners: [[S; 3]; 2], faces: &'static [HalfSpace<S>]) -> Self {
        Self { corners, faces, exponent: 0 }
    }

    /// The half-spaces as they are stored.
    pub(crate) const fn stored(&self) -> &'static [HalfSpace<S>] {
        self.faces
    }
}

impl<S: Scalar> CutBox<S> {
    /// The same with all lengths multiplied by `2^e`.
    pub(crate) fn scaled(self, e: i32) -> Self {
        let corners = self.corners.map(|corner| corner.map(|c| c.scaled(e)));
        Self { corners, exponent: self.exponent + e, ..self }
    }

    /// The facets in order.
    #[inline]
    pub(crate) fn facets(self) -> impl Iterator<Item = (Part, HalfSpace<S>)> {
        Part::facets().zip(self.faces).map(move |(part, face)| (part, face.scaled(self.exponent)))
    }

    /// The half-space of a facet; `None` if there is no such facet.
    pub(crate) fn facet(self, part: Part) -> Option<HalfSpace<S>> {
        Some(self.faces.get(part.facet_number()?)?.scaled(self.exponent))
    }

    /// The corners of the box.
    #[inline]
    pub(crate) fn box_corners(self) -> impl Iterator<Item = [S; 3]> {
        let [[left, base, back], [right, top, front]] = self.corners;
        let columns = [[left, back], [left, front], [right, back], [right, front]];
        columns.into_iter().flat_map(move |[x, z]| [[x, base, z], [x, top, z]])
    }
}
