//! The promise: leaving a surface needs no epsilon. From any hit of a bounded solid an outward ray never meets the same
//! solid, and an inward one always meets its far end; and of two surfaces a hair apart neither is skipped.
//!
//! In the long form ten million rays leave in each number type, in the quick one 200,000, spread over solids,
//! placements and tiers; every fourth of them nearly along the surface, where an epsilon would fail.

use raylet::tier::{Exact, Fast, Plain, Stable};
use raylet::{
    Camera, Capsule, Cone, Counters, Crossing, Cylinder, Frame, Leaving, Material, Object, Range, Ray, Scene, Shape,
    Sphere, UnitVec3,
};
use support::amount::{amount, times};
use support::cases::{Case, Kind, cases, direction, n, v};
use support::exact_types::Exact as Number;
use support::laws::{Grade, Graded, POSES, Pose, unit};
use support::random::{Random, dot};

/// What became of the rays that left.
#[derive(Debug, Default, PartialEq)]
struct Tally {
    rays: usize,
    self_hits: usize,
    lost_exits: usize,
}

/// A ray from the neighbourhood towards the solid, or from within it.
fn ray_at<S: Number>(random: &mut Random) -> Ray<S> {
    let from = random.direction().map(|c| c * random.between(0.2, 5.0));
    let aim: [f64; 3] = [(); 3].map(|()| random.between(-1.2, 1.2));
    let along = [0, 1, 2].map(|i| aim[i] - from[i]);
    let up = |[x, y, z]: [f64; 3]| [x, y + 1.0, z];
    Ray::new(v(up(from)), direction(along)).expect("the origin is near")
}

/// A direction that leaves to the given side of a surface with this normal; every fourth nearly along it.
fn leaving_to<S: Number>(normal: UnitVec3<S>, leaving: Leaving, random: &mut Random) -> UnitVec3<S> {
    let normal = normal.to_f64();
    loop {
        let any = random.direction();
        let squash = if random.below(4) == 0 { 1.0 - 10.0_f64.powf(random.between(-9.0, -2.0)) } else { 0.0 };
        let along = dot(any, normal) * squash;
        let any = direction::<S>([0, 1, 2].map(|i| any[i] - along * normal[i]));
        // In exact numbers of the type: a ray in the tangent plane leaves to neither side.
        let cosine = dot(any.to_f64(), normal);
        let outwards = cosine > 0.0;
        if cosine.abs() > 1e-300 {
            return if outwards == (leaving == Leaving::Outwards) { any } else { -any };
        }
    }
}

/// The rays of one tier: as many hits of every bounded solid, in every pose, left to both sides.
fn leave<S: Number, T: Graded<S>>(rays: usize, seed: u64) -> Tally {
    let mut random = Random(seed);
    let solids: Vec<Case<S>> = cases::<S>().into_iter().filter(|case| case.kind == Kind::Bounded).collect();
    let mut placed = vec![];
    for case in &solids {
        for index in 0..POSES {
            let pose = Pose::new(index);
            placed.push((case.name, pose, pose.place(case.shape())));
        }
    }
    let mut tally = Tally::default();
    while tally.rays < rays {
        let (name, pose, shape) = &placed[random.below(placed.len())];
        let ray = pose.ray(&ray_at::<S>(&mut random)).expect("near");
        let hits = shape.hits_at::<T>(&ray);
        for hit in &hits {
            let surface = shape.surface(&ray, hit);
            let (point, normal) = (surface.point(), surface.normal());
            for leaving in [Leaving::Outwards, Leaving::Inwards] {
                let along = leaving_to(normal, leaving, &mut random);
                let away = Ray::new(point, along).expect("near").departing(surface.departure(0, leaving));
                let met = shape.hits_at::<T>(&away);
                tally.rays += 1;
                let (fails, kind) = match leaving {
                    Leaving::Outwards => {
                        let none = met.is_empty() && !met.starts_inside() && met.coincident().is_none();
                        let is_met = shape.occludes_at::<T>(&away) || shape.nearest_at::<T>(&away).is_some();
                        (!none || is_met, &mut tally.self_hits)
                    }
                    Leaving::Inwards => {
                        let far = matches!(&met[..], [exit] if exit.crossing == Crossing::Exit && exit.t >= S::ZERO);
                        let is_met =
                            shape.occludes_at::<T>(&away) && shape.nearest_at::<T>(&away) == met.first().copied();
                        (!(far && met.starts_inside() && is_met), &mut tally.lost_exits)
                    }
                };
                if fails {
                    *kind += 1;
                    println!(
                        "{name} in {} at {:?}: {hit:?} of {ray:?} left {leaving:?} by {away:?}: {met:?}",
                        S::name(),
                        T::GRADE
                    );
                }
            }
        }
    }
    tally
}

