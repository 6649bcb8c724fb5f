//! The promise: the constructors for constants accept and refuse what those at run time do, and give the same bits.

use crate::frames::{close, component};
use fixed::FixedI32;
use fixed::types::extra::{U0, U30, U31};
use fixed::types::{I16F16, I32F32};
use raylet::scalar::{Unit, UnitScalar};
use raylet::{
    Annulus, Camera, Capsule, Color, Cone, Cuboid, Cylinder, Disc, Frame, FrameError, HalfSpace, Material, Object,
    Plane, Polyhedron, Prism, Rectangle, Revolved, RoundCone, RoundedCuboid, Scalar, Shape, Size, Sphere, Torus, Tube,
    UnitVec3, Vec3, constant,
};
use shared::flash;
use std::fmt::Debug;
use support::amount::times;
use support::random::Random;

/// Sizes at the edges of the budgets and beyond, and any.
fn numbers<S: Scalar>(random: &mut Random) -> Vec<S> {
    let budget = S::BUDGET;
    let edges = [
        S::ZERO,
        S::INFINITY,
        S::ROUNDED_ONE,
        budget.coordinate,
        budget.coordinate.next_up(),
        budget.size.next_up(),
        budget.smallest_size,
        budget.slope,
        budget.slope.next_up(),
        budget.smallest_slope,
        -(-budget.smallest_slope).next_up(),
        budget.distance,
    ];
    let any = (0..8).filter_map(|_| S::from_f64(4.0_f64.powf(random.between(-4.0, 4.0))).ok());
    let mut numbers: Vec<S> = edges.into_iter().chain(any).collect();
    numbers.extend(numbers.clone().into_iter().map(|number| -number));
    numbers.extend(S::from_f64(f64::NAN).ok());
    numbers
}

/// Equal, and with the same bits: `Debug` tells a zero from a negative zero.
#[expect(clippy::needless_pass_by_value, reason = "both are results as they are made")]
fn same<T: Debug + PartialEq, E: Debug + PartialEq>(constant: Result<T, E>, at_run_time: Result<T, E>) -> bool {
    assert_eq!(format!("{constant:?}"), format!("{at_run_time:?}"));
    constant.is_ok()
}

/// How many of some results are good and how many are not.
#[derive(Default)]
struct Tally {
    good: usize,
    bad: usize,
}

impl Tally {
    fn all(&mut self, several: impl IntoIterator<Item = bool>) {
        several.into_iter().for_each(|good| self.add(good));
    }

    fn add(&mut self, is_good: bool) {
        if is_good { self.good += 1 } else { self.bad += 1 }
    }
}

