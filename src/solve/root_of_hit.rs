//! The root of an equation that belongs to a hit, and its order with those of other hits.

use super::end::{Fraction, Of};
use super::local_ray::LocalRay;
use super::polyhedra::{end_in_a_polyhedron, end_in_a_prism};
use super::root_of_torus::{self, RootOfTorus};
use super::roots::{RootOfQuadric, at};
use super::rounded;
use super::side::planes_through;
use super::surface::{Line, surface_of};
use super::torus::Along;
use crate::equations::{Described, EquationKinds, Equations};
use crate::hit::{Crossing, Hit};
use crate::number::{Estimate, Number};
use crate::part::{FACES, Part};
use crate::ray::Leaving;
use crate::scalar::{Scalar, ToScalar};
use core::cmp::Ordering;

/// Where a line crosses a surface.
#[expect(missing_debug_implementations, reason = "the numbers of solvers need not be written")]
#[derive(Clone, Copy)]
pub enum Root<N: Number> {
    /// A quadric, or a plane.
    OfQuadric(RootOfQuadric<N>),
    /// A torus.
    OfTorus(RootOfTorus<N::Long>),
}

impl<N: Number> From<RootOfQuadric<N>> for Root<N> {
    fn from(root: RootOfQuadric<N>) -> Self {
        Self::OfQuadric(root)
    }
}

impl<N: Number> Root<N> {
    /// The parameter `t`.
    pub(crate) fn at_parameter(t: N) -> Self {
        RootOfQuadric::at(Fraction { n: t, e: N::ONE }).into()
    }

    /// How it compares with another root on the same line; `None` if a sign is not known, or if the roots are those of
    /// two tori and closer than numbers with an error bound can tell.
    pub(crate) fn order(&self, other: &Self) -> Option<Ordering> {
        match (self, other) {
            (Self::OfQuadric(root), Self::OfQuadric(other)) => root.order(other),
            (Self::OfTorus(root), Self::OfQuadric(other)) => root.order_with_quadric(&other.long()),
            (Self::OfQuadric(root), Self::OfTorus(other)) => {
                other.order_with_quadric(&root.long()).map(Ordering::reverse)
            }
            (Self::OfTorus(root), Self::OfTorus(other)) => root.order(other),
        }
    }

    /// This root, or the parameter zero if that is greater.
    pub(crate) fn not_before_start(self) -> Option<Self> {
        let start = Self::at_parameter(N::ZERO);
        Some(if self.order(&start)? == Ordering::Less { start } else { self })
    }
}

/// The root that belongs to a hit, of the equation of the part that is hit. If the line departs from a part, `t = 0` is
/// a root of the part's equation, whatever the rounded coordinates. `None` if the number does not know a sign.
pub(crate) fn root_at<S: Scalar, N: Of<S>, G: Described>(
    equations: &Equations<S>,
    hit: &Hit<S>,
    line: &Line<N>,
    departed: Option<Part>,
) -> Option<Root<N>> {
    if let Equations::RoundedCuboid { half, radius, .. } = *equations
        && G::EQUATIONS.has(EquationKinds::ROUNDED_CUBOID)
    {
        return Some(rounded::end_at(half, radius, hit.crossing, line, departed)?.root().into());
    }
    if let Equations::Torus { radii } = *equations
        && G::EQUATIONS.has(EquationKinds::TORUS)
    {
        let departure = departed.map(|part| (part, Leaving::Inwards));
        let along = Along::new(&LocalRay::new([line.origin, line.direction], departure).long(), radii, 0).ok()?;
        let t = <N::Estimate as ToScalar<S>>::of(hit.t).rough();
        let root = root_of_torus::nearest_to(t, &along, hit.crossing == Crossing::Exit, departed.is_some());
        // A ray that is said to lead inwards and does not ends at its start.
        return Some(root.map_or(Root::at_parameter(N::ZERO), Root::OfTorus));
    }
    let function = |part: Part| {
        let surface = surface_of::<S, N, G>(equations, part, line, N::scalar);
        let value = if departed == Some(part) { N::ZERO } else { surface.value() };
        [surface.bending(), surface.slope(), value]
    };
    let f @ [a, k, c] = function(hit.part);
    if is_constant(f)? {
        if let Equations::Prism { polygon, height } = *equations
            && G::EQUATIONS.has(EquationKinds::PRISM)
        {
            return end_in_a_prism(line, polygon, height, (hit.crossing == Crossing::Enter, departed)).map(Root::from);
        }
        if let Equations::Polyhedron { solid } = *equations
            && G::EQUATIONS.has(EquationKinds::POLYHEDRON)
        {
            return end_in_a_polyhedron(line, solid, (hit.crossing == Crossing::Enter, departed)).map(Root::from);
        }
        return edge(equations, hit.crossing == Crossing::Enter, function).map(Root::from);
    }
    let is_touch = hit.crossing == Crossing::Touch && a.sign()? != Ordering::Equal;
    if is_touch && N::sum([[k, k], [-a, c]]).sign()? != Ordering::Equal {
        // The line touches the solid at a rim, and crosses the infinite surface of the side there.
        for (_, part) in
            planes_through::<S, G>(equations).into_iter().zip([Part::Base, Part::Top]).filter(|(rim, _)| rim.is_some())
        {
            let [_, growth, value] = function(part);
            if growth.sign()? != Ordering::Equal {
                let rim = Fraction { n: -value, e: growth + growth };
                if at(f, rim).sign()? == Ordering::Equal {
                    return Some(RootOfQuadric::at(rim).into());
                }
            }
        }
    }
    RootOfQuadric::of(f, hit.crossing).map(Root::from)
}

/// True if the function does not change along the line.
fn is_constant<N: Number>([a, k, _]: [N; 3]) -> Option<bool> {
    Some(a.sign()? == Ordering::Equal && k.sign()? == Ordering::Equal)
}

/// The end, on an edge, of a line that lies in the surface of a solid. The hit's part owns the edge, but the end is the
/// root of another part's equation: the line is inside between the two parts of each pair.
fn edge<S, N: Number>(
    equations: &Equations<S>,
    enters: bool,
    function: impl Fn(Part) -> [N; 3],
) -> Option<RootOfQuadric<N>> {
    let ends = [FACES[2]];
    let pairs = if let Equations::Cuboid { .. } = equations { FACES.as_slice() } else { ends.as_slice() };
    let mut last: Option<RootOfQuadric<N>> = None;
    for pair in pairs {
        let [f, g] = pair.map(&function);
        if is_constant(f)? || is_constant(g)? {
            continue;
        }
        // A line in the side of a capsule touches the balls at its ends.
        let [first, second] = [RootOfQuadric::of(f, Crossing::Touch)?, RootOfQuadric::of(g, Crossing::Touch)?];
        let is_rising = first.order(&second)? == Ordering::Less;
        let end = if is_rising == enters { first } else { second };
        last = match last {
            Some(last) if (last.order(&end)? == Ordering::Greater) == enters => Some(last),
            _ => Some(end),
        };
    }
    last
}
