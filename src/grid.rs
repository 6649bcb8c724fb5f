//! What several primitives share on the grid of fixed point.

use crate::intersection::{End, Intersection, Span};
use crate::part::Part;
use crate::scalar::{Attempt, Crossed, GridScalar, InSide, LocalLine, UnitScalar, are_doubtful, found};
use core::cmp::Ordering;

/// The guards of a tier on the grid against rounding errors.
pub trait Guards: 'static {
    /// True if the grid is unsure where its rounding may decide, so that the robust number decides.
    const GUARDED: bool;
    /// See [`LocalLine::is_strict`](crate::scalar::LocalLine::is_strict).
    const STRICT: bool = false;
}

/// The interval of a line with `low <= y <= high`.
pub(crate) struct Slab<S> {
    pub(crate) span: Span<S>,
    /// Whether the grid is unsure where rounding may decide which of two ends is the first. Otherwise two ends within a
    /// unit of each other may be in either order.
    is_guarded: bool,
}

impl<S: GridScalar> Slab<S> {
    /// The interval between two heights, if the grid is sure. The parts of its ends are those of the two planes.
    ///
    /// The tiers with guards leave rims to the solver: rays aimed at them were lost or invented, up to 14 of 2,000.
    #[inline(always)]
    pub(crate) fn new<T: Guards>(line: &LocalLine<S>, low: S, high: S) -> Attempt<Self> {
        let ([_, y, _], [_, dy, _]) = (line.origin, line.direction);
        let of = |span| Self { span, is_guarded: T::GUARDED };
        match line.crossings([low, high]) {
            Attempt::Hit([low, high]) => {
                let (base, top) = (End::new(low, Part::Base), End::new(high, Part::Top));
                let rises = dy >= S::Unit::ZERO;
                Attempt::Hit(of(if rises { Span::new(base, top) } else { Span::new(top, base) }))
            }
            Attempt::Miss if line.extra_bits == 0 => {
                if low <= y && y <= high {
                    Attempt::Hit(of(Span::everywhere()))
                } else {
                    Attempt::Miss
                }
            }
            _ => Attempt::Unsure,
        }
    }

    /// Whether two ends are so close that their order may be decided by rounding.
    #[inline(always)]
    fn are_close(&self, a: S, b: S) -> bool {
        self.is_guarded && are_doubtful(a, b)
    }

    /// Whether rounding may decide the entry into a side and these planes.
    #[inline(always)]
    fn is_entry_close(&self, side: &Span<S>) -> bool {
        let planes = &self.span;
        self.are_close(side.enter.t, planes.enter.t)
            || self.are_close(side.enter.t, planes.exit.t)
            || self.are_close(side.exit.t, planes.enter.t)
            || self.are_close(planes.enter.t, planes.exit.t)
    }

    /// The same for their exit, once their entry is certain.
    #[inline(always)]
    fn is_exit_close(&self, side: &Span<S>) -> bool {
        self.are_close(side.exit.t, self.span.exit.t)
    }

    /// The exit of a line that starts on the part `from` of a side or of these planes: the nearer of the side's and the
    /// plane's.
    #[inline(always)]
    pub(crate) fn exit(&self, side: End<S>, from: Part) -> Attempt<End<S>> {
        let plane = self.span.exit;
        // It cannot leave by the plane that it starts on.
        let leads_away = plane.part == from && from != Part::Side;
        if leads_away || self.are_close(side.t, plane.t) {
            Attempt::Unsure
        } else {
            Attempt::Hit(if plane.t >= side.t { side } else { plane })
        }
    }

    /// The part of a side's interval that lies between the planes, if its ends are accurate enough. An end that is cut
    /// off by a plane need not be.
    #[inline(always)]
    pub(crate) fn clip(&self, inside: &InSide<S>) -> Attempt<Intersection<S>> {
        let side = Span::of_side(inside.ends);
        if self.is_entry_close(&side) || self.is_exit_close(&side) || !self.cuts_off_what_is_inaccurate(inside) {
            return Attempt::Unsure;
        }
        side.intersection(self.span).map_or(Attempt::Miss, |span| Attempt::Hit(Intersection::One(span)))
    }

    /// The ends of a side's interval that lie between the planes, if they are accurate enough; the rims belong to the
    /// side.
    #[inline(always)]
    pub(crate) fn rims(&self, inside: &InSide<S>) -> Attempt<Intersection<S>> {
        let side = Span::of_side(inside.ends);
        if self.is_entry_close(&side) || self.is_exit_close(&side) || !self.cuts_off_what_is_inaccurate(inside) {
            return Attempt::Unsure;
        }
        Attempt::Hit(between_rims(side, self.span))
    }

    /// Whether each end of a side's interval is accurate, or is cut off by a plane.
    #[inline(always)]
    fn cuts_off_what_is_inaccurate(&self, inside: &InSide<S>) -> bool {
        let ([is_enter_accurate, is_exit_accurate], [low, high]) = (inside.are_accurate(), inside.ends);
        (is_enter_accurate || self.span.enter.t > low) && (is_exit_accurate || self.span.exit.t < high)
    }
}

