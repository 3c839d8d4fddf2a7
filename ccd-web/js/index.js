// Continuous collision detection of triangle meshes: classes and typed arrays over the bindings.
// Types and documentation: index.d.ts.

import load, { initSync as loadSync, RawMesh, RawOptions, RawSession, version as rawVersion }
  from "./meshccd.js";
import { ends, id, ids, number, rawOptions } from "./input.js";
import { columns, KINDS, report, STATES, views } from "./output.js";

export { KINDS, STATES };

/** Where the WebAssembly modules are: that of the CPU, and the one with the kernels. */
export const gpuWasmUrl = new URL("./meshccd_gpu_bg.wasm", import.meta.url);
export const wasmUrl = new URL("./meshccd_bg.wasm", import.meta.url);

/** Exports of the module, once it is loaded. */
let wasm = null;
let loading = null;

export async function init(source) {
  if (wasm) return;
  loading ??= (async () => {
    wasm = await load({ module_or_path: await sourceOf(source) });
  })();
  try {
    await loading;
  } catch (why) {
    loading = null;
    throw why;
  }
}

export function initSync(source) {
  if (wasm) return;
  // Two loads would replace the module under the objects that there are by then.
  if (loading) throw new Error("init() is in flight: await it");
  wasm = loadSync({ module: source });
}

export function version() {
  loaded();
  return rawVersion();
}

/**
 * @internal What the bindings load: by default the module beside this file, which Node does not
 * fetch.
 */
export async function sourceOf(source) {
  const from = source ?? wasmUrl;
  const isFile = (from instanceof URL || typeof from === "string")
    && String(from).startsWith("file:");
  if (!isFile) return from;
  // Put together, so that bundlers for browsers do not look for it.
  const files = ["node:fs", "promises"].join("/");
  const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ files);
  return readFile(new URL(from));
}

function loaded() {
  if (!wasm) throw new Error("the module is not loaded: call `await init()` first");
}

export class Mesh {
  #raw;
  nVertices;

  constructor(nVertices, edges, faces) {
    loaded();
    if (!Number.isInteger(nVertices) || nVertices < 0 || nVertices > 0x7fffffff) {
      throw new Error(`nVertices is ${String(nVertices)}; it must be a whole number from 0 on`);
    }
    if (faces == null) {
      throw new Error("faces are missing: new Mesh(nVertices, edges, faces); [] if there are none");
    }
    this.#raw = new RawMesh(nVertices, ids(edges, "edges", 2), ids(faces, "faces", 3));
    this.nVertices = nVertices;
  }

  /** @internal */
  get raw() {
    if (!this.#raw) throw new Error("the mesh was freed");
    return this.#raw;
  }

  get edges() {
    return this.raw.edges();
  }

  get faces() {
    return this.raw.faces();
  }

  free() {
    this.#raw?.free();
    this.#raw = null;
  }
}

/** Options of `Session.open` besides. */
const DEVICES = ["auto", "cpu", "gpu"];
/** Edges from which on "auto" asks for a GPU; below, one thread is done sooner. */
const WORTH_A_GPU = 20_000;

export class Session {
  #raw;
  mesh;
  backend = "cpu";
  adapter = null;
  whyCpu = null;
  /** Of a GPU: its module's session, whether the CPU may take over, whether a call is awaited. */
  #gpu = null;
  #free = false;
  #busy = false;
  /** Whether there are views of the buffers of `f32` and of `f64`, which calls have to keep. */
  #viewed = [false, false];

  constructor(mesh, options) {
    loaded();
    const raw = rawOptions(options, RawOptions);
    try {
      this.#raw = new RawSession(mesh.raw, raw);
    } finally {
      raw.free();
    }
    this.mesh = mesh;
  }

