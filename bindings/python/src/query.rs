//! Many rays at one shape, on all cores.

use crate::number::Number;
use raylet::{Error, Fast, Plain, Ray, Shape, Stable, Tier, UnitVec3, Vec3};

/// What is computed besides the hit.
#[derive(Clone, Copy)]
pub struct Wanted {
    pub normals: bool,
}

/// A tier by its name.
#[derive(Clone, Copy)]
pub enum Tiers {
    Plain,
    Fast,
    Stable,
    Exact,
}

impl Tiers {
    pub fn named(name: &str) -> Option<Self> {
        Some(match name {
            "plain" => Self::Plain,
            "fast" => Self::Fast,
            "stable" => Self::Stable,
            "exact" => Self::Exact,
            _ => return None,
        })
    }
}

/// The hits, ray by ray: `NONE` and -1 where there is none.
pub struct Found<N> {
    pub t: Vec<N>,
    pub part: Vec<i8>,
    pub crossing: Vec<i8>,
    /// Three components a ray, if they are wanted.
    pub normal: Vec<N>,
}

/// Some of the rays, and where their hits go.
struct Share<'a, N> {
    /// The number of the first ray.
    first: usize,
    from: &'a [N],
    along: &'a [N],
    t: &'a mut [N],
    part: &'a mut [i8],
    crossing: &'a mut [i8],
    normal: &'a mut [N],
}

/// More than any machine has cores that gain by it.
const MOST_THREADS: usize = 256;

/// The nearest hits of rays from points along vectors of any length, three numbers each. Fails with the number of the
/// first ray of a core's share that cannot be made.
pub fn nearest<N: Number>(
    shape: &Shape<N::Scalar>,
    from: &[N],
    along: &[N],
    wanted: Wanted,
    tier: Tiers,
    threads: usize,
) -> Result<Found<N>, (usize, Error)> {
    let count = from.len() / 3;
    let normals = if wanted.normals { from.len() } else { 0 };
    let mut found = Found {
        t: vec![N::NONE; count],
        part: vec![-1; count],
        crossing: vec![-1; count],
        normal: vec![N::default(); normals],
    };
    let each = count.div_ceil(threads.clamp(1, MOST_THREADS)).max(1);
    let mut normal = found.normal.chunks_mut(3 * each);
    let shares = from.chunks(3 * each).zip(along.chunks(3 * each)).enumerate();
    let outputs = found.t.chunks_mut(each).zip(found.part.chunks_mut(each)).zip(found.crossing.chunks_mut(each));
    let work = shares.zip(outputs).map(|((index, (from, along)), ((t, part), crossing))| Share {
        first: index * each,
        from,
        along,
        t,
        part,
        crossing,
        normal: normal.next().unwrap_or_default(),
    });
    std::thread::scope(|scope| {
        let running: Vec<_> = work
            .map(|share| {
                scope.spawn(move || match tier {
                    Tiers::Plain => of_share::<N, Plain>(shape, share),
                    Tiers::Fast => of_share::<N, Fast>(shape, share),
                    Tiers::Stable => of_share::<N, Stable>(shape, share),
                    Tiers::Exact => of_share::<N, N::Best>(shape, share),
                })
            })
            .collect();
        running.into_iter().try_for_each(|thread| thread.join().expect("no query panics"))
    })?;
    Ok(found)
}

fn of_share<N: Number, T: Tier<N::Scalar>>(
    shape: &Shape<N::Scalar>,
    share: Share<'_, N>,
) -> Result<(), (usize, Error)> {
    let Share { first, from, along, t, part, crossing, normal } = share;
    let vector = |[x, y, z]: [N; 3]| Vec3::new(x.scalar(), y.scalar(), z.scalar());
    let (from, along) = (from.as_chunks::<3>().0, along.as_chunks::<3>().0);
    let mut normals = normal.as_chunks_mut::<3>().0.iter_mut();
    for (i, (from, along)) in from.iter().zip(along).enumerate() {
        let ray = UnitVec3::new(vector(*along)).map_err(Error::from);
        let ray = ray.and_then(|along| Ray::new(vector(*from), along).map_err(Error::from));
        let ray = ray.map_err(|error| (first + i, error))?;
        let normal = normals.next();
        if let Some(hit) = shape.nearest_at::<T>(&ray) {
            t[i] = N::from_scalar(hit.t);
            part[i] = hit.part as i8;
            crossing[i] = hit.crossing as i8;
            if let Some(normal) = normal {
                *normal = shape.surface(&ray, &hit).normal().to_array().map(N::from_unit);
            }
        }
    }
    Ok(())
}