/// The interval of a line in half-spaces, as far as it has been clipped.
pub(crate) struct Clip<S> {
    enter: End<S>,
    exit: End<S>,
    /// Whether the grid is unsure where rounding may decide which of two ends is the first.
    is_guarded: bool,
    /// False if rounding may decide which plane the line leaves by.
    is_exit_sure: bool,
    /// The part that the line starts on; it leads inwards from it.
    from: Option<Part>,
}

impl<S: GridScalar> Clip<S> {
    /// The whole line; or what is ahead of a start on this part, from which it leads inwards.
    #[inline(always)]
    pub(crate) fn new<T: Guards>(from: Option<Part>) -> Self {
        let Span { enter, exit, .. } = Span::everywhere();
        Self { enter, exit, is_guarded: T::GUARDED, is_exit_sure: true, from }
    }

    /// Whether rounding may decide the order of two ends.
    #[inline(always)]
    fn are_close(&self, a: S, b: S) -> bool {
        self.is_guarded && a.is_finite() && b.is_finite() && are_doubtful(a, b)
    }

    /// Clips by the half-space of a face. If two planes are crossed at the same `t`, the first one counts.
    #[inline(always)]
    pub(crate) fn by(&mut self, crossed: Attempt<Crossed<S>>, part: Part) -> Attempt<()> {
        match (crossed, self.from) {
            // It leads in by the slope alone, wherever its rounded coordinates put the crossing.
            (Attempt::Hit(Crossed::Leaves(_) | Crossed::Inside), Some(from)) if from == part => return Attempt::Unsure,
            (Attempt::Hit(Crossed::Inside | Crossed::Enters(_)), Some(_)) => {}
            // The line has been inside, whatever its rounded coordinates are.
            (Attempt::Miss, Some(_)) => return Attempt::Unsure,
            (Attempt::Hit(Crossed::Enters(t)), None) => {
                if self.are_close(t, self.enter.t) {
                    return Attempt::Unsure;
                }
                if t > self.enter.t {
                    self.enter = End::new(t, part);
                }
            }
            (Attempt::Hit(Crossed::Leaves(t)), _) => {
                if self.are_close(t, self.exit.t) {
                    self.is_exit_sure = false;
                } else if t < self.exit.t {
                    self.is_exit_sure = true;
                }
                if t < self.exit.t {
                    self.exit = End::new(t, part);
                }
            }
            (Attempt::Hit(Crossed::Inside), None) => {}
            (Attempt::Miss, None) => return Attempt::Miss,
            (Attempt::Unsure, _) => return Attempt::Unsure,
        }
        if self.enter.t > self.exit.t && !self.are_close(self.enter.t, self.exit.t) {
            return Attempt::Miss;
        }
        Attempt::Hit(())
    }

    /// Clips by two planes across an axis of the line, the parts of the lower and of the upper face.
    #[inline(always)]
    pub(crate) fn by_slab(
        &mut self,
        line: &LocalLine<S>,
        axis: usize,
        [low, high]: [S; 2],
        [below, above]: [Part; 2],
    ) -> Attempt<()> {
        let line = line.about(axis);
        let ([_, o, _], [_, d, _]) = (line.origin, line.direction);
        let [low, high] = match line.crossings([low, high]) {
            Attempt::Hit([at_low, at_high]) if d > S::Unit::ZERO => [Crossed::Enters(at_low), Crossed::Leaves(at_high)],
            Attempt::Hit([at_low, at_high]) => [Crossed::Leaves(at_low), Crossed::Enters(at_high)],
            Attempt::Miss if line.extra_bits == 0 => {
                return if low < o && o < high {
                    Attempt::Hit(())
                } else if o < low || o > high {
                    self.by(Attempt::Miss, below)
                } else {
                    Attempt::Unsure
                };
            }
            _ => return Attempt::Unsure,
        };
        found!(self.by(Attempt::Hit(low), below));
        self.by(Attempt::Hit(high), above)
    }

    /// The interval, or its entry alone.
    #[inline(always)]
    pub(crate) fn interval(&self, line: &LocalLine<S>) -> Attempt<Intersection<S>> {
        let Self { enter, exit, .. } = *self;
        if self.are_close(enter.t, exit.t) || enter.t > exit.t {
            return Attempt::Unsure;
        }
        let entry_alone = line.needs_only(enter.t) || !self.is_exit_sure;
        Attempt::Hit(if entry_alone { Intersection::Entered(enter) } else { Intersection::One(Span::new(enter, exit)) })
    }

    /// Where a line that starts on a part leaves.
    #[inline(always)]
    pub(crate) fn exit(&self) -> Attempt<End<S>> {
        if self.is_exit_sure { Attempt::Hit(self.exit) } else { Attempt::Unsure }
    }
}

