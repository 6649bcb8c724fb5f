//! Combinations by name: coincident faces, ties, nesting, constants, scenes, and what is refused.

use crate::crowd::{Crowd, Of};
use crate::random_combinations::holds;
use crate::values::{n, point};
use fixed::types::I16F16;
use raylet::hierarchy::{Hierarchy, Node, ShapeTree, Shapes};
use raylet::shape::combination::Op;
use raylet::shape::kinds::Combining;
use raylet::solids::{Crossings, SolidSet};
use raylet::tier::Precision;
use raylet::{
    Camera, Capsule, Color, Combination, CombinationError, Cone, Crossing, Cuboid, Cylinder, Departure,
    Exact as ExactTier, Frame, Hit, Leaving, Light, Material, Object, Part, Picture, Plane, Range, Ray, Revolved,
    Scene, Shape, Size, Sphere, Tier, UnitVec3, Vec3, Visible, constant,
};
use support::amount::times;
use support::call_in_every_tier;
use support::exact_types::Exact;
use support::random::Random;

fn v<S: Exact>(x: f64, y: f64, z: f64) -> Vec3<S> {
    point([x, y, z])
}

/// Those of the solid alone, without chords that round to a point.
fn apart<S: Exact>(hits: &[Hit<S>]) -> Vec<Hit<S>> {
    let is_lone = |t: S| hits.iter().filter(|hit| hit.t == t).count() == 1;
    hits.iter().filter(|hit| is_lone(hit.t)).copied().collect()
}

fn equal_solids<S: Exact, T: Tier<S>>() {
    let mut random = Random(0x7137_4491_23ef_65cd);
    for _ in 0..times(200) {
        let crowd = Crowd::<S>::random(&mut random, Of::Others);
        for shape in crowd.shapes.iter().filter(|shape| shape.is_solid()) {
            let twice = [*shape; 2];
            let (union, both, none) = (
                Combination::union(&twice).unwrap(),
                Combination::intersection(&twice).unwrap(),
                Combination::difference(&twice).unwrap(),
            );
            for _ in 0..4 {
                let Some(ray) = crowd.ray(&mut random) else { continue };
                let hits = shape.hits_at::<T>(&ray);
                assert!(none.shape().hits_at::<T>(&ray).is_empty() && !none.shape().occludes_at::<T>(&ray));
                assert!(!none.shape().hits_at::<T>(&ray).starts_inside());
                let of_union = union.shape().hits_at::<T>(&ray);
                assert_eq!(apart(&of_union), apart(&hits), "{shape:?} {ray:?}");
                assert_eq!(of_union.starts_inside(), hits.starts_inside());
                // With the first entry it is inside, with the last exit outside.
                let leaf_of = |crossing| u32::from(crossing == Crossing::Exit);
                assert!(union.leaf_hits_at::<T>(&ray).all(|on| on.leaf == leaf_of(on.hit.crossing)));
                let without_touch = |hits: &[Hit<S>]| {
                    apart(hits).into_iter().filter(|hit| hit.crossing != Crossing::Touch).collect::<Vec<_>>()
                };
                assert_eq!(without_touch(&both.shape().hits_at::<T>(&ray)), without_touch(&hits), "{shape:?} {ray:?}");
            }
        }
    }
}

/// The union of a solid with itself is the solid, the intersection too, and the difference is nothing.
#[test]
fn equal_solids_leave_no_sliver() {
    call_in_every_tier!(equal_solids);
}

