//! Where parts meet: the apex, rims, the planes of caps, seams; and starts on and next to a surface.

use super::Kind::{Ball, Can, Cone, DoubleCone, Frustum, Horn, Nappe, Pill, Pipe};
use super::{Case, case, enter, exit, touch};
use raylet::Part::{Base, Side, Top};

/// See the head of this file.
pub const CORNERS: [Case; 36] = [
    case("along the axis through the apex", "0/0 at the apex")
        .on(Cone(1.0, 1.0))
        .ray([0.0, -2.0, 0.0], [0.0, 1.0, 0.0])
        .hits(&[enter(Side, "2"), exit(Top, "3")]),
    case("along the axis of a double cone", "exit and enter at the same point")
        .on(DoubleCone(0.5))
        .ray([0.0, -3.0, 0.0], [0.0, 1.0, 0.0])
        .hits(&[exit(Side, "3"), enter(Side, "3")])
        .inside(),
    case("through the apex of a capped cone, across", "one touch")
        .on(Cone(0.5, 2.0))
        .ray([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "3")]),
    case("through the apex of an open cone, across", "one touch")
        .on(Horn(0.5, 2.0))
        .ray([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "3")]),
    case("through the apex into an open cone", "the apex is the only crossing")
        .on(Horn(1.0, 2.0))
        .ray([-0.25, -1.0, 0.0], [0.25, 1.0, 0.0])
        .hits(&[enter(Side, "1.0307764064044151375")]),
    case("through the apex of a pointed frustum", "the apex is the top")
        .on(Frustum(1.0, 0.0, 2.0))
        .ray([-3.0, 2.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "3")]),
    case("down into a pointed frustum through its apex", "the apex is no cap")
        .on(Frustum(1.0, 0.0, 2.0))
        .ray([0.0, 5.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "3"), exit(Base, "5")]),
    case("past the apex by 1e-7", "the apex is taken for hit").on(Nappe(1.0)).ray([-3.0, 0.0, 1e-7], [1.0, 0.0, 0.0]),
    case("under the apex by 1e-7", "the nappe below is reported")
        .on(Nappe(1.0))
        .ray([-3.0, -1e-7, 0.0], [1.0, 0.0, 0.0]),
    case("just above the apex by 1e-7", "both hits within 2e-7")
        .on(Nappe(1.0))
        .ray([-3.0, 1e-7, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "2.9999999"), exit(Side, "3.0000001")]),
    case("from the apex inwards", "a start at 0/0")
        .on(Cone(1.0, 2.0))
        .ray([0.0, 0.0, 0.0], [0.0, 1.0, 0.0])
        .hits(&[enter(Side, "0"), exit(Top, "2")]),
    case("from the apex outwards", "a start at 0/0")
        .on(Cone(1.0, 2.0))
        .ray([0.0, 0.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Top, "-2"), exit(Side, "0")])
        .inside(),
    case("rim to rim of a cylinder, through its axis", "hits doubled, or lost")
        .on(Can(1.0, 2.0))
        .ray([-2.0, -1.0, 0.0], [1.0, 1.0, 0.0])
        .hits(&[enter(Side, "1.4142135623730950488"), exit(Side, "4.2426406871192851464")]),
    case("a rim of a cylinder touched", "a touch that is side and cap")
        .on(Can(1.0, 2.0))
        .ray([0.0, 3.0, 0.0], [1.0, -1.0, 0.0])
        .hits(&[touch(Side, "1.4142135623730950488")]),
    case("rim to rim of a frustum", "hits doubled, or lost")
        .on(Frustum(3.0, 1.0, 4.0))
        .ray([-5.0, -2.0, 0.0], [1.0, 1.0, 0.0])
        .hits(&[enter(Side, "2.8284271247461900976"), exit(Side, "8.4852813742385702928")]),
    case("rim of a capped cone touched", "a touch that is side and cap")
        .on(Cone(1.0, 2.0))
        .ray([1.0, 3.0, 0.0], [1.0, -1.0, 0.0])
        .hits(&[touch(Side, "1.4142135623730950488")]),
    case("in the plane of the cap of a cone", "division by zero")
        .on(Cone(1.0, 2.0))
        .ray([-5.0, 2.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3"), exit(Side, "7")]),
    case("in the plane of the base of a frustum", "division by zero")
        .on(Frustum(1.0, 0.5, 2.0))
        .ray([0.0, 0.0, -4.0], [0.0, 0.0, 1.0])
        .hits(&[enter(Side, "3"), exit(Side, "5")]),
    case("in the plane of the top of a widening frustum", "division by zero")
        .on(Frustum(0.5, 1.25, 2.0))
        .ray([-4.0, 2.0, 0.75], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3"), exit(Side, "5")]),
    case("in the plane of a cap, beside it", "a miss by 0/0").on(Can(1.0, 2.0)).ray([-4.0, 2.0, 1.5], [1.0, 0.0, 0.0]),
    case("in the plane of a cap, touching the rim", "a touch in the plane of a cap")
        .on(Can(1.0, 2.0))
        .ray([-4.0, 0.0, 1.0], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "4")]),
    case("seam to seam of a capsule", "both ends belong to the side")
        .on(Pill(1.0, 2.0))
        .ray([-2.0, -1.0, 0.0], [1.0, 1.0, 0.0])
        .hits(&[enter(Side, "1.4142135623730950488"), exit(Side, "4.2426406871192851464")]),
    case("a capsule without a side", "the seam is the equator")
        .on(Pill(1.0, 0.0))
        .ray([-2.0, 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "1"), exit(Side, "3")]),
    case("an open cylinder left at its rim", "the rim belongs to the surface")
        .on(Pipe(1.0, 2.0))
        .ray([0.0, 4.0, 0.0], [0.25, -1.0, 0.0])
        .hits(&[exit(Side, "4.1231056256176605498")]),
    case("from a rim inwards", "a start on side and cap")
        .on(Can(1.0, 2.0))
        .ray([1.0, 2.0, 0.0], [-1.0, -1.0, 0.0])
        .hits(&[enter(Side, "0"), exit(Side, "2.8284271247461900976")]),
    case("from a cap inwards", "a start on a cap meets itself")
        .on(Can(1.0, 2.0))
        .ray([0.25, 0.0, 0.5], [0.0, 1.0, 0.0])
        .hits(&[enter(Base, "0"), exit(Top, "2")]),
    case("from a cap outwards", "a start on a cap meets itself")
        .on(Can(1.0, 2.0))
        .ray([0.25, 0.0, 0.5], [0.0, -1.0, 0.0])
        .hits(&[enter(Top, "-2"), exit(Base, "0")])
        .inside(),
    case("from the side of a cylinder inwards", "a start on the side meets itself, or misses its far end")
        .on(Can(1.25, 2.0))
        .ray([0.75, 1.0, 1.0], [-3.0, 0.0, -4.0])
        .hits(&[enter(Side, "0"), exit(Side, "2.5")]),
    case("from just above the surface", "an epsilon hides the near hit")
        .on(Ball(1.0))
        .ray([1.000001, 0.0, 0.0], [-1.0, 0.0, 0.0])
        .hits(&[enter(Side, "1e-6"), exit(Side, "2.000001")]),
    case("from just below the surface, outwards", "an epsilon hides the exit")
        .on(Ball(1.0))
        .ray([0.999999, 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "-1.999999"), exit(Side, "1e-6")])
        .inside(),
    case("from just above the surface, outwards", "a hit that lies behind")
        .on(Ball(1.0))
        .ray([1.000001, 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "-2.000001"), exit(Side, "-1e-6")]),
    case("from inside a capsule", "an entry is invented")
        .on(Pill(1.0, 2.0))
        .ray([0.25, 0.5, -0.25], [0.0, 0.0, 1.0])
        .hits(&[enter(Side, "-0.71824583655185422129"), exit(Side, "1.2182458365518542213")])
        .inside(),
    case("aslant through the apex of a nappe", "the touch is given to the nappe that is not there")
        .on(Nappe(0.5))
        .ray([1.0, 1.0, 0.0], [-1.0, -1.0, 0.0])
        .hits(&[touch(Side, "1.4142135623730950488")]),
    case("aslant through the apex of a capped cone", "the touch is given to the nappe that is not there")
        .on(Cone(0.5, 2.0))
        .ray([-3.0, 0.0, -3.0], [1.0, 0.0, 1.0])
        .hits(&[touch(Side, "4.2426406871192851464")]),
    case("from above through the apex of a capped cone", "the touch is given to the nappe that is not there")
        .on(Cone(0.5, 2.0))
        .ray([0.0, 3.0, 3.0], [0.0, -1.0, -1.0])
        .hits(&[touch(Side, "4.2426406871192851464")]),
    case("aslant through the apex of a double cone", "the touch of both nappes")
        .on(DoubleCone(0.5))
        .ray([1.0, 1.0, 0.0], [-1.0, -1.0, 0.0])
        .hits(&[touch(Side, "1.4142135623730950488")]),
];
