//! A picture on an STM32F411 (a "Black Pill") with an ST7735 display of 128 by 160 pixels, in `f32`. Wiring:
//! docs/boards.md.
#![no_std]
#![no_main]

#[path = "../../scene.rs"]
mod scene;

use embedded_graphics_core::geometry::Point;
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7735s;
use mipidsi::options::{Orientation, Rotation};
use panic_halt as _;
use stm32f4xx_hal::pac::{CorePeripherals, Peripherals, SPI1};
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::rcc::Config;
use stm32f4xx_hal::spi::{Mode, Phase, Polarity, Spi};

#[cortex_m_rt::entry]
fn main() -> ! {
    let core = CorePeripherals::take().expect("nothing has taken them before");
    let chip = Peripherals::take().expect("nothing has taken them before");
    // The crystal of the board; the clock of the chip.
    let mut rcc = chip.RCC.freeze(Config::hse(25.MHz()).sysclk(96.MHz()));
    let mut delay = core.SYST.delay(&rcc.clocks);
    let (a, b) = (chip.GPIOA.split(&mut rcc), chip.GPIOB.split(&mut rcc));

    let mode = Mode { polarity: Polarity::IdleLow, phase: Phase::CaptureOnFirstTransition };
    let bus = Spi::new(chip.SPI1, (Some(a.pa5), SPI1::NoMiso, Some(a.pa7)), mode, 16.MHz(), &mut rcc);
    let device = ExclusiveDevice::new_no_delay(bus, a.pa4.into_push_pull_output()).expect("a pin cannot fail");
    let mut buffer = [0; 320];
    let interface = SpiInterface::new(device, b.pb0.into_push_pull_output(), &mut buffer);
    let display = Builder::new(ST7735s, interface)
        .reset_pin(b.pb1.into_push_pull_output())
        .display_size(128, 160)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut delay);
    let mut display = display.ok().expect("the display is wired");

    scene::with_picture::<f32, _>(|picture| picture.draw(Point::zero(), &mut display).is_ok());
    loop {
        core::hint::spin_loop();
    }
}