/// The test of a number type: a macro, because the constructors for constants are not those of a trait.
macro_rules! of_type {
    ($test:ident, $S:ty, $($special:expr),*) => {
        #[test]
        fn $test() {
            type S = $S;
            let mut random = Random(7);
            let mut numbers = numbers::<S>(&mut random);
            numbers.extend([$($special),*] as [S; _]);
            let mut tally = Tally::default();
            for &a in &numbers {
                tally.all([
                    same(Sphere::<S>::const_new(a), Sphere::new(a)),
                    same(Disc::<S>::const_new(a), Disc::new(a)),
                    same(Cylinder::<S>::const_infinite(a), Cylinder::infinite(a)),
                    same(Cone::<S>::const_double(a), Cone::double(a)),
                    same(Cone::<S>::const_nappe(a), Cone::nappe(a)),
                ]);
                for &b in &numbers {
                    tally.all([
                        same(Capsule::<S>::const_new(a, b), Capsule::new(a, b)),
                        same(Annulus::<S>::const_new(a, b), Annulus::new(a, b)),
                        same(Torus::<S>::const_new(a, b), Torus::new(a, b)),
                        same(Rectangle::<S>::const_new(a, b), Rectangle::new(a, b)),
                        same(Cylinder::<S>::const_open(a, b), Cylinder::open(a, b)),
                        same(Cylinder::<S>::const_capped(a, b), Cylinder::capped(a, b)),
                        same(Cone::<S>::const_open(a, b), Cone::open(a, b)),
                        same(Cone::<S>::const_capped(a, b), Cone::capped(a, b)),
                    ]);
                    let c = numbers[random.below(numbers.len())];
                    tally.all([
                        same(Cuboid::<S>::const_new(a, b, c), Cuboid::new(a, b, c)),
                        same(RoundCone::<S>::const_new(a, b, c), RoundCone::new(a, b, c)),
                        same(RoundedCuboid::<S>::const_new(a, b, c, b), RoundedCuboid::new(a, b, c, b)),
                        same(Tube::<S>::const_new(a, b, c), Tube::new(a, b, c)),
                        same(Cone::<S>::const_frustum(a, b, c), Cone::frustum(a, b, c)),
                        same(Cone::<S>::const_frustum_open(a, b, c), Cone::frustum_open(a, b, c)),
                        same(Revolved::<S>::const_new(a, b, c, [b, c]), Revolved::new(a, b, c, [b, c])),
                        same(Frame::<S>::const_at(Vec3::new(a, b, c)), Frame::at(Vec3::new(a, b, c))),
                    ]);
                }
            }
            assert!(tally.good > 1000 && tally.bad > 1000, "{} and {}", tally.good, tally.bad);

            let mut tally = Tally::default();
            for round in 0..3000 {
                // Directions, some of them stretched; axes, some of them skewed or left-handed; at the edge of what is
                // taken too.
                let near = random.pick(&[0.0, 1e-9, 1e-6, 3.0e-6, 3.9e-6, 1e-3]);
                let mut nudged = |v: UnitVec3<S>| {
                    v.to_f64().map(|c| <Unit<S> as UnitScalar>::from_f64(c + near * random.between(-1.0, 1.0)))
                };
                let forward = UnitVec3::<S>::from_f64([0.3, -0.5, 0.1 + round as f64 * 1e-3]).expect("a length");
                let frame = Frame::from_base_and_axis(Vec3::ZERO, forward).expect("near");
                let axes = frame.axes().map(|axis| {
                    let components = nudged(axis);
                    let constant = UnitVec3::<S>::const_from_components(components);
                    tally.add(same(constant, UnitVec3::from_components(components)));
                    constant.unwrap_or(axis)
                });
                let mut axes = axes;
                if round % 5 == 0 {
                    axes.swap(0, round / 5 % 3);
                }
                let position = Vec3 { x: numbers[round % numbers.len()], ..Vec3::ZERO };
                tally.add(same(Frame::<S>::const_from_axes(position, axes), Frame::from_axes(position, axes)));
                assert_eq!(axes.map(|axis| axis.const_neg()), axes.map(|axis| -axis));

                let quaternion = {
                    let [x, y, z] = forward.to_f64();
                    let (sine, cosine) = (round as f64 * 0.01).sin_cos();
                    let length = 1.0 + near;
                    let unit = <Unit<S> as UnitScalar>::from_f64;
                    [x * sine, y * sine, z * sine, cosine].map(|c| unit(c * length))
                };
                let turned = Frame::<S>::from_quaternion(position, quaternion);
                match Frame::<S>::const_from_quaternion(position, quaternion) {
                    Ok(constant) => {
                        let turned = turned.expect("it is good");
                        assert_eq!(constant.position(), turned.position());
                        let limit = 8.0 * component::<S>().max(2.0_f64.powi(-53));
                        for (a, b) in constant.axes().into_iter().zip(turned.axes()) {
                            assert!(close(a.to_f64(), b.to_f64(), limit), "{constant:?} {turned:?}");
                        }
                    }
                    Err(FrameError::Quaternion) => assert!(near > 1e-7, "{quaternion:?}"),
                    Err(error) => assert_eq!(turned, Err(error)),
                }

                let number = numbers[round % numbers.len()];
                let (camera, run_time) = (Camera::<S>::const_in_frame(frame, number), Camera::in_frame(frame, number));
                assert_eq!(camera, run_time);
                let parallel = Camera::<S>::const_orthographic_in_frame(frame, number);
                assert_eq!(parallel, Camera::orthographic_in_frame(frame, number));
                for camera in [camera, parallel].into_iter().flatten() {
                    let same = if Ok(camera) == run_time {
                        Camera::in_frame(frame, number)
                    } else {
                        Camera::orthographic_in_frame(frame, number)
                    };
                    let rays = [camera, same.expect("it is good")].map(|camera| {
                        let raster = camera.raster(Size::new(7, 5));
                        [[0, 0], [3, 2], [6, 4]].map(|pixel| raster.ray(pixel, [0, 0]))
                    });
                    assert_eq!(rays[0], rays[1]);
                }
            }
            assert!(tally.good > 1000 && tally.bad > 300, "{} and {}", tally.good, tally.bad);
        }
    };
}

