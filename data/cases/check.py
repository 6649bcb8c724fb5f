"""Confirms every answer of cases.jsonl by decimal arithmetic, without raylet: python3 data/cases/check.py [FILE].

With p = origin - base, w along the solid's axis and W = w . w, a point p + s d of the line has the height (p + s d) . w
times |w|, and W times its squared distance from the axis is A s^2 + 2 B s + C: every surface is such a polynomial. All
terms are exact, since so many digits hold every product; roots have an error of 10^-1400, below which two are one.
"""
import json, struct, sys
from decimal import Decimal, getcontext
getcontext().prec, getcontext().Emax, getcontext().Emin = 3000, 10**9, -(10**9)
INF, ORDER = Decimal("inf"), ["side", "left", "right", "back", "front", "base", "top"]
ROUND = {"written": lambda x: x, "f64": lambda x: Decimal(float(x)),
         "f32": lambda x: Decimal(struct.unpack("f", struct.pack("f", float(x)))[0])}
dot = lambda a, b: sum((x * y for x, y in zip(a, b)), Decimal(0))
minus = lambda a, b: [x - y for x, y in zip(a, b)]
cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

def value(size):
    """A size is a number, or a fraction as text."""
    return size if isinstance(size, Decimal) else Decimal(size.split("/")[0]) / Decimal(size.split("/")[1])

def same(a, b):
    return a == b or (abs(a) != INF and abs(b) != INF and abs(a - b) <= max(abs(a), abs(b)) * Decimal(10) ** -1400)

def less(a, b):
    return Decimal(0) if same(a, b) else a - b

def roots(A, B, C):
    """The roots of A s^2 + 2 B s + C, in order; a double one twice."""
    if A == 0:
        return [-C / (2 * B)] if B != 0 else []
    D = B * B - A * C
    if D < 0:
        return []
    q = -(B + D.sqrt().copy_sign(B))
    return sorted([q / A, C / q if q != 0 else Decimal(0)])

def below(A, B, C, part="side"):
    """Where it is no larger than zero: intervals, each end with its part."""
    r, low, high = roots(A, B, C), (-INF, part), (INF, part)
    if not r:
        return [(low, high)] if (C if A == 0 else A) < 0 or A == B == C == 0 else []
    if A == 0:
        return [(low, (r[0], part))] if B > 0 else [((r[0], part), high)]
    a, b = (r[0], part), (r[1], part)
    return [(a, b)] if A > 0 else [(low, a), (b, high)]

def slab(y, v, low, high, parts):
    """Where low <= y + v s <= high."""
    if v == 0:
        return [((-INF, parts[0]), (INF, parts[1]))] if low <= y <= high else []
    ends = [((low - y) / v, parts[0]), ((high - y) / v, parts[1])]
    return [tuple(ends if v > 0 else ends[::-1])]

def both(a, b):
    """The intersection; of two parts at one place the first in ORDER has it."""
    def later(e, f, way):
        first = ORDER.index(e[1]) <= ORDER.index(f[1])
        return (e if first else f) if same(e[0], f[0]) else (e if (e[0] > f[0]) == way else f)
    found = [(later(i[0], j[0], True), later(i[1], j[1], False)) for i in a for j in b]
    return [(lo, hi) for lo, hi in found if lo[0] <= hi[0] or same(lo[0], hi[0])]

