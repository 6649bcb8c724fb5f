//! Pinhole and orthographic cameras: the primary ray of each pixel sample.

mod constant;

use crate::frame::Frame;
#[cfg(feature = "serde")]
use crate::frame::FrameError;
use crate::number::dot;
use crate::ray::Ray;
use crate::scalar::{Real, Ring, Scalar, Scanline};
use crate::vector::{UnitVec3, Vec3, pairs};
use core::fmt;

/// A pinhole camera, or an orthographic one, whose rays are parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera<S: Scalar> {
    position: Vec3<S>,
    forward: UnitVec3<S>,
    right: UnitVec3<S>,
    up: UnitVec3<S>,
    /// Half of the distance between the centres of the first and the last row of pixels: one unit in front of the eye,
    /// or of parallel rays.
    half_height: S::Real,
    is_orthographic: bool,
}

impl<S: Scalar> Camera<S> {
    /// A pinhole camera at `position` that looks at the point `target`, with `up` (of any length, not necessarily
    /// perpendicular) towards the upper edge of the picture.
    ///
    /// `angle`, in degrees between 0 and 180 exclusive, is the angle between the centres of the first and the last row
    /// of pixels, as NFF defines it. Pixels are square.
    ///
    /// # Errors
    ///
    /// A [`CameraError`] that names the value at fault.
    pub fn new(position: Vec3<S>, target: Vec3<S>, up: Vec3<S>, angle: S) -> Result<Self, CameraError> {
        let camera = Self::facing(position, target, up)?;
        let half_height = tangent_of_half(angle).ok_or(CameraError::Angle)?;
        Ok(Self { half_height, ..camera })
    }

