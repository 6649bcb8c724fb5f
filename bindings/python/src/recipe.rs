//! A shape by its sizes, made anew in each number type.

use core::fmt;
use raylet::{
    Affine, Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Error, Frame, Plane, Rectangle, Revolved, RoundCone,
    RoundedCuboid, Scalar, Shape, Sphere, Torus, Triangle, Tube, UnitVec3, Vec3,
};

/// The kinds, and how many sizes each has.
const KINDS: [(&str, usize); 23] = [
    ("sphere", 1),
    ("cylinder", 2),
    ("open cylinder", 2),
    ("infinite cylinder", 1),
    ("cone", 2),
    ("open cone", 2),
    ("infinite cone", 1),
    ("double cone", 1),
    ("frustum", 3),
    ("open frustum", 3),
    ("capsule", 2),
    ("round cone", 3),
    ("cuboid", 3),
    ("rounded cuboid", 4),
    ("tube", 3),
    ("torus", 2),
    ("plane", 0),
    ("disc", 1),
    ("annulus", 2),
    ("rectangle", 2),
    ("triangle", 9),
    ("paraboloid", 2),
    ("hyperboloid", 4),
];

#[derive(Clone, Copy)]
enum Turn {
    Not,
    Axis([f64; 3]),
    Quaternion([f64; 4]),
}

/// A shape by what it is, its sizes, and how it is placed.
#[derive(Clone)]
pub struct Recipe {
    kind: &'static str,
    sizes: Vec<f64>,
    position: [f64; 3],
    turn: Turn,
    factors: Option<[f64; 3]>,
}

fn vector<S: Scalar>(v: [f64; 3]) -> Result<Vec3<S>, Error> {
    Ok(Vec3::from_f64(v)?)
}

impl Recipe {
    pub fn new(kind: &str, sizes: &[f64]) -> Result<Self, String> {
        let Some((kind, count)) = KINDS.into_iter().find(|(name, _)| *name == kind) else {
            return Err(format!("there is no kind {kind}; there are {}", KINDS.map(|(name, _)| name).join(", ")));
        };
        if sizes.len() != count {
            return Err(format!("{kind} has {count} sizes, and {} are given", sizes.len()));
        }
        Ok(Self { kind, sizes: sizes.to_vec(), position: [0.0; 3], turn: Turn::Not, factors: None })
    }

    pub fn standing(self, position: [f64; 3], axis: [f64; 3]) -> Self {
        Self { position, turn: Turn::Axis(axis), ..self }
    }
    pub fn turned(self, position: [f64; 3], quaternion: [f64; 4]) -> Self {
        Self { position, turn: Turn::Quaternion(quaternion), ..self }
    }
    pub fn stretched(self, factors: [f64; 3]) -> Self {
        Self { factors: Some(factors), ..self }
    }

    /// The shape, of sizes and a placement that are rounded to the number type.
    pub fn shape<S: Scalar>(&self) -> Result<Shape<S>, Error> {
        let mut numbers = [S::ZERO; 9];
        for (number, size) in numbers.iter_mut().zip(&self.sizes) {
            *number = S::from_f64(*size)?;
        }
        let [a, b, c, d, ..] = numbers;
        let shape = match self.kind {
            "sphere" => Shape::new(Sphere::new(a)?),
            "cylinder" => Shape::new(Cylinder::capped(a, b)?),
            "open cylinder" => Shape::new(Cylinder::open(a, b)?),
            "infinite cylinder" => Shape::new(Cylinder::infinite(a)?),
            "cone" => Shape::new(Cone::capped(a, b)?),
            "open cone" => Shape::new(Cone::open(a, b)?),
            "infinite cone" => Shape::new(Cone::nappe(a)?),
            "double cone" => Shape::new(Cone::double(a)?),
            "frustum" => Shape::new(Cone::frustum(a, b, c)?),
            "open frustum" => Shape::new(Cone::frustum_open(a, b, c)?),
            "capsule" => Shape::new(Capsule::new(a, b)?),
            "round cone" => Shape::new(RoundCone::new(a, b, c)?),
            "cuboid" => Shape::new(Cuboid::new(a, b, c)?),
            "rounded cuboid" => Shape::new(RoundedCuboid::new(a, b, c, d)?),
            "tube" => Shape::new(Tube::new(a, b, c)?),
            "torus" => Shape::new(Torus::new(a, b)?),
            "disc" => Shape::new(Disc::new(a)?),
            "annulus" => Shape::new(Annulus::new(a, b)?),
            "rectangle" => Shape::new(Rectangle::new(a, b)?),
            "triangle" => {
                let [x, y, z] = [0, 3, 6].map(|i| Vec3::new(numbers[i], numbers[i + 1], numbers[i + 2]));
                Shape::new(Triangle::new(x, y, z)?)
            }
            "paraboloid" => Shape::new(Revolved::paraboloid(a, b)?),
            "hyperboloid" => Shape::new(Revolved::hyperboloid(a, b, [c, d])?),
            _ => Shape::new(Plane::new()),
        };
        let frame = match self.turn {
            Turn::Not if self.position == [0.0; 3] && self.factors.is_none() => return Ok(shape),
            Turn::Not => Frame::at(vector(self.position)?)?,
            Turn::Axis(axis) => Frame::from_base_and_axis(vector(self.position)?, UnitVec3::new(vector(axis)?)?)?,
            Turn::Quaternion([x, y, z, w]) => {
                let unit = |c: f64| <S::Unit as raylet::scalar::UnitScalar>::from_f64(c);
                Frame::from_quaternion(vector(self.position)?, [unit(x), unit(y), unit(z), unit(w)])?
            }
        };
        Ok(match self.factors {
            Some(factors) => shape.placed(Affine::stretched(frame, vector(factors)?)?),
            None => shape.placed(frame),
        })
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Shape({:?}, {:?})", self.kind, self.sizes)?;
        match self.turn {
            Turn::Not => {}
            Turn::Axis(axis) => write!(f, ".standing({:?}, {axis:?})", self.position)?,
            Turn::Quaternion(turn) => write!(f, ".turned({:?}, {turn:?})", self.position)?,
        }
        self.factors.map_or(Ok(()), |factors| write!(f, ".stretched({factors:?})"))
    }
}
