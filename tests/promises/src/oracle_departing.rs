//! The oracle's answer for a line that departs from a solid: from a point that lies on the surface exactly, it is the
//! ordinary answer without the point itself; from one that does not, the roots are 0 and `-2k/a`, and nothing is before
//! the start.

use support::amount::times;
use support::oracle::{
    Answer, ConeExtent, CylinderExtent, Dyadic, ExpectedHit, Leaving, Line, Part, Root, Solid, gradient, hits_in_range,
    solve, solve_departing,
};
use support::random::Random;

fn whole(value: i64) -> Dyadic {
    Dyadic::from(value)
}

fn point(v: [i64; 3]) -> [Dyadic; 3] {
    v.map(whole)
}

type OnSurface = ([i64; 3], Part);

/// Solids, and points of their parts with whole coordinates, clear of rims, seams and apexes.
fn solids() -> Vec<(Solid, Vec<OnSurface>)> {
    let radius = || whole(5);
    let wall: Vec<_> = [[3, 2, 4], [-4, 5, 3], [0, 1, -5], [5, 7, 0]].map(|v| (v, Part::Side)).to_vec();
    let caps = [([1, 0, 2], Part::Base), ([-2, 8, 1], Part::Top)];
    let cone: Vec<_> = [[3, 5, 4], [-4, 5, 3], [0, 2, -2], [6, 10, 8]].map(|v| (v, Part::Side)).to_vec();
    let balls = [([3, -4, 0], Part::Base), ([0, -3, 4], Part::Base), ([3, 12, 0], Part::Top), ([-4, 11, 0], Part::Top)];
    let cylinder = |extent| Solid::Cylinder { radius: radius(), extent };
    let slope = |extent| Solid::Cone { slope: whole(1), extent };
    let frustum = |capped| Solid::Frustum { base_radius: whole(2), top_radius: whole(10), height: whole(8), capped };
    // The frustum's wall is the cone's, two lower.
    let lower: Vec<_> =
        cone[..3].iter().filter(|(v, _)| v[1] > 2).map(|([x, y, z], part)| ([*x, y - 2, *z], *part)).collect();
    vec![
        (
            Solid::Sphere { radius: radius() },
            [[3, 0, 4], [0, -4, 3], [0, 5, 0], [-3, 4, 0]].map(|v| (v, Part::Side)).to_vec(),
        ),
        (cylinder(CylinderExtent::Infinite), wall.clone()),
        (cylinder(CylinderExtent::Open(whole(8))), wall.clone()),
        (cylinder(CylinderExtent::Capped(whole(8))), [&wall[..], &caps].concat()),
        (Solid::Capsule { radius: radius(), height: whole(8) }, [&wall[..], &balls].concat()),
        (slope(ConeExtent::Double), [&cone[..], &[([3, -5, 4], Part::Side)]].concat()),
        (slope(ConeExtent::Nappe), cone.clone()),
        (slope(ConeExtent::Open(whole(12))), cone.clone()),
        (slope(ConeExtent::Capped(whole(12))), [&cone[..], &[([2, 12, 7], Part::Top)]].concat()),
        (frustum(false), lower.clone()),
        (frustum(true), [&lower[..], &[([1, 0, 1], Part::Base), ([4, 8, -5], Part::Top)]].concat()),
        (Solid::Plane, vec![([3, 0, -2], Part::Side)]),
        (Solid::Disc { radius: radius() }, vec![([3, 0, -2], Part::Side)]),
        (
            Solid::Cuboid { half: point([5, 4, 3]) },
            vec![
                ([-5, 1, 2], Part::Left),
                ([5, -1, 0], Part::Right),
                ([1, -4, 2], Part::Base),
                ([0, 4, 1], Part::Top),
                ([2, 1, -3], Part::Back),
                ([-1, 0, 3], Part::Front),
            ],
        ),
        (Solid::Rectangle { half: [whole(5), whole(3)] }, vec![([-4, 0, 2], Part::Side)]),
        (
            Solid::Triangle { vertices: [point([0, 0, 0]), point([0, 0, 8]), point([8, 0, 0])] },
            vec![([2, 0, 3], Part::Side)],
        ),
    ]
}

fn ahead(answer: &Answer) -> Vec<ExpectedHit> {
    hits_in_range(answer, &Dyadic::zero(), None).hits
}

