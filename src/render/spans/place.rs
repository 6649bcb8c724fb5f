//! Where in a picture balls and their shadows may be seen.
//!
//! Away from the light, along `w`, the shadow of the ball of radius `r` about `c` is the balls about `c + d w` with the
//! radii `r + g d`, for `d >= 0`: in a light at `l` the growth `g` is `r / |c - l|`, and in a distant one it is 0.
//! Between two values of `d` they fill the convex hull of the two balls there; for infinite `d` the last one is seen as
//! the ball of radius `g` about `w`. A plane through the eye touches both balls if its normal `n`, of length 1, has
//! `n . c = r` for each; then every point `p` of the hull has `n . p >= 0`.

use crate::number::dot;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{BallInWorld, Light, Raster, Size};
use crate::vector::{UnitVec3, Vec3, cross, pairs};

/// Where something may be seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// The first row, and the one after the last.
    rows: [u16; 2],
    /// The same of columns.
    columns: [u16; 2],
    /// In the first row and in the last: no column before these may see it, and none after those. Between rows that
    /// changes evenly.
    edges: [[i16; 2]; 2],
}

/// Edges are less than `2^EDGE`.
const EDGE: i32 = 14;

/// No edge on the left, and none on the right.
const NONE: [[i16; 2]; 2] = [[i16::MIN >> 1; 2], [i16::MAX >> 1; 2]];

impl Place {
    /// All of a picture.
    pub(super) const fn all(Size { width, height, .. }: Size) -> Self {
        Self { rows: [0, height], columns: [0, width], edges: NONE }
    }

    /// Where the shadow of a ball may be seen: on what is in another one, if there is one, and before a plane, if there
    /// is one, which shades all that is behind it.
    pub(super) fn of<S: Scalar>(
        raster: &Raster<S>,
        ball: BallInWorld<S>,
        light: &Light<S>,
        on: Option<BallInWorld<S>>,
        plane: Option<(Vec3<S>, UnitVec3<S>)>,
    ) -> Self {
        let all = Self::all(raster.size());
        match shadow(raster, ball, light, on, plane) {
            Hull::Nothing => Self { rows: [0; 2], ..all },
            Hull::Unknown => all,
            Hull::Of(ends) => all.seen(&ends, raster),
        }
    }

    /// The first column that may see a ball, and the one after the last.
    pub(super) fn columns_of<S: Scalar>(raster: &Raster<S>, ball: BallInWorld<S>) -> [u16; 2] {
        let (width, ball) = (raster.size().width, sphere(raster, ball));
        let Some((half, (centre, radius))) = raster.half_a_pixel().zip(ball) else { return [0, width] };
        columns_of(&[End::<S>::new(centre, radius)], half, width)
    }

    /// True if no row may see it.
    pub(super) const fn is_nowhere(&self) -> bool {
        self.rows[0] >= self.rows[1] || self.columns[0] >= self.columns[1]
    }

    /// The columns of row `y` that may see it: the first one, and the one after the last.
    pub(super) fn columns(&self, y: u16) -> Option<[u16; 2]> {
        let ([first, end], [from, until]) = (self.rows, self.columns);
        if y < first || y >= end {
            return None;
        }
        let [left, right] = self.edges.map(|[start, last]| {
            let [start, last, rows] = [start.into(), last.into(), i32::from(end - 1 - first)];
            start + ((last - start) * i32::from(y - first)).checked_div(rows).unwrap_or(0)
        });
        let columns = [left.max(from.into()), right.min(until.into())];
        (columns[0] < columns[1]).then_some(columns.map(|column| column as u16))
    }

    /// Where the hull of two balls is seen.
    fn seen<S: Scalar>(self, ends: &[End<S>; 2], raster: &Raster<S>) -> Self {
        let (Some(half), Size { width, height, .. }) = (raster.half_a_pixel(), raster.size()) else { return self };
        let columns = columns_of(ends, half, width);
        let [first, end] = extent(ends, 0, |[_, y, z]| crossing::<S>([y, z], half, height), height);
        let rows = [height - end, height - first];
        let mut edges = NONE;
        let heights = [rows[0], rows[1].saturating_sub(1)];
        let heights = heights.map(|y| S::Real::from_int(i32::from(height) - 1 - 2 * i32::from(y)) * half);
        for [x, y, z] in tangents(ends).into_iter().flatten() {
            let [[left, right], [last_left, last_right]] = heights.map(|v| crossing::<S>([x, y * v + z], half, width));
            for (kept, edge) in edges.iter_mut().zip([[left, last_left], [right, last_right]]) {
                if edge.into_iter().all(|end| end.abs() < 1 << EDGE) {
                    *kept = edge.map(|end| end as i16);
                }
            }
        }
        Self { rows, columns, edges }
    }
}

