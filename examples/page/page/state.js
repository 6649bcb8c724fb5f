// What the page shows, and its link: all of it is in the part of the address after `#`.

const INITIAL = {
    solid: "cylinder", sizes: [0.8, 1.6, 0], base: [0, -0.8, 0], axis: [0.2, 1, 0.1],
    start: [-2.2, 0.6, 1.2], target: [0.1, 0.1, 0], back: 0, number: "f32", tier: "Stable",
    turned: 30, tilted: 20, scene: "sea", type: "f32",
};

/** Rays that are hard for some number type or tier. */
const EXAMPLES = {
    "through a cylinder": {},
    "past a sphere, 10,000 radii away": {
        solid: "sphere", sizes: [1, 0, 0], base: [0, 0, 0], start: [-3, 0.99, 0], target: [0, 0.99, 0], back: 3,
        tier: "Plain",
    },
    "along the side of a cone": {
        solid: "cone", sizes: [0.5, 1.6, 0], base: [0, -0.8, 0], axis: [0, 1, 0], start: [1.302, 1.8, 0],
        target: [0.3, -0.2, 0], tier: "Fast",
    },
    "through the apex of a double cone": {
        solid: "double cone", sizes: [0.5, 0, 0], base: [0, 0, 0], axis: [0, 1, 0], start: [-2, 0.5, 0],
        target: [0, 0, 0],
    },
    "through the rim of a cylinder": {
        solid: "cylinder", sizes: [1, 1, 0], base: [0, 0, 0], axis: [0, 1, 0], start: [-2, 2, 0], target: [-1, 1, 0],
        tier: "Exact",
    },
    "nearly in the face of a box": {
        solid: "box", sizes: [1, 0.7, 0.8], base: [0, 0, 0], axis: [0, 1, 0], start: [-3, 0.7003, 0.2],
        target: [0, 0.6997, 0], back: 2,
    },
};

/** The state that a link means; what it does not have, or not in the right form, is as at first. */
function stateOf(link) {
    const state = structuredClone(INITIAL), given = new URLSearchParams(link.replace(/^#/, ""));
    const allowed = {
        solid: Object.keys(SOLIDS), number: NUMBERS, type: NUMBERS, tier: TIERS, scene: Object.keys(SCENES),
    };
    for (const [key, value] of Object.entries(INITIAL)) {
        const text = given.get(key);
        if (text === null) continue;
        if (allowed[key]) {
            if (allowed[key].includes(text)) state[key] = text;
        } else if (Array.isArray(value)) {
            const parts = text.split(","), list = parts.map(Number);
            const isList = list.length === 3 && parts.every((part) => part.trim()) && list.every(Number.isFinite);
            if (isList) state[key] = list;
        } else if (key === "back") {
            if (/^[0-4]$/.test(text)) state[key] = Number(text);
        } else if (text.trim() && Number.isFinite(Number(text))) {
            state[key] = Number(text);
        }
    }
    if (!tiersOf(state.number).includes(state.tier)) state.tier = "Stable";
    return state;
}

function linkOf(state) {
    const changed = Object.entries(state).filter(([key, value]) => String(value) !== String(INITIAL[key]));
    return `#${new URLSearchParams(changed.map(([key, value]) => [key, String(value)]))}`;
}
