//! Frames in constants.

use super::{Frame, FrameError};
use crate::scalar::constant::{self, each_number};
use crate::vector::{UnitVec3, Vec3};

macro_rules! constants {
    ([$($generics:tt)*] $Number:ty, $checks:ident) => {
        impl<$($generics)*> Frame<$Number> {
            /// [`Frame::at`] in a constant.
            ///
            /// # Errors
            ///
            /// As [`Frame::at`].
            pub const fn const_at(position: Vec3<$Number>) -> Result<Self, FrameError> {
                match constant::$checks::point(position) {
                    Some(fault) => Err(FrameError::Position(fault)),
                    None => Ok(Self { position, axes: [UnitVec3::X, UnitVec3::Y, UnitVec3::Z] }),
                }
            }

            /// [`Frame::from_axes`] in a constant. (The other constructors compute axes, for which they need a square
            /// root.)
            ///
            /// # Errors
            ///
            /// As [`Frame::from_axes`].
            pub const fn const_from_axes(
                position: Vec3<$Number>,
                axes: [UnitVec3<$Number>; 3],
            ) -> Result<Self, FrameError> {
                if !constant::$checks::are_axes([axes[0].to_array(), axes[1].to_array(), axes[2].to_array()]) {
                    return Err(FrameError::Axes);
                }
                match constant::$checks::point(position) {
                    Some(fault) => Err(FrameError::Position(fault)),
                    None => Ok(Self { position, axes }),
                }
            }
        }
    };
}
each_number!(constants);
