//! What effects cost on a chip: instructions and stack of a pixel, with each set of effects compiled in, and with all
//! of them; some sets in the other tiers, and on a display.
//!
//! | module | what it holds |
//! |---|---|
//! | `stage` | a scene that calls for a set of effects, and for nothing else |
//! | `measure` | instructions, stack and colours of a picture |

mod measure;
mod stage;

use crate::shown::with_built_in;
use core::fmt::{self, Display};
use fixed::types::I16F16;
pub use measure::{Measured, every, every_in_spans, picture};
use raylet::effect::{
    All, Ambient, Antialiasing, Bump, Diffuse, EffectSet, Effects, Fog, Outline, Reflection, Refraction, Shadows,
    Specular, Texture,
};
use raylet::gallery::BuiltIn;
use raylet::scene::SceneError;
use raylet::tier::{Fast, Plain, Stable, Tier};
use raylet::{Picture, Scalar, Scene, Size};
use stage::Stage;

/// Columns and rows of the pictures that are measured.
const SIZE: Size = Size::new(16, 12);

/// Those of a display, of which one row in [`ROWS`] is measured.
const DISPLAY: Size = Size::new(240, 240);
const ROWS: u16 = 24;

/// What was measured of one set of effects.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The set: what its scene calls for.
    pub set: EffectSet,
    /// The tier.
    pub tier: &'static str,
    /// The number type.
    pub number: &'static str,
    /// A scene of the gallery, or how that of this module is made if not pixel by pixel; else empty.
    pub scene: &'static str,
    /// With just this set compiled in.
    pub alone: Measured,
    /// The same scene with every effect compiled in; measured only in `Stable`.
    pub among_all: Option<Measured>,
}

impl Display for Row {
    /// A line of JSON.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { set, tier, number, scene, alone, among_all } = self;
        write!(f, r#"{{"set":"{set}","tier":"{tier}","number":"{number}","scene":"{scene}","alone":{alone},"#)?;
        f.write_str(r#""among_all":"#)?;
        match among_all {
            Some(measured) => write!(f, "{measured}}}"),
            None => f.write_str("null}"),
        }
    }
}

/// Measures a nearest hit, light and shadows on a display in a number type.
pub fn on_displays<S: Scalar>(number: &'static str, give: &mut impl FnMut(Row)) {
    on_display::<S, Plain>("Plain", number, give);
    on_display::<S, Fast>("Fast", number, give);
    by_spans::<S, Fast>("Fast", number, give);
    on_display::<S, Stable>("Stable", number, give);
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
    give(row_in_tier::<S, (), T>(tier, number, SIZE));
    give(row_in_tier::<S, (Diffuse,), T>(tier, number, SIZE));
    give(row_in_tier::<S, (Diffuse, Specular, Shadows), T>(tier, number, SIZE));
}

/// The same on a display, whose rows are longer, and a scene of more objects.
fn on_display<S: Scalar, T: Tier<S>>(tier: &'static str, number: &'static str, give: &mut impl FnMut(Row)) {
    give(row_in_tier::<S, (), T>(tier, number, DISPLAY));
    give(row_in_tier::<S, (Diffuse,), T>(tier, number, DISPLAY));
    give(row_in_tier::<S, (Diffuse, Specular, Shadows), T>(tier, number, DISPLAY));
    give(still_life::<S, T>(tier, number));
}

/// The same by spans, and in one light.
fn by_spans<S: Scalar, T: Tier<S>>(tier: &'static str, number: &'static str, give: &mut impl FnMut(Row)) {
    give(row_by_spans::<S, (), T>("none, by spans", tier, number, Stage::scene));
    give(row_by_spans::<S, (Diffuse,), T>("diffuse, by spans", tier, number, Stage::scene));
    give(row_by_spans::<S, (Diffuse,), T>("diffuse, one light, by spans", tier, number, Stage::in_one_light));
    let scene = "diffuse, shadows, one light, by spans";
    give(row_by_spans::<S, (Diffuse, Shadows), T>(scene, tier, number, Stage::in_one_light));
    let scene = "diffuse, specular, shadows, by spans";
    give(row_by_spans::<S, (Diffuse, Specular, Shadows), T>(scene, tier, number, Stage::scene));
}

#[inline(never)]
fn row_by_spans<S: Scalar, E: Effects, T: Tier<S>>(
    scene: &'static str,
    tier: &'static str,
    number: &'static str,
    of: impl Fn(&Stage<S>) -> Result<Scene<'_, S>, SceneError>,
) -> Row {
    let stage = Stage::<S>::calling_for(E::SET).expect("the stage's numbers fit every type");
    let of = of(&stage).expect("the stage's lists fit together").at_tier::<T>();
    let alone = every_in_spans(ROWS, &Picture::<S, E, T>::leaving_out(&of, DISPLAY));
    Row { set: E::SET, tier, number, scene, alone, among_all: None }
}

/// The scene of the gallery, of fourteen objects, with a hierarchy.
#[inline(never)]
fn still_life<S: Scalar, T: Tier<S>>(tier: &'static str, number: &'static str) -> Row {
    type Lit = (Diffuse, Specular, Shadows);
    let mut alone = None;
    with_built_in::<S>(BuiltIn::StillLife, |scene| {
        alone = Some(every(ROWS, &Picture::<S, Lit, T>::leaving_out(&scene.at_tier::<T>(), DISPLAY)));
    });
    let alone = alone.expect("the scene was measured");
    Row { set: Lit::SET, tier, number, scene: BuiltIn::StillLife.name(), alone, among_all: None }
}

#[inline(never)]
fn row_in_tier<S: Scalar, E: Effects, T: Tier<S>>(tier: &'static str, number: &'static str, size: Size) -> Row {
    let stage = Stage::<S>::calling_for(E::SET).expect("the stage's numbers fit every type");
    let scene = stage.scene().expect("the stage's lists fit together").at_tier::<T>();
    let picture = Picture::<S, E, T>::leaving_out(&scene, size);
    let alone = every(if size == DISPLAY { ROWS } else { 1 }, &picture);
    Row { set: E::SET, tier, number, scene: "", alone, among_all: None }
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
        scene: "",
        alone: picture(&Picture::<S, E>::leaving_out(&scene, size)),
        among_all: Some(picture(&Picture::<S, All>::new(&scene, size).only(E::SET))),
    }
}
