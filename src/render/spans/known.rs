//! What is known of the objects of a picture in every row: what they look like, and where their shadows may be.

use super::curve;
use super::light_over::LightOver;
use super::place::Place;
use crate::effect::{Course, Effect, Effects};
use crate::number::dot;
use crate::part::Part;
use crate::render::Picture;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{
    Ball, BallInWorld, Candidates, Directions, Light, MOST, View, are_apart, around_box, ends, may_shade,
};
use crate::shape::kinds::Kinds;
use crate::shape::{Outlined, Shape};
use crate::tier::Tier;
use crate::vector::{UnitVec3, Vec3, pairs};

/// The most shadows on planes, and on all else; in pictures of more not all are known.
pub(super) const SHADOWS: usize = 32;

/// What is known of the objects of a picture.
#[derive(Clone, Debug)]
pub(super) struct Known {
    /// The rays of the first row.
    pub(super) directions: Directions,
    pub(super) objects: heapless::Vec<KnownObject, MOST>,
    /// Where shadows may be seen on planes, of all other objects; `None` if that is not known.
    ///
    /// A plane throws none on what is seen before it: in a light on its other side it shades all that, and in a light
    /// on this side nothing.
    pub(super) shadows: Option<heapless::Vec<KnownShadow, SHADOWS>>,
    /// Those on all other objects.
    shadows_on: heapless::Vec<ShadowOn, SHADOWS>,
    pub(super) planes: Candidates,
    /// The planes that may throw a shadow on what is seen: those with a light that is not surely on the eye's side.
    ///
    /// An object with certain spans is convex, and throws no shadow on itself.
    pub(super) shading: Candidates,
    /// The normal of the only plane, away from the eye, in the coordinates of the camera; `None` if there are others,
    /// or the eye is next to it.
    pub(super) beyond: Option<[i64; 3]>,
}

/// What is known of an object.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownObject {
    pub(super) outlined: Outlined,
    pub(super) is_solid: bool,
    pub(super) ball: Option<Ball>,
    /// The first column that may see it, and the one after the last.
    pub(super) columns: [u16; 2],
    /// A ball around the cap that is seen, if one is.
    pub(super) cap: Option<Ball>,
    /// True if its normals turn over the columns of a row as those of a ball do.
    is_round: bool,
    /// The objects that have no point in common with it.
    apart: Candidates,
    /// The objects whose shadows may fall on it anywhere.
    shaded_by: Candidates,
    /// The most columns between pixels that are traced where its light changes smoothly.
    longest: u16,
}

/// Where the shadow of an object in a light may be seen on planes.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownShadow {
    pub(super) object: u32,
    pub(super) light: u32,
    pub(super) place: Place,
}

/// Where the shadow of an object may be seen on another one.
#[derive(Clone, Copy, Debug)]
struct ShadowOn {
    object: u8,
    on: u8,
    place: Place,
}

