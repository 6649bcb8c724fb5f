//! `parry3d` (`f32`) and `parry3d-f64`: `RayCast::cast_local_ray`, not solid, so that a ray from inside meets the far
//! side as it does in raylet.
//!
//! Its cylinder and its cone have their middle in the origin, and the cone's apex is above. The rays are moved there
//! beforehand, so that parry is called in the frame that suits it best; its `cast_ray` with a pose would move them
//! itself.

use crate::contestant::{Contestant, Entrant};
use crate::names::PARRY;
use crate::pose::Pose;
use crate::sizes::Sizes;
use raylet::Ray;
use support::exact_types::Exact;
use support::oracle::{Dyadic, Solid};

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

            /// parry, for this primitive; it has no disc.
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

/// parry's shapes in poses, for the workloads of placed solids.
pub mod placed {
    use parry3d::glamx::{Mat3, Quat};
    use parry3d::math::{Pose, Vector};
    use parry3d::query::{Ray, RayCast};
    use parry3d::shape::{Ball, Capsule, Cone, Cylinder, Triangle};
    use raylet::{Placement, Primitive};
    use shared::workload::Query;
    use std::f32::consts::PI;

    enum Any {
        Ball(Ball),
        Cylinder(Cylinder),
        Cone(Cone),
        Capsule(Capsule),
        Triangle(Triangle),
    }

    /// A query in parry's own types.
    pub struct Posed {
        shape: Any,
        pose: Pose,
        ray: Ray,
    }

    fn vector([x, y, z]: [f32; 3]) -> Vector {
        Vector::new(x, y, z)
    }

    impl Posed {
        /// The same query; `None` if parry does not have the solid, or no such placement.
        pub fn of(query: &Query<f32>) -> Option<Self> {
            // Where parry's solid stands in raylet's canonical pose: its cylinder and its cone have their middle in the
            // origin, and the cone's apex is above instead of below.
            let raised = |height: f32| Pose::translation(0.0, height / 2.0, 0.0);
            let (shape, own) = match query.shape.primitive() {
                Primitive::Sphere(sphere) => (Any::Ball(Ball::new(sphere.radius())), Pose::IDENTITY),
                Primitive::Cylinder(cylinder) => {
                    let height = cylinder.height()?;
                    (Any::Cylinder(Cylinder::new(height / 2.0, cylinder.radius())), raised(height))
                }
                Primitive::Cone(cone) if cone.base_radius() == 0.0 => {
                    let height = cone.height()?;
                    let turned = Pose::from_rotation(Quat::from_rotation_x(PI));
                    (Any::Cone(Cone::new(height / 2.0, cone.top_radius()?)), raised(height) * turned)
                }
                Primitive::Capsule(capsule) => {
                    let top = Vector::Y * capsule.height();
                    (Any::Capsule(Capsule::new(Vector::ZERO, top, capsule.radius())), Pose::IDENTITY)
                }
                Primitive::Triangle(triangle) => {
                    let [a, b, c] = triangle.vertices().map(|v| vector(v.to_array()));
                    (Any::Triangle(Triangle::new(a, b, c)), Pose::IDENTITY)
                }
                _ => return None,
            };
            let placed = match query.shape.placement() {
                Placement::World => Pose::IDENTITY,
                Placement::Frame(frame) => {
                    let [x, y, z] = frame.axes().map(|axis| vector(axis.to_array()));
                    let rotation = Quat::from_mat3(&Mat3::from_cols(x, y, z));
                    Pose::from_parts(vector(frame.position().to_array()), rotation)
                }
                _ => return None,
            };
            let ray = Ray::new(vector(query.ray.origin().to_array()), vector(query.ray.direction().to_array()));
            Some(Self { shape, pose: placed * own, ray })
        }

        /// The distance of the nearest hit.
        pub fn nearest(&self) -> Option<f32> {
            let (pose, ray) = (&self.pose, &self.ray);
            match &self.shape {
                Any::Ball(shape) => shape.cast_ray(pose, ray, f32::MAX, false),
                Any::Cylinder(shape) => shape.cast_ray(pose, ray, f32::MAX, false),
                Any::Cone(shape) => shape.cast_ray(pose, ray, f32::MAX, false),
                Any::Capsule(shape) => shape.cast_ray(pose, ray, f32::MAX, false),
                Any::Triangle(shape) => shape.cast_ray(pose, ray, f32::MAX, false),
            }
        }
    }
}
