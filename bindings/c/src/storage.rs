//! Opaque types of stated size, in which C keeps values of the library; reading and writing them. All unsafe code of
//! this crate is here, besides the names that it exports.
//!
//! What is unsafe is what the header asks of C: that a value has been made before it is used, that a list has as many
//! values as it says and stays where it is, and that what is written does not overlap what is read.

#![expect(unsafe_code, reason = "C says which pointers are valid, and what it has made")]

use crate::number::{Number, Of, i16f16};
use crate::status::{Failed, Outcome, raylet_error, raylet_status};
use crate::value::raylet_hit;
use core::marker::PhantomData;
use core::mem::{MaybeUninit, offset_of};
use fixed::types::I16F16;
use raylet::hierarchy::Node;
use raylet::{Crossing, Frame, HalfSpace, Hit, Part, Ray, Shape, Shaped, Shapes, Surface};

// `Chosen`, as the build chose.
include!(concat!(env!("OUT_DIR"), "/chosen.rs"));

/// Storage of which C knows the size and the alignment alone.
pub trait Stored {
    /// What is in it.
    type Value;
}

/// A solid or an open surface, placed in the world. It is a value: it may be copied, and needs no release.
#[repr(C)]
pub struct raylet_shape<N> {
    /// Not to be read or written.
    pub opaque: [u64; 16],
    _of: PhantomData<N>,
}

/// A position and three axes at right angles, which place a shape.
#[repr(C)]
pub struct raylet_frame<N> {
    /// Not to be read or written.
    pub opaque: [u64; 6],
    _of: PhantomData<N>,
}

/// A ray: an origin, a direction, a range of `t`, and the surface that it departs from, if any.
#[repr(C)]
pub struct raylet_ray<N> {
    /// Not to be read or written.
    pub opaque: [u64; 5],
    _of: PhantomData<N>,
}

/// The surface of a shape at a hit, from which point, normal, coordinates and tangents are computed.
#[repr(C)]
pub struct raylet_surface<N> {
    /// Not to be read or written.
    pub opaque: [u64; 22],
    _of: PhantomData<N>,
}

/// A half-space, of which polyhedra are made.
#[repr(C)]
pub struct raylet_half_space<N> {
    /// Not to be read or written.
    pub opaque: [u64; 3],
    _of: PhantomData<N>,
}

/// A node of a hierarchy of many shapes.
#[repr(C)]
pub struct raylet_node<N> {
    /// Not to be read or written.
    pub opaque: [u64; 4],
    _of: PhantomData<N>,
}

/// Many shapes with a hierarchy of boxes around them. The list and the nodes must stay where they are, unchanged,
/// as long as it is used.
#[repr(C)]
pub struct raylet_shapes<N> {
    /// Not to be read or written.
    pub opaque: [u64; 6],
    _of: PhantomData<N>,
}

impl<N: Number> Stored for raylet_shape<N> {
    type Value = Shape<Of<N>, Chosen>;
}
impl<N: Number> Stored for raylet_frame<N> {
    type Value = Frame<Of<N>>;
}
impl<N: Number> Stored for raylet_ray<N> {
    type Value = Ray<Of<N>>;
}
impl<N: Number> Stored for raylet_surface<N> {
    type Value = Surface<Of<N>, Chosen>;
}
impl<N: Number> Stored for raylet_half_space<N> {
    type Value = HalfSpace<Of<N>>;
}
impl<N: Number> Stored for raylet_node<N> {
    type Value = Node<Of<N>>;
}
impl<N: Number> Stored for raylet_shapes<N> {
    type Value = Shapes<'static, Of<N>, raylet_shape<N>>;
}

impl<N: Number> Shaped<Of<N>> for raylet_shape<N> {
    type Kinds = Chosen;

    fn shape(&self) -> &Shape<Of<N>, Chosen> {
        value(self)
    }
}

/// The value in a storage that C has filled by a function of this library.
pub fn value<T: Stored>(storage: &T) -> &T::Value {
    const { assert!(size_of::<T::Value>() <= size_of::<T>() && align_of::<T::Value>() <= align_of::<T>()) }
    // SAFETY: size and alignment are checked above, and the header says that a value must have been made before it is
    // used: `put` has written it.
    unsafe { &*core::ptr::from_ref(storage).cast() }
}

/// A pointer is null. The compiler must not know the code, or it loads it before it looks at the pointers.
#[cold]
#[inline(never)]
pub fn null() -> Failed {
    core::hint::black_box(Failed::of(raylet_error::RAYLET_ERROR_NULL))
}

/// What a pointer points at; fails if it is null.
pub fn given<T>(pointer: Option<&T>) -> Result<&T, Failed> {
    pointer.ok_or_else(null)
}

/// The value in a storage; fails if the pointer is null.
pub fn get<T: Stored>(storage: Option<&T>) -> Result<&T::Value, Failed> {
    given(storage).map(value)
}

/// Stores a value, if it was made.
pub fn put<T: Stored>(
    storage: Option<&mut MaybeUninit<T>>,
    made: impl FnOnce() -> Result<T::Value, Failed>,
) -> Outcome {
    const { assert!(size_of::<T::Value>() <= size_of::<T>() && align_of::<T::Value>() <= align_of::<T>()) }
    let storage = storage.ok_or_else(null)?;
    let made = made()?;
    // SAFETY: the pointer is to storage that is large enough, and aligned as the value.
    unsafe { storage.as_mut_ptr().cast::<T::Value>().write(made) };
    Ok(0)
}

/// Writes a result, if there is one and the pointer is not null.
pub fn write<T>(place: Option<&mut MaybeUninit<T>>, made: impl FnOnce() -> Result<T, Failed>) -> Outcome {
    let place = place.ok_or_else(null)?;
    place.write(made()?);
    Ok(0)
}