/// All rays of one number type, spread over its tiers.
macro_rules! leave_in {
    ($($name:ident: $S:ty, [$($T:ty),+];)+) => {
        $(
            mod $name {
                use super::*;

                fn leave_all(rays: usize) {
                    let tiers = [$(leave::<$S, $T>),+];
                    for (index, leave) in tiers.iter().enumerate() {
                        let tally = leave(rays / tiers.len() + 1, 81 + index as u64);
                        println!("{}, tier {index}: {tally:?}", stringify!($S));
                        let wrong = (tally.self_hits, tally.lost_exits);
                        assert_eq!(wrong, (0, 0), "{} of {} rays", stringify!($S), tally.rays);
                    }
                }
                #[test]
                fn no_self_hit_and_no_lost_exit() {
                    leave_all(amount(200_000, 10_000_000));
                }
            }
        )+
    };
}
leave_in! {
    f32: f32, [Plain, Fast, Stable, Exact];
    f64: f64, [Plain, Fast, Stable];
    i16f16: fixed::types::I16F16, [Plain, Fast, Stable, Exact];
    i32f32: fixed::types::I32F32, [Plain, Fast, Stable];
    i8f24: fixed::types::I8F24, [Plain, Fast, Stable, Exact];
    i20f12: fixed::types::I20F12, [Plain, Fast, Stable, Exact];
}

/// Two solids of the same kind, the inner one this far from the outer one everywhere.
struct Shells<S: Number> {
    name: &'static str,
    outer: Shape<S>,
    inner: Shape<S>,
}

/// Shells 4e-5 apart; in types that hardly tell such numbers apart, four units.
fn shells<S: Number>() -> Vec<Shells<S>> {
    let unit = unit::<S>();
    // On the type's grid, so that the gap is as wide on all sides; no narrower than wanted.
    let gap = if support::laws::is_float::<S>() { 4e-5 } else { (4e-5_f64.max(4.0 * unit) / unit).ceil() * unit };
    let sizes = "the sizes are within the budget";
    let raised = |height: f64| Frame::at(v::<S>([0.0, height, 0.0])).expect(sizes);
    let pair = |name, outer: Shape<S>, inner: Shape<S>| Shells { name, outer, inner };
    // A cone of slope 3/4: its side leans by 3 in 5, so that a side `gap` within starts 5/3 of it higher.
    let (slope, tall) = (0.75, 2.0);
    let apex = (gap * 5.0 / 3.0 / unit).ceil() * unit;
    vec![
        pair(
            "spheres",
            Shape::new(Sphere::new(n(1.0 + gap)).expect(sizes)),
            Shape::new(Sphere::new(n(1.0)).expect(sizes)),
        ),
        pair(
            "cylinders",
            Shape::new(Cylinder::capped(n(1.0 + gap), n(2.0 + 2.0 * gap)).expect(sizes)),
            Shape::new(Cylinder::capped(n(1.0), n(2.0)).expect(sizes)).placed(raised(gap)),
        ),
        pair(
            "capsules",
            Shape::new(Capsule::new(n(1.0 + gap), n(2.0)).expect(sizes)),
            Shape::new(Capsule::new(n(1.0), n(2.0)).expect(sizes)),
        ),
        pair(
            "cones",
            Shape::new(Cone::capped(n(slope), n(tall)).expect(sizes)),
            Shape::new(Cone::capped(n(slope), n(tall - apex - gap)).expect(sizes)).placed(raised(apex)),
        ),
        pair(
            "frustums",
            Shape::new(Cone::frustum(n(1.5), n(0.75), n(1.0)).expect(sizes)),
            Shape::new(Cone::frustum(n(1.5 - 2.0 * gap), n(0.75 - 2.0 * gap), n(1.0 - 2.0 * gap)).expect(sizes))
                .placed(raised(gap)),
        ),
    ]
}

