//! The JSON: every figure has a name, in the published tables and in those of a file of rays.

use super::{at, command, json_of};
use crate::stored;
use crate::study::{Cost, as_json};
use serde_json::Value;

/// Fails at a figure in a list: the elements of a list are objects, whose fields have names.
fn assert_named(value: &Value, path: &str) {
    match value {
        Value::Array(elements) => {
            for (index, element) in elements.iter().enumerate() {
                assert!(element.is_object(), "{path}[{index}] has no name: {element}");
                assert_named(element, &format!("{path}[{index}]"));
            }
        }
        Value::Object(fields) => fields.iter().for_each(|(name, field)| assert_named(field, &format!("{path}.{name}"))),
        _ => {}
    }
}

#[test]
fn published_tables() {
    let study = stored::study().unwrap();
    let value: Value = serde_json::from_str(&as_json(&study)).unwrap();
    assert_named(&value, "");
    assert_eq!(value["rays"], 2000);
    assert_eq!(value["reference_nanoseconds"], study.times.reference_nanoseconds);
    let is_of = |row: &&Value| {
        [&row["number"], &row["tier"], &row["primitive"], &row["workload"], &row["placed"]]
            == ["f32", "Stable", "sphere", "benign", "-"]
    };
    let row = value["rows"].as_array().unwrap().iter().find(is_of).unwrap();
    let time = study.time(study.row("f32", "Stable", "sphere", "benign").unwrap()).unwrap();
    for (field, cost) in [("time_hit", time.hit), ("time_miss", time.miss)] {
        let Cost { ratio, nanoseconds } = cost.unwrap();
        assert_eq!((&row[field]["ratio"], &row[field]["nanoseconds"]), (&ratio.into(), &nanoseconds.into()));
    }
    let chip = &study.chips[0];
    assert!(row["instructions"][chip.name]["hit"].as_u64() > row["instructions"][chip.name]["miss"].as_u64());
}

#[test]
fn file_of_rays() {
    let options = at("cylinder capped radius 1 height 2", "at 0 -1 0");
    let value = json_of(&options, "ox,oy,oz,dx,dy,dz\n0,0.25,5,0,0,-3\n0,5,0,1,0,0\n1e6,0,0,-1,0,0");
    assert_named(&value, "");
    assert_eq!(value["file"], "my.csv");
    assert_eq!(value["solid"], "cylinder capped radius 1 height 2");
    assert_eq!(value["placement"], "at 0 -1 0");
    assert_eq!((&value["rays"], &value["machine"]), (&3.into(), &Value::Null));
    let rows = value["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 18);
    let row = rows.iter().find(|row| row["number"] == "I16F16" && row["tier"] == "Exact").unwrap();
    assert_eq!(
        (&row["rays"], &row["not_held"], &row["hits"], &row["lost"]),
        (&2.into(), &1.into(), &2.into(), &0.into())
    );
    let worst = &row["worst_ray"];
    assert_eq!((&worst["line"], &worst["error"]), (&2.into(), &0.0.into()));
    for hits in ["hits", "exact"] {
        let hit = &worst[hits][0];
        assert_eq!((&hit["t"], &hit["part"], &hit["crossing"]), (&4.0.into(), &"Side".into(), &"Enter".into()));
    }
    for name in
        ["median", "p999", "worst", "median_length", "p999_length", "worst_length", "phantom", "edge", "part", "broken"]
    {
        assert!(row[name].is_number(), "{name}");
    }
}

/// What is not there is null, not a figure.
#[test]
fn nothing_is_null() {
    let value = json_of(&at("sphere radius 1", ""), "0,5,0,1,0,0");
    assert_eq!(value["placement"], Value::Null);
    for row in value["rows"].as_array().unwrap() {
        assert_eq!((&row["hits"], &row["worst"], &row["worst_ray"]), (&0.into(), &Value::Null, &Value::Null));
    }
    let value = json_of(&at("sphere radius 1e5", ""), "0,5,0,1,0,0");
    assert_eq!(value["not_measured"][0]["number"], "I16F16");
}

/// Times have names too.
#[test]
fn times() {
    let value = json_of(&command(&["my.csv", "--solid", "sphere radius 1", "--number", "f32"]), "0,0,5,0,0,-1");
    assert_named(&value, "");
    assert!(value["machine"].is_string() && value["reference_nanoseconds"].is_number());
    for row in value["rows"].as_array().unwrap() {
        assert!(row["time_hit"]["ratio"].is_number() && row["time_hit"]["nanoseconds"].is_number(), "{row}");
        assert_eq!(row["time_miss"], Value::Null);
    }
}
