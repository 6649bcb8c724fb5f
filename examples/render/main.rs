//! From a scene to a picture: a built-in one, or an NFF file, in a number type of your choice.
//!
//! ```text
//! cargo run --release --example render
//! cargo run --release --example render -- examples/scenes/star.nff --number i16f16 --samples 3
//! cargo run --release --example render -- examples/scenes/tubes.nff --compare i16f16 f64
//! cargo run --release --example render -- --scene glass --compare f32-fast f32-exact
//! ```

mod compare;
mod image;
mod load;
mod options;
mod report;
mod trace;

use clap::Parser;
use compare::Difference;
use fixed::types::{I16F16, I32F32};
use load::Source;
use options::{Arithmetic, Number, Options, TierName};
use raylet::effect::EffectSet;
use raylet::scene::nff::Scale;
use raylet::tier;
use std::error::Error;
use std::process::ExitCode;
use trace::Traced;

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let source = Source::new(options.file.as_deref(), options.scene)?;
    if let [arithmetic, reference] = options.compare[..] {
        return compare_two(options, &source, arithmetic, reference);
    }
    let arithmetic = options.arithmetic();
    let traced = trace(options, &source, arithmetic, options.effects)?;
    report(&traced, arithmetic);
    if options.report {
        report::costs(options, &source, &traced)?;
        report::objects(&traced);
    }
    let files = image::Files::new(options.output.as_deref(), source.name(), "");
    println!("written: {}", files.write(&traced.image)?);
    Ok(())
}

/// Traces in the number type and tier that were named: the one place where the choice becomes types.
fn trace(
    options: &Options,
    source: &Source,
    Arithmetic { number, tier }: Arithmetic,
    effects: EffectSet,
) -> Result<Traced, Box<dyn Error>> {
    use TierName::{Exact, Fast, Stable};
    match (number, tier) {
        (Number::F32, Fast) => trace::trace::<f32, tier::Fast>(source, options, effects),
        (Number::F32, Stable) => trace::trace::<f32, tier::Stable>(source, options, effects),
        (Number::F32, Exact) => trace::trace::<f32, tier::Exact>(source, options, effects),
        (Number::F64, Fast) => trace::trace::<f64, tier::Fast>(source, options, effects),
        (Number::F64, Stable) => trace::trace::<f64, tier::Stable>(source, options, effects),
        (Number::I16f16, Fast) => trace::trace::<I16F16, tier::Fast>(source, options, effects),
        (Number::I16f16, Stable) => trace::trace::<I16F16, tier::Stable>(source, options, effects),
        (Number::I16f16, Exact) => trace::trace::<I16F16, tier::Exact>(source, options, effects),
        (Number::I32f32, Fast) => trace::trace::<I32F32, tier::Fast>(source, options, effects),
        (Number::I32f32, Stable) => trace::trace::<I32F32, tier::Stable>(source, options, effects),
        (Number::F64 | Number::I32f32, Exact) => {
            Err(format!("there is no exact tier for {number}: take f32 or i16f16, or --tier stable").into())
        }
    }
}

fn report(traced: &Traced, number: Arithmetic) {
    let (counters, seconds) = (traced.counters, traced.seconds);
    println!(
        "{}x{} pixels in {number}: {} rays ({} primary, {} shadow, {} reflection, {} refraction), \
         {} intersection tests, {} box tests",
        traced.image.width,
        traced.image.height,
        counters.rays(),
        counters.primary_rays,
        counters.shadow_rays,
        counters.reflection_rays,
        counters.refraction_rays,
        counters.intersection_tests,
        counters.box_tests,
    );
    println!("called for: {}", traced.called_for);
    let left_off = traced.called_for.difference(traced.used);
    if !left_off.is_empty() {
        println!("left off: {left_off}");
    }
    if traced.scale != Scale::ONE {
        println!("scale: one unit of the file is {} in the scene", traced.scale);
    }
    let rate = counters.rays() as f64 / seconds.max(1e-9) / 1e6;
    println!("time: {seconds:.3} s, {rate:.2} million rays/s");
    if traced.invisible > 0 {
        println!("left out: {} objects too small for the number type, or without area", traced.invisible);
    }
}

fn compare_two(
    options: &Options,
    source: &Source,
    number: Arithmetic,
    reference: Arithmetic,
) -> Result<(), Box<dyn Error>> {
    let first = trace(options, source, number, options.effects)?;
    report(&first, number);
    let second = trace(options, source, reference, options.effects)?;
    report(&second, reference);
    let difference = Difference::between(&first, &second);
    println!("{number} against {reference}: {difference}");
    for (image, label) in [
        (&first.image, format!("-{number}")),
        (&second.image, format!("-{reference}-reference")),
        (&difference.image, "-difference".to_owned()),
    ] {
        println!("written: {}", image::Files::new(options.output.as_deref(), source.name(), &label).write(image)?);
    }
    Ok(())
}
