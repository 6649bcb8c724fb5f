//! A solid as it is written on the command line: a name of the tables, and its sizes by name.

use super::decimal::Decimal;
use super::words::{Words, list};
use raylet::Part;
use support::described::{ConeExtent, CylinderExtent, Described};

/// Every solid, as one writes it.
pub const EXAMPLES: [&str; 23] = [
    "sphere radius 1",
    "cylinder infinite radius 1",
    "cylinder open radius 1 height 2",
    "cylinder capped radius 1 height 2",
    "cone double slope 0.5",
    "cone nappe slope 0.5",
    "cone open slope 0.5 height 2",
    "cone capped slope 0.5 height 2",
    "frustum open base 1 top 0.5 height 2",
    "frustum capped base 1 top 0.5 height 2",
    "capsule radius 1 height 2",
    "revolved open a -0.5 b 1 radius 0 low 0 high 2",
    "revolved capped a -0.5 b 1 radius 0 low 0 high 2",
    "round cone base 1 top 0.5 height 2",
    "tube inner 0.75 radius 1 height 2",
    "torus major 1 minor 0.25",
    "plane",
    "disc radius 1",
    "annulus inner 0.25 radius 1",
    "cuboid x 1 y 0.5 z 2",
    "rounded cuboid x 1 y 0.5 z 2 radius 0.25",
    "rectangle x 1 z 2",
    "triangle -1 0 -1, 1 0 -1, 0 0 1",
];

/// The sizes of a solid as they are read.
struct Sizes<'a> {
    solid: &'static str,
    example: &'static str,
    read: Vec<(&'a str, Decimal<'a>)>,
}

impl<'a> Sizes<'a> {
    fn get(&self, name: &str) -> Result<Decimal<'a>, String> {
        let found = self.read.iter().find(|(read, _)| *read == name);
        found.map(|(_, size)| *size).ok_or_else(|| {
            let Self { solid, example, .. } = self;
            format!("the {solid} has no {name}: give all sizes, as in `{example}`")
        })
    }
}

/// The name in an example, and the names of the sizes.
fn names(example: &'static str) -> (&'static str, Vec<&'static str>) {
    let is_number = |word: &&str| word.starts_with(|c: char| c.is_ascii_digit() || c == '-');
    let words: Vec<&str> = example.split(' ').filter(|word| !is_number(word)).collect();
    let is_size = |word: &str| {
        let of_round = ["radius", "inner", "major", "minor", "height", "slope", "base", "top"];
        of_round.contains(&word) || ["x", "y", "z", "a", "b", "low", "high"].contains(&word)
    };
    let count = words.iter().take_while(|word| !is_size(word)).count();
    let length = words[..count].join(" ").len();
    (&example[..length], words[count..].to_vec())
}

