//! Asks shapes about rays, for C. As in its header, places for results come first.

use crate::make::Out;
use crate::number::{Number, Of};
use crate::status::{Failed, Outcome};
use crate::storage::{
    Chosen, get, given, list, nodes, null, put, put_hit, raylet_node, raylet_ray, raylet_shape, raylet_shapes,
};
use crate::storage::{raylet_surface, room, write};
use crate::value::{RAYLET_MOST_CROSSINGS, RAYLET_MOST_HITS, raylet_crossing, raylet_hit, raylet_hits, raylet_vec3};
use core::ffi::c_void;
use core::mem::MaybeUninit;
use raylet::shape::Surface;
use raylet::solids::{Crossings, Start};
use raylet::{Error, Hits, Shapes, Tier};

type Shape<'a, N> = Option<&'a raylet_shape<N>>;
type Ray<'a, N> = Option<&'a raylet_ray<N>>;

#[inline(always)]
pub fn nearest<N: Number, T: Tier<Of<N>>>(
    hit: Out<'_, raylet_hit<N>>,
    shape: Shape<'_, N>,
    ray: Ray<'_, N>,
) -> Outcome {
    let (shape, ray, hit) = (get(shape)?, get(ray)?, hit.ok_or_else(null)?);
    Ok(put_hit(hit, || shape.nearest_at::<T>(ray)))
}

#[inline(always)]
pub fn try_nearest<N: Number, T: Tier<Of<N>>>(
    hit: Out<'_, raylet_hit<N>>,
    shape: Shape<'_, N>,
    ray: Ray<'_, N>,
) -> Outcome {
    let found = get(shape)?.try_nearest_at::<T>(get(ray)?).map_err(Error::from)?;
    Ok(put_hit(hit.ok_or_else(null)?, || found))
}

#[inline(always)]
pub fn occludes<N: Number, T: Tier<Of<N>>>(shape: Shape<'_, N>, ray: Ray<'_, N>) -> Outcome {
    Ok(get(shape)?.occludes_at::<T>(get(ray)?).into())
}

#[inline(always)]
pub fn contains<N: Number, T: Tier<Of<N>>>(shape: Shape<'_, N>, point: raylet_vec3<N>) -> Outcome {
    Ok(get(shape)?.contains_at::<T>(point.vector()).into())
}

fn all_of<N: Number>(hits: &Hits<Of<N>>) -> raylet_hits<N> {
    let zero = N::from_scalar(Default::default());
    let mut all = [raylet_hit { t: zero, part: 0, crossing: 0 }; RAYLET_MOST_HITS];
    for (place, hit) in all.iter_mut().zip(hits.iter()) {
        *place = raylet_hit::of(*hit);
    }
    let coincident = hits.coincident().map(|range| [range.start(), range.end()].map(N::from_scalar));
    raylet_hits {
        hits: all,
        count: hits.len() as u8,
        starts_inside: hits.starts_inside(),
        is_coincident: coincident.is_some(),
        coincident: coincident.unwrap_or([zero; 2]),
    }
}

/// Their number.
#[inline(always)]
pub fn hits<N: Number, T: Tier<Of<N>>>(out: Out<'_, raylet_hits<N>>, shape: Shape<'_, N>, ray: Ray<'_, N>) -> Outcome {
    let hits = get(shape)?.hits_at::<T>(get(ray)?);
    write(out, || Ok(all_of(&hits)))?;
    Ok(hits.len() as i32)
}

pub fn surface<N: Number>(
    out: Out<'_, raylet_surface<N>>,
    shape: Shape<'_, N>,
    ray: Ray<'_, N>,
    hit: Option<&raylet_hit<N>>,
) -> Outcome {
    put(out, || Ok(get(shape)?.surface(get(ray)?, &given(hit)?.hit()?)))
}

/// What a surface is asked for.
pub fn of_surface<N: Number, A>(
    out: Out<'_, A>,
    surface: Option<&raylet_surface<N>>,
    what: impl FnOnce(&Surface<Of<N>, Chosen>) -> A,
) -> Outcome {
    write(out, || Ok(what(get(surface)?)))
}

