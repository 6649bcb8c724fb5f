//! A line against a torus: the real roots of a polynomial of the fourth degree, isolated by Sturm's theorem.
//!
//! A root is answered as a rational within 2^-220 of the line's largest root, and exactly where it is dyadic with at
//! most 120 bits: only such a root can be equal to a machine number.

use std::cmp::Ordering;

use dashu::base::BitTest;

use super::algebraic::Root;
use super::departing::{self, Leaving};
use super::dyadic::{Dyadic, shifted};
use super::solids::{Line, Part, dot};
use super::solve::{Answer, End, Span};

/// The bits below the bound of all roots to which a root is isolated, and those of a root that is taken to be exact.
const BITS: isize = 240;
const FEW_BITS: isize = 120;

/// Coefficients from the lowest power to the highest, which is not zero.
type Polynomial = Vec<Dyadic>;

fn sum(terms: &[Dyadic]) -> Dyadic {
    terms.iter().fold(Dyadic::zero(), |sum, term| &sum + term)
}

/// `S = |p|^2 - R^2 - r^2` at a point.
fn power([major, minor]: [&Dyadic; 2], point: &[Dyadic; 3]) -> Dyadic {
    &dot(point, point) - &(&major.squared() + &minor.squared())
}

/// `f = S^2 + 4 R^2 (y^2 - r^2)` at a point, negative inside.
pub(super) fn value(radii @ [major, minor]: [&Dyadic; 2], point: &[Dyadic; 3]) -> Dyadic {
    let beyond = &point[1].squared() - &minor.squared();
    &power(radii, point).squared() + &(&major.squared().scaled(2) * &beyond)
}

/// Half the gradient of `f`.
pub(super) fn gradient(radii: [&Dyadic; 2], point: &[Dyadic; 3]) -> [Dyadic; 3] {
    let twice = power(radii, point).scaled(1);
    let along = &radii[0].squared().scaled(2) * &point[1];
    let [x, y, z] = point.each_ref().map(|c| c * &twice);
    [x, &y + &along, z]
}

/// `f` along the line.
fn along_line(radii @ [major, minor]: [&Dyadic; 2], line: &Line) -> Polynomial {
    let (o, d) = (&line.origin, &line.direction);
    let (a, b, c) = (dot(d, d), dot(o, d).scaled(1), power(radii, o));
    let four = major.squared().scaled(2);
    vec![
        &c.squared() + &(&four * &(&o[1].squared() - &minor.squared())),
        (&(&b * &c) + &(&four * &(&o[1] * &d[1]))).scaled(1),
        sum(&[b.squared(), (&a * &c).scaled(1), &four * &d[1].squared()]),
        (&a * &b).scaled(1),
        a.squared(),
    ]
}

fn at(polynomial: &[Dyadic], x: &Dyadic) -> Dyadic {
    polynomial.iter().rev().fold(Dyadic::zero(), |value, coefficient| &(&value * x) + coefficient)
}

fn derivative(polynomial: &[Dyadic]) -> Polynomial {
    (1..).zip(&polynomial[1..]).map(|(power, coefficient)| &Dyadic::from(power) * coefficient).collect()
}

/// The negative remainder of a division, times a positive number; empty if it is zero.
fn negative_remainder(dividend: &[Dyadic], divisor: &[Dyadic]) -> Polynomial {
    let lead = divisor.last().expect("the divisor is not zero");
    let mut rest = dividend.to_vec();
    while rest.len() >= divisor.len() {
        let factor = lead * rest.last().expect("it is as long as the divisor");
        let shift = rest.len() - divisor.len();
        rest = rest.iter().map(|coefficient| coefficient * &lead.squared()).collect();
        for (index, coefficient) in divisor.iter().enumerate() {
            rest[index + shift] = &rest[index + shift] - &(&factor * coefficient);
        }
        rest.pop();
        while rest.last().is_some_and(Dyadic::is_zero) {
            rest.pop();
        }
    }
    rest.iter().map(|coefficient| -coefficient).collect()
}

