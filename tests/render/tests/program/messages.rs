//! The promise: what the program says is about its options and the file, in the words of whoever runs it.

use crate::support::{BALL, Folder, LIGHT, VIEW};

/// What is said of a file, in a view and with a light before it: they are lines 1 and 2.
fn said(rest: &str, options: &str) -> String {
    let folder = Folder::with(format!("{VIEW}{LIGHT}{rest}"));
    let said = folder.run(&format!("scene.nff {options}"));
    assert_eq!(said.code, Some(1), "{said:?}");
    said.error.trim_end().strip_prefix("error: scene.nff, line 3, column ").unwrap_or(&said.error).to_owned()
}

#[test]
fn a_coordinate_too_large_says_which_way_to_scale() {
    assert_eq!(
        said("s 20000 0 0 1", "-n i16f16 --scale 1"),
        "3: the sphere's centre is beyond 16384, the most that i16f16 holds at --scale 1: give --scale auto, or a \
         smaller --scale, or -n i32f32, f32 or f64"
    );
    assert_eq!(
        said("s 20000 0 0 1", "-n i16f16 --scale 4").split(':').nth(1),
        Some(" the sphere's centre is beyond 4096, the most that i16f16 holds at --scale 4")
    );
    assert_eq!(
        said("s 2e9 0 0 1", "-n i16f16"),
        "3: the sphere's centre is beyond 1073741824, the most that i16f16 holds at --scale 1/65536: move everything closer \
         to the origin, or -n i32f32, f32 or f64"
    );
    // The view's own from is beyond that.
    let tiny = said("s 1 0 0 1", "-n i16f16 --scale 4294967296");
    assert!(tiny.contains("is beyond 3.8e-6, the most that i16f16 holds at --scale 4294967296"), "{tiny}");
    // What was advised helps.
    for advised in ["--scale auto", "--scale 1/2", "--scale 1 -n i32f32"] {
        Folder::with(format!("{VIEW}{LIGHT}{BALL}s 20000 0 0 1"))
            .run(&format!("scene.nff -n i16f16 {advised}").replace("-n i16f16 --scale 1 -n", "--scale 1 -n"))
            .succeeds();
    }
}

#[test]
fn a_number_too_large_that_is_no_length_is_not_scaled() {
    assert_eq!(
        said("f 1 1 1 40000 0 1 0 1", "-n i16f16"),
        "9: the material's Kd is beyond 32768, the most that i16f16 holds: give a smaller number, or -n i32f32, \
         f32 or f64"
    );
    assert!(said("s 1e999 0 0 1", "-n f64").ends_with("move everything closer to the origin"));
}

#[test]
fn a_polygon_with_more_corners_than_the_file_says_so() {
    assert_eq!(
        said("p 4294967295 0 0 0 1 0 0 0 1 0", ""),
        "3: the file ends before 4294967295 corners: give as many as the polygon has"
    );
    assert_eq!(said("pp 999 0 0 0 0 0 1", "").split(':').nth(1), Some(" the file ends before 999 corners"));
    assert!(said("p 4 0 0 0 1 0 0 0 1 0  ", "").contains("the file ends where the corner's position should be"));
}

#[test]
fn no_message_names_a_type_of_the_library() {
    for (rest, options) in [
        ("s 20000 0 0 1", "-n i16f16 --scale 1"),
        ("p 99 0 0 0", ""),
        ("f 1 1 1 1 0 -1e9 0 1", "-n i16f16"),
        ("c -1e4 -1e4 -1e4 1 1e4 1e4 1e4 1", "-n i16f16 --scale 1"),
        ("s 1 2", ""),
    ] {
        let said = said(rest, options);
        let words = ["nff::", "Scale", "budget", "scratch", "store", "capacity", "number type"];
        assert!(words.iter().all(|word| !said.contains(word)), "{said}");
    }
}

#[test]
fn unknown_names_get_a_suggestion() {
    let folder = Folder::new();
    for (arguments, expected) in [
        (
            "--scene glas",
            "there is no scene `glas`: did you mean `glass`? There are still-life, patterns, glass, waves",
        ),
        ("--scene Pattern", "there is no scene `Pattern`: did you mean `patterns`?"),
        ("--scene teapot", "there is no scene `teapot`: choose among still-life, patterns, glass, waves"),
        ("--effects diffuse,shadow", "there is no effect `shadow`: did you mean `shadows`?"),
    ] {
        let said = folder.run(arguments);
        assert!(said.error.contains(expected), "{said:?}");
        assert_eq!(said.code, Some(2));
    }
    let said = folder.run("glass");
    assert!(said.error.starts_with("error: cannot read glass: "), "{said:?}");
    assert!(said.error.ends_with("; there is a built-in scene, --scene glass\n"), "{said:?}");
}

#[test]
fn a_tier_that_a_number_type_lacks_is_refused_before_anything_is_read() {
    let reason = "there is no exact tier for f64: take f32 or i16f16, or the tier `stable`";
    let folder = Folder::new();
    folder.run("nothing.nff -n f64 -t exact").fails(reason);
    let said = folder.run("nothing.nff --compare f32 f64-exact");
    assert!(said.error.contains(reason), "{said:?}");
}

#[test]
fn help_names_every_option_and_place() {
    let said = Folder::new().run("--help").succeeds_silently();
    for word in ["--both-sides", "--output", "`-`", "standard input", "standard output", "--scale", "--report", "glass"]
    {
        assert!(said.output.contains(word), "{word}: {}", said.output);
    }
}
