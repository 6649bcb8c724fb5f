//! Spheres, capsules and round cones.

use super::attempt::{Attempt, Stop, known};
use super::end::{
    self, Curve, End, Flat, Fraction, Goal, Interval, Of, between, inwards, order, settled, solid, span, times,
};
use super::local_ray::LocalRay;
use super::quadratic::{Inside, Quadratic};
use super::quadric::{Ball, Cylinder, Quadric, Tangent};
use super::side::{Within, within};
use crate::intersection::{self, Intersection, Span};
use crate::number::{Difference, Estimate, Number, Ring, dot};
use crate::part::Part;
use crate::scalar::{Scalar, ToScalar};
use core::cmp::Ordering;

/// The ball about the origin.
#[inline(always)]
pub(crate) fn ball<S: Scalar, N: Of<S>>(line: &LocalRay<N>, radius: S, goal: Goal<S>) -> Attempt<Intersection<S>> {
    ball_about(line, line.origin, N::scalar(radius), true, goal)
}

/// The ball relative to whose centre the line's origin is `o`.
#[inline(always)]
fn ball_about<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    o: [N; 3],
    r: N,
    is_about_origin: bool,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    if is_approached::<S, N>(line) {
        return from_closest_approach(line, &Approach::new(line, o, r, is_about_origin), goal);
    }
    let quadratic = Quadratic::new(Ball { o, d: line.direction, r }, line, line.departs())?;
    // The only other case is `Nowhere`, since a > 0.
    let Inside::Between(touch) = quadratic.inside else { return Err(Stop::Miss) };
    let interval = quadratic.between(touch);
    if line.departs() {
        return inwards(&quadratic, line, &interval.exit, goal.range);
    }
    solid(&quadratic, line, &interval, goal)
}

/// True if a ball is intersected by [`Approach`]. It is cheaper than the Pluecker moment, but has a small error if the
/// length of the direction is only nearly 1.
#[inline(always)]
fn is_approached<S: Scalar, N: Of<S>>(line: &LocalRay<N>) -> bool {
    line.is_unit && !line.departs() && <N::Estimate as ToScalar<S>>::ROUNDING_DECIDES
}

/// The point `p` of the line `o + t d` that is closest to the centre of a ball, where `o` is relative to the centre and
/// `|d|` is nearly 1.
struct Approach<N: Number> {
    /// `r^2 - |p|^2` with `p = o - k d`
    discriminant: N,
    /// `r^2 + |p|^2`: the magnitudes to which the error of that difference is proportional.
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
            // The origin was moved from f by m = -f . d, so that o . d = (f + m d) . d = m (|d|^2 - 1).
            (if N::KNOWS_LENGTH { line.moved * excess } else { N::ZERO }, o)
        };
        // `o . d / |d|^2`, of a ball that is not about the origin to which the line's origin was moved.
        let k = if N::KNOWS_LENGTH && !is_about_origin { k - k * excess } else { k };
        let (rr, pp) = (r * r, dot(p, p));
        Self { discriminant: rr - pp, terms: rr + pp + line.far(N::MOVED), k, excess }
    }

    /// True if the line touches the ball, false if it crosses it; an error if it misses the ball.
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

    /// `-k -+ sqrt(D) / |d|` of the discriminant `D`, and `sqrt(D)`. `1 / |d|` is taken as `1 - excess / 2`; the next
    /// term of the series, `3 excess^2 / 8`, is below 2^-39, since a direction has `|excess| < 2^-19`.
    #[inline(always)]
    fn roots(&self) -> ([N::Estimate; 2], N::Estimate) {
        let (k, root) = (self.k.estimate(), self.discriminant.estimate().square_root());
        let half = if N::KNOWS_LENGTH { root - root * self.excess.estimate().scaled(-1) } else { root };
        ([-k - half, half - k], root)
    }
}

#[inline(always)]
fn from_closest_approach<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    approach: &Approach<N>,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
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
#[inline(always)]
pub(crate) fn capsule<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    [radius, height]: [S; 2],
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    let (r, height) = (N::scalar(radius), N::scalar(height));
    let side = Quadratic::new(Cylinder::along(line.origin, line.direction, r), line, line.departs_from(Part::Side))?;
    let along = [line.origin[1], line.direction[1]];
    let rounded = Rounded { line, side: &side, along, seams: [N::ZERO, height], radii: [r; 2], height, goal };
    if line.departs() {
        return match side.inside {
            Inside::Between(_) => rounded.departing(side.ends()[1]),
            Inside::Everywhere => rounded.departing(End::never_left()),
            Inside::InSurface if N::KNOWS_ZERO => rounded.in_the_side(),
            _ => rounded.departing(End::start(Part::Side)),
        };
    }
    let interval = match side.inside {
        Inside::Between(touch) => side.between(touch),
        Inside::Everywhere => Interval::everywhere(),
        Inside::InSurface if N::KNOWS_ZERO => return rounded.in_the_side(),
        _ => return Err(Stop::Miss),
    };
    rounded.met(&interval)
}

