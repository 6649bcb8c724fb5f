//! Cylinders and cones about the y axis, infinite, open or between planes.

use super::attempt::{Attempt, Stop, known};
use super::end::{self, Curve, End, Fraction, Goal, Interval, Of, inwards, order, settled, solid, span};
use super::local_ray::LocalRay;
use super::quadratic::{Inside, Quadratic};
use super::quadric::{Cylinder, Nappe, Profile, Quadric};
use crate::equations::{Described, EquationKinds, Equations};
use crate::intersection::{self, Intersection, Span};
use crate::number::Number;
use crate::outline::{Extent, Outline};
use crate::part::Part;
use crate::ray::Leaving;
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// The ends of a side, and whether a plane cuts it at its lower and at its upper height: none does at an apex.
#[derive(Clone, Copy)]
struct Ends<S> {
    extent: Extent<S>,
    are_planes: [bool; 2],
}

/// The cylinder of this radius, or its side alone.
#[inline(always)]
pub(crate) fn cylinder<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    radius: S,
    extent: Extent<S>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let ends = Ends { extent, are_planes: [true; 2] };
    side(line, Cylinder::along(line.origin, line.direction, N::scalar(radius)), ends, goal)
}

/// The cone of this outline, or its side alone.
#[inline(always)]
pub(crate) fn cone<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    outline: Outline<S>,
    extent: Extent<S>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    side(line, nappe(line, outline), Ends { extent, are_planes: caps(&outline) }, goal)
}

/// Whether a capped cone has a cap at its base and at its top: it has none where it ends in an apex.
#[inline(always)]
pub(crate) fn caps<S: Scalar>(outline: &Outline<S>) -> [bool; 2] {
    match *outline {
        Outline::Slope(_) => [false, true],
        Outline::Radii(base, top, _) => [base != S::ZERO, top != S::ZERO],
    }
}

/// The planes that cut a side with these caps.
#[inline(always)]
pub(super) fn planes_of<S: Scalar>(extent: Extent<S>, [base, top]: [bool; 2]) -> [Option<S>; 2] {
    match extent {
        Extent::Double | Extent::Infinite => [None; 2],
        Extent::Open(height) => [Some(S::ZERO), Some(height)],
        Extent::Capped(height) => [base.then_some(S::ZERO), top.then_some(height)],
    }
}

/// The planes that cut a primitive with a side, if the geometry `G` has such equations.
#[inline(always)]
pub(super) fn planes_through<S: Scalar, G: Described>(equations: &Equations<S>) -> [Option<S>; 2] {
    let has = |kind| G::EQUATIONS.has(kind);
    match equations {
        Equations::Cylinder { extent, .. } if has(EquationKinds::CYLINDER) => planes_of(*extent, [true; 2]),
        Equations::Cone { outline, extent } if has(EquationKinds::CONE) => planes_of(*extent, caps(outline)),
        Equations::Revolved { meridian } if has(EquationKinds::REVOLVED) => meridian.heights.map(Some),
        Equations::Tube { height, .. } if has(EquationKinds::TUBE) => [Some(S::ZERO), Some(*height)],
        _ => [None; 2],
    }
}

/// The line in the coordinates of a cone.
#[inline(always)]
fn nappe<S: Scalar, N: Of<S>>(line: &LocalRay<N>, outline: Outline<S>) -> Nappe<N> {
    let profile = Profile::of(outline, N::scalar);
    let slope = match outline {
        Outline::Slope(_) => Some(profile.growth),
        Outline::Radii(..) => profile.growth.rounded_quotient(profile.h),
    };
    // With a rounded slope m the radius at y is base + m y, with fewer roundings than (base h + growth y) / h.
    let Some(m) = slope else { return Nappe::along(line.origin, line.direction, profile) };
    let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
    Nappe { o: [x, z, profile.base + m * y], d: [dx, dz, m * dy] }
}

