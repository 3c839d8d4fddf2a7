// Sessions that are opened on a device: under Node there is no WebGPU, so the CPU's answers.

import assert from "node:assert/strict";
import test from "node:test";
import { init, Mesh, Session } from "../pkg/index.js";
import { scene } from "../page/example.js";

await init();
const { x0, x1, faces } = scene();
const [a, b] = [x0, x1].map((x) => Float64Array.from(x));
const mesh = new Mesh(a.length / 3, null, faces);

test("awaited calls are those that return at once", async () => {
  const want = new Session(mesh).step(a, b, { geometry: true }).contacts;
  assert.ok(want.length > 200);
  for (const device of ["cpu", "auto", undefined]) {
    const session = await Session.open(mesh, { device });
    const { contacts, backend, toi } = await session.stepAsync(a, b, { geometry: true });
    assert.deepEqual(contacts, want);
    assert.equal(backend, "cpu");
    assert.equal(await session.earliestToiAsync(a, b), toi);
    assert.equal(session.whyCpu === null, device === "cpu");
    await assert.rejects(session.stepAsync(a.subarray(3), b), /the mesh has/);
    session.free();
  }
});

test("positions of awaited calls are those at the time of the call", async () => {
  const session = await Session.open(mesh, { device: "cpu" });
  const { contacts } = session.step(a, b, { window: [0, 0.5] });
  const toi = session.earliestToi(a, b);
  assert.ok(contacts.length > 10);
  const own = Object.values(session.positions(Float64Array));
  for (const copies of [[a, b].map((x) => x.slice()), own]) {
    const reset = () => copies.forEach((x, i) => x.set([a, b][i]));
    const window = [0, 0.5];
    reset();
    const step = session.stepAsync(...copies, { window });
    window[1] = 1;
    copies[1].set(a);
    assert.deepEqual((await step).contacts, contacts);
    reset();
    const earliest = session.earliestToiAsync(...copies);
    copies[1].set(a);
    assert.equal(await earliest, toi);
  }
});

test("a GPU that is not there is an error, or the CPU's turn", async () => {
  await assert.rejects(Session.open(mesh, { device: "gpu" }), /there is no WebGPU here/);
  await assert.rejects(Session.open(mesh, { device: "tpu" }), /must be one of auto, cpu, gpu/);
  await assert.rejects(Session.open(mesh, { device: "cpu", mode: "fast" }), /mode is "fast"/);
  const n = 110;
  const grid = [];
  for (let v = 0; v + n + 1 < n * n; v++) {
    if (v % n < n - 1) grid.push([v, v + 1, v + n], [v + 1, v + n + 1, v + n]);
  }
  const large = await Session.open(new Mesh(n * n, null, grid));
  assert.equal(large.backend, "cpu");
  assert.match(large.whyCpu, /no WebGPU/);
});
