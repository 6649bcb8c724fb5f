//! The parts of a scene as they are logged with `defmt`.

use super::nff::View;
use super::{Camera, Color, Fog, Light, Material, Object, Outline, Raster, SceneHit, Texture, Waves};
use crate::scalar::Scalar;
use crate::scalar::written::Plain;
use crate::shape::kinds::Kinds;
use defmt::{Format, Formatter, write};

impl<S: Scalar> Format for Color<S> {
    fn format(&self, f: Formatter<'_>) {
        let [red, green, blue] = self.to_array().map(Plain);
        write!(f, "Color {{ red: {}, green: {}, blue: {} }}", red, green, blue);
    }
}

impl<S: Scalar> Format for Light<S> {
    fn format(&self, f: Formatter<'_>) {
        let [red, green, blue] = self.strength.map(Plain);
        let kind = if self.distant { "distant" } else { "point" };
        write!(f, "Light {{ position: {}, strength: [{}, {}, {}], {=str} }}", self.position, red, green, blue, kind);
    }
}

impl<S: Scalar> Format for Waves<S> {
    fn format(&self, f: Formatter<'_>) {
        let slope = Plain(self.slope);
        write!(f, "Waves {{ along_u: {}, along_v: {}, slope: {} }}", self.along_u, self.along_v, slope);
    }
}

impl<S: Scalar> Format for Material<S> {
    fn format(&self, f: Formatter<'_>) {
        let Self { color, diffuse, specular, shine, transmittance, refraction, mirror, texture, bump } = *self;
        write!(f, "Material {{ color: {}, diffuse: {}, specular: {}, ", color, Plain(diffuse), Plain(specular));
        write!(f, "shine: {}, transmittance: {}, ", Plain(shine), Plain(transmittance));
        write!(f, "refraction: {}, mirror: {}, ", Plain(refraction), Plain(mirror));
        write!(f, "texture: {}, bump: {} }}", texture, bump);
    }
}

impl<S: Scalar, K: Kinds> Format for Object<S, K> {
    fn format(&self, f: Formatter<'_>) {
        let Self { shape, material, base, top, smooth } = self;
        write!(f, "Object {{ shape: {}, material: {}, base: {}, ", shape, material, base);
        write!(f, "top: {}, smooth: {} }}", top, smooth);
    }
}

impl<S: Scalar> Format for Texture<'_, S> {
    fn format(&self, f: Formatter<'_>) {
        match self {
            Self::Checker { columns, rows, colors: [a, b] } => {
                write!(f, "Checker {{ columns: {}, rows: {}, colors: [{}, {}] }}", columns, rows, a, b);
            }
            Self::Stripes { along, count, colors: [a, b] } => {
                write!(f, "Stripes {{ along: {}, count: {}, colors: [{}, {}] }}", along, count, a, b);
            }
            Self::Cells { counts, colors: [a, b] } => {
                write!(f, "Cells {{ counts: {}, colors: [{}, {}] }}", counts, a, b);
            }
            // Without the pixels, which may be many.
            Self::Image { width, height, .. } => write!(f, "Image {{ width: {}, height: {} }}", width, height),
        }
    }
}

impl<S: Scalar> Format for Fog<S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Fog {{ color: {}, clarity: {} }}", self.color(), Plain(self.clarity()));
    }
}

impl<S: Scalar> Format for Outline<S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Outline {{ color: {}, width: {} }}", self.color, self.width);
    }
}

impl<S: Scalar> Format for Camera<S> {
    fn format(&self, f: Formatter<'_>) {
        // The height of its picture is a computing number; this is its value rounded to the number type.
        let half_height = Plain(S::round(self.half_height()));
        let [forward, right, up] = self.axes();
        write!(f, "Camera {{ position: {}, forward: {}, right: {}, ", self.position(), forward, right);
        write!(f, "up: {}, half_height: {}, orthographic: {} }}", up, half_height, self.is_orthographic());
    }
}

impl<S: Scalar> Format for Raster<S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Raster {{ camera: {}, size: {} }}", self.camera(), self.size());
    }
}

impl<S: Scalar> Format for SceneHit<S> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "SceneHit {{ object: {}, hit: {} }}", self.object, self.hit);
    }
}

impl<S: Scalar> Format for View<S> {
    fn format(&self, f: Formatter<'_>) {
        let Self { camera, resolution, hither, background, invisible, turned, distant } = self;
        write!(f, "View {{ camera: {}, resolution: {}, hither: {}, ", camera, resolution, Plain(*hither));
        write!(f, "background: {}, invisible: {}, ", background, invisible);
        write!(f, "turned: {}, distant: {} }}", turned, distant);
    }
}
