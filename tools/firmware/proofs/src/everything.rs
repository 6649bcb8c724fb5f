//! Every public query of the library, with values of any bits.

use crate::input::{Any, any_direction, any_list, any_point, any_word, give};
use crate::sensors::sensors;
use raylet::ExactScalar;
use raylet::hierarchy::{Hierarchy, Node, Shapes};
use raylet::scalar::{Real, UnitScalar};
use raylet::shape::combination::Op;
use raylet::shape::kinds::{KindError, Kinds};
use raylet::solids::{self, Crossings, SolidSet, Start};
use raylet::thick::{self, ThickRay};
use raylet::tier::Tier;
use raylet::{
    Affine, Annulus, Capsule, Combination, Cone, Cuboid, Cylinder, Departure, Disc, Ellipsoid, Frame, HalfSpace,
    Leaving, Part, Plane, Polyhedron, Prism, Range, Ray, Rectangle, Revolved, RoundCone, RoundedCuboid, Shape, Sphere,
    Surface, Torus, Triangle, Tube, UnitVec3, Vec3, Visible,
};

/// Calls the methods that a primitive shares with a shape, in one tier.
macro_rules! call {
    ($thing:expr, $ray:expr, $T:ty) => {
        match &$thing {
            thing => {
                let hits = thing.hits_at::<$T>($ray);
                give((hits.starts_inside(), hits.coincident(), hits.len()));
                for hit in &hits {
                    surface(thing.surface($ray, hit));
                }
                hits.into_iter().for_each(give);
                give(thing.nearest_at::<$T>($ray));
                give(thing.occludes_at::<$T>($ray));
                give(thing.contains_at::<$T>(any_point()));
                give(thing.bounds());
            }
        }
    };
}

/// Everything that can be computed of a hit.
#[inline(never)]
fn surface<S: Any, K: Kinds>(surface: Surface<S, K>) {
    give(surface.point());
    give(surface.local_point());
    give(surface.normal());
    give(surface.normal_towards_ray());
    give(surface.uv());
    give(surface.tangents());
    give(surface.departure(any_word() as u32, Leaving::Outwards));
}

/// Any ray, made in every way that there is.
pub fn any_ray<S: Any>() -> Option<Ray<S>> {
    let ray = match any_word() {
        0 => Ray::new(any_point(), any_direction()),
        _ => Ray::towards(any_point(), any_point()),
    };
    let range = match any_word() {
        0 => Range::line(),
        _ => Range::new(S::any(), S::any()).ok()?,
    };
    give(range.contains(S::any()));
    let ray = ray.ok()?.with_range(range);
    give(ray.at(S::any()));
    let part = Part::EVERY.into_iter().nth(any_word() as usize)?;
    let leaving = if any_word() == 0 { Leaving::Inwards } else { Leaving::Outwards };
    Some(if any_word() == 0 { ray } else { ray.departing(Departure { object: 0, part, leaving }) })
}

pub(crate) fn any_frame<S: Any>() -> Option<Frame<S>> {
    let frame = match any_word() {
        0 => Frame::at(any_point()),
        1 => Frame::from_base_and_axis(any_point(), any_direction()),
        2 => Frame::between(any_point(), any_point()).map(|(frame, _)| frame),
        3 => Frame::looking(any_point(), any_direction(), any_direction()),
        _ => Frame::from_left_up_forward(any_point(), any_direction(), any_direction(), any_direction()),
    };
    frame.ok()
}

fn any_affine<S: Any>() -> Option<Affine<S>> {
    let affine = match any_word() {
        0 => Affine::new(any_point(), [any_point(), any_point(), any_point()]),
        _ => Affine::stretched(any_frame()?, any_point()),
    };
    affine.ok()
}

fn any_prism<S: Any>() -> Option<Prism<S>> {
    Prism::new(any_list(), S::any()).ok()
}

fn any_polyhedron<S: Any>() -> Option<Polyhedron<S>> {
    give(HalfSpace::new(any_point::<S>(), any_point()));
    match any_word() {
        0 => Polyhedron::within(any_point(), any_point(), any_list()).ok(),
        _ => Polyhedron::new(any_list()).ok(),
    }
}

