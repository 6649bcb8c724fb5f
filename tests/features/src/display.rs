//! The promise: a display shows the picture, whole or by rows, and colours of few levels are right in the mean.

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size as Area};
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565, Rgb666, Rgb888,
    RgbColor,
};
use fixed::types::{I16F16, I32F32};
use raylet::display::DisplayColor;
use raylet::{
    Camera, Color, Frame, Light, Material, Object, Picture, Plane, Scalar, Scene, Shape, Size, Sphere, TraceContext,
    Vec3,
};

const WIDTH: u16 = 24;
const HEIGHT: u16 = 18;

/// A display that remembers its pixels, and breaks at a row if it is told to.
struct Screen<C> {
    pixels: Vec<Option<C>>,
    breaks_at: i32,
}

impl<C: Copy> Screen<C> {
    fn new() -> Self {
        Self { pixels: vec![None; usize::from(WIDTH) * usize::from(HEIGHT)], breaks_at: i32::MAX }
    }
    fn at(&self, x: u16, y: u16) -> Option<C> {
        self.pixels[usize::from(y) * usize::from(WIDTH) + usize::from(x)]
    }
}

impl<C> OriginDimensions for Screen<C> {
    fn size(&self) -> Area {
        Area::new(WIDTH.into(), HEIGHT.into())
    }
}

impl<C: DisplayColor> DrawTarget for Screen<C> {
    type Color = C;
    type Error = &'static str;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(point, color) in pixels {
            if point.y >= self.breaks_at {
                return Err("the wire is cut");
            }
            if let (Ok(x @ 0..WIDTH), Ok(y @ 0..HEIGHT)) = (u16::try_from(point.x), u16::try_from(point.y)) {
                let own = &mut self.pixels[usize::from(y) * usize::from(WIDTH) + usize::from(x)];
                assert!(own.is_none(), "drawn twice: {point}");
                *own = Some(color);
            }
        }
        Ok(())
    }
}