/// The interval of the line with `low <= y <= high`; `None` if there is none. Its ends have the parts `Base` and `Top`.
/// The start of a line that departs from one of the planes is taken to lie on it.
#[inline(always)]
pub(super) fn slab<N: Number>(line: &LocalRay<N>, low: Option<N>, high: Option<N>) -> Attempt<Option<Interval<N>>> {
    let (y, dy) = (line.origin[1], line.direction[1]);
    let end = |height: N, part: Part| {
        if line.departs_from(part) { End::start(part) } else { End::at(Fraction { n: height - y, e: dy }, part) }
    };
    let low_end = |none: fn() -> End<N>| low.map_or_else(none, |height| end(height, Part::Base));
    let high_end = |none: fn() -> End<N>| high.map_or_else(none, |height| end(height, Part::Top));
    Ok(match known(dy.sign())? {
        Ordering::Greater => Some(Interval::new(low_end(End::never_entered), high_end(End::never_left))),
        Ordering::Less => Some(Interval::new(high_end(End::never_entered), low_end(End::never_left))),
        Ordering::Equal => {
            let is_below = match low {
                Some(low) => known((y - low).sign())? == Ordering::Less,
                None => false,
            };
            let is_above = match high {
                Some(high) => known((y - high).sign())? == Ordering::Greater,
                None => false,
            };
            (!(is_below || is_above)).then(Interval::everywhere)
        }
    })
}

/// The interval of a line inside a side.
pub(super) enum Within<N: Number> {
    Nowhere,
    In(Interval<N>),
    /// The whole interval lies in the surface.
    Along(Interval<N>),
}

/// The interval of the line inside a side; of a cone, inside the nappe with `v >= 0`, where `v` is the outline.
#[inline(always)]
pub(super) fn within<N: Number, Q: Quadric<N>>(quadratic: &Quadratic<N, Q>) -> Attempt<Within<N>> {
    N::apart(
        #[inline(always)]
        || {
            let [g, slope] = quadratic.quadric.outline();
            // Whether the outline v grows along the line.
            let grows = || if Q::HAS_NAPPES { known(slope.sign()) } else { Ok(Ordering::Equal) };
            let is_between = matches!(quadratic.inside, Inside::Between(_));
            if is_between && Q::HAS_NAPPES {
                // Both roots are in one nappe, whose sign is that of v at t = -k / a, between the roots, times a > 0.
                let vertex = N::sum([[g, quadratic.a], [-slope, quadratic.k]]);
                if known(vertex.sign())? == Ordering::Less {
                    return Ok(Within::Nowhere);
                }
            }
            if !is_between {
                match quadratic.inside {
                    Inside::Everywhere => return Ok(Within::In(Interval::everywhere())),
                    Inside::InSurface if N::KNOWS_ZERO => return Ok(Within::Along(along([g, slope], grows()?))),
                    Inside::InSurface | Inside::Nowhere => return Ok(Within::Nowhere),
                    _ => {}
                }
            }
            let [first, second] = quadratic.ends();
            if let Inside::Between(touch) = quadratic.inside {
                return Ok(Within::In(Interval { enter: first, exit: second, touch }));
            }
            // If the line is steeper than the side, a half-line lies in each nappe. If it is parallel to a generator,
            // there is one half-line, in one nappe.
            Ok(match (quadratic.inside, grows()?) {
                (Inside::Beyond | Inside::From, Ordering::Greater) => {
                    Within::In(Interval::new(second, End::never_left()))
                }
                (Inside::Beyond, _) | (Inside::Until, Ordering::Less) => {
                    Within::In(Interval::new(End::never_entered(), first))
                }
                _ => Within::Nowhere,
            })
        },
    )
}

/// The interval of a line that lies in the surface: up to the apex or from it on, or the whole line.
#[cold]
#[inline(never)]
fn along<N: Number>([g, slope]: [N; 2], grows: Ordering) -> Interval<N> {
    let apex = || End::at(Fraction { n: -g, e: slope }, Part::Side);
    match grows {
        Ordering::Equal => Interval::everywhere(),
        Ordering::Greater => Interval::new(apex(), End::never_left()),
        Ordering::Less => Interval::new(End::never_entered(), apex()),
    }
}

