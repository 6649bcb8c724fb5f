//! Approximate roots of polynomials, whose number is known.
//!
//! From beyond the largest root Newton's method falls to it without passing it, if the function is convex from there
//! on. Where it may not be, an interval is known at whose ends the function has different signs, and a step that leaves
//! it is replaced by a step to its middle (Press et al., *Numerical Recipes*, 9.4; Yuksel, *High-Performance Polynomial
//! Root Finding for Graphics*, 2022). The other roots are those of the quotient.
//!
//! Coefficients are from the lowest power to the highest.

use crate::number::{Estimate, Number, Ring};
use core::cmp::Ordering;

/// More steps than any root takes that is not one of several close together.
const MOST_STEPS: usize = 40;

/// The simple roots of `x^4 + 2 p x^2 + 4 q x + s`, two or four, all of which are at most `most` in magnitude; `c` is
/// `p^2 - s`.
///
/// Ferrari's method: for a root `z` of `z^3 + 2 p z^2 + c z - 2 q^2` the equation is the difference of the squares of
/// `x^2 + p + z` and `w x - n`, with `w^2 = 2 z` and `n = 2 q / w`. The largest `z` is half the square of the largest
/// sum of two real roots, so that its two pairs of roots do not interleave.
#[inline(never)]
pub(super) fn of_quartic<E: Estimate>([p, q, c]: [E; 3], count: usize, most: E) -> [E; 4] {
    let is_left = q.sign() == Some(Ordering::Greater);
    let q = if is_left { q } else { -q };
    let twice = (q * q).scaled(1);
    let (resolvent, most) = ([-twice, c, p + p, E::ONE], (most * most).scaled(1));
    let z = match count {
        2 if twice.sign() == Some(Ordering::Equal) => E::ZERO,
        // Its other roots are not positive, or not real.
        2 => {
            let near = if c.sign() == Some(Ordering::Greater) { twice.over(c) } else { most };
            between(resolvent, [E::ZERO, near, most], None)
        }
        _ => fall(resolvent, most, None),
    };
    let w = root_or_zero(z + z);
    // Beside a small z the other difference does not cancel.
    let is_small = (z * z).scaled(8).compare(c) != Some(Ordering::Greater);
    let n =
        if is_small || w.sign() == Some(Ordering::Equal) { root_or_zero(c + z * (p + p + z)) } else { (q + q).over(w) };
    let (middle, square) = (w.scaled(-1), -(z.scaled(-1) + p));
    // Half the distance of the roots of each pair; if there are two roots, only the first pair is real.
    let [half, other] = [root_or_zero(square + n), if count == 2 { E::ZERO } else { root_or_zero(square - n) }];
    let (first, second) = ([-middle - half, half - middle], [middle - other, middle + other]);
    match (is_left, count) {
        (true, 2) => [first[0], first[1], first[1], first[1]],
        (false, 2) => [-first[1], -first[0], -first[0], -first[0]],
        (true, _) => [first[0], first[1], second[0], second[1]],
        (false, _) => [-second[1], -second[0], -first[1], -first[0]],
    }
}

fn root_or_zero<E: Estimate>(square: E) -> E {
    if square.sign() == Some(Ordering::Greater) { square.square_root() } else { E::ZERO }
}

/// The positive roots, at most three and simple, of a cubic whose highest coefficient is positive; none is above `most`.
#[inline(never)]
pub(super) fn of_cubic<E: Estimate>(coefficients: [E; 4], count: usize, [most, size]: [E; 2]) -> [E; 4] {
    if count < 2 {
        return [between(coefficients, [E::ZERO, most.scaled(-1), most], Some(size)); 4];
    }
    let last = fall(coefficients, most, Some(size));
    let [first, second] = of_quadratic(without_root(coefficients, last));
    if count == 2 { [second, last, last, last] } else { [first, second, last, last] }
}

