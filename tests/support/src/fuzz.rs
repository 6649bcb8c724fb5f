//! What the fuzz targets check, and `tests/promises/src/fuzz_corpus.rs` with them: no bit pattern breaks it.

mod agreement;
mod bytes;
mod known;
mod laws;
mod nff;
mod question;

use agreement::Agreement;
pub use agreement::Verdict;
use bytes::{Bytes, Number};
use fixed::types::extra::{U0, U12, U24, U30, U31, U32, U62};
use fixed::types::{I16F16, I32F32};
use fixed::{FixedI32, FixedI64};
pub use nff::check_nff;
use question::Question;
use raylet::Tier;
use raylet::tier;

/// What became of an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// A constructor refused the bytes, with an error.
    Rejected,
    /// Every tier was asked; so it compares with exact arithmetic in the tier where that went worst.
    Asked(Verdict),
}

/// Makes a solid and a ray from any bytes, asks everything that can be asked, and fails if an answer breaks a promise.
///
/// The first byte is the number type. `question` has the rest.
pub fn check_solid(data: &[u8]) -> Outcome {
    let (which, rest) = data.split_first().map_or((0, data), |(first, rest)| (*first, rest));
    match which % 12 {
        0 => narrow::<f32>(rest),
        1 => wide::<f64>(rest),
        2 => narrow::<I16F16>(rest),
        3 => wide::<I32F32>(rest),
        4 => narrow::<FixedI32<U24>>(rest),
        5 => narrow::<FixedI32<U12>>(rest),
        6 => narrow::<FixedI32<U30>>(rest),
        7 => narrow::<FixedI32<U0>>(rest),
        8 => narrow::<FixedI32<U31>>(rest),
        9 => narrow::<FixedI32<U32>>(rest),
        10 => wide::<FixedI64<U62>>(rest),
        _ => wide::<FixedI64<U0>>(rest),
    }
}

/// The default tier promises 16 units to a float and one to a fixed type, two and a half to a tiny solid.
const STABLE: Agreement = Agreement::Backward { float: 16.0, fixed: 2.5 };

/// The tiers of every number type: a line each.
fn every_tier<S: Number>(question: &Question<S>) -> Vec<Verdict> {
    vec![ask::<S, tier::Stable>(question, STABLE), ask::<S, tier::Fast>(question, Agreement::Lawful)]
}

/// The tiers of `f32` and of the 32-bit fixed types alone: a line each.
fn narrow_tiers<S: Number>(question: &Question<S>) -> Vec<Verdict>
where
    tier::Exact: Tier<S>,
{
    vec![ask::<S, tier::Exact>(question, Agreement::Total)]
}

fn wide<S: Number>(data: &[u8]) -> Outcome {
    asked::<S>(data, every_tier)
}

fn narrow<S: Number>(data: &[u8]) -> Outcome
where
    tier::Exact: Tier<S>,
{
    asked::<S>(data, |question| [every_tier(question), narrow_tiers(question)].concat())
}

fn asked<S: Number>(data: &[u8], ask: impl Fn(&Question<S>) -> Vec<Verdict>) -> Outcome {
    let Ok(question) = Question::from_bytes(&mut Bytes::new(data)) else { return Outcome::Rejected };
    Outcome::Asked(if ask(&question).contains(&Verdict::Tie) { Verdict::Tie } else { Verdict::Same })
}

fn ask<S: Number, T: Tier<S>>(question: &Question<S>, promise: Agreement) -> Verdict {
    question.tier.set((std::any::type_name::<T>(), promise));
    laws::hold::<S, T>(question);
    agreement::agree::<S, T>(question)
}
