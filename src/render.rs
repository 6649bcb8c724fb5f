//! Pictures.
//!
//! No frame buffer is needed: a [`Picture`] computes any single pixel or row, and [`Picture::render`] passes the pixels
//! to a function one by one, row after row, so that they may be sent directly to a display. Rows do not depend on each
//! other.

mod changes;
mod spans;

pub use spans::{InSpans, RowInSpans};

use crate::effect::{All, Effect, EffectError, EffectSet, Effects, Sample, TraceContext, Tracer, differ};
use crate::part::Part;
use crate::ray::Ray;
use crate::scalar::{Real, Ring, Scalar};
use crate::scene::{
    Candidates, CandidatesOfRow, Color, Counters, Levels, Observer, Raster, RaysOfRow, Scene, SceneHit, Size,
};
use crate::shape::kinds::{self, Kinds};
use crate::tier::{Stable, Tier};

/// A picture of a scene from its camera in a given size, with the effects `E` compiled in, in the scene's
/// accuracy tier `T`.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a, S: Scalar, E = All, T = Stable, K: Kinds = kinds::All> {
    tracer: Tracer<'a, S, E, T, K>,
    raster: Raster<S>,
    /// The levels of a channel that the cut-off must not change, where the picture is not antialiased.
    levels: Levels,
}

/// One pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(bound = ""))]
pub struct Pixel<S: Scalar> {
    /// The mean of its samples, each clamped to `[0, 1]` before averaging, so that the edges of highlights are
    /// antialiased too. If the corners agree, only they are sampled, and this is their mean.
    pub color: Color<S>,
    /// The first hit of its middle sample (or of all corners): the object and the part of its surface; `None` for the
    /// background.
    pub seen: Option<(u32, Part)>,
    /// Bit mask of the first 32 lights that contribute to the shading of that hit.
    pub lit_by: u32,
}

impl<'a, S: Scalar, T: Tier<S>, K: Kinds> Picture<'a, S, All, T, K> {
    /// The picture of a scene in this size, with every effect compiled in. Those that the scene needs are used.
    pub fn new(scene: &'a Scene<'a, S, T, K>, size: Size) -> Self {
        Self::leaving_out(scene, size)
    }
}

