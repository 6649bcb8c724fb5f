//! The promise: spans see what the exact rays of the picture's grid see, but for what the rounding of rays explains.
//!
//! The reference is no ray of the library: it is the direction `f + x p r + y p u` of the axes and of the pitch as they
//! are stored, of any length, in exact arithmetic.

use fixed::types::I16F16;
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{Camera, Color, Frame, Material, Object, Part, Picture, Scene, Size, UnitVec3, Vec3};
use support::amount::amount;
use support::described::{ConeExtent, CylinderExtent, Described};
use support::exact_types::{Exact as ExactNumber, oracle_part};
use support::oracle::{self, Dyadic, Root, Solid};
use support::placed::{Placed, Placement};
use support::random::Random;

fn number<S: ExactNumber>(value: f64) -> S {
    S::from_f64(value).unwrap()
}

fn point<S: ExactNumber>(v: [f64; 3]) -> Vec3<S> {
    Vec3::from_f64(v).unwrap()
}

/// A convex solid or a flat surface.
fn described<S: ExactNumber>(random: &mut Random) -> Described<S> {
    let size = random.between(0.2, 1.2);
    let [large, middle, small] = [1.0, 0.6, 0.3].map(|share| number::<S>(share * size));
    match random.below(8) {
        0..2 => Described::Sphere { radius: large },
        2 => Described::Cylinder { radius: middle, extent: CylinderExtent::Capped(large) },
        3 => Described::Cone { slope: number(0.6), extent: ConeExtent::Capped(large) },
        4 => Described::Frustum { base: large, top: small, height: middle, capped: true },
        5 => Described::Cuboid { half: [small, large, middle] },
        6 => Described::Disc { radius: large },
        _ => Described::Rectangle { half: [large, small] },
    }
}

/// A floor, and solids that stand on it or are turned anyhow.
fn placed<S: ExactNumber>(random: &mut Random) -> Vec<(Placed<S>, Solid)> {
    let floor = point([0.0, -1.5, 0.0]);
    let plane = Described::<S>::Plane;
    let by = |described: &Described<S>, frame: Frame<S>| {
        let solid = described.solid();
        (Placed::by(&described.shape().unwrap(), &solid, Placement::Frame(frame)).unwrap(), solid)
    };
    let mut placed = vec![by(&plane, Frame::at(floor).unwrap())];
    for _ in 0..=random.below(4) {
        let [x, y, z] = [0; 3].map(|_| random.between(-1.5, 1.5));
        let axis = UnitVec3::new(point(random.direction())).unwrap();
        let frame = match random.below(2) {
            0 => Frame::at(point([x, -1.5, z])).unwrap(),
            _ => Frame::from_base_and_axis(point([x, y, z]), axis).unwrap(),
        };
        placed.push(by(&described(random), frame));
    }
    placed
}

/// The rows of a picture, so that its pitch is a power of two of the tangent.
const SIZE: Size = Size::new(48, 33);

/// The direction of the exact ray of a pixel.
fn exact_direction<S: ExactNumber>(frame: &Frame<S>, tangent: S, [x, y]: [i64; 2]) -> [Dyadic; 3] {
    let [right, up, forward] = frame.axes().map(|axis| axis.to_array().map(S::exact_unit));
    let (width, height) = (i64::from(SIZE.width), i64::from(SIZE.height));
    // The frame's x axis points to the left. Times the intervals between the rows, so that no quotient is left.
    let steps = [-(2 * x + 1 - width), height - 1 - 2 * y].map(|step| &Dyadic::from(step) * &tangent.exact());
    let intervals = Dyadic::from(height - 1);
    [0, 1, 2].map(|i| &(&(&right[i] * &steps[0]) + &(&up[i] * &steps[1])) + &(&forward[i] * &intervals))
}

