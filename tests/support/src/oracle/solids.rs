//! The solids in their canonical pose, straight from their definitions, and which points belong to them.

use super::algebraic::Root;
use super::dyadic::{Dyadic, sign_of};

/// How far a cylinder reaches; `x^2 + z^2 = radius^2` throughout.
#[derive(Clone, Debug, PartialEq)]
pub enum CylinderExtent {
    /// All y; the solid.
    Infinite,
    /// The tube over `0 <= y <= height`, without caps.
    Open(Dyadic),
    /// The solid over `0 <= y <= height`, with flat caps.
    Capped(Dyadic),
}

/// How far a cone reaches; `x^2 + z^2 = (slope * y)^2` throughout, apex at the origin.
#[derive(Clone, Debug, PartialEq)]
pub enum ConeExtent {
    /// All y; the solid of two nappes.
    Double,
    /// `y >= 0`; the solid.
    Nappe,
    /// The lateral surface over `0 <= y <= height`.
    Open(Dyadic),
    /// The solid over `0 <= y <= height`, with a flat cap at the height.
    Capped(Dyadic),
}

/// A solid or a surface, axis +y. Sizes are positive but where said otherwise.
#[derive(Clone, Debug, PartialEq)]
pub enum Solid {
    /// The ball around the origin.
    Sphere {
        /// Its radius.
        radius: Dyadic,
    },
    /// A cylinder around the y axis.
    Cylinder {
        /// Its radius.
        radius: Dyadic,
        /// Which part of it.
        extent: CylinderExtent,
    },
    /// A cone around the y axis that opens to +y, apex at the origin.
    Cone {
        /// Radius per height.
        slope: Dyadic,
        /// Which part of it.
        extent: ConeExtent,
    },
    /// A cone cut off: its radius runs linearly from `y = 0` to `y = height`.
    Frustum {
        /// The radius at `y = 0`; may be zero where the other is not.
        base_radius: Dyadic,
        /// The radius at `y = height`; may be zero where the other is not.
        top_radius: Dyadic,
        /// Its height.
        height: Dyadic,
        /// Whether it is the solid with flat caps or the lateral surface alone.
        capped: bool,
    },
    /// All points within the radius of the segment from the origin to `(0, height, 0)`.
    Capsule {
        /// Its radius.
        radius: Dyadic,
        /// The length of the segment; may be zero.
        height: Dyadic,
    },
    /// The convex hull of a ball around the origin and one around `(0, height, 0)`.
    RoundCone(RoundCone),
    /// A quadric of revolution between two planes.
    Revolved(Revolved),
    /// What lies between two cylinders around the y axis, over `0 <= y <= height`, with flat ends.
    Tube {
        /// The smaller radius.
        inner: Dyadic,
        /// The larger radius.
        outer: Dyadic,
        /// Its height.
        height: Dyadic,
    },
    /// All points within the minor radius of the circle of the major radius around the y axis, in the plane `y = 0`.
    Torus {
        /// The radius of the circle.
        major: Dyadic,
        /// The radius of the tube, below the other.
        minor: Dyadic,
    },
    /// The plane `y = 0`, facing +y.
    Plane,
    /// The disc around the origin in the plane `y = 0`, facing +y.
    Disc {
        /// Its radius.
        radius: Dyadic,
    },
    /// What lies between two circles around the origin in the plane `y = 0`, facing +y.
    Annulus {
        /// The smaller radius.
        inner: Dyadic,
        /// The larger radius.
        outer: Dyadic,
    },
    /// All points whose coordinates are at most these in magnitude.
    Cuboid {
        /// The half extents along x, y and z.
        half: [Dyadic; 3],
    },
    /// All points within a radius of such a cuboid.
    RoundedCuboid(RoundedCuboid),
    /// A prism or a polyhedron.
    HalfSpaces(HalfSpaces),
    /// The rectangle around the origin in the plane `y = 0`, facing +y.
    Rectangle {
        /// The half extents along x and z.
        half: [Dyadic; 2],
    },
    /// A triangle with its edges, facing `(v1 - v0) x (v2 - v0)`, which must not be zero.
    Triangle {
        /// Its corners.
        vertices: [[Dyadic; 3]; 3],
    },
}

