//! Outlines, where neighbouring rays see different things: Saito and Takahashi, *Comprehensible Rendering of 3-D
//! Shapes* (1990).

use crate::hit::Crossing;
use crate::ray::Ray;
use crate::scalar::{Ring, Scalar};
use crate::scene::{Scene, SceneHit};
use crate::shape::Surface;
use crate::shape::kinds::Kinds;
use crate::tier::Tier;

/// True if there is an edge between what two neighbouring rays see, each with its nearest hit.
pub(super) fn is_edge<S: Scalar, K: Kinds>(
    scene: &Scene<'_, S, impl Tier<S>, K>,
    rays: [&Ray<S>; 2],
    hits: [Option<SceneHit<S>>; 2],
) -> bool {
    let [Some(a), Some(b)] = hits else { return hits.iter().any(Option::is_some) };
    // Within one part, seen from one side, every primitive is smooth; where one nappe of a double cone hides the other,
    // there is no line.
    let face = |on: SceneHit<S>| (on.object, on.hit.part, on.hit.crossing == Crossing::Exit);
    if face(a) == face(b) {
        return false;
    }
    let [Some(first), Some(second)] = [a, b].map(|on| scene.object(on.object)) else { return true };
    if first.material_of(a.hit.part) != second.material_of(b.hit.part) {
        return true;
    }
    let nearer = if a.hit.t < b.hit.t { a.hit.t } else { b.hit.t };
    let apart = (rays[1].at(nearer) - rays[0].at(nearer)).length();
    !is_smooth(&first.shape.surface(rays[0], &a.hit), &second.shape.surface(rays[1], &b.hit), apart)
}

/// True if two points lie on one smooth surface: their normals differ by at most 29 degrees (a cosine of 7/8), and
/// neither is farther from the tangent plane of the other than the rays are `apart`.
fn is_smooth<S: Scalar, K: Kinds>(a: &Surface<S, K>, b: &Surface<S, K>, apart: S) -> bool {
    let (step, apart) = (b.point() - a.point(), apart.real());
    let normals = [a.normal_towards_ray(), b.normal_towards_ray()];
    let is_near = |normal| {
        let distance = step.dot(normal);
        distance <= apart && -distance <= apart
    };
    normals[0].dot(normals[1]) >= S::Real::ONE - S::Real::ONE.scaled(-3) && normals.into_iter().all(is_near)
}
