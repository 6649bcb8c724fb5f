//! Whether an answer is that of exact arithmetic.

use crate::bytes::Number;
use crate::known;
use crate::query::Query;
use raylet::{Hits, Part, Ray, Shape, Tier};
use support::cases::Kind;
use support::exact_types::{exact_line, same_crossing, same_part};
use support::oracle::{self, ConeExtent, CylinderExtent, Dyadic, InRange, Line, Revolved, Solid, hits_in_range};
use support::random::Random;

/// What a tier promises.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Agreement {
    /// The exact answer, with every `t` within one unit in the last place.
    Total,
    /// No answer in particular, but one that keeps the laws.
    Lawful,
    /// The exact answer where it is the same for all solids and rays that lie within some units of the one given, and a
    /// `t` that is off by so many units, and by what such a change moves it.
    Backward {
        /// Units in the last place of a float's `t`, and of its lengths.
        float: f64,
        /// Units of a fixed type.
        fixed: f64,
    },
}

/// How a case came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The exact answer.
    Same,
    /// None was looked for.
    Lawful,
    /// Another one, where a little makes another one of the exact answer as well.
    Tie,
}

/// Queries the solid in its canonical pose, without a departure, and compares with exact arithmetic.
pub fn agree<S: Number, T: Tier<S>>(query: &Query<S>) -> Verdict {
    let (_, promise) = query.tier.get();
    let ray = query.ray.without_departure();
    let hits = Shape::new(*query.shape.primitive()).hits_at::<T>(&ray);
    let line = exact_line(&ray);
    // A triangle without an area is none to the oracle.
    if promise == Agreement::Lawful || is_flat_to_a_line(&query.solid) {
        return Verdict::Lawful;
    }
    // Where squares vanish nothing is promised but by a tier that is exact.
    let excused = query.squares_vanish() || known::has_a_vanishing_slope(query);
    if excused && promise != Agreement::Total {
        return Verdict::Tie;
    }
    let exact = in_range(&query.solid, &line, &ray, &Dyadic::zero(), &Dyadic::zero());
    let (wrong_structure, error) = (!same_structure(&hits, &exact), greatest_error(&hits, &exact));
    let told = |why: &str| {
        let exact: Vec<_> = exact.hits.iter().map(|hit| (hit.t.to_f64(), hit.part, hit.crossing)).collect();
        format!("{why}: {hits:?}, exactly {exact:?}: {query:#?}")
    };
    let units = match promise {
        Agreement::Total => {
            assert!(!wrong_structure, "{}", told("wrong, in a tier that is exact"));
            assert!(error <= 1.0, "{}", told(&format!("{error} units off, in a tier that is exact")));
            return Verdict::Same;
        }
        Agreement::Lawful => return Verdict::Lawful,
        Agreement::Backward { float, fixed } => {
            if S::VANISHING.is_some() {
                float
            } else {
                fixed
            }
        }
    };
    if !wrong_structure && error <= units {
        return Verdict::Same;
    }
    // Rarely reached, so that it may cost what it costs.
    let near = Near::new(query, line, units);
    if near.is_all_rounding() || near.is_a_point_of_overlap(&hits) || near.is_at_a_seam(&hits, &exact) {
        return Verdict::Tie;
    }
    let mut moved = vec![0.0; exact.hits.len()];
    for other in near.answers(&ray) {
        if structure(&other) != structure(&exact) {
            return Verdict::Tie;
        }
        for ((moved, hit), other) in moved.iter_mut().zip(&exact.hits).zip(&other.hits) {
            let difference = hit.t.error_in(&other.t.approximation(200), &S::unit_at(&hit.t));
            *moved = f64::max(*moved, difference);
        }
    }
    assert!(!wrong_structure, "{}", told("wrong, and nothing near it is any different"));
    for ((hit, exact), moved) in hits.iter().zip(&exact.hits).zip(moved) {
        // Along an asymptote, where a little moves an end far, its rounding counts several times.
        let moved = if moved > 2.0 * units { 8.0 * moved } else { moved };
        let error = exact.t.error_in(&hit.t.exact(), &S::unit_at(&exact.t));
        assert!(error <= units + moved, "{}", told(&format!("{error} units off, where {moved} are excused")));
    }
    Verdict::Tie
}

