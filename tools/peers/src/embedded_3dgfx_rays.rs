//! `embedded-3dgfx` (`f32`): its module `ray_primitive`, and for the triangle `mesh_ray_cast` of one face.
//!
//! Its documentation names a cylinder, but no function has one; of a cone there is nothing. Every answer comes with
//! point and normal: there is no function that leaves them out.

use crate::contestant::{Contestant, Entrant};
use crate::names::EMBEDDED_3DGFX;
use crate::sizes::Sizes;
use embedded_3dgfx::pipeline::vertex::camera;
use embedded_3dgfx::pipeline::vertex::mesh::Geometry;
use embedded_3dgfx::ray_primitive::{
    RayHit, ray_intersects_capsule, ray_intersects_disc, ray_intersects_plane, ray_intersects_sphere,
};
use embedded_3dgfx::{MeshRayCastHit, mesh_ray_cast};
use nalgebra::{Matrix4, Vector3};
use raylet::Ray;
use support::oracle::Solid;

/// A ray of its own; its constructor would make the direction unit once more and so change it.
fn own_ray(ray: &Ray<f32>) -> camera::Ray {
    camera::Ray { origin: ray.origin().to_array().into(), direction: ray.direction().to_array().into() }
}

macro_rules! contestants {
    ($($Primitive:ident { $($size:ident: $Size:ty),+ }, |$ray:ident| $query:expr;)+) => {
        $(
            struct $Primitive {
                $($size: $Size,)+
            }

            impl Contestant<f32> for $Primitive {
                type Ray = camera::Ray;
                type Answer = Option<RayHit>;
                fn ray(ray: &Ray<f32>) -> camera::Ray {
                    own_ray(ray)
                }
                #[inline]
                fn nearest(&self, $ray: &camera::Ray) -> Option<RayHit> {
                    $(let $size = self.$size;)+
                    $query
                }
                fn distance(answer: &Option<RayHit>) -> Option<f32> {
                    answer.map(|hit| hit.distance)
                }
            }
        )+
    };
}
contestants! {
    Sphere { centre: Vector3<f32>, radius: f32 }, |ray| ray_intersects_sphere(ray, centre, radius);
    Capsule { low: Vector3<f32>, high: Vector3<f32>, radius: f32 }, |ray| {
        ray_intersects_capsule(ray, low, high, radius)
    };
    Plane { point: Vector3<f32>, normal: Vector3<f32> }, |ray| ray_intersects_plane(ray, point, normal);
    Disc { centre: Vector3<f32>, normal: Vector3<f32>, radius: f32 }, |ray| {
        ray_intersects_disc(ray, centre, normal, radius)
    };
}

/// A mesh of one face.
struct Triangle {
    vertices: [[f32; 3]; 3],
    faces: [[usize; 3]; 1],
    model_matrix: Matrix4<f32>,
}

impl Contestant<f32> for Triangle {
    type Ray = camera::Ray;
    type Answer = Option<MeshRayCastHit>;
    fn ray(ray: &Ray<f32>) -> camera::Ray {
        own_ray(ray)
    }
    #[inline]
    fn nearest(&self, ray: &camera::Ray) -> Option<MeshRayCastHit> {
        let geometry = Geometry::new(&self.vertices, &self.faces);
        mesh_ray_cast(ray.origin, ray.direction, &geometry, &self.model_matrix, f32::MAX)
    }
    fn distance(answer: &Option<MeshRayCastHit>) -> Option<f32> {
        answer.map(|hit| hit.distance)
    }
}

/// Whether this build took its square roots from the standard library, or from `micromath`, which approximates them. It
/// depends on which crates are in the build: a method of the standard library is found once any crate brings it along.
pub fn has_exact_roots() -> bool {
    let ray = camera::Ray { origin: Vector3::new(0.9, 0.0, -5.0), direction: Vector3::z() };
    ray_intersects_sphere(&ray, Vector3::zeros(), 1.1).is_some_and(|hit| (hit.distance - 4.367_544_5).abs() < 1e-4)
}

/// embedded-3dgfx, for this primitive, if it has it.
pub fn entrant(sizes: Sizes<f32>, solid: &Solid) -> Option<Entrant<f32>> {
    let (origin, up) = (Vector3::zeros(), Vector3::y());
    Some(match sizes {
        Sizes::Sphere { radius } => Entrant::new(EMBEDDED_3DGFX, solid, Sphere { centre: origin, radius }),
        Sizes::Capsule { radius, height } => {
            Entrant::new(EMBEDDED_3DGFX, solid, Capsule { low: origin, high: up * height, radius })
        }
        Sizes::Plane => Entrant::new(EMBEDDED_3DGFX, solid, Plane { point: origin, normal: up }),
        Sizes::Disc { radius } => Entrant::new(EMBEDDED_3DGFX, solid, Disc { centre: origin, normal: up, radius }),
        Sizes::Triangle { vertices } => Entrant::new(
            EMBEDDED_3DGFX,
            solid,
            Triangle { vertices, faces: [[0, 1, 2]], model_matrix: Matrix4::identity() },
        ),
        Sizes::Cylinder { .. } | Sizes::Cone { .. } => return None,
    })
}