/// A face of what half-spaces have in common.
#[derive(Clone, Debug, PartialEq)]
pub struct HalfSpace {
    /// Its part.
    pub part: Part,
    /// The outward normal, of any length.
    pub normal: [Dyadic; 3],
    /// A point of the plane.
    pub point: [Dyadic; 3],
}

impl HalfSpace {
    /// How far inside of the plane the point is, times the length of the normal.
    pub fn margin(&self, point: &[Dyadic; 3]) -> Dyadic {
        dot(&self.normal, &subtract(&self.point, point))
    }
}

/// What half-spaces have in common: a prism, or a polyhedron.
#[derive(Clone, Debug, PartialEq)]
pub struct HalfSpaces {
    /// The faces in the order in which they own edges.
    pub faces: Vec<HalfSpace>,
    /// The coordinates and sizes that it was made of.
    pub lengths: Vec<Dyadic>,
}

impl HalfSpaces {
    /// The prism over `0 <= y <= height` and the polygon with these corners, each as x and z, counter-clockwise as seen
    /// from +y.
    pub fn prism(corners: &[[Dyadic; 2]], height: &Dyadic) -> Self {
        let next = corners.iter().cycle().skip(1);
        let facets = corners.iter().zip(next).enumerate().map(|(i, ([ax, az], [bx, bz]))| HalfSpace {
            part: Part::Facet(i as u8),
            normal: [az - bz, Dyadic::zero(), bx - ax],
            point: [ax.clone(), Dyadic::zero(), az.clone()],
        });
        let ends = [(Part::Base, 1, false, Dyadic::zero()), (Part::Top, 1, true, height.clone())];
        let lengths = corners.iter().flatten().chain([height]).cloned().collect();
        Self { faces: facets.chain(ends.map(across)).collect(), lengths }
    }

    /// The box between these corners, cut by half-spaces: of each a point and the outward normal.
    pub fn polyhedron([low, high]: [&[Dyadic; 3]; 2], facets: &[[[Dyadic; 3]; 2]]) -> Self {
        let facets = facets.iter().enumerate();
        let facets = facets.map(|(i, [point, normal])| HalfSpace {
            part: Part::Facet(i as u8),
            normal: normal.clone(),
            point: point.clone(),
        });
        let ends = [
            (Part::Left, 0, false, low[0].clone()),
            (Part::Right, 0, true, high[0].clone()),
            (Part::Back, 2, false, low[2].clone()),
            (Part::Front, 2, true, high[2].clone()),
            (Part::Base, 1, false, low[1].clone()),
            (Part::Top, 1, true, high[1].clone()),
        ];
        let lengths = low.iter().chain(high).cloned().collect();
        Self { faces: facets.chain(ends.map(across)).collect(), lengths }
    }

    /// How far inside of each face's plane the point is, times the length of the normal.
    pub fn margins(&self, point: &[Dyadic; 3]) -> Vec<Dyadic> {
        self.faces.iter().map(|face| face.margin(point)).collect()
    }

    /// The normal of a part.
    pub fn normal(&self, part: Part) -> [Dyadic; 3] {
        let face = self.faces.iter().find(|face| face.part == part);
        face.expect("the solid has no such part").normal.clone()
    }
}

/// A face across an axis at this coordinate, and whether its normal points along the axis.
fn across((part, axis, is_along, at): (Part, usize, bool, Dyadic)) -> HalfSpace {
    let (mut normal, mut point) = ([0, 0, 0].map(Dyadic::from), [0, 0, 0].map(Dyadic::from));
    normal[axis] = Dyadic::from(if is_along { 1 } else { -1 });
    point[axis] = at;
    HalfSpace { part, normal, point }
}

