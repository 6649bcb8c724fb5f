//! The promise: a picture goes where the options say, before anything is said of it, or the program fails before it is
//! traced.

use crate::support::{Folder, ball, pixels};
use std::fs;
use std::process::Stdio;
use std::thread;
use std::time::Duration;

const PICTURES: [&str; 2] = ["out/scene.png", "out/scene.ppm"];

/// The files that a run adds to a folder with a scene.
fn written(arguments: &str) -> Vec<String> {
    let folder = Folder::with(ball());
    folder.run(&format!("scene.nff {arguments}")).succeeds_silently();
    folder.files().into_iter().filter(|name| name != "scene.nff" && !name.ends_with('/')).collect()
}

#[test]
fn a_picture_goes_to_the_folder_out_by_default() {
    assert_eq!(written(""), PICTURES);
}

#[test]
fn a_suffix_says_the_format_and_no_suffix_means_both() {
    assert_eq!(written("-o a.png"), ["a.png"]);
    assert_eq!(written("-o a.ppm"), ["a.ppm"]);
    assert_eq!(written("-o A.PNG"), ["A.PNG"]);
    assert_eq!(written("-o a"), ["a.png", "a.ppm"]);
    assert_eq!(written("-o .hidden"), [".hidden.png", ".hidden.ppm"]);
    assert_eq!(written("-o b/c/a.b.png"), ["b/c/a.b.png"]);
}

#[test]
fn a_name_that_is_only_a_suffix_is_a_name() {
    assert_eq!(written("-o .png"), [".png"]);
    assert_eq!(written("-o .ppm"), [".ppm"]);
    assert_eq!(written("-o new/.ppm"), ["new/.ppm"]);
    assert_eq!(written("-o .ppm --compare f32 f64"), ["difference.ppm", "f32.ppm", "f64-reference.ppm"]);
}

#[test]
fn a_folder_holds_the_picture_under_the_name_of_the_scene() {
    assert_eq!(written("-o ."), ["scene.png", "scene.ppm"]);
    assert_eq!(written("-o new/"), ["new/scene.png", "new/scene.ppm"]);
    assert_eq!(written("-o new.png/"), ["new.png/scene.png", "new.png/scene.ppm"]);
    let folder = Folder::with(ball());
    fs::create_dir(folder.path("old.png")).unwrap();
    folder.run("scene.nff -o old.png").succeeds_silently();
    assert_eq!(folder.files(), ["old.png/", "old.png/scene.png", "old.png/scene.ppm", "scene.nff"]);
    folder.run("--scene glass --size 4x3 -o old.png").succeeds_silently();
    assert!(folder.path("old.png/glass.ppm").exists());
}

#[test]
fn a_comparison_writes_three_pictures() {
    let names = ["a-difference.png", "a-f32.png", "a-i16f16-reference.png"];
    assert_eq!(written("-o a.png --compare f32 i16f16"), names);
}

#[test]
fn an_unknown_suffix_is_refused() {
    let folder = Folder::with(ball());
    for name in ["a.jpg", "a.", "scene.nff"] {
        let reason = format!(
            "cannot write {name}: pictures are PNG or PPM; end the name in .png or .ppm, or leave the suffix away for both"
        );
        folder.run(&format!("scene.nff -o {name}")).fails(&reason);
    }
    assert_eq!(folder.read("scene.nff"), ball().as_bytes());
    assert_eq!(folder.files(), ["scene.nff"]);
}

/// A picture that took long would be lost.
#[test]
fn an_output_that_cannot_be_written_is_found_before_tracing() {
    let folder = Folder::with(ball());
    // Minutes of tracing.
    let huge = "scene.nff --size 60000x6000 -s 16 --uncut --threads 1";
    let said = folder.run(&format!("{huge} -o scene.nff/a.png"));
    assert!(said.error.starts_with("error: cannot write scene.nff/a.png: "), "{said:?}");
    assert!(said.error.ends_with("; a file stands where a folder should: give --output another place\n"), "{said:?}");
    let said = folder.run(&format!("{huge} -o scene.nff/b/c/"));
    assert!(said.error.starts_with("error: cannot make the folder scene.nff/b/c/: "), "{said:?}");
    fs::create_dir(folder.path("a.ppm")).unwrap();
    let said = folder.run(&format!("{huge} -o a"));
    assert!(said.error.starts_with("error: cannot write a.ppm: "), "{said:?}");
    assert!(said.error.ends_with("; a folder has this name: give --output another name\n"), "{said:?}");
    assert_eq!((said.code, said.output.as_str()), (Some(1), ""));
    assert_eq!(folder.files(), ["a.ppm/", "scene.nff"], "nothing is left behind");
}

