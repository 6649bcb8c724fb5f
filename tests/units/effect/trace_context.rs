use super::*;

/// One entry for all lights would give the same results with more tests.
#[test]
fn each_light_has_a_memory_of_its_own() {
    let mut context = TraceContext::new(());
    (0..10).for_each(|light| context.remember_occluder(light, Some(light + 100)));
    (0..10).for_each(|light| assert_eq!(context.last_occluder(light), (light < 8).then_some(light + 100)));
    context.remember_occluder(3, None);
    assert_eq!([2, 3].map(|light| context.last_occluder(light)), [Some(102), None]);
    context.forget();
    assert_eq!(context.last_occluder(2), None);
}
