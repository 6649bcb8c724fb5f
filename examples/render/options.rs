//! The options of the command line.

use crate::arithmetic::{Arithmetic, Number, TierName};
use crate::suggest;
use clap::builder::{PossibleValue, TypedValueParser};
use clap::error::ErrorKind;
use clap::error::{ContextKind, ContextValue};
use clap::{Arg, Command, CommandFactory, Parser};
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
        The picture is written before anything is reported. Warnings, on standard error, say why a picture is\n\
        black or empty, or less true than it seems. The exit status is 1 if there is no picture or it cannot be\n\
        written, and 2 if the options are wrong. Every output is opened before tracing, and one that cannot be\n\
        opened fails at once. Where the system does not tell that standard output is closed (all but Linux), a\n\
        picture sent there is lost.\n\n\
        What NFF files mean: Ks is the weight of the highlights and also of the mirrored rays, T that of the\n\
        refracted rays. Transparent objects cast full shadows."
)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of its own")]
pub(crate) struct Options {
    /// The scene, a file in the Neutral File Format (.nff); `-` reads standard input. Without it, a built-in scene is
    /// shown
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,

    /// The built-in scene to show, if no FILE is given
    #[arg(long, value_parser = SceneNames, value_name = "NAME", default_value = "still-life", conflicts_with = "file")]
    pub(crate) scene: BuiltIn,

    /// Effects to use: `auto` for all that the scene calls for, `none`, or a list such as `diffuse,shadows`
    ///
    /// There are ambient, diffuse, specular, shadows, reflection, refraction, texture, bump, fog, antialiasing and
    /// outline. One that is named but not called for by the scene is not used; the report says which are.
    #[arg(long, value_name = "LIST", default_value = "auto", value_parser = parse_effects)]
    pub(crate) effects: EffectSet,

    /// Report also what each effect costs (the picture is traced again without it), and how often each object was
    /// tested and hit
    #[arg(long, conflicts_with = "compare")]
    pub(crate) report: bool,

    /// Number type to trace in, which all coordinates and lengths are rounded to. Other splits of 32 bits, i20f12 and
    /// i8f24, are compiled with `--features raylet-render/every-type`
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = Number::F32)]
    pub(crate) number: Number,

    /// How accurately rays and objects are intersected. `exact` exists for f32 and i16f16 only
    #[arg(short, long, value_enum, ignore_case = true, default_value_t = TierName::Stable)]
    pub(crate) tier: TierName,

    /// Width and height of the picture in pixels, such as 320x240; by default the resolution in the file, or 160x120
    /// for a built-in scene
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = parse_size)]
    pub(crate) size: Option<(u16, u16)>,

    /// Antialiasing: N x N rays, on a regular grid, in each pixel whose corners differ (1 to 16); 1 is one ray a pixel
    #[arg(short, long, value_name = "N", default_value_t = 1, allow_hyphen_values = true, value_parser = parse_samples)]
    pub(crate) samples: u8,

    /// Where to write: FILE.png, FILE.ppm, a name for both, a folder, or `-` for standard output; by default the folder
    /// `out`
    ///
    /// A name that ends in .png or .ppm is written in that format, and a name without a suffix in both. In a folder,
    /// both are written under the scene's name. `-` writes a PPM to standard output, and the report to standard error.
    /// Folders that are missing are made, and files that exist are replaced.
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Trace the scene twice, in A and in B, and report how far the picture of A is from that of B
    ///
    /// A and B are each a number type, or a number type and a tier, such as `i16f16-exact`. The report says how many
    /// pixels differ and by how much. Three pictures are written: both, and their difference, 32 times amplified.
    #[arg(long, num_args = 2, value_names = ["A", "B"], conflicts_with_all = ["number", "tier"],
        value_parser = Arithmetic::parse)]
    pub(crate) compare: Vec<Arithmetic>,

    /// Enlarge or shrink the file by a power of two before it is rounded to the number type: `auto`, or 1/65536 to
    /// 4294967296
    ///
    /// One unit of the file becomes this many in the scene. In exact arithmetic the picture would be the same. Fixed
    /// point rounds lengths to steps of fixed size: in a larger scene they matter less, but it may have coordinates
    /// beyond the number type. `auto` takes the largest scale that leaves room in fixed point, and 1 in floating point,
    /// where it does not matter.
    #[arg(long, value_name = "FACTOR", default_value = "auto", allow_hyphen_values = true, value_parser = parse_scale)]
    pub(crate) scale: Units,

    /// Show every surface from both sides, for files whose polygons run the wrong way
    ///
    /// Without it a polygon is seen only from its front, where its corners run counterclockwise; a sphere, cone or
    /// cylinder only from outside, or only from within if its radii are negative; and what is transparent from both
    /// sides.
    #[arg(long)]
    pub(crate) both_sides: bool,

    /// White ambient light, 0 to 1: with 0.1, what no light reaches is a tenth as bright as what faces a light of
    /// strength 1 [default: that of the built-in scene, 0 for a file]
    #[arg(long, value_name = "LEVEL", allow_hyphen_values = true, value_parser = parse_level)]
    pub(crate) ambient: Option<f64>,

    /// Draw a black line around everything that is seen, PIXELS wide (1 to 16): for displays of few shades
    #[arg(
        long,
        value_name = "PIXELS",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "1",
        value_parser = parse_width
    )]
    pub(crate) outline: Option<u8>,

    /// Write levels in proportion to the light, for measuring. Without it they are encoded by sRGB, as screens expect
    /// it
    ///
    /// On a screen a linear picture is too dark. A PNG says which of the two it is.
    #[arg(long)]
    pub(crate) linear: bool,

    /// Cast every reflected and refracted ray, 16 surfaces deep, however little it adds
    ///
    /// Without it those that add too little to change a level are not cast; compare the pictures to see that none
    /// changes.
    #[arg(long)]
    pub(crate) uncut: bool,

    /// Find the spans of pixels that see the same part of the same object with few rays, as a microcontroller may
    ///
    /// The picture shows the same objects. Light that changes smoothly is interpolated, and may be a level or two off.
    #[arg(long)]
    pub(crate) spans: bool,

    /// Threads to trace with, 1 to 256; by default one for each processor. The picture is the same with any number of
    /// them
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = parse_threads)]
    pub(crate) threads: Option<u16>,

    /// Test every object for every ray, instead of only those whose boxes the ray meets, to see what time the boxes
    /// save
    ///
    /// The picture is the same.
    #[arg(long)]
    pub(crate) no_hierarchy: bool,
}

