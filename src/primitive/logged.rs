//! Primitives as they are logged with `defmt`: by the constructor's name and the sizes.

use super::{Capsule, Cone, Cuboid, Cylinder, Disc, Plane, Rectangle, Sphere, Triangle};
use crate::outline::{Extent, Outline};
use crate::scalar::Scalar;
use crate::scalar::written::Plain;
use defmt::{Format, Formatter, write};

impl<S: Scalar> Format for Sphere<S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Sphere {{ radius: {} }}", Plain(self.radius()));
    }
}

impl<S: Scalar> Format for Disc<S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Disc {{ radius: {} }}", Plain(self.radius()));
    }
}

impl<S: Scalar> Format for Plane<S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Plane");
    }
}

impl<S: Scalar> Format for Capsule<S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Capsule {{ radius: {}, height: {} }}", Plain(self.radius()), Plain(self.height()));
    }
}

impl<S: Scalar> Format for Cuboid<S> {
    fn format(&self, f: Formatter<'_>) {
        let [x, y, z] = self.half_extents().map(Plain);
        write!(f, "Cuboid {{ half_extents: [{}, {}, {}] }}", x, y, z);
    }
}

impl<S: Scalar> Format for Rectangle<S> {
    fn format(&self, f: Formatter<'_>) {
        let [x, z] = self.half_extents().map(Plain);
        write!(f, "Rectangle {{ half_extents: [{}, {}] }}", x, z);
    }
}

impl<S: Scalar> Format for Triangle<S> {
    fn format(&self, f: Formatter<'_>) {
        let [a, b, c] = self.vertices();
        write!(f, "Triangle {{ vertices: [{}, {}, {}] }}", a, b, c);
    }
}

impl<S: Scalar> Format for Cylinder<S> {
    fn format(&self, f: Formatter<'_>) {
        let radius = Plain(self.radius());
        match self.extent {
            Extent::Double | Extent::Infinite => write!(f, "Cylinder {{ radius: {}, infinite }}", radius),
            Extent::Open(height) => {
                write!(f, "Cylinder {{ radius: {}, height: {}, open }}", radius, Plain(height));
            }
            Extent::Capped(height) => {
                write!(f, "Cylinder {{ radius: {}, height: {}, capped }}", radius, Plain(height));
            }
        }
    }
}

impl<S: Scalar> Format for Cone<S> {
    fn format(&self, f: Formatter<'_>) {
        match self.outline {
            Outline::Slope(slope) => write!(f, "Cone {{ slope: {}, ", Plain(slope)),
            Outline::Radii(base, top, _) => write!(f, "Cone {{ radii: [{}, {}], ", Plain(base), Plain(top)),
        }
        match self.extent {
            Extent::Double => write!(f, "double }}"),
            Extent::Infinite => write!(f, "nappe }}"),
            Extent::Open(height) => write!(f, "height: {}, open }}", Plain(height)),
            Extent::Capped(height) => write!(f, "height: {}, capped }}", Plain(height)),
        }
    }
}
