//! Cuboids and rectangles: who owns edges and corners, rays in faces, placed cuboids beside the oracle, and surface
//! coordinates.

use raylet::scalar::UnitScalar;
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{
    Crossing, Cuboid, Departure, Frame, Hits, Leaving, Object, Part, Range, Ray, Rectangle, Shape, SizeError, UnitVec3,
    Vec3,
};
use support::amount::times;
use support::cases::{direction, n, v};
use support::exact_types::Exact as Number;
use support::measure::{measure_each, measure_placed};
use support::method::Method;
use support::placed::PLACINGS;
use support::subject::Subject;
use support::workload::{FURTHER, WORKLOADS};

use Crossing::{Enter, Exit, Touch};
use Part::{Back, Base, Front, Left, Right, Side, Top};

every_type!(
    ends_at_edges_belong_to_the_first_of_their_faces,
    one_point_of_an_edge_is_touched,
    a_rectangle_holds_its_edges,
    departing_rays_meet_the_far_faces,
    faces_have_normals_coordinates_and_tangents,
    placed_boxes_break_no_promise,
);

fn brick<S: Number>() -> Cuboid<S> {
    Cuboid::new(n(2.0), n(1.0), n(3.0)).expect("sizes")
}

/// The hits of a line in every tier that the type has.
fn in_tiers<S: Number>(shape: &Shape<S>, ray: Ray<S>) -> [Hits<S>; 3] {
    [shape.hits_at::<Plain>(&ray), shape.hits_at::<Fast>(&ray), shape.hits_at::<Stable>(&ray)]
}

fn line<S: Number>(origin: [f64; 3], along: [f64; 3]) -> Ray<S> {
    Ray::new(v(origin), direction(along)).expect("a ray").with_range(Range::line())
}

/// Origin and direction, and `t` and part of both ends.
type Row = ([f64; 3], [f64; 3], [(f64, Part); 2]);

/// Rays along the axes, in faces and edges.
const ALONG_AXES: [Row; 14] = [
    ([0.5, 5.0, 0.5], [0.0, -1.0, 0.0], [(4.0, Top), (6.0, Base)]),
    ([5.0, 0.5, 0.5], [-1.0, 0.0, 0.0], [(3.0, Right), (7.0, Left)]),
    ([0.5, 0.5, -5.0], [0.0, 0.0, 1.0], [(2.0, Back), (8.0, Front)]),
    // In a face.
    ([-5.0, 1.0, 0.0], [1.0, 0.0, 0.0], [(3.0, Left), (7.0, Right)]),
    ([0.0, 1.0, -5.0], [0.0, 0.0, 1.0], [(2.0, Back), (8.0, Front)]),
    ([2.0, -5.0, 0.0], [0.0, 1.0, 0.0], [(4.0, Right), (6.0, Right)]),
    ([-2.0, 0.0, 5.0], [0.0, 0.0, -1.0], [(2.0, Left), (8.0, Left)]),
    ([0.0, 5.0, 3.0], [0.0, -1.0, 0.0], [(4.0, Front), (6.0, Front)]),
    ([-5.0, 0.0, -3.0], [1.0, 0.0, 0.0], [(3.0, Left), (7.0, Right)]),
    ([0.0, -1.0, 5.0], [0.0, 0.0, -1.0], [(2.0, Front), (8.0, Back)]),
    // In an edge, from corner to corner.
    ([2.0, 1.0, -5.0], [0.0, 0.0, 1.0], [(2.0, Right), (8.0, Right)]),
    ([-5.0, 1.0, 3.0], [1.0, 0.0, 0.0], [(3.0, Left), (7.0, Right)]),
    ([-2.0, -5.0, 3.0], [0.0, 1.0, 0.0], [(4.0, Left), (6.0, Left)]),
    ([5.0, -1.0, -3.0], [-1.0, 0.0, 0.0], [(3.0, Right), (7.0, Left)]),
];

