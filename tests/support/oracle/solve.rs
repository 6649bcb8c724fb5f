//! Where a line meets a solid, from `f(origin + t * direction) <= 0` in integers.
//!
//! The given numbers are brought to common powers of two first: one for lengths, one for directions. Then the
//! coefficients are integers, and the textbook `k^2 - a c` is exact.

use std::cmp::Ordering;

use dashu::integer::IBig;

use super::algebraic::Root;
use super::dyadic::{Dyadic, common_exponent, sign_of};
use super::solids::{ConeExtent, CylinderExtent, Lateral, Line, Part, Solid, triangle_normal};

/// An end of a span.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct End {
    /// The parameter of the line.
    pub t: Root,
    /// Where on the surface.
    pub part: Part,
}

/// A maximal piece of a line within a solid; `None` where it has no end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// Its lower end.
    pub enter: Option<End>,
    /// Its upper end.
    pub exit: Option<End>,
}

impl Span {
    /// Whether the line only touches the solid.
    pub fn is_touch(&self) -> bool {
        matches!((&self.enter, &self.exit), (Some(enter), Some(exit)) if enter.t == exit.t)
    }
}

/// How a line comes to a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Approach {
    /// From the side that the normal points to: outside the tube or cone, above the plane.
    FromOutside,
    /// From the other side.
    FromInside,
    /// Along it, without crossing it.
    Touch,
}

/// A crossing of a surface that encloses nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Crossing {
    /// The parameter of the line.
    pub t: Root,
    /// From where.
    pub side: Approach,
    /// Where on the surface.
    pub part: Part,
}

/// Where a line meets a solid or a surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Of a solid: the pieces of the line within it, sorted; at most two, and two for a double cone only.
    Spans(Vec<Span>),
    /// Of an open or flat surface: the crossings, sorted.
    Crossings(Vec<Crossing>),
    /// The line lies in an open, flat or infinite surface from one parameter to another, which may be the same;
    /// `None` where it never leaves.
    Coincident {
        /// The lower end.
        from: Option<Root>,
        /// The upper end.
        to: Option<Root>,
    },
}

/// A closed interval of `t`; `None` where it has no end.
#[derive(Clone)]
struct Interval {
    enter: Option<Root>,
    exit: Option<Root>,
}

const EVERYWHERE: Interval = Interval {
    enter: None,
    exit: None,
};

impl Interval {
    fn between(enter: Root, exit: Root) -> Self {
        Self {
            enter: Some(enter),
            exit: Some(exit),
        }
    }

    fn from(enter: Root) -> Self {
        Self {
            enter: Some(enter),
            exit: None,
        }
    }

    fn until(exit: Root) -> Self {
        Self {
            enter: None,
            exit: Some(exit),
        }
    }
}

/// The piece of a line within a convex region.
enum Overlap {
    Nothing,
    /// Within the region, and not all of it on the surface.
    Within(Interval),
    /// All of it on the surface.
    InSurface(Interval),
}

/// A line in units of powers of two: `t = t' * 2^exponent` for the `t'` that its integers give.
struct IntegerLine {
    origin: [IBig; 3],
    direction: [IBig; 3],
    length_unit: isize,
    exponent: isize,
}

impl IntegerLine {
    fn new(line: &Line, lengths: &[&Dyadic]) -> Self {
        let length_unit = common_exponent(line.origin.iter().chain(lengths.iter().copied()));
        let direction_unit = common_exponent(&line.direction);
        Self {
            origin: std::array::from_fn(|axis| line.origin[axis].in_units_of(length_unit)),
            direction: std::array::from_fn(|axis| line.direction[axis].in_units_of(direction_unit)),
            length_unit,
            exponent: length_unit - direction_unit,
        }
    }

    fn length(&self, length: &Dyadic) -> IBig {
        length.in_units_of(self.length_unit)
    }

    fn ratio(&self, numerator: IBig, denominator: &IBig) -> Root {
        Root::quotient(numerator, denominator.clone(), self.exponent)
    }

    /// Where the line is at the height; its `y` must change.
    fn at_height(&self, height: &IBig) -> Root {
        self.ratio(height - &self.origin[1], &self.direction[1])
    }
}

/// `a t^2 + 2 k t + c`.
struct Quadratic {
    a: IBig,
    k: IBig,
    c: IBig,
}

impl Quadratic {
    fn discriminant(&self) -> IBig {
        self.k.sqr().as_ibig() - &self.a * &self.c
    }

