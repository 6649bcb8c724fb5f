use super::*;
use crate::scene::{Camera, Light, Material};
use crate::vector::Vec3;

/// The bound is a geometric sum: the light that is shaded at each of `DEPTH + 1` surfaces, and the background or
/// fog behind the last. With a smaller bound visible light would be left out; with a larger one fewer rays would
/// be.
#[test]
fn the_brightest_light_is_that_of_surfaces_seen_in_surfaces() {
    let camera = Camera::new(Vec3::new(0.0_f64, 0.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    let material = Material { diffuse: 0.5, ..Material::matte(Color::new(1.0, 0.5, 0.0)) };
    let black = Material { diffuse: 0.0, ..Material::default() };
    let materials = [black, material.with_highlight(0.25, 9.0).with_mirror(0.5).with_refraction(0.25, 1.5)];
    let lights = [1.0, 2.0].map(|strength| Light::new(Vec3::ZERO, strength));
    let scene = camera.ok().and_then(|camera| Scene::<f64>::new(&[], &materials, &lights, camera).ok());
    let scene = scene.expect("a scene").with_background(Color::new(0.2, 0.9, 0.1));
    let sent_on = |material: &Material<f64>| material.mirror + material.transmittance;
    let bound = brightest(&scene.with_fog(Fog::new(Color::new(0.8, 0.3, 0.1), 0.5)), sent_on);
    // Three lights of strength 1; 3/4 of the light is reflected or transmitted.
    let (shaded, air) = ([2.25, 1.5, 0.75], [0.8, 0.9, 0.1]);
    for ((bound, shaded), air) in bound.into_iter().zip(shaded).zip(air) {
        let rest = 0.75_f64.powi(i32::from(DEPTH) + 1);
        let expected = shaded * (1.0 - rest) / 0.25 + air * rest;
        assert!((bound - expected).abs() < 1e-9, "{bound} {expected}");
    }
}
