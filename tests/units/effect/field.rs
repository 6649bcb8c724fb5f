use super::*;

/// Fields of every width begin where they should, in every number type.
#[test]
fn fields_divide_the_unit_interval() {
    fn check<S: Scalar>() {
        use crate::scalar::{Ring, UnitScalar};
        for count in [1_u16, 2, 3, 7, 100, 65535] {
            for step in 0..=1000_u32 {
                let at = f64::from(step) / 1000.0;
                let unit = S::Unit::from_f64(at);
                let place = unit.to_f64() * f64::from(count);
                let (index, rest) = field::<S>(unit, count);
                let expected = (place.floor() as u16).min(count - 1);
                // The product may round on to a boundary.
                let near = (place - place.round()).abs() < 0.01;
                assert!(index == expected || near, "{at} of {count}: {index} {expected}");
                let rest = S::unit_round(rest.scaled(-1)).to_f64() * 2.0;
                assert!((-1e-6..=1.0 + 1e-6).contains(&rest), "{at} of {count}: {rest}");
            }
        }
        for count in [1, 2, 3, 65535] {
            assert_eq!(field::<S>(S::Unit::ONE, count).0, count - 1, "the far edge belongs to the last");
        }
        assert_eq!(field::<S>(S::Unit::ONE, 0).0, 0);
    }
    check::<f32>();
    check::<f64>();
    #[cfg(feature = "fixed")]
    check::<fixed::types::I16F16>();
    #[cfg(feature = "fixed")]
    check::<fixed::types::I8F24>();
    #[cfg(feature = "fixed")]
    check::<fixed::types::I32F32>();
}
