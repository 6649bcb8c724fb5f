//! Lets the linker note who calls what, so that `check proofs` can say where a panic comes from.

fn main() {
    println!("cargo:rustc-link-arg-bins=--emit-relocs");
}
