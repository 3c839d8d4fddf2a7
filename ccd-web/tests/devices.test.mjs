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
