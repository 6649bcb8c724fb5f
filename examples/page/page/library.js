// The library in WebAssembly, as functions of names and lists of numbers.

const NUMBERS = ["f32", "I16F16", "f64"], TIERS = ["Plain", "Fast", "Stable", "Exact"];
const PARTS = ["side", "base", "top", "left", "right", "back", "front"], CROSSINGS = ["enters", "exits", "touches"];

/** The tiers of a number type. */
const tiersOf = (number) => (number === "f64" ? TIERS.slice(0, 3) : TIERS);

/** The solids in the order of the library's numbers: what their sizes are, and values to begin with. */
const SOLIDS = {
    "sphere": { radius: 1 },
    "cylinder": { radius: 0.8, height: 1.6 },
    "open cylinder": { radius: 0.8, height: 1.6 },
    "cone": { slope: 0.6, height: 1.6 },
    "double cone": { slope: 0.5 },
    "frustum": { "base radius": 1, "top radius": 0.4, height: 1.4 },
    "capsule": { radius: 0.6, height: 1.2 },
    "box": { "half x": 1, "half y": 0.7, "half z": 0.8 },
};

/** The library's module: text in which a character is a byte, and `=` stands before one that is moved by 64. */
async function loaded(text) {
    const characters = new TextDecoder("windows-1252").decode(Uint8Array.from({ length: 256 }, (_, i) => i));
    const byteOf = new Map([...characters].map((character, byte) => [character, byte]));
    const packed = [];
    for (let i = 0; i < text.length; i++) {
        packed.push(text[i] === "=" ? byteOf.get(text[++i]) ^ 64 : byteOf.get(text[i]));
    }
    const module = Uint8Array.from(LZMA.decompress(packed));
    const { instance } = await WebAssembly.instantiate(module);
    return new Library(instance.exports);
}

class Library {
    constructor(exports) {
        this.exports = exports;
    }

    /** What a function answers with, given these numbers; fails with the library's own words. */
    ask(name, numbers, ...rest) {
        const at = this.exports.numbers();
        // Each time anew: when its memory grows, an earlier view of it is void.
        const list = () => new Float64Array(this.exports.memory.buffer, at, 3072);
        list().set(numbers);
        const count = this.exports[name](...rest);
        if (count >= 0) return list().slice(0, count);
        const [place, length] = [this.exports.reason(), this.exports.reason_length()];
        throw new Error(new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, place, length)));
    }

    /** A world in one number type, with these solids. */
    world(number, solids) {
        return new World(this, NUMBERS.indexOf(number), solids);
    }
}

class World {
    constructor(library, number, solids) {
        Object.assign(this, { library, number, solids, rays: 0 });
        library.exports.clear(number);
        for (const { name, sizes, base, axis } of solids) {
            const three = [...sizes, 0, 0, 0].slice(0, 3);
            library.ask("place", [...three, ...base, ...axis], number, Object.keys(SOLIDS).indexOf(name));
        }
    }

    /** Adds a ray: its number. */
    aim(origin, direction) {
        this.library.ask("aim", [...origin, ...direction], this.number);
        return this.rays++;
    }

    look({ position, target, angle = 0, height = 0 }, [columns, rows]) {
        this.library.ask("look", [...position, ...target], this.number, angle, height, columns, rows);
    }

    /** A solid as it is stored. */
    solid(index) {
        const numbers = this.library.ask("solid", [], this.number, index);
        const [sizes, position] = [0, 3].map((i) => [...numbers.slice(i, i + 3)]);
        return { name: this.solids[index].name, sizes, position, axes: [...numbers.slice(6)] };
    }

    /** A ray as it is stored. */
    ray(index) {
        return this.asRay(this.library.ask("ray", [], this.number, index));
    }

    rayOfPixel(x, y) {
        return this.asRay(this.library.ask("ray_of_pixel", [], this.number, x, y));
    }

    asRay(numbers) {
        return { origin: [...numbers.slice(0, 3)], direction: [...numbers.slice(3, 6)] };
    }

    hits(tier, solid, ray) {
        const numbers = this.library.ask("hits", [], this.number, TIERS.indexOf(tier), solid, ray), hits = [];
        for (let i = 0; i < numbers.length; i += 9) {
            const [t, part, crossing, ...rest] = numbers.slice(i, i + 9);
            hits.push({ t, part, crossing, point: rest.slice(0, 3), normal: rest.slice(3) });
        }
        return hits;
    }

    /** Nanoseconds that all hits of a ray with the first solid take, about: a round of some milliseconds. */
    cost(tier) {
        const start = performance.now();
        let times = 0, passed = 0;
        for (let more = 1; passed < 4; more *= 2) {
            this.library.exports.repeated(this.number, TIERS.indexOf(tier), more);
            times += more;
            passed = performance.now() - start;
        }
        return (passed / times / this.rays) * 1e6;
    }

    /** Of each pixel of a row: the nearest solid or -1, t, the cosine between normal and ray. */
    row(tier, y) {
        return this.library.ask("row", [], this.number, TIERS.indexOf(tier), y);
    }
}
