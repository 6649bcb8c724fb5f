//! The promise: scenes are read as others write them: from a file or a pipe, with any ends of lines, with comments in
//! any encoding.

use crate::support::{Folder, LIGHT, VIEW, ball};

#[test]
fn a_hyphen_reads_standard_input() {
    let folder = Folder::with(ball());
    folder.run("scene.nff -o a.ppm").succeeds_silently();
    let said = folder.run_with_input("-", ball().as_bytes()).succeeds_silently();
    assert!(said.output.ends_with("written: out/stdin.ppm, out/stdin.png\n"), "{said:?}");
    assert_eq!(folder.pixels("out/stdin.ppm"), folder.pixels("a.ppm"));
    folder
        .run_with_input("-", b"q")
        .fails("standard input, line 1, column 1: this starts no entity: expected one of v, b, l, f, c, s, p, pp or #");
    folder.shell("\"$render\" - -o - <scene.nff >b.ppm").succeeds();
    assert_eq!(folder.pixels("b.ppm"), folder.pixels("a.ppm"));
}

#[test]
fn lines_end_in_any_of_the_three_ways() {
    let lines = [VIEW.trim_end(), "# a comment", LIGHT.trim_end(), "s 0 0 0 1 # another", "s 0 0 zero 1", ""];
    let number = "should be a number such as -12.5 or 1.5e-3";
    let mut pictures = Vec::new();
    for end in ["\n", "\r\n", "\r"] {
        let folder = Folder::with(lines.join(end));
        folder.run("scene.nff").fails(&format!("scene.nff, line 5, column 7: the sphere's centre {number}"));
        let folder = Folder::with(lines[..4].join(end));
        folder.run("scene.nff -o a.ppm").succeeds_silently();
        pictures.push(folder.pixels("a.ppm"));
    }
    assert!(pictures[0].iter().any(|pixel| pixel[0] > 100));
    assert!(pictures.iter().all(|picture| *picture == pictures[0]));
}

#[test]
fn a_byte_that_is_no_text_is_no_error_in_a_comment() {
    let folder = Folder::with(ball());
    folder.run("scene.nff -o a.ppm").succeeds_silently();
    // Latin 1, and a cut-off sequence at the end of a line.
    let folder_2 = Folder::with([b"# caf\xe9 \xff\xfe\n", ball().as_bytes(), b"# na\xc3\n# \xe2\x82"].concat());
    folder_2.run("scene.nff -o a.ppm").succeeds_silently();
    assert_eq!(folder_2.pixels("a.ppm"), folder.pixels("a.ppm"));
}

#[test]
fn a_byte_that_is_no_text_is_an_error_elsewhere_with_line_and_column() {
    let reason = "this is no UTF-8 text: remove it, or move it into a comment behind a #";
    for (text, place) in [
        (&b"s 0 0 0 1\xff\n"[..], "line 3, column 10"),
        (b"# \xe9\n\xe9 s 0 0 0 1\n", "line 4, column 1"),
        (b"s 0 0\n \xc3\xa9\xff0 1", "line 4, column 3"),
        (b"p \xb3 0 0 0 1 0 0 0 1 0", "line 3, column 3"),
    ] {
        let folder = Folder::with([VIEW.as_bytes(), LIGHT.as_bytes(), text].concat());
        folder.run("scene.nff").fails(&format!("scene.nff, {place}: {reason}"));
    }
    let folder = Folder::with(b"v from 0 0 5 at 0 0 0 up 0 1 0 ang\xeele 45 resolution 8 6");
    folder.run("scene.nff").fails(&format!("scene.nff, line 1, column 35: {reason}"));
}

#[test]
#[cfg(target_os = "linux")]
fn a_file_that_cannot_be_read_says_what_to_do() {
    let folder = Folder::with(ball());
    std::fs::create_dir(folder.path("scenes")).unwrap();
    std::fs::write(folder.path("scenes/star.nff"), ball()).unwrap();
    let missing = "No such file or directory (os error 2)";
    for (name, reason) in [
        ("teapot.nff", format!("{missing}; check the name and the folder")),
        ("nowhere/scene.nff", format!("{missing}; check the name and the folder")),
        ("scene", format!("{missing}; did you mean scene.nff?")),
        ("scenes/stars.nff", format!("{missing}; did you mean scenes/star.nff?")),
        ("scenes", "Is a directory (os error 21); this is a folder: name a scene file in it".into()),
        (
            "scene.nff/a.nff",
            "Not a directory (os error 20); a file stands where a folder should: correct the path".into(),
        ),
    ] {
        folder.run(name).fails(&format!("cannot read {name}: {reason}"));
    }
    let said = folder.shell("\"$render\" - <scenes");
    said.fails("cannot read standard input: Is a directory (os error 21); this is a folder: name a scene file in it");
    assert_eq!(folder.files(), ["scene.nff", "scenes/", "scenes/star.nff"]);
}

#[test]
fn an_empty_file_says_what_a_scene_needs() {
    let view =
        "the file ends without a view: add one, such as \"v from 0 0 9 at 0 0 0 up 0 1 0 angle 45 resolution 160 120\"";
    Folder::with("").run("scene.nff").fails(&format!("scene.nff, line 1, column 1: {view}"));
    // What it suggests is a view.
    let (_, suggested) = view.split_once('"').unwrap();
    let folder = Folder::with(format!("{}\n{LIGHT}s 0 0 0 1", suggested.trim_end_matches('"')));
    folder.run("scene.nff").succeeds_silently();
}

/// Pictures and programs, and text that an editor saved as UTF-16.
#[test]
fn a_file_that_is_no_plain_text_says_so() {
    let plain = "scene.nff is no plain text: give a scene in the Neutral File Format (.nff), saved as UTF-8";
    let utf_16: Vec<u16> = std::iter::once(0xfeff).chain(ball().encode_utf16()).collect();
    for bytes in [
        utf_16.iter().flat_map(|unit| unit.to_le_bytes()).collect(),
        utf_16.iter().flat_map(|unit| unit.to_be_bytes()).collect(),
        utf_16[1..].iter().flat_map(|unit| unit.to_le_bytes()).collect(),
        b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec(),
    ] {
        Folder::with(bytes).run("scene.nff").fails(plain);
    }
    // The mark that some editors put before UTF-8 is none of the scene's business.
    Folder::with(["\u{feff}", &ball()].concat()).run("scene.nff").succeeds_silently();
}
