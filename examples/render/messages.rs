//! What is wrong with a scene file, in the words of whoever runs the program: its options, and the limits of what they chose.

use crate::arithmetic::Number;
use raylet::Scalar;
use raylet::scene::CameraError;
use raylet::scene::nff::{NffError, Reason, Scale};

/// Where the file is at fault, why, and what to do.
pub(crate) fn fault<S: Scalar>(file: &str, error: &NffError, number: Number, scale: Scale) -> String {
    let (place, reason) = (error.place, error.reason);
    format!("{file}, line {}, column {}: {}", place.line, place.column, because::<S>(reason, number, scale))
}

fn because<S: Scalar>(reason: Reason, number: Number, scale: Scale) -> String {
    let wider = number.wider();
    let or_wider = if wider.is_empty() { String::new() } else { format!(", or {wider}") };
    match reason {
        Reason::BeyondBudget { what } => {
            let limit = readable(S::BUDGET.coordinate.to_f64() / f64::from(scale.power()).exp2());
            let smaller = if S::RELATIVE || scale == Scale::LEAST {
                "move everything closer to the origin"
            } else {
                "give --scale auto, or a smaller --scale"
            };
            format!("{what} is beyond {limit}, the most that {number} holds at --scale {scale}: {smaller}{or_wider}")
        }
        Reason::BeyondType { what } => {
            let limit = readable(S::BUDGET.distance.to_f64().round());
            format!("{what} is beyond {limit}, the most that {number} holds: give a smaller number{or_wider}")
        }
        Reason::Proportions => format!(
            "the cone or cylinder is too long, or too wide for its length, for {number}: give it other proportions{or_wider}"
        ),
        Reason::Camera(CameraError::Position) => format!("the camera is too far away for {number}{or_wider}"),
        Reason::Camera(CameraError::Target) => {
            format!(
                "the view's from and at are the same point, or nearer to each other than {number} can tell: move one"
            )
        }
        Reason::EndsBeforeCorners { corners } => {
            format!("the file ends before {corners} corners: give as many as the polygon has")
        }
        Reason::Ended { what } => format!("the file ends where {what} should be: complete the entity"),
        Reason::NoView => "the file ends without a view: add a \"v\" entity".into(),
        other => other.to_string(),
    }
}

/// A number in few digits.
fn readable(number: f64) -> String {
    if (1e-3..1e12).contains(&number) { number.to_string() } else { format!("{number:.1e}") }
}
