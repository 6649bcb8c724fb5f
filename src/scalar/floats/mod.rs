//! The fast path of floats.
//!
//! Where nothing cancels, the textbook formulas are accurate to a few units in the last place. A guard, which is a comparison, checks each
//! difference for cancellation. Rays that fail a guard (grazing rays, starts next to a surface, sizes whose powers overflow or underflow) are
//! [`Attempt::Unsure`]. They are tried again along a more accurate line, and, if a guard still fails, in double-word numbers.
//!
//! Numbers are not scaled. Of the plain formulas only two values are compensated, where that is cheaper than double-word numbers: the constant
//! term of a sphere next to the start, and the leading coefficient of a cone next to a generator.
//!
//! If a line starts far away or is transformed to a frame, its origin is moved to a point next to the solid. The line then has an error of some
//! roundings of the distance moved, which the guards take into account.
//!
//! | file | what it holds |
//! |---|---|
//! | `guards` | the guards, and the local lines |
//! | `second` | the local lines of the second attempt |
//! | `round` | spheres and cylinders |
//! | `cone` | cones |
//! | `doubled` | round solids in double-word numbers |
//! | `doubled_triangle` | triangles in double-word numbers |
//! | `departing` | lines that depart from a surface |
//! | `cuboid` | cuboids |
//! | `flat` | planes, discs, rectangles, triangles |

#[macro_use]
mod guards;
#[macro_use]
mod second;
#[macro_use]
mod round;
#[macro_use]
mod cone;
#[macro_use]
mod doubled;
#[macro_use]
mod doubled_triangle;
#[macro_use]
mod departing;
#[macro_use]
mod cuboid;
#[macro_use]
mod flat;

use crate::scalar::{
    Attempt, FastPath, InCuboid, InSide, LocalLine, LowWords, NappeOutline, Real, found, slabs::Slabs,
};
use core::cmp::Ordering;

