//! What the programs share.
//!
//! | module | what it holds |
//! |---|---|
//! | `clock` | instructions carried out so far, in QEMU |
//! | `figures` | what a picture took, for printing |
//! | `footprint` | memory that a program takes before it runs |
//! | `panel` | a stand-in for a display on an SPI bus |
//! | `stack` | how much of the stack is used at most |
#![no_std]

pub mod clock;
pub mod figures;
#[cfg(target_os = "none")]
pub mod footprint;
pub mod panel;
#[cfg(target_os = "none")]
pub mod stack;

/// The attribute of the function that the chip's runtime calls first, for [`starts_with!`].
#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
/// The attribute of the function that the chip's runtime calls first, for [`starts_with!`]. The ESP32-C3 starts without
/// a runtime.
#[cfg(all(target_arch = "riscv32", not(feature = "esp32c3")))]
pub use riscv_rt::entry;

/// Makes a function, which never returns, the first that the chip's runtime calls.
#[macro_export]
macro_rules! starts_with {
    ($run:path) => {
        #[$crate::entry]
        fn main() -> ! {
            $run()
        }
    };
}
