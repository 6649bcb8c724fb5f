//! Scenes of many solids, and rays at all that is special about them.

use super::random::{Random, add, scale};
use raylet::scalar::UnitScalar;
use raylet::{
    Affine, Camera, Capsule, Cone, Counters, Cuboid, Cylinder, Disc, Frame, Leaving, Object, Placement, Plane,
    Primitive, Range, Ray, Scalar, Scene, Shape, Sphere, Triangle, UnitVec3, Vec3, Visible,
};

/// How far from the origin the solids stand.
const AWAY: f64 = 6.0;

fn number<S: Scalar>(value: f64) -> S {
    S::from_f64(value).expect("in every type of the tests")
}

fn point<S: Scalar>(at: [f64; 3]) -> Vec3<S> {
    Vec3::from_f64(at).expect("in every type of the tests")
}

/// A direction; often along an axis or in a plane of two.
fn direction<S: Scalar>(random: &mut Random) -> UnitVec3<S> {
    let mut v = random.direction();
    match random.below(4) {
        0 => v = [0.0; 3],
        1 => v[random.below(3)] = 0.0,
        _ => {}
    }
    if v == [0.0; 3] {
        v[random.below(3)] = random.sign();
    }
    UnitVec3::from_components(super::random::normalize(v).map(<S::Unit as UnitScalar>::from_f64))
        .expect("a unit vector")
}

fn primitive<S: Scalar>(random: &mut Random) -> Primitive<S> {
    // From tiny to large; often round, so that several have the same faces.
    let mut size = || {
        let size = if random.below(2) == 0 {
            random.pick(&[0.25, 0.5, 1.0])
        } else {
            20.0_f64.powf(random.between(-2.0, 0.5))
        };
        number::<S>(size)
    };
    let (a, b, c) = (size(), size(), size());
    let corner = |random: &mut Random| point(scale(random.direction(), random.between(0.1, 2.0)));
    match random.below(24) {
        0..6 => Sphere::new(a).expect("a size").into(),
        6..8 => Capsule::new(a, b).expect("sizes").into(),
        8..10 => Cylinder::capped(a, b).expect("sizes").into(),
        10 => Cylinder::open(a, b).expect("sizes").into(),
        11 => Cylinder::infinite(number(0.125)).expect("a size").into(),
        12..14 => Cone::frustum(a, b, c).map_or_else(|_| Plane::new().into(), Primitive::from),
        14 => Cone::capped(number(0.5), b).expect("sizes").into(),
        15 => Cone::open(number(0.5), b).expect("sizes").into(),
        16 => Cone::nappe(number(0.25)).expect("a slope").into(),
        17 => Plane::new().into(),
        18 => Cuboid::new(a, b, c).expect("sizes").into(),
        19 => Disc::new(a).expect("a size").into(),
        _ => {
            let [p, q, r] = [(); 3].map(|()| corner(random));
            Triangle::new(p, q, r).map_or_else(|_| Disc::new(a).expect("a size").into(), Primitive::from)
        }
    }
}

fn placement<S: Scalar>(random: &mut Random) -> Placement<S> {
    let at = if random.below(2) == 0 {
        [(); 3].map(|()| random.between(-AWAY, AWAY).round())
    } else {
        [(); 3].map(|()| random.between(-AWAY, AWAY))
    };
    let turned = Frame::from_base_and_axis(point(at), direction(random)).expect("within the budget");
    match random.below(8) {
        0 => Placement::World,
        1..4 => Frame::at(point(at)).expect("within the budget").into(),
        4..6 => turned.into(),
        6 => {
            let strongest = random.pick(&[2.0_f64, 10.0, 300.0]);
            let factors = [(); 3].map(|()| strongest.powf(random.between(-1.0, 0.5)));
            Affine::stretched(turned, point(factors)).map_or(turned.into(), Placement::from)
        }
        // Sheared, as often as not nearly flat.
        _ => {
            let (a, b) = (random.direction(), random.direction());
            let lean = random.pick(&[1.0, 0.1, 0.01]);
            let c = add(a, scale(random.direction(), lean));
            Affine::new(point(at), [a, b, c].map(point)).map_or(turned.into(), Placement::from)
        }
    }
}

/// This many objects; some of them twice in the same place.
pub fn objects<S: Scalar>(count: usize, random: &mut Random) -> Vec<Object<S>> {
    let mut objects: Vec<Object<S>> = Vec::new();
    while objects.len() < count {
        let visible = random.pick(&[Visible::Both, Visible::Both, Visible::Outside, Visible::Inside]);
        let twin = random.below(12) == 0 && !objects.is_empty();
        objects.push(if twin {
            random.pick(&objects)
        } else {
            Object::new(Shape::new(primitive(random)).placed(placement(random)).seen_from(visible), 0)
        });
    }
    objects
}