fn ends_at_edges_belong_to_the_first_of_their_faces<S: Number>() {
    let shape = Shape::new(brick::<S>());
    for (origin, along, ends) in ALONG_AXES {
        for hits in in_tiers(&shape, line(origin, along)) {
            let got: Vec<_> = hits.iter().map(|hit| (hit.t.to_f64(), hit.part, hit.crossing)).collect();
            let [(enter, first), (exit, last)] = ends;
            assert_eq!(got, [(enter, first, Enter), (exit, last, Exit)], "{origin:?} {along:?}");
            assert_eq!(hits.coincident(), None);
        }
    }
    // A hair beside a face: nothing.
    let beside = 2.0 + 1.0 / 1024.0;
    assert!(in_tiers(&shape, line([beside, 0.0, 5.0], [0.0, 0.0, -1.0])).iter().all(|hits| hits.is_empty()));
    // From corner to corner of a cube.
    let cube = Shape::new(Cuboid::new(n::<S>(1.0), n::<S>(1.0), n::<S>(1.0)).expect("sizes"));
    for hits in in_tiers(&cube, line([-2.0; 3], [1.0; 3])) {
        assert_eq!(hits.iter().map(|hit| hit.part).collect::<Vec<_>>(), [Left, Right]);
    }
}

fn one_point_of_an_edge_is_touched<S: Number>() {
    let shape = Shape::new(brick::<S>());
    // Both components of a direction have the same bits, so that the ends are exactly one point.
    let rows = [
        ([1.0, 2.0, 0.0], [1.0, -1.0, 0.0], Right),
        ([-1.0, 2.0, 0.5], [-1.0, -1.0, 0.0], Left),
        ([1.0, 0.0, 4.0], [1.0, 0.0, -1.0], Right),
        ([0.0, 0.0, 4.0], [0.0, 1.0, -1.0], Front),
        ([0.5, -2.0, -2.0], [0.0, 1.0, -1.0], Back),
        // At corners.
        ([1.0, 2.0, 3.0], [1.0, -1.0, 0.0], Right),
        ([-2.0, 0.0, 4.0], [0.0, 1.0, -1.0], Left),
    ];
    for (origin, along, owner) in rows {
        let ray = line(origin, along);
        // The cheaper tiers promise nothing of a chord of no length.
        let hits = shape.hits_at::<Stable>(&ray);
        assert_eq!(hits.iter().map(|hit| (hit.part, hit.crossing)).collect::<Vec<_>>(), [(owner, Touch)]);
        assert!(shape.occludes(&ray) && !shape.hits(&ray).starts_inside());
    }
}

fn a_rectangle_holds_its_edges<S: Number>() {
    let table = Shape::new(Rectangle::new(n::<S>(2.0), n(3.0)).expect("sizes"));
    for (x, z) in [(2.0, 0.0), (-2.0, 3.0), (0.5, -3.0), (2.0, -3.0)] {
        for (y, crossing) in [(4.0, Enter), (-4.0, Exit)] {
            for hits in in_tiers(&table, line([x, y, z], [0.0, -y, 0.0])) {
                let got: Vec<_> = hits.iter().map(|hit| (hit.t.to_f64(), hit.part, hit.crossing)).collect();
                assert_eq!(got, [(4.0, Side, crossing)], "{x} {y} {z}");
            }
        }
    }
    let beside = 1.0 / 1024.0;
    for (x, z) in [(2.0 + beside, 0.0), (0.0, -3.0 - beside)] {
        assert!(in_tiers(&table, line([x, 4.0, z], [0.0, -1.0, 0.0])).iter().all(|hits| hits.is_empty()));
    }
    let overlap = |origin, along| {
        let hits = table.hits(&line(origin, along));
        assert!(hits.is_empty());
        hits.coincident().map(|range| (range.start().to_f64(), range.end().to_f64()))
    };
    assert_eq!(overlap([-5.0, 0.0, 1.0], [1.0, 0.0, 0.0]), Some((3.0, 7.0)));
    assert_eq!(overlap([-5.0, 0.0, 3.0], [1.0, 0.0, 0.0]), Some((3.0, 7.0)));
    assert_eq!(overlap([-5.0, 0.0, 3.5], [1.0, 0.0, 0.0]), None);
    assert_eq!(overlap([-5.0, 0.5, 0.0], [1.0, 0.0, 0.0]), None);
    // Through a corner: a single point.
    assert!(overlap([1.0, 0.0, 4.0], [1.0, 0.0, -1.0]).is_some_and(|(start, end)| start == end));
}

