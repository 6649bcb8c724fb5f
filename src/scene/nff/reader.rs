//! Conversion of entities to objects, materials, lights and a camera.

use super::error::{NffError, Place, Reason};
use super::lexer::Lexer;
use super::numbers::{Number, Numbers};
use super::polygon::{Corner, contradicts_its_normals, triangulate};
use super::{Counts, SHORTEST_POINT, Scale, Stores, View};
use crate::frame::Frame;
use crate::primitive::{Cone, Cylinder, Sphere, Triangle};
use crate::scalar::Scalar;
use crate::scene::{Camera, Color, Light, Material, Object, Store};
use crate::shape::{Primitive, Shape, Visible};
use crate::vector::{UnitVec3, Vec3};

/// Reads one text into the stores.
pub(super) struct Reader<'t, 'a, S: Scalar> {
    text: &'t str,
    numbers: Numbers<'t, S>,
    stores: Stores<'a, S>,
    material: Material<S>,
    materials: u32,
    normals: u32,
    invisible: u32,
    turned: u32,
    distant: u32,
}

/// The parts of a `v` entity that make a camera.
struct Viewpoint<S: Scalar> {
    camera: Camera<S>,
    resolution: [u16; 2],
    hither: S,
}

impl<'t, 'a, S: Scalar> Reader<'t, 'a, S> {
    pub(super) fn new(text: &'t str, stores: Stores<'a, S>, scale: Scale) -> Self {
        Self {
            text,
            numbers: Numbers::new(text, scale),
            stores,
            material: Material::default(),
            materials: 0,
            normals: 0,
            invisible: 0,
            turned: 0,
            distant: 0,
        }
    }

    pub(super) fn read(self) -> Result<View<S>, NffError> {
        let text = self.text;
        self.entities().map_err(|error| not_text_at(text, error.place).unwrap_or(error))
    }

    fn entities(mut self) -> Result<View<S>, NffError> {
        let mut viewpoint = None;
        let mut background = None;
        // The strength of a light without a colour depends on lights that come later: they are counted first.
        let lights = u32::try_from(Counts::of(self.text).lights).unwrap_or(u32::MAX);
        let strength = Light::<S>::usual_strength(lights);
        while let Some(entity) = self.numbers.word() {
            let place = entity.place;
            match entity.text {
                "v" if viewpoint.is_some() => return Err(NffError { place, reason: Reason::SecondView }),
                "v" => viewpoint = Some(self.viewpoint()?),
                "b" if background.is_some() => return Err(NffError { place, reason: Reason::SecondBackground }),
                "b" => background = Some(Color::from(self.numbers.color("the background")?)),
                "l" => self.light(place, strength)?,
                "f" => self.material(place)?,
                "c" => self.cone(place)?,
                "s" => self.sphere(place)?,
                "p" => self.polygon(place, false)?,
                "pp" => self.polygon(place, true)?,
                _ => return Err(NffError { place, reason: Reason::UnknownEntity }),
            }
        }
        let Some(Viewpoint { camera, resolution, hither }) = viewpoint else {
            return Err(NffError { place: self.numbers.place(), reason: Reason::NoView });
        };
        let background = background.unwrap_or(Color::BLACK);
        let Self { invisible, turned, distant, .. } = self;
        Ok(View { camera, resolution, hither, background, invisible, turned, distant })
    }

