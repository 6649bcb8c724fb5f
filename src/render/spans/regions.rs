//! The columns of a row in which objects and shadows are seen.

use super::curve;
use super::known::{Known, KnownShadow, SHADOWS};
use super::search::{Found, Search};
use crate::effect::{Effects, TraceContext};
use crate::part::Part;
use crate::render::Picture;
use crate::scalar::Scalar;
use crate::scene::{Ball, Candidates, MOST, Observer, RaysOfRow, View};
use crate::shape::Outlined;
use crate::shape::kinds::Kinds;
use crate::tier::Tier;

/// The columns in which an object, its cap or its shadow is seen.
#[derive(Clone, Copy, Debug)]
struct Region {
    /// One of [`MOST`].
    object: u8,
    is_cap: bool,
    /// False if it is seen in some of these columns only.
    is_certain: bool,
    /// The first one, and the one after the last.
    columns: [u16; 2],
}

impl Region {
    fn new(object: u32, is_cap: bool, found: Found) -> Option<Self> {
        let (columns, is_certain) = match found {
            Found::Nowhere => return None,
            Found::Exactly(columns) => (columns, true),
            Found::Within(columns) => (columns, false),
        };
        Some(Self { object: object as u8, is_cap, is_certain, columns })
    }
}

/// The regions of a row.
#[derive(Clone, Debug)]
pub(super) struct Regions {
    /// Of the only plane, and of all other objects before any plane.
    seen: heapless::Vec<Region, { 2 * MOST }>,
    /// Of the shadows of these objects on the only plane; `None` if they are not known.
    shadows: Option<heapless::Vec<Region, SHADOWS>>,
}

/// What is seen from a column on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    /// The objects that are seen before any plane.
    pub(super) objects: Candidates,
    /// Those of them whose cap is seen.
    pub(super) caps: Candidates,
    /// The objects that may be seen in some columns.
    pub(super) doubtful: Candidates,
    /// True if the only plane is seen.
    pub(super) plane: bool,
    /// The column in which this may change.
    pub(super) until: u16,
}

