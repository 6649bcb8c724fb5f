//! Faults 6 and 12 of the first solver: when a ray starts inside; the degenerate rays that the table lacked; which
//! points a solid contains; and occlusion that agrees with the nearest hit for every size.

use crate::named::{any_frame, extreme_ray, extreme_solid, point_in, ray_in};
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{
    Capsule, Cone, Crossing, Cylinder, Disc, Frame, Hits, Part, Placement, Primitive, Range, Ray, Shape, Sphere,
    Triangle, UnitVec3, Vec3,
};
use support::amount::times;
use support::cases::{cases, direction, n, random_ray, summary, v};
use support::exact_types::Exact as Number;
use support::oracle::{self, Dyadic, Membership, Solid};
use support::random::{Random, add, scale};

promised!(
    a_start_on_the_surface_that_leaves_starts_inside,
    a_start_on_the_surface_that_enters_or_touches_does_not_start_inside,
    a_range_that_starts_at_an_end_starts_inside_where_it_leaves,
    a_line_through_the_apex_of_a_double_cone_passes_from_nappe_to_nappe,
    a_line_that_touches_a_rim_or_a_corner_in_its_own_plane_lies_in_it_over_one_point,
    what_is_more_than_a_unit_from_the_boundary_is_told_apart,
    occlusion_agrees_with_the_nearest_hit_for_every_size,
);

fn hits<S: Number, T: Tier<S>>(shape: &Shape<S>, from: [f64; 3], along: UnitVec3<S>, range: [f64; 2]) -> Hits<S> {
    let range = Range::new(n(range[0]), n(range[1])).expect("the ends are in order");
    let ray = Ray::new(v(from), along).expect("the origin is within the budget").with_range(range);
    let hits = shape.hits_at::<T>(&ray);
    assert_eq!(shape.nearest_at::<T>(&ray), hits.first().copied(), "{ray:?}");
    assert_eq!(shape.occludes_at::<T>(&ray), !hits.is_empty(), "{ray:?}");
    hits
}

const AHEAD: [f64; 2] = [0.0, 64.0];
const LINE: [f64; 2] = [-64.0, 64.0];

/// A solid with inside, a point of its surface, the direction straight out of it there, and the part.
type Place<S> = (Shape<S>, [f64; 3], UnitVec3<S>, Part);

fn places<S: Number>() -> Vec<Place<S>> {
    let sizes = "the sizes are within the budget";
    let shape = |primitive: Primitive<S>| Shape::new(primitive);
    let ball = shape(Sphere::new(n(1.0)).expect(sizes).into());
    let can = shape(Cylinder::capped(n(1.0), n(2.0)).expect(sizes).into());
    let pipe = shape(Cylinder::infinite(n(1.0)).expect(sizes).into());
    let capsule = shape(Capsule::new(n(1.0), n(2.0)).expect(sizes).into());
    let cone = shape(Cone::capped(n(0.5), n(2.0)).expect(sizes).into());
    let frustum = shape(Cone::frustum(n(1.0), n(0.5), n(2.0)).expect(sizes).into());
    let nappe = shape(Cone::nappe(n(1.0)).expect(sizes).into());
    let double = shape(Cone::double(n(1.0)).expect(sizes).into());
    let (x, y, z) = (UnitVec3::X, UnitVec3::Y, UnitVec3::Z);
    let (side, base, top) = (Part::Side, Part::Base, Part::Top);
    let mut places = vec![
        (ball, [0.0, 1.0, 0.0], y, side),
        (ball, [0.0, 0.0, -1.0], -z, side),
        (can, [1.0, 1.0, 0.0], x, side),
        (can, [0.5, 2.0, 0.0], y, top),
        (can, [0.5, 0.0, 0.0], -y, base),
        (can, [1.0, 2.0, 0.0], x, side),
        (pipe, [0.0, 5.0, 1.0], z, side),
        (capsule, [1.0, 1.0, 0.0], x, side),
        (capsule, [0.0, 3.0, 0.0], y, top),
        (capsule, [0.0, -1.0, 0.0], -y, base),
        (cone, [0.5, 1.0, 0.0], x, side),
        (cone, [0.25, 2.0, 0.0], y, top),
        (cone, [0.0, 0.0, 0.0], -y, side),
        (frustum, [0.75, 1.0, 0.0], x, side),
        (frustum, [0.25, 0.0, 0.0], -y, base),
        (nappe, [0.0, 2.0, 2.0], z, side),
        (double, [2.0, 2.0, 0.0], x, side),
        (double, [2.0, -2.0, 0.0], x, side),
    ];
    let frame = Frame::at(v([2.0, -1.0, 3.0])).expect("within the budget");
    let moved = |(shape, at, out, part): Place<S>| (shape.placed(frame), add(at, [2.0, -1.0, 3.0]), out, part);
    places.extend(places.clone().into_iter().map(moved));
    places
}

