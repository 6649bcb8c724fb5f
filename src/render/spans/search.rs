//! Rays that find the first and the last column in which something is seen.
//!
//! The rays of a row lie in a plane. Those that meet a convex solid before all planes lie within one angle of it, and
//! so do those that see a flat part of the solid, or its shadow on a plane. If one of these rays is known, bisection
//! finds the first and the last column, and no ray between them is cast.

use super::known::{Known, KnownObject};
use super::light_over::LightOver;
use crate::effect::{Effects, TraceContext};
use crate::hit::Crossing;
use crate::part::Part;
use crate::ray::Ray;
use crate::render::Picture;
use crate::scalar::Scalar;
use crate::scene::{Candidates, Observer, RaysOfRow, SceneHit};
use crate::shape::kinds::Kinds;
use crate::shape::{Outlined, Section, Shape, Visible};
use crate::tier::Tier;
use crate::vector::{UnitVec3, Vec3};

/// Where something is seen: the first column and the one after the last.
#[derive(Clone, Copy, Debug)]
pub(super) enum Found {
    /// In no column.
    Nowhere,
    /// In all columns between them.
    Exactly([u16; 2]),
    /// In some columns between them, or in none.
    Within([u16; 2]),
}

impl<S: Scalar, E: Effects, T: Tier<S>, K: Kinds> Picture<'_, S, E, T, K> {
    /// The ray through a column, and its first hit among these objects.
    pub(super) fn first<O: Observer>(
        &self,
        rays: &RaysOfRow<'_, S>,
        x: u16,
        among: Candidates,
        context: &mut TraceContext<O>,
    ) -> Option<(Ray<S>, SceneHit<S>)> {
        let [right, _] = self.raster.place([x, 0], [0, 0]);
        let ray = rays.through(right)?;
        context.counters.primary_rays += 1;
        self.tracer.first(&ray, among, context).map(|on| (ray, on))
    }
}

/// Casts rays of a row.
pub(super) struct Search<'c, 'p, 's, S: Scalar, E, O, T, K: Kinds> {
    pub(super) picture: &'c Picture<'p, S, E, T, K>,
    pub(super) rays: &'c RaysOfRow<'s, S>,
    pub(super) known: &'c Known,
    pub(super) context: &'c mut TraceContext<O>,
}

