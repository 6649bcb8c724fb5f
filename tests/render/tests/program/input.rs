//! The promise: scenes are read as others write them: from a file or a pipe, with any ends of lines, with comments in any encoding.

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
