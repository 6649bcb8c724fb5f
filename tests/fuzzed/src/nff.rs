//! What must hold for the NFF reader, whatever the text.

use raylet::scalar::UnitScalar;
use raylet::scene::nff::{self, Corner, Counts, NffError, Scale, Stores, View};
use raylet::scene::{CornerNormals, Full, Store};
use raylet::{Light, Material, Object, Picture, Scalar, Scene, Size, TraceContext};
use std::fmt::Debug;

/// Reads any bytes as a scene, in two number types, into stores of fixed capacity and into stores that grow; fails if
/// one of them breaks a promise. Bytes that are no UTF-8 are replaced: a reader is given a `str`. True if one of them
/// draws it.
pub fn check_nff(data: &[u8]) -> bool {
    let text = String::from_utf8_lossy(data);
    let drawn = [check::<f32>(&text), check::<fixed::types::I16F16>(&text)];
    drawn.contains(&true)
}

/// A store that never fills up.
struct Growing<T>(Vec<T>);

impl<T> Store<T> for Growing<T> {
    fn push(&mut self, item: T) -> Result<(), Full> {
        self.0.push(item);
        Ok(())
    }
}

/// What a text says.
struct Contents<S: Scalar> {
    view: View<S>,
    objects: Vec<Object<S>>,
    materials: Vec<Material<S>>,
    lights: Vec<Light<S>>,
    normals: Vec<CornerNormals<S>>,
}

fn check<S: Scalar>(text: &str) -> bool {
    fits::<S>(text);
    let large = read_growing::<S>(text, Scale::ONE);
    let small = read_small::<S>(text);
    for error in [&large, &small].into_iter().filter_map(|read| read.as_ref().err()) {
        is_in_the_text(text, error);
    }
    match (large, small) {
        (Ok(large), Ok(small)) => {
            assert_eq!(large.view, small.view, "the store changes the view: {text:?}");
            assert_eq!(large.objects, small.objects, "the store changes the objects: {text:?}");
            draw(text, &large);
            true
        }
        (Ok(large), Err(error)) => {
            use nff::Reason::{Full, TooManyCorners};
            let full = matches!(error.reason, Full { .. } | TooManyCorners { .. });
            assert!(full, "only room may be missing: {error}: {text:?}");
            draw(text, &large);
            true
        }
        (Err(_), Err(_)) => false,
        (Err(error), Ok(_)) => panic!("room is all that a small store lacks: {error}: {text:?}"),
    }
}

/// In fitting units a text says where it goes wrong as well, and never for a coordinate that the type cannot hold, but
/// for those beyond all scales.
fn fits<S: Scalar>(text: &str) {
    let scale = Scale::fitting::<S>(text);
    match read_growing::<S>(text, scale) {
        Ok(contents) => draw(text, &contents),
        Err(error) => {
            is_in_the_text(text, &error);
            let beyond = matches!(error.reason, nff::Reason::BeyondBudget { .. });
            assert!(S::RELATIVE || scale == Scale::LEAST || !beyond, "{scale} does not fit: {error}: {text:?}");
        }
    }
}

/// With as much memory as [`Counts`] says.
fn read_growing<S: Scalar>(text: &str, scale: Scale) -> Result<Contents<S>, NffError> {
    let counts = Counts::of(text);
    let (mut objects, mut materials) = (Growing(vec![]), Growing(vec![]));
    let (mut lights, mut normals) = (Growing(vec![]), Growing(vec![]));
    let view = nff::read_scaled(
        text,
        Stores {
            objects: &mut objects,
            materials: &mut materials,
            lights: &mut lights,
            normals: &mut normals,
            corners: &mut vec![Corner::default(); counts.corners],
        },
        scale,
    )
    .inspect_err(|error| {
        // More corners than the text has letters are an error, for which no memory is reserved.
        let lies = !matches!(error.reason, nff::Reason::TooManyCorners { room } if room < text.len());
        assert!(lies, "counted too few: {error}: {text:?}");
    })?;
    let (objects, materials, lights, normals) = (objects.0, materials.0, lights.0, normals.0);
    let used = [objects.len(), materials.len(), lights.len(), normals.len()];
    let counted = [counts.objects, counts.materials, counts.lights, counts.normals];
    assert!(used.iter().zip(counted).all(|(used, counted)| *used <= counted), "{used:?} of {counts:?}: {text:?}");
    Ok(Contents { view, objects, materials, lights, normals })
}

/// With little room, as on a microcontroller.
fn read_small<S: Scalar>(text: &str) -> Result<Contents<S>, NffError> {
    let (mut objects, mut materials) = (heapless::Vec::<_, 6>::new(), heapless::Vec::<_, 3>::new());
    let (mut lights, mut normals) = (heapless::Vec::<_, 2>::new(), heapless::Vec::<_, 3>::new());
    let view = nff::read(
        text,
        Stores {
            objects: &mut objects,
            materials: &mut materials,
            lights: &mut lights,
            normals: &mut normals,
            corners: &mut [Corner::default(); 6],
        },
    )?;
    let (objects, materials) = (objects.to_vec(), materials.to_vec());
    Ok(Contents { view, objects, materials, lights: lights.to_vec(), normals: normals.to_vec() })
}

/// An error names a place that exists, or the end of the text.
fn is_in_the_text(text: &str, error: &NffError) {
    // A carriage return and the line feed behind it are one end of a line.
    let lines = 1 + text.matches(['\n', '\r']).count() - text.matches("\r\n").count();
    let (line, column) = (error.place.line as usize, error.place.column as usize);
    assert!((1..=lines).contains(&line), "{error}, of {lines} lines: {text:?}");
    assert!((1..=text.chars().count() + 1).contains(&column), "{error}: {text:?}");
    assert!(error.to_string().len() > 20, "an error without words: {error}: {text:?}");
}

/// A scene that was read can be drawn, in finite colours. What is large is not drawn in full: the time goes into other
/// texts.
fn draw<S: Scalar>(text: &str, contents: &Contents<S>) {
    let Contents { view, objects, materials, lights, normals } = contents;
    let scene = ok(text, Scene::new(objects, materials, lights, view.camera)).with_background(view.background);
    let scene = ok(text, scene.with_normals(normals));
    let size = if objects.len() * (1 + lights.len()) > 100 { Size::new(2, 1) } else { Size::new(5, 4) };
    Picture::new(&scene, size).render(|x, y, pixel| {
        let channels = pixel.color.to_array();
        let range = S::Unit::ZERO..=S::Unit::ONE;
        assert!(channels.iter().all(|channel| range.contains(channel)), "{pixel:?} at {x}, {y}: {text:?}");
        let exists = pixel.seen.is_none_or(|(object, _)| (object as usize) < objects.len());
        assert!(exists, "{pixel:?} at {x}, {y} is of no object: {text:?}");
    });
    // One pixel of the picture of the text, whatever its size.
    let [width, height] = view.resolution;
    let picture = Picture::new(&scene, Size::new(width, height));
    picture.pixel(width - 1, height / 2, &mut TraceContext::new(()));
}

fn ok<T, E: Debug>(text: &str, result: Result<T, E>) -> T {
    result.unwrap_or_else(|error| panic!("a scene that was read is no scene: {error:?}: {text:?}"))
}
