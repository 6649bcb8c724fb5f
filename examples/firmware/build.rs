//! Hands the memory map of the board to the linker: of the emulated one, or of the real one that a feature names.

use std::path::PathBuf;
use std::{env, fs};

/// The real boards: a feature of this crate and a folder of `boards` each, and the processor family.
const BOARDS: [(&str, &str); 3] = [("rp2040", "arm"), ("stm32f4", "arm"), ("esp32c3", "riscv32")];

fn main() {
    let arch = env::var("CARGO_CFG_TARGET_ARCH").expect("cargo sets it");
    let emulated = match arch.as_str() {
        "arm" => "memory-mps2.x",
        "riscv32" => "memory-virt.x",
        // The host, for the library alone.
        _ => return,
    };
    let mut chosen = BOARDS
        .into_iter()
        .filter(|(board, _)| env::var_os(format!("CARGO_FEATURE_{}", board.to_uppercase())).is_some());
    let board = chosen.next();
    assert!(chosen.next().is_none(), "a program is built for one board");
    let map = match board {
        Some((board, family)) => {
            assert_eq!(family, arch, "the board {board} is of another processor family than the target");
            format!("boards/{board}/memory.x")
        }
        None => emulated.to_owned(),
    };
    place(&map, "memory.x");
    println!("cargo:rustc-link-search={}", env::var("OUT_DIR").expect("cargo sets it"));
    if matches!(board, Some(("esp32c3", _))) {
        place("boards/esp32c3/link.x", "board.x");
        println!("cargo:rustc-link-arg-bins=-Tboard.x");
        return;
    }
    if arch == "riscv32" {
        println!("cargo:rustc-link-arg-bins=-Tmemory.x");
    }
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
}

/// Copies a file of this crate to where the linker looks for it.
fn place(file: &str, name: &str) {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets it"));
    fs::copy(here.join(file), out.join(name)).expect("the memory maps are beside this file");
    println!("cargo:rerun-if-changed={file}");
}
