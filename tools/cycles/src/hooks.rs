//! What Unicorn and `machine.py` call.
#![expect(unsafe_code, reason = "both call through C")]

use crate::{Block, Counter};
use std::ffi::c_void;

/// Tells `machine.py` of a block that is not known: its address and its bytes.
type Unknown = extern "C" fn(u32, u32);

/// A counter, and where it is read.
pub struct Counting {
    counter: Counter,
    unknown: Unknown,
    /// The clock advances by so many cycles at once.
    grain: u64,
}

/// A new counter. It lives as long as the program that made it.
#[unsafe(no_mangle)]
pub extern "C" fn counting_new(base: u32, bytes: u32, predicts: bool, grain: u32, unknown: Unknown) -> *mut Counting {
    let counter = Counter::new(base, bytes, predicts);
    Box::into_raw(Box::new(Counting { counter, unknown, grain: u64::from(grain.max(1)) }))
}

/// Learns a block.
///
/// # Safety
///
/// `counting` comes from [`counting_new`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn counting_learn(
    counting: *mut Counting,
    address: u32,
    end: u32,
    cycles: u32,
    taken: u32,
    entered: u32,
    predicted: bool,
) -> bool {
    // SAFETY: as promised; Unicorn calls from one thread.
    let counting = unsafe { &mut *counting };
    counting.counter.learn(Block { address, end, cycles, taken, entered, predicted })
}

/// Unicorn's hook of blocks.
///
/// # Safety
///
/// `counting` comes from [`counting_new`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn counting_block(_: *mut c_void, address: u64, bytes: u32, counting: *mut Counting) {
    // SAFETY: as promised. No reference lives while `unknown` runs, which calls `counting_learn`.
    if !unsafe { &*counting }.counter.knows(address as u32, bytes) {
        let unknown = unsafe { &*counting }.unknown;
        unknown(address as u32, bytes);
    }
    // SAFETY: as above.
    unsafe { &mut *counting }.counter.add(address as u32);
}

/// The timer of Arm's boards, which counts down: the register at 4 is its value.
///
/// # Safety
///
/// `counting` comes from [`counting_new`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn counting_timer(_: *mut c_void, offset: u64, _: u32, counting: *mut Counting) -> u64 {
    // SAFETY: as promised.
    let Counting { counter, grain, .. } = unsafe { &mut *counting };
    if offset != 4 {
        return 0;
    }
    counter.was_read();
    u64::from(u32::MAX - (counter.cycles() / *grain) as u32)
}

/// RISC-V's counter of 64 bits: the lower half at 0, the upper at 4.
///
/// # Safety
///
/// `counting` comes from [`counting_new`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn counting_register(_: *mut c_void, offset: u64, _: u32, counting: *mut Counting) -> u64 {
    // SAFETY: as promised.
    let counter = unsafe { &mut (*counting).counter };
    if offset == 4 {
        return counter.cycles() >> 32;
    }
    counter.was_read();
    u64::from(counter.cycles() as u32)
}

/// Writes to the timer change nothing.
#[unsafe(no_mangle)]
pub extern "C" fn counting_ignore(_: *mut c_void, _: u64, _: u32, _: u64, _: *mut Counting) {}

/// How often a block was carried out while the program measured; its address and its end in `ends`. `u64::MAX` behind
/// the last block.
///
/// # Safety
///
/// `counting` comes from [`counting_new`], and `ends` has room for two.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn counting_executions(counting: *const Counting, number: u32, ends: *mut u32) -> u64 {
    // SAFETY: as promised.
    let Some((block, executions)) = (unsafe { &*counting }).counter.block(number as usize) else { return u64::MAX };
    // SAFETY: as promised.
    unsafe { [ends.write(block.address), ends.add(1).write(block.end)] };
    executions
}
