// The exact crossings of a line with a solid, in integers: the reference of the page. It shares no code with the
// library, and is given the numbers that the library stored.
//
// Floats are m 2^e. All lengths of a question are brought to one exponent, and so are directions and axes; then a point
// of the line is o + u d with integers o and d, and u = t 2^k. A solid is a union of pieces; a piece is where all its
// polynomials in u, of degree 2 at most, are not positive. A root of one is (a + b sqrt(D)) / q with q > 0.

/** x = m 2^e, m odd or zero. */
function dyadic(x) {
    if (x === 0) return [0n, 0];
    const bits = new DataView(new ArrayBuffer(8));
    bits.setFloat64(0, x);
    const word = bits.getBigUint64(0), field = Number((word >> 52n) & 0x7ffn);
    let m = (word & 0xfffffffffffffn) | (field ? 0x10000000000000n : 0n), e = Math.max(field, 1) - 1075;
    for (; !(m & 1n); m >>= 1n) e++;
    return [word >> 63n ? -m : m, e];
}

/** Floats as integers times 2^exponent. */
function integers(floats) {
    const pairs = floats.map(dyadic), exponent = Math.min(0, ...pairs.map(([, e]) => e));
    return { exponent, values: pairs.map(([m, e]) => m ? m << BigInt(e - exponent) : 0n) };
}

const signOf = (x) => (x > 0n ? 1 : x < 0n ? -1 : 0);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0n);

/** The sign of u + v sqrt(D). */
function signOfSurd(u, v, D) {
    const [su, sv] = [signOf(u), signOf(v) * signOf(D)];
    if (su * sv >= 0) return su || sv;
    return su * signOf(u * u - v * v * D);
}

/** The sign of the polynomial A u^2 + B u + C at a root. */
function signAt([A, B, C], { a, b, D, q }) {
    return signOfSurd(A * (a * a + b * b * D) + B * a * q + C * q * q, 2n * A * a * b + B * b * q, D);
}

/** Its sign at the dyadic number x / 2^places. */
const signNear = ([A, B, C], x, places) => signOf((A * x + (B << places)) * x + (C << (2n * places)));

function roots([A, B, C]) {
    if (A === 0n) {
        if (B === 0n) return [];
        return [B > 0n ? { a: -C, b: 0n, D: 0n, q: B } : { a: C, b: 0n, D: 0n, q: -B }];
    }
    if (A < 0n) [A, B, C] = [-A, -B, -C];
    const D = B * B - 4n * A * C;
    if (D < 0n) return [];
    return (D ? [-1n, 1n] : [0n]).map((b) => ({ a: -B, b, D, q: 2n * A }));
}

/**
 * Roots have so many binary places, and more where u is smaller than t. Those nearer than 2^-400, in all but contrived
 * cases equal, are taken as one.
 */
const PLACES = 512n, APART = 1n << 112n;

function squareRoot(x) {
    if (x < 2n) return x;
    let root = 1n << BigInt((x.toString(16).length * 4 + 2) >> 1);
    for (;;) {
        const next = (root + x / root) >> 1n;
        if (next >= root) return root;
        root = next;
    }
}

/** The root times 2^places. */
const near = ({ a, b, D, q }, places) => ((a << places) + b * squareRoot(D << (2n * places))) / q;

/** The pieces of a solid along the line o + u d; of an open surface the first polynomial is its side. */
function pieces(solid, [a, b, c], slope, o, d) {
    const [ox, oy, oz] = o, [dx, dy, dz] = d;
    const height = solid === "frustum" ? c : b, slab = [[0n, -dy, -oy], [0n, dy, oy - height]];
    const round = [dx * dx + dz * dz, 2n * (ox * dx + oz * dz), ox * ox + oz * oz];
    const minus = ([A, B, C], [e, f, g]) => [A - e, B - f, C - g], times = (n, p) => p.map((x) => x * n);
    // The square of a length that is r + s y.
    const squared = (r, s) => [s * s * dy * dy, 2n * s * dy * (r + s * oy), (r + s * oy) ** 2n];
    const ball = (r, y) => minus(round, [-dy * dy, -2n * dy * (oy - y), r * r - (oy - y) ** 2n]);
    switch (solid) {
        case "sphere": return [[ball(a, 0n)]];
        case "cylinder": case "open cylinder": return [[minus(round, [0n, 0n, a * a]), ...slab]];
        case "cone": return [[minus(times(slope[1], round), squared(0n, slope[0])), ...slab]];
        case "double cone": return [[minus(times(slope[1], round), squared(0n, slope[0]))]];
        case "frustum": return [[minus(times(c * c, round), squared(a * c, b - a)), ...slab]];
        case "capsule": return [[minus(round, [0n, 0n, a * a]), ...slab], [ball(a, 0n)], [ball(a, b)]];
        default: return [[a, b, c].flatMap((half, i) => [[0n, d[i], o[i] - half], [0n, -d[i], -o[i] - half]])];
    }
}

