//! Every small example runs, and finds what it says. `examples/render` has tests of its own, in the repository.

#[path = "../examples/character.rs"]
mod character;
#[path = "../examples/many_rays.rs"]
mod many_rays;
#[path = "../examples/one_bit.rs"]
mod one_bit;
#[path = "../examples/own_picture.rs"]
mod own_picture;
#[path = "../examples/picking.rs"]
mod picking;
#[path = "../examples/range.rs"]
mod range;
#[path = "../examples/thickness.rs"]
mod thickness;
#[path = "../examples/tiers.rs"]
mod tiers;

#[test]
fn a_ball_is_pushed_through_a_gap() {
    character::main().expect("it runs");
}

#[test]
fn many_rays_run_on_all_processors() {
    many_rays::main().expect("it runs");
}

#[test]
fn a_display_of_one_bit_shows_outlines() {
    one_bit::main().expect("it runs");
}

#[test]
fn a_picture_of_ones_own_has_light_and_shadow() {
    own_picture::main().expect("it runs");
}

#[test]
fn what_is_under_the_pointer_is_picked() {
    picking::main().expect("it runs");
}

#[test]
fn the_sensor_sees_the_posts() {
    range::main().expect("it runs");
}

#[test]
fn the_wall_has_its_thickness() {
    thickness::main().expect("it runs");
}

#[test]
fn the_tiers_tell_the_same_part() {
    tiers::main().expect("it runs");
}
