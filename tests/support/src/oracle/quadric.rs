//! A line in integers, and the pieces of it within a ball, an infinite cylinder or one nappe of a cone.
//!
//! The given numbers are brought to common powers of two first: one for lengths, one for directions. Then the
//! coefficients of `f(origin + t * direction)` are integers, and the textbook `k^2 - a c` is exact.

use dashu::integer::IBig;

use super::algebraic::Root;
use super::dyadic::{Dyadic, common_exponent, sign_of};
use super::solids::{Lateral, Line};

/// A closed interval of `t`; `None` where it has no end.
#[derive(Clone)]
pub(super) struct Interval {
    pub(super) enter: Option<Root>,
    pub(super) exit: Option<Root>,
}

pub(super) const EVERYWHERE: Interval = Interval { enter: None, exit: None };

impl Interval {
    pub(super) fn between(enter: Root, exit: Root) -> Self {
        Self { enter: Some(enter), exit: Some(exit) }
    }

    pub(super) fn from(enter: Root) -> Self {
        Self { enter: Some(enter), exit: None }
    }

    pub(super) fn until(exit: Root) -> Self {
        Self { enter: None, exit: Some(exit) }
    }
}

/// The piece of a line within a convex region.
pub(super) enum Overlap {
    Nothing,
    /// Within the region, and not all of it on the surface.
    Within(Interval),
    /// All of it on the surface.
    InSurface(Interval),
}

/// A line in units of powers of two: `t = t' * 2^exponent` for the `t'` that its integers give.
pub(super) struct IntegerLine {
    pub(super) origin: [IBig; 3],
    pub(super) direction: [IBig; 3],
    pub(super) length_unit: isize,
    pub(super) exponent: isize,
}

impl IntegerLine {
    pub(super) fn new(line: &Line, lengths: &[&Dyadic]) -> Self {
        let length_unit = common_exponent(line.origin.iter().chain(lengths.iter().copied()));
        let direction_unit = common_exponent(&line.direction);
        Self {
            origin: std::array::from_fn(|axis| line.origin[axis].in_units_of(length_unit)),
            direction: std::array::from_fn(|axis| line.direction[axis].in_units_of(direction_unit)),
            length_unit,
            exponent: length_unit - direction_unit,
        }
    }

    pub(super) fn length(&self, length: &Dyadic) -> IBig {
        length.in_units_of(self.length_unit)
    }

    pub(super) fn ratio(&self, numerator: IBig, denominator: &IBig) -> Root {
        Root::quotient(numerator, denominator.clone(), self.exponent)
    }

    /// Where the line is at the height; its `y` must change.
    pub(super) fn at_height(&self, height: &IBig) -> Root {
        self.ratio(height - &self.origin[1], &self.direction[1])
    }
}

/// `a t^2 + 2 k t + c`.
pub(super) struct Quadratic {
    pub(super) a: IBig,
    pub(super) k: IBig,
    pub(super) c: IBig,
}

impl Quadratic {
    pub(super) fn discriminant(&self) -> IBig {
        self.k.sqr().as_ibig() - &self.a * &self.c
    }

    /// The roots, the lower one first; none where they are not real. `a` must not be zero.
    pub(super) fn roots(&self, exponent: isize) -> Option<(Root, Root)> {
        let discriminant = self.discriminant();
        if sign_of(&discriminant) < 0 {
            return None;
        }
        let lower_sign = -sign_of(&self.a);
        let root = |sign, discriminant| Root::new(-&self.k, sign, discriminant, self.a.clone(), exponent);
        Some((root(lower_sign, discriminant.clone()), root(-lower_sign, discriminant)))
    }
}

/// The quadratic of the ball of the radius around `(0, height, 0)`.
pub(super) fn sphere(line: &IntegerLine, radius: &IBig, height: &IBig) -> Quadratic {
    let [x, y, z] = &line.origin;
    let [dx, dy, dz] = &line.direction;
    let y = &(y - height);
    Quadratic {
        a: dx * dx + dy * dy + dz * dz,
        k: x * dx + y * dy + z * dz,
        c: x * x + y * y + z * z - radius * radius,
    }
}

