//! Whether a plane meets a shape, and a point where it does.

use super::Shape;
use super::kind::Kind;
use super::kinds::Kinds;
use super::placement::Placement;
use crate::geometry::{Geometry, Hull};
use crate::number::dot;
use crate::part::Part;
use crate::scalar::{Real, Ring, Scalar, largest};
use crate::vector::{Vec3, pairs};

/// A plane and a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Section<P> {
    /// The plane does not meet the shape.
    Missed,
    /// It may meet the shape at this point: one of what is around it, but for rounding.
    At(P),
    /// It is not known.
    Unknown,
}

impl<P> Section<P> {
    /// The same with what this makes of the point; unknown if it makes nothing of it.
    pub(crate) fn and_then<Q>(self, of_point: impl FnOnce(P) -> Option<Q>) -> Section<Q> {
        match self {
            Self::Missed => Section::Missed,
            Self::At(point) => of_point(point).map_or(Section::Unknown, Section::At),
            Self::Unknown => Section::Unknown,
        }
    }
}

impl<S: Scalar, K: Kinds> Shape<S, K> {
    /// Where the plane through a point, whose normal has about the length 1, meets the shape, or a cap of it.
    pub(crate) fn section(&self, point: Vec3<S>, normal: [S::Real; 3], cap: Option<Part>) -> Section<Vec3<S>> {
        if self.combined().is_some() {
            return Section::Unknown;
        }
        let hull = self.member.hull().end(cap);
        // Points are rounded in the world.
        let farthest = largest(point.to_array());
        let rounding = farthest.next_up().minus(farthest).real().scaled(2);
        match self.own().1 {
            Placement::World => hull.section(point, normal, rounding),
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => {
                let turned = frame.axes().map(|axis| dot(axis.real(), normal));
                let section = hull.section(frame.point_to_local(point), turned, rounding);
                section.and_then(|point| Some(frame.point_to_world(point)))
            }
            _ => Section::Unknown,
        }
    }
}

impl<S: Scalar> Hull<S> {
    /// That of a cap.
    fn end(self, cap: Option<Part>) -> Self {
        match (self, cap) {
            (Self::Discs([base, _]), Some(Part::Base)) => Self::Discs([base; 2]),
            (Self::Discs([_, top]), Some(Part::Top)) => Self::Discs([top; 2]),
            (Self::Cone { slope, height }, Some(_)) => {
                Self::Discs([[height, S::round(slope.real() * height.real())]; 2])
            }
            (whole, _) => whole,
        }
    }

    fn section(&self, point: Vec3<S>, normal: [S::Real; 3], rounding: S::Real) -> Section<Vec3<S>> {
        let ends = [normal, normal.map(|c| -c)].map(|direction| self.farthest(direction));
        let [Some(above), Some(below)] = ends else { return Section::Unknown };
        let offset = dot(point.real(), normal);
        let [high, low] = [above, below].map(|end| dot(end, normal) - offset);
        // The coordinates of the point are rounded, and so are the sums.
        let most = [above, below, point.real()].into_iter().flatten().fold(S::Real::ZERO, |most, c| most + c.abs());
        let doubt = most.scaled(-16) + S::ZERO.next_up().real().scaled(3) + rounding;
        if high < -doubt || low > doubt {
            return Section::Missed;
        }
        let whole = high - low;
        let share = if whole > S::Real::ZERO { -low / whole } else { S::Real::ZERO };
        Section::At(Vec3::round(pairs(above, below).map(|(above, below)| below + (above - below) * share)))
    }

    /// A point of the hull that is farthest in a direction, but for rounding; `None` of an infinite hull, of a
    /// polyhedron's and of a torus's.
    fn farthest(&self, direction: [S::Real; 3]) -> Option<[S::Real; 3]> {
        let ([x, y, z], zero) = (direction, S::Real::ZERO);
        let over = |length: S::Real, radius: S| if length.is_zero() { zero } else { radius.real() / length };
        // About points of the axis.
        let on_ball = |[height, radius]: [S; 2]| {
            let share = over((x * x + y * y + z * z).sqrt(), radius);
            [x * share, y * share + height.real(), z * share]
        };
        let on_disc = |[height, radius]: [S; 2]| {
            let share = over((x * x + z * z).sqrt(), radius);
            [x * share, height.real(), z * share]
        };
        let farther = |[a, b]: [[S::Real; 3]; 2]| {
            if dot(a, direction) < dot(b, direction) { b } else { a }
        };
        let towards = |half: S, c: S::Real| if c.is_negative() { -half.real() } else { half.real() };
        let corner = |half: [S; 3]| pairs(half, direction).map(|(half, c)| towards(half, c));
        let is_finite = |sizes: &[S]| sizes.iter().all(|size| size.is_finite());
        match self {
            Self::Ball(radius) => Some(on_ball([S::ZERO, *radius])),
            Self::Balls(balls) if is_finite(balls.as_flattened()) => Some(farther(balls.map(on_ball))),
            Self::Discs(discs) if is_finite(discs.as_flattened()) => Some(farther(discs.map(on_disc))),
            Self::Cone { slope, height } if height.is_finite() => {
                let radius = S::round(slope.real() * height.real());
                Some(farther([[zero; 3], on_disc([*height, radius])]))
            }
            Self::Points([a, b, c]) => Some(farther([farther([a.real(), b.real()]), c.real()])),
            Self::Cuboid(half) => Some(corner(*half)),
            Self::RoundedCuboid(half, radius) => {
                Some(pairs(corner(*half), on_ball([S::ZERO, *radius])).map(|(core, more)| core + more))
            }
            Self::Prism(polygon, height) => {
                let base = polygon.corners().map(|[x, z]| [x.real(), zero, z.real()]);
                let [x, _, z] = base.reduce(|a, b| farther([a, b]))?;
                Some([x, if y.is_negative() { zero } else { height.real() }, z])
            }
            _ => None,
        }
    }
}
