//! Errors as codes, and their texts.

use core::ffi::{CStr, c_char};
use raylet::hierarchy::HierarchyError;
use raylet::hit::Undecided;
use raylet::solids::CrossingsError;
use raylet::{Error, FrameError, RayError, SizeError, ValueError};

/// What a function returns: zero or more as its comment says, or a negative error code,
/// `-(16 * raylet_error + raylet_fault)`. `raylet_status_text` says it in words.
pub type raylet_status = i32;

/// Done.
pub const RAYLET_OK: raylet_status = 0;

/// What is wrong with a value: the second part of an error code.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum raylet_fault {
    /// The error itself says it.
    RAYLET_FAULT_NONE = 0,
    /// It is infinite or NaN.
    RAYLET_FAULT_NOT_FINITE = 1,
    /// It is negative.
    RAYLET_FAULT_NEGATIVE = 2,
    /// It is zero.
    RAYLET_FAULT_ZERO = 3,
    /// It is below the least that the number type's budget allows.
    RAYLET_FAULT_BELOW_BUDGET = 4,
    /// It is beyond the number type's budget.
    RAYLET_FAULT_BEYOND_BUDGET = 5,
    /// It is beyond what the number type can hold.
    RAYLET_FAULT_BEYOND_TYPE = 6,
    /// Its length is not 1.
    RAYLET_FAULT_NOT_UNIT = 7,
    /// It has no direction.
    RAYLET_FAULT_NO_DIRECTION = 8,
}

const fn fault(error: ValueError) -> raylet_fault {
    match error {
        ValueError::NotFinite => raylet_fault::RAYLET_FAULT_NOT_FINITE,
        ValueError::Negative => raylet_fault::RAYLET_FAULT_NEGATIVE,
        ValueError::Zero => raylet_fault::RAYLET_FAULT_ZERO,
        ValueError::BelowBudget => raylet_fault::RAYLET_FAULT_BELOW_BUDGET,
        ValueError::BeyondBudget => raylet_fault::RAYLET_FAULT_BEYOND_BUDGET,
        ValueError::BeyondType => raylet_fault::RAYLET_FAULT_BEYOND_TYPE,
        ValueError::NotUnit => raylet_fault::RAYLET_FAULT_NOT_UNIT,
        ValueError::NoDirection => raylet_fault::RAYLET_FAULT_NO_DIRECTION,
        _ => raylet_fault::RAYLET_FAULT_NONE,
    }
}

/// A failure, as its code.
#[derive(Clone, Copy, Debug)]
pub struct Failed(raylet_status);

/// What a function returns, before an error becomes a code.
pub type Outcome = Result<raylet_status, Failed>;

impl Failed {
    /// An error that says all.
    pub const fn of(error: raylet_error) -> Self {
        Self::with(error, raylet_fault::RAYLET_FAULT_NONE)
    }
    const fn with(error: raylet_error, fault: raylet_fault) -> Self {
        Self(-(16 * error as i32 + fault as i32))
    }
}

/// The code.
pub fn code(outcome: Outcome) -> raylet_status {
    outcome.unwrap_or_else(|Failed(code)| code)
}

/// A text with the zero at its end that C expects.
const fn terminated<const N: usize>(text: &str) -> [u8; N] {
    let (mut all, mut i) = ([0; N], 0);
    while i < text.len() {
        all[i] = text.as_bytes()[i];
        i += 1;
    }
    all
}

macro_rules! text {
    ($message:expr) => {{
        const MESSAGE: &str = $message;
        const TEXT: [u8; MESSAGE.len() + 1] = terminated(MESSAGE);
        // An error has no text without its end.
        if let Ok(text) = CStr::from_bytes_with_nul(&TEXT) { text } else { c"" }
    }};
}

