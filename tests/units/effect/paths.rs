use super::*;

/// The size that the documentation of [`DEPTH`] states.
#[test]
fn a_waiting_ray_takes_no_more_than_100_bytes() {
    assert!(size_of::<Segment<f32>>() <= 100, "{}", size_of::<Segment<f32>>());
    #[cfg(feature = "fixed")]
    assert!(size_of::<Segment<fixed::types::I16F16>>() <= 100);
}
