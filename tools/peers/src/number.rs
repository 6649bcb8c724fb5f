//! The number types that are compared.

use shared::textbook::{self, Plain};
use support::exact_types::Exact;

/// A number type of the comparison: a float, whose directions are of the same type, and the textbook's numbers too.
pub trait Number: Exact<Unit = Self> + Plain<Number = Self> + textbook::Number {}

impl Number for f32 {}
impl Number for f64 {}
