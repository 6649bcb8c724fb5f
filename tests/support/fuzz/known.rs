//! What was found and is not mended yet: left out here, so that the search goes on, and kept as a test in
//! `tests/fuzz_corpus.rs`. Each goes when its fault does.

use super::agreement::Agreement;
use super::bytes::Number;
use super::question::Question;
use raylet::scalar::UnitScalar;
use raylet::{Crossing, Departure, Hits, Leaving, Part, Placement, Primitive, Ray};

/// `UnitVec3::from_components` adds up the squares of fixed components before it knows that they are short enough.
pub fn overflows<U: UnitScalar>(components: [U; 3]) -> bool {
    components.iter().any(|c| c.to_f64().abs() >= 1.5)
}

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

/// A ray that departs inwards has no far end: on a cylinder, where rounding puts a cap's point beside the side; on a pointed
/// cone, where the ray leads out of it in parallel to a generator.
pub fn has_no_far_end<S: Number>(question: &Question<S>, ray: &Ray<S>, again: &Hits<S>) -> bool {
    let Some(Departure { part, leaving: Leaving::Inwards, .. }) = ray.departure() else { return false };
    let met = match question.shape.primitive() {
        Primitive::Cylinder(_) => part == Part::Side || again.starts_inside(),
        Primitive::Cone(_) => part != Part::Side || !again.starts_inside(),
        _ => true,
    };
    again.is_empty() && !met
}

/// A float triangle that is so small beside its distance that its corners round to one point: a ray that passes by is said to
/// lie in it.
pub fn is_a_collapsed_triangle<S: Number>(question: &Question<S>, hits: &Hits<S>) -> bool {
    let triangle = matches!(question.shape.primitive(), Primitive::Triangle(_));
    let largest = question.ray.origin().to_f64().iter().fold(question.extent.1.to_f64(), |most, c| most.max(c.abs()));
    let rounding = largest * 2.0_f64.powi(4 - S::PRECISION as i32);
    S::VANISHING.is_some() && triangle && hits.coincident().is_some() && question.extent.0.to_f64() <= rounding
}

/// At the end of the float range a point relative to the solid is an infinity less another.
pub fn ends_at_infinity<S: Number>(farthest: f64) -> bool {
    S::VANISHING.is_some() && (farthest.is_nan() || farthest > S::BUDGET.distance.to_f64() * 0.25)
}

/// A 64-bit fixed cone of 44 bits and more: nearly along a generator its coefficients cancel to fewer bits than `t` has.
pub fn is_a_wide_cone<S: Number>(question: &Question<S>) -> bool {
    let cone = matches!(question.shape.primitive(), Primitive::Cone(_));
    let largest = question.ray.origin().to_f64().iter().fold(question.extent.1.to_f64(), |most, c| most.max(c.abs()));
    let units = largest / S::BUDGET.smallest_size.to_f64();
    S::VANISHING.is_none() && S::PRECISION > 60 && cone && units >= 2.0_f64.powi(44)
}

/// A cone as flat as a plate: its points are moved onto its side away from the axis and not along it, which is far.
pub fn is_a_flat_cone<S: Number>(question: &Question<S>) -> bool {
    let cone = matches!(question.shape.primitive(), Primitive::Cone(_));
    S::VANISHING.is_none() && cone && question.extent.1.to_f64() > question.extent.0.to_f64() * 1024.0
}

/// The fast tier: a pointed cone has one end where a ray is parallel to a generator by rounding alone; whether a far float
/// sphere is hit depends on which question is asked.
pub fn is_too_fast<S: Number>(question: &Question<S>) -> bool {
    let loose = match question.shape.primitive() {
        Primitive::Cone(_) => true,
        Primitive::Sphere(_) => {
            let far = question.away(&question.ray) / question.axes.0;
            S::VANISHING.is_some() && far > question.extent.1.to_f64() * 2.0_f64.powi(S::PRECISION as i32 - 4)
        }
        _ => false,
    };
    loose && question.promises(Agreement::Lawful)
}

/// A departing ray whose origin the type cannot hold relative to the solid is moved, and departs from where it is moved to.
pub fn departs_elsewhere<S: Number>(question: &Question<S>, ray: &Ray<S>) -> bool {
    !matches!(question.shape.placement(), Placement::World) && question.may_leave_the_type(ray)
}

/// A float capsule that is touched in two ends: a range that starts between them starts inside of it.
pub fn is_a_long_touch<S: Number>(question: &Question<S>, whole: &Hits<S>) -> bool {
    let capsule = matches!(question.shape.primitive(), Primitive::Capsule(_));
    S::VANISHING.is_some() && capsule && whole.iter().any(|hit| hit.crossing == Crossing::Touch)
}
