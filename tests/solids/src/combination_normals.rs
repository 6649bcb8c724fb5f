//! The surface at a hit of a combination: its point is on it, and its normal points out of the result.

use crate::crowd::Of;
use crate::random_combinations::Parts;
use fixed::types::{I16F16, I32F32};
use raylet::shape::combination::LeafHit;
use raylet::{Crossing, Exact as ExactTier, Fast, Plain, Range, Ray, Stable, Tier, UnitVec3, Vec3};
use support::exact_types::Exact;
use support::oracle::Dyadic;
use support::random::{add, dot, scale};

/// What a test has met.
#[derive(Debug, Default)]
struct Met {
    normals: usize,
    turned: usize,
    unclear: usize,
}

fn normals<S: Exact, T: Tier<S>>(of: Of) {
    let mut met = Met::default();
    Parts::<S>::each(of, 0x428a_2f98_d728_ae22, 1_000, |parts, ray, _| {
        let combination = parts.combination();
        let shape = combination.shape();
        for LeafHit { leaf, hit } in combination.leaf_hits_at::<T>(ray) {
            let (surface, told) = (shape.surface(ray, &hit), || format!("{hit:?}\n{}", parts.told(ray)));
            let (point, normal) = (surface.point().to_f64(), surface.normal());
            // Against a ray that enters; along one that leaves.
            let cosine = dot(normal.to_f64(), ray.direction().to_f64());
            match hit.crossing {
                Crossing::Enter => assert!(cosine < 1e-2, "{cosine} {}", told()),
                Crossing::Exit => assert!(cosine > -1e-2, "{cosine} {}", told()),
                Crossing::Touch => continue,
            }
            assert_eq!(surface.cosine().to_f64().signum(), 1.0);
            let facing = dot(surface.normal_towards_ray().to_f64(), ray.direction().to_f64());
            assert!(facing < 1e-2, "{facing} {}", told());
            if surface.leaf() != Some(leaf) {
                // The tier has another `t` than `Stable`, and two leaves are as near.
                met.unclear += 1;
                continue;
            }
            // Membership a step to both sides. Next to an edge another leaf decides.
            let side = |step: f64| {
                let origin = Vec3::<S>::from_f64(add(point, scale(normal.to_f64(), step))).ok()?;
                let there = Ray::new(origin, UnitVec3::X).ok()?;
                parts.is_in(&there, &Dyadic::zero())
            };
            let sides = [0.01, -0.01, 0.02, -0.02].map(side);
            let is_clear = sides.into_iter().all(|side| side.is_some()) && sides[..2] == sides[2..];
            if !is_clear || sides[0] == sides[1] {
                met.unclear += 1;
                continue;
            }
            assert_eq!(sides[..2], [Some(false), Some(true)], "{}", told());
            met.normals += 1;
            let own = parts.leaves[leaf as usize].hits_at::<T>(&ray.with_range(Range::line()));
            met.turned += usize::from(own.iter().any(|own| own.t == hit.t && own.crossing != hit.crossing));
        }
    });
    println!("{} {}: {met:?}", S::name(), core::any::type_name::<T>());
    assert!(met.normals > 1_500 && met.turned > 100 && met.unclear < met.normals / 4, "{met:?}");
}

#[test]
fn normals_point_out_of_the_result() {
    normals::<f32, Plain>(Of::Others);
    normals::<f32, Stable>(Of::Others);
    normals::<f32, ExactTier>(Of::Others);
    normals::<f32, ExactTier>(Of::All);
    normals::<f32, ExactTier>(Of::Further);
    normals::<f32, Stable>(Of::All);
    normals::<f32, Stable>(Of::Further);
    normals::<f64, Fast>(Of::Others);
    normals::<I16F16, Stable>(Of::Others);
    normals::<I16F16, ExactTier>(Of::Others);
    normals::<I32F32, Stable>(Of::Others);
}
