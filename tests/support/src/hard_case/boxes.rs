//! Cuboids and rectangles: faces, edges and corners.

use super::Kind::{Box, Rectangle};
use super::{Case, case, enter, exit, touch};
use raylet::Part::{Back, Base, Front, Left, Right, Side, Top};

/// See the head of this file.
pub const BOXES: [Case; 13] = [
    case("along an edge of a cuboid", "0 / 0 at two pairs of planes")
        .on(Box([2.0, 1.0, 3.0]))
        .ray([2.0, 1.0, -5.0], [0.0, 0.0, 1.0])
        .hits(&[enter(Right, "2"), exit(Right, "8")]),
    case("in a face of a cuboid, aslant", "0 / 0 at a pair of planes")
        .on(Box([2.0, 1.0, 3.0]))
        .ray([-5.0, 1.0, 0.0], [4.0, 0.0, 3.0])
        .hits(&[enter(Left, "3.75"), exit(Front, "5")]),
    case("in the right face of a cuboid", "the ends are on edges that the right face owns")
        .on(Box([2.0, 1.0, 3.0]))
        .ray([2.0, -5.0, 0.5], [0.0, 1.0, 0.0])
        .hits(&[enter(Right, "4"), exit(Right, "6")]),
    case("a cuboid touched at an edge", "the planes are crossed at the same t")
        .on(Box([2.0, 1.0, 3.0]))
        .ray([1.0, 2.0, 0.0], [1.0, -1.0, 0.0])
        .hits(&[touch(Right, "1.4142135623730950488")]),
    case("a cuboid touched at a corner", "the planes are crossed at the same t, in a face")
        .on(Box([2.0, 1.0, 3.0]))
        .ray([-2.0, 2.0, 2.0], [0.0, -1.0, 1.0])
        .hits(&[touch(Left, "1.4142135623730950488")]),
    case("past an edge of a cuboid", "the planes are crossed at nearly the same t")
        .on(Box([2.0, 1.0, 3.0]))
        .ray([1.0, 2.0009765625, 0.0], [1.0, -1.0, 0.0]),
    case("from inside a cuboid", "one end behind the start")
        .on(Box([2.0, 1.0, 3.0]))
        .ray([0.5, 0.0, 0.0], [3.0, 0.0, 4.0])
        .hits(&[enter(Back, "-3.75"), exit(Right, "2.5")])
        .inside(),
    case("parallel beside a face of a cuboid", "y / 0")
        .on(Box([2.0, 1.0, 3.0]))
        .ray([2.0009765625, 5.0, 0.0], [0.0, -1.0, 0.0]),
    case("a plate", "a height of 1/512")
        .on(Box([8.0, 0.0009765625, 8.0]))
        .ray([0.0, 5.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Top, "4.9990234375"), exit(Base, "5.0009765625")]),
    case("a rectangle on its edge", "the edge belongs to it")
        .on(Rectangle([1.5, 0.5]))
        .ray([1.5, 2.0, 0.25], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "2")]),
    case("beside a rectangle, just off its edge", "the edge decides")
        .on(Rectangle([1.5, 0.5]))
        .ray([1.0, -2.0, 0.5009765625], [0.0, 1.0, 0.0]),
    case("in the plane of a rectangle, across", "0 / 0")
        .on(Rectangle([1.5, 0.5]))
        .ray([-4.0, 0.0, 0.25], [1.0, 0.0, 0.0])
        .lies(Some("2.5"), Some("5.5")),
    case("in the plane of a rectangle, through a corner", "a piece of one point")
        .on(Rectangle([1.5, 0.5]))
        .ray([0.5, 0.0, 1.5], [1.0, 0.0, -1.0])
        .lies(Some("1.4142135623730950488"), Some("1.4142135623730950488")),
];