/// The end of the side's interval, `own`, or that of the slab's, `plane`, if `own` compares with it as `counts` says.
/// If both are the same point, it is on a rim, which belongs to the side (rule 5 of the contract).
#[inline(always)]
pub(super) fn choose<N: Number>(
    curve: &impl Curve<N>,
    own: End<N>,
    plane: End<N>,
    counts: Ordering,
) -> Attempt<End<N>> {
    Ok(if order(curve, &own, &plane)? == counts { plane } else { own })
}

/// The part of the side's interval that lies between the planes (rule 1 of the contract: one interval).
#[inline(always)]
pub(super) fn clip<N: Number>(curve: &impl Curve<N>, side: &Interval<N>, planes: &Interval<N>) -> Attempt<Interval<N>> {
    N::apart(
        #[inline(always)]
        || {
            let enter = choose(curve, side.enter, planes.enter, Ordering::Less)?;
            let exit = choose(curve, side.exit, planes.exit, Ordering::Greater)?;
            // Two roots are in order. With a plane the order must be decided.
            let lengths = match (enter.part, exit.part) {
                (Part::Side, Part::Side) => Ordering::Less,
                (_, Part::Side) => order(curve, &exit, &enter)?.reverse(),
                _ => order(curve, &enter, &exit)?,
            };
            match lengths {
                Ordering::Greater => Err(Stop::Miss),
                Ordering::Less => Ok(Interval { enter, exit, touch: side.touch }),
                Ordering::Equal => Ok(Interval { enter: enter.of_side(), exit: exit.of_side(), touch: true }),
            }
        },
    )
}

/// The intersection of a line with the inside of a side, or with the side alone.
#[inline(always)]
fn side<S: Scalar, N: Of<S>, Q: Quadric<N>>(
    line: &LocalRay<N>,
    quadric: Q,
    ends: Ends<S>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let quadratic = Quadratic::new(quadric, line, line.departs_from(Part::Side))?;
    if line.departs() {
        return departing(line, quadratic, ends, goal);
    }
    if Q::HAS_NAPPES && matches!(ends.extent, Extent::Double) {
        return both_nappes(line, quadratic, goal);
    }
    // By reference: on an M0+, a move of an interval takes 490 instructions, and with `?` there would be four.
    let within = within(&quadratic);
    let interval = match &within {
        Err(stop) => return Err(*stop),
        Ok(Within::Nowhere) => return Err(Stop::Miss),
        Ok(Within::In(interval)) => interval,
        Ok(Within::Along(interval)) if N::KNOWS_ZERO => {
            return in_the_side(line, quadratic, interval, ends, goal);
        }
        Ok(Within::Along(_)) => return Err(Stop::Unsure),
    };
    if let Extent::Infinite | Extent::Double = ends.extent {
        return solid(&quadratic, line, interval, goal);
    }
    let planes = planes(line, ends);
    let planes = match &planes {
        Err(stop) => return Err(*stop),
        Ok(None) => return Err(Stop::Miss),
        Ok(Some(planes)) => planes,
    };
    if let Extent::Open(_) = ends.extent {
        return on_the_side(line, &quadratic, interval, planes, goal);
    }
    solid(&quadratic, line, &clip(&quadratic, interval, planes)?, goal)
}

/// The interval of the line between the planes at the ends; `None` if there is none.
#[inline(always)]
fn planes<S: Scalar, N: Of<S>>(line: &LocalRay<N>, ends: Ends<S>) -> Attempt<Option<Interval<N>>> {
    N::apart(
        #[inline(always)]
        || {
            let [low, high] = planes_of(ends.extent, ends.are_planes);
            slab(line, low.map(N::scalar), high.map(N::scalar))
        },
    )
}

