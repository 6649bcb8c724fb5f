//! Many solids along one ray: their order beside exact arithmetic, the set of solids inside, and rays that are followed
//! from crossing to crossing; light through touching and overlapping glass. Also balls that move along a ray, and
//! ellipsoids, polyhedra, prisms, quadrics of revolution, round cones, rounded cuboids, tori and tubes.

#[cfg(test)]
mod coincident;
#[cfg(test)]
mod combination_departures;
#[cfg(test)]
mod combination_hits;
#[cfg(test)]
mod combination_named;
#[cfg(test)]
mod combination_normals;
#[cfg(test)]
mod combination_recipes;
#[cfg(test)]
mod crowd;
#[cfg(test)]
mod drawn;
#[cfg(test)]
mod ellipsoid;
#[cfg(test)]
mod following;
#[cfg(test)]
mod glass;
#[cfg(test)]
mod hollow;
#[cfg(test)]
mod media;
#[cfg(test)]
mod order;
#[cfg(test)]
mod polyhedron;
#[cfg(test)]
mod prism;
#[cfg(test)]
mod queries;
#[cfg(test)]
mod random_combinations;
#[cfg(test)]
mod revolved;
#[cfg(test)]
mod round_cone;
#[cfg(test)]
mod rounded_cuboid;
#[cfg(test)]
mod thick;
#[cfg(test)]
mod torus;
#[cfg(test)]
mod values;

/// The examples of the page are tests.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/many-solids.md")]
struct Page;
