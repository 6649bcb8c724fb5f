//! What the programs of `tools/firmware/sizes` are made for: primitives in number types and tiers, sets of effects, and
//! chosen kinds.

/// The primitives, and a shape, which may be any of them in any placement.
pub const PRIMITIVES: [&str; 18] = [
    "sphere",
    "cylinder",
    "cone",
    "capsule",
    "plane",
    "disc",
    "triangle",
    "cuboid",
    "rectangle",
    "revolved",
    "tube",
    "annulus",
    "round_cone",
    "rounded_cuboid",
    "prism",
    "polyhedron",
    "torus",
    SHAPE,
];

/// Any primitive in any placement.
pub const SHAPE: &str = "shape";

/// Number types and tiers.
pub const KINDS: [[&str; 2]; 8] = [
    ["f32", "Plain"],
    ["f32", "Fast"],
    ["f32", "Stable"],
    ["f32", "Exact"],
    ["I16F16", "Plain"],
    ["I16F16", "Fast"],
    ["I16F16", "Stable"],
    ["I16F16", "Exact"],
];

/// The sets of effects, with the effects in each as the program `effects` names them.
pub const SETS: [(&str, &str); 13] = [
    ("none", "none"),
    ("ambient", "ambient"),
    ("diffuse", "diffuse"),
    ("specular", "diffuse, specular"),
    ("shadows", "diffuse, specular, shadows"),
    ("reflection", "diffuse, specular, shadows, reflection"),
    ("refraction", "diffuse, specular, shadows, reflection, refraction"),
    ("texture", "diffuse, specular, shadows, texture"),
    ("bump", "diffuse, specular, shadows, bump"),
    ("fog", "diffuse, specular, shadows, fog"),
    ("antialiasing", "diffuse, specular, shadows, antialiasing"),
    ("outline", "diffuse, specular, shadows, outline"),
    ("all", "ambient, diffuse, specular, shadows, reflection, refraction, texture, bump, fog, antialiasing, outline"),
];

/// The number types that they are measured in.
pub const NUMBERS: [&str; 2] = ["I16F16", "f32"];

/// A program that uses chosen kinds.
pub struct Use {
    /// Its name in the tables.
    pub name: &'static str,
    /// Its file's name, without the number type.
    pub program: &'static str,
    /// The macro of `raylet-sizes` that makes it.
    pub made_by: &'static str,
    /// The kinds that it names.
    pub kinds: &'static [&'static str],
    /// The effects of a picture.
    pub effects: Option<&'static str>,
}

/// The kinds of a simple picture.
pub const BALLS: &[&str] = &["Sphere", "Plane", "Frame"];

/// What users do, each in all of [`NUMBERS`].
pub const USES: [Use; 3] = [
    Use {
        name: "range sensor, cylinders and planes",
        program: "range_cylinder_plane",
        made_by: "range",
        kinds: &["Cylinder", "Plane", "Frame"],
        effects: None,
    },
    Use {
        name: "picture, spheres and planes, no effects",
        program: "picture_sphere_plane",
        made_by: "picture",
        kinds: BALLS,
        effects: Some("none"),
    },
    Use {
        name: "picture, spheres and planes, all effects",
        program: "picture_sphere_plane_effects",
        made_by: "picture",
        kinds: BALLS,
        effects: Some("all"),
    },
];

/// Every query of a shape, in every tier: no program of a user, but one that would show any code that is left.
const EVERYTHING: Use = Use {
    name: "all queries, spheres and planes",
    program: "asked_sphere_plane",
    made_by: "asked",
    kinds: BALLS,
    effects: None,
};

/// All programs that use chosen kinds.
pub fn uses() -> impl Iterator<Item = &'static Use> {
    USES.iter().chain([&EVERYTHING])
}
