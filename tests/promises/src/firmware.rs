//! The promise: the same bits everywhere. A digest of every answer to a fixed set of rays, and pictures, are the same
//! on the host as the firmware gives on each chip; `.ci/measure` compares those with the same files.
//!
//! `RAYLET_WRITE_EXPECTED=1 cargo test -p raylet-promises firmware` writes the files anew.

use fixed::types::I16F16;
use raylet::{Picture, Scalar, Stable, TraceContext};
use shared::picture::Storage;
use shared::range_sensor::{SOLIDS, ZONES};
use shared::{digest, flash, picture, returns};
use std::fmt::Write;

const RENEW: &str = "the host no longer gives what is expected of the chips. If the library's answers were meant to \
                     change: RAYLET_WRITE_EXPECTED=1 cargo test -p raylet-promises firmware";

/// Compares with a file of `examples/firmware/expected`, or writes it.
fn expect(file: &str, found: &[u8]) {
    let path = support::in_repository(&format!("examples/firmware/expected/{file}"));
    if std::env::var_os("RAYLET_WRITE_EXPECTED").is_some() {
        std::fs::write(&path, found).expect("the file can be written");
    }
    let expected = std::fs::read(&path).expect("the expected file is in the repository");
    if let (Ok(found), Ok(expected)) = (str::from_utf8(found), str::from_utf8(&expected)) {
        for (found, expected) in found.lines().zip(expected.lines()) {
            assert_eq!(found, expected, "{file}: {RENEW}");
        }
    }
    assert!(found == expected, "{file}: {RENEW}");
}

#[test]
fn the_host_gives_the_bits_of_the_chips() {
    let mut text = String::new();
    digest::all(&mut |number, tier, shape, digest| {
        writeln!(text, "{number} {tier} {shape}: {digest:016x}").expect("a string takes everything");
    });
    expect("digest.txt", text.as_bytes());
}

/// The digest leaves out a zone whose crossings do not fit into its list.
#[test]
fn a_zone_of_the_sensor_has_room_for_its_crossings() {
    let yard = returns::yard::<I16F16>();
    assert_eq!(yard.len(), SOLIDS);
    let zones = (0..ZONES * ZONES).map(|zone| (zone % ZONES, zone / ZONES));
    let found = zones.map(|(column, row)| {
        returns::returns::<I16F16, Stable>(yard.as_slice(), column, row).expect("there is room").len()
    });
    // What the program `returns` prints on the chips.
    assert_eq!(found.sum::<usize>(), 117);
}

/// Hands over the picture in this number type.
fn with_picture<S: Scalar>(use_it: impl FnOnce(&Picture<'_, S>)) {
    let mut storage = Storage::<S>::new();
    let view = storage.read().expect("the scene is well-formed and there is room for it");
    assert_eq!((view.resolution, view.invisible), ([picture::WIDTH, picture::HEIGHT], 0));
    use_it(&picture::picture(&storage.scene(&view).expect("the reader's lists fit together")));
}

/// What the program `render` writes.
fn render<S: Scalar>(number: &str) {
    with_picture::<S>(|picture| {
        let mut file = picture::HEADER.as_bytes().to_vec();
        let mut context = TraceContext::new(());
        for y in 0..picture::HEIGHT {
            file.extend(picture::row(picture, y, &mut context));
        }
        assert_eq!(context.counters.primary_rays, picture::PIXELS);
        expect(&format!("picture-{number}.ppm"), &file);
    });
}

/// What the program `display` writes, five, six and five bits a channel; and the digest of what goes to a display row
/// by row, which the program `board` leaves. Made without the adapter that is tested.
fn display<S: Scalar>(number: &str) -> u32 {
    let mut digest = 0x811c_9dc5_u32;
    with_picture::<S>(|picture| {
        let mut fold = |word: u16| {
            for byte in word.to_be_bytes() {
                digest = (digest ^ u32::from(byte)).wrapping_mul(0x0100_0193);
            }
        };
        let mut file = picture::HEADER.as_bytes().to_vec();
        picture.render(|x, y, pixel| {
            if x == 0 {
                [0, y, picture::WIDTH - 1, y].into_iter().for_each(&mut fold);
            }
            let [red, green, blue] = pixel.color.to_srgb().map(u32::from);
            // Bayer's thresholds, from the bits of column and row.
            let bit = |n: u16, bit: u16| n >> bit & 1;
            let threshold = 8 * bit(x ^ y, 0) + 4 * bit(y, 0) + 2 * bit(x ^ y, 1) + bit(y, 1);
            let dithered = |encoded: u32, levels: u32| {
                let sixteenths = (encoded * 16 * levels + 65_280 / 2) / 65_280;
                (sixteenths as u16 + threshold) >> 4
            };
            let (red, green, blue) = (dithered(red, 31), dithered(green, 63), dithered(blue, 31));
            fold(red << 11 | green << 5 | blue);
            // As a display does it: the high bits once more behind the low ones.
            let levels = [red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2];
            file.extend(levels.map(|level| level as u8));
        });
        expect(&format!("display-{number}.ppm"), &file);
    });
    digest
}

#[test]
fn the_host_draws_the_pictures_of_the_chips() {
    render::<I16F16>("I16F16");
    render::<f32>("f32");
    let digest = display::<I16F16>("I16F16");
    expect("board.txt", format!("{digest:08x}\n").as_bytes());
    display::<f32>("f32");
}

/// What the program `flash` prints first.
#[test]
fn the_host_draws_the_scene_in_flash_of_the_chips() {
    let line = |number: &str, picture: flash::Digest| {
        format!("{number}: {:016x}, pixels of each object {:?}\n", picture.levels, picture.seen)
    };
    let fixed = flash::digest(&flash::FIXED).expect("a scene");
    let single = flash::digest(&flash::SINGLE).expect("a scene");
    expect("flash.txt", (line("I16F16", fixed) + &line("f32", single)).as_bytes());
}
