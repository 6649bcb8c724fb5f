//! Parallel to an axis or to a generator, exactly and to a ten-millionth: where `a` is zero, or all rounding.

use super::Kind::{Can, Cone, DoubleCone, Frustum, Horn, Nappe, Pill, Pipe, Skirt, Tube};
use super::{Case, case, enter, exit};
use raylet::Part::{Base, Side, Top};

/// See the head of this file.
pub const PARALLEL: [Case; 27] = [
    case("along the axis of a cylinder", "a = 0")
        .on(Can(1.0, 2.0))
        .ray([0.25, -7.0, 0.5], [0.0, 1.0, 0.0])
        .hits(&[enter(Base, "7"), exit(Top, "9")]),
    case("1e-7 off the axis of a cylinder, inside", "a = 1e-14 beside 1")
        .on(Can(1.0, 2.0))
        .ray([0.25, -7.0, 0.5], [1e-7, 1.0, 0.0])
        .hits(&[enter(Base, "7.000000000000035"), exit(Top, "9.000000000000045")]),
    case("1e-7 off the axis of an infinite cylinder", "the ends lie ten million away")
        .on(Tube(1.0))
        .ray([0.5, 0.0, 0.0], [1e-7, 1.0, 0.0])
        .hits(&[enter(Side, "-15000000.000000075"), exit(Side, "5000000.000000025")])
        .inside(),
    case("1e-7 off the axis, outside the wall", "the tube is met far beyond the cap")
        .on(Can(1.0, 2.0))
        .ray([1.0001, -3.0, 0.0], [-1e-7, 1.0, 0.0]),
    case("along the axis of an infinite cylinder, inside", "a = 0 and c < 0: no end at all")
        .on(Tube(1.0))
        .ray([0.5, 0.0, 0.0], [0.0, 1.0, 0.0])
        .inside(),
    case("along the axis of an open cylinder, inside", "the openings are taken for caps")
        .on(Pipe(1.0, 2.0))
        .ray([0.5, -3.0, 0.0], [0.0, 1.0, 0.0]),
    case("in the wall of an infinite cylinder", "0/0")
        .on(Tube(1.0))
        .ray([1.0, 0.0, 0.0], [0.0, -1.0, 0.0])
        .lies(None, None),
    case("in the wall of an open cylinder", "0/0")
        .on(Pipe(1.0, 2.0))
        .ray([0.0, -3.0, -1.0], [0.0, 1.0, 0.0])
        .lies(Some("3"), Some("5")),
    case("in the wall of a straight frustum", "a frustum of equal radii is a cylinder")
        .on(Frustum(1.0, 1.0, 2.0))
        .ray([1.0, 5.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "3"), exit(Side, "5")]),
    case("in the wall of an open straight frustum", "a frustum of equal radii is a cylinder")
        .on(Skirt(1.0, 1.0, 2.0))
        .ray([1.0, 5.0, 0.0], [0.0, -1.0, 0.0])
        .lies(Some("3"), Some("5")),
    case("in the wall of a capsule", "from seam to seam, where the balls touch the line")
        .on(Pill(1.0, 2.0))
        .ray([1.0, -4.0, 0.0], [0.0, 1.0, 0.0])
        .hits(&[enter(Side, "4"), exit(Side, "6")]),
    case("along the axis of a capsule", "a = 0, and the round ends alone")
        .on(Pill(1.0, 2.0))
        .ray([0.0, 6.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Top, "3"), exit(Base, "7")]),
    case("beside a capsule, along its axis", "the ball is met, or not")
        .on(Pill(1.0, 2.0))
        .ray([0.75, -4.0, 0.5], [0.0, 1.0, 0.0])
        .hits(&[enter(Base, "3.5669872981077806766"), exit(Top, "6.4330127018922193234")]),
    case("parallel to a generator, outside", "a = 0: one root, not none")
        .on(DoubleCone(1.0))
        .ray([3.0, 1.0, 0.0], [1.0, 1.0, 0.0])
        .hits(&[exit(Side, "-2.8284271247461900976")]),
    case("parallel to a generator of a nappe, inside", "a = 0: no exit")
        .on(Nappe(1.0))
        .ray([1.0, 3.0, 0.0], [1.0, 1.0, 0.0])
        .hits(&[enter(Side, "-2.8284271247461900976")])
        .inside(),
    case("parallel to a generator of a capped cone", "a = 0, and out through the cap")
        .on(Cone(1.0, 5.0))
        .ray([1.0, 3.0, 0.0], [1.0, 1.0, 0.0])
        .hits(&[enter(Side, "-2.8284271247461900976"), exit(Top, "2.8284271247461900976")])
        .inside(),
    case("parallel to a generator of the lower nappe", "a = 0, and the nappe that is not there")
        .on(Nappe(1.0))
        .ray([3.0, 1.0, 0.0], [-1.0, -1.0, 0.0]),
    case("1e-7 off a generator", "the second root lies ten million away")
        .on(DoubleCone(1.0))
        .ray([3.0, 1.0, 0.0], [1.0, 1.0000001, 0.0])
        .hits(&[exit(Side, "-2.8284271247461936331"), enter(Side, "28284272.661675498704")]),
    case("1e-7 off a generator, the other side", "the second root lies ten million away")
        .on(DoubleCone(1.0))
        .ray([3.0, 1.0, 0.0], [1.0000001, 1.0, 0.0])
        .hits(&[enter(Side, "-28284272.661675498704"), exit(Side, "-2.8284271247461936331")]),
    case("1e-7 off a generator of a capped cone", "the second root lies beyond the cap")
        .on(Cone(1.0, 5.0))
        .ray([1.0, 3.0, 0.0], [1.0, 1.0000001, 0.0])
        .hits(&[enter(Side, "-2.8284271247461936331"), exit(Top, "2.828426983324851538")])
        .inside(),
    case("1e-7 off a generator of a frustum", "the second root lies beyond the caps")
        .on(Frustum(2.0, 1.0, 1.0))
        .ray([0.0, 1.5, 0.0], [1.0, -0.9999999, 0.0])
        .hits(&[enter(Top, "0.70710681654189100315"), exit(Base, "2.1213204496256730094")]),
    case("parallel to a generator of a frustum", "a = 0 with a base radius")
        .on(Frustum(2.0, 1.0, 1.0))
        .ray([-3.0, 3.5, 0.0], [1.0, -1.0, 0.0])
        .hits(&[enter(Top, "3.535533905932737622"), exit(Base, "4.9497474683058326708")]),
    case("along a generator of the double cone", "f = 0 everywhere")
        .on(DoubleCone(1.0))
        .ray([2.0, 2.0, 0.0], [1.0, 1.0, 0.0])
        .lies(None, None),
    case("along a generator of a nappe", "f = 0 everywhere, and the apex ends it")
        .on(Nappe(1.0))
        .ray([2.0, 2.0, 0.0], [-1.0, -1.0, 0.0])
        .lies(None, Some("2.8284271247461900976")),
    case("along a generator of an open cone", "f = 0 everywhere, and apex and rim end it")
        .on(Horn(1.0, 3.0))
        .ray([-1.0, -1.0, 0.0], [1.0, 1.0, 0.0])
        .lies(Some("1.4142135623730950488"), Some("5.6568542494923801952")),
    case("along a generator of a capped cone", "from the apex to the rim")
        .on(Cone(1.0, 3.0))
        .ray([-1.0, -1.0, 0.0], [1.0, 1.0, 0.0])
        .hits(&[enter(Side, "1.4142135623730950488"), exit(Side, "5.6568542494923801952")]),
    case("along a generator of a widening frustum", "from rim to rim")
        .on(Frustum(1.0, 3.0, 2.0))
        .ray([0.0, -1.0, 0.0], [1.0, 1.0, 0.0])
        .hits(&[enter(Side, "1.4142135623730950488"), exit(Side, "4.2426406871192851464")]),
];