    /// An orthographic camera: all rays are parallel to the line from `position` to the point `target`, so that lengths
    /// across it are the same near and far. `up` is that of [`Camera::new`].
    ///
    /// `height` is the distance between the centres of the first and the last row of pixels. Pixels are square. Rays
    /// start in the plane through `position`; those that start beyond the number type's budget see nothing.
    ///
    /// # Errors
    ///
    /// A [`CameraError`] that names the value at fault.
    ///
    /// ```
    /// # use raylet::{Camera, Material, Object, Picture, Scene, Shape, Size, Sphere, Vec3};
    /// let y = Vec3::new(0.0_f32, 1.0, 0.0);
    /// let camera = Camera::orthographic(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, y, 2.4)?;
    /// # let objects = [Object::new(Shape::new(Sphere::new(1.0_f32)?), 0)];
    /// # let materials = [Material::default()];
    /// # let scene = Scene::new(&objects, &materials, &[], camera)?;
    /// let mut widths = [0; 11];
    /// Picture::new(&scene, Size::new(11, 11)).render(|_, y, pixel| {
    ///     widths[y as usize] += u32::from(pixel.seen.is_some());
    /// });
    /// // A disc of radius 1, in pixels 0.24 apart.
    /// assert_eq!(widths, [0, 3, 5, 7, 9, 9, 9, 7, 5, 3, 0]);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn orthographic(position: Vec3<S>, target: Vec3<S>, up: Vec3<S>, height: S) -> Result<Self, CameraError> {
        let camera = Self::facing(position, target, up)?;
        // A NaN compares false.
        if height > S::ZERO && height <= S::BUDGET.coordinate {
            Ok(Self { half_height: height.real().scaled(-1), is_orthographic: true, ..camera })
        } else {
            Err(CameraError::Height)
        }
    }

    /// A pinhole camera at the position of a frame, that looks along the frame's z axis, with its y axis up. (The x
    /// axis points to the left of the picture, since a frame is right-handed.) It keeps the axes to the bit, and needs
    /// no square root, so that it can be called in a constant: see [`mod@crate::constant`].
    ///
    /// `tangent` is that of half the angle between the centres of the first and the last row of pixels: half of the
    /// picture's height, one unit in front of the eye.
    ///
    /// # Errors
    ///
    /// [`CameraError::Angle`] if the tangent is not between the least and the largest slope of the number type's
    /// [`Budget`](crate::scalar::Budget).
    ///
    /// ```
    /// # use raylet::{Camera, Frame, UnitVec3, Vec3};
    /// let frame = Frame::looking(Vec3::new(0.0_f32, 0.0, 5.0), -UnitVec3::Z, UnitVec3::Y)?;
    /// assert_eq!(Camera::in_frame(frame, 0.5)?.forward(), -UnitVec3::Z);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn in_frame(frame: Frame<S>, tangent: S) -> Result<Self, CameraError> {
        if tangent >= S::BUDGET.smallest_slope && tangent <= S::BUDGET.slope {
            Ok(Self { half_height: tangent.real(), ..Self::along(frame) })
        } else {
            Err(CameraError::Angle)
        }
    }

    /// An orthographic camera in a frame, which it keeps as [`Camera::in_frame`] does; `height` is that of
    /// [`Camera::orthographic`].
    ///
    /// # Errors
    ///
    /// [`CameraError::Height`] as for [`Camera::orthographic`].
    pub fn orthographic_in_frame(frame: Frame<S>, height: S) -> Result<Self, CameraError> {
        // A NaN compares false.
        if height > S::ZERO && height <= S::BUDGET.coordinate {
            Ok(Self { half_height: height.real().scaled(-1), is_orthographic: true, ..Self::along(frame) })
        } else {
            Err(CameraError::Height)
        }
    }

    fn along(frame: Frame<S>) -> Self {
        let (position, [x, up, forward]) = (frame.position(), frame.axes());
        Self { position, forward, right: -x, up, half_height: S::Real::ZERO, is_orthographic: false }
    }

    fn facing(position: Vec3<S>, target: Vec3<S>, up: Vec3<S>) -> Result<Self, CameraError> {
        if !position.is_within_budget() {
            return Err(CameraError::Position);
        }
        if !target.is_within_budget() {
            return Err(CameraError::Target);
        }
        let sample = difference(target, position);
        let forward = UnitVec3::from_real(sample).ok_or(CameraError::Target)?;
        let up = UnitVec3::new(up).map_err(|_| CameraError::Up)?;
        let right = UnitVec3::from_real(forward.cross(up)).ok_or(CameraError::Up)?;
        let up = UnitVec3::from_real(right.cross(forward)).ok_or(CameraError::Up)?;
        Ok(Self { position, forward, right, up, half_height: S::Real::ZERO, is_orthographic: false })
    }

    /// Forward, right and up.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(super) const fn axes(&self) -> [UnitVec3<S>; 3] {
        [self.forward, self.right, self.up]
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(super) const fn half_height(&self) -> S::Real {
        self.half_height
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(super) const fn is_orthographic(&self) -> bool {
        self.is_orthographic
    }

    /// From the stored values of a camera, to the bit.
    #[cfg(feature = "serde")]
    pub(super) fn from_stored(
        position: Vec3<S>,
        [forward, right, up]: [UnitVec3<S>; 3],
        half_height: S::Real,
        is_orthographic: bool,
    ) -> Result<Self, CameraError> {
        Frame::from_axes(position, [right, up, -forward]).map_err(|error| match error {
            FrameError::Position(_) => CameraError::Position,
            _ => CameraError::Axes,
        })?;
        // Half of the height of a pinhole's picture is that of fixed point between the least and the largest quotient
        // of two units.
        let (one, bound) = (S::Real::ONE, 64);
        let in_type = if S::RELATIVE {
            S::round(half_height).is_finite()
        } else {
            half_height >= one.scaled(-bound) && half_height <= one.scaled(bound)
        };
        // The comparison is false for NaN. Half of the least float is zero.
        let is_positive = half_height > S::Real::ZERO && in_type;
        let is_least = S::RELATIVE && half_height.is_zero();
        let is_height = is_least || (is_positive && half_height.scaled(1) <= S::BUDGET.coordinate.real());
        if is_orthographic && !is_height {
            Err(CameraError::Height)
        } else if !is_orthographic && !is_positive {
            Err(CameraError::Angle)
        } else {
            Ok(Self { position, forward, right, up, half_height, is_orthographic })
        }
    }

    /// The position of the eye, or the middle of the plane in which parallel rays start.
    pub const fn position(&self) -> Vec3<S> {
        self.position
    }

    /// The viewing direction, through the centre of the picture.
    pub const fn forward(&self) -> UnitVec3<S> {
        self.forward
    }

    /// The grid of rays for a picture of this size.
    pub fn raster(&self, size: Size) -> Raster<S> {
        // A picture of one row has no distance between rows: its one pixel spans the whole angle.
        let intervals = i32::from(size.height.max(2)) - 1;
        let samples = i32::from(size.samples.max(1));
        let pitch = self.half_height / (S::Real::from_int(intervals) * S::Real::from_int(samples));
        Raster { camera: *self, size, pitch }
    }
}