/**
 * The crossings with t >= 0, sorted: of each `crossing` (0 enters, 1 exits, 2 touches), and t as x 2^exponent.
 *
 * `solid`: `{ name, sizes, position, axes }`; `ray`: `{ origin, direction }`; flat lists of floats.
 */
function exactCrossings({ name, sizes, position, axes }, { origin, direction }) {
    const hasSlope = name.endsWith("cone"), frame = name === "sphere" ? [1, 0, 0, 0, 1, 0, 0, 0, 1] : axes;
    const lengths = integers([...position, ...origin, ...sizes.map((x, i) => (hasSlope && i === 0 ? 0 : x))]);
    const rows = integers(frame), along = integers(direction), slope = integers([hasSlope ? sizes[0] : 0]);
    const [p, from, size] = [0, 3, 6].map((i) => lengths.values.slice(i, i + 3));
    const local = (v) => [0, 3, 6].map((i) => dot(rows.values.slice(i, i + 3), v));
    const o = local(from.map((x, i) => x - p[i])), d = local(along.values);
    const scaled = size.map((x) => x << BigInt(-rows.exponent));
    const union = pieces(name, scaled, [slope.values[0], 1n << BigInt(-2 * slope.exponent)], o, d);

    const scale = lengths.exponent - along.exponent, places = PLACES + BigInt(Math.max(0, scale));
    const exponent = scale - Number(places);
    const found = [], add = (root, x, crossing) => {
        if (signAt([0n, 1n, 0n], root) >= 0) found.push({ crossing, x, exponent });
    };
    if (name.startsWith("open")) {
        const [side, ...slab] = union[0];
        for (const root of roots(side)) {
            if (slab.some((plane) => signAt(plane, root) > 0)) continue;
            add(root, near(root, places), root.b < 0n ? 0 : root.b > 0n ? 1 : 2);
        }
        return found;
    }
    const all = union.flat().flatMap(roots).map((root) => ({ root, x: near(root, places) }));
    all.sort((one, other) => signOf(one.x - other.x));
    const isApart = ({ x }, i) => i === 0 || x - all[i - 1].x > APART, apart = all.filter(isApart);
    const isInside = (sign) => union.some((piece) => piece.every((polynomial) => sign(polynomial) <= 0));
    const inside = (x) => isInside((polynomial) => signNear(polynomial, x, places));
    let before = apart.length > 0 && inside(apart[0].x - (1n << places));
    apart.forEach(({ root, x }, i) => {
        const after = inside(i + 1 < apart.length ? (x + apart[i + 1].x) >> 1n : x + (1n << places));
        if (before !== after) add(root, x, before ? 1 : 0);
        else if (!before && isInside((polynomial) => signAt(polynomial, root))) add(root, x, 2);
        before = after;
    });
    return found;
}

/** x 2^exponent as the nearest float, to the last bits. */
function toFloat(x, exponent) {
    const bits = (x < 0n ? -x : x).toString(2).length, surplus = Math.max(0, bits - 64);
    return Number(x >> BigInt(surplus)) * 2 ** (exponent + surplus);
}

/** How far a float is from a crossing. */
function errorOf(t, { x, exponent }) {
    const [m, e] = dyadic(t), shift = e - exponent;
    const difference = (shift >= 0 ? m << BigInt(shift) : m >> BigInt(-shift)) - x;
    return toFloat(difference < 0n ? -difference : difference, exponent);
}

/** A crossing's t in decimal, to 20 digits after the point. */
function decimal({ x, exponent }) {
    const scaled = (x * 10n ** 20n) >> BigInt(-exponent), digits = scaled.toString().padStart(21, "0");
    return `${digits.slice(0, -20)}.${digits.slice(-20)}`;
}
