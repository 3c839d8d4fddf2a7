// Sessions on WebGPU: the module with the kernels, and the device, both opened when one is asked
// for.

import load, { RawDevice, RawGpuSession, RawMesh, RawOptions } from "./meshccd_gpu.js";
import { columns, gpuWasmUrl, rawOptions, report, sourceOf } from "./index.js";

let opening = null;

/** The module's exports and the device, once in each thread, and again after a device is lost. */
async function opened() {
  if (!globalThis.navigator?.gpu) throw new Error("there is no WebGPU here");
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
  // wgpu reads `navigator` where there is a window or a worker; in Node, with a package that has
  // WebGPU, there is neither.
  const alone = !("Window" in globalThis || "WorkerGlobalScope" in globalThis);
  if (alone) globalThis.WorkerGlobalScope = Object;
  try {
    return { wasm, device: await RawDevice.open() };
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

  async step(wide, { window = [0, 1], geometry = false }) {
    await this.raw.step(wide, window[0], window[1], geometry);
    const numbers = this.raw.numbers();
    const begun = performance.now();
    const contacts = columns(this.raw.columns(), { geometry, memory: this.memory });
    return report(contacts, numbers, performance.now() - begun, "gpu");
  }

  async earliestToi(wide) {
    return (await this.raw.earliest_toi(wide)) ?? null;
  }

  free() {
    this.raw.free();
  }
}
