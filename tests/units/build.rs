//! Turns on the modules of tests in the library's source.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-cfg=units");
}
