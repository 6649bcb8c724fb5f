//! What `docs/which-one.md` says, the rows that it cites, and what must hold of them.

use super::which_one::cost;
use crate::study::Study;

/// Number type, tier, primitive, and the workload with the placement.
#[derive(Clone, Copy)]
pub struct Row(pub &'static str, pub &'static str, pub &'static str, pub &'static str);

/// What must hold for a piece of advice. Times are not compared: they differ from run to run.
pub enum Claim {
    /// On each of these chips the first row takes fewer instructions than the second.
    Cheaper(&'static [&'static str], Row, Row),
    /// The 99.9 % error of the row is at most so many units.
    Within(Row, f64),
    /// No hit of the number type and tier is lost, invented or on another part, in any row.
    NeverWrong(&'static str, &'static str),
    /// In this row hits are lost or invented.
    Wrong(Row),
}

pub struct Advice {
    pub situation: &'static str,
    pub take: String,
    pub rows: Vec<Row>,
    pub claims: Vec<Claim>,
}

fn advice(situation: &'static str, take: impl Into<String>, rows: Vec<Row>, claims: Vec<Claim>) -> Advice {
    Advice { situation, take: take.into(), rows, claims }
}

const NO_UNIT: &[&str] = &["Cortex-M0+", "Cortex-M3", "RV32IMC"];
const EVERY_CHIP: &[&str] = &["Cortex-M0+", "Cortex-M3", "Cortex-M4F", "RV32IMC"];
const SPHERE: &str = "sphere";
const CYLINDER: &str = "cylinder capped";
const CONE: &str = "cone capped";

/// Which number type of 64 bits takes fewer instructions where floats are software.
fn cheaper_of_64_bits(study: &Study) -> String {
    let benign = |number, tier| Row(number, tier, SPHERE, "benign");
    // The one that takes fewer instructions on most of these chips.
    let fewer = |tier| {
        let is_fixed =
            |chip: &&&str| cost(study, chip, &benign("I32F32", tier)) < cost(study, chip, &benign("f64", tier));
        if NO_UNIT.iter().filter(is_fixed).count() * 2 > NO_UNIT.len() { "`I32F32`" } else { "`f64`" }
    };
    match [fewer("Fast"), fewer("Stable")] {
        [fast, stable] if fast == stable => format!("{fast} takes fewer instructions for a sphere"),
        [fast, stable] => format!("{fast} takes fewer instructions for a sphere in `Fast`, and {stable} in `Stable`"),
    }
}

/// Which solids take fewer instructions in `f32` than in `I16F16` on a chip that computes in it.
fn cheaper_with_a_unit(study: &Study) -> String {
    let (in_float, in_fixed): (Vec<_>, Vec<_>) =
        [(SPHERE, "spheres"), (CYLINDER, "capped cylinders"), (CONE, "capped cones")].into_iter().partition(
            |(solid, _)| {
                let [float, fixed] =
                    ["f32", "I16F16"].map(|number| cost(study, "Cortex-M4F", &Row(number, "Stable", solid, "benign")));
                float <= fixed
            },
        );
    let listed = |solids: &[(&str, &str)]| solids.iter().map(|(_, plural)| *plural).collect::<Vec<_>>().join(" and ");
    match (in_float.as_slice(), in_fixed.as_slice()) {
        (_, []) => "In `Stable` it takes fewer instructions than `I16F16` for all solids.".to_string(),
        ([], _) => "In `Stable` `I16F16` takes fewer instructions for all solids, if coordinates fit it.".to_string(),
        (float, fixed) => format!(
            "In `Stable` it takes fewer instructions than `I16F16` for {}; for {} fixed point takes fewer, if coordinates fit it.",
            listed(float),
            listed(fixed)
        ),
    }
}

