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

Each picture with the command that draws it, what that command says, and what a pixel costs on a chip. Written by `.ci/measure
--document` from the output of `.ci/gallery --renew` and the figures of `.ci/measure --renew`; do not edit. CI draws every picture
again and compares it to the bit.

The instructions are those of the same scene at 24 by 18 pixels, in the mean, with 3 by 3 samples where a pixel's corners differ: at that
size more of the pixels have an edge in them than in the picture shown. What instructions are is told in
[microcontrollers.md](microcontrollers.md).
";

/// The file of a picture, and what the gallery says of it: in this order.
const PICTURES: [(&str, &str); 7] = [
    (
        "still-life",
        "Every solid of revolution, a disc and a pyramid. A ball stretched to an ellipsoid, a cone on its apex, a disc that leans on it.",
    ),
    (
        "patterns",
        "Materials of their own on base and top; checkers, stripes and an image of 8 by 8 pixels through `uv`, on a cuboid and a rectangle too; a capsule carved from cells in space, through `uvw`.",
    ),
    ("glass", "Refraction with Fresnel's weights and total reflection, mirrors, a pane of index 1 that bends nothing."),
    ("waves", "Bump mapping through the tangents: on water that mirrors, on a ball, as flutes of columns in fog."),
    (
        "tubes",
        "Cylinders, cones and a ball from a file in the Neutral File Format, in fixed point read in larger units; one is seen from within.",
    ),
    ("star", "Concave polygons from a file, cut into triangles on the chip."),
    (
        "dome",
        "Quadrilaterals, flat on the left and with a normal at each corner on the right, under a hierarchy of boxes.",
    ),
];

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
        for (target, chip) in CHIPS.into_iter().filter(|(_, chip)| DRAWN_ON.contains(chip)) {
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