  /** @internal */
  get raw() {
    if (!this.#raw) throw new Error("the session was freed");
    return this.#raw;
  }

  static async open(mesh, { device = "auto", ...options } = {}) {
    if (!DEVICES.includes(device)) {
      throw new Error(`device is ${device}; it must be one of ${DEVICES.join(", ")}`);
    }
    await init();
    const session = new Session(mesh, options);
    if (device === "cpu") return session;
    session.#free = device === "auto";
    if (session.#free && mesh.edges.length / 2 < WORTH_A_GPU) {
      session.whyCpu = `the mesh has fewer than ${WORTH_A_GPU} edges`;
      return session;
    }
    try {
      const { open } = await import("./gpu.js");
      session.#gpu = await open(mesh, options, session.#free);
      [session.backend, session.adapter] = ["gpu", session.#gpu.adapter];
    } catch (why) {
      if (!session.#free) {
        session.free();
        throw why;
      }
      session.whyCpu = String(why?.message ?? why);
    }
    return session;
  }

  positions(Type) {
    if (Type !== Float32Array && Type !== Float64Array) {
      throw new Error("positions are in a Float32Array or a Float64Array");
    }
    const wide = Type === Float64Array;
    this.#viewed[Number(wide)] = true;
    const [x0, x1] = this.#buffers(wide);
    return { x0, x1 };
  }

  step(x0, x1, { window = [0, 1], geometry = false, views: borrow = false } = {}) {
    const part = ends(window);
    const begun = performance.now();
    let [placed, found] = [begun, begun];
    const numbers = this.#on([x0, x1], (wide) => {
      placed = performance.now();
      this.raw.step(wide, ...part, Boolean(geometry));
      const all = this.raw.numbers();
      found = performance.now();
      return all;
    });
    const contacts = columns(this.raw.columns(), { geometry, borrow, memory: wasm.memory });
    const copy = placed - begun + performance.now() - found;
    return report(contacts, numbers, copy, "cpu");
  }

  async stepAsync(x0, x1, { window = [0, 1], geometry = false } = {}) {
    // A copy, because the CPU may read it when the caller has changed it.
    const options = { window: ends(window), geometry: Boolean(geometry) };
    return this.#awaited([x0, x1], (gpu, wide) => gpu.step(wide, options),
      (...x) => this.step(...x, options));
  }

