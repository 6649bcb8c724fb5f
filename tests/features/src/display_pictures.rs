//! The promise: the pictures of `docs/displays` are what displays show, drawn by the code that the firmware uses.
//!
//! `RAYLET_WRITE_EXPECTED=1 cargo test -p raylet-features pictures` writes them anew.

use crate::one_bit;
use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size as Area};
use embedded_graphics::pixelcolor::{BinaryColor, IntoStorage, Rgb565, RgbColor};
use fixed::types::I16F16;
use raylet::gallery::BuiltIn;
use raylet::scene::{Hierarchy, Node};
use raylet::{Scalar, TraceContext};
use shared::bounce;
use shared::turntable::{self, FRAMES, Line, NODES};

#[path = "../../../examples/one_bit.rs"]
#[expect(dead_code, reason = "its `main` prints")]
mod outlined;

/// A display that remembers its pixels.
struct Screen<C> {
    size: Area,
    pixels: Vec<C>,
    /// How many pixels were drawn.
    drawn: usize,
}

impl<C: Copy> Screen<C> {
    fn new(width: u16, height: u16, blank: C) -> Self {
        let pixels = vec![blank; usize::from(width) * usize::from(height)];
        Self { size: Area::new(width.into(), height.into()), pixels, drawn: 0 }
    }

    /// Eight-bit levels, each pixel a square of `scale` by `scale`.
    fn enlarged(&self, scale: usize, levels: impl Fn(C) -> [u8; 3]) -> Image {
        let [width, height] = [self.size.width, self.size.height].map(|side| side as usize);
        let places = (0..height * scale).flat_map(|y| (0..width * scale).map(move |x| (x / scale, y / scale)));
        let pixels = places.map(|(x, y)| levels(self.pixels[y * width + x])).collect();
        Image { width: width * scale, pixels }
    }
}

impl<C> OriginDimensions for Screen<C> {
    fn size(&self) -> Area {
        self.size
    }
}

impl<C: raylet::display::DisplayColor> DrawTarget for Screen<C> {
    type Color = C;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(Point { x, y }, color) in pixels {
            self.pixels[y as usize * self.size.width as usize + x as usize] = color;
            self.drawn += 1;
        }
        Ok(())
    }
}

struct Image {
    width: usize,
    pixels: Vec<[u8; 3]>,
}