/// Two balls and what is between them.
#[derive(Clone, Debug, PartialEq)]
pub struct RoundCone {
    /// Of the ball around the origin.
    pub base_radius: Dyadic,
    /// Of the other ball.
    pub top_radius: Dyadic,
    /// Of the other ball's centre; may be zero.
    pub height: Dyadic,
}

impl RoundCone {
    /// The solid of these sizes: with equal radii a capsule.
    pub fn solid(base_radius: Dyadic, top_radius: Dyadic, height: Dyadic) -> Solid {
        if base_radius == top_radius {
            Solid::Capsule { radius: base_radius, height }
        } else {
            Solid::RoundCone(Self { base_radius, top_radius, height })
        }
    }

    /// The difference of the radii.
    pub fn difference(&self) -> Dyadic {
        &self.base_radius - &self.top_radius
    }

    /// The ball that holds the other, and its part, if one does.
    pub fn ball(&self) -> Option<(Part, &Dyadic, Dyadic)> {
        let k = self.difference();
        if k >= self.height {
            Some((Part::Base, &self.base_radius, Dyadic::zero()))
        } else if -&k >= self.height {
            Some((Part::Top, &self.top_radius, self.height.clone()))
        } else {
            None
        }
    }

    /// The heights of the circles where the cone touches the balls, times the height.
    pub fn seams(&self) -> [Dyadic; 2] {
        let k = self.difference();
        [&self.base_radius * &k, &self.height.squared() + &(&self.top_radius * &k)]
    }

    /// The part that a point of the surface at this height belongs to.
    pub fn part_at(&self, y: &Dyadic) -> Part {
        if let Some((part, ..)) = self.ball() {
            return part;
        }
        let ([low, high], y) = (self.seams(), y * &self.height);
        if y < low {
            Part::Base
        } else if y > high {
            Part::Top
        } else {
            Part::Side
        }
    }

    /// `h^2 - k^2` and `r h - k y`: on the cone `(h^2 - k^2) (x^2 + z^2) = (r h - k y)^2`.
    pub fn cone_at(&self, y: &Dyadic) -> [Dyadic; 2] {
        let k = self.difference();
        [&self.height.squared() - &k.squared(), &(&self.base_radius * &self.height) - &(&k * y)]
    }
}

/// All points within a radius of a cuboid around the origin.
#[derive(Clone, Debug, PartialEq)]
pub struct RoundedCuboid {
    /// The half extents of the cuboid; may be zero.
    pub half: [Dyadic; 3],
    /// The radius.
    pub radius: Dyadic,
}

impl RoundedCuboid {
    /// How far a point is beyond the cuboid along each axis.
    pub fn excess(&self, point: &[Dyadic; 3]) -> [Dyadic; 3] {
        std::array::from_fn(|axis| {
            let beyond = &point[axis].magnitude() - &self.half[axis];
            if beyond.signum() > 0 { beyond } else { Dyadic::zero() }
        })
    }

    /// The part of a point of the surface: the seams belong to the faces.
    pub fn part_at(&self, line: &Line, t: &Root) -> Part {
        let sides: [i8; 3] = std::array::from_fn(|axis| {
            let (c, half) = (line.coordinate_at(t, axis), &self.half[axis]);
            i8::from(c.cmp_dyadic(half).is_gt()) - i8::from(c.cmp_dyadic(&-half).is_lt())
        });
        Self::part_of(sides)
    }

    /// The part of points that are beyond the cuboid along these axes, to these sides.
    pub fn part_of(sides: [i8; 3]) -> Part {
        match sides {
            [-1, 0, 0] => Part::Left,
            [1, 0, 0] => Part::Right,
            [0, -1, 0] => Part::Base,
            [0, 1, 0] => Part::Top,
            [0, 0, -1] => Part::Back,
            [0, 0, 1] => Part::Front,
            _ => Part::Side,
        }
    }
}

