//! Decimal numbers as they are written, so that each number type rounds the text itself, once.

use raylet::{Scalar, UnitVec3, ValueError};
use support::exact_types::Exact;
use support::oracle::Dyadic;

/// A decimal number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decimal<'a> {
    text: &'a str,
    /// The nearest double: for directions that are normalised before they are rounded, and for comparisons.
    pub double: f64,
}

impl<'a> Decimal<'a> {
    /// What is wrong with the text, and what to do, if it is no decimal number.
    pub fn parse(text: &'a str) -> Result<Self, String> {
        if let Some(double) = <f64 as Scalar>::parse(text) {
            return Ok(Self { text, double });
        }
        match text.parse::<f64>() {
            Ok(number) if !number.is_finite() && text.contains(|c: char| c.is_ascii_digit()) => {
                Err(format!("{text} is beyond every number type: give a smaller one"))
            }
            Ok(_) => Err(format!("`{text}` is not finite: give a decimal number such as -12.5 or 1.5e-3")),
            Err(_) => Err(format!("`{text}` is not a number: give a decimal number such as -12.5 or 1.5e-3")),
        }
    }

    /// The nearest number of a type.
    pub fn rounded<S: Scalar>(&self) -> Result<S, ValueError> {
        S::parse(self.text).ok_or(ValueError::BeyondType)
    }
}

/// Three coordinates in a number type.
pub fn rounded<S: Scalar>([x, y, z]: [Decimal<'_>; 3]) -> Result<[S; 3], ValueError> {
    Ok([x.rounded()?, y.rounded()?, z.rounded()?])
}

/// The nearest doubles.
pub fn doubles(numbers: [Decimal<'_>; 3]) -> [f64; 3] {
    numbers.map(|number| number.double)
}

/// A direction in a number type. One whose length is 1 as far as the type tells is kept as it is written, so that a
/// direction that the type has stored comes back to the bit; another is normalised, and then rounded once.
pub fn direction<S: Exact>(numbers: [Decimal<'_>; 3]) -> Result<UnitVec3<S>, ValueError> {
    as_written(numbers).map_or_else(|| UnitVec3::from_f64(doubles(numbers)), Ok)
}

/// The direction of these components, if the square of its length is 1 within two units: each component that is
/// rounded, and a normalisation in the type itself, may be off by so much.
fn as_written<S: Exact>([x, y, z]: [Decimal<'_>; 3]) -> Option<UnitVec3<S>> {
    let components = [S::parse_unit(x.text)?, S::parse_unit(y.text)?, S::parse_unit(z.text)?];
    let [x, y, z] = components.map(|component| S::exact_unit(component).squared());
    let off = &(&(&x + &y) + &z) - &Dyadic::from(1);
    let is_unit = off.magnitude() <= Dyadic::power_of_two(1 - S::UNIT_BITS);
    UnitVec3::from_components(components).ok().filter(|_| is_unit)
}
