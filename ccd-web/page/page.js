// What the parts of the page share: elements, numbers as text, tables, and the worker.

export const $ = (id) => document.getElementById(id);
export const NAMES = { cpu: "CPU (WebAssembly)", gpu: "GPU (WebGPU)" };
export const ms = (t) => `${t.toFixed(t < 9.95 ? 1 : 0)} ms`;
export const count = (n) => n.toLocaleString("en");
export const stages = (t) => [
  ["boxes", ms(t.boxes)], ["trees", ms(t.build)], ["candidates", ms(t.traverse)],
  ["decisions", ms(t.narrow)], ["copies", ms(t.copy)],
];

/** Rows of a table of names and values. */
export function table(id, rows) {
  $(id).replaceChildren(...rows.flatMap(([name, value]) => {
    const cells = [document.createElement("dt"), document.createElement("dd")];
    [name, value].forEach((text, i) => { cells[i].textContent = text; });
    return cells;
  }));
}

let worker = null;
const waiting = new Map();
const listeners = [];
let asked = 0;

/** Asks the worker; one answer for each question. */
export function ask(call, given) {
  worker ??= begin();
  return new Promise((resolve, reject) => {
    waiting.set(++asked, { resolve, reject });
    worker.postMessage({ id: asked, call, given });
  });
}

/** Calls a function whenever a worker ended: the next one knows nothing of what was before. */
export const onEnded = (call) => { listeners.push(call); };

function begin() {
  const mine = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
  let started = false;
  mine.onmessage = ({ data: { id, answer, error, ended } }) => {
    started = true;
    if (ended) return end(error);
    const { resolve, reject } = waiting.get(id);
    waiting.delete(id);
    if (error === undefined) resolve(answer);
    else reject(new Error(error));
  };
  mine.onerror = ({ message }) => {
    if (!started) end(`the worker could not start: ${message ?? "no reason given"}`);
  };
  return mine;
}

/** Ends the worker; the next question goes to a new one. */
function end(reason) {
  worker.terminate();
  worker = null;
  const all = [...waiting.values()];
  waiting.clear();
  listeners.forEach((call) => call());
  all.forEach(({ reject }) => reject(new Error(reason)));
}