#[test]
fn without_a_picture_no_file_is_touched() {
    let folder = Folder::with("s 0 0 zero 1");
    fs::write(folder.path("old.png"), "an old picture").unwrap();
    assert_eq!(folder.run("scene.nff -o old.png").code, Some(1));
    assert_eq!(folder.run("scene.nff -o new/er/a.png").code, Some(1));
    assert_eq!(folder.run("scene.nff").code, Some(1));
    assert_eq!(folder.read("old.png"), b"an old picture");
    assert_eq!(folder.files(), ["old.png", "scene.nff"]);
}

#[test]
fn an_interrupted_picture_leaves_no_file_and_no_change() {
    let folder = Folder::with(ball());
    fs::write(folder.path("old.ppm"), "an old picture").unwrap();
    for name in ["new.ppm", "old.ppm"] {
        let mut child = folder.command(&format!("scene.nff --size 4000x4000 -s 16 -o {name}")).spawn().unwrap();
        thread::sleep(Duration::from_millis(300));
        assert!(child.try_wait().unwrap().is_none(), "the picture is too small for this test");
        child.kill().unwrap();
        child.wait().unwrap();
    }
    assert_eq!(
        (folder.read("old.ppm"), folder.files()),
        (b"an old picture".into(), vec!["old.ppm".into(), "scene.nff".into()])
    );
}

#[test]
fn a_longer_file_is_replaced_whole() {
    let folder = Folder::with(ball());
    fs::write(folder.path("a.ppm"), [b'x'; 9999]).unwrap();
    folder.run("scene.nff -o a.ppm").succeeds_silently();
    assert_eq!(folder.pixels("a.ppm").len(), 48);
}

#[test]
fn a_hyphen_writes_to_standard_output_and_reports_on_standard_error() {
    let folder = Folder::with(ball());
    folder.run("scene.nff -o a.ppm").succeeds_silently();
    for output in ["-", "/dev/stdout", "/dev/fd/1"] {
        let run = folder.command(&format!("scene.nff -o {output}")).output().unwrap();
        assert_eq!(pixels(&run.stdout), folder.pixels("a.ppm"));
        let report = String::from_utf8(run.stderr).unwrap();
        assert!(report.starts_with("8x6 pixels in f32") && report.ends_with("written: standard output\n"), "{report}");
    }
    assert_eq!(folder.files(), ["a.ppm", "scene.nff"]);
    folder
        .run("scene.nff -o - --compare f32 f64")
        .fails("standard output holds one picture, and --compare writes three: give --output a name");
}

#[test]
fn a_device_takes_a_picture_and_stays_what_it_is() {
    let folder = Folder::with(ball());
    folder.run("scene.nff -o /dev/null").succeeds_silently();
    assert_eq!(folder.files(), ["scene.nff"]);
    assert!(!fs::exists("/dev/null.ppm").unwrap());
}

#[test]
fn a_closed_standard_output_is_no_panic_and_no_lost_picture() {
    let folder = Folder::with(ball());
    let mut child = folder.command("scene.nff --report").spawn().unwrap();
    drop(child.stdout.take());
    assert!(child.wait().unwrap().success());
    assert_eq!(folder.files(), ["out/", PICTURES[0], PICTURES[1], "scene.nff"]);
    let mut child = folder.command("scene.nff --compare f32 f64 -o b").spawn().unwrap();
    drop(child.stdout.take());
    assert!(child.wait().unwrap().success());
    assert!(folder.path("b-difference.png").exists());
    folder.shell("\"$render\" scene.nff -o c.ppm >&- 2>&-");
    assert_eq!(folder.pixels("c.ppm").len(), 48);
    // Warnings have no reader either.
    let mut child = folder.command("scene.nff -o d.ppm --effects none").stderr(Stdio::piped()).spawn().unwrap();
    drop((child.stdout.take(), child.stderr.take()));
    assert!(child.wait().unwrap().success());
    assert_eq!(folder.pixels("d.ppm").len(), 48);
}