    fn viewpoint(&mut self) -> Result<Viewpoint<S>, NffError> {
        let (mut from, mut at, mut up, mut angle, mut hither, mut resolution) = (None, None, None, None, None, None);
        while let Some(word) = self.numbers.peek() {
            let place = word.place;
            let numbers = &mut self.numbers;
            let mut value = |keyword: &'static str, taken: bool| {
                if taken {
                    return Err(NffError { place, reason: Reason::TwiceInView { keyword } });
                }
                numbers.word();
                Ok(())
            };
            match word.text {
                "from" => {
                    value("from", from.is_some())?;
                    from = Some((place, numbers.point("the view's from")?));
                }
                "at" => {
                    value("at", at.is_some())?;
                    at = Some((place, numbers.point("the view's at")?));
                }
                "up" => {
                    value("up", up.is_some())?;
                    up = Some((place, numbers.vector("the view's up")?));
                }
                "angle" => {
                    value("angle", angle.is_some())?;
                    angle = Some((place, numbers.number("the view's angle")?.value));
                }
                "hither" => {
                    value("hither", hither.is_some())?;
                    hither = Some(numbers.distance("the view's hither")?);
                }
                "resolution" => {
                    value("resolution", resolution.is_some())?;
                    resolution = Some([self.pixels()?, self.pixels()?]);
                }
                _ => break,
            }
        }
        let place = self.numbers.place();
        let missing = |keyword| NffError { place, reason: Reason::MissingInView { keyword } };
        let (from_place, from) = from.ok_or(missing("from"))?;
        let (at_place, at) = at.ok_or(missing("at"))?;
        let (up_place, up) = up.ok_or(missing("up"))?;
        let (angle_place, angle) = angle.ok_or(missing("angle"))?;
        let resolution = resolution.ok_or(missing("resolution"))?;
        let camera = Camera::new(from, at, up, angle).map_err(|error| {
            use crate::scene::CameraError as Fault;
            let place = match error {
                Fault::Position => from_place,
                Fault::Target => at_place,
                Fault::Up | Fault::Axes => up_place,
                Fault::Angle | Fault::Height => angle_place,
            };
            NffError { place, reason: Reason::Camera(error) }
        })?;
        Ok(Viewpoint { camera, resolution, hither: hither.unwrap_or(S::ZERO) })
    }

    fn pixels(&mut self) -> Result<u16, NffError> {
        let place = self.numbers.place();
        let what = "the view's resolution";
        match self.numbers.count(what)? {
            0 => Err(NffError { place, reason: Reason::NotACount { what } }),
            pixels => Ok(pixels),
        }
    }

    fn light(&mut self, place: Place, strength: S) -> Result<(), NffError> {
        let what = "the light's position";
        let words = self.numbers.clone();
        let mut light = match self.numbers.point(what) {
            Ok(position) => Light::new(position, strength),
            Err(error) if matches!(error.reason, Reason::BeyondBudget { .. }) => {
                self.numbers = words;
                self.distant = self.distant.saturating_add(1);
                Light::distant(self.numbers.direction(what)?.ok_or(error)?, strength)
            }
            Err(error) => return Err(error),
        };
        if self.numbers.number_follows() {
            for channel in &mut light.strength {
                *channel = self.numbers.not_negative("the light's colour")?;
            }
        }
        store(self.stores.lights, light, "lights", place)
    }

    fn material(&mut self, place: Place) -> Result<(), NffError> {
        let mut material = Material {
            color: self.numbers.color("the material's colour")?.into(),
            diffuse: self.numbers.not_negative("the material's Kd")?,
            specular: self.numbers.not_negative("the material's Ks")?,
            shine: self.numbers.saturated("the material's shine")?,
            transmittance: self.numbers.not_negative("the material's T")?,
            refraction: self.numbers.not_negative("the material's index of refraction")?,
            ..Material::default()
        };
        material.mirror = material.specular;
        self.add_material(place, material)
    }

    fn add_material(&mut self, place: Place, material: Material<S>) -> Result<(), NffError> {
        store(self.stores.materials, material, "materials", place)?;
        self.material = material;
        self.materials = self.materials.saturating_add(1);
        Ok(())
    }

    /// Adds a shape with the current material.
    fn object(&mut self, place: Place, shape: Shape<S>, smooth: Option<u32>, inside: bool) -> Result<(), NffError> {
        if self.materials == 0 {
            self.add_material(place, Material::default())?;
        }
        let visible = match (self.material.transmits(), inside) {
            (true, _) => Visible::Both,
            (false, true) => Visible::Inside,
            (false, false) => Visible::Outside,
        };
        let object = Object { smooth, ..Object::new(shape.seen_from(visible), self.materials - 1) };
        store(self.stores.objects, object, "objects", place)
    }

    fn leave_out(&mut self) {
        self.invisible = self.invisible.saturating_add(1);
    }

    fn sphere(&mut self, place: Place) -> Result<(), NffError> {
        let what = "the sphere's radius";
        let center = self.numbers.point("the sphere's centre")?;
        let radius = self.numbers.size(what)?;
        if radius.vanished {
            self.leave_out();
            return Ok(());
        }
        let zero = NffError { place: radius.place, reason: Reason::ZeroRadius { what } };
        let sphere = Sphere::new(radius.value.magnitude()).map_err(|_| zero)?;
        let frame = Frame::at(center).map_err(|_| zero)?;
        self.object(place, Shape::new(sphere).placed(frame), None, radius.value < S::ZERO)
    }

    fn cone(&mut self, place: Place) -> Result<(), NffError> {
        let base_words = self.numbers.clone();
        let base = self.numbers.point("the cone's base")?;
        let base_radius = self.numbers.size("the cone's base radius")?;
        let apex_words = self.numbers.clone();
        let apex = self.numbers.point("the cone's apex")?;
        let apex_radius = self.numbers.size("the cone's apex radius")?;
        let is_zero = |radius: Number<S>| radius.value == S::ZERO;
        if is_zero(base_radius) && is_zero(apex_radius) {
            if base_radius.vanished || apex_radius.vanished {
                self.leave_out();
                return Ok(());
            }
            let reason = Reason::ZeroRadius { what: "the cone's larger radius" };
            return Err(NffError { place: base_radius.place, reason });
        }
        let inside = base_radius.value < S::ZERO || apex_radius.value < S::ZERO;
        let outside = base_radius.value > S::ZERO || apex_radius.value > S::ZERO;
        if inside && outside {
            return Err(NffError { place: apex_radius.place, reason: Reason::MixedRadii });
        }
        if base == apex {
            let mut pairs = core::iter::zip(base_words.texts(), apex_words.texts()).take(3);
            if pairs.all(|(base, apex)| base == apex) {
                return Err(NffError { place: apex_words.place(), reason: Reason::ZeroLength });
            }
            // The points differ in the text, and are equal after rounding.
            self.leave_out();
            return Ok(());
        }
        let (base_radius, apex_radius) = (base_radius.value.magnitude(), apex_radius.value.magnitude());
        let shape =
            tube(base, base_radius, apex, apex_radius).ok_or(NffError { place, reason: Reason::Proportions })?;
        self.object(place, shape, None, inside)
    }

    fn polygon(&mut self, place: Place, patch: bool) -> Result<(), NffError> {
        let count_place = self.numbers.place();
        let count: u32 = self.numbers.count("the number of corners")?;
        if count < 3 {
            return Err(NffError { place: count_place, reason: Reason::TooFewCorners });
        }
        let (room, remaining) = (self.stores.corners.len(), self.numbers.remaining());
        let can_hold = usize::try_from(count).is_ok_and(|count| count <= remaining / SHORTEST_POINT);
        let reason =
            if can_hold { Reason::TooManyCorners { room } } else { Reason::EndsBeforeCorners { corners: count } };
        let too_many = NffError { place: count_place, reason };
        // Taken out of `self`, so that triangles can be added while they are cut.
        let scratch = core::mem::take(&mut self.stores.corners);
        let corners = usize::try_from(count).ok().and_then(|count| scratch.get_mut(..count)).ok_or(too_many)?;
        for corner in &mut *corners {
            let point = self.numbers.point("the corner's position")?;
            let mut normal = UnitVec3::Y;
            if patch {
                let place = self.numbers.place();
                let vector = self.numbers.vector("the corner's normal")?;
                normal = UnitVec3::new(vector).map_err(|_| NffError { place, reason: Reason::ZeroNormal })?;
            }
            *corner = Corner { point, normal };
        }
        if patch && contradicts_its_normals(corners) {
            turn_around(corners);
            self.turned = self.turned.saturating_add(1);
        }
        let triangles = triangulate(corners, |[a, b, c]| {
            let Ok(triangle) = Triangle::new(a.point, b.point, c.point) else {
                self.leave_out();
                return Ok(());
            };
            let mut smooth = None;
            if patch {
                store(self.stores.normals, [a.normal, b.normal, c.normal], "corner normals", place)?;
                smooth = Some(self.normals);
                self.normals = self.normals.saturating_add(1);
            }
            self.object(place, Shape::new(triangle), smooth, false)
        })?;
        if triangles == 0 {
            self.leave_out();
        }
        self.stores.corners = scratch;
        Ok(())
    }
}

