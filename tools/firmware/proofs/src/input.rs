//! Values of which the compiler knows nothing, and a place for answers that it may not leave out.

use core::cell::UnsafeCell;
use core::hint::black_box;
use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedI64};
use raylet::{Scalar, UnitVec3, Vec3};

/// A word that anyone might have written.
struct Word(UnsafeCell<u64>);
// SAFETY: the programs have one thread, and are not run.
unsafe impl Sync for Word {}

static WORD: Word = Word(UnsafeCell::new(0));

/// Any bits.
#[inline(never)]
pub fn any_word() -> u64 {
    // SAFETY: it points to a static. Volatile: the compiler may assume nothing of what is read.
    unsafe { WORD.0.get().read_volatile() }
}

/// A reference to anything, which nobody follows: the programs are not run.
#[inline(never)]
pub fn any_reference<T>() -> &'static T {
    // SAFETY: never run.
    unsafe { &*(any_word() as usize as *const T) }
}

/// A list of anything, which nobody reads: the programs are not run.
pub fn any_list<T>() -> &'static [T] {
    // SAFETY: never run.
    unsafe { core::slice::from_raw_parts(any_reference::<T>(), any_word() as usize) }
}

/// Any text.
pub fn any_text() -> &'static str {
    // SAFETY: never run.
    unsafe { core::str::from_utf8_unchecked(core::slice::from_raw_parts(any_reference::<u8>(), any_word() as usize)) }
}

/// An answer that must be computed.
#[inline(always)]
pub fn give<T>(answer: T) {
    black_box(answer);
}

/// A number of any bits.
pub trait Any: Scalar {
    /// The number.
    fn any() -> Self;
}

impl Any for f32 {
    fn any() -> Self {
        Self::from_bits(any_word() as u32)
    }
}

impl Any for f64 {
    fn any() -> Self {
        Self::from_bits(any_word())
    }
}

impl<F: LeEqU32 + Send + Sync + 'static> Any for FixedI32<F> {
    fn any() -> Self {
        Self::from_bits(any_word() as i32)
    }
}

impl<F: LeEqU64 + Send + Sync + 'static> Any for FixedI64<F> {
    fn any() -> Self {
        Self::from_bits(any_word() as i64)
    }
}

/// A point of any bits.
pub fn any_point<S: Any>() -> Vec3<S> {
    Vec3::new(S::any(), S::any(), S::any())
}

/// Any direction.
pub fn any_direction<S: Any>() -> UnitVec3<S> {
    UnitVec3::new(any_point()).unwrap_or(UnitVec3::X)
}
