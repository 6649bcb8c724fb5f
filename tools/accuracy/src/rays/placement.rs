//! A placement as it is written on the command line: a position, the directions that turn, and factors or a matrix that
//! stretch.

use super::decimal::{self, Decimal, rounded};
use super::words::{Words, list};
use raylet::{Affine, Frame, UnitVec3, Vec3};
use support::exact_types::Exact;
use support::placed;

type Three<'a> = [Decimal<'a>; 3];

/// Every form, as one writes it.
pub const EXAMPLES: [&str; 7] = [
    "at 1 2 3",
    "at 1 2 3 axis 0 0 1",
    "at 1 2 3 forward 1 0 0 up 0 1 1",
    "at 1 2 3 left 1 0 0 up 0 0 1 forward 0 -1 0",
    "at 1 2 3 stretched 2 1 0.5",
    "at 1 2 3 axis 0 0 1 stretched 2 1 0.5",
    "at 1 2 3 x 2 0 0 y 0 1 0 z 0 1 0.5",
];

/// The names, each of which takes three numbers.
const NAMES: [&str; 9] = ["at", "axis", "left", "up", "forward", "stretched", "x", "y", "z"];

/// How the axes of a frame lie: by the constructors of [`Frame`].
#[derive(Clone, Copy, Debug, PartialEq)]
enum Turn<'a> {
    None,
    Axis(Three<'a>),
    Looking { forward: Three<'a>, up: Three<'a> },
    Axes { left: Three<'a>, up: Three<'a>, forward: Three<'a> },
}

/// A placement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement<'a> {
    at: Option<Three<'a>>,
    form: Form<'a>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Form<'a> {
    Frame {
        turn: Turn<'a>,
        stretched: Option<Three<'a>>,
    },
    /// The images of the axes.
    Matrix([Three<'a>; 3]),
}

/// The placement, or what is wrong with the text and what to do; `None` for a solid that is not placed.
pub fn parse(text: &str) -> Result<Option<Placement<'_>>, String> {
    let all = || list(&EXAMPLES);
    let mut words = Words::new(text);
    let mut read: Vec<(&str, Three<'_>)> = vec![];
    while let Some(name) = words.next() {
        if !NAMES.contains(&name) {
            return Err(format!("`{name}` is no part of a placement: give one of{}", all()));
        }
        if read.iter().any(|(read, _)| *read == name) {
            return Err(format!("`{name}` is given twice: remove one"));
        }
        read.push((name, words.numbers(name)?));
    }
    let get = |name: &str| read.iter().find(|(read, _)| *read == name).map(|(_, numbers)| *numbers);
    let (at, stretched) = (get("at"), get("stretched"));
    let turn = match (get("axis"), get("left"), get("up"), get("forward"), [get("x"), get("y"), get("z")]) {
        _ if read.is_empty() => return Ok(None),
        (None, None, None, None, [Some(x), Some(y), Some(z)]) if stretched.is_none() => {
            return Ok(Some(Placement { at, form: Form::Matrix([x, y, z]) }));
        }
        (None, None, None, None, [None, None, None]) => Turn::None,
        (Some(axis), None, None, None, [None, None, None]) => Turn::Axis(axis),
        (None, None, Some(up), Some(forward), [None, None, None]) => Turn::Looking { forward, up },
        (None, Some(left), Some(up), Some(forward), [None, None, None]) => Turn::Axes { left, up, forward },
        _ => {
            let names: Vec<_> = read.iter().map(|(name, _)| *name).collect();
            return Err(format!("{} make no placement together: give one of{}", names.join(", "), all()));
        }
    };
    Ok(Some(Placement { at, form: Form::Frame { turn, stretched } }))
}

/// A direction of the number type.
fn direction<S: Exact>(name: &str, numbers: Three<'_>) -> Result<UnitVec3<S>, String> {
    decimal::direction(numbers).map_err(|error| format!("the vector `{name}` {}", error.predicate()))
}

/// A point or a vector of the number type.
fn vector<S: Exact>(name: &str, numbers: Three<'_>) -> Result<Vec3<S>, String> {
    let rounded = rounded::<S>(numbers).map_err(|error| format!("a number of `{name}` {}", error.predicate()))?;
    Ok(Vec3::from(rounded))
}

impl Placement<'_> {
    /// How tables name it.
    pub fn name(&self) -> &'static str {
        match self.form {
            Form::Frame { turn: Turn::None, stretched: None } => "moved",
            Form::Frame { stretched: None, .. } => "turned",
            Form::Frame { .. } | Form::Matrix(_) => "stretched",
        }
    }

    /// In a number type; or why it does not hold it, in the library's words.
    pub fn rounded<S: Exact>(&self) -> Result<placed::Placement<S>, String> {
        let at = self.at.map_or(Ok(Vec3::ZERO), |at| vector("at", at))?;
        let (turn, stretched) = match self.form {
            Form::Frame { turn, stretched } => (turn, stretched),
            Form::Matrix([x, y, z]) => {
                let axes = [vector("x", x)?, vector("y", y)?, vector("z", z)?];
                return Ok(placed::Placement::Matrix(Affine::new(at, axes).map_err(|error| error.to_string())?));
            }
        };
        let frame = match turn {
            Turn::None => Frame::at(at),
            Turn::Axis(axis) => Frame::from_base_and_axis(at, direction("axis", axis)?),
            Turn::Looking { forward, up } => Frame::looking(at, direction("forward", forward)?, direction("up", up)?),
            Turn::Axes { left, up, forward } => Frame::from_left_up_forward(
                at,
                direction("left", left)?,
                direction("up", up)?,
                direction("forward", forward)?,
            ),
        };
        let frame = frame.map_err(|error| error.to_string())?;
        Ok(match stretched {
            None => placed::Placement::Frame(frame),
            Some(factors) => placed::Placement::Stretched(frame, vector("stretched", factors)?.to_array()),
        })
    }
}
