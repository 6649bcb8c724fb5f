//! The promise: what is measured is what its name says, in every number type.

use fixed::types::{I16F16, I32F32};
use raylet::Scalar;
use raylet::scalar::UnitScalar;
use shared::borrowed::Borrowed;
use shared::range_sensor::{SOLIDS, ZONES, ray, solid};
use shared::workload::{PLACEMENTS, QUERIES, RAYS, Rays, SENSED, SOLIDS_BY_NAME, query, sensed};

fn the_range_sensor_sees_its_yard<S: Scalar>() {
    let solids: Vec<_> = (0..SOLIDS).filter_map(solid::<S>).collect();
    assert_eq!(solids.len(), SOLIDS);
    assert!(solid::<S>(SOLIDS).is_none());
    let (mut level, mut seeing) = (0, 0);
    for (column, row) in (0..ZONES).flat_map(|row| (0..ZONES).map(move |column| (column, row))) {
        let ray = ray::<S>(column, row).expect("within the budget");
        level += u16::from(ray.direction().to_array()[1] == S::Unit::ZERO);
        seeing += usize::from(solids.iter().any(|solid| solid.occludes(&ray)));
    }
    assert_eq!(level, ZONES, "one row of zones is level");
    assert!((32..64).contains(&seeing), "{seeing} of 64 zones see something");
    assert_eq!((0..SENSED).filter_map(sensed::<S>).count(), SENSED);
}

fn every_solid_has_its_queries<S: Borrowed>() {
    for solid in SOLIDS_BY_NAME {
        for placed in PLACEMENTS {
            for rays in RAYS {
                let queries: Vec<_> = (0..QUERIES).filter_map(|index| query::<S>(solid, placed, rays, index)).collect();
                let name = format!("{solid}, {}, {} in {}", placed.name(), rays.name(), std::any::type_name::<S>());
                assert_eq!(queries.len(), QUERIES, "{name}");
                let met = queries.iter().filter(|query| query.shape.occludes(&query.ray)).count();
                let departing = queries.iter().filter(|query| query.ray.departure().is_some()).count();
                if rays == Rays::Departing {
                    assert_eq!(departing, QUERIES, "{name}");
                } else {
                    assert_eq!(departing, 0, "{name}");
                    assert!((QUERIES / 5..QUERIES).contains(&met) || solid == "plane", "{met} hits: {name}");
                }
            }
        }
    }
}

macro_rules! in_every_type {
    ($($module:ident: $S:ty;)+) => {
        $(
            mod $module {
                use super::*;

                #[test]
                fn the_range_sensor_sees_its_yard() {
                    super::the_range_sensor_sees_its_yard::<$S>();
                }
                #[test]
                fn every_solid_has_its_queries() {
                    super::every_solid_has_its_queries::<$S>();
                }
            }
        )+
    };
}
in_every_type! {
    f32: f32;
    f64: f64;
    i16f16: I16F16;
    i32f32: I32F32;
}
