// Three hard scenes: each tier's picture, and beside it how wrong each pixel is, by the exact answer to the same ray.

const SCENE_SIZE = [120, 90];

/** A cylinder or frustum between two points. */
function between(from, to, base, top = base) {
    const axis = minus(to, from), height = Math.hypot(...axis);
    return base === top ? { name: "cylinder", sizes: [base, height, 0], base: from, axis }
        : { name: "frustum", sizes: [base, top, height], base: from, axis };
}

const ball = (base, radius) => ({ name: "sphere", sizes: [radius, 0, 0], base, axis: [0, 1, 0] });
const box = (base, sizes) => ({ name: "box", sizes, base, axis: [0, 1, 0] });

/** The scenes, and why each is hard. */
const SCENES = {
    sea: {
        why: "Nearly all rays graze a ball of radius 8,000, seen from 0.002 above it.",
        view: { position: [0, 0.002, 0], target: [0, 0.01, 10], angle: 0.45 },
        solids: [ball([0, -8000, 0], 8000), ball([0.02, 0.01, 10], 0.02),
            between([-0.03, -0.01, 9], [-0.03, 0.035, 9], 0.004),
            between([-0.02, -0.01, 14], [-0.02, 0.03, 14], 0.004),
            between([-0.005, -0.01, 12], [-0.005, 0.025, 12], 0.012, 0)],
        colors: [[77, 115, 128], [204, 64, 51], [230, 191, 51], [230, 191, 51], [77, 166, 89]],
    },
    jetty: {
        why: "Everything is some 2,800 from the origin, where neighbouring values of f32 are 1/4096 apart.",
        view: { position: [2750, 1750.5, 2250], target: [2750, 1750.15, 2260], angle: 40 },
        solids: [box([2750, 1749.9, 2420], [250, 0.1, 172.5]),
            between([2749.55, 1750.175, 2251], [2749.55, 1750.175, 2315], 0.02),
            between([2750.45, 1750.175, 2251], [2750.45, 1750.175, 2315], 0.02),
            between([2749.775, 1750.0625, 2251], [2749.85, 1750.0625, 2300], 0.0625),
            between([2750.225, 1750.0625, 2251], [2750.15, 1750.0625, 2300], 0.0625),
            between([2749, 1750.25, 2252.5], [2749.65, 1750.4, 2280], 0.075, 0),
            between([2751, 1750.25, 2252.5], [2750.35, 1750.4, 2280], 0.075, 0),
            ball([2750, 1600, 2425], 153)],
        colors: [[140, 128, 107], [204, 64, 51], [204, 64, 51], [51, 128, 179], [51, 128, 179], [230, 191, 51],
            [230, 191, 51], [77, 166, 89]],
    },
    telescope: {
        why: "A rail, a cone and a ball of size 1 are seen from 8,000 sizes away.",
        view: { position: [0, 130, -8000], target: [0, 0.35, 0], angle: 0.03 },
        solids: [box([0, -0.5, 0], [40, 0.5, 200]), between([-1.2, 0.35, -30], [-1, 0.35, 30], 0.3),
            between([1.1, 0, 0], [1.1, 1.2, 0], 0.5, 0), ball([0, 0.6, 0], 0.6)],
        colors: [[140, 128, 107], [204, 64, 51], [230, 191, 51], [51, 128, 179]],
    },
};

/** For each pixel the nearest solid and its crossing; for the sky nothing. */
async function exactPicture(world, isWanted, tell) {
    const [columns, rows] = SCENE_SIZE, exact = [], solids = world.solids.map((_, i) => world.solid(i));
    const rayOf = (i) => world.rayOfPixel(i % columns, Math.floor(i / columns));
    const rays = Array.from({ length: columns * rows }, (_, i) => rayOf(i));
    for (const [i, ray] of rays.entries()) {
        if (i % columns === 0) {
            const row = i / columns;
            // Not each row: a screen reader says them.
            if (row % 30 === 0) tell(`Computing exactly: ${Math.round((100 * row) / rows)} % …`);
            await pause();
            if (!isWanted()) return null;
        }
        let best = null;
        solids.forEach((solid, index) => {
            const [first] = exactCrossings(solid, ray);
            if (!first) return;
            // In one unit for all solids.
            const places = first.x << BigInt(first.exponent + 2000);
            if (!best || places < best.places) best = { index, places, first };
        });
        exact.push(best);
    }
    return exact;
}