fn hole_as_deep_as_the_block<S: Exact, T: Tier<S>>() {
    let mut random = Random(0xb5c0_fbcf_ec4d_3b2f);
    let ring = |radius: f64| Shape::new(Cylinder::capped(n::<S>(radius), n(2.0)).unwrap());
    for _ in 0..times(50) {
        let point = |random: &mut Random| v::<S>(random.between(-4.0, 4.0), random.between(-4.0, 4.0), 0.5);
        let unit = |random: &mut Random| UnitVec3::<S>::from_f64(random.direction()).unwrap();
        let frame = Frame::looking(point(&mut random), unit(&mut random), unit(&mut random)).unwrap();
        let leaves = [ring(1.0), ring(0.5)].map(|ring| ring.placed(frame));
        let tube = Combination::difference(&leaves).unwrap();
        for _ in 0..20 {
            // Through both rims of the hole, however they are met.
            let within = |random: &mut Random, y: f64| {
                let (x, z) = (random.between(-0.25, 0.25), random.between(-0.25, 0.25));
                frame.point_to_world(v(x, y, z))
            };
            let (from, to) = (within(&mut random, 3.0), within(&mut random, -1.0));
            let ray = Ray::towards(from, to).unwrap();
            for ray in [ray, Ray::towards(to, from).unwrap(), ray.with_range(Range::line())] {
                let hits = tube.shape().hits_at::<T>(&ray);
                assert!(hits.is_empty() && !hits.starts_inside(), "{ray:?} {hits:?} {leaves:?}");
                assert_eq!(tube.shape().nearest_at::<T>(&ray), None);
            }
        }
    }
}

#[test]
fn a_hole_as_deep_as_the_block_is_open() {
    call_in_every_tier!(hole_as_deep_as_the_block);
}

fn touching_blocks<S: Exact, T: Tier<S>>() {
    let block = Shape::new(Cuboid::new(n::<S>(0.5), n(0.5), n(0.5)).unwrap());
    let leaves = [1.0, 0.0].map(|x| block.placed(Frame::at(v(x, 0.0, 0.0)).unwrap()));
    let (bar, face) = (Combination::union(&leaves).unwrap(), Combination::intersection(&leaves).unwrap());
    let ray = Ray::new(v(-2.0, 0.25, 0.0), UnitVec3::X).unwrap();
    let hits: Vec<_> = bar.leaf_hits_at::<T>(&ray).map(|on| (on.leaf, on.hit.t.to_f64(), on.hit.part)).collect();
    assert_eq!(hits, [(1, 1.5, Part::Left), (0, 3.5, Part::Right)]);
    assert_eq!(face.leaf_hits_at::<T>(&ray).count(), 0);
    // From the shared face too.
    let within = Ray::new(v(0.5, 0.25, 0.0), UnitVec3::X).unwrap();
    let hits = bar.shape().hits_at::<T>(&within);
    assert!(hits.starts_inside() && hits.len() == 1 && hits[0].t.to_f64() == 1.0, "{hits:?}");
    // In the list it is one solid.
    let list = [bar.shape(), block.beside_combinations()];
    let crossings = Crossings::<S, 8>::of(&list, &ray).unwrap();
    let sets: Vec<_> = crossings.iter().map(|c| (c.solid, c.hit.t.to_f64(), c.after)).collect();
    let (none, first) = (SolidSet::EMPTY, SolidSet::EMPTY.with(0));
    assert_eq!(sets, [(0, 1.5, first), (1, 1.5, first.with(1)), (1, 2.5, first), (0, 3.5, none)]);
}

#[test]
fn touching_blocks_are_one() {
    call_in_every_tier!(touching_blocks);
}

fn de_morgan<S: Exact, T: Tier<S>>() {
    let mut random = Random(0xe9b5_dba5_8189_dbbc);
    let mut met = 0;
    for _ in 0..times(300) {
        let crowd = Crowd::<S>::random(&mut random, Of::Others);
        let solids: Vec<_> = crowd.shapes.iter().filter(|shape| shape.is_solid()).copied().collect();
        let [a, b, ..] = solids[..] else { continue };
        let all = Shape::new(Cuboid::new(n::<S>(1000.0), n(1000.0), n(1000.0)).unwrap());
        let (plain, negated) = ([a, b], [all, all, a, all, b]);
        // all - ((all - a) + (all - b))
        let [leaf, less] = [Op::Leaf, Op::Difference];
        let operations = [leaf, leaf, leaf, less, leaf, leaf, less, Op::Union, less];
        let both = Combination::intersection(&plain).unwrap();
        let same = Combination::new(&negated, &operations).unwrap();
        for _ in 0..5 {
            let Some(ray) = crowd.ray(&mut random) else { continue };
            // It does not leave what stands for the world.
            let ray = ray.with_range(Range::new(n(0.0), n(500.0)).unwrap());
            let hits = both.shape().hits_at::<T>(&ray);
            assert_eq!(hits, same.shape().hits_at::<T>(&ray), "{ray:?} {plain:?}");
            met += hits.len();
        }
    }
    assert!(met > 50, "{met}");
}

