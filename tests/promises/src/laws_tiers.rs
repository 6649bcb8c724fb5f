//! The promise: a finer tier sees what a coarser one sees, but for what the coarser one's bound decides.
//!
//! The bound is a distance in space, that of [`support::laws::bound`], and so is how near a ray is to a decision: two
//! tiers may differ where the chord that one of them sees is no deeper than twice the bound, where a hit is as near to
//! both parts, or where the ray's range starts as near to the surface. A tier that loses a hit anywhere else, or gives
//! it to another part, fails.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use raylet::tier::{Exact, Fast, Plain, Stable};
use raylet::{Hits, Range};
use support::amount::times;
use support::exact_types::Exact as Number;
use support::laws::{Grade, Graded, Law, Setting, bound, met};
use support::random::Random;

laws!(finer_tiers_see_the_same_crossings_on_the_same_parts);

mod law {
    use super::*;

    /// Law 4, of this tier against `Stable`, and of `Plain` and `Fast` against `Exact` too: `Exact` exists where the
    /// tier is it.
    pub(super) fn finer_tiers_see_the_same_crossings_on_the_same_parts<S: Number, T: Graded<S>>(
        setting: &Setting<S>,
        _: &mut Random,
    ) -> Law {
        if !setting.is_bounded() {
            return Ok(());
        }
        for range in [setting.ray.range(), Range::line()] {
            let ray = setting.ray.with_range(range);
            let hits = setting.shape.hits_at::<T>(&ray);
            let stable = setting.shape.hits_at::<Stable>(&ray);
            match T::GRADE {
                Grade::Plain | Grade::Fast => same::<S, T>(setting, &ray, &hits, &stable)?,
                Grade::Stable => {}
                Grade::Exact => {
                    same::<S, Stable>(setting, &ray, &stable, &hits)?;
                    let fast = setting.shape.hits_at::<Fast>(&ray);
                    same::<S, Fast>(setting, &ray, &fast, &hits)?;
                    let plain = setting.shape.hits_at::<Plain>(&ray);
                    same::<S, Plain>(setting, &ray, &plain, &hits)?;
                }
            }
        }
        Ok(())
    }

    pub(super) fn same<S: Number, Coarse: Graded<S>>(
        setting: &Setting<S>,
        ray: &raylet::Ray<S>,
        coarse: &Hits<S>,
        fine: &Hits<S>,
    ) -> Law {
        // Where neither has a hit there is nothing to differ in.
        let at = |t: S| bound::<S, Coarse>(setting, ray, t);
        let bound = coarse.iter().chain(fine).map(|hit| 2.0 * at(hit.t)).fold(0.0, f64::max);
        let alike = setting.alike(ray, &met(coarse), &met(fine), bound);
        prop_assert!(alike.is_ok(), "{alike:?}: {ray:?}: {coarse:?}, {fine:?}");
        if coarse.len() == fine.len() && coarse.starts_inside() != fine.starts_inside() {
            let deep = setting.depth(ray, &ray.range().start().exact());
            prop_assert!(deep.abs() <= bound, "{ray:?} starts {deep} deep: {coarse:?}, {fine:?}");
        }
        Ok(())
    }
}

/// Most rays are nowhere near a decision: benign ones differ in nothing, in no tier.
#[test]
fn benign_rays_need_no_excuse() {
    fn check<S: Number, T: Graded<S>>() {
        use support::subject::SUBJECTS;
        use support::workload::Workload;
        let (mut rays, mut differ) = (0, 0);
        for name in SUBJECTS {
            for seed in 0..times(4000) {
                let Some((setting, _)) = Setting::<S>::draw((name, Workload::Benign, (seed % 6) as usize, seed)) else {
                    continue;
                };
                let coarse = setting.shape.hits_at::<T>(&setting.ray);
                let fine = setting.shape.hits_at::<Stable>(&setting.ray);
                let seen = |hits: &Hits<S>| hits.iter().map(|hit| (hit.part, hit.crossing)).collect::<Vec<_>>();
                rays += 1;
                if seen(&coarse) != seen(&fine) {
                    differ += 1;
                    let lawful = law::same::<S, T>(&setting, &setting.ray, &coarse, &fine);
                    assert!(lawful.is_ok() || !setting.is_bounded(), "{name}: {lawful:?}");
                }
            }
        }
        println!("{} {:?}: {differ} of {rays} benign rays differ from Stable", S::name(), T::GRADE);
        // In fixed point one of some 100,000 random rays passes a rim within a unit.
        let most = if support::laws::is_float::<S>() { 0 } else { rays / 100_000 };
        assert!(differ <= most, "{} {:?}: {differ} of {rays} rays", S::name(), T::GRADE);
    }
    check::<f32, Plain>();
    check::<f32, Fast>();
    check::<f32, Exact>();
    check::<f64, Plain>();
    check::<f64, Fast>();
    check::<fixed::types::I16F16, Plain>();
    check::<fixed::types::I16F16, Fast>();
    check::<fixed::types::I16F16, Exact>();
    check::<fixed::types::I32F32, Plain>();
    check::<fixed::types::I32F32, Fast>();
    check::<fixed::types::I8F24, Exact>();
}
