//! Placed primitives: the shape, and the exact way from the world into its frame.

use super::exact_types::Exact;
use super::oracle::{self, Dyadic, Solid};
use super::random::{Random, add, dot, normalize, scale};
use super::subject::Subject;
use super::workload::{Line, Workload};
use raylet::{Affine, Frame, FrameError, Ray, Shape, UnitVec3, Vec3};

/// How a primitive is placed: a half of the placements within 4 of the world's origin, the others within 1,000 and
/// 1,000,000, or as far as the number type reaches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Placing {
    /// By a frame that only moves it.
    Moved,
    /// By a frame, turned anyhow.
    Turned,
    /// By a matrix that stretches each axis of such a frame by its own factor, from the inverse of this one to it.
    Stretched(f64),
}

pub const PLACINGS: [Placing; 4] =
    [Placing::Moved, Placing::Turned, Placing::Stretched(30.0), Placing::Stretched(1_000.0)];

/// How a primitive that is not placed is told in tables.
pub const UNPLACED: &str = "-";

impl Placing {
    pub fn name(self) -> String {
        match self {
            Self::Moved => "moved".into(),
            Self::Turned => "turned".into(),
            Self::Stretched(factor) => format!("stretched by 1/{factor} to {factor}"),
        }
    }

    /// True if tiers promise something of solids that are placed so: of factors of a ratio up to 1,000.
    pub fn is_promised(self) -> bool {
        !matches!(self, Self::Stretched(factor) if factor * factor > 1_000.0)
    }

    /// True if there is a row of the workload at solids that are placed so.
    pub fn has(self, workload: Workload) -> bool {
        match self {
            Self::Moved | Self::Turned => true,
            Self::Stretched(_) if self.is_promised() => matches!(
                workload,
                Workload::Benign | Workload::Away(_) | Workload::Grazing(_) | Workload::NearPlane(_) | Workload::Rims
            ),
            Self::Stretched(_) => workload == Workload::Benign,
        }
    }

    /// A position: its coordinates are rounded to the type.
    fn position<S: Exact>(random: &mut Random) -> Option<Vec3<S>> {
        let farthest = (S::BUDGET.coordinate.to_f64() / 4.0).min(1e6);
        let distance = random.pick(&[4.0, 4.0, farthest.min(1_000.0), farthest]);
        Vec3::from_f64(scale(random.direction(), distance * random.unit())).ok()
    }

    /// A frame anywhere.
    fn frame<S: Exact>(self, random: &mut Random) -> Option<Frame<S>> {
        let position = Self::position(random)?;
        if self == Self::Moved {
            return Frame::at(position).ok();
        }
        // To the last bit of the type's directions: a turn from the coordinates' bits would be too round.
        let [axis, forward] = [random.direction(), random.direction()];
        Frame::looking(
            position,
            UnitVec3::new(Vec3::from_f64(forward).ok()?).ok()?,
            UnitVec3::new(Vec3::from_f64(axis).ok()?).ok()?,
        )
        .ok()
    }

    /// A number of the type between the factor's inverse and the factor, evenly in its logarithm.
    fn factor<S: Exact>(factor: f64, random: &mut Random) -> S {
        let value = libm::pow(factor, random.between(-1.0, 1.0));
        S::from_f64(value).expect("a factor that every tested type holds")
    }
}

/// By what a primitive is placed.
#[derive(Clone, Copy)]
pub enum Placement<S: Exact> {
    Frame(Frame<S>),
    /// A frame, each axis stretched by a factor.
    Stretched(Frame<S>, [S; 3]),
    Matrix(Affine<S>),
}

impl<S: Exact> Placement<S> {
    pub fn position(&self) -> Vec3<S> {
        match self {
            Self::Frame(frame) | Self::Stretched(frame, _) => frame.position(),
            Self::Matrix(affine) => affine.position(),
        }
    }
}

/// A primitive somewhere.
pub struct Placed<S: Exact> {
    pub shape: Shape<S>,
    pub placement: Placement<S>,
    /// Images of the local axes, in `f64`.
    axes: [[f64; 3]; 3],
    position: [f64; 3],
    /// The largest factor that it is stretched by, or 1.
    pub largest: f64,
    /// The smallest one, or 1.
    pub smallest: f64,
    /// The rows of the way into the frame, and the position, as they are stored.
    rows: [[Dyadic; 3]; 3],
    exact_position: [Dyadic; 3],
}

