//! Readings beside a plain search: all hits of all obstacles, sorted.

use crate::yard::{Number, n, obstacles, zones};
use raylet::hierarchy::{Hierarchy, Node, Shapes};
use raylet::sensor::{Bounded, Obstacles, RangeSensor, Reading, Return, Status, Try};
use raylet::{Crossing, Cylinder, Frame, Ray, Scalar, Shape, Sphere, Stable, Tier, UnitVec3, Vec3};
use support::amount::amount;
use support::random::Random;

/// What a sensor with these limits reads, from the lists of all hits.
fn expected<S: Scalar, T: Tier<S>>(
    [least, greatest, separation]: [S; 3],
    list: &[Shape<S>],
    rays: &[Ray<S>],
) -> (Status, Vec<(S, u32)>) {
    let mut returns = Vec::<(S, u32, u32)>::new();
    for (number, ray) in rays.iter().enumerate() {
        for (index, shape) in list.iter().enumerate() {
            let hits = shape.hits_at::<T>(ray);
            for (i, hit) in hits.iter().enumerate() {
                let is_exit = shape.is_solid() && hit.crossing == Crossing::Exit;
                if hit.t <= greatest && (i == 0 || !is_exit) {
                    returns.push((hit.t, number as u32, index as u32));
                }
            }
        }
    }
    returns.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    // Of a solid that the ray starts in the way out counts only as the first of all.
    let is_way_out = |(t, number, index): (S, u32, u32)| {
        let shape = &list[index as usize];
        let hits = shape.hits_at::<T>(&rays[number as usize]);
        shape.is_solid() && hits.iter().any(|hit| hit.t == t && hit.crossing == Crossing::Exit)
    };
    let mut separated = Vec::<(S, u32)>::new();
    for (place, of) in returns.iter().enumerate() {
        let is_apart = separated.last().is_none_or(|(last, _)| {
            let next = last.plus(separation);
            of.0 >= if next > *last { next } else { last.next_up() }
        });
        if is_apart && (place == 0 || !is_way_out(*of)) {
            separated.push((of.0, of.2));
        }
    }
    match separated.first() {
        None => (Status::NoTarget, separated),
        Some((t, _)) if *t < least => (Status::TooNear, vec![]),
        Some(_) => (Status::Measured, separated),
    }
}

fn of<S: Scalar, const N: usize>(reading: &Reading<S, N>) -> (Status, Vec<(S, u32)>) {
    (reading.status, reading.returns.iter().map(|seen| (seen.hit.t, seen.obstacle)).collect())
}

fn agree<S: Number, T: Tier<S>>() {
    let mut random = Random(1);
    let [mut measured, mut many, mut decided] = [0; 3];
    for _ in 0..amount(25, 1_000) {
        let count = 1 + random.below(20);
        let list = obstacles::<S>(&mut random, count);
        let mut nodes = vec![Node::EMPTY; Hierarchy::<S>::nodes_for(list.len())];
        let shapes = Shapes::new(&list, &mut nodes).expect("as many nodes as it needs");
        let bounded = Bounded::new(&list);
        let zones = zones::<S>(&mut random);
        let seen = bounded.seen_by(&zones);
        let fan = zones.fan::<729>().expect("room for 9 by 9 zones of 9 rays");
        let limits = [random.pick(&[0.0, 0.5, 3.0]), random.pick(&[6.0, 30.0]), random.pick(&[0.0, 0.25, 2.0])].map(n);
        let [least, greatest, separation] = limits;
        let sensor =
            RangeSensor::new(least, greatest).and_then(|sensor| sensor.separating(separation)).expect("a sensor");
        let [columns, rows] = zones.counts();
        for (column, row) in (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))) {
            let rays = zones.rays(column, row);
            let listed: Vec<_> = rays.clone().collect();
            assert!(fan.rays(column, row).eq(rays.clone()));
            let reading = sensor.read_at::<T, 3>(&list[..], rays.clone(), 0);
            let wanted = expected::<S, T>(limits, &list, &listed);
            let first_three = (wanted.0, wanted.1.iter().take(3).copied().collect::<Vec<_>>());
            assert_eq!(of(&reading), first_three, "{listed:?} {list:?}");
            assert_eq!(sensor.read_at::<T, 3>(&seen.in_zone(column, row), rays.clone(), 0), reading, "{list:?}");
            assert_eq!(sensor.read_at::<T, 3>(&shapes, fan.rays(column, row), 0), reading);
            // Beside the field of view.
            let beside = sensor.read_at::<T, 3>(&seen.in_zone(columns, row), zones.rays(columns, row), 0);
            assert_eq!(beside, sensor.read_at::<T, 3>(&list[..], zones.rays(columns, row), 0));
            let one = sensor.read_at::<T, 1>(&seen.in_zone(column, row), rays.clone(), 0);
            assert_eq!(one.returns.first(), reading.returns.first());
            let tried = sensor.read_at::<Try<T>, 3>(&list[..], rays, 0);
            if tried.status != Status::Undecided {
                assert_eq!(tried, reading);
                decided += 1;
            }
            measured += usize::from(reading.status == Status::Measured);
            many += usize::from(reading.returns.len() > 1);
        }
    }
    assert!(measured > 100 && many > 50 && decided > 50, "{measured} {many} {decided}");
}

