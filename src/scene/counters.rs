//! What was done for a picture.

/// What was done for a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Counters {
    /// Rays from the eye.
    pub primary_rays: u64,
    /// Rays towards lights.
    pub shadow_rays: u64,
    /// Questions put to a shape, nearest hit and occlusion together.
    pub intersection_tests: u64,
    /// Boxes of a [`Hierarchy`](super::Hierarchy) that a ray was asked to miss.
    pub box_tests: u64,
    /// Hits for which a point and a normal were computed.
    pub hits_refined: u64,
    /// Rays that a mirror threw back.
    pub reflection_rays: u64,
    /// Rays that went through a transparent surface, and those that it threw back although it is no mirror.
    pub refraction_rays: u64,
    /// Colours taken from a texture.
    pub texture_lookups: u64,
    /// Normals bent by waves.
    pub bumps: u64,
    /// Rays of which fog took a part.
    pub fogged_rays: u64,
    /// Pixels whose corners differ, so that their whole grid of samples was traced.
    pub refined_pixels: u64,
}

impl Counters {
    /// Adds what another part of the work cost.
    pub const fn add(&mut self, other: &Self) {
        self.primary_rays += other.primary_rays;
        self.shadow_rays += other.shadow_rays;
        self.intersection_tests += other.intersection_tests;
        self.box_tests += other.box_tests;
        self.hits_refined += other.hits_refined;
        self.reflection_rays += other.reflection_rays;
        self.refraction_rays += other.refraction_rays;
        self.texture_lookups += other.texture_lookups;
        self.bumps += other.bumps;
        self.fogged_rays += other.fogged_rays;
        self.refined_pixels += other.refined_pixels;
    }

    /// All rays.
    pub const fn rays(&self) -> u64 {
        self.primary_rays + self.shadow_rays + self.reflection_rays + self.refraction_rays
    }
}
