//! Hands the linker the script of the chip's runtime. The memory map of the emulated board, `memory.x`, comes from
//! `raylet-firmware`: the folders that the build script of a dependency adds to the linker's search are searched here
//! too.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let scripts: &[&str] = match std::env::var("CARGO_CFG_TARGET_ARCH").as_deref() {
        Ok("arm") => &["link.x"],
        Ok("riscv32") => &["memory.x", "link.x"],
        // The host, for the library alone.
        _ => &[],
    };
    for script in scripts {
        println!("cargo:rustc-link-arg-bins=-T{script}");
    }
    // `cost` names every query of every number type, which is more than the boards' flash holds. Functions of equal
    // code are linked once: what a query executes is the same.
    if !scripts.is_empty() {
        println!("cargo:rustc-link-arg-bin=cost=--icf=all");
    }
}