/// The oracle's answer in the ray's range, whose ends are moved.
fn in_range<S: Number>(solid: &Solid, line: &Line, ray: &Ray<S>, start: &Dyadic, end: &Dyadic) -> InRange {
    let range = ray.range();
    let (start, end) = (&range.start().exact() + start, &range.end().exact() + end);
    hits_in_range(&oracle::solve(solid, line), &start, Some(&end))
}

fn same_structure<S: Number>(hits: &Hits<S>, exact: &InRange) -> bool {
    hits.len() == exact.hits.len()
        && hits.starts_inside() == exact.starts_inside
        && hits.coincident().is_some() == exact.coincident
        && hits
            .iter()
            .zip(&exact.hits)
            .all(|(hit, exact)| same_part(hit.part, exact.part) && same_crossing(hit.crossing, exact.crossing))
}

type Structure = (Vec<(oracle::Part, oracle::ExpectedCrossing)>, bool, bool);

/// Everything but the numbers.
fn structure(answer: &InRange) -> Structure {
    let hits = answer.hits.iter().map(|hit| (hit.part, hit.crossing)).collect();
    (hits, answer.starts_inside, answer.coincident)
}

fn greatest_error<S: Number>(hits: &Hits<S>, exact: &InRange) -> f64 {
    let each = hits.iter().zip(&exact.hits);
    each.map(|(hit, exact)| exact.t.error_in(&hit.t.exact(), &S::unit_at(&exact.t))).fold(0.0, f64::max)
}

/// What lies within rounding of a query.
struct Near<'a, S: Number> {
    query: &'a Query<S>,
    line: Line,
    /// So many units in the last place of the lengths that the line and the solid are made of.
    step: Dyadic,
}

impl<'a, S: Number> Near<'a, S> {
    fn new(query: &'a Query<S>, line: Line, units: f64) -> Self {
        let step = S::unit_at(&oracle::Root::from(&grain(query))).scaled(units.log2().ceil() as isize);
        Self { query, line, step }
    }

    /// True if the whole solid is not larger than what is excused.
    fn is_all_rounding(&self) -> bool {
        let least = &self.query.extent.0;
        let has_none = self.query.kind == Kind::Unbounded || matches!(self.query.solid, Solid::Plane);
        !has_none && *least <= self.step
    }

    /// True if the ray lies in a surface over no more than what is excused: cut off by edges that round to the same
    /// `t`.
    fn is_a_point_of_overlap(&self, hits: &Hits<S>) -> bool {
        hits.coincident().is_some_and(|overlap| &overlap.end().exact() - &overlap.start().exact() <= self.step)
    }

    /// True if a side is met next to its rim or seam: to the same `t`, rounded, as the plane that ends it.
    fn is_at_a_seam(&self, hits: &Hits<S>, exact: &InRange) -> bool {
        let seams = seams(&self.query.solid);
        let own = hits.iter().filter(|hit| hit.part == Part::Side).map(|hit| oracle::Root::from(&hit.t.exact()));
        let exact = exact.hits.iter().filter(|hit| hit.part == oracle::Part::Side).map(|hit| hit.t.clone());
        let heights = own.chain(exact).map(|t| self.line.coordinate_at(&t, 1));
        let is_near = |height: &oracle::Root, seam: &Dyadic| {
            height.cmp_dyadic(&(seam - &self.step)).is_gt() && height.cmp_dyadic(&(seam + &self.step)).is_lt()
        };
        heights.into_iter().any(|height| seams.iter().any(|seam| is_near(&height, seam)))
    }

