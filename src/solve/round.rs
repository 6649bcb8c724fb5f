//! Spheres and capsules.

use super::attempt::{Attempt, Stop, known};
use super::end::{
    self, Curve, End, Flat, Fraction, Goal, Interval, Of, between, inwards, order, settled, solid, span, times,
};
use super::local_ray::LocalRay;
use super::quadratic::{Inside, Quadratic};
use super::quadric::{Ball, Tube};
use super::side::slab;
use crate::intersection::{self, Intersection, Span};
use crate::number::{Difference, Estimate, Number, Ring, dot};
use crate::part::Part;
use crate::scalar::{Scalar, ToScalar};
use core::cmp::Ordering;

/// The ball about the origin.
#[inline(always)]
pub(crate) fn ball<S: Scalar, N: Of<S>>(line: &LocalRay<N>, radius: S, goal: Goal<S>) -> Attempt<Intersection<S>> {
    let r = N::scalar(radius);
    if is_approached::<S, N>(line) {
        return from_closest_approach(line, r, goal);
    }
    let quadratic = Quadratic::new(Ball { o: line.origin, d: line.direction, r }, line, line.departs())?;
    // a > 0, so that there is no other case.
    let Inside::Between(touch) = quadratic.inside else { return Err(Stop::Miss) };
    let interval = quadratic.between(touch);
    if line.departs() {
        return inwards(&quadratic, line, &interval.exit, goal.range);
    }
    solid(&quadratic, line, &interval, goal)
}

/// True if a ball is intersected from the point of closest approach: cheaper than from the Pluecker moment, but only
/// nearly exact where the direction's length is only nearly 1.
#[inline(always)]
fn is_approached<S: Scalar, N: Of<S>>(line: &LocalRay<N>) -> bool {
    line.is_unit && !line.departs() && <N::Estimate as ToScalar<S>>::ROUNDING_DECIDES
}

/// The closest approach of a line whose direction has nearly length 1 to the ball about `o`.
struct Approach<N: Number> {
    /// `r^2 - |p|^2` with `p = o - k d`
    discriminant: N,
    /// `r^2 + |p|^2`, which bounds the error of that difference.
    terms: N,
    /// `o . d`
    k: N,
    /// `|d|^2 - 1`
    excess: N,
}

impl<N: Number> Approach<N> {
    #[inline(always)]
    fn new(line: &LocalRay<N>, o: [N; 3], r: N, is_about_origin: bool) -> Self {
        let d = line.direction;
        let excess = if N::KNOWS_LENGTH { dot(d, d) - N::ONE } else { N::ZERO };
        let (k, p) = if N::APPROACHES_AGAIN || !is_about_origin || line.start.is_none() {
            let k = dot(o, d);
            (k, [o[0] - k * d[0], o[1] - k * d[1], o[2] - k * d[2]])
        } else {
            // The line was moved by `m = -f . d`, so that `o . d = (f + m d) . d = m (|d|^2 - 1)`.
            (if N::KNOWS_LENGTH { line.moved * excess } else { N::ZERO }, o)
        };
        let (rr, pp) = (r * r, dot(p, p));
        Self { discriminant: rr - pp, terms: rr + pp + line.far(N::MOVED), k, excess }
    }

    /// True if the line touches the ball, false if it crosses it.
    #[inline(always)]
    fn touches(&self) -> Attempt<bool> {
        // The formulas neglect the square of the excess.
        if !self.excess.is_negligible_squared() {
            return Err(Stop::Unsure);
        }
        match known(self.discriminant.sign_among(Difference::Squares, || self.terms))? {
            Ordering::Less => Err(Stop::Miss),
            sign => Ok(sign == Ordering::Equal),
        }
    }

    /// `-k -+ sqrt(D) / |d|`, where one over the length is `1 - excess / 2`: the next term is below 2^-40.
    #[inline(always)]
    fn roots(&self) -> ([N::Estimate; 2], N::Estimate) {
        let (k, root) = (self.k.estimate(), self.discriminant.estimate().square_root());
        let half = if N::KNOWS_LENGTH { root - root * self.excess.estimate().scaled(-1) } else { root };
        ([-k - half, half - k], root)
    }
}

