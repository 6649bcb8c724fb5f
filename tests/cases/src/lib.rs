//! The hard cases as data for other programs: `data/cases/cases.jsonl` has the cases of the tables, each as a line of
//! JSON that `data/cases/make.py` completes.

#![cfg(test)]

use std::fmt::{Display, Write as _};
use support::hard_case::{Axis, Case, Kind, Written, classes};
use support::in_repository;

fn list(items: impl IntoIterator<Item = impl Display>) -> String {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    format!("[{}]", items.join(", "))
}

/// A number as it is written: a decimal, a fraction, or a multiple of a power of two with all its digits.
fn number(number: f64) -> String {
    let thirds = number * 3.0;
    if thirds.fract() == 0.0 && number.fract() != 0.0 {
        return format!("\"{thirds}/3\"");
    }
    let digits = format!("{number:.160e}");
    let (mantissa, exponent) = digits.split_once('e').expect("it has an exponent");
    let is_short = number.to_bits() & ((1 << 40) - 1) == 0;
    if is_short && !(1e-5..1e15).contains(&number.abs()) && number != 0.0 {
        format!("{}e{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
    } else {
        format!("{number:?}")
    }
}

fn numbers(numbers: &[f64]) -> String {
    list(numbers.iter().copied().map(number))
}

/// The solid in its canonical pose, by what it is and its sizes. A height that an axis gives is left out.
fn solid(Case { kind, axis, .. }: &Case) -> String {
    let named = |name: &str, sizes: &[(&str, f64)]| {
        let mut text = format!("{{\"kind\": \"{name}\"");
        for (size, value) in sizes {
            if *size != "height" || !matches!(axis, Axis::To(_)) {
                write!(text, ", \"{size}\": {}", number(*value)).expect("a string has room");
            }
        }
        text + "}"
    };
    match *kind {
        Kind::Ball(r) => named("sphere", &[("radius", r)]),
        Kind::Tube(r) => named("infinite cylinder", &[("radius", r)]),
        Kind::Pipe(r, h) => named("open cylinder", &[("radius", r), ("height", h)]),
        Kind::Can(r, h) => named("cylinder", &[("radius", r), ("height", h)]),
        Kind::Pill(r, h) => named("capsule", &[("radius", r), ("height", h)]),
        Kind::DoubleCone(m) => named("double cone", &[("slope", m)]),
        Kind::Nappe(m) => named("infinite cone", &[("slope", m)]),
        Kind::Horn(m, h) => named("open cone", &[("slope", m), ("height", h)]),
        Kind::Cone(m, h) => named("cone", &[("slope", m), ("height", h)]),
        Kind::Frustum(a, b, h) => named("frustum", &[("base_radius", a), ("top_radius", b), ("height", h)]),
        Kind::Skirt(a, b, h) => named("open frustum", &[("base_radius", a), ("top_radius", b), ("height", h)]),
        Kind::Plane => named("plane", &[]),
        Kind::Disc(r) => named("disc", &[("radius", r)]),
        Kind::Box([x, y, z]) => named("box", &[("half_x", x), ("half_y", y), ("half_z", z)]),
        Kind::Rectangle([x, z]) => named("rectangle", &[("half_x", x), ("half_z", z)]),
        Kind::Triangle(corners) => {
            format!("{{\"kind\": \"triangle\", \"vertices\": {}}}", list(corners.iter().map(|at| numbers(at))))
        }
    }
}

fn hit((crossing, part, t): &Written) -> String {
    let [crossing, part] = [format!("{crossing:?}"), format!("{part:?}")].map(|name| name.to_lowercase());
    format!("{{\"t\": \"{t}\", \"crossing\": \"{crossing}\", \"part\": \"{part}\"}}")
}

/// A case, but for the closing brace.
fn line(class: &str, case: &Case) -> String {
    let axis = match case.axis {
        Axis::X => numbers(&[1.0, 0.0, 0.0]),
        Axis::Y => numbers(&[0.0, 1.0, 0.0]),
        Axis::Z => numbers(&[0.0, 0.0, 1.0]),
        Axis::To(end) => format!("{{\"to\": {}}}", numbers(&end)),
    };
    let end = |end: Option<&str>| end.map_or("null".to_string(), |end| format!("\"{end}\""));
    let lies = case.lies.map_or("null".to_string(), |ends| list(ends.map(end)));
    format!(
        "{{\"name\": \"{}\", \"class\": \"{class}\", \"why\": \"{}\", \
         \"source\": \"tests/support/src/hard_case/{class}.rs\", \
         \"solid\": {}, \"base\": {}, \"axis\": {axis}, \"origin\": {}, \"direction\": {}, \"hits\": {}, \
         \"starts_inside\": {}, \"lies_in_it\": {lies}",
        case.name,
        case.breaks,
        solid(case),
        numbers(&case.base),
        numbers(&case.origin),
        numbers(&case.towards),
        list(case.hits.iter().map(hit)),
        case.starts_inside,
    )
}

#[test]
fn the_cases_are_stored_as_data() {
    let lines: Vec<String> =
        classes().into_iter().flat_map(|(class, cases)| cases.iter().map(move |case| line(class, case))).collect();
    let path = in_repository("data/cases/cases.jsonl");
    if std::env::var_os("RAYLET_WRITE_EXPECTED").is_some() {
        let text: String = lines.iter().map(|line| line.clone() + "}\n").collect();
        std::fs::write(&path, text).expect("the file can be written");
    }
    let stored = std::fs::read_to_string(&path).unwrap_or_default();
    let renew = "write them with RAYLET_WRITE_EXPECTED=1, and complete them with data/cases/make.py";
    assert_eq!(stored.lines().count(), lines.len(), "{renew}");
    for (stored, line) in stored.lines().zip(&lines) {
        assert!(stored.starts_with(line), "{renew}:\n{line}\n{stored}");
    }
}
