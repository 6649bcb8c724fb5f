//! What the tests of named cases share: a ray as a placed solid sees it in exact numbers, and how far an answer may be
//! off.
//!
//! The modules `named_*` hold the faults that were found in the first solver, each with the numbers that showed it, and
//! a seeded search around it.

use raylet::scene::{Hierarchy, Node, SceneHit};
use raylet::tier::Tier;
use raylet::{
    Capsule, Color, Cone, Counters, Crossing, Cylinder, Disc, Frame, Material, Object, Part, Primitive, Range, Ray,
    Scalar, Scene, Shape, Sphere, Triangle, UnitVec3, Vec3,
};
use support::cases::{Verdict, compare_answers, direction, v};
use support::crowd;
use support::exact_types::{Exact as Number, exact_line};
use support::oracle::{self, ConeExtent, CylinderExtent, Dyadic, Line, Solid};
use support::random::{Random, add, scale};

/// Defines a test for each number type and tier that promises an error, from generic functions of the same names that
/// take the units promised: one in fixed point and in `Exact`, and in floats 31 for any ray that grazes to 1e-7.
macro_rules! promised {
    ($($law:ident),+ $(,)?) => {
        $(
            mod $law {
                use raylet::tier::{Exact, Stable};
                #[test]
                fn stable_f32() {
                    super::$law::<f32, Stable>(31.0);
                }
                #[test]
                fn stable_f64() {
                    super::$law::<f64, Stable>(31.0);
                }
                #[test]
                fn stable_i16f16() {
                    super::$law::<fixed::types::I16F16, Stable>(1.0);
                }
                #[test]
                fn stable_i32f32() {
                    super::$law::<fixed::types::I32F32, Stable>(1.0);
                }
                #[test]
                fn exact_f32() {
                    super::$law::<f32, Exact>(1.0);
                }
                #[test]
                fn exact_i16f16() {
                    super::$law::<fixed::types::I16F16, Exact>(1.0);
                }
            }
        )+
    };
}

/// A hit that must be found: `t`, part and crossing.
pub type Want = (f64, Part, Crossing);

/// Three numbers by their bits.
pub fn bits(raw: [u32; 3]) -> [f32; 3] {
    raw.map(f32::from_bits)
}

/// The ray with these stored components.
pub fn ray<S: Number>(origin: [S; 3], along: [S::Unit; 3]) -> Ray<S> {
    let along = UnitVec3::from_components(along).expect("a direction is unit within 2^-20");
    Ray::new(origin.into(), along).expect("the origin is within the budget")
}

/// How far `t` is from the exact value, in units in the last place.
pub fn units_off<S: Number>(t: S, exact: f64) -> f64 {
    let exact = oracle::Root::from(&oracle::exact_f64(exact));
    exact.error_in(&t.exact(), &S::unit_at(&exact))
}

/// Fails unless these are the hits, each `t` at most so many units off, and all queries agree.
pub fn assert_hits<S: Number, T: Tier<S>>(shape: &Shape<S>, ray: &Ray<S>, want: &[Want], units: f64) {
    let (hits, tier) = (shape.hits_at::<T>(ray), std::any::type_name::<T>());
    let found: Vec<_> = hits.iter().map(|hit| (hit.part, hit.crossing)).collect();
    let wanted: Vec<_> = want.iter().map(|(_, part, crossing)| (*part, *crossing)).collect();
    assert_eq!(found, wanted, "{tier} in {}: {hits:?}, exactly {want:?}", S::name());
    for (hit, (t, ..)) in hits.iter().zip(want) {
        let off = units_off(hit.t, *t);
        assert!(off <= units, "{tier} in {}: {off} units: {hit:?}, exactly {t}", S::name());
    }
    assert_eq!(shape.nearest_at::<T>(ray), hits.first().copied(), "{tier} in {}", S::name());
    assert_eq!(shape.occludes_at::<T>(ray), !hits.is_empty(), "{tier} in {}", S::name());
}

