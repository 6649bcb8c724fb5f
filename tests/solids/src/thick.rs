//! Balls that move along a ray: their first contact, beside the distance of the centre from the solid in `f64`.

use crate::values::{n, point};
use fixed::types::{I8F24, I16F16, I20F12, I32F32};
use raylet::thick::{self, Contact, ThickError, ThickRay};
use raylet::{
    Affine, Capsule, Cone, Cuboid, Cylinder, Disc, Exact as ExactTier, Fast, Frame, Plain, Plane, Primitive, Range,
    Ray, Rectangle, RoundedCuboid, Scalar, Shape, SizeError, Sphere, Stable, Tier, Triangle, UnitVec3, ValueError,
    Vec3,
};
use support::random::{Random, add, cross, dot, scale};

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    add(a, scale(b, -1.0))
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// The distance of a point from a segment.
fn from_segment(p: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let (ab, ap) = (sub(b, a), sub(p, a));
    let t = (dot(ap, ab) / dot(ab, ab)).clamp(0.0, 1.0);
    length([0, 1, 2].map(|i| ap[i] - t * ab[i]))
}

/// The distance of a point from a solid, zero inside: by definition, and not as the library computes it.
fn distance<S: Scalar>(shape: &Shape<S>, point: [f64; 3]) -> f64 {
    let p = shape.frame().map_or(point, |frame| {
        let from = sub(point, frame.position().to_f64());
        frame.axes().map(|axis| dot(axis.to_f64(), from))
    });
    let outside = |half: [f64; 3]| length([0, 1, 2].map(|i| (p[i].abs() - half[i]).max(0.0)));
    match shape.primitive() {
        Primitive::Sphere(sphere) => (length(p) - sphere.radius().to_f64()).max(0.0),
        Primitive::Capsule(capsule) => {
            let top = [0.0, capsule.height().to_f64(), 0.0];
            let from_axis = if top[1] == 0.0 { length(p) } else { from_segment(p, [0.0; 3], top) };
            (from_axis - capsule.radius().to_f64()).max(0.0)
        }
        Primitive::Plane(_) => p[1].abs(),
        Primitive::RoundedCuboid(cuboid) => {
            (outside(cuboid.half_extents().map(S::to_f64)) - cuboid.radius().to_f64()).max(0.0)
        }
        Primitive::Cuboid(cuboid) => outside(cuboid.half_extents().map(S::to_f64)),
        Primitive::Rectangle(rectangle) => {
            let [x, z] = rectangle.half_extents().map(S::to_f64);
            outside([x, 0.0, z])
        }
        Primitive::Triangle(triangle) => {
            let [a, b, c] = triangle.vertices().map(Vec3::to_f64);
            let n = cross(sub(b, a), sub(c, a));
            let within = [(a, b), (b, c), (c, a)].iter().all(|(a, b)| dot(cross(n, sub(*b, *a)), sub(p, *a)) >= 0.0);
            if within {
                return (dot(n, sub(p, a)) / length(n)).abs();
            }
            from_segment(p, a, b).min(from_segment(p, b, c)).min(from_segment(p, c, a))
        }
        other => panic!("{other:?}"),
    }
}

/// A shape that a ball can be tested against.
fn shape<S: Scalar>(random: &mut Random) -> Option<Shape<S>> {
    let mut size = || n::<S>(0.25 + 2.0 * random.unit());
    let [a, b, c] = [size(), size(), size()];
    let primitive: Primitive<S> = match random.below(7) {
        0 => Sphere::new(a).ok()?.into(),
        1 => Capsule::new(a, if random.below(4) == 0 { S::ZERO } else { b }).ok()?.into(),
        2 => Plane::new().into(),
        3 => Cuboid::new(a, b, c).ok()?.into(),
        4 if random.below(2) == 0 => RoundedCuboid::new(a, b, S::ZERO, c.scaled(-2)).ok()?.into(),
        4 => RoundedCuboid::new(a, b, c, b.scaled(-1)).ok()?.into(),
        5 => Rectangle::new(a, b).ok()?.into(),
        _ => {
            let mut vertex = || point(random.direction().map(|x| 2.0 * x));
            Triangle::new(vertex(), vertex(), vertex()).ok()?.into()
        }
    };
    let shape = Shape::new(primitive);
    let position = point(random.direction().map(|x| 8.0 * x));
    Some(match random.below(4) {
        0 => shape,
        1 => shape.placed(Frame::at(position).ok()?),
        _ => {
            let axes =
                [random.direction(), random.direction()].map(|axis| UnitVec3::new(point(axis)).expect("no zero"));
            shape.placed(Frame::looking(position, axes[0], axes[1]).ok()?)
        }
    })
}

