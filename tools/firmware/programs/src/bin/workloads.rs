//! Prints what users' queries cost, in instructions, a line of JSON a workload: the same lines on every run.
#![no_std]
#![no_main]

use raylet_firmware::clock;
use raylet_programs::workloads;
use semihosting::println;

fn run() -> ! {
    clock::start();
    workloads::all(&mut |row| {
        let [mean, nearly, worst] = row.instructions;
        let [gap, placed, comma, rays] =
            row.kind.map_or([""; 4], |(placed, rays)| [", ", placed.name(), ", ", rays.name()]);
        println!(
            r#"{{"of":"{}{gap}{placed}{comma}{rays}","number":"{}","tier":"{}","mean":{mean},"nearly":{nearly},"worst":{worst}}}"#,
            row.of, row.number, row.tier
        );
    });
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