// A hit of the library is written where C reads it, which takes three instructions less on a Cortex-M3 than to convert
// it. The compiler gives both one layout, or this does not compile.
const _: () = {
    const fn has_one_layout<S, N>(hit: Option<Hit<S>>) -> raylet_hit<N> {
        assert!(size_of::<Option<Hit<S>>>() == size_of::<raylet_hit<N>>());
        assert!(align_of::<Option<Hit<S>>>() <= align_of::<raylet_hit<N>>());
        // SAFETY: both have one size, and the members are compared below.
        unsafe { core::mem::transmute_copy(&MaybeUninit::new(hit)) }
    }
    let in_f32 = has_one_layout::<f32, f32>(Some(Hit { t: 2.0, part: Part::Top, crossing: Crossing::Exit }));
    assert!(in_f32.t == 2.0 && in_f32.part == 2 && in_f32.crossing == 1);
    let t = I16F16::from_bits(7);
    let in_i16f16 = has_one_layout::<I16F16, i16f16>(Some(Hit { t, part: Part::Top, crossing: Crossing::Touch }));
    assert!(in_i16f16.t == 7 && in_i16f16.part == 2 && in_i16f16.crossing == 2);
    assert!(crossing_of_none::<f32, f32>() == 3 && crossing_of_none::<I16F16, i16f16>() == 3);
};

/// What stands in the place of the crossing if there is no hit.
const fn crossing_of_none<S, N>() -> u8 {
    let none = MaybeUninit::new(None::<Hit<S>>);
    // SAFETY: the place is in the value, and this does not compile if `None` leaves it uninitialised.
    unsafe { (&raw const none).cast::<u8>().add(offset_of!(raylet_hit<N>, crossing)).read() }
}

/// Writes a hit, if there is one: 1, or 0. Without one the place means nothing.
#[inline(always)]
pub fn put_hit<N: Number>(
    place: &mut MaybeUninit<raylet_hit<N>>,
    nearest: impl FnOnce() -> Option<Hit<Of<N>>>,
) -> raylet_status {
    let place = place.as_mut_ptr();
    // SAFETY: the place has the size and the alignment of the value, which has been written when its crossing is read.
    unsafe {
        place.cast::<Option<Hit<Of<N>>>>().write(nearest());
        // Read again: otherwise the compiler cuts it out of the copied words, which takes up to 4 instructions (M0+).
        let crossing = (&raw const (*place).crossing).read_volatile();
        // That of no hit is the largest. On an RV32IMC this takes an instruction less than whether it is another one.
        (crossing < const { crossing_of_none::<Of<N>, N>() }).into()
    }
}

/// A list of C, which must stay as it is.
pub fn list<'a, T>(first: *const T, count: usize) -> Result<&'a [T], Failed> {
    if count == 0 {
        return Ok(&[]);
    }
    if first.is_null() {
        return Err(null());
    }
    // SAFETY: the header says that there are `count` values, which do not change while they are used.
    Ok(unsafe { core::slice::from_raw_parts(first, count) })
}

/// The same of a list of values of the library, each as long as its storage.
pub fn values<'a, T: Stored>(first: *const T, count: usize) -> Result<&'a [T::Value], Failed> {
    const { assert!(size_of::<T::Value>() == size_of::<T>() && align_of::<T::Value>() <= align_of::<T>()) }
    let list = list(first, count)?;
    // SAFETY: as in `value`, for each of them.
    Ok(unsafe { core::slice::from_raw_parts(list.as_ptr().cast(), list.len()) })
}

/// Room for a list of values, which is C's until it calls, and the library's afterwards. It may not be initialised.
pub fn room<'a, T>(first: *mut T, count: usize) -> Result<&'a mut [MaybeUninit<T>], Failed> {
    if count == 0 {
        return Ok(&mut []);
    }
    if first.is_null() {
        return Err(null());
    }
    // SAFETY: the header says that there is room for `count` values.
    Ok(unsafe { core::slice::from_raw_parts_mut(first.cast(), count) })
}

/// Nodes, made empty first.
pub fn nodes<'a, N: Number>(first: *mut raylet_node<N>, count: usize) -> Result<&'a mut [Node<Of<N>>], Failed> {
    const { assert!(size_of::<Node<Of<N>>>() == size_of::<raylet_node<N>>()) }
    let room = room(first, count)?;
    // SAFETY: the size is checked above; a node is written before it is read.
    let nodes: &mut [MaybeUninit<Node<Of<N>>>] =
        unsafe { core::slice::from_raw_parts_mut(room.as_mut_ptr().cast(), room.len()) };
    for node in &mut *nodes {
        node.write(Node::EMPTY);
    }
    // SAFETY: all are initialised.
    Ok(unsafe { core::slice::from_raw_parts_mut(nodes.as_mut_ptr().cast(), nodes.len()) })
}

/// A list of pairs of numbers, as the library has them.
pub fn pairs<'a, N: Number>(first: *const N, count: usize) -> Result<&'a [[Of<N>; 2]], Failed> {
    const { assert!(size_of::<Of<N>>() == size_of::<N>() && align_of::<Of<N>>() == align_of::<N>()) }
    let list = list(first.cast::<[N; 2]>(), count)?;
    // SAFETY: a number of the library is one of C: a float, or an integer of which all bits are valid.
    Ok(unsafe { core::slice::from_raw_parts(list.as_ptr().cast(), list.len()) })
}

/// Storage that is initialised, as storage that may not be.
pub fn maybe<T>(storage: &mut T) -> &mut MaybeUninit<T> {
    // SAFETY: both have one layout, and whoever writes through it writes a value.
    unsafe { &mut *core::ptr::from_mut(storage).cast() }
}
