//! How wrong the ways to answer in one number type are, on one primitive and one workload.

use super::exact_types::{Exact as Number, exact_line, expected_of, same_crossing, same_part};
use super::method::{Method, Target, Told};
use super::oracle::{Dyadic, InRange, Root};
use super::placed::{Placed, Placement, Placing};
use super::promise::Judged;
use super::random::Random;
use super::subject::Subject;
use super::workload::Workload;
use raylet::tier::Tier;
use raylet::{Departure, Frame, Ray, Shape, UnitVec3, Vec3};

/// A ray of which a tier says what it promises not to.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// The error over the limit; infinite for a hit that is lost, invented or on another part.
    pub by: f64,
    /// The answers, and the ray and what it is to meet, by their bits.
    pub told: String,
}

/// What was measured over one row.
#[derive(Default)]
pub struct Measured {
    pub rays: usize,
    pub hits: usize,
    /// In units in the last place, sorted.
    errors: Vec<f64>,
    /// As lengths, sorted.
    lengths: Vec<f64>,
    /// Hits of exact arithmetic that are missing.
    pub lost: usize,
    /// Hits that exact arithmetic does not have.
    pub phantom: usize,
    /// Hits within one unit of the range's start that are on the other side of it, in either direction.
    pub edge: usize,
    /// Hits on another part, or with another crossing.
    pub part: usize,
    /// Rays that the exact tier decided in integers.
    pub integers: usize,
    /// Rays of which the tier's promise is broken.
    pub broken: usize,
    /// The worst of them.
    pub worst: Option<Broken>,
}

impl Measured {
    /// Compares the hits of one ray with the exact ones. The error over what the tier promises, or zero where half a
    /// unit is not exceeded.
    fn count<S: Number>(
        &mut self,
        tier: &str,
        got: &[Told<S>],
        judged: &Judged<'_, S>,
        told: &dyn Fn() -> String,
    ) -> f64 {
        self.rays += 1;
        let before = (self.errors.len(), self.part);
        let wrong = !self.compare(tier, got.to_vec(), judged);
        let errors = &self.errors[before.0..];
        let by = if wrong || self.part > before.1 {
            if judged.excuses(tier, got) { 0.0 } else { f64::INFINITY }
        } else {
            let most = errors.iter().copied().fold(0.0, f64::max);
            // The limit takes longer to find than that it is kept.
            if most <= 0.5 { 0.0 } else { judged.limit(tier).map_or(0.0, |limit| most / limit) }
        };
        if by > 1.0 {
            self.broken += 1;
            if self.worst.as_ref().is_none_or(|worst| by > worst.by) {
                let answers = |hits: &[f64]| format!("{hits:?}");
                let got: Vec<_> = got.iter().map(|hit| hit.t.to_f64()).collect();
                let want: Vec<_> = judged.want.hits.iter().map(|hit| hit.t.to_f64()).collect();
                let clear = super::promise::clearance(judged.solid, judged.line);
                self.worst = Some(Broken {
                    by,
                    told: format!(
                        "{errors:.3?} units, {clear:.1e} from grazing: t {}, exactly {}; {}",
                        answers(&got),
                        answers(&want),
                        told()
                    ),
                });
            }
        }
        by
    }

    /// Counts what differs; false if a hit is lost or invented.
    fn compare<S: Number>(&mut self, tier: &str, mut got: Vec<Told<S>>, judged: &Judged<'_, S>) -> bool {
        let mut want: Vec<_> = judged.want.hits.iter().collect();
        // The exact tier is held to its `t`, however small.
        let is_exact = tier == "Exact";
        let unit_of_size = judged.unit_of_size();
        if want.len() != got.len() {
            // A t of less than a unit rounds onto the range's start, or off it.
            let unit = |t: &Root| {
                let unit = if is_exact { S::unit_at(t) } else { unit_of_size.clone() };
                t.error_in(&S::ZERO.exact(), &unit) <= 1.0
            };
            let before = want.len() + got.len();
            want.retain(|hit| !unit(&hit.t));
            got.retain(|hit| !unit(&(&hit.t.exact()).into()));
            self.edge += before - want.len() - got.len();
        }
        if want.len() != got.len() {
            self.lost += want.len().saturating_sub(got.len());
            self.phantom += got.len().saturating_sub(want.len());
            return false;
        }
        for (want, got) in want.iter().zip(&got) {
            self.hits += 1;
            let differs = |(part, crossing)| !same_part(part, want.part) || !same_crossing(crossing, want.crossing);
            self.part += usize::from(got.surface.is_some_and(differs));
            let own = S::unit_at(&want.t);
            // Of a hit next to the start the position counts, in units of the solid's size.
            let unit: &Dyadic =
                if !is_exact && own < unit_of_size && judged.is_near(want.t.to_f64()) { &unit_of_size } else { &own };
            let error = want.t.error_in(&got.t.exact(), unit);
            self.errors.push(error);
            // A unit is a power of two: the product is as exact as the error.
            self.lengths.push(error * unit.to_f64());
        }
        true
    }

