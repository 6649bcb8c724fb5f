//! The queries of a primitive by itself.

/// Gives a primitive the queries of an unplaced, two-sided shape as methods of its own.
macro_rules! queries {
    ($Primitive:ident) => {
        impl<S: Scalar> $Primitive<S> {
            /// All hits, sorted by `t`.
            pub fn hits(&self, ray: &crate::ray::Ray<S>) -> crate::hit::Hits<S> {
                self.hits_at::<crate::tier::Stable>(ray)
            }
            /// All hits, in a chosen accuracy tier.
            pub fn hits_at<T: crate::tier::Tier<S>>(&self, ray: &crate::ray::Ray<S>) -> crate::hit::Hits<S> {
                crate::query::hits::<S, T, _, _>(self, &crate::line::InWorld, ray)
            }
            /// The hit with the smallest `t`.
            pub fn nearest(&self, ray: &crate::ray::Ray<S>) -> Option<crate::hit::Hit<S>> {
                self.nearest_at::<crate::tier::Stable>(ray)
            }
            /// The hit with the smallest `t`, in a chosen accuracy tier.
            pub fn nearest_at<T: crate::tier::Tier<S>>(&self, ray: &crate::ray::Ray<S>) -> Option<crate::hit::Hit<S>> {
                crate::query::nearest::<S, T, _, _>(self, &crate::line::InWorld, ray, crate::query::Reported::ALL)
            }
            /// True if there is any hit.
            pub fn occludes(&self, ray: &crate::ray::Ray<S>) -> bool {
                self.occludes_at::<crate::tier::Stable>(ray)
            }
            /// True if there is any hit, in a chosen accuracy tier.
            pub fn occludes_at<T: crate::tier::Tier<S>>(&self, ray: &crate::ray::Ray<S>) -> bool {
                crate::query::occludes::<S, T, _, _>(self, &crate::line::InWorld, ray, crate::query::Reported::ALL)
            }
            /// True if the point belongs to the primitive: inside or on a solid, on an open surface.
            pub fn contains(&self, point: Vec3<S>) -> bool {
                self.contains_at::<crate::tier::Stable>(point)
            }
            /// True if the point belongs to the primitive, in a chosen accuracy tier.
            pub fn contains_at<T: crate::tier::Tier<S>>(&self, point: Vec3<S>) -> bool {
                T::contains(self, &crate::line::InWorld, point)
            }
        }
    };
}
pub(crate) use queries;
