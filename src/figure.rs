//! A primitive as the exact solver sees it: which equations and inequalities its points satisfy.

/// A primitive in the numbers that it was built from.
#[derive(Clone, Copy, Debug)]
pub enum Figure<S> {
    /// All points within `radius` of the origin.
    Ball {
        /// The radius.
        radius: S,
    },
    /// All points within `radius` of the segment from the origin to `(0, height, 0)`.
    Capsule {
        /// The radius.
        radius: S,
        /// The length of the segment.
        height: S,
    },
    /// What lies inside a side around the y axis, or that side alone.
    Round {
        /// The side.
        side: Side<S>,
        /// What ends it.
        extent: Extent<S>,
    },
    /// Both nappes of a cone.
    DoubleCone {
        /// Radius over height.
        slope: S,
    },
    /// The plane `y = 0`.
    Plane,
    /// The part of the plane `y = 0` within `radius` of the origin.
    Disc {
        /// The radius.
        radius: S,
    },
    /// The triangle with these vertices.
    Triangle {
        /// The vertices.
        vertices: [[S; 3]; 3],
    },
}

/// A surface around the y axis.
#[derive(Clone, Copy, Debug)]
pub enum Side<S> {
    /// A cylinder of this radius.
    Straight(S),
    /// A cone from the apex at the origin upwards: radius over height.
    Slope(S),
    /// A cone through a radius at `y = 0` and another at `y = height`, which is the third number.
    Radii(S, S, S),
}

/// What ends a side.
#[derive(Clone, Copy, Debug)]
pub enum Extent<S> {
    /// Nothing; the inside belongs to it.
    Infinite,
    /// Rims at `y = 0` and at this height; the inside does not belong to it.
    Open(S),
    /// Caps, where there are numbers; the inside belongs to it. An apex needs no cap.
    Capped(Option<S>, Option<S>),
}
