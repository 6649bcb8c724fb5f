//! Every primitive of the crate beside the oracle's own, rays at their edges, and what counts as the same answer.

use super::described::Described;
use super::exact_types::{Exact, expected, same_crossing, same_part};
use super::oracle::{self, ConeExtent, CylinderExtent, Solid};
use super::random::Random;
use raylet::scalar::UnitScalar;
use raylet::{
    Annulus, Capsule, Cone, Crossing, Cuboid, Cylinder, Disc, Hits, Part, Plane, Primitive, Range, Ray, Rectangle,
    Revolved, RoundCone, RoundedCuboid, Shape, Sphere, Torus, Triangle, Tube, UnitVec3, Vec3,
};

impl Random {
    /// A point of the cube `[-size, size]^3`.
    pub fn point<S: Exact>(&mut self, size: f64) -> Vec3<S> {
        v([self.between(-size, size), self.between(-size, size), self.between(-size, size)])
    }

    /// A direction of the type.
    pub fn unit_vector<S: Exact>(&mut self) -> UnitVec3<S> {
        direction(self.direction())
    }
}

/// A number of the type.
pub fn n<S: Exact>(value: f64) -> S {
    S::from_f64(value).expect("the number is within the type")
}

/// A vector of the type.
pub fn v<S: Exact>(components: [f64; 3]) -> Vec3<S> {
    Vec3::from_f64(components).expect("the vector is within the type")
}

/// The direction nearest to the given one: right to the last bits of the type's unit component.
pub fn direction<S: Exact>(components: [f64; 3]) -> UnitVec3<S> {
    let [x, y, z] = components;
    let length = (x * x + y * y + z * z).sqrt();
    UnitVec3::from_components(components.map(|c| <S::Unit as UnitScalar>::from_f64(c / length)))
        .expect("the direction has a length")
}

/// Calls a test in all tiers of the usual number types, or in the tiers of one type: `call_in_every_tier!(test)`,
/// `call_in_every_tier!(test: f32, raylet::Fast)`.
#[macro_export]
macro_rules! call_in_every_tier {
    ($test:ident) => {
        $crate::call_in_every_tier!($test: f32, raylet::Plain, raylet::Fast, raylet::Stable, raylet::Exact);
        $crate::call_in_every_tier!($test: f64, raylet::Plain, raylet::Fast, raylet::Stable);
        $crate::call_in_every_tier!(
            $test: fixed::types::I16F16, raylet::Plain, raylet::Fast, raylet::Stable, raylet::Exact
        );
        $crate::call_in_every_tier!($test: fixed::types::I32F32, raylet::Plain, raylet::Fast, raylet::Stable);
    };
    ($test:ident: $S:ty, $($T:ty),+) => { $($test::<$S, $T>();)+ };
}

/// What rule of section 2 a primitive falls under.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A closed set of finite size: rule 1.
    Bounded,
    /// A closed set of finite size that a line may meet in two intervals: rule 1, of each of them.
    NotConvex,
    /// A solid without end: rule 2.
    Unbounded,
    /// A surface that encloses nothing: rule 2.
    Open,
}

/// A primitive, the same as the oracle sees it, and the heights and radii at which something changes.
#[derive(Clone)]
pub struct Case<S: Exact> {
    pub name: &'static str,
    pub kind: Kind,
    pub primitive: Primitive<S>,
    pub solid: Solid,
    /// Heights of rims, seams and the apex.
    pub seams: Vec<f64>,
    /// Radii at the seams.
    pub radii: Vec<f64>,
}

impl<S: Exact> Case<S> {
    pub fn shape(&self) -> Shape<S> {
        Shape::new(self.primitive)
    }

    pub fn is_convex(&self) -> bool {
        matches!(self.kind, Kind::Bounded | Kind::Unbounded) && self.name != "double cone"
    }
}

