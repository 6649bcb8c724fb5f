//! docs/your-rays.md: its commands are run, and it lists what the tool takes.

use super::super::{csv, placement, solid};
use super::command;
use crate::publish;
use support::in_repository;

fn guide() -> String {
    std::fs::read_to_string(in_repository("docs/your-rays.md")).unwrap()
}

/// The words of a command as a shell takes them: what stands in quotes is one.
fn words(line: &str) -> Vec<&str> {
    let mut words = vec![];
    for (index, part) in line.split('\'').enumerate() {
        if index % 2 == 1 {
            words.push(part);
        } else {
            words.extend(part.split_whitespace().filter(|word| *word != "\\"));
        }
    }
    words
}

/// The text of each block of code, with its language.
fn blocks(page: &str) -> Vec<(&str, &str)> {
    let mut blocks = vec![];
    let mut rest = page;
    while let Some(start) = rest.find("```") {
        let (language, body) = rest[start + 3..].split_once('\n').unwrap();
        let (block, after) = body.split_once("```").unwrap();
        blocks.push((language, block));
        rest = after;
    }
    blocks
}

/// The first command prints what the page shows, and everything that it writes can be written.
#[test]
fn the_example_prints_what_the_guide_shows() {
    let page = guide();
    let mut blocks = blocks(&page).into_iter();
    let (_, line) = blocks.find(|(language, _)| *language == "sh").unwrap();
    let (_, shown) = blocks.find(|(language, _)| *language == "text").unwrap();
    let words = words(line);
    assert_eq!(words[..7], ["cargo", "run", "--release", "-p", "raylet-accuracy", "--", "rays"]);
    let options = command(&words[7..]);
    let text = csv::read(in_repository(&options.file).to_str().unwrap()).unwrap();
    let task = options.task(&text).unwrap();
    let outcome = task.measure(&mut || ()).unwrap();
    let printed = publish::rays_summary(&task, options.texts(), &outcome);
    assert_eq!(shown.trim(), printed.trim(), "docs/your-rays.md should show this:\n{printed}");
    let files = publish::rays_documents(&task, options.texts(), &outcome).unwrap();
    let names: Vec<_> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["rays.md", "rays.svg", "rays.json"]);
    for (name, _) in &files {
        assert!(page.contains(&format!("`{name}`")), "{name} is not in the guide");
    }
}

#[test]
fn every_command_of_the_guide_is_taken() {
    let page = guide();
    let all = blocks(&page).into_iter().filter(|(language, _)| *language == "sh").flat_map(|(_, block)| {
        block.split("cargo run").skip(1).map(|line| line.split('#').next().unwrap_or(line)).collect::<Vec<_>>()
    });
    let mut count = 0;
    for line in all {
        let words = words(line);
        let start = words.iter().position(|word| *word == "rays").unwrap();
        if words.contains(&"--help") {
            continue;
        }
        let options = command(&words[start + 1..]);
        options.task("0,0,5,0,0,-1").unwrap_or_else(|error| panic!("{line}: {error}"));
        count += 1;
    }
    assert!(count >= 3, "{count} commands");
}

#[test]
fn the_guide_lists_every_solid_and_placement_and_column() {
    let page = guide();
    for form in solid::EXAMPLES.into_iter().chain(placement::EXAMPLES).chain(csv::COLUMNS) {
        assert!(page.contains(&format!("`{form}`")), "`{form}` is not in the guide");
    }
}

/// The fields of the JSON are those that the guide lists; a file of rays has no instructions of chips.
#[test]
fn the_guide_lists_every_field() {
    fn check(value: &serde_json::Value, page: &str) {
        if let Some(fields) = value.as_object() {
            for (name, field) in fields {
                assert!(page.contains(&format!("`{name}`")), "`{name}` is not in the guide");
                check(field, page);
            }
        }
        value.as_array().into_iter().flatten().for_each(|element| check(element, page));
    }
    let options = command(&["my.csv", "--solid", "sphere radius 1", "--number", "f32"]);
    let value = super::json_of(&options, "0,0,5,0,0,-1\n0,5,0,1,0,0");
    check(&value["rows"], &guide());
}

/// The page is found from where one looks for it.
#[test]
fn the_guide_is_linked() {
    for page in ["docs/README.md", "docs/accuracy.md"] {
        assert!(std::fs::read_to_string(in_repository(page)).unwrap().contains("(your-rays.md)"), "{page}");
    }
}
