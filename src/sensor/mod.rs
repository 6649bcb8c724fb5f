//! Range sensors: what a time-of-flight sensor with zones, a scanning lidar or a single beam measures among obstacles.
//!
//! | module | what it holds |
//! |---|---|
//! | [`Zones`] | the rays of a sensor that measures zone by zone, on a grid as the pixels of a camera |
//! | [`Sweep`] | the rays of a lidar that turns about an axis |
//! | [`Noise`] | the errors of its distances, from a seed |
//! | [`Obstacles`] | what may be in the way: a list, or one that is searched faster |
//! | [`RangeSensor`] | a measurement of all these: a [`Reading`] |
//!
//! A sensor has a least and a greatest distance. What is farther than the greatest is not seen. What is nearer than the
//! least blinds it: it measures nothing, and says so ([`Status::TooNear`]).
//!
//! A beam is wider than a ray, so that sensors report more than one *return*: the edge of a post and the wall behind
//! it. A reading has up to `N` of them. Each is where a ray of the zone enters a solid or crosses a surface, farther
//! than the one before by at least the sensor's *separation*, in which two echoes are one. Rays do not end at a return,
//! so that it takes the place of the part of the beam that passes by. What a beam meets on its way out of a solid is no
//! return.
//!
//! ```
//! use fixed::types::I16F16;
//! use raylet::sensor::{RangeSensor, Reading, Status, Zones};
//! use raylet::{Cylinder, Frame, Plane, Shape, UnitVec3, Vec3};
//!
//! let metres = |x: f64| I16F16::from_num(x);
//! let point = |x, y, z| Vec3::new(metres(x), metres(y), metres(z));
//! // The ground, and a post two metres ahead.
//! let post = Shape::new(Cylinder::capped(metres(0.25), metres(1.5))?);
//! let obstacles = [Shape::new(Plane::new()), post.placed(Frame::at(point(0.0, 0.0, 2.0))?)];
//! // Half a metre above the ground; 8 by 8 zones over 45 by 45 degrees.
//! let place = Frame::at(point(0.0, 0.5, 0.0))?;
//! let zones = Zones::new(place, [8, 8], [metres(45.0), metres(45.0)])?;
//! let sensor = RangeSensor::new(metres(0.1), metres(4.0))?;
//!
//! // The upper left zone sees nothing; one in the middle the post; a lower one the ground.
//! let reading: Reading<_, 1> = sensor.read(&obstacles[..], zones.rays(0, 0), 0);
//! assert_eq!(reading.status, Status::NoTarget);
//! let reading: Reading<_, 1> = sensor.read(&obstacles[..], zones.rays(3, 3), 0);
//! let seen = &reading.returns[0];
//! assert!(seen.obstacle == 1 && seen.distance > metres(1.77) && seen.distance < metres(1.78));
//! // With a second return, it sees the ground behind the post too.
//! let reading: Reading<_, 2> = sensor.read(&obstacles[..], zones.rays(3, 5), 0);
//! assert!(reading.returns.iter().map(|seen| seen.obstacle).eq([1, 0]));
//! # Ok::<(), raylet::Error>(())
//! ```

mod bounded;
mod columns;
mod error;
mod noise;
mod obstacles;
mod reading;
mod search;
mod sweep;
mod zones;

pub use bounded::{Bounded, InZone, SeenByZones};
pub use error::SensorError;
pub use noise::Noise;
pub use obstacles::Obstacles;
pub use reading::{RangeSensor, Reading, Return, Status};
pub use search::{Search, Try};
pub use sweep::Sweep;
pub use zones::{Fan, RaysOfZone, Zones};
