//! Which rows of a picture an animation draws again.

use super::{Picture, Pixel};
use crate::effect::{Effect, Effects, TraceContext};
use crate::part::Part;
use crate::scalar::Scalar;
use crate::scene::{Counters, Directions, Object, View, around};
use crate::shape::kinds::Kinds;
use crate::tier::Tier;

impl<S: Scalar, E: Effects, T: Tier<S>, K: Kinds> Picture<'_, S, E, T, K> {
    /// The rows that may differ from those of a picture of the frame before, in which objects were placed otherwise, or
    /// were others. All other rows are the same to the bit, and need not be drawn again. (In scenes of more than 16
    /// objects [`Plain`](crate::tier::Plain) and [`Fast`](crate::tier::Fast) may invent hits in them, farther from an
    /// object than they promise.)
    ///
    /// These rows may show an object that differs, as it is or as it was, its shadow, or a mirror or a transparent
    /// object, in which it may be seen. Objects are told apart by their index, and a ball stands for each; a shadow
    /// ends at planes that stay. So every row is among them if an object differs that has no such ball: a plane, any
    /// that is infinite, any that a matrix places, or a combination; or if the pictures differ in anything but their
    /// objects; or if the camera is orthographic.
    ///
    /// ```
    /// # use raylet::{Camera, Frame, Light, Material, Object, Picture, Plane, Scene, Shape, Size, Sphere, Vec3};
    /// # let (eye, up) = (Vec3::new(0.0_f32, 2.0, 8.0), Vec3::new(0.0, 1.0, 0.0));
    /// let ball = Shape::new(Sphere::new(0.5)?);
    /// let at = |x| Frame::at(Vec3::new(x, 1.0, 0.0)).map(|place| Object::new(ball.placed(place), 0));
    /// let floor = Object::new(Shape::new(Plane::new()), 0);
    /// let (first, second) = ([floor, at(0.0)?], [floor, at(0.25)?]);
    /// # let camera = Camera::new(eye, up, up, 40.0)?;
    /// # let (materials, lights) = ([Material::default()], [Light::new(Vec3::new(2.0, 9.0, 4.0), 0.9)]);
    /// let before = Scene::new(&first, &materials, &lights, camera)?;
    /// let now = Scene::new(&second, &materials, &lights, camera)?;
    /// let [before, now] = [&before, &now].map(|scene| Picture::new(scene, Size::new(64, 48)));
    /// assert_eq!(now.changed_rows(&before).count(), 19);
    /// assert_eq!(now.render_changed(&before, |_, _, _| {}).primary_rays, 19 * 64);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn changed_rows<'p>(&'p self, before: &'p Picture<'_, S, E, T, K>) -> impl Iterator<Item = u16> + 'p {
        let are_comparable = self.raster == before.raster
            && self.levels == before.levels
            && self.tracer.differs_only_in_objects(&before.tracer);
        (0..self.size().height).filter(move |y| !are_comparable || self.may_differ(before, u32::from(*y)))
    }

    /// Traces the [changed rows](Picture::changed_rows), and passes each of their pixels to `each` with its column and
    /// row. Returns the counters of rays and tests.
    pub fn render_changed(
        &self,
        before: &Picture<'_, S, E, T, K>,
        mut each: impl FnMut(u16, u16, Pixel<S>),
    ) -> Counters {
        let mut context = TraceContext::new(());
        for y in self.changed_rows(before) {
            for (x, pixel) in (0..=u16::MAX).zip(self.row(y, &mut context)) {
                each(x, y, pixel);
            }
        }
        context.counters
    }

    fn may_differ(&self, before: &Picture<'_, S, E, T, K>, y: u32) -> bool {
        // An outline is drawn where a ray some rows below sees something else.
        let outline = if self.tracer.uses(Effect::Outline) { self.tracer.scene().outline() } else { None };
        let below = outline.map(|outline| u32::from(outline.width));
        [Some(0), below].into_iter().flatten().any(|below| self.may_see_others(before, y + below))
    }

    /// True if a ray of a row may see what it did not see before.
    fn may_see_others(&self, before: &Picture<'_, S, E, T, K>, y: u32) -> bool {
        let Some(row) = Directions::of_row(&self.raster, y) else { return true };
        let view = View::of(&self.raster);
        let [now, was] = [self, before].map(|picture| picture.tracer.scene().objects());
        let stay = || now.iter().zip(was).filter(|(now, was)| now == was).map(|(now, _)| now);
        let (mut is_changed, mut shows_others) = (false, false);
        for index in 0..now.len().max(was.len()) {
            let pair = [now.get(index), was.get(index)];
            if let [Some(now), Some(was)] = pair
                && now == was
            {
                shows_others |= self.sends_rays_on(now) && view.ball(&now.shape).is_none_or(|ball| row.may_meet(&ball));
                continue;
            }
            is_changed = true;
            for object in pair.into_iter().flatten() {
                let may_be_seen = view.ball(&object.shape).is_none_or(|ball| row.may_meet(&ball));
                if may_be_seen || self.may_shade(object, &row, &view, &stay()) {
                    return true;
                }
            }
        }
        is_changed && shows_others
    }

    /// True if a ray of a row may see the shadow of an object where others, which stay, do not throw theirs.
    fn may_shade<'o>(
        &self,
        object: &Object<S, K>,
        row: &Directions,
        view: &View<S>,
        others: &(impl Iterator<Item = &'o Object<S, K>> + Clone),
    ) -> bool
    where
        K: 'o,
    {
        let lights = if self.tracer.uses(Effect::Shadows) { self.tracer.scene().lights() } else { &[] };
        lights.iter().any(|light| {
            let may_meet = |other: Option<&Object<S, K>>| {
                let ball = around(&object.shape);
                let shadow = ball.and_then(|ball| view.shadow(ball, light, other.map(|other| &other.shape)));
                shadow.is_none_or(|shadow| row.may_meet_shadow(&shadow))
            };
            let planes = others.clone().filter(|other| other.shape.plane().is_some());
            may_meet(None) && planes.map(Some).all(may_meet)
        })
    }

    /// True if other objects may be seen in a mirror or through a transparent material of this one.
    fn sends_rays_on(&self, object: &Object<S, K>) -> bool {
        let (reflects, refracts) = (self.tracer.uses(Effect::Reflection), self.tracer.uses(Effect::Refraction));
        [Part::Side, Part::Base, Part::Top].into_iter().any(|part| {
            let material = self.tracer.scene().material_of(object, part);
            material.is_some_and(|material| reflects && material.mirror > S::ZERO || refracts && material.transmits())
        })
    }
}
