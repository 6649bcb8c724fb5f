//! A range sensor with 8 by 8 zones among twelve obstacles in flash, in fixed point: prints the distance and the
//! obstacle of each zone, and what a zone takes.
#![no_std]
#![no_main]

use core::hint::black_box;
use fixed::types::I16F16;
use raylet::sensor::{Bounded, Obstacles, Reading, Search, Try};
use raylet::{Error, Fast, Ray, Stable};
use raylet_firmware::footprint::Footprint;
use raylet_firmware::{clock, stack};
use semihosting::println;
use shared::sensor::{OBSTACLES, RAYS, Row, ZONES, sensor, zones};

type Readings<const N: usize> = [[Reading<I16F16, N>; ZONES as usize]; ZONES as usize];

/// All zones by one search, with up to `N` returns each, and the instructions of a zone.
#[inline(never)]
fn scan<T: Search<I16F16>, const N: usize, O: Obstacles<I16F16>, R: Iterator<Item = Ray<I16F16>> + Clone>(
    obstacles: impl Fn(u8, u8) -> O,
    rays: impl Fn(u8, u8) -> R,
) -> Result<(Readings<N>, u64), Error> {
    let sensor = sensor()?;
    let (readings, instructions) = counted(|| {
        core::array::from_fn(|row| {
            core::array::from_fn(|column| {
                let (column, row) = (column as u8, row as u8);
                sensor.read_at::<T, N>(&obstacles(column, row), rays(column, row), 0)
            })
        })
    });
    Ok((readings, instructions / u64::from(ZONES) / u64::from(ZONES)))
}

/// A result, and the instructions that it takes.
fn counted<A>(work: impl FnOnce() -> A) -> (A, u64) {
    let start = clock::instructions();
    let result = black_box(work());
    (result, clock::instructions() - start)
}

fn all() -> Result<(), Error> {
    let list = black_box(&OBSTACLES);
    let (bounded, bounding) = counted(|| Bounded::new(list));
    let zones = zones()?;
    let (seen, seeing) = counted(|| bounded.seen_by(&zones));
    let (fan, making) = counted(|| zones.fan::<RAYS>());
    let fan = fan?;

    let in_zone = |column, row| seen.in_zone(column, row);
    let (of_zones, of_fan) = (|column, row| zones.rays(column, row), |column, row| fan.rays(column, row));
    let (readings, stable) = scan::<Stable, 1, _, _>(in_zone, of_fan)?;
    for row in &readings {
        println!("{}", Row(row));
    }
    println!("instructions: bounds {bounding}, as seen from a place {seeing}, fan of rays {making}; a zone");
    for (name, (again, taken)) in [
        ("Stable, bounds, fan", (readings.clone(), stable)),
        ("Fast, bounds, fan", scan::<Fast, 1, _, _>(in_zone, of_fan)?),
        ("first numbers of Fast, bounds, fan", scan::<Try<Fast>, 1, _, _>(in_zone, of_fan)?),
        ("first numbers of Fast, bounds", scan::<Try<Fast>, 1, _, _>(in_zone, of_zones)?),
        ("first numbers of Fast", scan::<Try<Fast>, 1, _, _>(|_, _| &list[..], of_zones)?),
    ] {
        println!("  {name}: {taken}{}", if again == readings { "" } else { ", with other readings" });
    }
    let (_, taken) = scan::<Stable, 3, _, _>(in_zone, of_fan)?;
    println!("  Stable, bounds, fan, up to three returns: {taken}");
    let finer = zones.with_rays(2);
    let fan = finer.fan::<{ 4 * RAYS }>()?;
    let (_, taken) = scan::<Stable, 1, _, _>(in_zone, |column, row| fan.rays(column, row))?;
    println!("  Stable, bounds, fan, four rays a zone: {taken}");
    Ok(())
}

fn run() -> ! {
    clock::start();
    stack::paint();
    if let Err(error) = all() {
        println!("{error}");
    }
    println!("{} bytes of stack, {}", stack::used(), Footprint::of_this_program());
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
