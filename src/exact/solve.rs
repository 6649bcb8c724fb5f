//! Where a line meets a figure, decided by signs alone.
//!
//! No two rounded numbers are ever compared. Whether a root of a quadric comes before a plane is the sign of the quadric
//! and of its slope where the line crosses the plane; whether a hit lies in the range is the same question, asked at the
//! range's end. Every question can go unanswered (`None`), and then the whole is asked again in wider numbers.

use super::form::{Form, Homogeneous, Line, Weight};
use crate::part::Part;
use crate::ray::Range;
use crate::scalar::certain::{Certain, Estimate, FromScalar, Number};
use core::cmp::Ordering;

/// A parameter `n / e` of the line; `e` is not zero.
#[derive(Clone, Copy)]
pub(super) struct Fraction<N> {
    pub(super) n: N,
    pub(super) e: N,
}

impl<N: Number> Fraction<N> {
    /// How it compares with another.
    pub(super) fn order(self, other: Self) -> Option<Ordering> {
        let order = (self.n * other.e - other.n * self.e).sign()?;
        Some(times(order, times(self.e.sign()?, other.e.sign()?)))
    }
}

/// The sign of a product, as an ordering with zero.
pub(super) fn times(a: Ordering, b: Ordering) -> Ordering {
    match b {
        Ordering::Less => a.reverse(),
        Ordering::Equal => Ordering::Equal,
        Ordering::Greater => a,
    }
}

/// One end of an interval of the line.
#[derive(Clone, Copy)]
pub(super) enum Place<N> {
    /// The lower root of the quadric, or its only one.
    First,
    /// The upper root.
    Second,
    /// Where the line crosses a plane.
    At(Fraction<N>),
}

/// A place, its parameter approximately, and the part of the surface that it lies on.
#[derive(Clone, Copy)]
pub(super) struct End<N: Number> {
    pub(super) place: Place<N>,
    pub(super) t: N::Estimate,
    pub(super) part: Part,
}

impl<N: Number> End<N> {
    /// Where the line crosses a plane.
    #[inline(always)]
    pub(super) fn at(t: Fraction<N>, part: Part) -> Self {
        let ([n, e, _], _) = N::together([t.n, t.e, N::ZERO], N::ZERO);
        Self { place: Place::At(t), t: n.over(e), part }
    }

    /// The same place, as one of the side's.
    pub(super) fn of_side(self) -> Self {
        Self { part: Part::Side, ..self }
    }
}

/// A piece of the line inside a convex set; an end that is missing is infinitely far away.
#[derive(Clone, Copy)]
pub(super) struct Interval<N: Number> {
    pub(super) enter: Option<End<N>>,
    pub(super) exit: Option<End<N>>,
    /// The two ends are one point.
    pub(super) touch: bool,
}

impl<N: Number> Interval<N> {
    pub(super) const EVERYWHERE: Self = Self { enter: None, exit: None, touch: false };

    pub(super) const fn new(enter: Option<End<N>>, exit: Option<End<N>>) -> Self {
        Self { enter, exit, touch: false }
    }
}

/// Where along the line a quadric is zero or below.
pub(super) enum Inside {
    Nowhere,
    /// From the first to the second root; `true` if they are one.
    Between(bool),
    /// Up to the first and from the second on.
    Beyond,
    /// Up to the only root.
    Until,
    /// From the only root on.
    From,
    Everywhere,
    InSurface,
}

/// A quadric along the line: `f = a t^2 + 2 k t + c`.
pub(super) struct Quadratic<'a, N> {
    form: Form<N>,
    line: &'a Line<N>,
    pub(super) a: N,
    pub(super) k: N,
    c: N,
    discriminant: N,
    a_sign: Ordering,
    discriminant_sign: Ordering,
}

impl<'a, N: Number> Quadratic<'a, N> {
    #[inline(always)]
    pub(super) fn new(form: Form<N>, line: &'a Line<N>) -> Option<Self> {
        let o = Homogeneous { v: line.origin, w: Weight::One };
        let d = Homogeneous { v: line.direction, w: Weight::Zero };
        let (a, k, c, discriminant) = (form.of(d, d), form.of(o, d), form.of(o, o), form.discriminant(line));
        let (a_sign, discriminant_sign) = (a.sign()?, discriminant.sign()?);
        Some(Self { form, line, a, k, c, discriminant, a_sign, discriminant_sign })
    }

    #[inline(always)]
    pub(super) fn inside(&self) -> Option<Inside> {
        Some(match (self.a_sign, self.discriminant_sign) {
            (Ordering::Greater, Ordering::Less) => Inside::Nowhere,
            (Ordering::Greater, sign) => Inside::Between(sign == Ordering::Equal),
            (Ordering::Less, _) => Inside::Beyond,
            (Ordering::Equal, _) => match (self.k.sign()?, self.c.sign()?) {
                (Ordering::Less, _) => Inside::From,
                (Ordering::Greater, _) => Inside::Until,
                (Ordering::Equal, Ordering::Less) => Inside::Everywhere,
                (Ordering::Equal, Ordering::Equal) => Inside::InSurface,
                (Ordering::Equal, Ordering::Greater) => Inside::Nowhere,
            },
        })
    }

    /// How the end compares with another, which is no root.
    #[inline(always)]
    pub(super) fn order(&self, end: &End<N>, other: &End<N>) -> Option<Ordering> {
        // Seldom so close that approximately does not do.
        (end.t - other.t).sign().or_else(|| match other.place {
            Place::At(t) => self.order_for_certain(end.place, t),
            Place::First | Place::Second => None,
        })
    }

