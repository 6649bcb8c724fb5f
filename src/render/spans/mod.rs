//! Pictures by spans: the pixels of a row that follow each other and see the same part of the same object.
//!
//! Spans are as old as pictures of solids: Wylie, Romney, Evans and Erdahl, *Half-tone perspective drawings by
//! computer* (1967), and Watkins, *A real time visible surface algorithm* (1970), find their ends by the edges of
//! polygons. Here rays find them, so that curved solids have spans too, and the ends are where a picture that is traced
//! pixel by pixel has them.
//!
//! | module | what it holds |
//! |---|---|
//! | `known` | what is known of the objects in every row |
//! | `search` | rays that find the first and the last column in which something is seen |
//! | `regions` | those columns, for all objects and shadows of a row |
//! | `place` | where in a picture balls and their shadows may be seen |
//! | `light_over` | a light over a plane |
//! | `curve` | light between pixels that were traced |

mod curve;
mod known;
mod light_over;
mod place;
mod regions;
mod search;

use super::{Picture, Pixel, Row};
use crate::effect::{All, Course, Effect, Effects, TraceContext};
use crate::part::Part;
use crate::scalar::Scalar;
use crate::scene::{Candidates, Counters, Observer, Size};
use crate::shape::Outlined;
use crate::shape::kinds::{self, Kinds};
use crate::tier::{Stable, Tier};
use curve::{Curve, Reciprocals};
use known::Known;
use regions::{Regions, Seen};

/// The most pixels that are traced ahead: the last one of a curve, and the middles of its halves.
const AHEAD: usize = curve::LONGEST.ilog2() as usize;

/// A picture that is traced by spans: see [`Picture::in_spans`].
#[derive(Clone, Debug)]
pub struct InSpans<'a, S: Scalar, E = All, T = Stable, K: Kinds = kinds::All> {
    picture: Picture<'a, S, E, T, K>,
    /// What is known of the objects; `None` if each pixel is traced by itself.
    known: Option<(Known, Reciprocals<S>)>,
}

impl<'a, S: Scalar, E: Effects, T: Tier<S>, K: Kinds> Picture<'a, S, E, T, K> {
    /// The same picture with fewer rays: by spans, which are pixels of a row that follow each other and see the same
    /// part of the same object. Rays find their first and last pixels. Between them no ray is cast where the light is
    /// the same, and few where it changes smoothly.
    ///
    /// Each pixel shows the part of the object that it shows in the picture made pixel by pixel, since the rays of a
    /// row that see a convex solid, or a flat part of it, lie within one angle. (Rays are rounded, so that one that
    /// grazes an edge may be an exception.) Diffused light is interpolated by parabolas through traced pixels: mostly
    /// it is off by no more than an eight-bit level of sRGB or two. All other light is traced.
    ///
    /// | what | is found by spans |
    /// |---|---|
    /// | spheres, cuboids, prisms, polyhedra, discs, rectangles, triangles | yes |
    /// | capped or infinite cylinders and cones, surfaces of revolution with caps and without a waist | yes |
    /// | planes that are seen from both sides | yes |
    /// | capsules, round cones, rounded cuboids | their ends; each pixel between them is traced |
    /// | all others; what is seen from inside only; solids around the eye; what may touch where it overlaps | no |
    ///
    /// Light is interpolated where only Lambert's law, ambient light and fog make it, with highlights on flat parts,
    /// spheres and cylinders alone; and not where a shadow may begin or end, but for shadows of convex solids on the
    /// only plane of a scene, whose ends rays find, too. Rays are cast to lights only where a shadow may fall.
    ///
    /// Every pixel is traced by itself if the scene has more than 16 objects, if something in it refracts, if it has an
    /// outline, if a pixel has several samples, or if the camera is orthographic. With more than 32 pairs of objects
    /// and lights no shadow's place is known.
    ///
    /// In 32-bit fixed point the value takes up to 2,800 bytes, as it holds what is known of all objects, and the
    /// iterator of a row up to 1,100. Where a row begins may change interpolated light.
    ///
    /// ```
    /// # use raylet::{Camera, Color, Frame, Light, Material, Object, Picture, Plane, Scene, Shape, Size, Sphere, Vec3};
    /// # let (eye, up) = (Vec3::new(0.0_f32, 2.0, 8.0), Vec3::new(0.0, 1.0, 0.0));
    /// # let camera = Camera::new(eye, up, up, 40.0)?;
    /// let ball = Shape::new(Sphere::new(0.5)?).placed(Frame::at(Vec3::new(0.0, 0.5, 0.0))?);
    /// let objects = [Object::new(Shape::new(Plane::new()), 0), Object::new(ball, 0)];
    /// let (materials, lights) = ([Material::default()], [Light::new(Vec3::new(2.0, 9.0, 4.0), 0.9)]);
    /// let scene = Scene::new(&objects, &materials, &lights, camera)?;
    /// let picture = Picture::new(&scene, Size::new(160, 120));
    ///
    /// let mut pixels = Vec::new();
    /// let all = picture.render(|_, _, pixel| pixels.push(pixel)).rays();
    /// let mut pixels = pixels.into_iter();
    /// let few = picture.in_spans().render(|_, _, pixel| {
    ///     assert_eq!(Some(pixel.seen), pixels.next().map(|one| one.seen));
    /// });
    /// assert!(few.rays() * 3 < all);
    /// # Ok::<(), raylet::Error>(())
    /// ```
    pub fn in_spans(&self) -> InSpans<'a, S, E, T, K> {
        let is_traced = self.tracer.uses(Effect::Refraction) || self.tracer.uses(Effect::Outline);
        let Size { width, height, .. } = self.size();
        let is_traced = is_traced || self.is_antialiased() || width == 0 || height == 0;
        let known = if is_traced { None } else { Known::of(self).map(|known| (known, Reciprocals::new())) };
        InSpans { picture: *self, known }
    }
}

