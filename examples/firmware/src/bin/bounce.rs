//! A ball bounces on a display of 160 by 128 pixels, in fixed point and in the tier `Fast`, with a line of pixels in
//! memory. Of each frame only the rows are drawn that may show something else than before. Under QEMU it draws the
//! first frames, and prints for each a digest of what went over the bus, how many rows that were, and the instructions.
#![no_std]
#![no_main]

use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use fixed::types::I16F16;
use raylet::TraceContext;
use raylet_firmware::footprint::Footprint;
use raylet_firmware::panel::{Fold, Panel};
use raylet_firmware::{clock, stack};
use semihosting::println;
use shared::bounce::{Stage, picture, show_changed};
use shared::turntable::{HEIGHT, Line, WIDTH, show_rows};

/// How many frames are drawn; firmware would go on for ever.
const DRAWN: u8 = 6;

#[inline(never)]
fn bounce() {
    stack::paint();
    let mut line: Line = [Rgb565::BLACK; WIDTH as usize];
    let mut context = TraceContext::new(());
    let mut before = Stage::<I16F16>::of(0).expect("the number type holds it");
    for frame in 0..DRAWN {
        // A real display's driver stands here in the place of `Panel`, before the loop.
        let mut display = Panel::new(WIDTH, HEIGHT, Fold::new());
        let stage = Stage::of(frame).expect("the number type holds it");
        let start = clock::instructions();
        let (scene, earlier) = (stage.scene(), before.scene());
        let (now, earlier) = (picture(&scene), picture(&earlier));
        // The first frame has none before it.
        let Ok(rows) = if frame == 0 {
            show_rows(&now, 0..HEIGHT, &mut line, &mut context, &mut display)
        } else {
            show_changed([&now, &earlier], &mut line, &mut context, &mut display)
        };
        let instructions = clock::instructions() - start;
        println!("frame {frame}: {:08x} {rows} of {HEIGHT} rows, {instructions} instructions", display.bus.digest());
        before = stage;
    }
    println!("stack {} bytes", stack::used());
}

fn run() -> ! {
    clock::start();
    bounce();
    println!("{}", Footprint::of_this_program());
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
