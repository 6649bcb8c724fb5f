//! What is wrong with a scene file, in the words of whoever runs the program: its options, and the limits of what they
//! chose.

use crate::arithmetic::Number;
use crate::instead;
use crate::options::{Options, Units};
use raylet::Scalar;
use raylet::scene::CameraError;
use raylet::scene::nff::{NffError, Reason, Scale};

/// Where the file is at fault, why, and what to do.
pub(crate) fn fault<S: Scalar>(
    file: &str,
    text: &str,
    error: &NffError,
    options: &Options,
    number: Number,
    scale: Scale,
) -> String {
    let NffError { place, reason } = *error;
    // UTF-16 has zeros between its letters, and so has nearly every picture or program.
    if matches!(reason, Reason::NotText | Reason::UnknownEntity) && text.contains('\0') {
        return format!("{file} is no plain text: give a scene in the Neutral File Format (.nff), saved as UTF-8");
    }
    let because = because::<S>(text, reason, options, number, scale);
    format!("{file}, line {}, column {}: {because}", place.line, place.column)
}

fn because<S: Scalar>(text: &str, reason: Reason, options: &Options, number: Number, scale: Scale) -> String {
    let or_wider =
        if instead::may_help(reason) { instead::another_number(text, options, number) } else { String::new() };
    match reason {
        Reason::BeyondBudget { what } => {
            let limit = readable(S::BUDGET.coordinate.to_f64() / f64::from(scale.power()).exp2());
            let is_chosen = options.scale != Units::Fitting;
            let smaller = if is_chosen && instead::fits::<S>(text) {
                "give --scale auto, or a smaller --scale"
            } else {
                "move everything closer to the origin"
            };
            format!("{what} is beyond {limit}, the most that {number} holds at --scale {scale}: {smaller}{or_wider}")
        }
        Reason::BeyondType { what } => {
            let limit = readable(S::BUDGET.distance.to_f64().round());
            format!("{what} is beyond {limit}, the most that {number} holds: give a smaller number{or_wider}")
        }
        Reason::Proportions => format!(
            "the cone or cylinder is too long, or too wide for its length, for {number}: give it other \
             proportions{or_wider}"
        ),
        Reason::Camera(CameraError::Position) => {
            format!("the camera is too far away for {number}: move it closer to the origin{or_wider}")
        }
        Reason::Camera(CameraError::Target) => {
            format!(
                "the view's from and at are the same point, or nearer to each other than {number} can tell: move \
                 one{or_wider}"
            )
        }
        Reason::Camera(CameraError::Angle) => {
            format!(
                "the view's angle must be more than 0 and less than 180 degrees, and not too near to either for \
                 {number}: give one such as 45{or_wider}"
            )
        }
        Reason::Camera(error) => format!("{error}{or_wider}"),
        Reason::NotACount { what } => {
            let most = if what.contains("resolution") { 65_535 } else { u32::MAX };
            format!("{what} should be a whole number from 1 to {most}")
        }
        Reason::Color { what } => format!("{what} is outside 0 to 1: give red, green and blue from 0 to 1, not to 255"),
        Reason::TooFewCorners => "a polygon has at least three corners: give more, or remove it".into(),
        Reason::EndsBeforeCorners { corners } => {
            format!("the file ends before {corners} corners: give as many as the polygon has")
        }
        Reason::Ended { what } => format!("the file ends where {what} should be: complete the entity"),
        Reason::NoView => {
            "the file ends without a view: add one, such as \"v from 0 0 9 at 0 0 0 up 0 1 0 angle 45 resolution 160 \
             120\""
                .into()
        }
        other => other.to_string(),
    }
}

/// A number in few digits.
fn readable(number: f64) -> String {
    if (1e-3..1e12).contains(&number) { number.to_string() } else { format!("{number:.1e}") }
}
