//! What the programs share that are linked and never run: `check proofs` and `check size` look at what the linker left.
//!
//! They start at `_start`, on no runtime: every byte of them is raylet's, `core`'s or that of the compiler's own
//! helpers.
#![no_std]

pub mod everything;
pub mod input;
pub mod pictures;
pub mod sensors;

/// The bottom of every panic. Where any code can panic, this is linked.
#[inline(never)]
fn panicked() -> ! {
    loop {
        input::give(0_u32);
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    panicked()
}

/// Makes `_start` from a body.
#[macro_export]
macro_rules! program {
    ($($body:tt)*) => {
        /// Where the linker starts looking for what is needed.
        #[unsafe(no_mangle)]
        pub extern "C" fn _start() -> ! {
            loop {
                $($body)*
            }
        }
    };
}