/// The piece of the line within the ball of the radius around `(0, height, 0)`.
pub(super) fn sphere_overlap(line: &IntegerLine, radius: &IBig, height: &IBig) -> Option<Interval> {
    let (enter, exit) = sphere(line, radius, height).roots(line.exponent)?;
    Some(Interval::between(enter, exit))
}

/// A line against a curved side: the quadratic of `(weight^2)(x^2 + z^2) - reach^2`, and the reach along the line,
/// `weight` times the radius, as `reach + t * reach_slope`.
pub(super) struct LateralLine {
    pub(super) quadratic: Quadratic,
    pub(super) reach: IBig,
    pub(super) reach_slope: IBig,
    pub(super) exponent: isize,
}

impl LateralLine {
    pub(super) fn new(line: &IntegerLine, lateral: &Lateral) -> Self {
        let offset = lateral.offset.scaled(-line.length_unit);
        let unit = common_exponent([&lateral.weight, &offset, &lateral.growth]);
        let weight = lateral.weight.in_units_of(unit);
        let growth = lateral.growth.in_units_of(unit);
        let [x, y, z] = &line.origin;
        let [dx, dy, dz] = &line.direction;
        let square = weight.sqr();
        let square = square.as_ibig();
        let reach = offset.in_units_of(unit) + &growth * y;
        let reach_slope = growth * dy;
        Self {
            quadratic: Quadratic {
                a: square * (dx * dx + dz * dz) - &reach_slope * &reach_slope,
                k: square * (x * dx + z * dz) - &reach * &reach_slope,
                c: square * (x * x + z * z) - &reach * &reach,
            },
            reach,
            reach_slope,
            exponent: line.exponent,
        }
    }

    /// Of a line parallel to a generator: where `2 k t + c` vanishes. `k` must not be zero.
    pub(super) fn single_root(&self) -> Root {
        Root::quotient(-&self.quadratic.c, &self.quadratic.k << 1, self.exponent)
    }

    /// Where `f <= 0` and the reach is not negative: an infinite cylinder, or one nappe.
    pub(super) fn one_nappe(&self) -> Overlap {
        let Quadratic { a, k, c } = &self.quadratic;
        let widening = sign_of(&self.reach_slope);
        match sign_of(a) {
            1 => {
                // Between the roots the reach keeps its sign, and it vanishes there at the apex only; so its sign
                // midway, at -k/a, tells the nappe.
                if sign_of(&(&self.reach * a - &self.reach_slope * k)) < 0 {
                    return Overlap::Nothing;
                }
                match self.quadratic.roots(self.exponent) {
                    None => Overlap::Nothing,
                    Some((enter, exit)) => Overlap::Within(Interval::between(enter, exit)),
                }
            }
            -1 => {
                // Steeper than the side: outside there is one bounded gap, with a nappe at either end of it.
                let (lower, upper) =
                    self.quadratic.roots(self.exponent).expect("a line that runs within a nappe meets it");
                Overlap::Within(if widening > 0 { Interval::from(upper) } else { Interval::until(lower) })
            }
            _ => match (sign_of(k), widening) {
                (0, 0) => match sign_of(c) {
                    -1 => Overlap::Within(EVERYWHERE),
                    0 => Overlap::InSurface(EVERYWHERE),
                    _ => Overlap::Nothing,
                },
                (0, _) if !c.is_zero() => Overlap::Nothing,
                (0, _) => {
                    let apex = Root::quotient(-&self.reach, self.reach_slope.clone(), self.exponent);
                    Overlap::InSurface(if widening > 0 { Interval::from(apex) } else { Interval::until(apex) })
                }
                (-1, 1) => Overlap::Within(Interval::from(self.single_root())),
                (1, -1) => Overlap::Within(Interval::until(self.single_root())),
                _ => Overlap::Nothing,
            },
        }
    }
}