/// Round cones: both radii, the height, and the heights of the seams.
const ROUND_CONES: [(&str, [f64; 3], &[f64]); 4] = [
    ("round cone", [1.0, 0.5, 2.0], &[0.25, 2.125]),
    ("widening round cone", [0.25, 1.0, 1.5], &[-0.125, 1.0]),
    ("straight round cone", [1.0, 1.0, 2.0], &[0.0, 2.0]),
    ("round cone of one ball", [0.5, 1.5, 0.75], &[]),
];

/// Rounded cuboids: the half extents of the core, and the radius.
const ROUNDED_CUBOIDS: [(&str, [f64; 3], f64); 2] =
    [("rounded cuboid", [0.75, 0.75, 0.25], 0.25), ("cushion", [1.0, 0.0, 0.5], 0.5)];

fn rounded_cuboid<S: Exact>(half: [f64; 3], radius: f64) -> (Primitive<S>, Solid) {
    let [x, y, z] = half.map(n::<S>);
    let cuboid = RoundedCuboid::new(x, y, z, n(radius)).expect("the sizes are within the budget");
    let exact = |size: f64| n::<S>(size).exact();
    (cuboid.into(), Solid::RoundedCuboid(oracle::RoundedCuboid { half: half.map(exact), radius: exact(radius) }))
}

/// Tori: the major and the minor radius. The least is a thousandth that every type holds exactly.
const TORI: [(&str, f64, f64); 3] =
    [("torus", 1.0, 0.25), ("torus with a narrow hole", 1.0, 0.875), ("thin torus", 1.0, 1.0 / 1024.0)];

/// A prism with two parallel sides and slanted ones; and a block without an edge and without a corner. With the heights
/// and the distances at which something changes.
const OF_HALF_SPACES: [(Described<f64>, &[f64], &[f64]); 2] = [
    (
        Described::Prism { corners: [[1.0, 0.5], [1.0, -0.5], [0.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]], height: 2.0 },
        &[0.0, 2.0],
        &[1.0, 0.5],
    ),
    (
        Described::Polyhedron {
            corners: [[-1.0, -0.5, -1.0], [1.0, 1.5, 1.0]],
            facets: [[[1.0, 1.0, 0.0], [1.0, 1.0, 0.0]], [[-1.0, 0.0, 0.5], [-1.0, -1.0, 2.0]]],
        },
        &[-0.5, 1.5],
        &[1.0, 0.5],
    ),
];

fn of_half_spaces<S: Exact>(described: &Described<f64>) -> (&'static str, Primitive<S>, Solid) {
    let described = described.try_map(|size| S::from_f64(*size)).expect("the sizes are within the type");
    let shape = described.shape().expect("the sizes are within the budget");
    (described.name(), *shape.primitive(), described.solid())
}

/// Names, radii at the base and at the top, and whether the ends are closed.
const FRUSTUMS: [(&str, f64, f64, bool); 7] = [
    ("frustum", 1.0, 0.5, true),
    ("widening frustum", 0.5, 1.5, true),
    ("straight frustum", 1.0, 1.0, true),
    ("spire", 1.0, 0.0, true),
    ("open frustum", 1.0, 0.5, false),
    ("open straight frustum", 1.0, 1.0, false),
    ("open spire", 1.0, 0.0, false),
];

