//! What the firmware programs share, and what the host runs beside them.
#![no_std]

pub mod clock;
pub mod cost;
pub mod digest;
pub mod effects;
pub mod figures;
#[cfg(target_os = "none")]
pub mod footprint;
#[path = "../../gallery/mod.rs"]
pub mod gallery;
pub mod panel;
pub mod picture;
pub mod shown;
#[cfg(target_os = "none")]
pub mod stack;

/// Makes a function, which never returns, the first that the chip's runtime calls.
#[macro_export]
macro_rules! starts_with {
    ($run:path) => {
        #[cfg(target_arch = "arm")]
        #[cortex_m_rt::entry]
        fn main() -> ! {
            $run()
        }

        #[cfg(target_arch = "riscv32")]
        #[riscv_rt::entry]
        fn main() -> ! {
            $run()
        }
    };
}
