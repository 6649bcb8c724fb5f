//! The grid of fixed point: from stored numbers to raw integers and back.

use crate::scalar::integers;
use crate::scalar::{
    Attempt, FinerLine, GridScalar, InCuboid, InSide, LocalLine, NappeOutline, Scalar, found, including::narrowed,
};
use core::cmp::Ordering;
use fixed::types::extra::{LeEqU32, LeEqU64, U32};
use fixed::{FixedI32, FixedI64};

/// The error of an end is at most a unit, that of the height there less than two: rounding may decide the order of two
/// that are less than 2 to the power of this apart.
const DOUBTFUL_BITS: u32 = 2;

/// Defines it for the types of one width, with the functions that only this width has.
macro_rules! fast {
    ($Fixed:ident, $LeEq:ident, $raw:ty, $($kernels:ident)::+, [$($strict:ident)?], { $($own:tt)* }) => {
        impl<F: $LeEq + Send + Sync + 'static> GridScalar for $Fixed<F> {
        $($own)*
        #[inline(always)]
        fn ball(line: LocalLine<Self>, r: Self, by_moment: bool, is_strict: bool) -> Attempt<[Self; 2]> {
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
        fn ball_ahead(line: LocalLine<Self>, r: Self, by_moment: bool) -> Attempt<()> {
            let (o, d, r) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits), r.to_bits());
            if by_moment {
                found!($($kernels)::+::ByMoment::new(o, line.extra_bits, d, r)).meets_ahead()
            } else {
                found!($($kernels)::+::ByApproach::new(o, line.extra_bits, d, r)).meets_ahead()
            }
        }
        #[inline(always)]
        fn tube(line: LocalLine<Self>, r: Self) -> Attempt<InSide<Self>> {
            let (o, d, r) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits), r.to_bits());
            let ends = found!($($kernels)::+::tube(o, line.extra_bits, d, r $(, line.$strict)?));
            Attempt::Hit(InSide { ends: ends.map(Self::from_bits), beyond: [Self::from_bits(0); 2] })
        }
        #[inline(always)]
        fn exit_from_round(line: &LocalLine<Self>, is_ball: bool) -> Attempt<Self> {
            if line.start != <Self as Scalar>::ZERO {
                return Attempt::Unsure;
            }
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let exit = found!($($kernels)::+::exit_from_round(o, line.extra_bits, d, is_ball));
            Attempt::Hit(Self::from_bits(exit))
        }
        #[inline(always)]
        fn exit_from_nappe(
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
        fn seams(line: LocalLine<Self>, t: Self, height: Self) -> Attempt<Ordering> {
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
        fn lowered(line: LocalLine<Self>, y: Self) -> Attempt<LocalLine<Self>> {
            let [ox, oy, oz] = line.origin;
            let lowered = found!($($kernels)::+::lowered(oy.to_bits(), line.extra_bits, y.to_bits()));
            Attempt::Hit(LocalLine { origin: [ox, Self::from_bits(lowered), oz], ..line })
        }
        #[inline(always)]
        fn crossings(line: LocalLine<Self>, y: [Self; 2]) -> Attempt<[Self; 2]> {
            let (oy, dy) = (line.origin[1].to_bits(), line.direction[1].to_bits());
            let [first, second] = found!($($kernels)::+::crossings(oy, line.extra_bits, dy, y.map(Self::to_bits)));
            Attempt::Hit([Self::from_bits(first), Self::from_bits(second)])
        }
        #[inline(always)]
        fn nappe(
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
        fn double_cone(line: LocalLine<Self>, slope: Self) -> Attempt<([Self; 2], bool)> {
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let one = match (1 as $raw).checked_shl(F::U32) {
                Some(one) if one > 0 => one,
                _ => return Attempt::Unsure,
            };
            let (ends, beyond) = found!($($kernels)::+::double_cone(o, line.extra_bits, d, [slope.to_bits(), one] $(, line.$strict)?));
            Attempt::Hit((ends.map(Self::from_bits), beyond))
        }
        #[inline(always)]
        fn disc(line: LocalLine<Self>, r: Self) -> Attempt<Self> {
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            Attempt::Hit(Self::from_bits(found!($($kernels)::+::disc(o, line.extra_bits, d, r.to_bits()))))
        }
        #[inline(always)]
        fn rectangle(line: LocalLine<Self>, half: [Self; 2]) -> Attempt<Self> {
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let t = found!($($kernels)::+::rectangle(o, line.extra_bits, d, half.map(Self::to_bits)));
            Attempt::Hit(Self::from_bits(t))
        }
        #[inline(always)]
        fn cuboid(line: &LocalLine<Self>, half: [Self; 3]) -> Attempt<InCuboid<Self>> {
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let since = line.since.map(Self::to_bits);
            let InCuboid { ends, axes } =
                found!(integers::cuboid(o, line.extra_bits, d, half.map(Self::to_bits), since));
            Attempt::Hit(InCuboid { ends: ends.map(Self::from_bits), axes })
        }
        #[inline(always)]
        fn exit_from_cuboid(line: &LocalLine<Self>, half: [Self; 3]) -> Attempt<(Self, usize)> {
            if line.start != <Self as Scalar>::ZERO {
                return Attempt::Unsure;
            }
            let (o, d) = (line.origin.map(Self::to_bits), line.direction.map($Fixed::to_bits));
            let (t, axis) =
                found!(integers::exit_from_cuboid(o, line.extra_bits, d, half.map(Self::to_bits)));
            Attempt::Hit((Self::from_bits(t), axis))
        }
        #[inline(always)]
        fn turned(
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
        fn stretched(
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
        fn along_ray(line: &FinerLine<Self>, t: Self) -> Option<Self> {
            $($kernels)::+::along_ray(line.inverse_length, line.line.start.to_bits(), t.to_bits()).map(Self::from_bits)
        }
        }
    };
}

fast!(FixedI32, LeEqU32, i32, integers, [is_strict], {
    type Wider = FixedI64<U32>;
    // With fewer fraction bits the coordinates of usual scenes leave 32 bits enough room. With more the wider type has
    // too few finer bits.
    const WIDENS: bool = F::U32 >= 20 && F::U32 <= 28;
    #[inline]
    fn narrowed(value: Self::Wider) -> Self {
        narrowed(value)
    }
    #[inline(always)]
    fn fit(line: &mut LocalLine<Self>, bounding_radius: Self) {
        let fitting = integers::fitting(bounding_radius.to_bits());
        if line.extra_bits > fitting {
            let origin = integers::coarser(line.origin.map(Self::to_bits), (line.extra_bits - fitting) as u32);
            (line.origin, line.extra_bits) = (origin.map(Self::from_bits), fitting);
        }
    }
    #[inline(always)]
    fn triangle(line: LocalLine<Self>, vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)> {
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
    type Wider = Self;
    #[inline(always)]
    fn narrowed(value: Self) -> Self {
        value
    }
    /// A line has as many extra bits as there is room for.
    #[inline(always)]
    fn fit(_: &mut LocalLine<Self>, _: Self) {}
    #[inline(always)]
    fn triangle(line: LocalLine<Self>, vertices: [[Self; 3]; 3]) -> Attempt<(Self, bool)> {
        let (o, d) = (line.origin.map(Self::to_bits), line.direction.map(FixedI64::to_bits));
        let vertices = vertices.map(|vertex| vertex.map(Self::to_bits));
        let (t, from_front) = found!(integers::wide::triangle(o, line.extra_bits, d, vertices));
        Attempt::Hit((Self::from_bits(t), from_front))
    }
});