/// The convex hull of two balls, one about the origin and the other about `(0, height, 0)`: both, and what the cone
/// that touches them encloses between the two circles where it does. If one ball holds the other, it is that ball.
#[inline(always)]
pub(crate) fn round_cone<S: Scalar, N: Of<S>>(
    line: &LocalRay<N>,
    radii: [S; 2],
    height: S,
    goal: Goal<S>,
) -> Attempt<Intersection<S>> {
    if radii[0] == radii[1] {
        return capsule(line, [radii[0], height], goal);
    }
    let (radii, height) = (radii.map(N::scalar), N::scalar(height));
    let k = radii[0] - radii[1];
    let [x, y, z] = line.origin;
    if known((k - height).sign())? != Ordering::Less {
        return Ok(ball_about(line, line.origin, radii[0], true, goal)?.with_part(Part::Base));
    }
    if known((k + height).sign())? != Ordering::Greater {
        return Ok(ball_about(line, [x, y - height, z], radii[1], false, goal)?.with_part(Part::Top));
    }
    let Tangency { cone, along, seams } = Tangency::of(line, radii, height, k);
    let side = Quadratic::new(cone, line, line.departs_from(Part::Side))?;
    let rounded = Rounded { line, side: &side, along, seams, radii, height, goal };
    match (within(&side)?, line.departs()) {
        (Within::Along(_), _) if N::KNOWS_ZERO => rounded.in_the_side(),
        (Within::Along(_), _) => Err(Stop::Unsure),
        (Within::In(interval), true) => rounded.departing(interval.exit),
        (Within::Nowhere, true) => rounded.departing(End::start(Part::Side)),
        (Within::In(interval), false) => rounded.met(&interval),
        (Within::Nowhere, false) => Err(Stop::Miss),
    }
}

/// The cone that touches two balls, and multiples of heights: of the line's origin and their growth along the line, and
/// of the circles where it touches the balls.
struct Tangency<N> {
    cone: Tangent<N>,
    along: [N; 2],
    seams: [N; 2],
}

impl<N: Number> Tangency<N> {
    /// `k` is the difference of the radii.
    #[inline(always)]
    fn of(line: &LocalRay<N>, [base, top]: [N; 2], height: N, k: N) -> Self {
        let ([x, y, z], [dx, dy, dz]) = (line.origin, line.direction);
        // With a rounded `m = k / h`, the sine of the angle between axis and side, there are fewer roundings.
        match k.rounded_quotient(height) {
            Some(m) => Self {
                cone: Tangent {
                    o: [x, z],
                    d: [dx, dz],
                    w: (N::ONE - m) * (N::ONE + m),
                    v: [base - m * y, -(m * dy)],
                    k: m,
                },
                along: [y, dy],
                seams: [base * m, height + top * m],
            },
            None => Self {
                cone: Tangent::along(line.origin, line.direction, [base, height, k]),
                along: [height * y, height * dy],
                seams: [base * k, N::sum([[height, height], [top, k]])],
            },
        }
    }
}

/// A convex side with a ball at each end, which touches it along a circle, the seam.
///
/// The balls lie inside of the infinite side. A line that passes a ball inside the side, beyond the seam, does not meet
/// what is between the seams, whose ends are discs inside of the balls. Therefore each end of the line's interval in
/// the infinite side corresponds to one end of the interval in the solid, or the line misses the solid.
struct Rounded<'a, S: Scalar, N: Number, Q> {
    line: &'a LocalRay<N>,
    side: &'a Quadratic<N, Q>,
    /// The height of the line's origin, and its growth along the line; or a multiple of both.
    along: [N; 2],
    /// The heights of the seams, or the same multiple of them.
    seams: [N; 2],
    radii: [N; 2],
    /// That of the upper ball's centre.
    height: N,
    goal: Goal<S>,
}

