//! The value types go to other crates and come back the same: `mint`, `serde`, `defmt`.

use fixed::types::{I2F30, I2F62, I12F20, I16F16, I32F32};
use raylet::{
    Affine, Annulus, Bounds, Capsule, Cone, Crossing, Cuboid, Cylinder, Departure, Disc, Frame, FrameError, HalfSpace,
    Hit, Hits, Leaving, Part, Placement, Plane, Polyhedron, Primitive, Prism, Range, Ray, RayError, Rectangle,
    Revolved, RoundCone, RoundedCuboid, Scalar, Shape, Sphere, Torus, Triangle, Tube, UnitVec3, ValueError, Vec3,
    Visible,
};
use serde::{Serialize, de::DeserializeOwned};

/// Through JSON and back, and through a format that people do not read.
pub(crate) fn round_trip<T: Serialize + DeserializeOwned + PartialEq + std::fmt::Debug>(value: &T) {
    let text = serde_json::to_string(value).expect("every value can be written");
    let back: T = serde_json::from_str(&text).expect("what was written can be read");
    assert_eq!(&back, value, "{text}");
    let bytes = postcard::to_stdvec(value).expect("every value can be written");
    let back: T = postcard::from_bytes(&bytes).expect("what was written can be read");
    assert_eq!(&back, value, "{bytes:?}");
}

#[test]
fn serde_brings_every_value_type_back() {
    round_trip(&Vec3::new(1.0_f32, -0.0, 1e-30));
    round_trip(&Vec3::new(I16F16::from_bits(1), I16F16::MAX, I16F16::MIN));
    round_trip(&UnitVec3::new(Vec3::new(1.0_f64, 2.0, 3.0)).expect("it has a length"));
    round_trip(&UnitVec3::<I16F16>::new(Vec3::new(I16F16::ONE, I16F16::ONE, I16F16::ZERO)).expect("it has a length"));
    let range = Range::new(-1.5_f32, 2.0).expect("in order");
    round_trip(&range);
    let departure = Departure { object: 7, part: Part::Top, leaving: Leaving::Inwards };
    round_trip(&departure);
    let ray = Ray::new(Vec3::new(0.0_f32, 1.0, 2.0), UnitVec3::Z).expect("inside the budget");
    round_trip(&ray);
    round_trip(&ray.with_range(range).departing(departure));
    round_trip(&Hit { t: 1.25_f32, part: Part::Side, crossing: Crossing::Touch });
    round_trip(&Bounds { low: Vec3::new(0.0_f32, 0.0, 0.0), high: Vec3::new(1.0, 1.0, 1.0) });
    for visible in [Visible::Both, Visible::Outside, Visible::Inside] {
        round_trip(&visible);
    }
}

