//! What can be asked for on the command line.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Parser, ValueEnum};
use raylet::effect::{Effect, EffectSet};
use raylet::gallery::BuiltIn;
use raylet::scene::nff::Scale;
use std::fmt;
use std::path::PathBuf;

/// Renders a scene with raylet and writes the picture as PPM and PNG.
#[derive(Debug, Parser)]
#[command(
    version,
    after_help = "Examples:\n  \
        render                                          the built-in still life, 160x120, into out/\n  \
        render examples/scenes/star.nff -n i16f16 -s 3  a file, in fixed point, 9 rays a pixel\n  \
        render --scene glass -s 4                       glass and mirrors, antialiased\n  \
        render --scene waves --effects diffuse,fog      the same scene with two of its effects\n  \
        render examples/scenes/tubes.nff --compare i16f16 f64\n                                                  \
        how far is fixed point from double precision?\n\n\
        Only the effects that the scene calls for are at work, and the program says which. In NFF files the highlights'\n\
        weight Ks is the mirror's weight too, and T that of the refracted ray. There is no ambient light; transparent\n\
        objects cast full shadows. Levels are linear: no gamma curve is applied."
)]
pub(crate) struct Options {
    /// Scene in the Neutral File Format (.nff); without it, a built-in one
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,

    /// Built-in scene
    #[arg(long, value_parser = built_in_scenes(), value_name = "NAME", default_value = "still-life", conflicts_with = "file")]
    pub(crate) scene: BuiltIn,

    /// Effects to use, of those that the scene calls for: `auto` for all of them, `none`, or names with commas between: diffuse, specular,
    /// shadows, reflection, refraction, texture, bump, fog, antialiasing
    #[arg(long, value_name = "LIST", default_value = "auto", value_parser = parse_effects)]
    pub(crate) effects: EffectSet,

    /// Report what each effect costs (by rendering again without it), and each object's tests and hits
    #[arg(long, conflicts_with = "compare")]
    pub(crate) report: bool,

    /// Number type to trace in
    #[arg(short, long, value_enum, default_value_t = Number::F32)]
    pub(crate) number: Number,

    /// Accuracy tier to trace in. `exact` is there for f32 and i16f16
    #[arg(short, long, value_enum, default_value_t = TierName::Stable)]
    pub(crate) tier: TierName,

    /// Size of the picture in pixels; by default the file's own resolution, or 160x120
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub(crate) size: Option<(u16, u16)>,

    /// Samples along each side of a pixel, on a regular grid, where the pixel's corners differ (1 to 16); more than 1
    /// asks for antialiasing
    #[arg(short, long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=16))]
    pub(crate) samples: u8,

    /// Where to write: FILE.png or FILE.ppm for that format, any other name for both; by default out/<scene>
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Render in A and in B, each a number type, or a number type and a tier (`i16f16-exact`), with B as the reference: report how
    /// many pixels differ and by how much, and write both pictures and their difference, 32 times amplified
    #[arg(long, num_args = 2, value_names = ["A", "B"], conflicts_with_all = ["number", "tier"], value_parser = parse_arithmetic)]
    pub(crate) compare: Vec<Arithmetic>,

    /// Scene units to one unit of the file: `auto` (in fixed point the largest power of two that leaves room, otherwise 1), or
    /// a power of two from 1/65536 to 4294967296. In exact arithmetic it would not change the picture
    #[arg(long, value_name = "FACTOR", default_value = "auto", value_parser = parse_scale)]
    pub(crate) scale: Units,

    /// Cast every reflected and refracted ray, 16 surfaces deep, however little it adds: to see that what is usually not cast
    /// changes no level
    #[arg(long)]
    pub(crate) uncut: bool,

    /// Threads to trace with; by default one for each processor. Never changes the picture
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    pub(crate) threads: Option<u16>,

    /// Test every object for every ray, instead of only those whose boxes the ray meets. Never changes the picture, only
    /// its time: to see what the boxes save
    #[arg(long)]
    pub(crate) no_hierarchy: bool,
}