    /// The roots, the lower one first; none where they are not real. `a` must not be zero.
    fn roots(&self, exponent: isize) -> Option<(Root, Root)> {
        let discriminant = self.discriminant();
        if sign_of(&discriminant) < 0 {
            return None;
        }
        let lower_sign = -sign_of(&self.a);
        let root =
            |sign, discriminant| Root::new(-&self.k, sign, discriminant, self.a.clone(), exponent);
        Some((
            root(lower_sign, discriminant.clone()),
            root(-lower_sign, discriminant),
        ))
    }
}

/// The ball of the radius around `(0, height, 0)`.
fn sphere_overlap(line: &IntegerLine, radius: &IBig, height: &IBig) -> Option<Interval> {
    let [x, y, z] = &line.origin;
    let [dx, dy, dz] = &line.direction;
    let y = &(y - height);
    let quadratic = Quadratic {
        a: dx * dx + dy * dy + dz * dz,
        k: x * dx + y * dy + z * dz,
        c: x * x + y * y + z * z - radius * radius,
    };
    let (enter, exit) = quadratic.roots(line.exponent)?;
    Some(Interval::between(enter, exit))
}

/// A line against a curved side: the quadratic of `(weight^2)(x^2 + z^2) - reach^2`, and the reach along the line,
/// `weight` times the radius, as `reach + t * reach_slope`.
struct LateralLine {
    quadratic: Quadratic,
    reach: IBig,
    reach_slope: IBig,
    exponent: isize,
}

impl LateralLine {
    fn new(line: &IntegerLine, lateral: &Lateral) -> Self {
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
    fn single_root(&self) -> Root {
        Root::quotient(-&self.quadratic.c, &self.quadratic.k << 1, self.exponent)
    }

    /// Where `f <= 0` and the reach is not negative: an infinite cylinder, or one nappe.
    fn one_nappe(&self) -> Overlap {
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
                let (lower, upper) = self
                    .quadratic
                    .roots(self.exponent)
                    .expect("a line that runs within a nappe meets it");
                Overlap::Within(if widening > 0 {
                    Interval::from(upper)
                } else {
                    Interval::until(lower)
                })
            }
            _ => match (sign_of(k), widening) {
                (0, 0) => match sign_of(c) {
                    -1 => Overlap::Within(EVERYWHERE),
                    0 => Overlap::InSurface(EVERYWHERE),
                    _ => Overlap::Nothing,
                },
                (0, _) if !c.is_zero() => Overlap::Nothing,
                (0, _) => {
                    let apex =
                        Root::quotient(-&self.reach, self.reach_slope.clone(), self.exponent);
                    Overlap::InSurface(if widening > 0 {
                        Interval::from(apex)
                    } else {
                        Interval::until(apex)
                    })
                }
                (-1, 1) => Overlap::Within(Interval::from(self.single_root())),
                (1, -1) => Overlap::Within(Interval::until(self.single_root())),
                _ => Overlap::Nothing,
            },
        }
    }

    /// Where `f <= 0`.
    fn both_nappes(&self) -> Answer {
        let Quadratic { a, k, c } = &self.quadratic;
        let intervals = match sign_of(a) {
            1 => self
                .quadratic
                .roots(self.exponent)
                .map(|(enter, exit)| Interval::between(enter, exit))
                .into_iter()
                .collect(),
            -1 => {
                let (lower, upper) = self
                    .quadratic
                    .roots(self.exponent)
                    .expect("a line that runs within a nappe meets it");
                vec![Interval::until(lower), Interval::from(upper)]
            }
            _ => match sign_of(k) {
                -1 => vec![Interval::from(self.single_root())],
                1 => vec![Interval::until(self.single_root())],
                _ if c.is_zero() => return coincident(EVERYWHERE),
                _ => vec![],
            },
        };
        Answer::Spans(intervals.into_iter().map(all_side).collect())
    }
}

/// The piece of a line with `0 <= y <= height`.
enum Slab {
    Nothing,
    Everywhere,
    Between { enter: End, exit: End },
}

impl Slab {
    fn new(line: &IntegerLine, height: &IBig) -> Self {
        let [_, y, _] = &line.origin;
        let climb = sign_of(&line.direction[1]);
        if climb == 0 {
            return if sign_of(y) < 0 || y > height {
                Self::Nothing
            } else {
                Self::Everywhere
            };
        }
        let base = End {
            t: line.at_height(&IBig::ZERO),
            part: Part::Base,
        };
        let top = End {
            t: line.at_height(height),
            part: Part::Top,
        };
        if climb > 0 {
            Self::Between {
                enter: base,
                exit: top,
            }
        } else {
            Self::Between {
                enter: top,
                exit: base,
            }
        }
    }
}

