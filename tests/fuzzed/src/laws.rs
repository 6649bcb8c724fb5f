//! What must hold for every solid and ray, in every number type and tier, whatever the rounding.

use crate::agreement::Agreement;
use crate::bytes::Number;
use crate::known;
use crate::query::Query;
use raylet::scalar::UnitScalar;
use raylet::{Crossing, Hit, Hits, Leaving, Placement, Range, Ray, Scalar, Shape, Tier, UnitVec3, Vec3, Visible};
use support::cases::Kind;
use support::oracle::Solid;

/// Fails with the case in words.
macro_rules! law {
    ($holds:expr, $query:expr, $($words:tt)+) => {
        assert!($holds, "{}: {:#?}", format_args!($($words)+), $query)
    };
}

/// Calls everything in one tier, and checks each answer against the others.
pub fn hold<S: Number, T: Tier<S>>(query: &Query<S>) {
    let (shape, ray) = (&query.shape, &query.ray);
    let hits = listed::<S, T>(query, shape, ray);
    // The same line without the ray's range, and from both sides.
    let line = ray.with_range(Range::line());
    let whole = listed::<S, T>(query, &shape.seen_from(Visible::Both), &line);
    // A tier that is exact knows on which side of the range's end a hit lies that is rounded onto it.
    let (start, end) = (ray.range().start(), ray.range().end());
    let is_decided = |hit: &&Hit<S>| !query.promises(Agreement::Total) || (hit.t != start && hit.t != end);
    let is_kept = |hit: &&Hit<S>| ray.range().contains(hit.t) && is_seen(shape.visible(), hit.crossing);
    let kept = whole.iter().filter(is_kept).filter(is_decided);
    let cut = hits.iter().filter(is_decided).eq(kept);
    law!(cut, query, "the range or the side changes more than it drops: {hits:?} of {whole:?}");
    // A ray that departs from where it never was is answered, but nothing is promised of the answer.
    let is_honest = ray.departure().is_none() && !query.squares_vanish() && !known::has_a_vanishing_slope(query);
    if is_honest {
        pairs_up(query, &whole);
        if whole.iter().all(|hit| is_decided(&hit)) {
            starts_inside_as_the_crossings_say(query, &hits, &whole);
        }
    }
    for hit in &hits {
        surface_is_sound(query, hit, is_honest);
        leaves_without_epsilon::<S, T>(query, hit, is_honest);
    }
    let bounds = shape.bounds();
    let (low, high) = (bounds.low.to_array(), bounds.high.to_array());
    law!((0..3).all(|i| low[i] <= high[i]), query, "a box that is none: {bounds:?}");
    // Nothing to compare with in a rounded point: that it answers is enough.
    let _ = shape.contains(ray.origin());
}

fn is_seen(visible: Visible, crossing: Crossing) -> bool {
    match visible {
        Visible::Both => true,
        Visible::Outside => crossing != Crossing::Exit,
        Visible::Inside => crossing != Crossing::Enter,
    }
}

/// Sorted, in range, and the same for all three queries.
fn listed<S: Number, T: Tier<S>>(query: &Query<S>, shape: &Shape<S>, ray: &Ray<S>) -> Hits<S> {
    let hits = shape.hits_at::<T>(ray);
    law!(hits.len() <= raylet::hit::MOST_HITS, query, "too many: {hits:?}");
    law!(hits.windows(2).all(|pair| pair[0].t <= pair[1].t), query, "unsorted or NaN: {hits:?} on {ray:?}");
    law!(
        hits.iter().all(|hit| hit.t.is_finite() && ray.range().contains(hit.t)),
        query,
        "out of range: {hits:?} on {ray:?}"
    );
    if let Some(overlap) = hits.coincident() {
        let range = ray.range();
        let within = range.start() <= overlap.start() && overlap.end() <= range.end();
        law!(within && overlap.start() <= overlap.end(), query, "an overlap that is none: {hits:?} on {ray:?}");
        law!(hits.is_empty() && !hits.starts_inside(), query, "coincident, and crossing too: {hits:?} on {ray:?}");
        let is_closed = matches!(query.kind, Kind::Bounded | Kind::NotConvex);
        law!(!is_closed, query, "nothing lies in the surface of a closed solid: {hits:?}");
    }
    let nearest = shape.nearest_at::<T>(ray);
    law!(nearest == hits.first().copied(), query, "nearest is {nearest:?}, of {hits:?} on {ray:?}");
    // Where squares vanish a small solid is a point for the solver, and the signs know better.
    let excused = query.squares_vanish() || known::has_a_vanishing_slope(query);
    if !excused {
        let occludes = shape.occludes_at::<T>(ray);
        law!(occludes != hits.is_empty(), query, "occludes is {occludes}, of {hits:?} on {ray:?}");
    }
    hits
}

/// Rules 1 and 2: the crossings of a whole line. An end that the type does not hold may be missing.
fn pairs_up<S: Number>(query: &Query<S>, whole: &Hits<S>) {
    use Crossing::{Enter, Exit, Touch};
    let crossings: Vec<Crossing> = whole.iter().map(|hit| hit.crossing).collect();
    let as_should_be = match (query.kind, &crossings[..]) {
        (_, [] | [Touch] | [Enter, Exit]) => true,
        (Kind::Bounded, [Enter | Exit]) => query.may_leave_the_type(&query.ray),
        (_, [Enter | Exit]) => true,
        (Kind::NotConvex, several) => {
            let mut ends = several.iter().filter(|crossing| **crossing != Touch);
            let are_paired = ends.clone().collect::<Vec<_>>().chunks(2).all(|pair| *pair == [&Enter, &Exit]);
            are_paired || ends.next().is_some() && query.may_leave_the_type(&query.ray)
        }
        (Kind::Open, [Exit, Enter]) => matches!(&query.solid, Solid::Revolved(revolved) if revolved.has_waist()),
        (Kind::Unbounded, several) => {
            query.is_double && several.windows(2).all(|pair| pair[0] != pair[1]) && !several.contains(&Touch)
        }
        _ => false,
    };
    law!(as_should_be, query, "crossings that do not pair up: {whole:?}");
}