/// From a hit on the outer shell a ray goes inwards; every time it meets, in this order, the inner one's near side, its
/// far side, and the outer one's far side.
fn nested_shells_never_skip_each_other<S: Number, T: Graded<S>>(rays: usize) {
    for Shells { name, outer, inner } in shells::<S>() {
        let mut random = Random(91);
        let (mut tried, mut both) = (0, 0);
        while tried < rays {
            let ray = ray_at::<S>(&mut random);
            let Some(hit) = outer.nearest_at::<T>(&ray).filter(|hit| hit.crossing == Crossing::Enter) else { continue };
            tried += 1;
            let surface = outer.surface(&ray, &hit);
            let along = leaving_to(surface.normal(), Leaving::Inwards, &mut random);
            let start = Ray::new(surface.point(), along).expect("near");
            let told = |what: &str| {
                format!("{name} in {} at {:?}: {what}: {start:?} from {hit:?} of {ray:?}", S::name(), T::GRADE)
            };

            // With departure: the outer shell is left by its far side alone. A scene strips the departure for the other
            // object.
            let away = start.departing(surface.departure(0, Leaving::Inwards));
            let far = outer.hits_at::<T>(&away);
            assert!(
                matches!(&far[..], [exit] if exit.crossing == Crossing::Exit),
                "{}: {far:?}",
                told("the outer far end")
            );
            // Without: its near side may be met again at `t` next to nothing, or not; never its far side only by luck.
            let plain = outer.hits_at::<T>(&start);
            let cosine = dot(along.to_f64(), surface.normal().to_f64()).abs();
            if cosine > 0.25 {
                let last = plain.last().unwrap_or_else(|| panic!("{}", told("nothing of the outer")));
                assert_eq!(last.crossing, Crossing::Exit, "{}: {plain:?}", told("the outer"));
            }
            // `Fast` and `Plain` say of themselves that along a generator they are as wrong as plain subtraction makes
            // them: there they cannot tell 4e-5.
            if T::GRADE <= Grade::Fast && slope_of(name).is_some_and(|slope| is_near_generator(slope, along.to_f64())) {
                continue;
            }
            // The inner one, seen from the gap: a chord that exact arithmetic would not doubt.
            let whole = inner.hits_at::<T>(&start.with_range(Range::line()));
            let met = inner.hits_at::<T>(&start);
            let half = S::from_f64(far[0].t.to_f64() / 2.0).expect("between two values of the type");
            if cosine > 0.25 && inner.contains_at::<T>(start.at(half)) {
                assert_eq!(whole.len(), 2, "{}: {whole:?}", told("the inner"));
            }
            if let [enter, exit] = &whole[..] {
                both += 1;
                assert!(enter.t > S::ZERO, "{}: {whole:?}", told("the inner near side lies behind the outer one"));
                assert_eq!(&met[..], &whole[..], "{}", told("the inner is skipped"));
                assert!(!met.starts_inside(), "{}", told("the start is said to be inside the inner"));
                assert_eq!(inner.nearest_at::<T>(&start), Some(*enter), "{}", told("the inner"));
                assert!(inner.occludes_at::<T>(&start), "{}", told("the inner"));
                // A departure takes its start for a point of the outer side, which moves the far end by what it is off
                // over `a`.
                if slope_of(name).is_some_and(|slope| is_near_generator(slope, along.to_f64())) {
                    continue;
                }
                assert!(exit.t < far[0].t, "{}: {whole:?} {far:?}", told("the far sides are out of order"));
            }
        }
        assert!(both * 3 > tried, "{name}: only {both} of {tried} rays meet both");
    }
}

/// Radius over height of the shells' side.
fn slope_of(name: &str) -> Option<f64> {
    ["cones", "frustums"].contains(&name).then_some(0.75)
}

/// True if the leading coefficient of the cone's equation along the direction cancels to less than an eighth.
fn is_near_generator(slope: f64, [x, y, z]: [f64; 3]) -> bool {
    (x * x + z * z - slope * slope * y * y).abs() < 0.125
}

