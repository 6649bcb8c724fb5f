//! Rays that touch, or nearly: a ten-millionth inside and a ten-millionth outside.

use super::Kind::{Ball, Can, Disc, Frustum, Nappe, Pill, Pipe, Plane, Triangle, Tube};
use super::{Case, case, enter, exit, touch};
use raylet::Part::{Side, Top};

/// See the head of this file.
pub const GRAZING: [Case; 26] = [
    case("sphere grazed 1e-7 inside", "two hits fall together")
        .on(Ball(1.0))
        .ray([-4.0, 0.9999999, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.9995527864156803821"), exit(Side, "4.0004472135843196179")]),
    case("cylinder grazed 1e-7 inside", "two hits fall together")
        .on(Can(1.0, 2.0))
        .ray([-4.0, 0.5, 0.9999999], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.9995527864156803821"), exit(Side, "4.0004472135843196179")]),
    case("slanted past an infinite cylinder, 1e-7 inside", "two hits fall together")
        .on(Tube(1.0))
        .ray([-4.0, -4.0, 0.9999999], [1.0, 1.0, 0.0])
        .hits(&[enter(Side, "5.6562217939761579078"), exit(Side, "5.6574867050086024826")]),
    case("capsule grazed 1e-7 inside at its end", "two hits fall together")
        .on(Pill(1.0, 2.0))
        .ray([-4.0, 2.9999999, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Top, "3.9995527864156803821"), exit(Top, "4.0004472135843196179")]),
    case("cone grazed 1e-7 inside", "two hits fall together")
        .on(Nappe(0.5))
        .ray([-4.0, 2.0, 0.9999999], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.9995527864156803821"), exit(Side, "4.0004472135843196179")]),
    case("frustum grazed 1e-7 inside at its middle", "two hits fall together")
        .on(Frustum(1.5, 0.5, 2.0))
        .ray([-4.0, 1.0, 0.9999999], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.9995527864156803821"), exit(Side, "4.0004472135843196179")]),
    case("disc met 1e-7 inside its rim", "the rim is decided by a rounded point")
        .on(Disc(1.0))
        .ray([0.9999999, 3.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "3")]),
    case("triangle met 1e-7 inside its edge", "the edge is decided by a rounded point")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([0.25, 3.0, -0.9999999], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "3")]),
    case("sphere grazed 1e-7 outside", "a touch is invented")
        .on(Ball(1.0))
        .ray([-4.0, 1.0000001, 0.0], [1.0, 0.0, 0.0]),
    case("cylinder grazed 1e-7 outside", "a touch is invented")
        .on(Can(1.0, 2.0))
        .ray([-4.0, 0.5, 1.0000001], [1.0, 0.0, 0.0]),
    case("slanted past an infinite cylinder, 1e-7 outside", "a touch is invented")
        .on(Tube(1.0))
        .ray([-4.0, -4.0, 1.0000001], [1.0, 1.0, 0.0]),
    case("capsule grazed 1e-7 outside at its end", "a touch is invented")
        .on(Pill(1.0, 2.0))
        .ray([-4.0, 3.0000001, 0.0], [1.0, 0.0, 0.0]),
    case("cone grazed 1e-7 outside", "a touch is invented").on(Nappe(0.5)).ray([-4.0, 2.0, 1.0000001], [1.0, 0.0, 0.0]),
    case("frustum grazed 1e-7 outside at its middle", "a touch is invented")
        .on(Frustum(1.5, 0.5, 2.0))
        .ray([-4.0, 1.0, 1.0000001], [1.0, 0.0, 0.0]),
    case("disc met 1e-7 outside its rim", "the rim is decided by a rounded point")
        .on(Disc(1.0))
        .ray([1.0000001, 3.0, 0.0], [0.0, -1.0, 0.0]),
    case("triangle met 1e-7 outside its edge", "the edge is decided by a rounded point")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([0.25, 3.0, -1.0000001], [0.0, -1.0, 0.0]),
    case("cylinder grazed 1e-7 above the plane of its cap", "the plane of the cap is taken for the cap")
        .on(Can(1.0, 2.0))
        .ray([-4.0, 2.0000001, 0.0], [1.0, 0.0, 0.0]),
    case("cylinder grazed 1e-7 below the plane of its cap", "the plane of the cap is taken for a miss")
        .on(Can(1.0, 2.0))
        .ray([-4.0, 1.9999999, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3"), exit(Side, "5")]),
    case("sphere touched aslant", "a tangent in two rounded components")
        .on(Ball(1.25))
        .ray([-3.0, 1.25, -4.0], [3.0, 0.0, 4.0])
        .hits(&[touch(Side, "5")]),
    case("cylinder touched across", "a touch counts twice, or not at all")
        .on(Can(1.0, 2.0))
        .ray([-3.0, 0.5, 1.0], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "3")]),
    case("open cylinder touched from inside the slab", "a touch of an open surface")
        .on(Pipe(1.0, 2.0))
        .ray([-3.0, 0.5, -1.0], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "3")]),
    case("cone touched across", "a touch away from the apex")
        .on(Nappe(0.5))
        .ray([-3.0, 2.0, 1.0], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "3")]),
    case("capsule touched at its seam", "the seam and the touch are one point")
        .on(Pill(1.0, 2.0))
        .ray([-3.0, 2.0, 1.0], [1.0, 0.0, 0.0])
        .hits(&[touch(Side, "3")]),
    case("capsule touched at its end", "the touch of a round end")
        .on(Pill(1.0, 2.0))
        .ray([-3.0, 3.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[touch(Top, "3")]),
    case("plane approached at 1e-7", "oy / dy of a small dy")
        .on(Plane)
        .ray([0.0, 0.0000005, 0.0], [1.0, -1e-7, 0.0])
        .hits(&[enter(Side, "5.000000000000025")]),
    case("plane left at 1e-7", "the crossing lies behind")
        .on(Plane)
        .ray([0.0, 0.0000005, 0.0], [1.0, 1e-7, 0.0])
        .hits(&[exit(Side, "-5.000000000000025")]),
];
