use super::*;
use cone::{Nappe, double_cone, nappe};
use flat::disc;

/// For all sizes nothing overflows, and hits lie on the surface; for lines from far and near, in the world and in
/// frames.
#[test]
fn cones_discs_and_triangles_of_every_size_are_met_on_their_surfaces() {
    met_on_surfaces::<i32>();
    met_on_surfaces::<i64>();
}

fn met_on_surfaces<N: Tested>() {
    let (fraction, least) = (u64::from(N::FRACTION), u64::from(N::FRACTION / 3));
    let one = 2.0_f64.powi(N::FRACTION as i32);
    let precision = 1e-12 + 4.0 / one;
    let mut random = Random(7);
    let (mut cones, mut discs, mut triangles) = (0, 0, 0);
    for index in 0..4 * LINES {
        let extra_bits = if index % 2 == 0 { 0 } else { N::FINER };
        // Of similar sizes, or of any sizes.
        let bits = least + random.below(fraction - least);
        let size =
            |random: &mut Random| if index % 3 == 0 { random.sized(fraction) } else { random.sized(bits.max(4)) };
        let sizes = [size(&mut random), size(&mut random), size(&mut random)];
        let vertices = [(); 3].map(|()| [(); 3].map(|()| coordinate(&mut random, bits)));
        let o =
            [(); 3].map(|()| coordinate(&mut random, if index % 5 == 0 { fraction } else { (bits + 3).min(fraction) }));
        let unit_of = 2.0_f64.powi(-extra_bits);
        let from = o.map(|c| c as f64 * unit_of);
        // Approximately towards the solid.
        let aim = [0, 1, 2]
            .map(|i| vertices[index as usize % 3][i] as f64 / 3.0 - from[i] + random.either() * sizes[0] as f64);
        let d = unit(aim).map(|c| (c * one) as i64);
        let e = d.map(|c| c as f64 / one);
        let at = |t: i64| [0, 1, 2].map(|i| from[i] + t as f64 * e[i]);
        let off = |t: i64| precision * (from.iter().map(|c| c.abs()).sum::<f64>() + t as f64) + 8.0;
        if let Attempt::Hit(t) = disc(o.map(N::of), extra_bits, d.map(N::of), N::of(sizes[0])) {
            let t: i64 = t.into();
            discs += 1;
            let [x, y, z] = at(t);
            assert!(
                y.abs() <= off(t.abs()) && x.hypot(z) <= sizes[0] as f64 + 2.0 * off(t.abs()) / e[1].abs(),
                "{o:?} {d:?} {sizes:?}"
            );
        }
        let corners = vertices.map(|vertex| vertex.map(N::of));
        if let Attempt::Hit((t, _)) = triangle(o.map(N::of), extra_bits, d.map(N::of), corners) {
            let t: i64 = t.into();
            triangles += 1;
            let p = at(t);
            let [a, b, c] = vertices.map(|v| [0, 1, 2].map(|i| v[i] as f64 - p[i]));
            let cross = |[x, y, z]: [f64; 3], [u, v, w]: [f64; 3]| [y * w - z * v, z * u - x * w, x * v - y * u];
            let normal = cross([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
            let height: f64 = unit(normal).iter().zip(a).map(|(n, a)| n * a).sum();
            let largest = a.iter().chain(&b).chain(&c).fold(0.0_f64, |all, c| all.max(c.abs()));
            assert!(height.abs() <= off(t.abs()) + 1e-3 * largest, "{o:?} {d:?} {vertices:?}: {height}");
        }
        let [r, g, h] = [sizes[0], if index % 7 == 0 { -sizes[1] } else { sizes[1] }, sizes[2]];
        let on_cone = |t: i64, r: i64| {
            let [x, y, z] = at(t);
            let (ratio, off) = (g as f64 / h as f64, off(t.abs()));
            let outline = r as f64 + ratio * y;
            let near = (x.hypot(z) - outline.abs()).abs()
                <= (1.0 + ratio.abs()) * (off + 1e-9 * (x.abs() + y.abs() + z.abs()));
            assert!(near, "{o:?} {d:?} {:?}: {x} {y} {z} {outline}", [r, g, h]);
        };
        if let Attempt::Hit(InSide { ends, beyond }) =
            nappe(o.map(N::of), extra_bits, d.map(N::of), Nappe::of_radii([r, g, h].map(N::of)), false)
        {
            cones += 1;
            for (end, beyond) in ends.into_iter().zip(beyond) {
                if beyond == N::ZERO && end != N::MAX && end != -N::MAX {
                    on_cone(end.into(), r);
                }
            }
        }
        if let Attempt::Hit((ends, _)) =
            double_cone(o.map(N::of), extra_bits, d.map(N::of), [g.abs(), h].map(N::of), false)
        {
            cones += 1;
            assert!(ends[0] <= ends[1]);
        }
    }
    assert!(
        cones > LINES as i32 / 4 && discs > LINES as i32 / 40 && triangles > LINES as i32 / 40,
        "{cones} {discs} {triangles}"
    );
}