/// The interval holds points before the start, and the start: true, beside the hit at zero.
fn a_start_on_the_surface_that_leaves_starts_inside<S: Number, T: Tier<S>>(_: f64) {
    for (shape, at, out, part) in places::<S>() {
        let hits = hits::<S, T>(&shape, at, out, AHEAD);
        assert_eq!(summary(&hits).first(), Some(&(0.0, part, Crossing::Exit)), "{shape:?} from {at:?}");
        assert!(hits.len() == 1 && hits.starts_inside(), "{shape:?} from {at:?}: {hits:?}");
    }
}

/// The interval starts at the start, or is the start: false.
fn a_start_on_the_surface_that_enters_or_touches_does_not_start_inside<S: Number, T: Tier<S>>(_: f64) {
    for (shape, at, out, part) in places::<S>() {
        let entering = hits::<S, T>(&shape, at, -out, AHEAD);
        assert_eq!(summary(&entering).first(), Some(&(0.0, part, Crossing::Enter)), "{shape:?} from {at:?}");
        assert!(!entering.starts_inside(), "{shape:?} from {at:?}: {entering:?}");
    }
    let can = Shape::new(Cylinder::capped(n::<S>(1.0), n(2.0)).unwrap());
    let capsule = Shape::new(Capsule::new(n::<S>(1.0), n(2.0)).unwrap());
    let touched = [
        (Shape::new(Sphere::new(n::<S>(1.0)).unwrap()), [0.0, 1.0, 0.0], UnitVec3::X, Part::Side),
        (can, [1.0, 1.0, 0.0], UnitVec3::Z, Part::Side),
        // A cap's rim, in the cap's plane.
        (can, [1.0, 2.0, 0.0], UnitVec3::Z, Part::Side),
        (capsule, [1.0, 1.0, 0.0], UnitVec3::Z, Part::Side),
        (capsule, [0.0, 3.0, 0.0], UnitVec3::X, Part::Top),
        (Shape::new(Cone::capped(n(0.5), n(2.0)).unwrap()), [0.0, 0.0, 0.0], UnitVec3::X, Part::Side),
    ];
    for (shape, at, along, part) in touched {
        let touch = hits::<S, T>(&shape, at, along, AHEAD);
        assert_eq!(summary(&touch), [(0.0, part, Crossing::Touch)], "{shape:?} from {at:?}");
        assert!(!touch.starts_inside(), "{shape:?} from {at:?}: {touch:?}");
    }
}

/// Along the y axis a can is met from 1 to 3, and a range may start anywhere.
fn a_range_that_starts_at_an_end_starts_inside_where_it_leaves<S: Number, T: Tier<S>>(_: f64) {
    let can = Shape::new(Cylinder::capped(n::<S>(1.0), n(2.0)).unwrap());
    for (start, inside) in [(0.0, false), (1.0, false), (1.5, true), (3.0, true), (3.5, false)] {
        let hits = hits::<S, T>(&can, [0.0, -1.0, 0.0], UnitVec3::Y, [start, 64.0]);
        assert_eq!(hits.starts_inside(), inside, "from {start} on: {hits:?}");
    }
}