/// A line that lies in the side over an interval.
#[cold]
#[inline(never)]
fn in_the_side<S: Scalar, N: Of<S>, Q: Quadric<N>>(
    line: &LocalRay<N>,
    quadratic: Quadratic<N, Q>,
    interval: &Interval<N>,
    ends: Ends<S>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let is_solid = matches!(ends.extent, Extent::Capped(..));
    in_the_surface(line, &quadratic, interval, planes(line, ends)?, is_solid, goal)
}

/// A line that lies in a side without end, of which the part between the planes counts. A line that departs outwards
/// meets nothing.
#[cold]
#[inline(never)]
pub(super) fn in_the_whole_side<S: Scalar, N: Of<S>, Q: Quadric<N>>(
    line: &LocalRay<N>,
    side: &Quadratic<N, Q>,
    planes: Option<Interval<N>>,
    is_solid: bool,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    if line.leads_outwards() {
        return Err(Stop::Miss);
    }
    in_the_surface(line, side, &Interval::everywhere(), planes, is_solid, goal)
}

/// A line that lies in a surface over an interval, of which the part between the planes counts.
#[inline(always)]
fn in_the_surface<S: Scalar, N: Of<S>, Q: Quadric<N>>(
    line: &LocalRay<N>,
    quadratic: &Quadratic<N, Q>,
    interval: &Interval<N>,
    planes: Option<Interval<N>>,
    is_solid: bool,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let departs = line.departs();
    let planes = match planes {
        Some(planes) => planes,
        None if departs => Interval::everywhere(),
        None => return Err(Stop::Miss),
    };
    // Its ends lie on rims, which belong to the side.
    let Interval { enter, exit, touch } = clip(quadratic, interval, &planes)?;
    let interval = Interval { enter: enter.of_side(), exit: exit.of_side(), touch };
    if is_solid && departs {
        return inwards(quadratic, line, &interval.exit, goal.range);
    }
    let span = span(quadratic, line, &interval, goal.range)?;
    Ok(if is_solid { Intersection::One(span) } else { Intersection::LiesIn(span) })
}

/// A line that departs inwards.
#[inline(never)]
fn departing<S: Scalar, N: Of<S>, Q: Quadric<N>>(
    line: &LocalRay<N>,
    quadratic: Quadratic<N, Q>,
    ends: Ends<S>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    if Q::HAS_NAPPES && matches!(ends.extent, Extent::Double) {
        return departing_from_both(line, quadratic, goal);
    }
    let is_open = matches!(ends.extent, Extent::Open(_));
    // The line departs from a point of the slab, although its rounded coordinates may be outside.
    let planes = planes(line, ends)?.unwrap_or_else(Interval::everywhere);
    let own = match within(&quadratic)? {
        Within::Along(interval) if N::KNOWS_ZERO => {
            return in_the_side(line, quadratic, &interval, ends, goal);
        }
        Within::Along(_) => return Err(Stop::Unsure),
        Within::In(interval) => interval.exit,
        Within::Nowhere if is_open => return Err(Stop::Miss),
        // By its rounded coordinates the line is outside of the side. If it is parallel to the axis, its interval ends
        // at the plane. Any other line leaves the solid where it starts.
        Within::Nowhere if quadratic.a_sign == Ordering::Equal => End::never_left(),
        Within::Nowhere => End::start(Part::Side),
    };
    if !is_open {
        let exit = choose(&quadratic, own, planes.exit, Ordering::Greater)?;
        return inwards(&quadratic, line, &exit, goal.range);
    }
    // A ray that departs inwards hits the far wall; the start itself is no hit.
    let is_ahead = is_on_the_side(&quadratic, &own, &planes)?
        && known(end::compare(&quadratic, line, &own, S::ZERO))? == Ordering::Greater;
    if !is_ahead {
        return Err(Stop::Miss);
    }
    let exit = settled(&quadratic, line, &own, goal.range)?;
    Ok(Intersection::Surface(Span::new(intersection::End::none(-S::INFINITY), exit)))
}

/// Whether an end of the side's interval lies between the rims of an open side.
#[inline(always)]
pub(super) fn is_on_the_side<N: Number>(curve: &impl Curve<N>, end: &End<N>, planes: &Interval<N>) -> Attempt<bool> {
    Ok(order(curve, end, &planes.enter)? != Ordering::Less && order(curve, end, &planes.exit)? != Ordering::Greater)
}

