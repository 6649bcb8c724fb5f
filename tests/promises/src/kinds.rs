//! A shape of chosen kinds answers as the same shape of any kind does, to the bit, and has no other kinds.

use raylet::scene::{Hierarchy, Node};
use raylet::shape::kinds::{All, Kind, KindError, Kinds, Primitives};
use raylet::{
    Affine, Annulus, Camera, Capsule, Color, Cone, Cuboid, Cylinder, Disc, Exact, Fast, Frame, Light, Material, Object,
    Picture, Plain, Plane, Polyhedron, Prism, Ray, Rectangle, Revolved, RoundCone, RoundedCuboid, Scalar, Scene, Shape,
    Size, Sphere, Stable, Tier, Torus, Triangle, Tube, UnitVec3, Vec3, Visible,
};
use std::fmt::Debug;
use support::amount::times;
use support::cases::{cases, n, v};
use support::exact_types;
use support::placed::{PLACINGS, Placed, Placing};
use support::random::Random;
use support::subject::{SUBJECTS, Subject};
use support::workload::{FURTHER, WORKLOADS};

every_type!(
    answers_are_those_of_a_shape_of_any_kind,
    a_scene_of_chosen_kinds_is_the_same_scene,
    among_refuses_what_is_not_among_the_kinds,
);

mod the_exact_tier {
    #[test]
    fn f32() {
        super::exactly::<f32>();
    }
    #[test]
    fn i16f16() {
        super::exactly::<fixed::types::I16F16>();
    }
}

/// Fails if two answers differ in any bit. A number as it is written tells it from every other.
fn same<A: Debug>(chosen: A, any: A, told: &impl Fn() -> String) {
    let [chosen, any] = [chosen, any].map(|answer| format!("{answer:?}"));
    assert!(chosen == any, "{}: {chosen}, not {any}", told());
}

/// Compares a shape of chosen kinds with one of any kind, by every query.
fn same_answers<S: exact_types::Exact, K: Kinds, T: Tier<S>>(shape: &Shape<S>, chosen: &Shape<S, K>, ray: &Ray<S>) {
    let told = || format!("{shape:?} {ray:?} {}", K::SET);
    let hits = shape.hits_at::<T>(ray);
    same(format!("{:?}", chosen.hits_at::<T>(ray)), format!("{hits:?}"), &told);
    same(chosen.nearest_at::<T>(ray), shape.nearest_at::<T>(ray), &told);
    same(chosen.occludes_at::<T>(ray), shape.occludes_at::<T>(ray), &told);
    same(chosen.contains_at::<T>(ray.origin()), shape.contains_at::<T>(ray.origin()), &told);
    for hit in &hits {
        let (ours, theirs) = (chosen.surface(ray, hit), shape.surface(ray, hit));
        same((ours.point(), ours.local_point()), (theirs.point(), theirs.local_point()), &told);
        same((ours.normal(), ours.normal_towards_ray()), (theirs.normal(), theirs.normal_towards_ray()), &told);
        same((ours.uv(), ours.tangents()), (theirs.uv(), theirs.tangents()), &told);
        same(chosen.contains_at::<T>(ours.point()), shape.contains_at::<T>(theirs.point()), &told);
    }
}

/// A comparison of a shape of any kind with the same shape of chosen kinds, by a ray.
type Compare<S, K> = fn(&Shape<S>, &Shape<S, K>, &Ray<S>);

/// Every subject, placed in every way, that is among these kinds. Returns how many shapes were compared.
fn of_these<S: exact_types::Exact, K: Kinds>(tiers: &[Compare<S, K>]) -> usize {
    let (mut random, mut shapes) = (Random(7), 0);
    let workloads: Vec<_> = WORKLOADS.into_iter().chain(FURTHER).collect();
    for subject in SUBJECTS.map(Subject::<S>::new) {
        for placing in [None].into_iter().chain(PLACINGS.map(Some)) {
            for visible in [Visible::Both, Visible::Outside, Visible::Inside] {
                let Some(placed) = Placed::new(&subject, placing.unwrap_or(Placing::Turned), &mut random) else {
                    continue;
                };
                let shape = if placing.is_none() { subject.shape } else { placed.shape }.seen_from(visible);
                let Ok(chosen) = shape.among::<K>() else { continue };
                shapes += 1;
                same(chosen.bounds(), shape.bounds(), &|| format!("{shape:?}"));
                for workload in &workloads {
                    for _ in 0..times(1) {
                        let ray = match placing {
                            None => workload.ray(&subject, &mut random),
                            Some(_) => placed.ray(&subject, *workload, &mut random),
                        };
                        for (ray, compare) in ray.iter().flat_map(|ray| tiers.iter().map(move |compare| (ray, compare)))
                        {
                            compare(&shape, &chosen, ray);
                        }
                    }
                }
            }
        }
    }
    shapes
}

