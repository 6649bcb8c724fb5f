//! How much of the stack a program uses at most: its free part is painted before, and searched for the paint after.
//!
//! Both runtimes put the stack at the end of the memory, growing down towards the statics; nothing else is there, since
//! no program has a heap. Interrupts are off, so that nothing but the program itself writes to it.

use core::arch::asm;

/// No address, no small number and no instruction.
const PAINT: u32 = 0xc5a3_96e1;

unsafe extern "C" {
    /// Where the stack starts, just behind its first word.
    #[link_name = "_stack_start"]
    static START: u32;
    /// The lowest word that the stack may grow to.
    #[cfg_attr(target_arch = "arm", link_name = "_stack_end")]
    #[cfg_attr(target_arch = "riscv32", link_name = "__estack")]
    static LOWEST: u32;
}

fn start() -> usize {
    &raw const START as usize
}

fn lowest() -> usize {
    &raw const LOWEST as usize
}

/// Paints all of the stack that is free.
pub fn paint() {
    // The stack pointer is read and the loop runs in one block: between two, a compiler may make room for a frame.
    // SAFETY: aligned words of the stack's memory, below the stack pointer: no frame is there, and neither Arm's nor
    // RISC-V's calling convention has a red zone.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!(
            "mov {end}, sp", "b 3f",
            "2: str {paint}, [{word}]", "adds {word}, #4",
            "3: cmp {word}, {end}", "blo 2b",
            word = inout(reg) lowest() => _, end = out(reg) _, paint = in(reg) PAINT,
        );
        #[cfg(target_arch = "riscv32")]
        asm!(
            "mv {end}, sp", "j 3f",
            "2: sw {paint}, 0({word})", "addi {word}, {word}, 4",
            "3: bltu {word}, {end}, 2b",
            word = inout(reg) lowest() => _, end = out(reg) _, paint = in(reg) PAINT,
        );
    }
}

/// Bytes of the stack that have been used at most since [`paint`], all frames from the first.
///
/// A frame whose lowest words were never written to counts from its lowest word that was.
pub fn used() -> usize {
    let mut word = lowest();
    // SAFETY: aligned words of the stack's memory; reading has no effect.
    while word < start() && unsafe { core::ptr::with_exposed_provenance::<u32>(word).read_volatile() } == PAINT {
        word += size_of::<u32>();
    }
    start() - word
}
