//! The media along a path: which transparent solids its next ray starts inside of, and what lies on the two sides of a
//! place where surfaces meet.
//!
//! A point lies in the medium of the transparent solid that is listed last among those that it is inside of, and in
//! none outside of all. So water in a glass is modelled by a body of water that is listed after the glass and overlaps
//! its wall. Surfaces that the number type cannot tell apart are one place, with one medium before it and one behind
//! it; an interface is where these differ.
//!
//! An open surface has no inside. Its material is taken to lie behind it, the medium of the solids around in front of
//! it.

use super::compiled::Effects;
use super::set::Effect;
use crate::hierarchy::search::Known;
use crate::hit::Crossing;
use crate::part::Part;
use crate::ray::{Departure, Leaving, Ray};
use crate::scalar::Scalar;
use crate::scene::{Candidates, Material, Scene, SceneHit, near};
use crate::shape::Visible;
use crate::shape::kinds::Kinds;
use crate::shape::known::stays;
use crate::tier::Tier;
use core::marker::PhantomData;

/// The most objects that a path remembers. Of others its coordinates decide whether it is inside of them.
const MOST: usize = 6;

/// What a path knows of one object.
#[derive(Clone, Copy, Debug)]
struct Relation {
    object: u32,
    /// The path is inside of it. Only of transparent solids.
    is_inside: bool,
    /// The next ray departs from it.
    departs: Option<(Part, Leaving)>,
}

/// What a path knows of the objects around the start of its next ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passage {
    known: [Relation; MOST],
    /// How many of them are known.
    count: u8,
    /// False for a ray that begins a path, whose coordinates decide what it is inside of.
    continues: bool,
    /// There was no room for an object.
    is_full: bool,
}

impl Passage {
    /// That of a ray that begins a path.
    pub(super) const fn new() -> Self {
        let unknown = Relation { object: 0, is_inside: false, departs: None };
        Self { known: [unknown; MOST], count: 0, continues: false, is_full: false }
    }

    /// Notes that the path is inside of a solid.
    pub(super) fn enter(&mut self, object: u32) {
        self.note(Relation { object, is_inside: true, departs: None });
    }

    fn note(&mut self, relation: Relation) {
        match self.known.get_mut(usize::from(self.count)) {
            Some(free) => (*free, self.count) = (relation, self.count + 1),
            None => self.is_full = true,
        }
    }

    fn relations(&self) -> impl Iterator<Item = &Relation> + Clone {
        self.known.iter().take(self.count.into())
    }

    /// True for a ray that begins a path.
    pub(super) fn begins(&self) -> bool {
        !self.continues
    }

    fn of(&self, object: u32) -> Option<&Relation> {
        self.relations().find(|relation| relation.object == object)
    }

    /// The transparent solids that the path is inside of.
    fn solids(&self) -> impl Iterator<Item = u32> + '_ {
        self.relations().filter(|relation| relation.is_inside).map(|relation| relation.object)
    }

    /// That of the next ray from a place where these surfaces are met at `t`: behind it if the path `crosses` it,
    /// before it if not.
    pub(super) fn at<S: Scalar, K: Kinds>(
        &self,
        place: &Place<'_, S>,
        crosses: bool,
        ray: &Ray<S>,
        scene: &Scene<'_, S, impl Tier<S>, K>,
    ) -> Self {
        let mut next = Self { continues: true, is_full: self.is_full, ..Self::new() };
        for on in place.met {
            let leaving = match on.hit.crossing {
                Crossing::Enter if crosses => Leaving::Inwards,
                Crossing::Exit if !crosses => Leaving::Inwards,
                _ => Leaving::Outwards,
            };
            let is_inside = leaving == Leaving::Inwards && is_tracked(scene, on.object);
            let departs = Some((on.hit.part, leaving));
            next.note(Relation { object: on.object, is_inside, departs });
        }
        // Where the point is still the ray's start, it is on the surfaces that the ray departed from, too.
        let stays = || stays(ray, place.seen.hit.t);
        for relation in self.relations() {
            let departs = relation.departs.filter(|_| stays());
            if (relation.is_inside || departs.is_some()) && !place.meets(relation.object) {
                next.note(Relation { departs, ..*relation });
            }
        }
        next
    }
}

/// True for a solid whose material is transparent, and which is seen from both sides: a path knows whether it is
/// inside.
pub(super) fn is_tracked<S: Scalar, K: Kinds>(scene: &Scene<'_, S, impl Tier<S>, K>, object: u32) -> bool {
    let Some(object) = scene.object(object) else { return false };
    scene.material_of(object, Part::Side).is_some_and(Material::transmits)
        && object.shape.visible() == Visible::Both
        && object.shape.is_solid()
}

/// What is known of a ray of a path among the objects of a scene, with the effects `E` compiled in.
pub(super) struct Along<'a, S: Scalar, T, K: Kinds, E> {
    scene: &'a Scene<'a, S, T, K>,
    ray: &'a Ray<S>,
    passage: &'a Passage,
    candidates: Candidates,
    /// Paths cross surfaces.
    refracts: bool,
    compiled: PhantomData<E>,
}

impl<'a, S: Scalar, T, K: Kinds, E> Along<'a, S, T, K, E> {
    pub(super) const fn new(
        scene: &'a Scene<'a, S, T, K>,
        ray: &'a Ray<S>,
        passage: &'a Passage,
        refracts: bool,
    ) -> Self {
        Self { scene, ray, passage, candidates: Candidates::ALL, refracts, compiled: PhantomData }
    }