/// A ball on a floor.
fn with_picture<S: Scalar, T>(then: impl FnOnce(&Picture<'_, S>) -> T) -> T {
    with_samples(1, then)
}

fn with_samples<S: Scalar, T>(samples: u8, then: impl FnOnce(&Picture<'_, S>) -> T) -> T {
    let n = |value: f64| S::from_f64(value).unwrap();
    let point = |x, y, z| Vec3::new(n(x), n(y), n(z));
    let objects = [
        Object::new(Shape::new(Plane::new()), 0),
        Object::new(Shape::new(Sphere::new(n(1.0)).unwrap()).placed(Frame::at(point(0.0, 1.0, 0.0)).unwrap()), 1),
    ];
    let materials =
        [Material::matte(Color::from_f64([0.6, 0.7, 0.5])), Material::matte(Color::from_f64([0.9, 0.3, 0.2]))];
    let lights = [Light::new(point(4.0, 6.0, 5.0), n(0.9))];
    let camera = Camera::new(point(0.0, 2.0, 6.0), point(0.0, 0.8, 0.0), point(0.0, 1.0, 0.0), n(35.0)).unwrap();
    let scene = Scene::new(&objects, &materials, &lights, camera).unwrap();
    let scene = scene.with_background(Color::from_f64([0.2, 0.3, 0.4]));
    then(&Picture::new(&scene, Size::new(WIDTH, HEIGHT).with_samples(samples)))
}

fn shows_the_picture<S: Scalar, C: DisplayColor + std::fmt::Debug>() {
    with_picture::<S, _>(|picture| {
        let mut screen = Screen::<C>::new();
        let counters = picture.draw(Point::zero(), &mut screen).unwrap();
        assert_eq!(
            counters,
            picture.render(|x, y, pixel| {
                assert_eq!(screen.at(x, y), Some(C::shown(pixel.color, x, y)), "{x}, {y}");
            })
        );
    });
}

#[test]
fn a_display_shows_the_picture() {
    shows_the_picture::<f32, Rgb565>();
    shows_the_picture::<f32, Rgb888>();
    shows_the_picture::<f64, Rgb888>();
    shows_the_picture::<I16F16, Rgb565>();
    shows_the_picture::<I32F32, Rgb565>();
}

#[test]
fn eight_bits_are_the_nearest_levels() {
    for level in 0..=255_u8 {
        let channels = [level, 255 - level].map(|level| decoded(f64::from(level) / 255.0));
        let color = Color::<I16F16>::from_f64([channels[0], channels[1], 0.5]);
        assert_eq!(Rgb888::shown(color, 1, 2), Rgb888::new(level, 255 - level, 188));
    }
}

#[test]
fn rows_may_be_drawn_apart_and_in_any_order() {
    with_picture::<f32, _>(|picture| {
        let (mut whole, mut parts) = (Screen::<Rgb565>::new(), Screen::<Rgb565>::new());
        let counters = picture.draw(Point::zero(), &mut whole).unwrap();
        let (mut first, mut second) = (TraceContext::new(()), TraceContext::new(()));
        // The lower half, to a row that does not exist, before the upper one.
        picture.draw_rows(HEIGHT / 2..HEIGHT + 5, Point::zero(), &mut parts, &mut second).unwrap();
        picture.draw_rows(0..HEIGHT / 2, Point::zero(), &mut parts, &mut first).unwrap();
        assert!(whole.pixels == parts.pixels);
        first.counters.add(&second.counters);
        assert_eq!(first.counters, counters);
    });
}

#[test]
fn a_line_holds_what_a_display_shows() {
    with_picture::<I16F16, _>(|picture| {
        let mut screen = Screen::<Rgb565>::new();
        picture.draw(Point::zero(), &mut screen).unwrap();
        let mut context = TraceContext::new(());
        for y in 0..HEIGHT {
            let mut line = [Rgb565::MAGENTA; WIDTH as usize + 3];
            assert_eq!(picture.line(y, &mut line, &mut context), usize::from(WIDTH));
            for (x, color) in (0..WIDTH).zip(line) {
                assert_eq!(screen.at(x, y), Some(color));
            }
            assert_eq!(line[usize::from(WIDTH)..], [Rgb565::MAGENTA; 3], "beyond the width");
        }
        let mut short = [Rgb565::MAGENTA; 5];
        assert_eq!(picture.line(3, &mut short, &mut context), 5);
        assert_eq!(Some(short[4]), screen.at(4, 3));
        assert_eq!(picture.line(HEIGHT, &mut short, &mut context), 0, "beyond the last row");
    });
}

#[test]
fn the_corner_moves_the_picture_off_the_display_too() {
    with_picture::<f32, _>(|picture| {
        let (mut at_origin, mut moved) = (Screen::<Rgb888>::new(), Screen::<Rgb888>::new());
        picture.draw(Point::zero(), &mut at_origin).unwrap();
        let counters = picture.draw(Point::new(-5, 7), &mut moved).unwrap();
        assert_eq!(
            counters.primary_rays,
            u64::from(WIDTH - 5) * u64::from(HEIGHT - 7),
            "off the display nothing is traced"
        );
        let beside = picture.draw(Point::new(i32::from(WIDTH), 0), &mut Screen::<Rgb888>::new()).unwrap();
        assert_eq!(beside.primary_rays, 0);
        for y in 0..HEIGHT - 7 {
            for x in 0..WIDTH - 5 {
                assert_eq!(moved.at(x, y + 7), at_origin.at(x + 5, y), "{x}, {y}");
            }
        }
        assert_eq!(moved.at(0, 6), None);
        assert_eq!(moved.at(WIDTH - 5, 7), None);
    });
}

#[test]
fn a_picture_by_spans_may_lie_partly_off_the_display() {
    with_picture::<f32, _>(|picture| {
        let spans = picture.in_spans();
        for corner in [Point::zero(), Point::new(-5, -3), Point::new(9, 4), Point::new(i32::from(WIDTH), 0)] {
            let (mut one, mut other) = (Screen::<Rgb888>::new(), Screen::<Rgb888>::new());
            let whole = picture.draw(corner, &mut one).unwrap();
            let part = spans.draw(corner, &mut other).unwrap();
            for (x, y) in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))) {
                let is_same = match (one.at(x, y), other.at(x, y)) {
                    (Some(a), Some(b)) => {
                        let off = |a: u8, b: u8| a.abs_diff(b);
                        off(a.r(), b.r()).max(off(a.g(), b.g())).max(off(a.b(), b.b())) <= 1
                    }
                    (a, b) => a.is_none() && b.is_none(),
                };
                assert!(is_same, "{corner}: {x}, {y}");
            }
            assert!(part.rays() <= whole.rays(), "{corner}: {part:?}");
        }
    });
}

/// A row that begins in the middle has the corners on the left of its first pixel.
#[test]
fn an_antialiased_picture_may_lie_partly_off_the_display() {
    with_samples::<f32, _>(2, |picture| {
        let (mut at_origin, mut moved) = (Screen::<Rgb888>::new(), Screen::<Rgb888>::new());
        let whole = picture.draw(Point::zero(), &mut at_origin).unwrap();
        let part = picture.draw(Point::new(-7, -3), &mut moved).unwrap();
        for y in 3..HEIGHT {
            for x in 7..WIDTH {
                assert_eq!(moved.at(x - 7, y - 3), at_origin.at(x, y), "{x}, {y}");
            }
        }
        assert!(part.primary_rays < whole.primary_rays && part.refined_pixels > 0, "{part:?}");
    });
}