/// A ball that moves towards a point near the shape, or past it.
fn ball<S: Scalar>(random: &mut Random, shape: &Shape<S>) -> Option<ThickRay<S>> {
    let centre = shape.placement().position().to_f64();
    let target = random.direction().map(|x| 3.0 * x * x.abs());
    let target = [0, 1, 2].map(|i| centre[i] + target[i]);
    let away = random.pick(&[0.5, 2.0, 4.0, 12.0]);
    let from = random.direction();
    let from = [0, 1, 2].map(|i| target[i] + away * from[i]);
    let ray = Ray::towards(point(from), point(target)).ok()?;
    let range = |from: f64, to: f64| Range::new(n(from), n(to)).ok();
    let ray = match random.below(5) {
        0 => ray,
        1 => ray.with_range(range(0.0, 6.0)?),
        2 => ray.with_range(range(0.5, 20.0)?),
        3 => ray.with_range(range(-20.0, 20.0)?),
        // A step, as of one frame of an animation.
        _ => {
            let from = away * random.unit();
            ray.with_range(range(from, from + 0.5)?)
        }
    };
    ThickRay::new(ray, n(random.pick(&[0.0625, 0.25, 0.5, 1.0, 3.0]))).ok()
}

/// Checks one contact, or none, and returns what happened.
fn check<S: Scalar, T: Tier<S>>(shape: &Shape<S>, ball: &ThickRay<S>, unit: f64) -> &'static str {
    let told = || format!("{shape:?}\n{ball:?}");
    let contact = ball.contact_at::<T, _>(shape).unwrap_or_else(|error| panic!("{error}\n{}", told()));
    let (o, d, r) = (ball.ray().origin().to_f64(), ball.ray().direction().to_f64(), ball.radius().to_f64());
    let at = |t: f64| [0, 1, 2].map(|i| o[i] + t * d[i]);
    let range = ball.ray().range();
    let (start, end) = (range.start().to_f64(), range.end().to_f64().min(60.0));
    assert!(contact.is_none_or(|contact| contact.t <= range.end()), "beyond the range: {}", told());
    // With a plane far away.
    let contact = contact.filter(|contact| contact.t.to_f64() <= end);
    let clearance = |t: f64| distance(shape, at(t)) - r;
    // The distance from a convex set is convex along the ray: the least one before a contact is found by thirds.
    let least = |mut low: f64, mut high: f64| {
        for _ in 0..60 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if clearance(a) < clearance(b) { high = b } else { low = a }
        }
        clearance(low).min(clearance(high))
    };
    // Eight units in the last place, of coordinates up to 64; and what rounding adds.
    let (begins, touching) = (clearance(start), 4.0 * unit);
    // What it has met where it starts; and that it is pushed out by it.
    let at_start = ball.at_start(shape).expect("as above");
    assert!(begins.abs() <= touching || at_start.is_some() == (begins < 0.0), "{begins} {at_start:?} {}", told());
    if let Some(Contact { t, point, normal, overlaps }) = at_start {
        assert!(t == range.start() && (overlaps == (begins < 0.0) || begins.abs() <= touching), "{}", told());
        let is_in_block =
            matches!(shape.primitive(), Primitive::Cuboid(_) | Primitive::RoundedCuboid(_)) && begins <= unit - r;
        let out = add(point.to_f64(), scale(normal.to_f64(), r));
        let apart = distance(shape, out) - r;
        // Where the nearest point is next to the centre, the normal is as uncertain as both.
        let is_near = length(sub(at(start), point.to_f64())) < 1000.0 * unit;
        assert!(is_in_block || is_near || apart.abs() <= 4.0 * unit, "pushed to {apart}: {at_start:?} {}", told());
    }
    // What it comes closer, along a short path. Inside of a solid nothing is known of that here.
    let rate = (begins - clearance(start + 1e-4)) / 1e-4;
    let is_inside = begins <= unit - r;
    let Some(Contact { t, point, normal, overlaps }) = contact else {
        let goes_on = begins <= touching && (is_inside || rate <= 0.07);
        assert!(goes_on || least(start, end) >= -unit, "no contact: {begins} {} {}", least(start, end), told());
        return if goes_on { "goes on" } else { "passes" };
    };
    let (t, normal, on) = (t.to_f64(), normal.to_f64(), point.to_f64());
    assert!(start <= t && t <= end, "{t} {}", told());
    if begins <= -touching {
        assert!(t == start && overlaps && (is_inside || rate > -1e-3), "overlaps: {begins} {rate} {}", told());
        return "overlaps";
    }
    let most = if t == start { touching } else { unit };
    assert!(clearance(t).abs() <= most, "the clearance at t = {t} is {} {}", clearance(t), told());
    assert!(least(start, t) >= -most, "earlier: {} {}", least(start, t), told());
    assert!(dot(normal, d) <= unit, "it moves away: {}", told());
    let apart = sub(at(t), on);
    assert!((length(apart) - r).abs() <= 2.0 * most, "the point is {} away {}", length(apart), told());
    let across = [0, 1, 2].map(|i| apart[i] - r * normal[i]);
    assert!(length(across) <= 4.0 * unit, "the normal {}", told());
    assert!(distance(shape, on) <= 2.0 * unit, "the point is not on the solid: {}", told());
    "touches"
}

