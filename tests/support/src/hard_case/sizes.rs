//! Far, tiny, huge and planet-sized: where squares overflow, underflow, or drown what is small; and the largest and
//! smallest sizes of the number types.

use super::Axis::Y;
use super::Kind::{Ball, Can, Cone, Disc, Frustum, Pill, Triangle};
use super::{Case, case, enter, exit, touch, two_to};
use raylet::Part::{Base, Side, Top};

/// See the head of this file.
pub const SIZES: [Case; 33] = [
    case("cylinder from 10,000 away", "the wall drowns in the square of 10,000")
        .on(Can(1.0, 2.0))
        .ray([10000.0, 1.0, 0.75], [-1.0, 0.0, 0.0])
        .hits(&[enter(Side, "9999.3385621722338524"), exit(Side, "10000.661437827766148")]),
    case("cone from 8,192 away", "products of far coordinates with the slope")
        .on(Cone(0.5, 4.0))
        .ray([-8192.0, 3.0, 0.5], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "8190.585786437626905"), exit(Side, "8193.414213562373095")]),
    case("capsule from 10,000 away, aslant", "both coordinates are far")
        .on(Pill(1.0, 2.0))
        .ray([-5999.6, 0.5, -8000.3], [3.0, 0.0, 4.0])
        .hits(&[enter(Side, "9999.1339745962155614"), exit(Side, "10000.866025403784439")]),
    case("frustum from 60 away, into the top", "the cap is met beside the side")
        .on(Frustum(1.0, 0.5, 2.0))
        .ray([0.25, 60.0, 0.125], [0.0, -1.0, 0.0])
        .hits(&[enter(Top, "58"), exit(Base, "60")]),
    case("sphere from 1e30 away", "the step closer is larger than the sphere by 1e30")
        .on(Ball(1.0))
        .ray([-1e30, 0.5, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "1e30"), exit(Side, "1e30")]),
    case("triangle from 1,000 away", "volumes of far edges cancel")
        .on(Triangle([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.5, 0.0]]))
        .ray([0.25, 0.125, -1000.0], [0.0, 0.0, 1.0])
        .hits(&[exit(Side, "1000")]),
    case("sphere of radius 1e-20", "squares underflow in f32")
        .on(Ball(1e-20))
        .ray([-3e-20, 0.5e-20, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "2.1339745962155613532e-20"), exit(Side, "3.8660254037844386468e-20")]),
    case("cylinder of radius 1e-30", "squares underflow in f32")
        .on(Can(1e-30, 1e-30))
        .ray([-3e-30, 0.5e-30, 0.5e-30], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "2.1339745962155613532e-30"), exit(Side, "3.8660254037844386468e-30")]),
    case("sphere of radius 2^-146", "a subnormal radius has no square in f32")
        .on(Ball(two_to(-146)))
        .ray([-3.0 * two_to(-146), 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "2.2420775429197073135e-44"), exit(Side, "4.484155085839414627e-44")]),
    case("cone of height 2^-140", "a subnormal height")
        .on(Cone(0.5, two_to(-140)))
        .ray([0.0, 3.0 * two_to(-140), 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Top, "1.4349296274686126806e-42"), exit(Side, "2.1523944412029190209e-42")]),
    case("capsule of 2^-12 from 1 away", "sixteen units in I16F16, one in I20F12")
        .on(Pill(two_to(-12), two_to(-12)))
        .ray([-1.0, two_to(-13), 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "0.999755859375"), exit(Side, "1.000244140625")]),
    case("sphere of one unit of I16F16", "a radius of one raw unit")
        .on(Ball(two_to(-16)))
        .ray([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "0.9999847412109375"), exit(Side, "1.0000152587890625")]),
    case("cylinder of one unit of I8F24", "a radius of one raw unit")
        .on(Can(two_to(-24), 1.0))
        .ray([-1.0, 0.5, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "0.99999994039535522461"), exit(Side, "1.0000000596046447754")]),
    case("disc of one unit of I32F32", "a radius of one raw unit")
        .on(Disc(two_to(-32)))
        .ray([0.0, 1.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "1")]),
    case("sphere as large as I16F16 takes", "raw 2^30: products fill the double width")
        .on(Ball(16384.0))
        .ray([-16384.0, 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "0"), exit(Side, "32768")]),
    case("capsule as large as I8F24 takes", "raw 2^30")
        .on(Pill(64.0, 64.0))
        .ray([0.0, 64.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "-64"), exit(Side, "64")])
        .inside(),
    case("cylinder as large as I20F12 takes", "raw 2^30: the far wall lies beyond the type")
        .on(Can(262144.0, 262144.0))
        .ray([-262144.0, 131072.0, 262144.0], [0.0, 0.0, -1.0])
        .hits(&[touch(Side, "262144")]),
    case("frustum as large as I32F32 takes", "raw 2^62")
        .on(Frustum(1073741824.0, 536870912.0, 1073741824.0))
        .ray([-1073741824.0, 536870912.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "268435456"), exit(Side, "1879048192")]),
    case("cone across half of I16F16", "raw 2^29 times the slope")
        .on(Cone(1.0, 8192.0))
        .ray([-16384.0, 4096.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "12288"), exit(Side, "20480")]),
    case("sphere of radius 1e20", "squares overflow in f32")
        .on(Ball(1e20))
        .ray([-3e20, 0.5e20, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "2.1339745962155613532e20"), exit(Side, "3.8660254037844386468e20")]),
    case("cone of height 1e20", "squares overflow in f32")
        .on(Cone(1.0, 1e20))
        .ray([2e20, 0.5e20, 0.0], [-1.0, 0.0, 0.0])
        .hits(&[enter(Side, "150000000000000000000"), exit(Side, "250000000000000000000")]),
    case("capsule of 1e20, slanted ray", "squares overflow in f32")
        .on(Pill(1e20, 1e20))
        .ray([3e20, 4e20, 0.0], [-3.0, -4.0, 0.0])
        .hits(&[enter(Top, "340000000000000000000"), exit(Base, "600000000000000000000")]),
    case("frustum of 1e20", "squares overflow in f32")
        .on(Frustum(1e20, 0.5e20, 1e20))
        .ray([0.0, -1e20, 0.25e20], [0.0, 1.0, 0.0])
        .hits(&[enter(Base, "100000000000000000000"), exit(Top, "200000000000000000000")]),
    case("sphere of radius 2^126, from its surface", "the far end is near the largest finite f32")
        .on(Ball(two_to(126)))
        .ray([-two_to(126), 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "0"), exit(Side, "1.7014118346046923173e38")]),
    case("disc of radius 2^126", "the rim of the largest disc")
        .on(Disc(two_to(126)))
        .ray([two_to(125), two_to(126), 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "8.5070591730234615866e37")]),
    case("triangle of 1e37", "volumes of the third power overflow")
        .on(Triangle([[-1e37, 0.0, -1e37], [1e37, 0.0, -1e37], [0.0, 0.0, 1e37]]))
        .ray([1e36, 1e37, 1e36], [0.0, -1.0, 0.0])
        .hits(&[exit(Side, "1e37")]),
    case("a subnormal sphere from 1 away", "2^-149 beside 1")
        .on(Ball(two_to(-149)))
        .ray([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "1"), exit(Side, "1")]),
    case("to the horizon of a planet", "two metres beside 6,371,000")
        .on(Ball(6371000.0))
        .at([0.0, -6371000.0, 0.0], Y)
        .ray([0.0, 1.75, 0.0], [1.0, -0.0008, 0.0])
        .hits(&[enter(Side, "3178.7630584719760027"), exit(Side, "7014.8364795766937339")]),
    case("over the horizon of a planet", "two metres beside 6,371,000")
        .on(Ball(6371000.0))
        .at([0.0, -6371000.0, 0.0], Y)
        .ray([0.0, 1.75, 0.0], [1.0, -0.0007, 0.0]),
    case("a planet from orbit", "400,000 beside 6,371,000")
        .on(Ball(6371000.0))
        .at([0.0, -6371000.0, 0.0], Y)
        .ray([0.0, 400000.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Side, "400000"), exit(Side, "13142000")]),
    case("a planet from within, to the surface above", "0.5 beside 6,371,000")
        .on(Ball(6371000.0))
        .at([0.0, -6371000.0, 0.0], Y)
        .ray([0.0, -0.5, 0.0], [0.0, 1.0, 0.0])
        .hits(&[enter(Side, "-12741999.5"), exit(Side, "0.5")])
        .inside(),
    case("the largest capsule of I16F16, across", "the far end lies beyond the type")
        .on(Pill(16384.0, 16384.0))
        .ray([16384.0, 15360.0, 16384.0], [-1.0, 0.0, -1.0])
        .hits(&[enter(Side, "6786.4750059207892796"), exit(Side, "39554.47500592078928")]),
    case("a large capsule of I8F24, across", "the far end lies beyond the type")
        .on(Pill(40.0, 64.0))
        .ray([64.0, 50.0, 64.0], [-1.0, 0.0, -1.0])
        .hits(&[enter(Side, "50.509667991878083123"), exit(Side, "130.50966799187808312")]),
];
