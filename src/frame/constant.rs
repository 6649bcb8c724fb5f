//! Frames in constants.

use super::{Frame, FrameError};
use crate::scalar::Unit;
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

            /// [`Frame::from_quaternion`] in a constant, where there is no root: the length of the quaternion must be 1
            /// within 2^-20. The axes are within eight units in the last place of those of [`Frame::from_quaternion`].
            ///
            /// # Errors
            ///
            /// [`FrameError::Quaternion`] for another length; [`FrameError::Position`] as for [`Frame::at`].
            ///
            /// ```
            /// use raylet::{Frame, Vec3, constant};
            /// // Leaning by 60 degrees about the x axis: [sin 30, 0, 0, cos 30].
            /// static RAMP: Frame<f32> =
            ///     constant!(Frame::<f32>::const_from_quaternion(Vec3::ZERO, [0.5, 0.0, 0.0, 0.866_025_4]));
            /// assert!((RAMP.up().y() - 0.5).abs() < 1e-6 && RAMP.up().z() > 0.86);
            /// ```
            pub const fn const_from_quaternion(
                position: Vec3<$Number>,
                quaternion: [Unit<$Number>; 4],
            ) -> Result<Self, FrameError> {
                let Some([x, y, z]) = constant::$checks::axes_of(quaternion) else {
                    return Err(FrameError::Quaternion);
                };
                match constant::$checks::point(position) {
                    Some(fault) => Err(FrameError::Position(fault)),
                    None => Ok(Self {
                        position,
                        axes: [UnitVec3::rotated(x), UnitVec3::rotated(y), UnitVec3::rotated(z)],
                    }),
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