#[test]
fn readings_are_those_of_a_plain_search() {
    agree::<f32, raylet::Fast>();
    agree::<f32, Stable>();
    agree::<f64, Stable>();
    agree::<fixed::types::I16F16, raylet::Plain>();
    agree::<fixed::types::I16F16, Stable>();
    agree::<fixed::types::I20F12, Stable>();
    agree::<fixed::types::I32F32, Stable>();
    agree::<f32, raylet::Exact>();
    agree::<fixed::types::I16F16, raylet::Exact>();
}

fn ray(x: f32, y: f32) -> Ray<f32> {
    Ray::new(Vec3::new(x, y, 0.0), UnitVec3::Z).expect("a ray")
}

fn ball(z: f32) -> Shape<f32> {
    let frame = Frame::at(Vec3::new(0.0, 0.0, z)).expect("a frame");
    Shape::new(Sphere::new(1.0).expect("a radius")).placed(frame)
}

fn sensor(least: f32, greatest: f32) -> RangeSensor<f32> {
    RangeSensor::new(least, greatest).expect("a sensor")
}

#[test]
fn what_is_too_near_blinds_the_sensor() {
    let list = [ball(9.0), ball(4.0)];
    let status = |least| sensor(least, 20.0).read::<3>(&list[..], [ray(0.0, 0.0)], 0).status;
    assert_eq!([3.0, 3.0_f32.next_up()].map(status), [Status::Measured, Status::TooNear]);
    // From inside the way out is seen.
    let reading = sensor(0.0, 20.0).read::<3>(&[ball(0.0)][..], [ray(0.0, 0.0)], 0);
    assert!(reading.returns.iter().map(|seen| seen.distance).eq([1.0]));
    assert_eq!(sensor(0.0, 2.0).read::<1>(&list[..], [ray(0.0, 0.0)], 0).status, Status::NoTarget);
    assert_eq!(sensor(0.0, 3.0).read::<1>(&list[..], [ray(0.0, 0.0)], 0).status, Status::Measured);
}

#[test]
fn returns_are_apart_and_of_the_nearest_ray() {
    let list = [ball(9.0), ball(4.0), ball(4.5)];
    let read = |separation| {
        let sensor = sensor(0.0, 20.0).separating(separation).expect("a separation");
        sensor.read::<3>(&list[..], [ray(0.9, 0.0), ray(0.0, 0.0)], 0)
    };
    let reading = |separation| -> Vec<_> {
        read(separation).returns.iter().map(|seen: &Return<f32>| (seen.obstacle, seen.distance, seen.ray)).collect()
    };
    assert_eq!(reading(0.0), [(1, 3.0, 1), (2, 3.5, 1), (1, 3.564_11, 0)]);
    assert_eq!(reading(1.0), [(1, 3.0, 1), (2, 4.064_11, 0), (0, 8.0, 1)]);
    assert_eq!(reading(2.0), [(1, 3.0, 1), (0, 8.0, 1)]);
}

#[test]
fn the_second_return_behind_touching_solids_is_seen() {
    // One starts where the other ends.
    let can = Shape::new(Cylinder::capped(1.0_f32, 2.0).expect("sizes"));
    let on_top = can.placed(Frame::at(Vec3::new(0.0, 2.0, 0.0)).expect("a frame"));
    let down = Ray::new(Vec3::new(0.25, 9.0, 0.0), -UnitVec3::Y).expect("a ray");
    for list in [[can, on_top], [on_top, can]] {
        let reading = sensor(0.0, 20.0).read::<3>(&list[..], [down], 0);
        assert!(reading.returns.iter().map(|seen| seen.distance).eq([5.0, 7.0]));
    }
}

#[test]
fn incidence_is_that_of_the_surface() {
    let list = [ball(4.0)];
    let rays = [ray(0.6, 0.0)];
    let reading = sensor(0.0, 20.0).read::<1>(&list[..], rays, 0);
    let seen = reading.returns[0];
    assert!((seen.incidence(&list[0], &rays[0]) - 0.8).abs() < 1e-6);
}

#[test]
fn a_list_through_a_reference_is_the_list() {
    let list = [ball(4.0)];
    let by_reference: &[Shape<f32>] = &list;
    assert_eq!(Obstacles::<f32>::list(&by_reference).len(), 1);
    let reading = sensor(0.0, 20.0).read::<1>(&by_reference, [ray(0.0, 0.0)], 0);
    assert_eq!(reading, sensor(0.0, 20.0).read::<1>(&list[..], [ray(0.0, 0.0)], 0));
}

#[test]
fn obstacles_beyond_the_first_sixteen_are_seen() {
    let list: Vec<_> = (0..20_u8).map(|i| ball(40.0 - f32::from(i))).collect();
    let zones =
        raylet::sensor::Zones::new(Frame::at(Vec3::ZERO).expect("a frame"), [1, 1], [20.0, 20.0]).expect("zones");
    let bounded = Bounded::new(&list);
    let seen = bounded.seen_by(&zones);
    let reading = sensor(0.0, 90.0).read::<2>(&seen.in_zone(0, 0), zones.rays(0, 0), 0);
    assert!(reading.returns.iter().map(|seen| seen.obstacle).eq([19, 18]));
}
