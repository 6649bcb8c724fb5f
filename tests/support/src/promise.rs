//! What the tiers promise of one ray, and whether an answer keeps it.
//!
//! - `Plain`: no hit is lost or invented where the ray is plain, 10^-5 off the generators of a cone, 10^-4 of its minor
//!   radius off touching a torus, and the start within 10 sizes, and 10^5 of its narrowest size, but within 64 units of
//!   a rim or 16 of the start.
//! - `Fast`: no hit is lost, invented or on another part where the ray is plain and the start within 100 sizes, but
//!   within 16 units of a rim or of the start.
//! - `Stable`: no hit is lost, invented or on another part but within a unit of touching or of a rim. In floats `t` is
//!   within 16 units away from grazing, and 31 at any ray that grazes to 1e-7; in fixed point within one unit.
//! - `Exact`: the hits are those of exact arithmetic, and `t` is within one unit.
//!
//! A ray is *plain* if each chord of its line is at least a hundredth of the solid's size; if the line has no chord,
//! since it meets the surface once or not at all, the ray is plain if it does not graze.
//!
//! And for all of them: a ray that departs outwards does not meet what it departs from. In all but `Plain` that holds
//! too for a ray that departs inwards, so nearly along the surface that it leaves nothing behind.

use super::exact_types::{Exact as Number, expected_of, same_crossing, same_part};
use super::method::Told;
use super::oracle::{
    ConeExtent, CylinderExtent, Dyadic, ExpectedHit, InRange, Line, Revolved, Root, RoundCone, RoundedCuboid, Solid,
    exact_f64,
};
use super::random::{add, cross, dot, scale};
use raylet::{Leaving, Part, Range, Ray};

/// Away from grazing is what is farther than this from touching, and by as much off an axis, a generator and a plane.
const AWAY: f64 = 1e-2;

/// Nearer than this nothing is promised.
const NEAREST: f64 = 1e-7;

/// Nearer than this `Plain` promises nothing of a cone. Through a map that stretches by 30, the direction in the frame
/// of the solid is off by some 10^-6 in `f32`, which decides on which nappe a ray along a generator ends.
const NEAREST_TO_CONE: f64 = 1e-5;

/// Nearer than this it promises nothing of a torus. A line that has a chord in it and nearly touches it elsewhere was
/// given another chord there, at up to 1.3 10^-5: 12 rays of the table of bounds.
const NEAREST_TO_TORUS: f64 = 1e-4;

/// Farther than so many times the narrowest size away, `Plain` promises nothing: the coordinates of a start at 3,000,
/// in the units of a solid that a map makes a thousandth as wide, are off by a tenth of its size in `f32`.
const MOST_OF_NARROWEST: f64 = 1e5;

/// A start nearer to the surface than this share of the size is judged by positions.
const NEAR: f64 = 1e-3;

/// A ray at a solid as it stands, with the exact answer.
pub struct Judged<'a, S: Number> {
    pub solid: &'a Solid,
    /// In the solid's frame.
    pub line: &'a Line,
    pub ray: &'a Ray<S>,
    pub want: &'a InRange,
    /// The solid's size in the world, about.
    pub size: f64,
    /// The same along the axis along which a map makes it narrowest.
    pub narrowest: f64,
}