fn by_chip(study: &Study) -> Vec<Advice> {
    let benign = |number, tier| Row(number, tier, SPHERE, "benign");
    let [wide, single] = [cheaper_of_64_bits(study), cheaper_with_a_unit(study)];
    vec![
        advice(
            "No floating-point unit (M0+, M3, RV32IMC):",
            "`I16F16`, `Stable`. It takes fewer instructions than `f32` `Fast` for spheres, cylinders and cones, and its error is within a unit (1.5e-5) up to \
             16,384 from the origin. `I16F16` `Fast` takes two fifths to two thirds of the instructions of `Stable` for a sphere, and is within a unit too for rays from nearby; for a cylinder \
             and a cone it takes nearly as many as `Stable`.",
            vec![
                benign("I16F16", "Stable"),
                benign("I16F16", "Fast"),
                benign("f32", "Fast"),
                benign("f32", "Stable"),
                Row("I16F16", "Stable", CYLINDER, "benign"),
                Row("I16F16", "Fast", CYLINDER, "benign"),
                Row("I16F16", "Stable", CONE, "benign"),
                Row("I16F16", "Fast", CONE, "benign"),
            ],
            vec![
                Claim::Cheaper(NO_UNIT, benign("I16F16", "Stable"), benign("f32", "Fast")),
                Claim::Cheaper(
                    NO_UNIT,
                    Row("I16F16", "Stable", CYLINDER, "benign"),
                    Row("f32", "Fast", CYLINDER, "benign"),
                ),
                Claim::Cheaper(NO_UNIT, Row("I16F16", "Stable", CONE, "benign"), Row("f32", "Fast", CONE, "benign")),
                Claim::Cheaper(NO_UNIT, benign("I16F16", "Fast"), benign("I16F16", "Stable")),
                Claim::Within(benign("I16F16", "Stable"), 0.51),
                Claim::Within(Row("I16F16", "Stable", SPHERE, "10000 away"), 0.51),
                Claim::Within(benign("I16F16", "Fast"), 0.6),
            ],
        ),
        advice(
            "No floating-point unit, and coordinates beyond `I16F16`:",
            format!(
                "Try another split of 32 bits first: `I20F12` reaches 262,144 in units of 2.4e-4. On the host it takes about as many instructions as `I16F16`, and fewer for most placed solids far away \
                 ([benches.md](benches.md#what-users-do)); it is not measured on chips. Beyond that, of `f64` and `I32F32`, {wide}; for a hit `I32F32` takes two to four times the instructions of `I16F16`, and `f64` more than ten times."
            ),
            ["Fast", "Stable"].into_iter().flat_map(|tier| [benign("I32F32", tier), benign("f64", tier)]).collect(),
            vec![Claim::Cheaper(NO_UNIT, benign("I16F16", "Stable"), benign("f64", "Fast"))],
        ),
        advice(
            "A single-precision unit (M4F):",
            format!(
                "`f32`. `Stable` takes up to two fifths more instructions than `Fast` for a sphere and about twice as many for a cylinder and a cone, and keeps its accuracy where rays graze. {single} \
                 This chip computes doubles in software, and `f32` `Exact` needs them."
            ),
            vec![
                benign("f32", "Fast"),
                benign("f32", "Stable"),
                benign("I16F16", "Stable"),
                Row("f32", "Stable", CYLINDER, "benign"),
                Row("I16F16", "Stable", CYLINDER, "benign"),
                Row("f32", "Stable", CONE, "benign"),
                Row("I16F16", "Stable", CONE, "benign"),
                benign("f64", "Fast"),
                benign("f32", "Exact"),
            ],
            vec![
                Claim::Cheaper(&["Cortex-M4F"], benign("f32", "Fast"), benign("I16F16", "Fast")),
                Claim::Cheaper(&["Cortex-M4F"], benign("f32", "Stable"), benign("f64", "Fast")),
                Claim::Cheaper(&["Cortex-M4F"], benign("f64", "Fast"), benign("f32", "Exact")),
            ],
        ),
        advice(
            "A double-precision unit, or a host:",
            "`f64`, `Stable`, if memory allows: it is at most a fifth slower than `f32` in most rows, and finer by nearly nine decimal digits. `f64` `Fast` has smaller errors than `f32` `Exact` for rays \
             that do not graze, but does not promise that hits and misses are right; `Exact` exists for `f32` and 32-bit fixed point.",
            vec![
                benign("f64", "Fast"),
                benign("f64", "Stable"),
                benign("f32", "Stable"),
                benign("f32", "Exact"),
                benign("I16F16", "Stable"),
                benign("I32F32", "Stable"),
            ],
            vec![Claim::Within(Row("f64", "Stable", SPHERE, "grazing 1e-7"), 16.0)],
        ),
    ]
}

