//! Every error message: what is wrong, where, and what to do.

use super::super::words::list;
use super::super::{csv, placement, solid};
use super::{at, measured};

const RAY: &str = "0,0,5,0,0,-1";

#[track_caller]
fn refused(options: &super::Options, text: &str, message: &str) {
    match measured(options, text) {
        Ok(_) => panic!("measured, not refused: {message}"),
        Err(error) => assert_eq!(error, message),
    }
}

#[test]
fn solids() {
    let all = list(&solid::EXAMPLES);
    for (text, message) in [
        ("", format!("no solid is named: give one of{all}")),
        ("cube side 1", format!("`cube` is no solid that is measured: give one of{all}")),
        (
            "cylinder radius 1",
            format!("`cylinder` alone does not say which: give one of{}", list(&solid::EXAMPLES[1..4])),
        ),
        ("cone", format!("`cone` alone does not say which: give one of{}", list(&solid::EXAMPLES[4..8]))),
        (
            "cylinder capped radius 1 half-height 2",
            "the cylinder capped has no size `half-height`; its sizes are radius, height: write `cylinder capped radius 1 height 2`"
                .into(),
        ),
        ("capsule radius 1", "the capsule has no height: give all sizes, as in `capsule radius 1 height 2`".into()),
        ("sphere radius 1 radius 2", "the radius of the sphere is given twice: remove one".into()),
        ("plane radius 1", "the plane has no sizes: remove `radius`".into()),
        ("sphere radius", "`radius` takes a number, and has none".into()),
        ("capsule radius height 2", "`radius` takes a number, and has none before `height`".into()),
        ("sphere radius 1,5", "the sphere has no size `5`; its sizes are radius: write `sphere radius 1`".into()),
        ("sphere radius 1_0", "radius: `1_0` is not a number: give a decimal number such as -12.5 or 1.5e-3".into()),
        ("sphere radius 1e999", "radius: 1e999 is beyond every number type: give a smaller one".into()),
        ("triangle 0 0 0 1 0 0 0 0", "`each vertex of the triangle` takes 3 numbers, and has 2".into()),
        ("triangle 0 0 0 1 0 0 0 0 1 9", "`9` after the three vertices of the triangle: remove it".into()),
    ] {
        refused(&at(text, ""), RAY, &format!("--solid: {message}"));
    }
}

/// The library's own words, where no number type holds it.
#[test]
fn sizes() {
    let all = "f32, f64, I16F16, I32F32";
    for (solid, name, message) in [
        ("sphere radius -1", "sphere", "the radius is negative"),
        (
            "cylinder capped radius 1 height 0",
            "cylinder capped",
            "the height is zero, or was below one unit of the number type and was rounded to zero",
        ),
        ("cone nappe slope -2", "cone nappe", "the slope (radius over height) is negative"),
        ("triangle 0 0 0 1 0 0 2 0 0", "triangle", "the vertices lie on a line, or too nearly so for the number type"),
    ] {
        refused(&at(solid, ""), RAY, &format!("no number type ({all}) holds the {name}: {message}"));
    }
    let placements = [
        ("at 0 0 0 axis 0 0 0", "the vector `axis` has no direction: it is zero"),
        (
            "at 0 0 0 forward 0 0 1 up 0 0 2",
            "the axes do not span a right-handed frame: two are parallel, or the third points the other way",
        ),
        ("stretched 1 -1 1", "a factor of the scale is negative"),
        (
            "x 1 0 0 y 0 1 0 z 1 1 0",
            "the matrix has no inverse that the number type could hold: an axis has no length, or the three lie in a plane",
        ),
    ];
    for (placement, message) in placements {
        let told = format!("no number type ({all}) holds the sphere: {message}");
        refused(&at("sphere radius 1", placement), RAY, &told);
    }
    let error =
        measured(&super::command(&["my.csv", "--solid", "plane", "-p", "at 1e9 0 0", "-n", "I16F16"]), RAY).err();
    let message = "no number type (I16F16) holds the plane: a number of `at` is beyond what the number type can hold";
    assert_eq!(error.as_deref(), Some(message));
}

#[test]
fn placements() {
    let all = list(&placement::EXAMPLES);
    for (text, message) in [
        ("1 2 3", format!("`1` is no part of a placement: give one of{all}")),
        ("at 1 2", "`at` takes 3 numbers, and has 2".into()),
        ("at 1 2 axis 0 1 0", "`at` takes 3 numbers, and has 2 before `axis`".into()),
        ("at 1 2 3 at 1 2 3", "`at` is given twice: remove one".into()),
        ("at 1 2 three", "`at` takes 3 numbers, and has 2 before `three`".into()),
        ("at 1 2 0x3", "at: `0x3` is not a number: give a decimal number such as -12.5 or 1.5e-3".into()),
        ("at 0 0 0 up 0 1 0", format!("at, up make no placement together: give one of{all}")),
        ("axis 0 0 1 up 0 1 0", format!("axis, up make no placement together: give one of{all}")),
        ("x 1 0 0 y 0 1 0", format!("x, y make no placement together: give one of{all}")),
    ] {
        refused(&at("sphere radius 1", text), RAY, &format!("--placement: {message}"));
    }
}

