//! The promise of `Plain` and `Fast`: of a plain ray no hit is lost or invented, wherever the solid is placed.
//!
//! A ray is plain if its chord is at least a hundredth of the solid's size, or, where it has none, if it does not graze
//! (`support::promise`). It starts within 10 sizes for `Plain`, and within 100 for `Fast`. The rays here have chords of
//! any length from a little less than a hundredth on, at any angle to axes, generators and planes, and some pass the
//! solid, by a hundredth or more.
//!
//! The hits of each ray are compared with those of a finer tier. Where they are others, exact arithmetic says which are
//! right: it would take too long for all rays.

use fixed::types::{I8F24, I16F16, I20F12, I32F32};
use raylet::tier::{Exact, Fast, Plain, Stable};
use raylet::{Hits, Ray, Shape};
use std::fmt::Write;
use support::amount::amount;
use support::exact_types::Exact as Number;
use support::measure::measure_one;
use support::method::{Method, Target, Told};
use support::placed::{PLACINGS, Placed, Placing};
use support::random::{Random, add, normalize, scale};
use support::subject::{SUBJECTS, Subject};
use support::workload::{Line, Workload};

/// Rays at each solid, in each placement, number type and tier: in the long form more than ten million chords in all.
fn rays() -> usize {
    amount(2_000, 40_000)
}

/// A placement is made anew for so many rays.
const RAYS_A_PLACEMENT: usize = 8;

/// The hits of a tier that is finer than those tested.
type Finer<S> = fn(&Shape<S>, &Ray<S>) -> Hits<S>;

/// A tier, and how many sizes away its rays may start.
type Tested<S> = (Method<S>, f64);

fn power_of_ten(random: &mut Random, low: f64, high: f64) -> f64 {
    libm::pow(10.0, random.between(low, high))
}

/// A direction at a point of the surface: its sine is that of half a chord at a ball.
fn through(random: &mut Random, normal: [f64; 3]) -> [f64; 3] {
    let sine = power_of_ten(random, -2.5, 0.0);
    let along = scale(random.perpendicular(normal), (1.0 - sine * sine).sqrt());
    add(along, scale(normal, random.sign() * sine))
}

/// A line at the solid in its own frame, its origin up to so many sizes away; `None` for a kind that the solid does not
/// have.
fn line<S: Number>(subject: &Subject<S>, sizes: f64, random: &mut Random) -> Option<Line> {
    let (mut target, mut direction) = (subject.inner_point(random), random.direction());
    match random.below(8) {
        // Into the curved side or out of it.
        0..3 => {
            let (point, normal) = subject.side_point(random);
            (target, direction) = (point, through(random, normal));
        }
        // Through a cap.
        3 => {
            let (point, normal) = subject.flat_point(random)?;
            (target, direction) = (point, through(random, normal));
        }
        // Past the side.
        4 => {
            let (point, normal) = subject.side_point(random);
            target = add(point, scale(normal, power_of_ten(random, -2.0, 0.0)));
            direction = random.perpendicular(normal);
        }
        // Past a rim.
        5 => target = add(subject.rim_point(random), scale(random.direction(), power_of_ten(random, -6.0, -1.0))),
        // Nearly along the axis, a generator or a plane.
        6 => {
            let off = scale(random.direction(), power_of_ten(random, -7.0, -1.0));
            let angle = random.between(0.0, std::f64::consts::TAU);
            let slope = if subject.is_cone() { random.pick(&[0.0, subject.slope()]) } else { 0.0 };
            let straight = if subject.is_flat() {
                [libm::cos(angle), 0.0, libm::sin(angle)]
            } else {
                [libm::cos(angle) * slope, random.sign(), libm::sin(angle) * slope]
            };
            direction = normalize(add(straight, off));
        }
        // Anyhow, some with a component of zero.
        _ => {
            let axis = random.below(6);
            if axis < 3 {
                direction[axis] = 0.0;
                direction = normalize(direction);
            }
        }
    }
    // Some start on the surface or inside.
    let distance = if random.below(16) == 0 { 0.0 } else { power_of_ten(random, -1.0, sizes.log10()) };
    Some(Workload::aimed(target, direction, distance))
}

/// Whether two answers have the same hits, whatever their `t`.
fn are_alike<S: Number>(told: &[Told<S>], finer: &Hits<S>) -> bool {
    let seen = finer.iter().map(|hit| Some((hit.part, hit.crossing)));
    told.len() == finer.len() && told.iter().map(|hit| hit.surface).eq(seen)
}

/// Whether the ray has a long chord ahead, and starts so near.
fn has_chord<S: Number>(hits: &Hits<S>, size: f64, sizes: f64) -> bool {
    let t: Vec<_> = hits.iter().map(|hit| hit.t.to_f64()).collect();
    t.first().is_some_and(|first| *first <= sizes * size) && t.windows(2).any(|pair| pair[1] - pair[0] >= 1e-2 * size)
}

