//! The number types of the page and their tiers.

use crate::solid::Kinds;
use crate::world::World;
use core::cell::RefCell;
use fixed::types::I16F16;
use raylet::{Exact, Fast, Hits, Plain, Ray, Scalar, Shape, Stable, Tier};
use std::thread::LocalKey;

/// A number type with its world.
pub trait Number: Scalar {
    /// The best tier.
    type Best: Tier<Self>;

    /// The world in which it is used.
    fn world() -> &'static LocalKey<RefCell<World<Self>>>;

    /// All hits, in the tier of this number: `Plain`, `Fast`, `Stable`, `Exact`.
    // Not copied into each of its callers: code that is sent.
    #[inline(never)]
    fn hits(shape: &Shape<Self, Kinds>, ray: &Ray<Self>, tier: u32) -> Hits<Self> {
        match tier {
            0 => shape.hits_at::<Plain>(ray),
            1 => shape.hits_at::<Fast>(ray),
            2 => shape.hits_at::<Stable>(ray),
            _ => shape.hits_at::<Self::Best>(ray),
        }
    }
}

thread_local! {
    static IN_F32: RefCell<World<f32>> = RefCell::default();
    static IN_F64: RefCell<World<f64>> = RefCell::default();
    static IN_FIXED: RefCell<World<I16F16>> = RefCell::default();
}

impl Number for f32 {
    type Best = Exact;
    fn world() -> &'static LocalKey<RefCell<World<Self>>> {
        &IN_F32
    }
}

/// Has no `Exact`.
impl Number for f64 {
    type Best = Stable;
    fn world() -> &'static LocalKey<RefCell<World<Self>>> {
        &IN_F64
    }
}

impl Number for I16F16 {
    type Best = Exact;
    fn world() -> &'static LocalKey<RefCell<World<Self>>> {
        &IN_FIXED
    }
}