/// A shape of any primitive, in any placement, seen from any side.
pub fn any_shape<S: Any>() -> Option<Shape<S>> {
    let shape = match any_word() {
        0 => Shape::new(Sphere::new(S::any()).ok()?),
        1 => Shape::new(any_cylinder()?),
        2 => Shape::new(any_cone()?),
        3 => Shape::new(Capsule::new(S::any(), S::any()).ok()?),
        4 => Shape::new(Plane::new()),
        5 => Shape::new(Disc::new(S::any()).ok()?),
        6 => Shape::new(Cuboid::new(S::any(), S::any(), S::any()).ok()?),
        7 => Shape::new(Rectangle::new(S::any(), S::any()).ok()?),
        8 => Shape::new(any_revolved()?),
        9 => Shape::new(any_tube()?),
        10 => Shape::new(Annulus::new(S::any(), S::any()).ok()?),
        11 => Shape::new(RoundCone::new(S::any(), S::any(), S::any()).ok()?),
        12 => Shape::new(RoundedCuboid::new(S::any(), S::any(), S::any(), S::any()).ok()?),
        13 => Shape::new(any_prism()?),
        14 => Shape::new(any_polyhedron()?),
        15 => Shape::new(Torus::new(S::any(), S::any()).ok()?),
        16 => return Ellipsoid::new(S::any(), S::any(), S::any()).ok()?.placed(any_frame()?).ok(),
        _ => Shape::new(Triangle::new(any_point(), any_point(), any_point()).ok()?),
    };
    let shape = match any_word() {
        0 => shape,
        1 => shape.placed(any_frame()?),
        _ => shape.placed(any_affine()?),
    };
    Some(match any_word() {
        0 => shape,
        1 => shape.seen_from(Visible::Outside),
        _ => shape.seen_from(Visible::Inside),
    })
}

fn any_cylinder<S: Any>() -> Option<Cylinder<S>> {
    match any_word() {
        0 => Cylinder::infinite(S::any()).ok(),
        1 => Cylinder::open(S::any(), S::any()).ok(),
        _ => Cylinder::capped(S::any(), S::any()).ok(),
    }
}

fn any_revolved<S: Any>() -> Option<Revolved<S>> {
    let heights = [S::any(), S::any()];
    let revolved = match any_word() {
        0 => Revolved::new(S::any(), S::any(), S::any(), heights),
        1 => Revolved::paraboloid(S::any(), S::any()),
        2 => Revolved::spheroid(S::any(), S::any(), heights),
        3 => Revolved::ball_zone(S::any(), heights),
        4 => Revolved::cone(S::any(), heights),
        5 => Revolved::hyperboloid(S::any(), S::any(), heights),
        6 => Revolved::tower(S::any(), S::any(), S::any(), S::any()),
        _ => Revolved::optical(S::any(), S::any(), S::any()),
    };
    let revolved = revolved.ok()?;
    give((revolved.coefficients(), revolved.heights(), revolved.radius_at(S::any())));
    Some(if any_word() == 0 { revolved.open() } else { revolved })
}

fn any_tube<S: Any>() -> Option<Tube<S>> {
    match any_word() {
        0 => Tube::with_wall(S::any(), S::any(), S::any()).ok(),
        _ => Tube::new(S::any(), S::any(), S::any()).ok(),
    }
}

fn any_cone<S: Any>() -> Option<Cone<S>> {
    let cone = match any_word() {
        0 => Cone::double(S::any()),
        1 => Cone::nappe(S::any()),
        2 => Cone::open(S::any(), S::any()),
        3 => Cone::capped(S::any(), S::any()),
        4 => Cone::frustum_open(S::any(), S::any(), S::any()),
        _ => Cone::frustum(S::any(), S::any(), S::any()),
    };
    let cone = cone.ok()?;
    give((cone.height(), cone.base_radius(), cone.top_radius()));
    Some(cone)
}

/// Every query, of every primitive and of placed shapes.
pub fn queries<S: Any, T: Tier<S>>() -> Option<()> {
    let ray = &any_ray::<S>()?;
    call!(Sphere::new(S::any()).ok()?, ray, T);
    call!(any_cylinder()?, ray, T);
    call!(any_cone()?, ray, T);
    call!(Capsule::new(S::any(), S::any()).ok()?, ray, T);
    call!(Plane::new(), ray, T);
    call!(Disc::new(S::any()).ok()?, ray, T);
    call!(Cuboid::new(S::any(), S::any(), S::any()).ok()?, ray, T);
    call!(Rectangle::new(S::any(), S::any()).ok()?, ray, T);
    call!(any_revolved()?, ray, T);
    call!(any_tube()?, ray, T);
    call!(RoundCone::new(S::any(), S::any(), S::any()).ok()?, ray, T);
    call!(RoundedCuboid::new(S::any(), S::any(), S::any(), S::any()).ok()?, ray, T);
    call!(Annulus::new(S::any(), S::any()).ok()?, ray, T);
    call!(any_prism::<S>()?, ray, T);
    call!(any_polyhedron::<S>()?, ray, T);
    call!(Torus::new(S::any(), S::any()).ok()?, ray, T);
    call!(Triangle::new(any_point(), any_point(), any_point()).ok()?, ray, T);
    call!(any_shape::<S>()?, ray, T);
    call!(among::<S, (Sphere<S>, Plane<S>, Frame<S>)>()?, ray, T);
    call!(among::<S, (Affine<S>, Cone<S>)>()?, ray, T);
    combined::<S, T>(ray);
    sensors::<S, T>(ray);
    many_solids::<S, T>(ray)
}