    /// The exact answers nearby: the line moved along every axis and diagonal; the solid, and the ends of the range, a
    /// little larger and smaller; and some of all of that at once.
    fn answers<'b>(&'b self, ray: &'b Ray<S>) -> impl Iterator<Item = InRange> + 'b {
        let mut changes: Vec<[i64; 6]> = vec![];
        let signs = [-1, 0, 1];
        for [x, y] in signs.into_iter().flat_map(|x| signs.map(|y| [x, y])) {
            changes.extend(signs.map(|z| [x, y, z, 0, 0, 0]));
        }
        for other in 3..6 {
            for sign in [-1, 1] {
                let mut change = [0; 6];
                change[other] = sign;
                changes.push(change);
            }
        }
        let mut random = Random(1);
        changes.extend((0..24).map(|_| [(); 6].map(|()| random.pick(&signs))));
        changes.into_iter().map(move |[x, y, z, size, start, end]| {
            let by = |sign: i64| &self.step * &Dyadic::from(sign);
            let origin = [(0, x), (1, y), (2, z)].map(|(i, sign)| &self.line.origin[i] + &by(sign));
            let mut moved = Line { origin, direction: self.line.direction.clone() };
            if [x, y, z, size, start, end] == [0; 6] {
                moved = self.without_dust();
            }
            in_range(&resized(&self.query.solid, size, &self.step), &moved, ray, &by(start), &by(end))
        })
    }

    /// The line without what is nothing to a float beside the rest, or has a square that is.
    fn without_dust(&self) -> Line {
        let swept = |components: &[Dyadic; 3], least: &Dyadic| {
            components.each_ref().map(|c| if c.magnitude() < *least { Dyadic::zero() } else { c.clone() })
        };
        let least = S::VANISHING.map_or(Dyadic::zero(), |exponent| Dyadic::power_of_two(exponent as isize));
        let origin = swept(&self.line.origin, &self.step);
        Line { origin, direction: swept(&self.line.direction, &least) }
    }
}

/// The length in whose units a query is rounded: that of the solid and of the way to it. From farther off a float ray
/// first comes closer, by a step that has half of the type's bits and leaves so much of the way.
fn grain<S: Number>(query: &Query<S>) -> Dyadic {
    let greatest = &query.extent.1;
    let origin = query.ray.origin().to_array().map(|c| c.exact().magnitude());
    let [x, y, z] = &origin;
    let away = x.max(y).max(z);
    let endless = query.kind == Kind::Unbounded || matches!(query.solid, Solid::Plane);
    let near = if endless || *away <= greatest.scaled(4) {
        away.clone()
    } else {
        greatest.scaled(4).max(away.scaled(-S::PRECISION / 2 + 1))
    };
    near.max(greatest.clone())
}

/// The heights at which a side ends.
fn seams(solid: &Solid) -> Vec<Dyadic> {
    match solid {
        Solid::Cylinder { extent: CylinderExtent::Open(height) | CylinderExtent::Capped(height), .. }
        | Solid::Cone { extent: ConeExtent::Open(height) | ConeExtent::Capped(height), .. }
        | Solid::Frustum { height, .. }
        | Solid::Capsule { height, .. }
        | Solid::Tube { height, .. } => vec![Dyadic::zero(), height.clone()],
        Solid::Revolved(revolved) => vec![revolved.low.clone(), revolved.high.clone()],
        Solid::Cone { .. } => vec![Dyadic::zero()],
        _ => vec![],
    }
}

