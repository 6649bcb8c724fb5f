//! The promise: a picture that is black, empty or less true than it may seem says why.

use crate::support::{BALL, Folder, LIGHT, VIEW, ball};

/// The one warning about a scene.
#[track_caller]
fn warning(text: &str, options: &str) -> String {
    let said = Folder::with(text).run(&format!("scene.nff {options}")).succeeds();
    let [warning] = said.warnings()[..] else { panic!("one warning: {said:?}") };
    warning.to_owned()
}

#[test]
fn a_black_picture_says_why() {
    let black = "what the picture shows is black: ";
    for (text, options, why) in [
        (format!("{VIEW}{BALL}"), "", "the scene has no lights"),
        (format!("{VIEW}b 0 0 1 {BALL}"), "-s 3", "the scene has no lights"),
        (format!("{VIEW}l 3 4 5 0 0 0 {BALL}"), "", "all lights have the strength 0"),
        (format!("{VIEW}{LIGHT}f 1 1 1 0 0 1 0 1 s 0 0 0 1"), "", "no material sends light back"),
        (
            format!("{VIEW}{LIGHT}f 0 0 0 1 0 1 0 1 s 0 0 0 1"),
            "",
            "no light reaches what is seen, or its materials are black",
        ),
        (format!("{VIEW}l 0 0 -9 {BALL}"), "", "no light reaches what is seen"),
        (ball(), "--effects shadows", "--effects leaves off all that shows a surface"),
    ] {
        let warning = warning(&text, options);
        assert!(warning.starts_with(&format!("{black}{why}")), "{warning}");
    }
}

#[test]
fn an_empty_picture_says_why() {
    let empty = "the picture shows no object: ";
    for (text, options, why) in [
        (format!("{VIEW}{LIGHT}"), "", "the scene has none"),
        (format!("{VIEW}{LIGHT}s 0 0 0 1e-9"), "-n i16f16 --scale 1", "its only one was left out, too small"),
        (format!("{VIEW}{LIGHT}s 0 0 0 1e-9 s 1 0 0 1e-9"), "-n i16f16 --scale 1", "all 2 were left out, too small"),
        (format!("{VIEW}{LIGHT}s 0 0 9 1"), "", "none is in sight; check the view's from, at and angle"),
        // Clockwise, and from within.
        (
            format!("{VIEW}{LIGHT}p 3 -1 -1 0 0 1 0 1 -1 0"),
            "",
            "every surface in sight is seen from its back (4 % of the picture)",
        ),
        (format!("{VIEW}{LIGHT}s 0 0 0 9"), "", "every surface in sight is seen from its back (100 % of the picture)"),
    ] {
        let warning = warning(&text, options);
        assert!(warning.starts_with(&format!("{empty}{why}")), "{warning}");
    }
}

#[test]
fn objects_that_are_too_small_name_the_number_type_and_what_to_do() {
    let tiny = format!("{VIEW}{LIGHT}s 0 0 0 1e-9");
    let left_out = "the picture shows no object: its only one was left out, too small for";
    assert_eq!(
        warning(&tiny, "-n i16f16 --scale 1"),
        format!("{left_out} i16f16, or without area; make it larger, or try f64")
    );
    let tinier = format!("{VIEW}{LIGHT}s 0 0 0 1e-999");
    assert_eq!(warning(&tinier, "-n f64"), format!("{left_out} f64, or without area; make it larger"));
}

#[test]
fn both_sides_show_what_is_seen_from_the_back() {
    for text in ["p 3 -9 -9 0 0 9 0 9 -9 0", "s 0 0 0 9", "c 0 -9 0 7 0 9 0 7"] {
        for number in ["f32", "i16f16", "f64", "i32f32"] {
            let folder = Folder::with(format!("{VIEW}{LIGHT}{text}"));
            folder.run(&format!("scene.nff -n {number} --both-sides -o a.ppm")).succeeds_silently();
            assert!(folder.pixels("a.ppm")[27][0] > 50, "{text}");
        }
    }
    // The flag is nothing to what shows its front.
    let folder = Folder::with(ball());
    folder.run("scene.nff -o a.ppm").succeeds_silently();
    folder.run("scene.nff --both-sides -o b.ppm").succeeds_silently();
    assert_eq!(folder.pixels("a.ppm"), folder.pixels("b.ppm"));
}

/// A square of two patches before the eye, with corners in this order and normals towards it.
fn patches(order: [usize; 4], normal: &str) -> String {
    let corners = ["-2 -2 0", "2 -2 0", "2 2 0", "-2 2 0"];
    let corners = order.map(|corner| format!("{} {normal}", corners[corner])).join(" ");
    format!("{VIEW}{LIGHT}pp 4 {corners}\n")
}

