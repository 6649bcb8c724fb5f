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
    matches!(row.slower.primitive, "plane" | "disc" | "triangle")
}

/// The first that applies counts.
pub const WHY: [Why; 16] = [
    (
        |row| is_fixed(row) && row.slower.tier == "Textbook",
        "The operators of `fixed` round every product, widening and shifting each, and the textbook divides both roots by `a`. The tiers \
         keep products whole, see most misses by signs of plain integers, and take one root and one quotient.",
    ),
    (
        |row| row.slower.placed.starts_with("stretched") && row.slower.tier == "Exact",
        "A stretched placement is taken as it is stored; both answers are rounded correctly but for ties. What differs between them is chance.",
    ),
    (
        |row| is_fixed(row) && row.faster.tier == "Exact",
        "`Exact` computes in doubles first, which hold 32 bits with room for what products and sums lose; a host has a unit for them. `Fast` and \
         `Stable` compute in integers alone.",
    ),
    (
        |row| row.slower.number == "f32" && row.faster.tier == "Exact" && row.slower.tier == "Stable",
        "What the fast path of `Stable` leaves open is computed in integers of 64 bits. `Exact` takes the same path in doubles, which have so \
         many bits to spare that strict guards let nearly every ray through; and a host has a unit for them.",
    ),
    (
        |row| row.faster.tier == "Exact" && row.slower.tier == "Fast" && row.slower.primitive == "triangle",
        "What the fast path of `Fast` leaves open of a triangle is computed in integers of 64 bits. The fast path of `Exact` computes in \
         doubles, and leaves less open.",
    ),
    (
        |row| {
            row.slower.number == "f32"
                && row.faster.tier == "Exact"
                && row.slower.tier == "Fast"
                && row.machine == Machine::Host
        },
        "A stretched solid, and a line from far away, leave the fast path of `Fast` for integers of 64 bits. The doubles of `Exact` answer them, \
         and a host has a unit for doubles.",
    ),
    (
        |row| {
            row.slower.number == "I16F16"
                && row.faster.tier == "Stable"
                && row.slower.tier == "Fast"
                && row.machine == Machine::Host
        },
        "The fast path of `Fast` holds lengths of 28 bits (for a sphere: to 4,096), and beyond them the robust number answers; that of \
         `Stable` holds the whole range. Where the robust number answers both, they cost the same.",
    ),
    (
        |row| row.slower.number == "I32F32" && row.faster.tier == "Stable" && row.machine == Machine::Host,
        "On a processor of 64 bits, with products of 128, the closest approach of `Fast` saves nothing and has more steps that wait for \
         each other; what the fast path leaves open costs both tiers the same.",
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
        "Of an unbounded cone a hit may be very far away, and its `t` as ill-conditioned as it is long. What the fast path leaves open is \
         answered by the same numbers in both tiers. Which of the two comes out better is chance.",
    ),
    (
        |row| !is_fixed(row) && row.faster.tier == "Stable" && row.slower.tier == "Textbook",
        "Where nothing cancels, `Stable` computes in plain floats too, but by the moment instead of `k^2 - a c`, and most misses are seen before \
         the root.",
    ),
    (
        |row| {
            !is_fixed(row)
                && row.faster.tier == "Exact"
                && row.slower.tier == "Textbook"
                && row.machine == Machine::Host
        },
        "`Exact` takes the path of `Stable` in doubles, for which a host has a unit: by the moment instead of `k^2 - a c`, and most misses \
         are seen before the root.",
    ),
    (
        |row| !is_fixed(row) && row.faster.tier == "Stable" && row.slower.tier == "Fast",
        "Both have nearly the same fast path, and what that leaves open is answered by the same numbers. The few rows come from this host and \
         its compiler (read from the code, not taken apart); no chip has one.",
    ),
    (
        |row| is_nearly_as_accurate(row) || is_flat(row),
        "Nothing cancels for these rays, so that care buys nothing: the errors differ by a last rounding or two (the dearer tier \
         rounds once more), within a third of each other, or for flat primitives \
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
