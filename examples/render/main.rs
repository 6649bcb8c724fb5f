//! From a scene to a picture: a built-in one, or an NFF file, in a number type of your choice.
//!
//! ```text
//! cargo run --release --example render
//! cargo run --release --example render -- examples/scenes/star.nff --number i16f16 --samples 3
//! cargo run --release --example render -- examples/scenes/tubes.nff --compare i16f16 f64
//! cargo run --release --example render -- --scene glass --compare f32-fast f32-exact
//! ```

mod arithmetic;
mod compare;
mod console;
mod diagnosis;
mod files;
mod image;
mod instead;
mod load;
mod messages;
mod options;
mod output;
mod progress;
mod report;
mod standard;
mod suggest;
mod trace;

use arithmetic::{Arithmetic, Number, TierName};
use compare::Difference;
use console::Console;
#[cfg(feature = "every-type")]
use fixed::types::{I8F24, I20F12};
use fixed::types::{I16F16, I32F32};
use load::Source;
use options::Options;
use output::Output;
use raylet::effect::EffectSet;
use raylet::tier;
use std::error::Error;
use std::fmt::Write;
use std::process::ExitCode;
use trace::Traced;

fn main() -> ExitCode {
    match run(&Options::of_command_line()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            console::fail(error);
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let arithmetic = options.arithmetic().checked()?;
    let source = Source::new(options.file.as_deref(), options.scene)?;
    if let [arithmetic, reference] = options.compare[..] {
        return compare_two(options, &source, arithmetic, reference);
    }
    let mut output = Output::open(options.output.as_deref(), source.name(), &[String::new()])?;
    let traced = trace(options, &source, arithmetic, options.effects)?;
    // Whatever becomes of the report, the picture is there.
    let written = output.write(0, &traced.image)?;
    let console = Console { picture_on_standard_output: output.is_standard() };
    report::warnings(&traced, arithmetic);
    console.say(&report::picture(&traced, arithmetic))?;
    if options.report {
        console.say(&report::costs(options, &source, &traced)?)?;
        console.say(&report::objects(&traced))?;
    }
    console.say(&format!("written: {written}\n"))
}

/// Traces in the number type and tier that were named: the one place where the choice becomes types.
fn trace(
    options: &Options,
    source: &Source,
    Arithmetic { number, tier }: Arithmetic,
    effects: EffectSet,
) -> Result<Traced, Box<dyn Error>> {
    use TierName::{Exact, Fast, Plain, Stable};
    match (number, tier) {
        (Number::F32, Plain) => trace::trace::<f32, tier::Plain>(source, options, number, effects),
        (Number::F32, Fast) => trace::trace::<f32, tier::Fast>(source, options, number, effects),
        (Number::F32, Stable) => trace::trace::<f32, tier::Stable>(source, options, number, effects),
        (Number::F32, Exact) => trace::trace::<f32, tier::Exact>(source, options, number, effects),
        (Number::F64, Plain) => trace::trace::<f64, tier::Plain>(source, options, number, effects),
        (Number::F64, Fast) => trace::trace::<f64, tier::Fast>(source, options, number, effects),
        (Number::F64, Stable) => trace::trace::<f64, tier::Stable>(source, options, number, effects),
        (Number::I16f16, Plain) => trace::trace::<I16F16, tier::Plain>(source, options, number, effects),
        (Number::I16f16, Fast) => trace::trace::<I16F16, tier::Fast>(source, options, number, effects),
        (Number::I16f16, Stable) => trace::trace::<I16F16, tier::Stable>(source, options, number, effects),
        (Number::I16f16, Exact) => trace::trace::<I16F16, tier::Exact>(source, options, number, effects),
        (Number::I32f32, Plain) => trace::trace::<I32F32, tier::Plain>(source, options, number, effects),
        (Number::I32f32, Fast) => trace::trace::<I32F32, tier::Fast>(source, options, number, effects),
        (Number::I32f32, Stable) => trace::trace::<I32F32, tier::Stable>(source, options, number, effects),
        #[cfg(feature = "every-type")]
        (Number::I20f12, tier) => trace_split::<I20F12>(options, source, number, tier, effects),
        #[cfg(feature = "every-type")]
        (Number::I8f24, tier) => trace_split::<I8F24>(options, source, number, tier, effects),
        (Number::F64 | Number::I32f32, Exact) => Err("the options are checked before".into()),
    }
}

/// The same for another split of 32 bits.
#[cfg(feature = "every-type")]
fn trace_split<S: raylet::Scalar + Send + Sync>(
    options: &Options,
    source: &Source,
    number: Number,
    tier: TierName,
    effects: EffectSet,
) -> Result<Traced, Box<dyn Error>>
where
    tier::Exact: tier::Tier<S>,
{
    match tier {
        TierName::Plain => trace::trace::<S, tier::Plain>(source, options, number, effects),
        TierName::Fast => trace::trace::<S, tier::Fast>(source, options, number, effects),
        TierName::Stable => trace::trace::<S, tier::Stable>(source, options, number, effects),
        TierName::Exact => trace::trace::<S, tier::Exact>(source, options, number, effects),
    }
}

fn compare_two(
    options: &Options,
    source: &Source,
    number: Arithmetic,
    reference: Arithmetic,
) -> Result<(), Box<dyn Error>> {
    let labels = [format!("-{number}"), format!("-{reference}-reference"), "-difference".into()];
    let mut output = Output::open(options.output.as_deref(), source.name(), &labels)?;
    let first = trace(options, source, number, options.effects)?;
    let second = trace(options, source, reference, options.effects)?;
    let difference = Difference::between(&first, &second)?;
    let mut written = String::new();
    for (index, image) in [&first.image, &second.image, &difference.image].into_iter().enumerate() {
        let names = output.write(index, image)?;
        let _ = writeln!(written, "written: {names}");
    }
    let console = Console { picture_on_standard_output: false };
    for (traced, number) in [(&first, number), (&second, reference)] {
        report::warnings(traced, number);
        console.say(&report::picture(traced, number))?;
    }
    console.say(&format!("{number} against {reference}: {difference}\n{written}"))
}