  earliestToiAsync(x0, x1) {
    return this.#awaited([x0, x1], (gpu, wide) => gpu.earliestToi(wide),
      (...x) => this.earliestToi(...x));
  }

  /** What the GPU answers, or the CPU if it is its turn; reads positions before it returns. */
  async #awaited(given, onGpu, onCpu) {
    const gpu = this.#gpu;
    if (!gpu) return onCpu(...given);
    this.#rest();
    const wide = this.#check(given);
    this.#busy = true;
    let copies = () => given;
    try {
      gpu.place(given, wide);
      // The caller may write into what was given from here on.
      copies = () => gpu.placed().map((x) => x.slice());
      return await onGpu(gpu, wide);
    } catch (why) {
      if (!this.#free) throw why;
      // Bad input is that on the CPU as well, which says so, and the GPU stays.
      const found = onCpu(...copies());
      this.#gpu = null;
      [this.backend, this.adapter] = ["cpu", null];
      this.whyCpu = String(why?.message ?? why);
      try {
        gpu.free();
      } catch {
        // A module that ended while it read positions; the CPU has the answer.
      }
      return found;
    } finally {
      this.#busy = false;
    }
  }

  earliestToi(x0, x1) {
    return this.#on([x0, x1], (wide) => this.raw.earliest_toi(wide)) ?? null;
  }

  collisionFreeStepsize(x0, x1) {
    return this.earliestToi(x0, x1) ?? 1;
  }

  isStepCollisionFree(x0, x1) {
    return this.earliestToi(x0, x1) === null;
  }

  firstContact(x0, x1) {
    const all = this.#on([x0, x1], (wide) => this.raw.first_contact(wide));
    if (!all) return null;
    const [toi, kind, state, a, b] = all;
    const list = (from, n) => Array.from(all.subarray(from, from + n));
    return {
      toi,
      kind: KINDS[kind],
      state: STATES[state],
      features: [a, b],
      bodies: list(5, 2),
      vertices: list(7, 4),
      point: list(11, 3),
      normal: list(14, 3),
      weights: list(17, 4),
      distance: all[21],
    };
  }

  candidates(x0, x1, { views: borrow = false } = {}) {
    const places = this.#on([x0, x1], (wide) => this.raw.candidates(wide));
    const lists = views(places, KINDS.map(() => Uint32Array), wasm.memory);
    return Object.fromEntries(KINDS.map((kind, i) => [kind, borrow ? lists[i] : lists[i].slice()]));
  }

  intersections(x) {
    const all = this.#on([x], (wide) => this.raw.intersections(wide));
    const n = all.length / 3;
    return Array.from({ length: n }, (_, i) => (
      { edge: all[3 * i], face: all[3 * i + 1], state: STATES[all[3 * i + 2]] }
    ));
  }

  hasIntersections(x) {
    return this.#on([x], (wide) => this.raw.has_intersections(wide));
  }

  setMinDistance(distance) {
    this.#both((raw) => raw.set_min_distance(number(distance, "minDistance")));
  }

  setFixed(body, fixed) {
    this.#both((raw) => raw.set_fixed(id(body, "body"), Boolean(fixed)));
  }

  setSleeping(body, sleeping) {
    this.#both((raw) => raw.set_sleeping(id(body, "body"), Boolean(sleeping)));
  }

  free() {
    this.#rest();
    this.#gpu?.free();
    this.#raw?.free();
    [this.#gpu, this.#raw] = [null, null];
  }

  /** Refuses a change while an awaited call is in flight. */
  #rest() {
    if (this.#busy) throw new Error("a step of this session is in flight: await it first");
  }

  /** A change of both sessions, that of the GPU if there is one. */
  #both(change) {
    this.#rest();
    // The GPU's session first: it may refuse what the CPU's accepts, and then neither changes.
    this.#gpu?.change(change);
    change(this.raw);
  }

  /** Whether positions are taken as `f64`; refuses what are none. */
  #check(given) {
    const length = 3 * this.mesh.nVertices;
    given.forEach((x, i) => {
      if (!(x instanceof Float32Array) && !(x instanceof Float64Array)) {
        throw new Error(`x${i} is neither a Float32Array nor a Float64Array`);
      }
      if (x.length !== length) {
        throw new Error(`x${i} has ${x.length} numbers; the mesh has ${this.mesh.nVertices} `
          + `vertices, of 3 numbers each (and a view of the module's memory that is older than `
          + `its last growth has none)`);
      }
    });
    return given.some((x) => x instanceof Float64Array);
  }

  /** The session's buffers of a precision. */
  #buffers(wide) {
    const Type = wide ? Float64Array : Float32Array;
    return views(this.raw.positions(wide), [Type, Type], wasm.memory);
  }

  /**
   * A call on positions, the first of which it finds in the first buffer. Those that are elsewhere
   * are copied there, and what the user's views of the buffers show is put back.
   */
  #on(given, call) {
    const wide = this.#check(given);
    const Type = wide ? Float64Array : Float32Array;
    // Before the next call, after which the module's memory may have grown.
    const places = given.map((x) => (
      x instanceof Type && x.buffer === wasm.memory.buffer ? x.byteOffset : -1
    ));
    const [buffers, length] = [this.#buffers(wide), 3 * this.mesh.nVertices];
    const all = given.map((x, i) => ({ x, i, to: buffers[i], at: buffers[i].byteOffset }));
    const moved = all.filter(({ at, i }) => places[i] !== at);
    for (const { x, i } of moved) {
      if (x.length !== length) {
        throw new Error(`x${i} is a view of the module's memory, which has grown: copy it first`);
      }
    }
    // The second may lie where the first goes; `set` itself minds what it overwrites.
    const [first, second] = moved;
    if (second && overlap(second.x, first.to)) second.x = second.x.slice();
    const kept = this.#viewed[Number(wide)] ? moved.map(({ to }) => to.slice()) : [];
    for (const { x, to } of moved) to.set(x);
    try {
      return call(wide);
    } finally {
      // The memory may be another one, in which the buffers are where they were.
      kept.forEach((x, k) => new Type(wasm.memory.buffer, moved[k].at, length).set(x));
    }
  }
}

/** Whether two arrays have bytes in common. */
function overlap(p, q) {
  return p.buffer === q.buffer
    && p.byteOffset < q.byteOffset + q.byteLength && q.byteOffset < p.byteOffset + p.byteLength;
}

if (Symbol.dispose) {
  for (const Type of [Mesh, Session]) Type.prototype[Symbol.dispose] = Type.prototype.free;
}
