//! Light through several media, beside the path by Snell's law: coatings, overlap, bubbles, lenses, a glass of water.

use crate::glass::*;
use crate::values::point;
use fixed::types::{I16F16, I32F32};
use raylet::gallery::BuiltIn;
use raylet::shape::combination::Op;
use raylet::shape::kinds::Combining;
use raylet::{Color, Combination, Cylinder, Exact, Fast, Frame, Material, Object, Plain, Scalar, Shape, Stable, Tier};
use support::random::{Random, dot};

fn media_are_refracted_by_their_ratio<S: Scalar, T: Tier<S>>() {
    let level = [0.0, 1.0, 0.0];
    let materials = || vec![glass::<S>(1.5), glass(1.333), glass(1.0)];
    let balls = ball_of::<S>;
    for (from, to) in
        [([0.0, 4.0, 0.5], [0.8, 0.0, 0.0]), ([-5.0, 3.0, 0.0], [0.25, 0.25, 0.1]), ([1.0, 5.0, 2.0], [0.1, 0.3, 0.2])]
    {
        use Surface::{Ball, Height};
        // A coating of water on glass, listed in either order.
        for objects in [
            vec![slab(0.0, 1.0, level, 0), slab(1.0, 1.25, level, 1)],
            vec![slab(1.0, 1.25, level, 1), slab(0.0, 1.0, level, 0)],
        ] {
            let layers = [(Height(1.25), 1.333), (Height(1.0), 1.5), (Height(0.0), 1.0)];
            leads::<S, T>(&(objects, materials()), [from, to], 1.0, &layers);
        }
        // Water that overlaps the glass under it: the one that is listed last is where they overlap.
        let (glass_part, water_part) = (|| slab(0.0, 1.0, level, 0), || slab(0.5, 1.5, level, 1));
        let water = [(Height(1.5), 1.333), (Height(0.5), 1.5), (Height(0.0), 1.0)];
        leads::<S, T>(&(vec![glass_part(), water_part()], materials()), [from, to], 1.0, &water);
        let wall = [(Height(1.5), 1.333), (Height(1.0), 1.5), (Height(0.0), 1.0)];
        leads::<S, T>(&(vec![water_part(), glass_part()], materials()), [from, to], 1.0, &wall);
        // A bubble of air in glass.
        let centre = [0.2, 0.2, 0.1];
        let bubble = vec![slab(-1.5, 1.5, level, 0), balls(centre, 1.0, 2)];
        let surfaces = [(Height(1.5), 1.5), (Ball(centre, 1.0), 1.0), (Ball(centre, 1.0), 1.5), (Height(-1.5), 1.0)];
        let inner = path(from, to, 1.0, &surfaces[..1]);
        let offset = along(inner.0, centre, -1.0);
        let (b, c) = (dot(offset, inner.1), dot(offset, offset) - 1.0);
        // Total reflection at the bubble is another path.
        if b * b - c > 0.0 && (1.0 - (b * b - c)).sqrt() * 1.5 < 0.95 {
            leads::<S, T>(&(bubble, materials()), [from, to], 1.0, &surfaces);
        }
    }
    // A ball of water in a ball of glass, and the eye in the water.
    let nested = (vec![balls([0.0; 3], 2.0, 0), balls([0.5, 0.0, 0.0], 1.0, 1)], materials());
    let eye = [0.5, 0.25, 0.0];
    let surfaces = [(Surface::Ball([0.5, 0.0, 0.0], 1.0), 1.5), (Surface::Ball([0.0; 3], 2.0), 1.0)];
    leads::<S, T>(&nested, [eye, [1.0, 2.0, 0.5]], 1.333, &surfaces);
    // Through two slabs that touch, at an angle at which a film of air between them would reflect everything.
    let touching = (vec![slab(0.0, 1.0, level, 0), slab(1.0, 2.0, level, 0)], materials());
    let (eye, at) = ([0.0, 0.5, 0.0], [1.7, 1.5, 0.0]);
    let (mut objects, mut materials) = touching;
    objects.push(balls(at, 0.2, 3));
    materials.push(Material::matte(Color::BLACK));
    assert_eq!(seen::<S, T, _>(&(objects, materials), eye, at).0, 0.0);
}