    /// How the place compares with the parameter `t`.
    #[inline(never)]
    fn order_for_certain(&self, place: Place<N>, t: Fraction<N>) -> Option<Ordering> {
        let second = match place {
            Place::At(own) => return own.order(t),
            Place::First => false,
            Place::Second => true,
        };
        // The point e (o + t d), and f and half its slope there, times e^2 and |e|.
        let along = |i: usize| self.line.origin[i] * t.e + self.line.direction[i] * t.n;
        let point = Homogeneous { v: [along(0), along(1), along(2)], w: Weight::By(t.e) };
        let f = self.form.of(point, point).sign()?;
        if self.a_sign == Ordering::Equal {
            // f = 2 k t + c: where it has the sign of k, the root has passed.
            return Some(times(f, self.k.sign()?).reverse());
        }
        // Downwards or upwards, f / a is a parabola that opens upwards.
        let f = times(f, self.a_sign);
        if f == Ordering::Less {
            return Some(if second { Ordering::Greater } else { Ordering::Less });
        }
        let slope = times(times((self.a * t.n + self.k * t.e).sign()?, t.e.sign()?), self.a_sign);
        Some(match (f, slope) {
            // t is the vertex, and a root: the only one.
            (_, Ordering::Equal) => Ordering::Equal,
            (Ordering::Greater, slope) => slope.reverse(),
            // t is the first root where f falls and the second where it rises.
            (_, Ordering::Less) => {
                if second {
                    Ordering::Greater
                } else {
                    Ordering::Equal
                }
            }
            (_, Ordering::Greater) => {
                if second {
                    Ordering::Equal
                } else {
                    Ordering::Less
                }
            }
        })
    }

    /// The roots in order; of a linear function its only one, twice.
    #[inline(always)]
    pub(super) fn ends(&self) -> [End<N>; 2] {
        let [first, second] = self.roots();
        let end = |place: Place<N>, t: N::Estimate| End { place, t, part: Part::Side };
        [end(Place::First, first), end(Place::Second, second)]
    }

    /// The roots' parameters, approximately.
    #[inline(always)]
    fn roots(&self) -> [N::Estimate; 2] {
        let ([a, k, c], discriminant) = N::together([self.a, self.k, self.c], self.discriminant);
        if self.a_sign == Ordering::Equal {
            return [(-c).over(k + k); 2];
        }
        let root =
            if self.discriminant_sign == Ordering::Greater { discriminant.square_root() } else { N::Estimate::ZERO };
        // -k and the root are added where they have one sign; the other root is c over that sum.
        let [lower, upper] = match k.sign() {
            Some(Ordering::Greater) => {
                let q = -k - root;
                [q.over(a), c.over(q)]
            }
            Some(Ordering::Less) => {
                let q = root - k;
                [c.over(q), q.over(a)]
            }
            // Next to nothing, or nothing: there is nothing to cancel.
            _ => [(-k - root).over(a), (root - k).over(a)],
        };
        if self.a_sign == Ordering::Greater { [lower, upper] } else { [upper, lower] }
    }
}

/// An end in the ray's own numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settled<S> {
    pub(super) t: S,
    pub(super) part: Part,
    pub(super) is_before_range: bool,
    pub(super) is_beyond_range: bool,
}

impl<S: Certain> Settled<S> {
    /// The same end, whose `t` is at least that of an end which comes before it: of two roots next to the same midpoint of
    /// two numbers, each may be rounded to the other's side.
    pub(super) fn not_before(self, earlier: Option<Self>) -> Self {
        match earlier {
            Some(earlier) if self.t < earlier.t => Self { t: earlier.t, ..self },
            _ => self,
        }
    }
}

/// An interval in the ray's own numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<S> {
    pub(super) enter: Option<Settled<S>>,
    pub(super) exit: Option<Settled<S>>,
    pub(super) touch: bool,
}

/// A number that stands for the scalars of one type.
pub(crate) trait Of<S: Certain>: Number<Estimate = S::Filter> + FromScalar<S> {}
impl<S: Certain, N: Number<Estimate = S::Filter> + FromScalar<S>> Of<S> for N {}

/// Settles an end: its `t`, and whether that lies in the range. `None` for `quadratic` where no end is one of its roots.
#[inline(always)]
pub(super) fn settle<S: Certain, N: Of<S>>(
    quadratic: Option<&Quadratic<'_, N>>,
    end: End<N>,
    range: Range<S>,
) -> Option<Settled<S>> {
    let compare = |bound: S| {
        (end.t - <S::Filter as FromScalar<S>>::scalar(bound)).sign().or_else(|| {
            let bound = Fraction { n: N::scalar(bound), e: N::ONE };
            match (end.place, quadratic) {
                (Place::At(t), _) => t.order(bound),
                (place, quadratic) => quadratic?.order_for_certain(place, bound),
            }
        })
    };
    let is_before_range = compare(range.start())? == Ordering::Less;
    let is_beyond_range = compare(range.end())? == Ordering::Greater;
    let t = if is_before_range {
        -S::INFINITY
    } else if is_beyond_range {
        S::INFINITY
    } else {
        S::rounded(end.t)?
    };
    Some(Settled { t, part: end.part, is_before_range, is_beyond_range })
}

/// Settles both ends.
#[inline(always)]
pub(super) fn piece<S: Certain, N: Of<S>>(
    quadratic: Option<&Quadratic<'_, N>>,
    interval: Interval<N>,
    range: Range<S>,
) -> Option<Piece<S>> {
    let settled = |end: Option<End<N>>| match end {
        None => Some(None),
        Some(end) => settle(quadratic, end, range).map(Some),
    };
    let (enter, exit) = (settled(interval.enter)?, settled(interval.exit)?);
    Some(Piece { enter, exit: exit.map(|exit| exit.not_before(enter)), touch: interval.touch })
}