/// Rule 3: the range starts inside exactly if the last crossing before it led in.
fn starts_inside_as_the_crossings_say<S: Number>(query: &Query<S>, hits: &Hits<S>, whole: &Hits<S>) {
    let start = query.ray.range().start();
    if query.kind == Kind::Open {
        law!(!hits.starts_inside() && !whole.starts_inside(), query, "an open surface has no inside: {hits:?}");
        return;
    }
    let Some(first) = whole.first() else {
        // A line without an end lies outside, or inside of what has none either.
        let endless = query.kind == Kind::Unbounded || query.may_leave_the_type(&query.ray);
        law!(!hits.starts_inside() || endless, query, "inside of nothing: {hits:?}");
        return;
    };
    let mut inside = first.crossing == Crossing::Exit;
    for hit in whole.iter().filter(|hit| hit.t < start) {
        inside = hit.crossing == Crossing::Enter;
    }
    law!(hits.starts_inside() == inside, query, "starts inside? {inside} by the crossings {whole:?}: {hits:?}");
}

/// Rule 8, for a ray that departs from where a hit was.
fn departs<S: Number>(query: &Query<S>, ray: &Ray<S>, whole: &Hits<S>, leaving: Leaving) {
    if matches!(query.kind, Kind::Open | Kind::NotConvex) || query.is_double {
        return;
    }
    let met = match (leaving, &whole[..]) {
        (Leaving::Outwards, hits) => hits.is_empty() && !whole.starts_inside(),
        (Leaving::Inwards, [exit]) => exit.crossing == Crossing::Exit && exit.t >= S::ZERO && whole.starts_inside(),
        // An unbounded solid may have no far end; that of another may lie beyond the type.
        (Leaving::Inwards, []) => query.kind == Kind::Unbounded || query.may_leave_the_type(ray),
        _ => false,
    };
    law!(met, query, "departing {leaving:?} gives {whole:?} on {ray:?}");
}

/// Rule 8, from each hit, along the ray and back.
fn leaves_without_epsilon<S: Number, T: Tier<S>>(query: &Query<S>, hit: &Hit<S>, is_honest: bool) {
    let surface = query.shape.surface(&query.ray, hit);
    let both = query.shape.seen_from(Visible::Both);
    let along = query.ray.direction();
    let normal = surface.normal();
    for direction in [along, -along, normal, -normal] {
        for leaving in [Leaving::Inwards, Leaving::Outwards] {
            let Ok(next) = Ray::new(surface.point(), direction) else { continue };
            let next = next.departing(surface.departure(0, leaving)).with_range(Range::line());
            let again = listed::<S, T>(query, &both, &next);
            if is_honest {
                departs(query, &next, &again, leaving);
            }
        }
    }
}

/// Whether everything of a surface is a number.
fn surface_is_sound<S: Number>(query: &Query<S>, hit: &Hit<S>, is_honest: bool) {
    let surface = query.shape.surface(&query.ray, hit);
    let (point, local) = (surface.point(), surface.local_point());
    let (o, d, t) = (query.ray.origin().to_f64(), query.ray.direction().to_f64(), hit.t.to_f64());
    let farthest = (0..3).map(|i| (o[i] + t * d[i]).abs()).fold(t.abs(), f64::max);
    let numbers = point.to_array().into_iter().chain(local.to_array()).all(is_number);
    law!(numbers, query, "{point:?} or {local:?} of {hit:?} is no number");
    // Well within the type a point has coordinates.
    let half = S::BUDGET.distance.to_f64() * 0.5;
    if is_honest && farthest <= half {
        law!(is_finite(point), query, "{point:?} of {hit:?} is beyond the type");
        let turned = matches!(query.shape.placement(), Placement::Affine(_));
        let far = farthest + query.position().iter().fold(0.0, |sum, c| sum + c.abs()) > half;
        law!(turned || far || is_finite(local), query, "{local:?} of {hit:?} is beyond the type");
    }
    let (tu, tv) = surface.tangents();
    for direction in [surface.normal(), surface.normal_towards_ray(), tu, tv] {
        // Taken only if it has the length one.
        let unit = UnitVec3::<S>::from_components(direction.to_array());
        law!(unit == Ok(direction), query, "{direction:?} of {hit:?} is no direction");
    }
    let (u, v) = surface.uv();
    let range = <S::Unit as UnitScalar>::ZERO..=<S::Unit as UnitScalar>::ONE;
    law!(range.contains(&u) && range.contains(&v), query, "surface coordinates {u:?}, {v:?} of {hit:?}");
}

/// False for NaN of any kind.
fn is_number<S: Scalar>(value: S) -> bool {
    value.partial_cmp(&S::ZERO).is_some()
}

fn is_finite<S: Scalar>(point: Vec3<S>) -> bool {
    point.to_array().into_iter().all(S::is_finite)
}
