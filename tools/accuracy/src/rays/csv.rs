//! A file of rays: comma-separated values, a ray a line.
//!
//! The cells are numbers, which hold no commas, quotes or line breaks: lines are split at commas, without a library. So
//! a line's number is that of the editor, after comments and empty lines too.

use super::decimal::{Decimal, direction, doubles, rounded};
use raylet::{Departure, Leaving, Part, Range, Ray, Vec3};
use support::exact_types::Exact;

/// The columns in their order; the last two and the last four may be left out.
pub const COLUMNS: [&str; 10] = ["ox", "oy", "oz", "dx", "dy", "dz", "start", "end", "part", "leaving"];

/// How many columns a line may have.
const COUNTS: [usize; 3] = [6, 8, 10];

/// The columns of a departure, counted from zero.
const PART: usize = 8;
const LEAVING: usize = 9;

const PARTS: [(&str, Part); 8] = [
    ("side", Part::Side),
    ("base", Part::Base),
    ("top", Part::Top),
    ("left", Part::Left),
    ("right", Part::Right),
    ("back", Part::Back),
    ("front", Part::Front),
    ("inner", Part::Inner),
];

const SIDES: [(&str, Leaving); 2] = [("outwards", Leaving::Outwards), ("inwards", Leaving::Inwards)];

/// One line of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<'a> {
    /// Its number, from 1.
    pub number: usize,
    pub origin: [Decimal<'a>; 3],
    pub direction: [Decimal<'a>; 3],
    /// Where the range starts and ends, if that is said.
    pub range: [Option<Decimal<'a>>; 2],
    /// The part of the solid that the ray departs from, and to which side.
    pub departure: Option<(Part, Leaving)>,
}

/// The text of a file; `-` is the standard input.
pub fn read(path: &str) -> Result<String, String> {
    let told = |error| format!("{path} cannot be read: {error}: give the path of a file of rays, or `-`");
    let bytes = if path == "-" {
        let mut bytes = vec![];
        std::io::Read::read_to_end(&mut std::io::stdin(), &mut bytes).map_err(told)?;
        bytes
    } else {
        std::fs::read(path).map_err(told)?
    };
    String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = valid.split(|byte| *byte == b'\n').count();
        format!("{path}, line {line}: this is not text in UTF-8: save the file as UTF-8")
    })
}

/// The cells of a line, without blanks and quotes around them.
fn cells(line: &str) -> Vec<&str> {
    let bare = |cell: &str| cell.trim().len() >= 2 && cell.trim().starts_with('"') && cell.trim().ends_with('"');
    line.split(',').map(|cell| if bare(cell) { cell.trim().trim_matches('"').trim() } else { cell.trim() }).collect()
}

/// The error of one cell.
fn at(path: &str, line: usize, column: usize, what: &str) -> String {
    format!("{path}, line {line}, column {} ({}): {what}", column + 1, COLUMNS[column])
}

fn check_header(path: &str, number: usize, cells: &[&str]) -> Result<(), String> {
    for (column, cell) in cells.iter().enumerate() {
        if !cell.eq_ignore_ascii_case(COLUMNS[column]) {
            return Err(at(
                path,
                number,
                column,
                &format!(
                    "the header calls it `{cell}`: name the columns {}, or leave the header out",
                    COLUMNS.join(",")
                ),
            ));
        }
    }
    Ok(())
}

/// The rays of a file, or what is wrong with it, where, and what to do.
pub fn parse<'a>(path: &str, text: &'a str) -> Result<Vec<Line<'a>>, String> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = vec![];
    let mut is_first = true;
    for (number, line) in (1..).zip(text.lines()) {
        if line.trim().is_empty() || line.trim_start().starts_with('#') {
            continue;
        }
        let cells = cells(line);
        if !COUNTS.contains(&cells.len()) {
            let columns = if cells.len() == 1 { "1 column".into() } else { format!("{} columns", cells.len()) };
            return Err(format!(
                "{path}, line {number}: it has {columns}: give 6 (origin x, y, z, direction x, y, z), 8 (also start \
                 and end of the range, which may be empty) or 10 (also the part that the ray departs from, and to \
                 which side), separated by commas"
            ));
        }
        // A header has no number at all.
        if std::mem::take(&mut is_first) && cells.iter().all(|cell| !cell.is_empty() && Decimal::parse(cell).is_err()) {
            check_header(path, number, &cells)?;
            continue;
        }
        lines.push(self::line(path, number, &cells)?);
    }
    if lines.is_empty() {
        return Err(format!("{path} has no ray: give one a line, {}", COLUMNS[..6].join(",")));
    }
    Ok(lines)
}

