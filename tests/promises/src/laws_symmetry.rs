//! The promise: moving the origin along a ray moves `t`, and turning or mirroring ray and solid together changes
//! nothing; in every number type and tier.
//!
//! Where every number on the way is exact (mirrors and quarter turns of a solid of revolution, axis-parallel shifts on
//! a grid) the answers are the same to the last bit. Elsewhere both answers hold on one and the same exact line, within
//! the bound of [`support::laws::bound`], and differ in nothing but what that bound decides. `Exact` in fixed point
//! decides alike; its `t` may be a unit apart.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use raylet::scalar::UnitScalar;
use raylet::{Crossing, Frame, Hits, Part, Range, Ray, Rectangle, Shape, Triangle, UnitVec3, Vec3};
use support::cases::v;
use support::exact_types::Exact as Number;
use support::laws::{Grade, Graded, Law, Met, Pose, Setting, bound, is_float, met, number, unit_at, unit_on_the_way};
use support::oracle::Solid;
use support::random::Random;

laws!(
    mirrors_and_quarter_turns_about_the_axis_change_no_bit,
    turning_the_world_turns_the_hits,
    a_turned_shape_is_met_as_the_shape_itself,
    a_shift_along_an_axis_shifts_t_exactly,
    a_shift_along_the_ray_shifts_t,
);

mod law {
    use super::*;

    /// The symmetries of a solid of revolution that permute bits: `x` and `z` with signs, swapped or not.
    const SYMMETRIES: [(bool, bool, bool); 7] = [
        (false, true, false),
        (false, false, true),
        (false, true, true),
        (true, false, false),
        (true, true, false),
        (true, false, true),
        (true, true, true),
    ];

    fn mapped<N: Copy + std::ops::Neg<Output = N>>(
        [x, y, z]: [N; 3],
        (swap, minus_x, minus_z): (bool, bool, bool),
    ) -> [N; 3] {
        let [x, z] = if swap { [z, x] } else { [x, z] };
        [if minus_x { -x } else { x }, y, if minus_z { -z } else { z }]
    }

    /// The face of a cuboid whose image a face is.
    fn image(part: Part, minus_x: bool, minus_z: bool) -> Part {
        match part {
            Part::Left if minus_x => Part::Right,
            Part::Right if minus_x => Part::Left,
            Part::Back if minus_z => Part::Front,
            Part::Front if minus_z => Part::Back,
            same => same,
        }
    }

