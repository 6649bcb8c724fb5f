//! Rays at solids that are drawn at random, small multiples of a half among their numbers: beside exact arithmetic, in
//! frames too, and with the rays that depart from each hit.

use raylet::scalar::Real;
use raylet::{Crossing, Departure, Frame, Hits, Leaving, Ray, Shape, Tier};
use support::amount::times;
use support::cases::{Verdict, compare_answers, direction, v};
use support::exact_types::{Exact as Number, exact_line, expected_of};
use support::oracle::{InRange, Solid};
use support::placed::{Placed, Placement};
use support::random::Random;

/// A ray from beside a solid or from farther away, through small multiples of a half or any points.
pub fn line(random: &mut Random) -> ([f64; 3], [f64; 3]) {
    if random.next() & 1 == 0 {
        let origin = [(); 3].map(|()| (random.between(-3.0, 3.0) * 2.0).round() / 2.0);
        let along = [(); 3].map(|()| random.pick(&[0.0, 0.0, 1.0, -1.0, 0.6, -0.8]));
        return (origin, if along == [0.0; 3] { [0.0, 1.0, 0.0] } else { along });
    }
    let far = random.pick(&[1.0, 3.0, 3.0, 50.0]);
    let (origin, at) = (random.direction().map(|c| c * far), [(); 3].map(|()| random.between(-1.5, 1.5)));
    (origin, [0, 1, 2].map(|i| at[i] - origin[i]))
}

fn assert_exact<S: Number>(hits: &Hits<S>, exact: &InRange, what: &dyn std::fmt::Debug) {
    match compare_answers(hits, exact) {
        Verdict::Same(error) => assert!(error <= 1.0, "{error} units: {what:?}"),
        other => panic!("{other:?}: {what:?}"),
    }
}

/// Every hit of random rays, and of the rays that leave from there to both sides. How many rays have how many hits.
pub fn is_exact<S: Number, T: Tier<S>>(draw: impl Fn(&mut Random) -> Option<(Shape<S>, Solid)>) -> [usize; 5] {
    let (mut random, mut hits_of) = (Random(0x9e37), [0; 5]);
    for _ in 0..times(25_000) {
        let Some((shape, solid)) = draw(&mut random) else { continue };
        let frame = Frame::looking(v(random.direction()), random.unit_vector(), random.unit_vector());
        let is_placed = random.next() & 1 == 0;
        let placed = frame.ok().map(Placement::Frame).filter(|_| is_placed);
        let placed = placed.and_then(|placement| Placed::by(&shape, &solid, placement).ok());
        for _ in 0..4 {
            let line = line(&mut random);
            let ray = match &placed {
                Some(placed) => placed.ray_along(line),
                None => Ray::new(v(line.0), direction(line.1)).ok(),
            };
            let Some(ray) = ray else { continue };
            let shape = placed.as_ref().map_or(shape, |placed| placed.shape);
            let expected = |ray: &Ray<S>| {
                let line = match &placed {
                    Some(placed) => placed.line(ray),
                    None => exact_line(ray),
                };
                expected_of(&solid, &line, ray)
            };
            let hits = shape.hits_at::<T>(&ray);
            assert_exact(&hits, &expected(&ray), &(shape, ray));
            hits_of[hits.len()] += 1;
            for hit in &hits {
                for leaving in [Leaving::Outwards, Leaving::Inwards] {
                    let along = if random.next() & 1 == 0 { ray.direction() } else { random.unit_vector() };
                    let departure = Departure { object: 0, part: hit.part, leaving };
                    let Ok(away) = Ray::new(ray.at(hit.t), along) else { continue };
                    let away = away.departing(departure);
                    assert_exact(&shape.hits_at::<T>(&away), &expected(&away), &(shape, away));
                }
            }
        }
    }
    println!("{}: rays by their hits {hits_of:?}", S::name());
    assert!(hits_of.iter().zip([5000, 500, 2000]).all(|(of, least)| *of >= least), "{hits_of:?}");
    hits_of
}

/// In every tier a ray that leaves a solid outwards meets nothing or enters it again ahead, and one that leaves inwards
/// has an exit, and after that whole intervals.
pub fn departures_pair_up<S: Number, T: Tier<S>>(draw: impl Fn(&mut Random) -> Option<(Shape<S>, Solid)>) {
    let mut random = Random(0x1eaf);
    for _ in 0..times(4_000) {
        let Some((shape, _)) = draw(&mut random) else { continue };
        let (origin, along) = line(&mut random);
        let Ok(ray) = Ray::new(v(origin), direction(along)) else { continue };
        for hit in shape.hits_at::<T>(&ray).iter().filter(|_| shape.is_solid()) {
            let surface = shape.surface(&ray, hit);
            for leaving in [Leaving::Outwards, Leaving::Inwards] {
                let along = random.unit_vector();
                let is_outwards = !along.dot(surface.normal()).is_negative();
                let along = if is_outwards == (leaving == Leaving::Outwards) { along } else { -along };
                let away = Ray::new(surface.point(), along).expect("near").departing(surface.departure(0, leaving));
                let met = shape.hits_at::<T>(&away);
                let crossings: Vec<_> = met.iter().map(|hit| hit.crossing).collect();
                let pairs = match leaving {
                    Leaving::Outwards => &crossings[..],
                    Leaving::Inwards => {
                        assert_eq!(crossings.first(), Some(&Crossing::Exit), "{shape:?} {away:?}: {met:?}");
                        &crossings[1..]
                    }
                };
                let are_pairs = matches!(pairs, [] | [Crossing::Touch] | [Crossing::Enter, Crossing::Exit]);
                assert!(are_pairs, "{shape:?} {away:?}: {met:?}");
                assert_eq!(met.starts_inside(), leaving == Leaving::Inwards, "{shape:?} {away:?}: {met:?}");
                assert_eq!(shape.nearest_at::<T>(&away), met.first().copied(), "{shape:?} {away:?}");
                assert_eq!(shape.occludes_at::<T>(&away), !met.is_empty(), "{shape:?} {away:?}");
            }
        }
    }
}