/// Random balls in one tier: `unit` is what the distance may be off at most.
fn many<S: Scalar, T: Tier<S>>(unit: f64) {
    let mut random = Random(0x7b1c_4a11);
    let mut seen = std::collections::BTreeMap::new();
    for _ in 0..4000 {
        let Some(shape) = shape::<S>(&mut random) else { continue };
        let Some(ball) = ball(&mut random, &shape) else { continue };
        *seen.entry(check::<S, T>(&shape, &ball, unit)).or_insert(0) += 1;
    }
    let [touches, passes, overlaps, goes_on] = ["touches", "passes", "overlaps", "goes on"].map(|what| seen[what]);
    assert!(touches > 800 && passes > 500 && overlaps > 300 && goes_on > 100, "{seen:?}");
}

/// What the distance of the centre from the solid may be off, in units of the last place of coordinates near 16.
const UNITS: f64 = 8.0;

#[test]
fn a_ball_touches_where_its_distance_is_its_radius() {
    let float = UNITS * 16.0 * 2f64.powi(-24);
    many::<f32, Stable>(float);
    many::<f32, Fast>(float);
    many::<f32, ExactTier>(float);
    many::<f64, Stable>(UNITS * 16.0 * 2f64.powi(-53));
    many::<I16F16, Stable>(UNITS * 2f64.powi(-16));
    many::<I16F16, ExactTier>(UNITS * 2f64.powi(-16));
    many::<I8F24, Stable>(UNITS * 2f64.powi(-24));
    many::<I20F12, Fast>(UNITS * 2f64.powi(-12));
    many::<I32F32, Stable>(UNITS * 2f64.powi(-32));
}

/// `Plain` has no guard against cancellation, and starts within 10 sizes here.
#[test]
fn plain_numbers_find_the_contacts_of_balls() {
    many::<f32, Plain>(64.0 * UNITS * 2f64.powi(-24));
    many::<I16F16, Plain>(UNITS * 2f64.powi(-16));
}

/// A ball above the level `y = 1` that moves along x.
fn along<S: Scalar>(y: f64, z: f64, r: f64) -> ThickRay<S> {
    ThickRay::new(Ray::new(point([-5.0, y, z]), UnitVec3::X).expect("a ray"), n(r)).expect("a radius")
}

#[test]
fn a_cuboid_is_met_at_faces_edges_and_corners() {
    let block = Shape::new(Cuboid::new(1.0_f64, 1.0, 1.0).expect("sizes"));
    let t = |y: f64, z: f64| along(y, z, 0.5).contact(&block).expect("a block").map(|contact| contact.t);
    assert_eq!(t(0.0, 0.0), Some(3.5));
    assert_eq!(t(1.0, 1.0), Some(3.5));
    // Over an edge by 0.3: the centre is 0.4 in front of it.
    assert_eq!(t(1.3, 0.0).map(|t| (t - 3.6).abs() < 1e-15), Some(true));
    // Over a corner by 0.3 twice.
    let corner = 4.0 - (0.25_f64 - 0.18).sqrt();
    assert_eq!(t(1.3, -1.3).map(|t| (t - corner).abs() < 1e-15), Some(true));
    // Past it: beside the edge, and beside the corner within the box around the grown block.
    assert_eq!((t(1.51, 0.0), t(1.4, 1.4)), (None, None));
    let contact = along(1.3, 0.0, 0.5).contact(&block).expect("a block").expect("a contact");
    assert_eq!(contact.point, Vec3::new(-1.0, 1.0, 0.0));
}