impl<'a, S: Scalar, E: Effects, T: Tier<S>, K: Kinds> Picture<'a, S, E, T, K> {
    /// The picture of a scene at this size, with the effects `E` compiled in.
    ///
    /// # Errors
    ///
    /// [`EffectError`] if the scene needs an effect that is not among them, or if the size has several samples for each
    /// pixel and antialiasing is not among them.
    ///
    /// ```
    /// # use raylet::{Camera, Color, Light, Material, Object, Picture, Scene, Shape, Size, Sphere, Vec3};
    /// # let y = Vec3::new(0.0_f32, 1.0, 0.0);
    /// # let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, y, 40.0)?;
    /// use raylet::effect::{Diffuse, Shadows};
    /// # let objects = [Object::new(Shape::new(Sphere::new(1.0_f32)?), 0)];
    /// # let lights = [Light::new(Vec3::new(0.0, 0.0, 9.0), 0.5)];
    /// let materials = [Material::matte(Color::WHITE).with_mirror(0.3)];
    /// let scene = Scene::new(&objects, &materials, &lights, camera)?;
    /// let error = Picture::<f32, (Diffuse, Shadows)>::try_new(&scene, Size::new(8, 6)).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "object 0 calls for reflection, which is not compiled in: name `Reflection` among the effects"
    /// );
    /// # Ok::<(), raylet::Error>(())
    /// ```
    ///
    /// With chosen effects and chosen kinds of shapes the two last parameters are inferred from the scene:
    ///
    /// ```
    /// use raylet::effect::{Diffuse, Shadows};
    /// use raylet::{Camera, Color, Light, Material, Object, Picture, Plane, Scene, Shape, Size, Sphere, Vec3};
    ///
    /// type Kinds = (Sphere<f32>, Plane<f32>);
    /// let objects = [Object::new(Shape::<f32, Kinds>::of(Sphere::new(1.0)?), 0)];
    /// let (materials, lights) = ([Material::matte(Color::WHITE)], [Light::new(Vec3::new(0.0, 0.0, 9.0), 0.5)]);
    /// let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0)?;
    /// let scene = Scene::new(&objects, &materials, &lights, camera)?;
    /// let picture = Picture::<f32, (Diffuse, Shadows), _, _>::try_new(&scene, Size::new(8, 6))?;
    /// # assert_eq!(picture.render(|_, _, _| {}).primary_rays, 48);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn try_new(scene: &'a Scene<'a, S, T, K>, size: Size) -> Result<Self, EffectError> {
        if size.samples > 1 && !E::SET.contains(Effect::Antialiasing) {
            return Err(EffectError::Antialiasing { samples: size.samples });
        }
        let tracer = Tracer::try_new(scene)?;
        Ok(Self { tracer, raster: scene.camera().raster(size), levels: Levels::Srgb })
    }

    /// The picture of a scene in this size, with the effects `E` compiled in. Other effects that the scene needs are
    /// left out; without antialiasing each pixel has one sample.
    pub fn leaving_out(scene: &'a Scene<'a, S, T, K>, size: Size) -> Self {
        let (tracer, raster) = (Tracer::leaving_out(scene), scene.camera().raster(size));
        let picture = Self { tracer, raster, levels: Levels::Srgb };
        if E::SET.contains(Effect::Antialiasing) { picture } else { picture.with_one_sample() }
    }

    /// The same picture with those of its effects that are in the set, without all others; see [`Tracer::only`].
    ///
    /// ```
    /// # use raylet::{Camera, Color, Light, Material, Object, Picture, Scene, Shape, Size, Sphere, Vec3};
    /// # let y = Vec3::new(0.0_f32, 1.0, 0.0);
    /// # let camera = Camera::new(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO, y, 40.0)?;
    /// use raylet::effect::{Effect, EffectSet};
    /// # let objects = [Object::new(Shape::new(Sphere::new(1.0_f32)?), 0)];
    /// # let materials = [Material::matte(Color::WHITE)];
    /// # let lights = [Light::new(Vec3::new(0.0, 9.0, 9.0), 0.5)];
    /// # let scene = Scene::new(&objects, &materials, &lights, camera)?;
    /// let picture = Picture::new(&scene, Size::new(8, 6));
    /// assert!(picture.render(|_, _, _| {}).shadow_rays > 0);
    /// let without = picture.only(EffectSet::ALL.without(Effect::Shadows));
    /// assert_eq!(without.render(|_, _, _| {}).shadow_rays, 0);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    #[must_use]
    pub fn only(self, effects: EffectSet) -> Self {
        let picture = Self { tracer: self.tracer.only(effects), ..self };
        if effects.contains(Effect::Antialiasing) { picture } else { picture.with_one_sample() }
    }

    /// The same picture without the cut-off, so that every ray is cast; see [`Tracer::uncut`].
    #[must_use]
    pub fn uncut(self) -> Self {
        Self { tracer: self.tracer.uncut(), ..self }
    }

    /// The same picture for [`Color::to_linear888`]: the cut-off changes no level that is in proportion to the light.
    #[must_use]
    pub fn in_linear_levels(self) -> Self {
        Self { levels: Levels::Linear, ..self }
    }

    /// The same picture with a cut-off at a sixteenth of an eight-bit level, for displays with other levels.
    #[cfg(feature = "embedded-graphics")]
    pub(crate) fn finely(self) -> Self {
        Self { levels: Levels::Fine, ..self }
    }

    fn with_one_sample(self) -> Self {
        let raster = self.tracer.scene().camera().raster(self.size().with_samples(1));
        Self { raster, ..self }
    }

    /// The size of the picture.
    pub const fn size(&self) -> Size {
        self.raster.size()
    }

    /// The effects in use.
    pub fn effects(&self) -> EffectSet {
        let effects = self.tracer.effects();
        if self.is_antialiased() { effects.with(Effect::Antialiasing) } else { effects }
    }

    #[inline(always)]
    fn is_antialiased(&self) -> bool {
        E::SET.contains(Effect::Antialiasing) && self.size().samples > 1
    }

    /// Traces the pixel in column `x` of row `y`, counted from the upper left. Adds its rays and tests to `context`.
    ///
    /// With several samples for each pixel, [`Picture::row`] gives the same pixels with fewer rays.
    pub fn pixel<O: Observer>(&self, x: u16, y: u16, context: &mut TraceContext<O>) -> Pixel<S> {
        if self.is_antialiased() {
            return self.pixel_of_many(x, y, context);
        }
        let [right, down] = self.raster.place([x, y], [0, 0]);
        self.pixel_of_one(&self.raster.row(down), right, None, context)
    }

    #[inline(always)]
    fn pixel_of_one<O: Observer>(
        &self,
        row: &RaysOfRow<'_, S>,
        right: i32,
        candidates: Option<Candidates>,
        context: &mut TraceContext<O>,
    ) -> Pixel<S> {
        let Sample { color, seen, lit_by } = self.sample(row, right, candidates, self.levels, context);
        Pixel { color, seen, lit_by }
    }

    /// Not inlined, so that pictures with one sample for each pixel do not take its stack frame.
    #[inline(never)]
    fn pixel_of_many<O: Observer>(&self, x: u16, y: u16, context: &mut TraceContext<O>) -> Pixel<S> {
        let (left, right) = (self.edge(u32::from(x), y, context), self.edge(u32::from(x) + 1, y, context));
        self.between([left, right], [x, y], context)
    }

    /// The pixels of row `y` from the left. Clears the shadow cache of `context`, and adds rays and tests to its
    /// counters.
    ///
    /// A ray tests only the objects whose bounding balls it may meet; with one sample for each pixel these are found
    /// once for all columns of the row. The pixels are those of [`Picture::pixel`], but for hits that
    /// [`Plain`](crate::tier::Plain) and [`Fast`](crate::tier::Fast) may invent farther away than they promise.
    ///
    /// With several samples for each pixel, its corners are traced first, which neighbours share. If the corners see
    /// the same part of the same object in the same lights, and no channel differs by more than eight levels of sRGB,
    /// the pixel is their mean. Otherwise the whole grid of `samples * samples` rays is traced, and the pixel is the
    /// mean of these.
    pub fn row<'w, O: Observer>(&'w self, y: u16, context: &'w mut TraceContext<O>) -> Row<'w, 'a, S, E, O, T, K> {
        self.row_from(0, y, context)
    }

    /// The pixels of row `y` from column `x` on.
    pub(crate) fn row_from<'w, O: Observer>(
        &'w self,
        x: u16,
        y: u16,
        context: &'w mut TraceContext<O>,
    ) -> Row<'w, 'a, S, E, O, T, K> {
        context.forget();
        let next = u32::from(x);
        let (left, candidates) = if self.is_antialiased() {
            (Some(self.edge(next, y, context)), None)
        } else {
            (None, CandidatesOfRow::new(self.tracer.balls(), &self.raster, y))
        };
        let [_, down] = self.raster.place([0, y], [0, 0]);
        Row { picture: self, context, next, y, left, rays: self.raster.row(down), candidates }
    }

    /// Traces every pixel, row after row from the upper left, and passes each to `each` with its column and row.
    /// Returns the counters of rays and tests.
    pub fn render(&self, mut each: impl FnMut(u16, u16, Pixel<S>)) -> Counters {
        let mut context = TraceContext::new(());
        for y in 0..self.size().height {
            for (x, pixel) in (0..=u16::MAX).zip(self.row(y, &mut context)) {
                each(x, y, pixel);
            }
        }
        context.counters
    }

    /// What a primary ray of a row sees, so many half samples from the left edge; its colour is clamped to `[0, 1]`.
    fn sample<O: Observer>(
        &self,
        row: &RaysOfRow<'_, S>,
        right: i32,
        candidates: Option<Candidates>,
        levels: Levels,
        context: &mut TraceContext<O>,
    ) -> Sample<S> {
        let Some(ray) = row.through(right) else {
            return Sample { color: Color::BLACK, seen: None, lit_by: 0 };
        };
        context.counters.primary_rays += 1;
        let candidates = candidates.unwrap_or_else(|| self.tracer.candidates(&ray));
        let gathered = self.tracer.gather(&ray, candidates, levels, context);
        let mut sample = gathered.sample();
        if self.tracer.uses(Effect::Outline)
            && let Some(outline) = self.tracer.scene().outline()
            && self.is_outlined(row, right, outline.width, &ray, gathered.first, context)
        {
            sample.color = outline.color;
        }
        Sample { color: sample.color.clamped(), ..sample }
    }

    /// True if an edge is so many pixels to the right of a point of the raster or below it, or nearer.
    ///
    /// Not inlined, so that pictures without an outline do not take its stack frame.
    #[inline(never)]
    fn is_outlined<O: Observer>(
        &self,
        row: &RaysOfRow<'_, S>,
        right: i32,
        width: u8,
        ray: &Ray<S>,
        on: Option<SceneHit<S>>,
        context: &mut TraceContext<O>,
    ) -> bool {
        let width = i32::from(width) * self.raster.pixel();
        let beside = [row.through(right + width), self.raster.row(row.down() + width).through(right)];
        beside.into_iter().flatten().any(|beside| self.tracer.sees_edge([ray, &beside], on, context))
    }

    /// The two corners, upper and lower, on the left of the pixel in column `x`.
    fn edge<O: Observer>(&self, x: u32, y: u16, context: &mut TraceContext<O>) -> [Sample<S>; 2] {
        let y = u32::from(y);
        [y, y + 1].map(|y| {
            let [right, down] = self.raster.corner([x, y]);
            self.sample(&self.raster.row(down), right, None, Levels::Fine, context)
        })
    }

    /// The pixel between two edges.
    fn between<O: Observer>(
        &self,
        edges: [[Sample<S>; 2]; 2],
        at: [u16; 2],
        context: &mut TraceContext<O>,
    ) -> Pixel<S> {
        let [[a, b], [c, d]] = edges;
        let corners = [a, b, c, d];
        if differ(&corners) {
            context.counters.refined_pixels += 1;
            return self.grid(at, context);
        }
        let mut mean = Mean::new();
        for corner in corners {
            mean.take(corner.color);
        }
        Pixel { color: mean.of(4), seen: a.seen, lit_by: a.lit_by }
    }

    /// The pixel from the whole grid of its samples.
    fn grid<O: Observer>(&self, at: [u16; 2], context: &mut TraceContext<O>) -> Pixel<S> {
        let samples = self.size().samples.max(1);
        let mut mean = Mean::new();
        let mut middle = Sample { color: Color::BLACK, seen: None, lit_by: 0 };
        for row in 0..samples {
            for column in 0..samples {
                let [right, down] = self.raster.place(at, [column, row]);
                let sample = self.sample(&self.raster.row(down), right, None, Levels::Fine, context);
                mean.take(sample.color);
                if (column, row) == (samples / 2, samples / 2) {
                    middle = sample;
                }
            }
        }
        let color = mean.of(i32::from(samples) * i32::from(samples));
        Pixel { color, seen: middle.seen, lit_by: middle.lit_by }
    }
}

