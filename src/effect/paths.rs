//! The paths of light from the eye: a chain where surfaces only mirror, a tree where they refract; and the order in
//! which their rays are cast.

use super::Sample;
use super::compiled::Effects;
use super::cutoff::{self, DEPTH};
use super::media::Passage;
use super::set::Effect;
use super::trace_context::TraceContext;
use super::tracer::Tracer;
use crate::ray::Ray;
use crate::scalar::{Ring, Scalar, UnitScalar};
use crate::scene::{Candidates, Color, Levels, Observer, SceneHit};
use crate::shape::kinds::Kinds;
use crate::tier::Tier;

/// Rays of a smaller weight than this power of two are deferred.
const FAINT: i32 = -7;

/// A ray that is to be cast, with its weight and depth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment<S: Scalar> {
    pub(super) ray: Ray<S>,
    /// What is known of its start.
    pub(super) passage: Passage,
    /// The fraction of its radiance that reaches the eye, in `[0, 1]`.
    pub(super) weight: S::Unit,
    /// The number of surfaces on the path before it.
    pub(super) depth: u8,
    /// Reflection or refraction; `None` for the primary ray.
    pub(super) cause: Option<Effect>,
    /// True inside a transparent object.
    pub(super) enclosed: bool,
}

/// The light that has been gathered for one primary ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gathered<S: Scalar> {
    /// The light.
    pub(super) light: [S::Unit; 3],
    /// The first hit of the primary ray, and the lights that reach it.
    pub(crate) first: Option<SceneHit<S>>,
    pub(super) lit_by: u32,
}

impl<S: Scalar, E: Effects, T: Tier<S>, K: Kinds> Tracer<'_, S, E, T, K> {
    /// The light that a ray brings and its first hit; as [`Tracer::look`], with other levels for the cut-off, for
    /// displays and for sums of samples.
    #[inline(always)]
    pub(crate) fn gather<O: Observer>(
        &self,
        ray: &Ray<S>,
        candidates: Candidates,
        levels: Levels,
        context: &mut TraceContext<O>,
    ) -> Gathered<S> {
        let mut gathered = Gathered::new();
        if self.uses(Effect::Refraction) {
            self.follow_tree((ray, candidates), &mut gathered, levels, context);
        } else if self.uses(Effect::Reflection) {
            self.follow_chain((ray, candidates), &mut gathered, levels, context);
        } else {
            self.meet(Segment::from_eye(*ray), candidates, &mut gathered, context);
        }
        gathered
    }

    /// Upper bound of the light that rays of this weight contribute.
    fn at_most(&self, weight: S::Real) -> [S::Real; 3] {
        self.brightest.map(|brightest| weight * brightest)
    }

    /// Follows a path that does not branch, until the rest of it cannot change a level.
    ///
    /// Not inlined, so that tracing a scene without reflection does not take its stack frame.
    #[inline(never)]
    fn follow_chain<O: Observer>(
        &self,
        (ray, mut candidates): (&Ray<S>, Candidates),
        gathered: &mut Gathered<S>,
        levels: Levels,
        context: &mut TraceContext<O>,
    ) {
        let mut next = Some(Segment::from_eye(*ray));
        while let Some(segment) = next {
            [next, _] = self.meet(segment, candidates, gathered, context);
            next = next.filter(|next| {
                let left = self.at_most(S::unit_real(next.weight));
                self.uncut || !cutoff::is_settled::<S>(gathered.light, left, levels)
            });
            if let Some(next) = &next {
                candidates = self.candidates(&next.ray);
            }
        }
    }

    /// Follows a path that may branch at each surface, until the rest of it cannot change a level.
    ///
    /// Rays of small weight are deferred, and cast last in order of decreasing weight. Not inlined, so that tracing a
    /// scene without refraction takes no stack for the lists.
    #[inline(never)]
    fn follow_tree<O: Observer>(
        &self,
        first: (&Ray<S>, Candidates),
        gathered: &mut Gathered<S>,
        levels: Levels,
        context: &mut TraceContext<O>,
    ) {
        // Where more rays are deferred than there is room for, the weakest are left out. If they could change a level,
        // which is rare, the path is followed again without leaving any out.
        if self.uncut || !self.follow(first, true, gathered, levels, context) {
            *gathered = Gathered::new();
            self.follow(first, false, gathered, levels, context);
        }
    }

    /// False if rays were left out that could change a level.
    fn follow<O: Observer>(
        &self,
        (ray, mut candidates): (&Ray<S>, Candidates),
        leaves_out: bool,
        gathered: &mut Gathered<S>,
        levels: Levels,
        context: &mut TraceContext<O>,
    ) -> bool {
        let faint = S::unit_round(S::Real::ONE.scaled(FAINT));
        let mut waiting = heapless::Vec::<Segment<S>, { DEPTH as usize + 1 }>::new();
        let mut aside = heapless::Vec::<Segment<S>, { DEPTH as usize }>::new();
        let mut left_out = S::Real::ZERO;
        let mut next = Some(Segment::from_eye(*ray));
        while let Some(segment) = next {
            let sent_on = self.meet(segment, candidates, gathered, context);
            for mut onward in sent_on.into_iter().flatten() {
                if onward.weight < faint && !self.uncut {
                    match aside.push(onward) {
                        Ok(()) => continue,
                        Err(no_room) if leaves_out => {
                            let weakest = exchanged(&mut aside, no_room, |weight, best| weight < best);
                            left_out = left_out + S::unit_real(weakest.weight);
                            if !cutoff::is_settled::<S>(gathered.light, self.at_most(left_out), levels) {
                                return false;
                            }
                            continue;
                        }
                        Err(no_room) => onward = no_room,
                    }
                }
                // Cannot be full: at most one ray waits for each smaller depth, and two for the current one.
                let pushed = waiting.push(onward);
                debug_assert!(pushed.is_ok());
            }
            next = waiting.pop();
            if next.is_none() {
                let weights = aside.iter().fold(left_out, |sum, segment| sum + S::unit_real(segment.weight));
                if cutoff::is_settled::<S>(gathered.light, self.at_most(weights), levels) {
                    return true;
                }
                next = aside.pop().map(|last| exchanged(&mut aside, last, |weight, best| weight > best));
            }
            if let Some(next) = &next {
                candidates = self.candidates(&next.ray);
            }
        }
        false
    }
}

