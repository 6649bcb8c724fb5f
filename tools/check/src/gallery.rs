//! `docs/gallery.md`: the pictures, with the commands that draw them and what they cost.

use crate::chip::{self, Part};
use crate::effects::{GALLERY_FIGURES, key};
use raylet_tables::{CHIPS, Outcome, grouped, in_repository};
use std::fmt::Write;
use std::fs;

/// The chips on which the gallery is drawn.
const DRAWN_ON: [&str; 2] = ["Cortex-M0+", "Cortex-M4F"];

const INTRODUCTION: &str = "\
# Gallery

Each picture with the command that draws it, the output of that command, and the cost of a pixel on two chips. `.ci/measure
--document` writes this page from the output of `.ci/gallery --renew` and the figures of `.ci/measure --renew`; do not edit it. CI draws every picture
again and compares it to the bit.

Instructions are the mean over the pixels of the same scene at 24 by 18 pixels, with 3 by 3 samples where a pixel's corners differ. At that
size a larger share of the pixels contains an edge than in the picture shown. How instructions are counted:
[microcontrollers.md](microcontrollers.md#how-it-is-measured).
";

/// The file of a picture, and what the gallery says of it: in this order.
const PICTURES: [(&str, &str); 8] = [
    (
        "still-life",
        "All solids of revolution, a disc and a pyramid; a ball is stretched to an ellipsoid, a cone stands on its apex, and a disc leans on it.",
    ),
    (
        "patterns",
        "Separate materials on base and top; checkers, stripes and an image of 8 by 8 pixels through `uv`, on a cuboid and a rectangle too; a capsule carved from cells in space, through `uvw`.",
    ),
    (
        "glass",
        "Refraction with Fresnel's weights and total reflection, mirrors, and a pane of index 1, which refracts nothing.",
    ),
    ("waves", "Bump mapping through the tangents: on water that mirrors, on a ball, as flutes of columns in fog."),
    (
        "tubes",
        "Cylinders, cones and a ball from a file in the Neutral File Format, which fixed point reads in larger units; one is seen from inside.",
    ),
    ("star", "Concave polygons from a file, cut into triangles on the chip."),
    (
        "dome",
        "Quadrilaterals, flat on the left and with a normal at each corner on the right, under a hierarchy of boxes.",
    ),
    (
        NOT_ON_CHIPS,
        "White things on a white floor, which an outline tells apart, for [displays](displays.md) of one bit. It is drawn on the host alone.",
    ),
];

/// A picture that is drawn on the host alone: the chips' program gives no scene an outline.
const NOT_ON_CHIPS: &str = "one-bit";

/// What the command of a picture printed: the command, and the lines that do not change from run to run.
fn said(name: &str) -> Outcome<(String, Vec<String>)> {
    let path = format!("docs/gallery/{name}.txt");
    let text = fs::read_to_string(in_repository(&path))
        .map_err(|error| format!("{path}: {error}; make it with `.ci/gallery --renew`"))?;
    let mut lines = text.lines().map(String::from);
    let command = lines.next().ok_or_else(|| format!("{path}: it is empty"))?;
    Ok((command, lines.collect()))
}

/// The document.
pub fn text() -> Outcome<String> {
    let mut text = INTRODUCTION.to_string();
    for (name, about) in PICTURES {
        let (command, lines) = said(name)?;
        let _ = write!(text, "\n## {name}\n\n![{name}](gallery/{name}.png)\n\n{about}\n\n");
        let _ = write!(text, "```sh\n{command}\n```\n\n");
        for line in lines {
            let _ = writeln!(text, "- {line}");
        }
        let chips = CHIPS.into_iter().filter(|(_, chip)| DRAWN_ON.contains(chip) && name != NOT_ON_CHIPS);
        for (target, chip) in chips {
            let baseline = chip::baseline(target)?;
            let figure = |number| {
                let instructions = Part::Gallery.figure(&baseline, &key(name, number, GALLERY_FIGURES[0]));
                instructions
                    .map(grouped)
                    .ok_or_else(|| format!("{name} was not measured on {chip}: .ci/measure --renew"))
            };
            let (fixed, float) = (figure("I16F16")?, figure("f32")?);
            let _ = writeln!(text, "- {chip}: {fixed} instructions a pixel in I16F16, {float} in f32");
        }
    }
    Ok(text)
}

/// Writes the document, or says whether it is as it should be.
pub fn write(verify: bool) -> Outcome {
    crate::document::put("docs/gallery.md", &text()?, verify)
}