impl<S: Scalar, E: Effects, O: Observer, T: Tier<S>, K: Kinds> Search<'_, '_, '_, S, E, O, T, K> {
    /// Where the only plane is seen: its columns follow each other, and so do those without it.
    pub(super) fn half_plane(&mut self, plane: u32) -> Found {
        let width = self.picture.size().width;
        let mut sees =
            |x: i32| self.picture.first(self.rays, x as u16, Candidates::NONE.with(plane), self.context).is_some();
        let [left, right] = [0, i32::from(width) - 1];
        match [sees(left), sees(right)] {
            [false, false] => Found::Nowhere,
            [true, true] => Found::Exactly([0, width]),
            [true, false] => Found::Exactly([0, outermost(right, left, FAR, &mut sees) as u16 + 1]),
            [false, true] => Found::Exactly([outermost(left, right, FAR, &mut sees) as u16, width]),
        }
    }

    /// Where an object is seen before all planes, or its cap, from the first of these columns to before the last.
    pub(super) fn convex(
        &mut self,
        (object, known): (u32, &KnownObject),
        cap: Option<Part>,
        columns: [u16; 2],
    ) -> Found {
        let (raster, among) = (&self.picture.raster, self.known.planes.with(object));
        let Some(of) = self.picture.tracer.scene().object(object).filter(|_| known.outlined != Outlined::Other) else {
            return Found::Within(columns);
        };
        let sees = |x: u16| {
            let first = self.picture.first(self.rays, x, among, self.context);
            first.is_some_and(|(_, on)| {
                // From the inside of a solid its rays leave it everywhere.
                let is_entered = !known.is_solid || on.hit.crossing != Crossing::Exit;
                on.object == object && is_entered && cap.is_none_or(|cap| on.hit.part == cap)
            })
        };
        between(columns, CLOSE, sees, || {
            let Some(normal) = raster.normal_of_row(self.rays) else { return Section::Unknown };
            let section = of.shape.section(raster.camera().position(), normal, cap);
            section.and_then(|point| Some(raster.pixel_of(point)?[0]))
        })
    }

    /// Where the shadow of an object in a light is seen on the only plane, from the first of these columns to before
    /// the last.
    ///
    /// The points of the plane in a row lie on a line. The object shades some of them only if it meets the plane
    /// through that line and the light.
    pub(super) fn shadow(
        &mut self,
        [object, light]: [u32; 2],
        (plane, on): (u32, (Vec3<S>, UnitVec3<S>)),
        columns: [u16; 2],
    ) -> Found {
        let (raster, scene) = (&self.picture.raster, self.picture.tracer.scene());
        // A solid that is seen from one side does not shade what is inside of it.
        let is_whole = |shape: &Shape<S, K>| !shape.is_solid() || shape.visible() == Visible::Both;
        let is_convex = self.known.outlined(object) != Outlined::Other;
        let of = scene.object(object).filter(|of| is_convex && is_whole(&of.shape));
        let of = of.zip(scene.lights().get(light as usize));
        let Some((of, lamp)) = of else { return Found::Within(columns) };
        let is_shaded = |x: u16| {
            let first = self.picture.first(self.rays, x, Candidates::NONE.with(plane), self.context);
            first.is_some_and(|(ray, on)| self.picture.tracer.is_shadowed_by(object, light, (&ray, on), self.context))
        };
        // They are those of the whole shadow.
        between(columns, FAR, is_shaded, || {
            let over = LightOver::new(lamp, on);
            let row = raster.normal_of_row(self.rays);
            let through = row.and_then(|row| over.plane_through(raster.camera().position(), row));
            let Some((point, normal)) = through else { return Section::Unknown };
            let section = of.shape.section(point, normal, None);
            section.and_then(|point| Some(raster.pixel_of(over.shadow_of(point)?)?[0]))
        })
    }
}

/// Where something is seen from the first of these columns to before the last, if all columns in which it is follow
/// each other, by a search of this first step. If the middle is not one of them, `other` may know one, or that there is
/// none.
fn between(
    columns: [u16; 2],
    step: i32,
    mut sees: impl FnMut(u16) -> bool,
    other: impl FnOnce() -> Section<i32>,
) -> Found {
    let mut sees = |x: i32| sees(x as u16);
    let [first, end] = columns.map(i32::from);
    let middle = first + (end - first) / 2;
    let mut inside = middle;
    if !sees(middle) {
        inside = match other() {
            Section::Missed => return Found::Nowhere,
            Section::At(column) if column >= first && column < end && sees(column) => column,
            Section::At(_) | Section::Unknown => return Found::Within(columns),
        };
    }
    let leftmost = outermost(first - 1, inside, step, &mut sees);
    Found::Exactly([leftmost as u16, outermost(end, inside, step, &mut sees) as u16 + 1])
}

/// The first step of a search for an end that is close to the column outside, and of one that halves all columns.
const CLOSE: i32 = 1;
const FAR: i32 = u16::MAX as i32;

/// The column nearest to `outside` in which something is seen, if it is seen in `inside` and not in `outside`.
///
/// Steps from there grow from the first one on until one is found, and are halved from then on.
fn outermost(mut outside: i32, mut inside: i32, mut step: i32, sees: &mut impl FnMut(i32) -> bool) -> i32 {
    while (inside - outside).abs() > 1 {
        let between = inside - outside;
        let is_near = step < between.abs() / 2;
        let probe = outside + if is_near { step * between.signum() } else { between / 2 };
        if sees(probe) {
            (inside, step) = (probe, FAR);
        } else {
            (outside, step) = (probe, 2 * step.min(FAR));
        }
    }
    inside
}