/// The ray of the best weight among a list and one more; the others are the list.
fn exchanged<S: Scalar>(
    list: &mut [Segment<S>],
    one: Segment<S>,
    is_better: impl Fn(S::Unit, S::Unit) -> bool,
) -> Segment<S> {
    let (mut best, mut weight) = (None, one.weight);
    for segment in list {
        if is_better(segment.weight, weight) {
            (weight, best) = (segment.weight, Some(segment));
        }
    }
    match best {
        Some(segment) => core::mem::replace(segment, one),
        None => one,
    }
}

impl<S: Scalar> Segment<S> {
    pub(super) fn from_eye(ray: Ray<S>) -> Self {
        Self { ray, passage: Passage::new(), weight: S::Unit::ONE, depth: 0, cause: None, enclosed: false }
    }
}

impl<S: Scalar> Gathered<S> {
    pub(super) fn new() -> Self {
        Self { light: [S::Unit::ZERO; 3], first: None, lit_by: 0 }
    }

    pub(super) fn gather(&mut self, light: [S::Unit; 3]) {
        for (sum, light) in self.light.iter_mut().zip(light) {
            *sum = sum.plus(light);
        }
    }

    pub(super) fn add(&mut self, color: Color<S>, weight: S::Unit) {
        self.gather(color.to_array().map(|channel| channel.times(weight)));
    }

    pub(crate) fn sample(&self) -> Sample<S> {
        Sample { color: self.light.into(), seen: self.first.map(|on| (on.object, on.hit.part)), lit_by: self.lit_by }
    }
}

#[cfg(units)]
#[path = "../../tests/units/effect/paths.rs"]
mod tests;