macro_rules! nested {
    ($S:ty, $T:ty,) => {
        nested_shells_never_skip_each_other::<$S, $T>(4000);
    };
}

#[test]
fn nested_shells_never_skip_each_other_in_any_type_and_tier() {
    in_every_tier!(nested!());
}

/// Along a generator (here `a` cancels to a five-hundredth) the near side of the inner cone, 4e-5 away, is not reported
/// at the start itself, as plain subtraction would have it.
#[test]
fn fast_tells_cones_a_hair_apart_along_a_generator() {
    let Some(Shells { inner, .. }) = shells::<f32>().into_iter().find(|shells| shells.name == "cones") else {
        panic!("there are cones")
    };
    let along = direction::<f32>([0.20203446, 0.8002625, -0.5645901]);
    let start = Ray::new(v([-1.1516892, 1.9588274, 0.91210055]), along).expect("near");
    let [exact, fast] =
        [inner.hits_at::<Exact>(&start), inner.hits_at::<Fast>(&start)].map(|hits| hits.first().map(|hit| hit.t));
    let exact = exact.expect("the inner cone is met");
    assert!(exact > 0.0 && fast.is_some_and(|t| (t - exact).abs() < 0.5 * exact), "{fast:?}, exactly {exact}");
}

/// A scene of two shells: from the outer one inwards the inner one is seen next, and from the inner one outwards the
/// outer one.
fn a_scene_of_nested_shells_alternates_between_them<S: Number>() {
    let camera = Camera::new(v::<S>([0.0, 1.0, 6.0]), v([0.0, 1.0, 0.0]), v([0.0, 1.0, 0.0]), n(45.0)).expect("a view");
    let materials = [Material::default()];
    for Shells { name, outer, inner } in shells::<S>() {
        let shapes = [outer, inner];
        let objects = shapes.map(|shape| Object::new(shape, 0));
        let scene = Scene::new(&objects, &materials, &[], camera).expect("one material");
        let mut random = Random(97);
        let mut counters = Counters::default();
        let mut turns = 0;
        for _ in 0..times(4000) {
            let mut ray = ray_at::<S>(&mut random);
            // Through the outer shell, into the inner one, and out of both by reflecting once inside.
            for (object, leaving) in
                [(0, Leaving::Inwards), (1, Leaving::Inwards), (1, Leaving::Outwards), (0, Leaving::Outwards)]
            {
                let Some(met) = scene.nearest(&ray, &mut counters) else { break };
                if met.object != object {
                    // Grazing, or from between the shells.
                    break;
                }
                let surface = shapes[object as usize].surface(&ray, &met.hit);
                let along = direction::<S>({
                    let (any, normal) = (random.direction(), surface.normal().to_f64());
                    let cosine = dot(any, normal);
                    let wanted = if leaving == Leaving::Inwards { -1.0 } else { 1.0 } * random.between(0.5, 1.0);
                    [0, 1, 2].map(|i| any[i] + (wanted - cosine) * normal[i])
                });
                ray = Ray::new(surface.point(), along).expect("near").departing(surface.departure(object, leaving));
                let next = scene.nearest(&ray, &mut counters);
                let expected = match (object, leaving) {
                    (0 | 1, Leaving::Inwards) => Some(1),
                    (1, Leaving::Outwards) => Some(0),
                    _ => None,
                };
                // Near the rims the gap is another: the ray may leave through the outer shell's corner.
                let by_corner =
                    expected == Some(1) && object == 0 && next.is_some_and(|next| is_near_corner(name, &next.hit));
                assert!(
                    next.map(|next| next.object) == expected || by_corner,
                    "{name} in {}: {ray:?} leaves {object} {leaving:?} and meets {next:?}",
                    S::name()
                );
                turns += 1;
            }
        }
        assert!(turns > 4000, "{name} in {}: only {turns} turns", S::name());
    }
}

/// True if the ray runs less than a hundredth before it is out again: across a rim, or the apex.
fn is_near_corner<S: Number>(name: &str, hit: &raylet::Hit<S>) -> bool {
    !["spheres", "capsules"].contains(&name) && hit.t.to_f64() < 1e-2
}

every_type!(a_scene_of_nested_shells_alternates_between_them);
