//! The crate's numbers, rays and primitives as the oracle's exact ones, bit for bit.

use super::oracle::{self, Dyadic};
use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedI64};
use raylet::{Crossing, Departure, Leaving, Part, Ray, Scalar};

/// A number type whose values the oracle can take exactly.
pub trait Exact: Scalar {
    /// The name in tables.
    fn name() -> String;
    /// The exact value.
    fn exact(self) -> Dyadic;
    /// The exact value of a component of a direction.
    fn exact_unit(unit: Self::Unit) -> Dyadic;
    /// One unit in the last place at the exact value: a float's spacing there, or the fixed type's unit.
    fn unit_at(exact: &oracle::Root) -> Dyadic;
    /// The stored bits, as tests write them down.
    fn bits(self) -> String;
    /// Those of a component of a direction.
    fn unit_bits(unit: Self::Unit) -> String;
    /// The fraction bits of a component of a direction next to 1.
    const UNIT_BITS: isize;
    /// A decimal number as a component of a direction, rounded once; `None` if it is none, or beyond the component's
    /// type.
    fn parse_unit(text: &str) -> Option<Self::Unit>;
}

impl Exact for f32 {
    fn name() -> String {
        "f32".into()
    }
    fn exact(self) -> Dyadic {
        oracle::exact_f32(self)
    }
    fn exact_unit(unit: f32) -> Dyadic {
        oracle::exact_f32(unit)
    }
    fn unit_at(exact: &oracle::Root) -> Dyadic {
        exact.ulp_f32()
    }
    fn bits(self) -> String {
        format!("{:#x}", self.to_bits())
    }
    fn unit_bits(unit: f32) -> String {
        unit.bits()
    }
    const UNIT_BITS: isize = 23;
    fn parse_unit(text: &str) -> Option<f32> {
        <f32 as Scalar>::parse(text)
    }
}

impl Exact for f64 {
    fn name() -> String {
        "f64".into()
    }
    fn exact(self) -> Dyadic {
        oracle::exact_f64(self)
    }
    fn exact_unit(unit: f64) -> Dyadic {
        oracle::exact_f64(unit)
    }
    fn unit_at(exact: &oracle::Root) -> Dyadic {
        exact.ulp_f64()
    }
    fn bits(self) -> String {
        format!("{:#x}", self.to_bits())
    }
    fn unit_bits(unit: f64) -> String {
        unit.bits()
    }
    const UNIT_BITS: isize = 52;
    fn parse_unit(text: &str) -> Option<f64> {
        <f64 as Scalar>::parse(text)
    }
}

impl<F: LeEqU32 + Send + Sync + 'static> Exact for FixedI32<F> {
    fn name() -> String {
        format!("I{}F{}", 32 - F::U32, F::U32)
    }
    fn exact(self) -> Dyadic {
        oracle::exact_fixed(self.to_bits().into(), F::U32)
    }
    fn exact_unit(unit: Self::Unit) -> Dyadic {
        oracle::exact_fixed(unit.to_bits().into(), 30)
    }
    fn unit_at(_: &oracle::Root) -> Dyadic {
        Dyadic::power_of_two(-(F::I32 as isize))
    }
    fn bits(self) -> String {
        self.to_bits().to_string()
    }
    fn unit_bits(unit: Self::Unit) -> String {
        unit.to_bits().to_string()
    }
    const UNIT_BITS: isize = 30;
    fn parse_unit(text: &str) -> Option<Self::Unit> {
        let scaled = Self::parse_scaled(text, 30 - F::I32)?;
        Some(Self::Unit::from_bits(scaled.to_bits()))
    }
}

impl<F: LeEqU64 + Send + Sync + 'static> Exact for FixedI64<F> {
    fn name() -> String {
        format!("I{}F{}", 64 - F::U32, F::U32)
    }
    fn exact(self) -> Dyadic {
        oracle::exact_fixed(self.to_bits().into(), F::U32)
    }
    fn exact_unit(unit: Self::Unit) -> Dyadic {
        oracle::exact_fixed(unit.to_bits().into(), 62)
    }
    fn unit_at(_: &oracle::Root) -> Dyadic {
        Dyadic::power_of_two(-(F::I32 as isize))
    }
    fn bits(self) -> String {
        self.to_bits().to_string()
    }
    fn unit_bits(unit: Self::Unit) -> String {
        unit.to_bits().to_string()
    }
    const UNIT_BITS: isize = 62;
    fn parse_unit(text: &str) -> Option<Self::Unit> {
        let scaled = Self::parse_scaled(text, 62 - F::I32)?;
        Some(Self::Unit::from_bits(scaled.to_bits()))
    }
}

/// The ray's line, exactly as stored.
pub fn exact_line<S: Exact>(ray: &Ray<S>) -> oracle::Line {
    oracle::Line::new(ray.origin().to_array().map(S::exact), ray.direction().to_array().map(S::exact_unit))
}

/// What the oracle expects in the ray's range; of a ray that departs, as if it did not.
pub fn expected<S: Exact>(solid: &oracle::Solid, ray: &Ray<S>) -> oracle::InRange {
    expected_of(solid, &exact_line(ray), &ray.without_departure())
}

/// What the oracle expects in the ray's range, given its line as the solid sees it.
pub fn expected_of<S: Exact>(solid: &oracle::Solid, line: &oracle::Line, ray: &Ray<S>) -> oracle::InRange {
    let answer = match ray.departure() {
        None => oracle::solve(solid, line),
        Some(Departure { part, leaving, .. }) => {
            let leaving = match leaving {
                Leaving::Outwards => oracle::Leaving::Outwards,
                Leaving::Inwards => oracle::Leaving::Inwards,
            };
            oracle::solve_departing(solid, line, oracle_part(part), leaving)
        }
    };
    oracle::hits_in_range(&answer, &ray.range().start().exact(), Some(&ray.range().end().exact()))
}

/// The same part in the oracle's words.
pub fn oracle_part(part: Part) -> oracle::Part {
    match part {
        Part::Base => oracle::Part::Base,
        Part::Top => oracle::Part::Top,
        Part::Left => oracle::Part::Left,
        Part::Right => oracle::Part::Right,
        Part::Back => oracle::Part::Back,
        Part::Front => oracle::Part::Front,
        Part::Inner => oracle::Part::Inner,
        _ => part.facet_number().map_or(oracle::Part::Side, |number| oracle::Part::Facet(number as u8)),
    }
}

pub fn same_part(part: Part, exact: oracle::Part) -> bool {
    oracle_part(part) == exact
}

pub fn same_crossing(crossing: Crossing, exact: oracle::ExpectedCrossing) -> bool {
    matches!(
        (crossing, exact),
        (Crossing::Enter, oracle::ExpectedCrossing::Enter)
            | (Crossing::Exit, oracle::ExpectedCrossing::Exit)
            | (Crossing::Touch, oracle::ExpectedCrossing::Touch)
    )
}
