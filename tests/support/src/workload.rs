//! Workloads: what kinds of rays the accuracy tables speak of.

use super::exact_types::Exact;
use super::random::{Random, add, dot, normalize, scale};
use super::subject::Subject;
use raylet::scalar::UnitScalar;
use raylet::{Leaving, Ray, Shape, UnitVec3, Vec3};

/// A kind of ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Workload {
    /// From 3 to 8 away at a point well inside.
    Benign,
    /// From this far away at a point well inside.
    Away(f64),
    /// Past the side at this fraction of the radius inside or outside of touching.
    Grazing(f64),
    /// From a point inside, anywhere.
    Inside,
    /// From a point on the side, rounded to the number type.
    OnSurface,
    /// This far off the axis's direction.
    NearAxis(f64),
    /// This far off a generator's direction.
    NearGenerator(f64),
    /// At this angle to a flat's or a cap's plane, at a point of it.
    NearPlane(f64),
    /// At a rim, a seam or the apex, within a thousandth.
    Rims,
    /// With one or two zero components.
    ZeroComponents,
    /// From a hit of the solid to this side of it, and said to depart from there; every fourth nearly along the
    /// surface.
    Departing(Leaving),
}

/// A line's origin and direction.
pub type Line = ([f64; 3], [f64; 3]);

/// Those that are timed too, and given to other libraries.
pub const WORKLOADS: [Workload; 21] = [
    Workload::Benign,
    Workload::Away(100.0),
    Workload::Away(1_000.0),
    Workload::Away(10_000.0),
    Workload::Away(1_000_000.0),
    Workload::Grazing(1e-1),
    Workload::Grazing(1e-2),
    Workload::Grazing(1e-3),
    Workload::Grazing(1e-4),
    Workload::Grazing(1e-5),
    Workload::Grazing(1e-6),
    Workload::Grazing(1e-7),
    Workload::Inside,
    Workload::OnSurface,
    Workload::NearAxis(1e-2),
    Workload::NearAxis(1e-4),
    Workload::NearGenerator(1e-2),
    Workload::NearGenerator(1e-4),
    Workload::NearGenerator(1e-7),
    Workload::Rims,
    Workload::ZeroComponents,
];

/// Those of which errors are measured alone.
pub const FURTHER: [Workload; 15] = [
    Workload::NearAxis(1e-1),
    Workload::NearAxis(1e-3),
    Workload::NearAxis(1e-6),
    Workload::NearGenerator(1e-1),
    Workload::NearGenerator(1e-3),
    Workload::NearGenerator(1e-6),
    Workload::NearPlane(1e-1),
    Workload::NearPlane(1e-2),
    Workload::NearPlane(1e-3),
    Workload::NearPlane(1e-4),
    Workload::NearPlane(1e-5),
    Workload::NearPlane(1e-6),
    Workload::NearPlane(1e-7),
    Workload::Departing(Leaving::Inwards),
    Workload::Departing(Leaving::Outwards),
];

impl Workload {
    pub fn name(self) -> String {
        match self {
            Self::Benign => "benign".into(),
            Self::Away(distance) => format!("{distance} away"),
            Self::Grazing(off) => format!("grazing {off:.0e}"),
            Self::Inside => "inside".into(),
            Self::OnSurface => "on the surface".into(),
            Self::NearAxis(off) => format!("{off:.0e} off the axis"),
            Self::NearGenerator(off) => format!("{off:.0e} off a generator"),
            Self::NearPlane(off) => format!("{off:.0e} off a plane"),
            Self::Rims => "rims".into(),
            Self::ZeroComponents => "zero components".into(),
            Self::Departing(Leaving::Inwards) => "departing inwards".into(),
            Self::Departing(Leaving::Outwards) => "departing outwards".into(),
        }
    }

    /// The next ray; `None` where the workload has no sense for the subject, or the draw does not fit the type.
    pub fn ray<S: Exact>(self, subject: &Subject<S>, random: &mut Random) -> Option<Ray<S>> {
        let ray = Self::rounded(self.line(subject, random)?)?;
        self.from_there(&subject.shape, ray, random)
    }

