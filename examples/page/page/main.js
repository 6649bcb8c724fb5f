// Ties the controls to the state, and the state to the link.

let library, state;

/** Milliseconds without a change after which the link is written, and errors and times are measured. */
const DELAY = 300;
let waiting;

/** Safari refuses a page that writes its link with every move of a pointer. */
function writeLink() {
    const link = linkOf(state);
    if (link !== (location.hash || "#")) history.replaceState(null, "", link);
}

/** Shows what changed at once, and what takes long a moment later. */
function show() {
    fillControls();
    showSolid(state);
    forgetCost();
    clearTimeout(waiting);
    waiting = setTimeout(() => {
        writeLink();
        showCost(structuredClone(state));
    }, DELAY);
}

/** The example that is none. */
const OWN = "none, your own";

let isChanged = false;

/** Changes the state; what is shown follows once for all changes between two frames. */
function change(edit) {
    edit(state);
    find("examples").value = OWN;
    if (isChanged) return;
    isChanged = true;
    requestAnimationFrame(() => {
        isChanged = false;
        show();
    });
}

/** A labelled input for a number. */
function field(label, value, edit) {
    const input = element("input", { type: "number", step: "any", value: String(value) });
    input.addEventListener("change", () => {
        const number = Number(input.value);
        if (input.value.trim() && Number.isFinite(number)) change((state) => edit(state, number));
    });
    return element("label", {}, `${label} `, input);
}

/** The choices of a select. */
function choices(id, names, chosen, edit) {
    const select = find(id);
    select.replaceChildren(...names.map((name) => element("option", {}, name)));
    select.value = chosen;
    select.onchange = () => edit(select.value);
}

function fillControls() {
    choices("solid", Object.keys(SOLIDS), state.solid, (name) => change((state) => {
        state.solid = name;
        state.sizes = [...Object.values(SOLIDS[name]), 0, 0, 0].slice(0, 3);
    }));
    choices("number", NUMBERS, state.number, (number) => change((state) => {
        state.number = number;
        if (!tiersOf(number).includes(state.tier)) state.tier = "Stable";
    }));
    choices("tier", tiersOf(state.number), state.tier, (tier) => change((state) => (state.tier = tier)));
    // What is being typed into is not replaced.
    if (!find("sizes").contains(document.activeElement)) {
        find("sizes").replaceChildren(...Object.keys(SOLIDS[state.solid]).map((label, i) => {
            return field(label, state.sizes[i], (state, x) => (state.sizes = state.sizes.with(i, x)));
        }));
    }
    for (const group of document.querySelectorAll("[data-point]")) {
        if (group.contains(document.activeElement)) continue;
        const point = group.dataset.point;
        const fields = ["x", "y", "z"].map((axis, i) => {
            return field(axis, state[point][i], (state, x) => (state[point] = state[point].with(i, x)));
        });
        group.replaceChildren(group.querySelector("legend"), ...fields);
    }
    find("back").value = state.back;
    find("back-said").textContent = state.back ? `${10 ** state.back} times as far away` : "as drawn";
}

function listen() {
    const examples = find("examples");
    examples.append(...[OWN, ...Object.keys(EXAMPLES)].map((name) => element("option", {}, name)));
    examples.addEventListener("change", () => {
        const { scene, type } = state;
        state = { ...structuredClone(INITIAL), ...structuredClone(EXAMPLES[examples.value] ?? state), scene, type };
        show();
    });
    find("back").addEventListener("input", () => change((state) => (state.back = Number(find("back").value))));
    listenToHandles(change);
    for (const [id, names] of [["scene", Object.keys(SCENES)], ["type", NUMBERS]]) {
        choices(id, names, state[id], (chosen) => {
            state[id] = chosen;
            writeLink();
            showScene(structuredClone(state));
        });
    }
    find("copy").addEventListener("click", async () => {
        writeLink();
        try {
            await navigator.clipboard.writeText(location.href);
            find("copied").textContent = "Copied.";
        } catch {
            find("copied").textContent = "This browser does not let the page copy: take the address above.";
        }
    });
    addEventListener("hashchange", () => {
        state = stateOf(location.hash);
        document.activeElement.blur();
        find("scene").value = state.scene;
        find("type").value = state.type;
        show();
        showScene(structuredClone(state));
    });
}

async function start() {
    try {
        library = await loaded(find("library").textContent);
    } catch (error) {
        find("said").textContent = `The library could not be started: ${error.message}`;
        return;
    }
    state = stateOf(location.hash);
    document.querySelector(".legend").style.background = `linear-gradient(90deg, ${COLORS.map((c) => `rgb(${c})`)})`;
    listen();
    show();
    showScene(structuredClone(state));
    document.body.dataset.ready = "yes";
}

start();