/// A ball as seen from the eye: how far it is to the right, upwards and forwards, and its radius, in any unit.
#[derive(Clone, Copy, Debug)]
struct End<S: Scalar> {
    centre: [S::Real; 3],
    radius: S::Real,
}

impl<S: Scalar> End<S> {
    /// Larger by what rounding may turn a plane that touches it.
    fn new(centre: [S::Real; 3], radius: S::Real) -> Self {
        Self { centre, radius: radius + dot(centre, centre).sqrt().scaled(-10) }
    }
}

/// What a shadow fills.
#[derive(Clone, Copy, Debug)]
enum Hull<S: Scalar> {
    Nothing,
    Unknown,
    Of([End<S>; 2]),
}

/// The part of the shadow of a ball that is before a plane, and within another ball.
fn shadow<S: Scalar>(
    raster: &Raster<S>,
    ball: BallInWorld<S>,
    light: &Light<S>,
    on: Option<BallInWorld<S>>,
    plane: Option<(Vec3<S>, UnitVec3<S>)>,
) -> Hull<S> {
    let (zero, one, axes) = (S::Real::ZERO, S::Real::ONE, raster.axes().map(UnitVec3::real));
    let turned = |v: [S::Real; 3]| axes.map(|axis| dot(axis, v));
    let minus = |v: [S::Real; 3], from: [S::Real; 3]| pairs(v, from).map(|(v, from)| v - from);
    let from_eye = |point: Vec3<S>| seen_from_eye(raster, point);
    let Some((c, r)) = sphere(raster, ball) else { return Hull::Unknown };
    let towards = if light.distant { turned(light.position.real()) } else { minus(from_eye(light.position), c) };
    let far = dot(towards, towards).sqrt();
    let Some(w) = UnitVec3::<S>::from_real(towards).map(|towards| towards.real().map(|c| -c)) else {
        return Hull::Unknown;
    };
    let g = if light.distant { zero } else { r / far };
    // Of a light within the ball, or next to it, no shadow is known.
    if g > one - one.scaled(-4) {
        return Hull::Unknown;
    }
    let (mut first, mut last) = (zero, None);
    if let Some((b, s)) = on.and_then(|on| sphere(raster, on)) {
        // A ball of the shadow meets this one: |d - (b - c) . w| <= r + g d + s.
        let (along, reach) = (dot(minus(b, c), w), r + s);
        if along > reach {
            first = (along - reach) / (one + g);
        }
        last = Some((along + reach) / (one - g));
    }
    if let Some((point, normal)) = plane {
        let (on, normal) = (from_eye(point), turned(normal.real()));
        let of_light = dot(if light.distant { towards } else { minus(from_eye(light.position), on) }, normal);
        let upwards = |height: S::Real| if of_light.is_negative() { -height } else { height };
        // A ball of the shadow reaches up to the plane: h + d (w . n) >= -(r + g d).
        let (height, fall) = (upwards(dot(minus(c, on), normal)) + r, -upwards(dot(w, normal)) - g);
        if !of_light.is_zero() && fall > one.scaled(-8) {
            let deepest = height / fall;
            last = Some(last.filter(|last| *last < deepest).unwrap_or(deepest));
        }
    }
    let at = |d: S::Real| End::new(pairs(c, w).map(|(c, w)| c + w * d), r + g * d);
    match last {
        Some(last) if last < first => Hull::Nothing,
        Some(last) => Hull::Of([at(first), at(last)]),
        None => Hull::Of([at(first), End::new(w, g)]),
    }
}

/// How far a point is to the right of the eye, above it and in front of it.
fn seen_from_eye<S: Scalar>(raster: &Raster<S>, point: Vec3<S>) -> [S::Real; 3] {
    let from_eye = pairs(point.real(), raster.camera().position().real()).map(|(point, eye)| point - eye);
    raster.axes().map(|axis| dot(axis.real(), from_eye))
}

