//! What each effect and each object cost.

use crate::load::Source;
use crate::options::Options;
use crate::trace;
use crate::trace::Traced;
use raylet::Counters;
use raylet::effect::{Effect, EffectSet};
use std::error::Error;
use std::time::Instant;

/// How often a picture is timed with and without an effect, at most.
const MOST_ROUNDS: u32 = 9;
/// Seconds after which it is not timed once more.
const LONG_ENOUGH: f64 = 1.0;

/// How many objects are listed.
const OBJECTS: usize = 20;

/// For each effect in use: its work, and the share of the time that the picture takes less without it.
pub(crate) fn costs(options: &Options, source: &Source, traced: &Traced) -> Result<(), Box<dyn Error>> {
    println!("{:<14}{:>12}  {:<18}{:>14}", "effect", "count", "", "share of time");
    for effect in traced.used {
        let without = EffectSet::ALL.without(effect).intersection(options.effects);
        let (mut whole, mut less, start) = (f64::INFINITY, f64::INFINITY, Instant::now());
        // By turns, so that both meet the same machine, and the fastest of each, which the machine disturbed least.
        for round in 0.. {
            if round > 0 && (round == MOST_ROUNDS || start.elapsed().as_secs_f64() > LONG_ENOUGH) {
                break;
            }
            whole = whole.min(crate::trace(options, source, options.arithmetic(), options.effects)?.seconds);
            less = less.min(crate::trace(options, source, options.arithmetic(), without)?.seconds);
        }
        let share = 100.0 * (1.0 - less / whole.max(1e-9));
        let (count, what) = work(effect, &traced.counters);
        println!("{effect:<14}{count:>12}  {what:<18}{share:>12.0} %");
    }
    Ok(())
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
        // Diffuse, specular, and any other that shades a hit and casts no ray.
        _ => (counters.hits_refined, "hits refined"),
    }
}

/// The objects that were asked most: how often, and how often a ray met them.
pub(crate) fn objects(traced: &Traced) {
    let mut objects: Vec<(usize, trace::Tests)> = traced.objects.iter().copied().enumerate().collect();
    objects.sort_by_key(|(index, tests)| (std::cmp::Reverse(tests.met), *index));
    println!("{:<14}{:>12}{:>12}", "object", "tests", "hits");
    for (index, tests) in objects.iter().take(OBJECTS) {
        println!("{index:<14}{:>12}{:>12}", tests.asked, tests.met);
    }
    if let Some(others) = objects.len().checked_sub(OBJECTS).filter(|others| *others > 0) {
        println!("and {others} others with fewer hits");
    }
}