fn departing_rays_meet_the_far_faces<S: Number>() {
    let shape = Shape::new(brick::<S>());
    let leave = |origin, along, part, leaving| {
        let ray = line::<S>(origin, along).with_range(Range::FORWARD).departing(Departure { object: 0, part, leaving });
        in_tiers(&shape, ray).map(|hits| hits.iter().map(|hit| (hit.t.to_f64(), hit.part)).collect::<Vec<_>>())
    };
    for (origin, along, ends) in ALONG_AXES {
        let [(enter, first), (exit, last)] = ends;
        let start = [0, 1, 2].map(|i| origin[i] + along[i] * enter);
        let far = vec![(exit - enter, last)];
        assert_eq!(leave(start, along, first, Leaving::Inwards), [(); 3].map(|()| far.clone()), "{start:?} {along:?}");
        assert_eq!(leave(start, along, first, Leaving::Outwards), [(); 3].map(|()| vec![]));
    }
    // Said to lead inwards, it leads outwards: it ends where it starts.
    assert_eq!(leave([0.0, 1.0, 0.0], [0.0, 1.0, 0.0], Top, Leaving::Inwards), [(); 3].map(|()| vec![(0.0, Top)]));
    // The same from a point that rounding has put below the face, and nearly along it.
    let (below, along) = ([0.0, 0.0, 3.0 - 1.0 / 1024.0], [1.0, 0.0, 1.0 / 1_048_576.0]);
    assert_eq!(leave(below, along, Front, Leaving::Inwards), [(); 3].map(|()| vec![(0.0, Front)]));
    // Beside the face by its coordinates.
    let far = vec![(2.25, Base)];
    assert_eq!(leave([0.0, 1.25, 0.0], [0.0, -1.0, 0.0], Top, Leaving::Inwards), [(); 3].map(|()| far.clone()));
}

fn faces_have_normals_coordinates_and_tangents<S: Number>() {
    let shape = Shape::new(brick::<S>());
    let (x, y, z) = (UnitVec3::<S>::X, UnitVec3::<S>::Y, UnitVec3::<S>::Z);
    // The origin, the face, its normal, the coordinates, and the directions in which they grow.
    let rows = [
        ([-5.0, 0.5, 1.5], Left, -x, (0.75, 0.75), (z, y)),
        ([5.0, 0.5, 1.5], Right, x, (0.25, 0.75), (-z, y)),
        ([1.0, 0.5, -5.0], Back, -z, (0.25, 0.75), (-x, y)),
        ([1.0, 0.5, 5.0], Front, z, (0.75, 0.75), (x, y)),
        ([1.0, 5.0, 1.5], Top, y, (0.75, 0.75), (x, z)),
        ([1.0, -5.0, 1.5], Base, -y, (0.75, 0.75), (x, z)),
    ];
    for (origin, part, normal, (u, v), tangents) in rows {
        let ray = line::<S>(origin, (-normal).to_f64());
        let hit = shape.nearest(&ray).expect("a hit");
        let surface = shape.surface(&ray, &hit);
        assert_eq!((hit.part, surface.normal(), surface.tangents()), (part, normal, tangents));
        let (got_u, got_v) = surface.uv();
        assert_eq!([got_u.to_f64(), got_v.to_f64()], [u, v], "{part:?}");
        assert!(shape.contains(surface.point()));
    }
    let table = Shape::new(Rectangle::new(n::<S>(2.0), n(3.0)).expect("sizes"));
    let ray = line::<S>([1.0, 5.0, -1.5], [0.0, -1.0, 0.0]);
    let surface = table.surface(&ray, &table.nearest(&ray).expect("a hit"));
    let (u, v) = surface.uv();
    assert_eq!(([u.to_f64(), v.to_f64()], surface.normal()), ([0.75, 0.25], y));
    assert!(!shape.contains(self::v([2.5, 0.0, 0.0])) && shape.contains(self::v([2.0, 1.0, 3.0])));
}

