//! What the fast paths of several primitives share.

use crate::intersection::{End, Intersection, Span};
use crate::part::{FACES, Part};
use crate::scalar::{Attempt, LocalLine, Scalar, UnitScalar, found};

/// Whether a tier's fast path has guards against rounding.
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
        Self::between(line, line, [low, high], [Part::Base, Part::Top])
    }

    /// The interval between two planes across an axis, which is the y axis of the line `seen`: the line itself, or with its axes exchanged.
    #[inline(always)]
    fn between(
        line: &'a LocalLine<S>,
        seen: &LocalLine<S>,
        [low, high]: [S; 2],
        [base, top]: [Part; 2],
    ) -> Attempt<Self> {
        let ([_, y, _], [_, dy, _]) = (seen.origin, seen.direction);
        match S::fast_crossings(*seen, [low, high]) {
            Attempt::Found(([low, high], [off_low, off_high])) => {
                let (base, top) = (End::new(low, base), End::new(high, top));
                Attempt::Found(if dy < S::Unit::ZERO {
                    Self { line, span: Span::new(top, base), off: [off_high, off_low] }
                } else {
                    Self { line, span: Span::new(base, top), off: [off_low, off_high] }
                })
            }
            Attempt::Miss if line.finer == 0 => {
                if low <= y && y <= high {
                    Attempt::Found(Self { line, span: Span::everywhere(), off: [S::ZERO; 2] })
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
            Attempt::Found(side)
        } else if S::is_good(self.line, plane.t, off) {
            Attempt::Found(plane)
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
            Attempt::Found(Intersection::One(span))
        } else {
            Attempt::Unsure
        }
    }
}

/// The intervals of a line in the three slabs of a cuboid, in the order of [`FACES`].
pub(crate) struct CuboidSlabs<'a, S: Scalar>([Slab<'a, S>; 3]);

impl<'a, S: Scalar> CuboidSlabs<'a, S> {
    /// The intervals; unsure of a line that lies in the plane of a face, since that owns its ends.
    #[inline(always)]
    pub(crate) fn new(line: &'a LocalLine<S>, [x, y, z]: [S; 3]) -> Attempt<Self> {
        let [across_x, across_z, across_y] = FACES;
        let slab = |seen: &LocalLine<S>, half: S, faces: [Part; 2]| {
            let ([_, o, _], [_, d, _]) = (seen.origin, seen.direction);
            if d == S::Unit::ZERO && o.magnitude() == half {
                return Attempt::Unsure;
            }
            Slab::between(line, seen, [-half, half], faces)
        };
        let first = found!(slab(&line.across_x(), x, across_x));
        let second = found!(slab(&line.across_z(), z, across_z));
        Attempt::Found(Self([first, second, found!(slab(line, y, across_y))]))
    }

    /// The end that comes after all others, if `is_later` says so, and its error; whether rounding may decide which one that is.
    #[inline(always)]
    fn decisive(&self, ends: [(End<S>, S); 3], is_later: impl Fn(S, S) -> bool) -> ((End<S>, S), bool) {
        let [first, second, third] = ends;
        let later = |a: (End<S>, S), b: (End<S>, S)| if is_later(b.0.t, a.0.t) { b } else { a };
        let decisive = later(later(first, second), third);
        let is_close = |other: (End<S>, S)| {
            let (own, own_off) = decisive;
            other.0.part != own.part
                && (other.0.t == own.t || S::are_close(self.line(), other.0.t, own.t, other.1.plus(own_off)))
        };
        (decisive, is_close(first) || is_close(second) || is_close(third))
    }

    #[inline(always)]
    fn line(&self) -> &'a LocalLine<S> {
        let Self([slab, ..]) = self;
        slab.line
    }

    #[inline(always)]
    fn exit(&self) -> ((End<S>, S), bool) {
        let Self([x, z, y]) = self;
        self.decisive([x, z, y].map(|slab| (slab.span.exit, slab.off[1])), |a, b| a < b)
    }

    /// What the slabs have in common.
    #[inline(always)]
    pub(crate) fn intersection(&self) -> Attempt<Intersection<S>> {
        let (Self([x, z, y]), line) = (self, self.line());
        let ((enter, enter_off), enters_at_edge) =
            self.decisive([x, z, y].map(|slab| (slab.span.enter, slab.off[0])), |a, b| a > b);
        let ((exit, exit_off), exits_at_edge) = self.exit();
        if enter.t == exit.t || S::are_close(line, enter.t, exit.t, enter_off.plus(exit_off)) {
            return Attempt::Unsure;
        }
        // Whichever of the planes come last and first: no entry is before the one, no exit after the other.
        if enter.t > exit.t {
            return Attempt::Miss;
        }
        let is_good = S::is_good(line, enter.t, enter_off) && S::is_good(line, exit.t, exit_off);
        if enters_at_edge || exits_at_edge || !is_good {
            return Attempt::Unsure;
        }
        Attempt::Found(Intersection::One(Span::new(enter, exit)))
    }

    /// The exit of a line that starts on a face.
    #[inline(always)]
    pub(crate) fn exit_from(&self, from: Part) -> Attempt<End<S>> {
        let Self([x, z, y]) = self;
        // Its direction leads out by the face that it starts on, which it then does at once, whatever its rounded coordinates say.
        let leads_away = x.span.exit.part == from || z.span.exit.part == from || y.span.exit.part == from;
        let ((exit, off), exits_at_edge) = self.exit();
        if leads_away || exits_at_edge || !S::is_good(self.line(), exit.t, off) {
            return Attempt::Unsure;
        }
        Attempt::Found(exit)
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