/// A ray that enters the box around a grown block beside one edge, and meets the capsule of another one.
#[test]
fn a_ball_that_passes_one_edge_may_meet_another() {
    let block = Shape::new(Cuboid::new(1.0_f64, 1.0, 1.0).expect("sizes"));
    let (mut random, mut met) = (Random(5), 0);
    for _ in 0..20_000 {
        let mut near = || 1.0 + random.unit();
        let (from, to) = ([near() + 1.0, near(), near() - 0.5], [near() - 1.0, near() - 0.5, near() + 0.5]);
        let Ok(ray) = Ray::towards(point(from), point(to)) else { continue };
        let ball = ThickRay::new(ray, 1.0).expect("a radius");
        if check::<f64, Stable>(&block, &ball, 1e-14) == "touches" {
            met += 1;
        }
    }
    assert!(met > 1000, "{met}");
}

#[test]
fn a_ball_leaves_and_slides_along_what_it_touches() {
    fn of<S: Scalar>() {
        let floor = Shape::new(Plane::<S>::new());
        let ball = |direction: [f64; 3]| {
            let direction = UnitVec3::from_f64(direction).expect("a direction");
            let ray = Ray::new(point([3.0, 0.5, 1.0]), direction).expect("a ray");
            ThickRay::new(ray, n(0.5)).expect("a radius").contact(&floor).expect("a plane")
        };
        assert_eq!(ball([1.0, 0.0, 0.0]), None, "it slides");
        assert_eq!(ball([1.0, 0.5, 0.0]), None, "it leaves");
        let contact = ball([0.0, -1.0, 0.0]).expect("it is pressed");
        assert_eq!((contact.t, contact.overlaps), (S::ZERO, false));
        assert_eq!((contact.point, contact.normal), (point([3.0, 0.0, 1.0]), UnitVec3::Y));
        // From its contact with a block it goes on in any direction that does not lead into it.
        let block = Shape::new(Cuboid::new(n::<S>(0.7), n(0.3), n(0.9)).expect("sizes"));
        let frame = Frame::turned_about(point([4.0, 1.0, -3.0]), UnitVec3::Z, n(30.0)).expect("a frame");
        let block = block.placed(frame);
        let ball = ThickRay::new(Ray::towards(point([0.0; 3]), point([4.0, 1.0, -3.0])).expect("a ray"), n(0.25));
        let ball = ball.expect("a radius");
        let contact = ball.contact(&block).expect("a block").expect("a contact");
        let centre = ball.ray().at(contact.t);
        for (direction, leads_in) in [(contact.normal, false), (-contact.normal, true)] {
            let ball = ThickRay::new(Ray::new(centre, direction).expect("a ray"), n(0.25)).expect("a radius");
            let again = ball.contact(&block).expect("a block");
            assert_eq!(again.map(|again| again.t), leads_in.then_some(S::ZERO));
        }
    }
    of::<f32>();
    of::<f64>();
    of::<I16F16>();
    of::<I20F12>();
}

#[test]
fn the_first_of_a_list_is_its_nearest() {
    let at = |x: f32| Shape::new(Sphere::new(1.0_f32).unwrap()).placed(Frame::at(Vec3::new(x, 0.0, 0.0)).unwrap());
    let ball = along::<f32>(0.0, 0.0, 0.5);
    let first = |shapes: &[Shape<f32>]| thick::first::<_, Stable, _>(&ball, shapes).unwrap().map(|(index, _)| index);
    assert_eq!(first(&[at(6.0), at(3.0), at(3.0)]), Some(1));
    assert_eq!((first(&[]), first(&[at(-20.0)])), (None, None));
}