def solve(case, number=ROUND["written"]):
    """All crossings of the line, as (t, crossing, part); does the ray start inside; does it lie in the surface."""
    vec, kind = lambda v: [number(x) for x in v], case["solid"]["kind"]
    solid = {k: number(value(v)) for k, v in case["solid"].items() if k not in ("kind", "vertices")}
    base, d, axis = vec(case["base"]), vec(case["direction"]), case["axis"]
    p, to = minus(vec(case["origin"]), base), isinstance(axis, dict)
    w = minus(vec(axis["to"]), base) if to else vec(axis)
    W, unit = dot(w, w), dot(d, d).sqrt()
    h = W if to else solid.get("height", Decimal(0))
    r, m, flat, hollow = solid.get("radius"), solid.get("slope"), None, kind.startswith("open")
    y, v = dot(p, w), dot(d, w)
    A, B, C = dot(d, d) * W - v * v, dot(p, d) * W - y * v, dot(p, p) * W - y * y
    if kind == "triangle":
        a, b, c = (vec(x) for x in case["solid"]["vertices"])
        w = cross(minus(b, a), minus(c, a))
        y, v = dot(minus(p, a), w), dot(d, w)
        sides = [(e, minus(f, e)) for e, f in ((a, b), (b, c), (c, a))]
        edges = [(dot(cross(f, minus(p, e)), w), dot(cross(f, d), w)) for e, f in sides]
        flat = lambda: [slab(*e, Decimal(0), INF, ["side"] * 2) for e in edges]
    elif kind in ("plane", "disc", "rectangle"):
        i = [x != 0 for x in w].index(True)
        x, z = (p[i - 1], d[i - 1]), (p[i - 2], d[i - 2])
        flat = lambda: [below(A, B, C - r * r * W)] if r else [
            slab(*c, -solid[n], solid[n], ["side"] * 2) for c, n in ((x, "half_x"), (z, "half_z")) if n in solid]
    if flat:
        if v == 0:
            inside = [((-INF, "side"), (INF, "side"))] if y == 0 else []
            for limit in flat():
                inside = both(inside, limit)
            return [], False, bool(inside)
        s = -y / v
        within = lambda i: (i[0][0] <= s or same(i[0][0], s)) and (s <= i[1][0] or same(i[1][0], s))
        on = all(any(map(within, limit)) for limit in flat())
        return [(s * unit, "enter" if v < 0 else "exit", "side")] * on, False, False
    if kind == "box":
        inside = [((-INF, "side"), (INF, "side"))]
        faces = (0, "half_x", ["left", "right"]), (2, "half_z", ["back", "front"]), (1, "half_y", ["base", "top"])
        for i, n, parts in faces:
            inside = both(inside, slab(p[i], d[i], -solid[n], solid[n], parts))
        edge = lambda s, old: next((part for i, n, parts in faces[:2] for part, sign in zip(parts, (-1, 1))
                                    if same(p[i] + s * d[i], sign * solid[n])), old)
        inside = [tuple((s, edge(s, part)) for s, part in i) for i in inside]
    elif kind == "sphere":
        inside = below(dot(d, d), dot(p, d), dot(p, p) - r * r)
    else:
        if "cylinder" in kind or kind == "capsule":
            q = (A, B, C - r * r * W)
        elif "cone" in kind:
            q = (less(A, m * m * v * v), less(B, m * m * y * v), less(C, m * m * y * y))
        else:
            r, k = solid["base_radius"], (solid["top_radius"] - solid["base_radius"]) / h
            q = (A - k * k * W * v * v, B - k * W * v * (r + k * y), C - W * (r + k * y) ** 2)
        inside = below(*q)
        top = INF if kind == "infinite cone" else h
        ends = slab(y, v, Decimal(0), top, ["side" if "cone" in kind else "base", "top"])
        if (hollow or kind in ("infinite cylinder", "infinite cone", "double cone")) and q[0] == q[1] == q[2] == 0:
            return [], False, kind == "double cone" or bool(ends)
        if hollow:
            found, R = [], roots(*q)
            for i, s in enumerate(R):
                if (0 <= y + v * s or same(-y, v * s)) and (y + v * s <= h or same(h - y, v * s)):
                    slope = q[0] * s + q[1]
                    if len(R) == 2 and same(*R):
                        found += [] if i else [(s, "touch" if q[0] > 0 else "enter" if v > 0 else "exit", "side")]
                    else:
                        found.append((s, "enter" if slope < 0 else "exit", "side"))
            return [(s * unit, c, part) for s, c, part in found], False, False
        if kind == "capsule":
            balls = [below(dot(d, d), dot(p, d) - e * v, dot(p, p) - 2 * e * y + e * e * W - r * r) for e in (0, h / W)]
            parts = [i for l in (both(inside, ends), *balls) for i in l]
            low = lambda s: y + v * s < 0 and not same(-y, v * s)
            part = lambda s: "base" if low(s) else "side" if y + v * s <= h or same(h - y, v * s) else "top"
            lo, hi = (f((i[n][0] for i in parts), default=None) for n, f in ((0, min), (1, max)))
            inside = [((lo, part(lo)), (hi, part(hi)))] if parts else []
        elif kind not in ("infinite cylinder", "double cone"):
            inside = both(inside, ends)
            rim = lambda s: abs(s) != INF and same(q[0] * s * s + q[2], -2 * q[1] * s)
            inside = [tuple((s, "side" if rim(s) else part) for s, part in i) for i in inside]
            if len(inside) == 2 and same(inside[0][1][0], inside[1][0][0]):
                inside = [(inside[0][0], inside[1][1])]
    hits = []
    for (lo, part), (hi, other) in inside:
        if same(lo, hi):
            hits.append((lo, "touch", min(part, other, key=ORDER.index)))
        else:
            hits += [(s, c, q) for s, c, q in ((lo, "enter", part), (hi, "exit", other)) if abs(s) != INF]
    inner = any(lo[0] < 0 and hi[0] >= 0 and not same(lo[0], hi[0]) for lo, hi in inside)
    return [(s * unit, c, part) for s, c, part in hits], inner, False

def main(path="data/cases/cases.jsonl"):
    wrong = count = 0
    for line in open(path):
        case = json.loads(line, parse_float=Decimal, parse_int=Decimal)
        for numbers in ROUND:
            answer = case if numbers == "written" else case.get(numbers)
            if answer is None:
                continue
            hits, inside, lies = solve(case, ROUND[numbers])
            told = [(Decimal(h["t"]), h["crossing"], h["part"]) for h in answer["hits"]]
            agree = [a[1:] for a in hits] == [b[1:] for b in told] and all(
                abs(a[0] - b[0]) <= abs(b[0]) * Decimal("1e-18") for a, b in zip(hits, told))
            count += 1
            if not agree or inside != answer["starts_inside"] or lies != (answer["lies_in_it"] is not None):
                wrong += 1
                found = [(f"{a[0]:.20g}", *a[1:]) for a in hits], inside, lies
                print(f"{case['name']}, {numbers}:\n  stored {answer['hits']}\n  found {found}")
    print(f"{count} answers confirmed" if wrong == 0 else f"{wrong} of {count} answers are wrong")
    return wrong

if __name__ == "__main__":
    sys.exit(min(main(*sys.argv[1:]), 1))
