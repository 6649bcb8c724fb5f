// One solid and one ray: the picture, what is dragged, and the table of crossings.

/** Columns and rows of the picture, and the height of what it shows. */
const PICTURE = [240, 180], SHOWN = 5, AWAY = 40;

/** The view's axes: to the right, upwards, towards the viewer. */
function axesOfView({ turned, tilted }) {
    const steep = Math.max(-85, Math.min(85, tilted)), [a, b] = [turned, steep].map((angle) => (angle * Math.PI) / 180);
    const towards = [Math.sin(a) * Math.cos(b), Math.sin(b), Math.cos(a) * Math.cos(b)];
    const right = unit(cross([0, 1, 0], towards));
    return { right, up: cross(towards, right), towards };
}

/** The origin of the ray: its start, moved back by a power of ten. */
function originOf({ start, target, back }) {
    return plus(target, times(minus(start, target), 10 ** back));
}

const solidOf = ({ solid, sizes, base, axis }) => ({ name: solid, sizes, base, axis });

/** The page's solid and ray in a number type. */
function worldOf(state, number) {
    const world = library.world(number, [solidOf(state)]);
    world.aim(originOf(state), minus(state.target, state.start));
    return world;
}

function draw(state) {
    const view = axesOfView(state), [columns, rows] = PICTURE, canvas = find("picture");
    const world = library.world(state.number, [solidOf(state)]);
    world.look({ position: times(view.towards, AWAY), target: [0, 0, 0], height: SHOWN }, PICTURE);
    const context = canvas.getContext("2d"), image = context.createImageData(columns, rows);
    for (let y = 0; y < rows; y++) {
        const row = world.row(state.tier, y);
        for (let x = 0; x < columns; x++) {
            const [index, , cosine] = row.slice(3 * x, 3 * x + 3), shade = 0.25 + 0.75 * Math.abs(cosine);
            const color = index < 0 ? [0, 0, 0, 0] : [...times([96, 160, 230], shade), 255];
            image.data.set(color, 4 * (y * columns + x));
        }
    }
    context.putImageData(image, 0, 0);
}

/** The ray, its crossings and their normals over the picture; the handles. */
function drawRay(state, hits) {
    const { right, up } = axesOfView(state), place = (p) => [inner(p, right), -inner(p, up)];
    const line = (a, b, kind) => {
        const [[x1, y1], [x2, y2]] = [a, b].map(place);
        return element("line", { x1, y1, x2, y2, class: kind });
    };
    const direction = unit(minus(state.target, state.start)), far = times(direction, 12);
    const from = state.back > 0 ? minus(state.start, far) : state.start;
    const marks = [line(from, plus(state.target, far), "ray")];
    for (const { point, normal, crossing, part } of hits) {
        const [cx, cy] = place(point);
        marks.push(line(point, plus(point, times(normal, 0.6)), "normal"));
        const title = element("title", {}, `${CROSSINGS[crossing]} at the ${PARTS[part]}`);
        marks.push(element("circle", { cx, cy, r: 0.05, class: CROSSINGS[crossing] }, title));
    }
    find("marks").replaceChildren(...marks);
    placeHandles(state);
}

function placeHandles(state) {
    const { right, up } = axesOfView(state);
    for (const handle of document.querySelectorAll(".handle")) {
        const [x, y] = [inner(state[handle.dataset.moves], right), -inner(state[handle.dataset.moves], up)];
        handle.style.left = `${50 + (100 * x * 3) / (4 * SHOWN)}%`;
        handle.style.top = `${50 + (100 * y) / SHOWN}%`;
    }
}

/** The bits of a number of this type, in hexadecimal. */
function bitsOf(number, value) {
    const view = new DataView(new ArrayBuffer(8));
    if (number === "f64") view.setFloat64(0, value);
    else if (number === "f32") view.setFloat32(0, value);
    else view.setInt32(0, value * 65536);
    return number === "f64" ? view.getBigUint64(0).toString(16).padStart(16, "0")
        : view.getUint32(0).toString(16).padStart(8, "0");
}

