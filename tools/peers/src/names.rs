//! How the contestants are called.

/// raylet's cheapest tier.
pub const PLAIN: &str = "raylet Plain";
/// The tier between it and the default.
pub const FAST: &str = "raylet Fast";
/// raylet's default tier.
pub const STABLE: &str = "raylet Stable";
/// The tier whose decisions are those of exact arithmetic.
pub const EXACT: &str = "raylet Exact";
/// `parry3d`, and in doubles `parry3d-f64`.
pub const PARRY: &str = "parry3d";
/// `embedded-3dgfx`.
pub const EMBEDDED_3DGFX: &str = "embedded-3dgfx";
/// The formulas of every tutorial.
pub const TEXTBOOK: &str = "textbook";