pub fn build<N: Number>(
    out: Out<'_, raylet_shapes<N>>,
    shapes: *const raylet_shape<N>,
    count: usize,
    storage: *mut raylet_node<N>,
    node_count: usize,
) -> Outcome {
    put(out, || Ok(Shapes::new(list(shapes, count)?, nodes(storage, node_count)?).map_err(Error::from)?))
}

type Many<'a, N> = Option<&'a raylet_shapes<N>>;

#[inline(always)]
pub fn nearest_of<N: Number, T: Tier<Of<N>>>(
    shape: Out<'_, u32>,
    hit: Out<'_, raylet_hit<N>>,
    shapes: Many<'_, N>,
    ray: Ray<'_, N>,
) -> Outcome {
    match get(shapes)?.nearest_at::<T>(get(ray)?) {
        Some((index, found)) => {
            write(shape, || Ok(index))?;
            write(hit, || Ok(raylet_hit::of(found)))?;
            Ok(1)
        }
        None => Ok(0),
    }
}

#[inline(always)]
pub fn occlude<N: Number, T: Tier<Of<N>>>(shapes: Many<'_, N>, ray: Ray<'_, N>) -> Outcome {
    Ok(get(shapes)?.occludes_at::<T>(get(ray)?).into())
}

/// A function of C that is called with each shape that a ray meets.
pub type Each<N> = Option<extern "C" fn(context: *mut c_void, shape: u32, hits: *const raylet_hits<N>)>;

#[inline(always)]
pub fn hits_of<N: Number, T: Tier<Of<N>>>(
    shapes: Many<'_, N>,
    ray: Ray<'_, N>,
    each: Each<N>,
    context: *mut c_void,
) -> Outcome {
    let each = *given(each.as_ref())?;
    let mut count = 0;
    get(shapes)?.hits_at::<T>(get(ray)?, |shape, hits| {
        count += 1;
        each(context, shape, &all_of(&hits));
    });
    Ok(count)
}

/// The crossings in `out`, as many as there is room for; their number.
#[inline(always)]
pub fn crossings<N: Number, T: Tier<Of<N>>>(
    out: *mut raylet_crossing<N>,
    capacity: usize,
    shapes: *const raylet_shape<N>,
    count: usize,
    ray: Ray<'_, N>,
) -> Outcome {
    let room: &mut [MaybeUninit<_>] = room(out, capacity)?;
    let shapes = list(shapes, count)?;
    let all = Crossings::<Of<N>, RAYLET_MOST_CROSSINGS>::with_start::<T>(shapes, get(ray)?, &Start::new());
    let all = all.map_err(Error::from)?;
    if all.len() > room.len() {
        return Err(Failed::of(crate::status::raylet_error::RAYLET_ERROR_FULL));
    }
    let bits = |set: raylet::solids::SolidSet| set.iter().fold(0, |bits, solid| bits | 1 << solid);
    for (place, crossing) in room.iter_mut().zip(all.iter()) {
        let (before, after) = (bits(crossing.before), bits(crossing.after));
        place.write(raylet_crossing { hit: raylet_hit::of(crossing.hit), solid: crossing.solid, before, after });
    }
    Ok(all.len() as i32)
}

pub fn bounds<N: Number>(low: Out<'_, raylet_vec3<N>>, high: Out<'_, raylet_vec3<N>>, shape: Shape<'_, N>) -> Outcome {
    let bounds = get(shape)?.bounds();
    write(low, || Ok(raylet_vec3::of(bounds.low)))?;
    write(high, || Ok(raylet_vec3::of(bounds.high)))
}

pub fn tangents<N: Number>(
    along_u: Out<'_, raylet_vec3<N>>,
    along_v: Out<'_, raylet_vec3<N>>,
    surface: Option<&raylet_surface<N>>,
) -> Outcome {
    let (u, v) = get(surface)?.tangents();
    write(along_u, || Ok(raylet_vec3::of_direction(u)))?;
    write(along_v, || Ok(raylet_vec3::of_direction(v)))
}
