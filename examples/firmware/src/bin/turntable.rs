//! The still life of the gallery turns on a display of 160 by 128 pixels, in fixed point, with a line of pixels in
//! memory and no frame. Under QEMU it draws two frames, and prints for each the instructions of a pixel and a digest of
//! what went over the bus.
#![no_std]
#![no_main]

use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use fixed::types::I16F16;
use raylet::TraceContext;
use raylet::gallery::BuiltIn;
use raylet::scene::{Hierarchy, Node};
use raylet_firmware::footprint::Footprint;
use raylet_firmware::panel::{Fold, Panel};
use raylet_firmware::{clock, stack};
use semihosting::println;
use shared::turntable::{self, HEIGHT, Line, NODES, WIDTH};

/// How many frames are drawn; firmware would go on for ever.
const DRAWN: u8 = 2;

#[inline(never)]
fn turn() {
    stack::paint();
    let mut stage = BuiltIn::StillLife.build::<I16F16>().expect("every number type holds it");
    let mut nodes = [Node::EMPTY; NODES];
    // The objects stay where they are: one hierarchy is enough for all frames.
    let hierarchy = Hierarchy::build(&stage.objects, &mut nodes).expect("there are nodes for fourteen objects");
    let mut line: Line = [Rgb565::BLACK; WIDTH as usize];
    let mut context = TraceContext::new(());
    for frame in 0..DRAWN {
        // A real display's driver stands here in the place of `Panel`, before the loop.
        let mut display = Panel::new(WIDTH, HEIGHT, Fold::new());
        stage.camera = turntable::camera(frame).expect("the number type holds the camera");
        let scene = turntable::lit(stage.scene().expect("the lists are those that were built"));
        let scene = scene.with_hierarchy(&hierarchy).expect("it is that of these objects");
        let start = clock::instructions();
        let Ok(()) = turntable::show(&turntable::picture(&scene), &mut line, &mut context, &mut display);
        let instructions = (clock::instructions() - start) / (u64::from(WIDTH) * u64::from(HEIGHT));
        println!("frame {frame}: {:08x}, {instructions} instructions a pixel", display.bus.digest());
    }
    println!(
        "stack {} bytes (of which scene and hierarchy {})",
        stack::used(),
        size_of_val(&stage) + size_of_val(&nodes)
    );
}

fn run() -> ! {
    clock::start();
    turn();
    println!("{}", Footprint::of_this_program());
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
