//! Range sensors, and queries by the first numbers of a tier alone.

use crate::everything::{any_frame, any_shape};
use crate::input::{Any, any_word, give};
use raylet::Ray;
use raylet::hierarchy::{Hierarchy, Node, Shapes};
use raylet::sensor::{Bounded, Noise, RangeSensor, Reading, Sweep, Try, Zones};
use raylet::tier::Tier;

/// Any sensor among any shapes.
pub fn sensors<S: Any, T: Tier<S>>(ray: &Ray<S>) -> Option<()> {
    let list = [any_shape::<S>()?, any_shape()?, any_shape()?];
    give(list[0].try_nearest_at::<T>(ray).ok()?);
    let counts = [any_word() as u8, any_word() as u8];
    let zones = Zones::with_tangents(any_frame()?, counts, [S::any(), S::any()]).ok()?;
    let zones = zones.with_rays(any_word() as u8).moved_to(any_frame()?);
    let [column, row] = [any_word() as u8, any_word() as u8];
    let noise = Noise::new(S::any(), S::any(), any_word() as u32).ok()?.losing(any_word() as u16);
    let sensor = RangeSensor::new(S::any(), S::any()).ok()?.separating(S::any()).ok()?.with_noise(noise);
    let read: Reading<S, 3> = sensor.read_at::<T, 3>(&list[..], zones.rays(column, row), any_word() as u32);
    let seen = read.returns.first()?;
    give((read.status, seen.incidence(list.get(seen.obstacle as usize)?, ray), zones.depth(ray, seen.distance)));
    let bounded = Bounded::new(&list);
    let in_zone = bounded.seen_by(&zones);
    let fan = zones.fan::<9>().ok()?;
    give(sensor.read_at::<Try<T>, 2>(&in_zone.in_zone(column, row), fan.rays(column, row), any_word() as u32).status);
    let mut nodes = [Node::EMPTY; Hierarchy::<S>::nodes_for(3)];
    let tree = Shapes::new(&list, &mut nodes).ok()?;
    give(sensor.read_at::<T, 1>(&tree, [*ray], any_word() as u32).status);
    Some(())
}

/// What is made from angles.
pub fn angles<S: Any>() -> Option<()> {
    give(Zones::new(any_frame()?, [any_word() as u8, any_word() as u8], [S::any(), S::any()]));
    give(Sweep::new(any_frame()?, any_word() as u16, S::any()).ok()?.beam(any_word() as u16));
    Some(())
}
