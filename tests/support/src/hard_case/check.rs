//! How a hard case is checked: the table against exact arithmetic, and the crate against exact arithmetic.

use super::{Axis, Case, Limit, build};
use crate::cases::{direction, lattice_directions};
use crate::exact_types::{Exact, same_crossing, same_part};
use crate::oracle::{self, Answer, ConeExtent, CylinderExtent, Dyadic, InRange, Line, Root, Solid};
use raylet::{Crossing, Frame, Hits, Part, Range, Ray, Shape, Tier, UnitVec3, Vec3};

/// What a tier is held to.
#[derive(Clone, Copy, Debug)]
pub struct Policy {
    /// The greatest error of `t` for floats, in units in the last place.
    pub floats: f64,
    /// The same for fixed types, in units.
    pub fixed: f64,
    /// Whether the limits that stand in the tables count, for rows and for sweeps.
    pub limits: bool,
}

impl Policy {
    /// The default tier: what was measured (3.4 and 0.82 units), and a little more; the rows say what they except.
    pub const STABLE: Self = Self { floats: 3.5, fixed: 0.85, limits: true };
    /// The exact tier: never another answer. Floats round every t correctly but for ties, integers nearly so.
    pub const EXACT: Self = Self { floats: 0.51, fixed: 0.75, limits: false };

    /// The bound for a number type.
    pub fn units<S: Exact>(&self) -> f64 {
        if S::name().starts_with('f') { self.floats } else { self.fixed }
    }
}

/// What was found: the greatest error of `t` in units, the answers that are not the exact ones, and what is wrong in
/// itself, whatever the exact answer is.
#[derive(Clone, Debug, Default)]
pub struct Found {
    pub worst: f64,
    /// Other answers that are exact for a ray within one unit: see `is_within_a_unit`.
    pub ties: Vec<String>,
    /// Other answers, that are exact for no ray near by.
    pub other: Vec<String>,
    pub broken: Vec<String>,
    /// The differences in full, for messages.
    pub told: Vec<String>,
}

/// Calls every query with the ray, and with the whole line, and compares with the exact answer.
pub fn compare<S: Exact, T: Tier<S>>(shape: &Shape<S>, solid: &Solid, line: &Line, ray: &Ray<S>, found: &mut Found) {
    let answer = oracle::solve(solid, line);
    for ray in [*ray, ray.with_range(Range::line())] {
        let hits = shape.hits_at::<T>(&ray);
        let (start, end) = (ray.range().start().exact(), ray.range().end().exact());
        let exact = oracle::hits_in_range(&answer, &start, Some(&end));
        if shape.nearest_at::<T>(&ray) != hits.first().copied() {
            found.broken.push(format!("nearest is {:?} of {hits:?}", shape.nearest_at::<T>(&ray)));
        }
        if shape.occludes_at::<T>(&ray) == hits.is_empty() {
            found.broken.push(format!("occludes does not agree with {hits:?}"));
        }
        let (given, wanted) = (summary(&hits), exact_summary(&exact));
        if given != wanted {
            let told = format!("{ray:?} gives {hits:?}, exactly {} of {solid:?}", with_distances(&exact));
            if is_within_a_unit(solid, line, &ray, &hits, &exact) {
                found.ties.push(given);
            } else {
                found.other.push(given);
                found.told.push(told);
            }
            continue;
        }
        for (hit, exact) in hits.iter().zip(&exact.hits) {
            found.worst = found.worst.max(error(hit.t, &exact.t));
        }
        if let (Some(overlap), Answer::Coincident { from, to }) = (hits.coincident(), &answer) {
            // What lies beyond the range is cut off at its ends.
            let low = from.as_ref().filter(|from| from.cmp_dyadic(&start).is_gt()).cloned();
            let high = to.as_ref().filter(|to| to.cmp_dyadic(&end).is_lt()).cloned();
            found.worst = found.worst.max(error(overlap.start(), &low.unwrap_or_else(|| Root::from(&start))));
            found.worst = found.worst.max(error(overlap.end(), &high.unwrap_or_else(|| Root::from(&end))));
        }
    }
}

