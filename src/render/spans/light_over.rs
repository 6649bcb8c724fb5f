//! A light over a plane, and shadows on that plane.

use crate::number::dot;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{Light, Raster};
use crate::vector::{UnitVec3, Vec3, cross, pairs};

/// A light over a plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct LightOver<S: Scalar> {
    /// A point of the plane, and its normal.
    on: Vec3<S>,
    normal: [S::Real; 3],
    /// From that point to the light; of a distant light towards it, at any distance.
    light: [S::Real; 3],
    is_distant: bool,
}

impl<S: Scalar> LightOver<S> {
    /// Over the plane through a point with this normal.
    pub(super) fn new(light: &Light<S>, (on, normal): (Vec3<S>, UnitVec3<S>)) -> Self {
        let from = if light.distant { Vec3::ZERO } else { on };
        let towards = pairs(light.position.real(), from.real()).map(|(a, b)| a - b);
        Self { on, normal: normal.real(), light: towards, is_distant: light.distant }
    }

    /// The plane through the light and the line in which a plane through the eye meets this plane: a point and the
    /// normal, of about the length 1. `None` if the planes are nearly parallel, or the light is close to that line.
    pub(super) fn plane_through(&self, eye: Vec3<S>, row: [S::Real; 3]) -> Option<(Vec3<S>, [S::Real; 3])> {
        let along = cross(row, self.normal);
        // Of nearly parallel planes the line is not well known.
        if dot(along, along) < S::Real::ONE.scaled(-8) {
            return None;
        }
        // In the plane of the row, perpendicular to the line: towards it from the eye.
        let down = cross(along, row);
        let from_eye = pairs(self.on.real(), eye.real()).map(|(on, eye)| on - eye);
        let fall = dot(down, self.normal);
        if fall.is_zero() {
            return None;
        }
        let t = dot(from_eye, self.normal) / fall;
        let point = Vec3::<S>::round(pairs(eye.real(), down).map(|(eye, down)| eye + down * t));
        let to_light = if self.is_distant {
            self.light
        } else {
            let from_on = pairs(point.real(), self.on.real()).map(|(point, on)| point - on);
            pairs(self.light, from_on).map(|(light, point)| light - point)
        };
        let normal = cross(along, to_light);
        // So is the plane, of a light close to the line.
        if dot(normal, normal) < dot(to_light, to_light).scaled(-16) {
            return None;
        }
        let normal = UnitVec3::<S>::from_real(normal)?;
        point.is_within_budget().then(|| (point, normal.real()))
    }

    /// The shadow of a point on the plane; `None` if it has none, or that is too far away.
    pub(super) fn shadow_of(&self, point: Vec3<S>) -> Option<Vec3<S>> {
        let from_on = pairs(point.real(), self.on.real()).map(|(point, on)| point - on);
        let to_light = if self.is_distant { self.light } else { pairs(self.light, from_on).map(|(l, p)| l - p) };
        let (height, rise) = (dot(from_on, self.normal), dot(to_light, self.normal));
        if rise.is_zero() || !height.is_zero() && rise.is_negative() != height.is_negative() {
            return None;
        }
        let t = height / rise;
        let shadow = Vec3::<S>::round(pairs(point.real(), to_light).map(|(point, to_light)| point - to_light * t));
        shadow.is_within_budget().then_some(shadow)
    }

    /// The least width, over all rows of a picture, of what the light brightens by Lambert's law: half of the width at
    /// `1 / sqrt(2)` of its height, as a fraction, in lengths one unit in front of the eye.
    ///
    /// From the eye, the plane is `k` away along its normal `n`, and the light `l` is `h` above it. The ray along `r`
    /// meets the plane at `r k / (n . r)`, so that the cosine is `h (n . r)` by the length of `r k - l (n . r)`. That
    /// vector is linear in `r`: over a row it goes along a line, by `k b - l (n . b)` for each step `b` to the right.
    /// Those of all rows are a plane with the normal `n (l . f) - f h`, where `f` is the direction forwards. The width
    /// is the distance of that plane from the origin by the length of a step.
    pub(super) fn width(&self, raster: &Raster<S>) -> [S::Real; 2] {
        let ([right, _, forward], n) = (raster.axes().map(UnitVec3::real), self.normal);
        let length = |v: [S::Real; 3]| dot(v, v).sqrt();
        let from_eye = pairs(self.on.real(), raster.camera().position().real()).map(|(on, eye)| on - eye);
        let lamp = pairs(from_eye, self.light).map(|(on, light)| on + light);
        let (k, h) = (dot(n, from_eye), dot(n, self.light));
        let (ahead, beside) = (dot(lamp, forward), dot(n, right));
        let normal = pairs(n, forward).map(|(n, f)| n * ahead - f * h);
        let step = pairs(right, lamp).map(|(b, l)| b * k - l * beside);
        [(k * h).abs(), length(normal) * length(step)]
    }
}
