// The page without a browser: answers of its worker that come late, fail, or end it.

import assert from "node:assert/strict";
import test from "node:test";

/** Elements of the page by their ids, made when they are asked for. */
const elements = new Map();
const element = () => ({
  textContent: "", value: "8", classList: { toggle() {} }, getContext: () => null,
  addEventListener() {}, setAttribute() {}, removeAttribute() {}, replaceChildren() {},
});
const $ = (id) => {
  if (!elements.has(id)) elements.set(id, element());
  return elements.get(id);
};
/** Workers, the last one first, each with what it was asked. */
const workers = [];
class Worker {
  asked = [];
  constructor() { workers.unshift(this); }
  postMessage(question) {
    this.asked.push(question);
    if (question.call === "load") this.answer(question, { version: "0", ms: 1 });
    if (question.call === "cloth") this.answer(question, { faces: [], x: [], thickness: 0.008 });
  }
  answer({ id }, answer) { queueMicrotask(() => this.onmessage({ data: { id, answer } })); }
  fail({ id }, error, ended) { this.onmessage({ data: { id, error, ended } }); }
  terminate() { this.ended = true; }
  calls() { return this.asked.map(({ call }) => call); }
}
Object.defineProperty(globalThis, "navigator", { value: {}, configurable: true });
Object.assign(globalThis, {
  Worker,
  document: { getElementById: $, createElement: element },
  matchMedia: () => ({ matches: true }),
  requestAnimationFrame() {},
  addEventListener() {},
});
await import("../page/main.js");

const settled = () => new Promise((go) => setTimeout(go, 5));
const perKind = { vf: 0, ee: 0, ve: 0, vv: 0 };
const result = (toi) => ({
  counts: { contacts: perKind, candidates: perKind }, toi, undecided: 0, loading: 1, backend: "gpu",
  ms: { total: 1 }, faces: [], x0: [], x1: [], points: [], times: [],
});
const file = (name) => ({ name, arrayBuffer: async () => new ArrayBuffer(1) });
/** Chooses files, and waits until they are read. */
async function choose(...files) {
  $("pick").files = files;
  $("pick").onchange();
  await settled();
}

test("an answer that comes after a later question is not shown", async () => {
  const [worker] = workers;
  await choose(file("p2"), file("p1"));
  await choose(file("q1"), file("q2"));
  const [p, q] = worker.asked.slice(-2);
  assert.deepEqual(p.given.files.map(({ name }) => name), ["p1", "p2"]);
  worker.answer(q, result(0.5));
  await settled();
  worker.answer(p, result(null));
  await settled();
  assert.equal($("first").textContent, "From q1 to q2: first contact after 50.0 % of the step.");
  assert.equal($("which").textContent, "Start: q1, end: q2");
  $("download").onclick();
  assert.deepEqual(worker.asked.at(-1).given, { check: q.given.check });
  // Nor an error, nor while it is the files that are swapped.
  $("exact").onchange();
  $("swap").onclick();
  const [late, swapped] = worker.asked.slice(-2);
  worker.fail(late, "late");
  await settled();
  assert.equal($("error").textContent, "");
  worker.answer(swapped, result(null));
  await settled();
  assert.equal($("first").textContent, "No contact from q2 to q1.");
});

test("what went wrong with files is said, and no result is shown", async () => {
  const folder = { name: "folder", arrayBuffer: () => Promise.reject(new Error("not found")) };
  const [worker] = workers;
  $("exact").onchange();
  const late = worker.asked.at(-1);
  await choose(file("a"), folder);
  worker.answer(late, result(0.5));
  await settled();
  assert.match($("error").textContent, /^folder cannot be read.* not found/);
  assert.deepEqual([$("first").textContent, $("result").hidden], ["", true]);
  await choose(file("a"));
  assert.match($("error").textContent, /^Two files are needed/);
  await choose(file("a"), file("b"));
  worker.answer(worker.asked.at(-1), result(0.5));
  await settled();
  assert.deepEqual([$("error").textContent, $("result").hidden], ["", false]);
  $("download").onclick();
  worker.fail(worker.asked.at(-1), "gone");
  await settled();
  assert.deepEqual([$("error").textContent, $("result").hidden], ["gone", true]);
});

test("after a step that failed comes another, after the module's end another worker", async () => {
  const [worker] = workers;
  for (let i = 0; i < 2; i++) {
    const before = worker.asked.length;
    $("step").onclick();
    assert.deepEqual(worker.calls().slice(before), ["step"]);
    worker.fail(worker.asked.at(-1), "once");
    await settled();
    assert.equal($("backend").textContent, "Error: once");
  }
  $("step").onclick();
  worker.fail(worker.asked.at(-1), "unreachable", true);
  await settled();
  assert.ok(worker.ended);
  $("step").onclick();
  await settled();
  $("step").onclick();
  assert.deepEqual(workers[0].calls(), ["cloth", "step"]);
  assert.match($("backend").textContent, /^Version 0/);
});
