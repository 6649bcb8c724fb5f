//! Placed primitives: the shape, and the exact way from the world into its frame.

use super::exact_types::Exact;
use super::oracle::{self, Dyadic};
use super::random::{Random, add, scale};
use super::subject::Subject;
use super::workload::Workload;
use raylet::{Affine, Frame, Ray, Shape, UnitVec3, Vec3};

/// How a primitive is placed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Placing {
    /// By a frame within this distance of the world's origin, turned anyhow.
    Framed(f64),
    /// By a matrix that stretches each axis of such a frame (nearby) by its own factor, from the inverse of this one to it.
    Stretched(f64),
}

pub const PLACINGS: [Placing; 5] = [
    Placing::Framed(4.0),
    Placing::Framed(1_000.0),
    Placing::Stretched(4.0),
    Placing::Stretched(100.0),
    Placing::Stretched(1_000.0),
];

impl Placing {
    pub fn name(self) -> String {
        match self {
            Self::Framed(distance) => format!("framed within {distance}"),
            Self::Stretched(factor) => format!("stretched by 1/{factor} to {factor}"),
        }
    }

    /// A number of the type between the factor's inverse and the factor, evenly in its logarithm.
    fn factor<S: Exact>(factor: f64, random: &mut Random) -> S {
        let value = libm::pow(factor, random.between(-1.0, 1.0));
        S::from_f64(value).expect("a factor that every tested type holds")
    }
}

/// A primitive somewhere.
pub struct Placed<S: Exact> {
    pub shape: Shape<S>,
    /// Images of the local axes, in `f64`.
    axes: [[f64; 3]; 3],
    position: [f64; 3],
    largest: f64,
    /// The frame, and what its axes are stretched by.
    frame: Frame<S>,
    factors: Option<[S; 3]>,
    /// The rows of the inverse and the position, exactly (those of a stretched one to 256 bits).
    rows: [[Dyadic; 3]; 3],
    exact_position: [Dyadic; 3],
}

/// `1 / value` to 256 bits.
fn reciprocal(value: &Dyadic) -> Dyadic {
    let one = dashu::integer::IBig::ONE << 320_usize;
    Dyadic::new(one / &value.mantissa, -value.exponent - 320)
}

impl<S: Exact> Placed<S> {
    /// `None` if the placing does not fit the type.
    pub fn new(subject: &Subject<S>, placing: Placing, random: &mut Random) -> Option<Self> {
        let distance = match placing {
            Placing::Framed(distance) => distance,
            Placing::Stretched(_) => 4.0,
        };
        let position = Vec3::<S>::from_f64(scale(random.direction(), distance * random.unit()))?;
        let axis = UnitVec3::new(Vec3::<S>::from_f64(random.direction())?)?;
        // To the last bit of the type's directions: a turn from the coordinates' bits would be too round.
        let frame = Frame::looking(position, UnitVec3::new(Vec3::from_f64(random.direction())?)?, axis).ok()?;
        let stored = [frame.right(), frame.up(), frame.forward()];
        let exact = stored.map(|axis| axis.to_array().map(S::exact_unit));
        let base = Self {
            shape: subject.shape.placed(frame),
            axes: stored.map(UnitVec3::to_f64),
            position: position.to_f64(),
            largest: 1.0,
            frame,
            factors: None,
            rows: exact.clone(),
            exact_position: position.to_array().map(S::exact),
        };
        let Placing::Stretched(factor) = placing else {
            return Some(base);
        };
        let factors = [(); 3].map(|()| Placing::factor::<S>(factor, random));
        let affine = Affine::stretched(frame, Vec3::new(factors[0], factors[1], factors[2])).ok()?;
        let mut rows = exact;
        for (row, factor) in rows.iter_mut().zip(factors) {
            let by = reciprocal(&factor.exact());
            *row = row.each_ref().map(|component| component * &by);
        }
        let stretched = |i: usize| scale(base.axes[i], factors[i].to_f64());
        Some(Self {
            shape: subject.shape.placed(affine),
            axes: [stretched(0), stretched(1), stretched(2)],
            largest: factors.iter().map(|factor| factor.to_f64()).fold(1.0, f64::max),
            factors: Some(factors),
            rows,
            ..base
        })
    }

    /// The frame that it stands in, not stretched.
    pub fn frame(&self) -> Frame<S> {
        self.frame
    }

    /// What each of the frame's axes is stretched by.
    pub fn factors(&self) -> Option<[S; 3]> {
        self.factors
    }

    /// A ray at a point well inside, from 3 to 8 sizes of the solid away.
    pub fn ray(&self, subject: &Subject<S>, random: &mut Random) -> Option<Ray<S>> {
        let local = subject.inner_point(random);
        let image = (0..3).fold(self.position, |sum, i| add(sum, scale(self.axes[i], local[i])));
        let (origin, direction) = Workload::aimed(image, random.direction(), self.largest * random.between(3.0, 8.0));
        let direction = direction.map(<S::Unit as raylet::scalar::UnitScalar>::from_f64);
        Ray::new(Vec3::from_f64(origin)?, UnitVec3::from_components(direction)?).ok()
    }

    /// The ray's line in the primitive's frame, exactly.
    pub fn line(&self, ray: &Ray<S>) -> oracle::Line {
        let dot = |a: &[Dyadic; 3], b: &[Dyadic; 3]| &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2]);
        let (o, d) = (ray.origin().to_array().map(S::exact), ray.direction().to_array().map(S::exact_unit));
        let from_position = [0, 1, 2].map(|i| &o[i] - &self.exact_position[i]);
        oracle::Line::new(
            self.rows.each_ref().map(|row| dot(row, &from_position)),
            self.rows.each_ref().map(|row| dot(row, &d)),
        )
    }
}