fn side_end(t: Root) -> End {
    End {
        t,
        part: Part::Side,
    }
}

fn all_side(interval: Interval) -> Span {
    Span {
        enter: interval.enter.map(side_end),
        exit: interval.exit.map(side_end),
    }
}

fn coincident(interval: Interval) -> Answer {
    Answer::Coincident {
        from: interval.enter,
        to: interval.exit,
    }
}

/// The interval within the slab; ends that the interval and the slab share are the interval's, and so the side's.
fn clip(interval: Interval, slab: Slab) -> Option<Span> {
    let mut span = all_side(interval);
    match slab {
        Slab::Nothing => return None,
        Slab::Everywhere => {}
        Slab::Between { enter, exit } => {
            if span.enter.as_ref().is_none_or(|own| own.t < enter.t) {
                span.enter = Some(enter);
            }
            if span.exit.as_ref().is_none_or(|own| own.t > exit.t) {
                span.exit = Some(exit);
            }
        }
    }
    if let (Some(enter), Some(exit)) = (&mut span.enter, &mut span.exit) {
        match enter.t.cmp(&exit.t) {
            Ordering::Greater => return None,
            // A touch is one point: where it is on the side at all, it is on the rim, which the side owns.
            Ordering::Equal if enter.part == Part::Side || exit.part == Part::Side => {
                enter.part = Part::Side;
                exit.part = Part::Side;
            }
            _ => {}
        }
    }
    Some(span)
}

fn solid_with_flat_caps(overlap: Overlap, slab: Slab) -> Answer {
    let span = match overlap {
        Overlap::Nothing => None,
        Overlap::Within(interval) => clip(interval, slab),
        // Every point of it is on the side, its ends on the rims among them.
        Overlap::InSurface(interval) => clip(interval, slab).map(|span| {
            let side = |end: End| side_end(end.t);
            Span {
                enter: span.enter.map(side),
                exit: span.exit.map(side),
            }
        }),
    };
    Answer::Spans(span.into_iter().collect())
}

fn open_side(overlap: Overlap, slab: Slab) -> Answer {
    match overlap {
        Overlap::Nothing => Answer::Crossings(vec![]),
        Overlap::InSurface(interval) => match clip(interval, slab) {
            None => Answer::Crossings(vec![]),
            Some(span) => Answer::Coincident {
                from: span.enter.map(|end| end.t),
                to: span.exit.map(|end| end.t),
            },
        },
        Overlap::Within(interval) => {
            let reached = |t: &Root| match &slab {
                Slab::Nothing => false,
                Slab::Everywhere => true,
                Slab::Between { enter, exit } => enter.t <= *t && *t <= exit.t,
            };
            let touches = interval.enter.is_some() && interval.enter == interval.exit;
            let crossing = |t, side| Crossing {
                t,
                side,
                part: Part::Side,
            };
            let crossings = if touches {
                vec![interval.enter.map(|t| crossing(t, Approach::Touch))]
            } else {
                vec![
                    interval.enter.map(|t| crossing(t, Approach::FromOutside)),
                    interval.exit.map(|t| crossing(t, Approach::FromInside)),
                ]
            };
            Answer::Crossings(
                crossings
                    .into_iter()
                    .flatten()
                    .filter(|crossing| reached(&crossing.t))
                    .collect(),
            )
        }
    }
}

fn unbounded(overlap: Overlap) -> Answer {
    match overlap {
        Overlap::Nothing => Answer::Spans(vec![]),
        Overlap::Within(interval) => Answer::Spans(vec![all_side(interval)]),
        Overlap::InSurface(interval) => coincident(interval),
    }
}

