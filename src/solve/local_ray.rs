//! A ray in a primitive's frame.

use super::end::Of;
use crate::line::{Needs, Place};
use crate::number::word::Word;
use crate::number::{Bounded, Doubled, Filtered, Guarded, Integer, Limbs, Number, Plain, Running};
use crate::part::Part;
use crate::ray::{Leaving, Ray};
use crate::scalar::{FromScalar, Real, RealOf, Scalar};

/// A ray in a primitive's frame. Its direction may have any length, since `t` is the parameter of the ray as stored.
#[derive(Clone, Copy, Debug)]
pub struct LocalRay<N: Number> {
    pub(crate) origin: [N; 3],
    pub(crate) direction: [N; 3],
    /// The part that it departs from at `t = 0`, and the side to which it departs.
    pub(super) departure: Option<(Part, Leaving)>,
    /// The ray's `t` at the origin, if that was moved.
    pub(crate) start: Option<N::Estimate>,
    /// The same as a number; zero if the origin was not moved.
    pub(crate) moved: N,
    /// The square of the direction's length is 1 within 2^-19.
    pub(crate) is_unit: bool,
}

impl<N: Number> LocalRay<N> {
    /// The ray from its own start.
    #[inline(always)]
    pub(super) const fn new([origin, direction]: [[N; 3]; 2], departure: Option<(Part, Leaving)>) -> Self {
        Self { origin, direction, departure, start: None, moved: N::ZERO, is_unit: false }
    }

    /// True if it departs from a part.
    #[inline(always)]
    pub(super) fn departs(&self) -> bool {
        N::DEPARTS && self.departure.is_some()
    }

    /// True if it departs from this part.
    #[inline(always)]
    pub(super) fn departs_from(&self, part: Part) -> bool {
        N::DEPARTS && self.departure.is_some_and(|(from, _)| from == part)
    }

    /// True if it departs outwards.
    #[inline(always)]
    pub(super) fn leads_outwards(&self) -> bool {
        N::DEPARTS && self.departure.is_some_and(|(_, leaving)| leaving == Leaving::Outwards)
    }

    /// The same ray in [`Number::Long`].
    #[inline(always)]
    pub(super) fn long(&self) -> LocalRay<N::Long> {
        let [origin, direction] = [self.origin, self.direction].map(|v| v.map(N::long));
        let Self { departure, start, is_unit, .. } = *self;
        LocalRay { origin, direction, departure, start, moved: self.moved.long(), is_unit }
    }

    /// The square of the distance by which the origin was moved, times `2^e`.
    #[inline(always)]
    pub(super) fn far(&self, e: i32) -> N {
        (self.moved * self.moved).scaled(e)
    }
}

/// A number in which rays are transformed into a primitive's frame.
pub trait Localize<S: Scalar>: Of<S> {
    /// The ray in the frame of `place`. A number of limited precision moves the origin to the point closest to the
    /// frame's, since errors grow with the distance of the origin.
    #[inline(always)]
    fn local_ray<P: Place<S>>(
        place: &P,
        ray: &Ray<S>,
        needs: Needs,
        departure: Option<(Part, Leaving)>,
    ) -> LocalRay<Self> {
        LocalRay::new(unmoved(place, ray, needs), departure)
    }
}

/// Origin and direction, rounded by the operations of the number.
#[inline(always)]
fn unmoved<S: Scalar, N: FromScalar<S>, P: Place<S>>(place: &P, ray: &Ray<S>, needs: Needs) -> [[N; 3]; 2] {
    match needs {
        Needs::Translation => place.ball_line(ray),
        Needs::Height => {
            let [y, dy] = place.height_line(ray);
            [[N::ZERO, y, N::ZERO], [N::ZERO, dy, N::ZERO]]
        }
        Needs::Flat | Needs::All => place.line(ray),
    }
}

impl<S: Scalar, W: Word> Localize<S> for Limbs<W> where Self: Of<S> {}

impl<S: Scalar, W: Word> Localize<S> for Bounded<W> {}