#[test]
fn light_is_bent_at_each_interface_by_snell() {
    media_are_refracted_by_their_ratio::<f32, Plain>();
    media_are_refracted_by_their_ratio::<f32, Stable>();
    media_are_refracted_by_their_ratio::<f32, Exact>();
    media_are_refracted_by_their_ratio::<f64, Fast>();
    media_are_refracted_by_their_ratio::<f64, Stable>();
    media_are_refracted_by_their_ratio::<I16F16, Stable>();
    media_are_refracted_by_their_ratio::<I16F16, Exact>();
    media_are_refracted_by_their_ratio::<I32F32, Stable>();
}

/// The upright cylinders of the glass of water, as numbers: radius, base, height and index, in the order of the list.
const CYLINDERS: [[f64; 4]; 3] = [[1.0, 0.0, 2.4, 1.5], [0.9, 0.2, 2.3, 1.0], [0.9, 0.2, 1.4, 1.333]];

/// The index of refraction at a point: that of the last cylinder that holds it.
fn index_at([x, y, z]: Vector) -> f64 {
    let holds = |[radius, base, height, _]: &[f64; 4]| {
        x * x + z * z <= radius * radius && (0.0..=*height).contains(&(y - base))
    };
    CYLINDERS.iter().rev().find(|cylinder| holds(cylinder)).map_or(1.0, |cylinder| cylinder[3])
}

/// The path through the glass of water, by the indices on both sides of every point where the ray meets a cylinder;
/// `None` if light is reflected totally or meets the floor.
fn path_through_water(from: Vector, to: Vector) -> Option<(Vector, Vector)> {
    let difference = along(to, from, -1.0);
    let length = dot(difference, difference).sqrt();
    let (mut at, mut direction) = (from, difference.map(|c| c / length));
    for _ in 0..20 {
        let mut met: Vec<(f64, Vector)> = vec![];
        for [radius, base, height, _] in CYLINDERS {
            let a = direction[0] * direction[0] + direction[2] * direction[2];
            let k = at[0] * direction[0] + at[2] * direction[2];
            let root = (k * k - a * (at[0] * at[0] + at[2] * at[2] - radius * radius)).sqrt();
            for t in [(-k - root) / a, (-k + root) / a] {
                let [x, _, z] = along(at, direction, t);
                met.push((t, [x / radius, 0.0, z / radius]));
            }
            met.extend([base, base + height].map(|y| ((y - at[1]) / direction[1], [0.0, 1.0, 0.0])));
        }
        met.retain(|(t, _)| *t > 1e-9);
        met.sort_by(|a, b| a.0.total_cmp(&b.0));
        let near = |t| [-1e-7, 1e-7].map(|step| index_at(along(at, direction, t + step)));
        let Some((t, normal)) = met.into_iter().find(|(t, _)| near(*t)[0] != near(*t)[1]) else {
            return Some((at, direction));
        };
        let [before, behind] = near(t);
        let normal = if dot(normal, direction) < 0.0 { normal } else { normal.map(|c| -c) };
        at = along(at, direction, t);
        direction = refracted(direction, normal, before, behind);
        if at[1] < 1e-6 || direction.iter().any(|c| c.is_nan()) {
            return None;
        }
    }
    None
}

/// The scene of the gallery, without floor and straw.
#[test]
fn the_glass_of_water_bends_light_by_snell() {
    fn check<S: Scalar, T: Tier<S>>() {
        let stage = BuiltIn::Water.build::<S>().unwrap();
        let objects: Vec<_> = stage.objects.iter().copied().filter(|o| (1..4).contains(&o.material)).collect();
        assert_eq!(objects.len(), CYLINDERS.len());
        let case = (objects, stage.materials.to_vec());
        let mut seen = 0;
        let mut random = Random(0x61A5_5000);
        while seen < 40 {
            let from = [4.0 * random.unit() - 2.0, 1.0 + 3.0 * random.unit(), 6.0];
            let to = [1.6 * random.unit() - 0.8, 2.2 * random.unit() + 0.1, 0.0];
            // Near an edge of a cylinder the ball's width does not decide.
            let Some((at, direction)) = path_through_water(from, to) else { continue };
            let shifted = [[1e-2, 0.0], [-1e-2, 0.0], [0.0, 1e-2], [0.0, -1e-2]];
            let is_smooth = shifted.iter().all(|[x, y]| {
                path_through_water(from, [to[0] + x, to[1] + y, to[2]])
                    .is_some_and(|(_, beside)| dot(beside, direction) > 0.98)
            });
            if is_smooth {
                leads_to::<S, T, _>(&case, [from, to], (at, direction), &|ball| ball);
                seen += 1;
            }
        }
    }
    check::<f32, Stable>();
    check::<f64, Stable>();
    check::<I16F16, Stable>();
}

