//! The linker finds the memory map of the chip, that of `examples/firmware`.

use std::path::Path;

fn main() {
    let map = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware/boards/stm32f4");
    println!("cargo:rustc-link-search={}", map.display());
    println!("cargo:rerun-if-changed={}", map.join("memory.x").display());
}
