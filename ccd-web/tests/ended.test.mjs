// A GPU module that an exception ends, played by a module whose steps are never settled.

import assert from "node:assert/strict";
import { copyFileSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";

/** Bindings in place of those of the module with the kernels. */
const PLAYED = `
import { initSync, RawMesh, RawOptions, RawSession } from "./meshccd.js";
export { RawMesh, RawOptions };
export default () => initSync();
export const state = { told: null, cutOff: false };
export const on_panic = (told) => { state.told = told; };
export const is_cut_off = () => state.cutOff;
export class RawDevice {
  static open = async () => new RawDevice();
  name = () => "played";
  is_emulated = () => false;
  is_lost = () => false;
}
export class RawGpuSession {
  constructor(device, mesh, options) { this.inner = new RawSession(mesh, options); }
  positions(wide) { return this.inner.positions(wide); }
  step() { return new Promise(() => {}); }
  earliest_toi() { return new Promise(() => {}); }
  set_min_distance() { if (state.told.ended) throw new Error("borrowed"); }
  free() { throw new Error("borrowed"); }
}`;

Object.defineProperty(globalThis, "navigator", { value: { gpu: {} }, configurable: true });
const n = 110;
const x0 = Float64Array.from({ length: 3 * n * n + 3 }, (_, i) => {
  const v = Math.floor(i / 3);
  return [v % n, 0, Math.floor(v / n)][i % 3];
});
x0.set([10.25, 1, 10.25], 3 * n * n);
const x1 = x0.slice();
x1[3 * n * n + 1] = -1;
const faces = [];
for (let v = 0; v + n + 1 < n * n; v++) {
  if (v % n < n - 1) faces.push([v, v + 1, v + n], [v + 1, v + n + 1, v + n]);
}

/** Calls a function with a package of its own, that mesh, and the state of the played module. */
async function withPackage(call) {
  const folder = mkdtempSync(join(tmpdir(), "meshccd-"));
  const names = ["index.js", "gpu.js", "input.js", "output.js", "meshccd.js", "meshccd_bg.wasm",
    "package.json"];
  try {
    for (const name of names) copyFileSync(`pkg/${name}`, join(folder, name));
    writeFileSync(join(folder, "meshccd_gpu.js"), PLAYED);
    writeFileSync(join(folder, "meshccd_gpu_bg.wasm"), "");
    const url = (name) => pathToFileURL(join(folder, name));
    const { init, Mesh, Session } = await import(url("index.js"));
    await init();
    const { state } = await import(url("meshccd_gpu.js"));
    await call(Session, new Mesh(n * n + 1, null, faces), state);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const WHY = /^Error: the GPU module ended: out of memory$/;
const PENDING = Symbol("pending");
const soon = (call) => Promise.race([call, new Promise((go) => setTimeout(go, 50, PENDING))]);

test("after a panic `gpu` is an error with the reason, and the CPU takes over `auto`", () => (
  withPackage(async (Session, mesh, state) => {
    const [gpu, auto, idle] = await Promise.all(["gpu", "auto", "auto"].map((device) => (
      Session.open(mesh, { device })
    )));
    assert.deepEqual([gpu, auto, idle].map(({ backend }) => backend), ["gpu", "gpu", "gpu"]);
    const flights = [gpu.stepAsync(x0, x1), auto.stepAsync(x0, x1)];
    assert.equal(await soon(Promise.race(flights)), PENDING);
    assert.throws(() => gpu.free(), /in flight/);
    state.told("out of memory");
    await assert.rejects(flights[0], WHY);
    const report = await flights[1];
    assert.deepEqual([report.backend, report.contacts.length], ["cpu", 1]);
    assert.match(auto.whyCpu, /the GPU module ended: out of memory/);
    assert.equal((await idle.stepAsync(x0, x1)).backend, "cpu");
    // The session on the CPU goes on, and what the module still borrows is left alone.
    await assert.rejects(gpu.earliestToiAsync(x0, x1), WHY);
    gpu.setMinDistance(0.1);
    assert.equal(gpu.step(x0, x1).contacts.length, 1);
    gpu.free();
    await assert.rejects(Session.open(mesh, { device: "gpu" }), WHY);
    const last = await Session.open(mesh);
    assert.equal(last.backend, "cpu");
    assert.match(last.whyCpu, /the GPU module ended/);
  })
));

test("a trap that nothing caught ends calls in flight; exceptions of others do not", () => (
  withPackage(async (Session, mesh, state) => {
    const event = "uncaughtExceptionMonitor";
    const session = await Session.open(mesh, { device: "gpu" });
    assert.equal(process.listenerCount(event), 0);
    const flight = session.stepAsync(x0, x1);
    process.emit(event, new Error("of another program"), "uncaughtException");
    assert.equal(await soon(flight), PENDING);
    state.cutOff = true;
    process.emit(event, new WebAssembly.RuntimeError("out of memory"), "uncaughtException");
    await assert.rejects(flight, WHY);
    assert.equal(process.listenerCount(event), 0);
  })
));
