//! The worst rays that `raylet-accuracy --search` climbed to, each against the limit that it once broke.

use crate::named::{assert_hits, bits, judge, line_in, ray};
use raylet::tier::Stable;
use raylet::{Crossing, Departure, Frame, Leaving, Part, UnitVec3};
use support::exact_types::Exact as Number;
use support::subject::Subject;

/// The solid, the frame's position and axes, and the ray, by their bits.
type Case<B, const N: usize> = (&'static str, [[B; 3]; N]);

/// Without a frame.
const UNPLACED_F32: [Case<u32, 2>; 5] = [
    // 18.9 units: 256 times the terms of a cone's discriminant were cancelled.
    ("cone capped", [[0x3e44_67b2, 0x3ed6_7163, 0xbf58_33f7], [0x3f17_e653, 0x3f25_ad28, 0x3ef5_0fcc]]),
    // 16.4: a and k of the quadric cancelled to an eighth and an eleventh.
    ("cone capped", [[0xc080_c3b9, 0x40cd_8179, 0xc036_9afa], [0x3f0a_42c7, 0xbf3c_9c25, 0x3ed0_4a5b]]),
    ("frustum widening", [[0x3d0f_4057, 0x3e65_e6c8, 0x3fa8_da97], [0xbf1d_d407, 0x3f17_64ed, 0xbf05_1064]]),
    // 20.7 and 19.2
    ("frustum pointed", [[0x401c_23e8, 0x40de_62cb, 0xc065_ae10], [0xbe79_be6d, 0xbf54_8e20, 0x3f00_49f7]]),
    ("frustum pointed", [[0xc087_284f, 0xc094_1328, 0xbf8c_b1fb], [0x3f25_a6b8, 0x3f40_b2a7, 0x3df8_48be]]),
];

const UNPLACED_F64: [Case<u64, 2>; 5] = [
    (
        "cone double",
        [
            [0x4011_0315_8cf7_0c3f, 0x4019_152d_5105_fde5, 0xbfb1_466a_980a_3940],
            [0xbfe5_a5a3_e9c3_1112, 0xbfe7_6a03_40ce_4f4e, 0x3fb5_71c3_a12f_cef4],
        ],
    ),
    (
        "cone capped",
        [
            [0x4008_dccd_db75_d9d8, 0x401c_a3fb_4ce0_9323, 0xc017_21fc_f401_8948],
            [0xbfd6_bd88_6d0b_9a1b, 0xbfe7_1a92_8e5a_70e2, 0x3fe2_ff8d_3afc_fa91],
        ],
    ),
    // 21.1
    (
        "frustum widening",
        [
            [0x4006_401e_07ab_7e55, 0x401c_0e79_691e_7a17, 0xbff1_3650_2d6b_372e],
            [0xbfda_c477_6bf8_09b2, 0xbfec_fdb9_eacf_f818, 0x3fb0_c387_fd63_28cc],
        ],
    ),
    (
        "frustum pointed",
        [
            [0xc010_e509_df63_8794, 0xc012_826d_2b8a_11bf, 0xbff1_963f_1203_9346],
            [0x3fe4_aec6_4077_e449, 0x3fe8_1952_77ed_ced7, 0x3fbf_7695_130c_313e],
        ],
    ),
    (
        "frustum widening",
        [
            [0xbfd9_8525_d66c_0d2b, 0x3f8b_1013_6bce_0280, 0x3fe2_26bf_9b37_0d06],
            [0x3fd7_3333_e4f2_411d, 0x3fec_4053_5740_9413, 0x3fd3_1c5c_6766_8912],
        ],
    ),
];

const TURNED_F32: [Case<u32, 6>; 4] = [
    // 22.7 units: turned, a cone's coordinates are rounded before its discriminant is.
    (
        "frustum widening",
        [
            [0x3db9_fe83, 0xbfb6_788e, 0x3fa3_71a0],
            [0x3e33_131d, 0x3f5f_0ade, 0x3eea_cf22],
            [0x3f7d_a807, 0xbf2b_0bf8, 0x3f85_30e3],
            [0x3f2b_aa3d, 0xbf3c_13eb, 0xbdd2_bb0a],
            [0x3e22_08ec, 0x3bc9_3345, 0x3f7c_c512],
            [0xbf39_8afc, 0xbf2d_aac8, 0x3df6_8501],
        ],
    ),
    // Invented: off by as much as the apex was away.
    (
        "cone double",
        [
            [0x48c2_4fe1, 0xc922_2516, 0x48fe_85f5],
            [0xbeda_27be, 0x3f36_4140, 0xbf0e_e722],
            [0x40bd_6b0f, 0x4440_a384, 0xc2a9_f2ea],
            [0xbe0f_8eab, 0x3f7c_138a, 0x3dd4_7ccc],
            [0x3f00_7b23, 0x3e24_dd0b, 0xbf59_8de9],
            [0xbf5a_7f07, 0xbd89_5a6c, 0xbf04_4a3a],
        ],
    ),
    // 24.2 units: nearly level.
    (
        "plane",
        [
            [0x4810_5b0c, 0x4903_65d5, 0xc92e_f4be],
            [0xbe26_f06d, 0xbf17_bc31, 0x3f49_eadf],
            [0xbe75_9148, 0x3ffe_11a9, 0xbcc0_a254],
            [0xbdcb_a377, 0xbf1f_9856, 0x3f46_89d0],
            [0x3e53_f7b9, 0xbf46_7ac8, 0xbf18_c0f4],
            [0x3f79_288d, 0x3dcf_44de, 0x3e53_160b],
        ],
    ),
    // 18.4: the same of a cap.
    (
        "frustum widening",
        [
            [0x3faf_201c, 0x3fcc_3f99, 0x40cb_851c],
            [0xbf28_5880, 0xbe5d_5f71, 0xbf38_c034],
            [0xc070_5d93, 0xbd80_b6cc, 0x3f34_9694],
            [0xbf32_339d, 0x3f24_12f9, 0xbea5_a60b],
            [0xbf2a_3669, 0xbecf_9bcb, 0x3f20_966b],
            [0x3e8a_ad7d, 0x3f26_dab3, 0x3f35_5990],
        ],
    ),
];

const TURNED_F64: [Case<u64, 6>; 1] = [
    // 17.2 units: .29 off the axis of the frame, 7 radii up, and next to the start.
    (
        "cylinder infinite",
        [
            [0x4005_b67d_dec8_fb22, 0x4014_8ba6_0189_3168, 0x4019_98b5_e0a2_7b34],
            [0xbfc1_1393_1c1d_a8a0, 0xbfe9_af7d_94db_6c58, 0xbfe2_9a13_8d8c_e31d],
            [0x3ff3_89bb_83c5_a207, 0xbfef_c131_678f_169d, 0x3ff5_bd5f_490c_891e],
            [0xbfed_5f90_098f_b586, 0x3fd5_d09a_4d0f_3d15, 0xbfc9_ff09_6bee_765f],
            [0x3faa_fc27_3a79_a219, 0x3fe3_961c_2a3e_e2d1, 0x3fe9_3fd5_78e8_7e58],
            [0x3fd9_2b2c_bdc8_3a6a, 0x3fe6_d590_5e5c_bc49, 0xbfe2_8db2_6a1d_f682],
        ],
    ),
];

fn assert_within<S: Number<Unit = S>>(name: &'static str, numbers: &[[S; 3]]) {
    let subject = Subject::<S>::new(name);
    let ray = ray(numbers[0], numbers[1]);
    let frame = match numbers {
        [_, _, position, axes @ ..] => {
            let [x, y, z] = [0, 1, 2].map(|i| UnitVec3::from_components(axes[i]).unwrap());
            Frame::from_left_up_forward((*position).into(), x, y, z).unwrap()
        }
        _ => Frame::at(raylet::Vec3::ZERO).unwrap(),
    };
    let line = line_in(&frame, &subject.solid, &ray);
    let shape = if numbers.len() > 2 { subject.shape.placed(frame) } else { subject.shape };
    let units = judge::<S, Stable>(&shape, &subject.solid, &line, &ray).unwrap();
    assert!(units <= 16.0, "{name} in {}: {units} units: {ray:?}", S::name());
}

#[test]
fn the_worst_rays_that_were_found_are_within_16_units() {
    for (name, bits) in UNPLACED_F32 {
        assert_within(name, &bits.map(|vector| vector.map(f32::from_bits)));
    }
    for (name, bits) in UNPLACED_F64 {
        assert_within(name, &bits.map(|vector| vector.map(f64::from_bits)));
    }
    for (name, bits) in TURNED_F32 {
        assert_within(name, &bits.map(|vector| vector.map(f32::from_bits)));
    }
    for (name, bits) in TURNED_F64 {
        assert_within(name, &bits.map(|vector| vector.map(f64::from_bits)));
    }
}

/// 22.7 units: from a cap and next to its plane, by the side's ordinary roots of the rounded start.
#[test]
fn a_ray_from_a_cap_and_along_it_leaves_by_the_side_as_promised() {
    let frustum = Subject::<f32>::new("frustum widening").shape;
    let ray = ray(bits([0xbf88_c235, 0x3fdb_5233, 0xbe72_c11f]), bits([0xbd1e_354d, 0xbc2e_51f5, 0xbf7f_cb62]));
    let ray = ray.departing(Departure { object: 0, part: Part::Top, leaving: Leaving::Inwards });
    assert_hits::<f32, Stable>(&frustum, &ray, &[(0.482_492_069_350_683_6, Part::Side, Crossing::Exit)], 16.0);
}