/// Steeper than the side it lies in both nappes, which meet at the apex: out of one and into the other at one t. Less
/// steep it touches the apex, and as steep it lies in the side.
fn a_line_through_the_apex_of_a_double_cone_passes_from_nappe_to_nappe<S: Number, T: Tier<S>>(_: f64) {
    let through = |t: f64| vec![(t, Part::Side, Crossing::Exit), (t, Part::Side, Crossing::Enter)];
    let at_rest = Frame::at(Vec3::ZERO).unwrap();
    for cone in [1.0, 0.5, 8.0].map(|slope| Shape::new(Cone::double(n::<S>(slope)).unwrap())) {
        for cone in [cone, cone.placed(at_rest)] {
            for (from, range, t) in [(-3.0, AHEAD, 3.0), (0.0, AHEAD, 0.0), (2.0, LINE, -2.0), (-3.0, [3.0, 64.0], 3.0)]
            {
                let hits = hits::<S, T>(&cone, [0.0, from, 0.0], UnitVec3::Y, range);
                assert_eq!(summary(&hits), through(t), "{cone:?} from {from}");
                // Points of the lower nappe lie before the start, up to it.
                assert!(hits.starts_inside() && hits.coincident().is_none(), "{hits:?}");
            }
            let from_beyond = hits::<S, T>(&cone, [0.0, -3.0, 0.0], UnitVec3::Y, [4.0, 64.0]);
            assert!(from_beyond.is_empty() && from_beyond.starts_inside(), "{from_beyond:?}");
            let across = hits::<S, T>(&cone, [-3.0, 0.0, 0.0], UnitVec3::X, AHEAD);
            assert_eq!(summary(&across), [(3.0, Part::Side, Crossing::Touch)], "{cone:?}");
            assert!(!across.starts_inside());
        }
    }
    // Not along the axis: from the apex, every stored direction passes through it. (Slope 1: 3 in 5 is steep, 4 in 5 is
    // not.)
    let cone = Shape::new(Cone::double(n::<S>(1.0)).unwrap());
    let steep = hits::<S, T>(&cone, [0.0; 3], direction([0.0, -4.0, 3.0]), LINE);
    assert_eq!(summary(&steep), through(0.0));
    assert!(steep.starts_inside());
    let flat = hits::<S, T>(&cone, [0.0; 3], direction([4.0, 3.0, 0.0]), LINE);
    assert_eq!(summary(&flat), [(0.0, Part::Side, Crossing::Touch)]);
    let along = hits::<S, T>(&cone, [0.0; 3], direction([1.0, 1.0, 0.0]), LINE);
    assert!(along.is_empty() && along.coincident().is_some() && !along.starts_inside(), "{along:?}");
}

fn a_line_that_touches_a_rim_or_a_corner_in_its_own_plane_lies_in_it_over_one_point<S: Number, T: Tier<S>>(_: f64) {
    let disc = Shape::new(Disc::new(n::<S>(1.5)).unwrap());
    let [a, b, c] = [[0.0, 0.0, 0.0], [1.5, 0.0, 0.0], [0.0, 0.0, 1.5]].map(v::<S>);
    let triangle = Shape::new(Triangle::new(a, b, c).unwrap());
    let at_rest = Frame::at(Vec3::ZERO).unwrap();
    for flat in [disc, triangle, disc.placed(at_rest), triangle.placed(at_rest)] {
        // Both have a point at x = 1.5, z = 0, and nothing beyond that x.
        for (from, range, t) in
            [(-2.0, AHEAD, Some(2.0)), (1.0, LINE, Some(-1.0)), (0.0, AHEAD, Some(0.0)), (1.0, AHEAD, None)]
        {
            let hits = hits::<S, T>(&flat, [1.5, 0.0, from], UnitVec3::Z, range);
            let over = hits.coincident().map(|over| (over.start().to_f64(), over.end().to_f64()));
            assert!(hits.is_empty() && !hits.starts_inside(), "{flat:?}: {hits:?}");
            assert_eq!(over, t.map(|t| (t, t)), "{flat:?} from {from}");
        }
        let beside = Vec3::new(n::<S>(1.5).next_up(), S::ZERO, n(-2.0));
        let beside = flat.hits_at::<T>(&Ray::new(beside, UnitVec3::Z).unwrap());
        assert!(beside.is_empty() && beside.coincident().is_none(), "{beside:?}");
    }
}