/// True if the answer is decided within one unit of the largest `t`, as the default tier documents: hits differ in
/// their parts alone, and lie at a rim or a seam; two ends round to the same `t`; or the answer is the exact one of a
/// ray whose origin is moved by up to a unit for each end (a rim, an apex, a tangent).
fn is_within_a_unit<S: Exact>(solid: &Solid, line: &Line, ray: &Ray<S>, hits: &Hits<S>, exact: &InRange) -> bool {
    let given = hits.iter().map(|hit| hit.t.exact()).chain(ray.origin().to_array().map(S::exact));
    let all: Vec<Root> = given.map(|t| Root::from(&t)).chain(exact.hits.iter().map(|hit| hit.t.clone())).collect();
    let largest = all.iter().map(Root::magnitude).max().expect("an origin has coordinates");
    let unit = S::unit_at(&largest);

    let at_seam = |t: &Root| {
        let y = line.coordinate_at(t, 1);
        seams(solid).iter().any(|seam| y.error_in(seam, &unit) <= 1.0)
    };
    let apart_in_parts = hits.len() == exact.hits.len()
        && hits.starts_inside() == exact.starts_inside
        && hits.iter().zip(&exact.hits).all(|(hit, exact)| {
            same_crossing(hit.crossing, exact.crossing) && (same_part(hit.part, exact.part) || at_seam(&exact.t))
        });
    // From far enough away a unit is larger than the whole solid.
    if apart_in_parts || seams(solid).iter().any(|seam| !seam.is_zero() && (seam - &unit).signum() <= 0) {
        return true;
    }
    if is_one(exact, hits, &unit) {
        return true;
    }
    let (start, end) = (ray.range().start().exact(), ray.range().end().exact());
    // Far away a unit is larger than the solid, and smaller moves tell more.
    [1, 0, -4, -8, -12, -16, -20, -24, -28].iter().any(|scale| {
        lattice_directions().iter().any(|way| {
            let origin = std::array::from_fn(|i| &line.origin[i] + &(&unit.scaled(*scale) * &way[i].exact()));
            let answer = oracle::solve(solid, &Line::new(origin, line.direction.clone()));
            let moved = oracle::hits_in_range(&answer, &start, Some(&end));
            exact_summary(&moved) == summary(hits) || is_one(&moved, hits, &unit)
        })
    })
}

/// True if a touch is given where two ends round to the same `t`.
fn is_one<S: Exact>(exact: &InRange, hits: &Hits<S>, unit: &Dyadic) -> bool {
    match (&hits[..], &exact.hits[..]) {
        ([hit], [enter, exit]) if hit.crossing == Crossing::Touch => {
            exit.t.error_in(&enter.t.approximation(200), unit) <= 1.0
        }
        _ => false,
    }
}

/// The heights at which parts of the solid meet.
fn seams(solid: &Solid) -> Vec<Dyadic> {
    match solid {
        Solid::Cylinder { extent: CylinderExtent::Open(height) | CylinderExtent::Capped(height), .. }
        | Solid::Cone { extent: ConeExtent::Open(height) | ConeExtent::Capped(height), .. }
        | Solid::Frustum { height, .. }
        | Solid::Capsule { height, .. }
        | Solid::Tube { height, .. } => vec![Dyadic::zero(), height.clone()],
        Solid::Revolved(revolved) => vec![revolved.low.clone(), revolved.high.clone()],
        _ => vec![],
    }
}

fn error<S: Exact>(t: S, exact: &Root) -> f64 {
    exact.error_in(&t.exact(), &S::unit_at(exact))
}

/// Everything of an answer but the distances, in words.
fn summary<S: Exact>(hits: &Hits<S>) -> String {
    let mut words: Vec<String> = hits.iter().map(|hit| format!("{:?} {:?}", hit.crossing, hit.part)).collect();
    words.extend(hits.starts_inside().then(|| "inside".into()));
    words.extend(hits.coincident().map(|_| "lies in it".into()));
    if words.is_empty() { "nothing".into() } else { words.join(", ") }
}

