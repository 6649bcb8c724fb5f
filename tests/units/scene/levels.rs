use super::*;

fn of<U: UnitScalar>(channel: f64) -> [u16; 2] {
    [Levels::Srgb, Levels::Fine].map(|levels| levels.of(U::from_f64(channel)))
}

/// Linear levels are rounded in the arithmetic of the type, which may differ half-way between two.
#[test]
fn equal_channels_have_equal_levels_in_every_number_type() {
    use crate::scalar::Numbers;
    for sixty_five_thousandth in 0..=65536 {
        // A quarter of a step more, which no type rounds.
        let channel = (f64::from(sixty_five_thousandth) + 0.25) / 65536.0;
        let levels = of::<f64>(channel);
        assert_eq!(levels, of::<f32>(channel), "{channel}");
        #[cfg(feature = "fixed")]
        assert_eq!(levels, of::<<fixed::types::I16F16 as Numbers>::Unit>(channel), "{channel}");
        #[cfg(feature = "fixed")]
        assert_eq!(levels, of::<<fixed::types::I32F32 as Numbers>::Unit>(channel), "{channel}");
    }
}

#[test]
fn what_is_no_level_is_clamped() {
    for (channel, levels) in [(-1.0, [0; 2]), (1.75, [255, 4080]), (f64::NAN, [0; 2])] {
        assert_eq!(of::<f32>(channel), levels, "{channel}");
        assert_eq!(Levels::Linear.of(channel as f32), levels[0], "{channel}");
        #[cfg(feature = "fixed")]
        assert_eq!(of::<<fixed::types::I16F16 as crate::scalar::Numbers>::Unit>(channel), levels, "{channel}");
    }
}