macro_rules! floats {
    (
        $name:ident, $Float:ident, $bits:ty, $bias:literal, $mantissa:literal, sqrt: $sqrt:path,
        may_have_spare_bits: $spare:literal
    ) => {
        pub(super) mod $name {
            use crate::number::Ring;
            use crate::scalar::attempt::within_edges;
            use crate::scalar::twofold::Twofold;
            use crate::scalar::{Attempt, InCuboid, InSide, LocalLine, LowWords, Real, found};
            use core::cmp::Ordering;

            guards!($Float, $bits, $bias, $mantissa, sqrt: $sqrt, may_have_spare_bits: $spare);
            second!($Float);
            round!($Float, sqrt: $sqrt);
            cone!($Float, sqrt: $sqrt);
            doubled!($Float, sqrt: $sqrt);
            doubled_triangle!($Float);
            departing!($Float);
            cuboid!($Float);
            flat!($Float);
        }

        impl FastPath for $Float {
            #[inline(always)]
            fn fast_ball(line: LocalLine<Self>, r: Self, by_moment: bool, _: bool) -> Attempt<[Self; 2]> {
                if line.is_doubled {
                    return $name::ball_doubled(&line, r);
                }
                if by_moment {
                    return $name::ball(line, r);
                }
                let (k, discriminant) = found!($name::closest_approach(line, r));
                if discriminant == 0.0 {
                    return Attempt::Unsure;
                }
                let root = $sqrt(discriminant);
                Attempt::Hit([-k - root, root - k])
            }
            #[inline(always)]
            fn fast_ball_ahead(line: LocalLine<Self>, r: Self, by_moment: bool) -> Attempt<()> {
                if by_moment {
                    return $name::ball_ahead(line, r);
                }
                let (k, discriminant) = found!($name::closest_approach(line, r));
                if discriminant == 0.0 {
                    return Attempt::Unsure;
                }
                // The line leads away from the closest point: the far end decides.
                if k <= 0.0 || $sqrt(discriminant) >= k { Attempt::Hit(()) } else { Attempt::Miss }
            }
            #[inline(always)]
            fn fast_tube(line: LocalLine<Self>, r: Self) -> Attempt<InSide<Self>> {
                $name::tube(line, r)
            }
            #[inline(always)]
            fn fast_nappe(
                line: LocalLine<Self>,
                NappeOutline { base, top, height }: NappeOutline<Self>,
            ) -> Attempt<InSide<Self>> {
                $name::nappe(line, [base, top, height.unwrap_or(1.0)])
            }
            #[inline(always)]
            fn fast_double_cone(line: LocalLine<Self>, slope: Self) -> Attempt<([Self; 2], bool)> {
                $name::double_cone(line, slope)
            }
            #[inline(always)]
            fn fast_exit_from_round(line: &LocalLine<Self>, is_ball: bool) -> Attempt<Self> {
                $name::exit_from_round(line, is_ball)
            }
            #[inline(always)]
            fn fast_exit_from_nappe(
                line: &LocalLine<Self>,
                NappeOutline { base, top, height }: NappeOutline<Self>,
            ) -> Attempt<Self> {
                $name::exit_from_nappe(line, [base, top, height.unwrap_or(1.0)])
            }
            #[inline(always)]
            fn fast_crossings(line: LocalLine<Self>, y: [Self; 2]) -> Attempt<([Self; 2], [Self; 2])> {
                $name::crossings(line, y)
            }
            #[inline(always)]
            fn passes_axis(o: [Self; 3], d: [Self; 3], position: [Self; 3], axis: [Self; 3], r: Self) -> bool {
                $name::passes_axis(o, d, position, axis, r)
            }
            #[inline(always)]
            fn fast_turned(
                o: [Self; 3],
                d: [Self; 3],
                position: [Self; 3],
                axes: [[Self; 3]; 3],
            ) -> Option<LocalLine<Self>> {
                Some($name::turned(o, d, position, axes))
            }
            #[inline(always)]
            fn fast_stretched(
                o: [Self; 3],
                d: [Self; 3],
                position: [Self; 3],
                rows: [([Self; 3], i32); 3],
            ) -> Option<LocalLine<Self>> {
                $name::stretched(o, d, position, rows)
            }
            #[inline(always)]
            fn is_far(o: [Self; 3], d: [Self; 3]) -> bool {
                $name::is_far(o, d)
            }
            #[inline(always)]
            fn fast_from_afar(o: [Self; 3], d: [Self; 3]) -> Option<LocalLine<Self>> {
                Some($name::from_afar(o, d))
            }
            #[inline(always)]
            fn fast_closer(o: [Self; 3], d: [Self; 3], base: [Self; 3]) -> Option<LocalLine<Self>> {
                $name::closer(o, d, base)
            }
            #[inline(always)]
            fn fast_turned_again(
                o: [Self; 3],
                d: [Self; 3],
                position: [Self; 3],
                axes: [[Self; 3]; 3],
                base: [Self; 3],
                near: Self,
            ) -> Option<LocalLine<Self>> {
                $name::turned_again(o, d, position, axes, base, near)
            }
            #[inline(always)]
            fn fast_stretched_again(
                o: [Self; 3],
                d: [Self; 3],
                position: [Self; 3],
                rows: [([Self; 3], i32); 3],
                base: [Self; 3],
                near: Self,
            ) -> Option<LocalLine<Self>> {
                $name::stretched_again(o, d, position, rows, base, near)
            }
            fn fast_moved_back(line: &LocalLine<Self>) -> LocalLine<Self> {
                $name::moved_back(line)
            }
            #[inline(always)]
            fn fast_disc(line: LocalLine<Self>, r: Self) -> Attempt<Self> {
                $name::disc(line, r)
            }
            #[inline(always)]
            fn fast_rectangle(line: LocalLine<Self>, half: [Self; 2]) -> Attempt<Self> {
                $name::rectangle(line, half)
            }
            #[inline(always)]
            fn fast_cuboid(line: &LocalLine<Self>, half: [Self; 3]) -> Attempt<InCuboid<Self>> {
                $name::cuboid(line, half)
            }
            #[inline(always)]
            fn fast_exit_from_cuboid(line: &LocalLine<Self>, half: [Self; 3]) -> Attempt<(Self, usize)> {
                $name::exit_from_cuboid(line, half)
            }
            #[inline(always)]
            fn fast_triangle(line: LocalLine<Self>, vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)> {
                $name::triangle(line, vertices)
            }
            #[inline(always)]
            fn fast_triangle_doubled(line: &LocalLine<Self>, vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)> {
                $name::triangle_doubled(line, vertices)
            }
            #[inline(always)]
            fn fast_seams(line: LocalLine<Self>, t: Self, height: Self) -> Attempt<Ordering> {
                $name::between_seams(line, t, height)
            }
            #[inline(always)]
            fn fast_lowered(line: LocalLine<Self>, y: Self) -> Attempt<LocalLine<Self>> {
                let ([ox, oy, oz], [rx, ry, rz]) = (line.origin, line.low_words.origin);
                // Next to the surface the rounding error of this difference matters.
                let [low, rest] = oy.plus_with_rest(-y);
                let [low, rest] = low.plus_with_rest(rest + ry);
                let [off, along_off] = line.low_words.off;
                let low_words = LowWords { origin: [rx, rest, rz], off: [off + $Float::abs(y), along_off], ..line.low_words };
                Attempt::Hit(LocalLine { origin: [ox, low, oz], low_words, ..line })
            }
            #[inline(always)]
            fn are_close(line: &LocalLine<Self>, a: Self, b: Self, off: Self) -> bool {
                $name::are_close(line, a, b, off)
            }
            #[inline(always)]
            fn is_good(line: &LocalLine<Self>, t: Self, off: Self) -> bool {
                $name::is_good(line, t, off)
            }
            type Slabs = Slabs<$Float, $Float>;
            #[inline(always)]
            fn slabs(o: [Self; 3], d: [Self; 3]) -> Self::Slabs {
                Slabs::<$Float, $Float>::new(o, d)
            }
            #[inline(always)]
            fn misses_box(slabs: &Self::Slabs, range: [Self; 2], centre: [Self; 3], half: [Self; 3]) -> bool {
                slabs.misses(range, centre, half)
            }
        }
    };
}
floats!(fast_f32, f32, u32, 127, 23, sqrt: crate::scalar::square_root::square_root_f32, may_have_spare_bits: false);
floats!(fast_f64, f64, u64, 1023, 52, sqrt: libm::sqrt, may_have_spare_bits: true);