/// What was seen of the rays of a row.
#[derive(Default)]
struct Seen {
    rays: usize,
    /// Those with a long chord.
    chords: usize,
    /// Those whose hits are others than the finer tier's, promised or not.
    differing: usize,
    /// Those that break the promise, and the first of them by their bits.
    broken: usize,
    told: String,
}

/// So many rays are told of a row.
const TOLD: usize = 3;

/// One solid in one placement, in one tier.
fn row<S: Number>(
    (method, sizes): &Tested<S>,
    finer: Finer<S>,
    subject: &Subject<S>,
    placing: Option<Placing>,
    seed: u64,
) -> Seen {
    let (mut random, mut seen) = (Random(seed), Seen::default());
    let mut placed: Option<Placed<S>> = None;
    for round in 0..rays() {
        if let Some(placing) = placing
            && round % RAYS_A_PLACEMENT == 0
        {
            placed = Placed::new(subject, placing, &mut random);
        }
        let Some(line) = line(subject, *sizes, &mut random) else { continue };
        let ray = match &placed {
            Some(placed) => placed.ray_along(line),
            None if placing.is_none() => Workload::rounded(line),
            None => None,
        };
        let Some(ray) = ray else { continue };
        let target = Target::of(subject, placed.as_ref());
        let (told, finer) = ((method.hits)(&target, &ray), finer(target.shape, &ray));
        seen.rays += 1;
        seen.chords += usize::from(has_chord(&finer, placed.as_ref().map_or(1.0, |placed| placed.largest), *sizes));
        if are_alike(&told, &finer) {
            continue;
        }
        seen.differing += 1;
        if let (_, Some(broken)) = measure_one(method, &target, &ray) {
            seen.broken += 1;
            if seen.broken <= TOLD {
                seen.told = format!("{}\n    {}", seen.told, broken.told);
            }
        }
    }
    seen
}

/// All solids in all placements.
fn no_hit_is_lost_or_invented<S: Number>(finer: Finer<S>) {
    let tested: [Tested<S>; 2] = [(Method::tier::<Plain>("Plain"), 10.0), (Method::tier::<Fast>("Fast"), 100.0)];
    let places = [None].into_iter().chain(PLACINGS[..3].iter().copied().map(Some));
    let mut broken = String::new();
    for (tested, from) in tested.iter().zip([40, 136]) {
        let tier = tested.0.tier;
        let mut all = Seen::default();
        for (name, seed) in SUBJECTS.into_iter().zip((from..).step_by(4)) {
            let subject = Subject::<S>::new(name);
            for (placing, seed) in places.clone().zip(seed + 1..) {
                let seen = row(tested, finer, &subject, placing, seed);
                if seen.broken > 0 {
                    let placed = placing.map_or("in the world".into(), Placing::name);
                    writeln!(broken, "{tier} {name}, {placed}: {} of {} rays:{}", seen.broken, seen.rays, seen.told)
                        .expect("a text grows");
                }
                all.rays += seen.rays;
                all.chords += seen.chords;
                all.differing += seen.differing;
            }
        }
        let Seen { rays, chords, differing, .. } = all;
        println!(
            "{tier} {}: {chords} of {rays} rays have a long chord; {differing} differ from a finer tier",
            S::name()
        );
        assert!(chords * 4 > rays && rays > self::rays() * SUBJECTS.len(), "{tier} {}: {chords} of {rays}", S::name());
    }
    assert!(broken.is_empty(), "hits of {} are lost or invented:\n{broken}", S::name());
}

#[test]
fn no_hit_of_a_plain_ray_is_lost_or_invented_in_f32() {
    no_hit_is_lost_or_invented::<f32>(Shape::hits_at::<Exact>);
}

#[test]
fn no_hit_of_a_plain_ray_is_lost_or_invented_in_f64() {
    no_hit_is_lost_or_invented::<f64>(Shape::hits_at::<Stable>);
}

#[test]
fn no_hit_of_a_plain_ray_is_lost_or_invented_in_i16f16() {
    no_hit_is_lost_or_invented::<I16F16>(Shape::hits_at::<Exact>);
}

#[test]
fn no_hit_of_a_plain_ray_is_lost_or_invented_in_i32f32() {
    no_hit_is_lost_or_invented::<I32F32>(Shape::hits_at::<Stable>);
}

#[test]
fn no_hit_of_a_plain_ray_is_lost_or_invented_in_i8f24() {
    no_hit_is_lost_or_invented::<I8F24>(Shape::hits_at::<Exact>);
}

#[test]
fn no_hit_of_a_plain_ray_is_lost_or_invented_in_i20f12() {
    no_hit_is_lost_or_invented::<I20F12>(Shape::hits_at::<Exact>);
}