/// The ends of the interval that lie between the rims of an open side; the rims belong to it.
#[inline(always)]
pub(super) fn on_the_side<S: Scalar, N: Of<S>, Q: Quadric<N>>(
    line: &LocalRay<N>,
    quadratic: &Quadratic<N, Q>,
    interval: &Interval<N>,
    planes: &Interval<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let Interval { enter, exit, touch } = *interval;
    let enters = is_on_the_side(quadratic, &enter, planes)?;
    let leaves = is_on_the_side(quadratic, &exit, planes)?;
    if !(enters || leaves) {
        return Err(Stop::Miss);
    }
    let enter = if enters { enter } else { End::never_entered() };
    let exit = if leaves { exit } else { End::never_left() };
    let touch = touch && enters && leaves;
    Ok(Intersection::Surface(span(quadratic, line, &Interval { enter, exit, touch }, goal.range)?))
}

/// Both nappes of a cone about its apex.
#[inline(never)]
fn both_nappes<S: Scalar, N: Of<S>, Q: Quadric<N>>(
    line: &LocalRay<N>,
    quadratic: Quadratic<N, Q>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let one = |interval: Interval<N>| solid(&quadratic, line, &interval, goal);
    match quadratic.inside {
        Inside::Nowhere => Err(Stop::Miss),
        Inside::Between(touch) => one(quadratic.between(touch)),
        Inside::Beyond => {
            let [first, second] = quadratic.ends();
            let first = span(&quadratic, line, &Interval::new(End::never_entered(), first), goal.range)?;
            if goal.since.is_some_and(|since| first.exit.t < since) {
                return one(Interval::new(second, End::never_left()));
            }
            let second = span(&quadratic, line, &Interval::new(second, End::never_left()), goal.range)?;
            Ok(Intersection::in_order(first, second))
        }
        Inside::Until => one(Interval::new(End::never_entered(), quadratic.ends()[0])),
        Inside::From => one(Interval::new(quadratic.ends()[0], End::never_left())),
        Inside::Everywhere | Inside::InSurface => Ok(Intersection::LiesIn(Span::everywhere())),
    }
}

/// A double cone is not convex: a ray that leaves it outwards may meet the other nappe. One of the roots is the start.
#[inline(never)]
fn departing_from_both<S: Scalar, N: Of<S>, Q: Quadric<N>>(
    line: &LocalRay<N>,
    quadratic: Quadratic<N, Q>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let leaving = line.departure.map_or(Leaving::Outwards, |(_, leaving)| leaving);
    let [first, second] = quadratic.ends();
    let is_ahead = || Ok(known(end::compare(&quadratic, line, &second, S::ZERO))? == Ordering::Greater);
    let until = |end: End<N>| inwards(&quadratic, line, &end, goal.range);
    let from = || span(&quadratic, line, &Interval::new(second, End::never_left()), goal.range);
    match (quadratic.inside, leaving) {
        (Inside::Everywhere | Inside::InSurface, _) => Ok(Intersection::LiesIn(Span::everywhere())),
        (Inside::Between(_), Leaving::Inwards) => until(second),
        // The other root is the entry into the other nappe.
        (Inside::Beyond, Leaving::Outwards) if is_ahead()? => Ok(Intersection::One(from()?)),
        // If rounding makes a ray that departs inwards lead outwards, its first interval ends at its start.
        (Inside::Beyond, Leaving::Inwards) if is_ahead()? => match until(first)? {
            Intersection::One(first) => Ok(Intersection::in_order(first, from()?)),
            other => Ok(other),
        },
        (Inside::Beyond | Inside::From, Leaving::Inwards) => until(End::never_left()),
        (Inside::Until, Leaving::Inwards) => until(first),
        (Inside::Nowhere, _) | (_, Leaving::Outwards) => Err(Stop::Miss),
    }
}
