//! Faults of the attempt in double-word numbers and of the lines that it takes, each with the ray that showed it.

use crate::named::{bits, judge, line_in, ray};
use crate::random_sizes::off;
use raylet::tier::{Fast, Stable};
use raylet::{
    Affine, Capsule, Cone, Cylinder, Departure, Disc, Frame, Leaving, Part, Primitive, Range, Ray, Rectangle, Shape,
    UnitVec3, Vec3,
};
use support::subject::Subject;

fn assert_near_exact(shape: impl Into<Primitive<f32>>, frame: Option<Frame<f32>>, ray: &Ray<f32>) {
    let shape = Shape::new(shape);
    let shape = frame.map_or(shape, |frame| shape.placed(frame));
    let units = off(&shape, ray, 0.0).expect("it is hit");
    assert!(units <= 16.0, "{units} units: {ray:?} at {shape:?}");
}

fn moved(position: [f32; 3]) -> Frame<f32> {
    Frame::at(position.into()).unwrap()
}

/// 222 and 605 units: the difference of the radii was rounded, and `k` cancelled.
#[test]
fn a_ray_from_the_side_of_a_frustum_and_along_it() {
    let inwards = Departure { object: 0, part: Part::Side, leaving: Leaving::Inwards };
    for (radii, origin, along) in [
        (
            [0.025_987_58, 0.007_178_079, 0.044_316_04],
            [-0.016_970_571, 6.919_842e-9, 0.019_681_312],
            [-0.726_824_6, 0.095_302_8, -0.680_178_94],
        ),
        (
            [4.123_304_4, 0.824_391_8, 1.850_075],
            [-0.343_845_84, 0.311_305_73, 3.551_602],
            [0.965_108_04, -0.085_933_25, 0.247_349_75],
        ),
    ] {
        let [base, top, height] = radii;
        let ray = ray::<f32>(origin, along).departing(inwards);
        assert_near_exact(Cone::frustum(base, top, height).unwrap(), None, &ray);
    }
}

/// 463,000 and 173 units: squares of the direction's components underflowed.
#[test]
fn a_ray_with_very_small_components_along_a_cylinder() {
    for (radius, position, origin, along) in [
        (
            0.017_869_053,
            [1.711_087_2e-6, -2.003_596e-5, 0.046_830_21],
            [-0.005_301_84, 0.006_650_286_3, 0.043_682_963],
            [2.439_637_7e-21, -1.0, -2.269_561e-21],
        ),
        (
            1.779_382_2e-6,
            [-0.000_485_600_44, -3.545_923_7e-8, 6.880_799_6e-5],
            [-0.000_486_125_65, -5.403_236e-6, 6.946_25e-5],
            [8.920_875e-18, 1.0, 1.666_367_4e-15],
        ),
    ] {
        let ray = ray::<f32>(origin, along).with_range(Range::line());
        assert_near_exact(Cylinder::infinite(radius).unwrap(), Some(moved(position)), &ray);
    }
}

/// 312 units: of a start next to the plane only the last bits of double words were left, which a disc's crossing and a
/// rectangle's did not count.
#[test]
fn a_ray_from_next_to_a_turned_rectangle_and_along_it() {
    let axes = [
        [0.579_800_1, 0.478_842_7, 0.659_197_6],
        [0.672_783_26, -0.737_727_7, -0.055_862_293],
        [0.459_559_08, 0.475_886_08, -0.749_891_94],
    ];
    let position = [-0.003_225_650_9, -0.003_393_404_7, -0.001_964_073_4];
    let axes = axes.map(|axis| UnitVec3::from_components(axis).unwrap());
    let frame = Frame::from_axes(position.into(), axes).unwrap();
    let ray = ray::<f32>([-0.784_812_87, -0.656_673_67, -0.787_750_7], [0.459_564_2, 0.475_891_56, -0.749_885_3])
        .with_range(Range::line());
    assert_near_exact(Rectangle::new(1.635_279, 0.159_992_75).unwrap(), Some(frame), &ray);
    assert_near_exact(Disc::new(1.635_279).unwrap(), Some(frame), &ray);
}

/// 2,396 units: the height of a start next to the cap was rounded to where the cap's ball is.
#[test]
fn a_ray_from_next_to_the_cap_of_a_short_capsule() {
    let capsule = Capsule::new(45_826_704.0, 26_916_286.0).unwrap();
    let ray =
        ray::<f32>([-7_239_697.5, 70_331_400.0, -12_783_167.0], [0.009_178_434_5, -0.999_957_86, -0.000_304_942_57]);
    assert_near_exact(capsule, None, &ray);
}

