//! Whoever wants to know more than the counters say.

/// Is told of every question that a scene puts to one of its objects.
///
/// `()` listens to nothing, and costs nothing.
pub trait Observer {
    /// The object of this index was asked for a hit, or whether it occludes; `found` is its answer.
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