/// How far a line is from grazing: the depth below or above a curved surface over the radius there, and the sines of
/// its angles to an axis, a generator and a plane, whichever is least. In `f64`: it sorts rays, and decides nothing
/// else.
pub fn clearance(solid: &Solid, line: &Line) -> f64 {
    let [o, d] = [&line.origin, &line.direction].map(|v| v.each_ref().map(Dyadic::to_f64));
    let d = scale(d, 1.0 / dot(d, d).sqrt());
    let [x, y, z] = d;
    let (across, off_plane) = (x.hypot(z), y.abs());
    let ball = |height: f64, radius: f64| {
        let w = cross(add(o, [0.0, -height, 0.0]), d);
        (1.0 - dot(w, w).sqrt() / radius).abs()
    };
    let tube = |radius: f64| across.min((1.0 - cross(o, d)[1].abs() / (across * radius)).abs());
    let cone = |apex: f64, slope: f64| {
        let [wx, wy, wz] = cross(add(o, [0.0, -apex, 0.0]), d);
        let off_generator = (libm::atan2(across, y.abs()) - libm::atan(slope.abs())).abs();
        across.min(off_generator).min((1.0 - wy.abs() / (slope.abs() * wx.hypot(wz))).abs())
    };
    let least = match solid {
        Solid::Sphere { radius } => ball(0.0, radius.to_f64()),
        Solid::Cylinder { radius, extent } => {
            let off_plane = if matches!(extent, CylinderExtent::Capped(_)) { off_plane } else { 1.0 };
            tube(radius.to_f64()).min(off_plane)
        }
        Solid::Capsule { radius, height } => {
            let radius = radius.to_f64();
            tube(radius).min(ball(0.0, radius)).min(ball(height.to_f64(), radius))
        }
        Solid::Cone { slope, extent } => {
            let off_plane = if matches!(extent, ConeExtent::Capped(_)) { off_plane } else { 1.0 };
            cone(0.0, slope.to_f64()).min(off_plane)
        }
        Solid::Frustum { base_radius, top_radius, height, capped } => {
            let [base, top, height] = [base_radius, top_radius, height].map(Dyadic::to_f64);
            let slope = (top - base) / height;
            cone(-base / slope, slope).min(if *capped { off_plane } else { 1.0 })
        }
        Solid::Revolved(Revolved { a, b, r, capped, .. }) => {
            let [a, b, r] = [a, b, r].map(Dyadic::to_f64);
            let [wx, wy, wz] = cross(o, d);
            // 1 less the ratio of the discriminant's terms; the angle to the generators of the asymptotic cone.
            let positive = [r * r * across * across, b * b * y * y, 2.0 * b * (wx * z - wz * x), -(a * r * r * y * y)];
            let full = positive.into_iter().map(f64::abs).sum::<f64>() + a.abs() * (wx * wx + wz * wz) + wy * wy;
            let discriminant = positive.into_iter().sum::<f64>() + a * (wx * wx + wz * wz) - wy * wy;
            let off_generator = if a > 0.0 { (libm::atan2(across, y.abs()) - libm::atan(a.sqrt())).abs() } else { 1.0 };
            let off_axis = if a < 0.0 { 1.0 } else { across };
            let off_plane = if *capped { off_plane } else { 1.0 };
            (discriminant / full).abs().min(off_generator).min(off_axis).min(off_plane)
        }
        Solid::RoundCone(RoundCone { base_radius, top_radius, height }) => {
            let [r, top, h] = [base_radius, top_radius, height].map(Dyadic::to_f64);
            let (k, balls) = (r - top, ball(0.0, r).min(ball(h, top)));
            if k.abs() < h { balls.min(cone(r * h / k, k / ((h - k) * (h + k)).sqrt())) } else { balls }
        }
        Solid::Tube { inner, outer, .. } => tube(inner.to_f64()).min(tube(outer.to_f64())).min(off_plane),
        Solid::Torus { major, minor } => torus([major.to_f64(), minor.to_f64()], o, d),
        Solid::Plane | Solid::Disc { .. } | Solid::Annulus { .. } | Solid::Rectangle { .. } => off_plane,
        Solid::Cuboid { .. } => x.abs().min(y.abs()).min(z.abs()),
        Solid::RoundedCuboid(RoundedCuboid { half, radius }) => {
            let ([hx, hy, hz], r) = (half.each_ref().map(Dyadic::to_f64), radius.to_f64());
            let corners = (0..8).map(|i| {
                let sign = |bit: i32, h: f64| if i & bit == 0 { h } else { -h };
                add(o, [sign(1, hx), sign(2, hy), sign(4, hz)])
            });
            corners.fold(x.abs().min(y.abs()).min(z.abs()), |least, o| {
                let w = cross(o, d);
                let of_edge = |axis: usize| {
                    let across = (1.0 - d[axis] * d[axis]).sqrt();
                    across.min((1.0 - w[axis].abs() / (across * r)).abs())
                };
                let of_ball = (1.0 - dot(w, w).sqrt() / r).abs();
                least.min(of_ball).min(of_edge(0)).min(of_edge(1)).min(of_edge(2))
            })
        }
        Solid::HalfSpaces(of) => of.faces.iter().fold(1.0, |least: f64, face| {
            let n = face.normal.each_ref().map(Dyadic::to_f64);
            least.min(dot(n, d).abs() / dot(n, n).sqrt())
        }),
        Solid::Triangle { vertices } => {
            let [a, b, c] = vertices.each_ref().map(|vertex| vertex.each_ref().map(Dyadic::to_f64));
            let n = cross(add(b, scale(a, -1.0)), add(c, scale(a, -1.0)));
            dot(n, d).abs() / dot(n, n).sqrt()
        }
    };
    // Nothing to divide by is along an axis.
    if least.is_nan() { 0.0 } else { least }
}