/// Every kind of solid and of flat part, in sizes that every type holds exactly.
pub fn cases<S: Exact>() -> Vec<Case<S>> {
    let mut cases: Vec<Case<S>> = vec![];
    let d = |value: f64| n::<S>(value).exact();
    let mut add = |name, kind, primitive: Primitive<S>, solid, seams: &[f64], radii: &[f64]| {
        cases.push(Case { name, kind, primitive, solid, seams: seams.to_vec(), radii: radii.to_vec() });
    };
    let sizes = "the sizes are within the budget";
    let sphere = Sphere::new(n(1.5)).expect(sizes);
    add("sphere", Kind::Bounded, sphere.into(), Solid::Sphere { radius: d(1.5) }, &[], &[1.5]);
    let cylinder = |extent| Solid::Cylinder { radius: d(1.0), extent };
    let infinite = Cylinder::infinite(n(1.0)).expect(sizes);
    add("infinite cylinder", Kind::Unbounded, infinite.into(), cylinder(CylinderExtent::Infinite), &[], &[1.0]);
    let open = Cylinder::open(n(1.0), n(2.0)).expect(sizes);
    add("open cylinder", Kind::Open, open.into(), cylinder(CylinderExtent::Open(d(2.0))), &[0.0, 2.0], &[1.0]);
    let capped = Cylinder::capped(n(1.0), n(2.0)).expect(sizes);
    add("capped cylinder", Kind::Bounded, capped.into(), cylinder(CylinderExtent::Capped(d(2.0))), &[0.0, 2.0], &[1.0]);
    let cone = |slope: f64, extent| Solid::Cone { slope: d(slope), extent };
    let double = Cone::double(n(0.5)).expect(sizes);
    add("double cone", Kind::Unbounded, double.into(), cone(0.5, ConeExtent::Double), &[0.0], &[0.5, 1.0]);
    let nappe = Cone::nappe(n(1.0)).expect(sizes);
    add("nappe", Kind::Unbounded, nappe.into(), cone(1.0, ConeExtent::Nappe), &[0.0], &[0.5, 1.0]);
    let open = Cone::open(n(1.0), n(2.0)).expect(sizes);
    add("open cone", Kind::Open, open.into(), cone(1.0, ConeExtent::Open(d(2.0))), &[0.0, 2.0], &[1.0, 2.0]);
    let capped = Cone::capped(n(0.5), n(2.0)).expect(sizes);
    add("capped cone", Kind::Bounded, capped.into(), cone(0.5, ConeExtent::Capped(d(2.0))), &[0.0, 2.0], &[0.5, 1.0]);
    let frustum = |base: f64, top: f64, height: f64, capped| Solid::Frustum {
        base_radius: d(base),
        top_radius: d(top),
        height: d(height),
        capped,
    };
    for (name, base, top, capped) in FRUSTUMS {
        let constructor = if capped { Cone::frustum } else { Cone::frustum_open };
        let kind = if capped { Kind::Bounded } else { Kind::Open };
        let primitive = constructor(n(base), n(top), n(2.0)).expect(sizes).into();
        add(name, kind, primitive, frustum(base, top, 2.0, capped), &[0.0, 2.0], &[base, top]);
    }
    for (name, height) in [("capsule", 2.0), ("capsule without a side", 0.0)] {
        let capsule = Capsule::new(n(1.0), n(height)).expect(sizes);
        let solid = Solid::Capsule { radius: d(1.0), height: d(height) };
        add(name, Kind::Bounded, capsule.into(), solid, &[0.0, height], &[1.0]);
    }
    for (name, [a, b, r, low, high], radii, capped) in [
        ("paraboloid", [0.0, 0.25, 0.0, 0.0, 2.0], [0.0, 1.0], true),
        ("ball zone", [-1.0, 0.0, 1.25, -0.75, 1.0], [1.0, 0.75], true),
        ("hourglass", [0.25, 0.0, 0.0, -2.0, 1.0], [1.0, 0.5], true),
        ("tower", [1.0, 0.0, 0.75, -1.0, 1.0], [1.25, 1.25], true),
        ("open paraboloid", [0.0, 0.25, 0.0, 0.0, 2.0], [0.0, 1.0], false),
        ("open tower", [1.0, 0.0, 0.75, -1.0, 1.0], [1.25, 1.25], false),
    ] {
        let revolved = Revolved::new(n(a), n(b), n(r), [n(low), n(high)]).expect(sizes);
        let revolved = if capped { revolved } else { revolved.open() };
        let kind = match name {
            _ if !capped => Kind::Open,
            "hourglass" | "tower" => Kind::NotConvex,
            _ => Kind::Bounded,
        };
        let solid = oracle::Revolved { a: d(a), b: d(b), r: d(r), low: d(low), high: d(high), capped };
        add(name, kind, revolved.into(), Solid::Revolved(solid), &[low, high], &radii);
    }
    for (name, sizes, seams) in ROUND_CONES {
        let cone = RoundCone::new(n(sizes[0]), n(sizes[1]), n(sizes[2])).expect("sizes");
        let [base, top, height] = sizes.map(d);
        let solid = oracle::RoundCone::solid(base, top, height);
        add(name, Kind::Bounded, cone.into(), solid, seams, &sizes[..2]);
    }
    let [inner, outer] = [0.75, 1.25];
    let tube = Tube::new(n(inner), n(outer), n(2.0)).expect(sizes);
    let solid = Solid::Tube { inner: d(inner), outer: d(outer), height: d(2.0) };
    add("tube", Kind::NotConvex, tube.into(), solid, &[0.0, 2.0], &[inner, outer]);
    for (name, major, minor) in TORI {
        let torus = Torus::new(n(major), n(minor)).expect(sizes);
        let solid = Solid::Torus { major: d(major), minor: d(minor) };
        let radii = [major - minor, major, major + minor];
        add(name, Kind::NotConvex, torus.into(), solid, &[-minor, 0.0, minor], &radii);
    }
    let annulus = Annulus::new(n(inner), n(outer)).expect(sizes);
    let solid = Solid::Annulus { inner: d(inner), outer: d(outer) };
    add("annulus", Kind::Open, annulus.into(), solid, &[0.0], &[inner, outer]);
    add("plane", Kind::Open, Plane::new().into(), Solid::Plane, &[0.0], &[]);
    let disc = Disc::new(n(1.5)).expect(sizes).into();
    add("disc", Kind::Open, disc, Solid::Disc { radius: d(1.5) }, &[0.0], &[1.5]);
    let cuboid = Cuboid::new(n(1.0), n(1.0), n(0.5)).expect(sizes);
    let solid = Solid::Cuboid { half: [1.0, 1.0, 0.5].map(d) };
    add("cuboid", Kind::Bounded, cuboid.into(), solid, &[-1.0, 1.0], &[1.0, 0.5]);
    for (name, half @ [x, y, z], r) in ROUNDED_CUBOIDS {
        let (cuboid, solid) = rounded_cuboid::<S>(half, r);
        add(name, Kind::Bounded, cuboid, solid, &[-y - r, -y, y, y + r], &[x, x + r, z, z + r]);
    }
    for (described, seams, radii) in OF_HALF_SPACES {
        let (name, primitive, solid) = of_half_spaces::<S>(&described);
        add(name, Kind::Bounded, primitive, solid, seams, radii);
    }
    let (rectangle, half) = (Rectangle::new(n(1.5), n(0.5)).expect(sizes), [1.5, 0.5].map(d));
    add("rectangle", Kind::Open, rectangle.into(), Solid::Rectangle { half }, &[0.0], &[1.5, 0.5]);
    let corners = [[-1.0, 0.5, -1.0], [1.0, 0.0, 1.0], [1.0, 1.0, -1.0]];
    let [a, b, c] = corners.map(v);
    let triangle = Triangle::new(a, b, c).expect(sizes);
    let vertices = corners.map(|corner| corner.map(d));
    add("triangle", Kind::Open, triangle.into(), Solid::Triangle { vertices }, &[0.0, 0.5, 1.0], &[1.0]);
    cases
}

