//! Many rays at once: all processors of a host, with nothing but the standard library. Shapes and queries are plain
//! values, so that threads share them.
//!
//! `time cargo run --release --example many_rays` says what a ray takes. On a Xeon with two processors its 1.2 million
//! rays at 1,000 balls took 0.27 s of processor time in all, which is 0.23 microseconds a ray. Two threads took 0.55 to
//! 0.71 of the time of one, while ten other programs shared the machine.

use raylet::hierarchy::{Hierarchy, Node, Shapes};
use raylet::{Fast, Frame, Plain, Ray, Shape, Sphere, Stable, Tier, UnitVec3, Vec3};
use std::num::NonZero;
use std::thread;
use std::time::Instant;

/// How many of the rays hit: each thread takes a part of the list.
fn hits<T: Tier<f32>>(balls: Shapes<'_, f32>, rays: &[Ray<f32>], threads: usize) -> usize {
    let part = |rays: &[Ray<f32>]| rays.iter().filter(|ray| balls.nearest_at::<T>(ray).is_some()).count();
    thread::scope(|scope| {
        let parts = rays.chunks(rays.len().div_ceil(threads)).map(|rays| scope.spawn(move || part(rays)));
        let parts: Vec<_> = parts.collect();
        parts.into_iter().filter_map(|part| part.join().ok()).sum()
    })
}

fn timed<T: Tier<f32>>(name: &str, balls: Shapes<'_, f32>, rays: &[Ray<f32>], threads: usize) -> usize {
    let start = Instant::now();
    let hits = hits::<T>(balls, rays, threads);
    let each = start.elapsed().as_secs_f64() * 1e9 / rays.len() as f64;
    println!("{name:8} {threads:2} threads: {each:6.1} ns a ray, {hits} of {} hit", rays.len());
    hits
}

pub fn main() -> Result<(), raylet::Error> {
    let ball = Shape::new(Sphere::new(0.375_f32)?);
    let places = (0..1000_u16).map(|i| [i % 10, i / 10 % 10, i / 100].map(f32::from));
    let balls = places.map(|place| Ok(ball.placed(Frame::at(place.into())?)));
    let balls = balls.collect::<Result<Vec<_>, raylet::Error>>()?;
    let mut nodes = vec![Node::EMPTY; Hierarchy::<f32>::nodes_for(balls.len())];
    let balls = Shapes::new(&balls, &mut nodes)?;
    // From a point in front, spread by a golden angle.
    let rays = (0..200_000_u32).map(|i| {
        let (turn, out) = ((f64::from(i) * 2.399_963).sin_cos(), (f64::from(i) / 200_000.0).sqrt());
        let direction = UnitVec3::from_f64([turn.0 * out * 0.5, turn.1 * out * 0.5, -1.0])?;
        Ok(Ray::new(Vec3::new(4.5, 4.5, 20.0), direction)?)
    });
    let rays = rays.collect::<Result<Vec<_>, raylet::Error>>()?;
    let all = thread::available_parallelism().map_or(1, NonZero::get);
    let mut found = Vec::new();
    for threads in [1, all] {
        found.push(timed::<Plain>("Plain", balls, &rays, threads));
        found.push(timed::<Fast>("Fast", balls, &rays, threads));
        found.push(timed::<Stable>("Stable", balls, &rays, threads));
    }
    assert_eq!(found[..3], found[3..], "threads change no answer");
    Ok(())
}
