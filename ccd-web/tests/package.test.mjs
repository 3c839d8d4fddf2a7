// The package as a user meets it: loading, errors, buffers, a worker.

import assert from "node:assert/strict";
import { copyFileSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";
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
  // Another load would replace the module of this one.
  const loading = init();
  assert.throws(() => initSync(readFileSync(wasmUrl)), /in flight: await it/);
  await loading;
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
  // Numbers that could be cut anew into rows of the right length.
  const quads = [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11]];
  refused(() => new Mesh(12, null, quads), /^faces: row 0 is a list of 4; rows have 3 ids/);
  refused(() => new Mesh(12, [[0, 1], [2, 3, 4], [5]], []), /^edges: row 1 is a list of 3; .* 2/);
  refused(() => new Mesh(12, null, [[0, 1, 2], 3, 4, 5]), /^faces: row 1 is 3; rows have 3 ids/);
  refused(() => new Mesh(12, null, [[], [0, 1, 2]]), /^faces: row 0 is a list of 0/);
  const threes = { ofVertex: [0, 0, 0, 1], excluded: [[0, 1, 2], [0, 1, 2]] };
  refused(() => new Session(floor(), { bodies: threes }), /^bodies.excluded: row 0 .* of 3; .* 2/);
  refused(() => new Session(floor(), { mode: "fast" }), /conservative/);
  refused(() => new Session(floor(), { minDistance: -1 }), /-1/);
  refused(() => new Session(floor(), { thickness: 1 }), /no option thickness/);
  refused(() => new Session(floor(), { bodies: { ofVertex: [0] } }), /bod/);
  const named = { ofVertex: [0, 0, 0, 1], sleeping: [1] };
  refused(() => new Session(floor(), { bodies: named }), /^there is no rule bodies.sleeping/);
  const session = new Session(floor());
  refused(() => session.step(x0, x1.subarray(3)), /x1 has 9 numbers/);
  refused(() => session.step([0], x1), /x0 is neither/);
  refused(() => session.step(x0, x1.with(4, Number.NaN)), /vertex 1.*NaN/);
  refused(() => session.step(x0, x1, { window: [0.5, 0.25] }), /0.5/);
  // It stays usable.
  assert.equal(session.step(x0, x1).contacts.length, 1);
});

test("numbers that WebAssembly would make of other values are refused", () => {
  const bodies = { ofVertex: [0, 0, 0, 1] };
  const session = new Session(floor(), { bodies });
  const values = [undefined, null, NaN, -1, 0.5, "1", 2 ** 32, 1n, Symbol("x")];
  for (const value of values) {
    for (const call of ["setFixed", "setSleeping"]) {
      const text = `body is ${String(value)};`;
      assert.throws(() => session[call](value, true), (why) => why.message.startsWith(text));
    }
  }
  // No body sleeps.
  assert.equal(session.step(x0, x1).contacts.length, 1);
  session.setSleeping(0, true);
  session.setSleeping(1, true);
  assert.equal(session.step(x0, x0).contacts.length, 0);
  for (const maxMemory of [NaN, -1, "5"]) {
    assert.throws(() => new Session(floor(), { maxMemory }), /maxMemory is (NaN|-1|5); it must be/);
  }
  assert.equal(new Session(floor(), { maxMemory: Infinity }).step(x0, x1).contacts.length, 1);
  const own = new Session(floor());
  for (const window of [null, [0], [0, 1, 2], 5]) {
    assert.throws(() => own.step(x0, x1, { window }), /window is .*; it must be a list of two/);
  }
  assert.throws(() => own.step(x0, x1, { window: ["0", 1] }), /window\[0\] is 0; it must be a n/);
  assert.throws(() => new Mesh(6, [0, 1, 2, 3, 4, 5]), /faces are missing/);
  assert.throws(() => new Mesh(6, [0, 1, 2, 3, 4, 5], null), /faces are missing/);
});

test("freeing twice does nothing, and what was freed says so", async () => {
  const mesh = floor();
  const session = new Session(mesh);
  mesh.free();
  mesh.free();
  assert.throws(() => mesh.edges, /^Error: the mesh was freed/);
  assert.throws(() => new Session(mesh), /^Error: the mesh was freed/);
  assert.equal(session.step(x0, x1).contacts.length, 1);
  session.free();
  session.free();
  const calls = [
    () => session.step(x0, x1), () => session.earliestToi(x0, x1), () => session.setFixed(0, true),
    () => session.positions(Float32Array), () => session.intersections(x0),
  ];
  for (const call of calls) assert.throws(call, /^Error: the session was freed/);
  await assert.rejects(session.stepAsync(x0, x1), /^Error: the session was freed/);
});