/// A cemented doublet: a lens of two spheres, and one whose front is the back of the first. Both are combinations.
#[test]
fn a_cemented_doublet_bends_light_by_snell() {
    fn check<S: Scalar, T: Tier<S>>() {
        let ball = |y: f64, radius: f64| ball_of::<S>([0.0, y, 0.0], radius, 0).shape;
        // From above: a sphere about y = -3, one about y = 4 that both glasses share, one about y = 5.
        let (front, middle, back) = (ball(-3.0, 4.0), ball(4.0, 4.25), ball(5.0, 6.0));
        let crown = [front, middle];
        let flint = [front, back, middle];
        let crown = Combination::intersection(&crown).unwrap();
        let flint =
            Combination::new(&flint, &[Op::Leaf, Op::Leaf, Op::Intersection, Op::Leaf, Op::Difference]).unwrap();
        let materials = vec![glass::<S>(1.5), glass(1.625)];
        use crate::glass::Surface::Ball;
        let surfaces = [
            (Ball([0.0, -3.0, 0.0], 4.0), 1.5),
            (Ball([0.0, 4.0, 0.0], 4.25), 1.625),
            (Ball([0.0, 5.0, 0.0], 6.0), 1.0),
        ];
        for objects in [
            vec![Object::new(crown.shape(), 0), Object::new(flint.shape(), 1)],
            vec![Object::new(flint.shape(), 1), Object::new(crown.shape(), 0)],
        ] {
            let case: Case<S, Combining<'_>> = (objects, materials.clone());
            for (from, to) in [
                ([0.0, 5.0, 0.0], [0.25, 1.0, 0.0]),
                ([0.5, 6.0, 0.25], [-0.5, 1.0, 0.25]),
                ([-0.75, 4.0, 0.5], [0.5, 0.75, -0.5]),
            ] {
                let lit = path(from, to, 1.0, &surfaces);
                leads_to::<S, T, _>(&case, [from, to], lit, &|ball| ball.beside_combinations());
            }
        }
    }
    check::<f32, Stable>();
    check::<f32, Exact>();
    check::<f64, Fast>();
    check::<I16F16, Stable>();
}

/// A tube of glass: one cylinder less another, or a glass cylinder with one of air after it.
#[test]
fn a_hole_in_glass_is_as_air_in_it() {
    fn check<S: Scalar, T: Tier<S>>(tolerance: f64) {
        let cylinder = |radius: f64, height: f64, base: f64| {
            let solid = Cylinder::capped(number::<S>(radius), number(height)).unwrap();
            Shape::new(solid).placed(Frame::at(point([0.0, base, 0.0])).unwrap())
        };
        let leaves = [cylinder(1.0, 2.0, -1.0), cylinder(0.75, 3.0, -1.5)];
        let drilled = Combination::difference(&leaves).unwrap();
        let materials = vec![glass::<S>(1.5), glass(1.0), Material::matte(Color::BLACK)];
        let walls = [ball_of::<S>([3.0, -4.0, 1.0], 2.0, 2), ball_of([-4.0, 2.0, 2.0], 2.0, 2)];
        let mut cut: Case<S> = (vec![Object::new(leaves[0], 0), Object::new(leaves[1], 1)], materials.clone());
        cut.0.extend(walls);
        let mut combined: Case<S, Combining<'_>> = (vec![Object::new(drilled.shape(), 0)], materials);
        combined.0.extend(walls.map(|wall| Object::new(wall.shape.beside_combinations(), wall.material)));
        let (mut random, mut differing) = (Random(0x7DBE), 0);
        for _ in 0..400 {
            let (from, to) = (random.direction().map(|c| 5.0 * c), random.direction().map(|c| 1.5 * c * random.unit()));
            let (a, b) = (seen::<S, T, _>(&cut, from, to).0, seen::<S, T, _>(&combined, from, to).0);
            differing += usize::from((a - b).abs() > tolerance);
        }
        // Where the air sticks out of the glass its ends count as surfaces of the path, which may end sooner.
        assert!(differing <= 1, "{differing} of 400 rays");
    }
    check::<f32, Stable>(1e-3);
    check::<f64, Stable>(1e-3);
    check::<I16F16, Stable>(1e-2);
    check::<f32, Exact>(1e-3);
}