/// The error for a word that is not valid text, if the word at this place is one.
fn not_text_at(text: &str, place: Place) -> Option<NffError> {
    let word = Lexer::new(text).find(|word| word.place == place)?;
    let (before, _) = word.text.split_once(char::REPLACEMENT_CHARACTER)?;
    let columns = u32::try_from(before.chars().count()).unwrap_or(u32::MAX);
    let place = Place { column: place.column.saturating_add(columns), ..place };
    Some(NffError { place, reason: Reason::NotText })
}

/// Puts an item into a store, or says which store is full.
fn store<T>(store: &mut dyn Store<T>, item: T, name: &'static str, place: Place) -> Result<(), NffError> {
    store.push(item).map_err(|_| NffError { place, reason: Reason::Full { store: name } })
}

/// Reverses the order of the corners. (`reverse` of slices may be compiled to code with a panic.)
fn turn_around<S: Scalar>(corners: &mut [Corner<S>]) {
    if let Some((first, last)) = corners.split_at_mut_checked(corners.len() / 2) {
        for (a, b) in first.iter_mut().zip(last.iter_mut().rev()) {
            core::mem::swap(a, b);
        }
    }
}

/// An open cylinder or cone between two points; `None` if the number type cannot hold it.
fn tube<S: Scalar>(base: Vec3<S>, base_radius: S, apex: Vec3<S>, apex_radius: S) -> Option<Shape<S>> {
    let (frame, height) = Frame::between(base, apex).ok()?;
    let primitive: Primitive<S> = if base_radius == apex_radius {
        Cylinder::open(base_radius, height).ok()?.into()
    } else {
        Cone::frustum_open(base_radius, apex_radius, height).ok()?.into()
    };
    Some(Shape::new(primitive).placed(frame))
}
