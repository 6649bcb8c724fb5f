//! What effects cost on a chip: instructions and stack of a pixel, with each set of effects compiled in, and with all
//! of them; and some sets in the other tiers.
//!
//! | module | what it holds |
//! |---|---|
//! | `stage` | a scene that calls for a set of effects, and for nothing else |
//! | `measure` | instructions, stack and colours of a picture |

mod measure;
mod stage;

use core::fmt::{self, Display};
use fixed::types::I16F16;
pub use measure::{Measured, picture};
use raylet::effect::{
    All, Ambient, Antialiasing, Bump, Diffuse, EffectSet, Effects, Fog, Outline, Reflection, Refraction, Shadows,
    Specular, Texture,
};
use raylet::tier::{Fast, Plain, Tier};
use raylet::{Picture, Scalar, Size};
use stage::Stage;

/// Columns and rows of the pictures that are measured.
const SIZE: Size = Size::new(16, 12);

/// What was measured of one set of effects.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The set: what its scene calls for.
    pub set: EffectSet,
    /// The tier.
    pub tier: &'static str,
    /// The number type.
    pub number: &'static str,
    /// With just this set compiled in.
    pub alone: Measured,
    /// The same scene with every effect compiled in; measured only in `Stable`.
    pub among_all: Option<Measured>,
}

impl Display for Row {
    /// A line of JSON.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { set, tier, number, alone, among_all } = self;
        write!(f, r#"{{"set":"{set}","tier":"{tier}","number":"{number}","alone":{alone},"among_all":"#)?;
        match among_all {
            Some(measured) => write!(f, "{measured}}}"),
            None => f.write_str("null}"),
        }
    }
}

/// Measures every set in two number types, and gives each row to `give`.
pub fn all(give: &mut impl FnMut(Row)) {
    every_set::<I16F16>("I16F16", give);
    every_set::<f32>("f32", give);
}

fn every_set<S: Scalar>(number: &'static str, give: &mut impl FnMut(Row)) {
    // The programs of `sizes` have the same sets.
    give(row::<S, ()>(number));
    give(row::<S, (Ambient,)>(number));
    give(row::<S, (Diffuse,)>(number));
    give(row::<S, (Diffuse, Specular)>(number));
    give(row::<S, (Diffuse, Specular, Shadows)>(number));
    give(row::<S, (Diffuse, Specular, Shadows, Reflection)>(number));
    give(row::<S, (Diffuse, Specular, Shadows, Reflection, Refraction)>(number));
    give(row::<S, (Diffuse, Specular, Shadows, Texture)>(number));
    give(row::<S, (Diffuse, Specular, Shadows, Bump)>(number));
    give(row::<S, (Diffuse, Specular, Shadows, Fog)>(number));
    give(row::<S, (Diffuse, Specular, Shadows, Antialiasing)>(number));
    give(row::<S, (Diffuse, Specular, Shadows, Outline)>(number));
    give(row::<S, All>(number));
    in_tier::<S, Plain>("Plain", number, give);
    in_tier::<S, Fast>("Fast", number, give);
}

/// What a nearest hit, a light and two shadows take.
fn in_tier<S: Scalar, T: Tier<S>>(tier: &'static str, number: &'static str, give: &mut impl FnMut(Row)) {
    give(row_in_tier::<S, (), T>(tier, number));
    give(row_in_tier::<S, (Diffuse,), T>(tier, number));
    give(row_in_tier::<S, (Diffuse, Specular, Shadows), T>(tier, number));
}

#[inline(never)]
fn row_in_tier<S: Scalar, E: Effects, T: Tier<S>>(tier: &'static str, number: &'static str) -> Row {
    let stage = Stage::<S>::calling_for(E::SET).expect("the stage's numbers fit every type");
    let scene = stage.scene().expect("the stage's lists fit together").at_tier::<T>();
    let alone = picture(&Picture::<S, E, T>::leaving_out(&scene, SIZE));
    Row { set: E::SET, tier, number, alone, among_all: None }
}

/// Its own frame, so that nothing of another set is counted.
#[inline(never)]
fn row<S: Scalar, E: Effects>(number: &'static str) -> Row {
    let stage = Stage::<S>::calling_for(E::SET).expect("the stage's numbers fit every type");
    let scene = stage.scene().expect("the stage's lists fit together");
    let size = SIZE.with_samples(stage.samples());
    // Of a light without shadows the set knows, but the scene does not: what is not in the set is left off.
    Row {
        set: E::SET,
        tier: "Stable",
        number,
        alone: picture(&Picture::<S, E>::leaving_out(&scene, size)),
        among_all: Some(picture(&Picture::<S, All>::new(&scene, size).only(E::SET))),
    }
}