/// Any combination of any solids, alone and in lists.
fn combined<S: Any, T: Tier<S>>(ray: &Ray<S>) -> Option<()> {
    let leaves = [any_shape::<S>()?, any_shape()?, any_shape()?];
    let op = |_| [Op::Union, Op::Intersection, Op::Difference].into_iter().nth(any_word() as usize).unwrap_or(Op::Leaf);
    let operations = [(); 5].map(op);
    let combination = match any_word() {
        0 => Combination::union(&leaves),
        1 => Combination::intersection(&leaves),
        2 => Combination::difference(&leaves),
        _ => Combination::new(&leaves, &operations),
    };
    let combination = combination.ok()?;
    combination.leaf_hits_at::<T>(ray).for_each(give);
    combination.operations().for_each(give);
    let list = [combination.shape().seen_from(Visible::Outside), any_shape()?.beside_combinations()];
    call!(list[0], ray, T);
    let mut nodes = [Node::EMPTY; Hierarchy::<S>::nodes_for(2)];
    let tree = Shapes::new(&list, &mut nodes).ok()?;
    give(tree.nearest_at::<T>(ray));
    give(tree.occludes_at::<T>(ray));
    let crossings = Crossings::<S, 7, 2>::with_start::<T>(&tree, ray, &Start::new()).ok()?;
    crossings.iter().for_each(give);
    give(solids::nearest::<S, T, 2>(&tree, ray, &crossings.start_across(any_word() as usize).ok()?));
    Some(())
}

/// Many solids along one ray, as a list and in a hierarchy, from any start.
fn many_solids<S: Any, T: Tier<S>>(ray: &Ray<S>) -> Option<()> {
    let shapes = [any_shape::<S>()?, any_shape()?, any_shape()?];
    let mut start = match any_word() {
        0 => Start::<2>::new(),
        _ => Start::inside_of(SolidSet::EMPTY.with(any_word() as u32)),
    };
    start = start.leaving_out(SolidSet::EMPTY.with(any_word() as u32));
    if let Some(departure) = any_ray::<S>()?.departure() {
        start = start.departing(departure).ok()?.arriving(departure);
    }
    let mut nodes = [Node::EMPTY; Hierarchy::<S>::nodes_for(3)];
    let tree = Shapes::new(&shapes, &mut nodes).ok()?;
    let crossings = Crossings::<S, 7, 2>::with_start::<T>(&tree, ray, &start).ok()?;
    crossings.iter().for_each(give);
    give(crossings.inside().last());
    give((crossings.start_across(any_word() as usize), crossings.start_before(any_word() as usize)));
    give(Crossings::<S, 7, 2>::with_start::<T>(&shapes, ray, &start));
    give(solids::nearest::<S, T, 2>(&tree, ray, &start));
    give(solids::occludes::<S, T, 2>(&shapes, ray, &start));
    let ball = ThickRay::new(*ray, S::any()).ok()?;
    give((thick::first::<S, T, _>(&ball, &shapes).ok()?, ball.at_start(&shapes[0]).ok()?));
    Some(())
}

/// Any shape of these kinds.
fn among<S: Any, K: Kinds>() -> Option<Shape<S, K>> {
    let among: Result<_, KindError> = any_shape::<S>()?.among();
    among.ok()
}

/// What the exact tier has besides.
pub fn precision<S: Any + ExactScalar>() -> Option<()> {
    give(any_shape::<S>()?.precision(&any_ray()?));
    Some(())
}

/// Vectors, directions and frames by themselves.
pub fn geometry<S: Any>() -> Option<()> {
    let (a, b) = (any_point::<S>(), any_point::<S>());
    give((a + b, a - b, -a, a.length(), UnitVec3::new(a), a.is_within_budget()));
    let (d, e) = (any_direction::<S>(), any_direction::<S>());
    give((-d, a.dot(d), d.dot(e), UnitVec3::<S>::from_real(d.cross(e)), d.perpendicular()));
    give(UnitVec3::<S>::from_components(e.to_array()));
    give(Vec3::<S>::round(a.real()));
    let frame = any_frame::<S>()?;
    give((frame.point_to_local(a), frame.point_to_world(a), frame.direction_to_world(d)));
    give(any_affine::<S>()?.point_to_local(a));
    Some(())
}

/// What a number type offers by itself.
pub fn numbers<S: Any>() {
    let (a, b) = (S::any(), S::any());
    give((a.plus(b), a.minus(b), a.next_up(), a.magnitude(), a.is_finite()));
    give(S::turns(a.real(), b.real()));
    give(S::power(a.fraction(), b));
    let (x, y) = (a.real(), b.real());
    give((x + y, x - y, x * y, x / y, x.sqrt(), S::Real::from_int(any_word() as i32)));
    let (u, v) = (S::unit_round(x), S::unit_round(y));
    give((u.plus(v), u.minus(v), u.times(v), u.level(255)));
}

/// Conversions for tools on the host, which know `f64`.
pub fn host_conversions<S: Any>() {
    give(S::from_f64(f64::any()));
    give(S::any().to_f64());
    give(Vec3::<S>::from_f64([f64::any(); 3]));
    give(UnitVec3::<S>::from_f64([f64::any(); 3]));
    give((any_point::<S>().to_f64(), any_direction::<S>().to_f64()));
}
