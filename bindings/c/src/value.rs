//! Structures of C.

use crate::number::{Number, Of};
use crate::status::{Failed, raylet_error};
use raylet::{Crossing, Hit, Part, UnitVec3, Vec3};

/// The most hits of a solid on one line.
pub const RAYLET_MOST_HITS: usize = 4;

/// The most crossings that `raylet_crossings_…` finds.
pub const RAYLET_MOST_CROSSINGS: usize = 32;

/// The most solids of which it finds them: a bit of a `uint32_t` each.
pub const RAYLET_MOST_SOLIDS: usize = 32;

/// A point, a vector of any length, or, with components in the number type's unit, a direction.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct raylet_vec3<N> {
    /// To the right.
    pub x: N,
    /// Upwards.
    pub y: N,
    /// Towards the viewer.
    pub z: N,
}

impl<N: Number> raylet_vec3<N> {
    pub(crate) fn vector(self) -> Vec3<Of<N>> {
        Vec3::new(self.x.scalar(), self.y.scalar(), self.z.scalar())
    }
    pub(crate) fn of(vector: Vec3<Of<N>>) -> Self {
        let [x, y, z] = vector.to_array().map(N::from_scalar);
        Self { x, y, z }
    }
    /// Components of a direction.
    pub(crate) fn units(self) -> [raylet::scalar::Unit<Of<N>>; 3] {
        [self.x, self.y, self.z].map(N::unit)
    }
    pub(crate) fn of_direction(direction: UnitVec3<Of<N>>) -> Self {
        let [x, y, z] = direction.to_array().map(N::from_unit);
        Self { x, y, z }
    }
}

/// The parts of a surface: `part` of a hit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub enum raylet_part {
    /// The curved side, or the whole surface of a sphere or a flat part. Rims, seams and the apex belong to it.
    RAYLET_PART_SIDE = 0,
    /// The cap or round end at the lower end of the axis; the lowest face of a cuboid or a prism.
    RAYLET_PART_BASE = 1,
    /// The cap or round end at the upper end of the axis; the highest face of a cuboid or a prism.
    RAYLET_PART_TOP = 2,
    /// The face of a cuboid at the lowest x.
    RAYLET_PART_LEFT = 3,
    /// The face of a cuboid at the highest x.
    RAYLET_PART_RIGHT = 4,
    /// The face of a cuboid at the lowest z.
    RAYLET_PART_BACK = 5,
    /// The face of a cuboid at the highest z.
    RAYLET_PART_FRONT = 6,
    /// The inner side of a tube. Its rims belong to it.
    RAYLET_PART_INNER = 7,
    /// Facet 0 of a prism or a polyhedron. Facet n is `RAYLET_PART_FACET_0 + n`, n below 16.
    RAYLET_PART_FACET_0 = 8,
}

/// How a ray crosses a surface: `crossing` of a hit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub enum raylet_crossing_kind {
    /// From the outside: into a solid, or through an open surface from its front.
    RAYLET_ENTER = 0,
    /// From the inside: out of a solid, or through an open surface from its back.
    RAYLET_EXIT = 1,
    /// The line touches the surface in one point and stays on its side.
    RAYLET_TOUCH = 2,
}

/// The sides from which a surface is seen.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub enum raylet_visible {
    /// From both sides.
    RAYLET_BOTH = 0,
    /// From outside, or of an open surface from the front: no exit is reported.
    RAYLET_OUTSIDE = 1,
    /// From inside, or of an open surface from the back: no enter is reported.
    RAYLET_INSIDE = 2,
}

/// Towards which side of a surface a ray departs.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub enum raylet_leaving {
    /// Along the outward normal: reflected outside, or refracted out.
    RAYLET_OUTWARDS = 0,
    /// Against the outward normal: refracted in, or reflected inside.
    RAYLET_INWARDS = 1,
}

/// A hit: where a ray meets a surface.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct raylet_hit<N> {
    /// The distance along the ray.
    pub t: N,
    /// A `raylet_part`.
    pub part: u8,
    /// A `raylet_crossing_kind`.
    pub crossing: u8,
}

// A part and a crossing are stored as their places in these lists.
const _: () = {
    let mut place = 0;
    while place < Part::EVERY.len() {
        assert!(Part::EVERY[place] as usize == place);
        place += 1;
    }
    assert!(Crossing::Enter as u8 == 0 && Crossing::Exit as u8 == 1 && Crossing::Touch as u8 == 2);
};

const CROSSINGS: [Crossing; 3] = [Crossing::Enter, Crossing::Exit, Crossing::Touch];

impl<N: Number> raylet_hit<N> {
    pub(crate) fn of(Hit { t, part, crossing }: Hit<Of<N>>) -> Self {
        Self { t: N::from_scalar(t), part: part as u8, crossing: crossing as u8 }
    }
    /// Fails if part or crossing is none.
    pub(crate) fn hit(&self) -> Result<Hit<Of<N>>, Failed> {
        let part = Part::EVERY.get(usize::from(self.part));
        let (Some(part), Some(crossing)) = (part, CROSSINGS.get(usize::from(self.crossing))) else {
            return Err(Failed::of(raylet_error::RAYLET_ERROR_HIT));
        };
        Ok(Hit { t: self.t.scalar(), part: *part, crossing: *crossing })
    }
}

/// All hits of a solid on one ray, sorted by `t`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct raylet_hits<N> {
    /// The hits; those from `count` on mean nothing.
    pub hits: [raylet_hit<N>; RAYLET_MOST_HITS],
    /// How many there are.
    pub count: u8,
    /// True if the ray starts inside the solid: the first hit is then an exit without an enter.
    pub starts_inside: bool,
    /// True if the ray lies in an open or infinite surface. There are then no hits.
    pub is_coincident: bool,
    /// Over which interval of `t` it does.
    pub coincident: [N; 2],
}

/// A crossing of one of many solids.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct raylet_crossing<N> {
    /// Where, on which part, and how.
    pub hit: raylet_hit<N>,
    /// The index of the solid.
    pub solid: u32,
    /// The solids that the ray is inside of before the crossing: bit i is solid i.
    pub before: u32,
    /// Those that it is inside of behind it.
    pub after: u32,
}