/// A polynomial with its Sturm chain.
struct Chain(Vec<Polynomial>);

impl Chain {
    fn new(polynomial: &[Dyadic]) -> Self {
        let mut chain = vec![polynomial.to_vec(), derivative(polynomial)];
        loop {
            let rest = negative_remainder(&chain[chain.len() - 2], &chain[chain.len() - 1]);
            if rest.is_empty() {
                return Self(chain);
            }
            chain.push(rest);
        }
    }

    /// How often signs change at a number that is not a root.
    fn changes(&self, x: &Dyadic) -> usize {
        let signs: Vec<i8> = self.0.iter().map(|member| at(member, x).signum()).filter(|sign| *sign != 0).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    fn value(&self, x: &Dyadic) -> Dyadic {
        at(&self.0[0], x)
    }

    /// A number near the middle of an interval that is not a root.
    fn middle(&self, low: &Dyadic, high: &Dyadic) -> Dyadic {
        let width = high - low;
        let candidates =
            (1..).map(|bits| &(&(low + high).scaled(-1) + &width.scaled(-2 - bits)) - &width.scaled(-3 - bits));
        let middle = Some((low + high).scaled(-1)).into_iter().chain(candidates);
        middle.into_iter().find(|x| !self.value(x).is_zero()).expect("there are few roots")
    }

    /// Intervals with one root each, in order, whose ends are no roots.
    fn isolated(&self, [low, high]: [&Dyadic; 2]) -> Vec<[Dyadic; 2]> {
        match self.changes(low).saturating_sub(self.changes(high)) {
            0 => vec![],
            1 => vec![[low.clone(), high.clone()]],
            _ => {
                let middle = self.middle(low, high);
                let mut all = self.isolated([low, &middle]);
                all.extend(self.isolated([&middle, high]));
                all
            }
        }
    }

    /// The root in such an interval, to this unit.
    fn root(&self, [mut low, mut high]: [Dyadic; 2], bound: isize) -> Root {
        let unit = Dyadic::power_of_two(bound - BITS);
        let rises = self.value(&high).signum();
        let crosses = self.value(&low).signum() != rises;
        let mut steps = 0;
        while &high - &low > unit {
            if crosses
                && steps == 40
                && let Some(root) = self.by_newton([&low, &high], rises, bound)
            {
                return self.few_bits(&root, bound);
            }
            steps += 1;
            let middle = self.middle(&low, &high);
            let is_above = if crosses {
                self.value(&middle).signum() == rises
            } else {
                self.changes(&low) != self.changes(&middle)
            };
            if is_above {
                high = middle;
            } else {
                low = middle;
            }
        }
        self.few_bits(&(&low + &high).scaled(-1), bound)
    }

    /// The root by Newton's method, if its result proves to be next to it.
    fn by_newton(&self, [low, high]: [&Dyadic; 2], rises: i8, bound: isize) -> Option<Dyadic> {
        let mut x = (low + high).scaled(-1);
        for bits in [70, 120, 200, 300, BITS + 20] {
            let (value, slope) = (self.value(&x), at(&self.0[1], &x));
            if slope.is_zero() {
                return None;
            }
            x = cut(&(&x - &quotient(&value, &slope, bound - bits)), bound - bits);
        }
        let doubt = Dyadic::power_of_two(bound - BITS);
        let [below, above] = [&x - &doubt, &x + &doubt];
        let is_proved = self.value(&above).signum() == rises && self.value(&below).signum() == -rises;
        (is_proved && *low < below && above < *high).then_some(x)
    }

    /// A root with few bits next to `x`, or `x`.
    fn few_bits(&self, x: &Dyadic, bound: isize) -> Root {
        let unit = bound - FEW_BITS;
        let short = cut(&(x + &Dyadic::power_of_two(unit - 1)), unit);
        let is_root = self.value(&short).is_zero() && (&short - x).magnitude() < Dyadic::power_of_two(bound - BITS + 4);
        Root::from(if is_root { &short } else { x })
    }
}

/// The number rounded down to a multiple of `2^unit`.
fn cut(x: &Dyadic, unit: isize) -> Dyadic {
    if x.exponent >= unit { x.clone() } else { Dyadic::new(shifted(&x.mantissa, x.exponent - unit), unit) }
}

/// `a / b`, to a multiple of `2^unit`.
fn quotient(a: &Dyadic, b: &Dyadic, unit: isize) -> Dyadic {
    let shift = a.exponent - b.exponent - unit;
    Dyadic::new(shifted(&a.mantissa, shift) / &b.mantissa, unit)
}

/// The exponent of a power of two above the magnitude of every root (Fujiwara 1916).
fn bound(polynomial: &[Dyadic]) -> isize {
    let size = |number: &Dyadic| number.mantissa.bit_len() as isize + number.exponent;
    let lead = size(polynomial.last().expect("it is not zero"));
    let lower = polynomial.iter().rev().skip(1).zip(1..).filter(|(coefficient, _)| !coefficient.is_zero());
    2 + lower.map(|(coefficient, power)| (size(coefficient) - lead + 1).div_euclid(power) + 1).max().unwrap_or(0)
}

/// The real roots where the polynomial changes its sign or has the value zero and positive ones beside it, and its sign
/// after each.
fn roots(polynomial: &[Dyadic]) -> Vec<(Root, i8)> {
    let (chain, bound) = (Chain::new(polynomial), bound(polynomial));
    let high = Dyadic::power_of_two(bound);
    let isolated = chain.isolated([&-&high, &high]);
    let signs = isolated.iter().map(|[low, high]| [chain.value(low).signum(), chain.value(high).signum()]);
    let signs: Vec<_> = signs.collect();
    let counted = isolated.into_iter().zip(signs).filter(|(_, signs)| *signs != [-1, -1]);
    counted.map(|(interval, [_, after])| (chain.root(interval, bound), after)).collect()
}

/// The pieces between roots where the polynomial is not positive, for a line that is inside before the first root, or
/// outside.
fn spans(roots: Vec<(Root, i8)>, starts_inside: bool) -> Vec<Span> {
    let end = |t: Root| Some(End { t, part: Part::Side });
    let mut spans = Vec::new();
    let mut open = starts_inside.then_some(None);
    for (root, after) in roots {
        match (open.take(), after) {
            (Some(enter), _) => spans.push(Span { enter, exit: end(root) }),
            (None, -1) => open = Some(end(root)),
            (None, _) => spans.push(Span { enter: end(root.clone()), exit: end(root) }),
        }
    }
    spans
}

/// Where the line meets the torus of these radii.
pub(super) fn solve(radii: [&Dyadic; 2], line: &Line) -> Answer {
    Answer::Spans(spans(roots(&along_line(radii, line)), false))
}

/// Where a line that departs from the torus meets it again. The start is a root, whatever its coordinates say: the
/// value there is zero, and the others are those of the quotient by `t`.
pub(super) fn departing(radii: [&Dyadic; 2], line: &Line, leaving: Leaving) -> Answer {
    let quotient = &along_line(radii, line)[1..];
    // Beside the start, which may be a root of the quotient too.
    let zeros = quotient.iter().take_while(|coefficient| coefficient.is_zero()).count();
    let starts_inside = quotient[zeros].signum() < 0;
    let quotient = &quotient[zeros..];
    let ahead = if quotient.len() > 1 { roots(quotient) } else { vec![] };
    let ahead = ahead.into_iter().filter(|(root, _)| root.cmp_dyadic(&Dyadic::zero()) == Ordering::Greater);
    let mut all = spans(ahead.collect(), starts_inside).into_iter();
    let first = if starts_inside { all.next().and_then(|span| span.exit) } else { None };
    match leaving {
        Leaving::Outwards => Answer::Spans(all.collect()),
        Leaving::Inwards => match departing::inwards(Some(first.unwrap_or_else(|| departing::start(Part::Side)))) {
            Answer::Spans(first) => Answer::Spans(first.into_iter().chain(all).collect()),
            answer => answer,
        },
    }
}