/// The cases of one kind.
pub fn cases_of<S: Exact>(kind: Kind) -> Vec<Case<S>> {
    let mut cases = cases::<S>();
    cases.retain(|case| case.kind == kind);
    cases
}

/// The 26 directions with components of -1, 0 and 1, of which the first six run along the axes.
pub fn lattice_directions() -> Vec<[f64; 3]> {
    let mut all = vec![];
    for x in [-1.0, 0.0, 1.0] {
        for y in [-1.0, 0.0, 1.0] {
            for z in [-1.0, 0.0, 1.0] {
                if [x, y, z] != [0.0; 3] {
                    all.push([x, y, z]);
                }
            }
        }
    }
    all.sort_by_key(|d: &[f64; 3]| d.iter().filter(|c| **c != 0.0).count());
    all
}

/// Rays that start at, run along, or pass through what is special about the case: rims, seams, walls, cap planes, the
/// apex, the axis. The second number is true if every number on the way is exact, so that no rounding excuses anything.
pub fn edge_rays<S: Exact>(case: &Case<S>) -> Vec<(Ray<S>, bool)> {
    let mut across = vec![0.0, 0.25, 3.0];
    for radius in &case.radii {
        across.extend([*radius, -radius]);
    }
    let mut heights = vec![-3.0, 0.25, 1.0, 4.0];
    heights.extend(&case.seams);
    across.sort_by(f64::total_cmp);
    across.dedup();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    let mut rays = vec![];
    for x in &across {
        for y in &heights {
            for z in &across {
                // Off the axes in one of the two is enough.
                if *z != 0.0 && x.abs() != 0.25 && x.abs() != z.abs() && *x != 0.0 {
                    continue;
                }
                for (index, along) in lattice_directions().into_iter().enumerate() {
                    let ray = Ray::new(v([*x, *y, *z]), direction(along)).expect("the origin is within the budget");
                    rays.push((ray.with_range(Range::line()), index < 6));
                }
            }
        }
    }
    rays
}