#[test]
fn de_morgan_holds_of_hits() {
    call_in_every_tier!(de_morgan);
}

macro_rules! ball {
    ($x:literal) => {
        constant!(Sphere::<f32>::const_new(0.75))
            .into_shape()
            .in_frame(constant!(Frame::<f32>::const_at(Vec3::new($x, 0.0, 0.0))))
    };
}

/// Fifteen balls in a row, which overlap, and a block around the middle of them.
static LEAVES: [Shape<f32>; 16] = [
    constant!(Cuboid::<f32>::const_new(6.5, 1.0, 0.5)).into_shape(),
    ball!(-7.0),
    ball!(-6.0),
    ball!(-5.0),
    ball!(-4.0),
    ball!(-3.0),
    ball!(-2.0),
    ball!(-1.0),
    ball!(0.0),
    ball!(1.0),
    ball!(2.0),
    ball!(3.0),
    ball!(4.0),
    ball!(5.0),
    ball!(6.0),
    ball!(7.0),
];
const L: Op = Op::Leaf;
/// The block less every other ball, and the others.
static OPERATIONS: [Op; 31] = {
    let mut operations = [L; 31];
    let mut place = 2;
    while place < 31 {
        operations[place] = if place % 4 == 2 { Op::Difference } else { Op::Union };
        place += 2;
    }
    operations
};
static BEADS: Combination<'_, f32> = constant!(Combination::new(&LEAVES, &OPERATIONS));
static LIST: [Shape<f32, Combining<'_>>; 2] =
    [BEADS.shape(), constant!(Sphere::<f32>::const_new(0.25)).into_shape().beside_combinations()];

#[test]
fn sixteen_leaves_in_flash() {
    assert_eq!(BEADS.leaves().len(), 16);
    assert!(BEADS.operations().eq(OPERATIONS));
    let ray = Ray::new(Vec3::new(-9.0, 0.125, 0.0), UnitVec3::X).unwrap();
    let hits = LIST[0].hits(&ray);
    // Every other ball is cut out of the block, and its neighbours reach into the gap.
    assert_eq!(hits.len(), 14);
    for step in 0..1440 {
        let (x, mut is_in) = (step as f32 / 80.0, false);
        is_in |= hits.iter().filter(|hit| hit.t < x).count() % 2 == 1;
        let point = ray.at(x);
        let expected = holds(&OPERATIONS, |leaf| LEAVES[leaf].contains(point));
        assert_eq!((LIST[0].contains(point), is_in), (expected, expected), "{x} {hits:?}");
    }
    assert_eq!(LIST[1].hits(&ray)[0].t, 9.0 - 0.216_506_36);
}

/// Nested the other way, all operations wait for the last leaf.
#[test]
fn operations_may_all_stand_at_the_end() {
    let mut operations = [L; 31];
    operations[16..].fill(Op::Difference);
    let beads = Combination::new(&LEAVES, &operations).unwrap();
    // a - (b - (c - ..)): the innermost leaf that contains a point decides.
    for x in [-6.75_f32, -6.25, -5.75, 0.0, 0.5, 6.25] {
        let point = Vec3::new(x, 0.0, 0.0);
        let expected = holds(&operations, |leaf| LEAVES[leaf].contains(point));
        assert_eq!(beads.shape().contains(point), expected, "{x}");
    }
    assert_eq!(beads.shape().bounds(), LEAVES[0].bounds());
}

#[test]
fn the_hit_is_that_of_the_crossing_that_decides() {
    let balls = [Shape::new(Sphere::new(1.0_f32).unwrap()); 3];
    let ray = Ray::new(Vec3::new(-3.0, 0.0, 0.0), UnitVec3::X).unwrap();
    let leaves = |combination: Combination<'_, f32>| combination.leaf_hits(&ray).map(|on| on.leaf).collect::<Vec<_>>();
    // With the first entry the ray is in the union, with the last exit out of it.
    assert_eq!(leaves(Combination::union(&balls).unwrap()), [0, 2]);
    assert_eq!(leaves(Combination::intersection(&balls).unwrap()), [2, 0]);
}

#[test]
fn a_touch_is_one_of_the_result() {
    let ball = Shape::new(Sphere::new(1.0_f32).unwrap());
    let block = Shape::new(Cuboid::new(2.0, 2.0, 2.0).unwrap());
    let ray = Ray::new(Vec3::new(-3.0, 1.0, 0.0), UnitVec3::X).unwrap();
    let hits = |combination: Combination<'_, f32>| {
        combination.shape().hits_at::<ExactTier>(&ray).iter().map(|hit| (hit.t, hit.crossing)).collect::<Vec<_>>()
    };
    assert_eq!(hits(Combination::union(&[ball]).unwrap()), [(3.0, Crossing::Touch)]);
    assert_eq!(hits(Combination::intersection(&[ball, block]).unwrap()), [(3.0, Crossing::Touch)]);
    let through = [(1.0, Crossing::Enter), (5.0, Crossing::Exit)];
    assert_eq!(hits(Combination::union(&[ball, block]).unwrap()), through);
    assert_eq!(hits(Combination::difference(&[block, ball]).unwrap()), through);
    assert_eq!(hits(Combination::difference(&[ball, block]).unwrap()), []);
    // Nothing hangs in the air.
    assert_eq!(hits(Combination::difference(&[ball, ball]).unwrap()), []);
}

