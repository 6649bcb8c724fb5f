//! Which primitives and placements the library has: all, or those that `RAYLET_KINDS` names.

use std::env;
use std::fs;
use std::path::Path;

const KINDS: [&str; 19] = [
    "Sphere",
    "Cylinder",
    "Cone",
    "Capsule",
    "Plane",
    "Disc",
    "Triangle",
    "Cuboid",
    "Rectangle",
    "Revolved",
    "Tube",
    "Annulus",
    "RoundCone",
    "RoundedCuboid",
    "Prism",
    "Polyhedron",
    "Torus",
    "Frame",
    "Affine",
];

fn main() {
    println!("cargo:rerun-if-env-changed=RAYLET_KINDS");
    println!("cargo:rerun-if-changed=build.rs");
    let chosen = env::var("RAYLET_KINDS").unwrap_or_default();
    let chosen: Vec<&str> = chosen.split([' ', ',']).filter(|name| !name.is_empty()).collect();
    for name in &chosen {
        assert!(KINDS.contains(name), "RAYLET_KINDS: there is no kind {name}; there are {}", KINDS.join(", "));
    }
    assert!(chosen.len() <= 12, "RAYLET_KINDS: at most 12 kinds can be chosen; without it there are all");
    let kinds: String = chosen.iter().map(|name| format!("raylet::{name}<f32>, ")).collect();
    let kinds = if chosen.is_empty() { "raylet::shape::kinds::All".into() } else { format!("({kinds})") };
    let text = format!("/// The primitives and placements that a shape may have.\npub type Chosen = {kinds};\n");
    let folder = env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    fs::write(Path::new(&folder).join("chosen.rs"), text).expect("cargo's folder can be written");
}
