//! What is known of the objects of a picture in every row: what they look like, and where their shadows may be.

use super::curve;
use crate::effect::{Course, Effect, Effects};
use crate::number::dot;
use crate::part::Part;
use crate::render::Picture;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{Ball, BallInWorld, Candidates, MOST, Raster, Size, View, are_apart, around_box, ends, shaded};
use crate::shape::kinds::Kinds;
use crate::shape::{Outlined, Shape};
use crate::tier::Tier;
use crate::vector::pairs;

/// The most shadows; in pictures of more none is known.
pub(super) const SHADOWS: usize = 2 * MOST;

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
}

/// What is known of an object.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownObject {
    pub(super) outlined: Outlined,
    pub(super) is_solid: bool,
    pub(super) ball: Option<Ball>,
    /// A ball around the cap that is seen, if one is.
    pub(super) cap: Option<Ball>,
    /// The objects that have no point in common with it.
    apart: Candidates,
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
        let (objects, eye) = (picture.tracer.scene().objects(), picture.raster.camera().position());
        let mut known = Self { objects: heapless::Vec::new(), shadows: None, planes: Candidates::NONE };
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
            known.objects.push(KnownObject { outlined, is_solid, ball, cap, apart, longest }).ok()?;
            if outlined == Outlined::Plane {
                known.planes = known.planes.with(index);
            }
        }
        known.shadows = known.shadows_of(picture, &balls);
        Some(known)
    }

    fn shadows_of<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(
        &self,
        picture: &Picture<'_, S, E, T, K>,
        balls: &[Option<BallInWorld<S>>],
    ) -> Option<heapless::Vec<KnownShadow, SHADOWS>> {
        let mut shadows = heapless::Vec::new();
        let (scene, raster) = (picture.tracer.scene(), &picture.raster);
        if !picture.tracer.uses(Effect::Shadows) {
            return Some(shadows);
        }
        let (view, Size { width, height, .. }) = (View::of(raster), raster.size());
        let floor = self.planes.first().and_then(|plane| scene.object(plane)).map(|object| &object.shape);
        for (object, ball) in (0_u32..).zip(balls).filter(|(object, _)| !self.planes.contain(*object)) {
            for (light, lamp) in (0_u32..).zip(scene.lights()) {
                let shadow = ball.and_then(|ball| Some((ball, view.shadow(ball, lamp, floor)?)));
                let all = [[0, height], [0, width]];
                let [rows, columns] = shadow.map_or(all, |((centre, _), shadow)| shaded(raster, &shadow, centre));
                if rows[0] < rows[1] && columns[0] < columns[1] {
                    shadows.push(KnownShadow { object, light, rows, columns }).ok()?;
                }
            }
        }
        Some(shadows)
    }

    /// What an object looks like.
    pub(super) fn outlined(&self, object: u32) -> Outlined {
        self.objects.get(object as usize).map_or(Outlined::Other, |known| known.outlined)
    }

    /// True if none of these objects has a point in common with this one.
    pub(super) fn is_apart(&self, object: u32, others: Candidates) -> bool {
        self.objects.get(object as usize).is_some_and(|known| known.apart.with(object).include(others))
    }

    /// The most columns from a pixel to the next that is traced, on this part of an object; 0 if its light may change
    /// in any way.
    pub(super) fn longest<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(
        &self,
        picture: &Picture<'_, S, E, T, K>,
        on: (u32, Part),
    ) -> u16 {
        let most = self.objects.get(on.0 as usize).map_or(0, |known| known.longest);
        match picture.tracer.course(Some(on)) {
            Course::Smooth => most,
            Course::Glossy(shine) if self.is_flat(on) => longest_of_highlights(most, shine, &picture.raster),
            Course::Same | Course::Glossy(_) | Course::Any => 0,
        }
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

/// The most columns of a curve on a shape: as many as the nearest light is above it, as seen from the eye at the point
/// below the light, since what that light brightens by Lambert's law is about as wide. 0 if no ball is known.
fn longest<S: Scalar, E: Effects, T: Tier<S>, K: Kinds>(
    picture: &Picture<'_, S, E, T, K>,
    shape: &Shape<S, K>,
    ball: Option<BallInWorld<S>>,
) -> u16 {
    let (scene, raster) = (picture.tracer.scene(), &picture.raster);
    let (Some(half), eye) = (raster.half_a_pixel(), raster.camera().position().real()) else { return 0 };
    let from = |a: [S::Real; 3], b: [S::Real; 3]| pairs(a, b).map(|(a, b)| a - b);
    let length = |v: [S::Real; 3]| dot(v, v).sqrt();
    let mut longest = curve::longest::<S>();
    for light in scene.lights().iter().filter(|light| !light.distant) {
        let lamp = light.position.real();
        let (height, distance) = if let Some((on, normal)) = shape.plane() {
            let height = dot(from(lamp, on.real()), normal.real());
            let below = pairs(lamp, normal.real()).map(|(lamp, normal)| lamp - normal * height);
            (height.abs(), length(from(below, eye)))
        } else if let Some((centre, legs)) = ball {
            let radius = length(legs.map(S::real));
            (length(from(lamp, centre.real())) - radius, length(from(centre.real(), eye)) + radius)
        } else {
            return 0;
        };
        let column = distance * half.scaled(1);
        while longest >= curve::SHORTEST && height < column * S::Real::from_int(longest.into()) {
            longest /= 2;
        }
    }
    longest
}

/// The most columns of a curve, of so many at most, over highlights of this exponent on a flat part. A highlight is
/// `2.4 / sqrt(e)` wide at half of its height: a curve is no longer than a quarter of that, for the eye.
fn longest_of_highlights<S: Scalar>(most: u16, exponent: S, raster: &Raster<S>) -> u16 {
    let Some(half) = raster.half_a_pixel() else { return 0 };
    let mut longest = most;
    while longest >= curve::SHORTEST {
        let wide = half.scaled(1) * S::Real::from_int(longest.into());
        if wide * wide * exponent.real() <= S::Real::from_int(3).scaled(-3) {
            return longest;
        }
        longest /= 2;
    }
    longest
}
