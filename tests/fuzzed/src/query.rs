//! A solid and a ray from bytes.

use crate::agreement::Agreement;
use crate::bytes::{Bytes, Number};
use raylet::{
    Affine, Annulus, Capsule, Cone, Cuboid, Cylinder, Departure, Disc, Frame, HalfSpace, Leaving, Part, Placement,
    Plane, Polyhedron, Primitive, Prism, Range, Ray, Rectangle, Revolved, RoundCone, RoundedCuboid, Scalar, Shape,
    Sphere, Torus, Triangle, Tube, Vec3, Visible, tier,
};
use std::any::type_name;
use std::cell::Cell;
use support::cases::Kind;
use support::oracle::{self, ConeExtent, CylinderExtent, Dyadic, Solid};
use support::random;

/// A constructor said no.
#[derive(Debug)]
pub struct Rejected;

/// What is tested: a solid as the crate and as the oracle see it, and a ray.
#[derive(Debug)]
pub struct Query<S: Number> {
    pub kind: Kind,
    pub is_double: bool,
    pub shape: Shape<S>,
    pub solid: Solid,
    pub ray: Ray<S>,
    /// The smallest length of the solid itself that is not zero, and the largest.
    pub extent: (Dyadic, Dyadic),
    /// The tier that is being tested, by name, and what it promises.
    pub tier: Cell<(&'static str, Agreement)>,
    /// The lengths of the shortest and of the longest axis of the placement, roughly.
    pub axes: (f64, f64),
}

/// Passes on what a constructor made; fails if it refuses what its documentation allows, or takes what it does not.
fn made<T, E: std::fmt::Display>(
    result: Result<T, E>,
    allowed: bool,
    given: &dyn std::fmt::Debug,
) -> Result<T, Rejected> {
    match result {
        Ok(made) => {
            assert!(allowed, "a constructor takes what its documentation excludes: {given:?}");
            Ok(made)
        }
        Err(error) => {
            assert!(!allowed, "a constructor refuses what its documentation allows: {error}: {given:?}");
            Err(Rejected)
        }
    }
}

fn is_size<S: Scalar>(size: S) -> bool {
    size >= S::BUDGET.smallest_size && size <= S::BUDGET.size
}

fn is_slope<S: Scalar>(slope: S) -> bool {
    slope >= S::BUDGET.smallest_slope && slope <= S::BUDGET.slope
}

impl<S: Number> Query<S> {
    pub fn from_bytes(bytes: &mut Bytes<'_, S>) -> Result<Self, Rejected> {
        let (kind, primitive, solid) = primitive(bytes)?;
        let visible = bytes.pick(&[Visible::Both, Visible::Both, Visible::Outside, Visible::Inside]);
        let (placement, axes) = placement(bytes)?;
        let shape = Shape::new(primitive).seen_from(visible).placed(placement);
        let is_double = matches!(solid, Solid::Cone { extent: ConeExtent::Double, .. });
        let extent = extent(&solid);
        let tier = Cell::new(("none", Agreement::Lawful));
        Ok(Self { kind, is_double, shape, solid, ray: ray(bytes)?, extent, tier, axes })
    }

    pub fn position(&self) -> [f64; 3] {
        match self.shape.placement() {
            Placement::World => [0.0; 3],
            Placement::Frame(frame) => frame.position().to_f64(),
            Placement::Affine(affine) => affine.position().to_f64(),
            _ => unreachable!("no other placement is made here"),
        }
    }

    /// True if the tier that is tested makes this promise.
    pub fn promises(&self, promise: Agreement) -> bool {
        self.tier.get().1 == promise
    }

    /// How far the ray's origin is from the solid's, as far as `f64` tells.
    pub fn away(&self, ray: &Ray<S>) -> f64 {
        ray.origin().to_f64().iter().chain(&self.position()).fold(0.0, |sum, c| sum + c.abs())
    }

    /// True if an end may lie at a `t` that the type does not hold, in the world or as the solid sees it.
    pub fn may_leave_the_type(&self, ray: &Ray<S>) -> bool {
        let (away, size) = (self.away(ray), self.extent.1.to_f64() * 3.0);
        let affine = matches!(self.shape.placement(), Placement::Affine(_));
        // The axes of a matrix may be nearly parallel.
        let skew = if affine { 2.0_f64.powi(-16) } else { 1.0 };
        let (shortest, longest) = self.axes;
        let reach = (away + size * longest.max(1.0)).max(away / shortest);
        let largest = S::BUDGET.distance.to_f64();
        // The terms of `Plain` have the square of a length, those of slanted solids its fourth power, and overflow.
        let overflows = S::VANISHING.is_some() && self.tier.get().0 == type_name::<tier::Plain>();
        let power = if !overflows {
            1.0
        } else if self.is_slanted() {
            0.25
        } else {
            0.5
        };
        reach >= largest.powf(power) * 0.99 * skew
    }

