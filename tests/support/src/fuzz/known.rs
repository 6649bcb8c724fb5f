//! Where the default tier promises less than elsewhere: squares that vanish.

use super::bytes::Number;
use super::question::Question;
use raylet::Placement;

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
