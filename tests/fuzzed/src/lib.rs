//! What the fuzz targets check, and `tests/corpus.rs` with them: no bit pattern breaks it.

mod agreement;
mod bytes;
mod known;
mod laws;
mod nff;
mod query;

use agreement::Agreement;
pub use agreement::Verdict;
use bytes::{Bytes, Number};
use fixed::FixedI32;
use fixed::types::extra::{U12, U24};
use fixed::types::{I16F16, I32F32};
pub use nff::check_nff;
use query::Query;
use raylet::Tier;
use raylet::tier;

/// What became of an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// A constructor refused the bytes, with an error.
    Rejected,
    /// Every tier was tested; this is how it compares with exact arithmetic in the tier where that went worst.
    Tested(Verdict),
}

/// Makes a solid and a ray from any bytes, calls every query and function of the surface, and fails if an answer breaks
/// a promise.
///
/// The first byte is the number type. `query` has the rest.
pub fn check_solid(data: &[u8]) -> Outcome {
    let (which, rest) = data.split_first().map_or((0, data), |(first, rest)| (*first, rest));
    match which % 12 {
        0 => narrow::<f32>(rest),
        1 => wide::<f64>(rest),
        2 => narrow::<I16F16>(rest),
        3 => wide::<I32F32>(rest),
        4 => narrow::<FixedI32<U24>>(rest),
        5 => narrow::<FixedI32<U12>>(rest),
        which => rare(which, rest),
    }
}

/// The types that the quick form of the tests leaves to the long one.
#[cfg(feature = "every-type")]
fn rare(which: u8, data: &[u8]) -> Outcome {
    use fixed::FixedI64;
    use fixed::types::extra::{U0, U30, U31, U32, U62};
    match which {
        6 => narrow::<FixedI32<U30>>(data),
        7 => narrow::<FixedI32<U0>>(data),
        8 => narrow::<FixedI32<U31>>(data),
        9 => narrow::<FixedI32<U32>>(data),
        10 => wide::<FixedI64<U62>>(data),
        _ => wide::<FixedI64<U0>>(data),
    }
}

/// Types of the same widths in their place.
#[cfg(not(feature = "every-type"))]
fn rare(which: u8, data: &[u8]) -> Outcome {
    match which {
        6..=9 => narrow::<I16F16>(data),
        _ => wide::<I32F32>(data),
    }
}

/// The default tier promises 16 units to a float and one to a fixed type, two and a half to a tiny solid.
const STABLE: Agreement = Agreement::Backward { float: 16.0, fixed: 2.5 };

/// The tiers of every number type: a line each.
fn every_tier<S: Number>(query: &Query<S>) -> Vec<Verdict> {
    vec![
        test_tier::<S, tier::Stable>(query, STABLE),
        test_tier::<S, tier::Fast>(query, Agreement::Lawful),
        test_tier::<S, tier::Plain>(query, Agreement::Lawful),
    ]
}

/// The tiers of `f32` and of the 32-bit fixed types alone: a line each.
fn narrow_tiers<S: Number>(query: &Query<S>) -> Vec<Verdict>
where
    tier::Exact: Tier<S>,
{
    vec![test_tier::<S, tier::Exact>(query, Agreement::Total)]
}

fn wide<S: Number>(data: &[u8]) -> Outcome {
    tested::<S>(data, every_tier)
}

fn narrow<S: Number>(data: &[u8]) -> Outcome
where
    tier::Exact: Tier<S>,
{
    tested::<S>(data, |query| [every_tier(query), narrow_tiers(query)].concat())
}

fn tested<S: Number>(data: &[u8], tiers: impl Fn(&Query<S>) -> Vec<Verdict>) -> Outcome {
    let Ok(query) = Query::from_bytes(&mut Bytes::new(data)) else { return Outcome::Rejected };
    Outcome::Tested(if tiers(&query).contains(&Verdict::Tie) { Verdict::Tie } else { Verdict::Same })
}

fn test_tier<S: Number, T: Tier<S>>(query: &Query<S>, promise: Agreement) -> Verdict {
    query.tier.set((std::any::type_name::<T>(), promise));
    laws::hold::<S, T>(query);
    agreement::agree::<S, T>(query)
}