/// Every primitive, by every constructor.
fn primitives<S: Scalar>() -> Vec<Primitive<S>> {
    let n = |value: f64| S::from_f64(value).expect("a number of the type");
    let corner = |x, y, z| Vec3::from_f64([x, y, z]).expect("numbers of the type");
    let third = n(1.0 / 3.0);
    vec![
        Sphere::new(third).expect("a size").into(),
        Disc::new(S::BUDGET.smallest_size).expect("a size").into(),
        Plane::new().into(),
        Cuboid::new(third, n(0.7), n(1.5)).expect("sizes").into(),
        Rectangle::new(third, n(0.7)).expect("sizes").into(),
        Triangle::new(corner(0.1, 0.2, 0.3), corner(1.0, 0.0, 0.0), corner(0.0, 1.0, 0.7)).expect("corners").into(),
        Capsule::new(third, S::ZERO).expect("sizes").into(),
        Cylinder::infinite(third).expect("a size").into(),
        Cylinder::open(third, S::BUDGET.size).expect("sizes").into(),
        Cylinder::capped(third, n(0.7)).expect("sizes").into(),
        Cone::double(third).expect("a slope").into(),
        Cone::nappe(third).expect("a slope").into(),
        Cone::open(third, n(0.7)).expect("sizes").into(),
        Cone::capped(third, n(0.7)).expect("sizes").into(),
        Cone::frustum_open(third, S::ZERO, n(0.7)).expect("sizes").into(),
        Cone::frustum(third, n(0.1), n(0.7)).expect("sizes").into(),
        Tube::new(third, n(0.7), n(0.9)).expect("sizes").into(),
        Torus::new(n(0.7), third).expect("sizes").into(),
        RoundCone::new(third, n(0.7), n(0.9)).expect("sizes").into(),
        RoundedCuboid::new(third, S::ZERO, n(0.7), n(0.1)).expect("sizes").into(),
        Annulus::new(third, n(0.7)).expect("sizes").into(),
        Prism::new(vec![[third, S::ZERO], [S::ZERO, n(-0.7)], [n(-0.9), third]].leak(), n(0.7))
            .expect("corners")
            .into(),
        Polyhedron::within(
            corner(-0.1, -0.2, -0.3),
            corner(0.4, 0.5, 0.6),
            vec![HalfSpace::new(corner(0.1, 0.2, 0.3), corner(1.0, -0.3, 0.7)).expect("a normal")].leak(),
        )
        .expect("a box")
        .into(),
        Revolved::paraboloid(third, n(0.7)).expect("sizes").into(),
        Revolved::hyperboloid(third, n(0.7), [n(-0.3), n(0.9)]).expect("sizes").open().into(),
    ]
}

fn shapes_come_back<S: Scalar>() {
    let position = Vec3::from_f64([0.1, -2.3, 4.7]).expect("numbers of the type");
    let leaning = UnitVec3::from_f64([1.0, 2.0, -3.0]).expect("it has a length");
    let frames = [
        Frame::at(position).expect("near"),
        Frame::from_base_and_axis(position, leaning).expect("near"),
        Frame::looking(position, UnitVec3::X, leaning).expect("near"),
    ];
    let scale = Vec3::from_f64([0.01, 1.7, 90.0]).expect("numbers of the type");
    let axes =
        [[1.0, 0.1, 0.0], [0.0, 0.3, 0.2], [-0.5, 0.0, 7.0]].map(|axis| Vec3::from_f64(axis).expect("in the type"));
    let affines = [Affine::stretched(frames[1], scale), Affine::new(position, axes)].map(|a| a.expect("a volume"));
    let placements =
        [Placement::World].into_iter().chain(frames.map(Placement::from)).chain(affines.map(Placement::from));
    for placement in placements {
        round_trip(&placement);
        for primitive in primitives::<S>() {
            round_trip(&primitive);
            for visible in [Visible::Both, Visible::Outside, Visible::Inside] {
                round_trip(&Shape::new(primitive).placed(placement).seen_from(visible));
            }
        }
    }
}

/// A shape of chosen kinds is written as one of any kind, and only what is among its kinds is read.
#[test]
fn serde_reads_no_kind_that_is_not_chosen() {
    type Few = Shape<f32, (Sphere<f32>, Frame<f32>)>;
    let (ball, frame) = (Sphere::new(2.0_f32).expect("a size"), Frame::at(Vec3::ZERO).expect("near"));
    round_trip(&Few::of(ball).placed(frame));
    let any = serde_json::to_string(&Shape::new(ball).placed(frame)).expect("every value can be written");
    assert_eq!(serde_json::to_string(&Few::of(ball).placed(frame)).expect("every value can be written"), any);
    let refused = |shape: Shape<f32>| {
        let text = serde_json::to_string(&shape).expect("every value can be written");
        serde_json::from_str::<Few>(&text).expect_err("it is not among the kinds").to_string()
    };
    let told =
        |kind| format!("a shape of the kinds Sphere, Frame cannot have the kind {kind}: name it among the kinds");
    assert_eq!(refused(Shape::new(Plane::new())), told("Plane"));
    let stretched = Affine::stretched(frame, Vec3::new(1.0, 2.0, 3.0)).expect("a volume");
    assert_eq!(refused(Shape::new(ball).placed(stretched)), told("Affine"));
}

