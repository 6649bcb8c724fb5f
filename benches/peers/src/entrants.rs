//! Who takes part: for each number type and primitive everyone that has it.

use crate::contestant::{Entrant, Number};
use crate::sizes::Sizes;
use crate::support::subject::Subject;
use crate::{embedded_3dgfx_rays, parry, raylet_tiers, textbook};

/// A number type, and who answers in it.
pub trait Field: Number {
    /// Everyone, in the order of the tables.
    const NAMES: &'static [&'static str];
    /// Those of them that have this primitive.
    fn entrants(subject: &Subject<Self>) -> Vec<Entrant<Self>>;
}

impl Field for f32 {
    const NAMES: &'static [&'static str] = &[
        raylet_tiers::FAST,
        raylet_tiers::STABLE,
        raylet_tiers::EXACT,
        parry::NAME,
        embedded_3dgfx_rays::NAME,
        textbook::NAME,
    ];

    fn entrants(subject: &Subject<f32>) -> Vec<Entrant<f32>> {
        let sizes = Sizes::of(subject);
        let mut all = Vec::from(raylet_tiers::entrants(subject));
        all.push(raylet_tiers::exact_entrant(subject));
        all.extend(parry::single::entrant(sizes, &subject.solid));
        all.extend(embedded_3dgfx_rays::entrant(sizes, &subject.solid));
        all.push(textbook::entrant(sizes, &subject.solid));
        all
    }
}

impl Field for f64 {
    const NAMES: &'static [&'static str] = &[raylet_tiers::FAST, raylet_tiers::STABLE, parry::NAME, textbook::NAME];

    fn entrants(subject: &Subject<f64>) -> Vec<Entrant<f64>> {
        let sizes = Sizes::of(subject);
        let mut all = Vec::from(raylet_tiers::entrants(subject));
        all.extend(parry::double::entrant(sizes, &subject.solid));
        all.push(textbook::entrant(sizes, &subject.solid));
        all
    }
}