impl<'a, S: Scalar, E: Effects, T: Tier<S>, K: Kinds> InSpans<'a, S, E, T, K> {
    /// The size of the picture.
    pub const fn size(&self) -> Size {
        self.picture.size()
    }

    /// The pixels of row `y` from the left, as [`Picture::row`]. Rows do not depend on each other.
    pub fn row<'w, O: Observer>(
        &'w self,
        y: u16,
        context: &'w mut TraceContext<O>,
    ) -> RowInSpans<'w, 'a, S, E, O, T, K> {
        self.row_of(&self.picture, [0, y], context)
    }

    /// The same of this picture with another cut-off.
    pub(crate) fn row_of<'w, O: Observer>(
        &'w self,
        picture: &'w Picture<'a, S, E, T, K>,
        [x, y]: [u16; 2],
        context: &'w mut TraceContext<O>,
    ) -> RowInSpans<'w, 'a, S, E, O, T, K> {
        let [_, down] = picture.raster.place([0, y], [0, 0]);
        let rays = picture.raster.row(down);
        let found = self.known.as_ref().map(|(known, reciprocals)| {
            context.forget();
            (known, reciprocals, Regions::find(known, picture, (y, &rays), context))
        });
        let row = if found.is_some() {
            Row { picture, context, next: x.into(), y, left: None, rays, candidates: None }
        } else {
            picture.row_from(x, y, context)
        };
        let span = Span { until: 0, fill: Fill::Traced(Candidates::NONE) };
        RowInSpans { row, found, span, may_shade: Candidates::ALL, ahead: heapless::Vec::new() }
    }

    /// Traces every pixel, as [`Picture::render`], and returns the counters of rays and tests.
    pub fn render(&self, mut each: impl FnMut(u16, u16, Pixel<S>)) -> Counters {
        let mut context = TraceContext::new(());
        for y in 0..self.size().height {
            for (x, pixel) in (0..=u16::MAX).zip(self.row(y, &mut context)) {
                each(x, y, pixel);
            }
        }
        context.counters
    }

    /// The picture, pixel by pixel.
    #[cfg(feature = "embedded-graphics")]
    pub(crate) const fn picture(&self) -> &Picture<'a, S, E, T, K> {
        &self.picture
    }
}

/// Iterator over the pixels of a row, by spans: see [`InSpans::row`].
#[derive(Debug)]
pub struct RowInSpans<'w, 'a, S: Scalar, E, O, T = Stable, K: Kinds = kinds::All> {
    row: Row<'w, 'a, S, E, O, T, K>,
    /// What is known of the objects, and where they are seen; `None` if each pixel is traced by itself.
    found: Option<(&'w Known, &'w Reciprocals<S>, Regions)>,
    span: Span<S>,
    /// The objects that may throw a shadow on what is seen in the span.
    may_shade: Candidates,
    /// Pixels of the span that were traced ahead of those before them, with their columns: the last is the nearest.
    /// (Columns have 32 bits here: behind 16, LLVM copies pixels by half words, which takes 80 instructions a pixel of
    /// a lit picture on a Cortex-M0+.)
    ahead: heapless::Vec<(u32, Pixel<S>), AHEAD>,
}