    fn sorted(mut self) -> Self {
        self.errors.sort_by(f64::total_cmp);
        self.lengths.sort_by(f64::total_cmp);
        self
    }

    /// The error in units in the last place that this share of all hits does not exceed.
    pub fn quantile(&self, fraction: f64) -> f64 {
        quantile(&self.errors, fraction)
    }

    /// The same as a length.
    pub fn length(&self, fraction: f64) -> f64 {
        quantile(&self.lengths, fraction)
    }
}

/// The least of these numbers that is not exceeded by this fraction of them (the nearest rank).
fn quantile(sorted: &[f64], fraction: f64) -> f64 {
    let rank = (sorted.len() as f64 * fraction).ceil() as usize;
    if sorted.is_empty() { 0.0 } else { sorted[rank.max(1) - 1] }
}

/// What a method made of one ray.
pub struct Judgement<S> {
    /// How far it goes, of what its tier promises.
    pub by: f64,
    /// The largest error of its hits, in units in the last place; of wrong hits there is none.
    pub error: f64,
    /// True if hits are lost or invented.
    pub is_wrong: bool,
    /// True if a hit is on another part or has another crossing.
    pub is_on_other_part: bool,
    pub hits: Vec<Told<S>>,
}

/// One row for each method, all at the same rays: the exact answer, which takes longest, is found once.
pub struct Rows<'a, S: Number> {
    methods: &'a [Method<S>],
    rows: Vec<Measured>,
}

/// How far one ray goes with a method, of what its tier promises; and the ray, if that is too far.
pub fn measure_one<S: Number>(method: &Method<S>, target: &Target<'_, S>, ray: &Ray<S>) -> (f64, Option<Broken>) {
    let mut rows = Rows::new(std::slice::from_ref(method));
    let (_, judgements) = rows.measure(target, ray);
    let by = judgements.iter().map(|judgement| judgement.by).fold(0.0, f64::max);
    (by, rows.rows.pop().and_then(|row| row.worst))
}

impl<'a, S: Number> Rows<'a, S> {
    pub fn new(methods: &'a [Method<S>]) -> Self {
        Self { methods, rows: methods.iter().map(|_| Measured::default()).collect() }
    }

    /// The exact answer, and what each method makes of the ray.
    pub fn measure(&mut self, target: &Target<'_, S>, ray: &Ray<S>) -> (InRange, Vec<Judgement<S>>) {
        let (line, [least, most]) = match target.placed {
            None => (exact_line(ray), [1.0; 2]),
            Some(placed) => (placed.line(ray), [placed.smallest, placed.largest]),
        };
        let (size, narrowest) = (most * target.size, least * target.size);
        let solid = target.solid;
        let want: InRange = expected_of(solid, &line, ray);
        let judged = Judged { solid, line: &line, ray, want: &want, size, narrowest };
        let judge = |(method, row): (&Method<S>, &mut Measured)| {
            let hits = (method.hits)(target, ray);
            let before = (row.errors.len(), row.lost + row.phantom, row.part);
            let by = row.count(method.tier, &hits, &judged, &|| bits(target, ray));
            row.integers += usize::from((method.in_integers)(target.shape, ray));
            Judgement {
                by,
                error: row.errors[before.0..].iter().copied().fold(0.0, f64::max),
                is_wrong: row.lost + row.phantom > before.1,
                is_on_other_part: row.part > before.2,
                hits,
            }
        };
        let judgements = self.methods.iter().zip(&mut self.rows).map(judge).collect();
        (want, judgements)
    }

    /// What was measured; `None` if there was no ray.
    pub fn done(self) -> Option<Vec<Measured>> {
        let any = self.rows.first().is_some_and(|row| row.rays > 0);
        any.then(|| self.rows.into_iter().map(Measured::sorted).collect())
    }
}

