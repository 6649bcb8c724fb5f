//! One error for all constructors, so that `?` carries any of theirs.

use crate::effect::EffectError;
use crate::frame::FrameError;
use crate::hierarchy::HierarchyError;
use crate::hit::Undecided;
use crate::primitive::SizeError;
use crate::ray::RayError;
use crate::scalar::ValueError;
use crate::scene::nff::NffError;
use crate::scene::{CameraError, SceneError};
use crate::sensor::SensorError;
use crate::shape::combination::CombinationError;
use crate::shape::kinds::KindError;
use crate::solids::{CrossingsError, StartError};
use crate::thick::ThickError;
use core::convert::Infallible;
use core::fmt;

/// Defines the enum of all errors, and how each becomes one.
macro_rules! errors {
    ($($(#[$doc:meta])+ $Variant:ident($Error:ty),)+) => {
        /// Any error of the library: all other errors are converted to it by [`From`], and therefore by `?`. Its
        /// message is that of the original error.
        ///
        /// ```
        /// use raylet::{Capsule, Error, Frame, Ray, Shape, Vec3};
        /// fn rail(from: [f64; 3], to: [f64; 3], radius: f32) -> Result<Shape<f32>, Error> {
        ///     let (frame, height) = Frame::between(Vec3::from_f64(from)?, Vec3::from_f64(to)?)?;
        ///     Ok(Shape::new(Capsule::new(radius, height)?).placed(frame))
        /// }
        /// assert!(rail([0.0; 3], [0.0, 2.0, 0.0], 0.5).is_ok());
        /// assert_eq!(rail([0.0; 3], [0.0, 2.0, 0.0], -0.5).unwrap_err().to_string(), "the radius is negative");
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub enum Error {
            $($(#[$doc])+ $Variant($Error),)+
        }

        $(
            impl From<$Error> for Error {
                fn from(error: $Error) -> Self {
                    Self::$Variant(error)
                }
            }
        )+

        impl fmt::Display for Error {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self { $(Self::$Variant(error) => error.fmt(f),)+ }
            }
        }
    };
}

errors! {
    /// Of a number or a vector.
    Value(ValueError),
    /// Of a primitive.
    Size(SizeError),
    /// Of a ray or its range.
    Ray(RayError),
    /// Of a frame or an affine placement.
    Frame(FrameError),
    /// Of a shape of chosen kinds.
    Kind(KindError),
    /// Of a combination of solids.
    Combination(CombinationError),
    /// Of a camera.
    Camera(CameraError),
    /// Of a scene.
    Scene(SceneError),
    /// Of a hierarchy.
    Hierarchy(HierarchyError),
    /// Of a query by the first numbers of a tier alone.
    Undecided(Undecided),
    /// Of a range sensor.
    Sensor(SensorError),
    /// Of the crossings of many solids.
    Crossings(CrossingsError),
    /// Of a start among many solids.
    Start(StartError),
    /// Of a thick ray.
    Thick(ThickError),
    /// Of a scene file.
    Nff(NffError),
    /// Of a picture that lacks an effect.
    Effect(EffectError),
}

/// For `?` on results that cannot fail, such as drawing on most buffers.
impl From<Infallible> for Error {
    fn from(never: Infallible) -> Self {
        match never {}
    }
}

impl core::error::Error for Error {}
