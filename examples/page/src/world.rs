//! Solids, rays and a view in one number type.

use crate::number::Number;
use crate::solid::{Kinds, placed};
use core::hint::black_box;
use raylet::{Camera, Crossing, Error, Frame, Hit, Ray, Scalar, Shape, Size, UnitVec3, Vec3};

/// A solid, and what places it.
struct Placed<S: Scalar> {
    shape: Shape<S, Kinds>,
    sizes: [S; 3],
    frame: Frame<S>,
}

/// Where the rays of a picture come from.
struct View<S: Scalar> {
    camera: Camera<S>,
    size: Size,
}

/// Solids, rays and a view.
pub struct World<S: Scalar> {
    solids: Vec<Placed<S>>,
    rays: Vec<Ray<S>>,
    view: Option<View<S>>,
}

impl<S: Scalar> Default for World<S> {
    fn default() -> Self {
        Self { solids: Vec::new(), rays: Vec::new(), view: None }
    }
}

/// The numbers of an answer.
pub type Answer = Vec<f64>;

fn all<const N: usize>(parts: [[f64; 3]; N]) -> Answer {
    parts.concat()
}

fn of_ray<S: Scalar>(ray: &Ray<S>) -> Answer {
    all([ray.origin().to_f64(), ray.direction().to_f64()])
}

fn of_crossing(crossing: Crossing) -> f64 {
    match crossing {
        Crossing::Enter => 0.0,
        Crossing::Exit => 1.0,
        Crossing::Touch => 2.0,
    }
}

impl<S: Number> World<S> {
    /// Takes everything away.
    pub fn clear(&mut self) {
        *self = Self::default();
    }

    /// Adds a solid by its number: sizes, base, axis.
    ///
    /// # Errors
    ///
    /// What the number type does not hold, or the library refuses.
    pub fn place(&mut self, solid: u32, [sizes, base, axis]: [[f64; 3]; 3]) -> Result<(), Error> {
        let (shape, frame) = placed(solid, sizes, base, axis)?;
        let sizes = Vec3::from_f64(sizes)?.to_array();
        self.solids.push(Placed { shape, sizes, frame });
        Ok(())
    }

    /// Adds a ray: origin, direction.
    ///
    /// # Errors
    ///
    /// What the number type does not hold, or the library refuses.
    pub fn aim(&mut self, [origin, direction]: [[f64; 3]; 2]) -> Result<(), Error> {
        // Of a direction only the ratios count. Fixed point holds more digits of a long vector than of a short one.
        let longest = direction.into_iter().fold(0.0, |longest: f64, c| longest.max(c.abs()));
        let scale = if longest > 0.0 { (13.0 - longest.log2().floor()).exp2() } else { 1.0 };
        let direction = UnitVec3::new(Vec3::from_f64(direction.map(|c| c * scale))?)?;
        self.rays.push(Ray::new(Vec3::from_f64(origin)?, direction)?);
        Ok(())
    }

    /// A view from a position to a target with +y up: by an angle in degrees, or of a height and without perspective.
    ///
    /// # Errors
    ///
    /// What the number type does not hold, or the library refuses.
    pub fn look(
        &mut self,
        [position, target]: [[f64; 3]; 2],
        angle: f64,
        height: f64,
        size: Size,
    ) -> Result<(), Error> {
        let (position, target) = (Vec3::from_f64(position)?, Vec3::from_f64(target)?);
        let up = Vec3::from_f64([0.0, 1.0, 0.0])?;
        let camera = if height > 0.0 {
            Camera::orthographic(position, target, up, S::from_f64(height)?)?
        } else {
            Camera::new(position, target, up, S::from_f64(angle)?)?
        };
        self.view = Some(View { camera, size });
        Ok(())
    }

    /// The sizes of a solid, its position and its three axes, as they are stored.
    pub fn solid(&self, index: usize) -> Option<Answer> {
        let Placed { sizes, frame, .. } = self.solids.get(index)?;
        let [x, y, z] = frame.axes().map(UnitVec3::to_f64);
        Some(all([sizes.map(S::to_f64), frame.position().to_f64(), x, y, z]))
    }

    /// All rays.
    pub fn rays(&self) -> &[Ray<S>] {
        &self.rays
    }

    /// The origin and the direction of a ray, as they are stored.
    pub fn ray(&self, ray: usize) -> Option<Answer> {
        self.rays.get(ray).map(of_ray)
    }

    /// The same of the ray through a pixel.
    pub fn ray_of_pixel(&self, pixel: [u16; 2]) -> Option<Answer> {
        let View { camera, size } = self.view.as_ref()?;
        camera.raster(*size).ray(pixel, [0, 0]).as_ref().map(of_ray)
    }

    /// All hits of a ray with a solid: of each `t`, part, crossing, point, normal.
    pub fn hits(&self, tier: u32, solid: usize, ray: usize) -> Option<Answer> {
        let (Placed { shape, .. }, ray) = (self.solids.get(solid)?, self.rays.get(ray)?);
        let of_hit = |hit: &Hit<S>| {
            let surface = shape.surface(ray, hit);
            let answer = [hit.t.to_f64(), f64::from(hit.part as u8), of_crossing(hit.crossing)];
            all([answer, surface.point().to_f64(), surface.normal().to_f64()])
        };
        Some(S::hits(shape, ray, tier).iter().flat_map(of_hit).collect())
    }

    /// All rays at the first solid, so many times: how many hits there are.
    pub fn repeated(&self, tier: u32, times: u32) -> usize {
        let Some(Placed { shape, .. }) = self.solids.first() else { return 0 };
        let hits_of = |ray| S::hits(black_box(shape), black_box(ray), tier).len();
        (0..times).flat_map(|_| self.rays.iter().map(hits_of)).sum()
    }

    /// A row of the picture: for each pixel the nearest solid or -1, `t`, and the cosine between its normal and the
    /// ray.
    pub fn row(&self, tier: u32, y: u16) -> Option<Answer> {
        let View { camera, size } = self.view.as_ref()?;
        let raster = camera.raster(*size);
        let nearest = |ray: &Ray<S>| {
            let mut best: Option<(usize, Hit<S>)> = None;
            for (index, Placed { shape, .. }) in self.solids.iter().enumerate() {
                if let Some(hit) = S::hits(shape, ray, tier).first()
                    && best.is_none_or(|(_, found)| hit.t < found.t)
                {
                    best = Some((index, *hit));
                }
            }
            best
        };
        let pixel = |x: u16| {
            let found = raster.ray([x, y], [0, 0]).and_then(|ray| Some((ray, nearest(&ray)?)));
            found.map_or([-1.0, 0.0, 0.0], |(ray, (index, hit))| {
                let cosine = self.solids[index].shape.surface(&ray, &hit).cosine();
                [index as f64, hit.t.to_f64(), cosine.to_f64()]
            })
        };
        Some((0..size.width).flat_map(pixel).collect())
    }
}