/// A mean of colours.
struct Mean<S: Scalar> {
    sum: [S::Real; 3],
}

impl<S: Scalar> Mean<S> {
    fn new() -> Self {
        Self { sum: [S::Real::ZERO; 3] }
    }

    fn take(&mut self, color: Color<S>) {
        for (sum, channel) in self.sum.iter_mut().zip(color.to_array()) {
            *sum = *sum + S::unit_real(channel);
        }
    }

    fn of(self, count: i32) -> Color<S> {
        let count = S::Real::from_int(count);
        self.sum.map(|sum| S::unit_round(sum / count)).into()
    }
}

/// Iterator over the pixels of a row, which are traced one by one: see [`Picture::row`].
#[derive(Debug)]
pub struct Row<'w, 'a, S: Scalar, E, O, T = Stable, K: Kinds = kinds::All> {
    picture: &'w Picture<'a, S, E, T, K>,
    context: &'w mut TraceContext<O>,
    next: u32,
    y: u16,
    /// The corners on the left of the next pixel.
    left: Option<[Sample<S>; 2]>,
    /// The objects that the next pixel's ray may meet, if it has one sample.
    rays: RaysOfRow<'w, S>,
    candidates: Option<CandidatesOfRow>,
}

impl<S: Scalar, E: Effects, O: Observer, T: Tier<S>, K: Kinds> Iterator for Row<'_, '_, S, E, O, T, K> {
    type Item = Pixel<S>;