fn by_distance() -> Vec<Advice> {
    let sphere = |number, tier, workload| Row(number, tier, SPHERE, workload);
    vec![
        advice(
            "Up to 100 away:",
            "Any tier but `Plain`, which promises right hits up to 10 sizes away. `Fast` is within a few units for well-aimed rays. The textbook loses two decimal digits at 100.",
            vec![
                sphere("f32", "Textbook", "100 away"),
                sphere("f32", "Plain", "100 away"),
                sphere("f32", "Fast", "100 away"),
                sphere("f32", "Stable", "100 away"),
                sphere("I16F16", "Fast", "100 away"),
                sphere("I16F16", "Stable", "100 away"),
            ],
            vec![
                Claim::Within(sphere("f32", "Fast", "100 away"), 8.0),
                Claim::Within(sphere("I16F16", "Fast", "100 away"), 1.0),
            ],
        ),
        advice(
            "1,000 to 16,000 away:",
            "`Stable`. Where the unit must be the same near and far, take `I16F16`: from 256 on its unit is smaller than that of `f32`. `I16F16` `Fast` has \
             about the same errors as `Stable` there, but takes longer, because its grid has no room for coordinates so large. The textbook loses hits.",
            vec![
                sphere("f32", "Textbook", "10000 away"),
                sphere("f32", "Fast", "10000 away"),
                sphere("f32", "Stable", "10000 away"),
                sphere("I16F16", "Textbook", "10000 away"),
                sphere("I16F16", "Fast", "10000 away"),
                sphere("I16F16", "Stable", "10000 away"),
            ],
            vec![
                Claim::Within(sphere("f32", "Stable", "10000 away"), 1.0),
                Claim::Within(sphere("I16F16", "Stable", "10000 away"), 0.51),
                Claim::Within(sphere("I16F16", "Fast", "10000 away"), 1.5),
                Claim::Wrong(sphere("f32", "Textbook", "10000 away")),
                Claim::Wrong(sphere("I16F16", "Textbook", "10000 away")),
            ],
        ),
        advice(
            "A million away:",
            "`f32` `Stable` finds all hits of these rows, but its unit is a sixteenth there. For a `t` that is accurate to a thousandth take `f64`, or `I32F32` if the program must not use \
             floats.",
            vec![
                sphere("f32", "Stable", "1000000 away"),
                sphere("f64", "Fast", "1000000 away"),
                sphere("f64", "Stable", "1000000 away"),
                sphere("I32F32", "Fast", "1000000 away"),
                sphere("I32F32", "Stable", "1000000 away"),
            ],
            vec![
                Claim::Within(sphere("f32", "Stable", "1000000 away"), 1.2),
                Claim::Within(sphere("f64", "Stable", "1000000 away"), 1.2),
                Claim::Within(sphere("I32F32", "Stable", "1000000 away"), 0.51),
            ],
        ),
    ]
}

