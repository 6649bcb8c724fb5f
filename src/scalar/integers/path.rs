//! The grid of fixed point: from stored numbers to raw integers and back.

use crate::scalar::integers;
use crate::scalar::{
    Attempt, FastPath, FinerLine, InCuboid, InSide, LocalLine, NappeOutline, Scalar, found, slabs::Slabs,
};
use core::cmp::Ordering;
use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedI64};

/// The error of an end is at most a unit, that of the height there less than two: rounding may decide the order of two
/// that are less than 2 to the power of this apart.
const DOUBTFUL_BITS: u32 = 2;

/// Defines it for the types of one width, with the functions that only this width has.
macro_rules! fast {
    ($Fixed:ident, $LeEq:ident, $raw:ty, $($kernels:ident)::+, [$($strict:ident)?], { $($own:tt)* }) => {
        impl<F: $LeEq + Send + Sync + 'static> FastPath for $Fixed<F> {
        $($own)*
        #[inline(always)]
        fn fast_ball(line: LocalLine<Self>, r: Self, by_moment: bool, is_strict: bool) -> Attempt<[Self; 2]> {
            let line = LocalLine { is_strict, ..line };
            let (o, d, r) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits), r.to_bits());
            let [low, high] = if by_moment {
                found!(found!($($kernels)::+::ByMoment::new(o, line.extra_bits, d, r)).ends($(line.$strict)?))
            } else {
                found!(found!($($kernels)::+::ByApproach::new(o, line.extra_bits, d, r)).ends())
            };
            Attempt::Hit([Self::from_bits(low), Self::from_bits(high)])
        }
        #[inline(always)]
        fn fast_ball_ahead(line: LocalLine<Self>, r: Self, by_moment: bool) -> Attempt<()> {
            let (o, d, r) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits), r.to_bits());
            if by_moment {
                found!($($kernels)::+::ByMoment::new(o, line.extra_bits, d, r)).meets_ahead()
            } else {
                found!($($kernels)::+::ByApproach::new(o, line.extra_bits, d, r)).meets_ahead()
            }
        }
        #[inline(always)]
        fn fast_tube(line: LocalLine<Self>, r: Self) -> Attempt<InSide<Self>> {
            let (o, d, r) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits), r.to_bits());
            let ends = found!($($kernels)::+::tube(o, line.extra_bits, d, r $(, line.$strict)?));
            Attempt::Hit(InSide { ends: ends.map(Self::from_bits), beyond: [Self::from_bits(0); 2] })
        }
        #[inline(always)]
        fn fast_exit_from_round(line: &LocalLine<Self>, is_ball: bool) -> Attempt<Self> {
            if line.start != <Self as Scalar>::ZERO {
                return Attempt::Unsure;
            }
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let exit = found!($($kernels)::+::exit_from_round(o, line.extra_bits, d, is_ball));
            Attempt::Hit(Self::from_bits(exit))
        }
        #[inline(always)]
        fn fast_exit_from_nappe(
            line: &LocalLine<Self>,
            NappeOutline { base, top, height }: NappeOutline<Self>,
        ) -> Attempt<Self> {
            if line.start != <Self as Scalar>::ZERO {
                return Attempt::Unsure;
            }
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let height = height.map_or((1 as $raw).checked_shl(F::U32).unwrap_or(0), Self::to_bits);
            let height = if height > 0 { height } else { return Attempt::Unsure };
            let outline = [base.to_bits(), top.minus(base).to_bits(), height];
            let exit = found!($($kernels)::+::exit_from_nappe(o, line.extra_bits, d, outline $(, line.$strict)?));
            Attempt::Hit(Self::from_bits(exit))
        }
        #[inline(always)]
        fn fast_seams(line: LocalLine<Self>, t: Self, height: Self) -> Attempt<Ordering> {
            let (oy, dy) = (line.origin[1].to_bits(), line.direction[1].to_bits());
            let y = found!($($kernels)::+::height(oy, line.extra_bits, dy, t.to_bits()));
            let is_close = |height: $raw| y.abs_diff(height) >> DOUBTFUL_BITS == 0;
            if line.is_strict && (is_close(0) || is_close(height.to_bits())) {
                return Attempt::Unsure;
            }
            Attempt::Hit(if y < 0 {
                Ordering::Less
            } else if y > height.to_bits() {
                Ordering::Greater
            } else {
                Ordering::Equal
            })
        }
        #[inline(always)]
        fn are_close(line: &LocalLine<Self>, a: Self, b: Self) -> bool {
            line.is_strict && Self::are_doubtful(a, b)
        }
        #[inline(always)]
        fn are_doubtful(a: Self, b: Self) -> bool {
            a.to_bits().abs_diff(b.to_bits()) >> DOUBTFUL_BITS == 0
        }
        #[inline(always)]
        fn fast_lowered(line: LocalLine<Self>, y: Self) -> Attempt<LocalLine<Self>> {
            let [ox, oy, oz] = line.origin;
            let lowered = found!($($kernels)::+::lowered(oy.to_bits(), line.extra_bits, y.to_bits()));
            Attempt::Hit(LocalLine { origin: [ox, Self::from_bits(lowered), oz], ..line })
        }
        #[inline(always)]
        fn fast_crossings(line: LocalLine<Self>, y: [Self; 2]) -> Attempt<[Self; 2]> {
            let (oy, dy) = (line.origin[1].to_bits(), line.direction[1].to_bits());
            let [first, second] = found!($($kernels)::+::crossings(oy, line.extra_bits, dy, y.map(Self::to_bits)));
            Attempt::Hit([Self::from_bits(first), Self::from_bits(second)])
        }
        #[inline(always)]
        fn fast_nappe(
            line: LocalLine<Self>,
            NappeOutline { base, top, height }: NappeOutline<Self>,
        ) -> Attempt<InSide<Self>> {
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let height = height.map_or((1 as $raw).checked_shl(F::U32).unwrap_or(0), Self::to_bits);
            let height = if height > 0 { height } else { return Attempt::Unsure };
            let outline = [base.to_bits(), top.minus(base).to_bits(), height];
            let InSide { ends, beyond } =
                found!($($kernels)::+::nappe(o, line.extra_bits, d, outline $(, line.$strict)?));
            Attempt::Hit(InSide { ends: ends.map(Self::from_bits), beyond: beyond.map(Self::from_bits) })
        }
        #[inline(always)]
        fn fast_double_cone(line: LocalLine<Self>, slope: Self) -> Attempt<([Self; 2], bool)> {
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let one = match (1 as $raw).checked_shl(F::U32) {
                Some(one) if one > 0 => one,
                _ => return Attempt::Unsure,
            };
            let (ends, beyond) = found!($($kernels)::+::double_cone(o, line.extra_bits, d, [slope.to_bits(), one] $(, line.$strict)?));
            Attempt::Hit((ends.map(Self::from_bits), beyond))
        }
        #[inline(always)]
        fn fast_disc(line: LocalLine<Self>, r: Self) -> Attempt<Self> {
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            Attempt::Hit(Self::from_bits(found!($($kernels)::+::disc(o, line.extra_bits, d, r.to_bits()))))
        }
        #[inline(always)]
        fn fast_rectangle(line: LocalLine<Self>, half: [Self; 2]) -> Attempt<Self> {
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let t = found!($($kernels)::+::rectangle(o, line.extra_bits, d, half.map(Self::to_bits)));
            Attempt::Hit(Self::from_bits(t))
        }
        #[inline(always)]
        fn fast_cuboid(line: &LocalLine<Self>, half: [Self; 3]) -> Attempt<InCuboid<Self>> {
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let since = line.since.map(Self::to_bits);
            let InCuboid { ends, axes } =
                found!(integers::cuboid(o, line.extra_bits, d, half.map(Self::to_bits), since));
            Attempt::Hit(InCuboid { ends: ends.map(Self::from_bits), axes })
        }
        #[inline(always)]
        fn fast_exit_from_cuboid(line: &LocalLine<Self>, half: [Self; 3]) -> Attempt<(Self, usize)> {
            if line.start != <Self as Scalar>::ZERO {
                return Attempt::Unsure;
            }
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let (t, axis) =
                found!(integers::exit_from_cuboid(o, line.extra_bits, d, half.map(Self::to_bits)));
            Attempt::Hit((Self::from_bits(t), axis))
        }
        #[inline(always)]
        fn fast_turned(
            o: [Self; 3],
            d: [Self::Unit; 3],
            position: [Self; 3],
            axes: [[Self::Unit; 3]; 3],
        ) -> Option<LocalLine<Self>> {
            let (raw, position) = (o.map(Self::to_bits), position.map(Self::to_bits));
            let line =
                $($kernels)::+::turned(raw, position, axes.map(|axis| axis.map($Fixed::to_bits)), d.map($Fixed::to_bits))?;
            Some(LocalLine {
                origin: line.origin.map(Self::from_bits),
                extra_bits: line.extra_bits,
                direction: line.direction.map($Fixed::from_bits),
                start: Self::from_bits(line.start),
                is_coarse: line.extra_bits < $($kernels)::+::FINER,
                ..LocalLine::along(o, d, Self::from_bits(0))
            })
        }
        #[inline(always)]
        fn fast_stretched_finely(
            o: [Self; 3],
            d: [Self::Unit; 3],
            position: [Self; 3],
            rows: [([Self::Unit; 3], i32); 3],
            bounding_radius: Self,
        ) -> Option<FinerLine<Self>> {
            let (raw, position) = (o.map(Self::to_bits), position.map(Self::to_bits));
            let rows = rows.map(|(row, exponent)| (row.map($Fixed::to_bits), exponent));
            let line = $($kernels)::+::stretched(raw, d.map($Fixed::to_bits), position, rows, bounding_radius.to_bits())?;
            let (scale, inverse_length) = (line.scale, line.inverse_length);
            let line = LocalLine {
                origin: line.origin.map(Self::from_bits),
                extra_bits: line.extra_bits,
                direction: line.direction.map($Fixed::from_bits),
                start: Self::from_bits(line.start),
                ..LocalLine::along(o, d, Self::from_bits(0))
            };
            Some(FinerLine { line, scale, inverse_length })
        }
        #[inline(always)]
        fn fast_along_ray(line: &FinerLine<Self>, t: Self) -> Option<Self> {
            $($kernels)::+::along_ray(line.inverse_length, line.line.start.to_bits(), t.to_bits()).map(Self::from_bits)
        }
        type Slabs = Slabs<$raw, i32>;
        #[inline(always)]
        fn slabs(o: [Self; 3], d: [Self::Unit; 3]) -> Self::Slabs {
            Slabs::<$raw, i32>::new(o.map(Self::to_bits), d.map($Fixed::to_bits))
        }
        #[inline(always)]
        fn misses_box(slabs: &Self::Slabs, range: [Self; 2], centre: [Self; 3], half: [Self; 3]) -> bool {
            slabs.misses(range.map(Self::to_bits), centre.map(Self::to_bits), half.map(Self::to_bits))
        }
        }
    };
}

