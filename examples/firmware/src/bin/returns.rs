//! A range sensor with up to three returns a zone, in fixed point: 8 by 8 zones over a yard of forty solids, with their
//! tree. Prints a zone a line, with the solid and the distance of each return, and what a zone takes.
#![no_std]
#![no_main]

use fixed::types::I16F16;
use raylet::Stable;
use raylet::hierarchy::{Hierarchy, Node, Shapes};
use raylet_firmware::footprint::Footprint;
use raylet_firmware::{clock, stack};
use semihosting::{print, println};
use shared::range_sensor::{SOLIDS, ZONES};
use shared::returns::{Yard, returns, yard};

/// The nodes of a tree of forty solids.
const NODES: usize = 2 * SOLIDS - 1;

fn run() -> ! {
    clock::start();
    stack::paint();
    let solids: Yard<I16F16> = yard();
    let mut nodes = [Node::EMPTY; NODES];
    assert!(Hierarchy::<I16F16>::nodes_for(solids.len()) <= NODES);
    let shapes = Shapes::new(&solids, &mut nodes).expect("there is a node for each");
    let (mut instructions, mut found) = (0, 0);
    for zone in 0..ZONES * ZONES {
        let (column, row) = (zone % ZONES, zone / ZONES);
        let start = clock::instructions();
        let seen = returns::<I16F16, Stable>(&shapes, column, row).expect("there is room for all crossings");
        instructions += clock::instructions() - start;
        found += seen.len();
        print!("zone {column} {row}:");
        for (solid, distance) in seen {
            print!(" {solid} at {distance},");
        }
        println!("");
    }
    println!("{found} returns, {} instructions a zone", instructions / u64::from(ZONES * ZONES));
    println!("{} bytes of stack, {}", stack::used(), Footprint::of_this_program());
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