fn exact_summary(exact: &InRange) -> String {
    let word = |hit: &oracle::ExpectedHit| match hit.part {
        oracle::Part::Facet(number) => format!("{:?} Facet{number}", hit.crossing),
        part => format!("{:?} {part:?}", hit.crossing),
    };
    let mut words: Vec<String> = exact.hits.iter().map(word).collect();
    words.extend(exact.starts_inside.then(|| "inside".into()));
    words.extend(exact.coincident.then(|| "lies in it".into()));
    if words.is_empty() { "nothing".into() } else { words.join(", ") }
}

fn with_distances(exact: &InRange) -> String {
    let at: Vec<String> = exact.hits.iter().map(|hit| format!("{}", hit.t.to_f64())).collect();
    format!("{} at {}", exact_summary(exact), at.join(", "))
}

/// The exact line in the coordinates of a frame with these axes, `offset` from its origin.
fn in_frame(offset: &[Dyadic; 3], towards: &[Dyadic; 3], axes: &[[Dyadic; 3]; 3]) -> Line {
    let dot = |a: &[Dyadic; 3], b: &[Dyadic; 3]| &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2]);
    Line::new(axes.each_ref().map(|axis| dot(axis, offset)), axes.each_ref().map(|axis| dot(axis, towards)))
}

/// The case in a number type: the shape, the solid, the ray, and its line as the solid sees it; `None` where the type
/// cannot hold it.
pub fn of_type<S: Exact>(case: &Case) -> Option<(Shape<S>, Solid, Ray<S>, Line)> {
    let base = Vec3::<S>::from_f64(case.base).ok()?;
    let (frame, end) = match case.axis {
        Axis::X => (Frame::from_base_and_axis(base, UnitVec3::X).ok()?, None),
        Axis::Y => (Frame::from_base_and_axis(base, UnitVec3::Y).ok()?, None),
        Axis::Z => (Frame::from_base_and_axis(base, UnitVec3::Z).ok()?, None),
        Axis::To(end) => {
            let (frame, height) = Frame::between(base, Vec3::from_f64(end).ok()?).ok()?;
            (frame, Some(height))
        }
    };
    let (primitive, solid) = build::<S>(case.kind, end)?;
    let ray = Ray::new(Vec3::from_f64(case.origin).ok()?, direction(case.towards)).ok()?;
    let shape = if case.is_unplaced() { Shape::new(primitive) } else { Shape::new(primitive).placed(frame) };
    let [o, p] = [ray.origin(), frame.position()].map(|v| v.to_array().map(S::exact));
    let offset = std::array::from_fn(|i| &o[i] - &p[i]);
    let axes = [frame.left(), frame.up(), frame.forward()].map(|axis| axis.to_array().map(S::exact_unit));
    let line = in_frame(&offset, &ray.direction().to_array().map(S::exact_unit), &axes);
    Some((shape, solid, ray, line))
}

/// The case in a number type and a tier: the greatest error and what is wrong; `None` where the type cannot hold it.
pub fn check<S: Exact, T: Tier<S>>(case: &Case, policy: &Policy) -> Option<(f64, Vec<String>)> {
    let (shape, solid, ray, line) = of_type::<S>(case)?;
    let mut found = Found::default();
    compare::<S, T>(&shape, &solid, &line, &ray, &mut found);
    let mut wrong = found.broken.clone();
    let (mut bound, mut given) = (policy.units::<S>(), String::new());
    for (name, limit) in case.limits {
        match limit {
            _ if !policy.limits || *name != S::name() => {}
            Limit::Units(units) => {
                if *units > found.worst * 1.1 || found.worst <= bound {
                    wrong.push(format!("a limit of {units} units is not needed: measured {}", found.worst));
                }
                bound = *units;
            }
            Limit::Gives(answer) => given = (*answer).into(),
        }
    }
    if found.worst > bound {
        wrong.push(format!("{} units, bound {bound}", found.worst));
    }
    // An answer that the row excepts must be given as it says, and not any other; and no longer, once it is right.
    let answers = [found.ties, found.other].concat().join(" / ");
    if answers != given {
        wrong.push(format!("gives \"{answers}\", the row says \"{given}\": {}", found.told.join("; ")));
    }
    let wrong = wrong.into_iter().map(|what| format!("{} in {}: {what}", case.name, S::name())).collect();
    Some((found.worst, wrong))
}