/// The solid with every size larger or smaller by the step, or a slope by a millionth.
fn resized(solid: &Solid, sign: i64, step: &Dyadic) -> Solid {
    let by = |size: &Dyadic| {
        let moved = size + &(step * &Dyadic::from(sign));
        // What is smaller than a step may be half as large, but is still there.
        if moved.signum() > 0 || size.is_zero() { moved } else { size.scaled(-1) }
    };
    let or_zero = |size: &Dyadic| if size.is_zero() { size.clone() } else { by(size) };
    // An outer radius, which stays above the inner one.
    let outside = |inner: &Dyadic, outer: &Dyadic| inner + &by(&(outer - inner));
    let slope = |slope: &Dyadic| slope * &(&Dyadic::from(1) + &(&Dyadic::from(sign) * &Dyadic::power_of_two(-20)));
    match solid {
        Solid::Sphere { radius } => Solid::Sphere { radius: by(radius) },
        Solid::Cylinder { radius, extent } => {
            let extent = match extent {
                CylinderExtent::Infinite => CylinderExtent::Infinite,
                CylinderExtent::Open(height) => CylinderExtent::Open(by(height)),
                CylinderExtent::Capped(height) => CylinderExtent::Capped(by(height)),
            };
            Solid::Cylinder { radius: by(radius), extent }
        }
        Solid::Cone { slope: m, extent } => {
            let extent = match extent {
                ConeExtent::Double => ConeExtent::Double,
                ConeExtent::Nappe => ConeExtent::Nappe,
                ConeExtent::Open(height) => ConeExtent::Open(by(height)),
                ConeExtent::Capped(height) => ConeExtent::Capped(by(height)),
            };
            Solid::Cone { slope: slope(m), extent }
        }
        Solid::Frustum { base_radius, top_radius, height, capped } => Solid::Frustum {
            base_radius: or_zero(base_radius),
            top_radius: or_zero(top_radius),
            height: by(height),
            capped: *capped,
        },
        Solid::Capsule { radius, height } => Solid::Capsule { radius: by(radius), height: or_zero(height) },
        Solid::Revolved(revolved) => {
            let further = |height: &Dyadic| height + &(step * &Dyadic::from(sign));
            Solid::Revolved(Revolved {
                a: slope(&revolved.a),
                b: further(&revolved.b),
                r: or_zero(&revolved.r),
                low: -&further(&-&revolved.low),
                high: further(&revolved.high),
                capped: revolved.capped,
            })
        }
        Solid::RoundCone(oracle::RoundCone { base_radius, top_radius, height }) => {
            Solid::RoundCone(oracle::RoundCone {
                base_radius: by(base_radius),
                top_radius: by(top_radius),
                height: or_zero(height),
            })
        }
        // The wall grows, or shrinks, to one side.
        Solid::Tube { inner, outer, height } => {
            Solid::Tube { inner: inner.clone(), outer: outside(inner, outer), height: by(height) }
        }
        // The minor radius, which stays below the major one, alone: then the torus grows, or shrinks, everywhere.
        Solid::Torus { major, minor } => {
            let wider = by(minor);
            let minor = if &wider < major { wider } else { minor.clone() };
            Solid::Torus { major: major.clone(), minor }
        }
        Solid::Plane => Solid::Plane,
        Solid::Disc { radius } => Solid::Disc { radius: by(radius) },
        Solid::Annulus { inner, outer } => Solid::Annulus { inner: inner.clone(), outer: outside(inner, outer) },
        Solid::Cuboid { half } => Solid::Cuboid { half: half.each_ref().map(by) },
        Solid::RoundedCuboid(oracle::RoundedCuboid { half, radius }) => {
            Solid::RoundedCuboid(oracle::RoundedCuboid { half: half.each_ref().map(or_zero), radius: by(radius) })
        }
        Solid::HalfSpaces(of) => {
            // Each plane moves along an axis, outwards or inwards.
            let mut of = of.clone();
            for face in &mut of.faces {
                let axis = (0..3).max_by_key(|i| face.normal[*i].magnitude()).unwrap_or(0);
                let is_low = (face.normal[axis].signum() < 0) == (sign > 0);
                face.point[axis] = &face.point[axis]
                    + &if sign == 0 {
                        Dyadic::zero()
                    } else if is_low {
                        -step
                    } else {
                        step.clone()
                    };
            }
            Solid::HalfSpaces(of)
        }
        Solid::Rectangle { half } => Solid::Rectangle { half: half.each_ref().map(by) },
        Solid::Triangle { vertices } => {
            // One corner or another, each in another direction.
            if sign == 0 {
                return solid.clone();
            }
            let mut vertices = vertices.clone();
            let corner = usize::from(sign > 0);
            vertices[corner][corner] = &vertices[corner][corner] + step;
            let moved = Solid::Triangle { vertices };
            if is_flat_to_a_line(&moved) { solid.clone() } else { moved }
        }
    }
}

/// True for a triangle without an area, of which the oracle knows nothing.
fn is_flat_to_a_line(solid: &Solid) -> bool {
    let Solid::Triangle { vertices: [a, b, c] } = solid else { return false };
    let edge = |to: &[Dyadic; 3]| [0, 1, 2].map(|i| &to[i] - &a[i]);
    let (e, f) = (edge(b), edge(c));
    (0..3).all(|i| {
        let (next, last) = ((i + 1) % 3, (i + 2) % 3);
        (&(&e[next] * &f[last]) - &(&e[last] * &f[next])).is_zero()
    })
}
