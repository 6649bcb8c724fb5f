//! A sensor with 8 by 8 zones among twelve obstacles: the ground and eleven posts, all constants, in flash.

use core::fmt;
use fixed::types::I16F16;
use raylet::sensor::{RangeSensor, Reading, SensorError, Zones};
use raylet::{Cylinder, Frame, Plane, Shape, UnitVec3, Vec3, constant};

/// Metres, in steps of 1/65,536.
pub type Number = I16F16;

/// A program has the code of these kinds alone.
pub type Obstacle = Shape<Number, (Cylinder<Number>, Plane<Number>, Frame<Number>)>;

/// Zones along each side.
pub const ZONES: u8 = 8;

/// The rays of all zones.
pub const RAYS: usize = ZONES as usize * ZONES as usize;

/// A constant, from hundredths.
const fn hundredths(value: i32) -> Number {
    Number::from_bits((value * (1 << 16) + 50 * value.signum()) / 100)
}

/// A post: 25 cm across and a metre high.
const POST: Cylinder<Number> = constant!(Cylinder::<Number>::const_capped(hundredths(12), hundredths(100)));

/// Where the posts stand: to the right and ahead, in hundredths.
pub const PLACES: [[i32; 2]; 11] = [
    [-60, 200],
    [10, 250],
    [90, 300],
    [-150, 350],
    [30, 400],
    [180, 450],
    [-220, 290],
    [230, 330],
    [-90, 490],
    [110, 520],
    [-20, 560],
];

const fn post(place: usize) -> Obstacle {
    let [right, ahead] = PLACES[place];
    let position = Vec3::new(hundredths(right), Number::ZERO, hundredths(-ahead));
    match Frame::<Number>::const_at(position) {
        Ok(frame) => POST.into_shape().in_frame(frame),
        Err(error) => panic!("{}", error.message()),
    }
}

/// The ground, and the posts.
pub static OBSTACLES: [Obstacle; 12] = [
    Plane::new().into_shape(),
    post(0),
    post(1),
    post(2),
    post(3),
    post(4),
    post(5),
    post(6),
    post(7),
    post(8),
    post(9),
    post(10),
];

/// Half a metre above the ground, level, along -z.
pub const PLACE: Frame<Number> = constant!(Frame::<Number>::const_from_axes(
    Vec3::new(Number::ZERO, hundredths(50), Number::ZERO),
    [UnitVec3::<Number>::X.const_neg(), UnitVec3::Y, UnitVec3::<Number>::Z.const_neg()],
));

/// Its zones: 45 degrees to each side and up and down.
///
/// # Errors
///
/// None.
pub fn zones() -> Result<Zones<Number>, SensorError> {
    // The tangent of 22.5 degrees.
    let tangent = const { Number::from_bits(27_146) };
    Zones::with_tangents(PLACE, [ZONES; 2], [tangent; 2])
}

/// It measures from 5 cm to 6 m.
///
/// # Errors
///
/// None.
pub fn sensor() -> Result<RangeSensor<Number>, SensorError> {
    RangeSensor::new(hundredths(5), hundredths(600))
}

/// A row of readings, for printing: the obstacle and the distance of each zone.
#[derive(Debug)]
pub struct Row<'a>(pub &'a [Reading<Number, 1>]);

impl fmt::Display for Row<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for reading in self.0 {
            match reading.returns.first() {
                Some(seen) => write!(f, "{:2}:{:.4} ", seen.obstacle, seen.distance)?,
                None => f.write_str(" -        ")?,
            }
        }
        Ok(())
    }
}
