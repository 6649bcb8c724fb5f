//! Hands the memory map of the emulated board to the linker.

use std::path::PathBuf;
use std::{env, fs};

fn main() {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    let arch = env::var("CARGO_CFG_TARGET_ARCH").expect("cargo sets it");
    let map = match arch.as_str() {
        "arm" => "memory-mps2.x",
        "riscv32" => "memory-virt.x",
        // The host, for the library alone.
        _ => return,
    };
    fs::copy(here.join(map), out.join("memory.x")).expect("the memory map is beside this file");
    println!("cargo:rerun-if-changed={map}");
    println!("cargo:rustc-link-search={}", out.display());
    if arch == "riscv32" {
        println!("cargo:rustc-link-arg-bins=-Tmemory.x");
    }
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
}