/// What is wrong: the first part of an error code.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum raylet_error {
    /// A radius.
    RAYLET_ERROR_RADIUS = 1,
    /// A height.
    RAYLET_ERROR_HEIGHT = 2,
    /// A slope.
    RAYLET_ERROR_SLOPE = 3,
    /// A half extent.
    RAYLET_ERROR_HALF_EXTENT = 4,
    /// A coordinate of a vertex.
    RAYLET_ERROR_VERTEX = 5,
    /// A coordinate of a corner.
    RAYLET_ERROR_CORNER = 6,
    /// A coefficient of a quadric of revolution.
    RAYLET_ERROR_COEFFICIENT = 7,
    /// The normal of a half-space.
    RAYLET_ERROR_HALF_SPACE = 8,
    /// A coordinate of the position of a frame.
    RAYLET_ERROR_POSITION = 9,
    /// The normal of a plane.
    RAYLET_ERROR_NORMAL = 10,
    /// A component of an axis of a matrix.
    RAYLET_ERROR_AXIS = 11,
    /// A factor of a scale.
    RAYLET_ERROR_SCALE = 12,
    /// A coordinate of a ray's origin.
    RAYLET_ERROR_ORIGIN = 13,
    /// A coordinate of a ray's target.
    RAYLET_ERROR_TARGET = 14,
    /// The vector of a ray's direction.
    RAYLET_ERROR_DIRECTION = 15,
    /// An end of a ray's range.
    RAYLET_ERROR_RANGE_END = 16,
    /// The lower height is not below the upper one.
    RAYLET_ERROR_HEIGHTS = 32,
    /// The inner radius is not below the outer one.
    RAYLET_ERROR_RADII = 33,
    /// The minor radius of a torus is not below the major one.
    RAYLET_ERROR_RING = 34,
    /// A quadric of revolution has no radius somewhere.
    RAYLET_ERROR_OUTLINE = 35,
    /// The vertices lie on a line.
    RAYLET_ERROR_VERTICES = 36,
    /// A polyhedron has no half-space, or more than 16.
    RAYLET_ERROR_FACE_COUNT = 37,
    /// Half-spaces bound no solid.
    RAYLET_ERROR_UNBOUNDED = 38,
    /// A prism has fewer than 3 corners, or more than 16.
    RAYLET_ERROR_CORNER_COUNT = 39,
    /// The corners of a prism do not turn to the left around a convex polygon.
    RAYLET_ERROR_CORNERS = 40,
    /// The axes do not span a right-handed frame.
    RAYLET_ERROR_AXES = 41,
    /// The angle is not between -360 and 360 degrees.
    RAYLET_ERROR_ANGLE = 42,
    /// The quaternion is not finite, nearly zero or very long.
    RAYLET_ERROR_QUATERNION = 43,
    /// The matrix has no inverse.
    RAYLET_ERROR_SINGULAR = 44,
    /// The start of a ray's range lies above its end.
    RAYLET_ERROR_RANGE = 45,
    /// There are fewer nodes than the shapes need.
    RAYLET_ERROR_NODES = 46,
    /// A hierarchy holds at most 2^30 - 1 shapes.
    RAYLET_ERROR_TOO_MANY_SHAPES = 47,
    /// There are more crossings than there is room for.
    RAYLET_ERROR_FULL = 48,
    /// There are more solids than a set can hold.
    RAYLET_ERROR_TOO_MANY_SOLIDS = 49,
    /// The first numbers of the tier do not decide the ray.
    RAYLET_ERROR_UNDECIDED = 50,
    /// A pointer is null.
    RAYLET_ERROR_NULL = 51,
    /// The part or the crossing of a hit is none.
    RAYLET_ERROR_HIT = 52,
    /// A choice of sides is none.
    RAYLET_ERROR_CHOICE = 53,
    /// A vector, as a direction.
    RAYLET_ERROR_VALUE = 54,
    /// The library was built without this kind of solid or placement.
    RAYLET_ERROR_KIND = 55,
    /// Another error.
    RAYLET_ERROR_OTHER = 56,
}

/// Defines which errors of the library have a code, and its text.
macro_rules! errors {
    (
        values { $($VALUE:ident, $Error:ident($E:ident::$Value:ident);)+ }
        others { $($OTHER:ident, $($Which:ident($O:ident::$Other:ident))?, $text:expr;)+ }
    ) => {
        impl From<Error> for Failed {
            fn from(error: Error) -> Self {
                match error {
                    $(Error::$Error($E::$Value(of)) => Self::with(raylet_error::$VALUE, fault(of)),)+
                    $($(Error::$Which($O::$Other) => Self::of(raylet_error::$OTHER),)?)+
                    Error::Hierarchy(HierarchyError::Storage { .. }) => Self::of(raylet_error::RAYLET_ERROR_NODES),
                    Error::Hierarchy(_) => Self::of(raylet_error::RAYLET_ERROR_TOO_MANY_SHAPES),
                    Error::Crossings(CrossingsError::Full { .. }) => Self::of(raylet_error::RAYLET_ERROR_FULL),
                    Error::Crossings(_) => Self::of(raylet_error::RAYLET_ERROR_TOO_MANY_SOLIDS),
                    Error::Kind(_) => Self::of(raylet_error::RAYLET_ERROR_KIND),
                    Error::Value(_) => Self::of(raylet_error::RAYLET_ERROR_VALUE),
                    Error::Undecided(Undecided) => Self::of(raylet_error::RAYLET_ERROR_UNDECIDED),
                    _ => Self::of(raylet_error::RAYLET_ERROR_OTHER),
                }
            }
        }

        /// The text of a code.
        fn text_of(error: i32, fault: i32) -> &'static CStr {
            $(
                if error == raylet_error::$VALUE as i32 {
                    return match fault {
                        1 => text!($E::$Value(ValueError::NotFinite).message()),
                        2 => text!($E::$Value(ValueError::Negative).message()),
                        3 => text!($E::$Value(ValueError::Zero).message()),
                        4 => text!($E::$Value(ValueError::BelowBudget).message()),
                        5 => text!($E::$Value(ValueError::BeyondBudget).message()),
                        6 => text!($E::$Value(ValueError::BeyondType).message()),
                        7 => text!($E::$Value(ValueError::NotUnit).message()),
                        8 => text!($E::$Value(ValueError::NoDirection).message()),
                        _ => NO_SUCH_CODE,
                    };
                }
            )+
            $(
                if error == raylet_error::$OTHER as i32 && fault == 0 {
                    return text!($text);
                }
            )+
            NO_SUCH_CODE
        }
    };
}

