//! The promise: the scenes of the gallery look the same in every number type, and what is not cast for them changes no
//! level.

use fixed::types::{I16F16, I32F32};
use raylet::effect::All;
use raylet::gallery::BuiltIn;
use raylet::{Fast, Picture, Plain, Scalar, Size, Stable, Tier};

type Levels = Vec<[u8; 3]>;

/// The picture of a built-in scene and how many rays it took; with every ray cast, or only those that may matter.
fn draw<S: Scalar>(built_in: BuiltIn, size: Size, uncut: bool) -> (Levels, u64) {
    let stage = built_in.build::<S>().unwrap();
    let scene = stage.scene().unwrap();
    let picture = Picture::new(&scene, size);
    let picture = if uncut { picture.uncut() } else { picture };
    let mut levels = Vec::new();
    let counters = picture.render(|_, _, pixel| levels.push(pixel.color.to_srgb888()));
    (levels, counters.rays())
}

#[test]
fn what_is_not_cast_changes_no_level() {
    fn check<S: Scalar>(number: &str) {
        for built_in in BuiltIn::EVERY {
            for (samples, size) in [(1, Size::new(64, 48)), (2, Size::new(32, 24))] {
                let size = size.with_samples(samples);
                let (cut, rays) = draw::<S>(built_in, size, false);
                let (uncut, all_rays) = draw::<S>(built_in, size, true);
                let differing = cut.iter().zip(&uncut).filter(|(cut, uncut)| cut != uncut).count();
                let levels = cut.as_flattened().iter().zip(uncut.as_flattened());
                let farthest = levels.map(|(cut, uncut)| cut.abs_diff(*uncut)).max().unwrap_or(0);
                println!(
                    "{built_in}, {number}, {samples} samples: {rays} of {all_rays} rays, {differing} pixels differ"
                );
                // The mean of several samples is off by up to a sixteenth of a level, so that one in sixteen may be
                // rounded to the next level; fewer are, since most samples are off by far less.
                let (most, off) = if samples == 1 { (0, 0) } else { (3, 1) };
                assert!(
                    differing <= most && farthest <= off,
                    "{built_in}, {number}, {samples} samples: {differing} pixels differ, by up to {farthest}"
                );
                let sends_rays_on =
                    matches!(built_in, BuiltIn::Glass | BuiltIn::Waves | BuiltIn::Water | BuiltIn::Raystones);
                assert_eq!(rays < all_rays, sends_rays_on, "{built_in}, {number}: {rays} of {all_rays} rays");
            }
        }
    }
    check::<f32>("f32");
    check::<I16F16>("I16F16");
}

/// A cheaper tier shows the same picture, though it shades from the rounded `t`: a level more or less on some pixels of
/// fixed point, and on few of them more where light goes through glass.
#[test]
fn tiers_agree() {
    const SIZE: Size = Size::new(64, 48);
    fn in_tier<S: Scalar, T: Tier<S>>(built_in: BuiltIn) -> Levels {
        let stage = built_in.build::<S>().unwrap();
        let scene = stage.scene().unwrap().at_tier::<T>();
        let mut levels = Vec::new();
        Picture::<S, All, T>::new(&scene, SIZE).render(|_, _, pixel| levels.push(pixel.color.to_srgb888()));
        levels
    }
    fn check<S: Scalar>(number: &str, [most, most_farther]: [usize; 2]) {
        for built_in in BuiltIn::EVERY {
            let stable = in_tier::<S, Stable>(built_in);
            for (tier, levels) in [("Plain", in_tier::<S, Plain>(built_in)), ("Fast", in_tier::<S, Fast>(built_in))] {
                let off = |(a, b): (&[u8; 3], &[u8; 3])| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max();
                let off: Vec<u8> = levels.iter().zip(&stable).filter_map(off).filter(|off| *off > 0).collect();
                let farther = off.iter().filter(|off| **off > 1).count();
                println!("{built_in}, {number}, {tier}: {} pixels differ from Stable, {farther} by more", off.len());
                assert!(off.len() <= most && farther <= most_farther, "{built_in}, {number}, {tier}: {off:?}");
            }
        }
    }
    check::<f32>("f32", [0, 0]);
    check::<I16F16>("I16F16", [10, 2]);
}

/// Within one level on 99 of 100 pixels, against `f64`.
#[test]
fn number_types_agree() {
    fn beyond_a_level<S: Scalar>(built_in: BuiltIn, reference: &Levels) -> usize {
        let (levels, _) = draw::<S>(built_in, SIZE, false);
        let far = |(a, b): &(&[u8; 3], &[u8; 3])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 1);
        levels.iter().zip(reference).filter(far).count()
    }
    const SIZE: Size = Size::new(128, 96);
    println!("pixels of {} more than a level off f64", 128 * 96);
    for built_in in BuiltIn::EVERY {
        let (reference, _) = draw::<f64>(built_in, SIZE, false);
        let single = beyond_a_level::<f32>(built_in, &reference);
        let fixed = beyond_a_level::<I16F16>(built_in, &reference);
        let wide = beyond_a_level::<I32F32>(built_in, &reference);
        println!("{built_in:10} f32 {single}  I16F16 {fixed}  I32F32 {wide}");
        // What was measured; the promise is one in a hundred, 122. In glass a cylinder stands on a stretched floor:
        // which of the two is met first is decided by the last place of `t`. A highlight of the benchmark's mirror is
        // ten times as bright as white; a channel of fixed point ends at twice white, which shows in other mirrors.
        let measured = match built_in {
            BuiltIn::Glass => [7, 16, 6],
            BuiltIn::Patterns => [1, 1, 0],
            BuiltIn::Water => [0, 4, 0],
            BuiltIn::Raystones => [1, 15, 15],
            _ => [0; 3],
        };
        let found = [single, fixed, wide];
        assert!(core::iter::zip(found, measured).all(|(found, most)| found <= most), "{built_in}: {found:?}");
    }
}