const brief = (x) => (x === 0 ? "0" : x.toExponential(1));
const vector = (v) => `(${v.map((x) => x.toFixed(3)).join(", ")})`;

function tabulate(state, hits, exact) {
    const rows = [];
    for (let i = 0; i < Math.max(hits.length, exact.length); i++) {
        const [hit, crossing] = [hits[i], exact[i]];
        const own = hit ? [String(hit.t), bitsOf(state.number, hit.t), CROSSINGS[hit.crossing], PARTS[hit.part],
            vector(hit.normal)] : ["missed", "", "", "", ""];
        const error = hit && crossing ? brief(errorOf(hit.t, crossing)) : "";
        const wanted = crossing ? `${decimal(crossing)}, ${CROSSINGS[crossing.crossing]}` : "there is none";
        rows.push(rowOf([String(i + 1), ...own, wanted, error]));
    }
    find("hits").tBodies[0].replaceChildren(...rows);
    const count = `${hits.length} crossing${hits.length === 1 ? "" : "s"}`;
    find("said").textContent = `${count} in ${state.number}, ${state.tier}; exactly ${exact.length}.`;
}

function showSolid(state) {
    try {
        draw(state);
        const world = worldOf(state, state.number), hits = world.hits(state.tier, 0, 0);
        const exact = exactCrossings(world.solid(0), world.ray(0));
        drawRay(state, hits);
        tabulate(state, hits, exact);
    } catch (error) {
        const canvas = find("picture");
        canvas.getContext("2d").clearRect(0, 0, canvas.width, canvas.height);
        find("marks").replaceChildren();
        placeHandles(state);
        find("hits").tBodies[0].replaceChildren();
        find("said").textContent = `${state.number}: ${error.message}`;
    }
}

/** Moves a point of the state in the plane of the picture. */
function move(state, point, [dx, dy]) {
    const { right, up } = axesOfView(state);
    state[point] = plus(state[point], plus(times(right, dx), times(up, dy))).map((x) => Math.round(x * 1000) / 1000);
}

/** Calls back with how far a pointer is dragged, in the units of the picture. What is said is read out when it ends. */
function dragged(target, moved) {
    let last = null, pointer;
    target.addEventListener("pointerdown", (event) => {
        if (last) return;
        [last, pointer] = [[event.clientX, event.clientY], event.pointerId];
        target.setPointerCapture(event.pointerId);
        find("said").ariaBusy = "true";
        event.preventDefault();
        event.stopPropagation();
        target.focus({ preventScroll: true });
    });
    target.addEventListener("pointermove", (event) => {
        if (!last || event.pointerId !== pointer) return;
        const scale = SHOWN / find("stage").clientHeight, now = [event.clientX, event.clientY];
        moved([(now[0] - last[0]) * scale, (last[1] - now[1]) * scale]);
        last = now;
    });
    for (const end of ["pointerup", "pointercancel"]) {
        target.addEventListener(end, (event) => {
            if (event.pointerId !== pointer) return;
            last = null;
            find("said").ariaBusy = "false";
        });
    }
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Makes handles move points, and the picture turn. */
function listenToHandles(change) {
    const turn = (state, [dx, dy]) => {
        const hundredths = (angle) => Math.round(100 * angle) / 100;
        state.turned = hundredths(state.turned - 40 * dx);
        state.tilted = hundredths(Math.max(-85, Math.min(85, state.tilted - 40 * dy)));
    };
    const moving = [...document.querySelectorAll(".handle")].map((handle) => [handle, (state, by) => {
        move(state, handle.dataset.moves, by);
    }]);
    for (const [target, act] of [...moving, [find("stage"), turn]]) {
        dragged(target, (by) => change((state) => act(state, by)));
        target.addEventListener("keydown", (event) => {
            const arrow = ARROWS[event.key];
            if (!arrow || event.target !== target || event.altKey || event.ctrlKey || event.metaKey) return;
            event.preventDefault();
            change((state) => act(state, times(arrow, event.shiftKey ? 0.01 : 0.1)));
        });
    }
}