/// `x^2 + z^2 = a y^2 + 2 b y + r^2` with `low <= y <= high`.
#[derive(Clone, Debug, PartialEq)]
pub struct Revolved {
    /// The coefficient of `y^2`.
    pub a: Dyadic,
    /// Half the coefficient of `y`.
    pub b: Dyadic,
    /// The radius at `y = 0`.
    pub r: Dyadic,
    /// The lower end.
    pub low: Dyadic,
    /// The upper end.
    pub high: Dyadic,
    /// Whether it is the solid with flat caps or the side alone.
    pub capped: bool,
}

impl Revolved {
    /// Whether a ray that departs outwards from the side may meet it again.
    pub fn has_waist(&self) -> bool {
        let has_two_sheets = match self.b.signum() {
            0 => self.low.signum() < 0 && self.high.signum() > 0,
            1 => self.low.signum() < 0,
            _ => self.high.signum() > 0,
        };
        self.a.signum() > 0 && (self.r.signum() > 0 || has_two_sheets)
    }
}

/// A part of a surface. The side owns every rim and seam that it shares.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The curved side; all of a sphere, plane, disc, rectangle or triangle.
    Side,
    /// The cap at `y = 0`; of a capsule the hemisphere with `y < 0`; of a cuboid the lowest face.
    Base,
    /// The cap at `y = height`; of a capsule the hemisphere with `y > height`; of a cuboid the highest face.
    Top,
    /// A cuboid's face at the lowest `x`.
    Left,
    /// A cuboid's face at the highest `x`.
    Right,
    /// A cuboid's face at the lowest `z`.
    Back,
    /// A cuboid's face at the highest `z`.
    Front,
    /// A facet of a prism, by its number.
    Facet(u8),
    /// The inner side of a tube.
    Inner,
}

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Membership {
    /// Strictly within the solid.
    Inside,
    /// On its boundary, or on the surface.
    OnSurface,
    /// Elsewhere. A surface that encloses nothing has no inside.
    Outside,
}

/// The line `origin + t * direction`; the direction is not zero and need not be unit.
#[derive(Clone, Debug)]
pub struct Line {
    /// The point at `t = 0`.
    pub origin: [Dyadic; 3],
    /// The derivative of the point by `t`.
    pub direction: [Dyadic; 3],
}

impl Line {
    /// The line through the origin given along the direction given.
    ///
    /// # Panics
    ///
    /// If the direction is zero.
    pub fn new(origin: [Dyadic; 3], direction: [Dyadic; 3]) -> Self {
        assert!(direction.iter().any(|component| !component.is_zero()), "a line has a direction");
        Self { origin, direction }
    }

    /// A coordinate (0, 1 or 2 for x, y or z) of the point at a parameter.
    pub fn coordinate_at(&self, t: &Root, axis: usize) -> Root {
        t.mul_add(&self.direction[axis], &self.origin[axis])
    }

    /// The point at a dyadic parameter.
    pub fn point_at(&self, t: &Dyadic) -> [Dyadic; 3] {
        std::array::from_fn(|axis| &self.origin[axis] + &(t * &self.direction[axis]))
    }
}

/// The surface `weight * sqrt(x^2 + z^2) = offset + growth * y`, which every straight-sided solid of revolution has.
pub(super) struct Lateral {
    pub weight: Dyadic,
    pub offset: Dyadic,
    pub growth: Dyadic,
}

impl Solid {
    /// The curved side, where it is a cylinder's or a cone's.
    pub(super) fn lateral(&self) -> Option<Lateral> {
        let (weight, offset, growth) = match self {
            Solid::Cylinder { radius, .. } | Solid::Capsule { radius, .. } => {
                (Dyadic::from(1), radius.clone(), Dyadic::zero())
            }
            Solid::Cone { slope, .. } => (Dyadic::from(1), Dyadic::zero(), slope.clone()),
            Solid::Frustum { base_radius, top_radius, height, .. } => {
                (height.clone(), base_radius * height, top_radius - base_radius)
            }
            _ => return None,
        };
        Some(Lateral { weight, offset, growth })
    }
}