/// The capsule as the union of a capped cylinder and two balls: the union is convex, so that the line's piece in it
/// reaches from the least to the greatest of their ends.
fn capsule(line: &IntegerLine, lateral: &Lateral, radius: &IBig, height: &IBig) -> Answer {
    let mut ends: Vec<(Root, Root, bool)> = [IBig::ZERO, height.clone()]
        .iter()
        .filter_map(|centre| sphere_overlap(line, radius, centre))
        .filter_map(|ball| Some((ball.enter?, ball.exit?, false)))
        .collect();
    let body = solid_with_flat_caps(
        LateralLine::new(line, lateral).one_nappe(),
        Slab::new(line, height),
    );
    if let Answer::Spans(spans) = body {
        ends.extend(
            spans
                .into_iter()
                .filter_map(|span| Some((span.enter?.t, span.exit?.t, true))),
        );
    }
    let part_at = |t: &Root| {
        let y = t.mul_add(
            &Dyadic::new(line.direction[1].clone(), -line.exponent),
            &Dyadic::new(line.origin[1].clone(), 0),
        );
        if y.signum() < 0 {
            Part::Base
        } else if y.cmp_dyadic(&Dyadic::new(height.clone(), 0)) == Ordering::Greater {
            Part::Top
        } else {
            Part::Side
        }
    };
    let end = |(t, on_body): (Root, bool)| {
        let part = if on_body { Part::Side } else { part_at(&t) };
        End { t, part }
    };
    let enter = ends
        .iter()
        .map(|(enter, _, on_body)| (enter.clone(), *on_body))
        .reduce(|best, next| if next.0 < best.0 { next } else { best });
    let exit = ends
        .iter()
        .map(|(_, exit, on_body)| (exit.clone(), *on_body))
        .reduce(|best, next| if next.0 > best.0 { next } else { best });
    Answer::Spans(
        enter
            .zip(exit)
            .map(|(enter, exit)| Span {
                enter: Some(end(enter)),
                exit: Some(end(exit)),
            })
            .into_iter()
            .collect(),
    )
}

/// One crossing of a plane by a line whose inner product with its normal has the sign given.
fn plane_crossing(t: Root, along_normal: i8) -> Answer {
    Answer::Crossings(vec![Crossing {
        t,
        side: if along_normal < 0 {
            Approach::FromOutside
        } else {
            Approach::FromInside
        },
        part: Part::Side,
    }])
}

fn plane(line: &IntegerLine) -> Answer {
    match sign_of(&line.direction[1]) {
        0 if line.origin[1].is_zero() => coincident(EVERYWHERE),
        0 => Answer::Crossings(vec![]),
        climb => plane_crossing(line.at_height(&IBig::ZERO), climb),
    }
}

fn disc(line: &IntegerLine, radius: &IBig) -> Answer {
    let [x, y, z] = &line.origin;
    let [dx, dy, dz] = &line.direction;
    let climb = sign_of(dy);
    if climb != 0 {
        // The point of the plane, times dy.
        let (px, pz) = (x * dy - y * dx, z * dy - y * dz);
        return if &px * &px + &pz * &pz <= (radius * dy).sqr().into() {
            plane_crossing(line.at_height(&IBig::ZERO), climb)
        } else {
            Answer::Crossings(vec![])
        };
    }
    let chord = if y.is_zero() {
        sphere_overlap(line, radius, &IBig::ZERO)
    } else {
        None
    };
    chord.map_or(Answer::Crossings(vec![]), coincident)
}

fn integer_subtract(left: &[IBig; 3], right: &[IBig; 3]) -> [IBig; 3] {
    std::array::from_fn(|axis| &left[axis] - &right[axis])
}

fn integer_dot(left: &[IBig; 3], right: &[IBig; 3]) -> IBig {
    &left[0] * &right[0] + &left[1] * &right[1] + &left[2] * &right[2]
}

fn integer_cross(left: &[IBig; 3], right: &[IBig; 3]) -> [IBig; 3] {
    std::array::from_fn(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        &left[next] * &right[last] - &left[last] * &right[next]
    })
}

