//! What tables of chips and of queries have in common.

/// The chips, by target.
pub const CHIPS: [(&str, &str); 4] = [
    ("thumbv6m-none-eabi", "Cortex-M0+"),
    ("thumbv7m-none-eabi", "Cortex-M3"),
    ("thumbv7em-none-eabihf", "Cortex-M4F"),
    ("riscv32imc-unknown-none-elf", "RV32IMC"),
];

/// The subjects, as the programs that count instructions name them.
pub const SUBJECTS: [&str; 32] = [
    "sphere",
    "cylinder, infinite",
    "cylinder, open",
    "cylinder, capped",
    "capsule",
    "cone, double",
    "cone, nappe",
    "cone, open",
    "cone, capped",
    "frustum",
    "plane",
    "disc",
    "triangle",
    "cuboid",
    "rectangle",
    "paraboloid",
    "hyperboloid",
    "tube",
    "round cone",
    "rounded cuboid",
    "prism",
    "polyhedron",
    "torus",
    "annulus",
    "cylinder, capped, as a shape",
    "sphere, framed",
    "cylinder, capped, framed",
    "cone, capped, framed",
    "disc, framed",
    "triangle, framed",
    "cuboid, framed",
    "cylinder, capped, stretched",
];