/// The difference of two vectors.
pub(super) fn subtract(left: &[Dyadic; 3], right: &[Dyadic; 3]) -> [Dyadic; 3] {
    std::array::from_fn(|axis| &left[axis] - &right[axis])
}

/// The inner product.
pub(super) fn dot(left: &[Dyadic; 3], right: &[Dyadic; 3]) -> Dyadic {
    let [x, y, z]: [Dyadic; 3] = std::array::from_fn(|axis| &left[axis] * &right[axis]);
    &(&x + &y) + &z
}

/// The cross product.
pub(super) fn cross(left: &[Dyadic; 3], right: &[Dyadic; 3]) -> [Dyadic; 3] {
    std::array::from_fn(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        &(&left[next] * &right[last]) - &(&left[last] * &right[next])
    })
}

/// The normal of a triangle, as long as twice its area.
///
/// # Panics
///
/// If the triangle has no area.
pub(super) fn triangle_normal(vertices: &[[Dyadic; 3]; 3]) -> [Dyadic; 3] {
    let normal = cross(&subtract(&vertices[1], &vertices[0]), &subtract(&vertices[2], &vertices[0]));
    assert!(normal.iter().any(|component| !component.is_zero()), "a triangle has an area");
    normal
}

/// The intersection of closed sets of which the point satisfies `margin >= 0` each.
fn within(margins: &[Dyadic]) -> Membership {
    match margins.iter().map(Dyadic::signum).min() {
        Some(1) | None => Membership::Inside,
        Some(0) => Membership::OnSurface,
        _ => Membership::Outside,
    }
}

/// The surface `wall = 0` where the point also satisfies `margin >= 0` each.
fn on(wall: &Dyadic, margins: &[Dyadic]) -> Membership {
    if wall.is_zero() && within(margins) != Membership::Outside { Membership::OnSurface } else { Membership::Outside }
}

