//! A sheet of panels with a legend, and its colours.
//!
//! A plot brings its own background: with a style that follows the colours that the reader prefers, text and ground
//! always fit each other, whatever page it stands on. The colours of the series are of middling lightness and read on
//! both.

use plotters::coord::Shift;
use plotters::coord::combinators::LogCoord;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;
use support::figures::TIERS;

/// Where the panels are drawn.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Stand-ins, which the style replaces by what the reader prefers.
pub const INK: RGBColor = RGBColor(0x1f, 0x23, 0x28);
const PAPER: RGBColor = RGBColor(0xfe, 0xfe, 0xfe);
const GRID: RGBColor = RGBColor(0xd8, 0xdc, 0xe0);

const STYLE: &str = "<style>\
    .paper{fill:#fff}.ink{fill:#1f2328}.pen{stroke:#1f2328}.grid{stroke:#d8dce0}\
    @media(prefers-color-scheme:dark){.paper{fill:#0d1117}.ink{fill:#e6edf3}.pen{stroke:#e6edf3}.grid{stroke:#30363d}}\
    </style>";

/// The shape of a mark: one for each tier.
#[derive(Clone, Copy)]
pub enum Mark {
    Cross,
    Diamond,
    Triangle,
    Circle,
    Square,
}

impl Mark {
    pub fn of(tier: &str) -> Self {
        match tier {
            "Textbook" => Self::Cross,
            "Plain" => Self::Diamond,
            "Fast" => Self::Triangle,
            "Stable" => Self::Circle,
            _ => Self::Square,
        }
    }

    /// The outline around a point, in pixels; what is hollow marks wrong hits or misses.
    pub fn draw<DB: DrawingBackend, CT: CoordTranslate>(
        self,
        area: &DrawingArea<DB, CT>,
        at: CT::From,
        color: RGBColor,
        hollow: bool,
    ) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>>
    where
        CT::From: Clone + 'static,
    {
        let style = if hollow { color.stroke_width(1) } else { color.filled() };
        let point = EmptyElement::at(at);
        match self {
            Self::Cross => area.draw(&(point + Cross::new((0, 0), 4, color.stroke_width(if hollow { 1 } else { 2 })))),
            Self::Diamond => {
                let corners = vec![(0, -5), (5, 0), (0, 5), (-5, 0), (0, -5)];
                if hollow {
                    area.draw(&(point + PathElement::new(corners, style)))
                } else {
                    area.draw(&(point + Polygon::new(corners, style)))
                }
            }
            Self::Triangle => area.draw(&(point + TriangleMarker::new((0, 0), 5, style))),
            Self::Circle => area.draw(&(point + Circle::new((0, 0), 4, style))),
            Self::Square => area.draw(&(point + Rectangle::new([(-4, -4), (4, 4)], style))),
        }
    }
}

/// Text of the sheet, in pixels from where it starts.
pub fn label(area: &Area<'_>, text: &str, at: (i32, i32), size: i32) -> Result<(), Box<dyn Error>> {
    let style = ("sans-serif", size).into_font().color(&INK).pos(Pos::new(HPos::Left, VPos::Center));
    area.draw(&Text::new(text.to_string(), at, style))?;
    Ok(())
}

/// A panel of two logarithmic axes.
pub type Panel<'a, 'b> = ChartContext<'b, SVGBackend<'a>, Cartesian2d<LogCoord<f64>, LogCoord<f64>>>;

/// An axis of a panel.
pub struct Axis {
    pub between: [f64; 2],
    pub labels: usize,
}

/// An empty panel. `across` says what is written at a place of the axis across.
pub fn panel<'a, 'b>(
    area: &'b Area<'a>,
    title: &str,
    [x, y]: [Axis; 2],
    across: impl Fn(&f64) -> String,
) -> Result<Panel<'a, 'b>, Box<dyn Error>> {
    let span = |axis: &Axis| (axis.between[0]..axis.between[1]).log_scale();
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 13).into_font().color(&INK))
        .margin(4)
        .margin_right(12)
        .x_label_area_size(18)
        .y_label_area_size(38)
        .build_cartesian_2d(span(&x), span(&y))?;
    chart
        .configure_mesh()
        .x_labels(x.labels)
        .y_labels(y.labels)
        .max_light_lines(0)
        .bold_line_style(GRID.stroke_width(1))
        .axis_style(GRID.stroke_width(1))
        .label_style(("sans-serif", 10).into_font().color(&INK))
        .x_label_formatter(&across)
        .y_label_formatter(&|value| power(*value))
        .draw()?;
    Ok(chart)
}

/// The marks of the tiers, and what a hollow one means, from this place on.
pub fn tiers(area: &Area<'_>, mut x: i32, color: impl Fn(&str) -> RGBColor) -> Result<(), Box<dyn Error>> {
    for tier in TIERS {
        Mark::of(tier).draw(area, (x, 40), color(tier), false)?;
        label(area, tier, (x + 10, 40), 12)?;
        x += 84;
    }
    label(area, "thin or hollow: wrong hits or misses", (x, 40), 12)
}

/// A power of ten, as a label.
pub fn power(value: f64) -> String {
    let exponent = value.log10();
    if (-2.5..=3.5).contains(&exponent) { format!("{value}") } else { format!("{value:.0e}") }
}

/// Draws on a sheet of this size, and gives it its colours.
pub fn sheet(
    size: (u32, u32),
    title: &str,
    draw: impl FnOnce(&Area<'_>) -> Result<(), Box<dyn Error>>,
) -> Result<String, Box<dyn Error>> {
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        area.fill(&PAPER)?;
        label(&area, title, (12, 18), 16)?;
        draw(&area)?;
        area.present()?;
    }
    Ok(colored(&svg))
}

/// The stand-ins replaced, and what says nothing left out: half of a plot is attributes that are the default.
fn colored(svg: &str) -> String {
    let mut svg = svg
        .replace(" opacity=\"1\"", "")
        .replace(" stroke=\"none\"", "")
        .replace("text-anchor=\"start\" ", "")
        .replace("font-family=\"sans-serif\" ", "")
        .replace(" stroke-width=\"1\"", "");
    for (color, [fill, stroke]) in [(INK, ["ink", "pen"]), (PAPER, ["paper", "paper"]), (GRID, ["ink", "grid"])] {
        let RGBColor(r, g, b) = color;
        let written = format!("#{r:02X}{g:02X}{b:02X}");
        svg = svg
            .replace(&format!("fill=\"{written}\""), &format!("class=\"{fill}\""))
            .replace(&format!("stroke=\"{written}\""), &format!("class=\"{stroke}\""));
    }
    // The lines between the labelled ones, which are drawn where there are none too.
    svg = svg.lines().filter(|line| !line.contains("opacity=\"0.1\"")).collect::<Vec<_>>().join("\n");
    // A text's own lines and its element's are one.
    svg = svg.replace(">\n", ">").replace("\n</text>", "</text>").replace("><", ">\n<");
    let head = svg.find('>').map_or(0, |end| end + 1);
    let tags =
        svg[head..].find("<svg").and_then(|start| svg[head + start..].find('>').map(|end| head + start + end + 1));
    let (before, after) = svg.split_at(tags.unwrap_or(head));
    format!("{}{STYLE}{after}\n", before.replacen("<svg ", "<svg font-family=\"sans-serif\" ", 1))
}
