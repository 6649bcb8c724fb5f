//! Errors in well-known articles on ray tracing cylinders and cones, and what is right.
//!
//! Documentation only. This crate grew from two articles that are still read and copied. Each error below has a test in
//! `tests/promises/src/errata.rs`, for every number type; the last column has its name. `ox`, `oy`, `oz` are the ray's
//! origin and `dx`, `dy`, `dz` its direction; `a`, `k` and `c` are the coefficients of `a t^2 + 2 k t + c = 0`; `m` is
//! a cone's slope, `rho` a point's distance from the axis.
//!
//! # An article on cylinders and cones (infinite, bounded, caps, normals)
//!
//! | printed | right | test |
//! |---|---|---|
//! | the cap at y = 1: `t = -(oy + 1) / dy`; the base: `t = oy / dy` | a plane with the normal (0, 1, 0) at y = 1 has the constant -1: `t = (1 - oy) / dy`, and `t = -oy / dy` | `cap_planes_are_at_the_height_minus_the_origin_over_the_direction` |
//! | "if a is zero there is no intersection", of a cone | a = 0 is a ray parallel to a generator: one root, `-c / (2k)` | `a_cone_met_parallel_to_a_generator_has_one_root` |
//! | the same, of a capped cylinder | a = 0 is a ray along the axis: it can meet both caps | `a_capped_cylinder_met_along_its_axis_is_met_at_both_caps` |
//! | "the smaller positive root is nearest" | the smaller root may lie beyond an end of the solid while the larger does not, or on the other nappe; this crate intersects intervals instead | `the_smaller_positive_root_is_not_the_nearest_hit_of_a_bounded_solid` |
//! | the lateral normal of a cone is (x, -y, z) | it is not unit, and zero at the apex: `(x / rho, -m, z / rho)` normalised, and at the apex the axis | `the_lateral_normal_of_a_cone_is_unit_and_at_the_apex_the_axis` |
//!
//! # An article on a cone in C# (placement, departure, textures)
//!
//! | printed | right | test |
//! |---|---|---|
//! | a cylinder with the axis y is `X^2 + Y^2 = R^2` | `x^2 + z^2 = R^2` | `the_cylinder_about_y_is_x_squared_plus_z_squared` |
//! | the inside test has `Z^2` where the height belongs | `x^2 + z^2 < y^2` at the ray's start | `a_point_is_inside_a_cone_by_its_distance_from_the_axis` |
//! | `A = 1 - 2 dy^2` | of unit local directions only: `a = dx^2 + dz^2 - m^2 dy^2` | `a_is_one_minus_two_dy_squared_for_unit_directions_only` |
//! | a hit must have y above a minimal distance | that cuts a hole at the apex; with a [`Departure`](crate::Departure) a secondary ray needs no such distance | `there_is_no_hole_at_the_apex` |
//! | `y < 1` on the side and `x^2 + z^2 < 1` on the base | both strict comparisons drop the rim, and with it every ray in the plane of the base: from (-3, 1, 0) along x the cone is met at t = 2 and 4 | `a_ray_in_the_plane_of_the_base_meets_the_rim_twice` |
//! | the part is told from the rounded point: the base if `y` is almost 1 | a hit of the side next to the rim would get the normal of the base; the part is known when the hit is found | `a_hit_of_the_side_next_to_the_rim_has_the_normal_of_the_side` |
//! | the text starts `u` at the positive z axis, the code (`atan2(x, -z)`) at the negative one; `w` runs against z | here `u` starts at the x axis and is 1/4 at -z, counter-clockwise as seen from +y, and `w` grows with z | `u_starts_at_the_x_axis_and_w_grows_with_z` |
//! | the code takes the base to be at v = 0, the text the tip | v = 0 at the tip | `v_is_zero_at_the_tip_of_the_cone` |
