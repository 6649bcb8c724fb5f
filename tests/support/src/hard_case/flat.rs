//! Planes, discs and triangles: rims, edges, vertices, and rays in the plane.

use super::Kind::{Disc, Plane, Triangle};
use super::{Case, case, enter, exit};
use raylet::Part::Side;

/// See the head of this file.
pub const FLAT: [Case; 26] = [
    case("a plane from above", "the crossing is the front")
        .on(Plane)
        .ray([0.5, 3.0, 0.5], [3.0, -4.0, 0.0])
        .hits(&[enter(Side, "3.75")]),
    case("a plane from below", "the crossing is the back")
        .on(Plane)
        .ray([0.5, -3.0, 0.5], [0.0, 4.0, 3.0])
        .hits(&[exit(Side, "3.75")]),
    case("parallel above a plane", "y / 0").on(Plane).ray([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
    case("in a plane", "0 / 0").on(Plane).ray([2.0, 0.0, 3.0], [3.0, 0.0, -4.0]).lies(None, None),
    case("from a plane", "a start on the plane")
        .on(Plane)
        .ray([2.0, 0.0, 3.0], [3.0, 4.0, 0.0])
        .hits(&[exit(Side, "0")]),
    case("a disc on its rim", "the rim belongs to it")
        .on(Disc(1.5))
        .ray([1.5, 2.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "2")]),
    case("a disc on its rim, aslant", "the rim belongs to it")
        .on(Disc(1.5))
        .ray([-0.5, 2.0, 0.0], [1.0, -1.0, 0.0])
        .hits(&[enter(Side, "2.8284271247461900976")]),
    case("in the plane of a disc, across", "0 / 0")
        .on(Disc(1.5))
        .ray([-4.0, 0.0, 0.0], [1.0, 0.0, 0.0])
        .lies(Some("2.5"), Some("5.5")),
    case("in the plane of a disc, touching it", "a chord of one point")
        .on(Disc(1.5))
        .ray([-4.0, 0.0, 1.5], [1.0, 0.0, 0.0])
        .lies(Some("4"), Some("4")),
    case("in the plane of a disc, beside it", "0 / 0").on(Disc(1.5)).ray([-4.0, 0.0, 2.0], [1.0, 0.0, 0.0]),
    case("a disc from 1,000 along its plane", "a slope of 1/1000")
        .on(Disc(1.5))
        .ray([-1000.0, 1.0, 0.25], [1000.0, -1.0, 0.0])
        .hits(&[enter(Side, "1000.0004999998750001")]),
    case("a triangle on an edge", "the edge belongs to it")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([0.5, 2.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "2")]),
    case("a triangle on an edge, from below", "the edge belongs to it")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([0.25, -2.0, -1.0], [0.0, 1.0, 0.0])
        .hits(&[exit(Side, "2")]),
    case("a triangle on a vertex", "the vertex belongs to it")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([0.0, 2.0, 1.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "2")]),
    case("a triangle on a vertex, aslant", "the vertex belongs to it")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([1.0, 2.0, 1.0], [-1.0, -2.0, 0.0])
        .hits(&[enter(Side, "2.2360679774997896964")]),
    case("in the plane of a triangle, across", "0 / 0")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([-3.0, 0.0, -0.5], [1.0, 0.0, 0.0])
        .lies(Some("2.25"), Some("3.75")),
    case("in the plane of a triangle, along an edge", "0 / 0 at an edge")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([-3.0, 0.0, -1.0], [1.0, 0.0, 0.0])
        .lies(Some("2"), Some("4")),
    case("in the plane of a triangle, through a vertex", "a piece of one point")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([-3.0, 0.0, 1.0], [1.0, 0.0, 0.0])
        .lies(Some("3"), Some("3")),
    case("in the plane of a triangle, beside it", "0 / 0")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([-3.0, 0.0, 1.5], [1.0, 0.0, 0.0]),
    case("beside a triangle", "the plane is not the triangle")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([0.75, 2.0, 0.5], [0.0, -1.0, 0.0]),
    case("a slanted triangle", "no plane of coordinates")
        .on(Triangle([[2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 4.0]]))
        .ray([1.0, 1.0, -3.0], [0.0, 0.0, 1.0])
        .hits(&[exit(Side, "3.6666666666666666667")]),
    case("a sliver of a triangle", "a height of 1/1024")
        .on(Triangle([[-8.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 0.0, 0.0009765625]]))
        .ray([0.5, 2.0, 0.00048828125], [0.0, -1.0, 0.0])
        .hits(&[exit(Side, "2")]),
    case("a disc on its rim, from below", "the rim belongs to it")
        .on(Disc(1.25))
        .ray([0.75, -3.0, 1.0], [0.0, 1.0, 0.0])
        .hits(&[exit(Side, "3")]),
    case("a disc from above, just off its rim", "the rim decides")
        .on(Disc(1.25))
        .ray([0.75, 3.0, 1.0009765625], [0.0, -1.0, 0.0]),
    case("a triangle across its plane at 1/1000", "a normal nearly across the ray")
        .on(Triangle([[-1.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, -1.0]]))
        .ray([-1000.0, 1.0, -0.5], [1000.0, -1.0, 0.0])
        .hits(&[enter(Side, "1000.0004999998750001")]),
    case("a triangle with a vertex far out", "volumes of unequal size cancel")
        .on(Triangle([[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [0.0, 0.0, 0.03125]]))
        .ray([40.0, 5.0, 0.0078125], [0.0, -1.0, 0.0])
        .hits(&[exit(Side, "5")]),
];
