//! Lists that a reader fills: of fixed capacity on a microcontroller, a growing `Vec` on a host.

use core::fmt;

/// A list to which items can be added until it is full.
///
/// Implemented for `heapless::Vec` and `heapless::VecView`, for `std::vec::Vec` with the feature `std`, and for
/// mutable references to any of these.
pub trait Store<T> {
    /// Adds an item after all others.
    ///
    /// # Errors
    ///
    /// [`Full`] if the capacity is exhausted; the store is unchanged.
    fn push(&mut self, item: T) -> Result<(), Full>;
}

/// The capacity of a store is exhausted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Full;

impl fmt::Display for Full {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the store is full: give it a larger capacity")
    }
}

impl core::error::Error for Full {}

impl<T, Length: heapless::LenType, Storage: heapless::vec::VecStorage<T> + ?Sized> Store<T>
    for heapless::vec::VecInner<T, Length, Storage>
{
    fn push(&mut self, item: T) -> Result<(), Full> {
        self.push(item).map_err(|_| Full)
    }
}

impl<T, Inner: Store<T> + ?Sized> Store<T> for &mut Inner {
    fn push(&mut self, item: T) -> Result<(), Full> {
        (**self).push(item)
    }
}

#[cfg(feature = "std")]
impl<T> Store<T> for std::vec::Vec<T> {
    fn push(&mut self, item: T) -> Result<(), Full> {
        self.push(item);
        Ok(())
    }
}
