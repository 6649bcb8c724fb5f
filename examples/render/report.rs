//! What a picture took, as text: in all, and for each effect and each object.

use crate::arithmetic::Arithmetic;
use crate::load::Source;
use crate::options::Options;
use crate::trace::{self, Traced};
use crate::{console, diagnosis};
use raylet::Counters;
use raylet::effect::{Effect, EffectSet};
use raylet::scene::nff::Scale;
use std::error::Error;
use std::fmt::Write;
use std::time::Instant;

/// How often a picture is timed with and without an effect, at most.
const MOST_ROUNDS: u32 = 9;
/// Seconds after which it is not timed once more.
const LONG_ENOUGH: f64 = 1.0;

/// How many objects are listed.
const OBJECTS: usize = 20;

/// Says what is odd about the picture or the file that it is made of.
pub(crate) fn warnings(traced: &Traced, arithmetic: Arithmetic) {
    for warning in diagnosis::remarks(traced.remarks, arithmetic.number).iter().chain(&traced.darkness) {
        console::warn(warning);
    }
}

/// What was traced, and how long it took.
pub(crate) fn picture(traced: &Traced, arithmetic: Arithmetic) -> String {
    let Traced { image, counters, remarks, .. } = traced;
    let outline = match counters.outline_rays {
        0 => String::new(),
        rays => format!(", {rays} outline"),
    };
    let mut text = format!(
        "{}x{} pixels in {arithmetic}: {} rays ({} primary, {} shadow, {} reflection, {} refraction{}), \
         {} intersection tests, {} box tests\ncalled for: {}\n",
        image.width,
        image.height,
        counters.rays(),
        counters.primary_rays,
        counters.shadow_rays,
        counters.reflection_rays,
        counters.refraction_rays,
        outline,
        counters.intersection_tests,
        counters.box_tests,
        traced.called_for,
    );
    let left_off = traced.called_for.difference(traced.used);
    if !left_off.is_empty() {
        let _ = writeln!(text, "left off: {left_off}");
    }
    if remarks.scale != Scale::ONE {
        let _ = writeln!(text, "scale: one unit of the file is {} in the scene", remarks.scale);
    }
    let rate = counters.rays() as f64 / traced.tracing().max(1e-9) / 1e6;
    let _ = writeln!(
        text,
        "time: {:.3} s, {:.3} s of them loading; {rate:.2} million rays/s",
        traced.seconds, traced.loading
    );
    if remarks.invisible > 0 {
        let objects = diagnosis::several(remarks.invisible, "object", "objects");
        let _ = writeln!(text, "left out: {objects} too small for {}, or without area", arithmetic.number);
    }
    text
}

/// For each effect in use: its work, and the share of the time that the picture takes less without it.
pub(crate) fn costs(options: &Options, source: &Source, traced: &Traced) -> Result<String, Box<dyn Error>> {
    let mut text = format!("{:<14}{:>12}  {:<18}{:>14}\n", "effect", "count", "", "share of time");
    for effect in traced.used {
        let without = EffectSet::ALL.without(effect).intersection(options.effects);
        let (mut whole, mut less, start) = (f64::INFINITY, f64::INFINITY, Instant::now());
        // By turns, so that both meet the same machine, and the fastest of each, which the machine disturbed least.
        for round in 0.. {
            if round > 0 && (round == MOST_ROUNDS || start.elapsed().as_secs_f64() > LONG_ENOUGH) {
                break;
            }
            whole = whole.min(crate::trace(options, source, options.arithmetic(), options.effects)?.tracing());
            less = less.min(crate::trace(options, source, options.arithmetic(), without)?.tracing());
        }
        let share = 100.0 * (1.0 - less / whole.max(1e-9));
        let (count, what) = work(effect, &traced.counters);
        let _ = writeln!(text, "{effect:<14}{count:>12}  {what:<18}{share:>12.0} %");
    }
    Ok(text)
}

/// What an effect counts.
fn work(effect: Effect, counters: &Counters) -> (u64, &'static str) {
    match effect {
        Effect::Shadows => (counters.shadow_rays, "rays"),
        Effect::Reflection => (counters.reflection_rays, "rays"),
        Effect::Refraction => (counters.refraction_rays, "rays"),
        Effect::Texture => (counters.texture_lookups, "lookups"),
        Effect::Bump => (counters.bumps, "normals"),
        Effect::Fog => (counters.fogged_rays, "rays"),
        Effect::Antialiasing => (counters.refined_pixels, "pixels refined"),
        Effect::Outline => (counters.outline_rays, "rays"),
        // Diffuse, specular, and any other that shades a hit and casts no ray.
        _ => (counters.hits_refined, "hits refined"),
    }
}

/// The objects that were tested most: how often, and how often a ray met them.
pub(crate) fn objects(traced: &Traced) -> String {
    let mut objects: Vec<(usize, trace::Tests)> = traced.objects.iter().copied().enumerate().collect();
    objects.sort_by_key(|(index, tests)| (std::cmp::Reverse(tests.met), *index));
    let mut text = format!("{:<14}{:>12}{:>12}\n", "object", "tests", "hits");
    for (index, tests) in objects.iter().take(OBJECTS) {
        let _ = writeln!(text, "{index:<14}{:>12}{:>12}", tests.tested, tests.met);
    }
    if let Some(others) = objects.len().checked_sub(OBJECTS).filter(|others| *others > 0) {
        let _ = writeln!(text, "and {others} others with fewer hits");
    }
    text
}
