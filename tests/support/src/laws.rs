//! What the laws share: a primitive, placed, and one ray; what each tier may be off by; and the tests of a law in every
//! number type and tier.

use super::cases::{Case, n};
use super::exact_types::{Exact as Number, oracle_part};
use super::laws_distance::{Point, depth, distance_from};
pub use super::laws_pose::{POSES, Pose};
use super::oracle::{self, Dyadic, Solid};
use super::random::Random;
use super::subject::Subject;
use super::workload::Workload;
use proptest::test_runner::TestCaseError;
use raylet::tier::{Exact, Fast, Plain, Stable, Tier};
use raylet::{Crossing, Hit, Hits, Part, Range, Ray, Shape};

/// What a law says of one ray.
pub type Law = Result<(), TestCaseError>;

/// A tier, so that a law can tell which it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Grade {
    Plain,
    Fast,
    Stable,
    Exact,
}

/// A tier that says which it is.
pub trait Graded<S: Number>: Tier<S> {
    const GRADE: Grade;
}

impl<S: Number> Graded<S> for Plain {
    const GRADE: Grade = Grade::Plain;
}
impl<S: Number> Graded<S> for Fast {
    const GRADE: Grade = Grade::Fast;
}
impl<S: Number> Graded<S> for Stable {
    const GRADE: Grade = Grade::Stable;
}
impl<S: Number> Graded<S> for Exact
where
    Exact: Tier<S>,
{
    const GRADE: Grade = Grade::Exact;
}

/// A primitive, placed, and one ray.
pub struct Setting<S: Number> {
    pub name: &'static str,
    pub nature: Nature,
    pub solid: Solid,
    /// As it stands in its own frame, and as it is placed.
    pub unplaced: Shape<S>,
    pub shape: Shape<S>,
    pub pose: Pose<S>,
    pub index: usize,
    /// The ray in the primitive's frame, and in the world.
    pub local_ray: Ray<S>,
    pub ray: Ray<S>,
}

/// What crossings a solid may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nature {
    Bounded,
    /// Of two intervals.
    NotConvex,
    Unbounded,
    Open,
}