fn in_rounding_tiers<S: exact_types::Exact, K: Kinds>() -> usize {
    of_these::<S, K>(&[same_answers::<S, K, Plain>, same_answers::<S, K, Fast>, same_answers::<S, K, Stable>])
}

/// Compares every primitive with every placement, a few in each set, and in sets without a placement or with one of
/// them.
macro_rules! every_set {
    ($S:ident, $compare:ident) => {{
        let compared = [
            $compare::<$S, (Sphere<$S>, Plane<$S>, Frame<$S>, Affine<$S>)>(),
            $compare::<$S, (Frame<$S>, Affine<$S>, Disc<$S>, Cylinder<$S>)>(),
            $compare::<$S, (Affine<$S>, Cone<$S>, Frame<$S>)>(),
            $compare::<$S, (Capsule<$S>, Triangle<$S>, Frame<$S>, Affine<$S>)>(),
            $compare::<$S, (Cylinder<$S>, Plane<$S>, Frame<$S>)>(),
            $compare::<$S, (Sphere<$S>, Capsule<$S>)>(),
            $compare::<$S, (Cuboid<$S>, Rectangle<$S>, Frame<$S>, Affine<$S>)>(),
            $compare::<$S, (Revolved<$S>, Frame<$S>, Affine<$S>)>(),
            $compare::<$S, (Tube<$S>, Annulus<$S>, Frame<$S>, Affine<$S>)>(),
            $compare::<$S, (RoundCone<$S>, Frame<$S>, Affine<$S>)>(),
            $compare::<$S, (RoundedCuboid<$S>, Frame<$S>, Affine<$S>)>(),
            $compare::<$S, (Prism<$S>, Polyhedron<$S>, Frame<$S>, Affine<$S>)>(),
            $compare::<$S, (Torus<$S>, Frame<$S>, Affine<$S>)>(),
        ];
        // So many subjects in so many placements, seen from both sides and from each.
        let one = (1, 5);
        let expected = [(2, 5), (4, 5), (8, 5), (2, 5), (4, 3), (2, 1), (2, 5), (2, 5), (2, 5), one, one, (2, 5), one];
        assert_eq!(compared, expected.map(|(subjects, placements)| subjects * placements * 3));
    }};
}

fn answers_are_those_of_a_shape_of_any_kind<S: exact_types::Exact>() {
    every_set!(S, in_rounding_tiers);
}

fn exactly<S: exact_types::Exact>()
where
    Exact: Tier<S>,
{
    fn in_the_exact_tier<S: exact_types::Exact, K: Kinds>() -> usize
    where
        Exact: Tier<S>,
    {
        of_these::<S, K>(&[same_answers::<S, K, Exact>])
    }
    every_set!(S, in_the_exact_tier);
}

/// A floor and balls on it, with a hierarchy, in the light of a lamp.
fn picture<S: Scalar, K: Kinds>(objects: &[Object<S, K>]) -> (Vec<String>, String) {
    let materials = [Material::matte(Color::WHITE).with_mirror(n_of(0.25)), Material::matte(Color::WHITE)];
    let up = Vec3::from_f64([0.0, 1.0, 0.0]).unwrap();
    let [eye, lamp] = [[0.5, 3.0, 8.0], [3.0, 9.0, 4.0]].map(|at| Vec3::from_f64(at).unwrap());
    let camera = Camera::new(eye, Vec3::ZERO, up, n_of(40.0)).unwrap();
    let lights = [Light::new(lamp, n_of(0.75))];
    let mut nodes = [Node::EMPTY; 31];
    let hierarchy = Hierarchy::build(objects, &mut nodes).unwrap();
    let scene = Scene::new(objects, &materials, &lights, camera).unwrap().with_hierarchy(&hierarchy).unwrap();
    let mut pixels = vec![];
    let size = Size::new(24, 18).with_samples(2);
    let counters = Picture::new(&scene, size).render(|x, y, pixel| pixels.push(format!("{x} {y} {pixel:?}")));
    (pixels, format!("{counters:?} {nodes:?}"))
}