/** The colors of errors from 1e-6 to 1, evenly in their logarithm. */
const COLORS = [[0, 0, 0], [0, 40, 220], [0, 160, 255], [120, 230, 160], [255, 230, 60], [255, 255, 255]];

/** The color of an error of a distance. */
function colorOf(error) {
    const place = Math.max(0, Math.min(1, (Math.log10(error) + 6) / 6)) * (COLORS.length - 1);
    const first = Math.min(Math.floor(place), COLORS.length - 2), [a, b] = COLORS.slice(first, first + 2);
    return [...a.map((channel, i) => Math.round(channel + (b[i] - channel) * (place - first))), 255];
}

/** Of another solid than the exact one. */
const WRONG = [255, 0, 255, 255];

function pictures(scene, world, tier, exact) {
    const [columns, rows] = SCENE_SIZE, both = [0, 1].map(() => new ImageData(columns, rows));
    let wrong = 0, worst = 0;
    for (let y = 0; y < rows; y++) {
        const row = world.row(tier, y);
        for (let x = 0; x < columns; x++) {
            const at = y * columns + x, [index, t, cosine] = row.slice(3 * x, 3 * x + 3);
            const shade = 0.3 + 0.7 * Math.abs(cosine);
            both[0].data.set(index < 0 ? [128, 153, 191, 255] : [...times(scene.colors[index], shade), 255], 4 * at);
            const wanted = exact[at];
            let color = [0, 0, 0, 255];
            if ((wanted ? wanted.index : -1) !== index) {
                wrong++;
                color = WRONG;
            } else if (wanted) {
                const error = errorOf(t, wanted.first);
                worst = Math.max(worst, error);
                color = colorOf(error);
            }
            both[1].data.set(color, 4 * at);
        }
    }
    return { both, wrong, worst };
}

function tile(tier, { both, wrong, worst }) {
    const [width, height] = SCENE_SIZE;
    const canvases = both.map((image, i) => {
        const label = `${tier}: ${i ? "map of the error" : "picture"}`;
        const canvas = element("canvas", { width, height, role: "img", "aria-label": label });
        canvas.getContext("2d").putImageData(image, 0, 0);
        return canvas;
    });
    const said = `${tier}: ${wrong} pixels see another solid, the largest error is ${brief(worst)}`;
    return element("figure", {}, ...canvases, element("figcaption", {}, said));
}

let rendering = 0;

async function showScene(state) {
    const own = ++rendering, isWanted = () => own === rendering, scene = SCENES[state.scene], tiles = [];
    const tell = (text) => (find("rendered").textContent = text);
    find("tiles").setAttribute("aria-busy", "true");
    find("why").textContent = scene.why;
    // Each time anew: between two of them the page may have used the number type for something else.
    const newWorld = () => {
        const world = library.world(state.type, scene.solids);
        world.look(scene.view, SCENE_SIZE);
        return world;
    };
    try {
        const exact = await exactPicture(newWorld(), isWanted, tell);
        if (!exact) return;
        for (const tier of tiersOf(state.type)) tiles.push(tile(tier, pictures(scene, newWorld(), tier, exact)));
        tell(`Rendered in ${state.type}.`);
    } catch (error) {
        tell(`${state.type}: ${error.message}`);
    }
    if (!isWanted()) return;
    find("tiles").replaceChildren(...tiles);
    find("tiles").removeAttribute("aria-busy");
}
