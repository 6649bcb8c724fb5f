//! What one primitive, and one set of effects, takes of a chip's memory: each program here asks for the nearest hit of one primitive, in
//! one number type and tier, or for a pixel with one set of effects, and does nothing else.
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

/// A program that finds out what a scene calls for and traces a pixel of it with a set of effects compiled in.
#[macro_export]
macro_rules! pixel {
    ($S:ident, $Effects:ty) => {
        $crate::proofs::program! {
            let scene = $crate::proofs::input::any_reference::<raylet::Scene<'static, $S>>();
            let [width, height] = [$crate::proofs::input::any_word() as u16, $crate::proofs::input::any_word() as u16];
            let size = raylet::Size::new(width, height).with_samples($crate::proofs::input::any_word() as u8);
            let picture = raylet::Picture::<$S, $Effects>::leaving_out(scene, size);
            let [x, y] = [$crate::proofs::input::any_word() as u16, $crate::proofs::input::any_word() as u16];
            $crate::proofs::input::give(picture.pixel(x, y, &mut raylet::Work::new(())));
        }
    };
}
