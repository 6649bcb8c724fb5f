//! From a scene to a picture: a built-in one, or an NFF file, in a number type of your choice.
//!
//! ```text
//! cargo run --release --example render
//! cargo run --release --example render -- examples/scenes/star.nff --number i16f16 --samples 3
//! cargo run --release --example render -- examples/scenes/tubes.nff --compare i16f16 f64
//! ```

mod compare;
mod image;
mod load;
mod options;
mod report;
mod trace;

use clap::Parser;
use compare::Difference;
use load::Source;
use options::{Number, Options};
use raylet::effect::EffectSet;
use raylet::scene::nff::Scale;
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
    if let [number, reference] = options.compare[..] {
        return compare_two(options, &source, number, reference);
    }
    let traced = trace(options, &source, options.number, options.effects)?;
    report(&traced, options.number);
    if options.report {
        report::costs(options, &source, &traced)?;
        report::objects(&traced);
    }
    let files = image::Files::new(options.output.as_deref(), source.name(), "");
    println!("written: {}", files.write(&traced.image)?);
    Ok(())
}

/// Traces in the number type that was asked for: the one place where the choice becomes a type.
fn trace(options: &Options, source: &Source, number: Number, effects: EffectSet) -> Result<Traced, Box<dyn Error>> {
    match number {
        Number::F32 => trace::trace::<f32>(source, options, effects),
        Number::F64 => trace::trace::<f64>(source, options, effects),
        Number::I16f16 => trace::trace::<fixed::types::I16F16>(source, options, effects),
        Number::I32f32 => trace::trace::<fixed::types::I32F32>(source, options, effects),
    }
}

fn report(traced: &Traced, number: Number) {
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

fn compare_two(options: &Options, source: &Source, number: Number, reference: Number) -> Result<(), Box<dyn Error>> {
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
