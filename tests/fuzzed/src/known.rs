//! Where the default tier promises less than elsewhere: squares that vanish.

use crate::bytes::Number;
use crate::query::Query;
use raylet::Placement;

/// A float direction nearly along the axis, whose other components have squares that vanish, runs along the axis for
/// the side and not for what is beside it: a cylinder is hit that lies a radius and more away.
pub fn has_a_vanishing_slope<S: Number>(query: &Query<S>) -> bool {
    let Some(exponent) = S::VANISHING else { return false };
    let world = matches!(query.shape.placement(), Placement::World);
    // Turned into the solid's frame, a component is a product of two.
    let least = 2.0_f64.powi(if world { exponent } else { exponent / 2 });
    let mut components = query.ray.direction().to_f64().to_vec();
    if let Placement::Frame(frame) = query.shape.placement() {
        components.extend([frame.left(), frame.up(), frame.forward()].iter().flat_map(|axis| axis.to_f64()));
    }
    components.iter().any(|c| *c != 0.0 && c.abs() < least) || query.axes.0 / query.axes.1 < least
}
