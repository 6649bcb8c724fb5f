//! Classes of hard rays, made rather than written: rows 16 to 18 of the list, and the ends of the number types. The
//! exact answer is the oracle's, on the bits that the type received.

use super::Kind::{Ball, Can, Cone, Disc, Frustum, Nappe, Pill, Tube};
use super::build;
use super::check::{Found, Policy, compare};
use crate::cases::{self, direction, lattice_directions};
use crate::exact_types::{Exact, exact_line};
use crate::oracle::Solid;
use raylet::{Crossing, Departure, Leaving, Part, Ray, Shape, Tier, Vec3};

/// The name of a class, and what the default tier does not promise of it.
pub struct Sweep {
    pub name: &'static str,
    /// Number type, how many answers are decided by a rounding within one unit, how many are wrong, and the greatest
    /// error where that is beyond the tier's bound: what was measured, and at most a tenth more.
    pub limits: &'static [(&'static str, usize, usize, f64)],
}

/// Rows 16 to 18, and the ends of the types. All of the ties are those of the tier's documentation; see
/// `check::is_within_a_unit`.
pub const CENTRE: Sweep = Sweep { name: "from the centre", limits: &[] };
pub const SURFACE: Sweep = Sweep {
    name: "from the surface",
    // Within the promise: a running bound of 32 roundings lets errors of some units pass.
    limits: &[("f32", 0, 0, 2.6), ("f64", 0, 0, 2.6)],
};
pub const ZEROS: Sweep = Sweep {
    name: "with zero components",
    // Through rims, openings and the apex, at which this class is aimed; in floats the error is larger than elsewhere.
    limits: &[("f32", 16, 0, 5.4), ("f64", 0, 0, 5.4)],
};
pub const FARTHER: Sweep = Sweep {
    name: "ever farther",
    // From 2^64 sizes away and farther, where the robust number's own bits end; nearer than that a line whose origin is
    // moved is off by as many roundings of its length as its incidence is oblique.
    // Along the axis of a round cone, and at edges and corners of a rounded cuboid, a prism and a polyhedron, the part
    // is lost there too.
    limits: &[("f32", 0, 0, 1.8), ("f64", 982, 126, 1.2)],
};
pub const ENDS: Sweep = Sweep { name: "at the ends of the type", limits: &[] };

/// What a class of rays came to.
pub struct Tally<'a, S: Exact> {
    sweep: &'a Sweep,
    policy: &'a Policy,
    rays: usize,
    found: Found,
    number: std::marker::PhantomData<S>,
}

impl<'a, S: Exact> Tally<'a, S> {
    pub fn new(sweep: &'a Sweep, policy: &'a Policy) -> Self {
        Self { sweep, policy, rays: 0, found: Found::default(), number: std::marker::PhantomData }
    }

    /// Beside this distance a radius has no square in the type: the crate documents that such a solid is a line or a
    /// point, and the default tier promises no answer there.
    fn is_a_point(&self, size: f64, distance: f64) -> bool {
        let ratio = if S::name() == "f32" { 60 } else { 500 };
        self.policy.limits && S::name().starts_with('f') && distance / size >= super::two_to(ratio)
    }

    fn test<T: Tier<S>>(&mut self, shape: &Shape<S>, solid: &Solid, ray: &Ray<S>) {
        self.rays += 1;
        compare::<S, T>(shape, solid, &exact_line(ray), ray, &mut self.found);
    }

    /// Notes what is wrong in itself, whatever the rounding.
    fn must(&mut self, holds: bool, told: impl FnOnce() -> String) {
        if !holds {
            self.found.broken.push(told());
        }
    }

    /// How many rays, the greatest error and what is wrong.
    pub fn finish(self) -> (usize, f64, Vec<String>) {
        let policy = self.policy;
        let name = format!("{} in {}", self.sweep.name, S::name());
        let mut wrong = self.found.broken;
        let own = self.sweep.limits.iter().find(|(number, ..)| policy.limits && *number == S::name());
        let (ties, others, bound) = own.map_or((0, 0, 0.0), |(_, ties, others, bound)| (*ties, *others, *bound));
        let bound = policy.units::<S>().max(bound);
        if self.found.worst > bound {
            wrong.push(format!("{} units, bound {bound}", self.found.worst));
        }
        if bound > policy.units::<S>() && bound > self.found.worst * 1.1 {
            wrong.push(format!("a limit of {bound} units is not needed: measured {}", self.found.worst));
        }
        if self.found.ties.len() != ties {
            let told = self.found.ties.join("\n");
            wrong.push(format!("{} answers are decided by a rounding, not {ties}: {told}", self.found.ties.len()));
        }
        if self.found.other.len() != others {
            let told = self.found.told.join("\n");
            wrong.push(format!("{} other answers, not {others}: {told}", self.found.other.len()));
        }
        (self.rays, self.found.worst, wrong.into_iter().map(|what| format!("{name}: {what}")).collect())
    }
}

