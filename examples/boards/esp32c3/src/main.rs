//! A picture on an ESP32-C3 with an ST7735 display of 128 by 160 pixels, in `I16F16`. Wiring: docs/boards.md.
#![no_std]
#![no_main]

#[path = "../../scene.rs"]
mod scene;

use embedded_graphics_core::geometry::Point;
use embedded_hal_bus::spi::ExclusiveDevice;
use esp_backtrace as _;
use esp_hal::clock::CpuClock;
use esp_hal::delay::Delay;
use esp_hal::gpio::{Level, Output, OutputConfig};
use esp_hal::spi::master::{Config, Spi};
use esp_hal::time::Rate;
use fixed::types::I16F16;
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7735s;
use mipidsi::options::{Orientation, Rotation};

esp_bootloader_esp_idf::esp_app_desc!();

#[esp_hal::main]
fn main() -> ! {
    let chip = esp_hal::init(esp_hal::Config::default().with_cpu_clock(CpuClock::max()));
    let mut delay = Delay::new();

    let bus = Spi::new(chip.SPI2, Config::default().with_frequency(Rate::from_mhz(16))).expect("a frequency");
    let bus = bus.with_sck(chip.GPIO6).with_mosi(chip.GPIO7);
    let select = Output::new(chip.GPIO10, Level::High, OutputConfig::default());
    let [command, reset] = [
        Output::new(chip.GPIO4, Level::Low, OutputConfig::default()),
        Output::new(chip.GPIO5, Level::High, OutputConfig::default()),
    ];
    let device = ExclusiveDevice::new_no_delay(bus, select).expect("a pin cannot fail");
    let mut buffer = [0; 320];
    let display = Builder::new(ST7735s, SpiInterface::new(device, command, &mut buffer))
        .reset_pin(reset)
        .display_size(128, 160)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut delay);
    let mut display = display.ok().expect("the display is wired");

    scene::with_picture::<I16F16, _>(|picture| picture.draw(Point::zero(), &mut display).is_ok());
    loop {
        core::hint::spin_loop();
    }
}
