//! Conversion of words to numbers: the part of the reader below the entities.

use super::decimal::{Decimal, Magnitude, parse_scaled};
use super::error::{NffError, Place, Reason};
use super::lexer::{Lexer, Word};
use super::scale::Scale;
use crate::scalar::{Ring, Scalar, is_decimal, is_zero_decimal};
use crate::vector::{UnitVec3, Vec3};
use core::marker::PhantomData;

/// A number with its place, and whether rounding has made it zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Number<S> {
    pub(super) value: S,
    pub(super) place: Place,
    /// The text gives a number other than zero, but its value is zero.
    pub(super) vanished: bool,
}

/// Takes values from the words of a text. `what` names the value in a message.
#[derive(Clone, Debug)]
pub(super) struct Numbers<'t, S> {
    words: Lexer<'t>,
    scale: Scale,
    scalar: PhantomData<S>,
}

impl<'t, S: Scalar> Numbers<'t, S> {
    pub(super) fn new(text: &'t str, scale: Scale) -> Self {
        Self { words: Lexer::new(text), scale, scalar: PhantomData }
    }

    /// The next word, if there is one.
    pub(super) fn word(&mut self) -> Option<Word<'t>> {
        self.words.next()
    }

    /// The next word, without taking it.
    pub(super) fn peek(&self) -> Option<Word<'t>> {
        self.words.peek()
    }

    /// Where the next word stands, or the end of the text.
    pub(super) fn place(&self) -> Place {
        self.peek().map_or(self.words.place(), |word| word.place)
    }

    /// True if the next word is a number, and not the name of an entity.
    pub(super) fn number_follows(&self) -> bool {
        self.peek().is_some_and(|word| is_decimal(word.text))
    }

    /// The words that follow, without taking them.
    pub(super) fn texts(&self) -> impl Iterator<Item = &'t str> {
        self.words.clone().map(|word| word.text)
    }

    /// The bytes that are left.
    pub(super) fn remaining(&self) -> usize {
        self.words.remaining()
    }

    fn expect(&mut self, what: &'static str) -> Result<Word<'t>, NffError> {
        self.word().ok_or(NffError { place: self.words.place(), reason: Reason::Ended { what } })
    }

    /// A number that the type can hold.
    pub(super) fn number(&mut self, what: &'static str) -> Result<Number<S>, NffError> {
        self.scaled(what, Scale::ONE)
    }

    fn scaled(&mut self, what: &'static str, scale: Scale) -> Result<Number<S>, NffError> {
        let Word { text, place } = self.expect(what)?;
        let reason = match parse_scaled::<S>(text, scale.power().into()) {
            Some(value) => return Ok(Number { value, place, vanished: value == S::ZERO && !is_zero_decimal(text) }),
            None if is_decimal(text) => Reason::BeyondType { what },
            None => Reason::NotANumber { what },
        };
        Err(NffError { place, reason })
    }

    /// A number of at least zero; beyond the type's range, the largest that it holds.
    pub(super) fn saturated(&mut self, what: &'static str) -> Result<S, NffError> {
        self.saturated_scaled(what, Scale::ONE)
    }

    /// A distance of at least zero; beyond the type's range, the largest that it holds.
    pub(super) fn distance(&mut self, what: &'static str) -> Result<S, NffError> {
        self.saturated_scaled(what, self.scale)
    }

    fn saturated_scaled(&mut self, what: &'static str, scale: Scale) -> Result<S, NffError> {
        let beyond = |text| is_decimal(text) && parse_scaled::<S>(text, scale.power().into()).is_none();
        if self.peek().is_some_and(|word| beyond(word.text) && !word.text.starts_with('-')) {
            self.word();
            return Ok(S::BUDGET.distance);
        }
        not_negative(self.scaled(what, scale)?, what)
    }

    /// A number of at least zero.
    pub(super) fn not_negative(&mut self, what: &'static str) -> Result<S, NffError> {
        not_negative(self.number(what)?, what)
    }

    /// A coordinate or size inside the budget.
    pub(super) fn size(&mut self, what: &'static str) -> Result<Number<S>, NffError> {
        let place = self.place();
        // The message names the budget, whichever limit was exceeded first.
        let beyond = NffError { place, reason: Reason::BeyondBudget { what } };
        let number = self.scaled(what, self.scale).map_err(|error| match error.reason {
            Reason::BeyondType { .. } => beyond,
            _ => error,
        })?;
        if number.value.magnitude() <= S::BUDGET.coordinate { Ok(number) } else { Err(beyond) }
    }

    /// Three coordinates inside the budget.
    pub(super) fn point(&mut self, what: &'static str) -> Result<Vec3<S>, NffError> {
        Ok(Vec3::new(self.size(what)?.value, self.size(what)?.value, self.size(what)?.value))
    }

    /// The direction of a point at any distance; `None` if the point is the origin. Nine digits of its coordinates are
    /// used.
    pub(super) fn direction(&mut self, what: &'static str) -> Result<Option<UnitVec3<S>>, NffError> {
        let mut decimals = [None; 3];
        for decimal in &mut decimals {
            let Word { text, place } = self.expect(what)?;
            let reason = if is_decimal(text) { Reason::BeyondBudget { what } } else { Reason::NotANumber { what } };
            *decimal = Some(Decimal::parse(text).ok_or(NffError { place, reason })?);
        }
        let place = decimals.iter().flatten().filter_map(|decimal| decimal.magnitude()).max().map(Magnitude::place);
        let Some(place) = place else { return Ok(None) };
        Ok(UnitVec3::from_real(decimals.map(|decimal| decimal.map_or(S::Real::ZERO, |decimal| decimal.leading(place)))))
    }

    /// Three numbers, the components of a direction of any length.
    pub(super) fn vector(&mut self, what: &'static str) -> Result<Vec3<S>, NffError> {
        Ok(Vec3::new(self.number(what)?.value, self.number(what)?.value, self.number(what)?.value))
    }

    /// Three colour channels from 0 to 1.
    pub(super) fn color(&mut self, what: &'static str) -> Result<[S::Unit; 3], NffError> {
        Ok([self.channel(what)?, self.channel(what)?, self.channel(what)?])
    }

    fn channel(&mut self, what: &'static str) -> Result<S::Unit, NffError> {
        let Number { value, place, .. } = self.number(what)?;
        if value < S::ZERO || value.real() > S::Real::ONE {
            return Err(NffError { place, reason: Reason::Color { what } });
        }
        Ok(S::unit_round(value.real()))
    }

    /// A whole number.
    pub(super) fn count<N: core::str::FromStr>(&mut self, what: &'static str) -> Result<N, NffError> {
        let Word { text, place } = self.expect(what)?;
        text.parse().map_err(|_| NffError { place, reason: Reason::NotACount { what } })
    }
}

fn not_negative<S: Scalar>(number: Number<S>, what: &'static str) -> Result<S, NffError> {
    let Number { value, place, .. } = number;
    if value < S::ZERO { Err(NffError { place, reason: Reason::Negative { what } }) } else { Ok(value) }
}