#[test]
fn boxes_are_those_of_the_operations() {
    let ball = |x: f32| Shape::new(Sphere::new(1.0).unwrap()).placed(Frame::at(Vec3::new(x, 0.0, 0.0)).unwrap());
    let endless = Shape::new(Cylinder::infinite(2.0_f32).unwrap());
    let (near, far) = ([ball(0.0), ball(1.0)], [ball(0.0), ball(5.0)]);
    let along_x = |combination: Combination<'_, f32>| {
        let bounds = combination.shape().bounds();
        [bounds.low.x, bounds.high.x]
    };
    assert_eq!(along_x(Combination::union(&near).unwrap()), [-1.0, 2.0]);
    assert_eq!(along_x(Combination::intersection(&near).unwrap()), [0.0, 1.0]);
    assert_eq!(along_x(Combination::difference(&near).unwrap()), [-1.0, 1.0]);
    // Nothing is in it, and the box holds that.
    let [low, high] = along_x(Combination::intersection(&far).unwrap());
    assert!(low <= high);
    let finite = Combination::intersection(&[endless, ball(0.0)]).unwrap().shape().bounds();
    assert_eq!((finite.low.y, finite.high.y), (-1.0, 1.0));
    assert_eq!(Combination::union(&[endless, ball(0.0)]).unwrap().shape().bounds().high.y, f32::INFINITY);
}

