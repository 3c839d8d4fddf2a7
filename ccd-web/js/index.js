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

/** Ids as the bindings take them. */
function ids(list, what) {
  if (list == null) return new Uint32Array();
  if (list instanceof Uint32Array) return list;
  const all = Array.isArray(list) ? list.flat() : Array.from(list);
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
    this.raw = new RawMesh(nVertices, ids(edges, "edges"), ids(faces, "faces"));
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
    ids(noSelfContact, "bodies.noSelfContact"), ids(excluded, "bodies.excluded"),
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
    const [x0, x1] = views(this.raw.positions(Type === Float64Array), [Type, Type]);
    return { x0, x1 };
  }

  step(x0, x1, { window = [0, 1], geometry = false, views: borrow = false } = {}) {
    const begun = performance.now();
    const wide = this.#place(x0, x1);
    const placed = performance.now();
    this.raw.step(wide, window[0], window[1], geometry);
    const numbers = this.raw.numbers();
    const found = performance.now();
    const contacts = columns(this.raw.columns(), { geometry, borrow });
    const copy = placed - begun + performance.now() - found;
    return report(contacts, numbers, copy, "cpu");
  }

  stepAsync(x0, x1, options = {}) {
    return this.#awaited((gpu, wide) => gpu.step(wide, options), x0, x1)
      .then((found) => found ?? this.step(x0, x1, { ...options, views: false }));
  }

  earliestToiAsync(x0, x1) {
    return this.#awaited((gpu, wide) => gpu.earliestToi(wide), x0, x1)
      .then((found) => (found === undefined ? this.earliestToi(x0, x1) : found));
  }

  /** What the GPU answers; nothing if it is the CPU's turn. */
  async #awaited(call, x0, x1) {
    if (!this.#gpu) return undefined;
    if (this.#busy) throw new Error("a step of this session is in flight: await it first");
    this.#busy = true;
    try {
      const wide = this.#check(x0, x1);
      this.#gpu.place([x0, x1], wide);
      return await call(this.#gpu, wide);
    } catch (why) {
      // Bad input is that on the CPU as well, which says so.
      if (!this.#free) throw why;
      this.#gpu.free();
      this.#gpu = null;
      [this.backend, this.adapter] = ["cpu", null];
      this.whyCpu = String(why?.message ?? why);
      return undefined;
    } finally {
      this.#busy = false;
    }
  }

  earliestToi(x0, x1) {
    return this.raw.earliest_toi(this.#place(x0, x1)) ?? null;
  }

  collisionFreeStepsize(x0, x1) {
    return this.earliestToi(x0, x1) ?? 1;
  }

  isStepCollisionFree(x0, x1) {
    return this.earliestToi(x0, x1) === null;
  }

  firstContact(x0, x1) {
    const all = this.raw.first_contact(this.#place(x0, x1));
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
    const places = this.raw.candidates(this.#place(x0, x1));
    const lists = views(places, KINDS.map(() => Uint32Array));
    return Object.fromEntries(KINDS.map((kind, i) => [kind, borrow ? lists[i] : lists[i].slice()]));
  }

  intersections(x) {
    const all = this.raw.intersections(this.#place(x, x));
    const n = all.length / 3;
    return Array.from({ length: n }, (_, i) => (
      { edge: all[3 * i], face: all[3 * i + 1], state: STATES[all[3 * i + 2]] }
    ));
  }

  hasIntersections(x) {
    return this.raw.has_intersections(this.#place(x, x));
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
  #check(x0, x1) {
    const given = [x0, x1];
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

  /** Puts positions into the session's buffers; whether they are taken as `f64`. */
  #place(x0, x1) {
    const [given, length] = [[x0, x1], 3 * this.mesh.nVertices];
    const wide = this.#check(x0, x1);
    // Before the next call, after which the module's memory may have grown.
    const places = given.map((x) => (x.buffer === wasm.memory.buffer ? x.byteOffset : -1));
    const to = this.positions(wide ? Float64Array : Float32Array);
    [to.x0, to.x1].forEach((buffer, i) => {
      if (places[i] === buffer.byteOffset) return;
      if (given[i].length !== length) {
        throw new Error(`x${i} is a view of the module's memory, which has grown: copy it first`);
      }
      buffer.set(given[i]);
    });
    return wide;
  }
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
