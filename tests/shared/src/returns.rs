//! The first three returns of each zone of the range sensor: where its ray enters solids of the yard, in order.

use crate::digest::{Bits, Digest};
use crate::range_sensor::{SOLIDS, ZONES, ray, solid};
use heapless::Vec;
use raylet::solids::{Crossings, CrossingsError, List, Start};
use raylet::{Crossing, Ray, Scalar, Shape, Tier};

/// Returns of a zone, at most.
pub const RETURNS: usize = 3;

/// The solids of the yard.
pub type Yard<S> = Vec<Shape<S>, SOLIDS>;

/// All crossings of a zone: no zone meets more than sixteen solids.
pub type OfZone<S> = Crossings<S, 32, 2>;

/// The yard, solid by solid.
pub fn yard<S: Scalar>() -> Yard<S> {
    (0..SOLIDS).filter_map(solid).collect()
}

/// All crossings of a ray.
///
/// # Errors
///
/// [`CrossingsError`] if they do not fit.
pub fn crossings<S: Scalar, T: Tier<S>>(
    yard: &(impl List<S> + ?Sized),
    ray: &Ray<S>,
) -> Result<OfZone<S>, CrossingsError> {
    Crossings::with_start::<T>(yard, ray, &Start::new())
}

/// The returns of a zone: the solid and its distance.
pub fn returns<S: Scalar, T: Tier<S>>(
    yard: &(impl List<S> + ?Sized),
    column: u16,
    row: u16,
) -> Option<Vec<(u32, S), RETURNS>> {
    let Ok(crossings) = &crossings::<S, T>(yard, &ray(column, row)?) else { return None };
    let entries = crossings.iter().filter(|crossing| crossing.hit.crossing != Crossing::Exit);
    Some(entries.take(RETURNS).map(|crossing| (crossing.solid, crossing.hit.t)).collect())
}

/// The rays of all zones.
pub fn rays<S: Scalar>() -> impl Iterator<Item = Ray<S>> {
    (0..ZONES * ZONES).filter_map(|zone| ray(zone % ZONES, zone / ZONES))
}

/// A digest of all crossings of all zones.
pub fn digest<S: Scalar + Bits, T: Tier<S>>() -> u64 {
    let (yard, mut digest) = (yard::<S>(), Digest::new());
    for ray in rays() {
        let Ok(crossings) = &crossings::<S, T>(yard.as_slice(), &ray) else { continue };
        for crossing in crossings {
            digest.take(crossing.hit.t.bits());
            digest
                .take(u64::from(crossing.solid) << 16 | (crossing.hit.part as u64) << 8 | crossing.hit.crossing as u64);
            crossing.after.iter().for_each(|solid| digest.take(solid.into()));
        }
    }
    digest.bits()
}