impl<S: Scalar, const N: usize> Localize<S> for Integer<N> where Self: Of<S> {}

#[cfg(feature = "libm")]
impl<S: Scalar> Localize<S> for Filtered {}

/// The ray in the frame, transformed in double-words and rounded to values with bounds of their errors. Its origin is
/// moved to the point closest to the position, since errors grow with the distance of the origin.
#[inline(always)]
pub(crate) fn rounded_ray<S: Scalar, R: RealOf<S>, P: Place<S>>(
    place: &P,
    ray: &Ray<S>,
    needs: Needs,
    departure: Option<(Part, Leaving)>,
) -> LocalRay<Running<R>> {
    if matches!(needs, Needs::Height) {
        let line = unmoved::<S, Doubled<R>, P>(place, ray, needs).map(|vector| vector.map(Doubled::rounded));
        return LocalRay { is_unit: !P::STRETCHES, ..LocalRay::new(line, departure) };
    }
    let ([ox, oy, oz], d) = (ray.origin().to_array().map(R::of), ray.direction().to_array().map(R::of_unit));
    let [px, py, pz] = place.position().map_or([R::ZERO; 3], |position| position.to_array().map(R::of));
    let from @ [x, y, z] = [Doubled::difference(ox, px), Doubled::difference(oy, py), Doubled::difference(oz, pz)];
    let direction @ [dx, dy, dz] = d.map(Doubled::exact);
    let is_moved = departure.is_none();
    let k = if is_moved { -((ox - px) * d[0] + (oy - py) * d[1] + (oz - pz) * d[2]) } else { R::ZERO };
    let step = Doubled::exact(k);
    let near = if is_moved { [x + step * dx, y + step * dy, z + step * dz] } else { from };
    let is_translated = matches!(needs, Needs::Translation) && !P::STRETCHES;
    let [origin, direction] =
        if is_translated { [near, direction] } else { [place.linear(near), place.linear(direction)] };
    let moved = Running::exact(k);
    LocalRay {
        origin: origin.map(Doubled::rounded),
        direction: direction.map(Doubled::rounded),
        departure,
        start: is_moved.then_some(moved),
        moved,
        is_unit: !P::STRETCHES,
    }
}

/// A number that consists of a real number and perhaps a bound of its error in roundings.
trait Approximate: Number {
    /// The real number.
    type Real;
    /// True if it knows its error: then the origin is moved so that the error does not grow with the distance.
    const KNOWS_ERROR: bool = false;
    fn approximate(value: Self::Real, error: Self::Real) -> Self;
}

impl<R: Real> Approximate for Plain<R> {
    type Real = R;
    #[inline(always)]
    fn approximate(value: R, _: R) -> Self {
        Self(value)
    }
}

impl<R: Real, const STABLE: bool> Approximate for Guarded<R, STABLE> {
    type Real = R;
    #[inline(always)]
    fn approximate(value: R, _: R) -> Self {
        Self(Plain(value))
    }
}

impl<R: Real, const STABLE: bool> Approximate for Running<R, STABLE> {
    type Real = R;
    const KNOWS_ERROR: bool = true;
    #[inline(always)]
    fn approximate(value: R, error: R) -> Self {
        Self { value, error }
    }
}