/// Pixels that follow each other.
#[derive(Clone, Copy, Debug)]
struct Span<S: Scalar> {
    /// The column after the last.
    until: u16,
    fill: Fill<S>,
}

/// How the pixels of a span are made.
#[derive(Clone, Copy, Debug)]
enum Fill<S: Scalar> {
    /// They are all the same.
    Same(Pixel<S>),
    /// Each is traced: they see one of these objects, or the background.
    Traced(Candidates),
    /// The same, but their light changes smoothly over so many columns at most, or over so many where a light does not
    /// reach them; from the last one traced to before a column they lie on a curve.
    Smooth(Candidates, [u16; 2], Option<(u32, Curve<S>)>),
}

impl<S: Scalar, E: Effects, O: Observer, T: Tier<S>, K: Kinds> Iterator for RowInSpans<'_, '_, S, E, O, T, K> {
    type Item = Pixel<S>;

    #[inline]
    fn next(&mut self) -> Option<Pixel<S>> {
        // Most pixels are of these two kinds.
        let x = self.row.next;
        let pixel = match &mut self.span.fill {
            Fill::Same(pixel) if x < u32::from(self.span.until) => *pixel,
            Fill::Smooth(_, _, Some((until, curve))) if x < *until => curve.next(),
            _ => return self.next_of_others(),
        };
        self.row.next += 1;
        Some(pixel)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.row.size_hint()
    }
}

impl<S, E, O, T, K> ExactSizeIterator for RowInSpans<'_, '_, S, E, O, T, K>
where
    S: Scalar,
    E: Effects,
    O: Observer,
    T: Tier<S>,
    K: Kinds,
{
}

impl<S: Scalar, E: Effects, O: Observer, T: Tier<S>, K: Kinds> core::iter::FusedIterator
    for RowInSpans<'_, '_, S, E, O, T, K>
{
}

impl<S: Scalar, E: Effects, O: Observer, T: Tier<S>, K: Kinds> RowInSpans<'_, '_, S, E, O, T, K> {
    /// The next pixel, which may be the first of a span.
    #[inline(never)]
    fn next_of_others(&mut self) -> Option<Pixel<S>> {
        if self.found.is_none() {
            return self.row.next();
        }
        let x = u16::try_from(self.row.next).ok().filter(|x| *x < self.row.picture.size().width)?;
        self.row.next += 1;
        if x >= self.span.until {
            self.span = self.span_from(x);
        }
        Some(match self.span.fill {
            Fill::Same(pixel) => pixel,
            Fill::Smooth(among, longest, _) => self.curved(x, among, longest),
            Fill::Traced(among) => self.traced(x, among),
        })
    }

    /// The pixel in a column, whose ray meets no other objects than these.
    #[inline(never)]
    fn traced(&mut self, x: u16, among: Candidates) -> Pixel<S> {
        let [right, _] = self.row.picture.raster.place([x, 0], [0, 0]);
        self.row.context.may_shade = self.may_shade;
        let pixel = self.row.picture.pixel_of_one(&self.row.rays, right, Some(among), self.row.context);
        self.row.context.may_shade = Candidates::ALL;
        pixel
    }

    /// The span that starts in a column.
    #[inline(never)]
    fn span_from(&mut self, x: u16) -> Span<S> {
        let Some((known, _, regions)) = &self.found else {
            return Span { until: x + 1, fill: Fill::Traced(Candidates::ALL) };
        };
        let known = *known;
        self.may_shade = Candidates::ALL;
        let seen = regions.from(x, self.row.picture.size().width, known.planes);
        let any = seen.objects.or(seen.doubtful).or(known.planes);
        let Some((on, until)) = self.seen_until(x, known, &seen) else {
            return Span { until: seen.until, fill: Fill::Traced(any) };
        };
        let tracer = &self.row.picture.tracer;
        // What else is at the same place matters for the rays from there.
        let among_alone = |sends_rays: bool| match on {
            Some((object, _)) if !sends_rays => Candidates::NONE.with(object),
            _ => any,
        };
        if tracer.course(on) == Course::Same {
            return Span { until, fill: Fill::Same(self.traced(x, among_alone(tracer.sends_rays()))) };
        }
        let (Some((object, part)), Some((_, _, regions))) = (on, &self.found) else {
            return Span { until, fill: Fill::Traced(any) };
        };
        let shade = regions.shade(known, object, [x, self.row.y], until);
        let reflects = tracer.uses(Effect::Reflection) && tracer.course(on) == Course::Any;
        if !reflects {
            self.may_shade = shade.thrown_by;
        }
        let among = among_alone(reflects || tracer.uses(Effect::Shadows) && !shade.thrown_by.are_none());
        let is_round = known.is_round(object);
        let (middle, until) = if is_round { regions.middle(object, x, shade.until) } else { (None, shade.until) };
        let longest = known.longest(self.row.picture, (object, part), middle);
        let is_smooth = shade.is_even && longest[0] >= curve::SHORTEST;
        let fill = if is_smooth { Fill::Smooth(among, longest, None) } else { Fill::Traced(among) };
        Span { until, fill }
    }