fn belongs<S: Number>(frame: Option<&Frame<S>>, solid: &Solid, point: &[Dyadic; 3]) -> bool {
    let local = frame.map_or_else(|| point.clone(), |frame| point_in(frame, solid, point));
    oracle::contains(solid, &local) != Membership::Outside
}

/// `Stable` may be wrong about a point only within a unit of the boundary, and `Exact` not at all: points of surfaces,
/// rounded, and points two units beside them. (3 % of such points of placed solids were told wrong, 14 % of a disc's,
/// and 8 % of a capsule's unplaced.)
fn what_is_more_than_a_unit_from_the_boundary_is_told_apart<S: Number, T: Tier<S>>(_: f64) {
    let is_exact = std::any::type_name::<T>() == std::any::type_name::<Exact>();
    let (mut random, mut told) = (Random(21), 0);
    for case in cases::<S>() {
        for round in 0..times(300) {
            let distance = random.pick(&[1.0, 100.0]);
            let frame = (round % 3 != 0).then(|| any_frame::<S>(&mut random, distance));
            let shape = frame.map_or(case.shape(), |frame| case.shape().placed(frame));
            let local = random_ray::<S>(&mut random);
            let in_world = |frame| ray_in(&frame, local.origin().to_f64(), local.direction().to_f64());
            let ray = frame.map_or(local, in_world);
            let Some(hit) = shape.nearest_at::<Stable>(&ray) else { continue };
            let surface = shape.surface(&ray, &hit);
            let largest =
                surface.point().to_f64().into_iter().chain(shape_position(&shape)).map(f64::abs).fold(1.0, f64::max);
            let unit = S::unit_at(&oracle::Root::from(&largest.exact()));
            for beside in [-2.0, 0.0, 2.0] {
                let off = scale(surface.normal().to_f64(), beside * unit.to_f64());
                let point = v::<S>(add(surface.point().to_f64(), off));
                let exact = point.to_array().map(S::exact);
                let inside = belongs(frame.as_ref(), &case.solid, &exact);
                let mut neighbours = (0..3).flat_map(|axis| [unit.clone(), -&unit].map(|by| (axis, by)));
                let is_clear = neighbours.all(|(axis, by)| {
                    let mut other = exact.clone();
                    other[axis] = &other[axis] + &by;
                    belongs(frame.as_ref(), &case.solid, &other) == inside
                });
                if is_exact || is_clear && beside != 0.0 {
                    told += 1;
                    let found = shape.contains_at::<T>(point);
                    assert_eq!(found, inside, "{} in {}: {point:?} of {shape:?}", case.name, S::name());
                }
            }
        }
    }
    assert!(told > 1_000, "{told} points");
}

fn shape_position<S: Number>(shape: &Shape<S>) -> [f64; 3] {
    match shape.placement() {
        Placement::Frame(frame) => frame.position().to_f64(),
        _ => [0.0; 3],
    }
}

fn agree<S: Number, T: Tier<S>>(shape: &Shape<S>, ray: &Ray<S>) {
    let (hits, nearest) = (shape.hits_at::<T>(ray), shape.nearest_at::<T>(ray));
    assert_eq!(nearest, hits.first().copied(), "{ray:?} at {shape:?}");
    assert_eq!(shape.occludes_at::<T>(ray), nearest.is_some(), "{ray:?} at {shape:?}: {hits:?}");
}

fn occlusion_agrees_with_the_nearest_hit_for_every_size<S: Number, T: Tier<S>>(_: f64) {
    let mut random = Random(22);
    for round in 0..times(4_000) {
        let Some((primitive, _)) = extreme_solid::<S>(&mut random) else { continue };
        let (shape, ray) = (Shape::new(primitive), extreme_ray::<S>(&mut random));
        let shape = if round % 2 == 0 { shape } else { shape.placed(any_frame::<S>(&mut random, 1.0)) };
        agree::<S, T>(&shape, &ray);
        agree::<S, Fast>(&shape, &ray);
        agree::<S, Plain>(&shape, &ray);
    }
}
