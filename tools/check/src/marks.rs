//! The marks that the kernels were written for, and what was reached of them.

use crate::chip::Part;
use crate::cost;
use crate::document::Measured;
use raylet_tables::Baseline;
use std::fmt::Write;

/// The instructions of rays that hit: subject, query, number type.
type Figure = (&'static str, &'static str, &'static str);

/// What is compared with a limit.
enum Mark {
    /// Instructions on one chip.
    Instructions { chip: &'static str, of: Figure, most: u64 },
    /// A ratio of instructions, on one chip or on all.
    Ratio { chip: Option<&'static str>, of: Figure, to: Figure, most: f64 },
}

const SPHERE: Figure = ("sphere", "nearest", "I16F16");
const OCCLUSION: Figure = ("sphere", "occlusion", "I16F16");
const CYLINDER: Figure = ("cylinder, capped", "nearest", "I16F16");
const CONE: Figure = ("cone, capped", "nearest", "I16F16");
const FLOAT_SPHERE: Figure = ("sphere", "nearest", "f32");
const WIDE_SPHERE: Figure = ("sphere", "nearest", "I32F32");

const MARKS: [(&str, Mark); 8] = [
    ("I16F16 sphere", Mark::Instructions { chip: "Cortex-M0+", of: SPHERE, most: 550 }),
    ("I16F16 sphere", Mark::Instructions { chip: "Cortex-M3", of: SPHERE, most: 180 }),
    ("I16F16 sphere", Mark::Instructions { chip: "RV32IMC", of: SPHERE, most: 200 }),
    ("f32 sphere", Mark::Instructions { chip: "Cortex-M4F", of: FLOAT_SPHERE, most: 60 }),
    ("I16F16 sphere, occlusion to nearest", Mark::Ratio { chip: None, of: OCCLUSION, to: SPHERE, most: 0.6 }),
    ("I16F16 capped cylinder to sphere", Mark::Ratio { chip: None, of: CYLINDER, to: SPHERE, most: 2.5 }),
    ("I16F16 capped cone to sphere", Mark::Ratio { chip: None, of: CONE, to: SPHERE, most: 2.5 }),
    ("I32F32 sphere to I16F16", Mark::Ratio { chip: Some("Cortex-M3"), of: WIDE_SPHERE, to: SPHERE, most: 6.0 }),
];

fn figure(baseline: &Baseline, (subject, query, number): Figure, tier: &str) -> Option<u64> {
    Part::Cost.figure(baseline, &cost::key(subject, query, number, tier, "hit"))
}

/// The figure, and whether it reaches the mark.
fn cell(baseline: &Baseline, mark: &Mark, tier: &str) -> Option<String> {
    let (text, reached) = match mark {
        Mark::Instructions { of, most, .. } => {
            let figure = figure(baseline, *of, tier)?;
            (figure.to_string(), figure <= *most)
        }
        Mark::Ratio { of, to, most, .. } => {
            let ratio = figure(baseline, *of, tier)? as f64 / figure(baseline, *to, tier)? as f64;
            (format!("{ratio:.2}"), ratio <= *most)
        }
    };
    Some(if reached { format!("**{text}**") } else { text })
}

/// A table of the marks: a row for each mark and chip.
pub fn table(text: &mut String, chips: &[Measured]) {
    text.push_str(
        "## The marks\n\nLimits that were set before spheres, cylinders and cones were computed in the types' own width: instructions of a nearest hit, or a ratio of them. A figure in bold is within its limit.\n\n\
         | mark | chip | at most | Fast | Stable |\n|---|---|---:|---:|---:|\n",
    );
    for (name, mark) in &MARKS {
        let (only, most) = match mark {
            Mark::Instructions { chip, most, .. } => (Some(*chip), most.to_string()),
            Mark::Ratio { chip, most, .. } => (*chip, most.to_string()),
        };
        for Measured { chip, counted, .. } in chips.iter().filter(|of| only.is_none_or(|only| only == of.chip)) {
            let [fast, stable] = ["Fast", "Stable"].map(|tier| cell(counted, mark, tier).unwrap_or_else(|| "–".into()));
            let _ = writeln!(text, "| {name} | {chip} | {most} | {fast} | {stable} |");
        }
    }
    text.push('\n');
    text.push_str(LIMITS);
}

/// Why marks are missed, by counting operations: what of a formula no kernel can leave out.
const LIMITS: &str = "\
`Fast` misses most marks that are ratios to the sphere, because its sphere takes so few instructions. The capped cone misses its mark in `Fast` and in `Stable`. The formulas need:

| nearest hit | products of 32 bits | roots | reciprocals | quotients by them |
|---|---:|---:|---:|---:|
| sphere: `k`, `o - k d`, its square, `r^2` | 10 | 1 | 0 | 0 |
| capped cylinder: `w_y`, `k`, `a`, `a r^2`; two planes | 10 | 1 | 2 | 4 |
| capped cone: `k`, the closest point, both scaled by the slope, `a`, `k`, the discriminant, the nappe; two planes | 30 | 1 | 2 | 4 |

- *Occlusion on the Cortex-M0+.* A ray that hits needs all that a ray that misses needs: the discriminant, and the signs of the ends. It leaves out only the
  root. A miss alone takes more than the mark allows for a hit: the row of the sphere in the next table has both.
- *Capped cylinder.* A reciprocal costs as much as a root, and a quotient by it half as much. Its root, reciprocals and quotients cost as much as
  five roots. A whole sphere in `Fast` costs little more than two on the Cortex-M3: within 2.5 spheres next to nothing remains for all other instructions.
- *Capped cone.* The divisions are those of the cylinder, and it has three times as many products.

";