#[test]
fn what_cannot_be_combined_is_refused() {
    let ball = Shape::new(Sphere::new(1.0_f32).unwrap());
    let told = |leaves: &[Shape<f32>], operations: &[Op]| {
        let error: raylet::Error = Combination::new(leaves, operations).unwrap_err().into();
        error.to_string()
    };
    assert_eq!(told(&[], &[]), "a combination has 1 to 16 leaves, and not 0");
    assert_eq!(told(&[ball; 17], &[]), "a combination has 1 to 16 leaves, and not 17");
    let tube = Shape::new(Cylinder::open(1.0, 1.0).unwrap());
    assert_eq!(told(&[ball, tube], &[]), "leaf 1 is a surface without an inside: take a solid");
    assert_eq!(told(&[Shape::new(Plane::new())], &[]), "leaf 0 is a surface without an inside: take a solid");
    let outside = ball.seen_from(Visible::Outside);
    assert_eq!(told(&[outside], &[L]), "leaf 0 is seen from one side only: say that of the combination's shape");
    let double = Shape::new(Cone::double(1.0_f32).unwrap());
    assert_eq!(
        told(&[double; 9], &[]),
        "a line may cross the leaves 36 times, and at most 32 are listed: take fewer leaves"
    );
    assert!(Combination::union(&[double; 8]).is_ok());
    assert_eq!(told(&[ball; 2], &[L, Op::Union]), "operation 1 stands before its two operands");
    assert_eq!(told(&[ball; 2], &[L]), "the operations name 1 leaves, and there are 2: name each once");
    assert_eq!(told(&[ball; 2], &[L, L]), "the operations leave 2 sets: combine them");
    let error = Combination::new(&[ball], &[L, L, Op::Union]).unwrap_err();
    assert_eq!(error, CombinationError::OtherLeaves { named: 2, leaves: 1 });
    assert_eq!(error.message(), "the operations do not name each leaf once");
}

/// What a program without combinations holds is as large as before.
#[test]
fn sizes_are_those_of_what_is_held() {
    fn size<T>() -> usize {
        core::mem::size_of::<T>()
    }
    assert_eq!((size::<Hit<f32>>(), size::<Hit<I16F16>>(), size::<Hit<f64>>()), (8, 8, 16));
    struct Before<S: raylet::Scalar>(raylet::Primitive<S>, raylet::Placement<S>, Visible);
    assert_eq!(size::<Shape<f32>>(), size::<Before<f32>>());
    assert_eq!(size::<Shape<f64>>(), size::<Before<f64>>());
    assert_eq!(size::<Shape<f32, (Sphere<f32>,)>>(), size::<Before<f32>>());
    assert_eq!(
        size::<Shape<f32, Combining<'_>>>(),
        size::<Before<f32>>().next_multiple_of(size::<usize>()) + size::<usize>()
    );
    let Before(_, _, visible) = Before::<f32>(Plane::new().into(), raylet::Placement::World, Visible::Both);
    assert_eq!(visible, Visible::Both);
}