    /// The ray in the number type.
    pub fn rounded<S: Exact>((origin, direction): Line) -> Option<Ray<S>> {
        let origin = Vec3::<S>::from_f64(origin).ok()?;
        // A direction as fine as the type holds, not as fine as its coordinates.
        Ray::new(origin, UnitVec3::from_components(direction.map(S::Unit::from_f64)).ok()?).ok()
    }

    /// The ray itself; or one that departs from one of its hits on the shape.
    pub fn from_there<S: Exact>(self, shape: &Shape<S>, ray: Ray<S>, random: &mut Random) -> Option<Ray<S>> {
        let Self::Departing(leaving) = self else { return Some(ray) };
        let hits = shape.hits(&ray);
        let hit = hits.get(random.below(hits.len().max(1)))?;
        let surface = shape.surface(&ray, hit);
        let normal = surface.normal().to_f64();
        let flat = if random.below(4) == 0 { 1.0 - 10.0_f64.powf(random.between(-9.0, -2.0)) } else { 0.0 };
        let any = random.direction();
        let any = normalize(add(any, scale(normal, -flat * dot(any, normal))));
        let leads_out = dot(any, normal) > 0.0;
        let direction = if leads_out == (leaving == Leaving::Outwards) { any } else { scale(any, -1.0) };
        let direction = UnitVec3::from_components(direction.map(S::Unit::from_f64)).ok()?;
        Some(Ray::new(surface.point(), direction).ok()?.departing(surface.departure(0, leaving)))
    }

    /// The next line at the subject as it is before it is placed; `None` where the workload has no sense for it.
    pub fn line<S: Exact>(self, subject: &Subject<S>, random: &mut Random) -> Option<Line> {
        Some(match self {
            Self::Benign | Self::Departing(_) => {
                let distance = random.between(3.0, 8.0);
                Self::aimed(subject.inner_point(random), random.direction(), distance)
            }
            Self::Away(distance) => {
                let distance = distance * random.between(0.8, 1.0);
                Self::aimed(subject.inner_point(random), random.direction(), distance)
            }
            Self::Grazing(off) => {
                if subject.is_flat() {
                    return None;
                }
                let (point, normal) = subject.side_point(random);
                let direction = random.perpendicular(normal);
                let off = off * random.sign() * random.between(1.0, 2.0);
                Self::aimed(add(point, scale(normal, off)), direction, random.between(1.0, 4.0))
            }
            Self::Inside => (subject.inner_point(random), random.direction()),
            Self::OnSurface => (subject.side_point(random).0, random.direction()),
            Self::NearAxis(off) => {
                let [x, _, z] = random.direction();
                let direction = normalize([x * off, random.sign(), z * off]);
                Self::aimed(subject.inner_point(random), direction, random.between(3.0, 8.0))
            }
            Self::NearGenerator(off) => {
                if !subject.is_cone() {
                    return None;
                }
                let angle = random.between(0.0, std::f64::consts::TAU);
                let slope = subject.slope();
                let generator = normalize([libm::cos(angle) * slope, 1.0, libm::sin(angle) * slope]);
                let direction = normalize(add(scale(generator, random.sign()), scale(random.direction(), off)));
                Self::aimed(subject.inner_point(random), direction, random.between(3.0, 8.0))
            }
            Self::NearPlane(off) => {
                let (point, normal) = subject.flat_point(random)?;
                let along = random.perpendicular(normal);
                let direction = normalize(add(along, scale(normal, off * random.sign() * random.between(0.5, 1.0))));
                Self::aimed(point, direction, random.between(3.0, 8.0))
            }
            Self::Rims => {
                let near = scale(random.direction(), 1e-3 * random.unit());
                Self::aimed(add(subject.rim_point(random), near), random.direction(), random.between(3.0, 8.0))
            }
            Self::ZeroComponents => {
                let mut direction = random.direction();
                let first = (random.next() % 3) as usize;
                direction[first] = 0.0 * random.sign();
                if random.next() & 1 == 0 {
                    direction[(first + 1) % 3] = 0.0 * random.sign();
                }
                Self::aimed(subject.inner_point(random), normalize(direction), random.between(3.0, 8.0))
            }
        })
    }

    pub fn aimed(target: [f64; 3], direction: [f64; 3], distance: f64) -> Line {
        (add(target, scale(direction, -distance)), direction)
    }
}