/// A subject, a workload, a pose, and the seed of one ray.
pub type Drawn = (&'static str, Workload, usize, u64);

impl<S: Number> Setting<S> {
    /// `None` for a draw that fits no ray of the type.
    pub fn draw((name, workload, index, seed): Drawn) -> Option<(Self, Random)> {
        let subject = Subject::<S>::new(name);
        let mut random = Random(seed);
        let local_ray = workload.ray(&subject, &mut random)?;
        let nature = match name {
            "cylinder infinite" | "cone double" | "cone nappe" => Nature::Unbounded,
            "plane" | "disc" | "annulus" | "rectangle" | "triangle" => Nature::Open,
            "hyperboloid" | "tube" | "torus" => Nature::NotConvex,
            _ if name.ends_with("open") => Nature::Open,
            _ => Nature::Bounded,
        };
        let pose = Pose::new(index);
        let (unplaced, shape) = (subject.shape, pose.place(subject.shape));
        let ray = pose.ray(&local_ray)?;
        Some((Self { name, nature, solid: subject.solid, unplaced, shape, pose, index, local_ray, ray }, random))
    }

    /// A ray at an edge of a case, in one of the poses; `None` if it does not fit the type there.
    pub fn at_edge(case: &Case<S>, local_ray: Ray<S>, index: usize) -> Option<Self> {
        use super::cases::Kind;
        let nature = match case.kind {
            Kind::Bounded => Nature::Bounded,
            Kind::NotConvex => Nature::NotConvex,
            Kind::Unbounded => Nature::Unbounded,
            Kind::Open => Nature::Open,
        };
        let (unplaced, solid, pose) = (case.shape(), case.solid.clone(), Pose::new(index));
        let (shape, ray) = (pose.place(unplaced), pose.ray(&local_ray)?.with_range(local_ray.range()));
        Some(Self { name: case.name, nature, solid, unplaced, shape, pose, index, local_ray, ray })
    }

    /// The same primitive and the local ray, unplaced.
    pub fn in_own_frame(&self) -> Self {
        let (shape, ray) = (self.unplaced, self.local_ray);
        Self { solid: self.solid.clone(), shape, pose: Pose::World, index: 0, ray, ..*self }
    }

    pub fn is_convex(&self) -> bool {
        matches!(self.nature, Nature::Bounded | Nature::Unbounded) && !self.name.contains("double")
    }

    /// True for a solid without end.
    pub fn is_bounded(&self) -> bool {
        matches!(self.nature, Nature::Bounded | Nature::NotConvex)
    }

    /// The point of the ray at `t`, in exact numbers, in the primitive's frame.
    pub fn local_point(&self, ray: &Ray<S>, t: &Dyadic) -> Point {
        self.pose.point_to_own_frame(&super::exact_types::exact_line(ray).point_at(t))
    }

    /// The ray's line in the primitive's frame.
    pub fn local_line(&self, ray: &Ray<S>) -> oracle::Line {
        let [origin, one] = [Dyadic::zero(), Dyadic::from(1)].map(|t| self.local_point(ray, &t));
        let direction = [0, 1, 2].map(|i| &one[i] - &origin[i]);
        oracle::Line { origin, direction }
    }

    /// [`Setting::local_point`]; of a ball, which has no axes, only moved: stored axes are perpendicular but for their
    /// last bits.
    fn point_as_the_solid_sees_it(&self, ray: &Ray<S>, t: &Dyadic) -> Point {
        match (&self.solid, self.pose) {
            (Solid::Sphere { .. }, Pose::Frame(frame)) => {
                let position = frame.position().to_array().map(Number::exact);
                let point = super::exact_types::exact_line(ray).point_at(t);
                [0, 1, 2].map(|i| &point[i] - &position[i])
            }
            _ => self.local_point(ray, t),
        }
    }

    /// How far the ray's point at `t` is from a part, in exact numbers.
    pub fn off(&self, ray: &Ray<S>, t: &Dyadic, part: Part) -> f64 {
        distance_from(&self.solid, oracle_part(part), &self.point_as_the_solid_sees_it(ray, t))
    }

    /// How deep the ray's point at `t` lies, in exact numbers.
    pub fn depth(&self, ray: &Ray<S>, t: &Dyadic) -> f64 {
        depth(&self.solid, &self.point_as_the_solid_sees_it(ray, t))
    }
}

pub fn is_float<S: Number>() -> bool {
    S::name().starts_with('f')
}

/// The type's unit: of a float that at 1.
pub fn unit<S: Number>() -> f64 {
    match S::name().as_str() {
        "f32" => f64::from(f32::EPSILON),
        "f64" => f64::EPSILON,
        _ => S::BUDGET.smallest_size.to_f64(),
    }
}

/// One unit in the last place at `t`.
pub fn unit_at<S: Number>(t: S) -> f64 {
    let t = t.magnitude();
    (&t.next_up().exact() - &t.exact()).to_f64()
}

/// Ranges that end or start at this `t`, or next to it.
pub fn ranges_next_to<S: Number>(t: S) -> Vec<Range<S>> {
    let (below, above) = (-(-t).next_up(), t.next_up());
    let [first, last] = [Range::line().start(), Range::line().end()];
    [[first, below], [first, t], [t, last], [above, last]]
        .into_iter()
        .filter_map(|[a, b]| Range::new(a, b).ok())
        .collect()
}

/// The unit of the numbers that the answer is made from: ray, `t` and solid.
pub fn unit_on_the_way<S: Number>(ray: &Ray<S>, t: f64) -> f64 {
    let reach = ray.origin().to_f64().iter().fold(t.abs(), |most, c| most.max(c.abs())).max(2.0);
    if is_float::<S>() { unit::<S>() * reach } else { unit::<S>() }
}

/// How far from the surface a hit may lie in space, whatever the angle: the bound that every law here shares.
///
/// `Exact`: one unit in the last place of `t`, and nothing else. `Stable`: 16 units of the numbers on the way. `Fast`
/// and `Plain` subtract plainly: what their quadratic equation is off by, `eta`, grows with the square of the distance
/// and with `1 / a` towards a cone's generator or a cylinder's axis, where one root cancels; at a distance `rho` from
/// the axis that is `eta / rho` in space, and at an apex its root.
pub fn bound<S: Number, T: Graded<S>>(setting: &Setting<S>, ray: &Ray<S>, t: S) -> f64 {
    let growth = setting.pose.growth();
    let units = unit_on_the_way(ray, t.to_f64()) * growth;
    match T::GRADE {
        // The direction is as long as 1 to 2^-20.
        Grade::Exact => unit_at(t) * growth * (1.0 + 2.0_f64.powi(-20)),
        Grade::Stable => {
            if is_float::<S>() {
                // Of the 16 units of `t` that are promised; the most that was seen in 10^6 rays is 4.9, along a
                // generator.
                6.0 * units
            } else {
                2.0 * units
            }
        }
        Grade::Plain | Grade::Fast => {
            let start = setting.local_point(ray, &Dyadic::zero()).map(|c| c.to_f64());
            let one = setting.local_point(ray, &Dyadic::from(1)).map(|c| c.to_f64());
            let [dx, dy, dz] = [0, 1, 2].map(|i| one[i] - start[i]);
            let square = square_of_slope(&setting.solid);
            let a = match setting.solid {
                Solid::Cylinder { .. }
                | Solid::Cone { .. }
                | Solid::Frustum { .. }
                | Solid::Capsule { .. }
                | Solid::Tube { .. }
                | Solid::RoundCone(_)
                | Solid::Revolved(_) => (dx * dx + dz * dz - square * dy * dy).abs(),
                _ => 1.0,
            };
            let [x, _, z] = setting.local_point(ray, &t.exact()).map(|c| c.to_f64());
            let reach =
                ray.origin().to_f64().iter().fold(t.to_f64().abs(), |most, c| most.max(c.abs())).max(2.0) * growth;
            let eta = 4.0 * units * reach * (1.0 + square.abs()) / a.max(1e-100);
            // The equation of a torus is as steep as its tube is wide.
            let across = if let Solid::Torus { minor, .. } = &setting.solid { minor.to_f64() } else { x.hypot(z) };
            eta / across.max(eta.sqrt())
        }
    }
}

/// The square of radius over height of the side; of a quadric of revolution that of the cone that it approaches, which
/// may be negative.
fn square_of_slope(solid: &Solid) -> f64 {
    match solid {
        Solid::Cone { slope, .. } => slope.to_f64().powi(2),
        Solid::Frustum { base_radius, top_radius, height, .. } => {
            ((top_radius - base_radius).to_f64() / height.to_f64()).powi(2)
        }
        Solid::RoundCone(cone) if cone.ball().is_none() => {
            let [k, h] = [cone.difference(), cone.height.clone()].map(|c| c.to_f64());
            k * k / ((h - k) * (h + k))
        }
        Solid::Revolved(revolved) => revolved.a.to_f64(),
        _ => 0.0,
    }
}

/// Prints each new most that was needed of a bound, if the environment has `RAYLET_LAWS` (run with `--nocapture`).
pub fn note<S: Number, T: Graded<S>>(of: &str, setting: &Setting<S>, ratio: f64) {
    use std::collections::BTreeMap;
    use std::sync::{LazyLock, Mutex};
    static WANTED: LazyLock<bool> = LazyLock::new(|| std::env::var_os("RAYLET_LAWS").is_some());
    static MOST: Mutex<BTreeMap<String, f64>> = Mutex::new(BTreeMap::new());
    if *WANTED && ratio > 1e-4 {
        let row = format!(
            "{of}: {} {:?} {}",
            S::name(),
            T::GRADE,
            if setting.index > 3 {
                "affine"
            } else if setting.index > 0 {
                "frame"
            } else {
                "world"
            }
        );
        let mut most = MOST.lock().expect("no test panics while it holds the lock");
        let old = most.entry(row.clone()).or_insert(0.0);
        if ratio > *old {
            *old = ratio;
            println!(
                "NOTE {row}: {ratio:.3} {} {:?} {:?}",
                setting.name,
                setting.ray.origin().to_f64(),
                setting.ray.direction().to_f64()
            );
        }
    }
}

/// One hit, its `t` in exact numbers along the ray that it is measured on.
#[derive(Clone, Debug)]
pub struct Met {
    pub t: Dyadic,
    pub part: Part,
    pub crossing: Crossing,
}

/// The hits as they are.
pub fn met<S: Number>(hits: &Hits<S>) -> Vec<Met> {
    hits.iter().map(|hit: &Hit<S>| Met { t: hit.t.exact(), part: hit.part, crossing: hit.crossing }).collect()
}

impl<S: Number> Setting<S> {
    /// Whether two answers of a solid with ends have the same crossings on the same parts, or differ in no more than
    /// what moving the line by `bound` in space decides: a chord no deeper than that, a hit as near to both parts or to
    /// the surface between them, or a range that starts as near to the surface.
    pub fn alike(&self, ray: &Ray<S>, a: &[Met], b: &[Met], bound: f64) -> Result<bool, String> {
        let same = |(a, b): (&Met, &Met)| a.part == b.part && a.crossing == b.crossing;
        if a.len() == b.len() && a.iter().zip(b).all(same) {
            return Ok(true);
        }
        let start = ray.range().start().exact();
        if self.depth(ray, &start).abs() <= bound {
            return Ok(false);
        }
        let kinds = |list: &[Met]| list.iter().map(|met| met.crossing).collect::<Vec<_>>();
        if kinds(a) == kinds(b) {
            let near_both = |(a, b): (&Met, &Met)| {
                let off = |t: &Dyadic| self.off(ray, t, a.part).max(self.off(ray, t, b.part));
                // Or the line runs so near to the surface from one to the other.
                let middle = (&a.t + &b.t).scaled(-1);
                a.part == b.part || off(&a.t).min(off(&b.t)) <= bound || self.depth(ray, &middle).abs() <= bound
            };
            return if a.iter().zip(b).all(near_both) { Ok(false) } else { Err("another part".into()) };
        }
        let longer = if a.len() >= b.len() { a } else { b };
        // A touch is one point; a solid that is not convex has a gap between two chords.
        let touches = longer.iter().filter(|met| met.crossing == Crossing::Touch || longer.len() == 1);
        let pairs = longer.windows(2).map(|pair| (&pair[0], &pair[1])).chain(touches.map(|one| (one, one)));
        let depths = pairs.map(|(one, other)| self.depth(ray, &(&one.t + &other.t).scaled(-1)));
        let least = depths.fold(f64::INFINITY, |least, deep| if deep.abs() < least.abs() { deep } else { least });
        if least.abs() <= bound { Ok(false) } else { Err(format!("a chord {:.1} bounds deep", least / bound)) }
    }
}

/// The nearest number of the type, if it has one so large.
pub fn number<S: Number>(value: f64) -> Option<S> {
    (value.abs() < S::BUDGET.distance.to_f64()).then(|| n(value))
}

/// The settings of a test at edges: every case of the design, rays along and through all that is special about it.
pub fn each_edge<S: Number>(every: usize, mut law: impl FnMut(&Setting<S>, &mut Random) -> Law) {
    let mut random = Random(77);
    for case in super::cases::cases::<S>() {
        for (at, (ray, _)) in super::cases::edge_rays(&case).into_iter().step_by(every).enumerate() {
            for (index, range) in [(0, ray.range()), (at % POSES, ray.range()), (at % POSES, raylet::Range::FORWARD)] {
                let Some(setting) = Setting::at_edge(&case, ray.with_range(range), index) else { continue };
                if let Err(error) = law(&setting, &mut random) {
                    panic!("{} in {}, {:?}: {error}", case.name, S::name(), setting.shape);
                }
            }
        }
    }
}

/// Calls a generic law for every number type and every tier that it has; `$on` is a macro of type, tier and the rest.
#[macro_export]
macro_rules! in_every_tier {
    ($on:ident ! ($($rest:tt)*)) => {
        $on!(f32, raylet::tier::Plain, $($rest)*);
        $on!(f32, raylet::tier::Fast, $($rest)*);
        $on!(f32, raylet::tier::Stable, $($rest)*);
        $on!(f32, raylet::tier::Exact, $($rest)*);
        $on!(f64, raylet::tier::Plain, $($rest)*);
        $on!(f64, raylet::tier::Fast, $($rest)*);
        $on!(f64, raylet::tier::Stable, $($rest)*);
        $on!(fixed::types::I16F16, raylet::tier::Plain, $($rest)*);
        $on!(fixed::types::I16F16, raylet::tier::Fast, $($rest)*);
        $on!(fixed::types::I16F16, raylet::tier::Stable, $($rest)*);
        $on!(fixed::types::I16F16, raylet::tier::Exact, $($rest)*);
        $on!(fixed::types::I32F32, raylet::tier::Plain, $($rest)*);
        $on!(fixed::types::I32F32, raylet::tier::Fast, $($rest)*);
        $on!(fixed::types::I32F32, raylet::tier::Stable, $($rest)*);
        // Other splits of 32 bits: one in the default tier, one in the exact one, and all four tiers in the long form.
        $on!(fixed::types::I8F24, raylet::tier::Stable, $($rest)*);
        $on!(fixed::types::I20F12, raylet::tier::Exact, $($rest)*);
        #[cfg(feature = "every-type")]
        {
            $on!(fixed::types::I8F24, raylet::tier::Plain, $($rest)*);
            $on!(fixed::types::I8F24, raylet::tier::Fast, $($rest)*);
            $on!(fixed::types::I8F24, raylet::tier::Exact, $($rest)*);
            $on!(fixed::types::I20F12, raylet::tier::Plain, $($rest)*);
            $on!(fixed::types::I20F12, raylet::tier::Fast, $($rest)*);
            $on!(fixed::types::I20F12, raylet::tier::Stable, $($rest)*);
        }
    };
}

/// One law on one draw, in one type and tier.
#[macro_export]
macro_rules! law_on_draw {
    ($S:ty, $T:ty, $law:ident, $drawn:ident) => {
        if let Some((setting, mut random)) = Setting::<$S>::draw($drawn) {
            law::$law::<$S, $T>(&setting, &mut random)
                .map_err(|error| TestCaseError::fail(format!("{} at {}: {error}", stringify!($S), stringify!($T))))?;
        }
    };
}

/// One law on the rays at edges, in one type and tier.
#[macro_export]
macro_rules! law_at_edges {
    ($S:ty, $T:ty, $law:ident, $every:expr) => {
        support::laws::each_edge::<$S>($every, law::$law::<$S, $T>);
    };
}

/// Defines, for each law of the module `law`, a test on draws of subject, workload and pose, and one on rays at edges.
#[macro_export]
macro_rules! laws {
    ($($law:ident),+ $(,)?) => {
        $(
            proptest! {
                #![proptest_config(ProptestConfig {
                    cases: $crate::amount::amount(1600, 60_000),
                    failure_persistence: None,
                    rng_seed: RngSeed::Fixed(0x7261_796c_6574),
                    ..ProptestConfig::default()
                })]
                #[test]
                fn $law(
                    drawn in (
                        prop::sample::select(&support::subject::SUBJECTS[..]),
                        prop::sample::select(&support::workload::WORKLOADS[..]),
                        0..support::laws::POSES,
                        any::<u64>(),
                    )
                ) {
                    $crate::in_every_tier!(law_on_draw!($law, drawn));
                }
            }
        )+
        /// The same laws on rays at, along and through rims, seams, walls, caps and apexes.
        mod at_edges {
            use super::*;
            $(
                #[test]
                fn $law() {
                    $crate::in_every_tier!(law_at_edges!($law, $crate::amount::amount(61, 3)));
                }
            )+
        }
    };
}
