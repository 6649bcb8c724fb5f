//! The options of the command line.

use crate::arithmetic::{Arithmetic, Number, TierName};
use crate::suggest;
use clap::builder::{PossibleValue, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Arg, Command, Parser};
use raylet::effect::{Effect, EffectSet};
use raylet::gallery::BuiltIn;
use raylet::scene::nff::Scale;
use std::ffi::OsStr;
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
        how far is fixed point from double precision?\n  \
        render - -o - < scene.nff | pnmtopng > a.png    from standard input to standard output\n\n\
        The picture is written first and reported then. What makes it less true than it seems, or black, is a warning on\n\
        standard error. The program fails (1) without a picture, or if one cannot be written; also (2) on wrong options.\n\n\
        Only the effects that the scene calls for are at work, and the program says which. In NFF files the highlights'\n\
        weight Ks is the mirror's weight too, and T that of the refracted ray. Transparent objects cast\n\
        full shadows. Levels are encoded by sRGB, as screens expect it, and the PNG says so; see --linear."
)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of its own")]
pub(crate) struct Options {
    /// Scene in the Neutral File Format (.nff), or `-` for standard input; without it, a built-in one
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,

    /// Built-in scene
    #[arg(long, value_parser = SceneNames, value_name = "NAME", default_value = "still-life", conflicts_with = "file")]
    pub(crate) scene: BuiltIn,

    /// Effects to use, of those that the scene calls for: `auto` for all of them, `none`, or names with commas between: ambient, diffuse, specular,
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
    /// needs antialiasing
    #[arg(short, long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=16))]
    pub(crate) samples: u8,

    /// Where to write: FILE.png or FILE.ppm in that format, a name without a suffix in both, a folder both under the scene's name,
    /// `-` a PPM to standard output (and the report to standard error); by default the folder `out`
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Render in A and in B, each a number type, or a number type and a tier (`i16f16-exact`), with B as the reference: report how
    /// many pixels differ and by how much, and write both pictures and their difference, 32 times amplified
    #[arg(long, num_args = 2, value_names = ["A", "B"], conflicts_with_all = ["number", "tier"], value_parser = Arithmetic::parse)]
    pub(crate) compare: Vec<Arithmetic>,

    /// Scene units to one unit of the file: `auto` (in fixed point the largest power of two that leaves room, otherwise 1), or
    /// a power of two from 1/65536 to 4294967296. In exact arithmetic it would not change the picture; in fixed point lengths
    /// are rounded to steps of the number type, which a larger scale makes finer and a smaller one coarser
    #[arg(long, value_name = "FACTOR", default_value = "auto", value_parser = parse_scale)]
    pub(crate) scale: Units,

    /// Show every surface from both sides: for files whose polygons run the wrong way. Without it a polygon is seen from its front
    /// only, and a sphere, cone or cylinder from its outside, or from within if its radii are negative
    #[arg(long)]
    pub(crate) both_sides: bool,

    /// Ambient light, white: 0.1 makes what no light reaches a tenth as bright as a surface that faces a light of strength 1
    #[arg(long, value_name = "LEVEL", default_value_t = 0.0, value_parser = parse_level)]
    pub(crate) ambient: f64,

    /// Write levels in proportion to the light, for measuring, instead of sRGB: on a screen such a picture is too dark
    #[arg(long)]
    pub(crate) linear: bool,

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

/// Parses the names of the built-in scenes, and says of each what it shows.
#[derive(Clone)]
struct SceneNames;

impl TypedValueParser for SceneNames {
    type Value = BuiltIn;

    fn parse_ref(&self, command: &Command, _: Option<&Arg>, value: &OsStr) -> Result<BuiltIn, clap::Error> {
        let name = value.to_string_lossy();
        BuiltIn::EVERY.into_iter().find(|scene| scene.name() == name).ok_or_else(|| {
            let names = BuiltIn::EVERY.map(BuiltIn::name);
            let message = format!("there is no scene `{name}`: {}\n", choice(&name, &names));
            clap::Error::raw(ErrorKind::InvalidValue, message).with_cmd(command)
        })
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let named = |scene: BuiltIn| PossibleValue::new(scene.name()).help(scene.about());
        Some(Box::new(BuiltIn::EVERY.into_iter().map(named)))
    }
}

/// The name that was meant, or all that there are.
fn choice(name: &str, names: &[&str]) -> String {
    match suggest::nearest(name, names.iter().copied()) {
        Some(nearest) => format!("did you mean `{nearest}`? There are {}", names.join(", ")),
        None => format!("choose among {}", names.join(", ")),
    }
}

fn parse_effects(text: &str) -> Result<EffectSet, String> {
    match text {
        "auto" => Ok(EffectSet::ALL),
        "none" => Ok(EffectSet::EMPTY),
        _ => text.split(',').map(str::trim).map(named).collect(),
    }
}

fn named(name: &str) -> Result<Effect, String> {
    Effect::named(name).ok_or_else(|| {
        let every = EffectSet::ALL.to_string();
        let names: Vec<_> = every.split(", ").chain(["auto", "none"]).collect();
        format!("there is no effect `{name}`: {}", choice(name, &names))
    })
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

fn parse_level(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|level| (0.0..=1.0).contains(level))
        .ok_or_else(|| "give a number from 0 to 1, such as 0.1".to_owned())
}

fn parse_size(text: &str) -> Result<(u16, u16), String> {
    let side = |text: &str| text.parse().ok().filter(|side| *side > 0);
    text.split_once(['x', 'X'])
        .and_then(|(width, height)| Some((side(width)?, side(height)?)))
        .ok_or_else(|| "give width and height in pixels, each 1 to 65535, such as 320x240".to_owned())
}