fn triangle(line: &IntegerLine, vertices: &[[IBig; 3]; 3]) -> Answer {
    let [first, second, third] = vertices;
    let normal = integer_cross(
        &integer_subtract(second, first),
        &integer_subtract(third, first),
    );
    let spokes: [[IBig; 3]; 3] =
        std::array::from_fn(|corner| integer_subtract(&vertices[corner], &line.origin));
    let along = integer_dot(&normal, &line.direction);
    let above = integer_dot(&normal, &spokes[0]);
    let direction_sign = sign_of(&along);
    if direction_sign != 0 {
        // The line passes on the inner side of each edge, or through it.
        let inside = (0..3).all(|start| {
            let turn = integer_cross(&spokes[start], &spokes[(start + 1) % 3]);
            sign_of(&integer_dot(&line.direction, &turn)) * direction_sign >= 0
        });
        return if inside {
            plane_crossing(line.ratio(above, &along), direction_sign)
        } else {
            Answer::Crossings(vec![])
        };
    }
    if !above.is_zero() {
        return Answer::Crossings(vec![]);
    }
    let mut overlap = EVERYWHERE;
    for start in 0..3 {
        let edge = integer_subtract(&vertices[(start + 1) % 3], &vertices[start]);
        let inward = integer_cross(&normal, &edge);
        // Within means distance <= t * speed.
        let distance = integer_dot(&inward, &spokes[start]);
        let speed = integer_dot(&inward, &line.direction);
        let pace = sign_of(&speed);
        if pace == 0 {
            if sign_of(&distance) > 0 {
                return Answer::Crossings(vec![]);
            }
            continue;
        }
        let bound = line.ratio(distance, &speed);
        if pace > 0 {
            if overlap.enter.as_ref().is_none_or(|enter| bound > *enter) {
                overlap.enter = Some(bound);
            }
        } else if overlap.exit.as_ref().is_none_or(|exit| bound < *exit) {
            overlap.exit = Some(bound);
        }
    }
    if overlap.enter > overlap.exit {
        Answer::Crossings(vec![])
    } else {
        coincident(overlap)
    }
}

/// Where the line meets the solid or the surface, exactly.
///
/// Closed and infinite solids answer with spans, open and flat surfaces with crossings; a line that lies in an open, flat
/// or infinite surface is coincident with it.
///
/// # Panics
///
/// If a triangle has no area.
pub fn solve(solid: &Solid, line: &Line) -> Answer {
    let one_nappe = |integers: &IntegerLine| match solid.lateral() {
        Some(lateral) => LateralLine::new(integers, &lateral).one_nappe(),
        None => Overlap::Nothing,
    };
    match solid {
        Solid::Sphere { radius } => {
            let integers = IntegerLine::new(line, &[radius]);
            let ball = sphere_overlap(&integers, &integers.length(radius), &IBig::ZERO);
            Answer::Spans(ball.map(all_side).into_iter().collect())
        }
        Solid::Cylinder {
            extent: CylinderExtent::Infinite,
            ..
        }
        | Solid::Cone {
            extent: ConeExtent::Nappe,
            ..
        } => unbounded(one_nappe(&IntegerLine::new(line, &[]))),
        Solid::Cone {
            extent: ConeExtent::Double,
            ..
        } => {
            let lateral = solid.lateral().expect("a cone has a side");
            LateralLine::new(&IntegerLine::new(line, &[]), &lateral).both_nappes()
        }
        Solid::Cylinder {
            extent: CylinderExtent::Capped(height),
            ..
        }
        | Solid::Cone {
            extent: ConeExtent::Capped(height),
            ..
        }
        | Solid::Frustum {
            height,
            capped: true,
            ..
        } => {
            let integers = IntegerLine::new(line, &[height]);
            let slab = Slab::new(&integers, &integers.length(height));
            solid_with_flat_caps(one_nappe(&integers), slab)
        }
        Solid::Cylinder {
            extent: CylinderExtent::Open(height),
            ..
        }
        | Solid::Cone {
            extent: ConeExtent::Open(height),
            ..
        }
        | Solid::Frustum {
            height,
            capped: false,
            ..
        } => {
            let integers = IntegerLine::new(line, &[height]);
            let slab = Slab::new(&integers, &integers.length(height));
            open_side(one_nappe(&integers), slab)
        }
        Solid::Capsule { radius, height } => {
            let integers = IntegerLine::new(line, &[radius, height]);
            let lateral = solid.lateral().expect("a capsule has a side");
            capsule(
                &integers,
                &lateral,
                &integers.length(radius),
                &integers.length(height),
            )
        }
        Solid::Plane => plane(&IntegerLine::new(line, &[])),
        Solid::Disc { radius } => {
            let integers = IntegerLine::new(line, &[radius]);
            disc(&integers, &integers.length(radius))
        }
        Solid::Triangle { vertices } => {
            // Called for its check that the triangle has an area.
            triangle_normal(vertices);
            let lengths: Vec<&Dyadic> = vertices.iter().flatten().collect();
            let integers = IntegerLine::new(line, &lengths);
            let corners = vertices
                .each_ref()
                .map(|vertex| vertex.each_ref().map(|x| integers.length(x)));
            triangle(&integers, &corners)
        }
    }
}