/// The query, by its bits.
fn bits<S: Number>(target: &Target<'_, S>, ray: &Ray<S>) -> String {
    let three = |v: [String; 3]| format!("({})", v.join(", "));
    let coordinates = |v: Vec3<S>| three(v.to_array().map(S::bits));
    let along = |v: UnitVec3<S>| three(v.to_array().map(S::unit_bits));
    let mut told = vec![format!("o {} d {}", coordinates(ray.origin()), along(ray.direction()))];
    if let Some(Departure { part, leaving, .. }) = ray.departure() {
        told.push(format!("departing {leaving:?} from {part:?}"));
    }
    if let Some(placed) = target.placed {
        let at = coordinates(placed.placement.position());
        let axes = |frame: &Frame<S>| frame.axes().map(along).join(" ");
        match &placed.placement {
            Placement::Frame(frame) => told.push(format!("at {at} axes {}", axes(frame))),
            Placement::Stretched(frame, factors) => {
                told.push(format!("at {at} axes {}", axes(frame)));
                told.push(format!("stretched by {}", three(factors.map(S::bits))));
            }
            Placement::Matrix(affine) => {
                let row =
                    |(row, exponent): ([S::Unit; 3], i32)| format!("2^{exponent} {}", three(row.map(S::unit_bits)));
                told.push(format!("at {at} inverse {}", affine.inverse().map(row).join(" ")));
            }
        }
    }
    told.join(", ")
}

/// The workload's rays for which `counts` holds; `None` if it has no sense for the subject, or no ray fits the type.
pub fn measure_each<S: Number>(
    methods: &[Method<S>],
    subject: &Subject<S>,
    workload: Workload,
    rays: usize,
    seed: u64,
    counts: impl Fn(&Ray<S>) -> bool,
) -> Option<Vec<Measured>> {
    let mut random = Random(seed);
    let mut rows = Rows::new(methods);
    for _ in 0..rays {
        if let Some(ray) = workload.ray(subject, &mut random).filter(&counts) {
            rows.measure(&Target::of(subject, None), &ray);
        }
    }
    rows.done()
}

/// The workload's rays at the primitive, placed anew for each.
pub fn measure_placed<S: Number>(
    methods: &[Method<S>],
    subject: &Subject<S>,
    workload: Workload,
    placing: Placing,
    rays: usize,
    seed: u64,
) -> Option<Vec<Measured>> {
    let mut random = Random(seed);
    let mut rows = Rows::new(methods);
    for _ in 0..rays {
        let Some(placed) = Placed::new(subject, placing, &mut random) else { continue };
        if let Some(ray) = placed.ray(subject, workload, &mut random) {
            rows.measure(&Target::of(subject, Some(&placed)), &ray);
        }
    }
    rows.done()
}

/// One tier at the workload's rays; `None` if it has no sense for the subject.
pub fn measure<S: Number, T: Tier<S>>(
    subject: &Subject<S>,
    workload: Workload,
    rays: usize,
    seed: u64,
) -> Option<Measured> {
    measure_where::<S, T>(subject, workload, rays, seed, |_| true, |_, _| false)
}

/// Of the workload's rays those for which `counts` holds.
pub fn measure_where<S: Number, T: Tier<S>>(
    subject: &Subject<S>,
    workload: Workload,
    rays: usize,
    seed: u64,
    counts: impl Fn(&Ray<S>) -> bool,
    in_integers: fn(&Shape<S>, &Ray<S>) -> bool,
) -> Option<Measured> {
    let method = Method { in_integers, ..Method::tier::<T>("") };
    measure_each(&[method], subject, workload, rays, seed, counts)?.pop()
}

#[cfg(test)]
mod tests {
    use super::quantile;

    #[test]
    fn a_quantile_is_not_exceeded_by_its_fraction() {
        let sorted: Vec<f64> = (1..=2_000).map(f64::from).collect();
        assert_eq!([0.5, 0.999, 1.0].map(|fraction| quantile(&sorted, fraction)), [1000.0, 1998.0, 2000.0]);
        assert_eq!([0.5, 0.999, 1.0].map(|fraction| quantile(&sorted[..2], fraction)), [1.0, 2.0, 2.0]);
        assert_eq!(quantile(&[], 0.5), 0.0);
    }
}
