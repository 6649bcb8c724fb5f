//! Many solids along one ray: their order beside exact arithmetic, the set of solids inside, and rays that are followed
//! from crossing to crossing.

#[cfg(test)]
mod crowd;
#[cfg(test)]
mod following;
#[cfg(test)]
mod order;
#[cfg(test)]
mod queries;

/// The examples of the page are tests.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/many-solids.md")]
struct Page;
