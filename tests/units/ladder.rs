//! Flat parts in the world, of which `Stable` knows constant bounds, beside exact arithmetic.

use crate::hit::Hits;
use crate::primitive::{Cuboid, Disc, Plane, Rectangle};
use crate::random::Random;
use crate::ray::Ray;
use crate::tier::{Exact, Stable};
use crate::vector::{UnitVec3, Vec3};

impl Random {
    fn point_within(&mut self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [self.between(-x, x), self.between(-y, y), self.between(-z, z)]
    }

    /// The sizes of solids, most of them near 1, and a ray at them: from near and far, at an edge or a corner, nearly
    /// or exactly parallel to a face.
    fn flat_case(&mut self) -> Option<([f32; 3], Ray<f32>)> {
        let size = if self.next().is_multiple_of(3) { libm::exp2(self.between(-40.0, 40.0)) } else { 1.0 };
        let half = [self.between(0.5, 2.0), self.between(0.2, 1.2), self.between(0.5, 1.5)].map(|half| half * size);
        let distance = size * libm::exp10(self.between(0.0, 5.0));
        let origin = self.point_within([distance; 3]);
        let mut aim = self.point_within(half.map(|half| 1.2 * half));
        for axis in 0..3 {
            if self.next().is_multiple_of(4) {
                aim[axis] = half[axis];
            }
        }
        let mut along = [0, 1, 2].map(|axis| (aim[axis] - origin[axis]) / size);
        let axis = (self.next() % 3) as usize;
        along[axis] *= [1.0, 1.0, 1.0, 1e-6, 0.0][(self.next() % 5) as usize];
        let direction = UnitVec3::new(Vec3::from(along.map(|c| c as f32))).ok()?;
        Some((half.map(|half| half as f32), Ray::new(Vec3::from(origin.map(|c| c as f32)), direction).ok()?))
    }
}

#[test]
fn flat_parts_in_the_world_are_met_as_promised() {
    let rounds = if std::env::var_os("RAYLET_LONG").is_some() { 10_000_000 } else { 60_000 };
    let (mut random, mut hit) = (Random(77), 0);
    for _ in 0..rounds {
        let Some((half @ [x, y, z], ray)) = random.flat_case() else { continue };
        let (Ok(cuboid), Ok(rectangle), Ok(disc)) = (Cuboid::new(x, y, z), Rectangle::new(x, z), Disc::new(x)) else {
            continue;
        };
        for [stable, exact] in [
            [cuboid.hits_at::<Stable>(&ray), cuboid.hits_at::<Exact>(&ray)],
            [rectangle.hits_at::<Stable>(&ray), rectangle.hits_at::<Exact>(&ray)],
            [disc.hits_at::<Stable>(&ray), disc.hits_at::<Exact>(&ray)],
            [Plane::new().hits_at::<Stable>(&ray), Plane::new().hits_at::<Exact>(&ray)],
        ] {
            let [stable, exact]: [Hits<f32>; 2] = [stable, exact];
            assert_eq!(stable.len(), exact.len(), "{stable:?} {exact:?} {half:?} {ray:?}");
            for (stable, exact) in stable.iter().zip(&exact) {
                hit += 1;
                assert_eq!((stable.part, stable.crossing), (exact.part, exact.crossing), "{half:?} {ray:?}");
                let unit = exact.t.abs().next_up() - exact.t.abs();
                assert!((stable.t - exact.t).abs() <= 16.0 * unit, "{stable:?} {exact:?} {half:?} {ray:?}");
            }
        }
    }
    assert!(hit > rounds / 2, "{hit}");
}
