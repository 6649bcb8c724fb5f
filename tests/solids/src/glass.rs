//! Scenes of glass, what a ray sees in them, and the path of light through them by Snell's law.

use crate::values::point;
use raylet::scalar::UnitScalar;
use raylet::shape::kinds::{All, Kinds};
use raylet::{
    Camera, Color, Counters, Cuboid, Frame, Material, Object, Ray, Scalar, Scene, Shape, Sphere, Tier, TraceContext,
    Tracer, UnitVec3,
};
use support::random::dot;

/// Objects and their materials.
pub type Case<S, K = All> = (Vec<Object<S, K>>, Vec<Material<S>>);

pub fn number<S: Scalar>(value: f64) -> S {
    S::parse(&format!("{value:.12}")).unwrap()
}

pub fn glass<S: Scalar>(index: f64) -> Material<S> {
    let clear = Material { diffuse: S::ZERO, ..Material::matte(Color::WHITE) };
    clear.with_refraction(number(1.0), number(index))
}

pub fn camera<S: Scalar>() -> Camera<S> {
    Camera::new(point([0.0, 9.0, 0.1]), point([0.0; 3]), point([0.0, 1.0, 0.0]), number(30.0)).unwrap()
}

/// What a ray sees before a background that shines, and how many rays that takes.
pub fn seen<S: Scalar, T: Tier<S>, K: Kinds>(
    (objects, materials): &Case<S, K>,
    from: Vector,
    to: Vector,
) -> (f64, Counters) {
    let scene = Scene::new(objects, materials, &[], camera()).unwrap().with_background(Color::WHITE).at_tier::<T>();
    let ray = Ray::towards(point(from), point(to)).unwrap();
    let mut context = TraceContext::new(());
    let sample = Tracer::new(&scene).uncut().look(&ray, &mut context);
    (sample.color.red.to_f64(), context.counters)
}

/// A slab between two heights, in a frame that may be turned about the y axis and leans by `lean`.
pub fn slab<S: Scalar>(low: f64, high: f64, lean: [f64; 3], material: u32) -> Object<S> {
    let up = UnitVec3::new(point::<S>(lean)).unwrap();
    let middle = f64::midpoint(low, high);
    let length = (lean.iter().map(|c| c * c).sum::<f64>()).sqrt();
    let at = lean.map(|c| c / length * middle);
    let frame = Frame::from_base_and_axis(point(at), up).unwrap();
    let half = number((high - low) / 2.0);
    Object::new(Shape::new(Cuboid::new(number(50.0), half, number(50.0)).unwrap()).placed(frame), material)
}

pub type Vector = [f64; 3];

pub fn along(from: Vector, direction: Vector, t: f64) -> Vector {
    [0, 1, 2].map(|i| from[i] + direction[i] * t)
}

/// Snell's law with angles: the refracted direction has the sine `sin(incident) before / behind` in the plane of
/// incidence. `normal` is on the side that the ray comes from.
pub fn refracted(direction: Vector, normal: Vector, before: f64, behind: f64) -> Vector {
    let cosine = -dot(direction, normal);
    let across = along(direction, normal, cosine);
    let sine = dot(across, across).sqrt();
    if sine < 1e-12 {
        return direction;
    }
    let angle = (sine * before / behind).asin();
    let unit = across.map(|c| c / sine);
    [0, 1, 2].map(|i| unit[i] * angle.sin() - normal[i] * angle.cos())
}

/// A path that is computed here, from surface to surface: a height, or a sphere.
pub enum Surface {
    Height(f64),
    Ball(Vector, f64),
}

pub fn path(from: Vector, to: Vector, mut medium: f64, surfaces: &[(Surface, f64)]) -> (Vector, Vector) {
    let difference = along(to, from, -1.0);
    let length = dot(difference, difference).sqrt();
    let (mut at, mut direction) = (from, difference.map(|c| c / length));
    for (surface, behind) in surfaces {
        let (t, outward) = match surface {
            Surface::Height(height) => ((height - at[1]) / direction[1], [0.0, 1.0, 0.0]),
            Surface::Ball(centre, radius) => {
                let offset = along(at, *centre, -1.0);
                let (b, c) = (dot(offset, direction), dot(offset, offset) - radius * radius);
                let root = (b * b - c).sqrt();
                let t = if -b - root > 1e-9 { -b - root } else { -b + root };
                (t, along(along(at, direction, t), *centre, -1.0).map(|c| c / radius))
            }
        };
        at = along(at, direction, t);
        let normal = if dot(outward, direction) < 0.0 { outward } else { outward.map(|c| -c) };
        direction = refracted(direction, normal, medium, *behind);
        medium = *behind;
    }
    (at, direction)
}

/// A black ball is seen where the path leads, and not beside it.
pub fn leads<S: Scalar, T: Tier<S>>(case: &Case<S>, [from, to]: [Vector; 2], medium: f64, surfaces: &[(Surface, f64)]) {
    leads_to::<S, T, _>(case, [from, to], path(from, to, medium, surfaces), &|ball| ball);
}

/// The same for a path that leaves the last surface at a point, in a direction.
pub fn leads_to<S: Scalar, T: Tier<S>, K: Kinds>(
    case: &Case<S, K>,
    [from, to]: [Vector; 2],
    (at, direction): (Vector, Vector),
    of_kinds: &impl Fn(Shape<S>) -> Shape<S, K>,
) {
    let ball = |centre: Vector| {
        let (mut objects, mut materials) = case.clone();
        let frame = Frame::at(point(centre)).unwrap();
        let ball = of_kinds(Shape::new(Sphere::new(number(0.05)).unwrap()).placed(frame));
        objects.push(Object::new(ball, materials.len() as u32));
        materials.push(Material::matte(Color::BLACK));
        seen::<S, T, _>(&(objects, materials), from, to).0
    };
    let (there, none) = (along(at, direction, 4.0), seen::<S, T, _>(case, from, to).0);
    // Near total reflection less than half of the light passes.
    assert!(ball(there) < 0.8 * none, "{from:?} {to:?}: {there:?} is not seen");
    for side in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]] {
        let across = along(side, direction, -dot(side, direction));
        let length = dot(across, across).sqrt();
        assert!((ball(along(there, across, 0.06 / length)) - none).abs() < 1e-2 * none, "{from:?} {to:?}");
    }
}

pub fn ball_of<S: Scalar>(centre: Vector, radius: f64, material: u32) -> Object<S> {
    let frame = Frame::at(point(centre)).unwrap();
    Object::new(Shape::new(Sphere::new(number(radius)).unwrap()).placed(frame), material)
}