/// Where the point lies. Surfaces without volume, the open tube and cone among them, have no inside.
pub fn contains(solid: &Solid, point: &[Dyadic; 3]) -> Membership {
    let [x, y, z] = point;
    let from_axis = &x.squared() + &z.squared();
    match solid {
        Solid::Torus { major, minor } => within(&[-&super::torus::value([major, minor], point)]),
        Solid::Sphere { radius } => within(&[&radius.squared() - &(&from_axis + &y.squared())]),
        Solid::Cylinder { radius, extent } => {
            let wall = &radius.squared() - &from_axis;
            match extent {
                CylinderExtent::Infinite => within(&[wall]),
                CylinderExtent::Open(height) => on(&wall, &[y.clone(), height - y]),
                CylinderExtent::Capped(height) => within(&[wall, y.clone(), height - y]),
            }
        }
        Solid::Cone { slope, extent } => {
            let wall = &(slope * y).squared() - &from_axis;
            match extent {
                ConeExtent::Double => within(&[wall]),
                ConeExtent::Nappe => within(&[wall, y.clone()]),
                ConeExtent::Open(height) => on(&wall, &[y.clone(), height - y]),
                ConeExtent::Capped(height) => within(&[wall, y.clone(), height - y]),
            }
        }
        Solid::Frustum { base_radius, top_radius, height, capped } => {
            // The radius there, times the height, so that nothing is divided.
            let reach = &(base_radius * &(height - y)) + &(top_radius * y);
            let wall = &reach.squared() - &(&height.squared() * &from_axis);
            let margins = [y.clone(), height - y];
            if *capped {
                let [above_base, below_top] = margins;
                within(&[wall, above_base, below_top])
            } else {
                on(&wall, &margins)
            }
        }
        Solid::Capsule { radius, height } => {
            let along = if y.signum() < 0 {
                y.clone()
            } else if y > height {
                y - height
            } else {
                Dyadic::zero()
            };
            within(&[&radius.squared() - &(&from_axis + &along.squared())])
        }
        Solid::RoundCone(cone) => {
            let ball = |radius: &Dyadic, y: &Dyadic| within(&[&radius.squared() - &(&from_axis + &y.squared())]);
            match cone.part_at(y) {
                Part::Base => ball(&cone.base_radius, y),
                Part::Top => ball(&cone.top_radius, &(y - &cone.height)),
                _ => {
                    let [w, v] = cone.cone_at(y);
                    within(&[&v.squared() - &(&w * &from_axis)])
                }
            }
        }
        Solid::Revolved(revolved) => {
            let wall = super::revolved::margin(revolved, y, &from_axis);
            let margins = [y - &revolved.low, &revolved.high - y];
            if revolved.capped {
                let [above, below] = margins;
                within(&[wall, above, below])
            } else {
                on(&wall, &margins)
            }
        }
        Solid::Tube { inner, outer, height } => {
            within(&[&outer.squared() - &from_axis, &from_axis - &inner.squared(), y.clone(), height - y])
        }
        Solid::Plane => on(y, &[]),
        Solid::Disc { radius } => on(y, &[&radius.squared() - &from_axis]),
        Solid::Annulus { inner, outer } => on(y, &[&outer.squared() - &from_axis, &from_axis - &inner.squared()]),
        Solid::Cuboid { half } => within(&std::array::from_fn::<_, 3, _>(|i| &half[i] - &point[i].magnitude())),
        Solid::RoundedCuboid(cuboid) => {
            let excess = cuboid.excess(point);
            within(&[&cuboid.radius.squared() - &dot(&excess, &excess)])
        }
        Solid::HalfSpaces(solid) => within(&solid.margins(point)),
        Solid::Rectangle { half: [along_x, along_z] } => on(y, &[along_x - &x.magnitude(), along_z - &z.magnitude()]),
        Solid::Triangle { vertices } => {
            let normal = triangle_normal(vertices);
            let margins: [Dyadic; 3] = std::array::from_fn(|start| {
                let end = (start + 1) % 3;
                let edge = subtract(&vertices[end], &vertices[start]);
                dot(&cross(&normal, &edge), &subtract(point, &vertices[start]))
            });
            on(&dot(&normal, &subtract(point, &vertices[0])), &margins)
        }
    }
}

/// How near grazing a line is: 0 through the middle, 1 tangent, more for a miss; none where it says nothing.
///
/// For a sphere the distance of the line from the centre over the radius; for a cylinder and a capsule that of the line
/// from the axis; for a cone `|w_y| / (slope * |(w_x, w_z)|)` of the moment `w`, and none where that has no
/// denominator.
pub fn margin(solid: &Solid, line: &Line) -> Option<f64> {
    let moment = cross(&line.origin, &line.direction);
    let [x, _, z] = &line.direction;
    let from_axis = &x.squared() + &z.squared();
    let (square, full) = match solid {
        Solid::Sphere { radius } => (dot(&moment, &moment), &dot(&line.direction, &line.direction) * &radius.squared()),
        Solid::Cylinder { radius, .. } | Solid::Capsule { radius, .. } => {
            if from_axis.is_zero() {
                let [x, _, z] = &line.origin;
                (&x.squared() + &z.squared(), radius.squared())
            } else {
                (moment[1].squared(), &from_axis * &radius.squared())
            }
        }
        Solid::Cone { slope, .. } => {
            (moment[1].squared(), &slope.squared() * &(&moment[0].squared() + &moment[2].squared()))
        }
        _ => return None,
    };
    if sign_of(&full.mantissa) == 0 {
        return None;
    }
    let ratio = Root::quotient(square.mantissa, full.mantissa, square.exponent - full.exponent);
    Some(ratio.to_f64().sqrt())
}
