//! Why: the words for what `findings` finds. Where a row has none here, the document says that it is not explained.

use super::findings::{Beaten, Machine};

type Why = (fn(&Beaten<'_>) -> bool, &'static str);

fn is_fixed(row: &Beaten<'_>) -> bool {
    row.slower.number.starts_with('I')
}

/// Both tiers make the same error but for the last roundings.
fn is_nearly_as_accurate(row: &Beaten<'_>) -> bool {
    row.faster.lengths[1] > row.slower.lengths[1] * 0.66
}

fn is_unbounded_and_placed(row: &Beaten<'_>) -> bool {
    matches!(row.slower.primitive, "cone double" | "cone nappe")
        && (row.slower.workload.starts_with("framed") || row.slower.workload.starts_with("stretched"))
}

fn is_flat(row: &Beaten<'_>) -> bool {
    matches!(row.slower.primitive, "plane" | "disc" | "triangle")
}

/// The first that applies counts.
pub const WHY: [Why; 15] = [
    (
        |row| is_fixed(row) && row.slower.tier == "Textbook",
        "The operators of `fixed` round every product, widening and shifting each, and the textbook divides both roots by `a`. The tiers \
         keep products whole, see most misses by signs of plain integers, and take one root and one quotient.",
    ),
    (
        |row| row.slower.workload.starts_with("stretched") && row.slower.tier == "Exact",
        "A stretched placement stores a rounded inverse and every tier takes it at its word. What is left is the matrix's rounding, \
         the same for all; where its effect and a tier's own rounding cancel is chance.",
    ),
    (
        |row| is_fixed(row) && row.faster.tier == "Exact" && row.slower.primitive == "triangle",
        "Where the volumes of a triangle's edges are in doubt, from far away or behind a stretched placement, `Stable` computes them twice: \
         quickly, and then carefully. `Exact` computes them once, in wide numbers.",
    ),
    (
        |row| row.slower.number == "f32" && row.faster.tier == "Exact" && row.slower.tier == "Stable",
        "`Stable` holds the careful coefficients of cones, grazing rays and triangles to twice the precision in pairs of `f32`, at some ten \
         to twenty operations a product. `Exact` has them in one `f64` each: where a sum is a 16,000th of its terms or more its sign is clear \
         without further ado, else the size of what went into it is the bound of its error. Where most coefficients are careful, or the short way of `Stable` was asked in vain before, that is \
         less, even where doubles are software.",
    ),
    (
        |row| row.faster.tier == "Exact" && row.slower.tier == "Fast" && row.slower.primitive == "triangle",
        "The products and sums of a float triangle are error-free in every tier, `Fast` too: each product is split and its rounding kept. \
         `Exact` has each in one `f64`.",
    ),
    (
        |row| {
            row.slower.number == "f32"
                && row.faster.tier == "Exact"
                && row.slower.tier == "Fast"
                && row.machine == Machine::Host
        },
        "A placed line, and one from far away, leave the short way of `Fast`, whose solver scales the line and its `t`. The doubles of `Exact` \
         need neither, and a host has a unit for them; no chip here is quicker with them.",
    ),
    (
        |row| {
            row.slower.number == "I16F16"
                && row.faster.tier == "Stable"
                && row.slower.tier == "Fast"
                && row.machine == Machine::Host
        },
        "The plain kernel of `Fast` holds lengths of 28 bits (for a sphere: to 4,096), and beyond them the long way in block-floating numbers \
         answers; that of `Stable` holds the whole range. Where both take the long way (discs, the axis of a cylinder), the narrower \
         blocks of `Fast` save nothing on a processor of 64 bits.",
    ),
    (
        |row| row.slower.number == "I32F32" && row.faster.tier == "Stable" && row.machine == Machine::Host,
        "On a processor of 64 bits, with products of 128, a step in the narrow blocks of `Fast` costs as many instructions as one in the wide \
         ones of `Stable` (a sphere took 2,100 in both when they were counted), and the closest approach has more steps that wait for each other.",
    ),
    (
        |row| row.slower.number == "I16F16" && row.faster.tier == "Stable" && row.slower.tier == "Fast",
        "Both run the same plain kernel; what differs is how the compiler laid it out (under 1 %). In such types `Fast` buys nothing \
         for this primitive.",
    ),
    (
        |row| row.faster.tier == "Fast" && row.slower.tier == "Textbook",
        "Closest approach takes a direction for exactly unit: no `a`, no quotient by it. And a miss is seen before the root.",
    ),
    (
        |row| row.faster.tier == "Fast" && row.slower.tier == "Stable" && is_unbounded_and_placed(row),
        "Of an unbounded cone a hit may be very far away, and its `t` as ill-conditioned as it is long: nearly all of the error is that of \
         the ray, rounded alike in both tiers on its way into the frame. Which of the two comes out better is chance.",
    ),
    (
        |row| !is_fixed(row) && row.faster.tier == "Stable" && row.slower.tier == "Textbook",
        "Where nothing cancels, `Stable` asks the plain formulas too, but the moment instead of `k^2 - a c`, and most misses are seen before \
         the root.",
    ),
    (
        |row| !is_fixed(row) && row.faster.tier == "Stable" && row.slower.tier == "Fast",
        "Both ask the same short way first, and what that leaves open goes to each one's solver. The few rows come from this host and \
         its compiler (read from the code, not taken apart); no chip has one.",
    ),
    (
        |row| is_nearly_as_accurate(row) || is_flat(row),
        "Nothing cancels for these rays, so that care buys nothing: the errors differ by a last rounding or two (the dearer tier \
         scales the ray or steps it closer, and then rounds once more), within a third of each other, or for flat primitives \
         by less than the rounding of their placement.",
    ),
    (
        |row| row.faster.tier == "Textbook",
        "From nearby the textbook's difference is the better one: `k^2` and `a c` shrink as a ray starts nearer, the moments that the tiers \
         subtract do not; from 3 away on it is the other way round, and growing. `Fast` is still the better one in the median of most of \
         these rows, but not in the tail, where `a` is small too; there `Stable` is. What all tiers pay for and the textbook leaves out: \
         parts and crossings that pair, and numbers that cannot overflow.",
    ),
];

/// The index of the explanation of a row; as many as there are if it has none.
pub fn of(row: &Beaten<'_>) -> usize {
    WHY.iter().position(|(applies, _)| applies(row)).unwrap_or(WHY.len())
}

/// Why one may take a combination that another beats in every row.
pub fn why_take(number: &str, tier: &str) -> &'static str {
    match (number, tier) {
        (_, "Textbook") => "It stands here to be compared with.",
        ("f32", "Exact") => {
            "It is the one whose decisions (hit, part, order) are proved right; the others are right in these rows, by measurement."
        }
        ("I16F16", "Exact") => {
            "Its decisions are proved right, in integers alone; `f32` `Exact` is finer near the solid and needs doubles."
        }
        ("I32F32", _) => {
            "Take it where a program must be free of floats, or must have the same unit from end to end of a long range. Where doubles are \
             allowed they are finer near the origin and take less."
        }
        ("I16F16", _) => {
            "Where there is a floating-point unit, floats are finer and take less. Take it where memory, a protocol or the rest of \
             the program is in fixed point."
        }
        ("f32", _) => {
            "Where doubles are no dearer, they are finer. Take it where memory counts (half of it), and where one processor has no doubles."
        }
        _ => "Take it where the rest of a program is in this type.",
    }
}

/// The same for all tiers of a number type.
pub fn why_take_number(number: &str) -> &'static str {
    why_take(number, "Fast")
}