/// A drilled block, a rounded one and a floor, as the camera sees them: each pixel by itself, with a hierarchy and
/// without.
#[test]
fn a_picture_of_combinations_is_that_of_its_pixels() {
    let at = |x: f32, y: f32, z: f32| Frame::at(Vec3::new(x, y, z)).unwrap();
    let drill = Frame::from_centre_and_axis(Vec3::new(-1.25, 1.0, 0.0), UnitVec3::Z, 4.0).unwrap();
    let drilled = [
        Shape::new(Cuboid::new(1.0_f32, 1.0, 1.0).unwrap()).placed(at(-1.25, 1.0, 0.0)),
        Shape::new(Cylinder::capped(0.5, 4.0).unwrap()).placed(drill),
        Shape::new(Capsule::new(0.25, 2.0).unwrap()).placed(at(-1.25, 1.0, 0.75)),
    ];
    let rounded = [
        Shape::new(Cuboid::new(0.75_f32, 0.75, 0.75).unwrap()).placed(at(1.25, 0.75, 0.0)),
        Shape::new(Sphere::new(1.0).unwrap()).placed(at(1.25, 0.75, 0.0)),
    ];
    let (block, die) = (Combination::difference(&drilled).unwrap(), Combination::intersection(&rounded).unwrap());
    let floor = Shape::new(Plane::new());
    let objects: [Object<f32, Combining<'_>>; 3] = [
        Object::new(block.shape(), 0),
        Object::new(floor.beside_combinations(), 1),
        Object::new(die.shape(), 2).with_top(1),
    ];
    let materials = [
        Material::matte(Color::from_f64([0.9, 0.2, 0.2])),
        Material::matte(Color::WHITE).with_mirror(0.25),
        Material::matte(Color::WHITE).with_refraction(0.75, 1.5),
    ];
    let lights = [Light::new(Vec3::new(3.0, 9.0, 6.0), 0.75)];
    let up = Vec3::new(0.0, 1.0, 0.0);
    let camera = Camera::new(Vec3::new(-0.5, 2.5, 6.0), Vec3::new(0.0, 0.75, 0.0), up, 40.0).unwrap();
    let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
    let mut nodes = [Node::EMPTY; Hierarchy::<f32>::nodes_for(3)];
    let hierarchy = Hierarchy::build(&objects, &mut nodes).unwrap();
    let size = Size::new(40, 30);
    let mut pixels = vec![];
    let counted = Picture::new(&scene, size).render(|x, y, pixel| pixels.push((x, y, pixel)));
    let in_a_tree = scene.with_hierarchy(&hierarchy).unwrap();
    let mut again = vec![];
    let counted_again = Picture::new(&in_a_tree, size).render(|x, y, pixel| again.push((x, y, pixel)));
    assert_eq!(pixels, again);
    assert!(counted_again.intersection_tests < counted.intersection_tests, "{counted:?} {counted_again:?}");

    let raster = camera.raster(size);
    let mut met = [0; 5];
    for (x, y, pixel) in pixels {
        let ray = raster.ray([x, y], [0, 0]).unwrap();
        // Of the points on the way that are on the surface of a leaf: the first behind which the ray is inside.
        let first = |leaves: &[Shape<f32>], is_in: &dyn Fn(&[bool]) -> bool| {
            let hits = leaves.iter().flat_map(|leaf| leaf.hits(&ray)).map(|hit| (hit.t, hit.part));
            let mut hits: Vec<_> = hits.collect();
            hits.sort_by(|a, b| a.0.total_cmp(&b.0));
            let next = hits.iter().map(|hit| hit.0).skip(1).chain([1e3]).collect::<Vec<_>>();
            let behind = hits.iter().zip(next).find(|((t, _), next)| {
                let middle = ray.at((t + next) / 2.0);
                is_in(&leaves.iter().map(|leaf| leaf.contains(middle)).collect::<Vec<_>>())
            });
            behind.map(|(hit, _)| *hit)
        };
        let on_block = first(&drilled, &|leaves| leaves == [true, false, false]);
        let on_die = first(&rounded, &|leaves| leaves == [true, true]);
        let on_floor = floor.nearest(&ray).map(|hit| (hit.t, hit.part));
        let all = [(0, on_block), (1, on_floor), (2, on_die)];
        let seen = all.into_iter().filter_map(|(object, on)| Some((on?.0, object, on?.1)));
        let seen = seen.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, object, part)| (object, part));
        assert_eq!(pixel.seen, seen, "{x} {y}");
        met[pixel.seen.map_or(3, |(object, _)| object as usize)] += 1;
        met[4] += usize::from(on_block.is_none() && drilled[0].occludes(&ray));
    }
    // Some see through the hole.
    assert!(met.into_iter().all(|met| met > 3), "{met:?}");
}

