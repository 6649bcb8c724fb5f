use super::*;
use fixed::types::extra::U24;
use fixed::types::{I0F32, I8F24, I32F32};

#[test]
fn values_of_32_bits_return_as_they_were() {
    for raw in [0, 1, -1, 12_345_678, i32::MAX - 1, 1 - i32::MAX, i32::MAX, -i32::MAX] {
        let (value, smallest) = (I8F24::from_bits(raw), I0F32::from_bits(raw));
        assert_eq!(narrowed::<U24>(Including::exactly(value)), value);
        assert_eq!(narrowed::<U32>(Including::exactly(smallest)), smallest);
        assert_eq!(<I32F32 as Including<I8F24>>::exactly(value), value.to_num::<I32F32>());
    }
}

#[test]
fn a_wider_value_is_rounded_to_nearest_and_infinite_beyond_the_type() {
    let last = (i32::MAX as i64 - 1) << 8;
    for (wide, want) in [
        (127, 0),
        (128, 0),
        (129, 1),
        (384, 2),
        (639, 2),
        (last, i32::MAX - 1),
        (last + 127, i32::MAX - 1),
        (last + 129, i32::MAX),
        (1 << 40, i32::MAX),
        (i64::MAX - 1, i32::MAX),
        (i64::MAX, i32::MAX),
    ] {
        for sign in [1, -1] {
            let narrow = narrowed::<U24>(I32F32::from_bits(sign * wide));
            assert_eq!(narrow.to_bits() as i64, sign * want as i64, "{wide}");
        }
    }
}
