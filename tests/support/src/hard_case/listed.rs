//! The list of rays on which published ray-primitive code is known to fail: its rows 1 to 15, every ray of each.
//!
//! Rows 16 to 18 (from the centre and from the surface; zero components; ever farther away) are classes of rays, and
//! are made by `hard_case_sweeps`.

use super::Axis::{To, X, Y, Z};
use super::Kind::{Ball, Can, DoubleCone, Nappe, Pill};
use super::{Case, TO_THE_END, case, enter, exit, touch};
use raylet::Part::{Base, Side, Top};

/// See the head of this file.
pub const LISTED: [Case; 26] = [
    case("1: sphere from 4,100 away", "the textbook discriminant in f32 gives 4100 twice")
        .on(Ball(1.0))
        .ray([-4100.0, 0.5, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "4099.1339745962155614"), exit(Side, "4100.8660254037844386")]),
    case("2: small sphere from 400 away", "the textbook discriminant in f32 gives 400")
        .on(Ball(0.1))
        .ray([-400.0, 0.095, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "399.96877501000800801"), exit(Side, "400.03122498999199199")]),
    case("3: one above a planet", "stable roots and closest approach give 0.98304 in f32")
        .on(Ball(6.4e6))
        .at([0.0, 0.0, -6.4e6], Y)
        .ray([0.0, 0.0, 1.0], [0.0, 0.0, -1.0])
        .hits(&[enter(Side, "1"), exit(Side, "12800001")]),
    case("4: tangent to a sphere", "a tangent vanishes, or counts twice")
        .on(Ball(0.5))
        .at([0.5, 0.5, 0.5], Y)
        .ray([0.0, 0.0, 0.5], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "0.5")]),
    case("4: past the tangent point", "the touch behind the start is reported")
        .on(Ball(0.5))
        .at([0.5, 0.5, 0.5], Y)
        .ray([0.6, 0.0, 0.5], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "-0.1")]),
    case("5: cylinder of radius 1e20", "squares overflow in f32")
        .on(Can(1e20, 1.0))
        .at([0.0, 0.0, 0.0], Z)
        .ray([-2e20, 0.0, 0.5], [1e20, 0.0, 0.0])
        .hits(&[enter(Side, "100000000000000000000"), exit(Side, "300000000000000000000")]),
    case("6: along a slanted axis, near it", "d.d - (d.a)^2 is all rounding error")
        .on(Can(5.0, TO_THE_END))
        .at([-30.005, -77.1061, -16.8721], To([-30.005, -27.301, 16.8721]))
        .ray([-29.0, -90.0, -25.0], [0.0, 0.827878, 0.560908])
        .hits(&[enter(Base, "15.233582034594576495"), exit(Top, "75.393527344160834087")]),
    case("6: along a slanted axis, from inside", "d.d - (d.a)^2 is all rounding error")
        .on(Can(5.0, TO_THE_END))
        .at([-30.005, -77.1061, -16.8721], To([-30.005, -27.301, 16.8721]))
        .ray([-29.0, -50.0, 1.0], [0.0, 0.827878, 0.560908])
        .hits(&[enter(Base, "-32.465151487088065916"), exit(Top, "27.694793822478191676")])
        .inside(),
    case("7: nearly along a capsule", "the tube is left far from where the round end is met")
        .on(Pill(1.0, 10.0))
        .ray([1.0001, 100.0, 0.0], [-0.001, -200.0, 0.0])
        .hits(&[enter(Top, "89.973549800925876501"), exit(Base, "100.02828644237053401")]),
    case("8: in the wall of a cylinder", "0/0: the wall is neither inside nor outside")
        .on(Can(1.0, 2.0))
        .at([0.0, 0.0, -1.0], Z)
        .ray([1.0, 0.0, 0.0], [0.0, 0.0, 1.0])
        .hits(&[enter(Side, "-1"), exit(Side, "1")])
        .inside(),
    case("8: just outside the wall", "a tolerance takes it for the wall")
        .on(Can(1.0, 2.0))
        .at([0.0, 0.0, -1.0], Z)
        .ray([1.0000001, 0.0, 0.0], [0.0, 0.0, 1.0]),
    case("9: in the plane of a cap", "division by zero in the slab of the caps")
        .on(Can(1.0, 2.0))
        .at([0.0, 0.0, -1.0], Z)
        .ray([2.0, 0.5, 1.0], [-1.0, 0.0, 0.0])
        .hits(&[enter(Side, "1.1339745962155613532"), exit(Side, "2.8660254037844386468")]),
    case("10: rim to rim", "hits doubled, or lost between side and cap")
        .on(Can(1.0, 2.0))
        .at([0.0, 0.0, -1.0], Z)
        .ray([2.0, 0.0, 2.0], [-1.0, 0.0, -1.0])
        .hits(&[enter(Side, "1.4142135623730950488"), exit(Side, "4.2426406871192851464")]),
    case("11: at a seam", "the seam is counted for the side and for the round end")
        .on(Pill(1.0, 2.0))
        .at([0.0, 0.0, -1.0], Z)
        .ray([2.0, 0.0, 1.0], [-1.0, 0.0, 0.0])
        .hits(&[enter(Side, "1"), exit(Side, "3")]),
    case("12: parallel to a generator from (-1.9, -.8, 3.3)", "a = 0: the textbook formula in f32 gives 4.0")
        .on(DoubleCone(2.0 / 3.0))
        .at([1.1, 2.2, 3.3], X)
        .ray([-1.9, -0.8, 3.3], [3.0, 2.0, 0.0])
        .hits(&[enter(Side, "4.5069390943299866164")])
        .f64_adds_beyond(1e9),
    case("12: parallel to a generator from (-1.9, 1.2, 3.3)", "a = 0: the textbook formula in f32 gives 4.0")
        .on(DoubleCone(2.0 / 3.0))
        .at([1.1, 2.2, 3.3], X)
        .ray([-1.9, 1.2, 3.3], [3.0, 2.0, 0.0])
        .hits(&[exit(Side, "2.7041634565979919698")])
        .inside()
        .f64_adds_beyond(1e9),
    case("12: parallel to a generator from (4.1, 3.2, 3.3)", "a = 0: the textbook formula in f32 gives 4.0")
        .on(DoubleCone(2.0 / 3.0))
        .at([1.1, 2.2, 3.3], X)
        .ray([4.1, 3.2, 3.3], [3.0, 2.0, 0.0])
        .hits(&[enter(Side, "-2.7041634565979919698")])
        .inside()
        .f64_adds_beyond(1e9),
    case("12: parallel to a generator from (4.1, 5.2, 3.3)", "a = 0: the textbook formula in f32 gives 4.0")
        .on(DoubleCone(2.0 / 3.0))
        .at([1.1, 2.2, 3.3], X)
        .ray([4.1, 5.2, 3.3], [3.0, 2.0, 0.0])
        .hits(&[exit(Side, "-4.5069390943299866164")])
        .f64_adds_beyond(1e9),
    case("13: through the apex of a nappe", "k/a is 0/0 at the apex")
        .on(Nappe(1.0))
        .at([0.0, 0.0, 0.0], X)
        .ray([0.0, 0.0, 1.0], [0.0, 0.0, -1.0])
        .hits(&[touch(Side, "1")]),
    case("13: parallel to a generator into the nappe", "a = 0, and the root of the other nappe")
        .on(Nappe(1.0))
        .at([0.0, 0.0, 0.0], X)
        .ray([0.0, 1.0, 0.0], [1.0, -1.0, 0.0])
        .hits(&[enter(Side, "0.7071067811865475244")]),
    case("13: parallel to a generator, into no nappe", "the other nappe is reported")
        .on(Nappe(1.0))
        .at([0.0, 0.0, 0.0], X)
        .ray([0.0, 1.0, 0.0], [-1.0, -1.0, 0.0]),
    case("13: the same on the double cone", "a = 0")
        .on(DoubleCone(1.0))
        .at([0.0, 0.0, 0.0], X)
        .ray([0.0, 1.0, 0.0], [-1.0, -1.0, 0.0])
        .hits(&[enter(Side, "0.7071067811865475244")]),
    case("14: close to the apex from 100 away", "the apex drowns in the squares of 100")
        .on(Nappe(0.5))
        .at([0.0, 0.0, 0.0], Z)
        .ray([-100.0, 1e-4, 1e-3], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "99.999510102051443364"), exit(Side, "100.00048989794855664")]),
    case("14: past the apex from 100 away", "a hit where the cone is not")
        .on(Nappe(0.5))
        .at([0.0, 0.0, 0.0], Z)
        .ray([-100.0, 1e-3, 0.0], [1.0, 0.0, 0.0]),
    case("15: the outer of two shells, from its surface", "a start on the surface meets itself, or misses its far end")
        .on(Ball(1.00004))
        .ray([0.0, 0.0, 1.00004], [0.0, 0.0, -1.0])
        .hits(&[enter(Side, "0"), exit(Side, "2.00008")]),
    case("15: the inner of two shells, from the outer one", "a fixed epsilon jumps over it")
        .on(Ball(1.0))
        .ray([0.0, 0.0, 1.00004], [0.0, 0.0, -1.0])
        .hits(&[enter(Side, "4e-5"), exit(Side, "2.00004")]),
];
