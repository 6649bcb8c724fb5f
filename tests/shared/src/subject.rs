//! The queries, and by what they are called: through the primitive's own methods, or those of a placed shape.

use raylet::tier::Tier;
use raylet::{
    Affine, Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Frame, Hit, Hits, Plane, Polyhedron, Prism, Ray, Rectangle,
    Revolved, RoundCone, RoundedCuboid, Scalar, Shape, Sphere, Surface, Torus, Triangle, Tube, UnitVec3, Vec3,
};

/// What a primitive and a shape have in common.
pub trait Subject<S: Scalar> {
    /// All hits.
    fn hits<T: Tier<S>>(&self, ray: &Ray<S>) -> Hits<S>;
    /// The first hit.
    fn nearest<T: Tier<S>>(&self, ray: &Ray<S>) -> Option<Hit<S>>;
    /// True if there is a hit.
    fn occludes<T: Tier<S>>(&self, ray: &Ray<S>) -> bool;
    /// True if the point belongs to it.
    fn contains(&self, point: Vec3<S>) -> bool;
    /// What a hit has.
    fn surface(&self, ray: &Ray<S>, hit: &Hit<S>) -> Surface<S>;
}

macro_rules! subjects {
    ($($Subject:ident)+) => {
        $(
            impl<S: Scalar> Subject<S> for $Subject<S> {
                #[inline(always)]
                fn hits<T: Tier<S>>(&self, ray: &Ray<S>) -> Hits<S> {
                    self.hits_at::<T>(ray)
                }
                #[inline(always)]
                fn nearest<T: Tier<S>>(&self, ray: &Ray<S>) -> Option<Hit<S>> {
                    self.nearest_at::<T>(ray)
                }
                #[inline(always)]
                fn occludes<T: Tier<S>>(&self, ray: &Ray<S>) -> bool {
                    self.occludes_at::<T>(ray)
                }
                fn contains(&self, point: Vec3<S>) -> bool {
                    $Subject::contains(self, point)
                }
                #[inline(always)]
                fn surface(&self, ray: &Ray<S>, hit: &Hit<S>) -> Surface<S> {
                    $Subject::surface(self, ray, hit)
                }
            }
        )+
    };
}
subjects!(Sphere Cylinder Cone Capsule Plane Disc Triangle Cuboid Rectangle Revolved Tube Annulus RoundCone);
subjects!(RoundedCuboid Prism Polyhedron Torus Shape);

/// The queries, as functions that are not inlined and whose answers are used.
pub mod query {
    use super::Subject;
    use core::hint::black_box;
    use raylet::tier::Tier;
    use raylet::{Hit, Ray, Scalar};

    /// All hits.
    #[inline(never)]
    pub fn hits<S: Scalar, T: Tier<S>, P: Subject<S>>(subject: &P, ray: &Ray<S>) {
        black_box(subject.hits::<T>(ray));
    }

    /// The first hit.
    #[inline(never)]
    pub fn nearest<S: Scalar, T: Tier<S>, P: Subject<S>>(subject: &P, ray: &Ray<S>) {
        black_box(subject.nearest::<T>(ray));
    }

    /// Whether there is a hit.
    #[inline(never)]
    pub fn occludes<S: Scalar, T: Tier<S>, P: Subject<S>>(subject: &P, ray: &Ray<S>) {
        black_box(subject.occludes::<T>(ray));
    }

    /// The normal at a hit.
    #[inline(never)]
    pub fn normal<S: Scalar, P: Subject<S>>(subject: &P, (ray, hit): &(Ray<S>, Option<Hit<S>>)) {
        if let Some(hit) = hit {
            black_box(subject.surface(ray, hit).normal());
        }
    }

    /// The surface coordinates of a hit.
    #[inline(never)]
    pub fn uv<S: Scalar, P: Subject<S>>(subject: &P, (ray, hit): &(Ray<S>, Option<Hit<S>>)) {
        if let Some(hit) = hit {
            black_box(subject.surface(ray, hit).uv());
        }
    }
}

/// Eighths, which every number type holds.
pub fn eighths<S: Scalar>(count: i32) -> S {
    S::from_f64(f64::from(count) / 8.0).unwrap_or(S::ZERO)
}

fn vector<S: Scalar>(x: i32, y: i32, z: i32) -> Vec3<S> {
    Vec3::new(eighths(x), eighths(y), eighths(z))
}

/// The triangle.
pub fn triangle<S: Scalar>() -> Option<Triangle<S>> {
    Triangle::new(vector(-9, 0, -6), vector(7, 2, -5), vector(2, -2, 10)).ok()
}