/// Those of what borrows a list: half-spaces, prisms and polyhedra.
macro_rules! of_lists {
    ($test:ident, $S:ty) => {
        #[test]
        fn $test() {
            type S = $S;
            let mut random = Random(0x9015);
            let numbers = numbers::<S>(&mut random);
            let [mut half_spaces, mut prisms, mut polyhedra] = [(); 3].map(|()| Tally::default());
            let up = Vec3::from_f64([0.0, 1.0, 0.0]).expect("small");
            let faces: &[HalfSpace<S>] = vec![HalfSpace::new(Vec3::ZERO, up).expect("a normal"); 17].leak();
            for _ in 0..times(2_000) {
                let [a, b, c, d, e, f] = [(); 6].map(|()| random.pick(&numbers));
                let (point, normal) = (Vec3::new(a, b, c), Vec3::new(d, e, f));
                half_spaces.add(same(HalfSpace::<S>::const_new(point, normal), HalfSpace::new(point, normal)));
                let faces = &faces[..random.pick(&[0, 1, 1, 1, 16, 17])];
                let ordered = |p: S, q: S| if q < p { [q, p] } else { [p, q] };
                let [x, y, z] = if random.below(4) > 0 {
                    [ordered(a, d), ordered(b, e), ordered(c, f)]
                } else {
                    [[a, d], [b, e], [c, f]]
                };
                let [low, high] = [0, 1].map(|i: usize| Vec3::new(x[i], y[i], z[i]));
                let built = Polyhedron::<S>::const_within(low, high, faces);
                polyhedra.add(same(built, Polyhedron::within(low, high, faces)));
                // A polygon of any numbers is seldom convex; one on an ellipse is, unless it is too flat.
                let flat = random.pick(&[1.0, 1.0, 1e-2, 1e-3, 2e-4, 1e-4, 1e-6]);
                let on_ellipse = |i: usize| {
                    let angle = i as f64;
                    [angle.cos(), -angle.sin() * flat].map(|c| <S as Scalar>::from_f64(c).expect("small"))
                };
                let corners: Vec<[S; 2]> = if random.below(4) == 0 {
                    vec![[a, b], [c, d], [e, f]]
                } else {
                    (0..random.pick(&[2, 3, 4, 5, 6, 7, 18])).map(on_ellipse).collect()
                };
                let corners = corners.leak();
                let height = if random.below(2) == 0 { a } else { up.y };
                prisms.add(same(Prism::<S>::const_new(corners, height), Prism::new(corners, height)));
            }
            for tally in [half_spaces, prisms, polyhedra] {
                assert!(tally.good > 50 && tally.bad > 50, "{} and {}", tally.good, tally.bad);
            }
        }
    };
}
of_lists!(lists_in_constants_are_those_of_run_time_f32, f32);
of_lists!(lists_in_constants_are_those_of_run_time_f64, f64);
of_lists!(lists_in_constants_are_those_of_run_time_i16f16, I16F16);
of_lists!(lists_in_constants_are_those_of_run_time_i32f32, I32F32);

of_type!(constants_are_those_of_run_time_f32, f32, f32::NAN, -0.0, f32::MIN_POSITIVE, f32::MAX);
of_type!(constants_are_those_of_run_time_f64, f64, f64::NAN, -0.0, f64::MIN_POSITIVE, f64::MAX);
of_type!(constants_are_those_of_run_time_i16f16, I16F16, I16F16::MIN, -I16F16::MAX);
of_type!(constants_are_those_of_run_time_i32f32, I32F32, I32F32::MIN, -I32F32::MAX);

#[test]
fn one_is_rounded_as_the_type_rounds_it() {
    fn check<S: Scalar>() {
        use raylet::scalar::Ring;
        assert_eq!(S::ROUNDED_ONE, S::round(<S::Real as Ring>::ONE));
    }
    check::<f32>();
    check::<f64>();
    check::<I16F16>();
    check::<I32F32>();
    check::<FixedI32<U0>>();
    check::<FixedI32<U30>>();
    check::<FixedI32<U31>>();
    check::<fixed::types::I1F63>();
    check::<fixed::types::I2F62>();
}

#[test]
fn shapes_and_objects_of_constants_are_those_of_run_time() {
    type Few = (Sphere<f32>, Plane<f32>, Frame<f32>);
    const AT: Frame<f32> = constant!(Frame::<f32>::const_at(Vec3::new(1.0, 2.0, 3.0)));
    const BALL: Shape<f32> = constant!(Sphere::<f32>::const_new(2.0)).into_shape().in_frame(AT);
    static FEW: Shape<f32, Few> = constant!(Sphere::<f32>::const_new(2.0)).into_shape().in_frame(AT);
    static MATTE: Material<f32> = Material::matte(Color::new(1.0, 0.5, 0.25)).with_mirror(0.5).with_texture(3);
    static THING: Object<f32> = Object::const_new(BALL, 1).with_top(2).with_base(3);
    let ball = Shape::new(Sphere::new(2.0).expect("a size")).placed(Frame::at(Vec3::new(1.0, 2.0, 3.0)).expect("near"));
    assert_eq!(BALL, ball);
    assert_eq!(Ok(FEW), ball.among());
    assert_eq!(THING, Object::new(ball, 1).with_top(2).with_base(3));
    assert_eq!(MATTE.diffuse, 1.0);
}

/// The scene that is all constants, and the same made at run time: what the firmware `flash` draws.
#[test]
fn a_picture_of_constants_is_that_of_the_scene_made_at_run_time() {
    fn check<S: Scalar>(constants: &flash::Constants<S>) {
        let made = flash::made::<S>().expect("its values are good");
        assert_eq!(constants.objects, made.objects);
        assert_eq!(constants.materials, made.materials);
        assert_eq!(constants.lights, made.lights);
        assert_eq!(constants.camera, made.camera);
        let pictures = [constants, &made].map(|scene| flash::digest(scene).expect("a scene"));
        assert_eq!(pictures[0], pictures[1]);
        assert!(pictures[0].seen.iter().all(|pixels| *pixels > 20), "{pictures:?}");
    }
    check(&flash::SINGLE);
    check(&flash::FIXED);
}
