//! The promise: parallel rays have no perspective.

use crate::effects::{ball, number, point};
use fixed::types::{I16F16, I32F32};
use raylet::{Camera, Material, Picture, Scalar, Scene, Size, Vec3};

/// Parallel rays see a ball as large from near as from far, and its picture is as wide as it is.
#[test]
fn an_orthographic_camera_shows_no_perspective() {
    fn check<S: Scalar>() {
        let seen = |distance: f64| {
            let up = point(0.0, 1.0, 0.0);
            let camera = Camera::<S>::orthographic(point(0.0, 0.0, distance), Vec3::ZERO, up, number(3.75)).unwrap();
            let objects = [ball(0.0, 0.0, 0.0, 1.0, 0)];
            let materials = [Material::default()];
            let scene = Scene::new(&objects, &materials, &[], camera).unwrap();
            // Pixels are an eighth apart: fifteen of radius 1 to each side of the middle are within.
            let mut pixels = vec![];
            Picture::new(&scene, Size::new(31, 31)).render(|_, _, pixel| pixels.push(pixel.seen.is_some()));
            pixels
        };
        let (near, far) = (seen(2.0), seen(200.0));
        assert_eq!(near, far);
        for (index, seen) in near.into_iter().enumerate() {
            let [x, y] = [index % 31, index / 31].map(|place| (place as f64 - 15.0) / 8.0);
            let square = x * x + y * y;
            assert!(seen == (square < 1.0) || (square - 1.0).abs() < 1e-9, "{x} {y}");
        }
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}

#[test]
fn an_orthographic_picture_has_a_height() {
    for height in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let up = point(0.0, 1.0, 0.0);
        let error = Camera::<f32>::orthographic(point(0.0, 0.0, 5.0), Vec3::ZERO, up, height).unwrap_err();
        let told =
            "the height of an orthographic camera's picture must be positive and within the number type's budget";
        assert_eq!(error.to_string(), told, "{height}");
    }
}