/// No promise of a tier is broken at any workload, in the world and placed.
fn break_no_promise<S: Number>(methods: &[Method<S>]) {
    let (mut rays, mut seed) = (0, 100);
    for subject in ["cuboid", "rectangle"].map(Subject::<S>::new) {
        for workload in WORKLOADS.into_iter().chain(FURTHER) {
            let unplaced = measure_each(methods, &subject, workload, times(60) as usize, seed, |_| true);
            let placed = PLACINGS.map(|placing| {
                // Stretched by more than any tier promises, all but `Plain` keep their promises all the same.
                let own = |method: &&Method<S>| placing.is_promised() || method.tier != "Plain";
                let methods: Vec<_> = methods.iter().filter(own).copied().collect();
                let any = placing.has(workload);
                any.then(|| measure_placed(&methods, &subject, workload, placing, times(60) as usize, seed)).flatten()
            });
            seed += 1;
            for row in [unplaced].into_iter().chain(placed).flatten().flatten() {
                rays += row.rays;
                let name = || format!("{} in {}, {}", subject.name, S::name(), workload.name());
                assert_eq!(row.broken, 0, "{}: {:?}", name(), row.worst.map(|worst| worst.told));
            }
        }
    }
    assert!(rays > 5_000, "{rays}");
}

fn placed_boxes_break_no_promise<S: Number>() {
    break_no_promise::<S>(&[
        Method::tier::<Plain>("Plain"),
        Method::tier::<Fast>("Fast"),
        Method::tier::<Stable>("Stable"),
    ]);
}

#[test]
fn exact_is_never_wrong() {
    fn check<S: Number>()
    where
        Exact: Tier<S>,
    {
        break_no_promise::<S>(&[Method::tier::<Exact>("Exact")]);
        let shape = Shape::new(brick::<S>());
        for (origin, along, ends) in ALONG_AXES {
            let hits = shape.hits_at::<Exact>(&line(origin, along));
            assert_eq!([0, 1].map(|i| (hits[i].t.to_f64(), hits[i].part)), ends);
        }
    }
    check::<f32>();
    check::<fixed::types::I16F16>();
}

#[test]
fn sizes_are_checked_and_faces_have_materials() {
    for bad in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        assert!(matches!(Cuboid::new(1.0, bad, 1.0), Err(SizeError::HalfExtent(_))));
        assert!(matches!(Rectangle::new(1.0, bad), Err(SizeError::HalfExtent(_))));
    }
    let object = Object::new(Shape::new(brick::<f32>()), 0).with_base(1).with_top(2);
    let materials = [Left, Right, Back, Front, Base, Top].map(|part| object.material_of(part));
    assert_eq!(materials, [0, 0, 0, 0, 1, 2]);
    // A box in a frame is as tight as the frame allows.
    let turned =
        Shape::new(brick::<f32>()).placed(Frame::from_base_and_axis(Vec3::ZERO, UnitVec3::X).expect("a frame"));
    let reach = turned.bounds().high.to_array().map(f32::abs);
    assert!(reach[0] >= 1.0 && reach[0] <= 1.000_001, "{reach:?}");
}