    /// The object and the part that all pixels from a column to before another see; `None` if that is not certain.
    fn seen_until(&mut self, x: u16, known: &Known, seen: &Seen) -> Option<(Option<(u32, Part)>, u16)> {
        if !seen.doubtful.are_none() {
            return None;
        }
        if seen.objects.are_none() {
            let only = known.planes.only();
            return Some(if known.planes.are_none() || only.is_some() {
                (only.filter(|_| seen.plane).map(|plane| (plane, Part::Side)), seen.until)
            } else {
                self.same_until(x, seen.until, known.planes)
            });
        }
        let object = if let Some(only) = seen.objects.only() {
            only
        } else {
            // What has no point in common with another is before it in all columns, or behind it in all.
            let (nearest, _) = self.part_seen(x, seen.objects)?;
            known.is_apart(nearest, seen.objects).then_some(nearest)?
        };
        Some(match known.outlined(object) {
            Outlined::Cap(part) if seen.caps.contain(object) => (Some((object, part)), seen.until),
            Outlined::Cap(_) | Outlined::Side => (Some((object, Part::Side)), seen.until),
            Outlined::Facets => self.same_until(x, seen.until, Candidates::NONE.with(object)),
            Outlined::Plane | Outlined::Parts | Outlined::Other => return None,
        })
    }

    /// What is seen of these objects in a column, and the column, up to `end`, from which on it is not, if all columns
    /// in which it is follow each other.
    fn same_until(&mut self, x: u16, end: u16, among: Candidates) -> (Option<(u32, Part)>, u16) {
        let on = self.part_seen(x, among);
        let (mut same, mut other) = (x, end);
        // The last one first: mostly it sees the same.
        let mut probe = end - 1;
        while probe > same {
            if self.part_seen(probe, among) == on {
                same = probe;
            } else {
                other = probe;
            }
            probe = same + (other - same) / 2;
        }
        (on, other)
    }

    fn part_seen(&mut self, x: u16, among: Candidates) -> Option<(u32, Part)> {
        let (_, on) = self.row.picture.first(&self.row.rays, x, among, self.row.context)?;
        Some((on.object, on.hit.part))
    }

    /// The pixel in a column of a smooth span, and a curve through those after it.
    #[inline(never)]
    fn curved(&mut self, x: u16, among: Candidates, longest: [u16; 2]) -> Pixel<S> {
        let pixel = match self.ahead.last() {
            Some(&(column, pixel)) if column == u32::from(x) => {
                self.ahead.truncate(self.ahead.len() - 1);
                pixel
            }
            _ => self.traced(x, among),
        };
        let most = longest[usize::from(!self.row.picture.tracer.is_lit_by_all(pixel.lit_by))];
        let left = self.span.until - 1 - x;
        if self.ahead.is_empty() && left >= curve::SHORTEST {
            // As many curves as there must be, of about the same length.
            self.trace_ahead(x + left.div_ceil(left.div_ceil(most.max(1)).max(1)), among);
        }
        let Some((_, reciprocals, _)) = self.found else { return pixel };
        let mut curve = None;
        while let Some(end) = self.ahead.last().map(|(end, _)| *end) {
            let columns = end as u16 - x;
            if columns < curve::SHORTEST {
                break;
            }
            self.trace_ahead(x + columns / 2, among);
            if columns <= most
                && let [.., (_, last), (_, middle)] = self.ahead.as_slice()
                && let Some(through) = Curve::through([&pixel, middle, last], columns, reciprocals)
            {
                self.ahead.truncate(self.ahead.len() - 1);
                curve = Some((end, through));
                break;
            }
        }
        self.span.fill = Fill::Smooth(among, longest, curve);
        pixel
    }

    /// Traces the pixel in a column to the right, and keeps it.
    fn trace_ahead(&mut self, x: u16, among: Candidates) {
        let pixel = self.traced(x, among);
        // There is room.
        let _ = self.ahead.push((x.into(), pixel));
    }
}
