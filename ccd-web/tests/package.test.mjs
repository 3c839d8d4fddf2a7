// The package as a user meets it: loading, errors, buffers, a worker.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { Worker } from "node:worker_threads";
import { init, initSync, KINDS, Mesh, Session, STATES, version, wasmUrl } from "../pkg/index.js";

/** A floor of one face, and a particle that falls through it half way. */
const x0 = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 0, 1, 0.2, 1, 0.2);
const x1 = Float64Array.of(0, 0, 0, 1, 0, 0, 0, 0, 1, 0.2, -1, 0.2);
const floor = () => new Mesh(4, null, [0, 1, 2]);

test("nothing works before the module is loaded, and says so", () => {
  assert.throws(floor, /await init\(\)/);
});

test("a source that is no module is refused, and another one may follow", async () => {
  await assert.rejects(init(new Uint8Array([1, 2, 3])), WebAssembly.CompileError);
  await init();
  await init();
  initSync(new Uint8Array());
  assert.equal(version(), JSON.parse(readFileSync("pkg/package.json", "utf8")).version);
});

test("a step, in both precisions", () => {
  const session = new Session(floor());
  for (const Type of [Float32Array, Float64Array]) {
    const report = session.step(Type.from(x0), Type.from(x1), { geometry: true });
    const { contacts, counts, ms } = report;
    assert.deepEqual([contacts.length, KINDS[contacts.kind[0]], ...contacts.ids], [1, "vf", 3, 0]);
    assert.equal(STATES[contacts.state[0]], "hit");
    assert.ok(report.toi === contacts.toi[0] && report.toi <= 0.5 && report.toi > 0.5 - 1e-6);
    assert.deepEqual([...contacts.vertices], [3, 0, 1, 2]);
    assert.deepEqual([...contacts.point].map((c) => Math.round(c * 1e6) / 1e6), [0.2, 0, 0.2]);
    assert.deepEqual([...contacts.normal].map(Math.abs), [0, 1, 0]);
    assert.deepEqual([counts.contacts.vf, counts.candidates.vf, report.undecided], [1, 1, 0]);
    assert.ok(Object.values(ms).every((t) => t >= 0) && ms.total > 0, JSON.stringify(ms));
    assert.equal(report.backend, "cpu");
  }
  assert.equal(session.step(x0, x1, { window: [0, 0.25] }).contacts.length, 0);
  assert.equal(session.step(x0, x0).toi, null);
  session.free();
});

test("times, sizes, the first contact", () => {
  const bodies = { ofVertex: [0, 0, 0, 1], fixed: [0] };
  const session = new Session(floor(), { bodies });
  const toi = session.earliestToi(x0, x1);
  assert.ok(toi <= 0.5 && toi > 0.5 - 1e-6);
  assert.equal(session.collisionFreeStepsize(x0, x1), toi);
  assert.equal(session.isStepCollisionFree(x0, x1), false);
  assert.equal(session.collisionFreeStepsize(x0, x0), 1);
  const hit = session.firstContact(x0, x1);
  assert.deepEqual([hit.kind, hit.state, hit.features, hit.bodies], ["vf", "hit", [3, 0], [1, 0]]);
  assert.deepEqual(hit.vertices, [3, 0, 1, 2]);
  assert.ok(hit.distance >= 0 && hit.distance < 1e-5 && hit.weights[0] === 1);
  assert.equal(session.firstContact(x0, x0), null);
  // The face moves, although its body is fixed.
  assert.throws(() => session.step(x0, x1.map((c) => c + 1)), /fixed/);
});

test("options reach the session", () => {
  const contacts = (options) => new Session(floor(), options).step(x0, near).contacts.length;
  const near = x1.slice();
  near[10] = 0.1;
  assert.equal(contacts({}), 0);
  assert.equal(contacts({ minDistance: 0.2 }), 1);
  assert.equal(contacts({ minDistance: 0.2, leaveContact: true }), 1);
  const apart = { ofVertex: [0, 0, 0, 1], excluded: [[0, 1]] };
  assert.equal(contacts({ minDistance: 0.2, bodies: apart }), 0);
  const session = new Session(floor(), { mode: "exact" });
  assert.equal(session.step(x0, x1).toi, 0.5);
  session.setMinDistance(0);
  assert.throws(() => session.setMinDistance(0.1), /exact/);
});