impl Known {
    /// That of the objects of a picture; `None` if there are more than [`MOST`], or its rays are parallel or have no
    /// room in integers.
    pub(super) fn of<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(picture: &Picture<'_, S, E, T, K>) -> Option<Self> {
        let (scene, eye) = (picture.tracer.scene(), picture.raster.camera().position());
        let width = picture.size().width;
        let mut known = Self {
            directions: Directions::of_row(&picture.raster, 0)?,
            objects: heapless::Vec::new(),
            shadows: None,
            shadows_on: heapless::Vec::new(),
            planes: Candidates::NONE,
            shading: Candidates::NONE,
            beyond: None,
        };
        let mut balls = heapless::Vec::<_, MOST>::new();
        for object in scene.objects() {
            balls.push(around_box(&object.shape)).ok()?;
        }
        for ((index, object), own) in (0_u32..).zip(scene.objects()).zip(&balls) {
            let shape = &object.shape;
            let outlined = shape.outlined_from(eye);
            let cap = match (outlined, ends(shape)) {
                (Outlined::Cap(Part::Base), Some([base, _])) => Ball::seen(base, eye),
                (Outlined::Cap(_), Some([_, top])) => Ball::seen(top, eye),
                _ => None,
            };
            let is_apart = |other: &Option<_>| own.zip(*other).is_some_and(|(own, other)| are_apart(own, other));
            let others = (0_u32..).zip(&balls).filter(|(_, other)| is_apart(other));
            let apart = others.map(|(other, _)| other).fold(Candidates::NONE, Candidates::with);
            let (is_solid, ball) = (shape.is_solid(), own.and_then(|own| Ball::seen(own, eye)));
            let longest = longest(picture, shape, *own);
            let is_round = shape.is_round() && own.is_some_and(|own| is_far_from(eye, own));
            let columns = own.map_or([0, width], |own| Place::columns_of(&picture.raster, own));
            let shaded_by = Candidates::NONE;
            let object = KnownObject { outlined, is_solid, ball, columns, cap, is_round, apart, shaded_by, longest };
            known.objects.push(object).ok()?;
            if outlined == Outlined::Plane {
                known.planes = known.planes.with(index);
                if !scene.lights().iter().all(|light| is_on_side_of(eye, light, shape)) {
                    known.shading = known.shading.with(index);
                }
            }
        }
        let only = known.planes.only().and_then(|plane| scene.object(plane)).and_then(|object| object.shape.plane());
        known.beyond = only.and_then(|plane| View::of(&picture.raster).beyond(plane));
        known.find_shadows(picture, &balls);
        Some(known)
    }

    /// Finds the shadows of all objects but planes, and what they may fall on.
    fn find_shadows<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(
        &mut self,
        picture: &Picture<'_, S, E, T, K>,
        balls: &[Option<BallInWorld<S>>],
    ) {
        let (scene, raster) = (picture.tracer.scene(), &picture.raster);
        let lights = if picture.tracer.uses(Effect::Shadows) { scene.lights() } else { &[] };
        let floor = self.planes.first().and_then(|plane| scene.object(plane)).and_then(|object| object.shape.plane());
        let mut shadows = Some(heapless::Vec::new());
        for (object, ball) in (0_u32..).zip(balls).filter(|(object, _)| !self.planes.contain(*object)) {
            for (light, lamp) in (0_u32..).zip(lights) {
                if floor.is_some() {
                    let place = ball.map(|ball| Place::of(raster, ball, lamp, None, floor));
                    let place = place.unwrap_or(Place::all(raster.size()));
                    let shadow = KnownShadow { object, light, place };
                    if !place.is_nowhere() && shadows.as_mut().is_some_and(|known| known.push(shadow).is_err()) {
                        shadows = None;
                    }
                }
                for ((index, on), other) in (0_u32..).zip(&mut self.objects).zip(balls) {
                    if index == object || on.outlined == Outlined::Plane {
                        continue;
                    }
                    let Some((ball, other)) = ball.zip(*other) else {
                        on.shaded_by = on.shaded_by.with(object);
                        continue;
                    };
                    if !may_shade(ball, other, lamp) {
                        continue;
                    }
                    let place = Place::of(raster, ball, lamp, Some(other), floor);
                    let shadow = ShadowOn { object: object as u8, on: index as u8, place };
                    if !place.is_nowhere() && self.shadows_on.push(shadow).is_err() {
                        on.shaded_by = on.shaded_by.with(object);
                    }
                }
            }
        }
        self.shadows = shadows;
    }

    /// What an object looks like.
    pub(super) fn outlined(&self, object: u32) -> Outlined {
        self.objects.get(object as usize).map_or(Outlined::Other, |known| known.outlined)
    }