/// The centre of a ball from the eye, and a radius that rounding cannot exceed; `None` if the square of the radius has
/// no digits, as that of a tiny float.
fn sphere<S: Scalar>(raster: &Raster<S>, (centre, legs): BallInWorld<S>) -> Option<([S::Real; 3], S::Real)> {
    let legs = legs.map(S::real);
    let square = dot(legs, legs);
    let radius = square.sqrt();
    (square > S::Real::SMALLEST.scaled(24)).then(|| (seen_from_eye(raster, centre), radius + radius.scaled(-8)))
}

/// The normals of the two planes through the eye that touch both balls, if the angle between these is not too small,
/// and neither is seen within the other.
fn tangents<S: Scalar>(ends: &[End<S>; 2]) -> Option<[[S::Real; 3]; 2]> {
    let one = S::Real::ONE;
    let [(a, r), (b, s)] = ends.map(|End { centre, radius }| {
        let length = dot(centre, centre).sqrt();
        let by = if length.is_zero() { length } else { one / length };
        (centre.map(|c| c * by), radius * by)
    });
    let (along, across) = (dot(a, b), cross(a, b));
    let square = dot(across, across);
    if square < one.scaled(-12) {
        return None;
    }
    // n = x a + y b + z (a x b), with n . a = r and n . b = s.
    let (x, y) = ((r - s * along) / square, (s - r * along) / square);
    let flat = pairs(a, b).map(|(a, b)| a * x + b * y);
    let rest = one - dot(flat, flat);
    if rest < one.scaled(-6) {
        return None;
    }
    let z = (rest / square).sqrt();
    Some([z, -z].map(|z| pairs(flat, across).map(|(flat, across)| flat + across * z)))
}

/// The first of so many columns that may see the hull of balls, and the one after the last.
fn columns_of<S: Scalar>(balls: &[End<S>], half: S::Real, width: u16) -> [u16; 2] {
    extent(balls, 1, |[x, _, z]| crossing::<S>([x, z], half, width), width)
}

/// The first of so many pixels and the one after the last that are left by the planes which touch the hull of balls and
/// hold an axis: to the right, 0, or upwards, 1. All of them where the hull may go beside the eye.
fn extent<S: Scalar>(
    balls: &[End<S>],
    axis: usize,
    bounds: impl Fn([S::Real; 3]) -> [i32; 2],
    pixels: u16,
) -> [u16; 2] {
    let is_beside = |End { centre: [_, _, ahead], radius }: &End<S>| *ahead <= *radius;
    if balls.iter().any(is_beside) {
        return [0, pixels];
    }
    let centre = core::array::from_fn(|i| if i == axis { S::Real::ONE } else { S::Real::ZERO });
    let along = End { centre, radius: S::Real::ZERO };
    // Each of these planes touches one of the balls.
    let of_balls = balls.iter().map(|ball| {
        let planes = tangents(&[*ball, along]).into_iter().flatten().map(&bounds);
        planes.fold(UNBOUNDED, |[first, end], [from, until]| [first.max(from), end.min(until)])
    });
    let whole = of_balls.reduce(|[first, end], [from, until]| [first.min(from), end.max(until)]);
    whole.unwrap_or(UNBOUNDED).map(|bound| bound.clamp(0, pixels.into()) as u16)
}

/// Beyond every picture.
const UNBOUNDED: [i32; 2] = [-(1 << 20), 1 << 20];

/// The first of so many pixels whose middles, `u` from the middle of all, have `n u + rest >= 0`, and the one after the
/// last.
fn crossing<S: Scalar>([n, rest]: [S::Real; 2], half: S::Real, pixels: u16) -> [i32; 2] {
    if n.abs() < S::Real::ONE.scaled(-10) {
        return UNBOUNDED;
    }
    // u is 2 x + 1 - pixels halves; that is less than 2^18.
    let share = (-rest / (n * half)).scaled(-18);
    if share.abs() >= S::Real::ONE {
        return UNBOUNDED;
    }
    let x = (S::unit_parts(S::unit_round(share)).truncated(18) + i32::from(pixels) - 1) >> 1;
    // Of edges between two rows that are rounded, too.
    if n.is_negative() { [UNBOUNDED[0], x + 4] } else { [x - 2, UNBOUNDED[1]] }
}

#[cfg(all(units, feature = "fixed"))]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../../../tests/units/render/place.rs"]
mod tests;
