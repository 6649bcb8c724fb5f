//! What to take instead of a number type or scale that does not hold a file: only what was tried on it.

use crate::arithmetic::{Arithmetic, Number, TierName};
use crate::load;
use crate::options::{Options, Units};
use fixed::types::{I16F16, I32F32};
use raylet::Scalar;
use raylet::scene::nff::Reason;

/// Whether another number type, or the same one at another scale, may hold what is wrong here.
pub(crate) const fn may_help(reason: Reason) -> bool {
    matches!(reason, Reason::BeyondBudget { .. } | Reason::BeyondType { .. } | Reason::Proportions | Reason::Camera(_))
}

/// The number types that hold the file, as a last alternative: `, or -n f32 or f64`; empty if none does.
pub(crate) fn another_number(text: &str, options: &Options, number: Number) -> String {
    let held: Vec<Number> =
        number.wider().iter().copied().filter(|number| holds(*number, text, options.scale)).collect();
    if held.is_empty() {
        return String::new();
    }
    if !options.compare.is_empty() {
        return format!(", or compare {} in place of {number}", one_of(&held));
    }
    let has_tier = |number: &Number| Arithmetic { number: *number, tier: options.tier }.checked().is_ok();
    let of_tier: Vec<Number> = held.iter().copied().filter(has_tier).collect();
    if of_tier.is_empty() {
        format!(", or -n {} with -t {}", one_of(&held), TierName::default())
    } else {
        format!(", or -n {}", one_of(&of_tier))
    }
}

/// True if the number type holds the file at the scale that fits it best.
pub(crate) fn fits<S: Scalar>(text: &str) -> bool {
    is_held::<S>(text, Units::Fitting)
}

fn holds(number: Number, text: &str, units: Units) -> bool {
    match number {
        Number::F32 => is_held::<f32>(text, units),
        Number::F64 => is_held::<f64>(text, units),
        Number::I16f16 => is_held::<I16F16>(text, units),
        Number::I32f32 => is_held::<I32F32>(text, units),
        #[cfg(feature = "every-type")]
        Number::I20f12 => is_held::<fixed::types::I20F12>(text, units),
        #[cfg(feature = "every-type")]
        Number::I8f24 => is_held::<fixed::types::I8F24>(text, units),
    }
}

fn is_held<S: Scalar>(text: &str, units: Units) -> bool {
    match load::parse::<S>(text, units, None) {
        Ok(loaded) => loaded.scene().is_ok(),
        // What else is wrong with the file is wrong in every number type.
        Err((error, _)) => !may_help(error.reason),
    }
}

/// `f32`, `f32 or f64`, `i32f32, f32 or f64`.
fn one_of(numbers: &[Number]) -> String {
    let names: Vec<String> = numbers.iter().map(Number::to_string).collect();
    match &names[..] {
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => names.concat(),
    }
}