/// What is wrong in the table: where the written answer is not that of exact arithmetic on the written inputs, rounded
/// to `f64`. Nothing of the crate decides here.
pub fn check_written(case: &Case) -> Vec<String> {
    let (axes, end) = written_axes(case);
    let (_, solid) = build::<f64>(case.kind, end).expect("f64 holds every size");
    let offset = std::array::from_fn(|i| &case.origin[i].exact() - &case.base[i].exact());
    let towards = case.towards.map(Exact::exact);
    let answer = oracle::solve(&solid, &in_frame(&offset, &towards, &axes.map(|axis| axis.map(Exact::exact))));
    let [x, y, z] = case.towards;
    let length = (x * x + y * y + z * z).sqrt();
    let mut wrong = vec![];
    let mut compare = |t: &Root, written: &str| {
        let (t, written) = (t.to_f64() * length, written.parse::<f64>().expect("a decimal"));
        // Every written case is that well conditioned, in f64.
        if (t - written).abs() > 1e-9 * written.abs() {
            wrong.push(format!("{}: t is written {written}, exactly {t}", case.name));
        }
    };
    if let (Some(lies), Answer::Coincident { from, to }) = (case.lies, &answer) {
        for (end, written) in [from, to].into_iter().zip(lies) {
            match (end, written) {
                (Some(end), Some(written)) => compare(end, written),
                (None, None) => {}
                _ => panic!("{}: the line lies in it from {from:?} to {to:?}", case.name),
            }
        }
    }
    // Both directions of the whole line, and the ray from t = 0.
    let reach = case.horizon.min(f64::MAX).exact();
    let line = oracle::hits_in_range(&answer, &-&reach, Some(&reach));
    let ray = oracle::hits_in_range(&answer, &Dyadic::zero(), Some(&reach));
    for (exact, (_, _, written)) in line.hits.iter().zip(case.hits) {
        compare(&exact.t, written);
    }
    let told = |ahead: bool| {
        let of = |(crossing, part, _): &(Crossing, Part, &str)| format!("{crossing:?} {part:?}");
        case.hits.iter().filter(|(_, _, t)| !ahead || !t.starts_with('-')).map(of).collect::<Vec<_>>().join(", ")
    };
    let exactly = |hits: &[oracle::ExpectedHit]| {
        hits.iter().map(|hit| format!("{:?} {:?}", hit.crossing, hit.part)).collect::<Vec<_>>().join(", ")
    };
    if (told(false), told(true)) != (exactly(&line.hits), exactly(&ray.hits)) {
        wrong.push(format!("{}: {:?} are written, exactly {line:?}", case.name, case.hits));
    }
    if case.starts_inside != ray.starts_inside || case.lies.is_some() != line.coincident {
        wrong.push(format!("{}: written {case:?}, exactly {ray:?}", case.name));
    }
    wrong
}

/// The axes of the case's frame and, where the axis is given by its far end, the height.
fn written_axes(case: &Case) -> ([[f64; 3]; 3], Option<f64>) {
    use crate::random::{cross, dot, normalize};
    const UNIT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let [x, y, z] = UNIT;
    match case.axis {
        Axis::X => ([z, x, y], None),
        Axis::Y => (UNIT, None),
        Axis::Z => ([y, z, x], None),
        Axis::To(end) => {
            let along: [f64; 3] = std::array::from_fn(|i| end[i] - case.base[i]);
            let up = normalize(along);
            let right = normalize(cross(up, if up[0].abs() < 0.8 { x } else { y }));
            ([right, up, cross(right, up)], Some(dot(along, along).sqrt()))
        }
    }
}
