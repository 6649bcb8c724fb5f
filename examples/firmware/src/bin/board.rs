//! Draws the scene on a real board, without semihosting and with nothing attached: the display is a digest of what went
//! over its bus, left in `DIGEST` for a debugger. README.md says what it must be, and how to build for each board.
//!
//! No clock is set up: the chip runs as slowly as it wakes. None of this has run on hardware.
#![no_std]
#![no_main]

#[cfg(feature = "esp32c3")]
#[path = "../../boards/esp32c3/start.rs"]
mod start;

use core::panic::PanicInfo;
use core::sync::atomic::{AtomicU32, Ordering};
use embedded_graphics_core::geometry::Point;
use fixed::types::I16F16;
use raylet_firmware::panel::{Fold, Panel};
use shared::picture::{HEIGHT, Storage, WIDTH, picture};

/// The digest of all that went to the display; 0 until the picture is finished.
#[unsafe(no_mangle)]
static DIGEST: AtomicU32 = AtomicU32::new(0);

/// What the boot ROM of the RP2040 runs first: it readies the flash chip of the Pico, a W25Q080.
#[cfg(feature = "rp2040")]
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

fn run() -> ! {
    let mut storage = Storage::<I16F16>::new();
    // A real display's driver stands here in the place of `Panel`.
    let mut display = Panel::new(WIDTH, HEIGHT, Fold::new());
    let view = storage.read().expect("the scene is well-formed and fits into its lists");
    let scene = storage.scene(&view).expect("the reader's lists fit together");
    let Ok(_) = picture(&scene).draw(Point::new(0, 0), &mut display);
    DIGEST.store(display.bus.digest(), Ordering::Relaxed);
    stay()
}

/// Stays here for a debugger to find.
fn stay() -> ! {
    loop {
        core::hint::spin_loop();
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    stay()
}

#[cfg(not(feature = "esp32c3"))]
raylet_firmware::starts_with!(run);
