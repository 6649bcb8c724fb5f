//! The promise: what the program says is about its options and the file, in the words of whoever runs it.

use crate::support::{BALL, Folder, LIGHT, VIEW, ball};

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

/// What is advised was tried on the file.
#[test]
fn advice_names_only_number_types_that_hold_the_scene() {
    let closer = "move everything closer to the origin";
    for (coordinate, options, advised) in [
        ("2e9", "-n i16f16", ", or -n i32f32, f32 or f64"),
        // `--scale auto` does not hold it, nor does i32f32 at this scale.
        ("2e9", "-n i16f16 --scale 2", ", or -n f32 or f64"),
        ("2e14", "-n i16f16", ", or -n f32 or f64"),
        ("2e14", "-n i32f32", ", or -n f64"),
        ("2e38", "-n i16f16", ", or -n f64"),
        ("2e38", "-n f32", ", or -n f64"),
        ("1e400", "-n i16f16", ""),
        ("1e400", "-n f32", ""),
        // f64 and i32f32 have no exact tier.
        ("2e14", "-n i16f16 -t exact", ", or -n f32"),
        ("2e38", "-n i16f16 -t exact", ", or -n f64 with -t stable"),
        // With --compare there is no --number.
        ("2e14", "--compare f64 i16f16", ", or compare f32 or f64 in place of i16f16"),
    ] {
        let said = said(&format!("s {coordinate} 0 0 1"), options);
        assert!(said.ends_with(&format!(": {closer}{advised}")), "{coordinate} {options}: {said}");
    }
    // What is wrong in every number type is found in the next.
    assert!(said("s 2e14 0 0 1 q", "-n i16f16").ends_with(", or -n f32 or f64"));
    assert!(said("s 2e14 0 0 1 q", "").contains("this starts no entity"));
    // What comes later counts too.
    assert!(said("s 2e9 0 0 1 s 2e38 0 0 1", "-n i16f16").ends_with(", or -n f64"));
    let folder = Folder::with(format!("{VIEW}{LIGHT}{BALL}s 2e14 0 0 1"));
    for advised in ["-n f32", "-n f64", "-n f32 -t exact", "--compare f64 f32"] {
        folder.run(&format!("scene.nff {advised}")).succeeds();
    }
}

#[test]
fn a_view_that_another_number_type_holds_says_so() {
    let target = "scene.nff, line 1, column 14: the view's from and at are the same point, or nearer to each other than f32 \
                  can tell: move one";
    for (at, advised) in [("4.9999999999", ", or -n f64"), ("5", "")] {
        let folder = Folder::with(VIEW.replace("at 0 0 0", &format!("at 0 0 {at}")));
        folder.run("scene.nff").fails(&format!("{target}{advised}"));
    }
    let folder = Folder::with(VIEW.replace("angle 45", "angle 180"));
    folder.run("scene.nff").fails(
        "scene.nff, line 1, column 32: the view's angle must be more than 0 and less than 180 degrees, and not too near to \
         either for f32: give one such as 45",
    );
}

#[test]
fn a_value_outside_its_limits_says_which_they_are() {
    for (resolution, column) in [("0 6", 52), ("8.5 6", 52), ("8 65536", 54)] {
        let folder = Folder::with(VIEW.replace("8 6", resolution));
        folder.run("scene.nff").fails(&format!(
            "scene.nff, line 1, column {column}: the view's resolution should be a whole number from 1 to 65535"
        ));
    }
    assert_eq!(
        said("f 255 0 0 1 0 1 0 1", ""),
        "3: the material's colour is outside 0 to 1: give red, green and blue from 0 to 1, not to 255"
    );
    assert_eq!(said("p 2 0 0 0 1 1 1", ""), "3: a polygon has at least three corners: give more, or remove it");
    assert_eq!(said("p -3 0 0 0", ""), "3: the number of corners should be a whole number from 1 to 4294967295");
}

#[test]
fn an_option_out_of_its_limits_says_which_they_are() {
    let folder = Folder::new();
    for (options, reason) in [
        ("-s 0", "give a whole number from 1 to 16"),
        ("-s 17", "give a whole number from 1 to 16"),
        ("-s two", "give a whole number from 1 to 16"),
        ("--outline=0", "give a whole number from 1 to 16"),
        ("--outline=thick", "give a whole number from 1 to 16"),
        ("--threads -1", "give a whole number from 1 to 256"),
        ("--size 0x9", "give width and height in pixels, each 1 to 65535, such as 320x240"),
        ("--size -3x4", "give width and height in pixels, each 1 to 65535, such as 320x240"),
        ("--size 99999x4", "give width and height in pixels, each 1 to 65535, such as 320x240"),
        ("--ambient -0.5", "give a number from 0 to 1, such as 0.1"),
        ("--ambient nan", "give a number from 0 to 1, such as 0.1"),
        ("--scale -2", "give `auto` or a power of two such as 512 or 1/4, 1/65536 to 4294967296"),
    ] {
        let said = folder.run(options);
        assert!(said.error.contains(&format!(": {reason}\n")), "{options}: {said:?}");
        assert_eq!(said.code, Some(2));
    }
}

#[test]
fn names_of_number_types_and_tiers_take_either_case() {
    let folder = Folder::with(ball());
    folder.run("scene.nff -n I16F16 -t Exact").succeeds_silently();
}

/// A number type that the program is not compiled for is told with those that it has.
#[test]
fn an_unknown_number_type_is_told_with_those_that_there_are() {
    let folder = Folder::with(ball());
    let said = folder.run("scene.nff -n I20F12");
    assert!(said.error.contains("possible values: f32, f64, i16f16, i32f32"), "{said:?}");
    let said = folder.run("scene.nff --compare I20F12 f64");
    assert!(said.error.contains("there is no number type `I20F12`: choose among f32, f64, i16f16, i32f32"), "{said:?}");
    folder.run("scene.nff --compare I16F16 F64-Plain -o a.ppm").succeeds_silently();
}

#[test]
fn an_unknown_option_gets_a_suggestion() {
    let folder = Folder::new();
    for (option, meant) in [("--compar", "--compare"), ("--both", "--both-sides"), ("--sample", "--samples")] {
        let said = folder.run(option);
        assert!(
            said.error.contains(&format!("'{option}' found")) && said.error.contains(&format!("'{meant}'")),
            "{said:?}"
        );
        assert!(!said.error.contains("as a value"), "{said:?}");
        assert_eq!(said.code, Some(2));
    }
    assert!(folder.run("--qqqq").error.contains("unexpected argument '--qqqq' found"));
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
    for word in [
        "--both-sides",
        "--output",
        "`-`",
        "standard input",
        "standard output",
        "--scale",
        "--report",
        "--spans",
        "glass",
        "exit status",
    ] {
        assert!(said.output.contains(word), "{word}: {}", said.output);
    }
}