impl Options {
    /// What a single picture is traced in.
    pub(crate) const fn arithmetic(&self) -> Arithmetic {
        Arithmetic { number: self.number, tier: self.tier }
    }
}

/// How large a file is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Units {
    /// As large as the number type allows, if that makes it more accurate.
    Fitting,
    Chosen(Scale),
}

/// The number types that the library is compiled for here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Number {
    /// Single precision
    F32,
    /// Double precision
    F64,
    /// Fixed point, 32 bits: coordinates up to 16384 in steps of 1/65536
    #[value(name = "i16f16")]
    I16f16,
    /// Fixed point, 64 bits: coordinates up to 10^9 in steps of 2^-32
    #[value(name = "i32f32")]
    I32f32,
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::I16f16 => "i16f16",
            Self::I32f32 => "i32f32",
        })
    }
}

/// The accuracy tiers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum TierName {
    /// The cheapest: grazing and far rays are less accurate
    Fast,
    /// Accurate to some units in the last place at any ray
    #[default]
    Stable,
    /// Every decision as exact arithmetic makes it
    Exact,
}

/// What a picture is traced in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Arithmetic {
    pub(crate) number: Number,
    pub(crate) tier: TierName,
}

impl fmt::Display for Arithmetic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = self.number;
        match self.tier {
            TierName::Fast => write!(f, "{number}-fast"),
            TierName::Stable => write!(f, "{number}"),
            TierName::Exact => write!(f, "{number}-exact"),
        }
    }
}

fn parse_arithmetic(text: &str) -> Result<Arithmetic, String> {
    let (number, tier) = text.split_once('-').unwrap_or((text, "stable"));
    let named = |names: &[&str]| names.join(", ");
    let number = Number::from_str(number, true).map_err(|_| {
        format!("there is no number type `{number}`: choose among {}", named(&["f32", "f64", "i16f16", "i32f32"]))
    })?;
    let tier = TierName::from_str(tier, true)
        .map_err(|_| format!("there is no tier `{tier}`: choose among {}", named(&["fast", "stable", "exact"])))?;
    Ok(Arithmetic { number, tier })
}

/// The names of the built-in scenes, each with what it shows.
fn built_in_scenes() -> impl TypedValueParser<Value = BuiltIn> {
    let names = BuiltIn::EVERY.map(|scene| PossibleValue::new(scene.name()).help(scene.about()));
    PossibleValuesParser::new(names)
        .try_map(|name| BuiltIn::EVERY.into_iter().find(|scene| scene.name() == name).ok_or("there is no such scene"))
}

fn parse_effects(text: &str) -> Result<EffectSet, String> {
    match text {
        "auto" => Ok(EffectSet::ALL),
        "none" => Ok(EffectSet::EMPTY),
        _ => text.split(',').map(str::trim).map(named).collect(),
    }
}

fn named(name: &str) -> Result<Effect, String> {
    Effect::named(name)
        .ok_or_else(|| format!("there is no effect `{name}`: choose among {}, auto, none", EffectSet::ALL))
}

fn parse_scale(text: &str) -> Result<Units, String> {
    if text == "auto" {
        return Ok(Units::Fitting);
    }
    (Scale::LEAST.power()..=Scale::LARGEST.power())
        .map(Scale::power_of_two)
        .find(|scale| scale.to_string() == text)
        .map(Units::Chosen)
        .ok_or_else(|| {
            format!("give `auto` or a power of two such as 512 or 1/4, {} to {}", Scale::LEAST, Scale::LARGEST)
        })
}

fn parse_size(text: &str) -> Result<(u16, u16), String> {
    let side = |text: &str| text.parse().ok().filter(|side| *side > 0);
    text.split_once(['x', 'X'])
        .and_then(|(width, height)| Some((side(width)?, side(height)?)))
        .ok_or_else(|| "give width and height in pixels, each 1 to 65535, such as 320x240".to_owned())
}