/// A ray aimed at the neighbourhood of the solid, from 3 to 8 away.
pub fn random_ray<S: Exact>(random: &mut Random) -> Ray<S> {
    let towards = random.unit_vector::<S>().to_f64();
    let distance = random.between(3.0, 8.0);
    let from = [0, 1, 2].map(|i| if i == 1 { 1.0 - towards[1] * distance } else { -towards[i] * distance });
    let aim: [f64; 3] = [(); 3].map(|()| random.between(-1.6, 1.6));
    let along = [0, 1, 2].map(|i| aim[i] + if i == 1 { 1.0 } else { 0.0 } - from[i]);
    Ray::new(v(from), direction(along)).expect("the origin is within the budget")
}

/// How the crate's answer compares with the exact one.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The same hits; the greatest error of a `t` in units in the last place.
    Same(f64),
    /// Not the same, but the exact answer lies within the given distance of another one.
    Tie,
    /// Wrong.
    Wrong(String),
}

/// Compares hits with exact ones; `tie` is the distance in `t` within which two ends, or an end and a seam or an end of
/// the range, cannot be told apart.
pub fn compare<S: Exact>(case: &Case<S>, ray: &Ray<S>, hits: &Hits<S>, tie: f64) -> Verdict {
    let exact = expected(&case.solid, ray);
    let verdict = compare_answers(hits, &exact);
    if let Verdict::Same(_) = verdict {
        return verdict;
    }
    if tie > 0.0 && is_tie(case, ray, hits, &exact, tie) {
        return Verdict::Tie;
    }
    Verdict::Wrong(format!("{} in {}: {ray:?} gives {hits:?}, exactly {exact:?}", case.name, S::name()))
}

/// Compares hits with exact ones: [`Verdict::Same`], or wrong.
pub fn compare_answers<S: Exact>(hits: &Hits<S>, exact: &oracle::InRange) -> Verdict {
    let same = hits.len() == exact.hits.len()
        && hits.starts_inside() == exact.starts_inside
        && hits.coincident().is_some() == exact.coincident
        && hits
            .iter()
            .zip(&exact.hits)
            .all(|(hit, exact)| same_part(hit.part, exact.part) && same_crossing(hit.crossing, exact.crossing));
    if !same {
        return Verdict::Wrong(format!("{hits:?}, exactly {exact:?}"));
    }
    let error =
        |(hit, exact): (&raylet::Hit<S>, &oracle::ExpectedHit)| exact.t.error_in(&hit.t.exact(), &S::unit_at(&exact.t));
    Verdict::Same(hits.iter().zip(&exact.hits).map(error).fold(0.0, f64::max))
}