test("what is refused is an Error with the library's text", () => {
  const refused = (call, text) => assert.throws(call, (why) => {
    assert.ok(why instanceof Error && !(why instanceof TypeError), String(why));
    assert.match(why.message, text);
    return true;
  });
  refused(() => new Mesh(2, null, [0, 1, 2]), /vertex 2/);
  refused(() => new Mesh(4, [0], []), /2 ids/);
  refused(() => new Mesh(4, null, [0, 1.5, 2]), /entry 1 is 1.5/);
  refused(() => new Mesh(-1, null, []), /nVertices/);
  refused(() => new Session(floor(), { mode: "fast" }), /conservative/);
  refused(() => new Session(floor(), { minDistance: -1 }), /-1/);
  refused(() => new Session(floor(), { thickness: 1 }), /no option thickness/);
  refused(() => new Session(floor(), { bodies: { ofVertex: [0] } }), /bod/);
  const session = new Session(floor());
  refused(() => session.step(x0, x1.subarray(3)), /x1 has 9 numbers/);
  refused(() => session.step([0], x1), /x0 is neither/);
  refused(() => session.step(x0, x1.with(4, Number.NaN)), /vertex 1.*NaN/);
  refused(() => session.step(x0, x1, { window: [0.5, 0.25] }), /0.5/);
  // It stays usable.
  assert.equal(session.step(x0, x1).contacts.length, 1);
});

test("positions written into the session's buffers, and results as views", () => {
  const session = new Session(floor());
  const own = session.positions(Float64Array);
  own.x0.set(x0);
  own.x1.set(x1);
  const place = own.x0.byteOffset;
  assert.equal(session.step(own.x0, own.x1).contacts.length, 1);
  const again = session.positions(Float64Array);
  assert.ok(again.x0.byteOffset === place && again.x1[10] === -1);
  const { contacts } = session.step(again.x0, again.x1, { views: true });
  assert.equal(contacts.toi.buffer, again.x0.buffer);
  assert.notEqual(session.step(x0, x1).contacts.toi.buffer, again.x0.buffer);
  assert.equal(session.candidates(x0, x1, { views: true }).vf.buffer, again.x0.buffer);
  // Memory grows: the old views are empty, and refused rather than read.
  const large = new Session(new Mesh(3_000_000, null, []));
  large.positions(Float64Array);
  assert.equal(again.x0.length, 0);
  assert.throws(() => session.step(again.x0, again.x1), /older than its last growth/);
  large.free();
});

test("intersections", () => {
  const mesh = new Mesh(6, null, [0, 1, 2, 3, 4, 5]);
  const x = Float32Array.of(0, 0, 0, 2, 0, 0, 0, 0, 2, 0.5, -1, 0.5, 0.5, 1, 0.5, 0.6, 1, 9);
  const session = new Session(mesh);
  const all = session.intersections(x);
  const ends = ({ edge, face }) => [face, ...mesh.edges.slice(2 * edge, 2 * edge + 2)].join(" ");
  assert.ok(all.map(ends).includes("0 3 4") && session.hasIntersections(x));
  x[10] += 3;
  x[13] += 3;
  x[16] += 3;
  assert.ok(!session.hasIntersections(x));
});

test("a worker, from a compiled module", async () => {
  const module = await WebAssembly.compile(readFileSync(wasmUrl));
  const worker = new Worker(new URL("./worker.mjs", import.meta.url), { workerData: module });
  const toi = await new Promise((resolve, reject) => {
    worker.once("message", resolve);
    worker.once("error", reject);
    worker.postMessage({ x0, x1 });
  });
  await worker.terminate();
  assert.equal(toi, new Session(floor()).earliestToi(x0, x1));
});
