//! A callback for each intersection test, for statistics beyond the counters.

/// A callback for each test of a ray against an object.
///
/// `()` ignores the calls, at no cost.
pub trait Observer {
    /// The object of this index was tested for a nearest hit or for occlusion; `found` is true if it was hit.
    #[inline(always)]
    fn tested(&mut self, object: u32, found: bool) {
        let _ = (object, found);
    }
}

impl Observer for () {}

impl<O: Observer + ?Sized> Observer for &mut O {
    #[inline(always)]
    fn tested(&mut self, object: u32, found: bool) {
        (**self).tested(object, found);
    }
}
