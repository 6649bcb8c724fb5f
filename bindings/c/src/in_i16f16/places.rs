//! Written by `bindings/c/generate` from `src/in_f32/places.rs`.

use crate::ask;
use crate::make;
use crate::number::Number;
use crate::number::i16f16;
use crate::status::{code, raylet_status};
use crate::storage::{get, raylet_frame, raylet_shape, write};
use crate::value::raylet_vec3;
use core::mem::MaybeUninit;
use raylet::Frame;

/// Places a shape by a frame, instead of what placed it before.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_in_frame_i16f16(
    shape: Option<&mut raylet_shape<i16f16>>,
    frame: Option<&raylet_frame<i16f16>>,
) -> raylet_status {
    code(make::in_frame(shape, frame))
}

/// Places a shape by a frame, and stretches it along the axes of the frame by positive factors.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_stretched_i16f16(
    shape: Option<&mut raylet_shape<i16f16>>,
    frame: Option<&raylet_frame<i16f16>>,
    scale: raylet_vec3<i16f16>,
) -> raylet_status {
    code(make::stretched(shape, frame, scale))
}

/// Places a shape by a matrix: where its origin and its unit vectors along x, y and z go.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_in_matrix_i16f16(
    shape: Option<&mut raylet_shape<i16f16>>,
    position: raylet_vec3<i16f16>,
    x: raylet_vec3<i16f16>,
    y: raylet_vec3<i16f16>,
    z: raylet_vec3<i16f16>,
) -> raylet_status {
    code(make::in_matrix(shape, position, [x, y, z]))
}

/// Moves a shape, however it is placed.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_move_to_i16f16(
    shape: Option<&mut raylet_shape<i16f16>>,
    position: raylet_vec3<i16f16>,
) -> raylet_status {
    code(make::moved(shape, position))
}

/// Makes a shape seen from these sides only: a `raylet_visible`.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_seen_from_i16f16(
    shape: Option<&mut raylet_shape<i16f16>>,
    visible: u8,
) -> raylet_status {
    code(make::seen_from(shape, visible))
}

/// The box around a shape along the axes of the world; an infinite shape has the largest or infinite numbers.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_shape_bounds_i16f16(
    low: Option<&mut MaybeUninit<raylet_vec3<i16f16>>>,
    high: Option<&mut MaybeUninit<raylet_vec3<i16f16>>>,
    shape: Option<&raylet_shape<i16f16>>,
) -> raylet_status {
    code(ask::bounds(low, high, shape))
}

/// A frame along the axes of the world.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_at_i16f16(
    frame: Option<&mut MaybeUninit<raylet_frame<i16f16>>>,
    position: raylet_vec3<i16f16>,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::at(position.vector()))))
}

/// A frame with its y axis along a vector of any length, for a solid whose base is there.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_from_base_and_axis_i16f16(
    frame: Option<&mut MaybeUninit<raylet_frame<i16f16>>>,
    base: raylet_vec3<i16f16>,
    axis: raylet_vec3<i16f16>,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::from_base_and_axis(base.vector(), make::direction(axis)?))))
}

/// The same, for a solid of this height whose middle is there.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_from_centre_and_axis_i16f16(
    frame: Option<&mut MaybeUninit<raylet_frame<i16f16>>>,
    centre: raylet_vec3<i16f16>,
    axis: raylet_vec3<i16f16>,
    height: i16f16,
) -> raylet_status {
    code(make::frame(frame, || {
        Ok(Frame::from_centre_and_axis(centre.vector(), make::direction(axis)?, height.scalar()))
    }))
}

/// A frame turned about an axis of any length through its position, counter-clockwise as seen from the tip of the
/// axis.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_turned_about_i16f16(
    frame: Option<&mut MaybeUninit<raylet_frame<i16f16>>>,
    position: raylet_vec3<i16f16>,
    axis: raylet_vec3<i16f16>,
    degrees: i16f16,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::turned_about(position.vector(), make::direction(axis)?, degrees.scalar()))))
}

/// A frame turned by the quaternion (x, y, z, w), of any length near 1; its components are in the unit of directions.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_from_quaternion_i16f16(
    frame: Option<&mut MaybeUninit<raylet_frame<i16f16>>>,
    position: raylet_vec3<i16f16>,
    x: i16f16,
    y: i16f16,
    z: i16f16,
    w: i16f16,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::from_quaternion(position.vector(), [x, y, z, w].map(Number::unit)))))
}

/// A frame with its y axis from one point to another; the distance between them is the height of a solid that reaches
/// from one to the other.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_between_i16f16(
    frame: Option<&mut MaybeUninit<raylet_frame<i16f16>>>,
    height: Option<&mut MaybeUninit<i16f16>>,
    from: raylet_vec3<i16f16>,
    to: raylet_vec3<i16f16>,
) -> raylet_status {
    code(make::between(frame, from, to, height))
}

/// A frame with its z axis along `forward`, and `up` towards its y axis; both of any length.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_looking_i16f16(
    frame: Option<&mut MaybeUninit<raylet_frame<i16f16>>>,
    position: raylet_vec3<i16f16>,
    forward: raylet_vec3<i16f16>,
    up: raylet_vec3<i16f16>,
) -> raylet_status {
    code(make::frame(frame, || Ok(Frame::looking(position.vector(), make::direction(forward)?, make::direction(up)?))))
}

/// A frame with these axes, which are nearly at right angles and right-handed, of any length.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_from_axes_i16f16(
    frame: Option<&mut MaybeUninit<raylet_frame<i16f16>>>,
    position: raylet_vec3<i16f16>,
    x: raylet_vec3<i16f16>,
    y: raylet_vec3<i16f16>,
    z: raylet_vec3<i16f16>,
) -> raylet_status {
    code(make::frame(frame, || {
        let axes = [make::direction(x)?, make::direction(y)?, make::direction(z)?];
        Ok(Frame::from_axes(position.vector(), axes))
    }))
}

/// A frame that is given in another one, as a frame in the world.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_to_world_i16f16(
    frame: Option<&mut MaybeUninit<raylet_frame<i16f16>>>,
    outer: Option<&raylet_frame<i16f16>>,
    inner: Option<&raylet_frame<i16f16>>,
) -> raylet_status {
    code(make::frame(frame, || Ok(get(outer)?.frame_to_world(get(inner)?))))
}

/// A point of the world in the coordinates of a frame.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_point_to_local_i16f16(
    out: Option<&mut MaybeUninit<raylet_vec3<i16f16>>>,
    frame: Option<&raylet_frame<i16f16>>,
    point: raylet_vec3<i16f16>,
) -> raylet_status {
    code(write(out, || Ok(raylet_vec3::of(get(frame)?.point_to_local(point.vector())))))
}

/// A point in the coordinates of a frame in those of the world.
#[unsafe(no_mangle)]
pub extern "C" fn raylet_frame_point_to_world_i16f16(
    out: Option<&mut MaybeUninit<raylet_vec3<i16f16>>>,
    frame: Option<&raylet_frame<i16f16>>,
    point: raylet_vec3<i16f16>,
) -> raylet_status {
    code(write(out, || Ok(raylet_vec3::of(get(frame)?.point_to_world(point.vector())))))
}
