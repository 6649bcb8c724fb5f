//! The longest that queries take, on a chip without a floating-point unit: a line of JSON a query, with what users do
//! beside it. `.ci/worst` compares it with the longest paths of the linked program, by the names of these functions.
#![no_std]
#![no_main]

use raylet::{Capsule, Cone, Cuboid, Cylinder, Fast, Plain, Plane, Ray, Sphere, Stable};
use raylet_firmware::clock;
use raylet_programs::worst::{Number, Of, of};
use semihosting::{print, println};

/// Defines the functions of a solid, one for each query, and prints what they take.
macro_rules! solids {
    ($($solid:literal, $P:ident, $make:expr, $try_fast:ident, $plain:ident, $fast:ident, $stable:ident;)+) => {
        $(
            solids!($P, $try_fast, |shape, ray| shape.try_nearest_at::<Fast>(ray).is_ok_and(|hit| hit.is_some()));
            solids!($P, $plain, |shape, ray| shape.nearest_at::<Plain>(ray).is_some());
            solids!($P, $fast, |shape, ray| shape.nearest_at::<Fast>(ray).is_some());
            solids!($P, $stable, |shape, ray| shape.nearest_at::<Stable>(ray).is_some());
        )+
        fn all() {
            $(
                let make: fn([Number; 3]) -> Option<$P<Number>> = $make;
                for (tier, name, query) in [
                    ("first numbers of `Fast`", stringify!($try_fast), $try_fast as fn(&Of<$P<Number>>, &_) -> bool),
                    ("`Plain`", stringify!($plain), $plain),
                    ("`Fast`", stringify!($fast), $fast),
                    ("`Stable`", stringify!($stable), $stable),
                ] {
                    let [mean, nearly, worst, found] = of::<$P<Number>>($solid, make, query);
                    print!(r#"{{"solid":"{}","tier":"{tier}","function":"{name}","#, $solid);
                    println!(r#""mean":{mean},"nearly":{nearly},"worst":{worst},"found":{found}}}"#);
                }
            )+
        }
    };
    ($P:ident, $name:ident, |$shape:ident, $ray:ident| $query:expr) => {
        // The linker must keep the name.
        #[unsafe(no_mangle)]
        #[inline(never)]
        fn $name($shape: &Of<$P<Number>>, $ray: &Ray<Number>) -> bool {
            $query
        }
    };
}

solids! {
    "sphere", Sphere, |[r, _, _]| Sphere::new(r).ok(),
        worst_sphere_try, worst_sphere_plain, worst_sphere_fast, worst_sphere_stable;
    "plane", Plane, |_| Some(Plane::new()),
        worst_plane_try, worst_plane_plain, worst_plane_fast, worst_plane_stable;
    "cylinder, capped", Cylinder, |[r, h, _]| Cylinder::capped(r, h).ok(),
        worst_cylinder_try, worst_cylinder_plain, worst_cylinder_fast, worst_cylinder_stable;
    "frustum", Cone, |[a, b, h]| Cone::frustum(a, b, h).ok(),
        worst_cone_try, worst_cone_plain, worst_cone_fast, worst_cone_stable;
    "capsule", Capsule, |[r, h, _]| Capsule::new(r, h).ok(),
        worst_capsule_try, worst_capsule_plain, worst_capsule_fast, worst_capsule_stable;
    "cuboid", Cuboid, |[a, b, c]| Cuboid::new(a, b, c).ok(),
        worst_cuboid_try, worst_cuboid_plain, worst_cuboid_fast, worst_cuboid_stable;
}

fn run() -> ! {
    clock::start();
    all();
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