/// Two balls and the part of an infinite side between the seams: the circles in which the side touches the balls.
///
/// An end of the line's interval in the solid is the end in the infinite side, if that lies between the seams, and
/// otherwise the end in the ball beyond the seam.
pub(crate) struct BetweenBalls<'a, S: GridScalar, F> {
    pub(crate) line: &'a LocalLine<S>,
    /// Whether the line's point at this `t` lies below the seams (`Less`), between them, or above.
    pub(crate) seams: F,
    pub(crate) radii: [S; 2],
    /// The height of the upper ball's centre; that of the lower one is zero.
    pub(crate) height: S,
    /// See [`LocalLine::ball`].
    pub(crate) by_moment: bool,
    pub(crate) is_strict: bool,
}

impl<S: GridScalar, F: Fn(S) -> Attempt<Ordering>> BetweenBalls<'_, S, F> {
    /// The intersection with a line whose interval in the infinite side is this.
    #[inline(always)]
    pub(crate) fn meets(&self, inside: &InSide<S>) -> Attempt<Intersection<S>> {
        let ([low, high], [is_low, is_high]) = (inside.ends, inside.are_accurate());
        // Next to a seam the ends in the ball are as inaccurate as those in the side.
        let by_moment = self.by_moment || !is_low || !is_high;
        let ball = |line: &LocalLine<S>, radius: S| line.ball(radius, by_moment, self.is_strict);
        let outer = if is_low { low } else { -S::INFINITY };
        let enter = found!(self.end([low, outer], |line, radius, _| Attempt::Hit(found!(ball(line, radius))[0])));
        if self.line.needs_only(enter.t) {
            return Attempt::Hit(Intersection::Entered(enter));
        }
        let outer = if is_high { high } else { S::INFINITY };
        match self.end([high, outer], |line, radius, _| Attempt::Hit(found!(ball(line, radius))[1])) {
            Attempt::Hit(exit) if enter.t <= exit.t => Attempt::Hit(Intersection::One(Span::new(enter, exit))),
            // The exit is uncertain, or rounding put it before the entry.
            _ => Attempt::Hit(Intersection::Entered(enter)),
        }
    }

    /// The exit of a line that starts on the part `from`, and leaves the infinite side at this end, or as far away as
    /// the second number.
    #[inline(always)]
    pub(crate) fn exit(&self, side: [S; 2], from: Part) -> Attempt<End<S>> {
        self.end(side, |line, radius, part| {
            if part == from {
                return line.exit_from_round(true);
            }
            let by_moment = self.by_moment || side[0] != side[1];
            Attempt::Hit(found!(line.ball(radius, by_moment, self.is_strict))[1])
        })
    }

    /// The end in the solid for one end in the infinite side, which may lie as far away as `outer`. `of_ball` is given
    /// the line relative to the ball's centre, and the radius.
    #[inline(always)]
    fn end(
        &self,
        [side, outer]: [S; 2],
        of_ball: impl FnOnce(&LocalLine<S>, S, Part) -> Attempt<S>,
    ) -> Attempt<End<S>> {
        let seams = found!((self.seams)(side));
        if side != outer && (seams == Ordering::Equal || found!((self.seams)(outer)) != seams) {
            return Attempt::Unsure;
        }
        let (part, [centre, radius]) = match seams {
            Ordering::Less => (Part::Base, [S::ZERO, self.radii[0]]),
            Ordering::Greater => (Part::Top, [self.height, self.radii[1]]),
            Ordering::Equal => return Attempt::Hit(End::new(side, Part::Side)),
        };
        let t = found!(of_ball(&found!(self.line.lowered(centre)), radius, part));
        Attempt::Hit(End::new(t, part))
    }
}

/// The interval of an infinite side, if its ends are accurate.
#[inline(always)]
pub(crate) fn whole_side<S: GridScalar>(inside: &InSide<S>) -> Attempt<Span<S>> {
    if inside.are_accurate() == [true; 2] { Attempt::Hit(Span::of_side(inside.ends)) } else { Attempt::Unsure }
}

/// The ends of `side` that lie in the slab between the rims; the rims belong to it.
#[inline(always)]
fn between_rims<S: GridScalar>(side: Span<S>, between: Span<S>) -> Intersection<S> {
    let on_surface = |end: End<S>| between.enter.t <= end.t && end.t <= between.exit.t;
    let (enter, exit) = (on_surface(side.enter), on_surface(side.exit));
    if !enter && !exit {
        return Intersection::Miss;
    }
    Intersection::Surface(Span {
        enter: if enter { side.enter } else { End::none(-S::INFINITY) },
        exit: if exit { side.exit } else { End::none(S::INFINITY) },
        touch: side.touch,
    })
}

/// The one crossing of a flat surface, from its front or its back.
#[inline]
pub(crate) fn surface_hit<S: GridScalar>(t: S, from_front: bool) -> Intersection<S> {
    let end = End::new(t, Part::Side);
    Intersection::Surface(if from_front {
        Span::new(end, End::none(S::INFINITY))
    } else {
        Span::new(End::none(-S::INFINITY), end)
    })
}