/// The root next to zero of `f + 2 h x + a x^2` at which it increases, if it is an exit, or decreases.
pub(super) fn step<E: Estimate>([f, h, a]: [E; 3], is_exit: bool) -> E {
    let [rough_f, rough_h, rough_a] = [f, h, a].map(E::rough);
    let sign = if is_exit { Ordering::Greater } else { Ordering::Less };
    let (square, product) = (rough_h * rough_h, rough_a * rough_f);
    let is_ahead = rough_h.sign() == Some(sign);
    if is_ahead && is_below(product, square.scaled(-E::Rough::DIGITS / 2)) {
        return (-f).over(h + h);
    }
    let rest = E::sum([[h, h], [-a, f]]);
    let root = match (rest.sign(), rest.rough().sign()) {
        (Some(Ordering::Greater), _) | (None, Some(Ordering::Greater)) => rest.square_root(),
        (Some(_), _) => E::ZERO,
        // Zero, but for its error.
        (None, _) => (rest - E::exactly(rest.rough())).square_root(),
    };
    let slope = if is_exit { root } else { -root };
    // (slope - h) / a, or -f / (slope + h): whichever does not cancel.
    let [numerator, denominator] = if is_ahead { [-f, slope + h] } else { [slope - h, a] };
    if denominator.rough().sign() == Some(Ordering::Equal) { E::ZERO } else { numerator.over(denominator) }
}

/// True if the magnitude is not above the limit.
#[inline(always)]
pub(super) fn is_below<E: Estimate>(number: E, limit: E) -> bool {
    number.compare(limit) != Some(Ordering::Greater) && (-number).compare(limit) != Some(Ordering::Greater)
}

/// True if a step is so short that the one after it, which squares its relative error, would be of no interest.
#[inline(always)]
fn is_short<E: Estimate>(step: E, size: E) -> bool {
    is_below(step, size.scaled(2 - E::DIGITS / 2))
}

/// The value of a polynomial and its slope, by Horner's rule.
#[inline(always)]
fn value_and_slope<E: Estimate, const M: usize>(coefficients: [E; M], x: E) -> [E; 2] {
    let (mut value, mut slope) = (E::ZERO, E::ZERO);
    let mut i = M;
    while i > 0 {
        i -= 1;
        slope = slope * x + value;
        value = value * x + coefficients[i];
    }
    [value, slope]
}

/// The root that Newton's method falls to from `x`, with an error that is small relative to `size` or, without that, to
/// itself.
fn fall<E: Estimate, const M: usize>(coefficients: [E; M], mut x: E, size: Option<E>) -> E {
    for _ in 0..MOST_STEPS {
        let [value, slope] = value_and_slope(coefficients, x);
        if slope.sign() == Some(Ordering::Equal) {
            break;
        }
        let step = value.over(slope);
        let next = x - step;
        if is_short(step, size.unwrap_or(next)) || next.compare(x) == Some(Ordering::Equal) {
            return next;
        }
        x = next;
    }
    x
}

/// The only root between the first and the last of three numbers, at the last of which the function is positive; as
/// accurate as [`fall`]. It begins with the second, if that is between them.
fn between<E: Estimate, const M: usize>(coefficients: [E; M], [mut low, near, mut high]: [E; 3], size: Option<E>) -> E {
    let is_inside =
        |x: E, low: E, high: E| x.compare(low) == Some(Ordering::Greater) && x.compare(high) == Some(Ordering::Less);
    let mut x = if is_inside(near, low, high) { near } else { (low + high).scaled(-1) };
    for _ in 0..MOST_STEPS {
        let [value, slope] = value_and_slope(coefficients, x);
        if value.sign() == Some(Ordering::Less) {
            low = x;
        } else {
            high = x;
        }
        let newton = (slope.sign() != Some(Ordering::Equal)).then(|| x - value.over(slope));
        let next = newton.filter(|x| is_inside(*x, low, high)).unwrap_or_else(|| (low + high).scaled(-1));
        let step = next - x;
        if is_short(step, size.unwrap_or(next)) || step.sign() == Some(Ordering::Equal) {
            return next;
        }
        x = next;
    }
    x
}

/// A cubic divided by `x - root`.
#[inline(always)]
fn without_root<E: Estimate>([_, c, b, a]: [E; 4], root: E) -> [E; 3] {
    let linear = b + a * root;
    [c + linear * root, linear, a]
}

/// Both roots of a quadratic equation; if by rounding it has none, its vertex.
#[inline(always)]
fn of_quadratic<E: Estimate>([c, b, a]: [E; 3]) -> [E; 2] {
    let half = b.scaled(-1);
    let root = root_or_zero(half * half - a * c);
    [(-half - root).over(a), (root - half).over(a)]
}