fast!(FixedI32, LeEqU32, i32, integers, [is_strict], {
    #[inline(always)]
    fn passes_axis(o: [Self; 3], d: [Self::Unit; 3], position: [Self; 3], axis: [Self::Unit; 3], r: Self) -> bool {
        let from = |i: usize| o[i].to_bits().wrapping_sub(position[i].to_bits());
        let (d, axis) = (d.map(FixedI32::to_bits), axis.map(FixedI32::to_bits));
        integers::passes([from(0), from(1), from(2)], d, axis, r.to_bits())
    }
    #[inline(always)]
    fn fast_fit(line: &mut LocalLine<Self>, bounding_radius: Self) {
        let fitting = integers::fitting(bounding_radius.to_bits());
        if line.extra_bits > fitting {
            let origin = integers::coarser(line.origin.map(Self::to_bits), (line.extra_bits - fitting) as u32);
            (line.origin, line.extra_bits) = (origin.map(Self::from_bits), fitting);
        }
    }
    #[inline(always)]
    fn fast_direction(v: [Self; 3]) -> Attempt<[Self::Unit; 3]> {
        Attempt::Hit(found!(integers::direction(v.map(Self::to_bits))).map(FixedI32::from_bits))
    }
    #[inline(always)]
    fn fast_triangle(line: LocalLine<Self>, vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)> {
        let (o, d) = (line.origin.map(Self::to_bits), line.direction.map(FixedI32::to_bits));
        let vertices = vertices.map(|vertex| vertex.map(Self::to_bits));
        let found = match integers::triangle(o, line.extra_bits, d, vertices) {
            // There may be too little room for the origin beside the vertices.
            Attempt::Unsure if line.extra_bits > integers::FINER => {
                let origin = integers::coarser(o, (line.extra_bits - integers::FINER) as u32);
                integers::triangle(origin, integers::FINER, d, vertices)
            }
            found => found,
        };
        let (t, from_front) = found!(found);
        Attempt::Hit((Self::from_bits(t), from_front))
    }
});
fast!(FixedI64, LeEqU64, i64, integers::wide, [], {
    #[inline(always)]
    fn passes_axis(o: [Self; 3], d: [Self::Unit; 3], position: [Self; 3], axis: [Self::Unit; 3], r: Self) -> bool {
        let from = |i: usize| o[i].to_bits().wrapping_sub(position[i].to_bits());
        let (d, axis) = (d.map(|c| (c.to_bits() >> 32) as i32), axis.map(|c| (c.to_bits() >> 32) as i32));
        integers::passes_wide([from(0), from(1), from(2)], d, axis, r.to_bits())
    }
    #[inline(always)]
    fn fast_triangle(line: LocalLine<Self>, vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)> {
        let (o, d) = (line.origin.map(Self::to_bits), line.direction.map(FixedI64::to_bits));
        let vertices = vertices.map(|vertex| vertex.map(Self::to_bits));
        let (t, from_front) = found!(integers::wide::triangle(o, line.extra_bits, d, vertices));
        Attempt::Hit((Self::from_bits(t), from_front))
    }
});