impl Image {
    fn png(&self) -> Vec<u8> {
        let mut file = Vec::new();
        let height = self.pixels.len() / self.width;
        let mut encoder = png::Encoder::new(&mut file, self.width as u32, height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(self.pixels.as_flattened()).unwrap();
        writer.finish().unwrap();
        file
    }
}

/// Compares with a file of the repository, or writes it.
fn expect(file: &str, found: &[u8]) {
    let path = raylet_tables::in_repository(file);
    if std::env::var_os("RAYLET_WRITE_EXPECTED").is_some() {
        std::fs::write(&path, found).unwrap();
    }
    let expected = std::fs::read(&path).unwrap();
    assert!(
        found == expected,
        "{file} is no longer what is drawn; if that is meant: RAYLET_WRITE_EXPECTED=1 cargo test -p raylet-features pictures"
    );
}

/// As a display does it: the high bits once more behind the low ones.
fn levels(color: Rgb565) -> [u8; 3] {
    let (red, green, blue) = (color.r(), color.g(), color.b());
    [red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2]
}

fn black_or_white(pixel: BinaryColor) -> [u8; 3] {
    if pixel.is_on() { [255; 3] } else { [0; 3] }
}

fn frames<S: Scalar>(frames: impl IntoIterator<Item = u8>) -> Vec<Screen<Rgb565>> {
    let mut stage = BuiltIn::StillLife.build::<S>().unwrap();
    let mut nodes = [Node::EMPTY; NODES];
    let hierarchy = Hierarchy::build(&stage.objects, &mut nodes).unwrap();
    let mut line: Line = [Rgb565::BLACK; turntable::WIDTH as usize];
    let mut context = TraceContext::new(());
    let mut show = |frame| {
        let mut screen = Screen::new(turntable::WIDTH, turntable::HEIGHT, Rgb565::MAGENTA);
        stage.camera = turntable::camera(frame).unwrap();
        let scene = turntable::lit(stage.scene().unwrap()).with_hierarchy(&hierarchy).unwrap();
        let Ok(()) = turntable::show(&turntable::picture(&scene), &mut line, &mut context, &mut screen);
        assert_eq!(screen.drawn, screen.pixels.len(), "each pixel is drawn once");
        screen
    };
    frames.into_iter().map(&mut show).collect()
}

/// What went over the bus of the firmware's stand-in for a display: for each of these rows its window, then its pixels
/// (FNV-1a, 32 bits).
fn digest(screen: &Screen<Rgb565>, rows: impl IntoIterator<Item = u16>) -> u32 {
    let width = screen.size.width as u16;
    let row = |y: u16| &screen.pixels[usize::from(y) * usize::from(width)..][..usize::from(width)];
    let words = rows.into_iter().map(|y| (y, row(y))).flat_map(|(y, row)| {
        [0, y, width - 1, y].into_iter().chain(row.iter().map(|color| color.into_storage())).collect::<Vec<u16>>()
    });
    words
        .flat_map(u16::to_be_bytes)
        .fold(0x811c_9dc5, |digest, byte| (digest ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

/// Four images, two by two.
fn two_by_two(images: &[Image]) -> Image {
    let row = |left: &Image, right: &Image| {
        let lines = left.pixels.chunks(left.width).zip(right.pixels.chunks(right.width));
        lines.flat_map(|(left, right)| [left, right].concat()).collect::<Vec<_>>()
    };
    let pixels = [row(&images[0], &images[1]), row(&images[2], &images[3])].concat();
    Image { width: 2 * images[0].width, pixels }
}

/// Four frames, a quarter of a turn apart, two by two.
#[test]
fn pictures_of_the_turntable() {
    let screens = frames::<I16F16>([0, FRAMES / 4, FRAMES / 2, 3 * (FRAMES / 4)]);
    let images: Vec<_> = screens.iter().map(|screen| screen.enlarged(2, levels)).collect();
    expect("docs/displays/turntable.png", &two_by_two(&images).png());
    let screens = frames::<I16F16>([0, 1]);
    let digests = screens.iter().map(|screen| format!("{:08x}", digest(screen, 0..turntable::HEIGHT)));
    let digests = digests.collect::<Vec<_>>();
    expect("examples/firmware/expected/turntable.txt", format!("{}\n", digests.join("\n")).as_bytes());
}

/// The frames of the ball, in each of which only the rows are drawn that may have changed, are whole frames to the bit.
/// Four of them, two by two; and what the firmware sends for the first.
#[test]
fn pictures_of_the_bounce() {
    const HEIGHT: u16 = turntable::HEIGHT;
    let mut line: Line = [Rgb565::BLACK; turntable::WIDTH as usize];
    let (mut context, mut sent, mut shown, mut drawn) = (TraceContext::new(()), vec![], vec![], 0);
    let mut screen = Screen::new(turntable::WIDTH, HEIGHT, Rgb565::MAGENTA);
    for frame in 0..=bounce::FRAMES {
        let [before, now] = [frame.saturating_sub(1), frame].map(|frame| bounce::Stage::<I16F16>::of(frame).unwrap());
        let [before, now] = [before.scene(), now.scene()];
        let [before, now] = [&before, &now].map(bounce::picture);
        let mut whole = Screen::new(turntable::WIDTH, HEIGHT, Rgb565::MAGENTA);
        let Ok(_) = turntable::show_rows(&now, 0..HEIGHT, &mut line, &mut context, &mut whole);
        let rows: Vec<u16> = if frame == 0 { (0..HEIGHT).collect() } else { now.changed_rows(&before).collect() };
        let Ok(count) = turntable::show_rows(&now, rows.iter().copied(), &mut line, &mut context, &mut screen);
        assert!(screen.pixels == whole.pixels, "frame {frame}");
        assert_eq!(usize::from(count), rows.len());
        if frame > 0 {
            drawn += rows.len();
        }
        if frame < 6 {
            sent.push(format!("{:08x} {count} of {HEIGHT} rows", digest(&screen, rows)));
        }
        if [0, 4, 10, 14].contains(&frame) {
            shown.push(screen.enlarged(2, levels));
        }
    }
    println!("{drawn} of {} rows are drawn", usize::from(bounce::FRAMES) * usize::from(HEIGHT));
    expect("docs/displays/bounce.png", &two_by_two(&shown).png());
    expect("examples/firmware/expected/bounce.txt", format!("{}\n", sent.join("\n")).as_bytes());
}

#[test]
fn a_turn_comes_back_to_where_it_began_and_shows_something_else_in_between() {
    let screens = frames::<f32>([0, 1, FRAMES / 2, FRAMES]);
    assert!(screens[0].pixels == screens[3].pixels);
    assert!(screens[0].pixels != screens[1].pixels && screens[1].pixels != screens[2].pixels);
    for (frame, fixed) in frames::<I16F16>([0, 1, FRAMES / 2]).into_iter().enumerate() {
        let differ = fixed.pixels.iter().zip(&screens[frame].pixels).filter(|(a, b)| a != b).count();
        assert!(differ < fixed.pixels.len() / 100, "frame {frame}: {differ} pixels of I16F16 are not those of f32");
    }
}

/// The share of the pixels of a kind that are on.
#[derive(Clone, Copy, Default)]
struct Share {
    on: u32,
    all: u32,
}

impl Share {
    fn add(&mut self, is_on: bool) {
        self.on += u32::from(is_on);
        self.all += 1;
    }

    fn get(self) -> f64 {
        f64::from(self.on) / f64::from(self.all.max(1))
    }
}

/// Every solid stands out against the floor, and has shades: what it is can be told. (Whether it looks so is for the
/// eye: the document shows it.)
#[test]
fn pictures_of_one_bit() {
    const BALL: usize = 5;
    let stage = one_bit::stage().unwrap();
    let scene = one_bit::lit(stage.scene().unwrap());
    let picture = one_bit::picture(&scene);
    let mut screen = Screen::new(one_bit::WIDTH, one_bit::HEIGHT, BinaryColor::Off);
    let Ok(_) = picture.draw(Point::zero(), &mut screen);

    let (mut shares, mut of_ball) = ([Share::default(); 14], vec![]);
    let mut context = TraceContext::new(());
    for y in 0..one_bit::HEIGHT {
        for (x, pixel) in (0_u16..).zip(picture.row(y, &mut context)) {
            let is_on = screen.pixels[usize::from(y) * usize::from(one_bit::WIDTH) + usize::from(x)].is_on();
            let Some((object, _)) = pixel.seen else { continue };
            shares[object as usize].add(is_on);
            if object as usize == BALL {
                of_ball.push(is_on);
            }
        }
    }
    let [floor, solids @ ..] = shares;
    assert!(floor.get() > 0.9, "the floor is white: {}", floor.get());
    // Of the pyramid two sides are seen.
    let seen = solids.iter().filter(|share| share.all >= 20);
    assert!(seen.clone().count() >= 11, "{} solids are seen", seen.count());
    for (object, share) in solids.iter().enumerate().filter(|(_, share)| share.all >= 20) {
        assert!((0.1..0.85).contains(&share.get()), "object {}: {}", object + 1, share.get());
    }
    // In the order of rows: the lamps are above.
    let share = |pixels: &[bool]| pixels.iter().filter(|is_on| **is_on).count() as f64 / pixels.len() as f64;
    let (upper, lower) = of_ball.split_at(of_ball.len() / 2);
    let [upper, lower] = [share(upper), share(lower)];
    assert!(upper > lower + 0.05, "the ball is as bright above ({upper}) as below ({lower})");

    expect("docs/displays/one-bit.png", &screen.enlarged(4, black_or_white).png());
}

/// The example `one_bit`: nothing but a line and some shade tells its things from the floor.
#[test]
fn pictures_of_outlines() {
    let pages = outlined::draw().unwrap();
    let mut screen = Screen::new(one_bit::WIDTH, one_bit::HEIGHT, BinaryColor::Off);
    for (index, pixel) in screen.pixels.iter_mut().enumerate() {
        let [x, y] = [index % usize::from(one_bit::WIDTH), index / usize::from(one_bit::WIDTH)];
        *pixel = (pages[y / 8][x] >> (y % 8) & 1 == 1).into();
    }
    expect("docs/displays/outline.png", &screen.enlarged(4, black_or_white).png());
}