/// The runtime opens `/dev/null` in its place, so that writing to it succeeds.
#[test]
#[cfg(target_os = "linux")]
fn a_picture_to_a_standard_output_that_is_closed_is_an_error_before_tracing() {
    let folder = Folder::with(ball());
    // Minutes of tracing.
    let huge = "\"$render\" scene.nff --size 60000x6000 -s 16 --uncut --threads 1";
    let instead = "redirect standard output to a file or a program, or give --output a name; with -o /dev/null no picture is kept";
    let closed = format!(
        "standard output is closed (or /dev/null, open for reading too), and the picture would be lost: {instead}"
    );
    for line in ["-o - >&-", "-o /dev/stdout >&-", "-o - 1<>/dev/null"] {
        folder.shell(&format!("{huge} {line}")).fails(&closed);
    }
    folder
        .shell(&format!("{huge} -o - 1<scene.nff"))
        .fails("standard output is open for reading only: redirect it to a file or a program, or give --output a name");
    assert_eq!(folder.shell(&format!("{huge} -o - >&- 2>&-")).code, Some(1));
    assert_eq!(folder.read("scene.nff"), ball().as_bytes());
    // What is open for writing takes it, and what is thrown away on purpose is.
    for line in ["-o - >a.ppm", "-o - >>b.ppm", "-o - 1<>c.ppm", "-o - >/dev/null", "-o /dev/null >&-"] {
        folder.shell(&format!("\"$render\" scene.nff {line}")).succeeds();
    }
    for name in ["a.ppm", "b.ppm", "c.ppm"] {
        assert_eq!(folder.pixels(name).len(), 48);
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_standard_output_is_no_panic_and_no_lost_picture() {
    let folder = Folder::with(ball());
    let full = "No space left on device (os error 28)";
    let said = folder.shell("\"$render\" scene.nff -o a.ppm >/dev/full");
    said.fails(&format!(
        "cannot write the report to standard output: {full}; the picture is written: send standard output somewhere else to \
         read of it"
    ));
    assert_eq!(folder.pixels("a.ppm").len(), 48);
    let said = folder.shell("\"$render\" scene.nff -o b.ppm --effects none >/dev/full 2>&1");
    assert_eq!(said.code, Some(1));
    assert_eq!(folder.pixels("b.ppm").len(), 48);
    let room = format!("{full}; there is no room left: make some, or give --output another place");
    folder.run("scene.nff -o /dev/full").fails(&format!("cannot write /dev/full: {room}"));
    let said = folder.shell("\"$render\" scene.nff -o - >/dev/full");
    said.fails(&format!("cannot write the picture to standard output: {room}"));
    // A PNG comes to its file by way of a library.
    std::os::unix::fs::symlink("/dev/full", folder.path("a.png")).unwrap();
    folder.run("scene.nff -o a").fails(&format!("cannot write a.png: {room}"));
    assert_eq!(folder.shell("\"$render\" --help >/dev/full").code, Some(0));
}

#[test]
#[cfg(target_os = "linux")]
fn pictures_too_large_for_memory_are_refused_before_tracing() {
    let folder = Folder::with(ball());
    // A hundred gigabytes and more.
    let said = folder.run("scene.nff --size 65535x65535 --compare f32 f64");
    assert!(
        said.error.contains("65535x65535 pixels need 159") && said.error.contains("give a smaller --size"),
        "{said:?}"
    );
    assert_eq!(said.code, Some(1));
    // Where the system hands out no more than so much.
    let said = folder.shell("ulimit -v 900000; \"$render\" scene.nff --size 20000x20000 --threads 1");
    assert!(said.error.contains("20000x20000 pixels need") && said.error.contains("give a smaller --size"), "{said:?}");
    assert_eq!(folder.files(), ["scene.nff"]);
}

/// The seconds that a scene of many objects takes in all, and to load.
fn times(folder: &Folder, number: &str) -> [f64; 2] {
    let said = folder.run(&format!("scene.nff --size 1x1 --threads 1 -n {number}")).succeeds_silently();
    let time = said.output.lines().find_map(|line| line.strip_prefix("time: ")).unwrap();
    let (all, rest) = time.split_once(" s, ").unwrap();
    let (loading, _) = rest.split_once(" s of them loading; ").unwrap();
    [all, loading].map(|seconds| seconds.parse().unwrap())
}

#[test]
fn loading_is_part_of_the_time() {
    let folder = Folder::with(ball() + &"s 9 9 9 1\n".repeat(100_000));
    let [all, loading] = times(&folder, "f32");
    assert!(loading > 0.0 && loading <= all && loading > 0.5 * all, "{loading} of {all}");
}

/// The fastest of three, which the machine disturbed least.
#[test]
fn fixed_point_loads_in_at_most_three_times_the_time_of_floats() {
    let many: Vec<_> = (0..40_000).map(|i| format!("s {}.{i:05} 0.25 -{}.5 0.1", i % 9, i % 7)).collect();
    let folder = Folder::with(ball() + &many.join("\n"));
    let fastest = |number| (0..3).map(|_| times(&folder, number)[1]).fold(f64::INFINITY, f64::min);
    for (float, fixed) in [("f32", "i16f16"), ("f64", "i32f32")] {
        let [float, fixed] = [float, fixed].map(fastest);
        println!("{fixed} s in fixed point, {float} s in floats");
        assert!(fixed <= 3.0 * float, "{fixed} s in fixed point, {float} s in floats");
    }
}
