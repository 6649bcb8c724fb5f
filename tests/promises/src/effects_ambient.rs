//! The promise: ambient light comes from everywhere, and only where a scene has it.

use crate::effects::{matte, same_with, with_scene};
use fixed::types::{I16F16, I32F32};
use raylet::effect::{Ambient, Effect, EffectSet};
use raylet::scalar::UnitScalar;
use raylet::{Color, Picture, Scalar, Size};

/// What no light reaches is as bright as the ambient light, the colour and `diffuse` say; elsewhere it is that much
/// brighter.
#[test]
fn ambient_light_comes_from_everywhere() {
    fn check<S: Scalar>() {
        let size = Size::new(20, 15);
        let ambient = [0.25, 0.5, 0.125];
        let near = |a: f64, b: f64| (a - b).abs() < 1e-4;
        with_scene(matte::<S>(), false, None, |scene| {
            let scene = scene.with_ambient(Color::from_f64(ambient));
            assert_eq!(scene.effects(), EffectSet::of(Effect::Ambient));
            same_with::<S, (Ambient,)>(&scene, size);
            let color = matte::<S>().color.to_array().map(UnitScalar::to_f64);
            let mut balls = 0;
            Picture::new(&scene, size).render(|_, _, pixel| {
                if pixel.seen.is_some_and(|(object, _)| object == 1) {
                    balls += 1;
                    let seen = pixel.color.to_array().map(UnitScalar::to_f64);
                    assert!((0..3).all(|i| near(seen[i], ambient[i] * color[i])), "{seen:?}");
                }
            });
            assert!(balls > 5);
        });
        with_scene(matte::<S>(), true, None, |scene| {
            let bright = scene.with_ambient(Color::from_f64(ambient));
            let (mut with, mut without) = (vec![], vec![]);
            Picture::new(&bright, size).render(|_, _, pixel| with.push(pixel));
            Picture::new(scene, size).render(|_, _, pixel| without.push(pixel));
            for (with, without) in with.iter().zip(&without) {
                assert_eq!((with.seen, with.lit_by), (without.seen, without.lit_by));
                if with.seen.is_some_and(|(object, _)| object == 1) {
                    let [with, without] = [with, without].map(|pixel| pixel.color.to_array().map(UnitScalar::to_f64));
                    assert!((0..3).all(|i| with[i] > without[i] || near(with[i], 1.0)), "{with:?} {without:?}");
                }
            }
        });
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
}