/// The tangent of half an angle in degrees, or `None` if the angle is not between 0 and 180, exclusive.
pub(crate) fn tangent_of_half<S: Scalar>(angle: S) -> Option<S::Real> {
    let turns = angle.real() / S::Real::from_int(720);
    if !angle.is_finite() || angle <= S::ZERO || turns >= S::Real::ONE.scaled(-2) {
        return None;
    }
    let (sine, cosine) = S::sine_cosine(S::unit_round(turns));
    let [sine, cosine] = [sine, cosine].map(S::unit_real);
    (sine > S::Real::ZERO && cosine > S::Real::ZERO).then(|| sine / cosine)
}

/// `a - b` in the computing number, since a fixed-point difference might saturate.
fn difference<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> [S::Real; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a.real(), b.real());
    [ax - bx, ay - by, az - bz]
}

/// The size of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Size {
    /// Pixels in a row.
    pub width: u16,
    /// Rows.
    pub height: u16,
    /// Samples along each side of a pixel: a pixel takes `samples * samples` rays, on a regular grid.
    pub samples: u8,
}

impl Size {
    /// A picture with one ray a pixel.
    pub const fn new(width: u16, height: u16) -> Self {
        Self { width, height, samples: 1 }
    }

    /// The same picture with a grid of `samples * samples` rays a pixel; 0 counts as 1.
    #[must_use]
    pub const fn with_samples(self, samples: u8) -> Self {
        Self { samples, ..self }
    }
}

/// A camera and the size of its picture. It makes the ray of every sample of every pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Raster<S: Scalar> {
    camera: Camera<S>,
    size: Size,
    /// Half of the distance between neighbouring samples, one unit in front of the eye or of parallel rays.
    pitch: S::Real,
}

impl<S: Scalar> Raster<S> {
    /// The camera.
    pub const fn camera(&self) -> &Camera<S> {
        &self.camera
    }

    /// The size of the picture.
    pub const fn size(&self) -> Size {
        self.size
    }

    /// The directions to the right, upwards and forwards.
    pub(crate) const fn axes(&self) -> [UnitVec3<S>; 3] {
        let Camera { forward, right, up, .. } = self.camera;
        [right, up, forward]
    }

    /// Half of the side of a pixel, one unit in front of the eye. `None` of an orthographic camera.
    pub(crate) fn half_a_pixel(&self) -> Option<S::Real> {
        let samples = S::Real::from_int(i32::from(self.size.samples.max(1)));
        (!self.camera.is_orthographic).then(|| self.pitch * samples)
    }

    /// The ray through a sample (column and row) of a pixel (column and row); (0, 0) is the upper left. With one sample
    /// a pixel it goes through the pixel's centre, as a zone of a range sensor is measured. `n` rows that span an angle
    /// `w` between their outer edges need a camera of the angle `2 atan((1 - 1/n) tan(w/2))` ([`Camera::new`]).
    ///
    /// Pixels and samples outside the picture are allowed. `None` only for an orthographic camera, for a ray that
    /// starts beyond the budget.
    pub fn ray(&self, pixel: [u16; 2], sample: [u8; 2]) -> Option<Ray<S>> {
        let [right, down] = self.place(pixel, sample);
        self.row(down).through(right)
    }

    /// Where the ray through a sample of a pixel goes: half samples to the right of the upper left corner, for
    /// [`RaysOfRow::through`], and below it, for [`Raster::row`].
    pub(crate) fn place(&self, [x, y]: [u16; 2], [column, row]: [u8; 2]) -> [i32; 2] {
        let half = |pixel: u16, sample: u8| i32::from(pixel) * self.pixel() + 2 * i32::from(sample) + 1;
        [half(x, column), half(y, row)]
    }

    /// Where the upper left corner of pixel (`x`, `y`) is, which it shares with its neighbours; (width, height) is the
    /// picture's lower right corner.
    pub(crate) fn corner(&self, corner: [u32; 2]) -> [i32; 2] {
        corner.map(|pixels| pixels as i32 * self.pixel())
    }

    /// The column and the row whose ray is nearest to a point, which may be beyond the picture; of a pinhole camera
    /// with one sample a pixel. `None` if the point is not in front of the eye, or very far aside.
    pub(crate) fn pixel_of(&self, point: Vec3<S>) -> Option<[i32; 2]> {
        let (Camera { position, forward, right, up, .. }, Size { width, height, .. }) = (self.camera, self.size);
        let from_eye = difference(point, position);
        let along = |axis: UnitVec3<S>| dot(from_eye, axis.real());
        let ahead = along(forward);
        if ahead <= S::Real::ZERO {
            return None;
        }
        let half_samples = |across: S::Real| {
            // A picture has less than 2^17.
            let share = (across / (ahead * self.pitch)).scaled(-18);
            let is_near = share.abs() < S::Real::ONE;
            is_near.then(|| S::unit_parts(S::unit_round(share)).truncated(18))
        };
        let [beside, above] = [half_samples(along(right))?, half_samples(along(up))?];
        Some([(beside + self.middle(width)) >> 1, (self.middle(height) - above) >> 1])
    }