/// The same for a torus, where the polynomial along the line is least or greatest: the depth over the minor radius.
fn torus([major, minor]: [f64; 2], o: [f64; 3], d: [f64; 3]) -> f64 {
    // From the point nearest to the centre the polynomial is u^4 + 2 p u^2 + 4 q u + s, and its derivative is
    // 4 (u^3 + p u + q).
    let o = add(o, scale(d, -dot(o, d)));
    let p = dot(o, o) - major * major - minor * minor + 2.0 * (major * d[1]).powi(2);
    let q = 2.0 * major * major * o[1] * d[1];
    // Viète: three roots, or else Cardano's one.
    let square = q * q / 4.0 + p * p * p / 27.0;
    let roots = if square < 0.0 {
        let (length, angle) = ((-p / 3.0).sqrt(), libm::acos((-q / 2.0 / (-p / 3.0).powf(1.5)).clamp(-1.0, 1.0)));
        [0.0, 1.0, 2.0].map(|i| 2.0 * length * libm::cos((angle + i * std::f64::consts::TAU) / 3.0))
    } else {
        let larger = -q / 2.0 - square.sqrt().copysign(q);
        let one = libm::cbrt(larger);
        // Of a root that is twice there, there is another one, which is half of that and of the other sign.
        let one = if one == 0.0 { 0.0 } else { one - p / (3.0 * one) };
        [one, -one / 2.0, one]
    };
    roots.into_iter().fold(1.0, |least: f64, u| {
        let [x, y, z] = add(o, scale(d, u));
        least.min(((x.hypot(z) - major).hypot(y) / minor - 1.0).abs())
    })
}

