//! A scene to a picture in memory, on all processors, with a progress bar if it takes long.

use crate::arithmetic::Number;
use crate::diagnosis::{self, Pixels};
use crate::image::{self, Image};
use crate::load::{Remarks, Source};
use crate::options::Options;
use crate::progress::Progress;
use raylet::effect::EffectSet;
use raylet::scene::{Hierarchy, Node, Observer};
use raylet::tier::Tier;
use raylet::{Color, Counters, Outline, Part, Picture, Pixel, Scalar, Size, TraceContext};
use std::error::Error;
use std::num::NonZero;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;

/// A pixel's object and part (`None`: background), and the lights that reach it.
pub(crate) type Sighting = (Option<(u32, Part)>, u32);

/// Up to this many objects all are tested: boxes would cost as much as they save.
const FEW_OBJECTS: usize = 8;

/// Bytes a pixel of a picture that is written: its levels, and twice as many while a PNG is made of it.
const WRITTEN: usize = 9;

/// Bytes a pixel of a picture that is compared: its levels and what it sees, twice, and their difference.
const COMPARED: usize = WRITTEN + 2 * (3 + size_of::<Sighting>());

/// A picture, and what is known about it.
#[derive(Debug)]
pub(crate) struct Traced {
    pub(crate) image: Image,
    /// For each pixel, if pictures are compared.
    pub(crate) sightings: Vec<Sighting>,
    pub(crate) counters: Counters,
    /// Of loading and tracing together.
    pub(crate) seconds: f64,
    /// Of these, what loading took.
    pub(crate) loading: f64,
    pub(crate) remarks: Remarks,
    /// Why there is nothing to be seen.
    pub(crate) darkness: Option<String>,
    /// The effects that the scene and the size of the picture call for, and those that were used.
    pub(crate) called_for: EffectSet,
    pub(crate) used: EffectSet,
    /// For each object, if a report is wanted.
    pub(crate) objects: Vec<Tests>,
}

impl Traced {
    /// The seconds that tracing took.
    pub(crate) fn tracing(&self) -> f64 {
        self.seconds - self.loading
    }
}

/// How often an object was tested, and how often the ray met it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tests {
    pub(crate) tested: u64,
    pub(crate) met: u64,
}

/// Listens to the tests of each object; to none if its list is empty.
#[derive(Clone, Debug, Default)]
struct PerObject(Vec<Tests>);

impl Observer for PerObject {
    fn tested(&mut self, object: u32, found: bool) {
        if let Some(tests) = self.0.get_mut(object as usize) {
            tests.tested += 1;
            tests.met += u64::from(found);
        }
    }
}