fn by_fault() -> Vec<Advice> {
    vec![
        advice(
            "Only flash counts:",
            "`Plain` in `f32`, for rays that start within 10 sizes of a solid and do not graze it. It computes the equations once, in the number type's own width, and a program that calls no other tier contains no \
             wider number: [microcontrollers.md](microcontrollers.md#flash) has the bytes. It takes about as many instructions as `Fast`. In fixed point it saves neither.",
            vec![
                Row("f32", "Plain", SPHERE, "benign"),
                Row("f32", "Fast", SPHERE, "benign"),
                Row("f32", "Plain", CONE, "benign"),
                Row("f32", "Fast", CONE, "benign"),
                Row("I16F16", "Plain", CONE, "benign"),
                Row("I16F16", "Fast", CONE, "benign"),
                Row("f32", "Plain", CONE, "grazing 1e-2"),
                Row("f32", "Plain", CONE, "grazing 1e-4"),
            ],
            vec![
                Claim::Within(Row("f32", "Plain", SPHERE, "benign"), 16.0),
                Claim::Cheaper(EVERY_CHIP, Row("f32", "Plain", SPHERE, "benign"), Row("f32", "Fast", SPHERE, "benign")),
            ],
        ),
        advice(
            "Hit or miss, the part, or the order must never be wrong:",
            "`Exact`, in `f32` or 32-bit fixed point. In no row is a hit lost, invented or on another part, for placed solids too. `Stable` has none in most rows either; but only `Exact` decides by proved bounds. A program in it often takes three times the flash: [firmware.md](firmware.md#what-a-tier-costs-in-flash) has the figures.",
            vec![
                Row("f32", "Fast", CONE, "1e-7 off a plane"),
                Row("f32", "Stable", CONE, "1e-7 off a plane"),
                Row("f32", "Exact", CONE, "1e-7 off a plane"),
                Row("I16F16", "Exact", CONE, "1e-7 off a plane"),
            ],
            vec![
                Claim::NeverWrong("f32", "Exact"),
                Claim::NeverWrong("I16F16", "Exact"),
                Claim::Wrong(Row("f32", "Fast", CONE, "1e-7 off a plane")),
            ],
        ),
        advice(
            "`t` must be good even where a ray grazes:",
            "`Stable`. In fixed point `Fast` is nearly as accurate, since it does not round products.",
            vec![
                Row("f32", "Fast", SPHERE, "grazing 1e-4"),
                Row("f32", "Stable", SPHERE, "grazing 1e-4"),
                Row("f64", "Stable", SPHERE, "grazing 1e-4"),
                Row("I16F16", "Fast", SPHERE, "grazing 1e-4"),
                Row("I16F16", "Stable", SPHERE, "grazing 1e-4"),
            ],
            vec![
                Claim::Within(Row("f32", "Stable", SPHERE, "grazing 1e-4"), 4.0),
                Claim::Within(Row("I16F16", "Fast", SPHERE, "grazing 1e-4"), 1.0),
            ],
        ),
        advice(
            "Rays that leave a surface:",
            "Make them with `Ray::departing`: such a ray needs no epsilon in any tier. The rows below have rays that start on the surface without it. One of their `t` is close to \
             zero, and `Fast` in floats has few correct digits of it.",
            vec![
                Row("f32", "Fast", SPHERE, "on the surface"),
                Row("f32", "Stable", SPHERE, "on the surface"),
                Row("f32", "Exact", SPHERE, "on the surface"),
                Row("I16F16", "Stable", SPHERE, "on the surface"),
            ],
            vec![
                Claim::Wrong(Row("f32", "Fast", SPHERE, "on the surface")),
                Claim::Within(Row("f32", "Exact", SPHERE, "on the surface"), 0.51),
                Claim::Within(Row("I16F16", "Stable", SPHERE, "on the surface"), 0.6),
            ],
        ),
        advice(
            "Cones seen along their generators:",
            "`Stable`. `Fast` promises less where a ray also grazes. In `f32` on a host `Exact` costs no more than \
             `Stable` in most of these rows.",
            vec![
                Row("f32", "Fast", CONE, "1e-4 off a generator"),
                Row("f32", "Stable", CONE, "1e-4 off a generator"),
                Row("f32", "Exact", CONE, "1e-4 off a generator"),
                Row("I16F16", "Stable", CONE, "1e-4 off a generator"),
            ],
            vec![Claim::Within(Row("f32", "Stable", CONE, "1e-4 off a generator"), 16.0)],
        ),
        advice(
            "Solids that are turned or stretched:",
            "The same advice: `Stable` and `Exact` promise the same wherever a solid is placed. They take the axes of a frame and the inverse of a stretch as they \
             are stored, that is, rounded. Where that rounding matters, as with large stretches, give the solid its size in its constructor instead.",
            vec![
                Row("f32", "Stable", CYLINDER, "benign"),
                Row("f32", "Stable", CYLINDER, "benign, moved"),
                Row("f32", "Stable", CYLINDER, "benign, turned"),
                Row("f32", "Stable", CYLINDER, "benign, stretched by 1/30 to 30"),
                Row("I16F16", "Stable", CYLINDER, "benign, turned"),
                Row("I16F16", "Stable", CYLINDER, "benign, stretched by 1/30 to 30"),
            ],
            vec![
                Claim::Within(Row("f32", "Stable", CYLINDER, "benign, turned"), 16.0),
                Claim::Within(Row("I16F16", "Stable", CYLINDER, "benign, turned"), 0.6),
            ],
        ),
    ]
}

/// The page's sections.
pub fn sections(study: &Study) -> Vec<(&'static str, Vec<Advice>)> {
    vec![("By chip", by_chip(study)), ("By distance", by_distance()), ("By what must not go wrong", by_fault())]
}