#[inline(always)]
fn from_closest_approach<S: Scalar, N: Of<S>>(line: &LocalRay<N>, r: N, goal: Goal<S>) -> Attempt<Intersection<S>> {
    let approach = Approach::new(line, line.origin, r, true);
    let touch = approach.touches()?;
    let ([lower, upper], root) = approach.roots();
    let end = |t: N::Estimate| {
        if !N::is_far(ToScalar::<S>::whole(t, line.start), root, || approach.terms) {
            return Err(Stop::Unsure);
        }
        Ok(End { place: end::Place::Missing, t, part: Part::Side })
    };
    let enter = settled(&Flat, line, &end(lower)?, goal.range)?;
    if touch {
        return Ok(Intersection::One(Span { enter, exit: enter, touch }));
    }
    between(&Flat, line, enter, || end(upper), goal)
}

/// All points within `r` of the segment from the origin to `(0, height, 0)`.
///
/// The balls at its ends lie in the infinite tube, and a line that is in the tube beyond a ball without hitting the
/// ball does not return to the side. Therefore each end of the interval in the tube corresponds to one end of the
/// interval in the capsule, or the line misses the capsule.
#[inline(always)]
pub(crate) fn capsule<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    [radius, height]: [S; 2],
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let (r, height) = (N::scalar(radius), N::scalar(height));
    let tube = Quadratic::new(Tube::along(line.origin, line.direction, r), line, line.departs_from(Part::Side))?;
    let capsule = Capsule { line, r, height, tube: &tube, goal };
    if line.departs() {
        return capsule.departing();
    }
    let interval = match tube.inside {
        Inside::Between(touch) => tube.between(touch),
        Inside::Everywhere => Interval::everywhere(),
        Inside::InSurface if N::KNOWS_ZERO => return capsule.in_the_side(),
        _ => return Err(Stop::Miss),
    };
    let (enter, touches) = capsule.end(interval.enter, true)?;
    // A line that only touches the side or a ball enters and leaves at the same point.
    if touches || interval.touch {
        let (exit, _) = capsule.end(interval.exit, false)?;
        let touch = enter.part == exit.part;
        let exit_t = if touch || exit.t < enter.t { enter.t } else { exit.t };
        return Ok(Intersection::One(Span { enter, exit: intersection::End { t: exit_t, ..exit }, touch }));
    }
    if goal.since.is_some_and(|since| enter.t >= since) {
        return Ok(Intersection::Entered(enter));
    }
    match capsule.end(interval.exit, false) {
        Ok((exit, _)) if exit.t < enter.t => {
            Ok(Intersection::One(Span::new(enter, intersection::End { t: enter.t, ..exit })))
        }
        Ok((exit, _)) => Ok(Intersection::One(Span::new(enter, exit))),
        Err(Stop::Miss) if N::IS_WIDE => Err(Stop::Miss),
        Err(_) if enter.t.is_finite() && !N::IS_WIDE => Ok(Intersection::Entered(enter)),
        Err(_) => Err(Stop::Unsure),
    }
}

/// The quantities from which the ends of a capsule are computed.
struct Capsule<'a, S: Scalar, N: Number> {
    line: &'a LocalRay<N>,
    r: N,
    height: N,
    tube: &'a Quadratic<N, Tube<N>>,
    goal: Goal<S>,
}

