//! What one primitive, and one set of effects, takes of a chip's memory: each program finds the nearest hit of one
//! primitive, in one number type and tier, or traces a pixel with one set of effects, or calls the queries of shapes of
//! chosen kinds, and does nothing else.
//!
//! The programs are not stored: `check programs` writes them to `src/bin`, one for each row of the tables that
//! `check size` and `check left-out` read.
#![no_std]

#[doc(hidden)]
pub use {raylet, raylet_proofs};

/// A program that does nothing: what the others have in common with it is taken off their size.
#[macro_export]
macro_rules! empty {
    () => {
        $crate::raylet_proofs::program! {
            $crate::raylet_proofs::input::give($crate::raylet_proofs::input::any_word());
        }
    };
}

/// A program that finds the nearest hit of one primitive.
#[macro_export]
macro_rules! nearest {
    ($Primitive:ident<$S:ty>, $Tier:ident) => {
        $crate::raylet_proofs::program! {
            use $crate::raylet::tier::$Tier;
            use $crate::raylet::{$Primitive, Ray};
            use $crate::raylet_proofs::input::{any_reference, give};

            let primitive = any_reference::<$Primitive<$S>>();
            let ray = any_reference::<Ray<$S>>();
            give(primitive.nearest_at::<$Tier>(ray));
        }
    };
}

/// A program that finds out what a scene calls for and traces a pixel of it with a set of effects compiled in.
#[macro_export]
macro_rules! pixel {
    ($S:ty, $Effects:ty) => {
        $crate::raylet_proofs::program! {
            use $crate::raylet::{Picture, Scene, Size, TraceContext};
            use $crate::raylet_proofs::input::{any_reference, any_word, give};

            let scene = any_reference::<Scene<'static, $S>>();
            let [width, height] = [any_word() as u16, any_word() as u16];
            let size = Size::new(width, height).with_samples(any_word() as u8);
            let picture = Picture::<$S, $Effects>::leaving_out(scene, size);
            let [x, y] = [any_word() as u16, any_word() as u16];
            give(picture.pixel(x, y, &mut TraceContext::new(())));
        }
    };
}

/// A program that finds the nearest hit of a shape of chosen kinds.
#[macro_export]
macro_rules! range {
    ($S:ty, $Kinds:ty) => {
        $crate::raylet_proofs::program! {
            use $crate::raylet::{Ray, Shape};
            use $crate::raylet_proofs::input::{any_reference, give};

            let shape = any_reference::<Shape<$S, $Kinds>>();
            let ray = any_reference::<Ray<$S>>();
            give(shape.nearest(ray));
        }
    };
}

/// A program that traces a pixel of a scene of chosen kinds with a set of effects compiled in.
#[macro_export]
macro_rules! picture {
    ($S:ty, $Kinds:ty, $Effects:ty) => {
        $crate::raylet_proofs::program! {
            use $crate::raylet::{Picture, Scene, Size, Stable, TraceContext};
            use $crate::raylet_proofs::input::{any_reference, any_word, give};

            let scene = any_reference::<Scene<'static, $S, Stable, $Kinds>>();
            let [width, height] = [any_word() as u16, any_word() as u16];
            let size = Size::new(width, height).with_samples(any_word() as u8);
            let picture = Picture::<$S, $Effects, Stable, $Kinds>::leaving_out(scene, size);
            let [x, y] = [any_word() as u16, any_word() as u16];
            give(picture.pixel(x, y, &mut TraceContext::new(())));
        }
    };
}

/// A program that calls every query of a shape of chosen kinds, in every tier.
#[macro_export]
macro_rules! asked {
    ($S:ty, $Kinds:ty) => {
        $crate::raylet_proofs::program! {
            use $crate::raylet::{Exact, Fast, Plain, Ray, Shape, Stable, Tier};
            use $crate::raylet_proofs::input::{any_point, any_reference, give};

            fn call<T: Tier<$S>>(shape: &Shape<$S, $Kinds>, ray: &Ray<$S>) {
                give((shape.nearest_at::<T>(ray), shape.occludes_at::<T>(ray), shape.contains_at::<T>(any_point())));
                for hit in &shape.hits_at::<T>(ray) {
                    let surface = shape.surface(ray, hit);
                    give((surface.point(), surface.normal_towards_ray(), surface.uv(), surface.tangents()));
                }
            }
            let shape = any_reference::<Shape<$S, $Kinds>>();
            let ray = any_reference::<Ray<$S>>();
            call::<Plain>(shape, ray);
            call::<Fast>(shape, ray);
            call::<Stable>(shape, ray);
            call::<Exact>(shape, ray);
            give((shape.precision(ray), shape.bounds()));
        }
    };
}