#[test]
fn corner_normals_decide_where_the_winding_contradicts_them() {
    let (counterclockwise, clockwise) = ([0, 1, 2, 3], [3, 2, 1, 0]);
    let right = Folder::with(patches(counterclockwise, "0 0.1 1"));
    right.run("scene.nff -o a.ppm").succeeds_silently();
    for number in ["f32", "i16f16", "f64", "i32f32"] {
        let wrong = Folder::with(patches(clockwise, "0 0.1 1"));
        let said = wrong.run(&format!("scene.nff -n {number} -o a.ppm")).succeeds();
        assert_eq!(
            said.warnings(),
            [
                "1 polygon with normals runs the other way than its corner normals say; the normals decide which side is seen"
            ]
        );
        let pairs = right.pixels("a.ppm").into_iter().zip(wrong.pixels("a.ppm"));
        assert!(pairs.clone().all(|(a, b)| a[0].abs_diff(b[0]) <= 1), "{number}: {:?}", pairs.collect::<Vec<_>>());
    }
    // Its back is seen where both agree on it.
    let back = Folder::with(patches(clockwise, "0 0.1 -1"));
    let said = back.run("scene.nff").succeeds();
    assert!(said.warnings()[0].contains("every surface in sight is seen from its back"), "{said:?}");
}

#[test]
fn a_scale_below_one_says_what_it_costs() {
    let text = format!("{VIEW}{LIGHT}{BALL}s 0 0 -2000000 9");
    assert_eq!(
        warning(&text, "-n i16f16"),
        "one unit of the file is 1/256 in the scene, so that its coordinates fit into i16f16: lengths are rounded to multiples of \
         0.00390625 of the file's units, which shows in what is small, thin or mirrored; f64 rounds less"
    );
    for number in ["f32", "f64", "i32f32"] {
        Folder::with(&text).run(&format!("scene.nff -n {number}")).succeeds_silently();
    }
    Folder::with(text).run("scene.nff -n f32 --scale 1/4").succeeds_silently();
}

#[test]
fn a_light_too_far_for_the_type_counts_by_its_direction() {
    let scene =
        |light: &str| format!("{VIEW}{light}\n{BALL}s 0.4 0.4 1 0.3\n").replace("resolution 8 6", "resolution 80 50");
    for light in [
        "l 2000000 1000000 1500000",
        "l 2e12 1e12 1.5e12",
        "l 2e30 1e30 15e29",
        "l 2000000.00000000000000001 1e6 1.5e6",
    ] {
        let folder = Folder::with(scene(light));
        folder.run("scene.nff -n f64 -o f64.ppm").succeeds_silently();
        let said = folder.run("scene.nff -n i16f16 -o a.ppm").succeeds();
        assert_eq!(
            said.warnings(),
            ["1 light is too far away for i16f16 at --scale 1024: only the direction counts"],
            "{said:?}"
        );
        let pairs = folder.pixels("f64.ppm").into_iter().zip(folder.pixels("a.ppm"));
        let off = pairs.filter(|(a, b)| a[0].abs_diff(b[0]) > 1).count();
        assert!(off <= 4, "{light}: {off} of 4000 pixels are off by more than a level");
    }
    // One that the type still holds is where it is, and shadows end at it.
    let folder = Folder::with(scene("l 2000 1000 1500"));
    folder.run("scene.nff -n i16f16 -o a.ppm").succeeds_silently();
}

/// Its inside is as bright as without it, and the line is black.
#[test]
fn an_outline_is_a_black_line_around_the_ball() {
    let folder = Folder::with(ball().replace("8 6", "40 30"));
    for number in ["f32", "i16f16"] {
        let run = |options| folder.run(&format!("scene.nff --ambient 0.5 -n {number} {options}")).succeeds_silently();
        run("-o without.ppm");
        let said = run("--outline -o with.ppm");
        assert!(said.output.contains(" outline), ") && said.output.contains("shadows, outline\n"), "{said:?}");
        run("--outline=3 -o thick.ppm");
        let [without, with, thick] = ["without", "with", "thick"].map(|name| folder.pixels(&format!("{name}.ppm")));
        let changed = |pixels: &[[u8; 3]]| {
            let changed = pixels.iter().zip(&without).filter(|(after, before)| after != before);
            assert!(changed.clone().all(|(after, _)| *after == [0; 3]));
            changed.count()
        };
        let [line, thick] = [changed(&with), changed(&thick)];
        assert!((15..60).contains(&line) && thick > 2 * line, "{number}: {line} {thick}");
        run("--outline --effects ambient,diffuse,shadows -o off.ppm");
        assert!(folder.pixels("off.ppm") == without, "{number}: it is left off");
    }
}

#[test]
fn spans_take_fewer_rays_for_the_same_picture() {
    let folder = Folder::new();
    let rays = |options: &str| {
        let said = folder.run(&format!("--scene still-life --size 120x90 {options}")).succeeds_silently();
        let (_, rest) = said.output.split_once(": ").unwrap();
        let (rays, _) = rest.split_once(" rays (").unwrap();
        rays.parse::<u64>().unwrap()
    };
    for number in ["f32", "i16f16"] {
        let [all, few] = ["-o all.ppm", "--spans -o few.ppm"].map(|options| rays(&format!("-n {number} {options}")));
        assert!(few < all, "{number}: {few} {all}");
        let pairs = folder.pixels("all.ppm").into_iter().zip(folder.pixels("few.ppm"));
        let off = pairs.flat_map(|(a, b)| [0, 1, 2].map(|channel| a[channel].abs_diff(b[channel]))).max();
        assert!(off <= Some(2), "{number}: {off:?}");
    }
}
