//! Where the default tier promises less than elsewhere: squares that vanish, and 64-bit cones at the end of their type.
//! (The second is kept as an ignored test in `tests/fuzz_corpus.rs`.)

use super::bytes::Number;
use super::question::Question;
use raylet::{Placement, Primitive};

/// A float direction nearly along the axis, whose other components have squares that vanish, runs along the axis for the
/// side and not for what is beside it: a cylinder is hit that lies a radius and more away.
pub fn has_a_vanishing_slope<S: Number>(question: &Question<S>) -> bool {
    let Some(exponent) = S::VANISHING else { return false };
    let world = matches!(question.shape.placement(), Placement::World);
    // Turned into the solid's frame, a component is a product of two.
    let least = 2.0_f64.powi(if world { exponent } else { exponent / 2 });
    let mut components = question.ray.direction().to_f64().to_vec();
    if let Placement::Frame(frame) = question.shape.placement() {
        components.extend([frame.right(), frame.up(), frame.forward()].iter().flat_map(|axis| axis.to_f64()));
    }
    components.iter().any(|c| *c != 0.0 && c.abs() < least) || question.axes.0 / question.axes.1 < least
}

/// A 64-bit fixed cone of 44 bits and more: nearly along a generator its coefficients cancel to fewer bits than `t` has.
pub fn is_a_wide_cone<S: Number>(question: &Question<S>) -> bool {
    let cone = matches!(question.shape.primitive(), Primitive::Cone(_));
    let largest = question.ray.origin().to_f64().iter().fold(question.extent.1.to_f64(), |most, c| most.max(c.abs()));
    let units = largest / S::BUDGET.smallest_size.to_f64();
    S::VANISHING.is_none() && S::PRECISION > 60 && cone && units >= 2.0_f64.powi(44)
}
