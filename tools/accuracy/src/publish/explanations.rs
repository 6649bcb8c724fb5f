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
    matches!(row.slower.primitive, "cone double" | "cone nappe") && !row.slower.is_unplaced()
}

fn is_flat(row: &Beaten<'_>) -> bool {
    matches!(row.slower.primitive, "plane" | "disc" | "rectangle" | "triangle")
}

/// The first that applies counts.
pub const WHY: [Why; 17] = [
    (
        |row| is_fixed(row) && row.slower.tier == "Textbook",
        "The operators of `fixed` round every product, widening and shifting each, and the textbook divides both roots by `a`. The tiers do not round products, decide most misses by the sign of an integer, and compute one root and one quotient.",
    ),
    (
        |row| row.slower.placed.starts_with("stretched") && row.slower.tier == "Exact",
        "A stretched placement is taken as it is stored; both answers are rounded nearly correctly. What differs between them is chance.",
    ),
    (
        |row| is_fixed(row) && row.faster.tier == "Exact",
        "What the integers of the grid cannot decide, `Exact` computes in doubles, whose 53 bits are enough for most decisions about 32-bit inputs; a \
         host has hardware for doubles. `Fast` and `Stable` compute in integers alone.",
    ),
    (
        |row| row.slower.number == "f32" && row.faster.tier == "Exact" && row.slower.tier == "Stable",
        "`Stable` computes a bound of its error in floats, of what that leaves unsure the line again in double-words (pairs of floats), and what is then unsure in integers of 64 bits. `Exact` computes the same bound in doubles, which leaves nearly no ray unsure. A host has hardware for doubles.",
    ),
    (
        |row| row.faster.tier == "Exact" && row.slower.tier == "Fast" && row.slower.primitive == "triangle",
        "What the guard of `Fast` leaves unsure about a triangle is computed in integers of 64 bits. `Exact` computes in doubles, which decide more rays.",
    ),
    (
        |row| {
            row.slower.number == "f32"
                && row.faster.tier == "Exact"
                && row.slower.tier == "Fast"
                && row.machine == Machine::Host
        },
        "For stretched solids and rays from far away floats are often unsure in `Fast`, and integers of 64 bits must decide. The doubles of `Exact` decide these rays, and a host has hardware for doubles.",
    ),
    (
        |row| {
            row.slower.number == "f32"
                && row.faster.tier == "Exact"
                && row.slower.tier == "Fast"
                && row.slower.primitive.starts_with("cone")
        },
        "What the guard of `Fast` leaves unsure about a cone is computed in integers of 64 bits. `Exact` computes in doubles, which decide more rays.",
    ),
    (
        |row| {
            row.slower.number == "I16F16"
                && row.faster.tier == "Stable"
                && row.slower.tier == "Fast"
                && row.machine == Machine::Host
        },
        "The grid of `Fast` is limited to lengths of 28 bits (for a sphere: to 4,096), and beyond them the robust number computes the answer; that of `Stable` covers the whole range. Where the robust number computes both, they cost the same.",
    ),
    (
        |row| row.slower.number == "I32F32" && row.faster.tier == "Stable" && row.machine == Machine::Host,
        "On a processor of 64 bits, with products of 128, the closest approach of `Fast` saves nothing and has the longer chain of dependent steps; what the grid cannot decide costs both tiers the same.",
    ),
    (
        |row| row.slower.number == "I16F16" && row.faster.tier == "Stable" && row.slower.tier == "Fast",
        "Both run the same kernel; what differs is the code that the compiler makes of it (under 1 %). In these types `Fast` has no advantage for this primitive.",
    ),
    (
        |row| matches!(row.faster.tier, "Plain" | "Fast") && row.slower.tier == "Textbook",
        "The formula of closest approach takes the direction for exactly unit, so that there is no `a` to divide by. And a miss is decided before the root.",
    ),
    (
        |row| row.faster.tier == "Fast" && row.slower.tier == "Stable" && is_unbounded_and_placed(row),
        "A hit of an unbounded cone may be very far away, and its `t` is then ill-conditioned. Which of the two is more accurate is chance.",
    ),
    (
        |row| !is_fixed(row) && row.faster.tier == "Stable" && row.slower.tier == "Textbook",
        "Where nothing cancels, `Stable` computes in floats too. It takes the direction for exactly unit, so that there is no `a` to divide by, and decides a miss before the root.",
    ),
    (
        |row| {
            !is_fixed(row)
                && row.faster.tier == "Exact"
                && row.slower.tier == "Textbook"
                && row.machine == Machine::Host
        },
        "`Exact` computes in doubles, for which a host has hardware, and decides a miss before the root.",
    ),
    (
        |row| !is_fixed(row) && row.faster.tier == "Stable" && row.slower.tier == "Fast",
        "Both compute the same formulas, of stretched solids in the same numbers. These few rows depend on this host and its compiler (concluded from the source, not from a profile); no chip has such a row.",
    ),
    (
        |row| is_nearly_as_accurate(row) || is_flat(row),
        "No cancellation occurs for these rays, so that the more accurate tier has no advantage: the errors differ by one or two roundings (the tier that costs more rounds once more) and are within a third of each other, or for flat primitives differ by less than the rounding of their placement.",
    ),
    (
        |row| row.faster.tier == "Textbook",
        "From nearby the textbook's difference is the more accurate one: `k^2` and `a c` get smaller the nearer a ray starts, and the moments that the tiers subtract do not. From a distance of 3 on the tiers are more accurate, increasingly so. In the median of most of these rows `Fast` is the more accurate one, but not among the worst rays, where `a` is small too; there `Stable` is. All tiers compute what the textbook does not: parts, crossings that pair, and no overflow.",
    ),
];

/// The index of the explanation of a row; as many as there are if it has none.
pub fn of(row: &Beaten<'_>) -> usize {
    WHY.iter().position(|(applies, _)| applies(row)).unwrap_or(WHY.len())
}

/// Why one may take a combination that another beats in every row.
pub fn why_take(number: &str, tier: &str) -> &'static str {
    match (number, tier) {
        (_, "Textbook") => "It is listed for comparison.",
        ("f32", "Exact") => {
            "It is the one whose decisions (hit, part, order) are proved right; the others are right in these rows, by measurement."
        }
        ("I16F16", "Exact") => {
            "Its decisions are proved right, and its unit is the same from end to end of its range; `f32` `Exact` is finer near the solid."
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
