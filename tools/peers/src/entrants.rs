//! Who takes part: for each number type and primitive everyone that has it.

use crate::contestant::Entrant;
use crate::names::{EMBEDDED_3DGFX, EXACT, FAST, PLAIN, STABLE, TEXTBOOK};
use crate::number::Number;
use crate::sizes::Sizes;
use crate::{embedded_3dgfx_rays, raylet_tiers, textbook};
#[cfg(feature = "parry")]
use crate::{names::PARRY, parry};
use support::subject::Subject;

/// A number type, and who answers in it.
pub trait Field: Number {
    /// Everyone, in the order of the tables.
    const NAMES: &'static [&'static str];
    /// Those of them that have this primitive.
    fn entrants(subject: &Subject<Self>) -> Vec<Entrant<Self>>;
}

impl Field for f32 {
    const NAMES: &'static [&'static str] = &[
        PLAIN,
        FAST,
        STABLE,
        EXACT,
        #[cfg(feature = "parry")]
        PARRY,
        EMBEDDED_3DGFX,
        TEXTBOOK,
    ];

    fn entrants(subject: &Subject<f32>) -> Vec<Entrant<f32>> {
        let sizes = Sizes::of(subject);
        let mut all = Vec::from(raylet_tiers::entrants(subject));
        all.push(raylet_tiers::exact_entrant(subject));
        #[cfg(feature = "parry")]
        all.extend(parry::single::entrant(sizes, &subject.solid));
        all.extend(embedded_3dgfx_rays::entrant(sizes, &subject.solid));
        all.push(textbook::entrant(&subject.solid));
        all
    }
}

impl Field for f64 {
    const NAMES: &'static [&'static str] = &[
        PLAIN,
        FAST,
        STABLE,
        #[cfg(feature = "parry")]
        PARRY,
        TEXTBOOK,
    ];

    fn entrants(subject: &Subject<f64>) -> Vec<Entrant<f64>> {
        let sizes = Sizes::of(subject);
        let mut all = Vec::from(raylet_tiers::entrants(subject));
        #[cfg(feature = "parry")]
        all.extend(parry::double::entrant(sizes, &subject.solid));
        all.push(textbook::entrant(&subject.solid));
        all
    }
}
