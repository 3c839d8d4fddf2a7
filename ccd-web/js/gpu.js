// Sessions on WebGPU: the module with the kernels, and the device, both opened when one is asked
// for.

import load, { is_cut_off, on_panic, RawDevice, RawGpuSession, RawMesh, RawOptions }
  from "./meshccd_gpu.js";
import { gpuWasmUrl, sourceOf } from "./index.js";
import { rawOptions } from "./input.js";
import { columns, report } from "./output.js";

let opening = null;
/**
 * Why the module does no more, if an exception ended a call inside it. Such a call leaves what it
 * changed half done, and its promise is never settled.
 */
let ended = null;
/** What rejects each call in flight. */
const flights = new Set();

function end(why) {
  ended ??= new Error(`the GPU module ended: ${why?.message ?? why}`);
  for (const reject of flights) reject(ended);
}

/**
 * Traps, and what imports throw, are seen as exceptions that nothing caught. The module knows
 * whether one of them ended a call of its own. Node's event leaves to the program what follows.
 */
const uncaught = (event) => { if (is_cut_off()) end(event?.error ?? event?.reason ?? event); };

function listen(on) {
  const call = on ? "addEventListener" : "removeEventListener";
  for (const name of ["error", "unhandledrejection"]) globalThis[call]?.(name, uncaught);
  globalThis.process?.[on ? "on" : "off"]?.("uncaughtExceptionMonitor", uncaught);
}

/** The answer of a call into the module, or an error if the module ends meanwhile. */
async function unlessEnded(call) {
  if (ended) throw ended;
  let reject;
  const theEnd = new Promise((_, rejected) => { reject = rejected; });
  // It may come while `call` itself throws.
  theEnd.catch(() => {});
  if (flights.size === 0) listen(true);
  flights.add(reject);
  try {
    return await Promise.race([theEnd, call()]);
  } finally {
    flights.delete(reject);
    if (flights.size === 0) listen(false);
  }
}

/** The module's exports and the device, once in each thread, and again after a device is lost. */
async function opened() {
  if (!globalThis.navigator?.gpu) throw new Error("there is no WebGPU here");
  if (ended) throw ended;
  const last = opening;
  if ((await last?.catch(() => null))?.device.is_lost() && opening === last) opening = null;
  opening ??= start();
  const mine = opening;
  try {
    return await mine;
  } catch (why) {
    if (opening === mine) opening = null;
    throw why;
  }
}

async function start() {
  const wasm = await load({ module_or_path: await sourceOf(gpuWasmUrl) });
  on_panic(end);
  // wgpu reads `navigator` where there is a window or a worker; in Node, with a package that has
  // WebGPU, there is neither.
  const alone = !("Window" in globalThis || "WorkerGlobalScope" in globalThis);
  if (alone) globalThis.WorkerGlobalScope = Object;
  try {
    return { wasm, device: await unlessEnded(() => RawDevice.open()) };
  } finally {
    if (alone) delete globalThis.WorkerGlobalScope;
  }
}

/** A session for the mesh of another module. `free`: not where a CPU plays the GPU. */
export async function open(mesh, options, free) {
  const { wasm, device } = await opened();
  if (free && device.is_emulated()) throw new Error("the browser's GPU is played by the CPU");
  const raw = rawOptions(options, RawOptions);
  const topology = new RawMesh(mesh.nVertices, mesh.edges, mesh.faces);
  try {
    return new GpuSession(new RawGpuSession(device, topology, raw), device.name(), wasm.memory);
  } finally {
    topology.free();
    raw.free();
  }
}

class GpuSession {
  constructor(raw, adapter, memory) {
    Object.assign(this, { raw, adapter, memory });
  }

  /** Copies positions. */
  place(x, wide) {
    if (ended) throw ended;
    const places = this.raw.positions(wide);
    this.places = places.all();
    places.free();
    this.Type = wide ? Float64Array : Float32Array;
    this.placed().forEach((to, i) => to.set(x[i]));
  }

  /** Those copies: they stay where they are, and a call that failed leaves them there. */
  placed() {
    const { Type, places: at, memory } = this;
    return [0, 2].map((i) => new Type(memory.buffer, at[i], at[i + 1]));
  }

  async step(wide, { window, geometry }) {
    await unlessEnded(() => this.raw.step(wide, ...window, geometry));
    const numbers = this.raw.numbers();
    const begun = performance.now();
    const contacts = columns(this.raw.columns(), { geometry, memory: this.memory });
    return report(contacts, numbers, performance.now() - begun, "gpu");
  }

  async earliestToi(wide) {
    return (await unlessEnded(() => this.raw.earliest_toi(wide))) ?? null;
  }

  /** A change of the session: calls say that the module ended, if it did. */
  change(call) {
    if (!ended) call(this.raw);
  }

  free() {
    if (!ended) this.raw.free();
  }
}
