//! What an ESP32-C3 needs between its ROM and a program. The runtime of the other RISC-V programs will not do: it
//! writes to registers (`mie`, `mip`) that this chip does not have.

use core::arch::global_asm;

// The first instruction behind the mark. Interrupts are off after a reset, and stay off. Nothing but the stack and the
// global pointer is set before `.data` and `.bss` are: the loops use no memory.
global_asm!(
    ".section .init, \"ax\"",
    ".global _start",
    "_start:",
    ".option push",
    ".option norelax",
    "la gp, __global_pointer$",
    ".option pop",
    "la sp, _stack_start",
    "la t0, __sdata",
    "la t1, __edata",
    "la t2, __sidata",
    "j 3f",
    "2: lw t3, 0(t2)",
    "sw t3, 0(t0)",
    "addi t0, t0, 4",
    "addi t2, t2, 4",
    "3: bltu t0, t1, 2b",
    "la t0, __sbss",
    "la t1, __ebss",
    "j 5f",
    "4: sw zero, 0(t0)",
    "addi t0, t0, 4",
    "5: bltu t0, t1, 4b",
    "tail {run}",
    run = sym run,
);

extern "C" fn run() -> ! {
    stop_watchdogs();
    super::run()
}

/// Four watchdogs run from the reset on; each would reset the chip within seconds (*ESP32-C3 Technical Reference
/// Manual*, chapter *Watchdog Timers*).
fn stop_watchdogs() {
    /// Opens the settings of the timers' and the real-time clock's watchdog.
    const KEY: u32 = 0x50d8_3aa1;
    /// Opens the settings of the super watchdog.
    const SUPER_KEY: u32 = 0x8f1d_312a;
    /// The super watchdog feeds itself.
    const SUPER_FEEDS_ITSELF: u32 = 1 << 31;
    const SUPER_SETTINGS: *mut u32 = 0x6000_80ac as *mut u32;
    const SUPER_LOCK: *mut u32 = 0x6000_80b0 as *mut u32;
    /// Settings and lock of the watchdogs of timer group 0, timer group 1, and the real-time clock.
    const OTHERS: [[*mut u32; 2]; 3] = [
        [0x6001_f048 as *mut u32, 0x6001_f064 as *mut u32],
        [0x6002_0048 as *mut u32, 0x6002_0064 as *mut u32],
        [0x6000_8090 as *mut u32, 0x6000_80a8 as *mut u32],
    ];
    // SAFETY: registers of this chip that nothing else uses; stopping a watchdog changes no memory.
    unsafe {
        for [settings, lock] in OTHERS {
            lock.write_volatile(KEY);
            settings.write_volatile(0);
            lock.write_volatile(0);
        }
        SUPER_LOCK.write_volatile(SUPER_KEY);
        SUPER_SETTINGS.write_volatile(SUPER_SETTINGS.read_volatile() | SUPER_FEEDS_ITSELF);
        SUPER_LOCK.write_volatile(0);
    }
}