    fn next(&mut self) -> Option<Pixel<S>> {
        let x = u16::try_from(self.next).ok().filter(|x| *x < self.picture.size().width)?;
        self.next += 1;
        if !self.picture.is_antialiased() {
            let candidates = self.candidates.as_mut().map(|row| row.of(x));
            let [right, _] = self.picture.raster.place([x, self.y], [0, 0]);
            return Some(self.picture.pixel_of_one(&self.rays, right, candidates, self.context));
        }
        let left = self.left?;
        let right = self.picture.edge(self.next, self.y, self.context);
        self.left = Some(right);
        Some(self.picture.between([left, right], [x, self.y], self.context))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = u32::from(self.picture.size().width).saturating_sub(self.next) as usize;
        (left, Some(left))
    }
}

impl<S: Scalar, E: Effects, O: Observer, T: Tier<S>, K: Kinds> ExactSizeIterator for Row<'_, '_, S, E, O, T, K> {}

impl<S: Scalar, E: Effects, O: Observer, T: Tier<S>, K: Kinds> core::iter::FusedIterator
    for Row<'_, '_, S, E, O, T, K>
{
}

#[cfg(units)]
#[expect(clippy::expect_used, reason = "a test may panic")]
#[path = "../tests/units/render.rs"]
mod tests;
