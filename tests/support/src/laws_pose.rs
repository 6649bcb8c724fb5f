//! Where a shape stands in the laws: by a frame or by an affine matrix, and the way back into its own frame in exact
//! numbers.

use super::cases::{direction, v};
use super::exact_types::Exact as Number;
use super::laws_distance::Point;
use super::random::normalize;
use raylet::scalar::UnitScalar;
use raylet::{Affine, Frame, Ray, Shape, UnitVec3, Vec3};

/// Where a shape stands: how its points are brought into its own frame in exact numbers.
#[derive(Clone, Copy, Debug)]
pub enum Pose<S: Number> {
    World,
    Frame(Frame<S>),
    /// The axis `i` of the local frame is the world's axis `axes[i]`, times `2^powers[i]` and a sign: an inverse that
    /// every number type holds exactly.
    Affine {
        position: Vec3<S>,
        axes: [usize; 3],
        signs: [f64; 3],
        powers: [i32; 3],
    },
}

/// The poses that a law is tried in.
pub const POSES: usize = 6;

impl<S: Number> Pose<S> {
    /// One of [`POSES`]; the positions and turns are exact in every type but for the axes of the third.
    pub fn new(index: usize) -> Self {
        let (x, y, z) = (UnitVec3::X, UnitVec3::Y, UnitVec3::Z);
        let position = v([2.0, -1.0, 3.0]);
        let frame = "the axes are perpendicular";
        match index {
            0 => Self::World,
            1 => Self::Frame(Frame::from_left_up_forward(position, y, z, x).expect(frame)),
            2 => Self::Frame(Frame::from_left_up_forward(position, -x, z, y).expect(frame)),
            3 => Self::Frame(Frame::from_base_and_axis(position, direction([1.0, 2.0, -2.0])).expect(frame)),
            4 => Self::Affine { position, axes: [0, 1, 2], signs: [1.0, 1.0, 1.0], powers: [1, -1, 0] },
            _ => Self::Affine { position, axes: [2, 0, 1], signs: [1.0, -1.0, 1.0], powers: [-1, 0, 1] },
        }
    }

    pub fn place(&self, shape: Shape<S>) -> Shape<S> {
        match *self {
            Self::World => shape,
            Self::Frame(frame) => shape.placed(frame),
            Self::Affine { position, .. } => {
                let images = [0, 1, 2].map(|i| v(self.image([0, 1, 2].map(|j| f64::from(u8::from(i == j))))));
                shape.placed(Affine::new(position, images).expect("powers of two have an inverse"))
            }
        }
    }

    /// A local vector in the world.
    fn image(&self, local: [f64; 3]) -> [f64; 3] {
        match self {
            Self::World => local,
            Self::Frame(frame) => {
                let axes = [frame.left(), frame.up(), frame.forward()].map(UnitVec3::to_f64);
                [0, 1, 2].map(|i| (0..3).map(|j| axes[j][i] * local[j]).sum())
            }
            Self::Affine { axes, signs, powers, .. } => {
                let mut image = [0.0; 3];
                for i in 0..3 {
                    image[axes[i]] = signs[i] * 2.0_f64.powi(powers[i]) * local[i];
                }
                image
            }
        }
    }

    fn position(&self) -> Vec3<S> {
        match self {
            Self::World => Vec3::ZERO,
            Self::Frame(frame) => frame.position(),
            Self::Affine { position, .. } => *position,
        }
    }

    /// The local ray, in the world; rounded. `None` if it does not fit the type.
    pub fn ray(&self, ray: &Ray<S>) -> Option<Ray<S>> {
        if let Self::World = self {
            return Some(*ray);
        }
        let (from, along) = (self.image(ray.origin().to_f64()), self.image(ray.direction().to_f64()));
        let position = self.position().to_f64();
        let origin = Vec3::from_f64([0, 1, 2].map(|i| from[i] + position[i])).ok()?;
        let along = UnitVec3::from_components(normalize(along).map(<S::Unit as UnitScalar>::from_f64)).ok()?;
        Ray::new(origin, along).ok()
    }

    /// A world point in the local frame, in exact numbers.
    pub fn point_to_own_frame(&self, point: &Point) -> Point {
        let position = self.position().to_array().map(S::exact);
        let from: Point = std::array::from_fn(|i| &point[i] - &position[i]);
        match self {
            Self::World => from,
            Self::Frame(frame) => [frame.left(), frame.up(), frame.forward()].map(|axis| {
                let axis = axis.to_array().map(S::exact_unit);
                &(&(&axis[0] * &from[0]) + &(&axis[1] * &from[1])) + &(&axis[2] * &from[2])
            }),
            Self::Affine { axes, signs, powers, .. } => std::array::from_fn(|i| {
                let along = from[axes[i]].scaled(-(powers[i] as isize));
                if signs[i] < 0.0 { -&along } else { along }
            }),
        }
    }

    /// A local normal in the world, of some length.
    pub fn normal_to_world(&self, local: [f64; 3]) -> [f64; 3] {
        match self {
            Self::World | Self::Frame(_) => self.image(local),
            Self::Affine { axes, signs, powers, .. } => {
                let mut normal = [0.0; 3];
                for i in 0..3 {
                    normal[axes[i]] = signs[i] * 2.0_f64.powi(-powers[i]) * local[i];
                }
                normal
            }
        }
    }

    /// The direction turned by quarter turns, without a rounding; `None` for other poses.
    pub fn turned(&self, along: UnitVec3<S>) -> Option<UnitVec3<S>> {
        let Self::Frame(frame) = self else { return None };
        let mut components = [S::Unit::ZERO; 3];
        for (axis, value) in [frame.left(), frame.up(), frame.forward()].into_iter().zip(along.to_array()) {
            for (component, sign) in components.iter_mut().zip(axis.to_array()) {
                if sign == S::Unit::ONE {
                    *component = value;
                } else if sign == -S::Unit::ONE {
                    *component = -value;
                } else if sign != S::Unit::ZERO {
                    return None;
                }
            }
        }
        UnitVec3::from_components(components).ok()
    }

    /// The most that a length of the world grows in the local frame.
    pub fn growth(&self) -> f64 {
        match self {
            Self::World | Self::Frame(_) => 1.0,
            Self::Affine { powers, .. } => powers.iter().map(|power| 2.0_f64.powi(-power)).fold(0.0, f64::max),
        }
    }
}
