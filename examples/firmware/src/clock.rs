//! Instructions carried out so far, by the emulator's deterministic clock.
//!
//! With `-icount shift=0` QEMU's time advances one nanosecond an instruction. These are instructions, not cycles: what
//! a real chip takes for them depends on its pipeline and its memory.

/// The clock advances by this many instructions at once: measure many repetitions.
#[cfg(target_arch = "arm")]
pub const GRAIN: u64 = 40;
/// The clock advances by this many instructions at once.
#[cfg(not(target_arch = "arm"))]
pub const GRAIN: u64 = 1;

/// The first of the two timers of the MPS2 boards: 32 bits, counting down at 25 MHz, one tick for each 40 ns (Arm,
/// *Cortex-M System Design Kit Technical Reference Manual*, dual-input timers).
#[cfg(target_arch = "arm")]
mod timer {
    pub const LOAD: *mut u32 = 0x4000_2000 as *mut u32;
    pub const VALUE: *const u32 = 0x4000_2004 as *const u32;
    pub const CONTROL: *mut u32 = 0x4000_2008 as *mut u32;
    /// Enabled, free-running, 32 bits wide.
    pub const RUN: u32 = 0x82;
}

/// Starts the clock. Call it once, first.
pub fn start() {
    #[cfg(target_arch = "arm")]
    // SAFETY: the registers of a timer that exists on the emulated boards and that nothing else uses.
    unsafe {
        timer::LOAD.write_volatile(u32::MAX);
        timer::CONTROL.write_volatile(timer::RUN);
    }
}

/// Instructions since the clock was started, a multiple of [`GRAIN`]; on Arm modulo 2^32 times it.
#[cfg(target_arch = "arm")]
pub fn instructions() -> u64 {
    // SAFETY: as above; reading has no effect.
    u64::from(u32::MAX - unsafe { timer::VALUE.read_volatile() }) * GRAIN
}

/// Instructions since the reset.
#[cfg(target_arch = "riscv32")]
pub fn instructions() -> u64 {
    riscv::register::minstret::read64()
}

/// The host has no such clock: always 0.
#[cfg(not(any(target_arch = "arm", target_arch = "riscv32")))]
pub fn instructions() -> u64 {
    0
}