/// A point that matters to an object: a corner of its box, on an edge or a face of it, inside.
fn special_point<S: Scalar>(shape: &Shape<S>, random: &mut Random) -> [f64; 3] {
    let bounds = shape.bounds();
    let inside = |c: f64| c.abs() < 100.0;
    let (low, high) = (bounds.low.to_f64(), bounds.high.to_f64());
    [0, 1, 2].map(|i| {
        let (low, high) = if inside(low[i]) && inside(high[i]) { (low[i], high[i]) } else { (-AWAY, AWAY) };
        match random.below(4) {
            0 => low,
            1 => high,
            2 => f64::midpoint(low, high),
            _ => random.between(low, high),
        }
    })
}

/// A ray, for these objects: anywhere, along and at faces and edges of boxes, from inside, with any range, and from a
/// surface. `None` where it would start beyond the budget.
pub fn ray<S: Scalar>(objects: &[Object<S>], scene: &Scene<'_, S>, random: &mut Random) -> Option<Ray<S>> {
    let far = if random.below(6) == 0 { random.pick(&[10.0, 100.0]) } else { 1.0 };
    let plain = |random: &mut Random| {
        let from = Vec3::from_f64([(); 3].map(|()| far * random.between(-2.0 * AWAY, 2.0 * AWAY))).ok()?;
        if objects.is_empty() || random.below(8) == 0 {
            return Ray::new(from, direction(random)).ok();
        }
        let object = random.pick(objects);
        let target = special_point(&object.shape, random);
        match random.below(3) {
            // From the point, or through it.
            0 => Ray::new(Vec3::from_f64(target).ok()?, direction(random)).ok(),
            1 => {
                let along = direction::<S>(random);
                let back = random.between(0.0, 4.0 * AWAY * far);
                Ray::new(Vec3::from_f64(add(target, scale(along.to_f64(), -back))).ok()?, along).ok()
            }
            _ => Ray::towards(from, Vec3::from_f64(target).ok()?).ok(),
        }
    };
    let mut ray = plain(random)?;
    if random.below(3) == 0
        && let Some(on) = scene.nearest(&ray, &mut Counters::default())
        && let Some(object) = scene.object(on.object)
    {
        let surface = object.shape.surface(&ray, &on.hit);
        if let Ok(next) = Ray::new(surface.point(), direction(random)) {
            let leaving = random.pick(&[Leaving::Outwards, Leaving::Inwards]);
            ray = if random.below(4) == 0 { next } else { next.departing(surface.departure(on.object, leaving)) };
        }
    }
    let (a, b) = (random.between(-AWAY, 2.0 * AWAY), random.between(-AWAY, 4.0 * AWAY));
    let hit = scene.nearest(&ray, &mut Counters::default()).map(|on| on.hit.t);
    let range = match (random.below(8), hit) {
        (0, _) => Range::new(number(a.min(b)), number(a.max(b))).expect("in order"),
        (1, _) => Range::line(),
        (2, _) => Range::new(S::ZERO, number(b.abs())).expect("in order"),
        // Ends and begins exactly at a hit.
        (3, Some(t)) => Range::new(S::ZERO, t).unwrap_or(Range::FORWARD),
        (4, Some(t)) => Range::new(t, S::BUDGET.distance).unwrap_or(Range::FORWARD),
        (5, Some(t)) => Range::new(t, t).unwrap_or(Range::FORWARD),
        _ => Range::FORWARD,
    };
    Some(ray.with_range(range))
}

/// A camera, for scenes of which no picture is made.
pub fn camera<S: Scalar>() -> Camera<S> {
    let at = |z| point([0.0, 0.0, z]);
    Camera::new(at(9.0), at(0.0), point([0.0, 1.0, 0.0]), number(40.0)).expect("a camera")
}

/// A ball with nine smaller ones around it, with nine around each, and so on for `depth` rounds: 1, 10, 91, 820 of
/// them.
pub fn flake<S: Scalar>(depth: u32) -> Vec<Object<S>> {
    fn grow<S: Scalar>(centre: [f64; 3], radius: f64, depth: u32, into: &mut Vec<Object<S>>) {
        let ball = Shape::new(Sphere::new(number(radius)).expect("a size"));
        into.push(Object::new(ball.placed(Frame::at(point(centre)).expect("within the budget")), 1));
        if depth == 0 {
            return;
        }
        for i in 0..9_u32 {
            // Around a golden spiral, the directions are evenly spread.
            let height = 1.0 - (2.0 * f64::from(i) + 1.0) / 9.0;
            let (sine, cosine) = (f64::from(i) * 2.4 + f64::from(depth)).sin_cos();
            let across = (1.0 - height * height).sqrt();
            let away = scale([across * cosine, height, across * sine], radius * 4.0 / 3.0);
            grow(add(centre, away), radius / 3.0, depth - 1, into);
        }
    }
    let mut objects = vec![];
    grow([0.0; 3], 1.0, depth, &mut objects);
    objects
}
