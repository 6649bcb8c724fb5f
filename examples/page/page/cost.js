// Error and cost of all number types and tiers, for rays about the page's own.

const RAYS = 400;

/** Numbers in [0, 1) that repeat (mulberry32). */
function randomNumbers(seed) {
    return () => {
        seed = (seed + 0x6d2b79f5) | 0;
        let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
        t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
        return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
}

/** Rays from about the origin of the state's ray to about the solid. */
function raysAbout(state) {
    const random = randomNumbers(1), origin = originOf(state), rays = [];
    const around = (p, size) => p.map((x) => x + size * (2 * random() - 1));
    for (let i = 0; i < RAYS; i++) {
        const from = around(origin, 0.5);
        rays.push([from, minus(around(plus(state.base, times(unit(state.axis), 0.6)), 1), from)]);
    }
    return rays;
}

/** How a number type answers, tier by tier: `{ number, tier, error, wrong, nanoseconds, time }`. */
async function judge(state, number, isWanted) {
    const rays = raysAbout(state), exact = [];
    // Each time anew: between two of them the page may have used the number type for something else.
    const newWorld = () => {
        const world = library.world(number, [solidOf(state)]);
        rays.forEach(([origin, direction]) => world.aim(origin, direction));
        return world;
    };
    const world = newWorld(), solid = world.solid(0), stored = rays.map((_, i) => world.ray(i));
    for (const [i, ray] of stored.entries()) {
        exact.push(exactCrossings(solid, ray));
        if (i % 50 === 0) await pause();
        if (!isWanted()) return [];
    }
    return tiersOf(number).map((tier) => {
        const world = newWorld(), errors = [];
        let wrong = 0;
        exact.forEach((crossings, i) => {
            const hits = world.hits(tier, 0, i);
            if (hits.length !== crossings.length) wrong++;
            else hits.forEach(({ t }, j) => errors.push(errorOf(t, crossings[j])));
        });
        errors.sort((a, b) => a - b);
        const error = errors.length ? errors[Math.floor(0.99 * (errors.length - 1))] : NaN;
        return { number, tier, error, wrong, nanoseconds: Infinity, time: () => newWorld().cost(tier) };
    });
}

/**
 * Times all answers in turn, for some seconds and until none becomes faster: a browser compiles what runs often anew.
 */
async function time(answers, isWanted, tell) {
    const start = performance.now();
    for (let round = 0, calm = 0; performance.now() - start < 3000 || (calm < 5 && round < 200); round++, calm++) {
        for (const answer of answers) {
            const nanoseconds = answer.time();
            if (nanoseconds < 0.9 * answer.nanoseconds) calm = 0;
            answer.nanoseconds = Math.min(nanoseconds, answer.nanoseconds);
            await pause();
            if (!isWanted()) return;
        }
        if (round % 8 === 0) tell();
    }
    tell();
}

/** Positions in the plot, of 100 by 60. */
function scaled(values) {
    const logs = values.filter((x) => x > 0).map(Math.log10);
    const [low, high] = [Math.floor(Math.min(...logs)), Math.ceil(Math.max(...logs))];
    return { low, high: Math.max(high, low + 1), of: (x) => (Math.log10(x) - low) / (Math.max(high, low + 1) - low) };
}

const SYMBOLS = { "f32": "M-1-1h2v2h-2z", "I16F16": "M0-1.3 1.2 1h-2.4z", "f64": "M0-1.3 1.3 0 0 1.3-1.3 0z" };

/** A text beside a place, where the least is in its way; what is taken grows by it. */
function label(text, [x, y], taken) {
    const sides = [0, 2.6, -2.6, 5.2, -5.2].flatMap((down) => [[2, down], [-2 - text.length * 1.1, down]]);
    const middle = ([right, down]) => [x + right + text.length * 0.55, y + down];
    const inTheWay = (side) => {
        const [a, b] = middle(side);
        return taken.filter(([c, d]) => Math.abs(a - c) < text.length * 0.55 + 1.2 && Math.abs(b - d) < 2.2).length;
    };
    const [right, down] = sides.reduce((best, side) => (inTheWay(side) < inTheWay(best) ? side : best));
    const [a, b] = middle([right, down]);
    for (let i = 0; i <= text.length; i += 2) taken.push([a + (i - text.length / 2) * 1.1, b]);
    return element("text", { x: x + right, y: y + down + 0.7 }, text);
}

function plot(answers) {
    const isKnown = ({ error, nanoseconds }) => error > 0 && Number.isFinite(nanoseconds);
    const shown = answers.filter(isKnown), marks = [];
    if (shown.length) {
        const across = scaled(shown.map(({ nanoseconds }) => nanoseconds));
        const up = scaled(shown.map(({ error }) => error));
        const [x, y] = [(value) => 12 + 80 * across.of(value), (value) => 50 - 46 * up.of(value)];
        for (let power = across.low; power <= across.high; power++) {
            const at = x(10 ** power);
            marks.push(element("line", { x1: at, x2: at, y1: 4, y2: 50, class: "grid" }));
            marks.push(element("text", { x: at, y: 53.5, "text-anchor": "middle" }, `${10 ** power} ns`));
        }
        for (let power = up.low; power <= up.high; power += Math.ceil((up.high - up.low) / 6)) {
            const at = y(10 ** power);
            marks.push(element("line", { x1: 12, x2: 92, y1: at, y2: at, class: "grid" }));
            marks.push(element("text", { x: 11, y: at + 0.7, "text-anchor": "end" }, `1e${power}`));
        }
        const taken = shown.map(({ error, nanoseconds }) => [x(nanoseconds), y(error)]);
        for (const { number, tier, error, nanoseconds, wrong } of shown) {
            const at = [x(nanoseconds), y(error)];
            const title = `${number} ${tier}: error ${brief(error)}, ${nanoseconds.toFixed(0)} ns, ${wrong} rays wrong`;
            const symbol = element("path", { d: SYMBOLS[number], transform: `translate(${at})` });
            const name = label(`${number} ${tier}`, at, taken);
            marks.push(element("g", { class: number }, element("title", {}, title), symbol, name));
        }
    }
    find("plot").replaceChildren(...marks);
}

let measurement = 0;

/** What is measured or shown is of an earlier state. */
function forgetCost() {
    measurement++;
    find("costs").setAttribute("aria-busy", "true");
}

async function showCost(state) {
    const own = ++measurement, isWanted = () => own === measurement, answers = [], refused = [];
    for (const number of NUMBERS) {
        find("measured").textContent = `Measuring ${number} …`;
        try {
            answers.push(...(await judge(state, number, isWanted)));
        } catch (error) {
            refused.push(`${number}: ${error.message}`);
        }
        if (!isWanted()) return;
    }
    find("measured").textContent = "Measuring times …";
    const tell = () => {
        find("costs").tBodies[0].replaceChildren(...answers.map(({ number, tier, error, wrong, nanoseconds }) => {
            const told = Number.isNaN(error) ? "–" : brief(error);
            return rowOf([`${number} ${tier}`, told, String(wrong), nanoseconds.toFixed(0)]);
        }));
        plot(answers);
    };
    if (answers.length) await time(answers, isWanted, tell);
    else tell();
    if (!isWanted()) return;
    find("measured").textContent = [`${RAYS} rays about this one.`, ...refused].join(" ");
    find("costs").removeAttribute("aria-busy");
}