impl<S: Number> Judged<'_, S> {
    /// One unit in the last place of the size.
    pub fn unit_of_size(&self) -> Dyadic {
        S::unit_at(&(&exact_f64(self.size)).into())
    }

    /// True if a hit is so near to the start that its position is judged, not its `t`.
    pub fn is_near(&self, t: f64) -> bool {
        t.abs() < NEAR * self.size
    }

    /// The units that the tier promises of this ray's `t`; `None` where it promises none.
    pub fn limit(&self, tier: &str) -> Option<f64> {
        let is_float = ["f32", "f64"].contains(&S::name().as_str());
        match tier {
            "Exact" => Some(1.0),
            "Stable" if !is_float => Some(1.0),
            "Stable" => match clearance(self.solid, self.line) {
                away if away > AWAY => Some(16.0),
                grazing if grazing >= NEAREST => Some(31.0),
                _ => None,
            },
            _ => None,
        }
    }

    /// Whether the tier's promise leaves room for these hits, which are others than the exact ones. A ray that departs
    /// outwards from a convex solid never meets it.
    pub fn excuses(&self, tier: &str, told: &[Told<S>]) -> bool {
        let departs = |leaving| self.ray.departure().is_some_and(|departure| departure.leaving == leaving);
        let from_inside = || self.ray.departure().is_some_and(|departure| departure.part == Part::Inner);
        let may_return = match self.solid {
            Solid::Revolved(revolved) => revolved.has_waist(),
            Solid::Tube { .. } => from_inside(),
            Solid::Torus { .. } => true,
            _ => false,
        };
        let must_miss = (departs(Leaving::Outwards) && !may_return) || (departs(Leaving::Inwards) && tier != "Plain");
        if must_miss && self.want.hits.is_empty() {
            return false;
        }
        match tier {
            "Exact" => false,
            "Stable" => self.is_within_units(0),
            "Plain" => {
                let nearest = match self.solid {
                    Solid::Cone { .. } | Solid::Frustum { .. } | Solid::RoundCone(_) => NEAREST_TO_CONE,
                    Solid::Torus { .. } => NEAREST_TO_TORUS,
                    _ => NEAREST,
                };
                !self.is_plain(10.0, nearest)
                    || self.away() > MOST_OF_NARROWEST * self.narrowest
                    || told.len() == self.want.hits.len()
                    || self.differs_at_start(told, 4)
                    // Farther beside, a ray may have the same hits for another reason.
                    || self.is_within_units(6)
                    || self.is_within_units(4)
            }
            "Fast" => !self.is_plain(100.0, NEAREST) || self.differs_at_start(told, 4) || self.is_within_units(4),
            _ => true,
        }
    }

    /// Whether hits differ only within `2^power` units of the size from the start, which then is as near to the
    /// surface.
    fn differs_at_start(&self, told: &[Told<S>], power: isize) -> bool {
        let unit = self.unit_of_size().scaled(power);
        let is_off = |t: &Root| t.error_in(&S::ZERO.exact(), &unit) > 1.0;
        let told: Vec<_> = told.iter().filter(|hit| is_off(&(&hit.t.exact()).into())).collect();
        let want: Vec<_> = self.want.hits.iter().filter(|hit| is_off(&hit.t)).collect();
        let same = |(told, want): (&&Told<S>, &&ExpectedHit)| {
            told.surface
                .is_none_or(|(part, crossing)| same_part(part, want.part) && same_crossing(crossing, want.crossing))
        };
        told.len() == want.len() && told.iter().zip(&want).all(same)
    }

    /// Whether the ray has other hits twice `2^power` units of the size beside, along an axis of the solid's frame:
    /// then it is within so many units, or twice as many, of touching, of a rim, or of a start on the surface.
    fn is_within_units(&self, power: isize) -> bool {
        let unit = self.unit_of_size().scaled(power + 1);
        (0..6).any(|side| {
            let mut beside = self.line.clone();
            let off = if side < 3 { unit.clone() } else { -&unit };
            beside.origin[side % 3] = &beside.origin[side % 3] + &off;
            !are_alike(self.want, &expected_of(self.solid, &beside, self.ray))
        })
    }

    /// How far the start is from the first hit, or from the point that is next to the frame's origin.
    fn away(&self) -> f64 {
        self.want.hits.first().map_or_else(|| nearest_to_origin(self.line), |hit| hit.t.to_f64()).abs()
    }

    /// Whether the ray is plain, is so far from grazing, and starts within so many sizes. A ray that meets nothing
    /// starts as far away as its point next to the frame's origin.
    pub fn is_plain(&self, sizes: f64, nearest: f64) -> bool {
        // A direction is not known well enough to tell on which side of a generator or a face such a ray leads.
        if self.away() > sizes * self.size || clearance(self.solid, self.line) < nearest {
            return false;
        }
        // The chord that a ray starts in counts from its beginning.
        let whole = expected_of(self.solid, self.line, &self.ray.without_departure().with_range(Range::line()));
        let gaps = whole.hits.windows(2).map(|pair| pair[1].t.to_f64() - pair[0].t.to_f64());
        match gaps.reduce(f64::min) {
            Some(shortest) => shortest >= 1e-2 * self.size,
            None => clearance(self.solid, self.line) >= AWAY,
        }
    }
}

/// The `t` at which a line comes nearest to its frame's origin.
fn nearest_to_origin(line: &Line) -> f64 {
    let [o, d] = [&line.origin, &line.direction].map(|v| v.each_ref().map(Dyadic::to_f64));
    -dot(o, d) / dot(d, d)
}

/// Whether the hits are the same, whatever their `t`.
fn are_alike(one: &InRange, other: &InRange) -> bool {
    let same = |(a, b): (&ExpectedHit, &ExpectedHit)| (a.part, a.crossing) == (b.part, b.crossing);
    one.hits.len() == other.hits.len() && one.hits.iter().zip(&other.hits).all(same)
}
