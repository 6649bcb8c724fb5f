//! Cylinders and cones about the y axis, infinite, open or between planes.

use super::form::{Form, Homogeneous, Line, Quadric, Weight};
use super::quadratic::{End, Fraction, Inside, Interval, Place, Quadratic};
use super::settle::{self, Of, inwards, span};
use crate::equations::{Described, EquationKinds, Extent, Side};
use crate::intersection::{self, Intersection, Span};
use crate::number::Number;
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// The interval of the line with `low <= y <= high`, if any. The parts of its ends are those of the two planes. The planes belong to the
/// slab. The start of a line that departs from one of them is taken to lie on it.
#[inline]
pub(super) fn slab<N: Number>(line: &Line<N>, low: Option<N>, high: Option<N>) -> Option<Option<Interval<N>>> {
    let (y, dy) = (line.origin[1], line.direction[1]);
    let end = |bound: Option<N>, part: Part| {
        bound.map(|bound| {
            if line.departs_from(part) { End::start(part) } else { End::at(Fraction { n: bound - y, e: dy }, part) }
        })
    };
    let base = || end(low, Part::Base);
    let top = || end(high, Part::Top);
    Some(match dy.sign()? {
        Ordering::Greater => Some(Interval::new(base(), top())),
        Ordering::Less => Some(Interval::new(top(), base())),
        Ordering::Equal => {
            let is_below = match low {
                Some(low) => (y - low).sign()? == Ordering::Less,
                None => false,
            };
            let is_above = match high {
                Some(high) => (y - high).sign()? == Ordering::Greater,
                None => false,
            };
            (!(is_below || is_above)).then_some(Interval::EVERYWHERE)
        }
    })
}

/// The interval of a line inside a side.
enum Within<N: Number> {
    Nowhere,
    In(Interval<N>),
    /// The whole interval lies in the surface.
    Along(Interval<N>),
}

/// The interval of the line inside a side. Of a cone only the nappe with a positive outline counts.
#[inline(always)]
fn within<N: Number, F: Quadric<N>>(quadratic: &Quadratic<'_, N, F>, side: F, line: &Line<N>) -> Option<Within<N>> {
    let g = || side.outline(Homogeneous { v: line.origin, w: Weight::One });
    let slope = || side.outline(Homogeneous { v: line.direction, w: Weight::Zero });
    let from = |end: End<N>| Within::In(Interval::new(Some(end), None));
    let until = |end: End<N>| Within::In(Interval::new(None, Some(end)));
    Some(match quadratic.inside()? {
        Inside::Nowhere => Within::Nowhere,
        Inside::Between(touch) => {
            // The outline at the vertex t = -k/a, which lies between the roots, has the sign of the nappe.
            let vertex = || N::sum([[g(), quadratic.a], [-slope(), quadratic.k]]);
            let is_lower = F::IS_CONE && vertex().sign()? == Ordering::Less;
            if is_lower { Within::Nowhere } else { Within::In(quadratic.between(touch)) }
        }
        // The line is steeper than the side: a half-line lies in each nappe. The outline grows with t if the line rises.
        Inside::Beyond if slope().sign()? == Ordering::Greater => from(quadratic.ends()[1]),
        Inside::Beyond => until(quadratic.ends()[0]),
        // The line is parallel to a generator: one half-line, in the nappe into which it leads.
        Inside::From if slope().sign()? == Ordering::Greater => from(quadratic.ends()[0]),
        Inside::Until if slope().sign()? == Ordering::Less => until(quadratic.ends()[0]),
        Inside::From | Inside::Until => Within::Nowhere,
        Inside::Everywhere => Within::In(Interval::EVERYWHERE),
        Inside::InSurface => {
            let slope = slope();
            let apex = || Some(End::at(Fraction { n: -g(), e: slope }, Part::Side));
            Within::Along(match slope.sign()? {
                Ordering::Equal => Interval::EVERYWHERE,
                Ordering::Greater => Interval::new(apex(), None),
                Ordering::Less => Interval::new(None, apex()),
            })
        }
    })
}

/// The side's end or the plane's: the plane's if it compares with the side's as `counts` says. If both are the same point, it is on a rim,
/// which belongs to the side (rule 5 of the contract).
#[inline]
fn choose<N: Number, F: Quadric<N>>(
    quadratic: &Quadratic<'_, N, F>,
    own: Option<End<N>>,
    plane: Option<End<N>>,
    counts: Ordering,
) -> Option<Option<End<N>>> {
    Some(match (own, plane) {
        (None, end) | (end, None) => end,
        (Some(own), Some(plane)) if quadratic.order(&own, &plane)? == counts => Some(plane),
        (own, _) => own,
    })
}

/// The side's interval between the planes (rule 1: one interval).
#[inline]
fn clip<N: Number, F: Quadric<N>>(
    quadratic: &Quadratic<'_, N, F>,
    side: Interval<N>,
    planes: Interval<N>,
) -> Option<Option<Interval<N>>> {
    let enter = choose(quadratic, side.enter, planes.enter, Ordering::Less)?;
    let exit = choose(quadratic, side.exit, planes.exit, Ordering::Greater)?;
    let (Some(first), Some(last)) = (enter, exit) else {
        return Some(Some(Interval { enter, exit, touch: side.touch }));
    };
    let lengths = match (first.place, last.place) {
        (_, Place::At(_)) => quadratic.order(&first, &last)?,
        (Place::At(_), _) => quadratic.order(&last, &first)?.reverse(),
        // The roots are in order.
        _ => Ordering::Less,
    };
    Some(match lengths {
        Ordering::Greater => None,
        Ordering::Less => Some(Interval { enter, exit, touch: side.touch }),
        Ordering::Equal => Some(Interval { enter: Some(first.of_side()), exit: Some(last.of_side()), touch: true }),
    })
}