/// The example of the solid that the words begin with.
fn example(words: &mut Words<'_>) -> Result<&'static str, String> {
    let Some(first) = words.next() else { return Err(format!("no solid is named: give one of{}", list(&EXAMPLES))) };
    let of_first: Vec<_> = EXAMPLES.into_iter().filter(|example| example.split(' ').next() == Some(first)).collect();
    match of_first[..] {
        [] => Err(format!("`{first}` is no solid that is measured: give one of{}", list(&EXAMPLES))),
        [only] if !names(only).0.contains(' ') => Ok(only),
        _ => {
            let second = words.next();
            let found = of_first.iter().copied().find(|example| names(example).0.split(' ').nth(1) == second);
            found.ok_or_else(|| format!("`{first}` alone does not say which: give one of{}", list(&of_first)))
        }
    }
}

/// The solid, or what is wrong with the text and what to do.
pub fn parse(text: &str) -> Result<Described<Decimal<'_>>, String> {
    let mut words = Words::new(text);
    let example = example(&mut words)?;
    let (solid, names) = names(example);
    if solid == "triangle" {
        let mut vertex = || words.numbers::<3>("each vertex of the triangle");
        let vertices = [vertex()?, vertex()?, vertex()?];
        return match words.next() {
            None => Ok(Described::Triangle { vertices }),
            Some(word) => Err(format!("`{word}` after the three vertices of the triangle: remove it")),
        };
    }
    let mut sizes = Sizes { solid, example, read: vec![] };
    while let Some(name) = words.next() {
        if !names.contains(&name) {
            return Err(match names[..] {
                [] => format!("the {solid} has no sizes: remove `{name}`"),
                _ => format!("the {solid} has no size `{name}`; its sizes are {}: write `{example}`", names.join(", ")),
            });
        }
        if sizes.get(name).is_ok() {
            return Err(format!("the {name} of the {solid} is given twice: remove one"));
        }
        let [size] = words.numbers(name)?;
        sizes.read.push((name, size));
    }
    let get = |name: &str| sizes.get(name);
    let frustum = |capped| {
        Ok::<_, String>(Described::Frustum { base: get("base")?, top: get("top")?, height: get("height")?, capped })
    };
    let revolved = |capped| {
        let heights = [get("low")?, get("high")?];
        Ok::<_, String>(Described::Revolved { a: get("a")?, b: get("b")?, radius: get("radius")?, heights, capped })
    };
    let cylinder = |extent| Ok::<_, String>(Described::Cylinder { radius: get("radius")?, extent });
    let cone = |extent| Ok::<_, String>(Described::Cone { slope: get("slope")?, extent });
    match solid {
        "sphere" => Ok(Described::Sphere { radius: get("radius")? }),
        "cylinder infinite" => cylinder(CylinderExtent::Infinite),
        "cylinder open" => cylinder(CylinderExtent::Open(get("height")?)),
        "cylinder capped" => cylinder(CylinderExtent::Capped(get("height")?)),
        "cone double" => cone(ConeExtent::Double),
        "cone nappe" => cone(ConeExtent::Nappe),
        "cone open" => cone(ConeExtent::Open(get("height")?)),
        "cone capped" => cone(ConeExtent::Capped(get("height")?)),
        "frustum open" => frustum(false),
        "frustum capped" => frustum(true),
        "capsule" => Ok(Described::Capsule { radius: get("radius")?, height: get("height")? }),
        "revolved open" => revolved(false),
        "revolved capped" => revolved(true),
        "round cone" => Ok(Described::RoundCone { base: get("base")?, top: get("top")?, height: get("height")? }),
        "tube" => Ok(Described::Tube { inner: get("inner")?, outer: get("radius")?, height: get("height")? }),
        "torus" => Ok(Described::Torus { major: get("major")?, minor: get("minor")? }),
        "annulus" => Ok(Described::Annulus { inner: get("inner")?, outer: get("radius")? }),
        "disc" => Ok(Described::Disc { radius: get("radius")? }),
        "cuboid" => Ok(Described::Cuboid { half: [get("x")?, get("y")?, get("z")?] }),
        "rounded cuboid" => {
            Ok(Described::RoundedCuboid { half: [get("x")?, get("y")?, get("z")?], radius: get("radius")? })
        }
        "rectangle" => Ok(Described::Rectangle { half: [get("x")?, get("z")?] }),
        _ => Ok(Described::Plane),
    }
}

/// The parts of its surface, from which a ray may depart.
pub fn parts<N>(solid: &Described<N>) -> &'static [Part] {
    use Part::{Back, Base, Front, Inner, Left, Right, Side, Top};
    match solid {
        Described::Cuboid { .. } => &[Left, Right, Base, Top, Back, Front],
        Described::RoundedCuboid { .. } => &[Side, Left, Right, Base, Top, Back, Front],
        Described::Tube { .. } => &[Side, Inner, Base, Top],
        Described::Cylinder { extent: CylinderExtent::Capped(_), .. }
        | Described::Frustum { capped: true, .. }
        | Described::Revolved { capped: true, .. }
        | Described::RoundCone { .. }
        | Described::Capsule { .. } => &[Side, Base, Top],
        Described::Cone { extent: ConeExtent::Capped(_), .. } => &[Side, Top],
        _ => &[Side],
    }
}