fn dot(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> Dyadic {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// The side to which the line leaves its start; `None` along the surface.
fn leaving(solid: &Solid, part: Part, line: &Line) -> Option<Leaving> {
    let normal = gradient(solid, part, &Root::from(&Dyadic::zero()), line);
    match dot(&normal, &line.direction).signum() {
        0 => None,
        1 => Some(Leaving::Outwards),
        _ => Some(Leaving::Inwards),
    }
}

#[test]
fn from_a_point_of_the_surface_all_is_met_but_the_point() {
    let (mut random, mut judged) = (Random(19), 0);
    for _ in 0..times(200) {
        for (solid, points) in solids() {
            for (start, part) in points {
                let whole_number = |random: &mut Random| random.below(13) as i64 - 6;
                let direction = [(); 3].map(|()| whole_number(&mut random));
                if direction == [0; 3] {
                    continue;
                }
                let line = Line::new(point(start), point(direction));
                let Some(leaving) = leaving(&solid, part, &line) else { continue };
                let mut want = ahead(&solve(&solid, &line));
                want.retain(|hit| hit.t.signum() != 0);
                let got = ahead(&solve_departing(&solid, &line, part, leaving));
                assert_eq!(got, want, "{solid:?} from {start:?} on {part:?} {leaving:?} along {direction:?}");
                judged += 1;
            }
        }
    }
    assert!(judged > 5_000, "{judged} lines");
}

#[test]
fn from_beside_the_surface_the_far_end_is_that_of_its_own_polynomial() {
    let unit = |v: [f64; 3]| v.map(support::oracle::exact_f64);
    let ends = |solid: &Solid, origin: [f64; 3], direction: [f64; 3], part| {
        let line = Line::new(unit(origin), unit(direction));
        let hits = ahead(&solve_departing(solid, &line, part, Leaving::Inwards));
        hits.into_iter().map(|hit| (hit.t.to_f64(), hit.part)).collect::<Vec<_>>()
    };
    let ball = Solid::Sphere { radius: whole(5) };
    // -2 k / a of the start as it is, outside and inside.
    assert_eq!(ends(&ball, [5.5, 0.0, 0.0], [-1.0, 0.0, 0.0], Part::Side), [(11.0, Part::Side)]);
    assert_eq!(ends(&ball, [4.5, 0.0, 0.0], [-2.0, 0.0, 0.0], Part::Side), [(4.5, Part::Side)]);
    // The direction contradicts what is said of it: the end is at the start.
    assert_eq!(ends(&ball, [5.0, 0.0, 0.0], [1.0, 0.0, 0.0], Part::Side), [(0.0, Part::Side)]);
    let can = Solid::Cylinder { radius: whole(5), extent: CylinderExtent::Capped(whole(8)) };
    // From the top, whose height is the start's; the base and the wall keep the coordinates.
    assert_eq!(ends(&can, [1.0, 8.5, 0.0], [0.0, -1.0, 0.0], Part::Top), [(8.5, Part::Base)]);
    assert_eq!(ends(&can, [1.0, 8.5, 0.0], [1.0, -0.5, 0.0], Part::Top), [(4.0, Part::Side)]);
    assert_eq!(ends(&can, [1.0, 8.5, 0.0], [0.0, 1.0, 0.0], Part::Top), [(0.0, Part::Top)]);
    // Beside the wall at the rim, it ends at once; parallel to it, at the other cap.
    assert_eq!(ends(&can, [5.5, 8.0, 0.0], [1.0, -1.0, 0.0], Part::Top), [(0.0, Part::Side)]);
    assert_eq!(ends(&can, [5.5, 8.0, 0.0], [0.0, -1.0, 0.0], Part::Top), [(8.0, Part::Base)]);
    // From the wall, beyond the base, which lies behind.
    assert_eq!(ends(&can, [5.0, -0.5, 0.0], [-1.0, -1.0, 0.0], Part::Side), [(0.0, Part::Base)]);
    let pill = Solid::Capsule { radius: whole(5), height: whole(8) };
    assert_eq!(ends(&pill, [5.5, 4.0, 0.0], [-1.0, 0.0, 0.0], Part::Side), [(11.0, Part::Side)]);
    assert_eq!(ends(&pill, [0.0, 13.5, 0.0], [0.0, -1.0, 0.0], Part::Top), [(18.5, Part::Base)]);
}