/// Of a primitive with straight edges: whether a ray that starts a hair beside has another number of hits.
fn is_at_an_edge<S: Exact>(case: &Case<S>, ray: &Ray<S>, hits: usize, tie: f64) -> bool {
    let (Solid::Triangle { .. } | Solid::Cuboid { .. } | Solid::HalfSpaces(_) | Solid::Rectangle { .. }) = case.solid
    else {
        return false;
    };
    let line = super::exact_types::exact_line(ray);
    let (start, end) = (ray.range().start().exact(), ray.range().end().exact());
    (0..6).any(|side| {
        let mut beside = line.clone();
        let off = super::oracle::exact_f64(if side < 3 { tie } else { -tie });
        beside.origin[side % 3] = &beside.origin[side % 3] + &off;
        oracle::hits_in_range(&oracle::solve(&case.solid, &beside), &start, Some(&end)).hits.len() != hits
    })
}

fn is_tie<S: Exact>(case: &Case<S>, ray: &Ray<S>, hits: &Hits<S>, exact: &oracle::InRange, tie: f64) -> bool {
    let line = oracle::solve(&case.solid, &super::exact_types::exact_line(ray));
    let mut ends: Vec<f64> = vec![];
    match &line {
        oracle::Answer::Spans(spans) => {
            ends.extend(spans.iter().flat_map(|span| [&span.enter, &span.exit]).flatten().map(|end| end.t.to_f64()));
        }
        oracle::Answer::Crossings(crossings) => ends.extend(crossings.iter().map(|crossing| crossing.t.to_f64())),
        oracle::Answer::Coincident { .. } => return false,
    }
    let touches =
        matches!(&line, oracle::Answer::Crossings(list) if list.iter().any(|c| c.side == oracle::Approach::Touch));
    let own: Vec<f64> = hits.iter().map(|hit| hit.t.to_f64()).collect();
    let close = |list: &[f64]| list.windows(2).any(|pair| (pair[0] - pair[1]).abs() < tie);
    let (low, high) = (ray.range().start().to_f64(), ray.range().end().to_f64());
    let (origin, along) = (ray.origin().to_f64(), ray.direction().to_f64());
    let at_seam = |t: &f64| case.seams.iter().any(|seam| (origin[1] + t * along[1] - seam).abs() < tie);
    let at_end = |t: &f64| (t - low).abs() < tie || (t - high).abs() < tie;
    is_at_an_edge(case, ray, exact.hits.len(), tie)
        || close(&ends)
        || (exact.hits.is_empty() && close(&own))
        || (exact.hits.is_empty() && hits.len() == 1 && hits[0].crossing == Crossing::Touch)
        || touches
        || ends.iter().chain(&own).any(|t| at_seam(t) || at_end(t))
}

/// Fails unless the answer is the exact one, in a case where no rounding excuses anything.
pub fn assert_exact<S: Exact>(case: &Case<S>, ray: &Ray<S>) {
    if let Verdict::Wrong(message) = compare(case, ray, &case.shape().hits(ray), 0.0) {
        panic!("{message}");
    }
}

/// The hits as the tests write them down.
pub fn summary<S: Exact>(hits: &Hits<S>) -> Vec<(f64, Part, Crossing)> {
    hits.iter().map(|hit| (hit.t.to_f64(), hit.part, hit.crossing)).collect()
}

/// Defines a test for each number type from a generic function of the same name.
#[macro_export]
macro_rules! every_type {
    ($($promise:ident),+ $(,)?) => {
        $(
            mod $promise {
                #[test]
                fn f32() {
                    super::$promise::<f32>();
                }
                #[test]
                fn f64() {
                    super::$promise::<f64>();
                }
                #[test]
                fn i16f16() {
                    super::$promise::<fixed::types::I16F16>();
                }
                #[test]
                fn i32f32() {
                    super::$promise::<fixed::types::I32F32>();
                }
            }
        )+
    };
}