fn subject(name: &'static str, position: Option<[u32; 3]>, origin: [u32; 3], along: [u32; 3]) -> f64 {
    let (subject, ray) = (Subject::<f32>::new(name), ray(bits(origin), bits(along)));
    let frame = Frame::at(position.map_or(Vec3::ZERO, |position| bits(position).into())).unwrap();
    let line = line_in(&frame, &subject.solid, &ray);
    let shape = if position.is_some() { subject.shape.placed(frame) } else { subject.shape };
    judge::<f32, Stable>(&shape, &subject.solid, &line, &ray).unwrap()
}

/// 23.5 units: the error of an end was compared with the whole of `t`.
#[test]
fn a_ray_from_the_surface_of_a_moved_nappe() {
    let units = subject(
        "cone nappe",
        Some([0xc7f7_54ae, 0x47e6_c19d, 0x48f5_8535]),
        [0xc7f7_5560, 0x47e6_c208, 0x48f5_86b3],
        [0xbf1a_cc71, 0x3f4a_5cf7, 0xbdc7_9bce],
    );
    assert!(units <= 16.0, "{units} units");
}

/// 16.4 units: several quantities cancelled a little each.
#[test]
fn a_ray_that_grazes_a_cone() {
    for name in ["cone open", "cone capped"] {
        let (origin, along) = ([0x3fd4_cfd8, 0x3fee_ac71, 0xbed8_c8ba], [0xbf2b_176d, 0xbec6_cc6c, 0x3f22_6e10]);
        let units = subject(name, None, origin, along);
        assert!(units <= 16.0, "{name}: {units} units");
    }
}

/// 125 units: the direction was divided by its length, which rounded it.
#[test]
fn a_ray_that_grazes_a_stretched_cone() {
    let axes = [
        [0xbf05_010a, 0x3f5a_8794, 0x3d18_68db],
        [0xbe81_9b60, 0xbde5_c01e, 0xbf75_fdc9],
        [0xbf50_ead3, 0xbf02_3723, 0x3e8c_7a63],
    ];
    let [x, y, z] = axes.map(|axis| UnitVec3::from_components(bits(axis)).unwrap());
    let frame = Frame::from_left_up_forward(bits([0x483c_102f, 0xc91e_1f98, 0x4862_a3cb]).into(), x, y, z).unwrap();
    let factors = bits([0x3f19_5cc6, 0x40fd_71ae, 0x3f0a_7583]);
    let ray = ray(bits([0x483c_0f91, 0xc91e_1fb4, 0x4862_a0de]), bits([0x3e50_01ba, 0x3e14_182e, 0x3f77_e9d8]));
    for cone in [Cone::double(0.8), Cone::nappe(0.8)] {
        let shape = Shape::new(cone.unwrap()).placed(Affine::stretched(frame, factors.into()).unwrap());
        let units = off(&shape, &ray, 0.0).expect("it is hit");
        assert!(units <= 31.0, "{units} units");
    }
}

/// 17.8 units at the far end: a part of 10^-9 was left of `a`, and of that squares of the rounding error were missing.
#[test]
fn a_ray_nearly_along_a_generator_of_a_double_cone() {
    let origin = [0.000_467_851_8, 0.000_788_919_57, -0.000_759_671_73];
    let ray = ray::<f32>(origin, [0.399_722_43, 0.724_730_1, -0.561_238_2]).with_range(Range::line());
    assert_near_exact(Cone::double(0.950_744_2).unwrap(), None, &ray);
}

/// `Fast` took the direction of a stretched line for unit, and lost its capsule.
#[test]
fn a_stretched_capsule_is_not_lost() {
    let capsule = Shape::new(Capsule::new(1.0_f32, 2.0).unwrap());
    let frame = Frame::at(Vec3::new(0.0, 0.0, 5.0)).unwrap();
    for factor in [0.001, 0.03, 30.0, 1_000.0] {
        let wide = capsule.placed(Affine::stretched(frame, Vec3::new(factor, factor, 1.0)).unwrap());
        for height in [-0.5, 0.25, 1.5, 2.75] {
            // From a thousand radii away, through the axis.
            let along = UnitVec3::new(Vec3::new(0.0, 0.0, 1.0)).unwrap();
            let ray = Ray::new(Vec3::new(0.0, height * factor, -1_000.0), along).unwrap();
            assert_eq!(wide.hits_at::<Fast>(&ray).len(), 2, "{factor}, {height}");
        }
    }
}
