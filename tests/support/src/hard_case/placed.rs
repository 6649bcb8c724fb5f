//! Solids that stand aslant, or far from the world's origin: where the placement rounds.

use super::Axis::{To, X, Y, Z};
use super::Kind::{Ball, Can, Cone, Disc, Frustum, Pill, Plane, Skirt};
use super::{Case, TO_THE_END, case, enter, exit, touch};
use raylet::Part::{Base, Side, Top};

/// See the head of this file.
pub const PLACED: [Case; 17] = [
    case("a capsule between two points, across", "the axis is rounded, and the ray with it")
        .on(Pill(0.5, TO_THE_END))
        .at([1.0, 2.0, 3.0], To([4.0, 6.0, 15.0]))
        .ray([2.5, 4.0, 20.0], [0.0, 0.0, -1.0])
        .hits(&[enter(Side, "9.7"), exit(Side, "12.3")]),
    case("a cylinder between two points, along its axis", "d.d - (d.a)^2 is all rounding error")
        .on(Can(0.5, TO_THE_END))
        .at([1.0, 2.0, 3.0], To([4.0, 6.0, 15.0]))
        .ray([-2.0, -2.0, -9.125], [3.0, 4.0, 12.0])
        .hits(&[enter(Base, "13.115384615384615385"), exit(Top, "26.115384615384615385")]),
    case("a cylinder between two points, from inside", "the start is rounded on its way into the frame")
        .on(Can(0.5, TO_THE_END))
        .at([1.0, 2.0, 3.0], To([4.0, 6.0, 15.0]))
        .ray([2.5, 4.0, 9.0], [12.0, 0.0, -3.0])
        .hits(&[enter(Side, "-0.5"), exit(Side, "0.5")])
        .inside(),
    case("a cone between two points, from its open end", "the apex is rounded")
        .on(Cone(0.25, TO_THE_END))
        .at([1.0, 2.0, 3.0], To([4.0, 6.0, 15.0]))
        .ray([5.0, 7.0, 20.0], [-0.3125, -0.375, -1.0])
        .hits(&[enter(Top, "5.164073963589806601"), exit(Side, "12.66806528415915103")]),
    case("a frustum between two points, across", "two radii, and a height that is rounded")
        .on(Frustum(1.0, 0.25, TO_THE_END))
        .at([1.0, 2.0, 3.0], To([4.0, 6.0, 15.0]))
        .ray([-5.0, 4.0, 9.0], [1.0, 0.0625, 0.125])
        .hits(&[enter(Side, "7.2331385509194704945"), exit(Side, "8.3925752120869085006")]),
    case("an open frustum between two points", "two radii, and a height that is rounded")
        .on(Skirt(0.25, 1.0, TO_THE_END))
        .at([1.0, 2.0, 3.0], To([4.0, 6.0, 15.0]))
        .ray([-5.0, 4.0, 9.0], [1.0, 0.0625, 0.125])
        .hits(&[enter(Side, "7.1224572786162102126"), exit(Side, "8.5633434360455824857")]),
    case("a cylinder between two points, 1e-7 off its axis", "a = 1e-14 beside the rounding of the frame")
        .on(Can(0.5, TO_THE_END))
        .at([1.0, 2.0, 3.0], To([4.0, 6.0, 15.0]))
        .ray([-2.0, -2.0, -9.125], [3.0000003, 4.0, 12.0])
        .hits(&[enter(Base, "13.115384615384618691"), exit(Top, "26.115384615384621968")]),
    case("1.75 above a planet, straight down", "the difference of two coordinates is rounded")
        .on(Ball(6371000.0))
        .at([0.0, -6371000.0, 0.0], Y)
        .ray([0.0, 1.75, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "1.75"), exit(Side, "12742001.75")]),
    case(".1 above a planet, aslant", "the difference of two coordinates is rounded")
        .on(Ball(6371000.0))
        .at([0.0, -6371000.0, 0.0], Y)
        .ray([0.0, 0.1, 0.0], [3.0, -4.0, 0.0])
        .hits(&[enter(Side, "0.12500000055181683112"), exit(Side, "10193600.034999999448")]),
    case("a sphere far from the world's origin, from near by", "the difference of two coordinates is rounded")
        .on(Ball(0.3))
        .at([7998.3, 5000.7, 2998.9], Y)
        .ray([8000.1, 5000.1, 3000.1], [-2.0, 1.0, -1.5])
        .hits(&[enter(Side, "2.1037758383440124045"), exit(Side, "2.352912277905232311")]),
    case("a lying cylinder far from the world's origin", "the difference of two coordinates is rounded")
        .on(Can(0.3, 1.7))
        .at([7999.1, 5000.2, 3000.1], X)
        .ray([8000.1, 5001.4, 3000.1], [-0.3, -1.0, 0.1])
        .hits(&[enter(Side, "0.95889546902670902345"), exit(Side, "1.5333235761300867318")]),
    case("a cone on its side, from its inside", "an exit and no entry")
        .on(Cone(0.5, 4.0))
        .at([4.0, 2.0, 1.0], X)
        .ray([7.0, 2.25, 1.0], [-0.25, 0.5, 0.125])
        .hits(&[enter(Top, "-2.2912878474779200033"), exit(Side, "1.1234803792583296991")])
        .inside(),
    case("a disc on a wall", "a disc that faces along x")
        .on(Disc(1.5))
        .at([1.0, 2.0, 7.0], X)
        .ray([9.0, 2.5, -3.0], [-3.0, -0.25, 4.0])
        .hits(&[enter(Side, "13.349989596333857152")]),
    case("a plane far away", "the difference of two coordinates is rounded")
        .on(Plane)
        .at([0.0, 0.0, -2000.7], Z)
        .ray([0.3, 0.1, 0.0], [1.0, 0.0, -3.0])
        .hits(&[enter(Side, "2108.9229715662921765")]),
    case("a sphere grazed, far from the world's origin", "the difference of two coordinates is rounded")
        .on(Ball(0.5))
        .at([1000.0, 2000.0, -3000.0], Y)
        .ray([1000.0, 2000.4990234375, -4000.0], [0.0, 0.0, 1.0])
        .hits(&[enter(Side, "999.9687652625161729"), exit(Side, "1000.0312347374838271")]),
    case("a lying capsule grazed at its seam", "seam and tangent, beside an axis along x")
        .on(Pill(0.5, 2.0))
        .at([10.0, 2.0, 3.0], X)
        .ray([12.0, 2.5, -4.0], [0.0, 0.0, 1.0])
        .hits(&[touch(Side, "7")]),
    case("a standing disc touched in its plane", "0 / 0, beside an axis along z")
        .on(Disc(1.5))
        .at([1.0, 2.0, 7.0], Z)
        .ray([-5.0, 3.5, 7.0], [1.0, 0.0, 0.0])
        .lies(Some("6"), Some("6")),
];
