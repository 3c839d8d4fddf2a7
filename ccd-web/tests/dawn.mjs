// Program of dawn.test.mjs: answers calls on a device of Dawn, until it is killed. Not in the
// process of the tests, because Dawn's bindings at times abort when a process ends.

import { pathToFileURL } from "node:url";
import * as meshccd from "../pkg/index.js";
import { scene } from "../page/example.js";
import { clothBall } from "./expected.mjs";
import { compareExample, compareFrames, compareSessions } from "./steps.mjs";

const { Mesh, Session } = meshccd;
/** Devices that were opened, in order. */
const devices = [];

const answers = {
  /** What is missing for a device, if anything is. */
  async open(dawn) {
    await meshccd.init();
    const bindings = await import(pathToFileURL(`${dawn}/index.js`)).catch((why) => why);
    if (bindings instanceof Error) return `Dawn does not load: ${bindings.message}`;
    const { create, globals } = bindings;
    Object.assign(globalThis, globals);
    const gpu = create([]);
    Object.defineProperty(globalThis, "navigator", { value: { gpu } });
    const { requestDevice } = GPUAdapter.prototype;
    GPUAdapter.prototype.requestDevice = async function (...given) {
      const device = await requestDevice.apply(this, given);
      devices.push(device);
      return device;
    };
    if (await gpu.requestAdapter()) return null;
    return "Dawn finds no adapter; on Debian 12, run .ci/lavapipe";
  },

  compareExample: (options) => compareExample(meshccd, options),
  compareSessions: () => compareSessions(meshccd),
  compareFrames: () => compareFrames(meshccd, clothBall().files),

  /** A device that is lost while a step is in flight; then two sessions more. */
  async lose() {
    const { x0, x1, faces } = scene();
    const frames = [x0, x1].map((x) => Float64Array.from(x));
    const mesh = new Mesh(x0.length / 3, null, faces);
    const open = () => Session.open(mesh, { device: "gpu" });
    const session = await open();
    const before = devices.length;
    const flight = session.stepAsync(...frames);
    devices.at(-1).destroy();
    const message = (call) => call.then(() => "no error", (why) => why.message);
    const errors = [await message(flight), await message(session.earliestToiAsync(...frames))];
    const onCpu = session.step(...frames).contacts.length;
    const others = await Promise.all([open(), open()]);
    const reports = await Promise.all(others.map((other) => other.stepAsync(...frames)));
    const contacts = reports.map((report) => report.contacts.length);
    return { errors, onCpu, contacts, opened: devices.length - before };
  },

  /**
   * Devices that are lost before and during calls of sessions that may go on on the CPU; nothing
   * moves any more in the positions as soon as a call has them.
   */
  async loseFreely() {
    const n = 100;
    const at = (i, k) => [i % n, 0, Math.floor(i / n)][k];
    const x0 = new Float64Array(3 * n * n + 3).map((_, i) => at(Math.floor(i / 3), i % 3));
    x0.set([10.25, 1, 10.25], 3 * n * n);
    const x1 = x0.with(3 * n * n + 1, -1);
    const faces = [];
    for (let v = 0; v + n + 1 < n * n; v++) {
      if (v % n < n - 1) faces.push([v, v + 1, v + n], [v + 1, v + n + 1, v + n]);
    }
    const mesh = new Mesh(n * n + 1, null, faces);
    // `auto` takes no GPU that a CPU plays, and the device that is open says what it is.
    Object.defineProperty(GPUAdapterInfo.prototype, "isFallbackAdapter", { get: () => false });
    devices.at(-1)?.destroy();
    const lose = () => devices.at(-1).destroy();
    const overwritten = (call, frames) => {
      const flight = call(...frames);
      frames[1].set(frames[0]);
      return flight;
    };
    const session = await Session.open(mesh);
    const step = (...frames) => session.stepAsync(...frames);
    const endless = x1.with(7, NaN);
    const message = (call) => call.then(() => "nothing", (why) => why.message);
    const refused = [
      await message(session.stepAsync(x0, endless)),
      await message(session.stepAsync(x0, x1.subarray(3))),
    ];
    const reports = [await overwritten(step, [x0.slice(), x1.slice()])];
    lose();
    reports.push(await overwritten(step, [x0.slice(), x1.slice()]));
    const times = [];
    for (const Type of [Float32Array, Float64Array]) {
      const other = await Session.open(mesh);
      const own = other.positions(Type);
      own.x0.set(x0);
      own.x1.set(x1);
      const flight = overwritten((p, q) => other.earliestToiAsync(p, q), [own.x0, own.x1]);
      lose();
      times.push([await flight, other.earliestToi(x0, x1), other.backend]);
    }
    return {
      refused, times,
      backends: reports.map(({ backend }) => backend),
      contacts: reports.map(({ contacts }) => contacts.length),
      backend: session.backend,
      why: session.whyCpu,
    };
  },

  /** A buffer that cannot be made ends the module in the midst of a step; what calls say then. */
  async end() {
    const { x0, x1, faces } = scene();
    const frames = [x0, x1].map((x) => Float64Array.from(x));
    const mesh = new Mesh(x0.length / 3, null, faces);
    const open = () => Session.open(mesh, { device: "gpu" });
    const [session, other] = [await open(), await open()];
    // As a program goes on that has a handler of its own.
    const uncaught = [];
    process.on("uncaughtException", (why) => uncaught.push(String(why?.message ?? why)));
    const { createBuffer } = GPUDevice.prototype;
    GPUDevice.prototype.createBuffer = () => { throw new RangeError("injected"); };
    const message = (call) => call.then(() => "no error", (why) => why.message);
    const errors = [await message(session.stepAsync(...frames))];
    GPUDevice.prototype.createBuffer = createBuffer;
    errors.push(await message(other.earliestToiAsync(...frames)), await message(open()));
    session.setMinDistance(0);
    const onCpu = session.step(...frames).contacts.length;
    session.free();
    return { errors, onCpu, uncaught };
  },
};

process.on("message", async ({ call, given }) => {
  try {
    process.send({ found: await answers[call](given) });
  } catch (why) {
    process.send({ error: String(why?.stack ?? why) });
  }
});