/// The intersection of a line with the inside of a side, or with the side alone.
#[inline(always)]
pub(super) fn intersect<S: Scalar, N: Of<S>, G: Described>(
    line: &Line<N>,
    side: Side<S>,
    extent: Extent<S>,
    range: Range<S>,
) -> Option<Intersection<S>> {
    match Form::of_side::<S, G>(side, N::scalar) {
        Form::Tube(tube) if G::EQUATIONS.has(EquationKinds::TUBE) => within_a_side(line, tube, extent, range),
        Form::Cone(cone) if G::EQUATIONS.has(EquationKinds::CONE) => within_a_side(line, cone, extent, range),
        // The geometry has no other side.
        _ => Some(Intersection::Miss),
    }
}

/// The same for a side of a known quadric.
#[inline(never)]
fn within_a_side<S: Scalar, N: Of<S>, F: Quadric<N>>(
    line: &Line<N>,
    form: F,
    extent: Extent<S>,
    range: Range<S>,
) -> Option<Intersection<S>> {
    let (low, high) = match extent {
        Extent::Infinite => (None, None),
        Extent::Open(height) => (Some(N::ZERO), Some(N::scalar(height))),
        Extent::Capped(low, high) => (low.map(N::scalar), high.map(N::scalar)),
    };
    let is_open = matches!(extent, Extent::Open(_));
    let departs = line.departure.is_some();
    let planes = match slab(line, low, high)? {
        Some(planes) => planes,
        // The line departs from a point of the slab, although its rounded coordinates are outside.
        None if departs => Interval::EVERYWHERE,
        None => return Some(Intersection::Miss),
    };
    let quadratic = Quadratic::new(form, line, line.departs_from(Part::Side))?;
    let within = within(&quadratic, form, line)?;
    match within {
        Within::Along(interval) => {
            let Some(interval) = clip(&quadratic, interval, planes)? else {
                return Some(Intersection::Miss);
            };
            // Its ends lie on rims, which belong to the side.
            let [enter, exit] = [interval.enter, interval.exit].map(|end| end.map(End::of_side));
            let interval = Interval { enter, exit, ..interval };
            if matches!(extent, Extent::Capped(..)) && departs {
                return Some(Intersection::One(inwards(&quadratic, exit, range)?));
            }
            let span = span(&quadratic, interval, range)?;
            Some(if let Extent::Capped(..) = extent { Intersection::One(span) } else { Intersection::LiesIn(span) })
        }
        Within::Nowhere if departs && !is_open => {
            // The interval of a line parallel to the axis, next to the side, ends at the plane. Any other line only touches the side, by its rounded
            // coordinates.
            let own = if quadratic.a_sign == Ordering::Equal { None } else { Some(End::start(Part::Side)) };
            let exit = choose(&quadratic, own, planes.exit, Ordering::Greater)?;
            Some(Intersection::One(inwards(&quadratic, exit, range)?))
        }
        Within::Nowhere => Some(Intersection::Miss),
        Within::In(interval) if departs && !is_open => {
            let exit = choose(&quadratic, interval.exit, planes.exit, Ordering::Greater)?;
            Some(Intersection::One(inwards(&quadratic, exit, range)?))
        }
        Within::In(interval) if is_open => on_the_side(&quadratic, interval, planes, range, departs),
        Within::In(interval) => Some(match clip(&quadratic, interval, planes)? {
            Some(interval) => Intersection::One(span(&quadratic, interval, range)?),
            None => Intersection::Miss,
        }),
    }
}

/// The ends of the interval that lie between the rims of an open side; the rims belong to it.
fn on_the_side<S: Scalar, N: Of<S>, F: Quadric<N>>(
    quadratic: &Quadratic<'_, N, F>,
    interval: Interval<N>,
    planes: Interval<N>,
    range: Range<S>,
    departs: bool,
) -> Option<Intersection<S>> {
    let on_surface = |end: Option<End<N>>| {
        let Some(end) = end else { return Some(None) };
        let reaches = |plane: Option<End<N>>, beyond: Ordering| match plane {
            Some(plane) => Some(quadratic.order(&end, &plane)? != beyond),
            None => Some(true),
        };
        let reached = reaches(planes.enter, Ordering::Less)? && reaches(planes.exit, Ordering::Greater)?;
        Some(reached.then_some(end))
    };
    if departs {
        // A ray that departs inwards hits the far wall; the start itself is no hit.
        let exit = on_surface(interval.exit)?;
        let is_ahead = match &exit {
            Some(exit) => settle::compare(quadratic, exit, S::ZERO)? == Ordering::Greater,
            None => false,
        };
        if !is_ahead {
            return Some(Intersection::Miss);
        }
        let enter = intersection::End::none(-S::INFINITY);
        return Some(Intersection::Surface(Span::new(enter, settle::exit(quadratic, exit, range, enter)?)));
    }
    let (enter, exit) = (on_surface(interval.enter)?, on_surface(interval.exit)?);
    if enter.is_none() && exit.is_none() {
        return Some(Intersection::Miss);
    }
    Some(Intersection::Surface(span(quadratic, Interval { enter, exit, touch: interval.touch }, range)?))
}