fn n_of<S: Scalar>(value: f64) -> S {
    S::from_f64(value).unwrap()
}

fn a_scene_of_chosen_kinds_is_the_same_scene<S: exact_types::Exact>() {
    fn of<S: exact_types::Exact, K: Kinds>(shape: Shape<S>, material: u32) -> Object<S, K> {
        Object::new(shape.among().expect("it is among them"), material)
    }
    fn objects<S: exact_types::Exact, K: Kinds>() -> Vec<Object<S, K>> {
        let ball = Shape::new(Sphere::new(n::<S>(0.5)).unwrap());
        let balls = (0..9_u32).map(|i| {
            let at = [f64::from(i % 3) * 1.25 - 1.0, 0.5, f64::from(i / 3) - 1.0];
            of(ball.placed(Frame::at(v(at)).unwrap()), i % 2)
        });
        [of(Shape::new(Plane::new()), 1)].into_iter().chain(balls).collect()
    }
    let (any, any_counted) = picture(&objects::<S, All>());
    let (chosen, counted) = picture(&objects::<S, (Sphere<S>, Plane<S>, Frame<S>)>());
    assert_eq!((chosen, counted), (any, any_counted));
}

fn among_refuses_what_is_not_among_the_kinds<S: exact_types::Exact>() {
    let frame = Frame::at(v::<S>([1.0, 2.0, 3.0])).unwrap();
    let affine = Affine::stretched(frame, v([1.0, 2.0, 0.5])).unwrap();
    let mut refused = 0;
    for case in cases::<S>() {
        type Few<S> = (Sphere<S>, Cylinder<S>, Frame<S>);
        let kind = case.primitive.kind();
        let expected = |placement: Option<Kind>| {
            let wrong = [Some(kind), placement].into_iter().flatten().find(|kind| !Few::<S>::SET.contains(*kind));
            wrong.map_or(Ok(()), |kind| Err(KindError { kind, among: Few::<S>::SET }))
        };
        let shape = case.shape();
        for (shape, placement) in
            [(shape, None), (shape.placed(frame), Some(Kind::Frame)), (shape.placed(affine), Some(Kind::Affine))]
        {
            let among = shape.among::<Few<S>>();
            assert_eq!(among.map(|_| ()), expected(placement), "{shape:?}");
            refused += usize::from(among.is_err());
            // And back again.
            assert_eq!(among.ok().and_then(|few| few.among::<All>().ok()), among.is_ok().then_some(shape));
        }
    }
    assert!(refused > 40, "{refused}");
}

/// A primitive and a placement that are named are taken without a test.
#[test]
fn what_is_named_is_taken() {
    fn placed<K: Primitives>(ball: Shape<f32, K>, frame: Frame<f32>) -> Shape<f32, K> {
        ball.among::<All>().expect("all are among them").placed(frame).among().expect("it is named")
    }
    type Few = (Frame<f32>, Sphere<f32>);
    let (ball, frame) = (Sphere::new(2.0_f32).unwrap(), Frame::at(v([0.0, 0.0, 9.0])).unwrap());
    let named = Shape::<f32, Few>::of(ball).placed(frame);
    assert_eq!(named, placed(Shape::<f32, Few>::of(ball), frame));
    assert_eq!(Shape::<f32, All>::of(ball).placed(frame), Shape::new(ball).placed(frame));
    let ray = Ray::new(Vec3::ZERO, UnitVec3::Z).unwrap();
    assert_eq!(named.nearest(&ray).map(|hit| hit.t), Some(7.0));
    assert_eq!(format!("{named:?}"), format!("{:?}", Shape::new(ball).placed(frame)));
}

/// The order of the names, a name twice and the number type of what is named are of no consequence.
#[test]
fn a_set_is_what_it_names() {
    assert_eq!(<(Plane<f32>, Sphere<f32>)>::SET, <(Sphere<f64>, Plane<f32>, Sphere<f32>)>::SET);
    assert_eq!(
        All::SET.to_string(),
        "Sphere, Cylinder, Cone, Capsule, Plane, Disc, Triangle, Cuboid, Rectangle, Revolved, Tube, Annulus, \
         RoundCone, RoundedCuboid, Prism, Polyhedron, Torus, Frame, Affine"
    );
    assert_eq!(All::SET.len(), Kind::EVERY.len());
    for kind in Kind::EVERY {
        assert!(All::SET.contains(kind) && format!("{kind:?}") == kind.name());
    }
}
