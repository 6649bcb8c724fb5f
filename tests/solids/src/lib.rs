//! Many solids along one ray: their order beside exact arithmetic, the set of solids inside, and rays that are followed
//! from crossing to crossing.

#![cfg(test)]

mod crowd;
mod following;
mod order;