impl<S: Scalar, N: Of<S>, Q: Quadric<N>> Rounded<'_, S, N, Q> {
    /// The intersection with a line whose interval in the infinite side is this.
    #[inline(always)]
    fn met(&self, interval: &Interval<N>) -> Attempt<Intersection<S>> {
        let (enter, touches) = self.end(interval.enter, true)?;
        // A line that only touches the side or a ball enters and leaves at the same point.
        if touches || interval.touch {
            let (exit, _) = self.end(interval.exit, false)?;
            let touch = enter.part == exit.part;
            return Ok(Intersection::One(Span::joined(enter, exit, touch)));
        }
        if self.goal.since.is_some_and(|since| enter.t >= since) {
            return Ok(Intersection::Entered(enter));
        }
        match self.end(interval.exit, false) {
            Ok((exit, _)) => Ok(Intersection::One(Span::joined(enter, exit, false))),
            Err(Stop::Miss) if N::IS_WIDE => Err(Stop::Miss),
            Err(_) if enter.t.is_finite() && !N::IS_WIDE => Ok(Intersection::Entered(enter)),
            Err(_) => Err(Stop::Unsure),
        }
    }

    /// How the height of an end of the side compares with that of a seam.
    #[inline(always)]
    fn beside(&self, end: &End<N>, seam: N) -> Attempt<Ordering> {
        let [y, dy] = self.along;
        if !N::IS_WIDE {
            return known(((y - seam).estimate() + end.t * dy.estimate()).sign());
        }
        match known(dy.sign())? {
            Ordering::Equal => known((y - seam).sign()),
            climb => Ok(times(order(self.side, end, &self.crossing(seam))?, climb)),
        }
    }

    /// Where the line is at the height of a seam.
    fn crossing(&self, seam: N) -> End<N> {
        let [y, dy] = self.along;
        End::at(Fraction { n: seam - y, e: dy }, Part::Side)
    }

    /// The end in the solid for one end in the infinite side, and whether the line only touches a ball there. It is on
    /// the side between the seams (included), and on a ball beyond them. A miss if the line misses that ball.
    #[inline(always)]
    fn end(&self, end: End<N>, entering: bool) -> Attempt<(intersection::End<S>, bool)> {
        N::apart(
            #[inline(always)]
            || {
                let part = if matches!(end.place, end::Place::Missing) {
                    let climbs = known(self.line.direction[1].sign())? == Ordering::Greater;
                    if climbs == entering { Part::Base } else { Part::Top }
                } else if self.beside(&end, self.seams[0])? == Ordering::Less {
                    Part::Base
                } else if self.beside(&end, self.seams[1])? == Ordering::Greater {
                    Part::Top
                } else {
                    return Ok((self.settled(self.side, &end, entering)?, false));
                };
                let [x, y, z] = self.line.origin;
                let (o, r) = match part {
                    Part::Top => ([x, y - self.height, z], self.radii[1]),
                    _ => ([x, y, z], self.radii[0]),
                };
                if is_approached::<S, N>(self.line) {
                    let approach = Approach::new(self.line, o, r, false);
                    let touch = approach.touches()?;
                    let ([lower, upper], _) = approach.roots();
                    let t = if entering { lower } else { upper };
                    return Ok((self.settled(&Flat, &End { place: end::Place::Missing, t, part }, entering)?, touch));
                }
                let ball = Ball { o, d: self.line.direction, r };
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

    /// A line in the side: from seam to seam, or, if they are one, at one point.
    #[cold]
    #[inline(never)]
    fn in_the_side(&self) -> Attempt<Intersection<S>> {
        let at = |part: Part, seam: N| {
            if self.line.departs_from(part) { End::start(Part::Side) } else { self.crossing(seam) }
        };
        let (low, high) = (at(Part::Base, self.seams[0]), at(Part::Top, self.seams[1]));
        let (enter, exit) = match known(self.along[1].sign())? {
            Ordering::Greater => (low, high),
            Ordering::Less => (high, low),
            Ordering::Equal => return Err(Stop::Miss),
        };
        if self.line.departs() {
            return inwards(&Flat, self.line, &exit, self.goal.range);
        }
        let touch = known((self.seams[1] - self.seams[0]).sign())? == Ordering::Equal;
        Ok(Intersection::One(span(&Flat, self.line, &Interval { enter, exit, touch }, self.goal.range)?))
    }

    /// A line that departs inwards, and leaves the infinite side at this end.
    #[inline(never)]
    fn departing(&self, exit: End<N>) -> Attempt<Intersection<S>> {
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
