//! What `docs/which-one.md` says, the rows that it cites, and what must hold of them.

use super::which_one::cost;
use crate::study::Study;

/// Number type, tier, primitive, and the workload with the placement.
#[derive(Clone, Copy)]
pub struct Row(pub &'static str, pub &'static str, pub &'static str, pub &'static str);

/// What an advice rests on. Times are no ground: they differ from run to run.
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
            "`I16F16`, `Stable`. It takes fewer instructions than `Fast` in `f32` for spheres, cylinders and cones, and is within a unit (of 1.5e-5) to \
             16,384 from the origin. `Fast` takes two fifths to two thirds of its instructions for a sphere, and is within a unit too from nearby; for a cylinder \
             and a cone it gains next to nothing.",
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
                "Another split first: `I20F12` reaches 262,144 in units of 2.4e-4, at the same price. Beyond that, of `f64` and `I32F32`, \
                 {wide}; both take several times the instructions of 32 bits."
            ),
            ["Fast", "Stable"].into_iter().flat_map(|tier| [benign("I32F32", tier), benign("f64", tier)]).collect(),
            vec![Claim::Cheaper(NO_UNIT, benign("I16F16", "Stable"), benign("f64", "Fast"))],
        ),
        advice(
            "A single-precision unit (M4F):",
            format!(
                "`f32`. `Fast` is the cheapest tier for spheres; `Stable` takes about twice as many instructions for a sphere and is right where rays graze. {single} \
                 Doubles are software, and `f32` `Exact` computes in them."
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
            "`f64`, `Stable`, if memory allows: mostly up to a fifth slower than `f32`, and finer by nine digits. `f64` `Fast` is finer than `f32` `Exact` for rays \
             that do not graze, but promises no decision; `Exact` exists for `f32` and 32-bit fixed point.",
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
            "Any. `Fast` is within a few units for well-aimed rays; the textbook has lost two digits at 100.",
            vec![
                sphere("f32", "Textbook", "100 away"),
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
            "`Stable`. Where one unit has to be the same near and far, `I16F16`: its unit is smaller than that of `f32` from 256 on. Its `Fast` is \
             about as good there, but takes longer, because its fast path does not reach so far. The textbook loses hits.",
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
            "`f32` `Stable` decides rightly, but its unit is a sixteenth there: for a `t` that is good to a thousandth take `f64`, or `I32F32` if floats \
             are out of the question.",
            vec![
                sphere("f32", "Stable", "1000000 away"),
                sphere("f64", "Fast", "1000000 away"),
                sphere("f64", "Stable", "1000000 away"),
                sphere("I32F32", "Fast", "1000000 away"),
                sphere("I32F32", "Stable", "1000000 away"),
            ],
            vec![
                Claim::Within(sphere("f32", "Stable", "1000000 away"), 1.0),
                Claim::Within(sphere("f64", "Stable", "1000000 away"), 1.0),
                Claim::Within(sphere("I32F32", "Stable", "1000000 away"), 0.51),
            ],
        ),
    ]
}

fn by_fault() -> Vec<Advice> {
    vec![
        advice(
            "Hit or miss, the part, or the order must never be wrong:",
            "`Exact`, in `f32` or 32-bit fixed point. In all rows nothing is lost, invented or on another part, placed or not. `Stable` is right in most rows too, and for nearly every ray; only for `Exact` it is proved.",
            vec![
                Row("f32", "Fast", SPHERE, "grazing 1e-7"),
                Row("f32", "Stable", SPHERE, "grazing 1e-7"),
                Row("f32", "Exact", SPHERE, "grazing 1e-7"),
                Row("I16F16", "Exact", SPHERE, "grazing 1e-7"),
            ],
            vec![
                Claim::NeverWrong("f32", "Exact"),
                Claim::NeverWrong("I16F16", "Exact"),
                Claim::Wrong(Row("f32", "Fast", SPHERE, "grazing 1e-7")),
            ],
        ),
        advice(
            "`t` must be good even where a ray grazes:",
            "`Stable`; in fixed point `Fast` does nearly as well, since its products are whole.",
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
            "Say so (`Ray::departing`): such a ray needs no epsilon in any tier. A start that merely happens to lie on a surface has a `t` next to \
             zero: `Fast` in floats has few right digits of it.",
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
            "`Stable`. `Fast` takes the same fast path there, but promises less where a ray also grazes. In `f32` on a host `Exact` costs no more than \
             `Stable` for many such rays.",
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
            "The same advice: `Stable` and `Exact` promise the same wherever a solid is placed. What is taken as exact are the axes of a \
             frame and the inverse of a stretch as they are stored, rounded. Where that rounding matters, as under large stretches, give the solid \
             its size instead.",
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
