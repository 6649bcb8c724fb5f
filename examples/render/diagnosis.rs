//! Why a picture is black or empty, or less true than it may seem.

use crate::arithmetic::Number;
use crate::load::{Loaded, Remarks};
use raylet::effect::{Effect, EffectSet};
use raylet::scene::nff::Scale;
use raylet::tier::Tier;
use raylet::{Camera, Counters, Light, Object, Scalar, Scene, Size, Visible};

/// The picture is looked through for surfaces that are seen from the back with so many rays a side.
const PROBES: u16 = 64;

/// How many pixels there are of some kinds.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pixels {
    /// Those that see an object.
    pub(crate) seen: u64,
    /// Those of them that are black.
    pub(crate) black: u64,
    /// Those that a lamp reaches.
    pub(crate) lit: u64,
}

impl Pixels {
    pub(crate) const fn add(&mut self, other: Self) {
        self.seen += other.seen;
        self.black += other.black;
        self.lit += other.lit;
    }

    /// Nearly all that is seen is black; not quite all where the background shines in at an edge.
    const fn is_dark(self) -> bool {
        10 * self.black > 9 * self.seen
    }
}

/// Why nothing is to be seen, and what to do about it; `None` if there is something.
pub(crate) fn darkness<S: Scalar, T: Tier<S>>(
    loaded: &Loaded<S>,
    scene: &Scene<'_, S, T>,
    size: Size,
    pixels: Pixels,
    [called_for, used]: [EffectSet; 2],
    number: Number,
) -> Option<String> {
    if pixels.seen == 0 {
        return Some(format!("the picture shows no object: {}", emptiness(loaded, scene.camera(), size, number)));
    }
    if !pixels.is_dark() {
        return None;
    }
    let shows = EffectSet::of(Effect::Diffuse).with(Effect::Specular).with(Effect::Reflection).with(Effect::Refraction);
    let out = |light: &Light<S>| light.strength.iter().all(|strength| *strength <= S::ZERO);
    let why = if loaded.lights.is_empty() {
        "the scene has no lights; add one, such as \"l 10 20 30\""
    } else if loaded.lights.iter().all(out) {
        "all lights have the strength 0; give them another, or none"
    } else if called_for.intersection(shows).is_empty() {
        "no material sends light back; give one a Kd, Ks or T above 0"
    } else if used.intersection(shows).is_empty() {
        "--effects leaves off all that shows a surface; add diffuse"
    } else if pixels.lit == 0 && pixels.black == pixels.seen {
        "no light reaches what is seen, or its materials are black; surfaces face away from the lights or lie in shadow"
    } else {
        return None;
    };
    Some(format!("what the picture shows is black: {why}"))
}

/// Why no pixel sees an object.
fn emptiness<S: Scalar>(loaded: &Loaded<S>, camera: &Camera<S>, size: Size, number: Number) -> String {
    let finer = if number == Number::F64 { "" } else { ", or try f64" };
    if loaded.objects.is_empty() {
        return match loaded.remarks.invisible {
            0 => "the scene has none; add one, such as \"s 0 0 0 1\"".into(),
            1 => format!("its only one was left out, too small for {number}, or without area; make it larger{finer}"),
            left_out => {
                format!(
                    "all {left_out} were left out, too small for {number}, or without area; make them larger{finer}"
                )
            }
        };
    }
    let [met, rays] = met_from_any_side(loaded, camera, size);
    if met > 0 {
        let percent = 100 * met / rays;
        return format!(
            "every surface in sight is seen from its back ({percent} % of the picture), which does not show; see them \
             with --both-sides"
        );
    }
    "none is in sight; check the view's from, at and angle".into()
}

/// How many rays to the picture meet a surface, whichever side it turns to the eye, and of how many.
fn met_from_any_side<S: Scalar>(loaded: &Loaded<S>, camera: &Camera<S>, size: Size) -> [u32; 2] {
    let both = |object: &Object<S>| Object { shape: object.shape.seen_from(Visible::Both), ..*object };
    let objects: Vec<_> = loaded.objects.iter().map(both).collect();
    let Ok(scene) = Scene::new(&objects, &loaded.materials, &[], *camera) else { return [0, 1] };
    let raster = camera.raster(Size::new(size.width, size.height));
    let steps = |pixels: u16| (0..pixels).step_by(usize::from(pixels.div_ceil(PROBES)));
    let (mut met, mut rays) = (0, 0);
    for (x, y) in steps(size.height).flat_map(|y| steps(size.width).map(move |x| (x, y))) {
        rays += 1;
        met += u32::from(raster.ray([x, y], [0, 0]).is_some_and(|ray| scene.occludes(&ray, &mut Counters::default())));
    }
    [met, rays]
}

/// What whoever looks at the picture should know of how its file was read.
pub(crate) fn remarks(remarks: Remarks, number: Number) -> Vec<String> {
    let mut all = Vec::new();
    if remarks.turned > 0 {
        all.push(format!(
            "{} corner normals say; the normals decide which side is seen",
            several(
                remarks.turned,
                "polygon with normals runs the other way than its",
                "polygons with normals run the other way than their"
            )
        ));
    }
    if remarks.distant > 0 {
        all.push(format!(
            "{} too far away for {number} at --scale {}: only the direction counts",
            several(remarks.distant, "light is", "lights are"),
            remarks.scale
        ));
    }
    if let Some(bits) = number.fraction_bits().filter(|_| remarks.scale < Scale::ONE) {
        let step = f64::from(-bits - i32::from(remarks.scale.power())).exp2();
        all.push(format!(
            "one unit of the file is {} in the scene, so that its coordinates fit into {number}: lengths are rounded \
             to multiples of {step} of the file's units, which shows in what is small, thin or mirrored; f64 rounds \
             less",
            remarks.scale
        ));
    }
    all
}

/// A count, and what is counted.
pub(crate) fn several(count: u32, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
