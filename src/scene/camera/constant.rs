//! Cameras in constants.

use super::{Camera, CameraError};
use crate::frame::Frame;
use crate::scalar::constant::{self, each_number};

macro_rules! constants {
    ([$($generics:tt)*] $Number:ty, $checks:ident) => {
        impl<$($generics)*> Camera<$Number> {
            /// [`Camera::in_frame`] in a constant. (The other constructors compute axes and a tangent, for which they
            /// need a square root.)
            ///
            /// # Errors
            ///
            /// As [`Camera::in_frame`].
            pub const fn const_in_frame(frame: Frame<$Number>, tangent: $Number) -> Result<Self, CameraError> {
                match constant::$checks::slope(tangent) {
                    Some(_) => Err(CameraError::Angle),
                    None => Ok(Self {
                        position: frame.position(),
                        forward: frame.forward(),
                        right: frame.left().const_neg(),
                        up: frame.up(),
                        half_height: constant::$checks::real(tangent),
                        is_orthographic: false,
                    }),
                }
            }

            /// [`Camera::orthographic_in_frame`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Camera::orthographic_in_frame`].
            pub const fn const_orthographic_in_frame(
                frame: Frame<$Number>,
                height: $Number,
            ) -> Result<Self, CameraError> {
                if !constant::$checks::is_extent(height) {
                    return Err(CameraError::Height);
                }
                Ok(Self {
                    position: frame.position(),
                    forward: frame.forward(),
                    right: frame.left().const_neg(),
                    up: frame.up(),
                    half_height: constant::$checks::half(height),
                    is_orthographic: true,
                })
            }
        }
    };
}
each_number!(constants);