#[test]
fn what_the_display_reports_comes_back_and_the_rows_before_are_drawn() {
    with_picture::<f32, _>(|picture| {
        let mut screen = Screen::<Rgb565> { breaks_at: 7, ..Screen::new() };
        assert_eq!(picture.draw(Point::zero(), &mut screen), Err("the wire is cut"));
        assert!(screen.at(WIDTH - 1, 6).is_some() && screen.at(0, 7).is_none());
    });
}

/// The encoding of sRGB.
fn encoded(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// The inverse.
fn decoded(encoded: f64) -> f64 {
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

/// Sixteen pixels of one colour show it to a sixteenth of a level, and a level that exists is shown by each.
/// `levels_of` gives the levels of the channels, of so many above black.
fn dithers<S: Scalar, C: DisplayColor>(most: &[u8], levels_of: impl Fn(C) -> Vec<u8>) {
    dithers_what_is_encoded::<S, C>(most, levels_of, [encoded, decoded]);
}

/// The same with another encoding, and its inverse.
fn dithers_what_is_encoded<S: Scalar, C: DisplayColor>(
    most: &[u8],
    levels_of: impl Fn(C) -> Vec<u8>,
    [encoded, decoded]: [fn(f64) -> f64; 2],
) {
    for step in 0..=1000 {
        let channel = f64::from(step) / 1000.0;
        let color = Color::<S>::from_f64([channel; 3]);
        let mut sums = vec![0_u32; most.len()];
        // Anywhere on the display.
        for (x, y) in (40..44).flat_map(|x| (17..21).map(move |y| (x, y))) {
            for (sum, level) in sums.iter_mut().zip(levels_of(C::shown(color, x, y))) {
                *sum += u32::from(level);
            }
        }
        for (sum, most) in sums.into_iter().zip(most) {
            let off = f64::from(sum) / 16.0 - encoded(channel) * f64::from(*most);
            let allowed = if *most == 255 { 0.53 } else { 0.5 / 16.0 + 2e-3 };
            assert!(off.abs() <= allowed, "{channel}: {off} levels of {most} off");
        }
    }
    for level in 0..=most[0] {
        let color = Color::<S>::from_f64([decoded(f64::from(level) / f64::from(most[0])); 3]);
        for (x, y) in (0..4).flat_map(|x| (0..4).map(move |y| (x, y))) {
            assert_eq!(levels_of(C::shown(color, x, y))[0], level, "at {x}, {y}");
        }
    }
}

fn every_color<S: Scalar>() {
    fn in_color<S: Scalar, C: DisplayColor + RgbColor>() {
        dithers::<S, C>(&[C::MAX_R, C::MAX_G, C::MAX_B], |shown| vec![shown.r(), shown.g(), shown.b()]);
    }
    in_color::<S, Rgb555>();
    in_color::<S, Bgr555>();
    in_color::<S, Rgb565>();
    in_color::<S, Bgr565>();
    in_color::<S, Rgb666>();
    in_color::<S, Bgr666>();
    in_color::<S, Rgb888>();
    in_color::<S, Bgr888>();
    dithers::<S, Gray2>(&[3], |shown| vec![shown.luma()]);
    dithers::<S, Gray4>(&[15], |shown| vec![shown.luma()]);
    dithers::<S, Gray8>(&[255], |shown| vec![shown.luma()]);
    // The part of the pixels that are on is the part of the light.
    dithers_what_is_encoded::<S, BinaryColor>(&[1], |shown| vec![u8::from(shown.is_on())], [|light| light; 2]);
}

#[test]
fn few_levels_are_dithered() {
    every_color::<f32>();
    every_color::<I16F16>();
    every_color::<I32F32>();
}

/// Green is brighter than red, and red than blue (ITU-R BT.709).
#[test]
fn grey_shows_the_luminance() {
    for (channels, weight) in [([1.0, 0.0, 0.0], 0.2126), ([0.0, 1.0, 0.0], 0.7152), ([0.0, 0.0, 1.0], 0.0722)] {
        let shown = Gray8::shown(Color::<I16F16>::from_f64(channels), 0, 0);
        assert_eq!(f64::from(shown.luma()), (255.0 * encoded(weight)).round());
    }
}

/// What is brighter than the display, and darker than black.
#[test]
fn colours_beyond_the_display_are_clamped() {
    let color = Color::<f32>::from_f64([1.7, -0.5, 1.0]);
    for (x, y) in (0..4).flat_map(|x| (0..4).map(move |y| (x, y))) {
        assert_eq!(Rgb565::shown(color, x, y), Rgb565::new(31, 0, 31));
        assert_eq!(Rgb888::shown(color, x, y), Rgb888::new(255, 0, 255));
    }
}
