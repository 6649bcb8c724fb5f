use super::*;
use crate::frame::Frame;
use crate::primitive::{Sphere, Triangle};
use fixed::types::{I16F16, I32F32};

#[test]
fn simple_bounds_are_those_of_the_shape() {
    fn check<S: Scalar>() {
        let mut state = 1_u32;
        let mut coordinate = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            S::from_f64(f64::from(state as i32) / f64::from(1 << (state % 13 + 17))).unwrap()
        };
        let mut simple = 0;
        for _ in 0..500 {
            let corners: [Vec3<S>; 3] = [(); 3].map(|()| Vec3::new(coordinate(), coordinate(), coordinate()));
            let [a, b, c] = corners;
            let triangle = Triangle::new(a, b, c).map(Shape::new).ok();
            let sphere = Sphere::new(coordinate().magnitude()).map(Shape::new).ok();
            let placed = sphere.map(|sphere| sphere.placed(Frame::at(a).unwrap()));
            for shape in [triangle, placed].into_iter().flatten() {
                if let Some(bounds) = simple_bounds(&shape) {
                    simple += 1;
                    assert_eq!(bounds, shape.bounds());
                }
            }
        }
        assert!(simple > if S::RELATIVE { 450 } else { 900 }, "{simple}");
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}
