//! Trace context: counters, observer and shadow cache.

use crate::scene::{Candidates, Counters, Observer};

/// The number of lights in the shadow cache.
const REMEMBERED: usize = 8;
/// Stands for no object: a scene has fewer objects than this.
const NOBODY: u32 = u32::MAX;

/// Trace context: the counters, a shadow cache and an observer.
///
/// The shadow cache holds, for each of the first 8 lights, the object that occluded it from the last shading point, if
/// any. That object is tested first, since neighbouring points are often in the shadow of the same object. The cache
/// never changes a result, only the number of tests. It is cleared at the start of every row, so that the cost of a row
/// does not depend on the rows before it.
#[derive(Clone, Debug)]
pub struct TraceContext<O = ()> {
    /// Counters of rays and tests.
    pub counters: Counters,
    /// Called after every intersection test.
    pub observer: O,
    occluders: [u32; REMEMBERED],
    /// The objects that may throw a shadow on what is traced.
    pub(crate) may_shade: Candidates,
}

impl<O: Observer> TraceContext<O> {
    /// A context with all counters at zero and an empty cache.
    pub fn new(observer: O) -> Self {
        let occluders = [NOBODY; REMEMBERED];
        Self { counters: Counters::default(), observer, occluders, may_shade: Candidates::ALL }
    }

    /// Clears the shadow cache, as at the start of a row.
    pub fn forget(&mut self) {
        self.occluders = [NOBODY; REMEMBERED];
    }

    /// The object that occluded this light from the last point.
    pub(super) fn last_occluder(&self, light: u32) -> Option<u32> {
        self.occluders.get(light as usize).copied().filter(|object| *object != NOBODY)
    }

    /// Stores the object that occludes this light from a point, or that none does.
    pub(super) fn remember_occluder(&mut self, light: u32, object: Option<u32>) {
        if let Some(last) = self.occluders.get_mut(light as usize) {
            *last = object.unwrap_or(NOBODY);
        }
    }
}

impl<O: Observer + Default> Default for TraceContext<O> {
    fn default() -> Self {
        Self::new(O::default())
    }
}

#[cfg(units)]
#[path = "../../tests/units/effect/trace_context.rs"]
mod tests;