    /// A normal of the plane of the rays in a row, of about the length 1, if it has any; of a pinhole camera.
    pub(crate) fn normal_of_row(&self, row: &RaysOfRow<'_, S>) -> Option<[S::Real; 3]> {
        // That ray is perpendicular to the row.
        let middle = row.through(self.middle(self.size.width))?;
        Some(self.camera.right.cross(middle.direction()))
    }

    /// The side of a pixel in half samples.
    pub(crate) fn pixel(&self) -> i32 {
        2 * i32::from(self.size.samples.max(1))
    }

    /// The rays that are so many half samples below the upper left corner.
    pub(crate) fn row(&self, down: i32) -> RaysOfRow<'_, S> {
        let above = self.above(down);
        let Camera { forward, right, up, is_orthographic, .. } = self.camera;
        let across = [right, up].map(UnitVec3::to_array);
        let line =
            (!is_orthographic).then(|| S::Scanline::new(forward.to_array(), across, [self.pitch; 2]).above(above));
        RaysOfRow { raster: self, down, line }
    }

    /// The ray of an orthographic camera that starts so many half samples to the right of the middle and above it.
    #[inline(never)]
    fn parallel(&self, steps: [i32; 2]) -> Option<Ray<S>> {
        let [across, upwards] = steps.map(|halves| S::Real::from_int(halves) * self.pitch);
        let Camera { position, forward, right, up, .. } = self.camera;
        let offsets = pairs(right.real(), up.real()).map(|(right, up)| right * across + up * upwards);
        let origin = Vec3::round(pairs(position.real(), offsets).map(|(position, offset)| position + offset));
        Ray::new(origin, forward).ok()
    }

    /// How many half samples a row is above the middle.
    fn above(&self, down: i32) -> i32 {
        self.middle(self.size.height) - down
    }

    /// How many half samples the middle of so many pixels is from their start: below 2^24, so that places are below
    /// 2^26, those of an outline included.
    fn middle(&self, pixels: u16) -> i32 {
        i32::from(pixels) * i32::from(self.size.samples.max(1))
    }
}

/// The rays of a row of samples.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RaysOfRow<'r, S: Scalar> {
    raster: &'r Raster<S>,
    down: i32,
    /// Their directions; `None` if they are parallel.
    line: Option<S::Scanline>,
}

impl<S: Scalar> RaysOfRow<'_, S> {
    /// How many half samples it is below the upper left corner.
    pub(crate) const fn down(&self) -> i32 {
        self.down
    }

    /// The ray that is so many half samples to the right of the left edge.
    #[inline]
    pub(crate) fn through(&self, right: i32) -> Option<Ray<S>> {
        let beside = right - self.raster.middle(self.raster.size.width);
        match &self.line {
            Some(line) => {
                let direction = UnitVec3::rotated(line.direction(beside)?);
                Some(Ray::from_within(self.raster.camera.position, direction))
            }
            None => self.raster.parallel([beside, self.raster.above(self.down)]),
        }
    }
}

/// Why a camera cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum CameraError {
    /// The position is not finite or beyond the budget.
    Position,
    /// The target coincides with the position, or is beyond the budget.
    Target,
    /// The up vector is zero or parallel to the line of sight.
    Up,
    /// The angle is not between 0 and 180 degrees, or too near to either for the number type.
    Angle,
    /// Axes that were stored are not perpendicular, or not right-handed.
    Axes,
    /// The height of an orthographic camera's picture is not positive, not finite or beyond the budget.
    Height,
}

impl CameraError {
    /// The message; also for constants.
    pub const fn message(self) -> &'static str {
        match self {
            Self::Position => "the camera is beyond the number type's budget: move it closer to the origin",
            Self::Target => "the camera looks at its own position, or at a point beyond the number type's budget",
            Self::Up => "the camera's up vector is zero or parallel to its line of sight: give another one",
            Self::Angle => "the camera's angle must lie between 0 and 180 degrees",
            Self::Axes => {
                "the camera's axes must be perpendicular; right, up and backwards must be a right-handed frame"
            }
            Self::Height => {
                "the height of an orthographic camera's picture must be positive and within the number type's budget"
            }
        }
    }
}

impl fmt::Display for CameraError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())
    }
}

impl core::error::Error for CameraError {}
