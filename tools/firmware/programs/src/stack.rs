//! Bytes of stack. The host does not measure them: there, all are 0.

#[cfg(target_os = "none")]
use raylet_firmware::stack;

/// Paints the stack, and returns how much of it is in use.
#[cfg(target_os = "none")]
#[inline(never)]
pub fn depth() -> usize {
    stack::paint();
    stack::used()
}

/// How much more was in use since then, at most.
#[cfg(target_os = "none")]
pub fn used_since(depth: usize) -> usize {
    stack::used().saturating_sub(depth)
}

/// Nothing.
#[cfg(not(target_os = "none"))]
pub fn depth() -> usize {
    0
}

/// Nothing.
#[cfg(not(target_os = "none"))]
pub fn used_since(depth: usize) -> usize {
    depth
}