    /// The shadows that may fall on an object in this row: what throws each, and the first column that may see it and
    /// the one after the last.
    pub(super) fn shadows_on(&self, object: u32, y: u16) -> impl Iterator<Item = (u32, [u16; 2])> {
        let on_it = self.shadows_on.iter().filter(move |shadow| u32::from(shadow.on) == object);
        on_it.filter_map(move |shadow| Some((shadow.object.into(), shadow.place.columns(y)?)))
    }

    /// The objects whose shadows may fall on this one anywhere.
    pub(super) fn shaded_by(&self, object: u32) -> Candidates {
        self.objects.get(object as usize).map_or(Candidates::ALL, |known| known.shaded_by)
    }

    /// True if none of these objects has a point in common with this one.
    pub(super) fn is_apart(&self, object: u32, others: Candidates) -> bool {
        self.objects.get(object as usize).is_some_and(|known| known.apart.with(object).include(others))
    }

    /// The most columns of a curve on this part of an object where all lights reach it, and where they do not; 0 if its
    /// light may change in any way. `middle` is the number of columns in which a round object is seen, if the curve is
    /// in the middle of them.
    pub(super) fn longest<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(
        &self,
        picture: &Picture<'_, S, E, T, K>,
        on: (u32, Part),
        middle: Option<u16>,
    ) -> [u16; 2] {
        let most = self.objects.get(on.0 as usize).map_or(0, |known| known.longest);
        // In the middle the normal of a ball turns by 2 / width a column, and what it mirrors by twice that.
        let turn_of_ball = |width: u16| S::Real::from_int(4) / S::Real::from_int(width.max(1).into());
        let is_flat = self.is_flat(on);
        let turn =
            if is_flat { picture.raster.half_a_pixel().map(|half| half.scaled(1)) } else { middle.map(turn_of_ball) };
        let longest = match picture.tracer.course(Some(on)) {
            Course::Smooth if is_flat || self.is_round(on.0) => most,
            // Next to the apex of a cone, say, light changes within few columns.
            Course::Smooth => most.min(8),
            Course::Glossy(shine) => turn.map_or(0, |turn| longest_of_highlights(most, shine, turn)),
            Course::Same | Course::Any => 0,
        };
        if is_flat {
            return [longest; 2];
        }
        // Between pixels that a light does not reach there may be some that it does, at a grazing angle. In the middle
        // of a ball the cosine between two that are `n / 2` apart is at most about (n / width)^2 / 8: 1 / 1024 for long
        // curves. On small balls, and elsewhere, curves are as short as they can be.
        let beyond = middle.map_or(0, |width| width / 12).max(curve::SHORTEST);
        [longest, longest.min(beyond)]
    }

    /// True if the normals of an object turn over the columns of a row as those of a ball do.
    pub(super) fn is_round(&self, object: u32) -> bool {
        self.objects.get(object as usize).is_some_and(|known| known.is_round)
    }

    /// True if the part of an object is certainly flat.
    fn is_flat(&self, (object, part): (u32, Part)) -> bool {
        match self.outlined(object) {
            Outlined::Plane | Outlined::Facets => true,
            Outlined::Cap(cap) => cap == part,
            _ => false,
        }
    }
}

/// True if the eye is three radii or more from the centre of a ball: then the columns of what is inside of it are about
/// as wide on its near side as on its far one.
fn is_far_from<S: Scalar>(eye: Vec3<S>, (centre, legs): BallInWorld<S>) -> bool {
    let (from_eye, legs) = (pairs(centre.real(), eye.real()).map(|(c, e)| c - e), legs.map(S::real));
    dot(from_eye, from_eye) >= S::Real::from_int(9) * dot(legs, legs)
}

