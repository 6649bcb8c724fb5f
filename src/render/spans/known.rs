//! What is known of the objects of a picture in every row: what they look like, and where their shadows may be.

use super::curve;
use super::light_over::LightOver;
use crate::effect::{Course, Effect, Effects};
use crate::number::dot;
use crate::part::Part;
use crate::render::Picture;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{
    Ball, BallInWorld, Candidates, Light, MOST, Size, View, are_apart, around_box, ends, may_shade, shaded,
};
use crate::shape::kinds::Kinds;
use crate::shape::{Outlined, Shape};
use crate::tier::Tier;
use crate::vector::{UnitVec3, Vec3, pairs};

/// The most shadows; in pictures of more none is known.
pub(super) const SHADOWS: usize = u32::BITS as usize;

/// What is known of the objects of a picture.
#[derive(Clone, Debug)]
pub(super) struct Known {
    pub(super) objects: heapless::Vec<KnownObject, MOST>,
    /// Where shadows may be seen of all objects but planes; `None` if that is not known.
    ///
    /// A plane throws none on what is seen before it: in a light on its other side it shades all that, and in a light
    /// on this side nothing.
    pub(super) shadows: Option<heapless::Vec<KnownShadow, SHADOWS>>,
    pub(super) planes: Candidates,
    /// The planes that may throw a shadow on what is seen: those with a light that is not surely on the eye's side.
    ///
    /// An object with certain spans is convex, and throws no shadow on itself.
    pub(super) shading: Candidates,
}

/// What is known of an object.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownObject {
    pub(super) outlined: Outlined,
    pub(super) is_solid: bool,
    pub(super) ball: Option<Ball>,
    /// A ball around the cap that is seen, if one is.
    pub(super) cap: Option<Ball>,
    /// True if its normals turn over the columns of a row as those of a ball do.
    is_round: bool,
    /// The objects that have no point in common with it.
    apart: Candidates,
    /// The shadows that may fall on it: bit `i` is the `i`-th one known.
    shaded_by: u32,
    /// The most columns between pixels that are traced where its light changes smoothly.
    longest: u16,
}

/// Where the shadow of an object in a light may be seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownShadow {
    pub(super) object: u32,
    pub(super) light: u32,
    /// The first row and the one after the last, and so the columns.
    pub(super) rows: [u16; 2],
    pub(super) columns: [u16; 2],
}

impl Known {
    /// That of the objects of a picture; `None` if there are more than [`MOST`].
    pub(super) fn of<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(picture: &Picture<'_, S, E, T, K>) -> Option<Self> {
        let (scene, eye) = (picture.tracer.scene(), picture.raster.camera().position());
        let objects = scene.objects();
        let mut known =
            Self { objects: heapless::Vec::new(), shadows: None, planes: Candidates::NONE, shading: Candidates::NONE };
        let mut balls = heapless::Vec::<_, MOST>::new();
        for object in objects {
            balls.push(around_box(&object.shape)).ok()?;
        }
        for ((index, object), own) in (0_u32..).zip(objects).zip(&balls) {
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
            let object = KnownObject { outlined, is_solid, ball, cap, is_round, apart, shaded_by: 0, longest };
            known.objects.push(object).ok()?;
            if outlined == Outlined::Plane {
                known.planes = known.planes.with(index);
                if !scene.lights().iter().all(|light| is_on_side_of(eye, light, shape)) {
                    known.shading = known.shading.with(index);
                }
            }
        }
        known.shadows = known.find_shadows(picture, &balls);
        Some(known)
    }

    /// Finds the shadows of all objects but planes, and what they may fall on.
    fn find_shadows<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(
        &mut self,
        picture: &Picture<'_, S, E, T, K>,
        balls: &[Option<BallInWorld<S>>],
    ) -> Option<heapless::Vec<KnownShadow, SHADOWS>> {
        let mut shadows = heapless::Vec::new();
        let (scene, raster) = (picture.tracer.scene(), &picture.raster);
        let lights = if picture.tracer.uses(Effect::Shadows) { scene.lights() } else { &[] };
        let (view, Size { width, height, .. }) = (View::of(raster), raster.size());
        let floor = self.planes.first().and_then(|plane| scene.object(plane)).map(|object| &object.shape);
        for (object, ball) in (0_u32..).zip(balls).filter(|(object, _)| !self.planes.contain(*object)) {
            for (light, lamp) in (0_u32..).zip(lights) {
                let shadow = ball.and_then(|ball| Some((ball, view.shadow(ball, lamp, floor)?)));
                let all = [[0, height], [0, width]];
                let [rows, columns] = shadow.map_or(all, |((centre, _), shadow)| shaded(raster, &shadow, centre));
                if rows[0] >= rows[1] || columns[0] >= columns[1] {
                    continue;
                }
                let bit = bit(shadows.len() as u32);
                shadows.push(KnownShadow { object, light, rows, columns }).ok()?;
                for ((index, on), other) in (0..).zip(&mut self.objects).zip(balls) {
                    let both = ball.zip(*other);
                    if index != object && both.is_none_or(|(ball, other)| may_shade(ball, other, lamp)) {
                        on.shaded_by |= bit;
                    }
                }
            }
        }
        Some(shadows)
    }

    /// What an object looks like.
    pub(super) fn outlined(&self, object: u32) -> Outlined {
        self.objects.get(object as usize).map_or(Outlined::Other, |known| known.outlined)
    }

    /// The shadows that may fall on an object in this row; `None` if they are not known.
    pub(super) fn shadows_on(&self, object: u32, y: u16) -> Option<impl Iterator<Item = &KnownShadow>> {
        let by = self.objects.get(object as usize)?.shaded_by;
        let shadows = (0_u32..).zip(self.shadows.as_ref()?);
        let on_it = shadows.filter(move |(index, _)| by & bit(*index) != 0).map(|(_, shadow)| shadow);
        Some(on_it.filter(move |shadow| (shadow.rows[0]..shadow.rows[1]).contains(&y)))
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

/// That of the `index`-th shadow.
const fn bit(index: u32) -> u32 {
    1 << (index % u32::BITS)
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

/// The most columns of a curve on a shape: as many as what the nearest light brightens by Lambert's law is wide. For
/// other shapes than planes that is the height of the light over the ball around it, as seen from the ball's far side.
/// 0 if no ball is known.
fn longest<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(
    picture: &Picture<'_, S, E, T, K>,
    shape: &Shape<S, K>,
    ball: Option<BallInWorld<S>>,
) -> u16 {
    let (scene, raster) = (picture.tracer.scene(), &picture.raster);
    let (Some(half), eye) = (raster.half_a_pixel(), raster.camera().position().real()) else { return 0 };
    let from = |a: [S::Real; 3], b: [S::Real; 3]| pairs(a, b).map(|(a, b)| a - b);
    let length = |v: [S::Real; 3]| dot(v, v).sqrt();
    let mut longest = curve::LONGEST;
    for light in scene.lights().iter().filter(|light| !light.distant) {
        let [width, unit] = if let Some(plane) = shape.plane() {
            LightOver::new(light, plane).width(raster)
        } else if let Some((centre, legs)) = ball {
            let radius = length(legs.map(S::real));
            let height = length(from(light.position.real(), centre.real())) - radius;
            [height, length(from(centre.real(), eye)) + radius]
        } else {
            return 0;
        };
        let column = unit * half.scaled(1);
        while longest >= curve::SHORTEST && width < column * S::Real::from_int(longest.into()) {
            longest /= 2;
        }
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
