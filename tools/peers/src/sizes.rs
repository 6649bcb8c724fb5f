//! The primitives that are compared, and their sizes: one set for all contestants.

use crate::number::Number;
use support::oracle::{ConeExtent, CylinderExtent, Dyadic, Solid};
use support::subject::Subject;

/// The primitives, by the names that `docs/accuracy.md` gives them.
pub const PRIMITIVES: [&str; 7] = ["sphere", "cylinder capped", "cone capped", "capsule", "plane", "disc", "triangle"];

/// What a library needs to build a primitive. Sizes are those of the subject, bit for bit.
#[derive(Clone, Copy, Debug)]
pub enum Sizes<S> {
    /// About the origin.
    Sphere { radius: S },
    /// About the y axis, from 0 to its height.
    Cylinder { radius: S, height: S },
    /// About the y axis, its apex in the origin, its cap at its height.
    Cone { slope: S, height: S },
    /// About the y axis, its hemispheres about the heights 0 and `height`.
    Capsule { radius: S, height: S },
    /// `y = 0`.
    Plane,
    /// In `y = 0`, about the origin.
    Disc { radius: S },
    /// Anywhere.
    Triangle { vertices: [[S; 3]; 3] },
}

impl<S: Number> Sizes<S> {
    /// The sizes of a subject.
    ///
    /// # Panics
    ///
    /// If the subject is none of [`PRIMITIVES`].
    pub fn of(subject: &Subject<S>) -> Self {
        // Every size came from a number of this type, so that it is one again.
        let size = |exact: &Dyadic| S::from_f64(exact.to_f64()).expect("a size of this number type");
        match &subject.solid {
            Solid::Sphere { radius } => Self::Sphere { radius: size(radius) },
            Solid::Cylinder { radius, extent: CylinderExtent::Capped(height) } => {
                Self::Cylinder { radius: size(radius), height: size(height) }
            }
            Solid::Cone { slope, extent: ConeExtent::Capped(height) } => {
                Self::Cone { slope: size(slope), height: size(height) }
            }
            Solid::Capsule { radius, height } => Self::Capsule { radius: size(radius), height: size(height) },
            Solid::Plane => Self::Plane,
            Solid::Disc { radius } => Self::Disc { radius: size(radius) },
            Solid::Triangle { vertices } => {
                Self::Triangle { vertices: std::array::from_fn(|i| std::array::from_fn(|j| size(&vertices[i][j]))) }
            }
            _ => panic!("{}: no contestant but raylet has such a primitive", subject.name),
        }
    }
}
