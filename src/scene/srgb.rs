//! The transfer function of sRGB (IEC 61966-2-1:1999), with which displays and picture files store brightness, in finer
//! steps for dark levels. It is computed in integers, so that every number type has the same levels.

/// The brightness of the levels 0 to 254 in 65536ths of the brightest.
static LINEAR: [u16; 255] = {
    let (mut linear, mut level) = ([0; 255], 0);
    while level < 255 {
        linear[level] = (decoded(level as f64 / 255.0) * 65536.0 + 0.5) as u16;
        level += 1;
    }
    linear
};

/// The brightness of an encoded channel; computed by the compiler.
const fn decoded(encoded: f64) -> f64 {
    if encoded <= 0.04045 {
        return encoded / 12.92;
    }
    // The power of 2.4: the square, times its fifth root by Newton's method.
    let base = (encoded + 0.055) / 1.055;
    let square = base * base;
    let (mut root, mut steps) = (1.0, 0);
    while steps < 64 {
        let fourth = root * root * root * root;
        root -= (fourth * root - square) / (5.0 * fourth);
        steps += 1;
    }
    square * root
}

/// Steps of [`encoded`] to one of the 255 levels.
pub(crate) const STEPS: u32 = 256;

/// The encoded channel in 256ths of a level, from 65536ths of the brightest. Between two levels it is interpolated.
pub(crate) fn encoded(linear: u32) -> u32 {
    let (level, [above, whole]) = between(linear);
    level * STEPS + (above * STEPS / whole.max(1)).min(STEPS)
}

/// The nearest of the levels 0 to 255 to a channel in 65536ths of the brightest.
pub(crate) fn nearest_of_255(linear: u32) -> u32 {
    // Black is frequent, and needs no search.
    if linear == 0 {
        return 0;
    }
    let (level, [above, whole]) = between(linear);
    level + u32::from(2 * above >= whole)
}

/// The fields of channels: narrow ones for dark channels, which have more levels.
const fn field(linear: u32) -> usize {
    (match linear {
        0..0x400 => linear >> 4,
        0x400..0x2000 => 64 + (linear >> 7),
        _ => 128 + (linear >> 10),
    }) as usize
}

/// The last level that is not brighter than any channel of a field. The search from there takes half as long as one
/// among all levels.
static FIRST: [u8; field(65536) + 1] = {
    let (mut first, mut level, mut linear) = ([0; field(65536) + 1], 0, 0);
    while linear <= 65536 {
        while level < 254 && LINEAR[level + 1] as u32 <= linear {
            level += 1;
        }
        if linear == 0 || field(linear) > field(linear - 1) {
            first[field(linear)] = level as u8;
        }
        linear += 1;
    }
    first
};

/// The brightest level that is not brighter, how much brighter the channel is, and how much the next level.
fn between(linear: u32) -> (u32, [u32; 2]) {
    let first = FIRST.get(field(linear)).map_or(254, |first| usize::from(*first));
    let (mut level, mut low) = (first, LINEAR.get(first).map_or(0, |brightness| u32::from(*brightness)));
    for brightness in LINEAR.get(first + 1..).unwrap_or_default() {
        let high = u32::from(*brightness);
        if high > linear {
            return (level as u32, [linear - low, high - low]);
        }
        (level, low) = (level + 1, high);
    }
    (level as u32, [linear.saturating_sub(low), 65536 - low])
}

#[cfg(units)]
#[path = "../../tests/units/scene/srgb.rs"]
mod tests;