/// The first hit of an exact ray: the object and the part, and whether another hit is at the same `t`.
fn exact_first<S: ExactNumber>(
    placed: &[(Placed<S>, Solid)],
    eye: &[Dyadic; 3],
    direction: &[Dyadic; 3],
) -> Option<(u32, oracle::Part, bool)> {
    let mut first: Option<(Root, u32, oracle::Part, bool)> = None;
    for (index, (placed, solid)) in (0..).zip(placed) {
        let answer = oracle::solve(solid, &placed.line_along(eye, direction));
        let hits = oracle::hits_in_range(&answer, &Dyadic::from(0), None);
        if let Some(hit) = hits.hits.into_iter().next() {
            let order = first.as_ref().map(|(t, ..)| hit.t.cmp(t));
            match order {
                Some(core::cmp::Ordering::Greater) => {}
                Some(core::cmp::Ordering::Equal) => first = first.map(|(t, index, part, _)| (t, index, part, true)),
                _ => first = Some((hit.t, index, hit.part, false)),
            }
        }
    }
    first.map(|(_, index, part, is_shared)| (index, part, is_shared))
}

/// Returns the pixels, those that see something else than their exact ray, and those of them whose neighbours' exact
/// rays see the same as theirs: those are no rounding.
fn check<S: ExactNumber, T: Tier<S>>(seed: u64) -> [usize; 3] {
    let (mut random, mut counts, mut rays) = (Random(seed), [0; 3], 0);
    for _ in 0..amount(20, 1_000) {
        let placed = placed::<S>(&mut random);
        let eye = point(random.direction().map(|c| c * random.between(3.0, 6.0)));
        let Ok(facing) = UnitVec3::new(-eye) else { continue };
        let Ok(frame) = Frame::looking(eye, facing, UnitVec3::Y) else { continue };
        let tangent = number(random.between(0.2, 0.6));
        let camera = Camera::in_frame(frame, tangent).unwrap();
        let objects: Vec<_> = placed.iter().map(|(placed, _)| Object::new(placed.shape, 0)).collect();
        let materials = [Material::matte(Color::WHITE)];
        let scene = Scene::new(&objects, &materials, &[], camera).unwrap().at_tier::<T>();
        let mut seen = vec![];
        let picture = Picture::<S, (), T>::leaving_out(&scene, SIZE);
        rays += picture.in_spans().render(|_, _, pixel| seen.push(pixel.seen)).primary_rays;
        let eye = eye.to_array().map(S::exact);
        let exact = |x: i64, y: i64| exact_first(&placed, &eye, &exact_direction(&frame, tangent, [x, y]));
        for (index, seen) in (0..).zip(&seen) {
            let (x, y) = (index % i64::from(SIZE.width), index / i64::from(SIZE.width));
            let expected = exact(x, y);
            counts[0] += 1;
            let is_same = |part: Part, exact: oracle::Part| oracle_part(part) == exact;
            let agrees = match (seen, expected) {
                (None, None) => true,
                (Some((object, part)), Some((index, exact, shared))) => {
                    shared || *object == index && is_same(*part, exact)
                }
                _ => false,
            };
            if !agrees {
                counts[1] += 1;
                let around = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)];
                counts[2] += usize::from(around.into_iter().all(|(x, y)| exact(x, y) == expected));
            }
        }
    }
    println!("{} {}: {counts:?}, {rays} rays", S::name(), std::any::type_name::<T>());
    assert!(2 * rays < counts[0] as u64, "{rays} rays for {} pixels", counts[0]);
    counts
}

#[test]
fn spans_see_what_the_exact_rays_of_the_grid_see() {
    for [pixels, other, inside] in [
        check::<f32, Plain>(1),
        check::<f32, Stable>(2),
        check::<f32, Exact>(3),
        check::<f64, Stable>(4),
        check::<I16F16, Fast>(5),
        check::<I16F16, Stable>(6),
        check::<I16F16, Exact>(7),
    ] {
        assert!(inside == 0 && other * 5_000 <= pixels, "{other} of {pixels} differ, {inside} of them inside");
    }
}