test("a module that was loaded from bytes is asked for no more", async () => {
  const folder = mkdtempSync(join(tmpdir(), "meshccd-"));
  try {
    const names = ["index.js", "input.js", "output.js", "meshccd.js", "package.json"];
    for (const name of names) copyFileSync(`pkg/${name}`, join(folder, name));
    const alone = await import(pathToFileURL(join(folder, "index.js")));
    alone.initSync(readFileSync(wasmUrl));
    await alone.init();
    const mesh = new alone.Mesh(4, null, [0, 1, 2]);
    assert.equal((await alone.Session.open(mesh, { device: "cpu" })).backend, "cpu");
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("bundlers for browsers meet no module of Node", () => {
  for (const name of ["index.js", "gpu.js", "input.js", "output.js"]) {
    const text = readFileSync(`pkg/${name}`, "utf8");
    assert.ok(!/(import\(|from) *["'`]node:/.test(text), name);
  }
  assert.match('await import("node:fs/promises")', /(import\(|from) *["'`]node:/);
});

test("the session's buffers are kept by a call in which the module's memory grows", () => {
  // Rods side by side, all of which touch. Before other tests have the memory grow by more.
  const n = 1000;
  const x = Float64Array.from({ length: 6 * n }, (_, i) => [i / 6e4, i % 6 < 3, 0][i % 3]);
  const rods = Uint32Array.from({ length: 2 * n }, (_, v) => v);
  const session = new Session(new Mesh(2 * n, rods, []), { minDistance: 1 });
  const own = session.positions(Float64Array);
  own.x1.fill(7);
  assert.equal(session.step(x, x).contacts.length, n * (n - 1) / 2);
  assert.equal(own.x1.length, 0);
  const again = session.positions(Float64Array);
  assert.ok(again.x0.every((c) => c === 0) && again.x1.every((c) => c === 7));
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

/** Typed arrays as lists, because a failure of bits is read more easily so. */
const lists = (...all) => all.map((x) => [...x]);

test("views of the session's buffers in any place: as copies of them, and none is changed", () => {
  // The particle goes past the face.
  const past = x1.with(9, 5);
  for (const Type of [Float32Array, Float64Array]) {
    const other = Type === Float32Array ? Float64Array : Float32Array;
    const session = new Session(floor());
    const own = session.positions(Type);
    const far = new Session(floor()).positions(Type);
    const pairs = [
      [own.x0, own.x1], [own.x1, own.x0], [own.x0, own.x0], [own.x1, own.x1],
      [own.x0, Type.from(past)], [Type.from(past), own.x1], [own.x1, Type.from(past)],
      [Type.from(past), own.x0], [far.x1, far.x0], [own.x1, far.x0],
      [Type.from(x0), Type.from(past)],
      [own.x1, other.from(past)], [other.from(past), own.x0],
    ];
    for (const [p, q] of pairs) {
      own.x0.set(x0);
      own.x1.set(x1);
      far.x0.set(past);
      far.x1.set(x0);
      const before = lists(own.x0, own.x1, p, q);
      const alone = new Session(floor());
      const copies = [p, q].map((x) => x.slice());
      const { ms: _, ...want } = alone.step(...copies, { geometry: true });
      const { ms, ...got } = session.step(p, q, { geometry: true });
      assert.deepEqual(got.contacts, want.contacts);
      assert.equal(got.toi, want.toi);
      assert.equal(session.earliestToi(p, q), alone.earliestToi(...copies));
      assert.deepEqual(session.firstContact(p, q), alone.firstContact(...copies));
      assert.deepEqual(session.candidates(p, q), alone.candidates(...copies));
      assert.deepEqual(lists(own.x0, own.x1, p, q), before);
      // Refused input changes them no more than any other does.
      assert.throws(() => session.step(q, p.map(() => Number.NaN)), /NaN/);
      assert.deepEqual(lists(own.x0, own.x1, p, q), before);
    }
  }
});

test("steps to and fro between both buffers", () => {
  const session = new Session(floor());
  let { x0: now, x1: next } = session.positions(Float64Array);
  const height = [1, 0.5, -0.5, 0.25, 0.75];
  now.set(x0);
  const found = height.slice(1).map((y) => {
    next.set(x0.with(10, y));
    const { toi } = session.step(now, next);
    [now, next] = [next, now];
    return toi && Math.round(toi * 1e4) / 1e4;
  });
  assert.deepEqual(found, [null, 0.5, 0.6667, null]);
});

test("views of a buffer as numbers of another precision are converted", () => {
  const session = new Session(floor());
  const { x0: first, x1: second } = session.positions(Float64Array);
  const want = session.earliestToi(x0, x1);
  assert.equal(want, 0.5);
  for (const buffer of [first, second]) {
    for (const skipped of [0, 24, 48]) {
      const inside = new Float32Array(buffer.buffer, buffer.byteOffset + skipped, 12);
      for (const [x, call] of [
        [x0, () => session.earliestToi(inside, x1)],
        [x1, () => session.earliestToi(x0, inside)],
      ]) {
        inside.set(x);
        const before = lists(first, second);
        assert.ok(Math.abs(call() - want) < 1e-6);
        assert.deepEqual(lists(first, second), before);
      }
    }
  }
  // Those that `positions` has of the other precision are other buffers.
  const { x0: single } = session.positions(Float32Array);
  single.set(x0);
  first.fill(0);
  assert.ok(Math.abs(session.earliestToi(single, x1) - want) < 1e-6);
  assert.deepEqual(lists(single, first), lists(Float32Array.from(x0), first.map(() => 0)));
});

test("a search of intersections leaves the session's buffers as they are", () => {
  const session = new Session(floor());
  for (const Type of [Float32Array, Float64Array]) {
    const own = session.positions(Type);
    const want = new Session(floor()).earliestToi(x0, x1);
    for (const x of [own.x0, own.x1, Type.from(x1), x1]) {
      own.x0.set(x0);
      own.x1.set(x1);
      assert.deepEqual(session.intersections(x), []);
      assert.equal(session.hasIntersections(x), false);
      assert.deepEqual(lists(own.x0, own.x1), lists(Type.from(x0), Type.from(x1)));
      assert.equal(session.earliestToi(own.x0, own.x1) > 0.49, want > 0.49);
    }
  }
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
