//! Primitives as they are logged with `defmt`: by the constructor's name and the sizes.

use super::{
    Annulus, Capsule, Cone, Cuboid, Cylinder, Disc, Plane, Polyhedron, Prism, Rectangle, Revolved, RoundCone,
    RoundedCuboid, Sphere, Torus, Triangle, Tube,
};
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

impl<S: Scalar> Format for RoundedCuboid<S> {
    fn format(&self, f: Formatter<'_>) {
        let ([x, y, z], radius) = (self.half_extents().map(Plain), Plain(self.radius()));
        write!(f, "RoundedCuboid {{ half_extents: [{}, {}, {}], radius: {} }}", x, y, z, radius);
    }
}

impl<S: Scalar> Format for Prism<S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Prism {{ corners: [");
        for (index, [x, z]) in self.corners().iter().enumerate() {
            let separator = if index == 0 { "" } else { ", " };
            write!(f, "{}[{}, {}]", separator, Plain(*x), Plain(*z));
        }
        write!(f, "], height: {} }}", Plain(self.height()));
    }
}

impl<S: Scalar> Format for Polyhedron<S> {
    fn format(&self, f: Formatter<'_>) {
        let [low, high] = self.corners();
        write!(f, "Polyhedron {{ low: {}, high: {}, half_spaces: [", low, high);
        for (index, face) in self.half_spaces().iter().enumerate() {
            let separator = if index == 0 { "" } else { ", " };
            write!(f, "{}{}", separator, face);
        }
        write!(f, "] }}");
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

impl<S: Scalar> Format for Revolved<S> {
    fn format(&self, f: Formatter<'_>) {
        let ((a, b, r), [low, high]) = (self.coefficients(), self.heights());
        let ends = if self.is_open() { "open" } else { "capped" };
        write!(f, "Revolved {{ a: {}, b: {}, radius: {}, ", Plain(a), Plain(b), Plain(r));
        write!(f, "heights: [{}, {}], {} }}", Plain(low), Plain(high), ends);
    }
}

impl<S: Scalar> Format for RoundCone<S> {
    fn format(&self, f: Formatter<'_>) {
        let [base, top, height] = [self.base_radius(), self.top_radius(), self.height()].map(Plain);
        write!(f, "RoundCone {{ base_radius: {}, top_radius: {}, height: {} }}", base, top, height);
    }
}

impl<S: Scalar> Format for Tube<S> {
    fn format(&self, f: Formatter<'_>) {
        let [inner, outer, height] = [self.inner_radius(), self.outer_radius(), self.height()].map(Plain);
        write!(f, "Tube {{ inner_radius: {}, outer_radius: {}, height: {} }}", inner, outer, height);
    }
}

impl<S: Scalar> Format for Torus<S> {
    fn format(&self, f: Formatter<'_>) {
        let [major, minor] = [self.major_radius(), self.minor_radius()].map(Plain);
        write!(f, "Torus {{ major_radius: {}, minor_radius: {} }}", major, minor);
    }
}

impl<S: Scalar> Format for Annulus<S> {
    fn format(&self, f: Formatter<'_>) {
        let [inner, outer] = [self.inner_radius(), self.outer_radius()].map(Plain);
        write!(f, "Annulus {{ inner_radius: {}, outer_radius: {} }}", inner, outer);
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