#[test]
fn files() {
    let number = "give a decimal number such as -12.5 or 1.5e-3";
    for (text, message) in [
        ("", "my.csv has no ray: give one a line, ox,oy,oz,dx,dy,dz".into()),
        ("# Nothing.\nox,oy,oz,dx,dy,dz\n", "my.csv has no ray: give one a line, ox,oy,oz,dx,dy,dz".into()),
        ("0,0,5,0,0,-1\n\n0,0,5,0,zero,-1", format!("my.csv, line 3, column 5 (dy): `zero` is not a number: {number}")),
        ("0,0,5,0,0,-1\n0,inf,5,0,0,-1", format!("my.csv, line 2, column 2 (oy): `inf` is not finite: {number}")),
        ("1e400,0,5,0,0,-1", "my.csv, line 1, column 1 (ox): 1e400 is beyond every number type: give a smaller one".into()),
        ("0,0,,0,0,-1", "my.csv, line 1, column 3 (oz): it is empty: give a decimal number".into()),
        (
            "0,0,5,0,0,-1\n0,0,5,0,0,0.0",
            "my.csv, line 2, columns 4 to 6 (dx, dy, dz): the direction is zero: give it a length".into(),
        ),
        (
            "0,0,5,0,0,-1,2,1",
            "my.csv, line 1, column 8 (end): the range is empty, since it starts at 2 and ends at 1: exchange them".into(),
        ),
        (
            "0,0,5,0,0,-1,,-1",
            "my.csv, line 1, column 8 (end): the range is empty, since it starts at 0 and ends at -1: give a start before it".into(),
        ),
        (
            "ox,oz,oy,dx,dy,dz\n0,0,5,0,0,-1",
            "my.csv, line 1, column 2 (oy): the header calls it `oz`: name the columns ox,oy,oz,dx,dy,dz,start,end,part,leaving, or leave the header out"
                .into(),
        ),
        (
            "0 0 5 0 0 -1",
            "my.csv, line 1: it has 1 column: give 6 (origin x, y, z, direction x, y, z), 8 (also start and end of the range, which \
             may be empty) or 10 (also the part that the ray departs from, and to which side), separated by commas"
                .into(),
        ),
        (
            "0,0,5,0,0,-1,7",
            "my.csv, line 1: it has 7 columns: give 6 (origin x, y, z, direction x, y, z), 8 (also start and end of the range, which \
             may be empty) or 10 (also the part that the ray departs from, and to which side), separated by commas"
                .into(),
        ),
    ] {
        refused(&at("sphere radius 1", ""), text, &message);
    }
}

#[test]
fn departures() {
    for (cells, message) in [
        ("top,", "column 10 (leaving): it is empty: give `outwards` or `inwards`"),
        (",inwards", "column 9 (part): it is empty: name the part that the ray departs from"),
        (
            "lid,inwards",
            "column 9 (part): `lid` is none of side, base, top, left, right, back, front, inner: give one of them, or leave both cells of the \
             departure empty",
        ),
        (
            "top,in",
            "column 10 (leaving): `in` is none of outwards, inwards: give one of them, or leave both cells of the departure empty",
        ),
        ("left,inwards", "column 9 (part): the cone capped has no part `left`: give one of its parts, side, top"),
        ("base,outwards", "column 9 (part): the cone capped has no part `base`: give one of its parts, side, top"),
    ] {
        let text = format!("{RAY},,,side,inwards\n0,1,0,0,1,0,,,{cells}");
        refused(&at("cone capped slope 1 height 2", ""), &text, &format!("my.csv, line 2, {message}"));
    }
}

#[test]
fn files_that_cannot_be_read() {
    let missing = csv::read("no/such.csv").unwrap_err();
    assert!(missing.starts_with("no/such.csv cannot be read: "), "{missing}");
    assert!(missing.ends_with(": give the path of a file of rays, or `-`"), "{missing}");
    let path = std::env::temp_dir().join(format!("raylet-rays-{}.csv", std::process::id()));
    let name = path.to_str().unwrap();
    std::fs::write(&path, b"0,0,5,0,0,-1\n0,0,\xff,0,0,-1\n").unwrap();
    let told = csv::read(name).unwrap_err();
    std::fs::remove_file(&path).unwrap();
    assert_eq!(told, format!("{name}, line 2: this is not text in UTF-8: save the file as UTF-8"));
}

/// What the command line itself refuses.
#[test]
fn options() {
    use clap::Parser;
    let refused = |words: &[&str]| {
        let all = ["raylet-accuracy", "rays"].iter().chain(words);
        crate::Options::try_parse_from(all).err().map(|error| error.to_string()).unwrap_or_default()
    };
    assert!(refused(&["my.csv"]).contains("--solid <SOLID>"));
    assert!(refused(&["--solid", "plane"]).contains("<FILE>"));
    assert!(refused(&["my.csv", "--solid", "plane", "--number", "f16"]).contains("I16F16"));
    assert!(
        crate::Options::try_parse_from(["raylet-accuracy", "--write", "rays", "my.csv", "--solid", "plane"]).is_err()
    );
}