    /// Law 6, about the solid's own axis.
    pub(super) fn mirrors_and_quarter_turns_about_the_axis_change_no_bit<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        _: &mut Random,
    ) -> Law {
        for symmetry in SYMMETRIES {
            let (swap, minus_x, minus_z) = symmetry;
            // A triangle is mirrored too, and its front with it.
            let is_mirror = swap ^ minus_x ^ minus_z;
            let (shape, flips) = match &setting.solid {
                Solid::Triangle { vertices } => {
                    let [a, b, c] = vertices
                        .each_ref()
                        .map(|corner| v::<S>(mapped(corner.each_ref().map(support::oracle::Dyadic::to_f64), symmetry)));
                    (Shape::new(Triangle::new(a, b, c).expect("as large as before")), is_mirror)
                }
                // Those under test have no symmetry.
                Solid::HalfSpaces(_) => continue,
                // Of two sides the one across x owns an edge, whichever of them it is after a turn.
                Solid::Cuboid { .. } | Solid::RoundedCuboid(_) if swap => continue,
                Solid::Rectangle { half: [x, z] } if swap => {
                    let [z, x] = [z, x].map(|half| number(half.to_f64()).expect("as large as before"));
                    (Shape::new(Rectangle::new(z, x).expect("as large as before")), false)
                }
                _ => (setting.unplaced, false),
            };
            for range in [setting.local_ray.range(), Range::line()] {
                let ray = setting.local_ray.with_range(range);
                let along =
                    UnitVec3::from_components(mapped(ray.direction().to_array(), symmetry)).expect("as long as before");
                let from = Vec3::from(mapped(ray.origin().to_array(), symmetry));
                let other = Ray::new(from, along).expect("as far as before").with_range(range);
                let (here, there) = (setting.unplaced.hits_at::<T>(&ray), shape.hits_at::<T>(&other));
                let turned = |crossing| match crossing {
                    Crossing::Enter if flips => Crossing::Exit,
                    Crossing::Exit if flips => Crossing::Enter,
                    same => same,
                };
                // Swapped, a rounded sum of three has another order, and so may have another last bit. The fast tier
                // cuts products off, which of a negative number goes the other way.
                let rounds = match T::GRADE {
                    Grade::Plain | Grade::Fast => true,
                    Grade::Stable => swap && is_float::<S>(),
                    Grade::Exact => false,
                };
                if rounds {
                    let back = |hit: Met| Met { part: image(hit.part, minus_x, minus_z), ..hit };
                    let there: Vec<_> = met(&there).into_iter().map(back).collect();
                    on_one_line::<S, T>(&setting.in_own_frame(), &ray, &met(&here), &there, 0.0)?;
                    continue;
                }
                let here: Vec<_> = here.iter().map(|hit| (hit.t, hit.part, turned(hit.crossing))).collect();
                let list: Vec<_> =
                    there.iter().map(|hit| (hit.t, image(hit.part, minus_x, minus_z), hit.crossing)).collect();
                prop_assert_eq!(here, list, "{:?} {:?}", symmetry, ray);
                let point = ray.at(number(0.75).expect("small"));
                let image = Vec3::from(mapped(point.to_array(), symmetry));
                prop_assert_eq!(setting.unplaced.contains_at::<T>(point), shape.contains_at::<T>(image), "{:?}", point);
            }
        }
        Ok(())
    }

    /// Quarter turns of all axes, which no type rounds.
    fn quarter_turns<S: Number>() -> [Frame<S>; 6] {
        let (x, y, z) = (UnitVec3::X, UnitVec3::Y, UnitVec3::Z);
        [[y, z, x], [z, x, y], [-x, z, y], [z, -x, -y], [-y, -x, -z], [y, -x, z]]
            .map(|[r, u, f]| Frame::from_left_up_forward(Vec3::ZERO, r, u, f).expect("perpendicular axes"))
    }

    /// Law 6, of the world: the line stays the same exact line, seen from the solid.
    pub(super) fn turning_the_world_turns_the_hits<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        random: &mut Random,
    ) -> Law {
        let frame = random.pick(&quarter_turns::<S>());
        let ray = setting.local_ray.with_range(Range::line());
        let along = Pose::Frame(frame).turned(ray.direction()).expect("quarter turns");
        let Ok(turned) = Ray::new(frame.point_to_world(ray.origin()), along) else { return Ok(()) };
        let turned = turned.with_range(Range::line());
        let shape = setting.unplaced.placed(frame);
        let (here, there) = (setting.unplaced.hits_at::<T>(&ray), shape.hits_at::<T>(&turned));
        // A float sum depends on the order of its terms, and fixed-point kernels see a placed solid on a finer grid.
        if T::GRADE == Grade::Exact && is_float::<S>() {
            prop_assert_eq!(&here, &there, "{:?} {:?}", frame, ray);
        } else if T::GRADE == Grade::Exact {
            let decided = |hits: &Hits<S>| {
                let crossings: Vec<_> = hits.iter().map(|hit| (hit.part, hit.crossing)).collect();
                (crossings, hits.starts_inside(), hits.coincident().is_some())
            };
            prop_assert_eq!(decided(&here), decided(&there), "{:?} {:?}", frame, ray);
        }
        on_one_line::<S, T>(&setting.in_own_frame(), &ray, &met(&here), &met(&there), 0.0)?;
        for (a, b) in here.iter().zip(&there) {
            if a == b {
                let (na, nb) = (setting.unplaced.surface(&ray, a).normal(), shape.surface(&turned, b).normal());
                let (na, nb) = (Pose::Frame(frame).turned(na).expect("quarter turns").to_f64(), nb.to_f64());
                let apart = (0..3).map(|i| (na[i] - nb[i]).abs()).fold(0.0, f64::max);
                // Near the axis a unit of the point turns the normal; what is left is far below a wrong axis.
                prop_assert!(apart < 1e-2 || near_axis(setting, &ray, a.t), "{a:?}: {na:?} {nb:?}");
            }
        }
        Ok(())
    }

    fn near_axis<S: Number>(setting: &Setting<S>, ray: &Ray<S>, t: S) -> bool {
        let [x, _, z] = setting.in_own_frame().local_point(ray, &t.exact()).map(|c| c.to_f64());
        x.hypot(z) < 1000.0 * unit_on_the_way(ray, t.to_f64())
    }

    /// Law 6, of any frame: turned and moved, the ray is rounded, and nothing else changes.
    pub(super) fn a_turned_shape_is_met_as_the_shape_itself<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        _: &mut Random,
    ) -> Law {
        if !matches!(setting.pose, Pose::Frame(_)) {
            return Ok(());
        }
        let here = setting.unplaced.hits_at::<T>(&setting.local_ray.with_range(Range::line()));
        let there = setting.shape.hits_at::<T>(&setting.ray.with_range(Range::line()));
        for hit in here.iter().chain(&there) {
            // Far along the ray a turned direction is off by its own last bits.
            if hit.t.to_f64().abs() > 1e3 {
                return Ok(());
            }
        }
        let ray = setting.local_ray.with_range(Range::line());
        let most = here.iter().chain(&there).map(|hit| hit.t.to_f64().abs()).fold(16.0, f64::max);
        let more = 8.0 * unit_on_the_way(&setting.ray, most).max(unit_on_the_way(&ray, most));
        on_one_line::<S, T>(&setting.in_own_frame(), &ray, &met(&here), &met(&there), more)
    }

    /// Law 5, where every number is exact: an axis-parallel ray from a grid, moved by a number of the grid, in a world
    /// that is turned by quarter turns and powers of two at most. In fixed point `t` shifts to the last bit (`Stable`:
    /// but for ties; `Plain`, `Fast`, and `Stable` where the world is stretched, which round on the way: within the
    /// bound); a float's `t` is rounded where it stands.
    pub(super) fn a_shift_along_an_axis_shifts_t_exactly<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        random: &mut Random,
    ) -> Law {
        if setting.index == 3 {
            return Ok(());
        }
        let mut grid = |size: f64| (random.between(-size, size) * 256.0).round() / 256.0;
        let (mut from, shift) = ([grid(2.0), grid(2.0), grid(2.0)], grid(8.0));
        let position = match setting.pose {
            Pose::World => [0.0; 3],
            _ => [2.0, -1.0, 3.0],
        };
        let axis = random.below(3);
        let sign = random.sign();
        let mut along = [0.0; 3];
        along[axis] = sign;
        for i in 0..3 {
            from[i] += position[i] - 4.0 * along[i];
        }
        let along = UnitVec3::from_components(along.map(<S::Unit as UnitScalar>::from_f64)).expect("a unit vector");
        let ray = Ray::new(v::<S>(from), along).expect("near").with_range(Range::line());
        from[axis] += sign * shift;
        let moved = Ray::new(v::<S>(from), along).expect("near").with_range(Range::line());
        let (here, there) = (setting.shape.hits_at::<T>(&ray), setting.shape.hits_at::<T>(&moved));
        let shift = number::<S>(shift).expect("small");
        let rounds_on_the_way = is_float::<S>() || matches!(setting.pose, Pose::Affine { .. });
        if T::GRADE <= Grade::Fast || rounds_on_the_way && T::GRADE != Grade::Exact {
            let shifted: Vec<Met> =
                met(&there).into_iter().map(|hit| Met { t: &hit.t + &shift.exact(), ..hit }).collect();
            return on_one_line::<S, T>(setting, &ray, &met(&here), &shifted, 0.0);
        }
        prop_assert_eq!(here.len(), there.len(), "{:?} by {:?}: {:?} {:?}", ray, shift, here, there);
        // Nothing is near an end of the range.
        prop_assert_eq!(here.starts_inside(), there.starts_inside());
        prop_assert_eq!(here.coincident().is_some(), there.coincident().is_some());
        for (a, b) in here.iter().zip(&there) {
            prop_assert_eq!((a.part, a.crossing), (b.part, b.crossing), "{:?} by {:?}: {:?} {:?}", ray, shift, a, b);
            if is_float::<S>() {
                let apart = (&(&a.t.exact() - &b.t.exact()) - &shift.exact()).to_f64().abs();
                prop_assert!(apart <= unit_at(a.t) + unit_at(b.t), "{ray:?} by {shift:?}: {a:?} {b:?}");
            } else if a.t != b.t.plus(shift) {
                // Roots and reciprocals have 31 bits: what lies within an eighth of a unit of a tie may be rounded to
                // either side.
                let (one, other) = (a.t.exact(), &b.t.exact() + &shift.exact());
                let unit = unit_at(a.t);
                prop_assert!((&one - &other).to_f64().abs() <= unit, "{ray:?} by {shift:?}: {a:?} {b:?}");
                let off = setting.off(&ray, &(&one + &other).scaled(-1), a.part) / setting.pose.growth();
                prop_assert!(off <= unit / 8.0, "{ray:?} by {shift:?}: {a:?} {b:?} is no tie");
            }
        }
        Ok(())
    }

    /// Each answer lies on the surface along the same line, and both cross it alike, but for what the bound decides.
    fn on_one_line<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        ray: &Ray<S>,
        here: &[Met],
        there: &[Met],
        more: f64,
    ) -> Law {
        let mut bounds = more;
        for list in [here, there] {
            for hit in list {
                let t = S::from_f64(hit.t.to_f64()).unwrap_or(S::ZERO);
                let bound = bound::<S, T>(setting, ray, t) + more;
                bounds = bounds.max(bound);
                let off = setting.off(ray, &hit.t, hit.part);
                prop_assert!(off <= bound, "{ray:?} {hit:?} is {:.2} bounds off", off / bound);
            }
        }
        if setting.is_bounded() {
            // Two answers, each as far off as the bound says.
            let alike = setting.alike(ray, here, there, 2.0 * bounds);
            prop_assert!(alike.is_ok(), "{ray:?}: {alike:?}: {here:?} {there:?}");
            prop_assert!(alike == Ok(true) || T::GRADE != Grade::Exact || more > 0.0, "{ray:?}: {here:?} {there:?}");
        }
        Ok(())
    }

    /// Law 5, of any direction: the moved origin is rounded, by half a unit in each coordinate.
    pub(super) fn a_shift_along_the_ray_shifts_t<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        random: &mut Random,
    ) -> Law {
        let ray = setting.ray.with_range(Range::line());
        let shift = number::<S>(random.between(-6.0, 6.0)).expect("small");
        let Ok(moved) = Ray::new(ray.at(shift), ray.direction()) else { return Ok(()) };
        let there = setting.shape.hits_at::<T>(&moved.with_range(Range::line()));
        let here = met(&setting.shape.hits_at::<T>(&ray));
        let shifted: Vec<Met> = met(&there).into_iter().map(|hit| Met { t: &hit.t + &shift.exact(), ..hit }).collect();
        let most = shifted.iter().map(|hit| hit.t.to_f64().abs()).fold(8.0, f64::max);
        // Towards larger `t` one unit of the shift's own place is as much as one of the origin's.
        let more = 2.0 * (unit_on_the_way(&ray, most).max(unit_on_the_way(&moved, most))) * setting.pose.growth();
        on_one_line::<S, T>(setting, &ray, &here, &shifted, more)
    }
}