    /// True if its equation has the fourth power of a length.
    fn is_slanted(&self) -> bool {
        matches!(self.solid, Solid::Cone { .. } | Solid::Frustum { .. } | Solid::Triangle { .. } | Solid::Torus { .. })
    }

    /// True if the square of the smallest length beside that of the largest is nothing to the type; of a cone, whose
    /// equation has the fourth power of a length, its square's square.
    pub fn squares_vanish(&self) -> bool {
        let Some(exponent) = S::VANISHING else { return false };
        let exponent = if self.is_slanted() { exponent / 2 } else { exponent };
        let (shortest, longest) = self.axes;
        let affine = matches!(self.shape.placement(), Placement::Affine(_));
        let skew = if affine { shortest / longest * 2.0_f64.powi(-16) } else { 1.0 };
        let mut lengths: Vec<f64> = self.ray.origin().to_f64().to_vec();
        lengths.extend(self.position());
        lengths.extend([self.extent.0.to_f64(), self.extent.1.to_f64()]);
        if let Solid::Triangle { vertices } = &self.solid {
            lengths.extend(vertices.iter().flatten().map(Dyadic::to_f64));
        }
        let lengths = lengths.into_iter().map(f64::abs).filter(|length| *length > 0.0);
        let (least, greatest) = lengths.fold((f64::INFINITY, 0.0), |(a, b): (f64, f64), c| (a.min(c), b.max(c)));
        least * skew < (greatest / shortest.min(1.0)).max(greatest * longest) * 2.0_f64.powi(exponent)
    }
}

/// The smallest and the largest length of the solid; zero where it has none.
fn extent(solid: &Solid) -> (Dyadic, Dyadic) {
    let lengths = match solid {
        Solid::Sphere { radius } | Solid::Disc { radius } => vec![radius.clone()],
        Solid::Cylinder { radius, extent: CylinderExtent::Infinite } => vec![radius.clone()],
        Solid::Cylinder { radius, extent: CylinderExtent::Open(height) | CylinderExtent::Capped(height) }
        | Solid::Capsule { radius, height } => vec![radius.clone(), height.clone()],
        Solid::Cone { slope, extent: ConeExtent::Open(height) | ConeExtent::Capped(height) } => {
            vec![height.clone(), slope * height]
        }
        Solid::Cone { .. } | Solid::Plane => vec![],
        Solid::Frustum { base_radius, top_radius, height, .. } => {
            vec![base_radius.clone(), top_radius.clone(), height.clone()]
        }
        Solid::Revolved(of) => [&of.r, &of.b, &of.low, &of.high].map(Dyadic::magnitude).to_vec(),
        Solid::RoundCone(oracle::RoundCone { base_radius, top_radius, height }) => {
            vec![base_radius.clone(), top_radius.clone(), height.clone()]
        }
        Solid::Tube { inner, outer, height } => vec![inner.clone(), outer - inner, outer.clone(), height.clone()],
        Solid::Torus { major, minor } => vec![minor.clone(), major - minor, major + minor],
        Solid::Annulus { inner, outer } => vec![inner.clone(), outer - inner, outer.clone()],
        Solid::Cuboid { half } => half.to_vec(),
        Solid::RoundedCuboid(oracle::RoundedCuboid { half, radius }) => half.iter().chain([radius]).cloned().collect(),
        Solid::HalfSpaces(of) => of.lengths.iter().map(Dyadic::magnitude).collect(),
        Solid::Rectangle { half } => half.to_vec(),
        Solid::Triangle { vertices } => return triangle_extent(vertices),
    };
    let lengths: Vec<Dyadic> = lengths.into_iter().filter(|length| !length.is_zero()).collect();
    let least = lengths.iter().min().cloned().unwrap_or_else(Dyadic::zero);
    (least, lengths.into_iter().max().unwrap_or_else(Dyadic::zero))
}

/// The least altitude, and the largest coordinate: a triangle is where its corners are.
fn triangle_extent(vertices: &[[Dyadic; 3]; 3]) -> (Dyadic, Dyadic) {
    let largest = vertices.iter().flatten().map(Dyadic::magnitude).max().unwrap_or_else(Dyadic::zero);
    let exponent = oracle::Root::from(&largest).binary_exponent().unwrap_or(0);
    let near_one = vertices.each_ref().map(|vertex| vertex.each_ref().map(|c| c.scaled(-exponent)));
    let edge = |from: usize, to: usize| [0, 1, 2].map(|i| (&near_one[to][i] - &near_one[from][i]).to_f64());
    let length = |v: [f64; 3]| v.iter().fold(0.0, |sum: f64, c| sum.hypot(*c));
    let edges = [edge(0, 1), edge(1, 2), edge(2, 0)];
    let longest = edges.map(length).into_iter().fold(0.0, f64::max);
    let altitude = length(random::cross(edges[0], edges[1])) / longest;
    (oracle::exact_f64(if altitude.is_finite() { altitude } else { 0.0 }).scaled(exponent), largest)
}

type Made<S> = (Kind, Primitive<S>, Solid);

fn primitive<S: Number>(bytes: &mut Bytes<'_, S>) -> Result<Made<S>, Rejected> {
    use Kind::{Bounded, NotConvex, Open, Unbounded};
    // The last are those of few bytes, so that most bytes of the corpus mean what they meant when it was made.
    let which = match bytes.byte() {
        which @ 0..224 => which % 14,
        which @ 224..248 => 14 + which % 2,
        248 => return revolved(bytes),
        249 => 19,
        250 => return prism(bytes),
        251 => return polyhedron(bytes),
        254 => 20,
        // 16 to 18.
        which => which.div_ceil(2) - 110,
    };
    if which == 13 {
        return triangle(bytes);
    }
    let given = [bytes.size(), bytes.size(), bytes.size()];
    let [a, b, c] = given;
    let both = is_size(a) && is_size(b);
    let with_slope = is_slope(a) && is_size(b);
    let or_zero = |size: S| size == S::ZERO || is_size(size);
    let frustum = or_zero(a) && or_zero(b) && !(a == S::ZERO && b == S::ZERO) && is_size(c);
    // The sizes are finite where the oracle is given them.
    let cylinder = |extent| Solid::Cylinder { radius: a.exact(), extent };
    let cone = |extent| Solid::Cone { slope: a.exact(), extent };
    let cut = |capped| Solid::Frustum { base_radius: a.exact(), top_radius: b.exact(), height: c.exact(), capped };
    Ok(match which {
        0 => (Bounded, made(Sphere::new(a), is_size(a), &given)?.into(), Solid::Sphere { radius: a.exact() }),
        1 => {
            let primitive = made(Cylinder::infinite(a), is_size(a), &given)?;
            (Unbounded, primitive.into(), cylinder(CylinderExtent::Infinite))
        }
        2 => {
            let primitive = made(Cylinder::open(a, b), both, &given)?;
            (Open, primitive.into(), cylinder(CylinderExtent::Open(b.exact())))
        }
        3 => {
            let primitive = made(Cylinder::capped(a, b), both, &given)?;
            (Bounded, primitive.into(), cylinder(CylinderExtent::Capped(b.exact())))
        }
        4 => {
            let primitive = made(Capsule::new(a, b), is_size(a) && or_zero(b), &given)?;
            (Bounded, primitive.into(), Solid::Capsule { radius: a.exact(), height: b.exact() })
        }
        5 => (Unbounded, made(Cone::double(a), is_slope(a), &given)?.into(), cone(ConeExtent::Double)),
        6 => (Unbounded, made(Cone::nappe(a), is_slope(a), &given)?.into(), cone(ConeExtent::Nappe)),
        7 => {
            let primitive = made(Cone::open(a, b), with_slope, &given)?;
            (Open, primitive.into(), cone(ConeExtent::Open(b.exact())))
        }
        8 => {
            let primitive = made(Cone::capped(a, b), with_slope, &given)?;
            (Bounded, primitive.into(), cone(ConeExtent::Capped(b.exact())))
        }
        9 => {
            let primitive = made(Cone::frustum_open(a, b, c), frustum, &given)?;
            (Open, primitive.into(), cut(false))
        }
        10 => {
            let primitive = made(Cone::frustum(a, b, c), frustum, &given)?;
            (Bounded, primitive.into(), cut(true))
        }
        11 => (Open, Plane::new().into(), Solid::Plane),
        14 => {
            let primitive = made(Cuboid::new(a, b, c), both && is_size(c), &given)?;
            (Bounded, primitive.into(), Solid::Cuboid { half: given.map(S::exact) })
        }
        15 => {
            let primitive = made(Rectangle::new(a, b), both, &given)?;
            (Open, primitive.into(), Solid::Rectangle { half: [a, b].map(S::exact) })
        }
        16 => {
            let primitive = made(Tube::new(a, b, c), both && is_size(c) && a < b, &given)?;
            let [inner, outer, height] = given.map(S::exact);
            (NotConvex, primitive.into(), Solid::Tube { inner, outer, height })
        }
        17 => {
            let primitive = made(RoundCone::new(a, b, c), both && or_zero(c), &given)?;
            let [base, top, height] = given.map(S::exact);
            (Bounded, primitive.into(), oracle::RoundCone::solid(base, top, height))
        }
        19 => {
            // Beyond the budget with the radius added: the constructor says so.
            let Ok(cuboid) = RoundedCuboid::new(a, b, S::ZERO, c) else { return Err(Rejected) };
            let half = [a.exact(), b.exact(), Dyadic::zero()];
            let solid = oracle::RoundedCuboid { half, radius: c.exact() };
            (Bounded, cuboid.into(), Solid::RoundedCuboid(solid))
        }
        20 => {
            let primitive = made(Torus::new(a, b), both && b < a, &given)?;
            (NotConvex, primitive.into(), Solid::Torus { major: a.exact(), minor: b.exact() })
        }
        18 => {
            let primitive = made(Annulus::new(a, b), both && a < b, &given)?;
            (Open, primitive.into(), Solid::Annulus { inner: a.exact(), outer: b.exact() })
        }
        _ => (Open, made(Disc::new(a), is_size(a), &given)?.into(), Solid::Disc { radius: a.exact() }),
    })
}

fn triangle<S: Number>(bytes: &mut Bytes<'_, S>) -> Result<Made<S>, Rejected> {
    let corners = [bytes.vector(), bytes.vector(), bytes.vector()];
    let [a, b, c] = corners;
    // What lies on a line after rounding is for the constructor to say.
    let Ok(triangle) = Triangle::new(a, b, c) else { return Err(Rejected) };
    assert!(corners.iter().all(|corner| corner.is_within_budget()), "beyond the budget: {corners:?}");
    let vertices = corners.map(|corner| corner.to_array().map(S::exact));
    Ok((Kind::Open, triangle.into(), Solid::Triangle { vertices }))
}

fn prism<S: Number>(bytes: &mut Bytes<'_, S>) -> Result<Made<S>, Rejected> {
    let corners: Vec<_> = (0..3 + bytes.byte() % 4).map(|_| [bytes.number(), bytes.number()]).collect();
    let height = bytes.size();
    // What is a polygon is for the constructor to say.
    let Ok(prism) = Prism::new(corners.clone().leak(), height) else { return Err(Rejected) };
    let corners: Vec<_> = corners.into_iter().map(|corner| corner.map(S::exact)).collect();
    let solid = Solid::HalfSpaces(oracle::HalfSpaces::prism(&corners, &height.exact()));
    Ok((Kind::Bounded, prism.into(), solid))
}

fn polyhedron<S: Number>(bytes: &mut Bytes<'_, S>) -> Result<Made<S>, Rejected> {
    let [low, high] = [bytes.vector(), bytes.vector()];
    let facets: Vec<_> = (0..=bytes.byte() % 4).map(|_| [bytes.vector(), bytes.vector()]).collect();
    let half_spaces =
        facets.iter().map(|[point, normal]| HalfSpace::new(*point, *normal)).collect::<Result<Vec<_>, _>>();
    // What are half-spaces is for the constructor to say.
    let Ok(half_spaces) = half_spaces else { return Err(Rejected) };
    let Ok(polyhedron) = Polyhedron::within(low, high, half_spaces.leak()) else { return Err(Rejected) };
    let exact = |v: Vec3<S>| v.to_array().map(S::exact);
    let facets: Vec<_> = facets.into_iter().map(|facet| facet.map(exact)).collect();
    let solid = Solid::HalfSpaces(oracle::HalfSpaces::polyhedron([&exact(low), &exact(high)], &facets));
    Ok((Kind::Bounded, polyhedron.into(), solid))
}

fn revolved<S: Number>(bytes: &mut Bytes<'_, S>) -> Result<Made<S>, Rejected> {
    let (sizes, is_open) = ([(); 5].map(|()| bytes.number()), bytes.byte() & 1 == 1);
    let [a, b, r, y, z] = sizes;
    let [low, high] = if z < y { [z, y] } else { [y, z] };
    // What is a quadric between planes is for the constructor to say.
    let Ok(revolved) = Revolved::new(a, b, r, [low, high]) else { return Err(Rejected) };
    let [a, b, r, low, high] = [a, b, r, low, high].map(S::exact);
    let solid = oracle::Revolved { a, b, r, low, high, capped: !is_open };
    let (kind, primitive) = match (is_open, solid.has_waist()) {
        (true, _) => (Kind::Open, revolved.open()),
        (false, true) => (Kind::NotConvex, revolved),
        (false, false) => (Kind::Bounded, revolved),
    };
    Ok((kind, primitive.into(), Solid::Revolved(solid)))
}

fn placement<S: Number>(bytes: &mut Bytes<'_, S>) -> Result<(Placement<S>, (f64, f64)), Rejected> {
    let which = bytes.byte() % 10;
    if which < 4 {
        return Ok((Placement::World, (1.0, 1.0)));
    }
    let position = bytes.vector();
    let within = position.is_within_budget();
    let placed = match which {
        4 => made(Frame::at(position), within, &position)?.into(),
        5 => {
            let axis = bytes.direction().ok_or(Rejected)?;
            made(Frame::from_base_and_axis(position, axis), within, &position)?.into()
        }
        6 => Frame::between(position, bytes.vector()).map_err(|_| Rejected)?.0.into(),
        7 => {
            let (forward, up) = (bytes.direction().ok_or(Rejected)?, bytes.direction().ok_or(Rejected)?);
            Frame::looking(position, forward, up).map_err(|_| Rejected)?.into()
        }
        8 => {
            let axes = [bytes.vector(), bytes.vector(), bytes.vector()];
            let affine = Affine::new(position, axes).map_err(|_| Rejected)?;
            return Ok((affine.into(), shortest_and_longest(axes.map(|axis| axis.length().to_f64()))));
        }
        _ => {
            let axis = bytes.direction().ok_or(Rejected)?;
            let frame = made(Frame::from_base_and_axis(position, axis), within, &position)?;
            let scale = bytes.vector();
            let affine = Affine::stretched(frame, scale).map_err(|_| Rejected)?;
            return Ok((affine.into(), shortest_and_longest(scale.to_f64())));
        }
    };
    Ok((placed, (1.0, 1.0)))
}

fn shortest_and_longest(lengths: [f64; 3]) -> (f64, f64) {
    (lengths.into_iter().fold(f64::INFINITY, f64::min), lengths.into_iter().fold(0.0, f64::max))
}

fn ray<S: Number>(bytes: &mut Bytes<'_, S>) -> Result<Ray<S>, Rejected> {
    let origin = bytes.vector();
    let ray = if bytes.byte().is_multiple_of(3) {
        let target = bytes.vector();
        let within = origin.is_within_budget() && target.is_within_budget();
        made(Ray::towards(origin, target), within && origin != target, &(origin, target))?
    } else {
        let direction = bytes.direction().ok_or(Rejected)?;
        made(Ray::new(origin, direction), origin.is_within_budget(), &origin)?
    };
    let ray = match bytes.byte() % 4 {
        0 | 1 => ray,
        2 => ray.with_range(Range::line()),
        _ => {
            let (start, end) = (bytes.number(), bytes.number());
            let allowed = start.is_finite() && end.is_finite() && start <= end;
            ray.with_range(made(Range::new(start, end), allowed, &(start, end))?)
        }
    };
    let part = bytes.pick(&[
        None,
        None,
        None,
        Some(Part::Side),
        Some(Part::Base),
        Some(Part::Top),
        None,
        None,
        Some(Part::Left),
        Some(Part::Right),
        Some(Part::Back),
        Some(Part::Front),
        Some(Part::Inner),
    ]);
    Ok(match part {
        None => ray,
        Some(part) => {
            let leaving = bytes.pick(&[Leaving::Inwards, Leaving::Outwards]);
            ray.departing(Departure { object: 0, part, leaving })
        }
    })
}
