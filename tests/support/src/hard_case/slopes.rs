//! Needles and flat cones, frustums of every taper, open and infinite variants, double cones; zeros of either sign.

use super::Kind::{Can, Cone, DoubleCone, Frustum, Nappe, Pipe, Skirt, Tube};
use super::{Case, case, enter, exit};
use raylet::Part::{Base, Side, Top};

/// See the head of this file.
pub const SLOPES: [Case; 29] = [
    case("a needle across", "the slope squared is 1e-6 beside 1")
        .on(Cone(0.001, 10.0))
        .ray([-1.0, 8.0, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "0.992"), exit(Side, "1.008")]),
    case("a needle along its axis", "apex and cap, and no side")
        .on(Cone(0.001, 10.0))
        .ray([0.0, -1.0, 0.0], [0.0, 1.0, 0.0])
        .hits(&[enter(Side, "1"), exit(Top, "11")]),
    case("a needle beside its axis", "steep against the side, and the cap is 0.01 wide")
        .on(Cone(0.001, 10.0))
        .ray([0.005, -1.0, 0.0], [0.0, 1.0, 0.0])
        .hits(&[enter(Side, "6"), exit(Top, "11")]),
    case("a needle grazed near its tip", "the outline is 1e-4 there")
        .on(Nappe(0.001))
        .ray([-1.0, 0.1, 0.00005], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "0.99991339745962155614"), exit(Side, "1.0000866025403784439")]),
    case("a flat cone from above", "the slope squared is 1e6 beside 1")
        .on(Nappe(1000.0))
        .ray([3.0, 2.0, 4.0], [0.0, -1.0, 0.0])
        .hits(&[exit(Side, "1.995")])
        .inside(),
    case("a flat cone from below", "the slope squared is 1e6 beside 1")
        .on(Nappe(1000.0))
        .ray([3.0, -2.0, 4.0], [0.0, 1.0, 0.0])
        .hits(&[enter(Side, "2.005")]),
    case("a flat capped cone across", "a disc with a dent")
        .on(Cone(1000.0, 0.01))
        .ray([-20.0, 0.005, 0.0], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "15"), exit(Side, "25")]),
    case("a flat double cone, steeply", "both nappes close to the plane")
        .on(DoubleCone(1000.0))
        .ray([1.0, 1.0, 1.0], [-0.5, -1.0, -0.25])
        .hits(&[exit(Side, "1.1446107527589793481"), enter(Side, "1.1466760922801941215")])
        .inside(),
    case("down through a frustum", "base and top, and no side")
        .on(Frustum(1.0, 0.5, 2.0))
        .ray([0.25, 5.0, 0.25], [0.0, -1.0, 0.0])
        .hits(&[enter(Top, "3"), exit(Base, "5")]),
    case("into the side of a frustum and out of its base", "side and cap")
        .on(Frustum(1.0, 0.5, 2.0))
        .ray([2.0, 3.0, 0.0], [-3.0, -4.0, 0.0])
        .hits(&[enter(Side, "2.1875"), exit(Base, "3.75")]),
    case("across a widening frustum", "the apex lies below the base")
        .on(Frustum(0.5, 1.5, 2.0))
        .ray([-4.0, 1.0, 0.5], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.1339745962155613532"), exit(Side, "4.8660254037844386468")]),
    case("down beside the base of a widening frustum", "top and side, steep against the side")
        .on(Frustum(0.5, 1.5, 2.0))
        .ray([1.0, 5.0, 0.0], [0.0, -1.0, 0.0])
        .hits(&[enter(Top, "3"), exit(Side, "4")]),
    case("a pointed frustum across", "the apex is the top")
        .on(Frustum(1.0, 0.0, 2.0))
        .ray([-4.0, 1.0, 0.25], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.5669872981077806766"), exit(Side, "4.4330127018922193234")]),
    case("a pointed frustum that widens", "the apex is the base")
        .on(Frustum(0.0, 1.0, 2.0))
        .ray([-4.0, 1.0, 0.25], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.5669872981077806766"), exit(Side, "4.4330127018922193234")]),
    case("a straight frustum across", "its slope is zero")
        .on(Frustum(1.0, 1.0, 2.0))
        .ray([-4.0, 1.0, 0.75], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.3385621722338523524"), exit(Side, "4.6614378277661476476")]),
    case("beyond the apex of a frustum", "the other nappe is reported")
        .on(Frustum(1.0, 0.5, 2.0))
        .ray([-4.0, 6.0, 0.0], [1.0, 0.0, 0.0]),
    case("an open frustum through both openings", "the openings are taken for caps")
        .on(Skirt(1.0, 0.5, 2.0))
        .ray([0.0, 5.0, 0.25], [0.0, -1.0, 0.0]),
    case("an open frustum through its top into its side", "an exit alone")
        .on(Skirt(1.0, 0.5, 2.0))
        .ray([0.0, 3.0, 0.0], [3.0, -4.0, 0.0]),
    case("an open frustum across", "both crossings")
        .on(Skirt(0.5, 1.5, 2.0))
        .ray([-4.0, 1.0, 0.5], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.1339745962155613532"), exit(Side, "4.8660254037844386468")]),
    case("a double cone across both nappes", "out of one nappe and into the other")
        .on(DoubleCone(1.0))
        .ray([0.25, -3.0, 0.5], [0.0, 1.0, 0.0])
        .hits(&[exit(Side, "2.4409830056250525759"), enter(Side, "3.5590169943749474241")])
        .inside(),
    case("a double cone, aslant", "out of one nappe and into the other")
        .on(DoubleCone(0.5))
        .ray([1.0, -4.0, 0.0], [-0.25, 1.0, 0.125])
        .hits(&[exit(Side, "3.2229316915972991355"), enter(Side, "5.8388397952224188855")])
        .inside(),
    case("a double cone across one nappe", "the nappe below")
        .on(DoubleCone(0.75))
        .ray([-5.0, -2.0, 0.5], [1.0, 0.0, 0.0])
        .hits(&[enter(Side, "3.5857864376269049512"), exit(Side, "6.4142135623730950488")]),
    case("a nappe from inside, upwards", "no exit")
        .on(Nappe(1.0))
        .ray([0.5, 2.0, 0.0], [0.25, 1.0, 0.0])
        .hits(&[enter(Side, "-2.0615528128088302749")])
        .inside(),
    case("a nappe from inside, down and out", "an exit and no entry")
        .on(Nappe(1.0))
        .ray([0.5, 2.0, 0.0], [0.25, -1.0, 0.0])
        .hits(&[exit(Side, "1.2369316876852981649")])
        .inside(),
    case("an open cylinder through its opening", "an exit alone")
        .on(Pipe(1.0, 2.0))
        .ray([0.0, 4.0, 0.0], [0.375, -1.0, 0.0])
        .hits(&[exit(Side, "2.848001248439177056")]),
    case("an infinite cylinder aslant", "both ends, however high")
        .on(Tube(1.5))
        .ray([-40.0, 30.0, 0.5], [4.0, -3.0, 0.0])
        .hits(&[enter(Side, "48.232233047033631189"), exit(Side, "51.767766952966368811")]),
    case("negative zeros", "a sign of zero chooses the wrong cap")
        .on(Can(1.0, 2.0))
        .ray([-0.0, -3.0, -0.0], [-0.0, 1.0, -0.0])
        .hits(&[enter(Base, "3"), exit(Top, "5")]),
    case("negative zeros, downwards", "a sign of zero chooses the wrong cap")
        .on(Can(1.0, 2.0))
        .ray([-0.0, 5.0, 0.5], [0.0, -1.0, -0.0])
        .hits(&[enter(Top, "3"), exit(Base, "5")]),
    case("negative zeros across", "1 / -0 is minus infinity")
        .on(Cone(1.0, 2.0))
        .ray([-3.0, 1.0, -0.0], [1.0, -0.0, -0.0])
        .hits(&[enter(Side, "2"), exit(Side, "4")]),
];