/// Traces a scene in a tier with those of its effects that are in the set.
pub(crate) fn trace<S: Scalar, T: Tier<S> + Send + Sync>(
    source: &Source,
    options: &Options,
    number: Number,
    effects: EffectSet,
) -> Result<Traced, Box<dyn Error>> {
    let progress = Progress::new();
    let loaded = source.load::<S>(options, number, &progress)?;
    let mut nodes = vec![Node::EMPTY; Hierarchy::<S>::nodes_for(loaded.objects.len())];
    let mut scene = loaded.scene()?.at_tier::<T>();
    if let Some(level) = options.ambient {
        scene = scene.with_ambient(Color::from_f64([level; 3]));
    }
    if let Some(width) = options.outline {
        scene = scene.with_outline(Outline::new(Color::BLACK).with_width(width));
    }
    let hierarchy;
    if !options.no_hierarchy && loaded.objects.len() > FEW_OBJECTS {
        hierarchy = Hierarchy::build(&loaded.objects, &mut nodes)?;
        scene = scene.with_hierarchy(&hierarchy)?;
    }
    let [width, height] = options.size.map_or(loaded.resolution, |(width, height)| [width, height]);
    let size = Size::new(width, height).with_samples(options.samples);
    let called_for = Picture::new(&scene, size);
    let picture = called_for.only(effects);
    let picture = if options.uncut { picture.uncut() } else { picture };
    let picture = if options.linear { picture.in_linear_levels() } else { picture };
    let spans = options.spans.then(|| picture.in_spans());
    let listened_to = if options.report { scene.objects().len() } else { 0 };
    let compared = !options.compare.is_empty();

    image::must_fit(width, height, if compared { COMPARED } else { WRITTEN })?;
    let sightings = if compared { image::filled((None, 0), width, height)? } else { Vec::new() };
    let canvas = Mutex::new((Image::black(width, height, options.linear)?, sightings));
    let loading = progress.seconds();
    progress.begin(usize::from(height), "rows");
    let next_row = AtomicU32::new(0);
    let parts = on_threads(options.threads, height, || {
        let (mut row, mut pixels) = (Vec::new(), Pixels::default());
        let mut context = TraceContext::new(PerObject(vec![Tests::default(); listened_to]));
        while let Ok(y) = u16::try_from(next_row.fetch_add(1, Ordering::Relaxed))
            && y < height
        {
            row.clear();
            match &spans {
                Some(spans) => row.extend(spans.row(y, &mut context)),
                None => row.extend(picture.row(y, &mut context)),
            }
            let mut canvas = canvas.lock().unwrap_or_else(PoisonError::into_inner);
            let (image, sightings) = &mut *canvas;
            let from = usize::from(y) * usize::from(width);
            for (index, pixel) in (from..).zip(&row) {
                let levels = if options.linear { pixel.color.to_linear888() } else { pixel.color.to_srgb888() };
                image.pixels[index] = levels;
                if let Some(sighting) = sightings.get_mut(index) {
                    *sighting = (pixel.seen, pixel.lit_by);
                }
                pixels.add(counted(pixel, levels));
            }
            progress.step();
        }
        (pixels, context)
    })?;
    progress.end();

    let seconds = progress.seconds();
    let (image, sightings) = canvas.into_inner().unwrap_or_else(PoisonError::into_inner);
    let (mut counters, mut objects) = (Counters::default(), vec![Tests::default(); listened_to]);
    let mut pixels = Pixels::default();
    for (part, context) in parts {
        pixels.add(part);
        counters.add(&context.counters);
        for (sum, tests) in objects.iter_mut().zip(context.observer.0) {
            sum.tested += tests.tested;
            sum.met += tests.met;
        }
    }
    let (called_for, used) = (called_for.effects(), picture.effects());
    let darkness = diagnosis::darkness(&loaded, &scene, size, pixels, [called_for, used], number);
    let remarks = loaded.remarks;
    Ok(Traced { image, sightings, counters, seconds, loading, remarks, darkness, called_for, used, objects })
}

/// What kind of pixel it is.
fn counted<S: Scalar>(pixel: &Pixel<S>, levels: [u8; 3]) -> Pixels {
    if pixel.seen.is_none() {
        return Pixels::default();
    }
    Pixels { seen: 1, black: u64::from(levels == [0; 3]), lit: u64::from(pixel.lit_by != 0) }
}

/// Does the same work on as many threads as are wanted, or as there are processors, and at most on `most`; fails if one
/// of them panics.
fn on_threads<R: Send>(
    threads: Option<u16>,
    most: u16,
    context: impl Fn() -> R + Sync,
) -> Result<Vec<R>, Box<dyn Error>> {
    let processors = || thread::available_parallelism().map_or(1, NonZero::get);
    let threads = threads.map_or_else(processors, usize::from).min(usize::from(most));
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(&context)).collect();
        let results: Vec<_> = workers.into_iter().map(thread::ScopedJoinHandle::join).collect();
        results.into_iter().collect::<Result<_, _>>()
    })
    .map_err(|_| {
        "a thread panicked, so that there is no picture: please report this with the scene and the options".into()
    })
}

#[cfg(test)]
mod tests {
    use super::on_threads;
    use std::sync::atomic::{AtomicU32, Ordering};

    #[test]
    fn a_worker_that_panics_fails_the_program() {
        let worker = AtomicU32::new(0);
        let context = || match worker.fetch_add(1, Ordering::Relaxed) {
            1 => panic!("the second worker"),
            number => number,
        };
        let error = on_threads(Some(3), 9, context).unwrap_err();
        assert!(error.to_string().contains("a thread panicked"), "{error}");
        assert_eq!(on_threads(Some(4), 2, || 7).unwrap(), [7, 7]);
    }
}
