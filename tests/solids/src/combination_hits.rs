//! Hits of combinations: what the crossings of the leaves and the predicate say, in every tier and number type, and
//! what exact arithmetic says of the points between them.

use crate::crowd::Of;
use crate::random_combinations::{Parts, holds};
use fixed::types::{I16F16, I32F32};
use raylet::{
    Crossing, Exact as ExactTier, Fast, Hit, Hits, Plain, Ray, Shape, Stable, Tier, Visible,
    shape::combination::LeafHit,
};
use support::exact_types::Exact;
use support::oracle::exact_f64;

/// The hits by definition, from those of the leaves in a tier that compares rounded `t`: at each `t` the predicate
/// before and behind it.
fn by_definition<S: Exact, T: Tier<S>>(parts: &Parts<S>, ray: &Ray<S>) -> (bool, Vec<(S, Crossing)>) {
    let lists: Vec<_> = parts.leaves.iter().map(|leaf| leaf.hits_at::<T>(ray)).collect();
    let mut inside: Vec<_> = lists.iter().map(Hits::starts_inside).collect();
    let mut ts: Vec<_> = lists.iter().flatten().map(|hit| hit.t).collect();
    ts.sort_by(|a, b| a.partial_cmp(b).unwrap());
    ts.dedup();
    let starts_inside = holds(&parts.operations, |leaf| inside[leaf]);
    let (mut hits, mut is_in) = (vec![], starts_inside);
    let combination = parts.combination();
    for t in ts {
        let before = inside.clone();
        for (leaf, list) in lists.iter().enumerate() {
            for hit in list.iter().filter(|hit| hit.t == t && hit.crossing != Crossing::Touch) {
                inside[leaf] = hit.crossing == Crossing::Enter;
            }
        }
        let after = holds(&parts.operations, |leaf| inside[leaf]);
        let touches = |leaf: usize| lists[leaf].iter().any(|hit| hit.t == t && hit.crossing == Crossing::Touch);
        // Those are subtracted that make the result smaller.
        let subtracts = |leaf: usize| combination.is_subtracted(leaf as u32);
        let is_in_with = |own: usize, inside: &[bool]| {
            holds(&parts.operations, |leaf| leaf == own || inside[leaf] || touches(leaf) && subtracts(leaf))
        };
        match (is_in, after) {
            (false, true) => hits.push((t, Crossing::Enter)),
            (true, false) => hits.push((t, Crossing::Exit)),
            (false, false)
                if (0..lists.len())
                    .any(|leaf| touches(leaf) && (is_in_with(leaf, &before) || is_in_with(leaf, &inside))) =>
            {
                hits.push((t, Crossing::Touch));
            }
            _ => {}
        }
        is_in = after;
    }
    (starts_inside, hits)
}

/// What a test has met.
#[derive(Debug, Default)]
struct Met {
    hits: usize,
    turned: usize,
    touches: usize,
    inside: usize,
    points: usize,
}

/// All queries of a combination agree, and each hit is one of its leaf.
fn agrees<S: Exact, T: Tier<S>>(parts: &Parts<S>, ray: &Ray<S>, met: &mut Met) -> Vec<Hit<S>> {
    let (combination, told) = (parts.combination(), || parts.told(ray));
    let hits = combination.shape().hits_at::<T>(ray);
    let mut is_in = hits.starts_inside();
    met.inside += usize::from(is_in);
    for hit in &hits {
        match hit.crossing {
            Crossing::Enter => assert!(!is_in, "{}", told()),
            Crossing::Exit => assert!(is_in, "{}", told()),
            Crossing::Touch => {
                met.touches += 1;
                assert!(!is_in, "{}", told());
                continue;
            }
        }
        is_in = !is_in;
    }
    let on_leaves: Vec<_> = combination.leaf_hits_at::<T>(ray).collect();
    assert_eq!(on_leaves.iter().map(|on| on.hit).collect::<Vec<_>>(), hits[..], "{}", told());
    for LeafHit { leaf, hit } in on_leaves {
        let own = parts.leaves[leaf as usize].hits_at::<T>(ray);
        let own = own.iter().find(|own| (own.t, own.part) == (hit.t, hit.part)).unwrap_or_else(|| panic!("{}", told()));
        met.turned += usize::from(own.crossing != hit.crossing);
    }
    for visible in [Visible::Both, Visible::Outside, Visible::Inside] {
        let shape = combination.shape().seen_from(visible);
        let seen = shape.hits_at::<T>(ray);
        assert_eq!(shape.nearest_at::<T>(ray).as_ref(), seen.first(), "{}", told());
        assert_eq!(shape.occludes_at::<T>(ray), !seen.is_empty(), "{}", told());
    }
    met.hits += hits.len();
    hits.to_vec()
}

