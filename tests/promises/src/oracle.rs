//! The oracle is right: checked against definitions and sampled membership.
//!
//! Every random case is drawn from a seeded generator, on a coarse grid, so that degenerate lines are common.

use std::cmp::Ordering;

use crate::oracle_drawn::{Random, number, open_and_capped, solids, triangle};
use crate::oracle_parts::is_on_part;
use support::amount::times;
use support::oracle::{Answer, Approach, ConeExtent, Dyadic, End, Membership, Part, Root, Solid, contains, solve};

/// Parameters to sample: a grid, and a little to either side of everything reported.
pub(crate) fn samples(reported: &[Root]) -> Vec<Dyadic> {
    let mut samples: Vec<Dyadic> = (-96..=96).map(|step| Dyadic::new(step, -3)).collect();
    let little = Dyadic::power_of_two(-40);
    for t in reported {
        let (low, high) = t.enclosure(90);
        samples.extend([&low - &little, low, high.clone(), &high + &little]);
    }
    samples
}

pub(crate) fn ends(answer: &Answer) -> Vec<(Root, Part)> {
    match answer {
        Answer::Spans(spans) => spans
            .iter()
            .flat_map(|span| [&span.enter, &span.exit])
            .flatten()
            .map(|end| (end.t.clone(), end.part))
            .collect(),
        Answer::Crossings(crossings) => crossings.iter().map(|crossing| (crossing.t.clone(), crossing.part)).collect(),
        Answer::Coincident { from, to } => [from, to].into_iter().flatten().map(|t| (t.clone(), Part::Side)).collect(),
    }
}

pub(crate) fn parameters(answer: &Answer) -> Vec<Root> {
    ends(answer).into_iter().map(|(t, _)| t).collect()
}

pub(crate) fn reaches(from: Option<&Root>, to: Option<&Root>, t: &Dyadic) -> bool {
    from.is_none_or(|from| from.cmp_dyadic(t) != Ordering::Greater)
        && to.is_none_or(|to| to.cmp_dyadic(t) != Ordering::Less)
}

#[test]
fn spans_are_the_parameters_of_the_points_that_belong_to_the_solid() {
    let mut random = Random(1);
    let (mut touches, mut pairs, mut coincidences) = (0, 0, 0);
    for _ in 0..times(1200) {
        let line = random.line();
        for solid in solids() {
            let answer = solve(&solid, &line);
            for t in samples(&parameters(&answer)) {
                // The roots of a torus are rounded, unless they have few bits.
                let is_root = || parameters(&answer).iter().any(|end| end.cmp_dyadic(&t) == Ordering::Equal);
                let is_rounded = |point| contains(&solid, &point) != Membership::OnSurface;
                if matches!(solid, Solid::Torus { .. }) && is_root() && is_rounded(line.point_at(&t)) {
                    continue;
                }
                let membership = contains(&solid, &line.point_at(&t));
                let expected = match &answer {
                    Answer::Spans(spans) => spans.iter().any(|span| {
                        let t_of = |end: &Option<End>| end.as_ref().map(|end| end.t.clone());
                        reaches(t_of(&span.enter).as_ref(), t_of(&span.exit).as_ref(), &t)
                    }),
                    Answer::Coincident { from, to } => reaches(from.as_ref(), to.as_ref(), &t),
                    Answer::Crossings(_) => panic!("{solid:?} is a solid"),
                };
                assert_eq!(
                    membership != Membership::Outside,
                    expected,
                    "{solid:?}\n{line:?}\nat {t:?}: {membership:?}, but {answer:?}"
                );
                if membership == Membership::Inside {
                    assert!(parameters(&answer).iter().all(|end| end.cmp_dyadic(&t) != Ordering::Equal));
                    assert!(!matches!(answer, Answer::Coincident { .. }));
                }
            }
            match &answer {
                Answer::Spans(spans) => {
                    touches += spans.iter().filter(|span| span.is_touch()).count();
                    pairs += spans.len();
                    assert!(parameters(&answer).is_sorted());
                    let is_convex =
                        !matches!(&solid, Solid::Cone { extent: ConeExtent::Double, .. } | Solid::Torus { .. });
                    assert!(spans.len() < 2 || !is_convex && spans.len() < 3);
                }
                _ => coincidences += 1,
            }
        }
    }
    // The grid must be coarse enough to bring these about.
    assert!(touches > 50 && pairs > 1000 && coincidences > 5, "{touches} {pairs} {coincidences}");
}

#[test]
fn ends_lie_on_the_part_that_they_name() {
    let mut random = Random(2);
    let mut found = [0; 12];
    for _ in 0..times(1200) {
        let line = random.line();
        let flat = [
            Solid::Plane,
            Solid::Disc { radius: number(2.0) },
            Solid::Rectangle { half: [2.0, 1.0].map(number) },
            triangle([[-2.0, 0.0, -1.0], [2.0, 0.0, -1.0], [0.0, 0.0, 2.0]]),
            triangle([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]),
        ];
        let open = open_and_capped().into_iter().map(|(open, _)| open);
        for solid in solids().into_iter().chain(flat).chain(open) {
            for (t, part) in ends(&solve(&solid, &line)) {
                let index = match part {
                    Part::Side => 0,
                    Part::Base => 1,
                    Part::Top => 2,
                    Part::Left => 3,
                    Part::Right => 4,
                    Part::Back => 5,
                    Part::Front => 6,
                    Part::Inner => unreachable!("no tube is among them"),
                    Part::Facet(number) => 7 + usize::from(number).min(4),
                };
                found[index] += 1;
                assert!(is_on_part(&solid, part, &line, &t), "{solid:?}\n{line:?}\n{part:?} at {t:?}");
            }
        }
    }
    let (others, facets) = found.split_at(7);
    assert!(others.iter().all(|&count| count > 200) && facets.iter().all(|&count| count > 40), "{found:?}");
}

