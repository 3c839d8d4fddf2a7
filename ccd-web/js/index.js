// Continuous collision detection of triangle meshes: classes and typed arrays over the bindings.
// Types and documentation: index.d.ts.

import load, { initSync as loadSync, RawMesh, RawOptions, RawSession, version as rawVersion }
  from "./meshccd.js";

/** Where the WebAssembly modules are: that of the CPU, and the one with the kernels. */
export const gpuWasmUrl = new URL("./meshccd_gpu_bg.wasm", import.meta.url);
export const wasmUrl = new URL("./meshccd_bg.wasm", import.meta.url);

/** Names of the kinds of contacts, by their numbers. */
export const KINDS = Object.freeze(["vf", "ee", "ve", "vv"]);

/** Names of the states of contacts, by their numbers. */
export const STATES = Object.freeze(["hit", "undecided"]);

/** Exports of the module, once it is loaded. */
let wasm = null;
let loading = null;

export async function init(source) {
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
  wasm ??= loadSync({ module: source });
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
  const { readFile } = await import("node:fs/promises");
  return readFile(new URL(from));
}

function loaded() {
  if (!wasm) throw new Error("the module is not loaded: call `await init()` first");
}

/** Views of lists in a module's memory, from their addresses and lengths. */
function views(places, types, memory = wasm.memory) {
  const all = places.all();
  places.free();
  return types.map((Type, i) => new Type(memory.buffer, all[2 * i], all[2 * i + 1]));
}

/** Ids as the bindings take them; `width`: how many a row has, if rows have one length. */
function ids(list, what, width) {
  if (list == null) return new Uint32Array();
  if (list instanceof Uint32Array) return list;
  const rows = Array.from(list);
  const nested = rows.some(Array.isArray);
  // Flat, rows of another length would be cut anew.
  const odd = nested && width ? rows.findIndex((row) => row?.length !== width) : -1;
  if (odd >= 0) {
    const [row, isList] = [rows[odd], Array.isArray(rows[odd])];
    throw new Error(`${what}: row ${odd} is ${isList ? `a list of ${row.length}` : row}; rows have `
      + `${width} ids each`);
  }
  const all = nested ? rows.flat() : rows;
  const wrong = all.findIndex((id) => !Number.isInteger(id) || id < 0 || id > 0xffffffff);
  if (wrong >= 0) {
    throw new Error(`${what}: entry ${wrong} is ${all[wrong]}; ids are whole numbers from 0 on`);
  }
  return Uint32Array.from(all);
}

export class Mesh {
  /** @internal */
  raw;
  nVertices;

  constructor(nVertices, edges, faces) {
    loaded();
    if (!Number.isInteger(nVertices) || nVertices < 0 || nVertices > 0x7fffffff) {
      throw new Error(`nVertices is ${nVertices}; it must be a whole number from 0 on`);
    }
    this.raw = new RawMesh(nVertices, ids(edges, "edges", 2), ids(faces, "faces", 3));
    this.nVertices = nVertices;
  }

  get edges() {
    return this.raw.edges();
  }

  get faces() {
    return this.raw.faces();
  }

  free() {
    this.raw.free();
  }
}

/** Options, each with how it is set. */
const SETTERS = {
  minDistance: (raw, value) => raw.set_min_distance(number(value, "minDistance")),
  tolerance: (raw, value) => raw.set_tolerance(number(value, "tolerance")),
  leaveContact: (raw, value) => raw.set_leave_contact(Boolean(value)),
  maxMemory: (raw, value) => raw.set_max_memory(number(value, "maxMemory")),
  mode: (raw, value) => raw.set_mode(String(value)),
  bodies: (raw, { ofVertex, fixed, noSelfContact, excluded }) => raw.set_bodies(
    ids(ofVertex, "bodies.ofVertex"), ids(fixed, "bodies.fixed"),
    ids(noSelfContact, "bodies.noSelfContact"), ids(excluded, "bodies.excluded", 2),
  ),
};

function number(value, what) {
  if (typeof value !== "number") throw new Error(`${what} is ${value}; it must be a number`);
  return value;
}

