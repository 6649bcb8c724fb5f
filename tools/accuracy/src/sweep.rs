//! Errors along two ways to make a ray hard: from farther and farther away, and closer and closer to touching.

use crate::study::Point;
use fixed::types::{I16F16, I32F32};
use support::figures::rounded_up;
use support::measure::measure_each;
use support::method::Measurable;
use support::subject::Subject;
use support::workload::Workload;

pub const PRIMITIVES: [&str; 2] = ["sphere", "cylinder capped"];

/// Steps a power of ten.
const STEPS: i32 = 4;

type Sweep = (&'static str, fn(f64) -> Workload, [i32; 2]);

const SWEEPS: [Sweep; 2] = [("distance", Workload::Away, [0, 6]), ("grazing", Workload::Grazing, [-7, -1])];

/// How often `tick` is called.
pub const TICKS: usize = 4 * PRIMITIVES.len() * 2 * (6 * STEPS as usize + 1);

fn sweep<S: Measurable>(rays: usize, all: &mut Vec<Point>, tick: &mut dyn FnMut()) {
    let methods = S::methods();
    for primitive in PRIMITIVES {
        let subject = Subject::<S>::new(primitive);
        for (sweep, workload, [first, last]) in SWEEPS {
            for step in first * STEPS..=last * STEPS {
                let at = 10.0_f64.powf(f64::from(step) / f64::from(STEPS));
                // As it is written and read again.
                let at = format!("{at:.3e}").parse().unwrap_or(at);
                let rows = measure_each(&methods, &subject, workload(at), rays, 3000, |_| true);
                for (method, row) in methods.iter().zip(rows.into_iter().flatten()) {
                    all.push(Point {
                        sweep: sweep.into(),
                        number: S::name(),
                        tier: method.tier.into(),
                        primitive: primitive.into(),
                        at,
                        hits: row.hits,
                        wrong: row.lost + row.phantom,
                        errors: [0.5, 0.999].map(|fraction| rounded_up(row.quantile(fraction))),
                    });
                }
                tick();
            }
        }
    }
}

/// Every tier in every number type along both sweeps. Where a ray does not fit the type there is no point.
pub fn measure(rays: usize, tick: &mut dyn FnMut()) -> Vec<Point> {
    let mut all = vec![];
    sweep::<f32>(rays, &mut all, tick);
    sweep::<f64>(rays, &mut all, tick);
    sweep::<I16F16>(rays, &mut all, tick);
    sweep::<I32F32>(rays, &mut all, tick);
    all
}