#[test]
fn an_open_side_is_met_where_the_capped_solid_is_met_on_its_side() {
    let mut random = Random(3);
    let mut coincidences = 0;
    for _ in 0..times(3000) {
        let line = random.line();
        for (open, capped) in open_and_capped() {
            let answer = solve(&open, &line);
            let solid = solve(&capped, &line);
            let mut of_side: Vec<Root> =
                ends(&solid).into_iter().filter(|(_, part)| *part == Part::Side).map(|(t, _)| t).collect();
            if let Answer::Coincident { from, to } = &answer {
                coincidences += 1;
                assert_eq!(of_side, [from.clone().unwrap(), to.clone().unwrap()]);
                continue;
            }
            of_side.dedup();
            assert_eq!(parameters(&answer), of_side, "{open:?}\n{line:?}");
        }
    }
    assert!(coincidences > 20, "{coincidences}");
}

/// The region that an open side bounds when it is continued: 1 inside, 0 on it, -1 outside.
pub(crate) fn side_of_continued(open: &Solid, [x, y, z]: &[Dyadic; 3]) -> i8 {
    let from_axis = &x.squared() + &z.squared();
    let (weight, reach) = match open {
        Solid::Cylinder { radius, .. } => (Dyadic::from(1), radius.clone()),
        Solid::Cone { slope, .. } => (Dyadic::from(1), slope * y),
        Solid::Frustum { base_radius, top_radius, height, .. } => {
            (height.clone(), &(base_radius * &(height - y)) + &(top_radius * y))
        }
        _ => panic!("{open:?} is not an open side"),
    };
    if reach.signum() < 0 {
        return -1;
    }
    (&reach.squared() - &(&weight.squared() * &from_axis)).signum()
}

#[test]
fn crossings_go_the_way_they_say() {
    let mut random = Random(4);
    let mut found = [0; 3];
    let little = Dyadic::power_of_two(-40);
    for _ in 0..times(2000) {
        let line = random.line();
        for (open, _) in open_and_capped() {
            let Answer::Crossings(crossings) = solve(&open, &line) else {
                continue;
            };
            for crossing in crossings {
                let (low, high) = crossing.t.enclosure(90);
                let before = side_of_continued(&open, &line.point_at(&(&low - &little)));
                let after = side_of_continued(&open, &line.point_at(&(&high + &little)));
                let expected = match crossing.side {
                    Approach::FromOutside => (-1, 1),
                    Approach::FromInside => (1, -1),
                    Approach::Touch => (-1, -1),
                };
                found[crossing.side as usize] += 1;
                assert_eq!((before, after), expected, "{open:?}\n{line:?}\n{crossing:?}");
            }
        }
    }
    assert!(found.iter().all(|&count| count > 100), "{found:?}");
}

#[test]
fn flat_surfaces_are_met_where_their_points_are() {
    let surfaces = [
        (Solid::Plane, [0.0, 1.0, 0.0]),
        (Solid::Disc { radius: number(2.0) }, [0.0, 1.0, 0.0]),
        (Solid::Rectangle { half: [2.0, 1.0].map(number) }, [0.0, 1.0, 0.0]),
        (triangle([[-2.0, 0.0, -1.0], [2.0, 0.0, -1.0], [0.0, 0.0, 2.0]]), [0.0, -1.0, 0.0]),
        (triangle([[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]), [1.0, 1.0, 1.0]),
    ];
    let mut random = Random(5);
    let (mut crossings, mut coincidences) = (0, 0);
    for _ in 0..times(20_000) {
        let line = random.line();
        for (surface, facing) in &surfaces {
            let facing = facing.map(number);
            let along: Dyadic =
                (0..3).map(|axis| &facing[axis] * &line.direction[axis]).reduce(|sum, next| &sum + &next).unwrap();
            let answer = solve(surface, &line);
            match &answer {
                Answer::Crossings(found) => {
                    crossings += found.len();
                    for crossing in found {
                        let expected = if along.signum() < 0 { Approach::FromOutside } else { Approach::FromInside };
                        assert_eq!(crossing.side, expected);
                        assert_ne!(along.signum(), 0);
                    }
                }
                Answer::Coincident { .. } => coincidences += 1,
                Answer::Spans(_) => panic!("{surface:?} encloses nothing"),
            }
            // A crossing on the grid of samples is a point of the surface, and no other sample is.
            for step in -12..=12 {
                let t = Dyadic::new(step, -2);
                let reported = match &answer {
                    Answer::Coincident { from, to } => reaches(from.as_ref(), to.as_ref(), &t),
                    _ => parameters(&answer).iter().any(|at| at.cmp_dyadic(&t) == Ordering::Equal),
                };
                let belongs = contains(surface, &line.point_at(&t)) == Membership::OnSurface;
                assert_eq!(belongs, reported, "{surface:?}\n{line:?}\nat {t:?}: {answer:?}");
            }
        }
    }
    assert!(crossings > 5000 && coincidences > 500, "{crossings} {coincidences}");
}