#[test]
fn what_a_ball_cannot_be_tested_against_is_named() {
    let ball = along::<f32>(0.0, 0.0, 0.5);
    let message = |shape: Shape<f32>| ball.contact(&shape).unwrap_err().to_string();
    let only =
        "a ball is tested against a Sphere, Capsule, Plane, Cuboid, RoundedCuboid, Rectangle or Triangle, and not a";
    assert_eq!(message(Shape::new(Cylinder::infinite(1.0).unwrap())), format!("{only} Cylinder"));
    assert_eq!(message(Shape::new(Cone::double(1.0).unwrap())), format!("{only} Cone"));
    assert_eq!(message(Shape::new(Disc::new(1.0).unwrap())), format!("{only} Disc"));
    let stretch = Affine::stretched(Frame::at(Vec3::ZERO).unwrap(), Vec3::new(1.0, 2.0, 1.0)).unwrap();
    let stretched = message(Shape::new(Sphere::new(1.0).unwrap()).placed(stretch));
    let by_frame = "a ball is not tested against a shape in an affine placement: place the shape by a frame";
    assert_eq!(stretched, by_frame);

    let ray = Ray::new(Vec3::<I16F16>::ZERO, UnitVec3::X).unwrap();
    assert_eq!(ThickRay::new(ray, I16F16::ZERO), Err(SizeError::Radius(ValueError::Zero)));
    let huge = I16F16::from_num(16_000);
    let ball = ThickRay::new(Ray::new(Vec3::new(I16F16::from_num(-16_000), huge, huge), UnitVec3::X).unwrap(), huge);
    let error = ball
        .unwrap()
        .contact(&Shape::new(Sphere::new(huge).unwrap()).placed(Frame::at(Vec3::new(huge, -huge, -huge)).unwrap()));
    assert!(matches!(error, Err(ThickError::Size(SizeError::Radius(ValueError::BeyondBudget)))), "{error:?}");
    let message = error.unwrap_err().to_string();
    let too_large = "the shape grown by the ball's radius has a piece that is too large: the radius is";
    assert!(message.starts_with(too_large), "{message}");
}

/// A range within the box around a grown block meets no face of that box.
#[test]
fn a_short_step_next_to_an_edge_is_seen() {
    fn of<S: Scalar>() {
        let down = UnitVec3::from_f64([-1.0, -1.0, 0.0]).expect("a direction");
        let step = |y: f64| {
            let ray = Ray::new(point([1.9, y, 0.0]), down).expect("a ray");
            let range = Range::new(S::ZERO, n(0.5)).expect("a range");
            ThickRay::new(ray.with_range(range), n(1.0)).expect("a radius")
        };
        let t = |shape: Shape<S>, y: f64| step(y).contact(&shape).expect("a shape").map(|contact| contact.t.to_f64());
        let block = Shape::new(Cuboid::new(n(1.0), n(1.0), n(1.0)).expect("sizes"));
        let mat = Shape::new(Rectangle::new(n(1.0), n(1.0)).expect("sizes"));
        let expected = 0.9 * 2f64.sqrt() - 1.0;
        for found in [t(block, 1.9), t(mat, 0.9)] {
            assert!(found.is_some_and(|t| (t - expected).abs() < 1e-3), "{found:?}");
        }
    }
    of::<f32>();
    of::<f64>();
    of::<I16F16>();
}

/// A ball that came from afar overlaps what it touches by the rounding of its way.
#[test]
fn a_ball_from_afar_goes_on_from_its_contact() {
    fn of<S: Scalar>(distances: &[f64]) {
        let (mut random, mut contacts) = (Random(0xfa2), 0);
        let ball = Shape::new(Sphere::new(n::<S>(0.5)).expect("a size"));
        let block = Shape::new(Cuboid::new(n::<S>(0.5), n(0.25), n(0.75)).expect("sizes"));
        for distance in distances {
            for _ in 0..300 {
                let from = random.direction().map(|x| distance * x);
                let to = random.direction().map(|x| 0.4 * x);
                let Ok(ray) = Ray::<S>::towards(point(from), point(to)) else { continue };
                let shape = if random.below(2) == 0 { ball } else { block };
                let thick = ThickRay::new(ray, n(0.25)).expect("a radius");
                let Some(contact) = thick.contact(&shape).expect("a shape") else { continue };
                let again = |direction: UnitVec3<S>| {
                    let ray = Ray::new(ray.at(contact.t), direction).expect("a ray");
                    ThickRay::new(ray, n(0.25)).expect("a radius").contact(&shape).expect("a shape")
                };
                let (tangent, other) = contact.normal.perpendicular();
                for along in [contact.normal, tangent, -tangent, other] {
                    assert_eq!(again(along), None, "{shape:?} {thick:?} {contact:?} {along:?}");
                }
                // It may stand as far away as its way was rounded.
                let pressed = again(-contact.normal).map(|contact| contact.t.to_f64());
                assert!(
                    pressed.is_some_and(|t| t <= 2f64.powi(-14) + distance * 2f64.powi(-22)),
                    "{pressed:?} {shape:?} {thick:?}"
                );
                contacts += 1;
            }
        }
        assert!(contacts > 100 * distances.len(), "{contacts}");
    }
    of::<f32>(&[2.0, 16.0, 128.0, 1e4]);
    of::<f64>(&[2.0, 16.0, 128.0, 1e4]);
    of::<I16F16>(&[2.0, 128.0, 1e4]);
    of::<I8F24>(&[2.0, 30.0]);
}