impl Regions {
    /// Those of row `y`.
    #[inline(never)]
    pub(super) fn find<S: Scalar, E: Effects, O: Observer, T: Tier<S>, K: Kinds>(
        known: &Known,
        picture: &Picture<'_, S, E, T, K>,
        (y, rays): (u16, &RaysOfRow<'_, S>),
        context: &mut TraceContext<O>,
    ) -> Self {
        let row = known.directions.in_row(y, picture.size().height);
        let view = View::of(&picture.raster);
        let columns = |ball: &Ball, within: [u16; 2]| row.columns(&view.seen(ball), within);
        let mut regions = Self { seen: heapless::Vec::new(), shadows: None };
        let mut search = Search { picture, rays, known, context };
        if let Some(plane) = known.planes.only() {
            let found = match known.beyond.and_then(|normal| row.go_along(normal)) {
                Some(true) => Found::Exactly([0, picture.size().width]),
                Some(false) => Found::Nowhere,
                None => search.half_plane(plane),
            };
            regions.add(plane, false, found);
            if let Found::Exactly(columns) = found {
                regions.shadows = shadows_on(plane, (y, columns), &mut search);
            }
        }
        for (object, of) in (0_u32..).zip(&known.objects) {
            let [first, end] = of.ball.as_ref().map_or(of.columns, |ball| columns(ball, of.columns));
            if of.outlined == Outlined::Plane || first == end {
                continue;
            }
            let found = search.convex((object, of), None, [first, end]);
            regions.add(object, false, found);
            if let (Found::Exactly(whole), Outlined::Cap(part)) = (found, of.outlined) {
                let within = of.cap.as_ref().map_or(whole, |cap| columns(cap, whole));
                if within[0] < within[1] {
                    regions.add(object, true, search.convex((object, of), Some(part), within));
                }
            }
        }
        regions
    }

    fn add(&mut self, object: u32, is_cap: bool, found: Found) {
        // There is room for two of each.
        let _ = Region::new(object, is_cap, found).map(|region| self.seen.push(region));
    }

    /// What is seen from a column on, of a row of this width.
    pub(super) fn from(&self, x: u16, width: u16, planes: Candidates) -> Seen {
        let none = Candidates::NONE;
        let mut seen = Seen { objects: none, caps: none, doubtful: none, plane: false, until: width };
        for Region { object, is_cap, is_certain, columns: [first, end] } in self.seen.iter().copied() {
            if x < end {
                seen.until = seen.until.min(if x < first { first } else { end });
            }
            if x < first || x >= end {
                continue;
            }
            let object = u32::from(object);
            if !is_certain {
                seen.doubtful = seen.doubtful.with(object);
            } else if is_cap {
                seen.caps = seen.caps.with(object);
            } else if planes.contain(object) {
                seen.plane = true;
            } else {
                seen.objects = seen.objects.with(object);
            }
        }
        seen
    }

    /// The shadows on an object from a column of row `y` on.
    pub(super) fn shade(&self, known: &Known, object: u32, [x, y]: [u16; 2], end: u16) -> Shade {
        let mut shade = Shade { thrown_by: known.shading, is_even: true, until: end };
        if let Some(shadows) = self.shadows.as_ref().filter(|_| known.planes.contain(object)) {
            shadows.iter().for_each(|of| shade.add(of.object.into(), x, of.columns, of.is_certain));
        } else if known.planes.contain(object)
            && let Some(shadows) = &known.shadows
        {
            let seen = shadows.iter().filter_map(|shadow| Some((shadow.object, shadow.place.columns(y)?)));
            seen.for_each(|(object, columns)| shade.add(object, x, columns, false));
        } else if !known.planes.contain(object) {
            let anywhere = known.shaded_by(object);
            (shade.thrown_by, shade.is_even) = (shade.thrown_by.or(anywhere), anywhere.are_none());
            known.shadows_on(object, y).for_each(|(object, columns)| shade.add(object, x, columns, false));
        } else {
            return Shade { thrown_by: Candidates::ALL, is_even: false, until: end };
        }
        shade
    }

    /// The number of columns in which an object is seen, if a column is not next to their ends, where the surface of a
    /// round one turns away; and the column, up to an end, in which that may change.
    pub(super) fn middle(&self, object: u32, x: u16, until: u16) -> (Option<u16>, u16) {
        let whole = self.seen.iter().find(|region| u32::from(region.object) == object && region.is_certain);
        let Some(Region { columns: [first, end], .. }) = whole.copied() else { return (None, until) };
        let width = end - first;
        let middle = first + width / 8..end - width / 8;
        if x < middle.start {
            (None, until.min(middle.start))
        } else if x < middle.end {
            (Some(width), until.min(middle.end))
        } else {
            (None, until)
        }
    }
}

/// The shadows on an object from a column on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shade {
    /// The objects whose shadows may be there.
    pub(super) thrown_by: Candidates,
    /// True if none of them begins or ends there.
    pub(super) is_even: bool,
    /// The column in which that may change.
    pub(super) until: u16,
}

impl Shade {
    /// The shadow of an object in these columns, or in some of them.
    fn add(&mut self, object: u32, x: u16, [first, end]: [u16; 2], is_certain: bool) {
        if x < end {
            self.until = self.until.min(if x < first { first } else { end });
        }
        if (first..end).contains(&x) {
            self.thrown_by = self.thrown_by.with(object);
            self.is_even &= is_certain;
        }
    }
}

/// The shadows on the only plane, in these columns of row `y`: those that a convex solid throws on a plane lie within
/// one angle, too. `None` if they are of no use.
fn shadows_on<S: Scalar, E: Effects, O: Observer, T: Tier<S>, K: Kinds>(
    plane: u32,
    (y, seen): (u16, [u16; 2]),
    search: &mut Search<'_, '_, '_, S, E, O, T, K>,
) -> Option<heapless::Vec<Region, SHADOWS>> {
    let known = search.known;
    if known.longest(search.picture, (plane, Part::Side), None)[0] < curve::SHORTEST {
        return None;
    }
    let on = search.picture.tracer.scene().object(plane)?.shape.plane()?;
    let mut shadows = heapless::Vec::new();
    for KnownShadow { object, light, place } in known.shadows.as_ref()?.iter().copied() {
        let Some(columns) = place.columns(y) else { continue };
        let within = [columns[0].max(seen[0]), columns[1].min(seen[1])];
        if within[0] < within[1] {
            let found = search.shadow([object, light], (plane, on), within);
            // There is room for all.
            let _ = Region::new(object, false, found).map(|region| shadows.push(region));
        }
    }
    Some(shadows)
}