impl<S: Exact> Placed<S> {
    /// `None` if the placing does not fit the type.
    pub fn new(subject: &Subject<S>, placing: Placing, random: &mut Random) -> Option<Self> {
        let frame = placing.frame::<S>(random)?;
        let placement = match placing {
            Placing::Moved | Placing::Turned => Placement::Frame(frame),
            Placing::Stretched(factor) => {
                Placement::Stretched(frame, [(); 3].map(|()| Placing::factor::<S>(factor, random)))
            }
        };
        Self::by(&subject.shape, &subject.solid, placement).ok()
    }

    /// A shape, and the solid that it is, placed by this.
    pub fn by(shape: &Shape<S>, solid: &Solid, placement: Placement<S>) -> Result<Self, FrameError> {
        let (axes, rows, shape) = match placement {
            Placement::Frame(frame) => {
                let exact = frame.axes().map(|axis| axis.to_array().map(S::exact_unit));
                // A ball in a frame has no axes: a turned ball is a ball, although stored axes are orthogonal only to
                // their last bits.
                let is_ball = matches!(solid, Solid::Sphere { .. });
                let none = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|row| row.map(Dyadic::from));
                (frame.axes().map(UnitVec3::to_f64), if is_ball { none } else { exact }, shape.placed(frame))
            }
            Placement::Stretched(frame, factors) => {
                let affine = Affine::stretched(frame, Vec3::from(factors))?;
                let stretched = |i: usize| scale(frame.axes()[i].to_f64(), factors[i].to_f64());
                ([stretched(0), stretched(1), stretched(2)], exact_rows(&affine), shape.placed(affine))
            }
            Placement::Matrix(affine) => (affine.axes().map(Vec3::to_f64), exact_rows(&affine), shape.placed(affine)),
        };
        let factors = match placement {
            Placement::Frame(_) => [1.0; 3],
            Placement::Stretched(_, factors) => factors.map(S::to_f64),
            Placement::Matrix(_) => axes.map(|axis| dot(axis, axis).sqrt()),
        };
        let position = placement.position();
        Ok(Self {
            shape,
            placement,
            axes,
            position: position.to_f64(),
            largest: factors.into_iter().fold(1.0, f64::max),
            smallest: factors.into_iter().fold(1.0, f64::min),
            rows,
            exact_position: position.to_array().map(S::exact),
        })
    }

    /// The next ray of the workload at the subject where it stands; `None` where the workload has no sense for it, or
    /// the draw does not fit the type. It is rounded in the world: from far away, what the workload says of it is only
    /// what it was drawn from.
    pub fn ray(&self, subject: &Subject<S>, workload: Workload, random: &mut Random) -> Option<Ray<S>> {
        let ray = self.ray_along(workload.line(subject, random)?)?;
        workload.from_there(&self.shape, ray, random)
    }

    /// The ray along a line of the primitive's frame, given by its origin and direction; `None` if it does not fit the
    /// type.
    pub fn ray_along(&self, (origin, direction): Line) -> Option<Ray<S>> {
        let image = |v: [f64; 3]| (0..3).fold([0.0; 3], |sum, i| add(sum, scale(self.axes[i], v[i])));
        Workload::rounded((add(self.position, image(origin)), normalize(image(direction))))
    }

    /// The ray's line in the primitive's frame, exactly.
    pub fn line(&self, ray: &Ray<S>) -> oracle::Line {
        self.line_along(&ray.origin().to_array().map(S::exact), &ray.direction().to_array().map(S::exact_unit))
    }

    /// The line from a point in a direction of any length, in the primitive's frame, exactly.
    pub fn line_along(&self, o: &[Dyadic; 3], d: &[Dyadic; 3]) -> oracle::Line {
        let dot = |a: &[Dyadic; 3], b: &[Dyadic; 3]| &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2]);
        let from_position = [0, 1, 2].map(|i| &o[i] - &self.exact_position[i]);
        oracle::Line::new(
            self.rows.each_ref().map(|row| dot(row, &from_position)),
            self.rows.each_ref().map(|row| dot(row, d)),
        )
    }
}

/// The rows of an inverse, as they are stored.
fn exact_rows<S: Exact>(affine: &Affine<S>) -> [[Dyadic; 3]; 3] {
    affine.inverse().map(|(row, exponent)| row.map(|c| S::exact_unit(c).scaled(exponent as isize)))
}