#[path = "../../../examples/character.rs"]
mod character;

/// A ball that is pushed along tilted floors and onto them, as in the example, goes on at each step.
#[test]
fn a_ball_slides_on_floors_of_any_tilt() {
    let mut random = Random(0x510);
    for _ in 0..200 {
        let up = {
            let [x, _, z] = random.direction();
            UnitVec3::from_f64([0.5 * x, 1.0, 0.5 * z]).expect("a direction")
        };
        let floor = Frame::from_base_and_axis(point([random.unit(), random.unit(), 0.0]), up).expect("a frame");
        let room = [Shape::new(Plane::new()).placed(floor)];
        let along = |x: f64, z: f64| floor.point_to_world(point([x, f64::from(character::RADIUS), z]));
        let mut at = along(0.0, 0.0);
        for _ in 0..60 {
            let [x, _, z] = random.direction();
            let push = along(0.05 * x, 0.05 * z) - along(0.0, 0.0);
            // A push along the floor, and a smaller one down.
            let step = push + Vec3::new(0.0, -0.01, 0.0);
            let next = character::moved(at, step, &room).expect("a plane");
            let gone = dot(sub(next.to_f64(), at.to_f64()), push.to_f64()) / length(push.to_f64());
            assert!(gone > 0.5 * length(push.to_f64()) - 0.01, "{gone} of {push:?}: {at:?} {room:?}");
            at = next;
        }
        let height = floor.point_to_local(at).y;
        assert!((height - character::RADIUS).abs() < 1e-4, "it sank or rose: {height}");
    }
    character::main().expect("it passes the gap");
}

#[test]
fn a_ball_may_come_from_everywhere() {
    fn of<S: Scalar>() {
        let ball = Shape::new(Sphere::new(n::<S>(1.0)).expect("a size"));
        let floor = Shape::new(Plane::<S>::new());
        let mat = Shape::new(Rectangle::new(n::<S>(1.0), n(1.0)).expect("sizes"));
        let line = |origin: [f64; 3], direction: UnitVec3<S>| {
            let ray = Ray::new(point(origin), direction).expect("a ray").with_range(Range::line());
            ThickRay::new(ray, n(0.5)).expect("a radius")
        };
        let t = |thick: ThickRay<S>, shape| thick.contact(shape).expect("a shape").map(|contact| contact.t.to_f64());
        assert_eq!(t(line([3.0, 10.0, 0.0], UnitVec3::X), &ball), None);
        assert_eq!(t(line([3.0, 0.0, 0.0], UnitVec3::X), &ball), Some(-4.5));
        assert_eq!(t(line([3.0, 2.0, 0.0], -UnitVec3::Y), &floor), Some(1.5));
        assert_eq!(t(line([3.0, 2.0, 0.0], UnitVec3::Y), &floor), Some(-2.5));
        assert_eq!(t(line([0.5, 2.0, 0.0], UnitVec3::Y), &mat), Some(-2.5));
        // Along a floor in which it lies it slides; that it overlaps it is told.
        let low = line([3.0, 0.25, 0.0], UnitVec3::X);
        assert_eq!(t(low, &floor), None);
        let low =
            ThickRay::new(low.ray().with_range(Range::from(S::ZERO).expect("a range")), n(0.5)).expect("a radius");
        assert!(low.at_start(&floor).expect("a plane").is_some_and(|contact| contact.overlaps));
    }
    of::<f32>();
    of::<f64>();
    of::<I16F16>();
    of::<I8F24>();
    of::<I32F32>();
}