fn line<'a>(path: &str, number: usize, cells: &[&'a str]) -> Result<Line<'a>, String> {
    let at = |column: usize, what: &str| at(path, number, column, what);
    let cell = |column: usize| match cells[column] {
        "" => Err(at(column, "it is empty: give a decimal number")),
        text => Decimal::parse(text).map_err(|what| at(column, &what)),
    };
    let three = |first: usize| Ok::<_, String>([cell(first)?, cell(first + 1)?, cell(first + 2)?]);
    let end = |column: usize| match cells.get(column) {
        None | Some(&"") => Ok(None),
        Some(_) => cell(column).map(Some),
    };
    let departure = departure(cells).map_err(|(column, what)| at(column, &what))?;
    let line = Line { number, origin: three(0)?, direction: three(3)?, range: [end(6)?, end(7)?], departure };
    if doubles(line.direction) == [0.0; 3] {
        return Err(format!(
            "{path}, line {number}, columns 4 to 6 (dx, dy, dz): the direction is zero: give it a length"
        ));
    }
    let [start, end] = line.range.map(|end| end.map(|end| end.double));
    if let Some(end) = end.filter(|end| *end < start.unwrap_or(0.0)) {
        let (start, remedy) = start.map_or((0.0, "give a start before it"), |start| (start, "exchange them"));
        return Err(at(7, &format!("the range is empty, since it starts at {start} and ends at {end}: {remedy}")));
    }
    Ok(line)
}

/// The value of a name, which may be written in capitals.
fn named<T: Copy>(names: &[(&str, T)], name: &str) -> Result<T, String> {
    let found = names.iter().find(|(known, _)| known.eq_ignore_ascii_case(name));
    found.map(|(_, value)| *value).ok_or_else(|| {
        let all: Vec<_> = names.iter().map(|(known, _)| *known).collect();
        format!("`{name}` is none of {}: give one of them, or leave both cells of the departure empty", all.join(", "))
    })
}

/// The departure that a line tells, if it tells one; or in which column it is wrong, and what to do.
fn departure(cells: &[&str]) -> Result<Option<(Part, Leaving)>, (usize, String)> {
    let [part, leaving] = [PART, LEAVING].map(|column| cells.get(column).copied().unwrap_or_default());
    match (part, leaving) {
        ("", "") => Ok(None),
        ("", _) => Err((PART, "it is empty: name the part that the ray departs from".into())),
        (_, "") => Err((LEAVING, "it is empty: give `outwards` or `inwards`".into())),
        _ => Ok(Some((
            named(&PARTS, part).map_err(|what| (PART, what))?,
            named(&SIDES, leaving).map_err(|what| (LEAVING, what))?,
        ))),
    }
}

/// Fails at a ray that departs from a part that the solid of this name does not have.
pub fn check_parts(path: &str, lines: &[Line<'_>], solid: &str, parts: &[Part]) -> Result<(), String> {
    let names = |has: &dyn Fn(Part) -> bool| {
        PARTS.iter().filter(|(_, part)| has(*part)).map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
    };
    for line in lines {
        if let Some((part, _)) = line.departure.filter(|(part, _)| !parts.contains(part)) {
            let [own, all] = [names(&|other| other == part), names(&|other| parts.contains(&other))];
            return Err(at(
                path,
                line.number,
                PART,
                &format!("the {solid} has no part `{own}`: give one of its parts, {all}"),
            ));
        }
    }
    Ok(())
}

impl Line<'_> {
    /// The ray as the number type stores it; `None` if the type does not hold it. A range that ends beyond the type
    /// ends where the type does: there is no `t` in between.
    pub fn ray<S: Exact>(&self) -> Option<Ray<S>> {
        let origin = Vec3::from(rounded::<S>(self.origin).ok()?);
        let direction = direction(self.direction).ok()?;
        let farthest = S::BUDGET.distance;
        let [start, end] = self.range;
        let start = start.map_or(Ok(S::ZERO), |start| start.rounded()).ok()?;
        let end = match end.map(|end| (end.double, end.rounded::<S>())) {
            Some((_, Ok(end))) if end < farthest => end,
            Some((end, Err(_))) if end < 0.0 => return None,
            _ => farthest,
        };
        let ray = Ray::new(origin, direction).ok()?.with_range(Range::new(start, end).ok()?);
        Some(match self.departure {
            Some((part, leaving)) => ray.departing(Departure { object: 0, part, leaving }),
            None => ray,
        })
    }
}