/// Lists that a primitive would borrow are as long as it takes, and each item is checked.
#[test]
fn serde_reads_no_list_that_is_none() {
    let refused = |text: &str| serde_json::from_str::<Primitive<f32>>(text).expect_err("it is none").to_string();
    let corners = |count: usize| vec!["[0,0]"; count].join(",");
    let prism = |count| refused(&format!(r#"{{"Prism":{{"corners":[{}],"height":1}}}}"#, corners(count)));
    assert!(prism(2).starts_with("Prism: there are fewer than 3 corners, or more than 16"), "{}", prism(2));
    assert!(prism(17).starts_with("invalid length 17, expected a list of at most 16"), "{}", prism(17));
    let origin = r#"{"x":0,"y":0,"z":0}"#;
    let half_space = format!(r#"{{"point":{origin},"normal":{origin}}}"#);
    let high = r#"{"x":1,"y":1,"z":1}"#;
    let text = format!(r#"{{"Polyhedron":{{"low":{origin},"high":{high},"half_spaces":[{half_space}]}}}}"#);
    let told = "Polyhedron: the largest component of the normal is zero";
    assert!(refused(&text).starts_with(told), "{}", refused(&text));
}

#[test]
fn serde_brings_every_shape_back() {
    shapes_come_back::<f32>();
    shapes_come_back::<f64>();
    shapes_come_back::<I16F16>();
    shapes_come_back::<I32F32>();
    shapes_come_back::<I12F20>();
}

/// Any bits of the type, as text, and back.
#[test]
fn fixed_point_numbers_are_decimal_text_and_come_back_to_the_bit() {
    let vector = Vec3::new(I16F16::from_num(1.5), I16F16::DELTA, -I16F16::ONE);
    let text = serde_json::to_string(&vector).expect("every value can be written");
    assert_eq!(text, r#"{"x":"1.5","y":"0.00002","z":"-1"}"#);
    let mut state = 1_u64;
    let mut any = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state ^ state >> 31) as i64
    };
    for _ in 0..20_000 {
        let shift = any() as u32 % 64;
        let raw = any() >> shift;
        round_trip(&Vec3::new(I16F16::from_bits(raw as i32), I16F16::from_bits(any() as i32), I16F16::MIN));
        round_trip(&Vec3::new(I32F32::from_bits(raw), I32F32::from_bits(any()), I32F32::MAX));
        round_trip(&Vec3::new(I2F30::from_bits(raw as i32), I2F30::from_bits(any() as i32), I2F30::MAX));
        round_trip(&Vec3::new(I2F62::from_bits(raw), I2F62::from_bits(any()), I2F62::MIN));
    }
    // As people write them.
    let written = r#"{"x":1.5,"y":-2,"z":"0.25"}"#;
    let read: Vec3<I16F16> = serde_json::from_str(written).expect("numbers of the type");
    assert_eq!(read, Vec3::new(I16F16::from_num(1.5), I16F16::from_num(-2), I16F16::from_num(0.25)));
    for bad in [
        r#"{"x":"1.5x","y":0,"z":0}"#,
        r#"{"x":32768,"y":0,"z":0}"#,
        r#"{"x":1e9,"y":0,"z":0}"#,
        r#"{"x":-99999,"y":0,"z":0}"#,
    ] {
        let error = serde_json::from_str::<Vec3<I16F16>>(bad).expect_err("no number of the type");
        assert!(error.to_string().contains("expected a decimal number that the number type can hold"), "{error}");
    }
}

#[test]
fn serde_writes_a_hit_list() {
    let ray = Ray::new(Vec3::new(0.0_f32, 0.0, -3.0), UnitVec3::Z).expect("inside the budget");
    let hits: Hits<f32> = Sphere::new(1.0).expect("a size").hits(&ray);
    let text = serde_json::to_string(&hits).expect("every value can be written");
    assert!(text.contains(r#"{"t":2.0,"part":"Side","crossing":"Enter"}"#), "{text}");
}

#[test]
fn serde_carries_the_state_of_a_ray_among_solids() {
    use raylet::solids::{Crossings, SolidCrossing, SolidSet, Start};
    let balls = [2.0_f32, 1.0].map(|radius| Shape::new(Sphere::new(radius).expect("a size")));
    let ray = Ray::new(Vec3::new(0.0_f32, 0.0, -3.0), UnitVec3::Z).expect("inside the budget");
    let crossings = Crossings::<f32, 4>::of(&balls, &ray).expect("room");
    let second = crossings.iter().nth(1).expect("four crossings");
    let text = serde_json::to_string(&second).expect("every value can be written");
    assert!(text.ends_with(r#""before":[0],"after":[0,1]}"#), "{text}");
    assert_eq!(serde_json::from_str::<SolidCrossing<f32>>(&text).expect("as written"), second);
    let start = crossings.start_across(1).expect("room").leaving_out(SolidSet::EMPTY.with(31));
    let text = serde_json::to_string(&start).expect("every value can be written");
    assert_eq!(serde_json::from_str::<Start>(&text).expect("as written"), start);
    let error = serde_json::from_str::<SolidSet>("[3, 32]").expect_err("it holds 32 solids");
    let message = "invalid value: integer `32`, expected a list of solids with indices below 32";
    assert!(error.to_string().starts_with(message), "{error}");
}

#[test]
fn serde_carries_contacts() {
    use raylet::thick::{Contact, ThickRay};
    let ball = Shape::new(Sphere::new(1.0_f32).expect("a size"));
    let ray = Ray::new(Vec3::new(0.0_f32, 0.0, 3.0), -UnitVec3::Z).expect("inside the budget");
    let contact = ThickRay::new(ray, 0.5).expect("a size").contact(&ball).expect("a ball").expect("a contact");
    let text = serde_json::to_string(&contact).expect("every value can be written");
    let expected = r#"{"t":1.5,"point":{"x":0.0,"y":0.0,"z":1.0},"normal":[0.0,0.0,1.0],"overlaps":false}"#;
    assert_eq!(text, expected);
    assert_eq!(serde_json::from_str::<Contact<f32>>(&text).expect("as written"), contact);
}

/// What one number type wrote another reads, rounded to its own numbers.
#[test]
fn serde_reads_a_shape_in_another_number_type() {
    fn read<A: Scalar, B: Scalar>() -> String {
        let n = |value: f64| A::from_f64(value).expect("near");
        let frame = Frame::from_base_and_axis(Vec3::new(n(1.5), n(-0.25), n(3.0)), UnitVec3::X).expect("near");
        let shape = Shape::new(Capsule::new(n(0.5), n(2.0)).expect("sizes")).placed(frame);
        let text = serde_json::to_string(&shape).expect("every value can be written");
        let read: Shape<B> = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
        serde_json::to_string(&read).expect("every value can be written")
    }
    assert_eq!(read::<I16F16, f32>(), read::<f32, f32>());
    assert_eq!(read::<I32F32, f64>(), read::<f64, f64>());
    assert_eq!(read::<f32, I16F16>(), read::<I16F16, I16F16>());
    let words = serde_json::from_str::<Vec3<f32>>(r#"{"x":"1.5","y":"two","z":3}"#).expect_err("two is no number");
    assert!(words.to_string().starts_with(r#"invalid value: string "two", expected a number"#), "{words}");
}

/// A list on the heap, with its hierarchy, changes in place.
#[test]
fn a_tree_of_shapes_owns_a_vec() {
    use raylet::ShapeTree;
    let ball = Shape::new(Sphere::new(1.0_f32).expect("a size"));
    let at = |x: f32| ball.placed(Frame::at(Vec3::new(x, 0.0, 0.0)).expect("near"));
    let mut tree = ShapeTree::new((0..100).map(|i| at(4.0 * i as f32)).collect::<Vec<_>>()).expect("few");
    let down = |x: f32| Ray::new(Vec3::new(x, 5.0, 0.0), -UnitVec3::Y).expect("near");
    assert_eq!(tree.nearest(&down(200.0)).map(|(index, hit)| (index, hit.t)), Some((50, 4.0)));
    tree.change(50, |ball| *ball = at(1000.0));
    assert_eq!((tree.nearest(&down(200.0)), tree.nearest(&down(1000.0)).map(|(index, _)| index)), (None, Some(50)));
    assert_eq!(tree.into_list().len(), 100);
    assert!(!ShapeTree::new(Vec::<Shape<f32>>::new()).expect("few").occludes(&down(0.0)));
}

#[test]
fn serde_refuses_what_a_constructor_refuses() {
    let direction = serde_json::from_str::<UnitVec3<f32>>("[1.0, 1.0, 0.0]").expect_err("its length is not 1");
    assert!(direction.to_string().starts_with("the direction has a length that is not 1: normalise it"), "{direction}");
    let range = serde_json::from_str::<Range<f32>>("[2.0, 1.0]").expect_err("its ends are in the wrong order");
    assert!(range.to_string().starts_with(&RayError::Range.to_string()), "{range}");
    let sphere = serde_json::from_str::<Sphere<f32>>(r#"{"radius":-1}"#).expect_err("its radius is negative");
    assert!(sphere.to_string().starts_with("Sphere: the radius is negative"), "{sphere}");
    let cone = r#"{"FrustumOpen":{"base_radius":"0","top_radius":"0","height":"1"}}"#;
    let cone = serde_json::from_str::<Cone<I16F16>>(cone).expect_err("both radii are zero");
    assert!(cone.to_string().starts_with("Cone: the radius is zero"), "{cone}");
    let skew = r#"{"position":{"x":0,"y":0,"z":0},"axes":[[1,0,0],[0.6,0.8,0],[0,0,1]]}"#;
    let skew = serde_json::from_str::<Frame<f32>>(skew).expect_err("its axes are not perpendicular");
    assert!(skew.to_string().starts_with(&FrameError::Axes.to_string()), "{skew}");
    let left = r#"{"position":{"x":0,"y":0,"z":0},"axes":[[1,0,0],[0,1,0],[0,0,-1]]}"#;
    let left = serde_json::from_str::<Frame<f32>>(left).expect_err("it is left-handed");
    assert!(left.to_string().starts_with(&FrameError::Axes.to_string()), "{left}");
    for rows in [
        "[[0.5,0,0],1],[[0,0.5,0],1],[[0,0,0],1]",
        "[[0.5,0,0],1],[[0,0.5,0],1],[[0.5,0,0],1]",
        "[[0.25,0,0],1],[[0,0.5,0],1],[[0,0,0.5],1]",
        "[[0.5,0,0],1000],[[0,0.5,0],1],[[0,0,0.5],1]",
        "[[0.5,0,0],-2147483648],[[0,0.5,0],1],[[0,0,0.5],1]",
    ] {
        let affine = format!(r#"{{"position":{{"x":0,"y":0,"z":0}},"inverse":[{rows}]}}"#);
        let affine = serde_json::from_str::<Affine<f32>>(&affine).expect_err("no placement has such rows");
        assert!(affine.to_string().starts_with(&FrameError::Singular.to_string()), "{affine}");
    }
    let ray = r#"{"origin":{"x":3e38,"y":0,"z":0},"direction":[0,0,1],"range":[0,1],"departure":null}"#;
    let ray = serde_json::from_str::<Ray<f32>>(ray).expect_err("its origin is beyond the budget");
    assert!(ray.to_string().starts_with(&RayError::Origin(ValueError::BeyondBudget).to_string()), "{ray}");
}

/// A combination is stored as its leaves and its operations, and made of them again; a primitive beside combinations as
/// any other.
#[test]
fn combinations_are_made_again_of_what_is_stored() {
    use raylet::shape::combination::{LeafHit, Op};
    use raylet::{Combination, Object};
    #[derive(serde::Deserialize)]
    struct Stored {
        leaves: Vec<Shape<I16F16>>,
        operations: Vec<Op>,
    }
    let n = |x: f64| I16F16::from_num(x);
    let leaves = [Shape::new(Cuboid::new(n(1.0), n(0.7), n(1.0)).unwrap()), Shape::new(Sphere::new(n(0.9)).unwrap())];
    for combination in [Combination::union(&leaves), Combination::difference(&leaves)] {
        let combination = combination.unwrap();
        let written = serde_json::to_string(&combination).unwrap();
        let stored: Stored = serde_json::from_str(&written).unwrap();
        let again = Combination::new(&stored.leaves, &stored.operations).unwrap();
        assert_eq!((again.leaves(), again.is_subtracted(1)), (combination.leaves(), combination.is_subtracted(1)));
        assert!(again.operations().eq(combination.operations()));
        let shape = serde_json::to_string(&combination.shape()).unwrap();
        assert_eq!(shape, format!(r#"{{"combination":{written},"visible":"Both"}}"#));
        let object = serde_json::to_string(&Object::new(combination.shape(), 3)).unwrap();
        assert!(object.starts_with(&format!(r#"{{"shape":{shape},"#)), "{object}");
    }
    let beside = serde_json::to_string(&leaves[0].beside_combinations()).unwrap();
    assert_eq!(beside, serde_json::to_string(&leaves[0]).unwrap());
    let hit = Hit { t: n(1.5), part: Part::Side, crossing: Crossing::Enter };
    round_trip(&LeafHit { leaf: 3, hit });
    fn formats<T: defmt::Format>() {}
    formats::<Combination<'_, f32>>();
    formats::<LeafHit<I16F16>>();
    formats::<Op>();
    formats::<raylet::CombinationError>();
    formats::<Shape<f32, raylet::shape::kinds::Combining<'_>>>();
}

#[test]
fn mint_vectors_and_points_convert_both_ways() {
    let v = Vec3::new(1.0_f32, 2.0, 3.0);
    assert_eq!(Vec3::from(mint::Vector3::from(v)), v);
    assert_eq!(Vec3::from(mint::Point3::from(v)), v);
    assert_eq!(mint::Vector3::<f32>::from(UnitVec3::<f32>::Y), mint::Vector3 { x: 0.0, y: 1.0, z: 0.0 });
    let generic: mint::Vector3<I16F16> = Vec3::<I16F16>::ZERO.into();
    assert_eq!(generic.x, I16F16::ZERO);
}

#[test]
fn defmt_formats_every_value_type() {
    fn formats<T: defmt::Format>() {}
    formats::<Vec3<f32>>();
    formats::<UnitVec3<f32>>();
    formats::<Ray<f32>>();
    formats::<Range<f32>>();
    formats::<Departure>();
    formats::<Hit<f32>>();
    formats::<Hits<f32>>();
    formats::<Shape<f32>>();
    formats::<Hit<I16F16>>();
    formats::<Hits<I32F32>>();
    formats::<Ray<I16F16>>();
    formats::<Bounds<I16F16>>();
    formats::<Frame<I32F32>>();
    formats::<raylet::solids::SolidCrossing<I16F16>>();
    formats::<raylet::solids::SolidSet<2>>();
    formats::<raylet::solids::Start>();
    formats::<raylet::thick::ThickRay<I16F16>>();
    formats::<raylet::thick::Contact<I16F16>>();
    formats::<raylet::Ellipsoid<I16F16>>();
    formats::<raylet::Error>();
    formats::<raylet::FrameError>();
    formats::<raylet::SizeError>();
    formats::<RayError>();
}
