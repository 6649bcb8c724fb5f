const plus = (a, b) => a.map((x, i) => x + b[i]);
const minus = (a, b) => a.map((x, i) => x - b[i]);
const times = (a, s) => a.map((x) => x * s);
const inner = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (a) => times(a, 1 / Math.hypot(...a));

/** An element with attributes; in SVG if it is one of its shapes. */
function element(name, attributes = {}, ...children) {
    const isOfSvg = /^(line|circle|path|text|g|title)$/.test(name);
    const made = isOfSvg ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    made.append(...children);
    return made;
}

const find = (id) => document.getElementById(id);

/** Lets the browser answer whoever uses the page. */
const pause = () => new Promise((resume) => setTimeout(resume));

/** A row of a table, the first cell of which is a heading. */
function rowOf(cells) {
    return element("tr", {}, ...cells.map((cell, i) => element(i ? "td" : "th", i ? {} : { scope: "row" }, cell)));
}