/// The frame of what is turned and moved.
pub fn frame<S: Scalar>() -> Option<Frame<S>> {
    let (forward, up) = (UnitVec3::new(vector(8, 16, 16)).ok()?, UnitVec3::new(vector(-3, 9, 1)).ok()?);
    Frame::looking(vector(2, -4, 2), forward, up).ok()
}

/// A shape, turned and moved.
pub fn framed<S: Scalar>(shape: Shape<S>) -> Option<Shape<S>> {
    Some(shape.placed(frame()?))
}

/// A shape, stretched, sheared, turned and moved.
pub fn stretched<S: Scalar>(shape: Shape<S>) -> Option<Shape<S>> {
    Some(shape.placed(Affine::new(vector(2, -4, 2), [vector(12, 1, 0), vector(-2, 5, 3), vector(0, 2, 10)]).ok()?))
}

/// Hands every subject to a body, with its name. (A macro: each is of a type of its own.)
#[macro_export]
macro_rules! every_subject {
    ($S:ty, |$name:ident, $subject:ident| $body:expr) => {{
        use $crate::subject::{eighths as n, framed, stretched, triangle};
        use raylet::{Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Plane};
        use raylet::{Rectangle, Revolved, RoundCone, RoundedCuboid, Shape, Sphere, Torus, Tube};
        $crate::every_subject!(@each $S, $name, $subject, $body;
            "sphere" Sphere::new(n::<$S>(8)).ok();
            "cylinder, infinite" Cylinder::infinite(n::<$S>(8)).ok();
            "cylinder, open" Cylinder::open(n::<$S>(8), n(12)).ok();
            "cylinder, capped" Cylinder::capped(n::<$S>(8), n(12)).ok();
            "capsule" Capsule::new(n::<$S>(6), n(12)).ok();
            "cone, double" Cone::double(n::<$S>(6)).ok();
            "cone, nappe" Cone::nappe(n::<$S>(6)).ok();
            "cone, open" Cone::open(n::<$S>(6), n(12)).ok();
            "cone, capped" Cone::capped(n::<$S>(6), n(12)).ok();
            "frustum" Cone::frustum(n::<$S>(10), n(5), n(12)).ok();
            "plane" Some(Plane::<$S>::new());
            "disc" Disc::new(n::<$S>(8)).ok();
            "triangle" triangle::<$S>();
            "cuboid" Cuboid::new(n::<$S>(8), n(6), n(7)).ok();
            "rectangle" Rectangle::new(n::<$S>(8), n(7)).ok();
            "paraboloid" Revolved::paraboloid(n::<$S>(3), n(12)).ok();
            "hyperboloid" Revolved::hyperboloid(n::<$S>(5), n(6), [n(-6), n(8)]).ok();
            "tube" Tube::new(n::<$S>(6), n(8), n(12)).ok();
            "round cone" RoundCone::new(n::<$S>(7), n(4), n(10)).ok();
            "rounded cuboid" RoundedCuboid::new(n::<$S>(6), n(4), n(5), n(2)).ok();
            "prism" $crate::borrowed::prism(n::<$S>(12));
            "polyhedron" $crate::borrowed::polyhedron::<$S>();
            "torus" Torus::new(n::<$S>(6), n(2)).ok();
            "annulus" Annulus::new(n::<$S>(4), n(8)).ok();
            "cylinder, capped, as a shape" Cylinder::capped(n::<$S>(8), n(12)).ok().map(Shape::new);
            "sphere, framed" Sphere::new(n::<$S>(8)).ok().map(Shape::new).and_then(framed);
            "cylinder, capped, framed" Cylinder::capped(n::<$S>(8), n(12)).ok().map(Shape::new).and_then(framed);
            "cone, capped, framed" Cone::capped(n::<$S>(6), n(12)).ok().map(Shape::new).and_then(framed);
            "disc, framed" Disc::new(n::<$S>(8)).ok().map(Shape::new).and_then(framed);
            "triangle, framed" triangle::<$S>().map(Shape::new).and_then(framed);
            "cuboid, framed" Cuboid::new(n::<$S>(8), n(6), n(7)).ok().map(Shape::new).and_then(framed);
            "cylinder, capped, stretched" Cylinder::capped(n::<$S>(8), n(12)).ok().map(Shape::new).and_then(stretched);
        );
    }};
    (@each $S:ty, $name:ident, $subject:ident, $body:expr; $($text:literal $made:expr;)+) => {
        $(
            if let Some($subject) = $made {
                let $name = $text;
                $body;
            }
        )+
    };
}
