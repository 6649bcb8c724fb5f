//! Prints what every query costs, in instructions and in stack, a line of JSON a figure: the same lines on every run.
#![no_std]
#![no_main]

use raylet_firmware::clock;
use raylet_programs::cost;
use semihosting::println;

fn run() -> ! {
    clock::start();
    cost::all(&mut |row| {
        println!(
            r#"{{"subject":"{}","query":"{}","number":"{}","tier":"{}","of":"{}","figure":{}}}"#,
            row.subject, row.query, row.number, row.tier, row.of, row.figure
        );
    });
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
