//! The square root of an `f32`, by the instruction where the chip has one.
//!
//! `core` has no `sqrt` on `no_std`, and `libm::sqrtf` is integer code even on a chip with a floating-point unit.
//! Both are correctly rounded, so that the bits agree everywhere.

/// The correctly rounded square root.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline(always)]
#[expect(unsafe_code, reason = "the one audited exception: stable Rust has no other way to VSQRT")]
pub(super) fn square_root_f32(x: f32) -> f32 {
    let mut bits = x.to_bits();
    // SAFETY: moves a register into the floating-point unit and back; reads and writes nothing else. The
    // `eabihf` ABI guarantees that the unit exists and is enabled. `s0` is saved and restored through a core
    // register, since the register class of the unit cannot be named as an operand on stable.
    unsafe {
        core::arch::asm!(
            "vmov {saved}, s0",
            "vmov s0, {bits}",
            "vsqrt.f32 s0, s0",
            "vmov {bits}, s0",
            "vmov s0, {saved}",
            bits = inout(reg) bits,
            saved = out(reg) _,
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    f32::from_bits(bits)
}

/// The correctly rounded square root.
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
#[inline(always)]
pub(super) fn square_root_f32(x: f32) -> f32 {
    libm::sqrtf(x)
}