/// Directions with two and with one zero component in every order of sign, of equal and of unequal components; for each
/// the zeros of both signs, which floats tell apart.
fn directions_with_zeros() -> Vec<[f64; 3]> {
    let mut all: Vec<[f64; 3]> = lattice_directions().into_iter().filter(|d| d.contains(&0.0)).collect();
    let unequal: Vec<[f64; 3]> = all
        .iter()
        .filter(|d| d.iter().filter(|c| **c == 0.0).count() == 1)
        .flat_map(|[x, y, z]| {
            [
                [3.0 * x, if *x == 0.0 { 3.0 * y } else { 4.0 * y }, 4.0 * z],
                [4.0 * x, 3.0 * y, if *x == 0.0 { 4.0 * z } else { 3.0 * z }],
            ]
        })
        .collect();
    all.extend(unequal);
    let negative = |d: &[f64; 3]| d.map(|c| if c == 0.0 { -0.0 } else { c });
    let negatives: Vec<[f64; 3]> = all.iter().map(negative).collect();
    all.extend(negatives);
    all
}

/// All the directions of a lattice, and two that lie on none.
fn all_directions() -> Vec<[f64; 3]> {
    let mut all = lattice_directions();
    all.extend([[2.0, -3.0, 6.0], [0.3, 0.5, -0.1], [-1.0, 1e-3, 0.25]]);
    all
}

/// Row 16: from the centre: one exit, and the start is inside.
pub fn from_the_centre<S: Exact, T: Tier<S>>(tally: &mut Tally<'_, S>) {
    for (kind, height) in [
        (Ball(1.5), 0.0),
        (Can(1.0, 2.0), 1.0),
        (Cone(0.5, 2.0), 1.5),
        (Pill(1.0, 2.0), 1.0),
        (Frustum(1.0, 0.5, 2.0), 1.0),
    ] {
        let (primitive, solid) = build::<S>(kind, None).expect("every type holds these sizes");
        let shape = Shape::new(primitive);
        for along in all_directions() {
            let ray =
                Ray::new(cases::v([0.0, height, 0.0]), direction(along)).expect("the origin is within the budget");
            tally.test::<T>(&shape, &solid, &ray);
            let hits = shape.hits_at::<T>(&ray);
            let leaves = hits.starts_inside() && hits.len() == 1 && hits[0].crossing == Crossing::Exit;
            tally.must(leaves, || format!("{kind:?} is not left by {ray:?}: {hits:?}"));
        }
    }
}

/// Points of a surface that every number type holds exactly, with outward normals of any length.
fn surface_points() -> [(super::Kind, Part, [f64; 3], [f64; 3]); 12] {
    [
        (Ball(3.75), Part::Side, [0.5, 1.25, 3.5], [2.0, 5.0, 14.0]),
        (Ball(3.75), Part::Side, [-2.25, 0.0, 3.0], [-3.0, 0.0, 4.0]),
        (Ball(3.75), Part::Side, [0.0, -3.75, 0.0], [0.0, -1.0, 0.0]),
        (Can(1.25, 2.0), Part::Side, [0.75, 1.0, -1.0], [3.0, 0.0, -4.0]),
        (Can(1.25, 2.0), Part::Top, [0.25, 2.0, -0.5], [0.0, 1.0, 0.0]),
        (Can(1.25, 2.0), Part::Base, [0.25, 0.0, -0.5], [0.0, -1.0, 0.0]),
        (Cone(0.5, 4.0), Part::Side, [0.75, 2.5, 1.0], [6.0, -5.0, 8.0]),
        (Cone(0.5, 4.0), Part::Top, [0.75, 4.0, 1.0], [0.0, 1.0, 0.0]),
        (Frustum(2.5, 1.25, 2.0), Part::Side, [1.125, 1.0, 1.5], [24.0, 25.0, 32.0]),
        (Pill(3.75, 2.0), Part::Side, [2.25, 0.5, -3.0], [3.0, 0.0, -4.0]),
        (Pill(3.75, 2.0), Part::Top, [0.5, 4.5, 2.75], [2.0, 10.0, 11.0]),
        (Pill(3.75, 2.0), Part::Base, [3.5, -1.25, -0.5], [14.0, -5.0, -2.0]),
    ]
}