const NO_SUCH_CODE: &CStr = c"there is no such error code";

errors! {
    values {
        RAYLET_ERROR_RADIUS, Size(SizeError::Radius);
        RAYLET_ERROR_HEIGHT, Size(SizeError::Height);
        RAYLET_ERROR_SLOPE, Size(SizeError::Slope);
        RAYLET_ERROR_HALF_EXTENT, Size(SizeError::HalfExtent);
        RAYLET_ERROR_VERTEX, Size(SizeError::Vertex);
        RAYLET_ERROR_CORNER, Size(SizeError::Corner);
        RAYLET_ERROR_COEFFICIENT, Size(SizeError::Coefficient);
        RAYLET_ERROR_HALF_SPACE, Size(SizeError::Normal);
        RAYLET_ERROR_POSITION, Frame(FrameError::Position);
        RAYLET_ERROR_NORMAL, Frame(FrameError::Normal);
        RAYLET_ERROR_AXIS, Frame(FrameError::Axis);
        RAYLET_ERROR_SCALE, Frame(FrameError::Scale);
        RAYLET_ERROR_ORIGIN, Ray(RayError::Origin);
        RAYLET_ERROR_TARGET, Ray(RayError::Target);
        RAYLET_ERROR_DIRECTION, Ray(RayError::Direction);
        RAYLET_ERROR_RANGE_END, Ray(RayError::RangeEnd);
    }
    others {
        RAYLET_ERROR_HEIGHTS, Size(SizeError::Heights), SizeError::Heights.message();
        RAYLET_ERROR_RADII, Size(SizeError::Radii), SizeError::Radii.message();
        RAYLET_ERROR_RING, Size(SizeError::Ring), SizeError::Ring.message();
        RAYLET_ERROR_OUTLINE, Size(SizeError::Outline), SizeError::Outline.message();
        RAYLET_ERROR_VERTICES, Size(SizeError::Vertices), SizeError::Vertices.message();
        RAYLET_ERROR_FACE_COUNT, Size(SizeError::FaceCount), SizeError::FaceCount.message();
        RAYLET_ERROR_UNBOUNDED, Size(SizeError::Unbounded), SizeError::Unbounded.message();
        RAYLET_ERROR_CORNER_COUNT, Size(SizeError::CornerCount), SizeError::CornerCount.message();
        RAYLET_ERROR_CORNERS, Size(SizeError::Corners), SizeError::Corners.message();
        RAYLET_ERROR_AXES, Frame(FrameError::Axes), FrameError::Axes.message();
        RAYLET_ERROR_ANGLE, Frame(FrameError::Angle), FrameError::Angle.message();
        RAYLET_ERROR_QUATERNION, Frame(FrameError::Quaternion), FrameError::Quaternion.message();
        RAYLET_ERROR_SINGULAR, Frame(FrameError::Singular), FrameError::Singular.message();
        RAYLET_ERROR_RANGE, Ray(RayError::Range), RayError::Range.message();
        RAYLET_ERROR_NODES, , "there are fewer nodes than the shapes need: RAYLET_NODES(count) says how many";
        RAYLET_ERROR_TOO_MANY_SHAPES, , "a hierarchy holds at most 2^30 - 1 shapes";
        RAYLET_ERROR_FULL, , "there are more crossings than there is room for";
        RAYLET_ERROR_TOO_MANY_SOLIDS, , "there are more solids than a set can hold: RAYLET_MOST_SOLIDS";
        RAYLET_ERROR_UNDECIDED, , "the first numbers of this tier do not decide the ray";
        RAYLET_ERROR_NULL, , "a pointer is null";
        RAYLET_ERROR_HIT, , "the part or the crossing of the hit is none";
        RAYLET_ERROR_CHOICE, , "the chosen side is none";
        RAYLET_ERROR_VALUE, , "a vector that is to be a direction has none, or is not of length 1";
        RAYLET_ERROR_KIND, , "this library was built without this kind of solid or placement: see RAYLET_KINDS";
        RAYLET_ERROR_OTHER, , "this function cannot do that";
    }
}

/// The text of an error code, in English, such as "the radius is negative". Of a status that is no error, "no error".
#[unsafe(no_mangle)]
pub extern "C" fn raylet_status_text(status: raylet_status) -> *const c_char {
    let text = match status.checked_neg() {
        Some(code) if code > 0 => text_of(code >> 4, code & 15),
        Some(_) => c"no error",
        None => NO_SUCH_CODE,
    };
    text.as_ptr()
}
