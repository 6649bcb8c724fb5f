//! Counters of the rays and tests that a picture takes.

/// Counters of the rays and tests that a picture takes. `{:?}` prints them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Counters {
    /// Rays from the eye.
    pub primary_rays: u64,
    /// Rays towards lights.
    pub shadow_rays: u64,
    /// Tests of a ray against a shape, for the nearest hit and for occlusion together.
    pub intersection_tests: u64,
    /// Tests of a ray against a box of a [`Hierarchy`](super::Hierarchy).
    pub box_tests: u64,
    /// Hits that were shaded, for which a point and a normal were computed.
    pub hits_refined: u64,
    /// Rays that a mirror reflected.
    pub reflection_rays: u64,
    /// Rays that a transparent surface refracted, and rays that it reflected although its material is no mirror.
    pub refraction_rays: u64,
    /// Texture lookups.
    pub texture_lookups: u64,
    /// Normals perturbed by waves.
    pub bumps: u64,
    /// Rays attenuated by fog.
    pub fogged_rays: u64,
    /// Pixels whose corners differed, so that their whole grid of samples was traced.
    pub refined_pixels: u64,
    /// Rays beside a pixel, which look for an outline.
    pub outline_rays: u64,
}

impl Counters {
    /// Adds the counters of another part of the work.
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
        self.outline_rays += other.outline_rays;
    }

    /// The number of all rays.
    pub const fn rays(&self) -> u64 {
        self.primary_rays + self.shadow_rays + self.reflection_rays + self.refraction_rays + self.outline_rays
    }
}
