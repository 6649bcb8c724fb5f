//! The rays of a sensor that measures zone by zone.

use super::SensorError;
use crate::frame::Frame;
use crate::ray::Ray;
use crate::scalar::{Real, Scalar, Scanline};
use crate::scene::tangent_of_half;
use crate::vector::{UnitVec3, Vec3};

/// The rays of a time-of-flight sensor with zones. Zones are equal rectangles in a plane before the sensor, as the
/// pixels of a camera are, and each has a grid of rays.
///
/// The sensor looks along the z axis of its frame, with the y axis up. Zone (0, 0) is the upper left as seen from the
/// sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zones<S: Scalar> {
    frame: Frame<S>,
    columns: u8,
    rows: u8,
    /// Rays along each side of a zone.
    side: u16,
    /// Half of the distance between neighbouring rays, to the right and upwards, one unit in front of the sensor.
    pitch: [S::Real; 2],
    /// Through the middle of the field of view.
    level: S::Scanline,
}

impl<S: Scalar> Zones<S> {
    /// Columns and rows of zones with one ray each, in the middle, and the sensor's field of view to the sides and up
    /// and down: in degrees, between the outer edges of zones.
    ///
    /// # Errors
    ///
    /// [`SensorError::NoZone`] if there is no row or no column; [`SensorError::Angle`] if an angle is not between 0 and
    /// 180 degrees, exclusive.
    pub fn new(frame: Frame<S>, counts: [u8; 2], angles: [S; 2]) -> Result<Self, SensorError> {
        let [right, up] = angles.map(|angle| tangent_of_half(angle).ok_or(SensorError::Angle));
        Self::of_reals(frame, counts, [right?, up?])
    }

    /// As [`Zones::new`], from the tangents of half the field of view: half of its width and of its height, one unit in
    /// front of the sensor. (A program that calls only this one has no code of sines.)
    ///
    /// # Errors
    ///
    /// As [`Zones::new`]; [`SensorError::Angle`] if a tangent is not between the least and the largest slope of the
    /// number type's [`Budget`](crate::scalar::Budget).
    ///
    /// ```
    /// use raylet::sensor::Zones;
    /// use raylet::{Frame, Vec3};
    /// let zones = Zones::with_tangents(Frame::at(Vec3::ZERO)?, [2, 1], [0.5_f32, 0.25])?;
    /// // The frame's x axis points to the left.
    /// let left = zones.rays(0, 0).next().map(|ray| ray.direction().x());
    /// assert!(left.is_some_and(|x| (x - 0.25 / 1.0625_f32.sqrt()).abs() < 1e-6));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn with_tangents(frame: Frame<S>, counts: [u8; 2], tangents: [S; 2]) -> Result<Self, SensorError> {
        if tangents.into_iter().all(|slope| slope >= S::BUDGET.smallest_slope && slope <= S::BUDGET.slope) {
            Self::of_reals(frame, counts, tangents.map(S::real))
        } else {
            Err(SensorError::Angle)
        }
    }

    fn of_reals(frame: Frame<S>, [columns, rows]: [u8; 2], [right, up]: [S::Real; 2]) -> Result<Self, SensorError> {
        if columns == 0 || rows == 0 {
            return Err(SensorError::NoZone);
        }
        let pitch = [right / S::Real::from_int(columns.into()), up / S::Real::from_int(rows.into())];
        Ok(Self { frame, columns, rows, side: 1, pitch, level: level(&frame, pitch) })
    }

    /// The same zones with a grid of `side * side` rays each; 0 counts as 1.
    #[must_use]
    pub fn with_rays(self, side: u8) -> Self {
        let side = side.max(1);
        let share = S::Real::from_int(self.side.into()) / S::Real::from_int(side.into());
        let pitch = self.pitch.map(|pitch| pitch * share);
        Self { side: side.into(), pitch, level: level(&self.frame, pitch), ..self }
    }

    /// Columns and rows.
    pub const fn counts(&self) -> [u8; 2] {
        [self.columns, self.rows]
    }

    /// The tangents of half the field of view, to the side and upwards.
    pub(super) fn tangents(&self) -> [S::Real; 2] {
        let [right, up] = self.pitch;
        [right * S::Real::from_int(self.middle(self.columns)), up * S::Real::from_int(self.middle(self.rows))]
    }

    /// Where the sensor is.
    pub const fn frame(&self) -> &Frame<S> {
        &self.frame
    }

    /// Moved with the sensor.
    #[must_use]
    pub fn moved_to(self, frame: Frame<S>) -> Self {
        Self { frame, level: level(&frame, self.pitch), ..self }
    }

    /// The rays of a zone, row by row from its upper left. Zones beside the field of view are allowed.
    #[inline]
    pub fn rays(&self, column: u8, row: u8) -> RaysOfZone<'_, S> {
        let side = i32::from(self.side);
        let (column, row) = (i32::from(column) * side, i32::from(row) * side);
        RaysOfZone { zones: self, column, left: self.side, row, below: self.side - 1, line: self.line(row) }
    }

    /// The row of rays of this number.
    #[inline]
    fn line(&self, row: i32) -> S::Scanline {
        self.level.above(self.middle(self.rows) - 2 * row - 1)
    }

    /// The rays of all zones, made now: for a sensor that keeps its direction. `N` is the number of rays at least.
    ///
    /// # Errors
    ///
    /// [`SensorError::Room`] if there are more.
    ///
    /// ```
    /// # use raylet::sensor::Zones;
    /// # use raylet::{Frame, Vec3};
    /// let zones = Zones::new(Frame::at(Vec3::ZERO)?, [8, 8], [45.0_f32, 45.0])?;
    /// let fan = zones.fan::<64>()?;
    /// assert!(fan.rays(2, 5).eq(zones.rays(2, 5)));
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn fan<const N: usize>(&self) -> Result<Fan<S, N>, SensorError> {
        let mut directions = heapless::Vec::new();
        for row in 0..self.rows {
            for column in 0..self.columns {
                for ray in self.rays(column, row) {
                    directions.push(ray.direction()).map_err(|_| SensorError::Room)?;
                }
            }
        }
        let of_zone = usize::from(self.side) * usize::from(self.side);
        Ok(Fan { position: self.frame.position(), directions, columns: self.columns, of_zone })
    }

    /// The distance along the sensor's line of sight, which some sensors report instead of that along the ray.
    #[inline]
    pub fn depth(&self, ray: &Ray<S>, distance: S) -> S {
        S::round(distance.real() * ray.direction().dot(self.frame.forward()))
    }

    /// How many half steps the middle of so many zones is from their edge.
    fn middle(&self, zones: u8) -> i32 {
        i32::from(zones) * i32::from(self.side)
    }
}

