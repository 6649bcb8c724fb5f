//! What the page must say: reads worlds as lines of JSON, and writes for each what the library says on the host, and
//! what the exact oracle of the tests says.

use fixed::types::I16F16;
use raylet::{Shape, Size};
use raylet_page::number::Number;
use raylet_page::solid::placed;
use raylet_page::world::World;
use serde_json::{Value, json};
use std::error::Error;
use std::io::{self, BufRead, Write};
use support::described::{ConeExtent, CylinderExtent, Described};
use support::exact_types::{Exact, expected_of};
use support::oracle::ExpectedCrossing;
use support::placed::{Placed, Placement};

fn vector(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|i| value[i].as_f64().expect("a number"))
}

/// The solid of this number as the oracle has it.
fn described(solid: u64, [a, b, c]: [f64; 3]) -> Described<f64> {
    match solid {
        0 => Described::Sphere { radius: a },
        1 => Described::Cylinder { radius: a, extent: CylinderExtent::Capped(b) },
        2 => Described::Cylinder { radius: a, extent: CylinderExtent::Open(b) },
        3 => Described::Cone { slope: a, extent: ConeExtent::Capped(b) },
        4 => Described::Cone { slope: a, extent: ConeExtent::Double },
        5 => Described::Frustum { base: a, top: b, height: c, capped: true },
        6 => Described::Capsule { radius: a, height: b },
        _ => Described::Cuboid { half: [a, b, c] },
    }
}

/// The exact crossings of each ray with the first solid.
fn exactly<S: Number + Exact>(request: &Value, world: &World<S>) -> Result<Value, Box<dyn Error>> {
    let first = &request["solids"][0];
    let (solid, sizes) = (first["solid"].as_u64().ok_or("a number")?, vector(&first["sizes"]));
    let sized = described(solid, sizes).try_map(|size| S::from_f64(*size))?;
    let (_, frame) = placed::<S>(solid as u32, sizes, vector(&first["base"]), vector(&first["axis"]))?;
    let shape: Shape<S> = sized.shape()?;
    let placed = Placed::by(&shape, &sized.solid(), Placement::Frame(frame))?;
    let mut answers = Vec::new();
    for ray in world.rays() {
        let expected = expected_of(&sized.solid(), &placed.line(ray), ray);
        let crossing = |crossing| match crossing {
            ExpectedCrossing::Enter => 0,
            ExpectedCrossing::Exit => 1,
            ExpectedCrossing::Touch => 2,
        };
        answers.push(expected.hits.iter().map(|hit| json!([hit.t.to_f64(), crossing(hit.crossing)])).collect());
    }
    Ok(Value::Array(answers))
}

fn answer<S: Number + Exact>(request: &Value, tiers: u32) -> Result<Value, Box<dyn Error>> {
    let mut world = World::<S>::default();
    for solid in request["solids"].as_array().ok_or("a list")? {
        let index = solid["solid"].as_u64().ok_or("a number")?;
        world.place(index as u32, ["sizes", "base", "axis"].map(|key| vector(&solid[key])))?;
    }
    for ray in request["rays"].as_array().ok_or("a list")? {
        world.aim([vector(&ray[0]), vector(&ray[1])])?;
    }
    let rays = request["rays"].as_array().map_or(0, Vec::len);
    let hits: Vec<Vec<_>> = (0..tiers).map(|tier| (0..rays).map(|ray| world.hits(tier, 0, ray)).collect()).collect();
    let mut rows = Vec::new();
    if let Some(view) = request["view"].as_object() {
        let number = |key: &str| view.get(key).and_then(Value::as_f64).unwrap_or(0.0);
        let size = Size::new(number("columns") as u16, number("rows") as u16);
        let places = [vector(&view["position"]), vector(&view["target"])];
        world.look(places, number("angle"), number("height"), size)?;
        rows = (0..tiers).map(|tier| (0..size.height).step_by(9).map(|y| world.row(tier, y)).collect()).collect();
    }
    let rows: Vec<Vec<_>> = rows;
    Ok(json!({ "hits": hits, "rows": rows, "exact": exactly(request, &world)? }))
}

fn main() -> Result<(), Box<dyn Error>> {
    for line in io::stdin().lock().lines() {
        let request: Value = serde_json::from_str(&line?)?;
        let answer = match request["number"].as_u64() {
            Some(0) => answer::<f32>(&request, 4),
            Some(1) => answer::<I16F16>(&request, 4),
            _ => answer::<f64>(&request, 3),
        };
        writeln!(io::stdout(), "{}", answer.unwrap_or_else(|error| json!({ "refused": error.to_string() })))?;
    }
    Ok(())
}