/// Coordinates and sizes whose sums are beyond the type, and edges longer than a capsule of the type may be.
#[test]
fn balls_are_tested_up_to_the_limits_of_fixed_point() {
    fn down<S: Scalar>(y: f64, r: f64, floor: f64) -> Option<f64> {
        let floor = Shape::new(Plane::new()).placed(Frame::at(point([0.0, floor, 0.0])).expect("a frame"));
        let ray = Ray::<S>::new(point([0.0, y, 0.0]), -UnitVec3::Y).expect("a ray");
        let contact = ThickRay::new(ray, n(r)).expect("a radius").contact(&floor).expect("a plane");
        contact.map(|contact| contact.t.to_f64())
    }
    assert_eq!(down::<I8F24>(64.0, 64.0, -32.0), Some(32.0));
    assert_eq!(down::<I16F16>(16384.0, 16384.0, -16384.0), Some(16384.0));

    let block = Shape::new(Cuboid::new(n::<I8F24>(33.0), n(33.0), n(33.0)).unwrap());
    for y in [3.3, 33.3] {
        let ray = Ray::new(point([-50.0, y, 0.0]), UnitVec3::X).unwrap();
        check::<I8F24, Stable>(&block, &ThickRay::new(ray, n(0.5)).unwrap(), UNITS * 2f64.powi(-24));
    }
    // The range starts beyond the type, where saturated coordinates are on the other side of the plane.
    let frame = Frame::turned_about(point([15000.0; 3]), UnitVec3::Z, n(30.0)).unwrap();
    let plane = Shape::new(Plane::<I16F16>::new()).placed(frame);
    let direction = UnitVec3::from_f64([-0.72154, -0.35735, -0.59303]).unwrap();
    let ray = Ray::new(point([15497.0956, 15392.0833, 15444.7070]), direction).unwrap();
    let ray = ray.with_range(Range::new(n(-30000.0), n(2000.0)).unwrap());
    check::<I16F16, Stable>(&plane, &ThickRay::new(ray, n(5.0)).unwrap(), 2f64.powi(-8));
}

/// Products of a triangle's sizes may overflow, or underflow to zero.
#[test]
fn triangles_of_any_size_and_place_are_met() {
    for s in [1e-20, 1e-12, 1e-6, 1.0, 1e6, 1e12, 1e17_f32] {
        let corners = [[-2.0, -2.0, 0.0], [2.0, -2.0, 0.0], [0.0, 2.0, 0.0]].map(|p: [f32; 3]| p.map(|c| c * s));
        let [a, b, c] = corners.map(|[x, y, z]| Vec3::new(x, y, z));
        let Ok(triangle) = Triangle::new(a, b, c) else { continue };
        let t = |x: f32| {
            let ray = Ray::new(Vec3::new(x * s, 0.3 * s, 5.0 * s), -UnitVec3::Z).unwrap();
            ThickRay::new(ray, 0.5 * s).unwrap().contact(&Shape::new(triangle)).unwrap().map(|contact| contact.t / s)
        };
        assert_eq!(t(5.0), None, "{s}");
        assert!(t(0.1).is_some_and(|t| (t - 4.5).abs() < 1e-5), "{s}: {:?}", t(0.1));
    }
    let frame = Frame::turned_about(Vec3::new(1e5_f32, 1e5, 1e5), UnitVec3::X, 30.0).unwrap();
    let small = Triangle::new(Vec3::ZERO, Vec3::new(1e-3, 0.0, 0.0), Vec3::new(0.0, 0.0, 1e-3)).unwrap();
    let ray = Ray::new(Vec3::new(1e5_f32, 1e5 + 10.0, 1e5), -UnitVec3::Y).unwrap();
    let contact = ThickRay::new(ray, 0.25).unwrap().contact(&Shape::new(small).placed(frame)).unwrap();
    assert!(contact.is_some_and(|contact| (contact.t - 9.75).abs() < 0.05), "{contact:?}");
}

