//! The promise: no ray slips between two triangles that share an edge, whatever their sizes.

use raylet::{Ray, Triangle, Vec3};
use support::amount::amount;
use support::exact_types::{Exact, expected};
use support::oracle::Solid;
use support::random::{Random, cross, dot};

every_type!(no_ray_slips_through_a_shared_edge);

fn no_ray_slips_through_a_shared_edge<S: Exact>() {
    let mut random = Random(11);
    let mut aimed = 0;
    for round in 0..amount(60_000_u64, 15_000_000) {
        // One triangle may be a hundred times as large as its neighbour, and the ray may come from far away.
        let mut point = |size: f64| [(); 3].map(|()| random.between(-size, size));
        let (a, c) = (point(2.0), point(2.0));
        let (b, d) = (point(2.0), point(if round % 2 == 0 { 2.0 } else { 200.0 }));
        let origin = point(if round % 3 == 0 { 1000.0 } else { 8.0 });
        let [a, b, c, d] = [a, b, c, d].map(|p| Vec3::<S>::from_f64(p).expect("inside the budget"));
        let along = random.between(0.05, 0.95);
        let ([ax, ay, az], [cx, cy, cz]) = (a.to_f64(), c.to_f64());
        let target = [ax + (cx - ax) * along, ay + (cy - ay) * along, az + (cz - az) * along];
        let (Ok(left), Ok(right)) = (Triangle::new(a, b, c), Triangle::new(a, c, d)) else { continue };
        let (origin, target) = (Vec3::from_f64(origin).ok(), Vec3::from_f64(target).ok());
        let ray = Ray::towards(origin.expect("inside the budget"), target.expect("inside the budget"));
        let Ok(ray) = ray else { continue };
        // A ray that sees the edge as the outline of both triangles may pass beside it.
        let sides = [b, d].map(|p| {
            let edge = cross(minus(c.to_f64(), a.to_f64()), ray.direction().to_f64());
            dot(edge, minus(p.to_f64(), a.to_f64()))
        });
        if sides[0] * sides[1] >= -1e-3 {
            continue;
        }
        aimed += 1;
        // A ray that sees one of the triangles from its edge may, for its direction is rounded, pass beside both.
        let slips = !left.occludes(&ray) && !right.occludes(&ray);
        assert!(!slips || !(meets(&left, &ray) || meets(&right, &ray)), "{}: {left:?} {right:?} {ray:?}", S::name());
    }
    assert!(aimed > 15_000, "{aimed} rays were aimed at a fold seen from its side");
}

/// In exact arithmetic.
fn meets<S: Exact>(triangle: &Triangle<S>, ray: &Ray<S>) -> bool {
    let vertices = triangle.vertices().map(|vertex| vertex.to_array().map(Exact::exact));
    !expected(&Solid::Triangle { vertices }, ray).hits.is_empty()
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