fn of_definition<S: Exact, T: Tier<S>>(of: Of) {
    let mut met = Met::default();
    Parts::<S>::each(of, 0x1f83_d9ab_fb41_bd6b, 1_000, |parts, ray, _| {
        let hits: Vec<_> = agrees::<S, T>(parts, ray, &mut met).iter().map(|hit| (hit.t, hit.crossing)).collect();
        let (starts_inside, expected) = by_definition::<S, T>(parts, ray);
        assert_eq!(hits, expected, "{}", parts.told(ray));
        let shape = parts.combination();
        assert_eq!(shape.shape().hits_at::<T>(ray).starts_inside(), starts_inside, "{}", parts.told(ray));
    });
    println!("{} {}: {met:?}", S::name(), core::any::type_name::<T>());
    assert!(met.turned * 10 > met.hits && met.touches > 0 && met.inside > 100, "{met:?}");
}

#[test]
fn hits_are_those_of_the_definition_f32() {
    of_definition::<f32, Plain>(Of::Others);
    of_definition::<f32, Fast>(Of::Others);
    of_definition::<f32, Stable>(Of::Others);
    of_definition::<f32, Stable>(Of::All);
    of_definition::<f32, Stable>(Of::Further);
}

#[test]
fn hits_are_those_of_the_definition_f64() {
    of_definition::<f64, Plain>(Of::Others);
    of_definition::<f64, Stable>(Of::Others);
}

#[test]
fn hits_are_those_of_the_definition_fixed() {
    of_definition::<I16F16, Plain>(Of::Others);
    of_definition::<I16F16, Stable>(Of::Others);
    of_definition::<I16F16, Stable>(Of::All);
    of_definition::<I16F16, Stable>(Of::Further);
    of_definition::<I32F32, Fast>(Of::Others);
    of_definition::<I32F32, Stable>(Of::Others);
}

/// Between any two crossings of the leaves that are `gap` apart the ray is inside of the result exactly if exact
/// arithmetic says so of the point in their middle.
fn of_points<S: Exact, T: Tier<S>>(of: Of, gap: f64) {
    let mut met = Met::default();
    Parts::<S>::each(of, 0x9b05_688c_2b3e_6c1f, 1_000, |parts, ray, _| {
        let hits = agrees::<S, T>(parts, ray, &mut met);
        let starts_inside = parts.combination().shape().hits_at::<T>(ray).starts_inside();
        let of_leaf = |leaf: &Shape<S>| leaf.hits_at::<T>(ray).iter().map(|hit| hit.t.to_f64()).collect::<Vec<_>>();
        let mut ts: Vec<_> = parts.leaves.iter().flat_map(of_leaf).chain([0.0]).collect();
        ts.sort_by(f64::total_cmp);
        ts.push(ts[ts.len() - 1] + 1.0);
        for pair in ts.windows(2).filter(|pair| pair[1] - pair[0] > gap) {
            let middle = f64::midpoint(pair[0], pair[1]);
            let Some(expected) = parts.is_in(ray, &exact_f64(middle)) else { continue };
            let before = hits.iter().filter(|hit| hit.crossing != Crossing::Touch && hit.t.to_f64() < middle);
            let is_in = starts_inside ^ (before.count() % 2 == 1);
            assert_eq!(is_in, expected, "at {middle} of {hits:?}\n{}", parts.told(ray));
            met.points += 1;
        }
    });
    println!("{} {}: {met:?}", S::name(), core::any::type_name::<T>());
    assert!(met.points > 5_000, "{met:?}");
}

#[test]
fn between_crossings_membership_is_that_of_exact_arithmetic() {
    of_points::<f32, ExactTier>(Of::Others, 1e-4);
    of_points::<f32, ExactTier>(Of::All, 1e-4);
    of_points::<f32, ExactTier>(Of::Further, 1e-4);
    of_points::<f64, Stable>(Of::All, 1e-6);
    of_points::<f64, Stable>(Of::Further, 1e-6);
    of_points::<I16F16, ExactTier>(Of::Others, 1e-3);
    of_points::<f32, Stable>(Of::Others, 1e-2);
    of_points::<f64, Stable>(Of::Others, 1e-6);
    of_points::<I32F32, Stable>(Of::Others, 1e-6);
}