/// The row of rays through the middle of the field of view.
fn level<S: Scalar>(frame: &Frame<S>, pitch: [S::Real; 2]) -> S::Scanline {
    let [left, up, forward] = frame.axes();
    S::Scanline::new(forward.to_array(), [-left, up].map(UnitVec3::to_array), pitch)
}

/// The rays of a zone.
#[derive(Clone, Debug)]
pub struct RaysOfZone<'z, S: Scalar> {
    zones: &'z Zones<S>,
    /// The column of the next ray, among those of all zones, and how many of its row are left.
    column: i32,
    left: u16,
    /// Its row, and how many rows are left after it.
    row: i32,
    below: u16,
    line: S::Scanline,
}

impl<S: Scalar> Iterator for RaysOfZone<'_, S> {
    type Item = Ray<S>;

    #[inline]
    fn next(&mut self) -> Option<Ray<S>> {
        let side = self.zones.side;
        if self.left == 0 {
            self.below = self.below.checked_sub(1)?;
            (self.column, self.left, self.row) = (self.column - i32::from(side), side, self.row + 1);
            self.line = self.zones.line(self.row);
        }
        let direction = self.line.direction(2 * self.column + 1 - self.zones.middle(self.zones.columns))?;
        (self.column, self.left) = (self.column + 1, self.left - 1);
        Ray::new(self.zones.frame.position(), UnitVec3::rotated(direction)).ok()
    }
}

/// The rays of all zones of a sensor: [`Zones::fan`].
#[derive(Clone, Debug, PartialEq)]
pub struct Fan<S: Scalar, const N: usize> {
    position: Vec3<S>,
    /// Zone by zone.
    directions: heapless::Vec<UnitVec3<S>, N>,
    columns: u8,
    /// Rays of a zone.
    of_zone: usize,
}

impl<S: Scalar, const N: usize> Fan<S, N> {
    /// The rays of a zone, as [`Zones::rays`] makes them; none beside the field of view.
    #[inline]
    pub fn rays(&self, column: u8, row: u8) -> impl Iterator<Item = Ray<S>> + Clone + '_ {
        let zone = usize::from(row) * usize::from(self.columns) + usize::from(column);
        let of_row = if column < self.columns { self.directions.get(zone * self.of_zone..) } else { None };
        let position = self.position;
        let directions = of_row.unwrap_or_default().iter().take(self.of_zone);
        directions.filter_map(move |direction| Ray::new(position, *direction).ok())
    }

    /// The same rays from another place.
    #[must_use]
    pub fn moved_to(self, position: Vec3<S>) -> Self {
        Self { position, ..self }
    }
}
