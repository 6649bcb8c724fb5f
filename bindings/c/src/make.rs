//! Makes shapes, frames and rays from the values of C.

use crate::number::{Number, Of};
use crate::status::{Failed, Outcome, raylet_error};
use crate::storage::{Chosen, get, maybe, null, put, raylet_frame, raylet_ray, raylet_shape, write};
use crate::value::raylet_vec3;
use core::mem::MaybeUninit;
use raylet::{
    Affine, Departure, Error, Frame, Leaving, Part, Placement, Primitive, Range, Ray, Shape, UnitVec3, Visible,
};

/// Where C wants a value.
pub type Out<'a, T> = Option<&'a mut MaybeUninit<T>>;

/// A shape of a primitive, unplaced. It fails if its kind is not among those of this library.
pub fn shape<N: Number, P: Into<Primitive<Of<N>>>, E: Into<Error>>(
    out: Out<'_, raylet_shape<N>>,
    primitive: impl FnOnce() -> Result<P, E>,
) -> Outcome {
    put(out, || value(Shape::new(value(primitive())?).among()))
}

/// A value that may fail to be made.
pub fn value<T, E: Into<Error>>(made: Result<T, E>) -> Result<T, Failed> {
    made.map_err(|error| error.into().into())
}

/// The direction of a vector of any length.
pub fn direction<N: Number>(vector: raylet_vec3<N>) -> Result<UnitVec3<Of<N>>, Failed> {
    value(UnitVec3::new(vector.vector()))
}

/// Places a shape anew. It fails if the kind of the placement is not among those of this library.
pub fn placed<N: Number>(
    shape: Option<&mut raylet_shape<N>>,
    placement: impl FnOnce(&Shape<Of<N>, Chosen>) -> Result<Placement<Of<N>>, Failed>,
) -> Outcome {
    changed(shape, |shape| {
        let anywhere = Shape::new(*shape.primitive()).seen_from(shape.visible());
        value(anywhere.placed(placement(&shape)?).among())
    })
}

/// Changes a shape.
fn changed<N: Number>(
    shape: Option<&mut raylet_shape<N>>,
    change: impl FnOnce(Shape<Of<N>, Chosen>) -> Result<Shape<Of<N>, Chosen>, Failed>,
) -> Outcome {
    let shape = shape.ok_or_else(null)?;
    let old = *get(Some(&*shape))?;
    put(Some(maybe(shape)), || change(old))
}

pub fn in_frame<N: Number>(shape: Option<&mut raylet_shape<N>>, frame: Option<&raylet_frame<N>>) -> Outcome {
    placed(shape, |_| Ok((*get(frame)?).into()))
}

pub fn stretched<N: Number>(
    shape: Option<&mut raylet_shape<N>>,
    frame: Option<&raylet_frame<N>>,
    scale: raylet_vec3<N>,
) -> Outcome {
    placed(shape, |_| Ok(value(Affine::stretched(*get(frame)?, scale.vector()))?.into()))
}

pub fn in_matrix<N: Number>(
    shape: Option<&mut raylet_shape<N>>,
    position: raylet_vec3<N>,
    axes: [raylet_vec3<N>; 3],
) -> Outcome {
    placed(shape, |_| Ok(value(Affine::new(position.vector(), axes.map(raylet_vec3::vector)))?.into()))
}

pub fn moved<N: Number>(shape: Option<&mut raylet_shape<N>>, position: raylet_vec3<N>) -> Outcome {
    placed(shape, |shape| value(shape.placement().moved_to(position.vector())))
}

pub fn seen_from<N: Number>(shape: Option<&mut raylet_shape<N>>, visible: u8) -> Outcome {
    let visible = match visible {
        0 => Visible::Both,
        1 => Visible::Outside,
        2 => Visible::Inside,
        _ => return Err(Failed::of(raylet_error::RAYLET_ERROR_CHOICE)),
    };
    changed(shape, |shape| Ok(shape.seen_from(visible)))
}

/// A frame that may fail to be made.
pub fn frame<N: Number, E: Into<Error>>(
    out: Out<'_, raylet_frame<N>>,
    made: impl FnOnce() -> Result<Result<Frame<Of<N>>, E>, Failed>,
) -> Outcome {
    put(out, || value(made()?))
}

/// A ray that may fail to be made.
pub fn ray<N: Number, E: Into<Error>>(
    out: Out<'_, raylet_ray<N>>,
    made: impl FnOnce() -> Result<Result<Ray<Of<N>>, E>, Failed>,
) -> Outcome {
    put(out, || value(made()?))
}

/// Changes a ray.
pub fn changed_ray<N: Number>(
    ray: Option<&mut raylet_ray<N>>,
    change: impl FnOnce(Ray<Of<N>>) -> Result<Ray<Of<N>>, Failed>,
) -> Outcome {
    let ray = ray.ok_or_else(null)?;
    let old = *get(Some(&*ray))?;
    put(Some(maybe(ray)), || change(old))
}

pub fn in_range<N: Number>(ray: Option<&mut raylet_ray<N>>, start: N, end: N) -> Outcome {
    changed_ray(ray, |ray| Ok(ray.with_range(value(Range::new(start.scalar(), end.scalar()))?)))
}

pub fn departing<N: Number>(ray: Option<&mut raylet_ray<N>>, object: u32, part: u8, leaving: u8) -> Outcome {
    let part = *Part::EVERY.get(usize::from(part)).ok_or(Failed::of(raylet_error::RAYLET_ERROR_HIT))?;
    let leaving = match leaving {
        0 => Leaving::Outwards,
        1 => Leaving::Inwards,
        _ => return Err(Failed::of(raylet_error::RAYLET_ERROR_CHOICE)),
    };
    changed_ray(ray, |ray| Ok(ray.departing(Departure { object, part, leaving })))
}

/// The same, of what C's lists make.
pub fn shape_of<N: Number, P: Into<Primitive<Of<N>>>, E: Into<Error>>(
    out: Out<'_, raylet_shape<N>>,
    primitive: impl FnOnce() -> Result<Result<P, E>, Failed>,
) -> Outcome {
    put(out, || value(Shape::new(value(primitive()?)?).among()))
}

/// A frame from one point to another, and their distance.
pub fn between<N: Number>(
    frame: Out<'_, raylet_frame<N>>,
    from: raylet_vec3<N>,
    to: raylet_vec3<N>,
    height: Out<'_, N>,
) -> Outcome {
    let (made, length) = value(Frame::between(from.vector(), to.vector()))?;
    put(frame, || Ok(made))?;
    write(height, || Ok(N::from_scalar(length)))
}