/// A ray whose origin is moved to the point closest to the position of the placement, in real numbers, with bounds of
/// their errors in roundings.
///
/// With `f = o - p`, `k = -f . d` and `n = f + k d`, in which each operation is rounded, a coordinate of `n` has an
/// error of at most `2 |k d_i| + 2 |n_i|` roundings, since `|f_i| <= |n_i| + |k d_i|`. (The `k` that was computed is
/// taken as it is.) A number that knows its error takes a `k` of half the bits, with which the products of both halves
/// of `d_i` are exact, and adds the rounding error of `f_i`: what remains is at most `2 |n_i| + 2^-10 |k|`. That leaves
/// half as many rays near a cylinder to the next method. (It gains nothing for flat parts.)
///
/// A row of a rotation makes of the first at most `2 |k| + 2 |n|`, and its own products and sums add `3 |n|`; they add
/// 3 to the direction's coordinates. (`|n|` is at most the sum of its coordinates' magnitudes.) An affine map is
/// computed in numbers that know their error.
#[inline(always)]
fn moved<S: Scalar, R: RealOf<S>, N: Approximate<Real = R> + FromScalar<S>, P: Place<S>>(
    place: &P,
    ray: &Ray<S>,
    needs: Needs,
    departure: Option<(Part, Leaving)>,
) -> LocalRay<N> {
    if matches!(needs, Needs::Height) {
        return LocalRay { is_unit: !P::STRETCHES, ..LocalRay::new(unmoved(place, ray, needs), departure) };
    }
    let [o, d] = [ray.origin().to_array().map(R::of), ray.direction().to_array().map(R::of_unit)];
    let position = place.position();
    // Blocks have so many bits that the origin stays.
    let is_flat = matches!(needs, Needs::Flat);
    let is_moved = departure.is_none() && R::IS_FLOAT && !(is_flat && P::IS_WORLD);
    let is_exact = is_moved && N::KNOWS_ERROR && !is_flat && size_of::<R>() == size_of::<S>();
    let [[x, x_rest], [y, y_rest], [z, z_rest]] = match position {
        Some(position) => {
            let p = position.to_array().map(R::of);
            let apart = |i: usize| if is_exact { o[i].plus_with_rest(-p[i]) } else { [o[i] - p[i], R::ZERO] };
            [apart(0), apart(1), apart(2)]
        }
        None => o.map(|c| [c, R::ZERO]),
    };
    let k = if is_moved { -(x * d[0] + y * d[1] + z * d[2]) } else { R::ZERO };
    let k = if is_exact { k.split()[0] } else { k };
    let moved = |from: R, rest: R, d: R| {
        if is_exact {
            let [high, low] = d.split();
            (from + k * high) + if position.is_some() { k * low + rest } else { k * low }
        } else if is_moved {
            from + k * d
        } else {
            from
        }
    };
    let near = [moved(x, x_rest, d[0]), moved(y, y_rest, d[1]), moved(z, z_rest, d[2])];
    let around = near[0].abs() + near[1].abs() + near[2].abs();
    let translated = if is_exact {
        k.abs().scaled(-10) + around.scaled(1)
    } else if is_moved && position.is_some() {
        k.abs().scaled(1) + around.scaled(1)
    } else if is_moved {
        k.abs() + around
    } else if position.is_some() {
        around
    } else {
        R::ZERO
    };
    let is_turned = position.is_some() && (P::STRETCHES || !matches!(needs, Needs::Translation));
    let [origin, direction] = if !is_turned {
        [near.map(|c| N::approximate(c, translated)), d.map(|c| N::approximate(c, R::ZERO))]
    } else if P::STRETCHES {
        let near = near.map(|c| N::approximate(c, translated));
        [place.linear::<N>(near), place.linear::<N>(d.map(|c| N::approximate(c, R::ZERO)))]
    } else {
        let turned = translated + around + around.scaled(1);
        let three = R::ONE + R::ONE.scaled(1);
        let rotated = |v: [R; 3]| place.linear::<Plain<R>>(v.map(Plain)).map(|c| c.0);
        [rotated(near).map(|c| N::approximate(c, turned)), rotated(d).map(|c| N::approximate(c, three))]
    };
    let moved = if is_moved { N::approximate(k, R::ZERO) } else { N::ZERO };
    let start = is_moved.then(|| moved.estimate());
    LocalRay { origin, direction, departure, start, moved, is_unit: !P::STRETCHES }
}

impl<S: Scalar, N: Approximate<Real: RealOf<S>> + Of<S>> Localize<S> for N {
    #[inline(always)]
    fn local_ray<P: Place<S>>(
        place: &P,
        ray: &Ray<S>,
        needs: Needs,
        departure: Option<(Part, Leaving)>,
    ) -> LocalRay<Self> {
        moved(place, ray, needs, departure)
    }
}
