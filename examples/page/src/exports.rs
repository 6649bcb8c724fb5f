//! The functions that JavaScript calls. Vectors go through one list of numbers: JavaScript writes arguments to its
//! start, and reads answers from there. Functions that can fail give the number of numbers that they answer with, or
//! -1; then [`reason`] has the reason.

use crate::number::Number;
use crate::world::Answer;
use core::cell::RefCell;
use fixed::types::I16F16;
use raylet::Size;

/// As many numbers as a row of a picture may need.
const MOST: usize = 3 * 1024;

thread_local! {
    static NUMBERS: RefCell<Vec<f64>> = RefCell::new(vec![0.0; MOST]);
    static REASON: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Where the list of numbers is.
#[unsafe(no_mangle)]
pub extern "C" fn numbers() -> usize {
    NUMBERS.with_borrow(|numbers| numbers.as_ptr() as usize)
}

/// Where the text of the last failure is.
#[unsafe(no_mangle)]
pub extern "C" fn reason() -> usize {
    REASON.with_borrow(|reason| reason.as_ptr() as usize)
}

/// The length of that text.
#[unsafe(no_mangle)]
pub extern "C" fn reason_length() -> usize {
    REASON.with_borrow(String::len)
}

/// The first vectors of the list.
fn vectors<const N: usize>() -> [[f64; 3]; N] {
    NUMBERS.with_borrow(|numbers| core::array::from_fn(|i| [3 * i, 3 * i + 1, 3 * i + 2].map(|j| numbers[j])))
}

fn answered(answer: Option<Answer>) -> i32 {
    let Some(answer) = answer.filter(|answer| answer.len() <= MOST) else {
        REASON.replace("there is no such solid, ray or view".into());
        return -1;
    };
    NUMBERS.with_borrow_mut(|numbers| numbers[..answer.len()].copy_from_slice(&answer));
    answer.len() as i32
}

fn done(result: Result<(), raylet::Error>) -> i32 {
    match result {
        Ok(()) => 0,
        Err(error) => {
            REASON.replace(error.to_string());
            -1
        }
    }
}

/// An expression about the world of the number type with this number: `f32`, `I16F16`, `f64`.
macro_rules! in_world {
    ($number:expr, $world:ident => $answer:expr) => {
        match $number {
            0 => f32::world().with_borrow_mut(|$world| $answer),
            1 => I16F16::world().with_borrow_mut(|$world| $answer),
            _ => f64::world().with_borrow_mut(|$world| $answer),
        }
    };
}

/// Takes all solids, rays and the view away.
#[unsafe(no_mangle)]
pub extern "C" fn clear(number: u32) {
    in_world!(number, world => world.clear());
}

/// Adds a solid. Arguments: sizes, base, axis.
#[unsafe(no_mangle)]
pub extern "C" fn place(number: u32, solid: u32) -> i32 {
    in_world!(number, world => done(world.place(solid, vectors())))
}

/// Adds a ray. Arguments: origin, direction.
#[unsafe(no_mangle)]
pub extern "C" fn aim(number: u32) -> i32 {
    in_world!(number, world => done(world.aim(vectors())))
}

/// Sets the view: by an angle in degrees, or of a height and without perspective. Arguments: position, target.
#[unsafe(no_mangle)]
pub extern "C" fn look(number: u32, angle: f64, height: f64, columns: u32, rows: u32) -> i32 {
    let size = Size::new(columns as u16, rows as u16);
    in_world!(number, world => done(world.look(vectors(), angle, height, size)))
}

/// A solid as it is stored: sizes, position, axes.
#[unsafe(no_mangle)]
pub extern "C" fn solid(number: u32, index: usize) -> i32 {
    in_world!(number, world => answered(world.solid(index)))
}

/// A ray as it is stored: origin, direction.
#[unsafe(no_mangle)]
pub extern "C" fn ray(number: u32, index: usize) -> i32 {
    in_world!(number, world => answered(world.ray(index)))
}

/// The same of the ray through a pixel.
#[unsafe(no_mangle)]
pub extern "C" fn ray_of_pixel(number: u32, x: u32, y: u32) -> i32 {
    in_world!(number, world => answered(world.ray_of_pixel([x as u16, y as u16])))
}

/// All hits of a ray with a solid, in a tier: of each `t`, part, crossing, point, normal.
#[unsafe(no_mangle)]
pub extern "C" fn hits(number: u32, tier: u32, solid: usize, ray: usize) -> i32 {
    in_world!(number, world => answered(world.hits(tier, solid, ray)))
}

/// All rays at the first solid, so many times: how many hits there are.
#[unsafe(no_mangle)]
pub extern "C" fn repeated(number: u32, tier: u32, times: u32) -> usize {
    in_world!(number, world => world.repeated(tier, times))
}

/// A row of the picture: of each pixel the number of the nearest solid or -1, `t`, the cosine between normal and ray.
#[unsafe(no_mangle)]
pub extern "C" fn row(number: u32, tier: u32, y: u32) -> i32 {
    in_world!(number, world => answered(world.row(tier, y as u16)))
}