/// A ball whose centre lies where no single point of the solid is nearest is pushed out against its ray.
#[test]
fn a_ball_in_the_middle_is_pushed_out() {
    fn of<S: Scalar>() {
        let pushed = |shape: Shape<S>, at: [f64; 3], along: [f64; 3]| {
            let direction = UnitVec3::from_f64(along).expect("a direction");
            let ball = ThickRay::new(Ray::new(point(at), direction).expect("a ray"), n(0.5)).expect("a radius");
            let contact = ball.contact(&shape).expect("a shape").expect("it moves in it");
            assert_eq!((contact.t, contact.overlaps, Ok(Some(contact))), (S::ZERO, true, ball.at_start(&shape)));
            (contact.normal.to_f64(), contact.point.to_f64())
        };
        let near = |found: ([f64; 3], [f64; 3]), normal: [f64; 3], on: [f64; 3]| {
            let off = |a: [f64; 3], b: [f64; 3]| length(sub(a, b));
            assert!(off(found.0, normal) < 1e-4 && off(found.1, on) < 1e-3, "{found:?} and not {normal:?} {on:?}");
        };
        let ball = Shape::new(Sphere::new(n(1.0)).expect("a size"));
        near(pushed(ball, [0.0; 3], [0.0, 0.6, 0.8]), [0.0, -0.6, -0.8], [0.0, -0.6, -0.8]);
        let pill = Shape::new(Capsule::new(n(1.0), n(4.0)).expect("sizes"));
        near(pushed(pill, [0.0, 2.0, 0.0], [0.6, 0.8, 0.0]), [-1.0, 0.0, 0.0], [-1.0, 2.0, 0.0]);
        let floor = Shape::new(Plane::new());
        near(pushed(floor, [3.0, 0.0, 1.0], [0.6, 0.8, 0.0]), [0.0, -1.0, 0.0], [3.0, 0.0, 1.0]);
        let mat = Shape::new(Rectangle::new(n(1.0), n(1.0)).expect("sizes"));
        near(pushed(mat, [0.5, 0.0, 0.5], [0.6, -0.8, 0.0]), [0.0, 1.0, 0.0], [0.5, 0.0, 0.5]);
        let [a, b, c] = [[-1.0, 0.0, -1.0], [1.0, 0.0, -1.0], [0.0, 0.0, 2.0]].map(point);
        let flat = Shape::new(Triangle::new(a, b, c).expect("a triangle"));
        near(pushed(flat, [0.0; 3], [0.6, -0.8, 0.0]), [0.0, 1.0, 0.0], [0.0; 3]);
        let block = Shape::new(Cuboid::new(n(1.0), n(1.0), n(1.0)).expect("sizes"));
        near(pushed(block, [0.5, 0.25, 0.0], [0.6, 0.8, 0.0]), [-0.6, -0.8, 0.0], [0.5, 0.25, 0.0]);
        // The same in a turned frame, whose axes are then those of the world in turn.
        let axes = [UnitVec3::Y, UnitVec3::Z, UnitVec3::X];
        let turned = Frame::from_axes(point([1.0, 2.0, 3.0]), axes).expect("a frame");
        near(pushed(mat.placed(turned), [1.5, 2.5, 3.0], [0.0, 0.6, -0.8]), [0.0, 0.0, 1.0], [1.5, 2.5, 3.0]);
        near(pushed(pill.placed(turned), [1.0, 2.0, 5.0], [0.0, 0.6, 0.8]), [0.0, -1.0, 0.0], [1.0, 1.0, 5.0]);
    }
    of::<f32>();
    of::<f64>();
    of::<I16F16>();
}

/// A ball in the middle of a core without extent along an axis is pushed along that.
#[test]
fn a_ball_in_a_thin_core_is_pushed_across_it() {
    let zero = Vec3::new(0.0_f64, 0.0, 0.0);
    let normal = |half: [f64; 3], along: [f64; 3]| {
        let solid = Shape::new(RoundedCuboid::new(half[0], half[1], half[2], 1.0).unwrap());
        let ray = Ray::new(zero, UnitVec3::new(along.into()).unwrap()).unwrap();
        let contact = ThickRay::new(ray, 0.25).unwrap().contact(&solid).unwrap();
        contact.map(|contact| contact.normal.to_f64())
    };
    assert_eq!(normal([0.0; 3], [1.0, 0.0, 0.0]), Some([-1.0, 0.0, 0.0]));
    assert_eq!(normal([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]), Some([0.0, 0.0, -1.0]));
    assert_eq!(normal([1.0, 0.0, 2.0], [0.6, 0.8, 0.0]), Some([0.0, -1.0, 0.0]));
    // Along the plate it does not move closer.
    assert_eq!(normal([0.0, 1.0, 1.0], [0.0, 1.0, 0.0]), None);
}
