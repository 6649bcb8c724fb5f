//! What is carried along while pixels are traced.

use crate::scene::{Counters, Observer};

/// How many lights have a memory.
const REMEMBERED: usize = 8;
/// No object has this index: a scene has fewer.
const NOBODY: u32 = u32::MAX;

/// The counters of the work, a small memory that saves some of it, and whoever listens.
///
/// Neighbouring points mostly lie in the shadow of the same thing: the memory holds, for each of the first 8 lights,
/// the object that shaded the last point, if one did, to be asked first. It never changes what is seen, only what it costs; it is
/// forgotten at the start of every row, so that the cost of a row is the same whoever traces it.
#[derive(Clone, Debug)]
pub struct Work<O = ()> {
    /// What was done.
    pub counters: Counters,
    /// Is told of every intersection test.
    pub observer: O,
    occluders: [u32; REMEMBERED],
}

impl<O: Observer> Work<O> {
    /// Nothing done yet.
    pub fn new(observer: O) -> Self {
        Self { counters: Counters::default(), observer, occluders: [NOBODY; REMEMBERED] }
    }

    /// Forgets which objects cast the last shadows, as at the start of a row.
    pub fn forget(&mut self) {
        self.occluders = [NOBODY; REMEMBERED];
    }

    /// The object that shaded the last point from this light.
    pub(super) fn last_occluder(&self, light: u32) -> Option<u32> {
        self.occluders.get(light as usize).copied().filter(|object| *object != NOBODY)
    }

    /// Notes the object that shades a point from this light, or that none does.
    pub(super) fn remember_occluder(&mut self, light: u32, object: Option<u32>) {
        if let Some(last) = self.occluders.get_mut(light as usize) {
            *last = object.unwrap_or(NOBODY);
        }
    }
}

impl<O: Observer + Default> Default for Work<O> {
    fn default() -> Self {
        Self::new(O::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One memory for all lights would be right as well, and cost a test more at most points.
    #[test]
    fn each_light_has_a_memory_of_its_own() {
        let mut work = Work::new(());
        (0..10).for_each(|light| work.remember_occluder(light, Some(light + 100)));
        (0..10).for_each(|light| assert_eq!(work.last_occluder(light), (light < 8).then_some(light + 100)));
        work.remember_occluder(3, None);
        assert_eq!([2, 3].map(|light| work.last_occluder(light)), [Some(102), None]);
        work.forget();
        assert_eq!(work.last_occluder(2), None);
    }
}