impl<S: Scalar, N: Of<S>> Capsule<'_, S, N> {
    /// How the height of an end in the tube compares with a seam's.
    #[inline(always)]
    fn beside(&self, end: &End<N>, seam: N) -> Attempt<Ordering> {
        let (y, dy) = (self.line.origin[1], self.line.direction[1]);
        if !N::IS_WIDE {
            return known(((y - seam).estimate() + end.t * dy.estimate()).sign());
        }
        match known(dy.sign())? {
            Ordering::Equal => known((y - seam).sign()),
            climb => {
                let crossing = End::at(Fraction { n: seam - y, e: dy }, Part::Side);
                Ok(times(order(self.tube, end, &crossing)?, climb))
            }
        }
    }

    /// The end in the capsule for one end in the infinite tube, and whether the line only touches a ball there. It is
    /// on the side between the seams (included), and on a ball beyond them. A miss if the line misses that ball.
    #[inline(always)]
    fn end(&self, end: End<N>, entering: bool) -> Attempt<(intersection::End<S>, bool)> {
        N::apart(
            #[inline(always)]
            || {
                let part = if matches!(end.place, end::Place::Missing) {
                    let climbs = known(self.line.direction[1].sign())? == Ordering::Greater;
                    if climbs == entering { Part::Base } else { Part::Top }
                } else if self.beside(&end, N::ZERO)? == Ordering::Less {
                    Part::Base
                } else if self.beside(&end, self.height)? == Ordering::Greater {
                    Part::Top
                } else {
                    return Ok((self.settled(self.tube, &end, entering)?, false));
                };
                let [x, y, z] = self.line.origin;
                let o = [x, if part == Part::Top { y - self.height } else { y }, z];
                if is_approached::<S, N>(self.line) {
                    let approach = Approach::new(self.line, o, self.r, false);
                    let touch = approach.touches()?;
                    let ([lower, upper], _) = approach.roots();
                    let t = if entering { lower } else { upper };
                    return Ok((self.settled(&Flat, &End { place: end::Place::Missing, t, part }, entering)?, touch));
                }
                let ball = Ball { o, d: self.line.direction, r: self.r };
                let ball = Quadratic::new(ball, self.line, self.line.departs_from(part))?;
                let Inside::Between(touch) = ball.inside else { return Err(Stop::Miss) };
                let [first, second] = ball.ends();
                let end = End { part, ..if entering { first } else { second } };
                Ok((self.settled(&ball, &end, entering)?, touch))
            },
        )
    }

    #[inline(always)]
    fn settled(&self, curve: &impl Curve<N>, end: &End<N>, entering: bool) -> Attempt<intersection::End<S>> {
        if !entering && self.line.departs() {
            return match inwards(curve, self.line, end, self.goal.range)? {
                Intersection::One(span) => Ok(span.exit),
                _ => Err(Stop::Unsure),
            };
        }
        settled(curve, self.line, end, self.goal.range)
    }

    /// A line in the side: from seam to seam, or, if the height is zero, at one point.
    #[cold]
    #[inline(never)]
    fn in_the_side(&self) -> Attempt<Intersection<S>> {
        let seams = slab(self.line, Some(N::ZERO), Some(self.height))?.ok_or(Stop::Miss)?;
        let touch = known(self.height.sign())? == Ordering::Equal;
        let (enter, exit) = (seams.enter.of_side(), seams.exit.of_side());
        if self.line.departs() {
            return inwards(&Flat, self.line, &exit, self.goal.range);
        }
        let interval = Interval { enter, exit, touch };
        Ok(Intersection::One(span(&Flat, self.line, &interval, self.goal.range)?))
    }

    /// A line that departs inwards.
    #[inline(never)]
    fn departing(&self) -> Attempt<Intersection<S>> {
        let exit = match self.tube.inside {
            Inside::Between(_) => self.tube.ends()[1],
            Inside::Everywhere => End::never_left(),
            Inside::InSurface if N::KNOWS_ZERO => return self.in_the_side(),
            _ => End::start(Part::Side),
        };
        let exit = match self.end(exit, false) {
            Ok((exit, _)) => exit,
            // If it misses the ball at its end by its rounded coordinates, its interval ends at its start.
            Err(Stop::Miss) => {
                let part = self.line.departure.map_or(Part::Side, |(part, _)| part);
                settled(&Flat, self.line, &End::<N>::start(part), self.goal.range)?
            }
            Err(Stop::Unsure) => return Err(Stop::Unsure),
        };
        Ok(Intersection::One(Span::new(intersection::End::none(-S::INFINITY), exit)))
    }
}
