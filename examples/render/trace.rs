//! A scene to a picture in memory, on all processors, with a progress bar if it takes long.

use crate::image::Image;
use crate::load::{Loaded, Source};
use crate::options::Options;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use raylet::effect::EffectSet;
use raylet::scene::nff::Scale;
use raylet::scene::{Hierarchy, Node, Observer};
use raylet::tier::Tier;
use raylet::{Counters, Part, Picture, Pixel, Scalar, Size, Work};
use std::error::Error;
use std::num::NonZero;
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::Instant;

/// A pixel's object and part (`None`: background), and the lights that reach it.
pub(crate) type Sighting = (Option<(u32, Part)>, u32);

/// Up to this many objects all are tested: boxes would cost as much as they save.
const FEW_OBJECTS: usize = 8;

/// A row of pixels and its number: threads finish in any order.
type Row<S> = (u16, Vec<Pixel<S>>);

/// A picture, and what is known about it.
#[derive(Debug)]
pub(crate) struct Traced {
    pub(crate) image: Image,
    pub(crate) sightings: Vec<Sighting>,
    pub(crate) counters: Counters,
    pub(crate) seconds: f64,
    pub(crate) invisible: u32,
    pub(crate) scale: Scale,
    /// The effects that the scene and the size of the picture call for, and those that were used.
    pub(crate) called_for: EffectSet,
    pub(crate) used: EffectSet,
    /// For each object, if a report is wanted.
    pub(crate) objects: Vec<Tests>,
}

/// How often an object was asked, and how often the ray met it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tests {
    pub(crate) asked: u64,
    pub(crate) met: u64,
}

/// Listens to the tests of each object; to none if its list is empty.
#[derive(Clone, Debug, Default)]
struct PerObject(Vec<Tests>);

impl Observer for PerObject {
    fn tested(&mut self, object: u32, found: bool) {
        if let Some(tests) = self.0.get_mut(object as usize) {
            tests.asked += 1;
            tests.met += u64::from(found);
        }
    }
}

/// Traces a scene in a tier with those of its effects that are in the set.
pub(crate) fn trace<S: Scalar, T: Tier<S> + Send + Sync>(
    source: &Source,
    options: &Options,
    effects: EffectSet,
) -> Result<Traced, Box<dyn Error>> {
    let loaded = source.load::<S>(options.scale)?;
    let mut nodes = vec![Node::EMPTY; Hierarchy::<S>::nodes_for(loaded.objects.len())];
    let mut scene = loaded.scene()?.at_tier::<T>();
    let hierarchy;
    if !options.no_hierarchy && loaded.objects.len() > FEW_OBJECTS {
        hierarchy = Hierarchy::build(&loaded.objects, &mut nodes)?;
        scene = scene.with_hierarchy(&hierarchy)?;
    }
    let [width, height] = options.size.map_or(loaded.resolution, |(width, height)| [width, height]);
    let called_for = Picture::new(&scene, Size::new(width, height).with_samples(options.samples));
    let picture = called_for.only(effects);
    let picture = if options.uncut { picture.uncut() } else { picture };
    let listened_to = if options.report { scene.objects().len() } else { 0 };

    let bar = ProgressBar::with_draw_target(Some(u64::from(height)), ProgressDrawTarget::hidden())
        .with_style(ProgressStyle::with_template("{bar:40} {pos}/{len} rows, {eta} left")?);
    let start = Instant::now();
    let next_row = AtomicU32::new(0);
    let threads = options
        .threads
        .map_or_else(|| thread::available_parallelism().map_or(1, NonZero::get), usize::from)
        .min(usize::from(height));
    let parts: Vec<(Vec<Row<S>>, Work<PerObject>)> = thread::scope(|scope| {
        let work = || {
            let (mut rows, mut work) = (Vec::new(), Work::new(PerObject(vec![Tests::default(); listened_to])));
            while let Ok(y) = u16::try_from(next_row.fetch_add(1, Ordering::Relaxed))
                && y < height
            {
                rows.push((y, picture.row(y, &mut work).collect()));
                // A bar that flashes up and is gone helps nobody.
                if bar.is_hidden() && start.elapsed().as_secs_f64() > 1.0 {
                    bar.set_draw_target(ProgressDrawTarget::stderr());
                }
                bar.inc(1);
            }
            (rows, work)
        };
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().map(|worker| worker.join().unwrap_or_default()).collect()
    });
    bar.finish_and_clear();

    let seconds = start.elapsed().as_secs_f64();
    let mut image = Image::black(width, height);
    let mut sightings = vec![(None, 0); image.pixels.len()];
    let (mut counters, mut objects) = (Counters::default(), vec![Tests::default(); listened_to]);
    for (rows, part) in parts {
        counters.add(&part.counters);
        for (sum, tests) in objects.iter_mut().zip(part.observer.0) {
            sum.asked += tests.asked;
            sum.met += tests.met;
        }
        for (y, row) in rows {
            let start = usize::from(y) * usize::from(width);
            for (index, pixel) in (start..).zip(row) {
                image.pixels[index] = pixel.color.to_rgb888();
                sightings[index] = (pixel.seen, pixel.lit_by);
            }
        }
    }
    let (called_for, used) = (called_for.effects(), picture.effects());
    let Loaded { invisible, scale, .. } = loaded;
    Ok(Traced { image, sightings, counters, seconds, invisible, scale, called_for, used, objects })
}
