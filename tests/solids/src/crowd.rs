//! Crowds of solids that share faces, axes, centres and edges, and rays that meet several of them at one point.

use raylet::{Frame, Ray, Shape, UnitVec3, Vec3};
use support::described::{ConeExtent, CylinderExtent, Described};
use support::exact_types::Exact;
use support::oracle::Solid;
use support::placed::{Placed, Placement};
use support::random::{Random, add, scale};

/// Some solids, placed, with what the oracle knows of them.
pub struct Crowd<S: Exact> {
    pub shapes: Vec<Shape<S>>,
    pub solids: Vec<Solid>,
    pub placed: Vec<Placed<S>>,
    /// A point that many of them are near.
    centre: [f64; 3],
    /// What sizes and distances are multiplied by.
    unit: f64,
}

/// Sizes that coincide often, and that every type holds exactly.
const SIZES: [f64; 5] = [0.25, 0.5, 1.0, 1.5, 2.0];

/// What solids a crowd consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// All but quadrics of revolution, round cones, rounded cuboids, prisms and tubes.
    Others,
    /// Every third is a quadric of revolution or a tube.
    All,
    /// Every third is a round cone, a rounded cuboid or a prism.
    Further,
}

/// A quadric of revolution; not all of them are solids.
fn quadric<S: Exact>(random: &mut Random, unit: f64) -> Described<S> {
    let number = |x: f64| S::from_f64(x).expect("every tested type holds it");
    let a = number(random.pick(&[-1.0, -0.25, 0.0, 0.25, 1.0]));
    let b = number(random.pick(&[0.0, 0.0, 0.25, -0.5, 1.0]) * unit);
    let mut size = || number(random.pick(&SIZES) * unit);
    let [radius, low, high] = [size(), -size(), size()];
    // Often with an end at the origin, where others have theirs.
    let (radius, low) = match random.below(3) {
        0 => (S::ZERO, S::ZERO),
        1 => (radius, S::ZERO),
        _ => (radius, low),
    };
    Described::Revolved { a, b, radius, heights: [low, high], capped: random.below(8) > 0 }
}

fn tube<S: Exact>(random: &mut Random, unit: f64) -> Described<S> {
    let mut size = || random.pick(&SIZES) * unit;
    let (inner, wall, height) = (size(), size(), size());
    let [inner, outer, height] =
        [inner, inner + wall, height].map(|x| S::from_f64(x).expect("every tested type holds it"));
    Described::Tube { inner, outer, height }
}

fn round_cone<S: Exact>(random: &mut Random, unit: f64) -> Described<S> {
    let [base, top, height] =
        [(); 3].map(|()| S::from_f64(random.pick(&SIZES) * unit).expect("every tested type holds it"));
    Described::RoundCone { base, top, height }
}

fn rounded_cuboid<S: Exact>(random: &mut Random, unit: f64) -> Described<S> {
    let [x, y, z, radius] =
        [(); 4].map(|()| S::from_f64(random.pick(&SIZES) * unit).expect("every tested type holds it"));
    // Often without extent along an axis.
    let half = match random.below(3) {
        0 => [x, S::ZERO, z],
        1 => [S::ZERO, y, S::ZERO],
        _ => [x, y, z],
    };
    Described::RoundedCuboid { half, radius }
}

/// A house: two walls and a roof in plan, so that faces coincide with those of cuboids.
fn prism<S: Exact>(random: &mut Random, unit: f64) -> Described<S> {
    let mut size = || random.pick(&SIZES) * unit;
    let [x, z, roof, height] = [size(), size(), size(), size()];
    let corners = [[x, z], [x, -z], [0.0, -z - roof], [-x, -z], [-x, z]];
    let number = |x: f64| S::from_f64(x).expect("every tested type holds it");
    Described::Prism { corners: corners.map(|corner| corner.map(number)), height: number(height) }
}