impl Options {
    /// Ends the program if the options are wrong, or ask for help.
    pub(crate) fn of_command_line() -> Self {
        Self::try_parse().unwrap_or_else(|error| with_suggestion(error).exit())
    }

    /// What a single picture is traced in.
    pub(crate) const fn arithmetic(&self) -> Arithmetic {
        Arithmetic { number: self.number, tier: self.tier }
    }
}

/// Says of an unknown option which one is much like it. (The library `clap` would need another crate for that.)
fn with_suggestion(mut error: clap::Error) -> clap::Error {
    if let (ErrorKind::UnknownArgument, Some(ContextValue::String(unknown))) =
        (error.kind(), error.get(ContextKind::InvalidArg))
    {
        let command = Options::command();
        let options = command.get_arguments().filter_map(Arg::get_long);
        if let Some(meant) = unknown.strip_prefix("--").and_then(|unknown| suggest::nearest(unknown, options)) {
            let meant = ContextValue::String(format!("--{meant}"));
            error.insert(ContextKind::SuggestedArg, meant);
            // Else it also says how to make it the name of a file.
            error.remove(ContextKind::Suggested);
        }
    }
    error
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

fn parse_samples(text: &str) -> Result<u8, String> {
    let samples = text.parse().ok().filter(|samples| (1..=16).contains(samples));
    samples.ok_or_else(|| "give a whole number from 1 to 16".to_owned())
}

fn parse_width(text: &str) -> Result<u8, String> {
    let width = text.parse().ok().filter(|width| (1..=16).contains(width));
    width.ok_or_else(|| "give a whole number from 1 to 16".to_owned())
}

fn parse_threads(text: &str) -> Result<u16, String> {
    let threads = text.parse().ok().filter(|threads| (1..=256).contains(threads));
    threads.ok_or_else(|| "give a whole number from 1 to 256".to_owned())
}

fn parse_size(text: &str) -> Result<(u16, u16), String> {
    let side = |text: &str| text.parse().ok().filter(|side| *side > 0);
    text.split_once(['x', 'X'])
        .and_then(|(width, height)| Some((side(width)?, side(height)?)))
        .ok_or_else(|| "give width and height in pixels, each 1 to 65535, such as 320x240".to_owned())
}
