//! `parry3d` (`f32`) and `parry3d-f64`: `RayCast::cast_local_ray`, not solid, so that a ray from inside meets the far side as
//! it does in raylet.
//!
//! Its cylinder and its cone have their middle in the origin, and the cone's apex is above. The rays are moved there
//! beforehand, so that parry is asked in the frame that suits it best; its `cast_ray` with a pose would move them itself.

use crate::contestant::{Contestant, Entrant};
use crate::names::PARRY;
use crate::pose::Pose;
use crate::sizes::Sizes;
use support::exact_types::Exact;
use support::oracle::{Dyadic, Solid};
use raylet::Ray;

macro_rules! parry {
    ($module:ident, $library:ident, $Float:ident) => {
        pub mod $module {
            use super::*;
            use $library::math::Vector;
            use $library::query::RayCast;
            use $library::shape::{Ball, Capsule, Cone, Cylinder, HalfSpace, Triangle};

            /// One of parry's shapes.
            struct Parry<G>(G);

            impl<G: RayCast> Contestant<$Float> for Parry<G> {
                type Ray = $library::query::Ray;
                type Answer = Option<$Float>;
                fn ray(ray: &Ray<$Float>) -> Self::Ray {
                    Self::Ray::new(vector(ray.origin().to_array()), vector(ray.direction().to_array()))
                }
                #[inline]
                fn nearest(&self, ray: &Self::Ray) -> Option<$Float> {
                    self.0.cast_local_ray(ray, $Float::MAX, false)
                }
                fn distance(answer: &Option<$Float>) -> Option<$Float> {
                    *answer
                }
            }

            fn vector([x, y, z]: [$Float; 3]) -> Vector {
                Vector::new(x, y, z)
            }

            /// parry, asked about this primitive; it has no disc.
            pub fn entrant(sizes: Sizes<$Float>, solid: &Solid) -> Option<Entrant<$Float>> {
                Some(match sizes {
                    Sizes::Sphere { radius } => Entrant::new(PARRY, solid, Parry(Ball::new(radius))),
                    Sizes::Cylinder { radius, height } => {
                        let half = height / 2.0;
                        let cylinder = Parry(Cylinder::new(half, radius));
                        Entrant::new(PARRY, solid, cylinder).standing(Pose::centred(half), solid.clone())
                    }
                    Sizes::Cone { slope, height } => {
                        // It stores the radius of the base where raylet stores the slope: the oracle is told.
                        let (half, radius) = (height / 2.0, slope * height);
                        let solid = Solid::Frustum {
                            base_radius: radius.exact(),
                            top_radius: Dyadic::zero(),
                            height: height.exact(),
                            capped: true,
                        };
                        let cone = Parry(Cone::new(half, radius));
                        Entrant::new(PARRY, &solid, cone).standing(Pose::mirrored(half), solid.clone())
                    }
                    Sizes::Capsule { radius, height } => {
                        let capsule = Capsule::new(Vector::ZERO, Vector::Y * height, radius);
                        Entrant::new(PARRY, solid, Parry(capsule))
                    }
                    Sizes::Plane => Entrant::new(PARRY, solid, Parry(HalfSpace::new(Vector::Y))),
                    Sizes::Disc { .. } => return None,
                    Sizes::Triangle { vertices } => {
                        let [a, b, c] = vertices.map(vector);
                        Entrant::new(PARRY, solid, Parry(Triangle::new(a, b, c)))
                    }
                })
            }
        }
    };
}
parry!(single, parry3d, f32);
parry!(double, parry3d_f64, f64);