    /// The same for a ray that meets no other objects than these.
    pub(super) const fn among(self, candidates: Candidates) -> Self {
        Self { candidates, ..self }
    }
}

impl<S: Scalar, T: Tier<S>, K: Kinds, E: Effects> Known<S> for Along<'_, S, T, K, E> {
    const KNOWS_INSIDE: bool = E::SET.contains(Effect::Refraction);
    const SHADES: bool = E::SET.contains(Effect::Ambient)
        || E::SET.contains(Effect::Diffuse)
        || E::SET.contains(Effect::Specular)
        || E::SET.contains(Effect::Reflection)
        || E::SET.contains(Effect::Refraction);

    #[inline(always)]
    fn shapes(&self) -> impl Iterator<Item = u32> + Clone {
        // The solids around the camera were found by their coordinates.
        let continues = self.passage.continues;
        self.passage.relations().filter(move |_| continues).map(|relation| relation.object)
    }
    #[inline(always)]
    fn departure_from(&self, object: u32) -> Option<Departure> {
        let (part, leaving) = self.passage.of(object)?.departs?;
        Some(Departure { object, part, leaving })
    }
    #[inline(always)]
    fn is_inside(&self, object: u32) -> Option<bool> {
        if !self.refracts || self.passage.begins() {
            return None;
        }
        match self.passage.of(object) {
            Some(relation) if relation.is_inside => Some(true),
            _ => (!self.passage.is_full && is_tracked(self.scene, object)).then_some(false),
        }
    }
    #[inline(always)]
    fn near(&self, t: S) -> S {
        near(self.ray, t)
    }
    #[inline(always)]
    fn may_meet(&self, object: u32) -> bool {
        self.candidates.contain(object)
    }
}

/// A place on a ray where it meets one surface, or several that the number type cannot tell apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'m, S: Scalar> {
    /// The first hit of each object there. Mostly it is one, for which no list is made: LLVM copies all of a list, and
    /// a lit picture takes 140 instructions a pixel more on a Cortex-M0+.
    met: &'m [SceneHit<S>],
    /// The one whose material and normal are seen.
    pub(super) seen: SceneHit<S>,
}

/// The materials before and behind an interface; `None` outside of all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Media<'a, S: Scalar> {
    pub(super) before: Option<&'a Material<S>>,
    pub(super) behind: Option<&'a Material<S>>,
}

impl<S: Scalar> Media<'_, S> {
    /// Outside of all on both sides.
    pub(super) const fn none() -> Self {
        Self { before: None, behind: None }
    }

    /// True if there is a medium behind the interface, in which there is no fog.
    pub(super) const fn is_enclosed(&self) -> bool {
        self.behind.is_some()
    }
}

/// A transparent object that a point lies in, and the index of its material there.
type Owner = (u32, u32);

impl<'m, S: Scalar> Place<'m, S> {
    /// That of the hits of a ray, of which the first is `nearest`.
    #[inline(always)]
    pub(super) const fn of(met: &'m [SceneHit<S>], nearest: SceneHit<S>) -> Self {
        Self { met, seen: nearest }
    }

    fn meets(&self, object: u32) -> bool {
        self.met.iter().any(|on| on.object == object)
    }

    fn crossings(&self, crossing: Crossing) -> impl Iterator<Item = &SceneHit<S>> {
        self.met.iter().filter(move |on| on.hit.crossing == crossing)
    }

    /// Of several surfaces, the one that is seen where no path crosses any: the opaque one that is listed last, or, if
    /// none is opaque, the last of all. The same as in [`Scene::seen`]. True if it is opaque.
    pub(super) fn see_last<K: Kinds>(&mut self, scene: &Scene<'_, S, impl Tier<S>, K>) -> bool {
        if let Some(seen) = self.met.iter().max_by_key(|on| scene.rank(on)) {
            self.seen = *seen;
        }
        !scene.transmits(&self.seen)
    }

    /// The media on both sides of transparent surfaces, and whether they differ; where they do not, nothing is seen.
    /// Sees the surface of the object that is listed last among those whose medium ends or begins here.
    pub(super) fn separate<'a, K: Kinds>(
        &mut self,
        scene: &'a Scene<'_, S, impl Tier<S>, K>,
        passage: &Passage,
    ) -> (Media<'a, S>, bool) {
        let owner = |on: &SceneHit<S>| {
            scene.object(on.object).map(|object| -> Owner { (on.object, object.material_of(on.hit.part)) })
        };
        let around = |object: u32| scene.object(object).map(|at| -> Owner { (object, at.material_of(Part::Side)) });
        let elsewhere = || passage.solids().filter(|solid| !self.meets(*solid)).filter_map(around);
        let last = |sides: Crossing| self.crossings(sides).filter_map(owner).chain(elsewhere()).max();
        let (before, behind) = (last(Crossing::Exit), last(Crossing::Enter));
        let media =
            [before, behind].map(|owner| owner.and_then(|(_, material)| scene.materials().get(material as usize)));
        let [before_is, behind_is] = media;
        let crosses = self.met.iter().any(|on| on.hit.crossing != Crossing::Touch);
        let ends = [before, behind].map(|owner| owner.filter(|(object, _)| self.meets(*object)));
        let seen = ends.into_iter().flatten().max().map(|(object, _)| object);
        if let Some(seen) = seen.and_then(|object| self.met.iter().find(|on| on.object == object)) {
            self.seen = *seen;
        }
        let is_interface = !crosses || before_is != behind_is;
        (Media { before: before_is, behind: behind_is }, is_interface)
    }
}