pub fn dot(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> Dyadic {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// The frame's axes as they are stored.
pub fn axes<S: Number>(frame: &Frame<S>) -> [[Dyadic; 3]; 3] {
    [frame.left(), frame.up(), frame.forward()].map(|axis| axis.to_array().map(S::exact_unit))
}

/// A vector as the solid sees it, exactly. A ball has no axes: turned, it is the same ball.
fn turned<S: Number>(frame: &Frame<S>, solid: &Solid, vector: [Dyadic; 3]) -> [Dyadic; 3] {
    if matches!(solid, Solid::Sphere { .. }) {
        return vector;
    }
    axes(frame).each_ref().map(|axis| dot(axis, &vector))
}

/// A point as the solid in the frame sees it, exactly.
pub fn point_in<S: Number>(frame: &Frame<S>, solid: &Solid, point: &[Dyadic; 3]) -> [Dyadic; 3] {
    let position = frame.position().to_array().map(S::exact);
    turned(frame, solid, [0, 1, 2].map(|i| &point[i] - &position[i]))
}

/// The ray's line as the solid in the frame sees it, exactly; its direction is not unit.
pub fn line_in<S: Number>(frame: &Frame<S>, solid: &Solid, ray: &Ray<S>) -> Line {
    let line = exact_line(ray);
    Line::new(point_in(frame, solid, &line.origin), turned(frame, solid, line.direction))
}

/// A frame turned anyhow, this far from the world's origin.
pub fn any_frame<S: Number>(random: &mut Random, distance: f64) -> Frame<S> {
    loop {
        let position = v(scale(random.direction(), distance));
        if let Ok(frame) = Frame::looking(position, random.unit_vector(), random.unit_vector()) {
            return frame;
        }
    }
}

/// A vector of the frame in the world, rounded.
pub fn to_world<S: Number>(frame: &Frame<S>, vector: [f64; 3]) -> [f64; 3] {
    let axes = [frame.left(), frame.up(), frame.forward()].map(UnitVec3::to_f64);
    (0..3).fold([0.0; 3], |sum, i| add(sum, scale(axes[i], vector[i])))
}

/// The ray with these local numbers, as it stands in the world, rounded to the type.
pub fn ray_in<S: Number>(frame: &Frame<S>, origin: [f64; 3], along: [f64; 3]) -> Ray<S> {
    let origin = add(frame.position().to_f64(), to_world(frame, origin));
    Ray::new(v(origin), direction(to_world(frame, along))).expect("the origin is within the budget")
}

/// The error of the worst `t` in units, against exact arithmetic on the line that the solid sees; or what differs.
pub fn judge<S: Number, T: Tier<S>>(shape: &Shape<S>, solid: &Solid, line: &Line, ray: &Ray<S>) -> Result<f64, String> {
    let (start, end) = (ray.range().start().exact(), ray.range().end().exact());
    let exact = oracle::hits_in_range(&oracle::solve(solid, line), &start, Some(&end));
    match compare_answers(&shape.hits_at::<T>(ray), &exact) {
        Verdict::Same(error) => Ok(error),
        other => Err(format!("{other:?}: {ray:?} at {shape:?}")),
    }
}

/// What a scene of these objects sees, without and with a hierarchy.
pub fn seen<S: Scalar>(objects: &[Object<S>], ray: &Ray<S>) -> [Option<SceneHit<S>>; 2] {
    let materials = [Material::matte(Color::WHITE)];
    let scene = Scene::new(objects, &materials, &[], crowd::camera()).expect("a scene");
    let mut nodes = vec![Node::EMPTY; Hierarchy::<S>::nodes_for(objects.len())];
    let hierarchy = Hierarchy::build(objects, &mut nodes).expect("as many nodes as it needs");
    let boxed = scene.with_hierarchy(&hierarchy).expect("built for these objects");
    [&scene, &boxed].map(|scene| scene.nearest(ray, &mut Counters::default()))
}

/// The exponents of the extreme numbers of a type, in powers of two; those from -30 to 30 may be slopes.
pub fn exponents<S: Number>() -> &'static [i32] {
    match S::name().as_str() {
        "f32" => &[-149, -140, -126, -75, -60, -30, -10, 0, 3, 30, 60, 75, 100, 126],
        "f64" => &[-1074, -1022, -540, -500, -60, -30, 0, 3, 30, 60, 500, 540, 1022],
        "I16F16" => &[-16, -15, -8, 0, 7, 13, 14],
        _ => &[-32, -31, -16, 0, 15, 29, 30],
    }
}

/// A number of an extreme size; none where it is beyond the type.
pub fn extreme<S: Number>(random: &mut Random) -> S {
    let value = random.pick(&[1.0, 1.0, 1.5, 1.75]) * libm::ldexp(1.0, random.pick(exponents::<S>()));
    S::from_f64(value).ok().filter(|value| *value <= S::BUDGET.size).unwrap_or(S::BUDGET.size)
}

/// A solid of extreme sizes; none where its constructor refuses them.
pub fn extreme_solid<S: Number>(random: &mut Random) -> Option<(Primitive<S>, Solid)> {
    let [r, h, s] = [(); 3].map(|()| extreme::<S>(random));
    let (radius, height, slope) = (r.exact(), h.exact(), s.exact());
    Some(match random.below(11) {
        0 => (Sphere::new(r).ok()?.into(), Solid::Sphere { radius }),
        1 => (Cylinder::infinite(r).ok()?.into(), Solid::Cylinder { radius, extent: CylinderExtent::Infinite }),
        2 => (Cylinder::open(r, h).ok()?.into(), Solid::Cylinder { radius, extent: CylinderExtent::Open(height) }),
        3 => (Cylinder::capped(r, h).ok()?.into(), Solid::Cylinder { radius, extent: CylinderExtent::Capped(height) }),
        4 => (Capsule::new(r, h).ok()?.into(), Solid::Capsule { radius, height }),
        5 => (Cone::double(s).ok()?.into(), Solid::Cone { slope, extent: ConeExtent::Double }),
        6 => (Cone::capped(s, h).ok()?.into(), Solid::Cone { slope, extent: ConeExtent::Capped(height) }),
        number @ (7 | 8) => {
            let (base, capped) = (if random.below(3) == 0 { S::ZERO } else { r }, number == 7);
            let built = if capped { Cone::frustum(base, s, h) } else { Cone::frustum_open(base, s, h) };
            (built.ok()?.into(), Solid::Frustum { base_radius: base.exact(), top_radius: slope, height, capped })
        }
        9 => (Disc::new(r).ok()?.into(), Solid::Disc { radius }),
        _ => {
            let corners = [[r, S::ZERO, S::ZERO], [S::ZERO, h, S::ZERO], [S::ZERO, S::ZERO, s]];
            let [a, b, c] = corners.map(Vec3::from);
            (
                Triangle::new(a, b, c).ok()?.into(),
                Solid::Triangle { vertices: corners.map(|corner| corner.map(S::exact)) },
            )
        }
    })
}

/// A ray of extreme coordinates, along an axis or not, ahead or both ways.
pub fn extreme_ray<S: Number>(random: &mut Random) -> Ray<S> {
    let origin = [(); 3].map(|()| match random.below(4) {
        0 => S::ZERO,
        1 => -extreme::<S>(random),
        _ => extreme::<S>(random),
    });
    let along = if random.below(2) == 0 {
        random.unit_vector()
    } else {
        let axis = random.pick(&[UnitVec3::X, UnitVec3::Y, UnitVec3::Z]);
        if random.below(2) == 0 { axis } else { -axis }
    };
    let ray = Ray::new(origin.into(), along).expect("the origin is within the budget");
    if random.below(2) == 0 { ray } else { ray.with_range(Range::line()) }
}
