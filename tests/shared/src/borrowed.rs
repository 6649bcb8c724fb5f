//! What a prism and a polyhedron borrow: constants of each number type.

use fixed::types::{I8F24, I16F16, I20F12, I32F32};
use raylet::{HalfSpace, Polyhedron, Prism, Scalar, Vec3, constant};

/// A number type with lists for a prism and a polyhedron.
pub trait Borrowed: Scalar {
    /// Five corners, of which no two edges are parallel.
    const PENTAGON: &'static [[Self; 2]];
    /// Two half-spaces that cut a box.
    const CUTS: &'static [HalfSpace<Self>];
    /// The corners of that box.
    const BOX: [Vec3<Self>; 2];
}

/// The prism over the pentagon.
pub fn prism<S: Borrowed>(height: S) -> Option<Prism<S>> {
    Prism::new(S::PENTAGON, height).ok()
}

/// The box that is cut.
pub fn polyhedron<S: Borrowed>() -> Option<Polyhedron<S>> {
    let [low, high] = S::BOX;
    Polyhedron::within(low, high, S::CUTS).ok()
}

/// Of numbers in eighths, by a function that makes them.
macro_rules! borrowed {
    ($($S:ty, $n:ident, |$eighths:ident| $number:expr;)+) => {
        $(
            const fn $n($eighths: i32) -> $S {
                $number
            }

            impl Borrowed for $S {
                const PENTAGON: &'static [[Self; 2]] =
                    &[[$n(8), $n(2)], [$n(5), $n(-6)], [$n(-4), $n(-7)], [$n(-8), $n(2)], [$n(1), $n(8)]];
                const CUTS: &'static [HalfSpace<Self>] = &[
                    constant!(HalfSpace::<Self>::const_new(
                        Vec3::new($n(4), $n(5), $n(2)),
                        Vec3::new($n(5), $n(6), $n(2)),
                    )),
                    constant!(HalfSpace::<Self>::const_new(
                        Vec3::new($n(-4), $n(1), $n(5)),
                        Vec3::new($n(-6), $n(2), $n(4)),
                    )),
                ];
                const BOX: [Vec3<Self>; 2] =
                    [Vec3::new($n(-7), $n(-5), $n(-6)), Vec3::new($n(7), $n(6), $n(7))];
            }
        )+
    };
}
borrowed!(
    f32, single, |eighths| eighths as f32 / 8.0;
    f64, double, |eighths| eighths as f64 / 8.0;
    I8F24, i8f24, |eighths| I8F24::from_bits(eighths << 21);
    I16F16, i16f16, |eighths| I16F16::from_bits(eighths << 13);
    I20F12, i20f12, |eighths| I20F12::from_bits(eighths << 9);
    I32F32, i32f32, |eighths| I32F32::from_bits((eighths as i64) << 29);
);
