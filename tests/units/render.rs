use super::*;
use crate::scene::Camera;
use crate::vector::Vec3;

/// Tested here because a picture does not show the difference between one corner and their mean, which is at most
/// 1/32.
#[test]
fn corners_that_agree_are_averaged_and_cost_no_ray() {
    let camera = Camera::new(Vec3::new(0.0_f32, 0.0, 5.0), Vec3::ZERO, Vec3::new(0.0, 1.0, 0.0), 40.0);
    let scene = camera.ok().and_then(|camera| Scene::<f32>::new(&[], &[], &[], camera).ok());
    let scene = scene.expect("an empty scene");
    let picture = Picture::new(&scene, Size::new(8, 6).with_samples(2));
    let corner = |steps: f32| Sample { color: Color::from([steps / 128.0; 3]), seen: None, lit_by: 0 };
    let mut context = TraceContext::new(());
    let pixel = picture.between([[corner(64.0), corner(65.0)], [corner(66.0), corner(67.0)]], [0, 0], &mut context);
    assert_eq!(pixel.color.to_array(), [65.5 / 128.0; 3]);
    assert_eq!(context.counters, Counters::default());
}