/// True if a light is surely on the same side of a plane as the eye.
fn is_on_side_of<S: Scalar, K: Kinds>(eye: Vec3<S>, light: &Light<S>, plane: &Shape<S, K>) -> bool {
    let Some((on, normal)) = plane.plane() else { return false };
    // The height, if it surely has that sign.
    let height = |from: [S::Real; 3]| {
        let (height, doubt) = (dot(from, normal.real()), from.map(S::Real::abs));
        let doubt = doubt.into_iter().fold(S::Real::ZERO, |sum, c| sum + c).scaled(-8);
        (height.abs() > doubt).then_some(height)
    };
    let from_on = |point: Vec3<S>| pairs(point.real(), on.real()).map(|(point, on)| point - on);
    let lamp = if light.distant {
        UnitVec3::<S>::from_real(light.position.real()).map(UnitVec3::real)
    } else {
        Some(from_on(light.position))
    };
    height(from_on(eye)).zip(lamp.and_then(height)).is_some_and(|(eye, lamp)| eye.is_negative() == lamp.is_negative())
}

/// The most columns of a curve on a shape: as many as what the nearest light brightens by Lambert's law is wide, and
/// fewer than a plane takes to vanish in fog. For other shapes than planes that is the height of the light over the
/// ball around it, as seen from the ball's far side. 0 if no ball is known.
fn longest<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(
    picture: &Picture<'_, S, E, T, K>,
    shape: &Shape<S, K>,
    ball: Option<BallInWorld<S>>,
) -> u16 {
    let (scene, raster, plane) = (picture.tracer.scene(), &picture.raster, shape.plane());
    let (Some(half), eye) = (raster.half_a_pixel(), raster.camera().position().real()) else { return 0 };
    if plane.is_none() && ball.is_none() {
        return 0;
    }
    let from = |a: [S::Real; 3], b: [S::Real; 3]| pairs(a, b).map(|(a, b)| a - b);
    let length = |v: [S::Real; 3]| dot(v, v).sqrt();
    let mut longest = curve::LONGEST;
    // The width as a fraction, one unit in front of the eye.
    let mut shorten = |[width, unit]: [S::Real; 2]| {
        let column = unit * half.scaled(1);
        while longest >= curve::SHORTEST && width < column * S::Real::from_int(longest.into()) {
            longest /= 2;
        }
    };
    for light in scene.lights().iter().filter(|light| !light.distant) {
        if let Some(plane) = plane {
            shorten(LightOver::new(light, plane).width(raster));
        } else if let Some((centre, legs)) = ball {
            let radius = length(legs.map(S::real));
            let height = length(from(light.position.real(), centre.real())) - radius;
            shorten([height, length(from(centre.real(), eye)) + radius]);
        }
    }
    let fog = scene.fog().filter(|_| picture.tracer.uses(Effect::Fog));
    let density = fog.map_or(S::Real::ZERO, |fog| S::Real::ONE - S::unit_real(fog.clarity()));
    if let Some((on, normal)) = plane {
        // A plane that is `k` away is seen through `exp(-s k / z)`, where `z = n . r` is linear in the column. Its
        // third derivative is less than `31 / (s k)^3`: over a quarter of `s k` a parabola is off by less than 1 / 250.
        let [right, ..] = raster.axes();
        let distance = dot(from(on.real(), eye), normal.real()).abs();
        if !density.is_zero() {
            shorten([density * distance, right.dot(normal).abs().scaled(2)]);
        }
    } else if let Some((_, legs)) = ball
        && density * length(legs.map(S::real)) > S::Real::ONE.scaled(-5)
    {
        // A long one may recede within few columns.
        longest = longest.min(curve::SHORTEST);
    }
    longest
}

/// The most columns of a curve, of so many at most, over highlights of this exponent, if the mirrored direction turns
/// by this angle a column. A highlight is `2.4 / sqrt(e)` wide at half of its height: a curve is about half as long.
fn longest_of_highlights<S: Scalar>(most: u16, exponent: S, turn: S::Real) -> u16 {
    let mut longest = most;
    while longest >= curve::SHORTEST {
        let angle = turn * S::Real::from_int(longest.into());
        if angle * angle * exponent.real() <= S::Real::from_int(3).scaled(-1) {
            return longest;
        }
        longest /= 2;
    }
    longest
}