/// A list with a hierarchy, and one that owns it, answer as a loop does.
#[test]
fn a_hierarchy_of_combinations_answers_as_a_loop() {
    fn of<S: Exact, T: Tier<S>>() {
        let mut random = Random(0x3956_c25b_f348_b538);
        let mut met = 0;
        for _ in 0..times(100) {
            let crowds: Vec<_> = (0..4).map(|_| Crowd::<S>::random(&mut random, Of::Others)).collect();
            let leaves: Vec<Vec<_>> = crowds
                .iter()
                .map(|crowd| crowd.shapes.iter().filter(|shape| shape.is_solid()).copied().collect())
                .collect();
            let make = [Combination::union, Combination::intersection, Combination::difference, Combination::union];
            let made: Vec<_> = leaves.iter().zip(make).filter_map(|(leaves, make)| make(leaves).ok()).collect();
            let mut list: Vec<_> = made.iter().map(Combination::shape).collect();
            list.extend(crowds[0].shapes.iter().map(|shape| shape.beside_combinations()));
            let mut nodes = vec![Node::EMPTY; Hierarchy::<S>::nodes_for(list.len())];
            let shapes = Shapes::new(&list, &mut nodes).unwrap();
            let tree = ShapeTree::new(heapless::Vec::<_, 16>::from_slice(&list).unwrap()).unwrap();
            for crowd in &crowds {
                for _ in 0..5 {
                    let Some(ray) = crowd.ray(&mut random) else { continue };
                    let mut nearest = None;
                    for (index, shape) in (0_u32..).zip(&list) {
                        if let Some(hit) = shape.nearest_at::<T>(&ray)
                            && nearest.is_none_or(|(_, best): (u32, Hit<S>)| hit.t < best.t)
                        {
                            nearest = Some((index, hit));
                        }
                    }
                    assert_eq!(shapes.nearest_at::<T>(&ray), nearest, "{ray:?} {list:#?}");
                    assert_eq!(tree.nearest_at::<T>(&ray), nearest);
                    assert_eq!(shapes.occludes_at::<T>(&ray), nearest.is_some());
                    let mut count = 0;
                    shapes.hits_at::<T>(&ray, |index, hits| {
                        assert_eq!(hits, list[index as usize].hits_at::<T>(&ray));
                        count += hits.len();
                    });
                    assert_eq!(count, list.iter().map(|shape| shape.hits_at::<T>(&ray).len()).sum::<usize>());
                    met += usize::from(nearest.is_some());
                }
            }
        }
        assert!(met > 300, "{met}");
    }
    call_in_every_tier!(of);
}

#[test]
fn precision_is_that_of_every_leaf() {
    let ball = Shape::new(Sphere::new(1.0_f32).unwrap());
    let leaves = [Shape::new(Cuboid::new(0.5, 0.5, 0.5).unwrap()), ball];
    let both = Combination::union(&leaves).unwrap();
    let touching = Ray::new(Vec3::new(-3.0, 1.0, 0.0), UnitVec3::X).unwrap();
    let through = Ray::new(Vec3::new(-3.0, 0.25, 0.125), UnitVec3::X).unwrap();
    assert_eq!(both.shape().precision(&touching), ball.precision(&touching));
    assert_eq!(both.shape().precision(&through), Precision::Filter);
}

/// A flat cone, a flat frustum or a dish beside the start, whose rim is at its height: the ray does not depart from it.
/// (The point next to the start on its side was taken to be the start itself, so that the ray ended where it began.)
#[test]
fn a_flat_leaf_beside_the_start_is_not_departed_from() {
    let at = |x, y, z| Frame::at(Vec3::new(x, y, z)).unwrap();
    let block = Shape::new(Cuboid::new(1.5_f32, 1.5, 2.0).unwrap()).placed(at(0.0, -1.0, -2.0));
    let ray = Ray::new(Vec3::new(0.5, 0.25, -4.0), UnitVec3::Z).unwrap();
    let ray = ray.departing(Departure { object: 0, part: Part::Back, leaving: Leaving::Inwards });
    let dish = Revolved::paraboloid(0.0625_f32, 0.25).unwrap();
    for flat in [
        Shape::new(Cone::capped(2.0, 0.25).unwrap()),
        Shape::new(Cone::frustum(0.25, 1.0, 0.25).unwrap()),
        Shape::new(dish),
        Shape::new(Revolved::cone(2.0, [0.0, 0.25]).unwrap()),
    ] {
        let flat = flat.placed(at(-2.0, 0.0, -2.0));
        let leaves = [block, flat];
        let combination = Combination::difference(&leaves).unwrap();
        let hits = combination.shape().hits(&ray);
        assert_eq!(hits.iter().map(|hit| (hit.t, hit.part)).collect::<Vec<_>>(), [(4.0, Part::Front)], "{flat:?}");
    }
}
