//! Numbers and points of a type, near those given.

use raylet::{Scalar, Vec3};

/// The number of the type that is nearest.
pub fn n<S: Scalar>(x: f64) -> S {
    S::from_f64(x).expect("every tested type holds it")
}

/// The point of the type that is nearest.
pub fn point<S: Scalar>(p: [f64; 3]) -> Vec3<S> {
    Vec3::from_f64(p).expect("every tested type holds it")
}