/** @internal Options for a module. */
export function rawOptions(options, Type = RawOptions) {
  const raw = new Type();
  for (const [name, value] of Object.entries(options ?? {})) {
    if (value == null) continue;
    if (!Object.hasOwn(SETTERS, name)) {
      const names = Object.keys(SETTERS).join(", ");
      throw new Error(`there is no option ${name}; options are ${names}`);
    }
    SETTERS[name](raw, value);
  }
  return raw;
}

/** Options of `Session.open` besides. */
const DEVICES = ["auto", "cpu", "gpu"];
/** Edges from which on "auto" asks for a GPU; below, one thread is done sooner. */
const WORTH_A_GPU = 20_000;

/** Types of the columns of contacts, in the order in which the bindings have them. */
const COLUMNS = {
  kind: Uint8Array,
  state: Uint8Array,
  ids: Uint32Array,
  toi: Float64Array,
  vertices: Uint32Array,
  point: Float64Array,
  normal: Float64Array,
  weights: Float64Array,
};
const GEOMETRY = ["vertices", "point", "normal", "weights"];

export class Session {
  /** @internal */
  raw;
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
    const raw = rawOptions(options);
    try {
      this.raw = new RawSession(mesh.raw, raw);
    } finally {
      raw.free();
    }
    this.mesh = mesh;
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
    const begun = performance.now();
    let [placed, found] = [begun, begun];
    const numbers = this.#on([x0, x1], (wide) => {
      placed = performance.now();
      this.raw.step(wide, window[0], window[1], geometry);
      const all = this.raw.numbers();
      found = performance.now();
      return all;
    });
    const contacts = columns(this.raw.columns(), { geometry, borrow });
    const copy = placed - begun + performance.now() - found;
    return report(contacts, numbers, copy, "cpu");
  }

  async stepAsync(x0, x1, { window = [0, 1], geometry = false } = {}) {
    // A copy, because the CPU may read it when the caller has changed it.
    const options = { window: Array.from(window), geometry };
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
    if (this.#busy) throw new Error("a step of this session is in flight: await it first");
    const wide = this.#check(given);
    this.#busy = true;
    let copies = () => given;
    try {
      gpu.place(given, wide);
      // The caller may write into what was given from here on.
      copies = () => gpu.placed();
      return await onGpu(gpu, wide);
    } catch (why) {
      if (!this.#free) throw why;
      // Bad input is that on the CPU as well, which says so, and the GPU stays.
      const found = onCpu(...copies());
      this.#gpu = null;
      [this.backend, this.adapter] = ["cpu", null];
      this.whyCpu = String(why?.message ?? why);
      gpu.free();
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
    const lists = views(places, KINDS.map(() => Uint32Array));
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
    this.#both((raw) => raw.set_fixed(body, fixed));
  }

  setSleeping(body, sleeping) {
    this.#both((raw) => raw.set_sleeping(body, sleeping));
  }

  free() {
    this.#both((raw) => raw.free());
  }

  /** A change of both sessions, that of the GPU if there is one. */
  #both(change) {
    if (this.#busy) throw new Error("a step of this session is in flight: await it first");
    change(this.raw);
    if (this.#gpu) change(this.#gpu.raw);
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
    return views(this.raw.positions(wide), [Type, Type]);
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

/** @internal Columns of contacts; `borrow`: as views. */
export function columns(places, { geometry, borrow, memory }) {
  const contacts = {};
  const lists = views(places, Object.values(COLUMNS), memory);
  Object.keys(COLUMNS).forEach((name, i) => {
    if (geometry || !GEOMETRY.includes(name)) {
      contacts[name] = borrow ? lists[i] : lists[i].slice();
    }
  });
  contacts.length = contacts.kind.length;
  return contacts;
}

/**
 * @internal A report of a step: columns, and numbers in the order in which the bindings have them.
 */
export function report(contacts, numbers, copy, backend) {
  const [toi, undecided, rebuilt] = numbers;
  const perKind = (from) => Object.fromEntries(KINDS.map((kind, i) => [kind, numbers[from + i]]));
  const [boxes, build, traverse, narrow, total] = numbers.subarray(15);
  return {
    contacts,
    toi: Number.isNaN(toi) ? null : toi,
    undecided,
    rebuilt: rebuilt === 1,
    counts: { contacts: perKind(3), candidates: perKind(7), filtered: perKind(11) },
    ms: { boxes, build, traverse, narrow, copy, total: total + copy },
    backend,
  };
}
