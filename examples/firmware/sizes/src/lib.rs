//! What one primitive takes of a chip's memory: each program here asks for the nearest hit of one primitive, in one number
//! type and tier, and does nothing else.
#![no_std]

pub use raylet_proofs as proofs;

/// A program that asks one primitive for its nearest hit.
#[macro_export]
macro_rules! nearest {
    ($Primitive:ident<$S:ident>, $T:ident) => {
        $crate::proofs::program! {
            let primitive = $crate::proofs::input::any_reference::<raylet::$Primitive<$S>>();
            let ray = $crate::proofs::input::any_reference::<raylet::Ray<$S>>();
            $crate::proofs::input::give(primitive.nearest_at::<raylet::tier::$T>(ray));
        }
    };
}
