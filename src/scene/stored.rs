//! The parts of a scene whose stored form differs from their fields, for `serde`: cameras, rasters, fog and textures.

use super::{Camera, Color, Coordinate, Fog, Raster, Size, Texture};
use crate::scalar::Scalar;
use crate::scalar::written::Plain;
use crate::vector::{UnitVec3, Vec3};
use serde::de::{Error, IgnoredAny};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A camera: its position and axes, and half of its picture's height. That is a number to compute in: of a float the
/// float, of fixed point an integer and the power of two by which it is multiplied.
#[derive(Serialize, Deserialize)]
#[serde(bound = "")]
struct StoredCamera<S: Scalar> {
    position: Vec3<S>,
    forward: UnitVec3<S>,
    right: UnitVec3<S>,
    up: UnitVec3<S>,
    half_height: Plain<S::Real>,
    is_orthographic: bool,
}

impl<S: Scalar> Serialize for Camera<S> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let (position, [forward, right, up]) = (self.position(), self.axes());
        let (half_height, is_orthographic) = (Plain(self.half_height()), self.is_orthographic());
        StoredCamera { position, forward, right, up, half_height, is_orthographic }.serialize(serializer)
    }
}

impl<'de, S: Scalar> Deserialize<'de> for Camera<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let StoredCamera { position, forward, right, up, half_height: Plain(half_height), is_orthographic } =
            StoredCamera::deserialize(deserializer)?;
        Self::from_stored(position, [forward, right, up], half_height, is_orthographic).map_err(D::Error::custom)
    }
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "")]
struct StoredRaster<S: Scalar> {
    camera: Camera<S>,
    size: Size,
}

impl<S: Scalar> Serialize for Raster<S> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        StoredRaster { camera: *self.camera(), size: self.size() }.serialize(serializer)
    }
}

impl<'de, S: Scalar> Deserialize<'de> for Raster<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        StoredRaster::deserialize(deserializer).map(|StoredRaster { camera, size }| camera.raster(size))
    }
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "")]
struct StoredFog<S: Scalar> {
    color: Color<S>,
    clarity: Plain<S::Unit>,
}

impl<S: Scalar> Serialize for Fog<S> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        StoredFog { color: self.color(), clarity: Plain(self.clarity()) }.serialize(serializer)
    }
}

/// A clarity outside `[0, 1]` is clamped, as by [`Fog::new`].
impl<'de, S: Scalar> Deserialize<'de> for Fog<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let StoredFog { color, clarity: Plain(clarity) } = StoredFog::deserialize(deserializer)?;
        Ok(Self::new(color, clarity))
    }
}

/// A texture as it is read: in the order of [`Texture`], by whose derived form it is written.
#[derive(Deserialize)]
#[serde(bound = "", rename = "Texture")]
enum ReadTexture<S: Scalar> {
    Checker { columns: u16, rows: u16, colors: [Color<S>; 2] },
    Stripes { along: Coordinate, count: u16, colors: [Color<S>; 2] },
    Cells { counts: [u16; 3], colors: [Color<S>; 2] },
    Image(IgnoredAny),
}

/// A pattern. An image borrows its pixels, for which a reader has no storage, so that it is refused.
impl<'de, S: Scalar> Deserialize<'de> for Texture<'_, S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let texture = match ReadTexture::deserialize(deserializer)? {
            ReadTexture::Checker { columns, rows, colors } => Self::Checker { columns, rows, colors },
            ReadTexture::Stripes { along, count, colors } => Self::Stripes { along, count, colors },
            ReadTexture::Cells { counts, colors } => Self::Cells { counts, colors },
            ReadTexture::Image(_) => {
                return Err(D::Error::custom("an image borrows its pixels: read these, and make the texture of them"));
            }
        };
        match texture.fault() {
            Some(fault) => Err(D::Error::custom(format_args!("the texture cannot be used: {fault}"))),
            None => Ok(texture),
        }
    }
}
