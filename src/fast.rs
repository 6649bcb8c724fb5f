//! What the fast paths of several primitives share.

use crate::intersection::{End, Intersection, Span};
use crate::part::Part;
use crate::scalar::{Attempt, LocalLine, Scalar, UnitScalar};

/// The guards of a tier's fast path against rounding errors.
pub trait Guards: 'static {
    /// True if the fast path is unsure where its rounding may decide, so that the robust number decides.
    const GUARDED: bool;
    /// See [`LocalLine::is_strict`](crate::scalar::LocalLine::is_strict).
    const STRICT: bool = false;
}

/// The interval of a line with `low <= y <= high`, and the error of its ends beyond a few units.
pub(crate) struct Slab<'a, S: Scalar> {
    line: &'a LocalLine<S>,
    pub(crate) span: Span<S>,
    off: [S; 2],
}

impl<'a, S: Scalar> Slab<'a, S> {
    /// The interval between two heights, if the fast path is sure. The parts of its ends are those of the two planes.
    #[inline(always)]
    pub(crate) fn new(line: &'a LocalLine<S>, low: S, high: S) -> Attempt<Self> {
        let ([_, y, _], [_, dy, _]) = (line.origin, line.direction);
        match S::fast_crossings(*line, [low, high]) {
            Attempt::Hit(([low, high], [off_low, off_high])) => {
                let (base, top) = (End::new(low, Part::Base), End::new(high, Part::Top));
                Attempt::Hit(if dy < S::Unit::ZERO {
                    Self { line, span: Span::new(top, base), off: [off_high, off_low] }
                } else {
                    Self { line, span: Span::new(base, top), off: [off_low, off_high] }
                })
            }
            Attempt::Miss if line.extra_bits == 0 => {
                if low <= y && y <= high {
                    Attempt::Hit(Self { line, span: Span::everywhere(), off: [S::ZERO; 2] })
                } else {
                    Attempt::Miss
                }
            }
            _ => Attempt::Unsure,
        }
    }

    /// Whether rounding may decide the order of the ends of a side and of these planes, or of the two planes.
    #[inline(always)]
    pub(crate) fn is_close_to(&self, side: &Span<S>) -> bool {
        let (planes, [enter, exit]) = (&self.span, self.off);
        S::are_close(self.line, side.enter.t, planes.enter.t, enter)
            || S::are_close(self.line, side.exit.t, planes.exit.t, exit)
            || S::are_close(self.line, side.enter.t, planes.exit.t, exit)
            || S::are_close(self.line, side.exit.t, planes.enter.t, enter)
            || S::are_close(self.line, planes.enter.t, planes.exit.t, enter)
    }

    /// The exit of a line that starts on the part `from` of a side or of these planes: the nearer of the side's and the plane's.
    #[inline(always)]
    pub(crate) fn exit(&self, side: End<S>, from: Part) -> Attempt<End<S>> {
        let (plane, [_, off]) = (self.span.exit, self.off);
        // It cannot leave by the plane that it starts on.
        let leads_away = plane.part == from && from != Part::Side;
        if leads_away || S::are_close(self.line, side.t, plane.t, off) {
            Attempt::Unsure
        } else if plane.t >= side.t {
            Attempt::Hit(side)
        } else if S::is_good(self.line, plane.t, off) {
            Attempt::Hit(plane)
        } else {
            Attempt::Unsure
        }
    }

    /// The part of a side's interval that lies between the planes, if its ends are accurate enough.
    #[inline(always)]
    pub(crate) fn clip(&self, side: Span<S>) -> Attempt<Intersection<S>> {
        let Some(span) = side.intersection(self.span) else { return Attempt::Miss };
        let [enter, exit] = self.off;
        let is_good = |end: End<S>, off: S| end.part == Part::Side || S::is_good(self.line, end.t, off);
        if is_good(span.enter, enter) && is_good(span.exit, exit) {
            Attempt::Hit(Intersection::One(span))
        } else {
            Attempt::Unsure
        }
    }
}

/// The ends of `side` that lie in the slab between the rims; the rims belong to it.
#[inline(always)]
pub(crate) fn between_rims<S: Scalar>(side: Span<S>, between: Span<S>) -> Intersection<S> {
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
pub(crate) fn surface_hit<S: Scalar>(t: S, from_front: bool) -> Intersection<S> {
    let end = End::new(t, Part::Side);
    Intersection::Surface(if from_front {
        Span::new(end, End::none(S::INFINITY))
    } else {
        Span::new(End::none(-S::INFINITY), end)
    })
}