fn described<S: Exact>(random: &mut Random, unit: f64, of: Of) -> Described<S> {
    if of == Of::Further && random.below(3) == 0 {
        return match random.below(3) {
            0 => round_cone(random, unit),
            1 => rounded_cuboid(random, unit),
            _ => prism(random, unit),
        };
    }
    if of == Of::All && random.below(3) == 0 {
        return if random.below(3) == 0 { tube(random, unit) } else { quadric(random, unit) };
    }
    let number = |x: f64| S::from_f64(x).expect("every tested type holds it");
    // Of a cone's slope there is no unit.
    let slope = number(random.pick(&SIZES));
    let mut size = || number(random.pick(&SIZES) * unit);
    let [a, b, c] = [size(), size(), size()];
    match random.below(12) {
        0 | 1 => Described::Sphere { radius: a },
        2 | 3 => Described::Cylinder { radius: a, extent: CylinderExtent::Capped(b) },
        4 => Described::Cylinder { radius: a, extent: CylinderExtent::Infinite },
        5 => Described::Cone { slope, extent: ConeExtent::Capped(b) },
        6 if a != b => Described::Frustum { base: a, top: b, height: c, capped: true },
        7 => Described::Capsule { radius: a, height: b },
        8 => Described::Cone { slope, extent: ConeExtent::Double },
        9 => Described::Cone { slope, extent: ConeExtent::Nappe },
        10 if random.below(2) == 0 => Described::Disc { radius: a },
        10 => Described::Cylinder { radius: a, extent: CylinderExtent::Open(b) },
        _ => Described::Cuboid { half: [a, b, c] },
    }
}

impl<S: Exact> Crowd<S> {
    /// Up to eight solids in a few frames: each frame is shared, or moved along the axes by sizes; one in six is
    /// stretched.
    pub fn random(random: &mut Random, of: Of) -> Self {
        Self::of_unit(random, 1.0, of)
    }

    /// The same, with all lengths multiplied by this.
    pub fn of_unit(random: &mut Random, unit: f64, of: Of) -> Self {
        let is_turned = random.below(2) == 0;
        let away = random.pick(&[0.0, 1.0, 8.0, 64.0]);
        let centre = scale(scale(random.direction(), away).map(f64::round), unit);
        let point = |p: [f64; 3]| Vec3::<S>::from_f64(p).expect("every tested type holds it");
        let axes = [random.direction(), random.direction()].map(|axis| UnitVec3::new(point(axis)).expect("not zero"));
        let mut crowd = Self { shapes: vec![], solids: vec![], placed: vec![], centre, unit };
        for _ in 0..2 + random.below(7) {
            let described = described::<S>(random, unit, of);
            let (Ok(shape), solid) = (described.shape(), described.solid()) else { continue };
            let shift = |random: &mut Random| random.pick(&[0.0, 0.0, 0.0, 0.5, 1.0, -0.5, -1.0, 2.0, -2.0]);
            let place = add(centre, scale([shift(random), shift(random), shift(random)], unit));
            let frame = if is_turned {
                // Turned alike; most in one place.
                let place = if random.below(3) > 0 { centre } else { place };
                Frame::looking(point(place), axes[0], axes[1])
            } else {
                Frame::at(point(place))
            };
            let Ok(frame) = frame else { continue };
            let placement = if random.below(6) == 0 {
                let factor = |random: &mut Random| S::from_f64(random.pick(&[0.25, 0.5, 1.0, 2.0, 3.0, 30.0]));
                let factors = [(); 3].map(|()| factor(random).expect("every tested type holds it"));
                Placement::Stretched(frame, factors)
            } else {
                Placement::Frame(frame)
            };
            let Ok(placed) = Placed::by(&shape, &solid, placement) else { continue };
            crowd.shapes.push(placed.shape);
            crowd.solids.push(solid);
            crowd.placed.push(placed);
        }
        crowd
    }

    /// A ray through the crowd: at any point, at one on the grid of sizes, or along an axis through such a point.
    pub fn ray(&self, random: &mut Random) -> Option<Ray<S>> {
        let grid = |random: &mut Random| random.pick(&[-2.0, -1.5, -1.0, -0.5, -0.25, 0.0, 0.25, 0.5, 1.0, 1.5, 2.0]);
        let target = if random.below(3) == 0 {
            add(self.centre, scale(random.direction(), 2.0 * random.unit() * self.unit))
        } else {
            add(self.centre, scale([grid(random), grid(random), grid(random)], self.unit))
        };
        let distance = random.pick(&[0.0, 1.0, 5.0, 50.0]) * self.unit;
        if random.below(3) == 0 {
            let mut along = [0.0; 3];
            along[random.below(3)] = random.sign();
            let origin = add(target, scale(along, -distance));
            return Ray::new(Vec3::from_f64(origin).ok()?, UnitVec3::new(Vec3::from_f64(along).ok()?).ok()?).ok();
        }
        let origin = add(target, scale(random.direction(), distance + 0.25 * self.unit));
        let origin =
            if random.below(2) == 0 { origin.map(|c| (c / self.unit * 4.0).round() / 4.0 * self.unit) } else { origin };
        Ray::towards(Vec3::from_f64(origin).ok()?, Vec3::from_f64(target).ok()?).ok()
    }
}
