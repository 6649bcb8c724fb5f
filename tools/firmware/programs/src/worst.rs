//! The ray that takes the most instructions: a search that changes solid and ray, and keeps what takes longer.

use core::hint::black_box;
use fixed::types::I16F16;
use heapless::Vec;
use raylet::shape::kinds::{Kinds, OfKind};
use raylet::{Departure, Frame, Leaving, Part, Primitive, Range, Ray, Shape, UnitVec3, Vec3};
use raylet_firmware::clock;
use shared::workload::{Placed, QUERIES, RAYS, query};

/// The number type.
pub type Number = I16F16;

/// A solid in a frame, whose kinds the program names.
pub type Of<P> = Shape<Number, (P, Frame<Number>)>;

/// Calls of a query a measurement.
const CALLS: u64 = 4;

/// Searches for each query, and steps of each.
const SEARCHES: usize = 40;
const STEPS: usize = 400;

/// Where numbers stand that describe a solid and a ray, each in units of the type or of a direction.
const SIZES: usize = 0;
const POSITION: usize = 3;
const AXES: usize = 6;
const ORIGIN: usize = 12;
const DIRECTION: usize = 15;
const DEPARTURE: usize = 18;
const RANGE: usize = 19;

/// A solid and a ray, as numbers.
type Genes = [i32; 20];

/// Random bits (Marsaglia, *Xorshift RNGs*, 2003).
struct Random(u32);

impl Random {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// A number of any length.
    fn number(&mut self, bits: u32) -> i32 {
        (self.next() as i32) >> (31 - self.next() % bits.max(1)).min(31)
    }

    /// A solid of a metre or so, a ray from nearby towards it, and sometimes what is special.
    fn genes(&mut self) -> Genes {
        let mut genes = [0; 20];
        for (place, gene) in genes.iter_mut().enumerate() {
            *gene = match place {
                SIZES..POSITION => 1 << 12 | self.number(17).abs(),
                AXES..ORIGIN | DIRECTION..DEPARTURE => self.number(30),
                _ => {
                    let is_far = self.next().is_multiple_of(4);
                    self.number(if is_far { 26 } else { 18 })
                }
            };
        }
        genes
    }

    /// Changes one number: by a power of two, to zero, to another of them, or its sign.
    fn change(&mut self, genes: &mut Genes) {
        let (place, other) = (self.next() as usize % 20, self.next() as usize % 20);
        let from = genes.get(other).copied().unwrap_or(0);
        let Some(gene) = genes.get_mut(place) else { return };
        *gene = match self.next() % 8 {
            0 => 0,
            1 => from,
            2 => gene.wrapping_neg(),
            3 => self.number(30),
            _ if self.next().is_multiple_of(2) => gene.wrapping_add(1 << (self.next() % 30)),
            _ => gene.wrapping_sub(1 << (self.next() % 30)),
        };
    }
}

/// The ray; `None` if there is none.
fn ray(genes: &Genes) -> Option<Ray<Number>> {
    let at = |place: usize| Number::from_bits(genes.get(place).copied().unwrap_or(0));
    let point = |place| Vec3::new(at(place), at(place + 1), at(place + 2));
    let mut ray = Ray::new(point(ORIGIN), UnitVec3::new(point(DIRECTION)).ok()?).ok()?;
    let [departure, range] = [DEPARTURE, RANGE].map(|place| genes.get(place).copied().unwrap_or(0));
    if range & 7 == 1 {
        ray = ray.with_range(Range::line());
    } else if range & 7 == 2 {
        ray = ray.with_range(Range::from(at(RANGE)).ok()?);
    }
    if departure & 3 == 0 {
        let part = [Part::Side, Part::Base, Part::Top][(departure >> 2) as usize % 3];
        let leaving = if departure & 0x100 == 0 { Leaving::Inwards } else { Leaving::Outwards };
        ray = ray.departing(Departure { object: 0, part, leaving });
    }
    Some(ray)
}

/// The solid.
fn shape<P: OfKind + Into<Primitive<Number>>>(genes: &Genes, make: fn([Number; 3]) -> Option<P>) -> Option<Of<P>>
where
    (P, Frame<Number>): Kinds,
{
    let at = |place: usize| Number::from_bits(genes.get(place).copied().unwrap_or(0));
    let point = |place| Vec3::new(at(place), at(place + 1), at(place + 2));
    let [forward, up] = [AXES, AXES + 3].map(|place| UnitVec3::new(point(place)));
    let frame = Frame::looking(point(POSITION), forward.ok()?, up.ok()?).ok()?;
    Some(Shape::of(make([at(SIZES), at(SIZES + 1), at(SIZES + 2)])?).placed(frame))
}

/// Instructions of one call.
fn taken<P>(query: fn(&Of<P>, &Ray<Number>) -> bool, shape: &Of<P>, ray: &Ray<Number>) -> u64
where
    (P, Frame<Number>): Kinds,
{
    let of = |query: fn(&Of<P>, &Ray<Number>) -> bool| {
        let query = black_box(query);
        let start = clock::instructions();
        for _ in 0..CALLS {
            black_box(query(black_box(shape), black_box(ray)));
        }
        clock::instructions().wrapping_sub(start)
    };
    let nothing = of(|_, _| black_box(true));
    of(query).saturating_sub(nothing) / CALLS
}

/// What a query takes: of what users do the mean, of the 99th of a hundred and of the worst; and of the worst that the
/// search finds.
#[inline(never)]
pub fn of<P: OfKind + Into<Primitive<Number>>>(
    solid: &str,
    make: fn([Number; 3]) -> Option<P>,
    query_of: fn(&Of<P>, &Ray<Number>) -> bool,
) -> [u64; 4]
where
    (P, Frame<Number>): Kinds,
{
    let mut users = Vec::<u64, { 3 * QUERIES }>::new();
    for rays in RAYS {
        for index in 0..QUERIES {
            let Some(test) = query::<Number>(solid, Placed::Turned, rays, index) else { continue };
            let Ok(shape) = test.shape.among::<(P, Frame<Number>)>() else { continue };
            let _ = users.push(taken(query_of, &shape, &test.ray));
        }
    }
    users.sort_unstable();
    let (mean, worst) = (users.iter().sum::<u64>() / users.len().max(1) as u64, users.last().copied().unwrap_or(0));
    let nearly = users.get(users.len() * 99 / 100).copied().unwrap_or(worst);

    let (mut random, mut most) = (Random(0x7261_796c), worst);
    for _ in 0..SEARCHES {
        let (mut best, mut length) = (random.genes(), 0);
        for _ in 0..STEPS {
            let mut genes = best;
            for _ in 0..=random.next() % 3 {
                random.change(&mut genes);
            }
            let (Some(shape), Some(ray)) = (shape(&genes, make), ray(&genes)) else { continue };
            let now = taken(query_of, &shape, &ray);
            if now >= length {
                (best, length) = (genes, now);
            }
        }
        most = most.max(length);
    }
    [mean, nearly, worst, most]
}
