//! Draws the scene on a display of `embedded-graphics`, in fixed point and in floats. The display is a stand-in that
//! passes on each pixel as it comes: to a file of the host.
#![no_std]
#![no_main]

use core::ffi::CStr;
use embedded_graphics_core::geometry::Point;
use fixed::types::I16F16;
use raylet::Scalar;
use raylet_firmware::figures::Figures;
use raylet_firmware::footprint::Footprint;
use raylet_firmware::panel::{Bus, Panel};
use raylet_firmware::{clock, stack};
use semihosting::fs::File;
use semihosting::io::{Error, Write};
use semihosting::println;
use shared::picture::{HEADER, HEIGHT, Storage, WIDTH, picture};

/// Passes the pixels on, and holds the clock while it does.
struct ToFile {
    file: File,
    next: [u16; 2],
    paused: u64,
}

impl Bus for ToFile {
    type Error = Error;

    fn window(&mut self, first: [u16; 2], last: [u16; 2]) -> Result<(), Error> {
        assert_eq!((first, last), (self.next, [WIDTH - 1, first[1]]), "rows come whole and in order");
        self.next = [0, first[1] + 1];
        Ok(())
    }

    fn pixel(&mut self, bytes: [u8; 2]) -> Result<(), Error> {
        let start = clock::instructions();
        let word = u16::from_be_bytes(bytes);
        let (red, green, blue) = (word >> 11, word >> 5 & 0x3f, word & 0x1f);
        // As a display does it: the high bits once more behind the low ones.
        let levels = [red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2];
        self.file.write_all(&levels.map(|level| level as u8))?;
        self.paused += clock::instructions() - start;
        Ok(())
    }
}

/// One picture. Its own frame, so that the stack of the other number type is not counted.
#[inline(never)]
fn show<S: Scalar>(number: &'static str, path: &CStr) {
    stack::paint();
    let mut storage = Storage::<S>::new();
    let view = storage.read().expect("the scene is well-formed and fits into its lists");
    let scene = storage.scene(&view).expect("the reader's lists fit together");
    let mut file = File::create(path).expect("the host lets a file be written");
    file.write_all(HEADER.as_bytes()).expect("the host lets it be written");
    let mut panel = Panel::new(WIDTH, HEIGHT, ToFile { file, next: [0, 0], paused: 0 });
    let start = clock::instructions();
    let counters = picture(&scene).draw(Point::new(0, 0), &mut panel).expect("the host lets it be written");
    let instructions = clock::instructions() - start - panel.bus.paused;
    let stack = stack::used();
    println!("{}", Figures { number, instructions, counters, stack, scene: size_of::<Storage<S>>() });
}

fn run() -> ! {
    clock::start();
    show::<I16F16>("I16F16", c"display-I16F16.ppm");
    show::<f32>("f32", c"display-f32.ppm");
    println!("{}", Footprint::of_this_program());
    semihosting::process::exit(0)
}

raylet_firmware::starts_with!(run);