/// Row 16: from a point of the surface, as a ray that departs from it: inwards exactly the far end, outwards nothing;
/// and as a ray that knows nothing of the surface, whose hit at zero is then the exact answer.
pub fn from_the_surface<S: Exact, T: Tier<S>>(tally: &mut Tally<'_, S>) {
    for (kind, part, point, normal) in surface_points() {
        let (primitive, solid) = build::<S>(kind, None).expect("every type holds these sizes");
        let shape = Shape::new(primitive);
        for along in all_directions() {
            let outwards = along.iter().zip(normal).map(|(d, n)| d * n).sum::<f64>();
            let ray = Ray::new(cases::v(point), direction(along)).expect("the origin is within the budget");
            tally.test::<T>(&shape, &solid, &ray);
            if outwards.abs() < 1e-3 {
                continue;
            }
            let leaving = if outwards > 0.0 { Leaving::Outwards } else { Leaving::Inwards };
            let departing = ray.departing(Departure { object: 0, part, leaving });
            let (hits, exact) = (shape.hits_at::<T>(&departing), crate::exact_types::expected(&solid, &ray));
            let far = exact.hits.last().filter(|_| leaving == Leaving::Inwards);
            let told = || format!("{kind:?}: {departing:?} gives {hits:?}, exactly {far:?}");
            tally.must(hits.len() == usize::from(far.is_some()), told);
            if let (Some(hit), Some(far)) = (hits.first(), far) {
                tally.must(hit.crossing == Crossing::Exit && crate::exact_types::same_part(hit.part, far.part), told);
                tally.found.worst = tally.found.worst.max(far.t.error_in(&hit.t.exact(), &S::unit_at(&far.t)));
            }
        }
    }
}

/// Row 17: every primitive, and directions with one or two zero components in every order of sign, from inside and from
/// outside, through what is special about it and beside it.
pub fn zero_components<S: Exact, T: Tier<S>>(tally: &mut Tally<'_, S>) {
    for case in cases::cases::<S>() {
        for along in directions_with_zeros() {
            for aim in [[0.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.3, 0.7, -0.2], [-0.6, 1.1, 0.4], [0.25, 1.75, 0.125]] {
                for away in [0.0, 1.0, 6.5] {
                    let origin = std::array::from_fn(|i| aim[i] - away * along[i]);
                    let ray = Ray::new(cases::v(origin), direction(along)).expect("the origin is within the budget");
                    tally.test::<T>(&case.shape(), &case.solid, &ray);
                }
            }
        }
    }
}

/// Row 18: every primitive, and the same ray from 10, 100, ... as far as the type reaches.
pub fn ever_farther<S: Exact, T: Tier<S>>(tally: &mut Tally<'_, S>) {
    for case in cases::cases::<S>() {
        for along in [
            [1.0, 0.0, 0.0],
            [0.0, -1.0, 0.0],
            [-0.6, 0.0, 0.8],
            [0.48, -0.6, 0.64],
            [-2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0],
        ] {
            for aim in [[0.25, 0.5, -0.125], [0.3, 0.7, -0.2]] {
                for away in (1..40).chain((40..308).step_by(20)).map(|power| 10.0_f64.powi(power)) {
                    let origin = std::array::from_fn(|i| aim[i] - away * along[i]);
                    let Ok(origin) = Vec3::<S>::from_f64(origin) else { break };
                    let Ok(ray) = Ray::new(origin, direction(along)) else { break };
                    if tally.is_a_point(0.5, away) {
                        break;
                    }
                    tally.test::<T>(&case.shape(), &case.solid, &ray);
                }
            }
        }
    }
}

/// The largest solids that a type takes, from the farthest origins, and the smallest, from near by: raw minimum and
/// maximum of fixed types, subnormal and largest floats.
pub fn at_the_ends_of_the_type<S: Exact, T: Tier<S>>(tally: &mut Tally<'_, S>) {
    let (most, least) = (S::BUDGET.size.to_f64(), S::BUDGET.smallest_size.to_f64());
    for (size, distance) in
        [(most, most), (most / 2.0, most), (least, 3.0 * least), (least * 5.0, least * 16.0), (least, 1.0)]
    {
        let kinds = [
            Ball(size),
            Tube(size),
            Can(size, size),
            Pill(size, size),
            Disc(size),
            Nappe(1.0),
            Cone(1.0, size),
            Frustum(size, 0.0, size),
            Frustum(size, size, size),
            super::Kind::Triangle([[0.0, 0.0, size], [size, 0.0, 0.0], [0.0, size, 0.0]]),
        ];
        if tally.is_a_point(size, distance) {
            continue;
        }
        for kind in kinds {
            // Of a single unit some solids have no area.
            let Some((primitive, solid)) = build::<S>(kind, None) else { continue };
            for along in all_directions() {
                for corner in [[1.0, 1.0, 1.0], [1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 0.0, 1.0]] {
                    let origin = std::array::from_fn(|i| if along[i] > 0.0 { -distance } else { distance } * corner[i]);
                    let ray = Ray::new(cases::v(origin), direction(along)).expect("the origin is within the budget");
                    tally.test::<T>(&Shape::new(primitive), &solid, &ray);
                }
            }
        }
    }
}
