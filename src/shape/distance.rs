//! Which part of a solid's surface a point is on, and how far it is from a part.

use super::Placement;
use super::kinds::{Kind, Primitives};
use super::primitive::Member;
use crate::equations::Equations;
use crate::geometry::{Geometry, Hull};
use crate::part::{FACES, Part};
use crate::primitive::RoundCone;
use crate::primitive::surface_coordinates::at_circle;
use crate::scalar::{Scalar, largest};
use crate::vector::{Vec3, pairs};
use core::cmp::Ordering;

/// A point as it lies beside a placed solid.
pub(super) struct Beside<'a, S: Scalar, K: Primitives> {
    member: &'a Member<S, K>,
    placement: &'a Placement<S>,
    hull: Hull<S>,
    point: Vec3<S>,
    local: Vec3<S>,
}

impl<'a, S: Scalar, K: Primitives> Beside<'a, S, K> {
    pub(super) fn new(member: &'a Member<S, K>, placement: &'a Placement<S>, point: Vec3<S>) -> Self {
        let local = match placement {
            Placement::Frame(frame) if K::SET.contains(Kind::Frame) => frame.point_to_local(point),
            Placement::Affine(affine) if K::SET.contains(Kind::Affine) => affine.point_to_local(point),
            _ => point,
        };
        Self { member, placement, hull: member.hull(), point, local }
    }

    /// How far the point is from the part, along the axis on which it is farthest; infinite if the solid has no such
    /// part.
    pub(super) fn distance_to(&self, part: Part) -> S {
        if !self.has(part) {
            return S::INFINITY;
        }
        let on = self.on(part);
        let [on, point] = match self.placement {
            Placement::Affine(affine) if K::SET.contains(Kind::Affine) => [affine.point_to_world(on), self.point],
            // A frame leaves distances as they are.
            _ => [on, self.local],
        };
        largest(pairs(on.to_array(), point.to_array()).map(|(on, point)| on.minus(point)))
    }

    /// The part that the point is on, but for rounding: this one, if it is on that; or the nearest.
    pub(super) fn part(&self, preferred: Part) -> Option<Part> {
        let ([px, py, pz], [x, y, z]) = (self.point.to_array(), self.placement.position().to_array());
        let reach = largest([px, py, pz, x, y, z]);
        // Eight units of the largest coordinate: the point is rounded, and so are the way into the frame and the part's
        // point.
        let is_rounding = |distance: S| distance.is_finite() && reach.plus(distance.scaled(-4)) == reach;
        if is_rounding(self.distance_to(preferred)) {
            return Some(preferred);
        }
        let mut nearest: Option<(S, Part)> = None;
        for part in Part::EVERY {
            let distance = self.distance_to(part);
            if nearest.is_none_or(|(least, _)| distance < least) {
                nearest = Some((distance, part));
            }
        }
        nearest.filter(|(distance, _)| is_rounding(*distance)).map(|(_, part)| part)
    }

    /// True if the solid has the part.
    fn has(&self, part: Part) -> bool {
        let [_, [low, high], _] = self.hull.extents();
        match (&self.hull, part) {
            (Hull::Ball(_) | Hull::Torus(_), _) => part == Part::Side,
            (Hull::Cuboid(_), _) => FACES.as_flattened().contains(&part),
            (Hull::RoundedCuboid(..), _) => part != Part::Inner && part.facet_number().is_none(),
            (Hull::Box(solid), _) => FACES.as_flattened().contains(&part) || solid.facet(part).is_some(),
            (Hull::Prism(polygon, _), _) => matches!(part, Part::Base | Part::Top) || polygon.edge(part).is_some(),
            // A cone ends at its apex without a cap.
            (Hull::Cone { .. }, Part::Base) => false,
            (Hull::Balls(balls), _) => {
                let [low, high] = self.seams(balls);
                match part {
                    Part::Side => low.is_finite(),
                    Part::Base => low > -S::INFINITY,
                    Part::Top => high < S::INFINITY,
                    _ => false,
                }
            }
            (_, Part::Side) => true,
            (_, Part::Inner) => matches!(self.member.equations(), Equations::Tube { .. }),
            (_, Part::Base) => low.is_finite(),
            (_, Part::Top) => high.is_finite(),
            _ => false,
        }
    }

    /// The heights of the circles between the side and the balls at its ends; infinite if one ball holds the other.
    fn seams(&self, [[low, _], [high, _]]: &[[S; 2]; 2]) -> [S; 2] {
        match self.member.equations() {
            Equations::RoundCone { radii, height } => RoundCone { radii, height }.seams(),
            _ => [*low, *high],
        }
    }

    /// The point of the part that is nearest, or nearly nearest.
    fn on(&self, part: Part) -> Vec3<S> {
        let endless = [-S::INFINITY, S::INFINITY];
        // How far the part reaches along the axis: its surface may go on within the solid, or beyond the apex.
        let [low, high] = match (&self.hull, part) {
            (
                Hull::Ball(_)
                | Hull::Torus(_)
                | Hull::Cuboid(_)
                | Hull::RoundedCuboid(..)
                | Hull::Prism(..)
                | Hull::Box(_),
                _,
            ) => endless,
            (Hull::Balls(balls), _) => {
                let [low, high] = self.seams(balls);
                match part {
                    Part::Base => [-S::INFINITY, low],
                    Part::Top => [high, S::INFINITY],
                    _ => [low, high],
                }
            }
            _ => {
                let [_, along, _] = self.hull.extents();
                along
            }
        };
        let y = if self.local.y < low { low } else { self.local.y };
        let y = if y > high { high } else { y };
        let on = self.member.on_surface(Vec3 { y, ..self.local }, part);
        // A flat cap ends at its rim.
        let radius = match (&self.hull, part) {
            (Hull::Discs([[_, radius], _]), Part::Base) | (Hull::Discs([_, [_, radius]]), Part::Top) => *radius,
            (Hull::Cone { slope, height }, Part::Top) => S::round(slope.real() * height.real()),
            _ => return on,
        };
        at_circle(on, radius, Ordering::Greater)
    }
}
