//! A picture on a Raspberry Pi Pico with an ST7735 display of 128 by 160 pixels, in `I16F16`. Wiring: docs/boards.md.
#![no_std]
#![no_main]

#[path = "../../scene.rs"]
mod scene;

use embedded_graphics_core::geometry::Point;
use embedded_hal::spi::MODE_0;
use embedded_hal_bus::spi::ExclusiveDevice;
use fixed::types::I16F16;
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7735s;
use mipidsi::options::{Orientation, Rotation};
use panic_halt as _;
use rp2040_hal::clocks::{Clock, init_clocks_and_plls};
use rp2040_hal::fugit::RateExtU32;
use rp2040_hal::gpio::{FunctionSpi, Pins};
use rp2040_hal::{Sio, Spi, Timer, Watchdog, pac};

/// The second-stage boot loader, for the Pico's flash chip.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// The Pico's crystal.
const CRYSTAL: u32 = 12_000_000;

#[rp2040_hal::entry]
fn main() -> ! {
    let mut chip = pac::Peripherals::take().expect("nothing has taken them before");
    let mut watchdog = Watchdog::new(chip.WATCHDOG);
    let (pll_sys, pll_usb) = (chip.PLL_SYS, chip.PLL_USB);
    let clocks =
        init_clocks_and_plls(CRYSTAL, chip.XOSC, chip.CLOCKS, pll_sys, pll_usb, &mut chip.RESETS, &mut watchdog);
    let clocks = clocks.ok().expect("the crystal runs");
    let mut timer = Timer::new(chip.TIMER, &mut chip.RESETS, &clocks);
    let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, Sio::new(chip.SIO).gpio_bank0, &mut chip.RESETS);

    let wires = (pins.gpio19.into_function::<FunctionSpi>(), pins.gpio18.into_function::<FunctionSpi>());
    let clock = clocks.peripheral_clock.freq();
    let bus = Spi::<_, _, _, 8>::new(chip.SPI0, wires).init(&mut chip.RESETS, clock, 16.MHz(), MODE_0);
    let device = ExclusiveDevice::new(bus, pins.gpio17.into_push_pull_output(), timer).expect("a pin cannot fail");
    let mut buffer = [0; 320];
    let interface = SpiInterface::new(device, pins.gpio16.into_push_pull_output(), &mut buffer);
    let display = Builder::new(ST7735s, interface)
        .reset_pin(pins.gpio20.into_push_pull_output())
        .display_size(128, 160)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut timer);
    let mut display = display.ok().expect("the display is wired");

    scene::with_picture::<I16F16, _>(|picture| picture.draw(Point::zero(), &mut display).is_ok());
    loop {
        core::hint::spin_loop();
    }
}
